//! The energy equation against manufactured temperatures, closed forms and integrals computed here.

use crate::common;
use ertel::engine::HeatError;

use std::f64::consts::PI;

use approx::assert_relative_eq;
use common::rigid::{EXTENTS, across_film, heated_case, problem_without_expansion, rigid, solve};
use ertel::contact::{ContactKind, Planar};
use ertel::film::MOST_NODES;
use ertel::film::cross_film::CrossFilm;
use ertel::forms::energy::{FilmPlace, Heat, Layer, film_column};
use ertel::run::problem;
use ertel::solve::discretisation::{Discretisation, Extents};
use ertel::solve::heat::column::Column;
use ertel::solve::heat::newton::{HeatNewton, HeatParams};
use ertel::solve::heat::system::{Kept, assemble};
use ertel::solve::state::State;
use ertel_fem::quadrature::Quadrature;
use ertel_rheology::{ConductivityLaw, ViscosityLaw};

/// T = T_0 + A g(X, Y) φ with φ = 0.7 + 0.3(1 + cos 2πs) in the film and 0.7 cos(πZ/2D) in the bodies: both without flux
/// at the walls, g without flux where nothing is prescribed. No slide, no pressure: the film flows as a whole, along x, but over
/// an ellipse (at an angle) round a centre with both bodies.
/// Errors in the film's and the bodies' L² norms must fall with the order of the surface elements plus one, or a half.
fn manufactured(kind: ContactKind, order: usize, sizes: [f64; 3]) {
    let mut case = heated_case(kind, 10);
    let spin = if kind == ContactKind::Elliptical {
        0.04
    } else {
        0.0
    };
    case.motion.spin = [spin * case.motion.entrainment_speed / case.hertz().half_width; 2];
    let problem = problem(&case);
    let heat = problem.heat.as_ref().unwrap();
    let zone = problem.shape.zone;
    let extents = EXTENTS;
    let depth = 1.2;
    let amplitude = 10.0;
    // g and its derivatives: value, ū·∇g, XX + YY
    // Over an ellipse in coordinates u(r), linear in r and not at right angles: zero on all edges, and level on all but the inlet's.
    let over_ellipse = |at: [f64; 2]| {
        let (length, width) = (extents.outlet - extents.inlet, 2.0 * extents.side);
        let [x, y] = zone.unit(at);
        let (u, v) = ((x - extents.inlet) / length, (y + extents.side) / width);
        let p = [
            u * (1.0 - u).powi(2),
            (1.0 - u) * (1.0 - 3.0 * u),
            6.0 * u - 4.0,
        ]
        .map(|p| 6.75 * p);
        let q = [
            (v * (1.0 - v)).powi(2),
            2.0 * v * (1.0 - v) * (1.0 - 2.0 * v),
            2.0 - 12.0 * v * (1.0 - v),
        ]
        .map(|q| 16.0 * q);
        let [to_x, to_y] = [zone.unit([1.0, 0.0]), zone.unit([0.0, 1.0])];
        let (du, dv) = (
            [to_x[0] / length, to_y[0] / length],
            [to_x[1] / width, to_y[1] / width],
        );
        let value = p[0] * q[0];
        let slope = |i: usize| p[1] * q[0] * du[i] + p[0] * q[1] * dv[i];
        let second = |i: usize| {
            p[2] * q[0] * du[i] * du[i]
                + 2.0 * p[1] * q[1] * du[i] * dv[i]
                + p[0] * q[2] * dv[i] * dv[i]
        };
        let carried = (1.0 - spin * at[1]) * slope(0) + spin * at[0] * slope(1);
        [value, carried, second(0) + second(1)]
    };
    let g = |at: [f64; 2]| {
        let [x, y] = at;
        if kind == ContactKind::Elliptical {
            return over_ellipse(at);
        }
        let k = PI / (2.0 * (extents.outlet - extents.inlet));
        let (l, along) = (PI / extents.side, k * (x - extents.inlet));
        let across = if kind == ContactKind::Line {
            1.0
        } else {
            (l * y).cos()
        };
        let ll = if kind == ContactKind::Line {
            0.0
        } else {
            l * l
        };
        let value = along.sin() * across;
        [value, k * along.cos() * across, -(k * k + ll) * value]
    };
    let film = |s: f64| {
        [
            0.7 + 0.3 * (1.0 + (2.0 * PI * s).cos()),
            -0.3 * (2.0 * PI).powi(2) * (2.0 * PI * s).cos(),
        ]
    };
    let body = |z: f64| {
        let k = PI / (2.0 * depth);
        [0.7 * (k * z).cos(), -0.7 * k * k * (k * z).cos()]
    };
    let exact = |p: [f64; 2], layer: Layer| {
        let phi = match layer {
            Layer::Film(s) => film(s)[0],
            Layer::Plane(z) | Layer::Ball(z) => body(z)[0],
        };
        amplitude * g(p)[0] * phi
    };
    let source = |p: [f64; 2], layer: Layer| {
        let [value, slope, laplacian] = g(p);
        let made = match layer {
            Layer::Film(s) => {
                let h = heat.film * (0.5 + problem.shape.gap.value(p));
                let rho = heat.density * 1.0;
                let [phi, second] = film(s);
                let c = rho * 2000.0 * h * heat.entrainment_speed / heat.length;
                c * slope * phi - 0.14 / h * value * second
            }
            Layer::Plane(z) | Layer::Ball(z) => {
                let b = &heat.bodies[usize::from(matches!(layer, Layer::Ball(_)))];
                let t = b.bulk_temperature;
                let c = b.density * b.heat_capacity.heat_capacity(0.0, t) * heat.entrainment_speed;
                let k = b.conductivity.conductivity(0.0, t) / heat.length;
                let [phi, second] = body(z);
                c * slope * phi - k * (laplacian * phi + value * second)
            }
        };
        amplitude * made
    };
    // The lubricant must not expand here: its convection is written down with one density.
    let mut still = problem_without_expansion(&case);
    still.heat.clone_from(&problem.heat);
    let errors = sizes.map(|size| {
        let column = Column::new(10, 4, depth, [0.3, 0.3]);
        let (d, mut state) = rigid(kind, &extents, size, order, column, heat);
        solve(&d, &still.fluid, heat, &mut state, Some(&source));
        let space = d.heat.as_ref().unwrap();
        let rule = Quadrature::simplex(d.contact.surface.dim, 8);
        let (mut square, mut whole) = ([0.0; 2], [0.0; 2]);
        for c in 0..d.contact.n_elements() {
            for (xi, w) in rule.points.iter().zip(&rule.weights) {
                let p = d.contact.point(c, *xi);
                let column = space.column_in(&state, c, *xi);
                for (k, t) in column.iter().enumerate() {
                    let range = space.column.film_range();
                    let z = space.column.depths[k];
                    let (part, layer) = if range.contains(&k) {
                        (0, Layer::Film(space.column.film.points()[k - range.start]))
                    } else if k < range.start {
                        (1, Layer::Plane(z))
                    } else {
                        (1, Layer::Ball(z))
                    };
                    let t_exact = exact(p, layer);
                    let weight = w * d.contact.maps[c].determinant;
                    square[part] += weight * (t - heat.inlet_temperature - t_exact).powi(2);
                    whole[part] += weight * t_exact * t_exact;
                }
            }
        }
        [0, 1].map(|part: usize| (square[part] / whole[part]).sqrt())
    });
    // Streamline upwinding on meshes that lie skewed to the flow is sure of half an order (Johnson, Nävert and Pitkäranta, Comput.
    // Methods Appl. Mech. Eng. 45 (1984) 285-312).
    let surplus = if kind == ContactKind::Elliptical {
        0.5
    } else {
        0.8
    };
    for part in 0..2 {
        let rate = (errors[0][part] / errors[2][part]).ln() / (sizes[0] / sizes[2]).ln();
        println!("{kind:?} order {order} part {part}: {errors:.2?} rate {rate:.2}");
        assert!(
            rate > order as f64 + surplus && errors[2][part] < 2e-2,
            "{kind:?} order {order} part {part}: {errors:?}, rate {rate}"
        );
    }
}

/// Theory: Energy.
/// Habchi 2008, eqs. 5.11, 5.13, 5.14 and 5.26.
#[test]
fn manufactured_temperatures() {
    manufactured(ContactKind::Line, 1, [0.2, 0.1, 0.05]);
    manufactured(ContactKind::Line, 2, [0.8, 0.4, 0.2]);
    manufactured(ContactKind::Circular, 1, [0.4, 0.28, 0.2]);
    manufactured(ContactKind::Elliptical, 1, [0.4, 0.28, 0.2]);
}

/// Couette flow between walls that the bodies keep at one temperature, no convection, no pressure: stress and
/// heat are the same at every height but for the viscosity, k T'' = −τ²/μ(T). By symmetry T' = 0 at mid-film; the profile
/// is integrated from there by Runge and Kutta's method, τ chosen such that the surfaces slide as they should.
///
/// Habchi 2008, eq. 5.11.
#[test]
fn couette_heating() {
    let mut case = heated_case(ContactKind::Line, 8);
    case.motion.slide_to_roll_ratio = 1.5;
    case.motion.entrainment_speed = 20.0;
    case.lubricant.heat_capacity = Some(ertel_rheology::HeatCapacityLaw::constant(1e-9).unwrap());
    for body in [&mut case.body_1, &mut case.body_2] {
        body.thermal_conductivity = Some(ConductivityLaw::constant(1e12).unwrap());
    }
    let problem = problem_without_expansion(&case);
    let heat = problem.heat.as_ref().unwrap();
    let extents = EXTENTS;
    let column = Column::new(8, 2, 1.0, [0.3, 0.3]);
    let (d, mut state) = rigid(ContactKind::Line, &extents, 0.25, 1, column, heat);
    solve(&d, &problem.fluid, heat, &mut state, None);

    let (t_wall, k, slide) = (313.15, 0.14, 30.0);
    let mu = |t: f64| 0.04 * (4000.0 * (1.0 / t - 1.0 / 313.15)).exp();
    // With s from mid-film to the wall, q = T'/(τh), all free of h: for T at mid-film the wall's T and the slide.
    let shoot = |t_mid: f64, stress_h: f64| {
        let n = 4000;
        let step = 0.5 / n as f64;
        let slope = |[t, q, _]: [f64; 3]| [q, -stress_h * stress_h / (mu(t) * k), stress_h / mu(t)];
        let mut y = [t_mid, 0.0, 0.0];
        for _ in 0..n {
            let at =
                |y: [f64; 3], k: [f64; 3], f: f64| [0, 1, 2].map(|i: usize| y[i] + f * step * k[i]);
            let k1 = slope(y);
            let k2 = slope(at(y, k1, 0.5));
            let k3 = slope(at(y, k2, 0.5));
            let k4 = slope(at(y, k3, 1.0));
            y = [0, 1, 2]
                .map(|i: usize| y[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        }
        y
    };
    // Bisections: stress for the wall's temperature inside, mid-film temperature for the slide outside.
    let bisect = |mut low: f64, mut high: f64, f: &dyn Fn(f64) -> f64| {
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if f(middle) > 0.0 {
                high = middle
            } else {
                low = middle
            }
        }
        0.5 * (low + high)
    };
    let stress = |t_mid: f64| bisect(0.0, 100.0, &|s| t_wall - shoot(t_mid, s)[0]);
    let t_mid = bisect(t_wall + 0.01, t_wall + 120.0, &|t| {
        2.0 * shoot(t, stress(t))[2] - slide
    });
    assert!(t_mid - t_wall > 15.0, "{t_mid}: the viscosity must matter");

    // Away from the inlet, whose temperature is prescribed: without convection it dies out from node to node.
    for x in [0.0, 0.7] {
        let film = across_film(&d, &state, x);
        assert_relative_eq!(film[4], t_mid, epsilon = 1e-4 * (t_mid - t_wall));
        assert_relative_eq!(film[0], t_wall, epsilon = 1e-4);
    }
}

/// Compression without conduction: a lubricant so viscous that it flows through as a plug is heated on its way up a rise of
/// pressure by dT/dp = −(T/ρ²c) ∂ρ/∂T and nothing else, whatever its speed. Integrated here by Runge and Kutta's method.
#[test]
fn compression_heats_and_expansion_cools() {
    let mut case = heated_case(ContactKind::Line, 4);
    case.lubricant.viscosity = ViscosityLaw::constant(1e8).unwrap();
    case.lubricant.thermal_conductivity = Some(ConductivityLaw::constant(1e-6).unwrap());
    for body in [&mut case.body_1, &mut case.body_2] {
        body.thermal_conductivity = Some(ConductivityLaw::constant(1e-6).unwrap());
        body.density = Some(1e-3);
    }
    let problem = problem(&case);
    let heat = problem.heat.as_ref().unwrap();
    let extents = EXTENTS;
    let column = Column::new(4, 2, 1.0, [0.3, 0.3]);
    let (d, mut state) = rigid(ContactKind::Line, &extents, 0.05, 1, column, heat);
    // Up to p_h in the middle, and down again: of order two, as the pressures are.
    let reduced = |x: f64| 1.0 - ((x + 0.5) / 1.5).powi(2);
    for (p, point) in state.pressure.iter_mut().zip(&d.pressure.points) {
        *p = reduced(point[0]);
    }
    solve(&d, &problem.fluid, heat, &mut state, None);

    let (beta, c) = (7e-4, 2000.0);
    let slope = |p: f64, t: f64| {
        let rho = 870.0 * (1.0 + 0.6e-9 * p / (1.0 + 1.7e-9 * p) - beta * (t - 313.15));
        t * 870.0 * beta / (rho * rho * c)
    };
    let at = |x: f64| {
        let (n, end) = (1000, heat.pressure * reduced(x));
        let step = end / f64::from(n);
        (0..n).fold(heat.inlet_temperature, |t, i| {
            let p = step * f64::from(i);
            let k1 = slope(p, t);
            let k2 = slope(p + 0.5 * step, t + 0.5 * step * k1);
            let k3 = slope(p + 0.5 * step, t + 0.5 * step * k2);
            let k4 = slope(p + step, t + step * k3);
            t + step / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
        })
    };
    let top = at(-0.5) - heat.inlet_temperature;
    assert!(top > 10.0, "{top}: there must be something to see");
    for x in [-1.3, -0.5, 0.3, 0.9] {
        let film = across_film(&d, &state, x);
        for t in &film[1..4] {
            assert_relative_eq!(*t, at(x), epsilon = 5e-3 * top);
        }
    }
}

/// Between bodies at rest no direction is another's better: a pressure that falls along y does to the film along y what one that
/// falls along x does along x.
#[test]
fn directions_of_the_flow_are_alike() {
    let case = heated_case(ContactKind::Circular, 6);
    let problem = problem(&case);
    let mut heat = problem.heat.as_ref().unwrap().clone();
    for body in &mut heat.bodies {
        body.velocity = Planar::default();
    }
    let heights = Column::new(6, 2, 1.0, [0.3, 0.3]).heights;
    let column_of = |pressure_gradient, filling| {
        let mut place = FilmPlace {
            pressure_rate: 0.0,
            at: [0.0; 2],
            pressure: 0.3,
            pressure_gradient,
            film: 0.5,
            filling,
            temperature: [0.0; MOST_NODES],
            held_conductance: None,
        };
        for (k, t) in place.temperature.iter_mut().take(7).enumerate() {
            *t = 320.0 + 3.0 * k as f64;
        }
        film_column(
            &problem.fluid,
            &heat,
            &heights,
            &place,
            &mut CrossFilm::default(),
        )
    };
    let column = |pressure_gradient| column_of(pressure_gradient, 1.0);
    let (along, across) = (column([-0.4, 0.0]), column([0.0, -0.4]));
    for (a, b) in along.heights.iter().zip(&across.heights).take(heights.n()) {
        assert!(a.compression != 0.0 && a.velocity[0] > 0.0);
        assert_relative_eq!(a.compression, b.compression, max_relative = 1e-10);
        assert_relative_eq!(a.shear, b.shear, max_relative = 1e-10);
        for (a, b) in [(a.velocity, b.velocity), (a.mass_below, b.mass_below)] {
            assert_relative_eq!(a[0], b[1], max_relative = 1e-10);
            assert!(a[1] == 0.0 && b[0] == 0.0);
        }
    }
    // Oil that fills two fifths of the gap carries, conducts and heats two fifths.
    let part = column_of([-0.4, 0.0], 0.4);
    for (a, b) in along.heights.iter().zip(&part.heights).take(heights.n()) {
        for (a, b) in [
            (a.capacity, b.capacity),
            (a.conduction, b.conduction),
            (a.shear, b.shear),
            (a.compression, b.compression),
            (a.mass_below[0], b.mass_below[0]),
            (a.by_stress[0], b.by_stress[0]),
        ] {
            assert_relative_eq!(b, 0.4 * a, max_relative = 1e-14);
        }
        assert_eq!(a.velocity, b.velocity);
    }
}

/// A band of heat on a moving half-space (Jaeger 1942): on its surface
/// T(x) = q/(πk) ∫_{−1}^{1} e^{Pe(x − x')} K₀(Pe|x − x'|) a dx', Pe = ua/(2κ). The other body is an insulator.
///
/// Habchi 2008, eqs. 5.13 and 5.14.
#[test]
fn moving_heat_source() {
    for (speed, flux) in [(0.2, 1e5), (4.0, 1e5)] {
        let mut case = heated_case(ContactKind::Line, 4);
        case.motion.entrainment_speed = speed;
        case.body_1.thermal_conductivity = Some(ConductivityLaw::constant(1e-5).unwrap());
        case.body_1.density = Some(1e-3);
        case.lubricant.heat_capacity =
            Some(ertel_rheology::HeatCapacityLaw::constant(1e-9).unwrap());
        case.lubricant.thermal_conductivity = Some(ConductivityLaw::constant(1.0).unwrap());
        let problem = problem_without_expansion(&case);
        let heat = problem.heat.as_ref().unwrap();
        let extents = Extents {
            inlet: -4.0,
            outlet: 3.0,
            side: 1.5,
            body_width: 28.0,
            body_depth: 28.0,
        };
        let body = &heat.bodies[1];
        let diffusivity = 46.0 / (body.density * 470.0);
        let peclet = speed * heat.length / (2.0 * diffusivity);
        let column = Column::new(4, 8, 12.0, [1.0, 0.5 / peclet.sqrt()]);
        let (d, mut state) = rigid(ContactKind::Line, &extents, 0.05, 2, column, heat);
        let source = |[x, _]: [f64; 2], layer: Layer| match layer {
            Layer::Film(_) if x.abs() < 1.0 => flux,
            _ => 0.0,
        };
        solve(&d, &problem.fluid, heat, &mut state, Some(&source));
        for x in [-0.5, 0.0, 0.5, 0.9] {
            let film = across_film(&d, &state, x);
            let rise = film[film.len() - 1] - heat.inlet_temperature;
            let jaeger = flux * heat.length / (PI * 46.0) * band(peclet, x);
            println!(
                "Pe {peclet:.2} x {x}: {rise:.4} {jaeger:.4} {:.2e}",
                rise / jaeger - 1.0
            );
            assert_relative_eq!(rise, jaeger, max_relative = 0.01);
        }
    }
}

/// ∫_{−1}^{1} e^{Pe(x − x')} K₀(Pe|x − x'|) dx', each side of x with x − x' = ±v³, by Simpson's rule.
fn band(peclet: f64, x: f64) -> f64 {
    let side = |reach: f64, sign: f64| {
        let n = 4000;
        let h = reach.cbrt() / n as f64;
        let f = |i: usize| {
            if i == 0 {
                return 0.0;
            }
            let v = h * i as f64;
            let u = v * v * v;
            3.0 * v * v * scaled_k0(peclet * u) * ((sign - 1.0) * peclet * u).exp()
        };
        let inner: f64 = (1..n)
            .map(|i| if i % 2 == 1 { 4.0 } else { 2.0 } * f(i))
            .sum();
        h / 3.0 * (f(0) + inner + f(n))
    };
    side(x + 1.0, 1.0) + side(1.0 - x, -1.0)
}

/// e^z K₀(z) = ∫_0^∞ e^{z(1 − cosh t)} dt, by the trapezoidal rule, which converges exponentially here.
fn scaled_k0(z: f64) -> f64 {
    let h = 0.02;
    let mut sum = 0.5;
    for i in 1..2000 {
        let term = (z * (1.0 - (h * i as f64).cosh())).exp();
        sum += term;
        if term < 1e-16 {
            break;
        }
    }
    h * sum
}

/// A rigid line contact on a coarse mesh.
fn coarse_line(heat: &Heat) -> (Discretisation, State) {
    let column = Column::new(6, 4, 1.2, [0.3, 0.3]);
    rigid(ContactKind::Line, &EXTENTS, 0.5, 1, column, heat)
}

/// Heat beyond what a matrix in single precision carries is refused as such, not as a preconditioner that breaks down.
#[test]
fn heat_beyond_all_bounds_is_refused() {
    let case = heated_case(ContactKind::Line, 6);
    let problem = problem(&case);
    let heat = problem.heat.as_ref().unwrap();
    let (d, state) = coarse_line(heat);
    for (made, refused) in [(1e8, false), (1e60, true)] {
        let source = |_: [f64; 2], layer: Layer| match layer {
            Layer::Film(_) => made,
            Layer::Plane(_) | Layer::Ball(_) => 0.0,
        };
        let mut newton = HeatNewton::new(&d, &problem.fluid, heat, HeatParams::default())
            .with_source(Some(&source));
        let step = newton.step(&mut state.clone());
        assert_eq!(
            matches!(step, Err(HeatError::Overheated)),
            refused,
            "{made:e}: {step:?}"
        );
    }
}

/// Lubricant that enters δ warmer brings ρc h u_m δ (1 − 2/(n + 1)) of heat along: next to the walls it has their temperature, by ∫(½ ± s)^n ds = 1/(n + 1) with polynomials of the
/// order n = 6. The gap h at the inlet is known, and what the rows of prescribed temperatures would have taken up counts as conducted.
#[test]
fn the_inflow_carries_its_heat() {
    let case = heated_case(ContactKind::Line, 6);
    let problem = problem_without_expansion(&case);
    let heat = problem.heat.as_ref().unwrap();
    let (d, state) = coarse_line(heat);
    let warmer = 10.0;
    let taken_up = |inlet_temperature: f64| {
        let mut heat = heat.clone();
        heat.inlet_temperature = inlet_temperature;
        let system = assemble(
            &d,
            &problem.fluid,
            &heat,
            &state,
            None,
            Kept::default(),
            None,
        );
        let rows: f64 = system.residual.iter().sum();
        let fixed: f64 = system.account.conducted.iter().sum();
        rows - fixed
    };
    let gap = (0.5 + 0.5 * EXTENTS.inlet.powi(2)) * heat.film;
    let brought = 870.0 * 2000.0 * gap * heat.entrainment_speed / heat.length * warmer;
    let brought = brought * (1.0 - 2.0 / 7.0);
    let inlet = heat.inlet_temperature;
    let less = taken_up(inlet) - taken_up(inlet + warmer);
    assert_relative_eq!(less, brought, max_relative = 1e-10);
}
