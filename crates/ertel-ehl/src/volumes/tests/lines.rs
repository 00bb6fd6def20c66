//! Line contacts against closed forms and differences.

use approx::assert_relative_eq;

use super::*;
use crate::contact::{Inlet, OilLayer};

/// A system on a row of nodes at some state that is no solution.
fn row() -> (System, State) {
    let motion = Motion::straight(0.8, 0.0);
    let fluid = problem(&motion, 0.01).fluid;
    let grid = Grid::of_line([-12, 10], 0.125);
    let x: Vec<f64> = grid.nodes().map(|[i, j]| grid.on_axes(i, j)[0]).collect();
    let gap = |x: &f64| 0.25 + 0.5 * x * x + 0.05 * (3.0 * x).sin();
    let pressure = |x: &f64| (0.4 - 0.4 * x * x + 0.05 * x).max(0.0);
    let state = State {
        wetted: x.iter().map(|x| pressure(x) > 0.0).collect(),
        contents: Vec::new(),
        pressure: x.iter().map(pressure).collect(),
        separation: -0.1,
    };
    let system = System {
        convolution: Deflection::new(&grid, 0.02).into(),
        gap: x.iter().map(gap).collect(),
        load: 1.0,
        beyond: None,
        fluid,
        lambda: 0.1,
        entrainment: Planar::along_x(1.0),
        arrival: Arrival::Flooded,
        warmth: Vec::new(),
        storage: None,
        balance: Balance::LOAD,
        grid,
    };
    (system, state)
}

/// The linearised balances of a row against central differences: of a Newtonian fluid, of Eyring's that slides along and across, with a layer of oil.
#[test]
fn jacobian_of_lines_against_differences() {
    let (system, state) = row();
    assert_changes(&system, &state, 1e-6);

    let scales = problem(&Motion::straight(0.8, 0.0), 0.01).scales;
    let eyring = ShearThinning::of(ShearLaw::ReeEyring(ReeEyring { eyring_stress: 1e6 }));
    let sliding = Planar {
        centre: [0.01, 0.02],
        spin: 0.0,
    };
    let (mut thinned, state) = row();
    thinned.fluid = (thinned.fluid).with_shear(Some(&eyring), &sliding, &scales);
    assert_changes(&thinned, &state, 1e-6);

    let (mut starved, mut state) = row();
    starved.arrival = Arrival::Layer(0.15);
    state.contents = starved.arrival.contents(&state.wetted);
    let at = starved.linearise(&state);
    assert!(at.contents.iter().filter(|c| c.is_finite()).count() > 5);
    assert_changes(&starved, &state, 1e-7);
}

/// A cylinder under a load per length, N/m, with a fluid of constant viscosity and density.
fn constant_fluid(load: f64, speed: f64) -> Problem<Plan> {
    let motion = Motion::straight(speed, 0.0);
    let mut problem = problem_of(&Contact::line(0.016, load), &motion, 0.0);
    let viscosity = ViscosityLaw::constant(0.04).unwrap();
    let density = DensityLaw::constant(870.0).unwrap();
    let sliding = motion.sliding(problem.scales.length);
    problem.fluid = FilmFluid::new(&density, &viscosity, 313.15, &problem.scales).with_shear(
        None,
        &sliding,
        &problem.scales,
    );
    problem
}

/// A light load hardly deforms a cylinder, whose film with Reynolds' condition at the outlet is h = 4.89497 u_m μ R/w (Martin, Engineering 102, 1916, 119), and breaks at
/// x = 0.47513 √(2Rh): with x = √(2Rh) tan γ, p' ~ cos²γ − cos⁴γ/cos²γ_0 and p(γ_0) = 0 both follow from integrals. Films of the grids converge to it by
/// the second order.
#[test]
fn rigid_cylinder() {
    let (load, speed, radius) = (2.0, 1.0, 0.016);
    let mut problem = constant_fluid(load, speed);
    let exact = 4.894_97 * speed * 0.04 * radius / load;
    let width = (2.0 * radius * exact).sqrt() / problem.scales.length;
    problem.start_film = exact / problem.scales.film;
    problem.extents.inlet = -300.0 * width;
    // Ten cells of the first grid as it is without a given outlet.
    problem.extents.outlet = 3.75 / std::f64::consts::SQRT_2 * width;
    problem.plan.most_grids = 8;
    let found = solved(&problem);
    let errors: Vec<f64> = (found.stats.iter())
        .map(|level| level.figures.value(Figure::FilmCentral).unwrap() / exact - 1.0)
        .collect();
    assert!(errors[7].abs() < 5e-4, "{errors:?}");
    // What does not fall is what the load deforms.
    let orders = [1, 2].map(|l: usize| {
        let changes = [0, 1].map(|k: usize| errors[l + k] - errors[l + k - 1]);
        (changes[0] / changes[1]).abs().log2()
    });
    assert!(
        orders.iter().all(|order| *order > 1.7),
        "{errors:?} {orders:?}"
    );
    let measured = found.measured(&problem);
    let outlet = measured.find(Figure::OutletPosition).unwrap().value;
    let width = width * problem.scales.length;
    assert_relative_eq!(outlet, 0.475_13 * width, max_relative = 2e-3);
}

/// Segments of all grids cover the contact area once, in the direction of the flow.
#[test]
fn segments_cover_the_line() {
    let mut problem = constant_fluid(7e4, 0.8);
    problem.plan.most_grids = 6;
    let found = solved(&problem);
    let mesh = Composite::new(&found.levels);
    let mut ends: Vec<[f64; 2]> = (mesh.cells.iter())
        .map(|[a, b, _]| {
            [a, b].map(|node| {
                let (l, [i, j]) = mesh.nodes[*node as usize];
                found.levels[l].system.grid.on_axes(i, j)[0]
            })
        })
        .collect();
    ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert!(ends.iter().all(|[a, b]| a < b));
    assert!(ends.windows(2).all(|pair| pair[0][1] == pair[1][0]));
    let [low, high] = found.levels[0].system.grid.bounds()[0];
    assert_eq!([ends[0][0], ends[ends.len() - 1][1]], [low, high]);
}

/// A thin layer passes unchanged: behind the meniscus the film in the middle is the layer over the density there (constant), less what flows to the sides, nothing.
#[test]
fn a_thin_layer_is_the_film() {
    let mut problem = constant_fluid(7e4, 0.8);
    let layer = 2e-8;
    problem.shape = problem.shape.with_inlet(Inlet::Layer(OilLayer {
        thickness: layer / problem.scales.film,
        lambda: problem.scales.lambda,
    }));
    problem.plan.target_error = 0.002;
    let measured = solved(&problem).measured(&problem);
    let film = measured.find(Figure::FilmCentral).unwrap();
    let error = (film.value - layer).abs();
    assert!(error < 0.01 * layer, "{film:?}");
}
