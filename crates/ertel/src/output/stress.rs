//! Stresses in the bodies: report and `stress.csv`.

use std::io::{self, Write};

use super::figure::{BODIES, estimate, number, percent, place, pressure_estimate, unresolved};
use super::lines::Lines;
use crate::mark::of_figure;
use crate::solution::{Estimate, Figure, Located, Solution};
use crate::stress::{
    BodyStresses, COMPONENTS, Extreme, Layer, Life, Lives, OverDepth, Profile, Shakedown,
    ShakedownBy, Site, Stresses,
};
use crate::words::{digits, length, pressure};

/// The stresses of both bodies, if there are any.
pub(super) fn write_results(out: &mut Lines, solution: &Solution) {
    let Some(stresses) = &solution.stresses else {
        return;
    };
    out.heading("Stresses in the bodies");
    out.row(
        "pressure on their grid over load",
        percent(Estimate {
            value: stresses.load_share,
            error: None,
        }),
    );
    write_dry(out, stresses);
    for (role, body) in BODIES.into_iter().zip(&stresses.bodies) {
        write_body(out, role, body, solution, stresses);
    }
    out.note("x, y: along and across the motion; traction: on the body, along x. Lives: over those of the dry contact without friction and without fatigue limit.");
    if stresses
        .bodies
        .iter()
        .any(|body| body.total_von_mises.is_some())
    {
        out.note("The given residual stress is in the indices of Dang Van and of Fatemi and Socie and in von Mises over yield strength. Shakedown does not depend on it: its theorem takes the best one.");
    }
    if stresses.bodies.iter().any(|body| !body.parts.is_empty()) {
        out.note("Lives of bodies with layers are those of the substrate, over those of the dry contact of a body without layers. σ_zz above zero pulls at an interface.");
    }
    for mark in of_figure(solution, Figure::VonMisesBody1).iter() {
        out.note(&format!("stresses: {}", mark.words()));
    }
    if !solution.unresolved.is_empty() {
        let all: Vec<String> = solution.unresolved.iter().map(unresolved).collect();
        out.note(&format!(
            "The contact is not resolved: {}. The stresses are those of its pressure and shear as they are, their bars may be too narrow.",
            all.join("; ")
        ));
    }
}

fn write_dry(out: &mut Lines, stresses: &Stresses) {
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
}

fn write_body(
    out: &mut Lines,
    role: &str,
    body: &BodyStresses,
    solution: &Solution,
    stresses: &Stresses,
) {
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
        out.row(&format!("  {name}"), at_place(extreme, solution));
    }
    out.row(
        &format!("  Dang Van (α {})", digits(stresses.dang_van_weight, 3)),
        at_depth(&body.dang_van, pressure_estimate),
    );
    out.row(
        "  Dang Van near the surface",
        at_depth(&body.near_surface_dang_van, pressure_estimate),
    );
    out.row("  shakedown", shakedown(&body.shakedown));
    if let Some(total) = &body.total_von_mises {
        out.row(
            "  von Mises with residual stress",
            at_depth(total, pressure_estimate),
        );
    }
    if let Some(utilisation) = &body.utilisation {
        out.row(
            "  von Mises over yield strength",
            at_depth(utilisation, percent),
        );
    }
    write_layers(out, body, solution);
    for lives in &body.lives {
        out.row("  relative life", life(lives));
    }
}

/// Each layer, the substrate, and the interfaces.
fn write_layers(out: &mut Lines, body: &BodyStresses, solution: &Solution) {
    for part in &body.parts {
        let name = (part.layer).map_or("substrate".to_owned(), |layer| format!("layer {layer}"));
        for (what, extreme) in [
            ("von Mises", &part.von_mises),
            ("largest shear", &part.largest_shear),
            ("tension", &part.tension),
        ] {
            out.row(&format!("  {name}: {what}"), at_place(extreme, solution));
        }
        if let Some(utilisation) = &part.utilisation {
            out.row(
                &format!("  {name}: von Mises over yield strength"),
                at_depth(utilisation, percent),
            );
        }
    }
    for interface in &body.interfaces {
        for (what, extreme) in [("shear", &interface.shear), ("σ_zz", &interface.pull)] {
            out.row(
                &format!("  interface {}: largest {what}", interface.interface),
                at_place(extreme, solution),
            );
        }
    }
}

/// A place in layers, in words.
fn within(site: Option<Site>) -> String {
    let Some(site) = site else {
        return String::new();
    };
    let part = (site.layer).map_or("substrate".to_owned(), |layer| format!("layer {layer}"));
    match site.interface {
        Some(interface) => format!(", interface {interface}, {part} side"),
        None => format!(
            ", in {}{part}",
            if site.layer.is_none() { "the " } else { "" }
        ),
    }
}

fn shakedown(found: &Shakedown) -> String {
    let (words, stress) = match found.by {
        ShakedownBy::OrthogonalShear => ("", "σ_xz"),
        ShakedownBy::SmallestSphere => ("at most ", "a shear path"),
    };
    let mut text = format!(
        "elastic up to {words}p_h/k {}, by {stress} of {}",
        digits(found.pressure_over_yield, 4),
        at_depth(&found.shear, pressure_estimate)
    );
    if let Some(safety) = found.safety {
        text.push_str(&format!("; k over it {}", at_depth(&safety, number)));
    }
    text
}

/// A value with its bar and its depth.
fn at_depth(found: &OverDepth, words: impl Fn(Estimate) -> String) -> String {
    let value = words(Estimate {
        value: found.value,
        error: Some(found.error),
    });
    let (depth, within) = (length(found.depth), within(found.site));
    format!("{value} at depth {depth}{within}")
}

/// Distance from the plane of motion over the half-width that counts as none.
const MIDDLE: f64 = 5e-4;

fn at_place(extreme: &Extreme, solution: &Solution) -> String {
    let value = pressure_estimate(Estimate {
        value: extreme.value,
        error: Some(extreme.error),
    });
    // Places across are those of parabolas, zero up to rounding.
    let is_middle = extreme.y.abs() < MIDDLE * solution.hertz.half_width;
    let at = Located {
        value: extreme.value,
        error: Some(extreme.error),
        resolved: true,
        x: extreme.x,
        y: if is_middle { 0.0 } else { extreme.y },
        place_error: None,
        place_resolved: true,
    };
    let depth = Estimate {
        value: extreme.depth,
        error: Some(extreme.depth_error),
    };
    format!(
        "{value} {}, depth {}{}",
        place(solution, &at),
        estimate(&depth),
        within(extreme.site)
    )
}

fn life(lives: &Lives) -> String {
    let shown = |life: Life| {
        number(Estimate {
            value: life.value,
            error: Some(life.error),
        })
    };
    let by_volume = (lives.integral).map(|life| life.map_or_else(|| "unlimited".to_owned(), shown));
    let [half, own, twice] = by_volume;
    let [half_largest, largest, twice_largest] = lives.largest_stress.map(shown);
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
        "body,below,x_m,y_m,depth_m,{components},von_mises_Pa,largest_shear_Pa,orthogonal_range_Pa,layer"
    )?;
    for (i, body) in stresses.bodies.iter().enumerate() {
        for (below, profile) in [("middle", &body.axis), ("largest", &body.below_largest)] {
            write_profile(
                &mut out,
                &format!("{},{below}", i + 1),
                profile,
                &body.layers,
            )?;
        }
    }
    Ok(())
}

fn write_profile(
    out: &mut impl Write,
    start: &str,
    profile: &Profile,
    layers: &[Layer],
) -> io::Result<()> {
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
        let layer = layers[i].site.and_then(|site| site.layer);
        let layer = layer.map_or(String::new(), |layer| layer.to_string());
        writeln!(out, "{start},{},{layer}", numbers.join(","))?;
    }
    Ok(())
}
