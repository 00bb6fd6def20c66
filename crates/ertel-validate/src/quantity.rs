//! Quantities that are compared: those of the thesis in its dimensionless form, one row for each, and every figure of the registry in SI.

use super::deflection::Deflection;
use super::outcome::{Outcome, Run};
use ertel::output::pictures;
use ertel::run::transient::TransientSolution;
use ertel::solution::{Figure, Solution};
use ertel::study::{CurveSolution, PointSolution};

/// How a quantity is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    /// As a number.
    Number,
    /// In per cent.
    Share,
    /// As a count.
    Count,
}

/// Where a quantity is found; nowhere where a run has no such figure.
#[derive(Clone, Copy, Default)]
struct Sources {
    solution: Option<fn(&Solution) -> Option<f64>>,
    curve: Option<fn(&CurveSolution) -> Option<f64>>,
    deflection: Option<OfDeflection>,
    transient: Option<fn(&TransientSolution) -> Option<f64>>,
}

/// Of a run that only deflects the bodies, and the run that differences are taken from.
type OfDeflection = fn(&Run, &Deflection, Option<&Outcome>) -> Option<f64>;

impl Sources {
    const NONE: Sources = Sources {
        solution: None,
        curve: None,
        deflection: None,
        transient: None,
    };

    const fn solution(value: fn(&Solution) -> Option<f64>) -> Sources {
        Sources::NONE.or_solution(value)
    }

    const fn or_solution(self, value: fn(&Solution) -> Option<f64>) -> Sources {
        Sources {
            solution: Some(value),
            ..self
        }
    }

    const fn curve(value: fn(&CurveSolution) -> Option<f64>) -> Sources {
        Sources {
            curve: Some(value),
            ..Sources::NONE
        }
    }

    const fn transient(value: fn(&TransientSolution) -> Option<f64>) -> Sources {
        Sources {
            transient: Some(value),
            ..Sources::NONE
        }
    }

    const fn deflection(value: OfDeflection) -> Sources {
        Sources {
            deflection: Some(value),
            ..Sources::NONE
        }
    }
}

/// Declares the quantities: name in `reference.toml`, name in tables, how it is written, where it is found.
macro_rules! quantities {
    ($($(#[$doc:meta])* $variant:ident, $key:literal, $label:literal, $format:ident, $sources:expr;)*) => {
        /// A figure of a run.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Quantity {
            /// A figure of the registry, SI.
            Figure(Figure),
            $($(#[$doc])* $variant,)*
        }

        impl Quantity {
            /// Every quantity.
            pub fn all() -> Vec<Quantity> {
                let figures = Figure::ALL.map(Quantity::Figure);
                [&[$(Quantity::$variant),*][..], &figures].concat()
            }

            /// Name in `reference.toml`.
            pub fn key(self) -> &'static str {
                match self {
                    Quantity::Figure(figure) => figure.name(),
                    $(Quantity::$variant => $key,)*
                }
            }

            /// Name in tables.
            pub fn label(self) -> &'static str {
                match self {
                    Quantity::Figure(figure) => figure.words(),
                    $(Quantity::$variant => $label,)*
                }
            }

            fn format(self) -> Format {
                match self {
                    Quantity::Figure(_) => Format::Number,
                    $(Quantity::$variant => Format::$format,)*
                }
            }

            fn sources(self) -> Sources {
                match self {
                    Quantity::Figure(_) => Sources::NONE,
                    $(Quantity::$variant => $sources,)*
                }
            }
        }
    };
}

quantities! {
    /// H_c = h_c R/a².
    CentralFilm, "central-film", "H_c", Number,
        Sources::solution(|s| Some(s.summary.film_central.value / s.scales.film));
    /// H_m = h_m R/a², the smallest anywhere.
    MinimumFilm, "minimum-film", "H_m", Number,
        Sources::solution(|s| Some(s.summary.film_minimum.value / s.scales.film));
    /// X at which the film breaks on the centreline.
    Outlet, "outlet", "X_out", Number,
        Sources::solution(|s| Some(s.summary.outlet_position.value / s.scales.length));
    /// Most negative P.
    MinimumPressure, "minimum-pressure", "min P", Number,
        Sources::solution(|s| Some(s.summary.pressure_minimum / s.scales.pressure));
    /// Largest P.
    MaximumPressure, "maximum-pressure", "max P", Number,
        Sources::solution(|s| Some(s.summary.pressure_maximum.value / s.scales.pressure));
    /// P at the spike near the outlet.
    SpikePressure, "spike-pressure", "P of the spike", Number,
        Sources::solution(|s| s.summary.spike.map(|p| p.value / s.scales.pressure));
    /// Mean P along X = 0 near the side of the dry contact, 0.7 < |Y| < 1.
    SidePressure, "side-pressure", "mean P at the side", Number, Sources::solution(side_pressure);
    /// Variation of P on the centreline, |X| ≤ 0.8, beyond that of one rise and one fall.
    PressureOscillation, "pressure-oscillation", "oscillation of P", Number, Sources::solution(pressure_oscillation);
    /// Mass balance error of the film between inlet and centre.
    FilmBalance, "film-balance", "balance error", Number,
        Sources::solution(|s| Some(s.summary.film_balance_error.abs()));
    /// Newton iterations of a cold start, all levels together.
    NewtonIterations, "newton-iterations", "Newton iterations", Count, Sources::solution(|s| {
        let iterations = s.stats.levels.iter().map(|l| l.newton_iterations);
        Some(iterations.sum::<usize>() as f64)
    });
    /// Largest deviation of the deflection from Hertz theory on |X| ≤ 1, over the central one.
    DeflectionError, "deflection-error", "deflection error", Share,
        Sources::deflection(|run, d, _| Some(d.error(run.case.contact.kind.family())));
    /// The same without the deviation at the centre, which the rigid displacement takes up.
    DeflectionShapeError, "deflection-shape-error", "shape error", Share,
        Sources::deflection(|run, d, _| Some(d.shape_error(run.case.contact.kind.family())));
    /// Largest difference of the deflections of two runs on |X| ≤ 1, over the central one.
    DeflectionDifference, "deflection-difference", "deflection difference", Number,
        Sources::deflection(|_, d, other| match other {
            Some(Outcome::Deflected(other)) => d.difference(other),
            _ => None,
        });
    /// Unknowns: displacements, and pressures where they are solved for.
    Unknowns, "unknowns", "unknowns", Count,
        Sources::deflection(|_, d, _| Some(d.n_displacement_dofs as f64)).or_solution(|s| {
            let solved = s.stats.solved()?;
            Some((solved.n_displacement_dofs + solved.n_pressure_dofs) as f64)
        });
    /// Hertz pressure, GPa.
    HertzPressure, "hertz-pressure", "p_h, GPa", Number,
        Sources::curve(|curve| {
            let solved = curve.points.iter().find_map(|p| p.outcome.solution());
            Some(1e-9 * solved?.hertz.pressure)
        })
        .or_solution(|s| Some(1e-9 * s.hertz.pressure));
    /// M.
    MoesLoad, "moes-load", "M", Number, Sources::solution(|s| Some(s.groups.moes_load));
    /// L with the initial slope of ln μ(p).
    MoesMaterial, "moes-material", "L", Number, Sources::solution(|s| Some(s.groups.moes_material));
    /// L with the reciprocal asymptotic coefficient α*.
    MoesMaterialAsymptotic, "moes-material-asymptotic", "L with α*", Number,
        Sources::solution(|s| s.groups_asymptotic.map(|g| g.moes_material));
    /// Traction coefficient at mid-film.
    Traction, "traction", "traction coefficient", Number,
        Sources::solution(|s| Some(s.traction.coefficient.value));
    /// X at the spike near the outlet.
    SpikePosition, "spike-position", "X of the spike", Number,
        Sources::solution(|s| s.summary.spike.map(|p| p.x / s.scales.length));
    /// Smallest film on the centreline over the smallest anywhere.
    CentrelineRatio, "centreline-ratio", "h_cmin/h_min", Number,
        Sources::solution(|s| Some(s.summary.film_centreline_minimum.value / s.summary.film_minimum.value));
    /// Largest rise of the film's temperature, K.
    FilmRiseOfTemperature, "film-temperature-rise", "largest film temperature rise, K", Number,
        Sources::solution(|s| {
            let thermal = s.thermal.as_ref()?;
            Some(thermal.film_maximum.value - thermal.inlet_temperature)
        });
    /// Mean temperature of the surface of body 1 less that of body 2, over the Hertz zone, K.
    SurfaceDifference, "surface-difference", "mean body 1 − mean body 2, K", Number,
        Sources::solution(|s| {
            let thermal = s.thermal.as_ref()?;
            Some(thermal.body_1_mean.value - thermal.body_2_mean.value)
        });
    /// How far mid-film is colder than the mean of both walls at the most, 0.8 < X < 1.2, K; negative where it is nowhere.
    OutletCooling, "outlet-cooling", "mid-film below the mean of the walls at the outlet, K", Number,
        Sources::solution(outlet_cooling);
    /// Traction coefficient without heat, on the first mesh.
    IsothermalTraction, "isothermal-traction", "isothermal traction coefficient", Number,
        Sources::solution(|s| Some(s.thermal.as_ref()?.reduction?.isothermal_traction.value));
    /// Reduction of the central film by heat.
    ThermalFilmReduction, "thermal-film-reduction", "film reduction by heat", Share,
        Sources::solution(|s| Some(s.thermal.as_ref()?.reduction?.film_central.value));
    /// Heat made but not carried off, over the heat made, absolute.
    HeatBalanceError, "heat-balance", "heat balance error", Share,
        Sources::solution(|s| Some(s.thermal.as_ref()?.balance.error.abs()));
    /// Of a curve: smallest reduction of the central film by shear thinning.
    LeastFilmReduction, "least-film-reduction", "smallest film reduction", Share,
        Sources::curve(|curve| reductions(curve)?.into_iter().reduce(f64::min));
    /// Of a curve: largest.
    MostFilmReduction, "most-film-reduction", "largest film reduction", Share,
        Sources::curve(|curve| largest(reductions(curve)?));
    /// Of a curve: share of the central film lost from the first point to the last.
    FilmFall, "film-fall", "fall of h_c, first to last point", Share, Sources::curve(|curve| {
        let films = values_of(curve, Figure::FilmCentral)?;
        Some(1.0 - films.last()? / films.first()?)
    });
    /// Of a curve: largest relative rise of the central film from a point to the next; negative where it always falls.
    FilmRise, "film-rise", "largest rise of h_c, point to point", Share, Sources::curve(|curve| {
        let films = values_of(curve, Figure::FilmCentral)?;
        largest(films.windows(2).map(|w| w[1] / w[0] - 1.0).collect())
    });
    /// Of a curve: largest traction coefficient at mid-film.
    MostTraction, "most-traction", "largest traction coefficient", Number,
        Sources::curve(|curve| largest(values_of(curve, Figure::TractionCoefficient)?));
    /// Of a curve: largest ratio of the traction to that without shear thinning, where surfaces slide.
    MostTractionRatio, "most-traction-ratio", "largest traction/Newtonian", Share,
        Sources::curve(most_traction_ratio);
    /// Of a curve: largest relative change of the largest pressure from the first point.
    PressureChange, "pressure-change", "largest change of max p", Share, Sources::curve(|curve| {
        let pressures = values_of(curve, Figure::PressureMaximum)?;
        let first = *pressures.first()?;
        largest(pressures.iter().map(|p| (p / first - 1.0).abs()).collect())
    });
    /// In time: A_d/A_i of waves at the end, what the film in the centre keeps of their amplitude.
    AmplitudeRatio, "amplitude-ratio", "A_d/A_i", Number,
        Sources::transient(|found| *found.amplitude_ratios.last()?);
    /// In time: film thickness on the centreline at a place and an instant, m.
    FilmAt, "film-at", "film at a place", Number, Sources::NONE;
}

impl Quantity {
    /// Whether it is a share, shown in per cent.
    pub fn is_share(self) -> bool {
        self.format() == Format::Share
    }

    /// Whether it counts something.
    pub fn is_count(self) -> bool {
        self.format() == Format::Count
    }

    /// Value in the outcome of a run, `None` where it has no such figure; `other` is the run that
    /// differences are taken from. Figures of a contact over time are those at the end.
    pub fn value(self, run: &Run, outcome: &Outcome, other: Option<&Outcome>) -> Option<f64> {
        let sources = self.sources();
        match (outcome, self) {
            (Outcome::Solved(s), Quantity::Figure(figure)) => Some(s.figure(figure)?.value),
            (Outcome::Solved(s), _) => sources.solution?(s),
            (Outcome::Deflected(d), _) => sources.deflection?(run, d, other),
            (Outcome::Curve(curve), _) => sources.curve?(curve),
            (Outcome::Transient(found), Quantity::Figure(figure)) => {
                Some(found.instants.last()?.measured.estimate(figure).value)
            }
            (Outcome::Transient(found), _) => sources.transient?(found),
            (Outcome::Failed(_) | Outcome::Skipped, _) => None,
        }
    }
}

fn side_pressure(s: &Solution) -> Option<f64> {
    let factor = 1.0 / s.scales.pressure;
    mean(
        &pictures::profile_across(s, &s.elements.pressure, factor),
        SIDE,
    )
}

fn pressure_oscillation(s: &Solution) -> Option<f64> {
    let line = &s.centreline;
    let places = line.x.iter().zip(&line.pressure);
    let inner = places
        .filter(|(x, _)| x.abs() <= OSCILLATION_ZONE * s.scales.length)
        .map(|(_, p)| p / s.scales.pressure);
    Some(oscillation(&inner.collect::<Vec<_>>()))
}

fn outlet_cooling(s: &Solution) -> Option<f64> {
    let line = &s.thermal.as_ref()?.centreline;
    let below = |i: usize| 0.5 * (line.body_1[i] + line.body_2[i]) - line.mid[i];
    (s.centreline.x.iter().enumerate())
        .filter(|(_, x)| OUTLET.contains(&(*x / s.scales.length)))
        .map(|(i, _)| below(i))
        .reduce(f64::max)
}

fn largest(list: Vec<f64>) -> Option<f64> {
    list.into_iter().reduce(f64::max)
}

/// A figure of every point, `None` where a point does not have it.
fn values_of(curve: &CurveSolution, figure: Figure) -> Option<Vec<f64>> {
    let value = |p: &PointSolution| Some(p.outcome.solution()?.figure(figure)?.value);
    curve.points.iter().map(value).collect()
}

/// Reductions of the central film by shear thinning at every point.
fn reductions(curve: &CurveSolution) -> Option<Vec<f64>> {
    let reduction = |p: &PointSolution| Some(p.film_reduction()?.central.value);
    curve.points.iter().map(reduction).collect()
}

fn most_traction_ratio(curve: &CurveSolution) -> Option<f64> {
    let coefficient = |s: &Solution| s.traction.coefficient.value;
    let sliding = curve.points.iter().filter(|p| p.case.motion.slides());
    let ratios: Option<Vec<f64>> = sliding
        .map(|p| Some(coefficient(p.outcome.solution()?) / coefficient(p.newtonian_solution()?)))
        .collect();
    largest(ratios?)
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
