//! Viscosities of a data sheet: two of them, one with the viscosity index, or a grade.

use super::data::{CELSIUS_40, CELSIUS_100, ZERO_CELSIUS, computed, estimated, figures, given};
use crate::DensityLaw;
use crate::data_sheet::{
    BaseOil, Estimate, ISO_VG, ISO_VG_NAMES, ISO_VG_TOLERANCE, Spread, viscosity_at_40,
    viscosity_at_100, viscosity_index,
};
use crate::database::names;
use crate::provenance::Datum;
use crate::viscosity::Walther;
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::{Dimension, is_saybolt, saybolt_corrected};

/// Kinematic viscosities that Walther's equation covers, m²/s, up to pitch.
const VISCOSITIES: Bounds = Bounds::closed(0.2e-6, 1.0);
/// The same of dynamic ones, Pa·s.
const DYNAMIC_VISCOSITIES: Bounds = Bounds::closed(1e-4, 1e3);
/// Viscosity indices of oils.
const INDICES: Bounds = Bounds::closed(-200.0, 500.0);
/// Difference between a given and a computed index that rounding explains.
const INDEX_TOLERANCE: f64 = 5.0;

/// Keys of kinematic viscosities, with their temperatures in degC.
pub(super) const KINEMATIC: [(&str, f64); 8] = [
    ("kinematic_viscosity_20", 20.0),
    ("kinematic_viscosity_25", 25.0),
    ("kinematic_viscosity_30", 30.0),
    ("kinematic_viscosity_40", 40.0),
    ("kinematic_viscosity_50", 50.0),
    ("kinematic_viscosity_60", 60.0),
    ("kinematic_viscosity_80", 80.0),
    ("kinematic_viscosity_100", 100.0),
];
/// The same of dynamic ones.
pub(super) const DYNAMIC: [(&str, f64); 8] = [
    ("dynamic_viscosity_20", 20.0),
    ("dynamic_viscosity_25", 25.0),
    ("dynamic_viscosity_30", 30.0),
    ("dynamic_viscosity_40", 40.0),
    ("dynamic_viscosity_50", 50.0),
    ("dynamic_viscosity_60", 60.0),
    ("dynamic_viscosity_80", 80.0),
    ("dynamic_viscosity_100", 100.0),
];

/// Keys of one viscosity at any temperature, which the key below gives.
pub(super) const AT_ANY: [&str; 2] = ["kinematic_viscosity", "dynamic_viscosity"];
pub(super) const ANY: &str = "viscosity_temperature";
/// Temperatures that a viscosity is given at, K: Walther's equation has no others.
const TEMPERATURES: Bounds = Bounds::closed(223.15, 473.15);

/// Temperature (K) and kinematic viscosity (m²/s) there.
pub(super) type Point = (f64, f64);

/// Whether a dynamic viscosity is given, which needs the density to become a kinematic one.
pub(super) fn has_dynamic(table: &mut Table<'_>) -> bool {
    let mut keys = DYNAMIC.iter().map(|(key, _)| *key).chain([AT_ANY[1]]);
    keys.any(|key| table.contains(key))
}

/// The key of a viscosity at any temperature, and that temperature in degC.
fn at_any(table: &mut Table<'_>) -> Result<Option<(&'static str, f64)>, InputError> {
    let keys: Vec<&'static str> = AT_ANY
        .into_iter()
        .filter(|key| table.contains(key))
        .collect();
    let celsius = (table.optional_quantity(ANY, Dimension::TEMPERATURE, TEMPERATURES)?)
        .map(|kelvin| kelvin - ZERO_CELSIUS);
    match (&keys[..], celsius) {
        ([], None) => Ok(None),
        ([key], Some(celsius)) => Ok(Some((key, celsius))),
        ([_, second, ..], _) => Err(table.error(
            second,
            format!(
                "`{}` and `{second}` say the same thing: give one of them",
                AT_ANY[0]
            ),
        )),
        ([key], None) => Err(table.missing(ANY).with_help(format!(
            "the temperature of `{key}`, as in {ANY} = \"70 degC\""
        ))),
        ([], Some(_)) => Err(table.error(
            ANY,
            format!(
                "`{ANY}` is that of `{}` or `{}`, and neither is given",
                AT_ANY[0], AT_ANY[1]
            ),
        )),
    }
}

/// Two points of the viscosity, by what the sheet gives. `density` is known where [`has_dynamic`].
pub(super) fn points(
    table: &mut Table<'_>,
    density: Option<&DensityLaw>,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<[Point; 2], InputError> {
    let is_usual = |(key, celsius): &(&str, f64)| {
        key.starts_with("kinematic") && [40.0, 100.0].contains(celsius)
    };
    let all = KINEMATIC.iter().chain(&DYNAMIC);
    let mut given_keys: Vec<(&'static str, f64)> = all
        .filter(|(key, _)| table.contains(key))
        .copied()
        .collect();
    given_keys.extend(at_any(table)?);
    if given_keys.iter().all(is_usual) {
        let index = table.contains("viscosity_index") || base_oil.is_some();
        let by_100 = table.contains("kinematic_viscosity_100")
            && !table.contains("kinematic_viscosity_40")
            && !table.contains("iso_vg");
        if by_100 && index {
            return by_viscosity_100(table, base_oil, data);
        }
        let nu_40 = viscosity_40(table, data)?;
        let nu_100 = viscosity_100(table, nu_40, base_oil, data)?;
        return Ok([(CELSIUS_40, nu_40), (CELSIUS_100, nu_100)]);
    }
    let mut found: Vec<(&'static str, Point)> = Vec::new();
    for (key, celsius) in given_keys {
        let point = measured(table, (key, celsius), density, data)?;
        found.push((key, point));
    }
    found.sort_by(|a, b| a.1.0.total_cmp(&b.1.0));
    match found[..] {
        [one] => by_one(table, one, base_oil, data),
        [(first, cold), (second, hot)] => {
            if cold.0 == hot.0 {
                return Err(table.error(
                    second,
                    format!("`{first}` and `{second}` say the same thing: give one of them"),
                ));
            }
            if hot.1 >= cold.1 {
                return Err(table
                    .error(
                        second,
                        format!(
                            "the viscosity must fall with temperature: {} mm^2/s by `{second}`, {} mm^2/s by `{first}`",
                            figures(1e6 * hot.1),
                            figures(1e6 * cold.1)
                        ),
                    )
                    .with_help("are both exchanged?"));
            }
            check_grade(table, [cold, hot], data)?;
            check_index(table, [cold, hot], data)?;
            Ok([cold, hot])
        }
        _ => {
            // Of the file, the last.
            let of_sheet = |key: &&str| found.iter().any(|(other, _)| other == key);
            let third = table.keys().filter(of_sheet).last().unwrap_or(found[2].0);
            Err(table
                .error(third, "a data sheet takes viscosities at two temperatures")
                .with_help(
                    "keep the two that bracket the temperature of the contact; `ertel fit viscosity TABLE.csv` fits a law to more",
                ))
        }
    }
}

/// A viscosity of the sheet as a kinematic one.
fn measured(
    table: &mut Table<'_>,
    (key, celsius): (&'static str, f64),
    density: Option<&DensityLaw>,
    data: &mut Vec<Datum>,
) -> Result<Point, InputError> {
    let temperature = celsius + ZERO_CELSIUS;
    if let Some(nu) = kinematic(table, key, temperature)? {
        if key.starts_with("kinematic") {
            data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
        }
        return Ok((temperature, nu));
    }
    let mu = table.required_quantity(key, Dimension::VISCOSITY, DYNAMIC_VISCOSITIES)?;
    data.push(given(table, key, figures(1e3 * mu), "mPa.s"));
    let Some(density) = density else {
        return Err(table.missing("density_15"));
    };
    let nu = mu / density.density(0.0, temperature);
    if !VISCOSITIES.contains(nu) {
        let must = VISCOSITIES.describe("m^2/s");
        return Err(table.error(
            key,
            format!("the kinematic viscosity is {nu:.3e} m^2/s; it must be {must}"),
        ));
    }
    Ok((temperature, nu))
}

/// The kinematic viscosity at `key`, also in Saybolt seconds at `temperature` (K); `None` of keys of dynamic ones.
fn kinematic(
    table: &mut Table<'_>,
    key: &str,
    temperature: f64,
) -> Result<Option<f64>, InputError> {
    if !key.starts_with("kinematic") {
        return Ok(None);
    }
    let text = table.unnoted().optional_str(key).ok().flatten();
    let nu = table.optional_quantity(key, Dimension::KINEMATIC_VISCOSITY, VISCOSITIES)?;
    Ok(nu.map(|nu| match text.is_some_and(is_saybolt) {
        true => saybolt_corrected(nu, temperature),
        false => nu,
    }))
}

/// A given index, or the typical one of the base oil, with the key that it comes from.
fn index_of(
    table: &mut Table<'_>,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<Option<(f64, &'static str)>, InputError> {
    let given_index = table.optional_number("viscosity_index", INDICES)?;
    Ok(
        match (given_index, base_oil.and_then(BaseOil::viscosity_index)) {
            (Some(index), _) => {
                data.push(given(table, "viscosity_index", index.to_string(), "1"));
                Some((index, "viscosity_index"))
            }
            (None, Some(typical)) => {
                let key = ("viscosity_index", &typical);
                let index = estimated(table, data, key, Dimension::DIMENSIONLESS, (1.0, "1"));
                Some((index, "base_oil"))
            }
            (None, None) => None,
        },
    )
}

fn no_index(table: &Table<'_>) -> InputError {
    table.missing("viscosity_index").with_help(
        "one viscosity fixes an oil together with its index, or with a second one, such as `kinematic_viscosity_100`; a typical index is \
         known for base_oil = \"mineral\" or \"PAO\"",
    )
}

/// By the viscosity at 100 degC and the index.
fn by_viscosity_100(
    table: &mut Table<'_>,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<[Point; 2], InputError> {
    let key = "kinematic_viscosity_100";
    let (_, nu_100) = measured(table, (key, 100.0), None, data)?;
    let Some((index, source)) = index_of(table, base_oil, data)? else {
        return Err(no_index(table));
    };
    let nu_40 = viscosity_at_40(nu_100, index).filter(|nu_40| *nu_40 > nu_100);
    let Some(nu_40) = nu_40 else {
        return Err(table.error(
            source,
            format!(
                "no oil of {} mm^2/s at 100 degC has a viscosity index of {index}",
                figures(1e6 * nu_100)
            ),
        ));
    };
    data.push(computed_viscosity("kinematic_viscosity_40", nu_40));
    Ok([(CELSIUS_40, nu_40), (CELSIUS_100, nu_100)])
}

/// By a viscosity at another temperature and the grade or the index.
fn by_one(
    table: &mut Table<'_>,
    (key, point): (&'static str, Point),
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<[Point; 2], InputError> {
    if table.contains("iso_vg") && point.0 != CELSIUS_40 {
        let at_40 = (CELSIUS_40, viscosity_40(table, data)?);
        let [cold, hot] = if point.0 < CELSIUS_40 {
            [point, at_40]
        } else {
            [at_40, point]
        };
        if hot.1 >= cold.1 {
            return Err(table.error(key, "the viscosity must fall with temperature, also from and to that of the grade at 40 degC"));
        }
        check_index(table, [cold, hot], data)?;
        return Ok([cold, hot]);
    }
    let Some((index, source)) = index_of(table, base_oil, data)? else {
        return Err(no_index(table));
    };
    let through = |nu_40: f64| {
        Some([
            (CELSIUS_40, nu_40),
            (CELSIUS_100, viscosity_at_100(nu_40, index)?),
        ])
    };
    // ν at the temperature of the point grows with ν at 40 degC.
    let (mut low, mut high) = (2e-6, 1.0);
    for _ in 0..200 {
        let middle = f64::sqrt(low * high);
        if middle <= low || middle >= high {
            break;
        }
        // Too thin to have an index: further up.
        match through(middle).map(|points| viscosity_of(points, point.0)) {
            Some(nu) if nu >= point.1 => high = middle,
            _ => low = middle,
        }
    }
    let found = through(high)
        .filter(|points| (viscosity_of(*points, point.0) / point.1 - 1.0).abs() < 1e-6);
    let Some([at_40, at_100]) = found else {
        return Err(table.error(
            source,
            format!(
                "no oil of {} mm^2/s by `{key}` and more than 2 mm^2/s at 100 degC has a viscosity index of {index}",
                figures(1e6 * point.1)
            ),
        ));
    };
    for (key, (_, nu)) in [
        ("kinematic_viscosity_40", at_40),
        ("kinematic_viscosity_100", at_100),
    ] {
        data.push(computed_viscosity(key, nu));
    }
    Ok([at_40, at_100])
}

/// Kinematic viscosity (m²/s) at `temperature` (K) of Walther's equation through two points.
pub(super) fn viscosity_of(points: [Point; 2], temperature: f64) -> f64 {
    let (a, b) = Walther::constants(points);
    Walther::kinematic_viscosity_of(a, b, temperature)
}

/// Refuses a grade that the two points do not have.
fn check_grade(
    table: &mut Table<'_>,
    points: [Point; 2],
    data: &mut Vec<Datum>,
) -> Result<(), InputError> {
    let Some((grade, middle)) = grade(table)? else {
        return Ok(());
    };
    data.push(given(table, "iso_vg", grade.to_string(), "1"));
    let nu_40 = viscosity_of(points, CELSIUS_40);
    if (nu_40 / middle - 1.0).abs() > ISO_VG_TOLERANCE + 1e-9 {
        return Err(table.error(
            "iso_vg",
            format!(
                "an oil of {} mm^2/s at 40 degC, by its two viscosities, is not of grade ISO VG {grade}",
                figures(1e6 * nu_40)
            ),
        ));
    }
    Ok(())
}

/// Refuses an index that the two points do not have.
fn check_index(
    table: &mut Table<'_>,
    points: [Point; 2],
    data: &mut Vec<Datum>,
) -> Result<(), InputError> {
    let [nu_40, nu_100] = [CELSIUS_40, CELSIUS_100].map(|t| viscosity_of(points, t));
    let index = table.optional_number("viscosity_index", INDICES)?;
    let found = viscosity_index(nu_40, nu_100);
    if let (Some(index), Some(found)) = (index, found)
        && (index - found).abs() > INDEX_TOLERANCE
    {
        return Err(table.error(
            "viscosity_index",
            format!("the two viscosities give an index of {found:.0}, not {index}"),
        ));
    }
    data.extend(found.map(computed_index));
    Ok(())
}

/// Of a kinematic viscosity, m²/s.
fn computed_viscosity(key: &str, nu: f64) -> Datum {
    computed(key, figures(1e6 * nu), "mm^2/s", "astm_d2270")
}

fn computed_index(index: f64) -> Datum {
    computed("viscosity_index", format!("{index:.0}"), "1", "astm_d2270")
}

/// The grade and its middle at 40 degC (m²/s): a number or a text such as `VG 46`.
fn grade(table: &mut Table<'_>) -> Result<Option<(f64, f64)>, InputError> {
    table.contains("iso_vg");
    let named = table
        .unnoted()
        .optional_str("iso_vg")
        .ok()
        .flatten()
        .and_then(names::grade);
    let grade = match named {
        Some(grade) => Some(grade),
        None => table
            .unnoted()
            .optional_number("iso_vg", Bounds::POSITIVE)?,
    };
    let Some(grade) = grade else {
        return Ok(None);
    };
    match ISO_VG_NAMES.iter().position(|name| *name == grade) {
        Some(i) => Ok(Some((grade, 1e-6 * ISO_VG[i]))),
        None => {
            let names = ISO_VG_NAMES.map(|name| name.to_string()).join(", ");
            Err(table
                .error("iso_vg", format!("there is no grade ISO VG {grade}"))
                .with_help(format!("the grades of ISO 3448 are {names}")))
        }
    }
}

/// Kinematic viscosity at 40 degC (m²/s), measured or that of the grade.
fn viscosity_40(table: &mut Table<'_>, data: &mut Vec<Datum>) -> Result<f64, InputError> {
    let key = "kinematic_viscosity_40";
    let measured = kinematic(table, key, CELSIUS_40)?;
    let (grade, middle) = grade(table)?.unzip();
    if let Some(grade) = grade {
        data.push(given(table, "iso_vg", grade.to_string(), "1"));
    }
    match (measured, middle) {
        (Some(nu), Some(middle)) => {
            if (nu / middle - 1.0).abs() > ISO_VG_TOLERANCE + 1e-9 {
                return Err(table
                    .error(
                        key,
                        format!(
                            "an oil of {} mm^2/s at 40 degC is not of grade ISO VG {}, which has {} to {} mm^2/s",
                            figures(1e6 * nu),
                            grade.unwrap_or_default(),
                            figures(1e6 * middle * (1.0 - ISO_VG_TOLERANCE)),
                            figures(1e6 * middle * (1.0 + ISO_VG_TOLERANCE)),
                        ),
                    )
                    .with_help("give `iso_vg` or `kinematic_viscosity_40`, or make them agree"));
            }
            data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
            Ok(nu)
        }
        (Some(nu), None) => {
            data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
            Ok(nu)
        }
        (None, Some(middle)) => {
            let estimate = Estimate {
                value: middle,
                below: ISO_VG_TOLERANCE,
                above: ISO_VG_TOLERANCE,
                spread: Spread::Even,
                source: "iso3448",
                basis: "an oil of a grade may lie anywhere in it",
            };
            let dimension = Dimension::KINEMATIC_VISCOSITY;
            Ok(estimated(
                table,
                data,
                (key, &estimate),
                dimension,
                (1e6, "mm^2/s"),
            ))
        }
        (None, None) => Err(table
            .missing(key)
            .with_help("a data sheet needs `kinematic_viscosity_40` or `iso_vg`, or a viscosity at another temperature with `viscosity_index`")),
    }
}

/// Kinematic viscosity at 100 degC (m²/s), measured or from the viscosity index.
fn viscosity_100(
    table: &mut Table<'_>,
    nu_40: f64,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<f64, InputError> {
    let key = "kinematic_viscosity_100";
    if let Some(nu) = kinematic(table, key, CELSIUS_100)? {
        let index = table.optional_number("viscosity_index", INDICES)?;
        if nu >= nu_40 {
            return Err(table
                .error(
                    key,
                    format!(
                        "the viscosity at 100 degC, {} mm^2/s, must be below that at 40 degC, {} mm^2/s",
                        figures(1e6 * nu),
                        figures(1e6 * nu_40)
                    ),
                )
                .with_help("are both exchanged?"));
        }
        let found = viscosity_index(nu_40, nu);
        if let Some(found) = found.filter(|index| !INDICES.contains(*index)) {
            return Err(table
                .error(
                    key,
                    format!(
                        "with {} mm^2/s at 40 degC the viscosity index is {found:.0}, which no oil has",
                        figures(1e6 * nu_40)
                    ),
                )
                .with_help("mineral oils have about 95, polyalphaolefins 150"));
        }
        if let (Some(index), Some(found)) = (index, found)
            && (index - found).abs() > INDEX_TOLERANCE
        {
            return Err(table
                .error(
                    "viscosity_index",
                    format!(
                        "the viscosities at 40 and 100 degC give an index of {found:.0}, not {index}"
                    ),
                )
                .with_help("give two of `kinematic_viscosity_40`, `kinematic_viscosity_100` and `viscosity_index`"));
        }
        data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
        data.extend(found.map(computed_index));
        return Ok(nu);
    }
    let Some((index, source)) = index_of(table, base_oil, data)? else {
        return Err(table.missing(key).with_help(
            "give it, or `viscosity_index`; a typical index is known for base_oil = \"mineral\" or \"PAO\"",
        ));
    };
    let Some(nu) = viscosity_at_100(nu_40, index) else {
        return Err(table
            .error(
                source,
                format!(
                    "no oil of {} mm^2/s at 40 degC and more than 2 mm^2/s at 100 degC has a viscosity index of {index}",
                    figures(1e6 * nu_40)
                ),
            )
            .with_help("give `kinematic_viscosity_100`"));
    };
    data.push(computed_viscosity(key, nu));
    Ok(nu)
}
