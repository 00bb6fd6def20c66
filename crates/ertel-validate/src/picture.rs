//! Pictures of studies.

use super::outcome::Outcome;
use super::{Picture, PictureKind, Quantity, Study};
use super::{instants, profiles};
use ertel::contact::{Family, hertz};
use ertel::output::curve;
use ertel::output::pictures;
use ertel::params::PenaltyScaling;
use ertel::reference::FilmFormula;
use ertel::solution::Solution;
use ertel::study::CurveSolution;
use ertel_plot::{Axis, Chart, Look, PALETTE, Series};

impl PictureKind {
    /// Whether it is one chart, whose left axis can be given a range.
    pub(super) fn has_left_axis(&self) -> bool {
        match self {
            PictureKind::Centreline(_)
            | PictureKind::Deflection
            | PictureKind::DeflectionError
            | PictureKind::FilmOverLoad(..)
            | PictureKind::FilmCurves(_)
            | PictureKind::FilmShape(_)
            | PictureKind::TractionCurves(_)
            | PictureKind::Penalty(_) => true,
            PictureKind::Profiles(..)
            | PictureKind::Overlay(..)
            | PictureKind::CrossFilm(..)
            | PictureKind::Temperatures(..)
            | PictureKind::Instants(..)
            | PictureKind::Map(..) => false,
        }
    }
}

impl Picture {
    /// The picture as an SVG file; `None` when its runs have no results.
    pub(super) fn svg(&self, study: &Study, outcomes: &[Outcome]) -> Option<String> {
        let solved = |runs: &[usize]| -> Vec<(String, Option<&Solution>)> {
            let solution = |i: &usize| match &outcomes[*i] {
                Outcome::Solved(s) => Some(&**s),
                _ => None,
            };
            runs.iter()
                .map(|i| (study.runs[*i].name.clone(), solution(i)))
                .collect()
        };
        match &self.kind {
            PictureKind::Profiles(runs, columns) => {
                profiles::panels(&self.caption, &solved(runs), *columns)
            }
            PictureKind::Overlay(profile, runs, zoom) => {
                profiles::overlay(*profile, &self.caption, &solved(runs), *zoom)
            }
            PictureKind::CrossFilm(runs, columns) => {
                profiles::temperatures(true, &self.caption, &solved(runs), *columns)
            }
            PictureKind::Temperatures(runs, columns) => {
                profiles::temperatures(false, &self.caption, &solved(runs), *columns)
            }
            PictureKind::Instants(run, published, columns) => match &outcomes[*run] {
                Outcome::Transient(found) => {
                    instants::panels(&self.caption, found, published, *columns)
                }
                _ => None,
            },
            PictureKind::Map(run, field) => {
                let pictures = pictures::pictures(&self.caption, solved(&[*run])[0].1?, None);
                let map = pictures.into_iter().find(|p| p.name == *field)?;
                Some(map.svg)
            }
            _ => self.chart(study, outcomes).map(|mut chart| {
                if let Some([low, high]) = self.range {
                    chart.y = Axis::linear(&chart.y.label, low, high);
                }
                chart.svg()
            }),
        }
    }

    /// The chart of a picture with one frame.
    fn chart(&self, study: &Study, outcomes: &[Outcome]) -> Option<Chart> {
        match &self.kind {
            PictureKind::Profiles(..)
            | PictureKind::Overlay(..)
            | PictureKind::CrossFilm(..)
            | PictureKind::Temperatures(..)
            | PictureKind::Instants(..)
            | PictureKind::Map(..) => None,
            PictureKind::Centreline(run) => match &outcomes[*run] {
                Outcome::Solved(s) => Some(pictures::centreline(&self.caption, s)),
                _ => None,
            },
            PictureKind::Deflection => self.deflection(study, outcomes, false),
            PictureKind::DeflectionError => self.deflection(study, outcomes, true),
            PictureKind::FilmOverLoad(formula, runs) => {
                self.film_over_load(study, outcomes, *formula, runs)
            }
            PictureKind::Penalty(quantity) => self.penalty(study, outcomes, *quantity),
            PictureKind::FilmCurves(runs) => {
                curve::films_chart(&self.caption, &curves(study, outcomes, runs))
            }
            PictureKind::FilmShape(run) => {
                let (_, curve) = *curves(study, outcomes, &[*run]).first()?;
                Some(curve::film_shape_chart(&self.caption, curve))
            }
            PictureKind::TractionCurves(runs) => {
                curve::tractions_chart(&self.caption, &curves(study, outcomes, runs))
            }
        }
    }

    fn deflection(&self, study: &Study, outcomes: &[Outcome], deviation: bool) -> Option<Chart> {
        let theory = |family: Family, x: f64| hertz::deflection_profile(family, x);
        let mut series = Vec::new();
        let mut hertz_curve = Vec::new();
        for (run, outcome) in study.runs.iter().zip(outcomes) {
            let Outcome::Deflected(d) = outcome else {
                continue;
            };
            let family = run.case.contact.kind.family();
            let points: Vec<[f64; 2]> = d.x.iter().zip(&d.value).map(|(x, v)| [*x, *v]).collect();
            if hertz_curve.is_empty() {
                let (from, to) = (points.first()?[0], points.last()?[0]);
                hertz_curve = (0..=N_MARKS)
                    .map(|i| from + (to - from) * f64::from(i) / f64::from(N_MARKS))
                    .map(|x| [x, theory(family, x)])
                    .collect();
            }
            let points = if deviation {
                let relative = |p: &[f64; 2]| [p[0], 100.0 * (p[1] - theory(family, p[0]))];
                points.iter().map(relative).collect()
            } else {
                points
            };
            series.push(Series::new(
                run.name.clone(),
                points,
                if series.len() % 2 == 0 {
                    Look::Line
                } else {
                    Look::Dashed
                },
                PALETTE[series.len() % PALETTE.len()],
            ));
        }
        if !deviation {
            series.push(Series::new(
                "Hertz theory",
                hertz_curve,
                Look::Circles,
                "#404040",
            ));
        }
        let label = if deviation {
            "Deviation of the deflection (% of the central)"
        } else {
            "Deflection *δR*/*a*^{2}"
        };
        self.curves("*x*/*a*", label, series)
    }

    fn film_over_load(
        &self,
        study: &Study,
        outcomes: &[Outcome],
        formula: FilmFormula,
        runs: &[usize],
    ) -> Option<Chart> {
        // (L, [M, H of ours, H of the formula])
        let mut curves: Vec<(f64, Vec<[f64; 3]>)> = Vec::new();
        for i in runs {
            let (run, outcome) = (&study.runs[*i], &outcomes[*i]);
            let Outcome::Solved(s) = outcome else {
                continue;
            };
            let scale = run.case.contact.radius * (2.0 * s.groups.speed).sqrt();
            let Some(predicted) = formula.film(&run.case.contact, &s.groups).0 else {
                continue;
            };
            let (m, l) = (s.groups.moes_load, s.groups.moes_material);
            let point = [m, s.summary.film_central.value / scale, predicted / scale];
            match curves
                .iter_mut()
                .find(|(other, _)| (other - l).abs() < 1e-3)
            {
                Some((_, points)) => points.push(point),
                None => curves.push((l, vec![point])),
            }
        }
        curves.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut series = Vec::new();
        for (i, (l, points)) in curves.iter_mut().enumerate() {
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let colour = PALETTE[i % PALETTE.len()].to_owned();
            series.push(Series::new(
                "",
                points.iter().map(|p| [p[0], p[2]]).collect(),
                Look::Dashed,
                colour.clone(),
            ));
            series.push(Series::new(
                format!("*L* = {}", (1e3 * *l).round() / 1e3),
                points.iter().map(|p| [p[0], p[1]]).collect(),
                Look::LineAndDots,
                colour,
            ));
        }
        series.push(Series {
            label: formula.name().to_owned(),
            look: Look::Dashed,
            colour: "#404040".to_owned(),
            ..Series::default()
        });
        let all = || series.iter().flat_map(|s| s.points.iter());
        all().next()?;
        let x = Axis::log_close_around("Load group *M*", all().map(|p| p[0]));
        let y = Axis::log_close_around("Central film *h*_{c}/(*R*√2*U*)", all().map(|p| p[1]));
        let mut chart = Chart::new(&self.caption, x, y);
        chart.series = series;
        Some(chart)
    }

    fn penalty(&self, study: &Study, outcomes: &[Outcome], quantity: Quantity) -> Option<Chart> {
        // One curve per (scaling, mesh), in the order of their first runs
        let mut curves: Vec<Curve> = Vec::new();
        for (run, outcome) in study.runs.iter().zip(outcomes) {
            let Some(value) = quantity.value(run, outcome, None) else {
                continue;
            };
            let solver = &run.case.solver;
            let key = (solver.penalty_scaling, run.case.mesh.constriction_size);
            let point = [solver.penalty, value];
            match curves.iter_mut().find(|(k, _)| *k == key) {
                Some((_, points)) => points.push(point),
                None => curves.push((key, vec![point])),
            }
        }
        let first_mesh = curves.first()?.0.1;
        let mut meshes: Vec<f64> = curves.iter().map(|((_, mesh), _)| *mesh).collect();
        meshes.dedup();
        let series: Vec<Series> = curves
            .into_iter()
            .map(|((scaling, mesh), points)| {
                let (label, colour) = match scaling {
                    PenaltyScaling::ElementSquared => ("*ξ*_{0}*h*_{e}^{2}", PALETTE[1]),
                    PenaltyScaling::Constant => ("*ξ*_{0}", PALETTE[0]),
                    PenaltyScaling::Film => ("*ξ*_{0} max(1, *H*_{f}^{2}/*λ*)", PALETTE[3]),
                    PenaltyScaling::InverseElementSquared => ("*ξ*_{0}/*h*_{e}^{2}", PALETTE[2]),
                };
                let look = match meshes.iter().position(|m| *m == mesh) {
                    // A line through one point cannot be seen.
                    _ if points.len() == 1 => Look::Dots,
                    Some(0) => Look::Line,
                    Some(1) => Look::Dashed,
                    _ => Look::LineAndDots,
                };
                let label = if mesh == first_mesh { label } else { "" };
                Series::new(label, points, look, colour)
            })
            .collect();
        let all = || series.iter().flat_map(|s| s.points.iter());
        let x = Axis::log_close_around("Penalty *ξ*_{0}", all().map(|p| p[0]));
        let label = match quantity {
            Quantity::Outlet => "Outlet *X*_{out}",
            other => other.label(),
        };
        let y = Axis::linear_around(label, all().map(|p| p[1]));
        let mut chart = Chart::new(&self.caption, x, y);
        chart.series = series;
        Some(chart)
    }

    fn curves(&self, x: &str, y: &str, series: Vec<Series>) -> Option<Chart> {
        let all = || series.iter().flat_map(|s| s.points.iter());
        let first = all().next()?[0];
        let (low, high) = all().fold((first, first), |(l, h), p| (l.min(p[0]), h.max(p[0])));
        let mut chart = Chart::new(
            &self.caption,
            Axis::linear(x, low, high),
            // Marks at the top of a curve keep clear of the frame
            Axis::linear_around(y, all().flat_map(|p| [p[1], 1.02 * p[1]])),
        );
        chart.series = series;
        Some(chart)
    }
}

/// The curves among the outcomes of runs, with the names of the runs.
fn curves<'a>(
    study: &'a Study,
    outcomes: &'a [Outcome],
    runs: &[usize],
) -> Vec<(&'a str, &'a CurveSolution)> {
    let curve = |i: &usize| match &outcomes[*i] {
        Outcome::Curve(curve) => Some((study.runs[*i].name.as_str(), curve)),
        _ => None,
    };
    runs.iter().filter_map(curve).collect()
}

/// Marks on the curve of the theory.
const N_MARKS: u32 = 30;

/// Points of one penalty scaling on one mesh (its constriction size).
type Curve = ((PenaltyScaling, f64), Vec<[f64; 2]>);
