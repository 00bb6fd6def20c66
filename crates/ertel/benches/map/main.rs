//! Convergence map: hundreds of contacts, each cold, with default settings.
//!
//! `cargo bench -p ertel --bench map -- --help` shows the choices. Every case prints a line; a
//! CSV table, a summary in markdown and a picture go into the output folder.

mod cases;
mod machine;
mod picture;
mod record;
mod sliding;
mod summary;

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::{Parser, ValueEnum};
use ertel::contact::ContactKind;
use ertel::params::MeshPreset;

use record::{Record, Settings};

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    Line,
    Circular,
    Elliptical,
    Roller,
}

/// Which contacts.
#[derive(Clone, Copy, ValueEnum)]
enum Map {
    /// Isothermal Newtonian contacts in pure rolling, by load and material
    Rolling,
    /// Sliding, heat and fluids that thin or limit their stress
    Sliding,
    /// Ellipses at any angle and rollers with each profile
    Machine,
}

#[derive(Clone, Copy, ValueEnum)]
enum Preset {
    Coarse,
    Normal,
    Fine,
}

/// Solves the cases of the convergence map, each cold.
#[derive(Parser)]
struct Args {
    /// Only cases whose names contain all of these, such as `barus` or `M10000-L1`
    filters: Vec<String>,
    /// Which of the maps
    #[arg(long, value_enum, default_value_t = Map::Rolling)]
    map: Map,
    /// Only contacts of one kind
    #[arg(long)]
    kind: Option<Kind>,
    /// Only every n-th of the cases that are left
    #[arg(long, default_value_t = 1)]
    every: usize,
    /// Where the count of `--every` starts
    #[arg(long, default_value_t = 0)]
    offset: usize,
    /// Mesh preset instead of the default
    #[arg(long)]
    preset: Option<Preset>,
    /// CPU seconds after which a case is stopped
    #[arg(long)]
    limit: Option<f64>,
    /// Folder of the results, from the root of the repository
    #[arg(long, default_value = "target/map")]
    output: PathBuf,
    /// Write the case files into the output folder instead of solving
    #[arg(long)]
    write: bool,
    /// List the cases instead of solving
    #[arg(long)]
    list: bool,
    /// Print every Newton iteration
    #[arg(long, short)]
    verbose: bool,
    /// Given by cargo
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> std::io::Result<()> {
    let args = Args::parse();
    let all = match args.map {
        Map::Rolling => cases::cases(),
        Map::Sliding => sliding::cases(),
        Map::Machine => machine::cases(),
    };
    let n_all = all.len();
    let selected: Vec<_> = all
        .into_iter()
        .filter(|c| match args.kind {
            Some(Kind::Line) => c.kind == ContactKind::Line,
            Some(Kind::Circular) => c.kind == ContactKind::Circular,
            Some(Kind::Elliptical) => c.kind == ContactKind::Elliptical,
            Some(Kind::Roller) => c.kind == ContactKind::Roller,
            None => true,
        })
        .filter(|c| args.filters.iter().all(|f| c.name.contains(f.as_str())))
        .skip(args.offset)
        .step_by(args.every.max(1))
        .collect();
    if args.list {
        selected.iter().for_each(|c| println!("{}", c.name));
        println!("{} of {n_all} cases", selected.len());
        return Ok(());
    }
    // Cargo runs benches in the folder of the package.
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = root.join(&args.output);
    fs::create_dir_all(&folder)?;
    if args.write {
        for case in &selected {
            fs::write(folder.join(format!("{}.toml", case.name)), &case.text)?;
        }
        println!("{} case files in {}", selected.len(), folder.display());
        return Ok(());
    }

    let settings = Settings {
        preset: args.preset.map(|p| match p {
            Preset::Coarse => MeshPreset::Coarse,
            Preset::Normal => MeshPreset::Normal,
            Preset::Fine => MeshPreset::Fine,
        }),
        limit: args.limit.map(Duration::from_secs_f64),
        verbose: args.verbose,
    };
    let mut table = fs::File::create(folder.join("map.csv"))?;
    writeln!(table, "{}", Record::CSV_HEAD)?;
    let mut records = Vec::new();
    let clock = Instant::now();
    for (i, case) in selected.iter().enumerate() {
        let record = record::run(case, settings);
        println!("[{:3}/{}] {}", i + 1, selected.len(), record.line());
        writeln!(table, "{}", record.csv())?;
        records.push(record);
    }
    let text = summary::markdown(&records, n_all);
    println!("\n{text}");
    println!("{:.0} s in all", clock.elapsed().as_secs_f64());
    fs::write(folder.join("map.md"), text)?;
    fs::write(folder.join("map.svg"), picture::svg(&records))?;
    println!("map.csv, map.md and map.svg in {}", folder.display());
    Ok(())
}
