//! Cost of contacts in time: `cargo bench -p ertel --bench transient`.
//!
//! Courses of speed and load, and surfaces that pass, each compared with the steady solve of the same contact: steps, time of the whole, of a step and of the
//! steady solve, and their ratio, all in one run on one machine. Also the film of a run with a third of the tolerance.

#[path = "common/clock.rs"]
mod clock;

use clap::Parser;
use clock::Clock;
use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;
use ertel::run::transient::TransientSolution;
use ertel::solution::Figure;

const LINE: &str = "kind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"";
const WAVY: &str = "kind = \"line\"\nradius = \"10 mm\"\nload = \"1083.32 kN/m\"";
/// Mourier et al. 2006: 15 N, E' 110 GPa, 0.09 m/s.
const BALL: &str = "kind = \"circular\"\nradius = \"12.5 mm\"\nload = \"15 N\"";

/// Name, contact, viscosity, speed, duration and the rest of `[transient]`, surface, tolerance.
struct Course {
    name: &'static str,
    contact: &'static str,
    modulus: &'static str,
    viscosity: &'static str,
    speed: &'static str,
    transient: &'static str,
    surface: &'static str,
    tolerance: f64,
}

const COURSES: [Course; 6] = [
    Course {
        name: "line, speed to three times in 1 ms",
        contact: LINE,
        modulus: "210 GPa",
        viscosity: "40 mPa.s",
        speed: "0.5 m/s",
        transient: "duration = \"3 ms\"\nentrainment_speed = { course = \"ramp\", start = \"0.5 ms\", end = \"1.5 ms\", to = \"1.5 m/s\" }",
        surface: "",
        tolerance: 0.003,
    },
    Course {
        name: "line, load by a half, four periods of 1 ms",
        contact: LINE,
        modulus: "210 GPa",
        viscosity: "40 mPa.s",
        speed: "1 m/s",
        transient: "duration = \"4 ms\"\nload = { course = \"sine\", amplitude = \"50 kN/m\", period = \"1 ms\" }",
        surface: "",
        tolerance: 0.004,
    },
    Course {
        name: "line, a groove of 200 nm passes",
        contact: LINE,
        modulus: "210 GPa",
        viscosity: "40 mPa.s",
        speed: "1 m/s",
        transient: "duration = \"1 ms\"",
        surface: "kind = \"groove\"\nbody = \"body_2\"\nhalf_width = \"40 um\"\ndepth = \"200 nm\"\nx = \"-0.4 mm\"",
        tolerance: 0.005,
    },
    Course {
        name: "line, waves of half a half-width",
        contact: WAVY,
        modulus: "210 GPa",
        viscosity: "40 mPa.s",
        speed: "0.6357 m/s",
        transient: "duration = \"2.2 ms\"",
        surface: "kind = \"waves\"\nbody = \"body_2\"\nwavelength = \"0.173 mm\"\namplitude = \"17 nm\"\nx = \"-0.8 mm\"",
        tolerance: 0.003,
    },
    Course {
        name: "ball, speed to twice in 2 ms",
        contact: BALL,
        modulus: "100.1 GPa",
        viscosity: "250 mPa.s",
        speed: "0.09 m/s",
        transient: "duration = \"8 ms\"\nentrainment_speed = { course = \"ramp\", start = \"1 ms\", end = \"3 ms\", to = \"0.18 m/s\" }",
        surface: "",
        tolerance: 0.01,
    },
    Course {
        name: "ball, a dent of 175 nm passes",
        contact: BALL,
        modulus: "100.1 GPa",
        viscosity: "250 mPa.s",
        speed: "0.09 m/s",
        transient: "duration = \"5 ms\"",
        surface: "kind = \"dent\"\nbody = \"body_2\"\nradius = \"15.5 um\"\ndepth = \"175 nm\"\nx = \"-225 um\"",
        tolerance: 0.01,
    },
];

/// Cost of contacts in time.
#[derive(Parser)]
struct Args {
    /// Those whose names contain this
    #[arg(long, default_value = "")]
    only: String,
    /// Leave out the runs with a third of the tolerance
    #[arg(long)]
    once: bool,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

impl Course {
    fn case(&self, tolerance: Option<f64>) -> Case {
        let Course {
            contact,
            modulus,
            viscosity,
            speed,
            transient,
            surface,
            ..
        } = self;
        let in_time = match tolerance {
            None => String::new(),
            Some(tolerance) => {
                let surface = match surface.is_empty() {
                    true => String::new(),
                    false => format!("[[surface]]\n{surface}\n"),
                };
                format!("[transient]\ntolerance = {tolerance}\n{transient}\n{surface}")
            }
        };
        let body = format!("{{ youngs_modulus = \"{modulus}\", poissons_ratio = 0.3 }}");
        let text = format!(
            "lubricant = {{ temperature = \"40 degC\", density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}, \
             viscosity = {{ law = \"roelands\", mu_0 = \"{viscosity}\", alpha = \"22 1/GPa\" }} }}\n[contact]\n{contact}\n[bodies]\nbody_1 = {body}\nbody_2 = {body}\n\
             [motion]\nentrainment_speed = \"{speed}\"\nslide_to_roll_ratio = 0.0\n[output]\nsensitivities = false\n[solver]\nmethod = \"finite-volumes\"\n{in_time}"
        );
        Case::from_text("case.toml", &text, "".as_ref()).expect("a case")
    }
}

/// The central film over time, m, by instants.
fn films(solution: &TransientSolution) -> Vec<[f64; 2]> {
    let of = |i: &run::transient::InstantSolution| {
        let film = i.measured.estimate(Figure::FilmCentral).value;
        [i.time, film]
    };
    solution.instants.iter().map(of).collect()
}

/// The largest difference of the films of a run from those of a finer one, which are interpolated, over the film.
fn off(of: &[[f64; 2]], finer: &[[f64; 2]]) -> f64 {
    let at = |time: f64| {
        let k = finer
            .partition_point(|[t, _]| *t < time)
            .clamp(1, finer.len() - 1);
        let ([t_0, h_0], [t_1, h_1]) = (finer[k - 1], finer[k]);
        h_0 + (h_1 - h_0) * (time - t_0) / (t_1 - t_0)
    };
    let differences = of.iter().map(|[t, h]| (h / at(*t) - 1.0).abs());
    differences.fold(0.0, f64::max)
}

fn main() {
    let args = Args::parse();
    println!(
        "| course | tolerance | steps | Newton iterations a step | wall s | CPU s | CPU ms a step | CPU s, steady | step/steady | largest change of h_c with a third of the tolerance |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for course in COURSES.iter().filter(|c| c.name.contains(&args.only)) {
        let clock = Clock::start();
        run::solve(&course.case(None), &mut NoObserver).expect("a steady contact");
        let steady = clock.seconds();
        let clock = Clock::start();
        let solution = run::transient::solve(&course.case(Some(course.tolerance)), &mut NoObserver);
        let whole = clock.seconds();
        if let Some(failure) = &solution.failure {
            println!("| {} | {failure} |", course.name);
            continue;
        }
        let change = match args.once {
            true => "-".to_owned(),
            false => {
                let finer = course.case(Some(course.tolerance / 3.0));
                let finer = run::transient::solve(&finer, &mut NoObserver);
                format!("{:.2} %", 100.0 * off(&films(&solution), &films(&finer)))
            }
        };
        let steps = solution.instants.len() - 1;
        let iterations: usize = solution.instants.iter().map(|i| i.newton_iterations).sum();
        let step = whole.cpu / steps as f64;
        println!(
            "| {} | {} % | {steps} | {:.1} | {:.1} | {:.1} | {:.1} | {:.2} | {:.3} | {change} |",
            course.name,
            100.0 * course.tolerance,
            iterations as f64 / steps as f64,
            whole.wall,
            whole.cpu,
            1e3 * step,
            steady.cpu,
            step / steady.cpu,
        );
    }
}
