//! Estimates of a case without a solve.

mod regime;

use serde::Serialize;

pub use crate::plausible::inertia::{
    CRITICAL_REYNOLDS, FilmReynolds, NEGLIGIBLE_INERTIA, film_reynolds,
};
pub use regime::{Regime, RegimeEstimate, regime};

use crate::case::Case;
use crate::contact::{ContactKind, Family, Groups, Hertz};
use crate::plausible::heat::inlet_heat;
use crate::plausible::neglected::{self, Known};
use crate::plausible::{smallest_radius, thick_film};
use crate::post::limits::thin_film_warning;
use crate::reference::biboulet_houpert::rolling_resistance;
use crate::reference::thermal::ThermalReduction;
use crate::reference::{FilmFormula, film_formulas};
use crate::run::{estimated_film, groups};
use crate::solution::{FormulaFilm, Neglected};
use crate::solution::{Separation, roughness_warning};
use crate::warning::{Warning, WarningKind, silence};

/// Estimates of a case, SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CaseEstimate {
    /// Line or circular.
    pub kind: ContactKind,
    /// The dry contact.
    pub hertz: Hertz,
    /// Reduced modulus E', Pa.
    pub reduced_modulus: f64,
    /// Groups with the initial slope of ln μ(p) as pressure-viscosity coefficient.
    pub groups: Groups,
    /// Groups with the reciprocal asymptotic isoviscous coefficient α*, where it exists.
    pub groups_asymptotic: Option<Groups>,
    /// Parameters of regime charts.
    pub chart: ChartParameters,
    /// Lubrication regime.
    pub regime: RegimeEstimate,
    /// Film-thickness formulas.
    pub formulas: Vec<FormulaFilm>,
    /// The same with α*, where it exists.
    pub formulas_asymptotic: Option<Vec<FormulaFilm>>,
    /// Whether the lubricant is shear-thinning, which no formula here includes.
    pub newtonian_only: bool,
    /// Film used in the other estimates.
    pub film: FilmEstimate,
    /// Rolling resistance of each surface after Biboulet and Houpert, N (N/m of a line), where their formulas reach.
    pub rolling_resistance: Option<f64>,
    /// Reynolds numbers.
    pub reynolds: FilmReynolds,
    /// Heating of the inlet.
    pub thermal: ThermalEstimate,
    /// Effects that a solve of the case would neglect; without frictional heat, which no formula here includes.
    pub left_out: Neglected,
    /// Film over roughness, if a roughness is given.
    pub lambda: Option<LambdaRatio>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

/// Hamrock and Dowson's parameters of regime charts: g_V = G W³/U² and, for circular contacts, g_E = W^(8/3)/U².
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ChartParameters {
    /// g_V, `None` for line contacts, whose parameters are defined otherwise.
    pub viscosity_parameter: Option<f64>,
    /// g_E, likewise.
    pub elasticity_parameter: Option<f64>,
}

/// Films from one central and one minimum formula.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FilmEstimate {
    /// Central film, m, of the formula that holds in all regimes.
    #[serde(rename = "film_central")]
    pub central: f64,
    /// Which.
    pub central_formula: &'static str,
    /// Minimum film, m, where a formula for it applies: those at hand are for piezoviscous contacts.
    #[serde(rename = "film_minimum")]
    pub minimum: Option<f64>,
    /// Which.
    pub minimum_formula: Option<&'static str>,
}

/// Reduction of the film by the heat of shear in the inlet.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThermalEstimate {
    /// β = −d ln μ/dT at ambient pressure, 1/K.
    pub temperature_coefficient: f64,
    /// L_T = μ₀ β u_m²/k; `None` without conductivity k or with a viscosity that does not fall with temperature.
    pub loading: Option<f64>,
    /// Factors by which to multiply the isothermal films.
    pub factors: Vec<ThermalFactor>,
    /// The recommended one, applied to the films; `None` where there is none.
    pub recommended: Option<HeatedFilm>,
    /// Why there are none.
    pub missing: Option<&'static str>,
}

/// Films with the heat of the inlet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HeatedFilm {
    /// Whose factor it is.
    pub name: &'static str,
    /// Thermal film over isothermal film.
    pub factor: f64,
    /// Central film, m.
    #[serde(rename = "film_central")]
    pub central: f64,
    /// Minimum film, m, where there is an isothermal one.
    #[serde(rename = "film_minimum")]
    pub minimum: Option<f64>,
    /// Largest difference of another published factor, over this one.
    pub difference: f64,
    /// Whether the published factors agree, within [`ThermalReduction::LARGEST_DIFFERENCE`].
    pub in_range: bool,
}

/// One published reduction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ThermalFactor {
    /// Name.
    pub name: &'static str,
    /// Thermal film over isothermal film.
    pub factor: f64,
    /// Source and status.
    pub source: &'static str,
}

/// Film over composite rms roughness.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LambdaRatio {
    /// h_c/σ.
    #[serde(rename = "lambda_central")]
    pub of_central: f64,
    /// h_min/σ.
    #[serde(rename = "lambda_minimum")]
    pub of_minimum: Option<f64>,
    /// By the minimum film, or the central one where there is no other.
    pub separation: Separation,
    /// Share of the load on asperities if the film had its central thickness all over the dry contact;
    /// `None` where the case does not describe them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asperity_load_share: Option<f64>,
}

/// Estimates from formulas; calls no solver.
pub fn estimate(case: &Case) -> CaseEstimate {
    let (contact, lubricant) = (&case.contact, &case.lubricant);
    let (hertz, modulus) = (case.hertz(), case.reduced_modulus());
    let temperature = lubricant.temperature;
    let slope = lubricant.viscosity.pressure_viscosity_slope(temperature);
    let asymptotic = (lubricant.viscosity)
        .pressure_viscosity_reciprocal_asymptotic(temperature)
        .ok();
    let g = groups(case, slope);
    let groups_asymptotic = asymptotic.map(|alpha| groups(case, alpha));
    let density = case.relative_density();
    let formulas = |g: &Groups| film_formulas(contact, g, density);
    let mut regime = regime(contact, &g);
    // The film that they blend into is divided by the relative density at the Hertz pressure, too.
    regime.films = regime.films.map(|film| film / density);
    let film = film(case, &g, regime.regime);
    let mut estimate = CaseEstimate {
        kind: contact.kind,
        hertz,
        reduced_modulus: modulus,
        chart: chart(contact.kind.family(), &g),
        regime,
        formulas: formulas(&g),
        formulas_asymptotic: groups_asymptotic.as_ref().map(formulas),
        rolling_resistance: rolling_resistance(contact, &hertz, &g, modulus),
        groups: g,
        groups_asymptotic,
        newtonian_only: case.shear_thinning().is_some(),
        film,
        reynolds: neglected::reynolds(case, film.central),
        thermal: thermal(case, hertz.pressure / modulus, &film),
        left_out: neglected::neglected(
            case,
            &Known {
                film_central: film.central,
                film_minimum: film.minimum.unwrap_or(film.central),
                friction_power: 0.0,
            },
        ),
        lambda: case.roughness.map(|sigma| LambdaRatio {
            of_central: film.central / sigma,
            of_minimum: film.minimum.map(|h| h / sigma),
            separation: Separation::of(film.minimum.unwrap_or(film.central) / sigma),
            asperity_load_share: case.asperities.as_ref().map(|asperities| {
                let pressure = asperities.pressure(film.central / sigma, sigma, modulus);
                pressure * hertz.area(contact) / contact.load
            }),
        }),
        warnings: case.warnings.clone(),
    };
    let new = warnings(case, &estimate);
    estimate.warnings.extend(new);
    silence(&mut estimate.warnings, &case.output.silence);
    estimate
}

/// Films of one central and one minimum formula.
pub fn films(case: &Case) -> FilmEstimate {
    let temperature = case.lubricant.temperature;
    let groups = groups(
        case,
        (case.lubricant.viscosity).pressure_viscosity_slope(temperature),
    );
    film(case, &groups, regime(&case.contact, &groups).regime)
}

fn chart(family: Family, groups: &Groups) -> ChartParameters {
    let (w, u, g) = (groups.load, groups.speed, groups.material);
    let circular = |value: f64| (family == Family::Point).then_some(value);
    ChartParameters {
        viscosity_parameter: circular(g * w.powi(3) / (u * u)),
        elasticity_parameter: circular(w.powf(8.0 / 3.0) / (u * u)),
    }
}

/// Films of the formula that holds in all regimes, and of the usual one for the minimum. A lubricant that thins
/// with pressure counts as isoviscous in the first. The formulas for the minimum are for piezoviscous contacts; of
/// isoviscous ones they make films that are far too thin.
fn film(case: &Case, groups: &Groups, regime: Regime) -> FilmEstimate {
    let (central, minimum) = match case.contact.kind.family() {
        Family::Point => (
            FilmFormula::NijenbanningVennerMoes,
            FilmFormula::HamrockDowson,
        ),
        Family::Cylinder => (FilmFormula::MoesLine, FilmFormula::DowsonHigginson),
    };
    let isoviscous = matches!(regime, Regime::IsoviscousRigid | Regime::IsoviscousElastic);
    let minimum_film = (minimum.film(&case.contact, groups).1)
        .filter(|_| !isoviscous && minimum.applies(&case.contact));
    FilmEstimate {
        central: estimated_film(case),
        central_formula: central.name(),
        minimum: minimum_film,
        minimum_formula: minimum_film.map(|_| minimum.name()),
    }
}

fn thermal(case: &Case, pressure_over_modulus: f64, film: &FilmEstimate) -> ThermalEstimate {
    let inlet = inlet_heat(case);
    let mut estimate = ThermalEstimate {
        temperature_coefficient: inlet.temperature_coefficient,
        loading: inlet.loading.ok(),
        factors: Vec::new(),
        recommended: None,
        missing: inlet.loading.err(),
    };
    let Ok(loading) = inlet.loading else {
        return estimate;
    };
    let ratio = case.motion.sliding_at_centre();
    estimate.factors = ThermalReduction::ALL
        .into_iter()
        .filter_map(|formula| {
            Some(ThermalFactor {
                name: formula.name(),
                factor: formula.factor(loading, pressure_over_modulus, ratio)?,
                source: formula.source(),
            })
        })
        .collect();
    estimate.recommended = inlet.factor(case).map(|factor| {
        let others = estimate.factors.iter();
        let difference = others
            .map(|other| (other.factor / factor - 1.0).abs())
            .fold(0.0, f64::max);
        HeatedFilm {
            name: ThermalReduction::RECOMMENDED.name(),
            factor,
            central: factor * film.central,
            minimum: film.minimum.map(|h| factor * h),
            difference,
            in_range: difference <= ThermalReduction::LARGEST_DIFFERENCE,
        }
    });
    estimate
}

fn warnings(case: &Case, estimate: &CaseEstimate) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if case.curve.is_some() {
        warnings.push(Warning::new(
            WarningKind::EstimateScope,
            "the estimates apply to the case itself, not to the points of its [curve]",
        ));
    }
    if case.supply.is_limited() {
        warnings.push(Warning::new(
            WarningKind::EstimateScope,
            "[inlet] limits the oil that reaches the contact; all film formulas and estimates are those of a flooded one, and \
             films may be thinner: `ertel solve` computes them",
        ));
    }
    if estimate.newtonian_only {
        warnings.push(Warning::new(
            WarningKind::EstimateScope,
            "shear thinning is not in these formulas, which take the low-shear viscosity: films may be thinner",
        ));
    }
    warnings.extend(neglected::warnings(
        case,
        estimate.film.central,
        &estimate.left_out,
    ));
    if neglected::squeeze(case).is_some() {
        let text = "the film formulas use the speeds of [motion], but the surfaces are at rest in [transient]: squeeze alone forms the film";
        warnings.push(Warning::new(WarningKind::EstimateScope, text));
        return warnings;
    }
    let (name, thickness) = match estimate.film.minimum {
        Some(minimum) => ("the estimated minimum film thickness", minimum),
        None => (
            "the estimated central film thickness",
            estimate.film.central,
        ),
    };
    warnings.extend(thin_film_warning(name, thickness));
    warnings.extend(thick_film(name, thickness, smallest_radius(case)));
    // With asperities the surfaces are not smooth: their share of the load is compared below.
    let smooth = case.roughness.filter(|_| case.asperities.is_none());
    warnings.extend(smooth.and_then(|sigma| roughness_warning(name, thickness, sigma)));
    if let Some(lambda) = &estimate.lambda {
        warnings.extend(lambda.asperity_load_share.and_then(share_warning));
    }
    warnings
}

/// Share of the load on asperities above which they lift the surfaces off the film of smooth ones.
const SMALL_SHARE: f64 = 0.1;

/// Warns if the asperities change the estimated film.
fn share_warning(share: f64) -> Option<Warning> {
    let text = format!(
        "at the estimated film, that of smooth surfaces, the asperities would carry {:.0} % of the load: the surfaces stay further apart (a solve shares the \
         load between oil and asperities)",
        100.0 * share
    );
    (share > SMALL_SHARE).then(|| Warning::beyond(WarningKind::AsperityLoad, share, text))
}

#[cfg(test)]
mod tests;
