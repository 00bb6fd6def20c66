//! Stresses in the bodies: report and `stress.csv`.

use std::io::{self, Write};

use super::BODIES;
use super::figure::{percent, pressure_estimate};
use super::lines::Lines;
use crate::solution::{Estimate, Solution};
use crate::stress::{BodyStresses, COMPONENTS, Extreme, Lives, Profile, Stresses};
use crate::words::{digits, length, pressure};

/// The stresses of both bodies, if there are any.
pub(super) fn write_results(out: &mut Lines, solution: &Solution) {
    let Some(stresses) = &solution.stresses else {
        return;
    };
    out.heading("Stresses in the bodies");
    let share = Estimate {
        value: stresses.load_share,
        error: None,
    };
    out.row("pressure on their grid over load", percent(share));
    let dry = &stresses.dry;
    let mut text = format!(
        "von Mises {} at depth {}, largest shear {}",
        pressure(dry.von_mises.value),
        length(dry.von_mises.depth),
        pressure(dry.largest_shear.value)
    );
    if let Some(shear) = dry.orthogonal_half_range {
        text.push_str(&format!(
            ", half range of orthogonal shear {} at {}",
            pressure(shear.value),
            length(shear.depth)
        ));
    }
    out.row("dry contact without friction", text);
    for (role, body) in BODIES.into_iter().zip(&stresses.bodies) {
        write_body(out, role, body, stresses);
    }
    out.note("x: along the motion; traction: on the body, along x. Lives: over those of the dry contact without friction and without fatigue limit.");
}

fn write_body(out: &mut Lines, role: &str, body: &BodyStresses, stresses: &Stresses) {
    out.row(&format!("{role}: traction/load"), digits(body.traction, 4));
    for (name, extreme) in [
        ("largest von Mises stress", &body.von_mises),
        ("largest shear stress", &body.largest_shear),
        ("largest tension", &body.tension),
        (
            "half range of orthogonal shear",
            &body.orthogonal_half_range,
        ),
    ] {
        out.row(&format!("  {name}"), at_place(extreme));
    }
    let index = &body.dang_van;
    out.row(
        &format!("  Dang Van (α {})", digits(stresses.dang_van_weight, 3)),
        format!("{} at depth {}", pressure(index.value), length(index.depth)),
    );
    if let Some(shakedown) = &body.shakedown {
        let mut text = format!(
            "elastic up to p_h/k {}, by σ_xz of {}",
            digits(shakedown.pressure_over_yield, 4),
            at_place(&shakedown.shear)
        );
        if let Some(safety) = shakedown.safety {
            text.push_str(&format!("; k over σ_xz at least {}", digits(safety, 3)));
        }
        out.row("  shakedown", text);
    }
    if let Some(utilisation) = &body.utilisation {
        let share = Estimate {
            value: utilisation.value,
            error: None,
        };
        out.row(
            "  von Mises over yield strength",
            format!("{} at depth {}", percent(share), length(utilisation.depth)),
        );
    }
    for lives in &body.lives {
        out.row("  relative life", life(lives));
    }
}

fn at_place(extreme: &Extreme) -> String {
    let value = pressure_estimate(Estimate {
        value: extreme.value,
        error: Some(extreme.error),
    });
    let (x, depth) = (length(extreme.x), length(extreme.depth));
    format!("{value} at x {x}, depth {depth}")
}

fn life(lives: &Lives) -> String {
    let number = |life: Option<f64>| life.map_or("unlimited".to_owned(), |life| digits(life, 3));
    let [half, own, twice] = lives.integral.map(number);
    let [half_largest, largest, twice_largest] = lives.largest_stress.map(|life| digits(life, 3));
    format!(
        "{own} by volume, {largest} by largest stress ({}, from depth {}; from half and twice that {half} and {twice}, {half_largest} and {twice_largest})",
        lives.criterion.words(),
        length(lives.cut_depth[1]),
    )
}

/// Writes the stresses below the middle of the contact and below the largest stress after von Mises of both bodies, SI, one line per depth.
///
/// # Errors
/// Those of the writer.
pub(super) fn write_profiles(mut out: impl Write, stresses: &Stresses) -> io::Result<()> {
    let components = COMPONENTS.map(|name| format!("stress_{name}_Pa")).join(",");
    writeln!(
        out,
        "body,below,x_m,y_m,depth_m,{components},von_mises_Pa,largest_shear_Pa,orthogonal_range_Pa"
    )?;
    for (i, body) in stresses.bodies.iter().enumerate() {
        for (below, profile) in [("middle", &body.axis), ("largest", &body.below_largest)] {
            write_profile(&mut out, &format!("{},{below}", i + 1), profile)?;
        }
    }
    Ok(())
}

fn write_profile(out: &mut impl Write, start: &str, profile: &Profile) -> io::Result<()> {
    for (i, (depth, stress)) in profile.depth.iter().zip(&profile.stress).enumerate() {
        let numbers = [profile.x, profile.y, *depth]
            .into_iter()
            .chain(stress.0)
            .chain([
                stress.von_mises(),
                stress.largest_shear(),
                profile.orthogonal_range[i],
            ]);
        let numbers: Vec<String> = numbers.map(|v| format!("{v:e}")).collect();
        writeln!(out, "{start},{}", numbers.join(","))?;
    }
    Ok(())
}
