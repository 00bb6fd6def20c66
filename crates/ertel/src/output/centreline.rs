//! `centreline.csv`: profiles along y = 0.

use std::io::{self, Write};

use crate::solution::Centreline;

/// Header line of the file: names with units.
pub const HEADER: &str = "x_m,x_over_a,pressure_Pa,hertz_pressure_Pa,film_thickness_m,deflection_m,\
     viscosity_Pa_s,density_kg_per_m3";

/// Writes the profiles, one line per point, SI; `half_width` a in m.
///
/// # Errors
/// Those of the writer.
pub fn write_centreline(mut out: impl Write, line: &Centreline, half_width: f64) -> io::Result<()> {
    writeln!(out, "{HEADER}")?;
    for (i, x) in line.x.iter().enumerate() {
        writeln!(
            out,
            "{:e},{:e},{:e},{:e},{:e},{:e},{:e},{:e}",
            x,
            x / half_width,
            line.pressure[i],
            line.hertz_pressure[i],
            line.film_thickness[i],
            line.deflection[i],
            line.viscosity[i],
            line.density[i]
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_line_per_point_under_a_header_with_units() {
        let line = Centreline {
            x: vec![-2e-4, 1e-4],
            pressure: vec![0.0, 1e9],
            film_thickness: vec![1e-6, 2.5e-7],
            deflection: vec![1e-6, 2e-6],
            viscosity: vec![0.04, 1e3],
            density: vec![870.0, 1000.5],
            hertz_pressure: vec![0.0, 9.5e8],
        };
        let mut out = Vec::new();
        write_centreline(&mut out, &line, 2e-4).unwrap();
        let text = String::from_utf8(out).unwrap();
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0].split(',').count(), rows[1].split(',').count());
        assert_eq!(rows[2], "1e-4,5e-1,1e9,9.5e8,2.5e-7,2e-6,1e3,1.0005e3");
    }
}
