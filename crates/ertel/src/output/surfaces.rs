//! Surface maps in the report.

use super::lines::Lines;
use crate::case::SurfaceEcho;
use crate::contact::topography::Parameters;
use crate::words::{digits, length};

/// One block per map: its source, processing and statistics.
pub(super) fn write(out: &mut Lines, surfaces: &[SurfaceEcho]) {
    for surface in surfaces {
        let name = surface.file.as_deref().unwrap_or("generated");
        let [nx, ny] = surface.points;
        let [dx, dy] = surface.spacing;
        let points = match ny {
            1 => format!("{nx} points {} apart", length(dx)),
            _ => format!("{nx} x {ny} points {} and {} apart", length(dx), length(dy)),
        };
        let missing = match surface.missing {
            0 => String::new(),
            n => format!(", {n} missing heights filled"),
        };
        out.row("surface", format!("{name}: {points}{missing}"));
        let level = match surface.level {
            "none" => "  unchanged",
            "mean" => "  mean removed",
            "plane" => "  plane removed",
            _ => "  quadratic form removed",
        };
        out.row(level, parameters(&surface.levelled));
        let cutoffs: Vec<String> = [
            surface
                .high_pass
                .map(|cutoff| format!("below {}", length(cutoff))),
            surface
                .low_pass
                .map(|cutoff| format!("above {}", length(cutoff))),
        ]
        .into_iter()
        .flatten()
        .collect();
        if !cutoffs.is_empty() {
            let label = format!("  waves {}", cutoffs.join(", "));
            out.row(&label, parameters(&surface.filtered));
        }
    }
}

fn parameters(own: &Parameters) -> String {
    format!(
        "Sa {}, Sq {}, Ssk {}, Sku {}, Sz {}; asperities: σβη {}, σ/β {}",
        length(own.sa),
        length(own.sq),
        digits(own.ssk, 3),
        digits(own.sku, 3),
        length(own.sz),
        digits(own.asperity_group, 2),
        digits(own.rms_height_to_asperity_radius, 2)
    )
}
