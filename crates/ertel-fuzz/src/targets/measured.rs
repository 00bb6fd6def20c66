//! Measured films and tractions, as far as the cases of their points.

use std::path::Path;

use ertel::compare::{Comparison, Measured, MeasuredError, Probe, ReadParams};
use ertel::output::compare::{
    comparison_json, comparison_picture, comparison_report, comparison_table,
};

use super::{Verdict, check_place, check_text};
use crate::finding::Defect;

/// Reads `measured.csv` with `case.toml`, by both thermometers of a rig, and writes the comparison with no results.
pub fn run(folder: &Path) -> Result<Verdict, Defect> {
    let (case, path) = (folder.join("case.toml"), folder.join("measured.csv"));
    let mut verdict = Verdict::Refused;
    for probe in [Probe::Lubricant, Probe::Pot] {
        let params = ReadParams {
            probe,
            ..ReadParams::default()
        };
        let measured = match Measured::read(&case, &path, &params) {
            Ok(measured) => measured,
            Err(MeasuredError::Case(error)) => {
                check_place(&error, folder)?;
                continue;
            }
            Err(error) => {
                check_text(&error.to_string())?;
                continue;
            }
        };
        if measured
            .rows
            .iter()
            .any(|row| row.point >= measured.study.points.len())
        {
            return Err(Defect::wrong(
                "a row without point",
                format!("{:?}", measured.rows),
            ));
        }
        let comparison = Comparison::new(&measured, &[]);
        let texts = [
            comparison_table(&comparison),
            comparison_report(&comparison, None),
            comparison_json(&comparison).to_string(),
            comparison_picture(&comparison).map_or(String::new(), |picture| picture.svg()),
        ];
        if texts.iter().any(|text| text.contains("NaN")) {
            return Err(Defect::wrong(
                "a comparison that is not finite",
                texts.join("\n"),
            ));
        }
        verdict = Verdict::Taken;
    }
    Ok(verdict)
}
