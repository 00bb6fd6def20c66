//! Figures of a rolling bearing: the parts of friction, and their sums.
//!
//! ```text
//!   P = Σ P_film + P_slip       over all contacts: work of the surfaces on the film, and of the differential slip
//!   P_roll = Σ (µ_2 − µ_1) Q u  the rolling part of P_film; the rest is spin
//!   M = P/|ω_i − ω_o|
//! ```

use ertel_machines::bearing::Geometry;
use ertel_machines::bearing::kinematics::deformed_radius;
use rayon::prelude::*;

use super::contacts::{figure_of, sum};
use super::rolling::rolling_coefficient;
use super::slip::Slip;
use crate::case::{BearingMechanics, Case, ContactKind, RINGS};
use crate::figures::Row;
use crate::figures::bearing::{
    BEARING_TEMPERATURE, ELEMENT_LOAD_MAXIMUM, FRICTION_POWER, FRICTION_POWER_DIFFERENTIAL_SLIP,
    FRICTION_POWER_SPIN, FRICTION_TORQUE, RIB_LOAD_MAXIMUM, SLICE_LOAD_RATIO,
};
use crate::figures::machine::{FRICTION_POWER_ROLLING, HERTZ_PRESSURE_MAXIMUM};
use crate::mark::{Mark, Marked, Marks};
use crate::plausible::LARGEST_TRACTION;
use crate::point::{MachineSolution, PointSolution};
use crate::solution::{Figure, limits};
use crate::warning::{Warning, WarningKind};
use crate::words::{CELSIUS, digits};

/// Smallest tilt of a roller that is reported, rad.
const LEAST_TILT: f64 = 1e-9;

/// Load per length of the heaviest slice of a roller over its mean above which a line does not represent the roller.
const UNEVEN: f64 = 1.5;

/// Difference between the temperature from the heat of the contacts and that of the lubricant above which a warning is given, K.
const SAME: f64 = 2.0;

/// The figures; sums over the contacts only where all of them are solved.
pub(super) fn figures(
    case: &Case,
    mechanics: &BearingMechanics,
    solved: &MachineSolution,
    warnings: &mut Vec<Warning>,
) -> Vec<Row> {
    let mut figures = loads(mechanics, warnings);
    let length = match (mechanics.contacts, &mechanics.bearing.geometry) {
        // Lines are solved per length.
        (ContactKind::Lines, Geometry::CylindricalRoller(roller)) => roller.length,
        (ContactKind::Lines, Geometry::TaperedRoller(roller)) => roller.length,
        _ => 1.0,
    };
    let film = sum(solved, |_, point| Some(film_power(point)? * length));
    let rolling = sum(solved, |_, point| Some(rolling_power(point)? * length));
    if let (Some(film), Some(rolling)) = (film, rolling) {
        figures.extend(friction(case, mechanics, solved, [film, rolling], warnings));
    }
    figures.extend(super::life::figures(case, mechanics, warnings));
    figures
}

/// Those that need no solved contact.
pub(super) fn estimate(
    case: &Case,
    mechanics: &BearingMechanics,
    warnings: &mut Vec<Warning>,
) -> Vec<Row> {
    let mut figures = loads(mechanics, warnings);
    figures.extend(super::life::figures(case, mechanics, warnings));
    figures
}

/// Largest loads and pressure.
fn loads(mechanics: &BearingMechanics, warnings: &mut Vec<Warning>) -> Vec<Row> {
    let heaviest = mechanics.distribution.elements.iter();
    let heaviest = heaviest.flat_map(|e| e.contacts.iter().map(|c| [c.load, c.pressure]));
    let [load, pressure] = heaviest.fold([0.0_f64; 2], |[q, p], [load, pressure]| {
        [q.max(load), p.max(pressure)]
    });
    let mut figures = vec![
        ELEMENT_LOAD_MAXIMUM.row(load, ""),
        HERTZ_PRESSURE_MAXIMUM.row(pressure, ""),
    ];
    figures.extend(heaviest_slice(mechanics, warnings));
    let rib = mechanics.distribution.elements.iter().map(|e| e.rib_load);
    let rib = rib.fold(0.0, f64::max);
    if rib > 0.0 {
        figures.push(RIB_LOAD_MAXIMUM.row(rib, ""));
    }
    figures
}

/// The heaviest slice of the roller under the largest pressure, over the mean of that roller; warns where a line does not represent it.
fn heaviest_slice(mechanics: &BearingMechanics, warnings: &mut Vec<Warning>) -> Option<Row> {
    let contacts = (mechanics.distribution.elements.iter()).flat_map(|e| &e.contacts);
    let heaviest = contacts.max_by(|a, b| a.pressure.total_cmp(&b.pressure))?;
    let share = heaviest.peak_slice()?;
    if mechanics.contacts == ContactKind::Lines && share > UNEVEN {
        // Below, a tilt is rounding.
        let tilt = match heaviest.tilt.abs() > LEAST_TILT {
            true => format!(
                ", at a tilt of {} mrad",
                digits(1e3 * heaviest.tilt.abs(), 3)
            ),
            false => String::new(),
        };
        warnings.push(Warning::new(
            WarningKind::UnevenRoller,
            format!(
                "rollers are solved as lines under their mean load per length, but the heaviest slice of the roller under the largest pressure carries {} times \
                 that{tilt}: give `roller_contacts = \"finite\"`",
                digits(share, 3)
            ),
        ));
    }
    Some(SLICE_LOAD_RATIO.row(share, ""))
}

/// Friction by its parts, torque and temperature, from the powers of films and of rolling.
fn friction(
    case: &Case,
    mechanics: &BearingMechanics,
    solved: &MachineSolution,
    [film, rolling]: [Marked; 2],
    warnings: &mut Vec<Warning>,
) -> Vec<Row> {
    let mut figures = vec![FRICTION_POWER_ROLLING.row(
        rolling,
        "rolling: resistance of the films to rolling, at both walls",
    )];
    let (slip, rows) = sliding(case, mechanics, solved, [film, rolling], warnings);
    figures.extend(rows);
    let power = film + slip;
    figures.push(FRICTION_POWER.row(power, ""));
    let relative = mechanics.speeds.relative().abs();
    if relative > 0.0 {
        figures.push(FRICTION_TORQUE.row(
            power / relative,
            match mechanics.bearing.geometry {
                Geometry::TaperedRoller(_) => {
                    "torque of the raceway contacts: without rib, cage, seals and churning of the oil; only SKF's model includes the rib"
                }
                Geometry::Ball(_) | Geometry::CylindricalRoller(_) => {
                    "torque of the contacts: without cage, seals and churning of the oil"
                }
            },
        ));
    }
    if let Some([resistance, ambient]) = mechanics.life.cooling {
        let temperature = (power * resistance).above(ambient);
        let melts = temperature.value > limits::TEMPERATURE;
        let temperature = temperature.with(Marks::when(melts, Mark::Unresolved));
        figures.push(BEARING_TEMPERATURE.row(
            temperature,
            "temperature: surroundings plus thermal resistance times the power of all contacts",
        ));
        let own = case.lubricant.temperature;
        if (temperature.value - own).abs() > SAME && !temperature.is_doubtful() {
            warnings.push(Warning::new(
                WarningKind::OilTemperature,
                format!(
                    "the heat of the contacts would bring the bearing to {:.1} °C, but the lubricant is taken at {:.1} °C: solve again \
                     at a temperature in between, or set `heat_balance = true`",
                    temperature.value - CELSIUS,
                    own - CELSIUS
                ),
            ));
        }
    }
    figures
}

/// Power of sliding that the films do not include, W, and the rows of spin and of differential slip. Without that of spin it is not resolved.
fn sliding(
    case: &Case,
    mechanics: &BearingMechanics,
    solved: &MachineSolution,
    [film, rolling]: [Marked; 2],
    warnings: &mut Vec<Warning>,
) -> (Marked, Vec<Row>) {
    let contacts = || (mechanics.distribution.elements.iter()).flat_map(|e| &e.contacts);
    let spins = contacts().any(|c| c.spin[0] != c.spin[1]);
    let by_law = spins && case.friction_by_law;
    let power = |value: f64| Marked {
        error: Some(0.0),
        ..Marked::exact(value)
    };
    let mut rows = Vec::new();
    if spins && !by_law {
        rows.push(FRICTION_POWER_SPIN.row(film - rolling, ""));
    }
    if !matches!(mechanics.bearing.geometry, Geometry::Ball(_)) {
        return (power(0.0), rows);
    }
    let slip = slip_power(case, mechanics, solved, |_| 0.0);
    let both = match by_law {
        true => slip_power(case, mechanics, solved, |i| spin_of(mechanics, i)),
        false => slip,
    };
    let (Some(slip), Some(both)) = (slip, both) else {
        warnings.push(Warning::new(
            WarningKind::Friction,
            format!(
                "differential slip{} omitted from the friction: its traction would exceed 0.15, because the laws of this lubricant do not limit the shear \
                 stress; give `shear_thinning`, such as `{{ law = \"estimate\" }}` with `base_oil`",
                if by_law { " and spin are" } else { " is" }
            ),
        ));
        return (power(0.0).with(Marks::when(by_law, Mark::Unresolved)), rows);
    };
    if by_law {
        rows.push(FRICTION_POWER_SPIN.row(
            both - slip,
            "spin: by the laws of the lubricant at the dry pressure and the central film of each contact",
        ));
    }
    rows.push(FRICTION_POWER_DIFFERENTIAL_SLIP.row(
        slip,
        "differential slip (Heathcote 1921): by the laws of the lubricant at the dry pressure and the central film of each contact",
    ));
    (power(both), rows)
}

/// Power of differential slip and of the spin (rad/s, of each contact) in all contacts, W; `None` where it is implausible.
fn slip_power(
    case: &Case,
    mechanics: &BearingMechanics,
    solved: &MachineSolution,
    spin: impl Fn(usize) -> f64 + Sync,
) -> Option<f64> {
    let power = |i: usize| {
        let point = solved.contacts[i].as_ref()?;
        let slip = Slip {
            spin: spin(i),
            ..slip_of(mechanics, solved.machine.contacts[i].side, point)?
        };
        let boundary = boundary_of(case, point);
        let film = stress_of(case);
        let found = slip.friction(|pressure, rate| film(pressure, rate) + boundary * pressure);
        (found.mean_traction < LARGEST_TRACTION).then_some(found.power)
    };
    let powers: Vec<Option<f64>> = (0..solved.contacts.len())
        .into_par_iter()
        .map(power)
        .collect();
    Some(sum(solved, |i, _| powers[i].map(Marked::exact))?.value)
}

/// Difference of the spins of a ball and of the ring at a contact, rad/s.
fn spin_of(mechanics: &BearingMechanics, contact: usize) -> f64 {
    let of = &mechanics.distribution.elements[contact / RINGS.len()];
    let [ring, ball] = of.contacts[contact % RINGS.len()].spin;
    ball - ring
}

/// Friction of the asperities of a contact over its pressure: that of boundary lubrication times their share of the load.
fn boundary_of(case: &Case, point: &PointSolution) -> f64 {
    let asperities = case.asperities.as_ref();
    let boundary = asperities.and_then(|asperities| asperities.boundary_friction_coefficient);
    let share = figure_of(point, Figure::AsperityLoadShare).map_or(0.0, |share| share.value);
    boundary.unwrap_or(0.0) * share
}

/// Power lost by rolling: (µ_2 − µ_1) Q u.
fn rolling_power(point: &PointSolution) -> Option<Marked> {
    let scale = point.case.contact.load * point.case.motion.entrainment_speed;
    Some(rolling_coefficient(point)? * scale)
}

/// Power that the surfaces lose on the film. It is not resolved where spin takes more than dry metal would, µ Q times the mean speed of sliding: that of spin
/// is at most 2/3 of the speed at the longer half-axis.
fn film_power(point: &PointSolution) -> Option<Marked> {
    let power = figure_of(point, Figure::FrictionPower)?;
    let [ring, ball] = point.case.motion.spin;
    let hertz = &point.outcome.solution()?.hertz;
    let reach = hertz.half_width_y.unwrap_or(0.0).max(hertz.half_width);
    let speed = (ball - ring).abs() * reach * 2.0 / 3.0;
    let dry = limits::TRACTION * point.case.contact.load * speed;
    let spin = power - rolling_power(point)?;
    // The difference of two equal powers is within the bars of both.
    let is_beyond = speed > 0.0 && spin.value - spin.error.unwrap_or(0.0) > dry;
    Some(power.with(Marks::when(is_beyond, Mark::Unresolved)))
}

/// Differential slip at a ring; `None` for rollers, and where the contact was not solved.
fn slip_of(mechanics: &BearingMechanics, side: usize, point: &PointSolution) -> Option<Slip> {
    let Geometry::Ball(geometry) = &mechanics.bearing.geometry else {
        return None;
    };
    let solution = point.outcome.solution()?;
    let deformed = deformed_radius(geometry.groove[side], geometry.ball_diameter);
    Some(Slip {
        half_widths: [solution.hertz.half_width, solution.hertz.half_width_y?],
        hertz_pressure: solution.hertz.pressure,
        film: (figure_of(point, Figure::MeanGapCentral))
            .map_or(solution.summary.film_central.value, |gap| gap.value),
        speed: point.case.motion.entrainment_speed,
        curvature: 0.5 / (deformed * point.case.contact.radius),
        spin: 0.0,
    })
}

/// Shear stress, Pa, by pressure, Pa, and shear rate, 1/s. It is limited whether or not the films are solved as Newtonian.
fn stress_of(case: &Case) -> impl Fn(f64, f64) -> f64 {
    let lubricant = &case.lubricant;
    let thinning = lubricant.shear_thinning.as_ref();
    move |pressure, rate| {
        let viscosity = lubricant
            .viscosity
            .viscosity(pressure, lubricant.temperature);
        thinning.map_or(viscosity * rate, |law| {
            law.stress(viscosity, pressure, rate)
        })
    }
}
