//! Quantities that are compared.

use super::run::{Outcome, Run};
use crate::output::pictures;
use crate::solution::Solution;
use crate::study::{CurveSolution, PointSolution};

/// A figure of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// H_c = h_c R/a².
    CentralFilm,
    /// H_m = h_m R/a², the smallest anywhere.
    MinimumFilm,
    /// X at which the film breaks on the centreline.
    Outlet,
    /// Most negative P.
    MinimumPressure,
    /// Largest P.
    MaximumPressure,
    /// P at the spike near the outlet.
    SpikePressure,
    /// Mean P along X = 0 near the side of the dry contact, 0.7 < |Y| < 1.
    SidePressure,
    /// Variation of P on the centreline, |X| ≤ 0.8, beyond that of one rise and one fall.
    PressureOscillation,
    /// Mass balance error of the film between inlet and centre.
    FilmBalance,
    /// Newton iterations of a cold start, all levels together.
    NewtonIterations,
    /// Largest deviation of the deflection from Hertz theory on |X| ≤ 1, over the central one.
    DeflectionError,
    /// The same without the deviation at the centre, which the rigid displacement takes up.
    DeflectionShapeError,
    /// Largest difference of the deflections of two runs on |X| ≤ 1, over the central one.
    DeflectionDifference,
    /// Unknowns: displacements, and pressures where they are solved for.
    Unknowns,
    /// Hertz pressure, GPa.
    HertzPressure,
    /// M.
    MoesLoad,
    /// L with the initial slope of ln μ(p).
    MoesMaterial,
    /// L with the reciprocal asymptotic coefficient α*.
    MoesMaterialAsymptotic,
    /// Traction coefficient at mid-film.
    Traction,
    /// X at the spike near the outlet.
    SpikePosition,
    /// Smallest film on the centreline over the smallest anywhere.
    CentrelineRatio,
    /// Largest rise of the film's temperature, K.
    FilmRiseOfTemperature,
    /// Mean temperature of the plane's surface less that of the ball's, over the Hertz zone, K.
    SurfaceDifference,
    /// How far mid-film is colder than the mean of both walls at the most, 0.8 < X < 1.2, K; negative where it is nowhere.
    OutletCooling,
    /// Traction coefficient without heat, on the first mesh.
    IsothermalTraction,
    /// Reduction of the central film by heat.
    ThermalFilmReduction,
    /// Heat made but not carried off, over the heat made, absolute.
    HeatBalanceError,
    /// Of a curve: smallest reduction of the central film by shear thinning.
    LeastFilmReduction,
    /// Of a curve: largest.
    MostFilmReduction,
    /// Of a curve: share of the central film lost from the first point to the last.
    FilmFall,
    /// Of a curve: largest relative rise of the central film from a point to the next; negative where it always falls.
    FilmRise,
    /// Of a curve: largest traction coefficient at mid-film.
    MostTraction,
    /// Of a curve: largest ratio of the traction to that without shear thinning, where surfaces slide.
    MostTractionRatio,
    /// Of a curve: largest relative change of the largest pressure from the first point.
    PressureChange,
}

impl Quantity {
    /// Every quantity.
    pub const ALL: [Quantity; 34] = [
        Quantity::CentralFilm,
        Quantity::MinimumFilm,
        Quantity::Outlet,
        Quantity::MinimumPressure,
        Quantity::MaximumPressure,
        Quantity::SpikePressure,
        Quantity::SidePressure,
        Quantity::PressureOscillation,
        Quantity::FilmBalance,
        Quantity::NewtonIterations,
        Quantity::DeflectionError,
        Quantity::DeflectionShapeError,
        Quantity::DeflectionDifference,
        Quantity::Unknowns,
        Quantity::HertzPressure,
        Quantity::MoesLoad,
        Quantity::MoesMaterial,
        Quantity::MoesMaterialAsymptotic,
        Quantity::Traction,
        Quantity::SpikePosition,
        Quantity::CentrelineRatio,
        Quantity::FilmRiseOfTemperature,
        Quantity::SurfaceDifference,
        Quantity::OutletCooling,
        Quantity::IsothermalTraction,
        Quantity::ThermalFilmReduction,
        Quantity::HeatBalanceError,
        Quantity::LeastFilmReduction,
        Quantity::MostFilmReduction,
        Quantity::FilmFall,
        Quantity::FilmRise,
        Quantity::MostTraction,
        Quantity::MostTractionRatio,
        Quantity::PressureChange,
    ];

    /// Name in `reference.toml`.
    pub fn key(self) -> &'static str {
        match self {
            Quantity::CentralFilm => "central-film",
            Quantity::MinimumFilm => "minimum-film",
            Quantity::Outlet => "outlet",
            Quantity::MinimumPressure => "minimum-pressure",
            Quantity::MaximumPressure => "maximum-pressure",
            Quantity::SpikePressure => "spike-pressure",
            Quantity::SidePressure => "side-pressure",
            Quantity::PressureOscillation => "pressure-oscillation",
            Quantity::FilmBalance => "film-balance",
            Quantity::NewtonIterations => "newton-iterations",
            Quantity::DeflectionError => "deflection-error",
            Quantity::DeflectionShapeError => "deflection-shape-error",
            Quantity::DeflectionDifference => "deflection-difference",
            Quantity::Unknowns => "unknowns",
            Quantity::HertzPressure => "hertz-pressure",
            Quantity::MoesLoad => "moes-load",
            Quantity::MoesMaterial => "moes-material",
            Quantity::MoesMaterialAsymptotic => "moes-material-asymptotic",
            Quantity::Traction => "traction",
            Quantity::SpikePosition => "spike-position",
            Quantity::CentrelineRatio => "centreline-ratio",
            Quantity::FilmRiseOfTemperature => "film-temperature-rise",
            Quantity::SurfaceDifference => "surface-difference",
            Quantity::OutletCooling => "outlet-cooling",
            Quantity::IsothermalTraction => "isothermal-traction",
            Quantity::ThermalFilmReduction => "thermal-film-reduction",
            Quantity::HeatBalanceError => "heat-balance",
            Quantity::LeastFilmReduction => "least-film-reduction",
            Quantity::MostFilmReduction => "most-film-reduction",
            Quantity::FilmFall => "film-fall",
            Quantity::FilmRise => "film-rise",
            Quantity::MostTraction => "most-traction",
            Quantity::MostTractionRatio => "most-traction-ratio",
            Quantity::PressureChange => "pressure-change",
        }
    }

    /// Name in tables.
    pub fn label(self) -> &'static str {
        match self {
            Quantity::CentralFilm => "H_c",
            Quantity::MinimumFilm => "H_m",
            Quantity::Outlet => "X_out",
            Quantity::MinimumPressure => "min P",
            Quantity::MaximumPressure => "max P",
            Quantity::SpikePressure => "P of the spike",
            Quantity::SidePressure => "mean P at the side",
            Quantity::PressureOscillation => "oscillation of P",
            Quantity::FilmBalance => "balance error",
            Quantity::NewtonIterations => "Newton iterations",
            Quantity::DeflectionError => "deflection error",
            Quantity::DeflectionShapeError => "shape error",
            Quantity::DeflectionDifference => "deflection difference",
            Quantity::Unknowns => "unknowns",
            Quantity::HertzPressure => "p_h, GPa",
            Quantity::MoesLoad => "M",
            Quantity::MoesMaterial => "L",
            Quantity::MoesMaterialAsymptotic => "L with α*",
            Quantity::Traction => "traction coefficient",
            Quantity::SpikePosition => "X of the spike",
            Quantity::CentrelineRatio => "h_cmin/h_min",
            Quantity::FilmRiseOfTemperature => "largest film temperature rise, K",
            Quantity::SurfaceDifference => "mean plane − mean ball, K",
            Quantity::OutletCooling => "mid-film below the mean of the walls at the outlet, K",
            Quantity::IsothermalTraction => "isothermal traction coefficient",
            Quantity::ThermalFilmReduction => "film reduction by heat",
            Quantity::HeatBalanceError => "heat balance error",
            Quantity::LeastFilmReduction => "smallest film reduction",
            Quantity::MostFilmReduction => "largest film reduction",
            Quantity::FilmFall => "fall of h_c, first to last point",
            Quantity::FilmRise => "largest rise of h_c, point to point",
            Quantity::MostTraction => "largest traction coefficient",
            Quantity::MostTractionRatio => "largest traction/Newtonian",
            Quantity::PressureChange => "largest change of max p",
        }
    }

    /// Whether it is a share, shown in per cent.
    pub fn is_share(self) -> bool {
        matches!(
            self,
            Quantity::DeflectionError
                | Quantity::DeflectionShapeError
                | Quantity::LeastFilmReduction
                | Quantity::ThermalFilmReduction
                | Quantity::HeatBalanceError
                | Quantity::MostFilmReduction
                | Quantity::FilmFall
                | Quantity::FilmRise
                | Quantity::MostTractionRatio
                | Quantity::PressureChange
        )
    }

    /// Whether it counts something.
    pub fn is_count(self) -> bool {
        matches!(self, Quantity::NewtonIterations | Quantity::Unknowns)
    }

    /// Value in the outcome of a run, `None` where it has no such figure; `other` is the run that
    /// differences are taken from.
    pub fn value(self, run: &Run, outcome: &Outcome, other: Option<&Outcome>) -> Option<f64> {
        match outcome {
            Outcome::Solved(s) => {
                let f = &s.summary;
                let last = s.stats.solved();
                match self {
                    Quantity::CentralFilm => Some(f.film_central.value / s.scales.film),
                    Quantity::MinimumFilm => Some(f.film_minimum.value / s.scales.film),
                    Quantity::Outlet => Some(f.outlet_position.value / s.scales.length),
                    Quantity::MinimumPressure => Some(f.pressure_minimum / s.scales.pressure),
                    Quantity::MaximumPressure => Some(f.pressure_maximum.value / s.scales.pressure),
                    Quantity::SpikePressure => f.spike.map(|p| p.value / s.scales.pressure),
                    Quantity::SidePressure => {
                        let factor = 1.0 / s.scales.pressure;
                        mean(
                            &pictures::profile_across(s, &s.elements.pressure, factor),
                            SIDE,
                        )
                    }
                    Quantity::PressureOscillation => {
                        let line = &s.centreline;
                        let inner = line
                            .x
                            .iter()
                            .zip(&line.pressure)
                            .filter(|(x, _)| x.abs() <= OSCILLATION_ZONE * s.scales.length)
                            .map(|(_, p)| p / s.scales.pressure);
                        Some(oscillation(&inner.collect::<Vec<_>>()))
                    }
                    Quantity::FilmBalance => Some(f.film_balance_error.abs()),
                    Quantity::NewtonIterations => Some(
                        s.stats
                            .levels
                            .iter()
                            .map(|l| l.newton_iterations)
                            .sum::<usize>() as f64,
                    ),
                    Quantity::Unknowns => {
                        last.map(|l| (l.n_displacement_dofs + l.n_pressure_dofs) as f64)
                    }
                    Quantity::HertzPressure => Some(1e-9 * s.hertz.pressure),
                    Quantity::MoesLoad => Some(s.groups.moes_load),
                    Quantity::MoesMaterial => Some(s.groups.moes_material),
                    Quantity::MoesMaterialAsymptotic => {
                        s.groups_asymptotic.map(|g| g.moes_material)
                    }
                    Quantity::Traction => Some(s.traction.coefficient.value),
                    Quantity::SpikePosition => f.spike.map(|p| p.x / s.scales.length),
                    Quantity::CentrelineRatio => {
                        Some(f.film_centreline_minimum.value / f.film_minimum.value)
                    }
                    _ => self.of_heat(s),
                }
            }
            Outcome::Deflected(d) => {
                let kind = run.case.contact.kind;
                match (self, other) {
                    (Quantity::DeflectionError, _) => Some(d.error(kind)),
                    (Quantity::DeflectionShapeError, _) => Some(d.shape_error(kind)),
                    (Quantity::DeflectionDifference, Some(Outcome::Deflected(other))) => {
                        d.difference(other)
                    }
                    (Quantity::Unknowns, _) => Some(d.n_displacement_dofs as f64),
                    _ => None,
                }
            }
            Outcome::Curve(curve) => self.of_curve(curve),
            Outcome::Failed(_) | Outcome::Skipped => None,
        }
    }
}

impl Quantity {
    /// Value of a thermal solution; `None` for another.
    fn of_heat(self, s: &Solution) -> Option<f64> {
        let thermal = s.thermal.as_ref()?;
        match self {
            Quantity::FilmRiseOfTemperature => {
                Some(thermal.film_maximum.value - thermal.inlet_temperature)
            }
            Quantity::SurfaceDifference => {
                Some(thermal.body_1_mean.value - thermal.body_2_mean.value)
            }
            Quantity::OutletCooling => {
                let line = &thermal.centreline;
                let below = |i: usize| 0.5 * (line.plane[i] + line.ball[i]) - line.mid[i];
                (s.centreline.x.iter().enumerate())
                    .filter(|(_, x)| OUTLET.contains(&(*x / s.scales.length)))
                    .map(|(i, _)| below(i))
                    .reduce(f64::max)
            }
            Quantity::IsothermalTraction => Some(thermal.reduction?.isothermal_traction.value),
            Quantity::ThermalFilmReduction => Some(thermal.reduction?.film_central.value),
            Quantity::HeatBalanceError => Some(thermal.balance.error.abs()),
            _ => None,
        }
    }

    /// Value of a curve; `None` where a point that it needs has no solution.
    fn of_curve(self, curve: &CurveSolution) -> Option<f64> {
        /// A figure of every point that has it, `None` if one that should does not.
        fn of_points(
            curve: &CurveSolution,
            figure: impl Fn(&PointSolution) -> Option<f64>,
        ) -> Option<Vec<f64>> {
            curve.points.iter().map(figure).collect()
        }
        let largest = |list: Vec<f64>| list.into_iter().reduce(f64::max);
        let slides = |p: &&PointSolution| p.case.motion.slides();
        let film = |p: &PointSolution| Some(p.outcome.solution()?.summary.film_central.value);
        let pressure =
            |p: &PointSolution| Some(p.outcome.solution()?.summary.pressure_maximum.value);
        let traction = |p: &PointSolution| Some(p.outcome.solution()?.traction.coefficient.value);
        let reductions = || of_points(curve, |p| Some(p.film_reduction()?.central.value));
        match self {
            Quantity::HertzPressure => {
                let solved = curve.points.iter().find_map(|p| p.outcome.solution());
                Some(1e-9 * solved?.hertz.pressure)
            }
            Quantity::LeastFilmReduction => reductions()?.into_iter().reduce(f64::min),
            Quantity::MostFilmReduction => largest(reductions()?),
            Quantity::FilmFall => {
                let films = of_points(curve, film)?;
                Some(1.0 - films.last()? / films.first()?)
            }
            Quantity::FilmRise => {
                let films = of_points(curve, film)?;
                largest(films.windows(2).map(|w| w[1] / w[0] - 1.0).collect())
            }
            Quantity::MostTraction => largest(of_points(curve, traction)?),
            Quantity::MostTractionRatio => {
                let ratio =
                    |p| Some(traction(p)? / p.newtonian_solution()?.traction.coefficient.value);
                let ratios: Option<Vec<f64>> =
                    curve.points.iter().filter(slides).map(ratio).collect();
                largest(ratios?)
            }
            Quantity::PressureChange => {
                let pressures = of_points(curve, pressure)?;
                let first = *pressures.first()?;
                largest(pressures.iter().map(|p| (p / first - 1.0).abs()).collect())
            }
            _ => None,
        }
    }
}

/// Part of the Hertz zone where a heavily loaded contact's pressure is smooth: the inlet and the
/// spike lie outside.
const OSCILLATION_ZONE: f64 = 0.8;

/// Where the pressure falls off at the side, |Y|.
const SIDE: [f64; 2] = [0.7, 1.0];

/// Mean of points of rising first coordinate within a range of its magnitude, by trapezia; `None` where there are none. The
/// coordinate is negative.
fn mean(points: &[[f64; 2]], [low, high]: [f64; 2]) -> Option<f64> {
    let inside = |p: &[f64; 2]| (low..=high).contains(&-p[0]);
    let inside: Vec<[f64; 2]> = points.iter().copied().filter(inside).collect();
    let (first, last) = (inside.first()?, inside.last()?);
    let trapezia = inside
        .windows(2)
        .map(|w| 0.5 * (w[0][1] + w[1][1]) * (w[1][0] - w[0][0]));
    Some(trapezia.sum::<f64>() / (last[0] - first[0]))
}

/// Where the film leaves the Hertz zone and its pressure falls off, X.
const OUTLET: std::ops::Range<f64> = 0.8..1.2;

/// Sum of all rises and falls beyond those of a profile that rises to its maximum and falls.
fn oscillation(values: &[f64]) -> f64 {
    let (Some(first), Some(last)) = (values.first(), values.last()) else {
        return 0.0;
    };
    let total: f64 = values.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
    let top = values.iter().fold(f64::NEG_INFINITY, |m, v| m.max(*v));
    (total - (2.0 * top - first - last)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::oscillation;
    use approx::assert_relative_eq;

    /// By hand: one dip of 0.2 on the way up and one of 0.1 on the way down cost twice their depths.
    #[test]
    fn oscillation_counts_dips_twice() {
        let smooth = oscillation(&[0.1, 0.5, 1.0, 0.7, 0.2]);
        assert_relative_eq!(smooth, 0.0, epsilon = 1e-15);
        let dips = [0.1, 0.5, 0.3, 1.0, 0.6, 0.7, 0.2];
        assert_relative_eq!(oscillation(&dips), 0.6, epsilon = 1e-14);
        assert_eq!(oscillation(&[]), 0.0);
    }
}
