//! The map in a table.

use std::fmt::Write;

use ertel::contact::ContactKind;

use crate::cases::Family;
use crate::record::Record;

/// Counts, iterations and times by kind and law, and the cases that did not converge.
pub fn markdown(records: &[Record], n_all: usize) -> String {
    let mut text = String::from(
        "| contact | viscosity | cases | converged | Newton median | most | Krylov per Newton | wall s median | most | CPU s median | film under 1 nm |\n\
         |---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for (kind, label) in [
        (ContactKind::Line, "line"),
        (ContactKind::Circular, "circular"),
        (ContactKind::Elliptical, "elliptical"),
        (ContactKind::Roller, "roller"),
    ] {
        let of_kind: Vec<&Record> = records.iter().filter(|r| r.kind == kind).collect();
        for family in Family::ALL {
            let part: Vec<&Record> = of_kind
                .iter()
                .filter(|r| r.family == family)
                .copied()
                .collect();
            row(&mut text, label, family.name(), &part);
        }
        row(&mut text, label, "all", &of_kind);
    }
    let failed: Vec<&Record> = records.iter().filter(|r| !r.converged()).collect();
    // Writing into a String cannot fail
    let _ = writeln!(
        text,
        "\n{} of {} cases converged ({n_all} in the whole map).",
        records.len() - failed.len(),
        records.len()
    );
    if !failed.is_empty() {
        text.push_str(
            "\n| not converged | M | L | p_h GPa | s | why |\n|---|---|---|---|---|---|\n",
        );
    }
    for r in failed {
        let _ = writeln!(
            text,
            "| {} | {:.4} | {:.4} | {:.2} | {:.1} | {} |",
            r.name,
            r.m,
            r.l,
            r.pressure / 1e9,
            r.wall,
            r.status()
        );
    }
    text
}

fn row(text: &mut String, kind: &str, law: &str, part: &[&Record]) {
    if part.is_empty() {
        return;
    }
    let converged: Vec<&&Record> = part.iter().filter(|r| r.converged()).collect();
    let sorted = |value: fn(&Record) -> f64| {
        let mut values: Vec<f64> = converged.iter().map(|r| value(r)).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    let middle = |v: &[f64]| v.get(v.len() / 2).copied().unwrap_or(f64::NAN);
    let last = |v: &[f64]| v.last().copied().unwrap_or(f64::NAN);
    let newton = sorted(|r| r.newton as f64);
    let krylov = sorted(|r| r.krylov as f64 / r.newton as f64);
    let (wall, cpu) = (sorted(|r| r.wall), sorted(|r| r.cpu));
    let thin = converged
        .iter()
        .filter(|r| r.film_minimum.is_some_and(|e| e.value < 1e-9))
        .count();
    let _ = writeln!(
        text,
        "| {kind} | {law} | {} | {} | {:.0} | {:.0} | {:.1} | {:.2} | {:.2} | {:.2} | {thin} |",
        part.len(),
        converged.len(),
        middle(&newton),
        last(&newton),
        middle(&krylov),
        middle(&wall),
        last(&wall),
        middle(&cpu),
    );
}
