//! Tables as spreadsheets and instruments write them, and what is wrong with others.

use super::*;

const PRESSURE: Dimension = Dimension::PRESSURE;

/// The numbers of the columns `pressure` and `viscosity`.
fn numbers(text: &str) -> Result<Vec<[f64; 2]>, CsvError> {
    let table = CsvTable::parse("t.csv", text)?;
    let pressure = table.find_with_unit("pressure", PRESSURE)?.unwrap();
    let viscosity = table
        .find_with_unit("viscosity", Dimension::VISCOSITY)?
        .unwrap();
    let row = |row| {
        Ok([
            table.required_number(row, &pressure)?,
            table.required_number(row, &viscosity)?,
        ])
    };
    table.rows().iter().map(row).collect()
}

#[test]
fn one_table_in_many_spellings() {
    for text in [
        "pressure_MPa,viscosity_mPa_s\n1,2.5\n3,4\n",
        "\u{feff}pressure [MPa], viscosity [mPa.s]\r\n1, 2.5\r\n3, 4",
        "\u{feff}# from a viscometer\n\nPressure (MPa);Viscosity (mPa.s)\n1;2,5\n  # \"hot\n3,0;4\n",
        "\"pressure [MPa]\",\"viscosity [mPa.s]\",\"remark, \"\"old\"\"\"\n\"1\",\"2.5\",\"a, b\"\n3,4\n",
        "pressure_bar\tremark\tviscosity_cP\n10\tx;y\t2,5\n\n30\t\t4.0\n",
        "viscosity_mPa_s,viscosity_ratio,pressure_MPa,,\n2.5,1,1,,\n4,1,3,,\n",
    ] {
        assert_eq!(
            numbers(text).unwrap(),
            [[1e6, 2.5e-3], [3e6, 4e-3]],
            "{text}"
        );
    }
}

#[test]
fn errors_name_file_line_and_column() {
    let head = "pressure_MPa;viscosity_mPa_s\n";
    for (text, line, column, part) in [
        ("\n# nothing\n", 1, 1, "the file is empty"),
        (
            "pressure_MPa,pressure [bar],viscosity_cP\n",
            1,
            2,
            "second column `pressure`",
        ),
        (
            "pressure_MPa,viscosity [Pa.s],viscosity [mPas]\n",
            1,
            3,
            "second column `viscosity`",
        ),
        (
            "pressure_MPa,viscosity [furlong],viscosity_cP\n",
            1,
            3,
            "second column `viscosity`",
        ),
        ("pressure_MPa,viscosity_furlong\n", 1, 2, "mPa.s"),
        ("pressure_MPa,viscosity\n", 1, 2, "has no unit"),
        ("pressure_MPa,viscosity_m\n", 1, 2, "unit of a length"),
        (
            &format!("{head}1;2\n\n# x\n1;2;3\n"),
            5,
            3,
            "3 cells, but the header has 2",
        ),
        (
            &format!("{head}1;1.23,4.5\n"),
            2,
            2,
            "`1.23,4.5` is not a number",
        ),
        (&format!("{head}1;1,234,5\n"), 2, 2, "not a number"),
        (&format!("{head}1;inf\n"), 2, 2, "not a number"),
        (&format!("{head}1e305;2\n"), 2, 1, "not a number"),
        (&format!("{head}1;\n"), 2, 2, "the cell is empty"),
        (&format!("{head}1\n"), 2, 2, "only 1 cells"),
        (
            &format!("{head}1;2\n3;\"4\n5;6\n"),
            3,
            2,
            "not closed on its line",
        ),
        (&format!("{head}1;\"2\n"), 2, 2, "not closed on its line"),
    ] {
        let error = numbers(text).unwrap_err();
        assert_eq!((error.line, error.column), (line, column), "{error}");
        let start = format!("t.csv:{line}:{column}: ");
        assert!(error.to_string().starts_with(&start), "{error}");
        assert!(error.problem.contains(part), "{error}");
    }
    let long = format!("{head}1;{}\u{1b}\n", "x".repeat(1000));
    let shown = numbers(&long).unwrap_err().to_string();
    assert!(
        shown.chars().count() < 400 && !shown.contains('\u{1b}'),
        "{shown}"
    );
}

#[test]
fn spans_are_those_of_the_lines() {
    let text = "\u{feff}# c\n\na,b\r\n 1,2\n\n# d\n3,\"4\"";
    let table = CsvTable::parse("t.csv", text).unwrap();
    let lines = |row: &Row| (row.line, &text[row.span.clone()]);
    assert_eq!(lines(table.header()), (3, "a,b"));
    let rows: Vec<_> = table.rows().iter().map(lines).collect();
    assert_eq!(rows, [(4, " 1,2"), (7, "3,\"4\"")]);
}

/// A title of thousands of control characters is no error of as many lines.
#[test]
fn errors_are_cut_to_what_can_be_read() {
    let text = format!("a{},b\n1,2,3\n", "\0".repeat(5000));
    let table = CsvTable::parse("d.csv", "a\n1\n").unwrap();
    let error = table.error(table.header(), 0, text);
    assert!(error.to_string().chars().count() < 2100);
}

/// `speed_mm_s` is a speed; where a product is asked for it is one.
#[test]
fn two_units_in_a_title_are_a_quotient_or_a_product() {
    let table = CsvTable::parse("t.csv", "speed_mm_s,work_N_m\n100,2\n").unwrap();
    let speed = table.find("speed", Dimension::SPEED).unwrap().unwrap();
    let row = &table.rows()[0];
    assert_eq!(table.required_number(row, &speed).unwrap(), 0.1);
    let work = table.find("work", Dimension::ENERGY).unwrap().unwrap();
    assert_eq!(table.required_number(row, &work).unwrap(), 2.0);
    assert!(table.find("speed", Dimension::FORCE).unwrap().is_none());
}

/// Reads a table with every reader and with default and given options.
fn read_all(text: &str) {
    let vocabulary = Vocabulary {
        names: &["pressure", "absolute pressure", "temperature", "viscosity"],
        is_key: &|title| title.contains('.'),
    };
    let given = CsvParams {
        columns: vec![ColumnMap::parse("viscosity=#2:mPa.s").unwrap()],
        ignored: vec!["T".to_owned()],
        decimal: Some(Decimal::Comma),
    };
    for params in [CsvParams::default(), given] {
        let Ok(table) = CsvTable::parse_for("x.csv", text, &vocabulary, &params) else {
            continue;
        };
        let names = [("pressure", PRESSURE), ("viscosity", Dimension::VISCOSITY)];
        for (name, dimension) in names {
            let Ok(Some(column)) = table.find_with_unit(name, dimension) else {
                continue;
            };
            for row in table.rows() {
                let _ = table.required_number(row, &column);
                let _ = &text[table.cell_span(text, row, column.index)];
                let _ = table.with_point(row.cell(column.index));
            }
        }
    }
}

proptest::proptest! {
    /// Nothing is read with a panic: text of the signs that mean something, and any bytes.
    #[test]
    fn any_text_is_read_or_refused(
        lines in proptest::collection::vec(
            proptest::string::string_regex("(p \\[MPa\\]|T|eta|[;,\t \"#%/()\\[\\]-]|[0-9.,]{1,6}|[°µη\u{308}ßA-z]|NaN|sep=|\u{feff}|\r){0,12}").unwrap(),
            0..8,
        )
    ) {
        let text = lines.join("\n");
        read_all(&text);
        read_all(&format!("p [MPa];T [K];eta [cP]\n{text}"));
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(proptest::num::u8::ANY, 0..300)) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("t.csv");
        std::fs::write(&path, &bytes).unwrap();
        if let Ok(text) = crate::file::read_table(&path) {
            read_all(&text);
            read_all(&format!("p [MPa]\tT [K]\teta [cP]\n{text}"));
        }
    }
}
