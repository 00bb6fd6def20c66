//! Whether the error bars of finite volumes hold, and whether they say anything: figures at several targets against those of finer grids.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use ertel::engine::NoObserver;
use ertel::params::Method;
use ertel::run::solve;
use ertel::solution::{Figure, Solution};

use crate::contacts::Trial;

/// Targets whose bars are tried.
const TARGETS: [f64; 3] = [0.03, 0.01, 0.002];
/// That of the reference: one to two grids more than the last of them.
const REFERENCE: f64 = 3e-4;
/// Unknowns of the reference at most.
const MOST: usize = 200_000;

/// A figure at a target.
struct Row {
    contact: String,
    family: String,
    target: f64,
    figure: Figure,
    value: f64,
    bar: f64,
    reference: f64,
    reference_bar: f64,
}

impl Row {
    fn difference(&self) -> f64 {
        (self.value - self.reference).abs()
    }

    /// Difference from the reference over the bar.
    fn off(&self) -> f64 {
        self.difference() / self.bar
    }
}

/// Solves all, writes every comparison to `csv`, and prints the tables by figure and by family.
pub fn calibrate(trials: &[Trial], csv: Option<&Path>) {
    let mut table =
        String::from("contact,family,target,figure,value,bar,reference,reference_bar\n");
    let mut rows = Vec::new();
    for trial in trials {
        let clock = Instant::now();
        let own = compare(trial);
        let covered = own.iter().filter(|r| r.off() <= 1.0).count();
        eprintln!(
            "{}: {covered} of {} within their bars, {:.1} s",
            trial.name,
            own.len(),
            clock.elapsed().as_secs_f64()
        );
        for r in &own {
            // Writing into a String cannot fail
            let _ = writeln!(
                table,
                "{},{},{},{},{:e},{:e},{:e},{:e}",
                r.contact,
                r.family,
                r.target,
                r.figure.name(),
                r.value,
                r.bar,
                r.reference,
                r.reference_bar
            );
        }
        if let Some(path) = csv {
            std::fs::write(path, &table).expect("the table can be written");
        }
        rows.extend(own);
    }
    report(&rows);
}

fn compare(trial: &Trial) -> Vec<Row> {
    let at = |target, most| {
        let case = trial.case(Method::FiniteVolumes, Some((target, most)));
        match solve(&case, &mut NoObserver) {
            Ok(solution) => Some(solution),
            Err(error) => {
                eprintln!("{} at {target}: {error}", trial.name);
                None
            }
        }
    };
    let Some(reference) = at(REFERENCE, MOST) else {
        return Vec::new();
    };
    let finest = |solution: &Solution| solution.stats.levels.len();
    let (mut rows, mut before) = (Vec::new(), 0);
    for target in TARGETS {
        let Some(found) = at(target, MOST) else {
            continue;
        };
        // Grids of the reference or of the target before say nothing new.
        let grids = finest(&found);
        if grids >= finest(&reference) || grids == before {
            continue;
        }
        before = grids;
        for (figure, here) in found.figures() {
            let Some(there) = reference.figure(figure) else {
                continue;
            };
            let (Some(bar), Some(reference_bar)) = (here.error, there.error) else {
                continue;
            };
            // Figures that are zero by symmetry, reported as not resolved, or not resolved by the reference.
            if here.value.abs() < 1e-9 * bar || bar == 0.0 || !here.resolved || reference_bar > bar
            {
                continue;
            }
            rows.push(Row {
                contact: trial.name.clone(),
                family: trial.family.clone(),
                target,
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

fn median(mut of: Vec<f64>) -> f64 {
    of.sort_by(f64::total_cmp);
    of.get(of.len() / 2).copied().unwrap_or(f64::NAN)
}

fn report(rows: &[Row]) {
    let line = |name: &str, rows: &[&Row]| {
        let Some(worst) = rows.iter().max_by(|a, b| a.off().total_cmp(&b.off())) else {
            return;
        };
        let within = |limit: f64| rows.iter().filter(|r| r.off() <= limit).count();
        let covered = within(1.0);
        let share = 100.0 * covered as f64 / rows.len() as f64;
        let width = median(
            rows.iter()
                .map(|r| r.bar / r.difference().max(1e-3 * r.bar))
                .collect(),
        );
        let wide = (rows.iter())
            .filter(|r| r.bar > 0.1 * r.value.abs())
            .count();
        println!(
            "| {name} | {} | {covered} | {share:.1} | {} | {width:.1} | {wide} | {:.2} | {}, {} % |",
            rows.len(),
            within(2.0),
            worst.off(),
            worst.contact,
            100.0 * worst.target
        );
    };
    let head = |what: &str| {
        println!(
            "| {what} | compared | within the bar | % | within twice the bar | median of bar over error | bars above 10 % | worst, in bars | contact, target |\n|---|---|---|---|---|---|---|---|---|"
        );
    };
    head("figure");
    for figure in Figure::ALL {
        let of_figure: Vec<&Row> = rows.iter().filter(|r| r.figure == figure).collect();
        line(figure.name(), &of_figure);
    }
    let all: Vec<&Row> = rows.iter().collect();
    line("all", &all);
    println!();
    head("contacts");
    let mut families: Vec<&str> = Vec::new();
    for row in rows {
        if !families.contains(&row.family.as_str()) {
            families.push(&row.family);
        }
    }
    for family in families {
        let own: Vec<&Row> = rows.iter().filter(|r| r.family == family).collect();
        line(family, &own);
    }
}
