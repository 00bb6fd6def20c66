//! Tables and gears that tests share.

use std::f64::consts::PI;

use ertel_ehl::contact::Material;

use super::{GearDimensions, Operation, TipAlteration};

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

/// Type C14 of a published program (GEARpie), with the tips shortened.
pub fn c14() -> GearDimensions {
    GearDimensions {
        pinion_shift: 0.1817,
        wheel_shift: Some(0.1715),
        tip_alteration: TipAlteration::KeepClearance,
        ..GearDimensions::spur(4.5e-3, [16, 24], PI / 9.0, 14e-3)
    }
}

/// Type H501 of the same.
pub fn h501() -> GearDimensions {
    GearDimensions {
        helix_angle: 15.0_f64.to_radians(),
        pinion_shift: 0.1809,
        wheel_shift: Some(0.0891),
        tip_alteration: TipAlteration::KeepClearance,
        ..GearDimensions::spur(3.5e-3, [20, 30], PI / 9.0, 23e-3)
    }
}

/// Type H701 of the same.
pub fn h701() -> GearDimensions {
    GearDimensions {
        helix_angle: 15.0_f64.to_radians(),
        pinion_shift: 0.2290,
        wheel_shift: Some(0.1489),
        tip_alteration: TipAlteration::KeepClearance,
        ..GearDimensions::spur(2.5e-3, [28, 42], PI / 9.0, 17e-3)
    }
}

pub fn steel() -> Material {
    Material {
        youngs_modulus: 206e9,
        poissons_ratio: 0.3,
    }
}

/// Steel gears at a torque (N·m) and a speed (1/min) of the pinion.
pub fn steel_operation(torque: f64, speed: f64) -> Operation {
    Operation {
        pinion_torque: torque,
        pinion_speed: PI / 30.0 * speed,
        materials: [steel(); 2],
    }
}
