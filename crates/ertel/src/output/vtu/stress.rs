//! `stress.vtu`: stresses in both bodies, in the plane of motion through the middle of the contact.

use std::io::{self, Write};

use super::grid::{Array, Data, Grid};
use crate::stress::{COMPONENTS, Section, Stress, Stresses};

/// Writes both sections, body 2 above z = 0 and body 1 below; stresses are those of each body, whose z points into it. The cell array `body` is 1
/// or 2.
///
/// # Errors
/// Those of the writer.
pub fn write_stresses(out: impl Write, stresses: &Stresses) -> io::Result<()> {
    let sections = stresses.bodies.each_ref().map(|body| &body.section);
    let mut points = Vec::new();
    let (mut cells, mut body): (Vec<[u32; 4]>, Vec<u8>) = (Vec::new(), Vec::new());
    for (i, (section, up)) in sections.into_iter().zip([-1.0, 1.0]).enumerate() {
        cells.extend(quadrilaterals(section, points.len(), up));
        body.resize(cells.len(), i as u8 + 1);
        let rows = section.depth.iter();
        points.extend(rows.flat_map(|z| section.x.iter().map(move |x| [*x, 0.0, up * z])));
    }
    let values = |of: &dyn Fn(&Stress) -> f64| {
        let all = sections.iter().flat_map(|section| &section.stress);
        Data::Float32(all.map(|s| of(s) as f32).collect())
    };
    let names = COMPONENTS.map(|name| format!("stress_{name}_Pa"));
    let array = |name, data| Array {
        name,
        unit: "Pa",
        n_components: 1,
        data,
    };
    let components = names.iter().enumerate();
    let mut fields: Vec<Array<'_>> = components
        .map(|(i, name)| array(name.as_str(), values(&|s| s.0[i])))
        .collect();
    fields.push(array("von_mises_Pa", values(&Stress::von_mises)));
    fields.push(array("largest_shear_Pa", values(&Stress::largest_shear)));
    let principal = ["principal_1_Pa", "principal_2_Pa", "principal_3_Pa"];
    for (i, name) in principal.into_iter().enumerate() {
        fields.push(array(name, values(&|s| s.principal()[i])));
    }
    let cells: Vec<&[u32]> = cells.iter().map(<[u32; 4]>::as_slice).collect();
    let grid = Grid {
        points: &points,
        cells: &cells,
        dimension: 2,
        point_data: &fields,
        cell_data: &[Array {
            name: "body",
            unit: "",
            n_components: 1,
            data: Data::UInt8(body),
        }],
        ..Grid::default()
    };
    grid.write(out)
}

/// The cells of a section whose points begin at an index, in the sense of the coordinates.
fn quadrilaterals(section: &Section, first: usize, up: f64) -> Vec<[u32; 4]> {
    let n = section.x.len();
    let cell = |i: usize, j: usize| {
        let a = (first + j * n + i) as u32;
        let (b, c, d) = (a + 1, a + n as u32 + 1, a + n as u32);
        match up > 0.0 {
            true => [a, b, c, d],
            false => [a, d, c, b],
        }
    };
    (section.rows())
        .flat_map(|j| (0..n - 1).map(move |i| (i, j)))
        .map(|(i, j)| cell(i, j))
        .collect()
}
