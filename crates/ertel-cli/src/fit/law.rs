//! `ertel fit viscosity` and `ertel fit density`: one law.

use std::path::{Path, PathBuf};

use ertel::files::write_whole;
use ertel::fit::{
    self, Data, DensityError, Fit, FittedLaw, Heading, LawName, Params, Property, Reading, Residual,
};
use ertel::words::{digits, pressure};
use ertel_input::file::read_table;
use ertel_quantity::{Dimension, Unit};
use ertel_rheology::database::Kind;
use ertel_rheology::viscosity::PressureLaw;
use ertel_rheology::{DensityLaw, database};

use crate::args::FitLawArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::picture;
use crate::print;
use crate::table::{columns, paragraph};

/// Fits one law.
///
/// # Errors
///
/// No such law, bad data, a fit that does not exist, files that cannot be written.
pub fn run(property: Property, arguments: &FitLawArgs) -> Result<(), Failure> {
    let law = LawName::ALL
        .into_iter()
        .find(|law| law.name() == arguments.law && law.property() == property)
        .ok_or_else(|| {
            Failure::Argument(format!(
                "--law {}: the laws for the {} are {}; `all` ranks them",
                arguments.law,
                property.name(),
                LawName::choices(property)
            ))
        })?;
    let plot = plot_path(arguments)?;
    keep_inputs(arguments, plot.as_deref())?;
    let params = params(arguments, Some(law))?;
    let data = read(arguments, property, &params, law == LawName::Walther)?;
    let fit = fit::fit(&data, law, &params).map_err(|error| {
        let help = match error {
            fit::FitError::NoEquationOfState
            | fit::FitError::NoDensity
            | fit::FitError::TabulatedDensity => " (--density NAME of a fluid, or FILE.toml)",
            fit::FitError::NoPressures => {
                " (--hold \"alpha=22 1/GPa\" --reference-temperature \"40 degC\", with the figures of the oil)"
            }
            fit::FitError::NoReferenceTemperature => " (--reference-temperature \"40 degC\")",
            fit::FitError::TooFew { .. } if law == LawName::Walther => {
                " (--hold KEY=VALUE; an oil of two viscosities needs no fit: a lubricant takes them as `kinematic_viscosity_40` and \
                 `kinematic_viscosity_100`)"
            }
            fit::FitError::Undetermined { .. }
            | fit::FitError::NoInterval { .. }
            | fit::FitError::TooFew { .. } => " (--hold KEY=VALUE)",
            _ => "",
        };
        Failure::Argument(format!("{}: {error}{help}", data.file))
    })?;
    finish(&fit, &data, arguments, plot.as_deref(), String::new())
}

/// Warns, writes the entry and the picture, and shows the fit behind `text`.
pub(super) fn finish(
    fit: &Fit,
    data: &Data,
    arguments: &FitLawArgs,
    plot: Option<&Path>,
    mut text: String,
) -> Result<(), Failure> {
    let nonsense = fit::nonsense(fit, data);
    for warning in fit.warnings.iter().chain(&nonsense) {
        print::stderr(&format!("warning: {warning}"));
    }
    let stem = arguments
        .data
        .file_stem()
        .map_or_else(|| data.file.clone(), |s| s.to_string_lossy().into_owned());
    let heading = Heading {
        title: arguments.title.clone().unwrap_or(stem),
        source: arguments
            .source
            .clone()
            .unwrap_or_else(|| data.file.clone()),
    };
    let entry = fit::entry(fit, data, &heading);
    let cannot_write = |path: &Path, error: std::io::Error| {
        Failure::Other(format!("cannot write {}: {error}", path.display()))
    };
    if let Some(path) = plot {
        picture::write(path, &fit::picture(fit, data, &heading.title).drawing())?;
    }
    text += &report(fit, data, arguments.verbose);
    match &arguments.output {
        Some(path) => {
            write_whole(path, entry.as_bytes()).map_err(|error| cannot_write(path, error))?;
            text += &format!("\nEntry written to {}\n", path.display());
        }
        None => text += &format!("\nEntry\n\n{entry}"),
    }
    let shown = print::stdout(&text);
    if arguments.strict && !nonsense.is_empty() {
        return Err(Failure::NotConverged(format!(
            "the fit is implausible: {}",
            nonsense.join("; ")
        )));
    }
    shown
}

/// Path of the picture: as given, or next to the entry.
pub(super) fn plot_path(arguments: &FitLawArgs) -> Result<Option<PathBuf>, Failure> {
    if let Some(path) = &arguments.plot {
        picture::check(path)?;
        return Ok(Some(path.clone()));
    }
    Ok(arguments
        .output
        .as_ref()
        .map(|path| path.with_extension("svg")))
}

/// Neither the data nor the equation of state is overwritten, nor the entry by its own picture, nor what is there already.
pub(super) fn keep_inputs(arguments: &FitLawArgs, plot: Option<&Path>) -> Result<(), Failure> {
    let mut read = vec![arguments.data.clone()];
    let density = arguments.density.as_ref();
    read.extend(density.and_then(|name| entry_path(name)));
    let entry = arguments.output.as_deref();
    inputs::keep(
        &read,
        &[
            entry.map(|path| ("--output", path)),
            plot.map(|path| ("the picture", path)),
        ]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>(),
    )?;
    if let (Some(entry), Some(plot)) = (entry, plot)
        && inputs::is_one_place(entry, plot)
    {
        return Err(Failure::Argument(format!(
            "--output {} names both the entry and the picture next to it; give the entry a name that ends in .toml",
            entry.display()
        )));
    }
    let outputs: Vec<&Path> = entry.into_iter().chain(plot).collect();
    inputs::refuse_existing(&outputs, arguments.force)
}

/// The table; a kinematic viscosity takes the density of `params`, and where `may_be_ambient`, pressures may be missing.
pub(super) fn read(
    arguments: &FitLawArgs,
    property: Property,
    params: &Params,
    may_be_ambient: bool,
) -> Result<Data, Failure> {
    let path = &arguments.data;
    let text = read_table(path)
        .map_err(|error| Failure::Argument(format!("{} {error}", path.display())))?;
    let file = path.display().to_string();
    let reading = Reading {
        table: arguments.table.params(&[]),
        density: params.density.clone(),
        may_be_ambient,
    };
    let data = Data::read(&file, &text, property, &reading)
        .map_err(|error| Failure::Argument(error.to_string()))?;
    for note in &data.notes {
        print::stderr(&format!("note: {}: {note}", data.file));
    }
    Ok(data)
}

/// Parameters of the fit; the constants to hold are those of `law`, or none.
pub(super) fn params(arguments: &FitLawArgs, law: Option<LawName>) -> Result<Params, Failure> {
    let mut held = Vec::new();
    for (text, law) in arguments.hold.iter().zip(law.into_iter().cycle()) {
        let (key, value) = text.split_once('=').ok_or_else(|| {
            Failure::Argument(format!(
                "--hold {text}: write KEY=VALUE, such as --hold \"mu_0=0.465 mPa.s\""
            ))
        })?;
        let value = fit::parse_constant(law, key.trim(), value)
            .map_err(|error| Failure::Argument(format!("--hold {text}: {error}")))?;
        held.push((key.trim().to_owned(), value));
    }
    let reference_temperature = arguments
        .reference_temperature
        .as_ref()
        .map(|text| ertel_quantity::parse(text, Dimension::TEMPERATURE))
        .transpose()?;
    let density = match arguments.density.as_deref() {
        Some(name) => Some(fit::density_of(name).map_err(|error| density_failure(name, error))?),
        None => None,
    };
    let equation_of_state = match (&density, law) {
        (Some(DensityLaw::Tait(tait)), _) => Some(tait.volume.clone()),
        (Some(other), Some(LawName::Doolittle)) => {
            return Err(Failure::Argument(format!(
                "--density {}: its density law is {}, but `tait` is needed",
                arguments.density.as_deref().unwrap_or_default(),
                other.name()
            )));
        }
        _ => None,
    };
    let pressure_law = PressureLaw::NAMES
        .iter()
        .find(|(name, _)| Some(*name) == arguments.pressure_law.as_deref())
        .map_or(PressureLaw::Roelands, |(_, law)| *law);
    if arguments.pressure_law.is_some() && law.is_some_and(|law| law != LawName::Walther) {
        return Err(Failure::Argument(
            "--pressure-law is an option of the law walther".to_owned(),
        ));
    }
    Ok(Params {
        held,
        freed: arguments.free.clone(),
        reference_temperature,
        residual: if arguments.absolute {
            Residual::Absolute
        } else {
            Residual::Relative
        },
        confidence: arguments.confidence,
        equation_of_state,
        density,
        pressure_law,
    })
}

fn density_failure(name: &str, error: DensityError) -> Failure {
    match error {
        DensityError::File(error) => error.into(),
        DensityError::Database(error) => error.into(),
        DensityError::None(_) => Failure::Argument(format!("--density {name}: {error}")),
    }
}

/// The file that `--density` names, by its path or in the own data; `None` of a fluid of the database.
fn entry_path(name: &str) -> Option<PathBuf> {
    database::own_path(Kind::Fluid, name, Path::new(""))
}

/// Pressures are above that of the surroundings.
const AMBIENT: &str = "ambient pressure";

fn report(fit: &Fit, data: &Data, verbose: bool) -> String {
    let [p_low, p_high] = data.pressure_range();
    let [t_low, t_high] = data.temperature_range();
    let mut text = paragraph(
        "",
        &format!(
            "Law {} fitted to {} states of {}, {}, {} to {} °C, by least squares of {} deviations",
            fit.name.name(),
            data.states.len(),
            data.file,
            match p_high > 0.0 {
                true => format!("{} to {}", pressure(p_low), pressure(p_high)),
                false => AMBIENT.to_owned(),
            },
            digits(t_low - 273.15, 5),
            digits(t_high - 273.15, 5),
            match fit.residual {
                Residual::Relative => "relative",
                Residual::Absolute => "absolute",
            }
        ),
    );
    let percent = format!("{} % interval", digits(100.0 * fit.confidence, 4));
    let mut rows = vec![
        ["constant", "value", percent.as_str()]
            .map(str::to_owned)
            .to_vec(),
    ];
    for constant in &fit.constants {
        let interval = constant.interval.map_or_else(
            || "fixed".to_owned(),
            |[low, high]| {
                format!(
                    "{} to {}",
                    number(low, constant.unit),
                    number(high, constant.unit)
                )
            },
        );
        rows.push(vec![
            constant.key.to_owned(),
            format!(
                "{} {}",
                number(constant.value, constant.unit),
                constant.unit
            ),
            interval,
        ]);
    }
    if let Some(t_r) = fit.reference_temperature {
        rows.push(vec![
            "reference_temperature".to_owned(),
            format!("{} °C", digits(t_r - 273.15, 5)),
            "fixed".to_owned(),
        ]);
    }
    text += &format!("\n{}\n", columns(&rows));
    let (worst, deviation) = fit.worst();
    let state = data.states[worst];
    text += &format!(
        "Deviation of the law from the data: rms {} %, largest {} % at {} and {} °C\n",
        digits(100.0 * fit.rms(), 3),
        digits(100.0 * deviation, 3),
        match state.pressure > 0.0 {
            true => pressure(state.pressure),
            false => AMBIENT.to_owned(),
        },
        digits(state.temperature - 273.15, 5)
    );
    if verbose {
        text += &format!("\n{}", states(fit, data));
    }
    text
}

/// Every state next to the value of the law.
fn states(fit: &Fit, data: &Data) -> String {
    let unit = match (&fit.law, data.property) {
        (FittedLaw::Viscosity(_), _) | (_, Property::Viscosity) => "mPa.s",
        _ => "kg/m^3",
    };
    let mut rows = vec![vec![
        "pressure".to_owned(),
        "temperature".to_owned(),
        format!("{} ({unit})", data.property.name()),
        "law".to_owned(),
        "deviation".to_owned(),
    ]];
    for (state, deviation) in data.states.iter().zip(&fit.deviations) {
        let law = fit.law.ln_value(state.pressure, state.temperature).exp();
        rows.push(vec![
            pressure(state.pressure),
            format!("{} °C", digits(state.temperature - 273.15, 5)),
            number(state.value, unit),
            number(law, unit),
            format!("{:+.2} %", 100.0 * deviation),
        ]);
    }
    columns(&rows)
}

/// A value (SI) in a unit, without it.
fn number(value: f64, unit: &str) -> String {
    digits(
        Unit::parse(unit).map_or(value, |unit| unit.from_si(value)),
        5,
    )
}
