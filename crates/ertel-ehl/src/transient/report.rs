//! The figures reported at an instant.

use super::body::Start;
use super::levels::Levels;
use super::present::Present;
use super::run::{Instant, Params};
use crate::engine::Problem;
use crate::engine::figures::sizes;
use crate::solution::{Bar, Figure, Figures, Measured, OPEN_MASS_BALANCE};
use crate::volumes::Plan;
use crate::volumes::ending::balance_error;
use crate::volumes::engine::{BAR_GRIDS, least_shares};
use crate::volumes::figures::{bars, figures};

/// Distance between the bodies, in a²/R, that is rounding.
const ROUNDING: f64 = 1e-13;

/// Time, step and effort of an instant.
#[derive(Clone, Copy, Default)]
pub(super) struct InstantMeta {
    pub time: f64,
    pub step: f64,
    pub newton_iterations: usize,
    pub is_asked: bool,
}

/// Measures the newest instant.
pub(super) fn measure<'a>(
    levels: &'a Levels,
    problem: &'a Problem<Plan>,
    present: &Present<'_>,
    params: &Params,
    at: InstantMeta,
) -> Instant<'a> {
    let conditions = present.conditions;
    let load = present.load * conditions.load.at(at.time);
    let film_force = levels.force(load) / present.load;
    let [approach, velocity] = levels.approached();
    // A velocity below the rounding of distances over a step counts as zero.
    let approach_velocity = match (velocity * at.step).abs() > ROUNDING {
        true => velocity,
        false if at.step == 0.0 => velocity + 0.0,
        false => 0.0,
    };
    let levels = levels.levels();
    let n = levels.len();
    let of_grids: Vec<Figures> = (n.saturating_sub(BAR_GRIDS)..n)
        .map(|l| figures(problem, &levels[..=l]))
        .collect();
    let mut newest = of_grids.iter().rev();
    let of_grids = [(); BAR_GRIDS].map(|()| newest.next());
    let cell = levels
        .last()
        .map_or(0.0, |level| level.system.grid.spacing[0]);
    let figures = of_grids[0].copied().unwrap_or_default();
    let length = problem.scales.length;
    let mass_error = match conditions.start {
        // Bodies that are apart without pressure gain nothing yet.
        Start::Apart { .. } if at.time == 0.0 => 0.0,
        _ => levels.last().map_or(f64::NAN, |level| {
            balance_error(&level.system, &level.system.linearise(&level.state))
        }),
    };
    let mut bars = bars(of_grids, cell * length, least_shares(problem, cell, false));
    // The error of the steps adds to that of the grids.
    for figure in Figure::ALL {
        if let (Some(bar), Some(reading)) = (bars.get(figure), figures.get(figure)) {
            let size = reading.size.abs();
            let value = bar.value + params.tolerance * size;
            let value = match mass_error.abs() > OPEN_MASS_BALANCE {
                true => value.max(size),
                false => value,
            };
            bars.set(figure, Bar { value, ..bar });
        }
    }
    let measured = Measured {
        figures,
        bars,
        half_width: length,
    };
    let mut known = sizes(problem);
    if known.load.is_nan() {
        known.load = 0.0;
    }
    Instant {
        time: at.time,
        speeds: conditions.speeds.at(at.time),
        load: conditions.load.at(at.time),
        approach,
        approach_velocity,
        film_force,
        measured: measured.without_rounding(&known).within_limits(&known),
        step: at.step,
        newton_iterations: at.newton_iterations,
        mass_error,
        is_asked: at.is_asked,
        problem,
        levels,
    }
}
