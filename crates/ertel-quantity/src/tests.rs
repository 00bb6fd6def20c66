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
    assert_eq!(near("1 kgm"), ["kg.m"]);
    assert_eq!(near("1 turns"), ["rev"]);
    assert_eq!(near("1 furlong"), Vec::<String>::new());
    assert_eq!(
        message("1 mpa", Dimension::VISCOSITY),
        "`1 mpa`: unknown unit `mpa`; did you mean mPa or MPa?"
    );
}

#[test]
fn a_product_after_a_slash_is_read_where_one_way_fits() {
    close("470 J/kg.K", Dimension::SPECIFIC_HEAT, 470.0);
    close("46 W/m K", Dimension::THERMAL_CONDUCTIVITY, 46.0);
    assert!(message("46 W/m K", Dimension::PRESSURE).contains("two ways"));
    assert!(Unit::parse("J/kg.K").is_err());
}

/// Units of data sheets and books, with what they are by definition: 1 in = 25.4 mm, 1 lb = 0.453 592 37 kg, g = 9.806 65 m/s²,
/// 1 US gallon = 231 in³.
#[test]
fn units_of_data_sheets_by_their_definition() {
    use Dimension as D;
    let psi = 0.453_592_37 * 9.806_65 / (0.0254 * 0.0254);
    let pound_force = 0.453_592_37 * 9.806_65;
    for (texts, dimension, expected) in [
        (
            "0.879 kg/l; 0.879 kg/L; 0.879 kg/dm3; 0.879 g/ml; 0.879 g/mL; 0.879 g/cc; 879 g/l",
            D::DENSITY,
            879.0,
        ),
        (
            "1 lb/ft3; 1 lb/ft^3; 1 lbm/ft³",
            D::DENSITY,
            0.453_592_37 / (0.3048 * 0.3048 * 0.3048),
        ),
        (
            "1 lb/gal",
            D::DENSITY,
            0.453_592_37 / (231.0 * 0.0254 * 0.0254 * 0.0254),
        ),
        (
            "1 slug/ft3",
            D::DENSITY,
            4.448_221_615_260_5 / 0.3048 / (0.3048 * 0.3048 * 0.3048),
        ),
        (
            "1 reyn; 1 psi.s; 1 lbf.s/in^2; 1e6 ureyn; 1e6 µreyn; 1e6 microreyn",
            D::VISCOSITY,
            psi,
        ),
        (
            "40 mPas; 40 mPa·s; 40 mPa*s; 0.04 Pas; 40 cP; 40 cp; 40 cps; 40000 uPas; 0.4 P; 0.4 g/(cm.s); 40 mPa-s; \
             40 mN.s/m2",
            D::VISCOSITY,
            0.04,
        ),
        (
            "46 cSt; 46 cst; 46 mm2/s; 46 mm²/s; 0.46 St; 46 mm^2/sec; 0.46 cm2/s",
            D::KINEMATIC_VISCOSITY,
            46e-6,
        ),
        (
            "1 kgf; 1 kp; 9.80665 N; 980665 dyn; 980.665 kdyn",
            D::FORCE,
            9.806_65,
        ),
        (
            "1 lbf; 0.001 kip; 16 ozf; 0.001 klbf",
            D::FORCE,
            pound_force,
        ),
        (
            "1 lbf/in; 1 pli; 12 lbf/ft",
            D::FORCE_PER_LENGTH,
            pound_force / 0.0254,
        ),
        ("21000 kgf/mm2; 21000 kp/mm²", D::PRESSURE, 205.939_65e9),
        ("1 at; 1 kgf/cm2; 1 kp/cm²", D::PRESSURE, 98_066.5),
        (
            "760 Torr; 1 atm; 1013.25 mbar; 10.1325 N/cm2; 1013.25 hPa",
            D::PRESSURE,
            101_325.0,
        ),
        (
            "30 Mpsi; 30 msi; 30000 ksi; 3e7 psi; 3e7 PSI; 3e7 lbf/in2",
            D::PRESSURE,
            3e7 * psi,
        ),
        ("210 GPa; 210 kN/mm2; 210000 N/mm^2", D::PRESSURE, 210e9),
        (
            "2.2e-9 cm2/dyn; 2.2×10^-8 m2/N; 2.2 x 10^-8 m²/N; 2.2·10⁻⁸ 1/Pa; 0.022 mm2/N; 22 1/GPa; 22 GPa-1",
            D::INVERSE_PRESSURE,
            22e-9,
        ),
        ("1 in2/lbf; 1 psi^-1", D::INVERSE_PRESSURE, 1.0 / psi),
        (
            "4 uin; 4 µin; 4 μin; 4 microinch; 101.6 nm; 1016 angstrom",
            D::LENGTH,
            101.6e-9,
        ),
        (
            "630 mil; 630 thou; 630 mils; 0.63 in; 0.63 inch; 0.63 inches; 16.002 mm",
            D::LENGTH,
            0.016_002,
        ),
        (
            "0.4 micron; 0.4 microns; 0.4 µm; 0.4 μm; 0.4 um",
            D::LENGTH,
            0.4e-6,
        ),
        ("1 ft; 1 foot; 12 in", D::LENGTH, 0.3048),
        (
            "302 Nm; 302 N.m; 0.302 kNm; 302000 Nmm; 302 J; 302000 mNm",
            D::ENERGY,
            302.0,
        ),
        (
            "1 lbf.ft; 1 ft-lbf; 12 lbf.in; 12 in-lbf",
            D::ENERGY,
            pound_force * 0.3048,
        ),
        (
            "1500 1/min; 1500 min^-1; 1500 min-1; 1500 rpm; 1500 RPM; 1500 rev/min; 1500 U/min; 25 rev/s; 1500 /min",
            D::ANGULAR_SPEED,
            50.0 * std::f64::consts::PI,
        ),
        (
            "90 C; 90 °C; 90 degC; 90 deg C; 90 celsius; 90 ° C; 90 ºC; 363.15 K; 363.15 kelvin; 194 F; 194 °F; \
             653.67 degR",
            D::TEMPERATURE,
            363.15,
        ),
        (
            "45 W/(m.K); 45 W/mK; 45 W/m/K; 45 W/m·K; 45 W/(m·K); 45 W m-1 K-1; 45 W/(m °C); 45 W/m-K; 45 N/(s.K)",
            D::THERMAL_CONDUCTIVITY,
            45.0,
        ),
        (
            "1 Btu/(h.ft.degF); 1 BTU/hr/ft/°F",
            D::THERMAL_CONDUCTIVITY,
            1_055.055_852_62 / 3600.0 / 0.3048 * 1.8,
        ),
        (
            "470 J/(kg.K); 470 J/kgK; 470 J/kg K; 0.47 J/gK; 0.47 kJ/(kg K); 0.47 kJ/kg/°C",
            D::SPECIFIC_HEAT,
            470.0,
        ),
        ("1 Btu/(lb.degF); 1 BTU/lb/°F", D::SPECIFIC_HEAT, 4186.8),
        ("1 cal/(g.K); 1 kcal/(kg.degC)", D::SPECIFIC_HEAT, 4184.0),
        (
            "6.5e-4 1/K; 6.5e-4 /K; 6.5e-4 1/degC; 6.5e-4 K-1; 650 ppm/K",
            D::INVERSE_TEMPERATURE,
            6.5e-4,
        ),
        (
            "2 m/s; 2000 mm/s; 120 m/min; 7.2 km/h; 2 m s-1",
            D::SPEED,
            2.0,
        ),
        ("1 ft/s; 60 fpm; 12 ips; 12 in/s", D::SPEED, 0.3048),
        (
            "180 deg; 180 °; 200 gon; 10800 arcmin",
            D::ANGLE,
            std::f64::consts::PI,
        ),
    ] {
        for text in texts.split("; ") {
            let value = parse(text, dimension).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!(
                (value / expected - 1.0).abs() < 1e-14,
                "{text}: {value} instead of {expected}"
            );
        }
    }
}

/// 215 SUS at 100 °F are 46.17 mm²/s by the formula of ASTM D2161, 100 mm²/s are 463.46 SUS.
#[test]
fn saybolt_seconds_are_kinematic_viscosities() {
    let value = parse("463.46 SUS", Dimension::KINEMATIC_VISCOSITY).unwrap();
    assert!((value / 100e-6 - 1.0).abs() < 1e-5, "{value}");
    assert_eq!(
        parse("463.46 SSU", Dimension::KINEMATIC_VISCOSITY),
        Ok(value)
    );
    assert!(message("20 SUS", Dimension::KINEMATIC_VISCOSITY).contains("begin at 32 SUS"));
    assert!(message("20 SUS", Dimension::VISCOSITY).contains("is a kinematic viscosity"));
    let unit = Unit::parse("SUS").unwrap();
    assert!((unit.from_si(100e-6) - 463.46).abs() < 0.01);
    assert!(super::parse_uncertain("463 SUS ± 40 SUS", Dimension::KINEMATIC_VISCOSITY).is_err());
    assert!(super::parse_uncertain("463 SUS ± 2 %", Dimension::KINEMATIC_VISCOSITY).is_ok());
}

#[test]
fn a_weight_is_a_force() {
    for (text, dimension) in [
        ("10 kg", Dimension::FORCE),
        ("10 lb", Dimension::FORCE),
        ("1 kg/cm2", Dimension::PRESSURE),
    ] {
        let error = parse(text, dimension).unwrap_err();
        assert!(error.advice().unwrap().contains("kgf"), "{text}");
    }
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
