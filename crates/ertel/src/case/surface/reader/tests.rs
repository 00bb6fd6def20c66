use std::path::PathBuf;

use approx::assert_relative_eq;
use rawzip::ZipArchiveWriter;

use super::*;

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

fn written(folder: &tempfile::TempDir, name: &str, bytes: &[u8]) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    path
}

const ROWS: Told = Told {
    spacing: Some(2e-6),
    row_spacing: Some(3e-6),
    height_unit: Some(1e-9),
    length_unit: None,
    has_points: false,
};

const POINTS: Told = Told {
    spacing: None,
    row_spacing: None,
    height_unit: Some(1e-9),
    length_unit: Some(1e-6),
    has_points: true,
};

/// Heights 10 j + i nm, a hole at (2, 1).
fn expected() -> Vec<f64> {
    let height = |k: usize| match k {
        7 => f64::NAN,
        k => 1e-9 * (10 * (k / 5) + k % 5) as f64,
    };
    (0..20).map(height).collect()
}

fn assert_is_expected(heights: &Heights, format: Format) {
    assert_eq!(heights.format, format);
    let map = &heights.map;
    assert_eq!(map.counts, [5, 4]);
    assert_relative_eq!(map.spacing[0], 2e-6, max_relative = 1e-12);
    assert_relative_eq!(map.spacing[1], 3e-6, max_relative = 1e-12);
    for (own, expected) in map.heights.iter().zip(expected()) {
        assert_eq!(own.is_nan(), expected.is_nan());
        if !own.is_nan() {
            assert_relative_eq!(*own, expected, max_relative = 1e-6, epsilon = 1e-18);
        }
    }
}

fn cell(h: f64, hole: &str) -> String {
    match h.is_nan() {
        true => hole.to_owned(),
        false => format!("{:.1}", h * 1e9),
    }
}

fn rows(separator: &str, hole: &str) -> String {
    let all = expected();
    let row = |row: &[f64]| -> String {
        let cells: Vec<String> = row.iter().map(|h| cell(*h, hole)).collect();
        cells.join(separator) + "\n"
    };
    all.chunks(5).map(row).collect()
}

fn points(separator: &str, with_hole: bool) -> String {
    let line = |(k, h): (usize, f64)| {
        let (x, y) = (-4.0 + 2.0 * (k % 5) as f64, 3.0 * (k / 5) as f64);
        format!("{x}{separator}{y}{separator}{}\n", cell(h, "nan"))
    };
    // The last point first.
    let mut all: Vec<(usize, f64)> = expected().into_iter().enumerate().collect();
    all.rotate_right(3);
    (all.into_iter().filter(|(_, h)| with_hole || !h.is_nan()))
        .map(line)
        .collect()
}

#[test]
fn texts_in_all_forms() {
    let folder = folder();
    let comment = |text: String| format!("# made by hand\n\n{text}");
    for (i, (text, told, format)) in [
        (comment(rows(" ", "nan")), &ROWS, Format::Rows),
        (rows("\t", "-"), &ROWS, Format::Rows),
        (rows(", ", ""), &ROWS, Format::Rows),
        (rows(";", "BAD").replace('.', ","), &ROWS, Format::Rows),
        (rows(";", "BAD").replace('\n', ";\n"), &ROWS, Format::Rows),
        (points("  ", true), &POINTS, Format::Points),
        (points(";", false), &POINTS, Format::Points),
        (
            format!("x (um),y (um),z (nm)\n{}", points(",", false)),
            &Told::default(),
            Format::Csv,
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let path = written(&folder, &format!("{i}.txt"), text.as_bytes());
        assert_is_expected(&read(&path, told).unwrap(), format);
    }
    let profile = written(&folder, "profile", b"1.0\n2.0\n4.0\n3.0\n");
    let told = Told {
        row_spacing: None,
        ..ROWS
    };
    let profile = read(&profile, &told).unwrap().map;
    assert_eq!(profile.counts, [4, 1]);
    assert!(profile.is_profile());
}

#[test]
fn sdf() {
    let header = "aISO-1.0\nManufacID = none\nNumPoints = 5\nNumProfiles = 4\nXscale = 2e-6\nYscale = 3.0E-6\nZscale = 1e-9\n\
                  Zresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n";
    let folder = folder();
    let text = format!("{header}{}*\nComment = made by hand\n*\n", rows(" ", "BAD"));
    let path = written(&folder, "a.sdf", text.as_bytes());
    assert_is_expected(&read(&path, &Told::default()).unwrap(), Format::Sdf);
    let error = |text: &str| {
        let path = written(&folder, "b.sdf", text.as_bytes());
        read(&path, &Told::default()).unwrap_err().to_string()
    };
    for (from, to, says) in [
        ("NumPoints = 5", "NumPoints = 6", "20 heights"),
        ("NumPoints = 5", "NumPoints = 4", "more heights"),
        ("NumPoints = 5", "NumPoints = 5000000", "too many"),
        ("NumProfiles = 4", "", "no NumProfiles"),
        ("Xscale = 2e-6", "Xscale = 0", "not positive"),
        ("Compression = 0", "Compression = 1", "compressed"),
        ("BAD", "1e999", "no height"),
        ("aISO", "bISO", "binary"),
    ] {
        let said = error(&text.replace(from, to));
        assert!(said.contains(says), "{said}");
    }
    let twice = read(&path, &ROWS).unwrap_err().to_string();
    assert!(twice.contains("`spacing`"), "{twice}");
}

fn zipped(files: &[(&str, &[u8], bool)]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    for (name, content, is_deflated) in files {
        let method = match is_deflated {
            true => rawzip::CompressionMethod::DEFLATE,
            false => rawzip::CompressionMethod::STORE,
        };
        let (mut entry, config) = archive
            .new_file(*name)
            .compression_method(method)
            .start()
            .unwrap();
        let packed = match is_deflated {
            true => miniz_oxide::deflate::compress_to_vec(content, 6),
            false => content.to_vec(),
        };
        std::io::Write::write_all(&mut entry, &packed).unwrap();
        // Size and checksum are those of the content.
        let mut count = config.wrap(std::io::sink());
        std::io::Write::write_all(&mut count, content).unwrap();
        let (_, descriptor) = count.finish().unwrap();
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap();
    bytes
}

fn description(kind: &str, unit: &str, link: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1><Revision>ISO5436 - 2000</Revision>\
         <FeatureType>SUR</FeatureType><Axes><CX><AxisType>I</AxisType><DataType>D</DataType><Increment>2e-6</Increment><Offset>0</Offset></CX>\
         <CY><AxisType>I</AxisType><DataType>D</DataType><Increment>3e-6</Increment></CY><CZ><AxisType>A</AxisType><DataType>{kind}</DataType>{unit}</CZ></Axes></Record1>\
         <Record3><MatrixDimension><SizeX>5</SizeX><SizeY>4</SizeY><SizeZ>1</SizeZ></MatrixDimension>{link}</Record3></p:ISO5436_2>"
    )
}

#[test]
fn x3p() {
    let folder = folder();
    let link = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
    let valid = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>";
    let doubles: Vec<u8> = expected().iter().flat_map(|h| h.to_le_bytes()).collect();
    let floats: Vec<u8> = (expected().iter())
        .flat_map(|h| (*h as f32).to_le_bytes())
        .collect();
    let shorts: Vec<u8> = (expected().iter())
        .flat_map(|h| ((h * 1e9).round() as i16).to_le_bytes())
        .collect();
    // All but the eighth.
    let bits = [0x7f, 0xff, 0x0f];
    let listed: String = (expected().iter())
        .map(|h| match h.is_nan() {
            true => "<Datum/>".to_owned(),
            false => format!("<Datum>{h}</Datum>"),
        })
        .collect();
    let unit = "<Increment>1e-9</Increment>";
    let cases: [(&str, Vec<u8>); 4] = [
        (
            "doubles",
            zipped(&[
                ("main.xml", description("D", "", link).as_bytes(), true),
                ("bindata/data.bin", &doubles, true),
            ]),
        ),
        (
            "floats",
            zipped(&[
                ("bindata/data.bin", &floats, false),
                ("main.xml", description("F", "", link).as_bytes(), false),
            ]),
        ),
        (
            "shorts",
            zipped(&[
                ("main.xml", description("I", unit, valid).as_bytes(), true),
                ("bindata/data.bin", &shorts, true),
                ("bindata/valid.bin", &bits, true),
            ]),
        ),
        (
            "listed",
            zipped(&[(
                "main.xml",
                description("D", "", &format!("<DataList>{listed}</DataList>")).as_bytes(),
                true,
            )]),
        ),
    ];
    for (name, bytes) in &cases {
        let path = written(&folder, name, bytes);
        assert_is_expected(&read(&path, &Told::default()).unwrap(), Format::X3p);
    }
    let mut damaged = cases[1].1.clone();
    damaged[60] ^= 1;
    let error = |bytes: &[u8]| {
        let path = written(&folder, "x.x3p", bytes);
        read(&path, &Told::default()).unwrap_err().to_string()
    };
    let no_data = zipped(&[("main.xml", description("D", "", link).as_bytes(), true)]);
    let short = zipped(&[
        ("main.xml", description("D", "", link).as_bytes(), true),
        ("bindata/data.bin", &floats, true),
    ]);
    // Far more than its description allows.
    let bomb = zipped(&[
        ("main.xml", description("D", "", link).as_bytes(), true),
        ("bindata/data.bin", &vec![0; 10_000_000], true),
    ]);
    for (bytes, says) in [
        (damaged, "damaged"),
        (no_data, "has no `bindata/data.bin`"),
        (short, "80 bytes"),
        (bomb, "damaged"),
        (zipped(&[("a", b"b", false)]), "no main.xml"),
    ] {
        let said = error(&bytes);
        assert!(said.contains(says), "{said}");
    }
}

#[test]
fn what_is_no_map_is_told() {
    let folder = folder();
    let said = |text: &str, told: &Told| {
        let path = written(&folder, "a.txt", text.as_bytes());
        read(&path, told).unwrap_err().to_string()
    };
    let one = |told: Told| told;
    for (text, told, says) in [
        ("", ROWS, "no heights"),
        ("1 2 3 4\n1 2 3\n", ROWS, "line 2: 3 heights"),
        ("1 2 3 4\n1 2 x 4\n", ROWS, "\"x\" is no number"),
        ("1 2 3 4\n1 2 inf 4\n", ROWS, "no finite height"),
        ("1 2 3 4\n1 2 3 4\n", ROWS, "too few"),
        (
            "1 2 3 4\n",
            one(Told {
                height_unit: None,
                ..ROWS
            }),
            "height_unit",
        ),
        (
            "1 2 3 4\n",
            one(Told {
                spacing: None,
                ..ROWS
            }),
            "spacing",
        ),
        ("1 2\n", POINTS, "2 numbers"),
        (
            "0 0 1\n1 0 1\n2 0 1\n3.4 0 1\n5 0 1",
            POINTS,
            "equal distances along x",
        ),
        ("0 0 1\n1 0 1\n1 0 1\n2 0 1\n3 0 0", POINTS, "two points"),
        ("nan 0 1\n", POINTS, "without a place"),
        ("x,y,z (nm)\n1,2,3\n", Told::default(), "unit"),
    ] {
        let said = said(text, &told);
        assert!(said.contains(says), "{text:?}: {said}");
    }
    let missing = read(&folder.path().join("none.txt"), &ROWS).unwrap_err();
    assert!(missing.to_string().contains("cannot be read"));
}
