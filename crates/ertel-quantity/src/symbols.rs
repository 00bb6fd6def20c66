//! Symbols of units, their prefixes and other spellings.
//!
//! Factors are exact by definition (BIPM, SI brochure, 9th edition; NIST SP 811, 2008, appendix B): the inch is 25.4 mm, the pound
//! 0.453 592 37 kg, standard gravity 9.806 65 m/s², the US gallon 231 cubic inches.

use super::Dimension;

/// Standard atmosphere (Pa), the ambient pressure that is taken off absolute ones.
pub const STANDARD_ATMOSPHERE: f64 = 101_325.0;

/// A symbol, its SI dimension, factor numerator and denominator, and the prefixes it takes.
pub(super) struct Symbol {
    pub name: &'static str,
    pub dimension: Dimension,
    pub numerator: f64,
    pub denominator: f64,
    pub prefixes: &'static str,
}

const fn symbol(
    name: &'static str,
    dimension: Dimension,
    numerator: f64,
    denominator: f64,
    prefixes: &'static str,
) -> Symbol {
    Symbol {
        name,
        dimension,
        numerator,
        denominator,
        prefixes,
    }
}

const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
const POUND: f64 = 0.453_592_37;
const GRAVITY: f64 = 9.806_65;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
/// One pound-force per square inch, Pa.
const PSI: f64 = 6_894.757_293_168_361;
/// British thermal unit of the International Table, J.
const BTU: f64 = 1_055.055_852_62;

// K takes no prefix: `mK` is the metre-kelvin of `W/mK`.
pub(super) const SYMBOLS: &[Symbol] = &[
    symbol("1", Dimension::DIMENSIONLESS, 1.0, 1.0, ""),
    symbol("%", Dimension::DIMENSIONLESS, 1.0, 1e2, ""),
    symbol("ppm", Dimension::DIMENSIONLESS, 1.0, 1e6, ""),
    symbol("m", Dimension::LENGTH, 1.0, 1.0, "pnumcdk"),
    symbol("in", Dimension::LENGTH, INCH, 1.0, "u"),
    symbol("mil", Dimension::LENGTH, INCH, 1e3, ""),
    symbol("ft", Dimension::LENGTH, FOOT, 1.0, ""),
    symbol("yd", Dimension::LENGTH, 3.0 * FOOT, 1.0, ""),
    symbol("angstrom", Dimension::LENGTH, 1.0, 1e10, ""),
    symbol("l", Dimension::VOLUME, 1.0, 1e3, "umcdh"),
    symbol("L", Dimension::VOLUME, 1.0, 1e3, "umcdh"),
    symbol("cc", Dimension::VOLUME, 1.0, 1e6, ""),
    symbol(
        "gal",
        Dimension::VOLUME,
        231.0 * INCH * INCH * INCH,
        1.0,
        "",
    ),
    symbol("g", Dimension::MASS, 1.0, 1e3, "numk"),
    symbol("lb", Dimension::MASS, POUND, 1.0, ""),
    symbol("oz", Dimension::MASS, POUND, 16.0, ""),
    symbol("slug", Dimension::MASS, POUND_FORCE, FOOT, ""),
    symbol("s", Dimension::TIME, 1.0, 1.0, "pnum"),
    symbol("min", Dimension::TIME, 60.0, 1.0, ""),
    symbol("h", Dimension::TIME, 3600.0, 1.0, ""),
    symbol("Hz", Dimension::SHEAR_RATE, 1.0, 1.0, "kMG"),
    symbol("mph", Dimension::SPEED, 5280.0 * FOOT, 3600.0, ""),
    symbol("fpm", Dimension::SPEED, FOOT, 60.0, ""),
    symbol("ips", Dimension::SPEED, INCH, 1.0, ""),
    symbol("K", Dimension::TEMPERATURE, 1.0, 1.0, ""),
    symbol("degC", Dimension::TEMPERATURE, 1.0, 1.0, ""),
    symbol("degF", Dimension::TEMPERATURE, 5.0, 9.0, ""),
    symbol("degR", Dimension::TEMPERATURE, 5.0, 9.0, ""),
    symbol(
        "mK",
        Dimension::LENGTH.times(Dimension::TEMPERATURE),
        1.0,
        1.0,
        "",
    ),
    symbol(
        "kgK",
        Dimension::MASS.times(Dimension::TEMPERATURE),
        1.0,
        1.0,
        "",
    ),
    symbol(
        "gK",
        Dimension::MASS.times(Dimension::TEMPERATURE),
        1.0,
        1e3,
        "",
    ),
    symbol("rad", Dimension::ANGLE, 1.0, 1.0, "mu"),
    symbol("deg", Dimension::ANGLE, std::f64::consts::PI, 180.0, "m"),
    symbol(
        "arcmin",
        Dimension::ANGLE,
        std::f64::consts::PI,
        10_800.0,
        "",
    ),
    symbol(
        "arcsec",
        Dimension::ANGLE,
        std::f64::consts::PI,
        648_000.0,
        "",
    ),
    symbol("gon", Dimension::ANGLE, std::f64::consts::PI, 200.0, ""),
    symbol("rev", Dimension::ANGLE, std::f64::consts::TAU, 1.0, ""),
    symbol(
        "rpm",
        Dimension::ANGULAR_SPEED,
        std::f64::consts::TAU,
        60.0,
        "k",
    ),
    symbol("N", Dimension::FORCE, 1.0, 1.0, "numkMG"),
    symbol("dyn", Dimension::FORCE, 1.0, 1e5, "k"),
    symbol("kgf", Dimension::FORCE, GRAVITY, 1.0, ""),
    symbol("gf", Dimension::FORCE, GRAVITY, 1e3, ""),
    symbol("tf", Dimension::FORCE, 1e3 * GRAVITY, 1.0, ""),
    symbol("lbf", Dimension::FORCE, POUND_FORCE, 1.0, "k"),
    symbol("ozf", Dimension::FORCE, POUND_FORCE, 16.0, ""),
    symbol("kip", Dimension::FORCE, 1e3 * POUND_FORCE, 1.0, ""),
    symbol("pli", Dimension::FORCE_PER_LENGTH, POUND_FORCE, INCH, ""),
    symbol("Pa", Dimension::PRESSURE, 1.0, 1.0, "numhkMGT"),
    symbol("bar", Dimension::PRESSURE, 1e5, 1.0, "mhk"),
    symbol("at", Dimension::PRESSURE, 98_066.5, 1.0, ""),
    symbol("atm", Dimension::PRESSURE, STANDARD_ATMOSPHERE, 1.0, ""),
    symbol("Torr", Dimension::PRESSURE, STANDARD_ATMOSPHERE, 760.0, ""),
    symbol("mmHg", Dimension::PRESSURE, 133.322_387_415, 1.0, ""),
    symbol("psi", Dimension::PRESSURE, PSI, 1.0, "kMG"),
    symbol("ksi", Dimension::PRESSURE, 1e3 * PSI, 1.0, ""),
    symbol("msi", Dimension::PRESSURE, 1e6 * PSI, 1.0, ""),
    symbol("J", Dimension::ENERGY, 1.0, 1.0, "numkMG"),
    symbol("Nm", Dimension::ENERGY, 1.0, 1.0, "mkM"),
    symbol("Ncm", Dimension::ENERGY, 1.0, 1e2, ""),
    symbol("Nmm", Dimension::ENERGY, 1.0, 1e3, "k"),
    symbol("Ws", Dimension::ENERGY, 1.0, 1.0, "k"),
    symbol("Wh", Dimension::ENERGY, 3600.0, 1.0, "k"),
    symbol("erg", Dimension::ENERGY, 1.0, 1e7, ""),
    symbol("cal", Dimension::ENERGY, 4.184, 1.0, "k"),
    symbol("Btu", Dimension::ENERGY, BTU, 1.0, ""),
    symbol("W", Dimension::POWER, 1.0, 1.0, "numkMG"),
    symbol("hp", Dimension::POWER, 550.0 * FOOT * POUND_FORCE, 1.0, ""),
    symbol("PS", Dimension::POWER, 75.0 * GRAVITY, 1.0, ""),
    symbol("P", Dimension::VISCOSITY, 1.0, 10.0, "umcd"),
    symbol("Pas", Dimension::VISCOSITY, 1.0, 1.0, "um"),
    symbol("reyn", Dimension::VISCOSITY, PSI, 1.0, "um"),
    symbol("St", Dimension::KINEMATIC_VISCOSITY, 1.0, 1e4, "mc"),
];

/// Prefix, power of ten as numerator and denominator.
pub(super) const PREFIXES: &[(char, f64, f64)] = &[
    ('p', 1.0, 1e12),
    ('n', 1.0, 1e9),
    ('u', 1.0, 1e6),
    ('m', 1.0, 1e3),
    ('c', 1.0, 1e2),
    ('d', 1.0, 1e1),
    ('h', 1e2, 1.0),
    ('k', 1e3, 1.0),
    ('M', 1e6, 1.0),
    ('G', 1e9, 1.0),
    ('T', 1e12, 1.0),
];

/// Other spellings that mean one symbol for certain.
const SPELLINGS: &[(&str, &str)] = &[
    ("inch", "in"),
    ("inches", "in"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("yard", "yd"),
    ("thou", "mil"),
    ("mils", "mil"),
    ("microinch", "uin"),
    ("microinches", "uin"),
    ("micron", "um"),
    ("microns", "um"),
    ("Å", "angstrom"),
    ("meter", "m"),
    ("metre", "m"),
    ("ccm", "cc"),
    ("liter", "l"),
    ("litre", "l"),
    ("lbs", "lb"),
    ("lbm", "lb"),
    ("Lb", "lb"),
    ("kp", "kgf"),
    ("Kp", "kgf"),
    ("lbsf", "lbf"),
    ("dyne", "dyn"),
    ("dynes", "dyn"),
    ("sec", "s"),
    ("secs", "s"),
    ("second", "s"),
    ("seconds", "s"),
    ("minute", "min"),
    ("minutes", "min"),
    ("hr", "h"),
    ("hrs", "h"),
    ("hour", "h"),
    ("hours", "h"),
    ("C", "degC"),
    ("celsius", "degC"),
    ("Celsius", "degC"),
    ("degc", "degC"),
    ("F", "degF"),
    ("fahrenheit", "degF"),
    ("Fahrenheit", "degF"),
    ("degf", "degF"),
    ("kelvin", "K"),
    ("Kelvin", "K"),
    ("degK", "K"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("Grad", "deg"),
    ("RPM", "rpm"),
    ("Rpm", "rpm"),
    ("revs", "rev"),
    ("U", "rev"),
    ("Newton", "N"),
    ("newton", "N"),
    ("newtons", "N"),
    ("Pascal", "Pa"),
    ("pascal", "Pa"),
    ("PSI", "psi"),
    ("Psi", "psi"),
    ("KSI", "ksi"),
    ("Bar", "bar"),
    ("torr", "Torr"),
    ("BTU", "Btu"),
    ("btu", "Btu"),
    ("HP", "hp"),
    ("cp", "cP"),
    ("CP", "cP"),
    ("cps", "cP"),
    ("cPs", "cP"),
    ("poise", "P"),
    ("Poise", "P"),
    ("centipoise", "cP"),
    ("cst", "cSt"),
    ("CST", "cSt"),
    ("stokes", "St"),
    ("centistokes", "cSt"),
    ("microreyn", "ureyn"),
    ("reyns", "reyn"),
];

/// The spelling that the symbols have.
pub(super) fn usual_spelling(name: &str) -> &str {
    let found = SPELLINGS.iter().find(|(other, _)| *other == name);
    found.map_or(name, |(_, usual)| usual)
}
