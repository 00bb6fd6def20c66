//! The thermal data of a case in the report.

use super::report::Lines;
use super::{HeatEcho, ThermalEcho, digits};

/// What carries the heat, `ball` being the word for the second body.
pub(super) fn write(out: &mut Lines, thermal: &ThermalEcho, ball: &str) {
    let of = |material: &HeatEcho| {
        let law = |name: &str| match name {
            "constant" => String::new(),
            name => format!(" ({name})"),
        };
        format!(
            "{} W/(m.K){}, heat capacity {} J/(kg.K){}",
            digits(material.thermal_conductivity, 4),
            law(&material.conductivity_law),
            digits(material.heat_capacity, 4),
            law(&material.heat_capacity_law),
        )
    };
    out.row("conductivity, lubricant", of(&thermal.lubricant));
    let params = &thermal.params;
    for (role, material, temperature) in [
        ("plane", &thermal.plane, params.plane_temperature),
        (ball, &thermal.ball, params.ball_temperature),
    ] {
        let bulk = temperature.map_or(String::new(), |t| format!(", bulk {} K", digits(t, 6)));
        out.row(&format!("conductivity, {role}"), of(material) + &bulk);
    }
}
