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

const ROWS: Layout = Layout {
    spacing: Some(2e-6),
    row_spacing: Some(3e-6),
    height_unit: Some(1e-9),
    length_unit: None,
    has_points: false,
};

const POINTS: Layout = Layout {
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
    for (i, (text, layout, format)) in [
        (comment(rows(" ", "nan")), &ROWS, Format::Rows),
        (rows("\t", "-"), &ROWS, Format::Rows),
        (rows(", ", ""), &ROWS, Format::Rows),
        (rows(";", "BAD").replace('.', ","), &ROWS, Format::Rows),
        (rows(";", "BAD").replace('\n', ";\n"), &ROWS, Format::Rows),
        (points("  ", true), &POINTS, Format::Points),
        (points(";", false), &POINTS, Format::Points),
        (
            format!("x (um),y (um),z (nm)\n{}", points(",", false)),
            &Layout::default(),
            Format::Csv,
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let path = written(&folder, &format!("{i}.txt"), text.as_bytes());
        assert_is_expected(&read(&path, layout).unwrap(), format);
    }
    let profile = written(&folder, "profile", b"1.0\n2.0\n4.0\n3.0\n");
    let layout = Layout {
        row_spacing: None,
        ..ROWS
    };
    let profile = read(&profile, &layout).unwrap().map;
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
    assert_is_expected(&read(&path, &Layout::default()).unwrap(), Format::Sdf);
    let error = |text: &str| {
        let path = written(&folder, "b.sdf", text.as_bytes());
        read(&path, &Layout::default()).unwrap_err().to_string()
    };
    for (from, to, says) in [
        ("NumPoints = 5", "NumPoints = 6", "20 heights"),
        ("NumPoints = 5", "NumPoints = 4", "more heights"),
        ("NumPoints = 5", "NumPoints = 5000000", "too many"),
        ("NumProfiles = 4", "", "no NumProfiles"),
        ("Xscale = 2e-6", "Xscale = 0", "not positive"),
        ("Compression = 0", "Compression = 1", "compressed"),
        ("BAD", "1e999", "no height"),
    ] {
        let said = error(&text.replace(from, to));
        assert!(said.contains(says), "{said}");
    }
    let twice = read(&path, &ROWS).unwrap_err().to_string();
    assert!(twice.contains("`spacing`"), "{twice}");
}

/// Files made by the layout of the standard: each type of height, one with a trailer, one with bytes added to the header as some makers do.
#[test]
fn binary_sdf() {
    let folder = folder();
    let header = |magic: &str, kind: u8, unit: f64| {
        let mut bytes = magic.as_bytes().to_vec();
        bytes.extend(b"made by us030220260900040220260900");
        for count in [5_u16, 4] {
            bytes.extend(count.to_le_bytes());
        }
        for scale in [2e-6, 3e-6, unit, -1.0] {
            bytes.extend(f64::to_le_bytes(scale));
        }
        bytes.extend([0, kind, 0]);
        assert_eq!(bytes.len(), 81);
        bytes
    };
    let nm = || expected().into_iter().map(|h| (1e9 * h).round());
    let integers = |hole: f64| nm().map(move |h| if h.is_nan() { hole } else { h });
    let cases: [(u8, f64, Vec<u8>); 6] = [
        (
            1,
            1e-9,
            integers(65535.0)
                .flat_map(|h| (h as u16).to_le_bytes())
                .collect(),
        ),
        (
            2,
            1e-9,
            integers(4_294_967_295.0)
                .flat_map(|h| (h as u32).to_le_bytes())
                .collect(),
        ),
        (
            3,
            1e-9,
            nm().flat_map(|h| (h as f32).to_le_bytes()).collect(),
        ),
        (
            5,
            1e-9,
            integers(-32768.0)
                .flat_map(|h| (h as i16).to_le_bytes())
                .collect(),
        ),
        (
            6,
            1e-9,
            integers(-2_147_483_648.0)
                .flat_map(|h| (h as i32).to_le_bytes())
                .collect(),
        ),
        (
            7,
            1.0,
            expected().iter().flat_map(|h| h.to_le_bytes()).collect(),
        ),
    ];
    for (kind, unit, data) in &cases {
        for (magic, added, trailer) in [
            ("bISO-1.0", &b""[..], &b""[..]),
            ("bBCR-1.0", b"", b"Comment"),
            ("bISO-1.0", b"\x05\0\0\0\x01\0\0\0", b""),
        ] {
            let bytes = [&header(magic, *kind, *unit), added, data, trailer].concat();
            let path = written(&folder, "a.sdf", &bytes);
            assert_is_expected(&read(&path, &Layout::default()).unwrap(), Format::Sdf);
        }
    }
    // Bytes have no number for a point without height.
    for kind in [0, 4] {
        let bytes = [header("bISO-1.0", kind, 1e-9), (0..20).collect()].concat();
        let map = read(&written(&folder, "b.sdf", &bytes), &Layout::default())
            .unwrap()
            .map;
        assert_relative_eq!(map.heights[7], 7e-9, max_relative = 1e-12);
    }
    let whole = [header("bISO-1.0", 5, 1e-9), cases[3].2.clone()].concat();
    type Change = fn(&mut Vec<u8>);
    let said = |change: Change| {
        let mut bytes = whole.clone();
        change(&mut bytes);
        let path = written(&folder, "c.sdf", &bytes);
        read(&path, &Layout::default()).unwrap_err().to_string()
    };
    let cases: [(Change, &str); 6] = [
        (|b| b.truncate(80), "80 bytes"),
        (|b| b.truncate(120), "39 bytes of heights"),
        (|b| b[78] = 1, "compressed"),
        (|b| b[79] = 8, "DataType is 8"),
        (|b| b[46..54].fill(0), "Xscale is 0"),
        (|b| b[42] = 2, "too few"),
    ];
    for (change, says) in cases {
        let said = said(change);
        assert!(said.contains(says), "{said}");
    }
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
        assert_is_expected(&read(&path, &Layout::default()).unwrap(), Format::X3p);
    }
    let mut damaged = cases[1].1.clone();
    damaged[60] ^= 1;
    let error = |bytes: &[u8]| {
        let path = written(&folder, "x.x3p", bytes);
        read(&path, &Layout::default()).unwrap_err().to_string()
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

/// z = offset + increment n; integers need the increment, and it has a name in errors.
#[test]
fn x3p_heights_are_offset_and_increments() {
    let folder = folder();
    let link = "<DataLink><PointDataLink>data.bin</PointDataLink></DataLink>";
    let heights = |kind: &str, axis: &str, bytes: &[u8]| {
        let description = description(kind, axis, link);
        let archive = zipped(&[
            ("main.xml", description.as_bytes(), true),
            ("data.bin", bytes, true),
        ]);
        read(&written(&folder, "z.x3p", &archive), &Layout::default()).map(|read| read.map.heights)
    };
    let numbers: Vec<i16> = (0..20).map(|k| 7 * k - 50).collect();
    let shorts: Vec<u8> = numbers.iter().flat_map(|n| n.to_le_bytes()).collect();
    let found = heights(
        "I",
        "<Increment>2e-11</Increment><Offset>1.25e-8</Offset>",
        &shorts,
    )
    .unwrap();
    for (h, n) in found.iter().zip(&numbers) {
        let expected = 1.25e-8 + 2e-11 * f64::from(*n);
        assert!((h - expected).abs() < 1e-20, "{h}");
    }
    let doubles: Vec<u8> = numbers
        .iter()
        .flat_map(|n| (f64::from(*n) * 1e-9).to_le_bytes())
        .collect();
    let found = heights(
        "D",
        "<Increment>1</Increment><Offset>-3e-9</Offset>",
        &doubles,
    )
    .unwrap();
    assert!((found[3] - (-29e-9 - 3e-9)).abs() < 1e-20);
    for (axis, says) in [
        (
            "<Offset>0</Offset>",
            "no Record1/Axes/CZ/Increment, the metres",
        ),
        ("<Increment/>", "no Record1/Axes/CZ/Increment"),
        ("<Increment>-1e-9</Increment>", "CZ/Increment is \"-1e-9\""),
        (
            "<Increment>1e-9</Increment><Offset>high</Offset>",
            "CZ/Offset is \"high\"",
        ),
    ] {
        let said = heights("I", axis, &shorts).unwrap_err().to_string();
        assert!(
            said.contains(says) && !said.contains("height_unit"),
            "{said}"
        );
    }
}

/// Desktops pack the folder; the checksums are those of `md5sum`.
#[test]
fn x3p_in_a_folder_and_with_checksums() {
    let folder = folder();
    let doubles: Vec<u8> = expected().iter().flat_map(|h| h.to_le_bytes()).collect();
    let described = |sum: &str| {
        let link = format!(
            "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>{sum}</MD5ChecksumPointData></DataLink>"
        );
        description("D", "", &link).replace(
            "</p:ISO5436_2>",
            "<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></p:ISO5436_2>",
        )
    };
    let sum = super::x3p::md5::digest(&doubles).to_uppercase();
    let read = |main: &str, files: [&str; 3], sums: &str| {
        let [a, b, c] = files;
        let archive = zipped(&[
            (b, &doubles, true),
            (a, main.as_bytes(), true),
            (c, sums.as_bytes(), false),
        ]);
        read(&written(&folder, "sums.x3p", &archive), &Layout::default())
    };
    let plain = ["main.xml", "bindata/data.bin", "md5checksum.hex"];
    let main = described(&sum);
    let sums = format!("{} *main.xml\n", super::x3p::md5::digest(main.as_bytes()));
    for files in [
        plain,
        [
            "scan/main.xml",
            "scan/bindata/data.bin",
            "scan/md5checksum.hex",
        ],
        [
            "a/Scan/Main.xml",
            "a/Scan/bindata\\data.bin",
            "a/Scan/md5checksum.hex",
        ],
    ] {
        assert_is_expected(&read(&main, files, &sums).unwrap(), Format::X3p);
    }
    // Writers that compute none leave it empty or zero.
    for none in ["", "00000000000000000000000000000000"] {
        assert_is_expected(&read(&described(none), plain, "").unwrap(), Format::X3p);
    }
    let other = "d41d8cd98f00b204e9800998ecf8427e";
    for (main, sums, says) in [
        (
            described(other),
            String::new(),
            "`bindata/data.bin` was changed after it was written",
        ),
        (
            main,
            format!("{other} *main.xml\r\n"),
            "`main.xml` was changed after it was written",
        ),
    ] {
        let said = read(&main, plain, &sums).unwrap_err().to_string();
        assert!(said.contains(says) && said.contains(other), "{said}");
    }
    let two = zipped(&[("a/main.xml", b"<a/>", true), ("b/main.xml", b"<a/>", true)]);
    let said = super::read(&written(&folder, "two.x3p", &two), &Layout::default());
    assert!(said.unwrap_err().to_string().contains("2 folders"));
}

/// Descriptions that grow in the memory, or that a parser reads for minutes, are refused at once.
#[test]
fn x3p_bombs_are_refused() {
    let folder = folder();
    let attributes: String = (0..300_000).map(|i| format!(" a{i}=\"1\"")).collect();
    // A closing bracket in a value does not end the element.
    let split: String = (0..80_000).map(|i| format!(" a{i}=\">\"")).collect();
    for (text, says) in [
        (format!("<r{attributes}/>"), "2000 attributes"),
        (format!("<r{split}/>"), "2000 attributes"),
        (
            format!("<r>{}</r>", "<a/>".repeat(1_500_000)),
            "300000 elements",
        ),
        (
            format!("<r>{}</r>", "<a>".repeat(400_000)),
            "300000 elements",
        ),
        (
            format!("<r>{}</r>", " ".repeat(20_000_000)),
            "more than 8388608 bytes",
        ),
        (
            "<!DOCTYPE r [<!ENTITY a \"aa\">]><r>&a;</r>".to_owned(),
            "main.xml",
        ),
    ] {
        let archive = zipped(&[("main.xml", text.as_bytes(), true)]);
        let path = written(&folder, "bomb.x3p", &archive);
        let clock = std::time::Instant::now();
        let said = read(&path, &Layout::default()).unwrap_err().to_string();
        assert!(said.contains(says), "{said}");
        assert!(
            clock.elapsed().as_secs_f64() < 1.0,
            "{says}: {:?}",
            clock.elapsed()
        );
    }
}

/// Titles by which people call places and heights, and points without a height as instruments write them.
#[test]
fn tables_with_other_titles_and_points_without_data() {
    let folder = folder();
    let profile = |text: &str| {
        let path = written(&folder, "profile.csv", text.as_bytes());
        read(&path, &Layout::default()).unwrap()
    };
    for head in [
        "Length (mm),Height (um)",
        "x [mm];z [um]",
        "# exported\nPosition / mm\tProfile height / um",
        "Weg (mm);H\u{f6}he (\u{b5}m)",
    ] {
        let separator = [';', '\t', ',']
            .into_iter()
            .find(|c| head.contains(*c))
            .unwrap();
        let rows: String = (0..6)
            .map(|i| {
                let z = if i == 3 {
                    "No Data".to_owned()
                } else {
                    format!("0.{i}")
                };
                format!("{:.3}{separator}{z}\n", 0.005 * f64::from(i))
            })
            .collect();
        let read = profile(&format!("{head}\n{rows}"));
        assert_eq!(
            (read.format, read.map.counts),
            (Format::Csv, [6, 1]),
            "{head}"
        );
        assert!((read.map.spacing[0] - 5e-6).abs() < 1e-15);
        assert!((read.map.heights[5] - 0.5e-6).abs() < 1e-15 && read.map.heights[3].is_nan());
    }
    // Between blanks the two words are one height.
    let text = "0 0 1\n1 0 No Data\n2 0 2\n3 0 no data\n4 0 1\n";
    let path = written(&folder, "a.xyz", text.as_bytes());
    let holes = read(&path, &POINTS).unwrap().map.heights;
    assert_eq!(holes.iter().filter(|h| h.is_nan()).count(), 2);
}

/// Tables without line breaks are refused before they fill the memory.
#[test]
fn one_line_of_megabytes_is_refused() {
    let folder = folder();
    let long = |head: &str, cell: &str| format!("{head}{}", cell.repeat(6_000_000));
    for (text, layout, says) in [
        (long("", "1 "), ROWS, "more than 4194304 points"),
        (long("", "1;"), ROWS, "more than 4194304 points"),
        (long("1 2 ", "3 "), POINTS, "numbers, where a point has"),
        (
            long("x (um),z (um)\n", "1,"),
            Layout::default(),
            "more than 32768 bytes",
        ),
    ] {
        let path = written(&folder, "long.txt", text.as_bytes());
        let said = read(&path, &layout).unwrap_err().to_string();
        assert!(said.contains(says), "{said}");
    }
}

/// Given places: both of them in a matrix, in a list in another order, y alone, and as texts.
#[test]
fn x3p_with_places() {
    let folder = folder();
    let axis = |kind: &str, data: &str, unit: &str| {
        format!(
            "<AxisType>{kind}</AxisType><DataType>{data}</DataType><Increment>{unit}</Increment>"
        )
    };
    let described = |x: String, y: String, z: String, rest: &str| {
        format!(
            "<?xml version=\"1.0\"?><p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1><FeatureType>PCL</FeatureType><Axes><CX>{x}</CX><CY>{y}</CY>\
             <CZ>{z}</CZ></Axes></Record1><Record3>{rest}</Record3></p:ISO5436_2>"
        )
    };
    let matrix =
        "<MatrixDimension><SizeX>5</SizeX><SizeY>4</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
    let link = "<DataLink><PointDataLink>data.bin</PointDataLink></DataLink>";
    let place = |k: usize| (7.0 + 2.0 * (k % 5) as f64, 3.0 * (k / 5) as f64 - 1.0);
    let all = expected();
    let doubles = |order: &[usize]| -> Vec<u8> {
        let point = |k: &usize| {
            let (x, y) = place(*k);
            [x * 1e-6, y * 1e-6, all[*k]].map(f64::to_le_bytes).concat()
        };
        order.iter().flat_map(point).collect()
    };
    let in_order: Vec<usize> = (0..20).collect();
    let turned: Vec<usize> = (0..20).map(|i| (7 * i + 3) % 20).collect();
    // y in whole µm, x by its place in the row.
    let mixed: Vec<u8> = (0..20)
        .flat_map(|k| {
            [
                &(place(k).1 as i16).to_le_bytes()[..],
                &(all[k] as f32).to_le_bytes(),
            ]
            .concat()
        })
        .collect();
    let absolute = || axis("A", "D", "1");
    let texts: String = (0..20)
        .map(|k| {
            let (x, y) = place(k);
            let z = if all[k].is_nan() {
                String::new()
            } else {
                format!("{:e}", all[k])
            };
            format!("<Datum>{:e};{:e};{z}</Datum>", x * 1e-6, y * 1e-6)
        })
        .collect();
    let list = format!("<ListDimension>20</ListDimension><DataList>{texts}</DataList>");
    let in_list = format!("<ListDimension>20</ListDimension>{link}");
    let in_matrix = format!("{matrix}{link}");
    for (name, xml, data) in [
        (
            "matrix",
            described(absolute(), absolute(), absolute(), &in_matrix),
            doubles(&in_order),
        ),
        (
            "list",
            described(absolute(), absolute(), absolute(), &in_list),
            doubles(&turned),
        ),
        (
            "mixed",
            described(
                axis("I", "D", "2e-6"),
                axis("A", "I", "1e-6"),
                axis("A", "F", "1"),
                &in_matrix,
            ),
            mixed,
        ),
        (
            "texts",
            described(absolute(), absolute(), absolute(), &list),
            Vec::new(),
        ),
    ] {
        let bytes = zipped(&[
            ("main.xml", xml.as_bytes(), true),
            ("data.bin", &data, true),
        ]);
        let path = written(&folder, name, &bytes);
        assert_is_expected(&read(&path, &Layout::default()).unwrap(), Format::X3p);
    }
    let said = |xml: String, data: &[u8]| {
        let bytes = zipped(&[("main.xml", xml.as_bytes(), true), ("data.bin", data, true)]);
        read(&written(&folder, "bad", &bytes), &Layout::default())
            .unwrap_err()
            .to_string()
    };
    let mut off = doubles(&in_order);
    off[24..32].copy_from_slice(&8.3e-6_f64.to_le_bytes());
    for (xml, data, says) in [
        (
            described(absolute(), absolute(), absolute(), &in_list),
            off,
            "equal distances along x",
        ),
        (
            described(absolute(), absolute(), absolute(), &in_list),
            doubles(&turned[..19]),
            "456 bytes",
        ),
        (
            described(absolute(), absolute(), absolute(), link),
            Vec::new(),
            "how many points",
        ),
        (
            described(axis("I", "D", "2e-6"), absolute(), absolute(), &in_list),
            Vec::new(),
            "of the type A",
        ),
        (
            described(axis("A", "D", "0"), absolute(), absolute(), &in_list),
            Vec::new(),
            "CX/Increment is \"0\"",
        ),
        (
            described(axis("A", "X", "1"), absolute(), absolute(), &in_list),
            Vec::new(),
            "data type X",
        ),
        (
            described(
                absolute(),
                absolute(),
                absolute(),
                "<ListDimension>1</ListDimension><DataList><Datum>1;2</Datum></DataList>",
            ),
            Vec::new(),
            "is no point",
        ),
    ] {
        let said = said(xml, &data);
        assert!(said.contains(says), "{said}");
    }
}

#[test]
fn invalid_maps_are_refused() {
    let folder = folder();
    let said = |text: &str, layout: &Layout| {
        let path = written(&folder, "a.txt", text.as_bytes());
        read(&path, layout).unwrap_err().to_string()
    };
    let one = |layout: Layout| layout;
    for (text, layout, says) in [
        ("", ROWS, "no heights"),
        ("1 2 3 4\n1 2 3\n", ROWS, "line 2: 3 heights"),
        ("1 2 3 4\n1 2 x 4\n", ROWS, "\"x\" is no number"),
        ("1 2 3 4\n1 2 inf 4\n", ROWS, "no finite height"),
        ("1 2 3 4\n1 2 3 4\n", ROWS, "too few"),
        (
            "1 2 3 4\n",
            one(Layout {
                height_unit: None,
                ..ROWS
            }),
            "height_unit",
        ),
        (
            "1 2 3 4\n",
            one(Layout {
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
        ("x,y,z (nm)\n1,2,3\n", Layout::default(), "unit"),
    ] {
        let said = said(text, &layout);
        assert!(said.contains(says), "{text:?}: {said}");
    }
    let missing = read(&folder.path().join("none.txt"), &ROWS).unwrap_err();
    assert!(missing.to_string().contains("cannot be read"));
}
