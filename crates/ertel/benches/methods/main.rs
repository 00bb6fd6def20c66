//! Finite volumes compared with finite elements: cost of contacts by each, difference of their films, and validity of the error bars of finite volumes.
//!
//!     cargo bench -p ertel --bench methods -- [--only TEXT] [--calibrate [--csv FILE]]
//!
//! Prints wall seconds of both in turn, their ratio, and both films with bars. With `--calibrate` finite volumes alone solve the contacts of `contacts.csv` at
//! three targets and against finer grids: how many figures differ by no more than their bars, and how much wider than the differences these are.

mod calibration;
mod contacts;

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser;
use ertel::case::Case;
use ertel::contact::{Contact, Hertz};
use ertel::engine::NoObserver;
use ertel::params::{Method, SensitivityDemand};
use ertel::run::solve;
use ertel::solution::{Figure, Solution};

use contacts::Trial;

#[derive(Parser)]
struct Args {
    /// Contacts whose name contains this.
    #[arg(long, default_value = "")]
    only: String,
    /// The error bars of finite volumes instead of times.
    #[arg(long)]
    calibrate: bool,
    /// Writes every comparison of a calibration as a table.
    #[arg(long)]
    csv: Option<PathBuf>,
    /// Given by cargo.
    #[arg(long, hide = true)]
    bench: bool,
}

/// Moes' groups of balls.
const BALLS: [[f64; 2]; 14] = [
    [5.0, 5.0],
    [5.0, 12.0],
    [20.0, 5.0],
    [20.0, 12.0],
    [20.0, 20.0],
    [60.0, 5.0],
    [60.0, 12.0],
    [200.0, 5.0],
    [200.0, 10.4],
    [200.0, 20.0],
    [500.0, 5.0],
    [500.0, 12.0],
    [1500.0, 12.0],
    [5000.0, 5.0],
];

/// Ellipses: R_x and R_y in mm, angle of the motion in degrees, load in N, slide-to-roll ratio, spin in rad/s, layer of oil in nm (0: flooded).
const ELLIPSES: [[f64; 7]; 10] = [
    [10.0, 40.0, 0.0, 60.0, 0.1, 0.0, 0.0],
    [10.0, 40.0, 35.0, 60.0, 0.1, 0.0, 0.0],
    [10.0, 40.0, 90.0, 60.0, 0.0, 0.0, 0.0],
    [10.0, 100.0, 0.0, 300.0, 0.0, 0.0, 0.0],
    [30.0, 6.0, 0.0, 100.0, 0.05, 0.0, 0.0],
    [10.0, 40.0, 20.0, 200.0, 0.0, 300.0, 0.0],
    [16.0, 16.0, 0.0, 100.0, 0.2, 300.0, 0.0],
    [16.0, 16.0, 0.0, 100.0, 0.0, 0.0, 150.0],
    [16.0, 16.0, 0.0, 30.0, 0.1, 0.0, 300.0],
    [10.0, 40.0, 0.0, 60.0, 0.0, 0.0, 200.0],
];

/// Laws of the shear, with the slide-to-roll ratio at which a ball of M 60, L 10 is sheared. With the limiting stress elements take minutes.
const LAWS: [(&str, &str, f64); 5] = [
    (
        "Eyring 5 MPa",
        "law = \"ree-eyring\", tau_0 = \"5 MPa\"",
        0.05,
    ),
    (
        "Eyring 5 MPa",
        "law = \"ree-eyring\", tau_0 = \"5 MPa\"",
        1.0,
    ),
    (
        "limit 2 MPa + 0.05 p",
        "law = \"limiting-stress\", tau_l0 = \"2 MPa\", lambda = 0.05",
        0.2,
    ),
    (
        "Carreau 0.1 MPa, 0.5",
        "law = \"carreau\", g_c = \"0.1 MPa\", n = 0.5, beta_c = 2.0, mu_2 = \"0 Pa.s\"",
        0.2,
    ),
    (
        "Carreau 5 MPa, 0.5",
        "law = \"carreau\", g_c = \"5 MPa\", n = 0.5, beta_c = 2.0, mu_2 = \"0 Pa.s\"",
        1.0,
    ),
];

/// The ball of 16 mm at 0.8 m/s and 40 mPa·s whose load and pressure-viscosity coefficient give Moes' groups; up to 1500 N, beyond which its speed does.
fn ball([m, l]: [f64; 2]) -> Trial {
    // M 199.3, L 10.36 at 100 N and 22 1/GPa: M ∝ w u^(−3/4), L ∝ α u^(1/4).
    let load = (100.0 * m / 199.3).min(1500.0);
    let speed = 0.8 * (m / 199.3 / (load / 100.0)).powf(-4.0 / 3.0);
    let alpha = 22.0 * l / 10.36 * (speed / 0.8).powf(-0.25);
    let contact = format!("kind = \"circular\"\nradius = \"16 mm\"\nload = \"{load} N\"");
    let motion = format!("entrainment_speed = \"{speed} m/s\"\nslide_to_roll_ratio = 0.1");
    Trial {
        family: String::new(),
        name: format!("ball M {m} L {l}"),
        text: text(&contact, &motion, alpha, ""),
    }
}

/// Loads of lines in kN/m, speeds in m/s, slide-to-roll ratios; with heat, too.
const LINES: [[f64; 3]; 8] = [
    [10.0, 10.0, 0.1],
    [20.0, 1.0, 0.1],
    [20.0, 10.0, 0.0],
    [50.0, 2.0, 0.4],
    [100.0, 2.0, 0.05],
    [100.0, 5.0, 1.0],
    [200.0, 1.0, 0.2],
    [300.0, 0.1, 0.1],
];

fn line([load, speed, sliding]: [f64; 3], heated: bool) -> Trial {
    let contact = format!("kind = \"line\"\nradius = \"10 mm\"\nload = \"{load} kN/m\"");
    let motion = format!("entrainment_speed = \"{speed} m/s\"\nslide_to_roll_ratio = {sliding}");
    let own = text(&contact, &motion, 18.0, "");
    Trial {
        family: String::new(),
        name: format!("line {load} kN/m {speed} m/s {sliding}, heat: {heated}"),
        text: match heated {
            false => own,
            true => own
                .replace("alpha =", "beta = \"0.045 1/K\", reference_temperature = \"40 degC\", alpha =")
                .replace("lubricant = {", "lubricant = { thermal_conductivity = \"0.14 W/(m.K)\", heat_capacity = \"2 kJ/(kg.K)\",")
                + "[thermal]\n",
        },
    }
}

fn ellipse([rx, ry, angle, load, sliding, spin, layer]: [f64; 7]) -> Trial {
    let contact = match rx == ry {
        true => format!("kind = \"circular\"\nradius = \"{rx} mm\"\nload = \"{load} N\""),
        false => format!(
            "kind = \"elliptical\"\nradius_x = \"{rx} mm\"\nradius_y = \"{ry} mm\"\nentrainment_angle = \"{angle} deg\"\nload = \"{load} N\""
        ),
    };
    let mut motion = format!("entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = {sliding}\n");
    if spin != 0.0 {
        motion += &format!("body_2_spin = \"{spin} rad/s\"");
    }
    let inlet = match layer > 0.0 {
        true => format!("[inlet]\noil_layer = \"{layer} nm\""),
        false => String::new(),
    };
    Trial {
        family: String::new(),
        name: format!("{rx} x {ry} mm, {angle} deg, {load} N, spin {spin}, layer {layer} nm"),
        text: text(&contact, &motion, 22.0, &inlet),
    }
}

fn thinned((name, law, sliding): (&str, &str, f64)) -> Trial {
    let newtonian = ball([60.0, 10.0]);
    let slides = format!("slide_to_roll_ratio = {sliding}");
    let text = newtonian.text.replace("slide_to_roll_ratio = 0.1", &slides);
    Trial {
        family: String::new(),
        name: format!("{name}, sliding {sliding}"),
        text: text.replace(
            "} }\n[contact]",
            &format!("}}, shear_thinning = {{ {law} }} }}\n[contact]"),
        ),
    }
}

fn text(contact: &str, motion: &str, alpha: f64, more: &str) -> String {
    format!(
        "lubricant = {{ temperature = \"40 degC\", density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}, viscosity = {{ law = \
         \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"{alpha} 1/GPa\" }} }}\n[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\n\
         body_2 = \"steel\"\n[motion]\n{motion}\n{more}\n"
    )
}

impl Trial {
    fn case(&self, method: Method, limits: Option<(f64, usize)>) -> Case {
        let mut case =
            Case::from_text(&self.name, &self.text, Path::new("")).expect("a valid case");
        case.solver.method = Some(method);
        case.output.sensitivities = SensitivityDemand::Off;
        if let Some((target, most)) = limits {
            case.mesh.target_error = Some(target);
            case.mesh.max_unknowns = Some(most);
        }
        case
    }
}

fn main() {
    let args = Args::parse();
    if args.calibrate {
        let mut chosen = contacts::contacts();
        chosen.retain(|trial| trial.name.contains(&args.only));
        calibration::calibrate(&chosen, args.csv.as_deref());
        return;
    }
    let balls = BALLS.map(ball).into_iter();
    let lines = [false, true].into_iter();
    let lines = lines.flat_map(|heated| LINES.map(|row| line(row, heated)));
    let trials = (balls.chain(ELLIPSES.map(ellipse)).chain(LAWS.map(thinned))).chain(lines);
    let chosen: Vec<Trial> = trials.filter(|t| t.name.contains(&args.only)).collect();
    compare(&chosen);
}

/// Films of a solution in nm.
fn films(solution: &Solution) -> String {
    let film = |figure| {
        let e = solution.measured.estimate(figure);
        format!(
            "{:.2} ± {:.2}",
            1e9 * e.value,
            1e9 * e.error.unwrap_or(f64::NAN)
        )
    };
    format!(
        "{} / {}",
        film(Figure::FilmCentral),
        film(Figure::FilmMinimum)
    )
}

fn compare(trials: &[Trial]) {
    println!(
        "| contact | p_h, GPa | elements, s | volumes, s | ratio | h_c / h_min by elements, nm | by volumes, nm |\n|---|---|---|---|---|---|---|"
    );
    for trial in trials {
        let mut ends = [Method::FiniteElements, Method::FiniteVolumes].map(|method| {
            let clock = Instant::now();
            let end = solve(&trial.case(method, None), &mut NoObserver);
            (clock.elapsed().as_secs_f64(), end)
        });
        let [(elements, _), (volumes, _)] = &ends;
        let (elements, volumes) = (*elements, *volumes);
        let films = ends.each_mut().map(|(_, end)| match end {
            Ok(solution) => films(solution),
            Err(error) => error.to_string(),
        });
        let case = trial.case(Method::FiniteVolumes, None);
        let contact: Contact = case.contact.along_motion();
        let pressure = 1e-9 * Hertz::new(&contact, case.reduced_modulus()).pressure;
        println!(
            "| {} | {pressure:.2} | {elements:.1} | {volumes:.1} | {:.2} | {} | {} |",
            trial.name,
            elements / volumes,
            films[0],
            films[1]
        );
    }
}
