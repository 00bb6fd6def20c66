//! Maps of surfaces: texts and SDF as they stand in a file, X3P made of its parts, so that damage does not end at the checksum of the archive.

use std::io::{self, Write};
use std::path::Path;

use rawzip::{CompressionMethod, ZipArchiveWriter};

use super::{Verdict, case};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// A contact at rest under a map, `map.txt`.
const CASE: &str = include_str!("../../corpus/surface-case.toml");
/// A description without checksums, and the heights of its 5 x 4 points in two bytes each.
const DESCRIPTION: &str = include_str!("../../corpus/x3p-main.xml");
const TEXTS: [&str; 5] = [
    "Length (mm),Height (um)\n0.0,0.1\n0.1,0.2\n0.2,No Data\n0.3,0.1\n0.4,0\n",
    "x [mm];y [mm];z [nm]\n0;0;1\n1;0;2\n2;0;3\n3;0;1\n0;1;1\n1;1;2\n2;1;3\n3;1;1\n0;2;1\n1;2;2\n2;2;3\n3;2;1\n0;3;1\n1;3;2\n2;3;3\n3;3;1\n",
    "1 2 3 4\n1,5 2 3 4\n1 2 No Data 4\n0 0 1e-3 7\n",
    "aISO-1.0\nManufacID = none\nNumPoints = 4\nNumProfiles = 4\nXscale = 1e-5\nYscale = 1e-5\nZscale = 1e-9\nCompression = 0\nDataType = 7\n*\n1 2 3 4\n1 2 BAD 4\n5 6 7 8\n1 1 1 1\n*\n",
    "0 0 1\n1 0 2\n2 0 1\n3 0 4\n0 1 1\n1 1 1\n2 1 1\n3 1 1\n0 2 1\n1 2 1\n2 2 2\n3 2 1\n0 3 1\n1 3 1\n2 3 1\n3 3 1\n",
];

/// Files from which inputs are made.
pub fn seeds() -> Vec<Input> {
    let of = |target: Target, case: String, files: &[(&str, &[u8])]| {
        let mut input = Input {
            target,
            files: Vec::new(),
        };
        input.set("case.toml", case.into_bytes());
        for (name, content) in files {
            input.set(name, content.to_vec());
        }
        input
    };
    let keys = "height_unit = \"um\"\n";
    let more = [
        String::new(),
        String::new(),
        format!("{keys}spacing = \"5 um\"\n"),
        String::new(),
        format!("{keys}layout = \"points\"\nlength_unit = \"um\"\n"),
    ];
    let texts = TEXTS.iter().zip(more).map(|(text, more)| {
        let case = format!("{CASE}{more}file = \"map.txt\"\n");
        of(Target::Surface, case, &[("map.txt", text.as_bytes())])
    });
    let heights: Vec<u8> = (0..20_i16)
        .flat_map(|k| (37 * k % 11).to_le_bytes())
        .collect();
    let x3p = of(
        Target::X3p,
        format!("{CASE}file = \"map.x3p\"\n"),
        &[
            ("main.xml", DESCRIPTION.as_bytes()),
            ("data.bin", &heights),
            ("valid.bin", &[0xff, 0xfe, 0x0f]),
        ],
    );
    texts.chain([x3p]).collect()
}

/// Packs the parts of an X3P, and reads `case.toml`.
pub fn x3p(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    let packed = packed(input).map_err(|error| Defect::wrong("no archive", error.to_string()))?;
    std::fs::write(folder.join("map.x3p"), packed)
        .map_err(|error| Defect::wrong("no file", error.to_string()))?;
    case::run(folder)
}

fn packed(input: &Input) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    let wrong = |error: rawzip::Error| io::Error::other(error.to_string());
    for (name, content) in input.files.iter().filter(|(name, _)| name != "case.toml") {
        let (mut entry, config) = archive
            .new_file(name)
            .compression_method(CompressionMethod::STORE)
            .start()
            .map_err(wrong)?;
        let mut writer = config.wrap(&mut entry);
        writer.write_all(content)?;
        let (_, descriptor) = writer.finish().map_err(wrong)?;
        entry.finish(descriptor).map_err(wrong)?;
    }
    archive.finish().map_err(wrong)?;
    Ok(bytes)
}
