//! Values that are usual for the keys of cases, and the units in which people give them.
//!
//! Ranges reach from miniature bearings to rolling mills, and hold for the liquids and solids in them. They serve questions about slips
//! of units, and proposals for numbers without one; no value is refused for them.

use ertel_quantity::{Dimension, Unit};

/// What is usual for some keys.
#[derive(Debug)]
pub struct Usual {
    /// Ends of the key paths, after a dot or the start; empty for every key of the dimension.
    keys: &'static [&'static str],
    dimension: Dimension,
    /// From, to, in the unit.
    pub range: [f64; 2],
    /// The unit of the range.
    pub unit: &'static str,
    /// SI per unit.
    pub factor: f64,
    /// Whether a value far outside is asked about.
    pub is_questioned: bool,
    /// Units to propose, the likeliest first.
    units: &'static [&'static str],
}

const fn usual(
    keys: &'static [&'static str],
    dimension: Dimension,
    range: [f64; 2],
    (unit, factor): (&'static str, f64),
    units: &'static [&'static str],
) -> Usual {
    Usual {
        keys,
        dimension,
        range,
        unit,
        factor,
        is_questioned: true,
        units,
    }
}

/// The same for proposals alone.
const fn likely(
    keys: &'static [&'static str],
    dimension: Dimension,
    range: [f64; 2],
    unit: (&'static str, f64),
    units: &'static [&'static str],
) -> Usual {
    Usual {
        is_questioned: false,
        ..usual(keys, dimension, range, unit, units)
    }
}

const MM: (&str, f64) = ("mm", 1e-3);
const SIZES: &[&str] = &["mm", "m", "um"];
const HEIGHTS: &[&str] = &["um", "nm", "m"];
const STRESSES: &[&str] = &["GPa", "MPa", "Pa"];

/// The first row of the dimension whose key fits holds.
const USUAL: &[Usual] = &[
    usual(
        &[
            "contact.radius",
            "contact.radius_x",
            "ball_radius",
            "ball_diameter",
            "roller_diameter",
            "base_radius",
        ],
        Dimension::LENGTH,
        [0.5, 1000.0],
        MM,
        SIZES,
    ),
    // Crowns and grooves are flat.
    usual(
        &["radius_x", "radius_y"],
        Dimension::LENGTH,
        [0.5, 50_000.0],
        MM,
        SIZES,
    ),
    usual(
        &[
            "contact.length",
            "roller_length",
            "face_width",
            "machine.width",
            "pitch_diameter",
        ],
        Dimension::LENGTH,
        [0.5, 2000.0],
        MM,
        SIZES,
    ),
    usual(
        &["module", "normal_module"],
        Dimension::LENGTH,
        [0.2, 50.0],
        MM,
        SIZES,
    ),
    usual(
        &[
            "roughness",
            "body_1_rms_height",
            "body_2_rms_height",
            "body_1_ra",
            "body_2_ra",
            "body_1_rz",
            "body_2_rz",
        ],
        Dimension::LENGTH,
        [0.1, 10_000.0],
        ("nm", 1e-9),
        HEIGHTS,
    ),
    likely(
        &["crown_radius", "end_radius"],
        Dimension::LENGTH,
        [1.0, 1e6],
        MM,
        SIZES,
    ),
    likely(
        &["end_drop", "drop", "spacer_thickness", "meniscus_distance"],
        Dimension::LENGTH,
        [0.01, 1000.0],
        ("um", 1e-6),
        &["um", "mm", "nm", "m"],
    ),
    likely(
        &["oil_layer"],
        Dimension::LENGTH,
        [0.005, 500.0],
        ("um", 1e-6),
        HEIGHTS,
    ),
    likely(
        &["wavelength", "wavelengths"],
        Dimension::LENGTH,
        [100.0, 2000.0],
        ("nm", 1e-9),
        &["nm", "um", "mm", "m"],
    ),
    likely(
        &["lift_acceleration"],
        Dimension::LENGTH,
        [0.1, 1000.0],
        MM,
        SIZES,
    ),
    likely(&[], Dimension::LENGTH, [0.05, 2000.0], MM, SIZES),
    usual(
        &["entrainment_speed"],
        Dimension::SPEED,
        [1e-4, 50.0],
        ("m/s", 1.0),
        &["m/s", "mm/s"],
    ),
    likely(
        &[],
        Dimension::SPEED,
        [1e-4, 200.0],
        ("m/s", 1.0),
        &["m/s", "mm/s"],
    ),
    usual(
        &[
            "inner_ring_speed",
            "outer_ring_speed",
            "pinion_speed",
            "cam_speed",
        ],
        Dimension::ANGULAR_SPEED,
        [0.1, 50_000.0],
        ("rpm", std::f64::consts::TAU / 60.0),
        &["rpm", "rad/s"],
    ),
    likely(
        &[],
        Dimension::ANGULAR_SPEED,
        [0.01, 100_000.0],
        ("rpm", std::f64::consts::TAU / 60.0),
        &["rpm", "rad/s"],
    ),
    usual(
        &["load", "ball_load", "roller_load", "design_load"],
        Dimension::FORCE,
        [0.01, 1e6],
        ("N", 1.0),
        &["N", "kN"],
    ),
    usual(
        &["load"],
        Dimension::FORCE_PER_LENGTH,
        [0.1, 1e4],
        ("kN/m", 1e3),
        &["kN/m", "N/m"],
    ),
    usual(
        &["pinion_torque"],
        Dimension::ENERGY,
        [0.01, 1e6],
        ("N.m", 1.0),
        &["N.m", "kN.m"],
    ),
    usual(
        &["youngs_modulus"],
        Dimension::PRESSURE,
        [1e-5, 1200.0],
        ("GPa", 1e9),
        // Soft solids are given in MPa: 2.4 is one of rubber, 210 one of steel.
        &["GPa", "MPa", "Pa"],
    ),
    likely(
        &["hertz_pressure"],
        Dimension::PRESSURE,
        [0.02, 5.0],
        ("GPa", 1e9),
        STRESSES,
    ),
    likely(
        &["g_c", "g", "tau_0", "tau_l0"],
        Dimension::PRESSURE,
        [0.001, 500.0],
        ("MPa", 1e6),
        &["MPa", "GPa", "Pa"],
    ),
    likely(
        &[],
        Dimension::PRESSURE,
        [0.01, 100.0],
        ("GPa", 1e9),
        STRESSES,
    ),
    usual(
        &["mu_0"],
        Dimension::VISCOSITY,
        [0.3, 3000.0],
        ("mPa.s", 1e-3),
        &["mPa.s", "Pa.s"],
    ),
    likely(
        &["mu_g"],
        Dimension::VISCOSITY,
        [1e6, 1e15],
        ("Pa.s", 1.0),
        &["Pa.s"],
    ),
    likely(
        &[],
        Dimension::VISCOSITY,
        [0.01, 10_000.0],
        ("mPa.s", 1e-3),
        &["mPa.s", "Pa.s"],
    ),
    usual(
        &[
            "alpha",
            "pressure_viscosity_coefficient",
            "pressure_viscosity_coefficient_20",
            "pressure_viscosity_coefficient_25",
            "pressure_viscosity_coefficient_30",
            "pressure_viscosity_coefficient_40",
            "pressure_viscosity_coefficient_50",
            "pressure_viscosity_coefficient_60",
            "pressure_viscosity_coefficient_80",
            "pressure_viscosity_coefficient_100",
        ],
        Dimension::INVERSE_PRESSURE,
        [0.5, 60.0],
        ("1/GPa", 1e-9),
        &["1/GPa", "1/MPa", "1/Pa"],
    ),
    likely(
        &[],
        Dimension::INVERSE_PRESSURE,
        [0.05, 100.0],
        ("1/GPa", 1e-9),
        &["1/GPa", "1/MPa", "1/Pa"],
    ),
    usual(
        &[
            "kinematic_viscosity_40",
            "kinematic_viscosity_100",
            "kinematic_viscosity",
        ],
        Dimension::KINEMATIC_VISCOSITY,
        [0.5, 5000.0],
        ("mm^2/s", 1e-6),
        &["mm^2/s", "m^2/s"],
    ),
    usual(
        &["rho_0", "density_15", "density_20"],
        Dimension::DENSITY,
        [500.0, 3000.0],
        ("kg/m^3", 1.0),
        &["kg/m^3", "g/cm^3"],
    ),
    usual(
        &[
            "plane.density",
            "ball.density",
            "body_1.density",
            "body_2.density",
        ],
        Dimension::DENSITY,
        [800.0, 20_000.0],
        ("kg/m^3", 1.0),
        &["kg/m^3", "g/cm^3"],
    ),
    likely(
        &[],
        Dimension::DENSITY,
        [500.0, 20_000.0],
        ("kg/m^3", 1.0),
        &["kg/m^3", "g/cm^3"],
    ),
    usual(
        &[
            "lubricant.thermal_conductivity",
            "lubricant.thermal_conductivity.k_0",
        ],
        Dimension::THERMAL_CONDUCTIVITY,
        [0.05, 1.0],
        ("W/(m.K)", 1.0),
        &["W/(m.K)", "mW/(m.K)"],
    ),
    usual(
        &["thermal_conductivity", "thermal_conductivity.k_0"],
        Dimension::THERMAL_CONDUCTIVITY,
        [0.1, 2500.0],
        ("W/(m.K)", 1.0),
        &["W/(m.K)", "mW/(m.K)"],
    ),
    usual(
        &["heat_capacity", "heat_capacity.c_0"],
        Dimension::SPECIFIC_HEAT,
        [100.0, 5000.0],
        ("J/(kg.K)", 1.0),
        &["J/(kg.K)", "kJ/(kg.K)"],
    ),
    likely(
        &[],
        Dimension::VOLUMETRIC_HEAT,
        [0.1, 10.0],
        ("MJ/(m^3.K)", 1e6),
        &["MJ/(m^3.K)", "kJ/(m^3.K)", "J/(m^3.K)"],
    ),
    likely(
        &[],
        Dimension::ANGLE,
        [0.001, 360.0],
        ("deg", std::f64::consts::PI / 180.0),
        &["deg", "mrad", "rad"],
    ),
    likely(
        &[],
        Dimension::TEMPERATURE_PER_PRESSURE,
        [1.0, 10_000.0],
        ("K/GPa", 1e-9),
        &["K/GPa", "K/MPa", "K/Pa"],
    ),
    likely(
        &[],
        Dimension::INVERSE_PRESSURE_SQUARED,
        [0.01, 1000.0],
        ("1/GPa^2", 1e-18),
        &["1/GPa^2", "1/Pa^2"],
    ),
];

/// Temperatures that are meant in degC: below, in degC, people write this scale; above, they write kelvin.
const CELSIUS: [f64; 2] = [-60.0, 200.0];

/// What is usual for a key path of a dimension, if anything is known.
#[must_use]
pub fn usual_of(key: &str, dimension: Dimension) -> Option<&'static Usual> {
    let ends_with = |end: &&str| {
        let head = key.strip_suffix(*end);
        head.is_some_and(|head| head.is_empty() || head.ends_with('.'))
    };
    (USUAL.iter())
        .filter(|row| row.dimension == dimension)
        .find(|row| row.keys.is_empty() || row.keys.iter().any(&ends_with))
}

/// The unit in which the number is most likely meant for a key path of a dimension: the first with which it is usual, or else the one
/// with which it is nearest to that.
#[must_use]
pub fn unit_meant(key: &str, dimension: Dimension, number: f64) -> String {
    if dimension == Dimension::TEMPERATURE {
        let is_celsius = (CELSIUS[0]..=CELSIUS[1]).contains(&number);
        return if is_celsius { "degC" } else { "K" }.to_owned();
    }
    let Some(row) = usual_of(key, dimension) else {
        return dimension.si_unit();
    };
    let size = number.abs();
    // How far outside, as a factor; zero has a place in every unit.
    let excess = |unit: &str| {
        let value = Unit::parse(unit).map_or(f64::NAN, |unit| unit.to_si(size)) / row.factor;
        let [low, high] = row.range;
        if value == 0.0 {
            1.0
        } else {
            (value / high).max(low / value).max(1.0)
        }
    };
    let nearest = row
        .units
        .iter()
        .min_by(|a, b| excess(a).total_cmp(&excess(b)));
    nearest.map_or_else(|| dimension.si_unit(), |unit| (*unit).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers as people type them without a unit.
    #[test]
    fn units_are_those_that_people_mean() {
        for (key, dimension, number, unit) in [
            ("machine.module", Dimension::LENGTH, 4.5, "mm"),
            ("machine.normal_module", Dimension::LENGTH, 0.0045, "m"),
            ("contact.radius", Dimension::LENGTH, 16.0, "mm"),
            ("contact.radius", Dimension::LENGTH, 0.016, "m"),
            ("bodies.roughness", Dimension::LENGTH, 0.4, "um"),
            ("bodies.roughness", Dimension::LENGTH, 400.0, "nm"),
            ("bodies.roughness", Dimension::LENGTH, 4e-7, "m"),
            ("surface_roughness.body_1_ra", Dimension::LENGTH, 0.8, "um"),
            ("inlet.oil_layer", Dimension::LENGTH, 0.5, "um"),
            ("contact.profile.end_drop", Dimension::LENGTH, 8.0, "um"),
            (
                "contact.profile.crown_radius",
                Dimension::LENGTH,
                5000.0,
                "mm",
            ),
            (
                "output.interferogram.wavelength",
                Dimension::LENGTH,
                532.0,
                "nm",
            ),
            (
                "lubricant.kinematic_viscosity_40",
                Dimension::KINEMATIC_VISCOSITY,
                46.0,
                "mm^2/s",
            ),
            (
                "lubricant.kinematic_viscosity_40",
                Dimension::KINEMATIC_VISCOSITY,
                46e-6,
                "m^2/s",
            ),
            ("lubricant.density_15", Dimension::DENSITY, 0.87, "g/cm^3"),
            ("lubricant.density_15", Dimension::DENSITY, 870.0, "kg/m^3"),
            ("bodies.body_1.density", Dimension::DENSITY, 7.85, "g/cm^3"),
            (
                "lubricant.viscosity.mu_0",
                Dimension::VISCOSITY,
                40.0,
                "mPa.s",
            ),
            (
                "lubricant.viscosity.mu_0",
                Dimension::VISCOSITY,
                0.04,
                "Pa.s",
            ),
            (
                "lubricant.viscosity.alpha",
                Dimension::INVERSE_PRESSURE,
                22.0,
                "1/GPa",
            ),
            (
                "lubricant.viscosity.alpha",
                Dimension::INVERSE_PRESSURE,
                2.2e-8,
                "1/Pa",
            ),
            (
                "lubricant.viscosity.alpha",
                Dimension::INVERSE_PRESSURE,
                0.022,
                "1/MPa",
            ),
            (
                "bodies.body_1.youngs_modulus",
                Dimension::PRESSURE,
                210.0,
                "GPa",
            ),
            (
                "bodies.body_1.youngs_modulus",
                Dimension::PRESSURE,
                206_000.0,
                "MPa",
            ),
            (
                "bodies.body_1.youngs_modulus",
                Dimension::PRESSURE,
                2.1e11,
                "Pa",
            ),
            ("contact.hertz_pressure", Dimension::PRESSURE, 1.2, "GPa"),
            ("contact.hertz_pressure", Dimension::PRESSURE, 800.0, "MPa"),
            ("contact.load", Dimension::FORCE, 50.0, "N"),
            ("contact.load", Dimension::FORCE_PER_LENGTH, 300.0, "kN/m"),
            ("contact.load", Dimension::FORCE_PER_LENGTH, 50_000.0, "N/m"),
            ("motion.entrainment_speed", Dimension::SPEED, 0.8, "m/s"),
            ("motion.entrainment_speed", Dimension::SPEED, 800.0, "mm/s"),
            (
                "machine.pinion_speed",
                Dimension::ANGULAR_SPEED,
                1500.0,
                "rpm",
            ),
            ("machine.pinion_torque", Dimension::ENERGY, 302.0, "N.m"),
            ("machine.contact_angle", Dimension::ANGLE, 40.0, "deg"),
            (
                "lubricant.temperature",
                Dimension::TEMPERATURE,
                90.0,
                "degC",
            ),
            ("lubricant.temperature", Dimension::TEMPERATURE, 353.0, "K"),
            (
                "lubricant.thermal_conductivity",
                Dimension::THERMAL_CONDUCTIVITY,
                140.0,
                "mW/(m.K)",
            ),
            (
                "lubricant.heat_capacity",
                Dimension::SPECIFIC_HEAT,
                2.0,
                "kJ/(kg.K)",
            ),
            (
                "lubricant.density.beta",
                Dimension::INVERSE_TEMPERATURE,
                6e-4,
                "1/K",
            ),
        ] {
            assert_eq!(unit_meant(key, dimension, number), unit, "{key} = {number}");
        }
    }

    /// Whatever usual value is typed in one of the units, the proposal makes a usual one of it.
    #[test]
    fn proposals_are_usual() {
        for row in USUAL {
            let [low, high] = row.range;
            let key = row.keys.first().copied().unwrap_or("key.of.no.row");
            for unit in row.units {
                let parsed = Unit::parse(unit).unwrap();
                assert_eq!(parsed.dimension(), row.dimension, "{unit}");
                for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let value = low * (high / low).powf(share);
                    let number = parsed.from_si(value * row.factor);
                    let meant = unit_meant(key, row.dimension, number);
                    let proposed = Unit::parse(&meant).unwrap().to_si(number) / row.factor;
                    let usual = low * (1.0 - 1e-9)..=high * (1.0 + 1e-9);
                    assert!(usual.contains(&proposed), "{key} = {number} {meant}");
                }
            }
        }
    }
}
