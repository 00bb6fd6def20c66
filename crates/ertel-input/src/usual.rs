//! Values that are usual for the keys of cases, and the units in which people give them.
//!
//! Ranges reach from miniature bearings to rolling mills, and hold for the liquids and solids in them. They serve questions about slips
//! of units, and proposals for numbers without one; no value is refused for them. The rows of [`keys`](crate::keys) say which key has which.

use ertel_quantity::{Dimension as D, Dimension};

/// Usual values of some keys.
#[derive(Clone, Copy, Debug)]
pub struct Usual {
    pub(crate) dimension: Dimension,
    /// Where the key paths begin; empty for all.
    pub(crate) within: &'static str,
    /// From, to, in the unit.
    pub range: [f64; 2],
    /// The unit of the range.
    pub unit: &'static str,
    /// SI per unit.
    pub factor: f64,
    /// Whether a value far outside is asked about.
    pub is_questioned: bool,
    /// Units to propose, the likeliest first.
    pub(crate) units: &'static [&'static str],
}

/// The unit of a range, SI per unit, and the units to propose.
pub(crate) type Units = (&'static str, f64, &'static [&'static str]);

const fn usual(dimension: Dimension, range: [f64; 2], (unit, factor, units): Units) -> Usual {
    Usual {
        dimension,
        within: "",
        range,
        unit,
        factor,
        is_questioned: true,
        units,
    }
}

/// The same for proposals alone.
pub(crate) const fn likely(dimension: Dimension, range: [f64; 2], units: Units) -> Usual {
    Usual {
        is_questioned: false,
        ..usual(dimension, range, units)
    }
}

pub(crate) const SIZE: Units = ("mm", 1e-3, &["mm", "m", "um"]);
const HEIGHT: Units = ("nm", 1e-9, &["um", "nm", "m"]);
const GAP: Units = ("um", 1e-6, &["um", "mm", "nm", "m"]);
pub(crate) const SPEED: Units = ("m/s", 1.0, &["m/s", "mm/s"]);
pub(crate) const RPM: Units = ("rpm", std::f64::consts::TAU / 60.0, &["rpm", "rad/s"]);
// Soft solids are given in MPa: 2.4 is one of rubber, 210 one of steel.
pub(crate) const STRESS: Units = ("GPa", 1e9, &["GPa", "MPa", "Pa"]);
pub(crate) const VISCOSITY: Units = ("mPa.s", 1e-3, &["mPa.s", "Pa.s"]);
pub(crate) const PER_PRESSURE: Units = ("1/GPa", 1e-9, &["1/GPa", "1/MPa", "1/Pa"]);
pub(crate) const DENSITY: Units = ("kg/m^3", 1.0, &["kg/m^3", "g/cm^3"]);
const CONDUCTIVITY: Units = ("W/(m.K)", 1.0, &["W/(m.K)", "mW/(m.K)"]);

/// Radii and diameters of bodies in contact.
pub(crate) const RADII: Usual = usual(D::LENGTH, [0.5, 1000.0], SIZE);
/// Principal radii: crowns and grooves are flat.
pub(crate) const GROOVES: Usual = usual(D::LENGTH, [0.5, 50_000.0], SIZE);
pub(crate) const LENGTHS: Usual = usual(D::LENGTH, [0.5, 2000.0], SIZE);
pub(crate) const MODULES: Usual = usual(D::LENGTH, [0.2, 50.0], SIZE);
/// Roughness.
pub(crate) const HEIGHTS: Usual = usual(D::LENGTH, [0.1, 10_000.0], HEIGHT);
pub(crate) const CROWNS: Usual = likely(D::LENGTH, [1.0, 1e6], SIZE);
/// Drops, layers, short distances.
pub(crate) const COATINGS: Usual = likely(D::LENGTH, [0.01, 1000.0], GAP);
/// Clearances and preloads of bearings, reliefs of tips of teeth.
pub(crate) const CLEARANCES: Usual = likely(D::LENGTH, [1.0, 500.0], GAP);
/// Extents of reliefs along the surface.
pub(crate) const RELIEFS: Usual = likely(D::LENGTH, [1.0, 5000.0], GAP);
pub(crate) const OIL_LAYER: Usual =
    likely(D::LENGTH, [0.005, 500.0], ("um", 1e-6, &["um", "nm", "m"]));
/// Contact temperatures at which oils lose their protection against scuffing, K: data sheets give them in degC.
pub(crate) const SCUFFING: Usual =
    likely(D::TEMPERATURE, [350.0, 850.0], ("K", 1.0, &["degC", "K"]));
pub(crate) const LIGHT: Usual = likely(
    D::LENGTH,
    [100.0, 2000.0],
    ("nm", 1e-9, &["nm", "um", "mm", "m"]),
);
pub(crate) const LIFT_ACCELERATION: Usual = likely(D::LENGTH, [0.1, 1000.0], SIZE);
pub(crate) const SPEEDS: Usual = usual(D::SPEED, [1e-4, 50.0], SPEED);
pub(crate) const ROTATIONS: Usual = usual(D::ANGULAR_SPEED, [0.1, 50_000.0], RPM);
pub(crate) const LOAD: Usual = usual(D::FORCE, [0.01, 1e6], ("N", 1.0, &["N", "kN"]));
pub(crate) const LINE_LOAD: Usual = usual(
    D::FORCE_PER_LENGTH,
    [0.1, 1e4],
    ("kN/m", 1e3, &["kN/m", "N/m"]),
);
pub(crate) const TORQUE: Usual = usual(D::ENERGY, [0.01, 1e6], ("N.m", 1.0, &["N.m", "kN.m"]));
pub(crate) const MODULUS: Usual = usual(D::PRESSURE, [1e-5, 1200.0], STRESS);
pub(crate) const HERTZ_PRESSURE: Usual = likely(D::PRESSURE, [0.02, 5.0], STRESS);
pub(crate) const SHEAR_STRESS: Usual = likely(
    D::PRESSURE,
    [0.001, 500.0],
    ("MPa", 1e6, &["MPa", "GPa", "Pa"]),
);
pub(crate) const OIL_VISCOSITY: Usual = usual(D::VISCOSITY, [0.3, 3000.0], VISCOSITY);
pub(crate) const GLASS_VISCOSITY: Usual =
    likely(D::VISCOSITY, [1e6, 1e15], ("Pa.s", 1.0, &["Pa.s"]));
/// Pressure-viscosity coefficients.
pub(crate) const COEFFICIENT: Usual = usual(D::INVERSE_PRESSURE, [0.5, 60.0], PER_PRESSURE);
pub(crate) const KINEMATIC_VISCOSITIES: Usual = usual(
    D::KINEMATIC_VISCOSITY,
    [0.5, 5000.0],
    ("mm^2/s", 1e-6, &["mm^2/s", "m^2/s"]),
);
pub(crate) const OIL_DENSITY: Usual = usual(D::DENSITY, [500.0, 3000.0], DENSITY);
pub(crate) const SOLID_DENSITY: Usual = usual(D::DENSITY, [800.0, 20_000.0], DENSITY);
pub(crate) const FILM_CONDUCTIVITY: Usual = Usual {
    within: "lubricant.",
    ..usual(D::THERMAL_CONDUCTIVITY, [0.05, 1.0], CONDUCTIVITY)
};
pub(crate) const SOLID_CONDUCTIVITY: Usual =
    usual(D::THERMAL_CONDUCTIVITY, [0.1, 2500.0], CONDUCTIVITY);
/// Of solids and lubricants.
pub(crate) const SPECIFIC_HEATS: Usual = usual(
    D::SPECIFIC_HEAT,
    [100.0, 5000.0],
    ("J/(kg.K)", 1.0, &["J/(kg.K)", "kJ/(kg.K)"]),
);
