//! Pressure-viscosity coefficients of a data sheet: at the reference temperature, at one or two others, or by correlation.

use super::base_oil::needs_base_oil;
use super::data::{ZERO_CELSIUS, estimated, figures, given, twice};
use crate::data_sheet::BaseOil;
use crate::provenance::Datum;
use crate::viscosity::{PressureLaw, Walther};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

/// Keys of coefficients, with their temperatures in degC: those of the viscosities.
pub(super) const COEFFICIENTS: [(&str, f64); 8] = [
    ("pressure_viscosity_coefficient_20", 20.0),
    ("pressure_viscosity_coefficient_25", 25.0),
    ("pressure_viscosity_coefficient_30", 30.0),
    ("pressure_viscosity_coefficient_40", 40.0),
    ("pressure_viscosity_coefficient_50", 50.0),
    ("pressure_viscosity_coefficient_60", 60.0),
    ("pressure_viscosity_coefficient_80", 80.0),
    ("pressure_viscosity_coefficient_100", 100.0),
];
/// At the reference temperature.
const KEY: &str = "pressure_viscosity_coefficient";
const LARGEST: f64 = 100e-9;
const PER_PRESSURE: Dimension = Dimension::INVERSE_PRESSURE;

/// Ratio of the hot to the cold coefficient that the scatter of measurements explains: of 12 mineral oils between 30 and
/// 100 degC it is 0.5 to 0.7 (Stachowiak and Batchelor, Engineering Tribology, table 2.3).
const LARGEST_RISE: f64 = 1.1;

/// Largest exponent of the temperature to either side; those oils have -1.0 to 0.5 in the index of Roelands and -3.5 to -1.7 in
/// the coefficient of Barus.
fn largest_exponent(law: PressureLaw) -> f64 {
    match law {
        PressureLaw::Roelands => 4.0,
        PressureLaw::Barus => 7.0,
    }
}

/// Gives `law` its coefficient, with the temperature where it holds, and the exponent that follows from two.
pub(super) fn read(
    table: &mut Table<'_>,
    law: &mut Walther,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<(), InputError> {
    let keys = COEFFICIENTS
        .into_iter()
        .filter(|(key, _)| table.contains(key))
        .collect::<Vec<_>>();
    if let Some((first, _)) = keys.first()
        && table.contains(KEY)
    {
        return Err(twice(table, first, KEY).with_help(format!(
            "`{KEY}` holds at `reference_temperature`; a key that ends with _40 holds at 40 degC"
        )));
    }
    match keys[..] {
        [] => {
            law.alpha = at_reference(table, law, base_oil, data)?;
            Ok(())
        }
        [(key, celsius)] => {
            law.alpha = measured(table, key, data)?;
            law.reference_temperature = celsius + ZERO_CELSIUS;
            Ok(())
        }
        [cold, hot] => through(table, law, [cold, hot], data),
        _ => {
            // Of the file, the last.
            let of_sheet = |key: &&str| keys.iter().any(|(other, _)| other == key);
            let third = table.keys().filter(of_sheet).last().unwrap_or(keys[2].0);
            Err(table
                .error(
                    third,
                    "a data sheet takes pressure-viscosity coefficients at two temperatures",
                )
                .with_help("keep the two that bracket the temperature of the contact"))
        }
    }
}

/// A coefficient whose key names its temperature.
fn measured(
    table: &mut Table<'_>,
    key: &'static str,
    data: &mut Vec<Datum>,
) -> Result<f64, InputError> {
    let alpha = table.required_quantity(key, PER_PRESSURE, Bounds::above_to(0.0, LARGEST))?;
    data.push(given(table, key, figures(1e9 * alpha), "1/GPa"));
    Ok(alpha)
}

/// The law through two coefficients.
fn through(
    table: &mut Table<'_>,
    law: &mut Walther,
    [(cold, celsius_1), (hot, celsius_2)]: [(&'static str, f64); 2],
    data: &mut Vec<Datum>,
) -> Result<(), InputError> {
    let (t_1, t_2) = (celsius_1 + ZERO_CELSIUS, celsius_2 + ZERO_CELSIUS);
    let (alpha_1, alpha_2) = (measured(table, cold, data)?, measured(table, hot, data)?);
    let [shown_1, shown_2] = [alpha_1, alpha_2].map(|alpha| figures(1e9 * alpha));
    if alpha_2 > LARGEST_RISE * alpha_1 {
        let problem = format!(
            "the pressure-viscosity coefficient of an oil falls with temperature, but it is {shown_2} 1/GPa by `{hot}` and {shown_1} \
             1/GPa by `{cold}`"
        );
        return Err(table.error(hot, problem).with_help("are both exchanged?"));
    }
    let Some(exponent) = law.exponent([(t_1, alpha_1), (t_2, alpha_2)]) else {
        let problem = format!(
            "at {celsius_2} degC the oil is thinner than 0.063 mPa.s, the pole of Roelands' law: there it has no pressure-viscosity \
             coefficient"
        );
        return Err(table.error(hot, problem));
    };
    if exponent.abs() > largest_exponent(law.pressure) {
        let what = if exponent < 0.0 { "falls" } else { "changes" };
        let problem = format!(
            "the pressure-viscosity coefficient {what} more steeply with temperature than that of any oil: {shown_2} 1/GPa by `{hot}` \
             and {shown_1} 1/GPa by `{cold}`"
        );
        return Err(table.error(hot, problem).with_help(
            "are the units right? Give the one that lies nearer to the temperature of the contact",
        ));
    }
    law.alpha = alpha_1;
    law.reference_temperature = t_1;
    law.alpha_exponent = exponent;
    Ok(())
}

/// The coefficient (1/Pa) at the reference temperature of `law`, measured or by correlation.
fn at_reference(
    table: &mut Table<'_>,
    law: &Walther,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<f64, InputError> {
    let bounds = Bounds::closed(0.0, LARGEST);
    if let Some(alpha) = table.optional_quantity(KEY, PER_PRESSURE, bounds)? {
        data.push(given(table, KEY, figures(1e9 * alpha), "1/GPa"));
        return Ok(alpha);
    }
    let Some(base_oil) = base_oil else {
        return Err(needs_base_oil(table, KEY));
    };
    let nu: f64 = law.kinematic_viscosity(law.reference_temperature);
    let estimate = base_oil.pressure_viscosity(nu);
    Ok(estimated(
        table,
        data,
        (KEY, &estimate),
        PER_PRESSURE,
        (1e9, "1/GPa"),
    ))
}
