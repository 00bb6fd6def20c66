//! Load and friction of the asperities at a solution.
//!
//! ```text
//!   L = ∫ p_a dA/W,     f_a = f_b/W ∫ p_a e dA        e: direction in which body 2 slides over body 1
//!   friction power = that of the film + f_b ∫ p_a |Δu| dA
//! ```

use crate::engine::friction::is_skewed;
use crate::engine::{Film, Problem};
use crate::mixed::Rough;
use crate::solution::{Figure, Figures, Reading};

/// Notes the load share of the asperities, and where surfaces slide their friction with that of oil and asperities together; adds their friction power.
pub fn note_asperities<Plan>(
    figures: &mut Figures,
    problem: &Problem<Plan>,
    rough: &Rough,
    film: &impl Film,
) {
    let slide = problem.friction_fluid().slide();
    let mut load = 0.0;
    let (mut directed, mut rubbed) = ([0.0; 2], 0.0);
    for point in film.points().iter() {
        let carried = point.area * point.fields.asperity_pressure;
        load += carried;
        let [u, v] = slide.at(point.fields.place);
        let speed = u.hypot(v);
        if speed > 0.0 {
            directed[0] += carried * u / speed;
            directed[1] += carried * v / speed;
            rubbed += carried * speed;
        }
    }
    let share = load / problem.load;
    figures.note(Figure::AsperityLoadShare, Reading::new(share));
    let Some(boundary) = rough.boundary_friction.filter(|_| problem.fluid.slides()) else {
        return;
    };
    let friction = directed.map(|sum| boundary * sum / problem.load);
    let reading = |value: f64| Reading {
        // The oil bears the rest: both are as uncertain.
        size: boundary * share,
        ..Reading::new(value)
    };
    figures.note(Figure::FrictionAsperities, reading(friction[0]));
    let film = figures.get(Figure::TractionCoefficient);
    if let Some(film) = film {
        let total = Reading {
            size: film.size.max(boundary * share),
            cut: film.cut,
            misfit: film.misfit,
            ..Reading::new(film.value + friction[0])
        };
        figures.note(Figure::FrictionTotal, total);
    }
    // All that the surfaces lose.
    if let Some(film) = figures.get(Figure::FrictionPower) {
        let scales = &problem.scales;
        let speed = problem.fluid.stress_scale() * scales.film / scales.viscosity;
        let power = boundary * rubbed * speed * scales.pressure * scales.area(&problem.shape);
        let all = Reading {
            value: film.value + power,
            size: film.size + power,
            ..film
        };
        figures.note(Figure::FrictionPower, all);
    }
    if is_skewed(&problem.shape, &problem.fluid) {
        figures.note(Figure::FrictionAsperitiesAcross, reading(friction[1]));
    }
}
