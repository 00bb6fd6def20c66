//! One viscosity table in the formats that people, spreadsheets and instruments write, and ambiguous tables that are rejected.

use ertel_input::csv::{ColumnMap, CsvParams, Decimal};
use ertel_input::file::read_table;

use super::*;

/// Pressure in MPa, temperature in °C, viscosity in mPa·s: Roelands' law for 40 mPa·s at 40 °C, 22 1/GPa and 0.045 1/K.
const STATES: [[f64; 3]; 9] = [
    [0.0, 20.0, 112.052],
    [100.0, 20.0, 1203.02],
    [200.0, 20.0, 9990.45],
    [0.0, 40.0, 40.0],
    [100.0, 40.0, 309.726],
    [200.0, 40.0, 1921.81],
    [0.0, 80.0, 9.53843],
    [100.0, 80.0, 46.8665],
    [200.0, 80.0, 193.837],
];

/// How the numbers are written.
#[derive(Clone, Copy)]
struct Style {
    separator: &'static str,
    number: fn(f64) -> String,
    end: &'static str,
    /// Conversions from MPa, °C and mPa·s.
    units: [fn(f64) -> f64; 3],
}

fn same(x: f64) -> f64 {
    x
}
fn bar(p: f64) -> f64 {
    10.0 * p
}
fn point(x: f64) -> String {
    format!("{x}")
}
fn comma(x: f64) -> String {
    point(x).replace('.', ",")
}
fn quoted(x: f64) -> String {
    format!("\"{}\"", comma(x))
}
fn scientific(x: f64) -> String {
    format!("{x:E}")
}
/// 1,203.020 with commas between thousands.
fn thousands(x: f64) -> String {
    let text = format!("{x:.4}");
    let (whole, decimals) = text.split_once('.').unwrap();
    match whole.len() {
        4 => format!("{},{}.{decimals}", &whole[..1], &whole[1..]),
        _ => text,
    }
}
fn german_thousands(x: f64) -> String {
    let swap = |c| match c {
        ',' => '.',
        '.' => ',',
        c => c,
    };
    thousands(x).chars().map(swap).collect()
}
fn spaced(x: f64) -> String {
    thousands(x).replace(',', "\u{202f}").replace('.', ",")
}

const COMMAS: Style = Style {
    separator: ",",
    number: point,
    end: "\n",
    units: [same, same, same],
};
const SEMICOLONS: Style = Style {
    separator: ";",
    ..COMMAS
};
const TABS: Style = Style {
    separator: "\t",
    ..COMMAS
};
const BLANKS: Style = Style {
    separator: "   ",
    ..COMMAS
};
const EXCEL: Style = Style {
    separator: ";",
    number: comma,
    end: "\r\n",
    units: [bar, same, same],
};

/// The table below lines with its titles.
fn table(head: &str, style: Style) -> String {
    let mut text = head.replace('\n', style.end) + style.end;
    for state in STATES {
        let cells = state.iter().zip(style.units);
        let cells: Vec<String> = cells
            .map(|(value, unit)| (style.number)(unit(*value)))
            .collect();
        text += &cells.join(style.separator);
        text += style.end;
    }
    text
}

fn read_bytes(bytes: &[u8], params: &CsvParams) -> Result<Data, DataError> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("oil.csv");
    std::fs::write(&path, bytes).unwrap();
    Data::parse_with(
        "oil.csv",
        &read_table(&path).unwrap(),
        Property::Viscosity,
        params,
    )
}

/// `offset` is that of the pressure, Pa.
fn check(name: &str, data: Result<Data, DataError>, offset: f64) {
    let data = data.unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(data.states.len(), STATES.len(), "{name}: {data:?}");
    for (state, [p, t, mu]) in data.states.iter().zip(STATES) {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-5 * b.abs().max(1.0);
        assert!(near(state.pressure, 1e6 * p + offset), "{name}: {state:?}");
        assert!(near(state.temperature, t + 273.15), "{name}: {state:?}");
        assert!(near(1e3 * state.value, mu), "{name}: {state:?}");
    }
}

#[test]
fn one_viscosity_table_in_many_spellings() {
    let kelvin: fn(f64) -> f64 = |t| t + 273.15;
    let fahrenheit: fn(f64) -> f64 = |t| 1.8 * t + 32.0;
    let in_units = |style: Style, units| Style { units, ..style };
    for (head, style) in [
        ("pressure_MPa,temperature_degC,viscosity_mPa_s", COMMAS),
        ("Pressure [MPa],Temperature [°C],Viscosity [mPa.s]", COMMAS),
        ("Pressure (MPa),Temperature (°C),Viscosity (mPa·s)", COMMAS),
        ("Pressure {MPa},Temperature {°C},Viscosity {mPa s}", COMMAS),
        ("pressure / MPa,temperature / °C,viscosity / mPa s", COMMAS),
        ("p/MPa,T/°C,η/mPa·s", COMMAS),
        (
            "Pressure in MPa;Temperature in °C;Viscosity in mPas",
            SEMICOLONS,
        ),
        ("p, MPa;T, °C;eta, mPa.s", SEMICOLONS),
        ("p: MPa;T: °C;mu: cP", SEMICOLONS),
        ("Pressure MPa\tTemperature C\tViscosity mPas", TABS),
        ("p;T;η\nMPa;°C;mPas", SEMICOLONS),
        (
            "Pressure,Temperature,Dynamic viscosity\n[MPa],[°C],[mPa·s]",
            COMMAS,
        ),
        ("Druck;Temperatur;Viskosität\n(bar);(°C);(mPas)", EXCEL),
        ("Druck [bar];Temperatur [°C];dyn. Viskosität [mPas]", EXCEL),
        (
            "Druck in bar;Öltemperatur in Grad C;Dynamische Viskosität in mPa s",
            EXCEL,
        ),
        (
            "Überdruck p / bar;Temperatur ϑ / °C;Viskositaet η / mPa·s",
            EXCEL,
        ),
        (
            "sep=;\nDruck [bar];Temperatur [°C];Viskosität [mPa·s]",
            EXCEL,
        ),
        ("\"sep=;\"\np [bar];t [°C];eta [mPa.s]", EXCEL),
        (
            "\"Druck\n[bar]\";\"Temperatur\n[°C]\";\"Viskosität\n[mPas]\"",
            EXCEL,
        ),
        (
            "p [barg],T [degC],mu [cP]",
            in_units(COMMAS, [bar, same, same]),
        ),
        (
            "p [bar(g)],T [deg C],mu [cps]",
            in_units(COMMAS, [bar, same, same]),
        ),
        (
            "Pressure (psig),Temperature (°F),Viscosity (cP)",
            in_units(COMMAS, [|p| p / 6.894_757_293_168_361e-3, fahrenheit, same]),
        ),
        (
            "pressure_GPa,temperature_K,viscosity_Pa_s",
            in_units(COMMAS, [|p| p / 1e3, kelvin, |mu| mu / 1e3]),
        ),
        (
            "pressure [N/mm2],temperature [K],viscosity [N.s/m2]",
            in_units(COMMAS, [same, kelvin, |mu| mu / 1e3]),
        ),
        ("pressure_MPa temperature_degC viscosity_mPa_s", BLANKS),
        (
            "Pressure [MPa]   Temperature [degC]   Viscosity [mPa.s]",
            BLANKS,
        ),
        (
            "Pressure [MPa] Temperature [degC] Viscosity [mPa.s]",
            Style {
                separator: " ",
                ..COMMAS
            },
        ),
        (
            "# pressure_MPa temperature_degC viscosity_mPa_s",
            Style {
                separator: " ",
                ..COMMAS
            },
        ),
        (
            "Anton Paar;MCR 302;Serial 12345\nOperator;Müller\nDate;03.04.2017;17:28\nTemperature;40;°C\n\nPressure [MPa];Temperature [°C];Viscosity [mPas]",
            SEMICOLONS,
        ),
        (
            "% from the rig\n// twice\n! old\npressure_MPa,temperature_degC,viscosity_mPa_s",
            COMMAS,
        ),
        (
            "p [bar];T [°C];eta [mPas]",
            Style {
                number: quoted,
                ..EXCEL
            },
        ),
        (
            "p [bar],T [°C],eta [mPas]",
            Style {
                separator: ",",
                number: quoted,
                ..EXCEL
            },
        ),
        (
            "p [MPa];T [°C];eta [mPas]",
            Style {
                number: thousands,
                ..SEMICOLONS
            },
        ),
        (
            "p [MPa];T [°C];eta [mPas]",
            Style {
                number: german_thousands,
                ..SEMICOLONS
            },
        ),
        (
            "p [MPa];T [°C];eta [mPas]",
            Style {
                number: spaced,
                ..SEMICOLONS
            },
        ),
        (
            "p [MPa]\tT [°C]\teta [mPas]",
            Style {
                number: scientific,
                ..TABS
            },
        ),
        (
            "p [MPa]\tT [°C]\teta [mPas]",
            Style {
                number: comma,
                ..TABS
            },
        ),
    ] {
        let text = table(head, style);
        check(
            head,
            read_bytes(text.as_bytes(), &CsvParams::default()),
            0.0,
        );
    }
}

#[test]
fn encodings_ends_and_empty_cells_do_not_matter() {
    let text = table("Druck [bar];Temperatur [°C];Viskosität [mPas]", EXCEL);
    let utf16 = |bytes_of: fn(u16) -> [u8; 2]| -> Vec<u8> {
        format!("\u{feff}{text}")
            .encode_utf16()
            .flat_map(bytes_of)
            .collect()
    };
    let none = CsvParams::default();
    for bytes in [
        format!("\u{feff}{text}").into_bytes(),
        text.chars().map(|c| c as u8).collect(),
        utf16(u16::to_le_bytes),
        utf16(u16::to_be_bytes),
        text.replace("\r\n", "\r").into_bytes(),
        text.replace("\r\n", ";;\r\n").into_bytes(),
        text.replace("\r\n", "\r\n;;\r\n\r\n").into_bytes(),
        text.replace("\r\n", "\r\n# a comment; with 1; 2; 3; 4\r\n")
            .into_bytes(),
        text.lines()
            .map(|l| format!(";;{l};\n"))
            .collect::<String>()
            .into_bytes(),
        text.lines()
            .enumerate()
            .map(|(i, l)| {
                format!(
                    "{};{l}\n",
                    if i == 0 { String::new() } else { i.to_string() }
                )
            })
            .collect::<String>()
            .into_bytes(),
        format!("{text}End of the data\r\n").into_bytes(),
        format!("{text}500;20;n/a\r\n600;20;\r\n700;20;NaN\r\n").into_bytes(),
        format!("{text}Druck [bar];Temperatur [°C];Viskosität [mPas]\r\n").into_bytes(),
    ] {
        check(
            &String::from_utf8_lossy(&bytes),
            read_bytes(&bytes, &none),
            0.0,
        );
    }
    // By hand: vacuum is 101,325 Pa below the ambient pressure.
    for head in [
        "p [bara];T [°C];eta [mPas]",
        "Absolutdruck [bar];T [°C];eta [mPas]",
        "p [bar(a)];T [°C];eta [mPas]",
        "Pressure, bar abs;T, C;eta, mPas",
    ] {
        check(
            head,
            read_bytes(table(head, EXCEL).as_bytes(), &none),
            -101_325.0,
        );
    }
}

/// μ = ρ ν: 872 kg/m³ and 45.8715596 mm²/s are 40 mPa·s.
#[test]
fn a_kinematic_viscosity_needs_a_density() {
    for head in [
        "p [bar],T [degC],nu [cSt],rho [g/cm3]",
        "Druck [bar],Temperatur [degC],Viskosität [mm²/s],Dichte [kg/l]",
    ] {
        let unit = if head.contains("kg/l") {
            "g/cm3"
        } else {
            "kg/l"
        };
        let text = format!("{}\n0,40,45.8715596,0.872\n", head.replace("kg/l", unit));
        let data = read_bytes(text.as_bytes(), &CsvParams::default()).unwrap();
        assert!((data.states[0].value - 0.04).abs() < 1e-9, "{data:?}");
        assert!(
            data.notes
                .iter()
                .any(|note| note.contains("multiplied by the density")),
            "{data:?}"
        );
    }
    let error = read_bytes(
        b"p [bar],T [degC],viscosity [cSt]\n0,40,46\n",
        &CsvParams::default(),
    );
    let error = error.unwrap_err();
    assert_eq!((error.line, error.column), (1, 3));
    for words in ["kinematic viscosity", "density"] {
        assert!(error.problem.contains(words), "{error}");
    }
    let both = b"p [bar],T [degC],nu [cSt],viscosity [mPas]\n0,40,46,40\n";
    assert_eq!(
        read_bytes(both, &CsvParams::default()).unwrap().states[0].value,
        0.04
    );
}

#[test]
fn columns_are_assigned_by_the_user() {
    let params = |maps: &[&str]| CsvParams {
        columns: maps
            .iter()
            .map(|map| ColumnMap::parse(map).unwrap())
            .collect(),
        ..CsvParams::default()
    };
    let text = table("Sensor A,Sensor B,Result [mPas]", COMMAS);
    let maps = [
        "pressure=Sensor A:MPa",
        "T=Sensor B:degC",
        "viscosity=Result [mPas]",
    ];
    check("titles", read_bytes(text.as_bytes(), &params(&maps)), 0.0);
    let text = table("x,x,x", COMMAS);
    let maps = ["p=#1:MPa", "temperature=#2:degC", "eta=#3:cP"];
    check("numbers", read_bytes(text.as_bytes(), &params(&maps)), 0.0);
    // A second column of the same name is no longer in the way.
    let twice = table(
        "p [MPa],T [degC],viscosity [mPas],viscosity (corrected) [mPas]",
        COMMAS,
    );
    let rows = twice
        .lines()
        .map(|l| format!("{l},1\n").replace("mPas],1", "mPas]"));
    let data = read_bytes(
        rows.collect::<String>().as_bytes(),
        &params(&["viscosity=viscosity [mPas]"]),
    );
    check("twice", data, 0.0);
    for (map, words) in [
        ("viscosity=Nothing", "no column `Nothing`"),
        ("film=Sensor A:nm", "`film` is no quantity"),
        ("pressure=Sensor A", "has no unit"),
        ("pressure=Sensor A:kg", "a mass"),
    ] {
        let text = table("Sensor A,T [degC],viscosity [mPas]", COMMAS);
        let error = read_bytes(text.as_bytes(), &params(&[map])).unwrap_err();
        assert!(error.problem.contains(words), "{error}");
    }
    assert!(ColumnMap::parse("film").is_err() && ColumnMap::parse("=x").is_err());
}

/// Tables that have two readings are not read.
#[test]
fn nothing_is_guessed() {
    let head = "p [MPa];T [degC];eta [mPas]\n";
    for (text, words) in [
        // Thousands or decimals?
        (
            format!("{head}0;40;1,203\n100;40;4,560\n"),
            &["1.203 or 1203", ":2:3:", "--decimal"][..],
        ),
        (
            format!("{head}0;40;1.203\n100;40;4,56\n"),
            &["1.203 or 1203"],
        ),
        (
            format!("{head}0;40;1,203\n100;40;4.56\n"),
            &["1.203 or 1203"],
        ),
        // Decimal commas between commas.
        (
            "p [MPa],T [degC],eta [mPas]\n0,40,112,052\n".to_owned(),
            &["4 cells", "quoted"],
        ),
        (
            "p [MPa],T [degC],eta [mPas],,\n0,40,112,052,\n".to_owned(),
            &["no title", "052", "quote"],
        ),
        // Two headers.
        (
            "p [MPa];T [K]\n1;300\nfurther\np [bar];eta [mPas]\n1;2\n".to_owned(),
            &["lines 1 and 4"],
        ),
        (
            "p [MPa];T [degC];eta [mPas];viscosity [cP]\n1;2;3;4\n".to_owned(),
            &["second column `viscosity`", "--column"],
        ),
        (
            "p [MPa];p [bar];T [degC];eta [mPas]\n1;2;3;4\n".to_owned(),
            &["second column `pressure`"],
        ),
        (
            format!("{head}NaN;40;2\n"),
            &["`NaN` is not a number", ":2:1:"],
        ),
        (format!("{head};40;2\n"), &["the cell is empty"]),
        (format!("{head}1;40;NaN\n"), &["no states"]),
        (head.to_owned(), &["no states"]),
        (String::new(), &["empty", "--column"]),
        ("\n\n# nothing\n".to_owned(), &["empty"]),
        (
            "a;b;c\n1;2;3\n".to_owned(),
            &["no column `pressure`", "a, b, c", "--column"],
        ),
        (
            "p;T [degC];eta [mPas]\n1;2;3\n".to_owned(),
            &["`p` has no unit", "pressure=p:Pa"],
        ),
        (
            "p [xyz];T [degC];eta [mPas]\n1;2;3\n".to_owned(),
            &["`p [xyz]`", "xyz"],
        ),
        (format!("{head}1;40;2;7\n"), &["4 cells"]),
        (format!("{head}1;40;two\n"), &["`two` is not a number"]),
    ] {
        let error = read_bytes(text.as_bytes(), &CsvParams::default());
        let error = error
            .map(|data| panic!("{text}\n{data:?}"))
            .unwrap_err()
            .to_string();
        for words in words {
            assert!(error.contains(words), "{text}\n{error}");
        }
    }
    let params = |decimal| CsvParams {
        decimal: Some(decimal),
        ..CsvParams::default()
    };
    let text = format!("{head}0;40;1,203\n");
    let value = |decimal| {
        read_bytes(text.as_bytes(), &params(decimal))
            .unwrap()
            .states[0]
            .value
    };
    assert_eq!(
        (value(Decimal::Comma), value(Decimal::Point)),
        (1.203e-3, 1.203)
    );
}

/// Pa·s for mPa·s in a title, as in a library of media.
#[test]
fn a_unit_that_was_mistaken_is_asked_about() {
    let head = "pressure [MPa],temperature [degC],viscosity [Pa.s]";
    let data = read_bytes(table(head, COMMAS).as_bytes(), &CsvParams::default()).unwrap();
    let asked = data
        .notes
        .iter()
        .find(|note| note.contains("is 112.1 mPa.s meant?"));
    assert!(
        asked.is_some_and(|note| note.contains("viscosity in line 2 = 112052 mPa.s")),
        "{:?}",
        data.notes
    );
    let usual = table(
        "pressure [MPa],temperature [degC],viscosity [mPa.s]",
        COMMAS,
    );
    assert!(
        read_bytes(usual.as_bytes(), &CsvParams::default())
            .unwrap()
            .notes
            .is_empty()
    );
    let text = "p [MPa],T [degC],density [g/cm3]\n0,20,880\n50,20,900\n";
    let data = Data::parse("d.csv", text, Property::Density).unwrap();
    assert!(
        data.notes[0].contains("is 880 kg/m^3 meant?"),
        "{:?}",
        data.notes
    );
}
