//! `ertel fluids`.

use std::path::Path;

use ertel::output::pictures::{ViscosityCurve, viscosity_chart};
use ertel::words::{digits, pressure};
use ertel_quantity::Dimension;
use ertel_rheology::database::Kind;
use ertel_rheology::shear::ShearLaw;
use ertel_rheology::{DensityLaw, Fluid, ShearThinning, database};

use crate::args::{FluidsArgs, FluidsCommand};
use crate::failure::Failure;
use crate::inputs;
use crate::picture;
use crate::print;
use crate::provenance::{data, notes};
use crate::table::{columns, paragraph};

/// Pressures of the table, Pa.
const PRESSURES: [f64; 10] = [
    0.0, 0.05e9, 0.1e9, 0.2e9, 0.3e9, 0.4e9, 0.5e9, 0.6e9, 0.8e9, 1e9,
];
/// Shear stresses of the table, Pa.
const STRESSES: [f64; 7] = [0.0, 1e4, 1e5, 0.3e6, 1e6, 3e6, 1e7];
/// Ranges that end below are extended to 0.1 GPa, with room for a label, Pa.
const SHORT_RANGE: f64 = 0.08e9;
/// Points of the curve in the picture.
const N_POINTS: usize = 201;

/// Runs the command.
///
/// # Errors
///
/// An unknown name, a bad temperature, a picture or stdout that cannot be written.
pub fn run(arguments: &FluidsArgs) -> Result<(), Failure> {
    match &arguments.command {
        None | Some(FluidsCommand::List) => print::report(&list()?),
        Some(FluidsCommand::Show {
            name,
            temperature,
            plot,
            force,
        }) => {
            if let Some(path) = plot {
                picture::check(path)?;
                inputs::refuse_existing(&[path], *force)?;
            }
            let fluid = database::fluid_or_file(name, Path::new(""), None)?;
            let temperature = state_temperature(&fluid, temperature.as_deref())?;
            if let Some(path) = plot {
                write_plot(path, &fluid, temperature)?;
            }
            print::report(&show(&fluid, temperature))
        }
    }
}

fn list() -> Result<String, Failure> {
    let mut rows = Vec::new();
    for name in names(Kind::Fluid) {
        let fluid = database::fluid_or_file(&name, Path::new(""), None)?;
        let density = fluid
            .density
            .as_ref()
            .map_or("no density law", DensityLaw::name);
        let thinning = fluid
            .shear_thinning
            .as_ref()
            .map_or_else(|| "no thinning law".to_owned(), ShearThinning::describe);
        rows.push(vec![
            name,
            fluid.viscosity.name().to_owned(),
            density.to_owned(),
            thinning,
            fluid.title,
        ]);
    }
    Ok(format!(
        "Fluids (`ertel fluids show NAME` for the data and their sources):\n\n{}",
        columns(&rows)
    ))
}

/// Names of the own data, then those of the database.
pub fn names(kind: Kind) -> Vec<String> {
    let own = database::own_data();
    let (own, shipped) = match kind {
        Kind::Fluid => (own.map(|own| &own.fluids), database::fluid_names()),
        Kind::Solid => (own.map(|own| &own.solids), database::solid_names()),
    };
    let own = own.cloned().unwrap_or_default();
    let shipped = shipped.into_iter().map(str::to_owned);
    let others: Vec<String> = shipped.filter(|name| !own.contains(name)).collect();
    own.into_iter().chain(others).collect()
}

/// The temperature asked for, or the fluid's own, K.
fn state_temperature(fluid: &Fluid, asked: Option<&str>) -> Result<f64, Failure> {
    if let Some(text) = asked {
        let temperature = ertel_quantity::parse(text, Dimension::TEMPERATURE)?;
        return if (100.0..=1000.0).contains(&temperature) {
            Ok(temperature)
        } else {
            Err(Failure::Argument(format!(
                "--temperature {text} is {} °C; it must be between -173.15 °C and 726.85 °C",
                digits(temperature - 273.15, 6)
            )))
        };
    }
    if let Some(temperature) = fluid.reference_temperature {
        return Ok(temperature);
    }
    if depends_on_temperature(fluid) {
        return Err(Failure::Argument(format!(
            "the data of `{}` have no temperature; give one, such as --temperature \"40 degC\"",
            fluid.name
        )));
    }
    Ok(293.15)
}

fn depends_on_temperature(fluid: &Fluid) -> bool {
    let state = |temperature: f64| {
        [0.0, 0.5e9].map(|p| {
            let density = fluid.density(p, temperature).ok();
            (fluid.viscosity(p, temperature), density)
        })
    };
    state(300.0) != state(350.0)
}

fn show(fluid: &Fluid, temperature: f64) -> String {
    let mut text = format!("{}: {}\n\n", fluid.name, fluid.title);
    text += &data(&fluid.provenance);
    if let Some(base_oil) = fluid.base_oil {
        let estimates = fluid.estimates_by_kind();
        if !estimates.is_empty() {
            text += &format!(
                "\nEstimates by the kind of the base oil ({}), where a case asks for them: `[thermal]`, `shear_thinning = {{ law = \"estimate\" \
                 }}`\n\n",
                base_oil.name()
            );
            text += &data(&estimates);
        }
    }
    text += "\nRange of the data\n";
    text += &range(fluid);
    text += &notes(&fluid.notes);
    text += &if depends_on_temperature(fluid) {
        format!(
            "\nAt {} °C ({} K)\n",
            digits(temperature - 273.15, 5),
            digits(temperature, 6)
        )
    } else {
        "\nAt any temperature\n".to_owned()
    };
    let per_gpa = |alpha: f64| format!("{} 1/GPa", digits(1e9 * alpha, 4));
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    let asymptotic = fluid.pressure_viscosity_reciprocal_asymptotic(temperature);
    text += &columns(&[
        row(
            "initial slope of ln viscosity, α",
            per_gpa(fluid.pressure_viscosity_slope(temperature)),
        ),
        row(
            "reciprocal asymptotic coefficient, α*",
            asymptotic.map_or_else(|error| format!("none: {error}"), per_gpa),
        ),
    ]);
    text.push('\n');
    text += &states(fluid, temperature);
    if let Some(law) = &fluid.shear_thinning {
        text += &thinning(law, fluid, temperature);
    }
    text
}

/// Viscosity ratio under shear stress, and the ends of the Newtonian plateaus, at ambient pressure.
fn thinning(law: &ShearThinning, fluid: &Fluid, temperature: f64) -> String {
    let mu_1 = fluid.viscosity(0.0, temperature);
    let [first, second] = law.newtonian_limits(0.0);
    let stress = |stress: Option<f64>| stress.map_or_else(|| "none".to_owned(), pressure);
    let plateau = law.law.as_ref().and_then(ShearLaw::plateau_ratio);
    let mut rows = vec![
        vec![
            "end of the first Newtonian plateau, η = 0.95 µ₁".to_owned(),
            stress(first),
        ],
        vec![
            "start of the second, η = 1.05 µ₂".to_owned(),
            stress(second),
        ],
    ];
    if let Some(ratio) = plateau.filter(|ratio| *ratio > 0.0) {
        rows.push(vec![
            "second plateau over first, µ₂/µ₁".to_owned(),
            digits(ratio, 4),
        ]);
    }
    let mut states = vec![
        ["shear stress τ", "viscosity η", "η/µ₁"]
            .map(str::to_owned)
            .to_vec(),
    ];
    for tau in STRESSES {
        let share = 1.0 / law.relative_fluidity(tau * tau, 0.0);
        states.push(vec![
            pressure(tau),
            viscosity(share * mu_1),
            digits(share, 4),
        ]);
    }
    format!(
        "\nShear thinning at ambient pressure ({})\n{}\n{}",
        law.describe(),
        columns(&rows),
        columns(&states)
    )
}

/// Pressures and temperatures for which the data hold.
fn range(fluid: &Fluid) -> String {
    let Some(validity) = &fluid.validity else {
        return "  not known\n".to_owned();
    };
    let pressures = validity
        .pressure
        .map(|(low, high)| format!("{} to {}", pressure(low), pressure(high)));
    let temperatures = validity.temperature.map(|(low, high)| {
        format!(
            "{} to {} °C",
            digits(low - 273.15, 5),
            digits(high - 273.15, 5)
        )
    });
    let ends: Vec<String> = [pressures, temperatures].into_iter().flatten().collect();
    paragraph("  ", &format!("{} ({})", ends.join(", "), validity.source))
}

/// Viscosity and density over pressure, and conductivity and heat capacity where they change; states outside the range
/// of the data are marked.
fn states(fluid: &Fluid, temperature: f64) -> String {
    let mut heading = vec!["pressure p", "viscosity µ", "density ρ"];
    let conductivity = fluid.thermal_conductivity.as_ref();
    let conductivity = conductivity.filter(|law| law.constant_value().is_none());
    let heat_capacity = fluid.heat_capacity.as_ref();
    let heat_capacity = heat_capacity.filter(|law| law.constant_value().is_none());
    heading.extend(conductivity.map(|_| "conductivity k"));
    heading.extend(heat_capacity.map(|_| "heat capacity c"));
    let mut rows: Vec<Vec<String>> = vec![heading.into_iter().map(str::to_owned).collect()];
    let mut extrapolated = false;
    for p in PRESSURES {
        let outside = fluid
            .highest_pressure_of_viscosity(temperature)
            .is_some_and(|end| p > end)
            || !fluid.check_range_with_heat(p, temperature).is_empty();
        extrapolated |= outside;
        let mark = if outside { " *" } else { "" };
        let mut row = vec![
            pressure(p) + mark,
            viscosity(fluid.viscosity(p, temperature)),
            fluid.density(p, temperature).map_or_else(
                |_| "no law".to_owned(),
                |density| format!("{} kg/m³", digits(density, 5)),
            ),
        ];
        row.extend(
            conductivity
                .map(|law| format!("{} W/(m.K)", digits(law.conductivity(p, temperature), 4))),
        );
        row.extend(
            heat_capacity
                .map(|law| format!("{} J/(kg.K)", digits(law.heat_capacity(p, temperature), 4))),
        );
        rows.push(row);
    }
    let remark = if extrapolated {
        "  * outside the range of the data\n"
    } else {
        ""
    };
    columns(&rows) + remark
}

fn viscosity(value: f64) -> String {
    match value {
        mu if mu < 1.0 => format!("{} mPa.s", digits(1e3 * mu, 4)),
        mu => format!("{} Pa.s", digits(mu, 4)),
    }
}

/// Pressure (Pa) up to which the curve is drawn, where the viscosity is known up to `end`.
fn drawn_to(fluid: &Fluid, end: Option<f64>) -> f64 {
    let is_declared = fluid
        .validity
        .as_ref()
        .is_some_and(|v| v.pressure.is_some());
    match end {
        Some(end) if end < SHORT_RANGE => 0.1e9,
        Some(end) if is_declared => end.min(3e9),
        // No range of the data: up to 1 GPa, where most contacts are.
        other => other.map_or(1e9, |end| end.min(1e9)),
    }
}

/// Writes the curve of viscosity over pressure as a picture.
fn write_plot(path: &Path, fluid: &Fluid, temperature: f64) -> Result<(), Failure> {
    let end = fluid.highest_pressure_of_viscosity(temperature);
    let valid = end.map(|end| {
        let declared = fluid.validity.as_ref().and_then(|v| v.pressure);
        [declared.map_or(0.0, |(low, _)| low).min(end), end]
    });
    let highest = drawn_to(fluid, end);
    let pressures: Vec<f64> = (0..N_POINTS)
        .map(|i| highest * i as f64 / (N_POINTS - 1) as f64)
        .collect();
    let curve = ViscosityCurve {
        temperature,
        viscosity: pressures
            .iter()
            .map(|p| fluid.viscosity(*p, temperature))
            .collect(),
        pressure: pressures,
    };
    let chart = viscosity_chart(&fluid.title, &[curve], valid);
    picture::write(path, &chart.drawing())
}
