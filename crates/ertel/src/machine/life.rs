//! Rating lives of a bearing.
//!
//! ```text
//!   κ = ν/ν_1     L_nmr = a_1 a_ISO L_10r     time = 2π L/ω
//! ```
//! Sources: ISO 281:2007, ISO/TS 16281:2008.

use std::f64::consts::TAU;

use ertel_machines::bearing::geometry::{BallGeometry, Ring};
use ertel_machines::bearing::{Geometry, Material, life};

use super::collected::Collected;
use crate::case::{BearingMechanics, Case, Contamination, RatingBasis};
use crate::figures::bearing::{
    BASIC_RATING_LIFE, BASIC_RATING_LIFE_TIME, CONTAMINATION_FACTOR, DYNAMIC_LOAD_RATING,
    EQUIVALENT_LOAD, FATIGUE_LOAD_LIMIT, KAPPA, LIFE_FACTOR, MODIFIED_RATING_LIFE,
    MODIFIED_RATING_LIFE_TIME, REFERENCE_EQUIVALENT_LOAD, REFERENCE_RATING_LIFE,
    REFERENCE_RATING_LIFE_TIME, RELIABILITY_FACTOR, STATIC_LOAD_RATING, STATIC_SAFETY_FACTOR,
};
use crate::figures::{Definition, Row};
use crate::mark::Marked;
use crate::solution::Estimate;
use crate::warning::{Warning, WarningKind};

/// Contact angle (deg) above which X_0 and Y_0 are those of steep angular contact bearings, halfway from 15 degrees to the 40 of the suffix B.
const MIN_STEEP_CONTACT_ANGLE: f64 = 27.5;

/// Ratings, loads and lives; values outside the range of a standard are omitted with a warning.
pub(super) fn figures(
    case: &Case,
    mechanics: &BearingMechanics,
    warnings: &mut Vec<Warning>,
) -> Vec<Row> {
    let mut out = Collected::default();
    if let Err(error) = collect(case, mechanics, &mut out) {
        warnings.push(Warning::new(
            WarningKind::RatingRange,
            format!("no further rating lives: {error}"),
        ));
    }
    warnings.append(&mut out.warnings);
    out.figures
}

const ISO_281: &str = "ISO 281:2007; ISO 76 for C_0";
const WIDE_GROOVES: &str = "ISO 281:2007, ISO 76; grooves wider than their 0.52 and 0.53 reduce C as in the formula of Lundberg and Palmgren, C_0 by the load under one Hertz pressure";
const ISO_16281: &str = "L_10r (ISO/TS 16281:2008) counts the load of each ball on each ring, with clearance, contact angles and inertia; L_10 takes P, for which half of the balls carry, as without clearance: the two differ";
const ISO_16281_ROLLERS: &str = "L_10r (ISO/TS 16281:2008) counts the load of each slice of each roller on each ring, pressure at the ends by its eq. 60, and depends on the fourth power of the load; L_10 takes P with the power 10/3: the two differ, most under light loads";
const CATALOGUE: &str = "C and C_0 of the catalogue: NSK, Rolling Bearings, E1102e; those of other makers differ, give `dynamic_load_rating` and `static_load_rating`";
const GIVEN: &str = "C and C_0 as given";
const GIVEN_LIMIT: &str = "C_u as given";
const ESTIMATED: &str = "C and C_0: ISO 281:2007, ISO 76, of dimensions that are estimated; ± by which such ratings miss those of NSK's catalogue (twice the root mean square of the series), in all that follows from them. Give `dynamic_load_rating` and `static_load_rating` of the maker";
const SIMPLE_LIMIT: &str = "C_u by C_0 (ISO 281:2007, annex B, simple method)";

/// A rating and how it is known.
struct Rating {
    value: f64,
    /// Relative error; 0 where none is known of.
    error: f64,
    source: &'static str,
}

impl Rating {
    fn estimate(&self) -> Estimate {
        with_error(self.value, self.error)
    }
}

/// A value and its relative error, if any.
fn with_error(value: f64, relative: f64) -> Estimate {
    Estimate {
        value,
        error: (relative > 0.0).then_some(value * relative),
    }
}

/// C (0) or C_0 (1), in this order: given, of the catalogue, computed.
fn rating(
    mechanics: &BearingMechanics,
    which: usize,
    computed: impl FnOnce() -> Result<f64, life::Error>,
) -> Result<Rating, life::Error> {
    let inputs = &mechanics.life;
    let known = |value, error, source| {
        Ok(Rating {
            value,
            error,
            source,
        })
    };
    match (
        [inputs.dynamic_rating, inputs.static_rating][which],
        mechanics.ratings,
    ) {
        (Some(value), _) => known(value, 0.0, GIVEN),
        (None, RatingBasis::Catalogue(ratings)) => known(ratings[which], 0.0, CATALOGUE),
        (None, RatingBasis::Estimated(error)) => known(computed()?, error, ESTIMATED),
        (None, RatingBasis::Geometry) => match &mechanics.bearing.geometry {
            Geometry::Ball(ball) if life::has_wide_grooves(ball) => {
                known(computed()?, 0.0, WIDE_GROOVES)
            }
            _ => known(computed()?, 0.0, ISO_281),
        },
    }
}

/// Data of a bearing for ISO 281 and ISO 76.
enum Rated<'a> {
    Balls {
        geometry: &'a BallGeometry,
        nominal: f64,
    },
    Rollers(life::RollerRow),
}

impl<'a> Rated<'a> {
    fn of(mechanics: &'a BearingMechanics) -> Rated<'a> {
        match &mechanics.bearing.geometry {
            Geometry::Ball(geometry) => Rated::Balls {
                geometry,
                nominal: life::nominal_angle(&mechanics.bearing.geometry, mechanics.series()),
            },
            Geometry::CylindricalRoller(roller) => Rated::Rollers(roller.into()),
            Geometry::TaperedRoller(roller) => Rated::Rollers(roller.into()),
        }
    }

    fn kind(&self) -> life::Kind {
        match self {
            Rated::Balls { .. } => life::Kind::Ball,
            Rated::Rollers(_) => life::Kind::Roller,
        }
    }

    fn exponent(&self) -> f64 {
        match self {
            Rated::Balls { .. } => life::BALL_EXPONENT,
            Rated::Rollers(_) => life::ROLLER_EXPONENT,
        }
    }

    fn dynamic_rating(&self) -> Result<f64, life::Error> {
        match self {
            Rated::Balls { geometry, nominal } => life::ball_rating(geometry, *nominal),
            Rated::Rollers(row) => life::roller_rating(row),
        }
    }

    fn static_rating(&self) -> Result<f64, life::Error> {
        match self {
            Rated::Balls { geometry, nominal } => {
                life::deep_groove_static_rating(geometry, *nominal)
            }
            Rated::Rollers(row) => Ok(life::roller_static_rating(row)),
        }
    }

    fn equivalent_load(&self, [radial, axial]: [f64; 2]) -> Result<f64, life::Error> {
        match self {
            Rated::Balls { geometry, nominal } => {
                life::dynamic_equivalent_load(geometry, *nominal, radial, axial)
            }
            Rated::Rollers(row) => life::roller_equivalent_load(row, radial, axial),
        }
    }

    fn static_equivalent_load(&self, [radial, axial]: [f64; 2]) -> Result<f64, life::Error> {
        let factors = match self {
            Rated::Balls { nominal, .. } if nominal.to_degrees() > MIN_STEEP_CONTACT_ANGLE => {
                [0.5, 0.26]
            }
            Rated::Balls { .. } => [0.6, 0.5],
            Rated::Rollers(row) if row.angle > 0.0 => life::roller_static_factors(row.angle)?,
            Rated::Rollers(_) => [1.0, 0.0],
        };
        Ok(life::static_equivalent_load(factors, radial, axial))
    }

    fn reference_life(
        &self,
        mechanics: &BearingMechanics,
        rating: f64,
    ) -> Result<life::ReferenceLife, life::Error> {
        // The load is stationary: a rotating ring turns relative to it. At rest, the inner ring counts as rotating.
        let speeds = mechanics.speeds;
        let turning = [
            speeds.inner != 0.0 || speeds.outer == 0.0,
            speeds.outer != 0.0,
        ];
        let found = &mechanics.distribution;
        match self {
            Rated::Balls { geometry, nominal } => {
                let [inner, outer] = Ring::BOTH.map(|ring| found.loads(ring));
                life::reference_life(geometry, *nominal, rating, [&inner, &outer], turning)
            }
            Rated::Rollers(row) => {
                let [inner, outer] = Ring::BOTH.map(|ring| found.slice_loads(ring));
                life::roller_reference_life(row, rating, [&inner, &outer], turning)
            }
        }
    }

    /// C_u, its relative error and source: by the contacts of balls under the standard's modulus, else by the static rating.
    fn fatigue_limit(
        &self,
        mechanics: &BearingMechanics,
        fixed: &Rating,
    ) -> Result<Rating, life::Error> {
        let is_known = mechanics.ratings == RatingBasis::Geometry;
        let (value, source) = match self {
            Rated::Balls { geometry, nominal } if is_known || fixed.error > 0.0 => (
                life::fatigue_limit(geometry, Material::STEEL, *nominal),
                ISO_281,
            ),
            _ => {
                let pitch = mechanics.bearing.geometry.pitch_diameter();
                (
                    life::simple_fatigue_limit(self.kind(), fixed.value, pitch)?,
                    SIMPLE_LIMIT,
                )
            }
        };
        Ok(Rating {
            value,
            error: fixed.error,
            source,
        })
    }
}

fn collect(
    case: &Case,
    mechanics: &BearingMechanics,
    out: &mut Collected,
) -> Result<(), life::Error> {
    let inputs = &mechanics.life;
    let pitch = mechanics.bearing.geometry.pitch_diameter();
    let relative = mechanics.speeds.relative().abs();
    let lubricant = &case.lubricant;
    let viscosity = lubricant.ambient_viscosity() / lubricant.ambient_density();
    let kappa = match relative > 0.0 {
        true => {
            let kappa = life::viscosity_ratio(viscosity, relative, pitch)?;
            out.add(KAPPA, kappa, ISO_281);
            Some(kappa)
        }
        false => None,
    };
    let rated = Rated::of(mechanics);
    let dynamic = rating(mechanics, 0, || rated.dynamic_rating())?;
    out.add(DYNAMIC_LOAD_RATING, dynamic.estimate(), dynamic.source);
    let equivalent = rated.equivalent_load(mechanics.loads)?;
    out.add(EQUIVALENT_LOAD, equivalent, ISO_281);
    let basic = life::basic_life(dynamic.value, equivalent, rated.exponent())?;
    // A life is proportional to C^p: the upper bound of its bar.
    let of_rating = (1.0 + dynamic.error).powf(rated.exponent()) - 1.0;
    lives(out, BASIC, with_error(basic, of_rating), relative, ISO_281);
    let fixed = rating(mechanics, 1, || rated.static_rating());
    // Ratings of some geometries are beyond the tables of ISO 76: the life goes on without them.
    let fixed = fixed.ok();
    if let Some(fixed) = &fixed {
        out.add(STATIC_LOAD_RATING, fixed.estimate(), fixed.source);
        let load = rated.static_equivalent_load(mechanics.loads)?;
        static_safety(out, fixed, load);
        super::moments::add(mechanics, viscosity, [fixed.value, load], out);
    }
    let reference = rated.reference_life(mechanics, dynamic.value)?;
    let source = match rated {
        Rated::Balls { .. } => ISO_16281,
        Rated::Rollers(_) => ISO_16281_ROLLERS,
    };
    let life = with_error(reference.life, of_rating);
    lives(out, REFERENCE, life, relative, source);
    out.add(REFERENCE_EQUIVALENT_LOAD, reference.equivalent_load, source);
    let limit = match (inputs.fatigue_limit, &fixed) {
        (Some(value), _) => Some(Rating {
            value,
            error: 0.0,
            source: GIVEN_LIMIT,
        }),
        (None, Some(fixed)) => Some(rated.fatigue_limit(mechanics, fixed)?),
        (None, None) => None,
    };
    if let Some(limit) = &limit {
        out.add(FATIGUE_LOAD_LIMIT, limit.estimate(), limit.source);
    }
    let (Some(limit), Some(kappa), Some(contamination)) = (limit, kappa, inputs.contamination)
    else {
        if inputs.contamination.is_none() {
            out.warn(WarningKind::MissingData, "no modified rating life: give `cleanliness`, or `contamination_factor` e_C from 0 to 1 (ISO 281, annex A)");
        }
        return Ok(());
    };
    let (factor, source) = contamination_factor(mechanics, contamination, kappa)?;
    out.add(CONTAMINATION_FACTOR, factor, source);
    let oil = life::Lubrication {
        viscosity_ratio: kappa,
        contamination: factor,
        additives: inputs.additives,
    };
    let load = reference.equivalent_load;
    let factor_of = |limit: f64| life::life_factor(rated.kind(), oil, limit, load);
    let a_iso = factor_of(limit.value)?;
    let high = factor_of(limit.value * (1.0 + limit.error))?;
    out.add(LIFE_FACTOR, with_error(a_iso, high / a_iso - 1.0), ISO_281);
    let a_1 = life::reliability_factor(inputs.reliability.unwrap_or(90.0))?;
    out.add(RELIABILITY_FACTOR, a_1, ISO_281);
    let modified = life::modified_life(reference.life, a_1, a_iso);
    let error = (1.0 + of_rating) * high / a_iso - 1.0;
    lives(
        out,
        MODIFIED,
        with_error(modified, error),
        relative,
        "L_nmr = a_1 a_ISO(P_ref) L_10r",
    );
    Ok(())
}

/// e_C and where it comes from.
fn contamination_factor(
    mechanics: &BearingMechanics,
    contamination: Contamination,
    kappa: f64,
) -> Result<(f64, &'static str), life::Error> {
    let pitch = mechanics.bearing.geometry.pitch_diameter();
    Ok(match contamination {
        Contamination::Factor(factor) => (factor, ISO_281),
        Contamination::Grease(class) => (life::contamination_factor(class, kappa, pitch)?, ISO_281),
        Contamination::Guide(class) => {
            let mean = (mechanics.entry.as_ref()).map_or(pitch, |e| e.boundary.mean_diameter());
            let [low, high] = life::contamination_guide(class, mean)?;
            (
                0.5 * (low + high),
                "e_C: the middle of the guide values for this cleanliness (ISO 281, table 13)",
            )
        }
    })
}

/// C_0/P_0, with a warning of damage where it is too low.
fn static_safety(out: &mut Collected, rating: &Rating, load: f64) {
    let safety = rating.value / load;
    out.add(
        STATIC_SAFETY_FACTOR,
        with_error(safety, rating.error),
        "static safety: ISO 76",
    );
    if safety < 1.0 {
        out.warnings.push(Warning::new(
            WarningKind::Strength,
            format!(
                "the static equivalent load of {load:.0} N exceeds the static rating of {:.0} N: the raceways are permanently indented",
                rating.value
            ),
        ));
    }
}

/// A life in revolutions, and the same in time.
type Lives = [Definition; 2];

const BASIC: Lives = [BASIC_RATING_LIFE, BASIC_RATING_LIFE_TIME];
const REFERENCE: Lives = [REFERENCE_RATING_LIFE, REFERENCE_RATING_LIFE_TIME];
const MODIFIED: Lives = [MODIFIED_RATING_LIFE, MODIFIED_RATING_LIFE_TIME];

/// A life, given in revolutions, in revolutions and in time.
fn lives(
    out: &mut Collected,
    [in_turns, in_time]: Lives,
    life: Estimate,
    speed: f64,
    source: &'static str,
) {
    let life = Marked::from(life);
    out.add(in_turns, life * 1e-6, source);
    if speed > 0.0 {
        out.add(in_time, life * (TAU / speed), source);
    }
}

#[cfg(test)]
#[path = "life_tests.rs"]
mod tests;
