//! Pressure orders at equal error: `cargo bench -p ertel --bench orders`.
//!
//! Each order is refined until the error bars of both films are within the target. Unknowns of the last
//! mesh, of all meshes together, and wall seconds.

#[path = "../tests/common/mod.rs"]
mod common;

use ertel::contact::ContactKind;
use ertel::params::MeshParams;
use ertel::run::solve;
use ertel::solve::Silent;

fn main() {
    println!(
        "contact   M     L    target  order       U   all U      P   wall s   bar h_c  bar h_min"
    );
    for (kind, m, l) in [
        (ContactKind::Line, 200.0, 10.0),
        (ContactKind::Line, 1000.0, 5.0),
        (ContactKind::Circular, 200.0, 10.0),
    ] {
        for target in [5e-3, 2e-3] {
            for order in 2..=5 {
                let mut case = common::moes_case(kind, m, l);
                case.mesh = MeshParams {
                    pressure_order: order,
                    ..MeshParams::adaptive(target, kind)
                };
                print!("{kind:<9?} {m:<5} {l:<4} {target:<7} {order:<6}");
                match solve(&case, &mut Silent) {
                    Ok(s) => {
                        let last = s.stats.levels.last().expect("a stage");
                        let all: usize = s.stats.levels.iter().map(|l| l.n_displacement_dofs).sum();
                        let bar =
                            |e: ertel::solution::Estimate| e.error.unwrap_or(f64::NAN) / e.value;
                        println!(
                            "{:>8} {all:>7} {:>6} {:>8.2} {:>9.1e} {:>9.1e}",
                            last.n_displacement_dofs,
                            last.n_pressure_dofs,
                            s.stats.wall_seconds,
                            bar(s.summary.film_central),
                            bar(s.summary.film_minimum)
                        );
                    }
                    Err(e) => println!("{e}"),
                }
            }
        }
    }
}
