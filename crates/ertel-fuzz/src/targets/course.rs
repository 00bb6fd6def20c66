//! Courses in time: tables, with a case.

use crate::input::{Input, Target};

/// A line contact whose load follows a table, `course.csv`.
const CASE: &str = include_str!("../../corpus/course-case.toml");
const TABLES: [&str; 3] = [
    "time (ms),value (kN/m)\n0,50\n0.5,60\n1,55\n",
    "time [s];value [N/m]\n0;5e4\n2,5e-4;5,5e4\n1e-3;6e4\n",
    "# of a logger\ntime_us\tvalue_kN_per_m\n0\t50\n400\t45\n1000\t52\n",
];

/// Files from which inputs are made.
pub fn seeds() -> Vec<Input> {
    let of = |text: &&str| {
        let mut input = Input {
            target: Target::Course,
            files: Vec::new(),
        };
        input.set("case.toml", CASE.as_bytes().to_vec());
        input.set("course.csv", text.as_bytes().to_vec());
        input
    };
    TABLES.iter().map(of).collect()
}
