//! Figures that are computed from a film in the same way for all engines.

use super::friction::{friction, is_skewed};
use super::{Film, Meniscus, Problem, Profile};
use crate::contact::Symmetry;
use crate::film::FilmFluid;
use crate::solution::{Figure, Figures, Reading, Sizes};

/// Sizes of a contact relative to which a figure counts as rounding error.
pub fn sizes<Plan>(problem: &Problem<Plan>) -> Sizes {
    let scales = &problem.scales;
    Sizes {
        load: scales.load * scales.pressure * scales.area(&problem.shape),
        length: scales.length,
        pressure: scales.pressure,
        // λ = 12 u μ/(p_h a)·(a/h)², h = a²/R
        speed: scales.lambda * scales.pressure * scales.film.powi(2)
            / (12.0 * scales.viscosity * scales.length),
    }
}

/// The part of the central pressure, in p_h, that depends on the film: a heavily loaded contact differs from the dry one by about its film
/// thickness in units of the approach, `film`.
pub fn share_of_film(pressure: f64, film: f64) -> f64 {
    (pressure - 1.0).abs().max(film.abs()).min(pressure.abs())
}

/// The mean film, and the figures of the centreline, where the film breaks at X = `outlet` and a layer of oil fills the gap from `meniscus` on.
pub fn note_film<Plan>(
    figures: &mut Figures,
    problem: &Problem<Plan>,
    film: &impl Film,
    profile: &Profile,
    outlet: f64,
    meniscus: Option<Meniscus>,
) {
    let scales = &problem.scales;
    let at = |value: f64, x: f64| Reading::new(value).at([x * scales.length, 0.0]);
    let [mean] = film.points().mean_in_zone(|fields| Some([fields.film]));
    figures.note(Figure::FilmZoneMean, Reading::new(scales.film * mean));
    let (h_line, x_line) = profile.film_minimum();
    let thinnest = at(scales.film * h_line, x_line);
    figures.note(Figure::FilmCentrelineMinimum, thinnest);
    if let Some((p, x)) = profile.spike() {
        figures.note(Figure::PressureSpike, at(scales.pressure * p, x));
    }
    let outlet = Reading::new(scales.length * outlet);
    figures.note(Figure::OutletPosition, outlet);
    if let Some(meniscus) = meniscus {
        let reading = Reading {
            misfit: scales.length * meniscus.misfit,
            ..Reading::new(scales.length * meniscus.place)
        };
        figures.note(Figure::MeniscusPosition, reading);
    }
}

/// Pressures over the outer quarters of a roller, and the moment of the pressure about its middle: `largest` gives the largest pressure where y is
/// accepted, with its place, and `moments` ∫P, ∫P y and ∫P|y|.
pub fn note_roller<Plan>(
    figures: &mut Figures,
    problem: &Problem<Plan>,
    largest: impl Fn(&dyn Fn(f64) -> bool) -> Option<(f64, [f64; 2])>,
    moments: impl FnOnce() -> [f64; 3],
) {
    let Some(roller) = &problem.shape.zone.roller else {
        return;
    };
    let scales = &problem.scales;
    let quarter = 0.5 * roller.half_length();
    let whole = problem.shape.symmetry == Symmetry::Full;
    let sides: [(Figure, f64); 2] = [
        (Figure::EdgePressureLeft, -1.0),
        (Figure::EdgePressureRight, 1.0),
    ];
    // Where one half is solved, it is the left one.
    for (figure, sign) in sides.into_iter().take(if whole { 2 } else { 1 }) {
        if let Some((p, place)) = largest(&|y| sign * y >= quarter) {
            let place = place.map(|x| x * scales.length);
            figures.note(figure, Reading::new(scales.pressure * p).at(place));
        }
    }
    if !whole {
        return;
    }
    let [force, moment, arms] = moments();
    let unit = scales.pressure * scales.length.powi(2);
    for (figure, scale) in [
        (Figure::RollerMoment, unit * scales.length),
        (Figure::LoadPosition, scales.length / force),
    ] {
        // A resultant in the middle is as uncertain as one elsewhere.
        let reading = Reading {
            size: scale * arms,
            ..Reading::new(scale * moment)
        };
        figures.note(figure, reading);
    }
}

/// Traction, friction power and shear of a film. `heats`: whether its temperature varies, so that its power is balanced by heat.
pub fn note_friction<Plan>(
    figures: &mut Figures,
    problem: &Problem<Plan>,
    fluid: &FilmFluid,
    film: &impl Film,
    heats: bool,
) {
    let sums = friction(problem, problem.friction.as_ref().unwrap_or(fluid), film);
    // The film's own fluid balances its work: another law does not flow as the film does.
    let power_misfit = match problem.friction {
        None => sums.power_misfit(),
        Some(_) => friction(problem, fluid, film).power_misfit(),
    };
    let (f, near) = (&sums.here, &sums.shorter);
    let [mid, body_1, body_2] = f.coefficients;
    let [near_mid, near_body_1, near_body_2] = near.coefficients;
    let wall = sums.wall_misfit().abs();
    let (shape, skewed) = (&problem.shape, is_skewed(&problem.shape, fluid));
    // If both components matter, one that happens to vanish is as uncertain as the whole.
    let component = |vector: [f64; 2], near: [f64; 2], i: usize| Reading {
        size: match skewed {
            true => vector[0].hypot(vector[1]),
            false => vector[i].abs(),
        },
        cut: (vector[i] - near[i]).abs(),
        ..Reading::new(vector[i])
    };
    for (figure, vector, near, misfit) in [
        (Figure::TractionCoefficient, mid, near_mid, 0.0),
        (Figure::TractionCoefficientBody1, body_1, near_body_1, wall),
        (Figure::TractionCoefficientBody2, body_2, near_body_2, wall),
        (Figure::TractionForce, f.force, near.force, 0.0),
    ] {
        let reading = Reading {
            misfit,
            ..component(vector, near, 0)
        };
        figures.note(figure, reading);
    }
    let power = Reading {
        cut: (f.work - near.work).abs(),
        // Films that heat up expand: their balance is that of the heat of the contact area.
        misfit: match heats {
            false => power_misfit.abs(),
            true => sums.work_around,
        },
        ..Reading::new(f.work)
    };
    figures.note(Figure::FrictionPower, power);
    figures.note(Figure::ShearStressMaximum, Reading::new(f.stress_maximum));
    if skewed {
        for (figure, vector, near) in [
            (Figure::TractionCoefficientAcross, mid, near_mid),
            (Figure::TractionCoefficientAcrossBody1, body_1, near_body_1),
            (Figure::TractionCoefficientAcrossBody2, body_2, near_body_2),
            (Figure::TractionForceAcross, f.force, near.force),
        ] {
            figures.note(figure, component(vector, near, 1));
        }
    }
    if skewed && !shape.is_line() {
        let [moment, size] = f.moment;
        let moment = Reading {
            size,
            cut: (moment - near.moment[0]).abs(),
            ..Reading::new(moment)
        };
        figures.note(Figure::TractionMoment, moment);
    }
    let limits = [Figure::BeyondFirstLimit, Figure::BeyondSecondLimit];
    for (figure, share) in limits.into_iter().zip(sums.whole.beyond) {
        if let Some(share) = share {
            figures.note(figure, Reading::new(share));
        }
    }
}
