use super::{Dimension, QuantityError, Unit, UnitError, parse};
use proptest::prelude::*;

fn close(text: &str, dimension: Dimension, expected: f64) {
    let value = parse(text, dimension).unwrap_or_else(|error| panic!("{error}"));
    // Two roundings at most: the number and one scaling.
    assert!(
        (value - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
        "{text}: {value} instead of {expected}"
    );
}

#[test]
fn quantities_of_a_case_file_in_si() {
    close("16 mm", Dimension::LENGTH, 0.016);
    close("100 N", Dimension::FORCE, 100.0);
    close("22 1/GPa", Dimension::INVERSE_PRESSURE, 2.2e-8);
    close("22 GPa^-1", Dimension::INVERSE_PRESSURE, 2.2e-8);
    close("22 GPa⁻¹", Dimension::INVERSE_PRESSURE, 2.2e-8);
    close("22/GPa", Dimension::INVERSE_PRESSURE, 2.2e-8);
    close("0.022 MPa^-1", Dimension::INVERSE_PRESSURE, 2.2e-8);
    close("40 mPa.s", Dimension::VISCOSITY, 0.04);
    close("40 mPa s", Dimension::VISCOSITY, 0.04);
    close("40 mPa·s", Dimension::VISCOSITY, 0.04);
    close("40 cP", Dimension::VISCOSITY, 0.04);
    close("0.4 P", Dimension::VISCOSITY, 0.04);
    close("32 cSt", Dimension::KINEMATIC_VISCOSITY, 32e-6);
    close("32 mm^2/s", Dimension::KINEMATIC_VISCOSITY, 32e-6);
    close("870 kg/m^3", Dimension::DENSITY, 870.0);
    close("870 kg/m3", Dimension::DENSITY, 870.0);
    close("870 kg m-3", Dimension::DENSITY, 870.0);
    close("0.87 g/cm³", Dimension::DENSITY, 870.0);
    close("470 J/(kg.K)", Dimension::SPECIFIC_HEAT, 470.0);
    close("470 J/kg/K", Dimension::SPECIFIC_HEAT, 470.0);
    close("46 W/(m.K)", Dimension::THERMAL_CONDUCTIVITY, 46.0);
    close("46 W m^-1 K^-1", Dimension::THERMAL_CONDUCTIVITY, 46.0);
    close("46 W/(m degC)", Dimension::THERMAL_CONDUCTIVITY, 46.0);
    close("7.52e-4 1/K", Dimension::INVERSE_TEMPERATURE, 7.52e-4);
    close("250 nm", Dimension::LENGTH, 2.5e-7);
    close("12 um", Dimension::LENGTH, 1.2e-5);
    close("12 µm", Dimension::LENGTH, 1.2e-5);
    close("12 μm", Dimension::LENGTH, 1.2e-5);
    close("0.5 in", Dimension::LENGTH, 0.0127);
    close("210 GPa", Dimension::PRESSURE, 210e9);
    close("1 bar", Dimension::PRESSURE, 1e5);
    close("1 atm", Dimension::PRESSURE, 101_325.0);
    close(
        "1 psi",
        Dimension::PRESSURE,
        4.448_221_615_260_5 / 0.0254 / 0.0254,
    );
    close("800 mm/s", Dimension::SPEED, 0.8);
    close("60 m/min", Dimension::SPEED, 1.0);
    close("3 N/mm", Dimension::FORCE_PER_LENGTH, 3000.0);
    close("0.3", Dimension::DIMENSIONLESS, 0.3);
    close("30 %", Dimension::DIMENSIONLESS, 0.3);
    close("30%", Dimension::DIMENSIONLESS, 0.3);
    close("2 m/m", Dimension::DIMENSIONLESS, 2.0);
    close(
        "-1.5 1/GPa^2",
        Dimension::INVERSE_PRESSURE_SQUARED,
        -1.5e-18,
    );
    close("4.07e-3 1/MPa", Dimension::INVERSE_PRESSURE, 4.07e-9);
    close(
        "1118.62 K/GPa",
        Dimension::TEMPERATURE_PER_PRESSURE,
        1118.62e-9,
    );
    close("16mm", Dimension::LENGTH, 0.016);
    close(" +1.6E1  mm ", Dimension::LENGTH, 0.016);
    close(".5 m", Dimension::LENGTH, 0.5);
    close("5. m", Dimension::LENGTH, 5.0);
}

#[test]
fn celsius_is_absolute_or_a_difference_as_asked() {
    close("40 degC", Dimension::TEMPERATURE, 313.15);
    close("40 °C", Dimension::TEMPERATURE, 313.15);
    close("-73.86 degC", Dimension::TEMPERATURE, 199.29);
    close("313.15 K", Dimension::TEMPERATURE, 313.15);
    close("104 degF", Dimension::TEMPERATURE, 313.15);
    close("40 degC", Dimension::TEMPERATURE_DIFFERENCE, 40.0);
    close("18.18 K", Dimension::TEMPERATURE_DIFFERENCE, 18.18);
    close("9 degF", Dimension::TEMPERATURE_DIFFERENCE, 5.0);
}

#[test]
fn revolutions_per_minute_are_an_angular_speed() {
    // 3000/60 revolutions of 2π each second.
    let close = |text: &str, expected: f64| {
        let value = parse(text, Dimension::ANGULAR_SPEED).unwrap();
        assert!((value / expected - 1.0).abs() < 1e-14, "{text}: {value}");
    };
    close("3000 rpm", 314.159_265_358_979_3);
    close("360 deg/s", std::f64::consts::TAU);
    assert_eq!(
        message("50 Hz", Dimension::ANGULAR_SPEED),
        "`50 Hz` is a rate, but an angular speed is needed (rad/s, rpm)"
    );
}

#[test]
fn scaling_by_powers_of_ten_is_exact() {
    // Dividing by 1e9 rounds once; multiplying by 1e-9 would round twice and miss the literal.
    assert_eq!(parse("22 1/GPa", Dimension::INVERSE_PRESSURE), Ok(22e-9));
    assert_eq!(parse("0.8 mm", Dimension::LENGTH), Ok(0.8e-3));
    assert_eq!(parse("7 um", Dimension::LENGTH), Ok(7e-6));
}

fn message(text: &str, dimension: Dimension) -> String {
    parse(text, dimension).unwrap_err().to_string()
}

#[test]
fn a_wrong_dimension_says_what_it_is_and_what_is_needed() {
    assert_eq!(
        message("100 mm", Dimension::FORCE),
        "`100 mm` is a length, but a force is needed (N, kN, mN)"
    );
    assert_eq!(
        message("3 N/m", Dimension::FORCE),
        "`3 N/m` is a force per length, but a force is needed (N, kN, mN)"
    );
    assert_eq!(
        message("3 kg.m^5", Dimension::LENGTH),
        "`3 kg.m^5` is a quantity in kg.m^5, but a length is needed (m, mm, um, nm)"
    );
    assert!(message("40 degC", Dimension::LENGTH).contains("is a temperature, but a length"));
    assert!(message("2 mm", Dimension::DIMENSIONLESS).contains("but a number without unit"));
}

#[test]
fn a_missing_unit_names_the_units() {
    assert_eq!(
        message("100", Dimension::FORCE),
        "`100` has no unit; a force is needed (N, kN, mN)"
    );
}

#[test]
fn unknown_units_come_with_near_ones() {
    let near = |text: &str| match parse(text, Dimension::VISCOSITY) {
        Err(QuantityError::Unit {
            source: UnitError::Unknown { near, .. },
            ..
        }) => near,
        other => panic!("{other:?}"),
    };
    assert_eq!(near("1 mpa"), ["mPa", "MPa"]);
    assert_eq!(near("1 mPas"), ["mPa.s"]);
    assert_eq!(near("1 W/mK"), ["m.K"]);
    assert_eq!(near("1 C"), ["degC"]);
    assert_eq!(near("1 degc"), ["degC"]);
    assert_eq!(near("1 furlong"), Vec::<String>::new());
    assert_eq!(
        message("1 mPas", Dimension::VISCOSITY),
        "`1 mPas`: unknown unit `mPas`; did you mean mPa.s?"
    );
}

#[test]
fn a_product_after_a_slash_needs_parentheses() {
    assert!(message("470 J/kg.K", Dimension::SPECIFIC_HEAT).contains("two ways"));
    assert!(message("46 W/m K", Dimension::THERMAL_CONDUCTIVITY).contains("two ways"));
}

/// 40 degC are 313.15 K and 104 degF; of a difference the zero of the scale is none of its business.
#[test]
fn values_are_written_back_in_their_units() {
    for (unit, number, value) in [
        ("degC", 40.0, 313.15),
        ("degF", 104.0, 313.15),
        ("K", 313.15, 313.15),
        ("mPa.s", 40.0, 0.04),
        ("1/GPa", 22.0, 22e-9),
        ("W/(m degC)", 46.0, 46.0),
    ] {
        let parsed = Unit::parse(unit).unwrap();
        assert!((parsed.to_si(number) / value - 1.0).abs() < 1e-14, "{unit}");
        assert!(
            (parsed.from_si(value) / number - 1.0).abs() < 1e-14,
            "{unit}"
        );
    }
    let fahrenheit = Unit::parse("degF").unwrap();
    assert!((fahrenheit.difference_to_si(9.0) - 5.0).abs() < 1e-14);
}

#[test]
fn numbers_must_be_finite() {
    for text in [
        "nan mm", "NaN", "inf N", "-inf N", "Infinity", "1e999 m", "1e308 km",
    ] {
        let error = parse(text, Dimension::LENGTH).unwrap_err();
        assert!(
            matches!(
                error,
                QuantityError::NotFinite { .. } | QuantityError::MissingUnit { .. }
            ),
            "{text}: {error}"
        );
    }
    assert!(message("1e999 m", Dimension::LENGTH).contains("not a finite number"));
    assert!(message("nan mm", Dimension::LENGTH).contains("not a finite number"));
    assert!(message("-300 degC", Dimension::TEMPERATURE).contains("below absolute zero"));
}

#[test]
fn garbage_is_refused() {
    for text in [
        "",
        " ",
        "mm",
        "16 mm mm^",
        "16 mm/",
        "16 (mm",
        "16 mm)",
        "16 m^x",
        "16 m^1.5",
        "16 m^99",
        "1,5 mm",
        "16 mm # large",
        "--3 m",
        "e3 m",
        "16 m..",
        "16 ()",
        "16 2 m",
        "0x10 m",
        "−3 m",
        "16 mm!",
        "16 m^^",
        "16 ²",
    ] {
        let result = parse(text, Dimension::LENGTH);
        assert!(result.is_err(), "{text} was read as {result:?}");
    }
    let deep = format!("1 {}m{}", "(".repeat(10_000), ")".repeat(10_000));
    assert!(parse(&deep, Dimension::LENGTH).is_err());
}

proptest! {
    #[test]
    fn no_text_makes_the_parser_panic(text in "\\PC{0,24}") {
        if let Ok(value) = parse(&text, Dimension::LENGTH) {
            prop_assert!(value.is_finite());
        }
    }

    #[test]
    fn unit_like_text_does_not_panic(text in "[-+0-9.eE]{0,6} ?[a-zA-Zµ°%/.^()0-9 -]{0,12}") {
        let _ = parse(&text, Dimension::PRESSURE);
    }

    #[test]
    fn a_printed_number_is_read_back(value in -1e30_f64..1e30) {
        prop_assert_eq!(parse(&format!("{value:e} m"), Dimension::LENGTH), Ok(value));
        prop_assert_eq!(parse(&format!("{value} m"), Dimension::LENGTH), Ok(value));
    }
}
