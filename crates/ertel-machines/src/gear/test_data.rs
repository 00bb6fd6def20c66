//! Tables and gears that tests share.

use super::GearDimensions;

/// A row of a table: names and cells.
pub struct Row {
    cells: Vec<(String, String)>,
}

impl Row {
    pub fn text(&self, name: &str) -> &str {
        let named = |exact: bool| {
            let mut cells = self.cells.iter();
            cells.find(|(key, _)| key == name || !exact && key.starts_with(name))
        };
        // Names may end with a unit or a formula.
        let cell = named(true).or_else(|| named(false));
        &cell.unwrap_or_else(|| panic!("no column {name}")).1
    }

    pub fn number(&self, name: &str) -> f64 {
        self.text(name).parse().expect("a number")
    }
}

/// Rows of a table with comment lines and a line of names.
pub fn rows(text: &str) -> Vec<Row> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().expect("names").split(',').collect();
    lines
        .map(|line| Row {
            cells: names
                .iter()
                .zip(line.split(','))
                .map(|(name, cell)| (name.to_string(), cell.to_string()))
                .collect(),
        })
        .collect()
}

/// "FZG A" or "FZG C" with the tips of `fzg_line_of_action.csv`; the pinion's shift does not matter to the path.
pub fn fzg(name: &str) -> GearDimensions {
    let alpha = 20.0_f64.to_radians();
    let (tips, width) = match name {
        "FZG A" => ([88.77e-3, 112.5e-3], 20e-3),
        _ => ([82.46e-3, 118.36e-3], 14e-3),
    };
    GearDimensions {
        centre_distance: Some(91.5e-3),
        pinion_shift: if name == "FZG A" { 0.8532 } else { 0.1817 },
        tip_diameters: tips.map(Some),
        ..GearDimensions::spur(4.5e-3, [16, 24], alpha, width)
    }
}
