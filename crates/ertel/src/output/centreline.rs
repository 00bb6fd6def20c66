//! `centreline.csv`: profiles along y = 0.

use std::io::{self, Write};

use crate::solution::{Centreline, FilmTemperatures};

/// The columns: names with units, and the values of each point.
pub fn columns(
    line: &Centreline,
    temperatures: Option<&FilmTemperatures>,
    half_width: f64,
) -> Vec<(&'static str, Vec<f64>)> {
    let mut columns = vec![
        ("x_m", line.x.clone()),
        ("x_over_a", line.x.iter().map(|x| x / half_width).collect()),
    ];
    for (field, values) in line.columns(temperatures) {
        columns.push((field.column(), values.to_vec()));
    }
    columns
}

/// Writes the profiles, one line per point, SI, with the temperatures of a thermal contact; `half_width` a in m.
/// Writes SI profiles, one line per point, with the temperatures of a thermal contact; `half_width` is a in m.
/// # Errors
/// Those of the writer.
pub fn write_centreline(
    mut out: impl Write,
    line: &Centreline,
    temperatures: Option<&FilmTemperatures>,
    half_width: f64,
) -> io::Result<()> {
    let columns = columns(line, temperatures, half_width);
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    writeln!(out, "{}", names.join(","))?;
    for i in 0..line.x.len() {
        let row: Vec<String> = (columns.iter())
            .map(|(_, values)| format!("{:e}", values[i]))
            .collect();
        writeln!(out, "{}", row.join(","))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::ShearFields;

    #[test]
    fn one_line_per_point_under_a_header_with_units() {
        let line = Centreline {
            x: vec![-2e-4, 1e-4],
            pressure: vec![0.0, 1e9],
            asperity_pressure: Vec::new(),
            film_thickness: vec![1e-6, 2.5e-7],
            deflection: vec![1e-6, 2e-6],
            viscosity: vec![0.04, 1e3],
            density: vec![870.0, 1000.5],
            hertz_pressure: vec![0.0, 9.5e8],
            shear: ShearFields {
                stress_mid: vec![0.0, 1e6],
                stress_body_1: vec![0.0, 2e6],
                stress_body_2: vec![0.0, 3e6],
                stress_across: Default::default(),
                rate_mid: vec![0.0, 4e6],
                generalized_viscosity: vec![0.04, 5.0],
            },
        };
        let mut out = Vec::new();
        write_centreline(&mut out, &line, None, 2e-4).unwrap();
        let text = String::from_utf8(out).unwrap();
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0].split(',').count(), rows[1].split(',').count());
        assert_eq!(
            rows[2],
            "1e-4,5e-1,1e9,9.5e8,2.5e-7,2e-6,1e3,1.0005e3,1e6,2e6,3e6,4e6,5e0"
        );
    }
}
