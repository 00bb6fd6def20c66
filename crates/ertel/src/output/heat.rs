//! Heat in the report: thermal data, temperatures and effects of a case; profiles across the film.

use std::io::{self, Write};

use super::figure::{number, percent, power};
use super::lines::Lines;
use super::results::write_section;
use crate::case::{HeatEcho, ThermalEcho};
use crate::output::figure::BODIES;
use crate::solution::{CrossProfile, Section, Solution, Thermal};
use crate::words::{CELSIUS, digits};

/// The thermal data of lubricant and bodies.
pub(super) fn write(out: &mut Lines, thermal: &ThermalEcho) {
    let of = |material: &HeatEcho| {
        let law = |name: &str| match name {
            "constant" => String::new(),
            name => format!(" ({name})"),
        };
        format!(
            "{} W/(m.K){}, heat capacity {} J/(kg.K){}",
            digits(material.thermal_conductivity, 4),
            law(&material.conductivity_law),
            digits(material.heat_capacity, 4),
            law(&material.heat_capacity_law),
        )
    };
    out.row("conductivity, lubricant", of(&thermal.lubricant));
    let params = &thermal.params;
    for (role, material, temperature) in [
        (BODIES[0], &thermal.body_1, params.body_1_temperature),
        (BODIES[1], &thermal.body_2, params.body_2_temperature),
    ] {
        let bulk = temperature.map_or(String::new(), |t| {
            format!(", bulk {} °C", digits(t - CELSIUS, 5))
        });
        out.row(&format!("conductivity, {role}"), of(material) + &bulk);
        for layer in &material.layers {
            out.row("  layer", of(layer));
        }
    }
}

/// Temperatures, heat, and the effects on film and traction.
pub(super) fn write_results(out: &mut Lines, solution: &Solution, thermal: &Thermal) {
    out.heading("Heat");
    write_section(out, solution, Section::Temperature);
    write_section(out, solution, Section::Heat);
    if let Some(r) = &thermal.reduction {
        let mut text = format!(
            "h_c {}, h_min {}",
            percent(r.film_central),
            percent(r.film_minimum)
        );
        if let Some(traction) = r.traction {
            text.push_str(&format!(
                ", traction {} (isothermal {})",
                percent(traction),
                number(r.isothermal_traction)
            ));
        }
        out.row("reduction by heat", text);
    }
    let c = &thermal.coupling;
    let contraction = match c.rounds {
        0 | 1 => String::new(),
        _ => format!(
            ", each change {} times the previous one",
            digits(c.contraction, 2)
        ),
    };
    let rounds = if c.rounds == 1 { "round" } else { "rounds" };
    out.row(
        "film-temperature coupling",
        format!(
            "{} {rounds}{contraction}, last change {}",
            c.rounds,
            power(c.change)
        ),
    );
}

/// Columns of the profiles across the film.
const PROFILE_COLUMNS: &str = "x_m,y_m,x_over_a,y_over_a,film_thickness_m,z_m,z_over_h,temperature_K,\
    velocity_x_m_per_s,velocity_y_m_per_s,shear_rate_per_s,generalized_viscosity_Pa_s";

/// Writes SI profiles across the film, one line per height; `half_width` is a in m.
///
/// # Errors
/// Those of the writer.
pub(super) fn write_profiles(
    mut out: impl Write,
    profiles: &[CrossProfile],
    half_width: f64,
) -> io::Result<()> {
    writeln!(out, "{PROFILE_COLUMNS}")?;
    for p in profiles {
        for (i, z) in p.z.iter().enumerate() {
            let row = [
                p.x,
                p.y,
                p.x / half_width,
                p.y / half_width,
                p.film_thickness,
                *z,
                z / p.film_thickness,
                p.temperature[i],
                p.velocity_x[i],
                p.velocity_y[i],
                p.shear_rate[i],
                p.viscosity[i],
            ];
            let row: Vec<String> = row.iter().map(|v| format!("{v:e}")).collect();
            writeln!(out, "{}", row.join(","))?;
        }
    }
    Ok(())
}

/// Place of a profile in half-widths, for legends.
pub(super) fn profile_label(profile: &CrossProfile, half_width: f64) -> String {
    let (x, y) = (profile.x / half_width, profile.y / half_width);
    // Rounds off the error of a product and a quotient by the same number.
    let round = |v: f64| digits((1e6 * v).round() / 1e6, 4).replace('-', "−");
    match y {
        0.0 => format!("*x*/*a* = {}", round(x)),
        _ => format!("*x*/*a* = {}, *y*/*a* = {}", round(x), round(y)),
    }
}
