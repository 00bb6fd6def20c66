//! Do the error bars hold? Figures of contacts on meshes for several targets, presets and edges set by hand, against finer meshes.
//!
//!     cargo bench -p ertel --bench calibration -- [--only TEXT] [--csv FILE]
//!
//! Prints how many figures differ from the reference by no more than their bars, figure by figure, and the worst; `--csv` writes every comparison.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::Parser;
use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run::problem;
use ertel::solution::{Figure, Measured};
use ertel::solve::figures::measure;
use ertel::solve::sequence::solve_stages;

#[derive(Parser)]
struct Args {
    /// Contacts whose name contains this.
    #[arg(long, default_value = "")]
    only: String,
    /// Writes every comparison as a table.
    #[arg(long)]
    csv: Option<PathBuf>,
    /// Given by cargo.
    #[arg(long, hide = true)]
    bench: bool,
}

/// Moes' groups: circular, line.
const CIRCULAR: [[f64; 2]; 12] = [
    [2.0, 0.0],
    [5.0, 5.0],
    [20.0, 0.0],
    [20.0, 10.0],
    [100.0, 5.0],
    [200.0, 0.0],
    [200.0, 10.0],
    [500.0, 10.0],
    [1000.0, 5.0],
    [1000.0, 10.0],
    [3000.0, 10.0],
    [9500.0, 10.0],
];
const LINE: [[f64; 2]; 9] = [
    [1.0, 5.0],
    [5.0, 0.0],
    [10.0, 20.0],
    [20.0, 25.0],
    [50.0, 10.0],
    [200.0, 5.0],
    [200.0, 15.0],
    [1000.0, 5.0],
    [10_000.0, 2.5],
];
/// Cases with heat, shear thinning and sliding.
const FILES: [&str; 4] = [
    "squalane-on-glass",
    "squalane-thermal",
    "glycerol-thermal",
    "roller",
];

/// Meshes whose bars are tried.
const MESHES: [(&str, &str); 7] = [
    ("3 %", "target_error = 0.03"),
    ("1 %", "target_error = 0.01"),
    ("0.2 %", ""),
    ("0.05 %", "target_error = 0.0005"),
    ("coarse", "preset = \"coarse\""),
    ("normal", "preset = \"normal\""),
    ("inlet -3", "inlet = -3.0"),
];
const SIDE: (&str, &str) = ("side 2", "side = 2.0");
/// Two levels finer than the default.
const REFERENCE: &str = "target_error = 0.0005\npressure_error = 0.004\nmax_unknowns = 40000";

/// A contact as the text of a case file without `[mesh]`, and where its tables are.
struct Contact {
    name: String,
    text: String,
    folder: PathBuf,
    circular: bool,
}

fn main() {
    let args = Args::parse();
    let contacts: Vec<Contact> = (contacts().into_iter())
        .filter(|c| c.name.contains(&args.only))
        .collect();
    let mut table = String::from("contact,mesh,figure,value,bar,reference,reference_bar\n");
    let mut rows = Vec::new();
    for contact in &contacts {
        // On a thread of the pool, as `solve` does.
        let own = rayon::scope(|_| compare(contact));
        let covered = own.iter().filter(|r| r.off() <= 1.0).count();
        eprintln!(
            "{}: {covered} of {} within their bars",
            contact.name,
            own.len()
        );
        for r in &own {
            let name = r.figure.name();
            // Writing into a String cannot fail
            let _ = writeln!(
                table,
                "{},{},{name},{:e},{:e},{:e},{:e}",
                r.contact, r.mesh, r.value, r.bar, r.reference, r.reference_bar
            );
        }
        if let Some(path) = &args.csv {
            std::fs::write(path, &table).expect("the table can be written");
        }
        rows.extend(own);
    }
    report(&rows);
}

/// One figure on one mesh.
struct Row {
    contact: String,
    mesh: &'static str,
    figure: Figure,
    value: f64,
    bar: f64,
    reference: f64,
    reference_bar: f64,
}

impl Row {
    /// Difference from the reference over the bar.
    fn off(&self) -> f64 {
        (self.value - self.reference).abs() / self.bar
    }
}

fn compare(contact: &Contact) -> Vec<Row> {
    let Some(reference) = solve(contact, REFERENCE) else {
        eprintln!("{}: no reference", contact.name);
        return Vec::new();
    };
    let mut meshes = MESHES.to_vec();
    meshes.extend(contact.circular.then_some(SIDE));
    let mut rows = Vec::new();
    for (mesh, settings) in meshes {
        let Some(found) = solve(contact, settings) else {
            eprintln!("{}: not solved at {mesh}", contact.name);
            continue;
        };
        for figure in Figure::ALL {
            let (Some(here), Some(there)) = (found.find(figure), reference.find(figure)) else {
                continue;
            };
            let (Some(bar), Some(reference_bar)) = (here.error, there.error) else {
                continue;
            };
            // Figures that are zero by symmetry or not resolved by the reference.
            if here.value.abs() < 1e-9 * bar || bar == 0.0 || reference_bar > 0.5 * bar {
                continue;
            }
            rows.push(Row {
                contact: contact.name.clone(),
                mesh,
                figure,
                value: here.value,
                bar,
                reference: there.value,
                reference_bar,
            });
        }
    }
    rows
}

fn solve(contact: &Contact, mesh: &str) -> Option<Measured> {
    let text = format!("{}\n[mesh]\n{mesh}\n", contact.text);
    let case = match Case::from_text(&contact.name, &text, &contact.folder) {
        Ok(case) => case,
        Err(error) => {
            eprintln!("{}: {error}", contact.name);
            return None;
        }
    };
    let problem = problem(&case);
    let (solution, levels) = solve_stages(&problem, &mut NoObserver).ok()?;
    Some(measure(&problem, &solution, &levels))
}

fn report(rows: &[Row]) {
    println!(
        "| figure | compared | within the bar | within twice the bar | worst, in bars | where |"
    );
    println!("|---|---|---|---|---|---|");
    let line = |name: &str, rows: &[&Row]| {
        let within = |limit: f64| rows.iter().filter(|r| r.off() <= limit).count();
        let worst = rows.iter().max_by(|a, b| a.off().total_cmp(&b.off()));
        if let Some(w) = worst {
            println!(
                "| {name} | {} | {} | {} | {:.2} | {}, {} |",
                rows.len(),
                within(1.0),
                within(2.0),
                w.off(),
                w.contact,
                w.mesh
            );
        }
    };
    for figure in Figure::ALL {
        let of_figure: Vec<&Row> = rows.iter().filter(|r| r.figure == figure).collect();
        line(figure.name(), &of_figure);
    }
    line("all", &rows.iter().collect::<Vec<_>>());
}

fn contacts() -> Vec<Contact> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let of_groups = |kind: &'static str| move |[m, l]: &[f64; 2]| group_contact(kind, *m, *l);
    let mut contacts: Vec<Contact> = LINE.iter().map(of_groups("line")).collect();
    contacts.extend(CIRCULAR.iter().map(of_groups("circular")));
    contacts.extend(FILES.iter().map(|name| {
        let path = root.join(format!("{name}.toml"));
        let text = std::fs::read_to_string(path).expect("a case of the project");
        Contact {
            name: (*name).to_owned(),
            circular: text.contains("\"circular\""),
            text,
            folder: root.clone(),
        }
    }));
    contacts
}

/// Contact of Moes' groups M and L: steel, 16 mm, 1 m/s, 22 1/GPa; viscosity and load from 2U = (L/αE')⁴ and
/// M = F/(E'R²(2U)^¾) or w/(E'R √2U).
fn group_contact(kind: &str, m: f64, l: f64) -> Contact {
    let (modulus, radius, alpha) = (230.769e9, 0.016, 22e-9);
    let two_u = (if l > 0.0 { l } else { 5.0 } / (alpha * modulus) as f64).powi(4);
    let viscosity = 0.5 * two_u * modulus * radius;
    let (load, unit) = match kind {
        "line" => (m * modulus * radius * two_u.sqrt(), "N/m"),
        _ => (m * modulus * radius * radius * two_u.powf(0.75), "N"),
    };
    let law = match l > 0.0 {
        true => {
            format!("{{ law = \"roelands\", mu_0 = \"{viscosity:e} Pa.s\", alpha = \"22 1/GPa\" }}")
        }
        false => format!("{{ law = \"constant\", mu_0 = \"{viscosity:e} Pa.s\" }}"),
    };
    Contact {
        name: format!("{kind} M {m} L {l}"),
        text: format!(
            "[contact]\nkind = \"{kind}\"\nradius = \"16 mm\"\nload = \"{load:e} {unit}\"\n\
             [bodies]\nbody_1 = {{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }}\n\
             body_2 = {{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }}\n\
             [motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.0\n\
             [lubricant]\ntemperature = \"40 degC\"\n\
             density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}\nviscosity = {law}\n"
        ),
        folder: PathBuf::new(),
        circular: kind == "circular",
    }
}
