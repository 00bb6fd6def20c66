//! Line contacts against closed forms and differences.

use approx::assert_relative_eq;

use super::*;
use crate::contact::gap::{Body, Form};
use crate::contact::{Inlet, OilLayer};
use crate::volumes::contents::Edges;

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
        oil: Vec::new(),
        separation: -0.1,
    };
    let system = System {
        convolution: Deflection::new(&grid, Kernel::HalfSpace { compliance: 0.02 }).into(),
        gap: x.iter().map(gap).collect(),
        load: 1.0,
        beyond: None,
        edges: Edges::default(),
        fluid,
        lambda: 0.1,
        entrainment: Planar::along_x(1.0),
        arrival: Arrival::Flooded,
        warmth: Vec::new(),
        storage: None,
        balance: Balance::LOAD,
        rough: None,
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
    // The part that does not fall is the elastic deformation.
    let change = |l: usize| (errors[l] - errors[l - 1]).abs();
    let order = (change(2) / change(5)).log2() / 3.0;
    assert!(order > 1.7, "{errors:?} {order}");
    let measured = found.measured(&problem);
    let outlet = measured.find(Figure::OutletPosition).unwrap().value;
    let width = width * problem.scales.length;
    // To half a cell, 2.2e-3.
    assert_relative_eq!(outlet, 0.475_13 * width, max_relative = 2.5e-3);
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

/// A thin layer passes unchanged: behind the meniscus the film in the middle is the layer over the density there (constant), with no flow to the sides.
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

/// Waves on a body at rest under a body that slides: entrainment is uniform in the thick oil, so the film is compressed only elastically, H/A = C/(1 + C), and pressures
/// are P/A = (E'w/4)/(1 + C), w = 2π/λ, C = h E'w/(4B), B = ρ dp/dρ (Hooke, Proc. IMechE J 220, 2006, 259, for Q → ∞). Films of 2 %, a half and a quarter of a half-width long, against the same
/// without waves. First order in A, and B and h change over a wave.
///
/// Theory: Surfaces.
#[test]
fn standing_waves_under_sliding_are_those_of_hooke() {
    let given = |waves: Option<[f64; 2]>| {
        let contact = Contact::line(0.01, 1e5);
        let mut problem = problem_of(&contact, &Motion::straight(0.8, 2.0), 1e-3);
        problem.plan.largest_cell = 0.25 / 32.0;
        if let Some([wavelength, amplitude]) = waves {
            let waves = Form::Waves {
                wavelength,
                amplitude,
                direction: 0.0,
            };
            problem.shape.gap.add(waves, Body::First, [1.25, 0.0]);
        }
        let found = solved(&problem);
        (problem, found)
    };
    let fields = |found: &Volumes, x: f64| {
        let level = found.levels.last().unwrap();
        let grid = &level.system.grid;
        let [i, j] = grid.centre();
        let k = grid.index(i, j) as i64 + (x / grid.spacing[0]).round() as i64;
        let k = k as usize;
        (grid.place(k, 0)[0], level.films[k], level.state.pressure[k])
    };
    let (smooth, found) = given(None);
    let (_, film, pressure) = fields(&found, 0.0);
    let [rho, rho_p, _] = smooth.fluid.at(pressure).density;
    let scales = &smooth.scales;
    for wavelength in [0.5, 0.25] {
        let amplitude = 0.02 * film;
        let (_, rough) = given(Some([wavelength, amplitude]));
        let wave = std::f64::consts::TAU / (wavelength * scales.length);
        let modulus = 230.769_230_77e9;
        let bulk = scales.pressure * rho / rho_p;
        let c = film * scales.film * modulus * wave / (4.0 * bulk);
        // The first harmonic over the wave about the centre.
        let n = 64;
        let mut sums = [[0.0; 2]; 2];
        for m in 0..n {
            let at = wavelength * ((f64::from(m) + 0.5) / f64::from(n) - 0.5);
            let (x, h, p) = fields(&rough, at);
            let (_, h_0, p_0) = fields(&found, at);
            let (sin, cos) = (std::f64::consts::TAU * x / wavelength).sin_cos();
            for (sums, difference) in sums.iter_mut().zip([h - h_0, p - p_0]) {
                *sums = [sums[0] + difference * cos, sums[1] + difference * sin];
            }
        }
        let [of_film, of_pressure] = sums.map(|[a, b]| 2.0 * a.hypot(b) / f64::from(n));
        assert_relative_eq!(of_film / amplitude, c / (1.0 + c), max_relative = 0.03);
        let stiffness = 0.25 * modulus * wave / (1.0 + c);
        let of_pressure = of_pressure * scales.pressure / (amplitude * scales.film);
        assert_relative_eq!(of_pressure, stiffness, max_relative = 0.03);
    }
}
