//! Convergence of the film over the meshes, and of Newton's method on each mesh.

use crate::solution::Role;
use crate::solution::{IterationRecord, LevelStats, Solution};
use ertel_plot::{Axis, Chart, Look, Marker, PALETTE, Series};

/// Colours of stages that stop before reaching the tolerance of the solution.
const PALE: [&str; 2] = ["#A9CBE3", "#F0BF9C"];
const GREY: &str = "#7f7f7f";
/// Smallest value shown, as a fraction of the tolerance; anything below is round-off.
const FLOOR: f64 = 1e-3;
/// Smallest distance of two stage labels, as a fraction of the axis.
const LABELS_APART: f64 = 0.055;

/// Convergence of the films towards the last mesh, if there are three meshes or more, and of Newton's method to its
/// tolerance.
pub fn convergence(title: &str, solution: &Solution, tolerance: Option<f64>) -> Vec<Chart> {
    let coupling = solution.thermal.as_ref().map(|t| t.coupling.tolerance);
    let newton = newton(title, solution, [tolerance, coupling]);
    meshes(title, solution)
        .into_iter()
        .chain([newton])
        .collect()
}

/// Index of the level of the solution.
fn solved(levels: &[LevelStats]) -> Option<usize> {
    levels
        .iter()
        .rposition(|l| l.role == Role::Final && l.converged)
}

/// Differences of both films from the last mesh over the number of unknowns.
fn meshes(title: &str, solution: &Solution) -> Option<Chart> {
    let levels = &solution.stats.levels;
    let last = solved(levels)?;
    let reached = levels[last].films();
    let former: Vec<&LevelStats> = levels[..last]
        .iter()
        .filter(|l| l.converged && matches!(l.role, Role::Final | Role::Estimate))
        .filter(|l| l.n_pressure_dofs < levels[last].n_pressure_dofs)
        .collect();
    let curve = |i: usize| -> Vec<[f64; 2]> {
        let points = former.iter().map(|l| {
            let difference = 100.0 * (l.films()[i] / reached[i] - 1.0).abs();
            [l.n_pressure_dofs as f64, difference]
        });
        points.filter(|p| p[1].is_finite() && p[1] > 0.0).collect()
    };
    let films = [
        ("central film", solution.summary.film_central),
        ("minimum film", solution.summary.film_minimum),
    ];
    let mut series = Vec::new();
    let unknowns = former.iter().map(|l| l.n_pressure_dofs as f64);
    let unknowns: Vec<f64> = unknowns.collect();
    let most = levels[last].n_pressure_dofs as f64;
    for (i, (name, film)) in films.into_iter().enumerate() {
        series.push(Series::new(name, curve(i), Look::LineAndDots, PALETTE[i]));
        let error = film.error.map(|error| 100.0 * error / film.value.abs());
        if let (Some(error), Some(first)) = (error.filter(|e| *e > 0.0), unknowns.first()) {
            series.push(Series::new(
                format!("error bar of the {name}"),
                vec![[0.5 * first, error], [2.0 * most, error]],
                Look::Dashed,
                PALETTE[i],
            ));
        }
    }
    if curve(0).len() < 2 {
        return None;
    }
    let heights = series.iter().flat_map(|s| &s.points).map(|p| p[1]);
    let mut chart = Chart::new(
        title,
        Axis::log_close_around("Pressure unknowns of the mesh", unknowns),
        Axis::log_around("Difference from the last mesh (%)", heights),
    );
    chart.heading = format!("Films of the meshes before the last one, which has {most} unknowns");
    chart.series = series;
    Some(chart)
}

/// Residual and update of every Newton iteration, one stage after the other; earlier stages are pale. In thermal cases,
/// film and temperatures are solved in turn, each to a fraction of the other's change: the change per round
/// converges to its tolerance. Tolerances are drawn for Newton's method and for that change.
fn newton(title: &str, solution: &Solution, [tolerance, coupling]: [Option<f64>; 2]) -> Chart {
    let history = &solution.history;
    let last = solved(&solution.stats.levels);
    // Without levels, every stage is the solution.
    let is_last = |record: &IterationRecord| last.is_none_or(|last| record.level == last);
    let floor = tolerance.map_or(0.0, |t| FLOOR * t);
    let curve = |value: fn(&IterationRecord) -> f64, of_last: bool| -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for (i, record) in history.iter().enumerate() {
            if i > 0 && history[i - 1].level != record.level {
                // A new mesh starts a new line
                points.push([f64::NAN; 2]);
            }
            if is_last(record) == of_last {
                points.push([(i + 1) as f64, value(record).max(floor)]);
            }
        }
        points
    };
    type Value = fn(&IterationRecord) -> f64;
    let values: [(&str, Value); 2] = [
        ("Reynolds residual", |r| r.residual),
        ("pressure update / *p*_{h}", |r| r.update),
    ];
    let mut series = Vec::new();
    let has_former = history.iter().any(|r| !is_last(r));
    for ((_, value), colour) in values.iter().zip(PALE) {
        let label = match (has_former, series.is_empty()) {
            (true, true) => "starts and coarser meshes: stopped early",
            _ => "",
        };
        series.push(Series::new(label, curve(*value, false), Look::Line, colour));
    }
    for ((label, value), colour) in values.iter().zip(PALETTE) {
        series.push(Series::new(
            *label,
            curve(*value, true),
            Look::LineAndDots,
            colour,
        ));
    }
    let of_last = || (1..).zip(history).filter(|(_, r)| is_last(r));
    let rounds: Vec<[f64; 2]> = of_last()
        .filter_map(|(i, r)| Some([f64::from(i), r.heat?.change]))
        .collect();
    let (tolerance, tolerance_of) = match coupling.filter(|_| !rounds.is_empty()) {
        Some(of_change) => (Some(of_change), "tolerance of the change"),
        None => (tolerance, "tolerance of the solution"),
    };
    if !rounds.is_empty() {
        series.push(Series::new(
            "film and heat, change per round",
            rounds,
            Look::LineAndDots,
            PALETTE[2],
        ));
    }
    let heights = series.iter().flat_map(|s| &s.points).map(|p| p[1]);
    let heights: Vec<f64> = heights.chain(tolerance).collect();
    if let Some(tolerance) = tolerance {
        let from = of_last().next().map_or(0.0, |(i, _)| f64::from(i) - 0.5);
        let to = of_last().last().map_or(0.0, |(i, _)| f64::from(i) + 0.5);
        series.push(Series::new(
            tolerance_of,
            vec![[from, tolerance], [to, tolerance]],
            Look::Dashed,
            GREY,
        ));
    }
    let mut chart = Chart::new(
        title,
        Axis::count("Newton iteration", history.len()),
        Axis::log_around("Relative residual and update", heights),
    );
    chart.series = series;
    chart.markers = stages(history, last);
    chart
}

/// A line where each stage begins; labels if there is room.
fn stages(history: &[IterationRecord], last: Option<usize>) -> Vec<Marker> {
    let apart = LABELS_APART * history.len() as f64;
    let mut markers: Vec<Marker> = Vec::new();
    let mut labelled = f64::NEG_INFINITY;
    let starts = history.iter().enumerate();
    for (i, record) in starts.filter(|(i, r)| *i == 0 || history[i - 1].level != r.level) {
        let x = i as f64 + 0.5;
        let is_solution = last == Some(record.level);
        let label = match (is_solution, x - labelled >= apart) {
            (true, _) => "solution".to_owned(),
            (false, true) => format!("{}", record.level + 1),
            (false, false) => String::new(),
        };
        if is_solution && x - labelled < apart {
            // The label of the solution takes precedence over that of the stage before it.
            if let Some(before) = markers.iter_mut().rev().find(|m| !m.label.is_empty()) {
                before.label.clear();
            }
        }
        if !label.is_empty() {
            labelled = if is_solution { x + 2.0 * apart } else { x };
        }
        markers.push(Marker { x, label });
    }
    markers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::sample;
    use crate::solution::HeatRound;

    fn record(level: usize) -> IterationRecord {
        IterationRecord {
            level,
            pressure_order: 3,
            penalty_share: 1.0,
            iteration: 1,
            residual: 1e-3,
            update: 1e-2,
            step: 1.0,
            krylov_iterations: 5,
            film_central: 2e-7,
            heat: None,
        }
    }

    /// Film and heat in turn: the drawn tolerance is that of the change per round, and the change falls below it.
    #[test]
    fn a_thermal_solve_ends_below_its_tolerance() {
        let (_, mut solution) = sample::line().clone();
        let last = solution.history.last().unwrap().level;
        let of_last: Vec<usize> = (0..solution.history.len())
            .filter(|i| solution.history[*i].level == last)
            .collect();
        for (round, i) in of_last.iter().enumerate() {
            let record = &mut solution.history[*i];
            (record.residual, record.update) = (1e-5, 1e-4);
            record.heat = Some(HeatRound {
                change: 0.1_f64.powi(2 + i32::try_from(round).unwrap()),
                temperature_rise: 8.0,
            });
        }
        let chart = newton("", &solution, [Some(1e-8), Some(1e-4)]);
        let points = |label: &str| {
            let series = chart.series.iter().find(|s| s.label.contains(label));
            &series.unwrap_or_else(|| panic!("no {label}")).points
        };
        let rounds = points("per round");
        assert_eq!(rounds.len(), of_last.len());
        let tolerance = points("tolerance of the change")[0][1];
        assert!(rounds[0][1] > tolerance && rounds.last().unwrap()[1] < tolerance);
        assert!(
            !chart
                .series
                .iter()
                .any(|s| s.label == "tolerance of the solution")
        );
    }

    /// Thirty stages of one iteration each: labels do not overlap, and the solution has a label.
    #[test]
    fn stage_labels_do_not_overlap() {
        let history: Vec<IterationRecord> = (0..30).map(record).collect();
        let markers = stages(&history, Some(29));
        assert_eq!(markers.len(), 30);
        assert_eq!(markers[29].label, "solution");
        let shown: Vec<f64> = markers
            .iter()
            .filter(|m| !m.label.is_empty())
            .map(|m| m.x)
            .collect();
        assert!(shown.windows(2).all(|w| w[1] - w[0] >= 0.055 * 30.0));
    }
}
