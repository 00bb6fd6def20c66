//! Figures read from states that are written down.

use std::path::Path;
use std::sync::Arc;

use ertel::case::Case;
use ertel::engine::figures::note_roller;
use ertel::problem::problem;
use ertel::solution::{Figure, Figures};
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::Discretisation;
use ertel::solve::evaluate::largest_pressure_where;
use ertel::solve::state::State;
use ertel_fem::linear::NEVER;
use ertel_input::Document;

const ROLLER: &str = r#"
    [contact]
    kind = "roller"
    radius = "10 mm"
    length = "2 mm"
    load = "200 N"
    profile = { kind = "crown", crown_radius = "300 mm" }
    [bodies]
    body_1 = "steel"
    body_2 = "steel"
    [motion]
    entrainment_speed = "1 m/s"
    slide_to_roll_ratio = 0.0
    [lubricant]
    temperature = "40 degC"
    density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
    viscosity = { law = "barus", mu_0 = "40 mPa.s", alpha = "10 1/GPa" }
    [mesh]
    preset = "coarse"
"#;

/// Pressures that fall from the middle of a roller towards its ends are largest, over the quarter of its length next to an end, where that
/// begins: at L/4 from the middle, half of the largest pressure.
#[test]
fn edge_pressures_are_those_of_the_outer_quarters() {
    let document = Document::parse("case.toml", ROLLER).unwrap();
    let problem = problem(&Case::from_document(&document, Path::new("")).unwrap());
    let stage = problem.plan.stages[0];
    let contact = ContactSurface::new(
        &problem.shape,
        &problem.extents,
        &stage.sizes,
        &problem.elasticity,
        NEVER,
    );
    let d = Discretisation::new(&Arc::new(contact.unwrap()), stage.pressure_order);
    let half = problem.shape.zone.roller.as_ref().unwrap().half_length();
    let falling = |p: &[f64; 3]| 1.0 - p[1].abs() / half;
    let state = State {
        pressure: d.pressure.points.iter().map(falling).collect(),
        deflection: vec![0.0; d.contact.deflection.n_nodes()],
        rigid_separation: 1.0,
        temperature: Vec::new(),
    };
    let mut figures = Figures::default();
    let largest =
        |at: &dyn Fn(f64) -> bool| Some(largest_pressure_where(&d, &state, |[_, y]| at(y)));
    let moments = || unreachable!("one half is solved");
    note_roller(&mut figures, &problem, largest, moments);
    let edge = figures.get(Figure::EdgePressureLeft).unwrap();
    let p = edge.size / problem.scales.pressure;
    // Read at nodes: one cell short of it at the most.
    assert!((0.42..=0.5 + 1e-9).contains(&p), "{p}");
    let y = edge.place.unwrap()[1] / problem.scales.length;
    assert!((-0.58..=-0.5 + 1e-9).contains(&(y / half)), "{}", y / half);
}
