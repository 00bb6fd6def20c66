//! Usual values of a key, and the unit in which a number without one is meant.

use ertel_quantity::{Dimension as D, Dimension, Unit};

use crate::keys::rows_of;
use crate::usual::{DENSITY, PER_PRESSURE, RPM, SIZE, SPEED, STRESS, Usual, VISCOSITY, likely};

/// Likely values of any other key of a dimension.
const OTHERS: &[Usual] = &[
    likely(D::LENGTH, [0.05, 2000.0], SIZE),
    likely(D::SPEED, [1e-4, 200.0], SPEED),
    likely(D::ANGULAR_SPEED, [0.01, 100_000.0], RPM),
    likely(D::PRESSURE, [0.01, 100.0], STRESS),
    likely(D::VISCOSITY, [0.01, 10_000.0], VISCOSITY),
    likely(D::INVERSE_PRESSURE, [0.05, 100.0], PER_PRESSURE),
    likely(D::DENSITY, [500.0, 20_000.0], DENSITY),
    likely(
        D::VOLUMETRIC_HEAT,
        [0.1, 10.0],
        (
            "MJ/(m^3.K)",
            1e6,
            &["MJ/(m^3.K)", "kJ/(m^3.K)", "J/(m^3.K)"],
        ),
    ),
    likely(
        D::ANGLE,
        [0.001, 360.0],
        ("deg", std::f64::consts::PI / 180.0, &["deg", "mrad", "rad"]),
    ),
    likely(
        D::TEMPERATURE_PER_PRESSURE,
        [1.0, 10_000.0],
        ("K/GPa", 1e-9, &["K/GPa", "K/MPa", "K/Pa"]),
    ),
    likely(
        D::INVERSE_PRESSURE_SQUARED,
        [0.01, 1000.0],
        ("1/GPa^2", 1e-18, &["1/GPa^2", "1/Pa^2"]),
    ),
];

/// Temperatures that are meant in degC: below, in degC, people write this scale; above, they write kelvin.
const CELSIUS: [f64; 2] = [-60.0, 200.0];

/// Usual values of a key path of a dimension, if known.
#[must_use]
pub fn usual_of(key: &str, dimension: Dimension) -> Option<&'static Usual> {
    let of_key = (rows_of(key).into_iter().flat_map(|row| row.usual))
        .find(|own| own.dimension == dimension && key.starts_with(own.within));
    of_key.or_else(|| OTHERS.iter().find(|own| own.dimension == dimension))
}

/// The unit in which the number is most likely meant for a key path of a dimension: the first with which it is usual, or else the one
/// with which it is nearest to that.
#[must_use]
pub fn unit_meant(key: &str, dimension: Dimension, number: f64) -> String {
    let row = usual_of(key, dimension);
    if row.is_none() && dimension == Dimension::TEMPERATURE {
        let is_celsius = (CELSIUS[0]..=CELSIUS[1]).contains(&number);
        return if is_celsius { "degC" } else { "K" }.to_owned();
    }
    let Some(row) = row else {
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
    use crate::keys::all;

    /// Numbers as people type them without a unit.
    #[test]
    fn units_are_those_that_people_mean() {
        for (key, number, unit) in [
            ("machine.module", 4.5, "mm"),
            ("machine.normal_module", 0.0045, "m"),
            ("contact.radius", 16.0, "mm"),
            ("contact.radius", 0.016, "m"),
            ("bodies.roughness", 0.4, "um"),
            ("bodies.roughness", 400.0, "nm"),
            ("bodies.roughness", 4e-7, "m"),
            ("surface_roughness.body_1_ra", 0.8, "um"),
            ("machine.pinion_ra", 0.4, "um"),
            ("machine.tip_relief", 20.0, "um"),
            ("machine.wheel_tip_relief", 0.02, "mm"),
            ("machine.radial_clearance", 12.0, "um"),
            ("machine.axial_preload", -5.0, "um"),
            ("machine.lift_tolerance", 1.3, "um"),
            ("machine.scuffing_temperature", 380.0, "degC"),
            ("machine.scuffing_temperature", 653.0, "K"),
            ("surface.depth", 0.5, "um"),
            ("surface.amplitude", 50.0, "nm"),
            ("surface.rms_height", 0.2, "um"),
            ("surface.wavelength", 50.0, "um"),
            ("surface.wavelength", 0.2, "mm"),
            ("inlet.oil_layer", 0.5, "um"),
            ("contact.profile.end_drop", 8.0, "um"),
            ("contact.profile.crown_radius", 5000.0, "mm"),
            ("output.interferogram.wavelength", 532.0, "nm"),
            ("lubricant.kinematic_viscosity_40", 46.0, "mm^2/s"),
            ("lubricant.kinematic_viscosity_40", 46e-6, "m^2/s"),
            ("lubricant.density_15", 0.87, "g/cm^3"),
            ("lubricant.density_15", 870.0, "kg/m^3"),
            ("bodies.body_1.density", 7.85, "g/cm^3"),
            ("lubricant.viscosity.mu_0", 40.0, "mPa.s"),
            ("lubricant.viscosity.mu_0", 0.04, "Pa.s"),
            ("lubricant.viscosity.alpha", 22.0, "1/GPa"),
            ("lubricant.viscosity.alpha", 2.2e-8, "1/Pa"),
            ("lubricant.viscosity.alpha", 0.022, "1/MPa"),
            ("bodies.body_1.youngs_modulus", 210.0, "GPa"),
            ("bodies.body_1.youngs_modulus", 206_000.0, "MPa"),
            ("bodies.body_1.youngs_modulus", 2.1e11, "Pa"),
            ("contact.hertz_pressure", 1.2, "GPa"),
            ("contact.hertz_pressure", 800.0, "MPa"),
            ("contact.load", 50.0, "N"),
            ("contact.load", 300.0, "kN/m"),
            ("contact.load", 50_000.0, "N/m"),
            ("motion.entrainment_speed", 0.8, "m/s"),
            ("motion.entrainment_speed", 800.0, "mm/s"),
            ("machine.pinion_speed", 1500.0, "rpm"),
            ("machine.pinion_torque", 302.0, "N.m"),
            ("machine.contact_angle", 40.0, "deg"),
            ("lubricant.temperature", 90.0, "degC"),
            ("lubricant.temperature", 353.0, "K"),
            ("lubricant.thermal_conductivity", 140.0, "mW/(m.K)"),
            ("lubricant.heat_capacity", 2.0, "kJ/(kg.K)"),
            ("lubricant.density.beta", 6e-4, "1/K"),
        ] {
            let dimension = Unit::parse(unit).unwrap().dimension();
            assert_eq!(unit_meant(key, dimension, number), unit, "{key} = {number}");
        }
    }

    /// Whatever usual value is typed in one of the units, the proposal makes a usual one of it.
    #[test]
    fn proposals_are_usual() {
        let of_keys = all()
            .iter()
            .flat_map(|(key, row)| row.usual.iter().map(move |own| (key.as_str(), own)));
        let others = OTHERS.iter().map(|own| ("key.of.no.row", own));
        for (key, row) in of_keys.chain(others) {
            if !key.starts_with(row.within)
                || usual_of(key, row.dimension).unwrap().range != row.range
            {
                continue;
            }
            let [low, high] = row.range;
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
