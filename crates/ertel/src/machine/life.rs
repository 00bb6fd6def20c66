//! Rating lives of a bearing.
//!
//! ```text
//!   κ = ν/ν_1     L_nmr = a_1 a_ISO L_10r     time = 2π L/ω
//! ```
//! Sources: ISO 281:2007, ISO/TS 16281:2008.

use std::f64::consts::TAU;

use ertel_machines::bearing::catalogue::Series;
use ertel_machines::bearing::geometry::{BallGeometry, Play, Ring};
use ertel_machines::bearing::{Geometry, life};

use super::{MachineFigure, Section};
use crate::case::{BearingMechanics, Case, Contamination};
use crate::mark::Marked;
use crate::warning::{Warning, WarningKind};

/// Degrees from which on X_0 and Y_0 are those of steep angular contact bearings, halfway from 15 degrees to the 40 of the suffix B.
const STEEP: f64 = 27.5;

/// The nominal contact angle that ratings take, rad: that of the series; else 0 of deep groove ball bearings, whose free angle comes from their clearance.
fn nominal_angle(mechanics: &BearingMechanics, geometry: &BallGeometry) -> f64 {
    let series = mechanics
        .entry
        .as_ref()
        .map(|entry| entry.designation.series);
    let of_series = series.and_then(Series::nominal_angle);
    of_series.unwrap_or(match geometry.play {
        Play::FreeAngle(angle) => angle,
        Play::Clearance(_) => 0.0,
    })
}

/// Ratings, loads and lives; what is out of the range of a norm is left out and told.
pub(super) fn figures(
    case: &Case,
    mechanics: &BearingMechanics,
    warnings: &mut Vec<Warning>,
) -> Vec<MachineFigure> {
    let mut out = Collected::default();
    if let Err(error) = collect(case, mechanics, &mut out) {
        warnings.push(Warning::new(
            WarningKind::RatingRange,
            format!("the rating life ends here: {error}"),
        ));
    }
    warnings.append(&mut out.warnings);
    out.figures
}

/// What was found so far.
#[derive(Default)]
pub(super) struct Collected {
    figures: Vec<MachineFigure>,
    warnings: Vec<Warning>,
}

impl Collected {
    pub(super) fn add(
        &mut self,
        section: Section,
        (name, words): (&'static str, &'static str),
        value: f64,
        unit: &'static str,
        source: &'static str,
    ) {
        self.figures.push(MachineFigure {
            name,
            words,
            estimate: Marked::exact(value),
            unit,
            section,
            source,
        });
    }
}

const ISO_281: &str = "ISO 281:2007; ISO 76 for C_0";
const ISO_16281: &str = "ISO/TS 16281:2008: L_10r by the load of each element on each ring";
const ISO_16281_ROLLERS: &str = "ISO/TS 16281:2008: L_10r by the load of each slice of each roller on each ring, pressure at the ends by its eq. 60";
const CATALOGUE: &str = "C and C_0 of the catalogue: NSK, Rolling Bearings, E1102";
const GIVEN: &str = "C and C_0 as given";

/// A rating and how it is known.
struct Rating {
    value: f64,
    source: &'static str,
}

/// C, in this order: given, of the catalogue, computed; likewise C_0.
fn rating(
    given: Option<f64>,
    published: Option<f64>,
    computed: impl FnOnce() -> Result<f64, life::Error>,
) -> Result<Rating, life::Error> {
    let known = |value, source| Ok(Rating { value, source });
    match (given, published) {
        (Some(value), _) => known(value, GIVEN),
        (None, Some(value)) => known(value, CATALOGUE),
        (None, None) => known(computed()?, ISO_281),
    }
}

/// What ISO 281 and ISO 76 take of a bearing.
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
                nominal: nominal_angle(mechanics, geometry),
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
            Rated::Balls { nominal, .. } if nominal.to_degrees() > STEEP => [0.5, 0.26],
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
        let turning = match mechanics.speeds.inner != 0.0 {
            true => Ring::Inner,
            false => Ring::Outer,
        };
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

    /// C_u by the contacts of balls, and by the static rating of rollers.
    fn fatigue_limit(
        &self,
        mechanics: &BearingMechanics,
        static_rating: f64,
    ) -> Result<f64, life::Error> {
        let bearing = &mechanics.bearing;
        match self {
            Rated::Balls { geometry, nominal } => {
                Ok(life::fatigue_limit(geometry, bearing.material, *nominal))
            }
            Rated::Rollers(row) => {
                life::simple_fatigue_limit(self.kind(), static_rating, row.pitch_diameter)
            }
        }
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
            out.add(
                Section::Life,
                ("kappa", "viscosity ratio κ"),
                kappa,
                "",
                ISO_281,
            );
            Some(kappa)
        }
        false => None,
    };
    let rated = Rated::of(mechanics);
    let published = mechanics.entry.as_ref().and_then(|entry| entry.ratings);
    let published = published.map(|ratings| ratings.value);
    let dynamic = rating(inputs.dynamic_rating, published.map(|r| r[0]), || {
        rated.dynamic_rating()
    })?;
    out.add(
        Section::Life,
        ("dynamic_load_rating", "dynamic load rating C"),
        dynamic.value,
        "N",
        dynamic.source,
    );
    let equivalent = rated.equivalent_load(mechanics.loads)?;
    out.add(
        Section::Life,
        ("equivalent_load", "equivalent load P"),
        equivalent,
        "N",
        ISO_281,
    );
    let basic = life::basic_life(dynamic.value, equivalent, rated.exponent())?;
    let keys = ("basic_rating_life", "basic_rating_life_time");
    lives(out, keys, basic, relative);
    let fixed = rating(inputs.static_rating, published.map(|r| r[1]), || {
        rated.static_rating()
    });
    // Ratings of some geometries are beyond the tables of ISO 76: the life goes on without them.
    let fixed = fixed.ok();
    if let Some(fixed) = &fixed {
        out.add(
            Section::Life,
            ("static_load_rating", "static load rating C_0"),
            fixed.value,
            "N",
            fixed.source,
        );
        let load = rated.static_equivalent_load(mechanics.loads)?;
        static_safety(out, fixed.value, load);
        super::moments::add(mechanics, viscosity, [fixed.value, load], out);
    }
    let reference = rated.reference_life(mechanics, dynamic.value)?;
    let source = match rated {
        Rated::Balls { .. } => ISO_16281,
        Rated::Rollers(_) => ISO_16281_ROLLERS,
    };
    let keys = ("reference_rating_life", "reference_rating_life_time");
    lives_of(out, keys, reference.life, relative, source);
    out.add(
        Section::Life,
        (
            "reference_equivalent_load",
            "reference equivalent load P_ref",
        ),
        reference.equivalent_load,
        "N",
        source,
    );
    let limit = match (inputs.fatigue_limit, &fixed) {
        (Some(given), _) => Some(given),
        (None, Some(fixed)) => Some(rated.fatigue_limit(mechanics, fixed.value)?),
        (None, None) => None,
    };
    if let Some(limit) = limit {
        out.add(
            Section::Life,
            ("fatigue_load_limit", "fatigue load limit C_u"),
            limit,
            "N",
            ISO_281,
        );
    }
    let (Some(limit), Some(kappa), Some(contamination)) = (limit, kappa, inputs.contamination)
    else {
        if inputs.contamination.is_none() {
            out.warnings.push(Warning::new(
                WarningKind::MissingData,
                "no modified rating life: give `cleanliness`, or `contamination_factor` e_C from 0 to 1 (ISO 281, annex A)",
            ));
        }
        return Ok(());
    };
    let (factor, source) = contamination_factor(mechanics, contamination, kappa)?;
    out.add(
        Section::Life,
        ("contamination_factor", "contamination factor e_C"),
        factor,
        "",
        source,
    );
    let oil = life::Lubrication {
        viscosity_ratio: kappa,
        contamination: factor,
        additives: inputs.additives,
    };
    let a_iso = life::life_factor(rated.kind(), oil, limit, reference.equivalent_load)?;
    out.add(
        Section::Life,
        ("life_factor", "life factor a_ISO"),
        a_iso,
        "",
        ISO_281,
    );
    let a_1 = life::reliability_factor(inputs.reliability.unwrap_or(90.0))?;
    out.add(
        Section::Life,
        ("reliability_factor", "reliability factor a_1"),
        a_1,
        "",
        ISO_281,
    );
    let modified = life::modified_life(reference.life, a_1, a_iso);
    let keys = ("modified_rating_life", "modified_rating_life_time");
    lives(out, keys, modified, relative);
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

/// C_0/P_0, and what is damaged where it is too low.
fn static_safety(out: &mut Collected, rating: f64, load: f64) {
    let safety = rating / load;
    out.add(
        Section::Safety,
        ("static_safety_factor", "static safety C_0/P_0"),
        safety,
        "",
        "static safety: ISO 76",
    );
    if safety < 1.0 {
        out.warnings.push(Warning::new(
            WarningKind::Strength,
            format!(
                "the static equivalent load of {load:.0} N is beyond the static rating of {rating:.0} N: raceways are dented for good"
            ),
        ));
    }
}

/// A life in revolutions and in time.
fn lives(out: &mut Collected, names: (&'static str, &'static str), life: f64, speed: f64) {
    let source = match names.0 {
        "basic_rating_life" => ISO_281,
        _ => "L_nmr = a_1 a_ISO(P_ref) L_10r",
    };
    lives_of(out, names, life, speed, source);
}

/// The same with its source.
fn lives_of(
    out: &mut Collected,
    (name, time): (&'static str, &'static str),
    life: f64,
    speed: f64,
    source: &'static str,
) {
    let (words, of_time) = match name {
        "basic_rating_life" => ("basic rating life L_10", "  L_10h"),
        "reference_rating_life" => ("reference rating life L_10r", "  L_10rh"),
        _ => ("modified rating life L_nmr", "  L_nmrh"),
    };
    out.add(
        Section::Life,
        (name, words),
        1e-6 * life,
        "million revolutions",
        source,
    );
    if speed > 0.0 {
        out.add(
            Section::Life,
            (time, of_time),
            life * TAU / speed,
            "s",
            source,
        );
    }
}
