//! The numbers of the pages that do whole jobs, held against the files that the commands of the pages write.

use std::path::Path;

use crate::common;

/// A row of numbers on a page: the text before them, and for each cell that follows, how many cells on, where its number is in the file, and the
/// file's unit over that of the page.
struct Held {
    page: &'static str,
    before: &'static str,
    file: &'static str,
    /// Row of a CSV file, from 0; of a JSON file the pointer of an object.
    place: Place,
    cells: &'static [(usize, &'static str, f64)],
}

enum Place {
    Row(usize),
    Pointer(&'static str),
}

use Place::{Pointer, Row};

/// Numbers on another machine differ by rounding on the way to meshes, and the pages round.
const TOLERANCE: f64 = 0.02;

const BEARING: &str = "results/bearing-6206-speeds/results.csv";
const BEARING_CELLS: &[(usize, &str, f64)] = &[
    (0, "film_minimum_m", 1e9),
    (1, "friction_torque_N_m", 1e3),
    (2, "modified_rating_life_million_revolutions", 1.0),
];
const GEARS: &str = "results/fzg-c-torques/results.csv";
const GEAR_CELLS: &[(usize, &str, f64)] = &[
    (0, "film_minimum_m", 1e9),
    (1, "friction_power_W", 1.0),
    (2, "mesh_loss", 100.0),
    (3, "scuffing_safety", 1.0),
    (4, "micropitting_safety", 1.0),
];
const SPEEDS: &str = "results/speeds/curve.csv";
const FILMS: &[(usize, &str, f64)] = &[(0, "film_central_m", 1e9), (1, "film_minimum_m", 1e9)];
const TRACTION: &str = "results/traction/curve.csv";
const TRACTION_CELLS: &[(usize, &str, f64)] =
    &[(0, "traction_coefficient", 1.0), (1, "film_central_m", 1e9)];
const CAM: &str = "results/cam-turn-speeds/results.csv";

const WAVES: &str = "results/waves-and-speeds/results.csv";
const WAVES_CELLS: &[(usize, &str, f64)] = &[
    (0, "film_minimum_lowest_m", 1e9),
    (1, "amplitude_ratio_last", 100.0),
];

const HELD: &[Held] = &[
    Held::row("time", "| 0.173 mm | 0.32 m/s | ", WAVES, 0, WAVES_CELLS),
    Held::row("time", "| 0.173 mm | 0.64 m/s | ", WAVES, 1, WAVES_CELLS),
    Held::row("time", "| 0.173 mm | 1.28 m/s | ", WAVES, 2, WAVES_CELLS),
    Held::row("time", "| 0.346 mm | 0.32 m/s | ", WAVES, 3, WAVES_CELLS),
    Held::row("time", "| 0.346 mm | 0.64 m/s | ", WAVES, 4, WAVES_CELLS),
    Held::row("time", "| 0.346 mm | 1.28 m/s | ", WAVES, 5, WAVES_CELLS),
    Held::row("bearing", "| 500 rpm | ", BEARING, 0, BEARING_CELLS),
    Held::row("bearing", "| 2000 rpm | ", BEARING, 1, BEARING_CELLS),
    Held::row("bearing", "| 6000 rpm | ", BEARING, 2, BEARING_CELLS),
    Held::row("gear", "| 50 N m | 750 rpm | ", GEARS, 0, GEAR_CELLS),
    Held::row("gear", "| 50 N m | 1500 rpm | ", GEARS, 1, GEAR_CELLS),
    Held::row("gear", "| 100 N m | 750 rpm | ", GEARS, 2, GEAR_CELLS),
    Held::row("gear", "| 100 N m | 1500 rpm | ", GEARS, 3, GEAR_CELLS),
    Held::row("gear", "| 200 N m | 750 rpm | ", GEARS, 4, GEAR_CELLS),
    Held::row("gear", "| 200 N m | 1500 rpm | ", GEARS, 5, GEAR_CELLS),
    Held::row(
        "cam",
        "the mean friction torque is ",
        CAM,
        0,
        &[(0, "friction_torque_N_m", 1e3)],
    ),
    Held::row(
        "cam",
        "and the smallest film ",
        CAM,
        0,
        &[(0, "film_minimum_m", 1e9)],
    ),
    Held::figure("rig", "The solve gives ", "results/rig", "film_central"),
    Held::figure("rig", "in the centre and ", "results/rig", "film_minimum"),
    Held {
        page: "rig",
        before: "Its traction coefficient is ",
        file: "results/rig/result.json",
        place: Pointer("/figures/traction_coefficient"),
        cells: &[(0, "value", 1.0)],
    },
    Held::row("rig", "| 0.4 m/s | ", SPEEDS, 0, FILMS),
    Held::row("rig", "| 0.7407 m/s | ", SPEEDS, 4, FILMS),
    Held::row("rig", "| 1.6 m/s | ", SPEEDS, 9, FILMS),
    Held {
        page: "rig",
        before: "ends with bias (",
        file: "results/measured/comparison.json",
        place: Pointer("/statistics/film_central"),
        cells: &[(0, "bias", 100.0)],
    },
    Held::row(
        "time",
        "The film in the centre is ",
        "results/waves/transient.csv",
        0,
        &[(0, "film_central_m", 1e9)],
    ),
    Held::row("rig", "| 0.01 | ", TRACTION, 0, TRACTION_CELLS),
    Held::row("rig", "| 0.1 | ", TRACTION, 4, TRACTION_CELLS),
    Held::row("rig", "| 0.6 | ", TRACTION, 9, TRACTION_CELLS),
    Held::figure(
        "own-oil",
        "the central film is ",
        "results/data-sheet",
        "film_central",
    ),
    Held::figure(
        "own-oil",
        "| 40 °C | 40.9 mPa·s | ",
        "results/oil-40",
        "film_central",
    ),
    Held::figure(
        "own-oil",
        "| 40 °C | 40.9 mPa·s | 253.9 nm | ",
        "results/oil-40",
        "film_minimum",
    ),
    Held::figure(
        "own-oil",
        "| 80 °C | 9.75 mPa·s | ",
        "results/oil-80",
        "film_central",
    ),
    Held::figure(
        "own-oil",
        "| 80 °C | 9.75 mPa·s | 83.9 nm | ",
        "results/oil-80",
        "film_minimum",
    ),
];

impl Held {
    const fn row(
        page: &'static str,
        before: &'static str,
        file: &'static str,
        row: usize,
        cells: &'static [(usize, &'static str, f64)],
    ) -> Held {
        Held {
            page,
            before,
            file,
            place: Row(row),
            cells,
        }
    }

    /// A film, nm, of a result's folder.
    const fn figure(
        page: &'static str,
        before: &'static str,
        file: &'static str,
        figure: &'static str,
    ) -> Held {
        Held {
            page,
            before,
            file,
            place: Pointer(figure),
            cells: &[(0, "value", 1e9)],
        }
    }

    fn number(&self, folder: &Path, column: &str) -> f64 {
        let path = folder.join(self.file);
        match self.place {
            Row(row) => common::rows_of(&path)[row][column].parse().unwrap(),
            Pointer(at) => {
                let (path, pointer) = match at.starts_with('/') {
                    true => (path, at.to_owned()),
                    false => (path.join("result.json"), format!("/figures/{at}")),
                };
                let text = std::fs::read_to_string(path).unwrap();
                let document: serde_json::Value = serde_json::from_str(&text).unwrap();
                document.pointer(&pointer).unwrap()[column]
                    .as_f64()
                    .unwrap()
            }
        }
    }
}

/// Panics where a number on a page, `guide/PAGE.md`, is not the one in the files that its commands wrote into the folder.
pub fn check(page: &str, text: &str, folder: &Path) {
    let name = page.trim_start_matches("guide/").trim_end_matches(".md");
    let mut wrong = Vec::new();
    for held in HELD.iter().filter(|held| held.page == name) {
        let (_, after) = (text.split_once(held.before))
            .unwrap_or_else(|| panic!("{page} has no `{}`", held.before));
        let cells: Vec<&str> = after.lines().next().unwrap().split(" | ").collect();
        for (cell, column, scale) in held.cells {
            let words = cells[*cell].split([' ', ')', ',']).next().unwrap();
            let shown: f64 = words.parse().unwrap();
            let found = scale * held.number(folder, column);
            if (shown - found).abs() > TOLERANCE * found.abs() {
                wrong.push(format!(
                    "{page}: after `{}` {shown}, {column} of {} is {found}",
                    held.before, held.file
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every page of a person's job has numbers.
#[test]
fn every_job_has_numbers() {
    for page in ["bearing", "gear", "cam", "rig", "time", "own-oil"] {
        assert!(HELD.iter().any(|held| held.page == page), "{page}");
    }
}
