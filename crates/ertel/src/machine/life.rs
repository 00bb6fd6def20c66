//! Rating lives of a bearing, and the models of friction that catalogues give, beside what the films say.
//!
//! ```text
//!   κ = ν/ν_1     L_nmr = a_1 a_ISO L_10r     time = 2π L/ω
//! ```
//! Sources: ISO 281:2007, ISO/TS 16281:2008; SKF and Schaeffler catalogues for the moments.

use std::f64::consts::TAU;

use ertel_machines::bearing::catalogue::Series;
use ertel_machines::bearing::friction::{
    PalmgrenOil, PalmgrenSeries, SkfParams, SkfSeries, SkfState, palmgren_load, palmgren_moment,
    skf_moment,
};
use ertel_machines::bearing::geometry::{BallGeometry, Play, Ring};
use ertel_machines::bearing::{Geometry, life};

use super::{MachineFigure, Section};
use crate::case::{BearingMechanics, Case, Contamination};
use crate::solution::Estimate;
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
            WarningKind::Other,
            format!("the rating life ends here: {error}"),
        ));
    }
    warnings.append(&mut out.warnings);
    out.figures
}

/// What was found so far.
#[derive(Default)]
struct Collected {
    figures: Vec<MachineFigure>,
    warnings: Vec<Warning>,
}

impl Collected {
    fn add(
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
            estimate: Estimate { value, error: None },
            unit,
            section,
            source,
        });
    }
}

const ISO_281: &str = "ISO 281:2007; ISO 76 for C_0";
const ISO_16281: &str = "ISO/TS 16281:2008: L_10r by the load of each element on each ring";

fn collect(
    case: &Case,
    mechanics: &BearingMechanics,
    out: &mut Collected,
) -> Result<(), life::Error> {
    let inputs = &mechanics.life;
    let pitch = mechanics.bearing.geometry.pitch_diameter();
    let relative = mechanics.speeds.relative().abs();
    let [radial, axial] = mechanics.loads;
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
    // Rollers: no source of f_c, so the rating must be given.
    let (kind, rating, reference) = match &mechanics.bearing.geometry {
        Geometry::Ball(geometry) => {
            let nominal = nominal_angle(mechanics, geometry);
            let rating = match inputs.dynamic_rating {
                Some(rating) => rating,
                None => life::ball_rating(geometry, nominal)?,
            };
            out.add(
                Section::Life,
                ("dynamic_load_rating", "dynamic load rating C"),
                rating,
                "N",
                ISO_281,
            );
            let equivalent = life::dynamic_equivalent_load(geometry, nominal, radial, axial)?;
            out.add(
                Section::Life,
                ("equivalent_load", "equivalent load P"),
                equivalent,
                "N",
                ISO_281,
            );
            let basic = life::basic_life(rating, equivalent, life::BALL_EXPONENT)?;
            lives(
                out,
                ("basic_rating_life", "basic_rating_life_time"),
                basic,
                relative,
            );
            let turning = match mechanics.speeds.inner != 0.0 {
                true => Ring::Inner,
                false => Ring::Outer,
            };
            let [inner, outer] = Ring::BOTH.map(|ring| mechanics.distribution.loads(ring));
            let found = life::reference_life(geometry, nominal, rating, [&inner, &outer], turning)?;
            (life::Kind::Ball, rating, Some(found))
        }
        Geometry::CylindricalRoller(_) | Geometry::TaperedRoller(_) => {
            match inputs.dynamic_rating {
                Some(rating) => {
                    let basic = life::basic_life(rating, radial, life::ROLLER_EXPONENT)?;
                    lives(
                        out,
                        ("basic_rating_life", "basic_rating_life_time"),
                        basic,
                        relative,
                    );
                    (life::Kind::Roller, rating, None)
                }
                None => {
                    out.warnings.push(Warning::new(
                    WarningKind::Other,
                    "no rating life: the rating of a roller bearing is not computed; give `dynamic_load_rating` of its catalogue",
                ));
                    return Ok(());
                }
            }
        }
    };
    let static_rating = match (&mechanics.bearing.geometry, inputs.static_rating) {
        (_, Some(given)) => Some(given),
        (Geometry::Ball(geometry), None) => {
            life::deep_groove_static_rating(geometry, nominal_angle(mechanics, geometry)).ok()
        }
        (Geometry::CylindricalRoller(_) | Geometry::TaperedRoller(_), None) => None,
    };
    if let Some(static_rating) = static_rating {
        out.add(
            Section::Life,
            ("static_load_rating", "static load rating C_0"),
            static_rating,
            "N",
            ISO_281,
        );
        let is_steep = matches!(&mechanics.bearing.geometry,
            Geometry::Ball(g) if nominal_angle(mechanics, g).to_degrees() > STEEP);
        let factors = match (kind, is_steep) {
            (life::Kind::Roller, _) => [1.0, 0.0],
            (life::Kind::Ball, true) => [0.5, 0.26],
            (life::Kind::Ball, false) => [0.6, 0.5],
        };
        let load = life::static_equivalent_load(factors, radial, axial);
        let safety = static_rating / load;
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
                    "the static equivalent load of {load:.0} N is beyond the static rating of {static_rating:.0} N: raceways are dented for good"
                ),
            ));
        }
        moments(mechanics, viscosity, [static_rating, load], out);
    }
    let (basis, equivalent) = match reference {
        Some(found) => {
            let keys = ("reference_rating_life", "reference_rating_life_time");
            lives(out, keys, found.life, relative);
            out.add(
                Section::Life,
                (
                    "reference_equivalent_load",
                    "reference equivalent load P_ref",
                ),
                found.equivalent_load,
                "N",
                ISO_16281,
            );
            (found.life, found.equivalent_load)
        }
        None => (
            life::basic_life(rating, radial, life::ROLLER_EXPONENT)?,
            radial,
        ),
    };
    let limit = match (
        &mechanics.bearing.geometry,
        inputs.fatigue_limit,
        static_rating,
    ) {
        (_, Some(given), _) => Some(given),
        (Geometry::Ball(geometry), None, _) => Some(life::fatigue_limit(
            geometry,
            mechanics.bearing.material,
            nominal_angle(mechanics, geometry),
        )),
        (_, None, Some(static_rating)) => {
            Some(life::simple_fatigue_limit(kind, static_rating, pitch)?)
        }
        (_, None, None) => None,
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
                WarningKind::Other,
                "no modified rating life: give `contamination_factor` e_C from 0 to 1 (ISO 281, annex A), or `grease_cleanliness`",
            ));
        }
        return Ok(());
    };
    let factor = match contamination {
        Contamination::Factor(factor) => factor,
        Contamination::Grease(class) => life::contamination_factor(class, kappa, pitch)?,
    };
    out.add(
        Section::Life,
        ("contamination_factor", "contamination factor e_C"),
        factor,
        "",
        ISO_281,
    );
    let oil = life::Lubrication {
        viscosity_ratio: kappa,
        contamination: factor,
        additives: inputs.additives,
    };
    let a_iso = life::life_factor(kind, oil, limit, equivalent)?;
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
    let modified = life::modified_life(basis, a_1, a_iso);
    let keys = ("modified_rating_life", "modified_rating_life_time");
    lives(out, keys, modified, relative);
    Ok(())
}

/// A life in revolutions and in time.
fn lives(out: &mut Collected, (name, time): (&'static str, &'static str), life: f64, speed: f64) {
    let (words, of_time, source) = match name {
        "basic_rating_life" => ("basic rating life L_10", "  the same in time", ISO_281),
        "reference_rating_life" => (
            "reference rating life L_10r",
            "  the same in time",
            ISO_16281,
        ),
        _ => (
            "modified rating life L_nmr",
            "  the same in time",
            ISO_16281,
        ),
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

/// Moments by the models of catalogues, where they cover the series.
fn moments(
    mechanics: &BearingMechanics,
    viscosity: f64,
    [static_rating, static_load]: [f64; 2],
    out: &mut Collected,
) {
    let Some(entry) = &mechanics.entry else {
        return;
    };
    let [radial, axial] = mechanics.loads;
    let speed = mechanics.speeds.relative();
    let skf = match entry.designation.series {
        Series::DeepGroove60 => Some(SkfSeries::S60),
        Series::DeepGroove62 => Some(SkfSeries::S62),
        Series::DeepGroove63 => Some(SkfSeries::S63),
        _ => None,
    };
    let state = SkfState {
        bore: entry.boundary.bore,
        outside: entry.boundary.outside,
        speed,
        viscosity,
        radial,
        axial,
        static_rating,
    };
    let params = SkfParams {
        replenishment: if mechanics.life.is_grease { 6e-8 } else { 3e-8 },
        ..SkfParams::default()
    };
    if let Some(moment) = skf.and_then(|series| skf_moment(series, &state, &params).ok()) {
        out.add(
            Section::Friction,
            ("friction_torque_skf", "beside it: torque by SKF's model"),
            moment.total(),
            "N m",
            "SKF: a mineral oil, without seals and churning; its rolling part stands for cage and oil as well",
        );
    }
    let palmgren = match entry.designation.series {
        Series::DeepGroove60 => PalmgrenSeries::DeepGroove60,
        Series::DeepGroove62 => PalmgrenSeries::DeepGroove62,
        Series::DeepGroove63 => PalmgrenSeries::DeepGroove63,
        Series::Angular72B => PalmgrenSeries::Angular72B,
        Series::Angular73B => PalmgrenSeries::Angular73B,
        Series::CylindricalNu10 => PalmgrenSeries::Cylindrical10,
        Series::CylindricalNu2 => PalmgrenSeries::Cylindrical2,
        Series::CylindricalNu3 => PalmgrenSeries::Cylindrical3,
        Series::Tapered302 | Series::Tapered303 => return,
    };
    let supply = match mechanics.life.is_grease {
        true => PalmgrenOil::Grease,
        false => PalmgrenOil::Bath,
    };
    let mean = entry.boundary.mean_diameter();
    let load = palmgren_load(palmgren, radial, axial);
    let moment = (palmgren.factors(supply, static_load, static_rating).ok())
        .and_then(|factors| palmgren_moment(factors, mean, speed, viscosity, load).ok());
    if let Some(moment) = moment {
        out.add(
            Section::Friction,
            (
                "friction_torque_palmgren",
                "beside it: torque by Palmgren's model",
            ),
            moment.total(),
            "N m",
            "Palmgren: with the churning of an oil bath, or run-in grease (Schaeffler HR 1, 2006)",
        );
    }
}
