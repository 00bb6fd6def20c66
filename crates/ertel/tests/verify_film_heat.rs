//! Stresses, velocities and heat of a thermal film against a film written out here: balance of forces, the law of Rabinowitsch, Simpson's
//! rule, all in SI.

use crate::common;

use crate::common::text::read;
use approx::assert_relative_eq;
use common::rigid::heated_case;
use ertel::case::Case;
use ertel::contact::{ContactKind, Motion};
use ertel::engine::PointFields;
use ertel::engine::shear::Shear;
use ertel::film::cross_film::CrossFilm;
use ertel::film::{MOST_NODES, TemperatureProfile};
use ertel::forms::energy::{FilmColumn, FilmPlace, Heat, film_column};
use ertel::run::problem;
use ertel::solve::sequence::Problem;
use ertel_rheology::ConductivityLaw;
use ertel_rheology::property::LinearFactor;
use ertel_rheology::shear::{Rabinowitsch, ShearLaw, ShearThinning};

/// The place, in half-widths, P, ∇P and H there; slide-to-roll ratio, and τ_c of the film that stress thins, Pa.
const AT: [f64; 2] = [0.5, -0.7];
const PRESSURE: f64 = 0.4;
const GRADIENT: [f64; 2] = [-0.8, 0.3];
const FILM: f64 = 0.2;
const SLIDE: f64 = 0.6;
/// Sliding across the motion over the entrainment speed, and spin of plane and ball, rad/s.
const ACROSS: f64 = -0.25;
const SPIN: [f64; 2] = [300.0, -900.0];
const KNEE: f64 = 2e6;

/// Temperature of the film without heat, K.
const ISOTHERMAL: f64 = 313.15;

/// T(s), K.
fn profile(s: f64) -> f64 {
    330.0 + 12.0 * s + 60.0 * (0.25 - s * s)
}

fn case(thins: bool) -> Case {
    let mut case = heated_case(ContactKind::Circular, 10);
    case.motion.slide_to_roll_ratio = SLIDE;
    case.motion.slide_to_roll_ratio_across = ACROSS;
    case.motion.spin = SPIN;
    let law = Rabinowitsch::new(KNEE, 1.0 / 3.0).unwrap();
    case.lubricant.shear_thinning = thins.then(|| ShearThinning::of(ShearLaw::Rabinowitsch(law)));
    case
}

/// The place, with a temperature at each node and height s.
fn place(
    problem: &Problem,
    held_conductance: Option<f64>,
    temperature: impl Fn(usize, f64) -> f64,
) -> FilmPlace {
    let mut place = FilmPlace {
        pressure_rate: 0.0,
        at: AT,
        pressure: PRESSURE,
        pressure_gradient: GRADIENT,
        film: FILM,
        filling: 1.0,
        temperature: [0.0; MOST_NODES],
        held_conductance,
    };
    let nodes = problem.fluid.nodes().unwrap().points();
    for (m, s) in nodes.iter().enumerate() {
        place.temperature[m] = temperature(m, *s);
    }
    place
}

/// The film at a place, with heat by these laws.
fn column_at(problem: &Problem, heat: &Heat, place: &FilmPlace) -> FilmColumn {
    let heights = &problem.plan.heat.as_ref().unwrap().column.heights;
    film_column(
        &problem.fluid,
        heat,
        heights,
        place,
        &mut CrossFilm::default(),
    )
}

/// Velocities of plane and ball at the place, m/s, by hand.
fn surfaces(case: &Case) -> [[f64; 2]; 2] {
    let [x, y] = AT.map(|v| v * case.hertz().half_width);
    let u_m = case.motion.entrainment_speed;
    [(-0.5, SPIN[0]), (0.5, SPIN[1])].map(|(share, spin)| {
        [
            u_m * (1.0 + share * SLIDE) - spin * y,
            u_m * share * ACROSS + spin * x,
        ]
    })
}

/// ∫ over −½ ≤ s ≤ `to` by Simpson's rule.
fn below(to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let n = 1000;
    let step = (to + 0.5) / f64::from(n);
    let at = |k: i32| f(-0.5 + step * f64::from(k));
    let inner: f64 = (1..n)
        .map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * at(k))
        .sum();
    step / 3.0 * (at(0) + inner + at(n))
}

/// τ(s) = τ_m + s h ∇p, γ̇ = τ(1 + |τ|²/τ_c²)/μ(p, T(s)), ∫γ̇ dz = u_2 − u_1.
struct Exact {
    mid: [f64; 2],
    /// h∇p, Pa.
    g: [f64; 2],
    /// h, m.
    h: f64,
    mu: Box<dyn Fn(f64) -> f64>,
    thinning: f64,
}

impl Exact {
    fn new(case: &Case, problem: &Problem) -> Exact {
        let scales = &problem.scales;
        let (p, h) = (PRESSURE * scales.pressure, FILM * scales.film);
        let law = case.lubricant.viscosity.clone();
        let thins = case.lubricant.shear_thinning.is_some();
        let heated = problem.heat.is_some();
        let mut film = Exact {
            mid: [0.0; 2],
            g: GRADIENT.map(|g| h * g * scales.pressure / scales.length),
            h,
            mu: Box::new(move |s| {
                let t = if heated { profile(s) } else { ISOTHERMAL };
                law.ln_viscosity(p, t).exp()
            }),
            thinning: if thins { 1.0 / (KNEE * KNEE) } else { 0.0 },
        };
        let [plane, ball] = surfaces(case);
        let wanted = [0, 1].map(|i: usize| ball[i] - plane[i]);
        // Newton's method for one component after the other, with differences
        for _ in 0..20 {
            for i in 0..2 {
                let here = film.slide(i);
                film.mid[i] += 1.0;
                let slope = film.slide(i) - here;
                film.mid[i] += (wanted[i] - here) / slope - 1.0;
            }
        }
        film
    }

    fn stress(&self, s: f64) -> [f64; 2] {
        [0, 1].map(|i: usize| self.mid[i] + s * self.g[i])
    }

    fn square(&self, s: f64) -> f64 {
        self.stress(s).iter().map(|t| t * t).sum()
    }

    fn fluidity(&self, s: f64) -> f64 {
        (1.0 + self.thinning * self.square(s)) / (self.mu)(s)
    }

    /// Velocity above that of the plane.
    fn velocity(&self, to: f64, i: usize) -> f64 {
        self.h * below(to, |s| self.stress(s)[i] * self.fluidity(s))
    }

    fn slide(&self, i: usize) -> f64 {
        self.velocity(0.5, i)
    }
}

/// Stresses at mid-film and at the walls, viscosity at mid-film, friction power, with and without heat. Nodes across the film carry ln μ to 1e-8.
#[test]
fn wall_stresses() {
    for (thins, heated) in [(false, false), (true, false), (false, true), (true, true)] {
        let mut case = case(thins);
        if !heated {
            case.thermal = None;
        }
        let problem = problem(&case);
        let film = Exact::new(&case, &problem);
        let mut temperature = TemperatureProfile::default();
        let nodes = problem
            .fluid
            .nodes()
            .map_or(&[][..], |nodes| nodes.points());
        for (t, s) in temperature.temperature.iter_mut().zip(nodes) {
            *t = profile(*s);
        }
        let fields = PointFields {
            place: AT,
            pressure: PRESSURE,
            pressure_gradient: GRADIENT,
            film: FILM,
            temperature: heated.then(|| Box::new(temperature)),
            ..PointFields::default()
        };
        let found = Shear::new(&problem.fluid, &problem.scales).at(&fields);
        let off = 1e-6 * film.square(0.0).sqrt();
        for (k, s) in [0.0, -0.5, 0.5].into_iter().enumerate() {
            for i in 0..2 {
                assert_relative_eq!(found.stress[k][i], film.stress(s)[i], epsilon = off);
            }
            assert_relative_eq!(found.equivalent[k], film.square(s).sqrt(), epsilon = off);
        }
        let viscosity = 1.0 / film.fluidity(0.0);
        assert_relative_eq!(found.viscosity, viscosity, max_relative = 1e-6);
        let power = film.h * below(0.5, |s| film.square(s) * film.fluidity(s));
        assert_relative_eq!(found.power, power, max_relative = 1e-6);
    }
}

/// u, h τ·γ̇, −hT/ρ ∂ρ/∂T u·∇p and H(∫_{−½}^s ρ̄u − (s + ½)∫ρ̄u) at every height; by the stress, the heat of shearing grows with
/// h(2τ + 4τ|τ|²/τ_c²)/μ. Polynomials through the heights carry them to 1e-6.
#[test]
fn heat_of_the_film() {
    for thins in [false, true] {
        let case = case(thins);
        let problem = problem(&case);
        let film = Exact::new(&case, &problem);
        let heat = problem.heat.as_ref().unwrap();
        let heights = &problem.plan.heat.as_ref().unwrap().column.heights;
        let nodes = problem.fluid.nodes().unwrap().points();
        let column = |warmer: Option<usize>, by: f64| {
            let place = place(&problem, None, |m, s| {
                profile(s) + if warmer == Some(m) { by } else { 0.0 }
            });
            column_at(&problem, heat, &place)
        };
        let found = column(None, 0.0);
        let u_m = case.motion.entrainment_speed;
        let [plane, _] = surfaces(&case);
        let p = PRESSURE * heat.pressure;
        let rho = |t: f64| 870.0 * (1.0 + 0.6e-9 * p / (1.0 + 1.7e-9 * p) - 7e-4 * (t - 313.15));
        let velocity = |s: f64| [0, 1].map(|i: usize| plane[i] + film.velocity(s, i));
        // ∫ρu, by parts of the velocity: of two Simpson's rules in each other, 1000 × 1000 points are too many
        let mass = |to: f64, i: usize| {
            let above = |s: f64| below(to, |x| rho(profile(x))) - below(s, |x| rho(profile(x)));
            let n = 200;
            let step = (to + 0.5) / f64::from(n);
            let rate = |s: f64| film.h * film.stress(s)[i] * film.fluidity(s) * above(s);
            let middle = |k: i32| -0.5 + step * (f64::from(k) + 0.5);
            let shift = step / 12.0_f64.sqrt();
            let driven: f64 = (0..n)
                .map(|k| 0.5 * step * (rate(middle(k) - shift) + rate(middle(k) + shift)))
                .sum();
            plane[i] * below(to, |x| rho(profile(x))) + driven
        };
        let whole = [mass(0.5, 0), mass(0.5, 1)];
        for (point, s) in found.heights.iter().zip(heights.points()) {
            let (t, u) = (profile(*s), velocity(*s));
            for i in 0..2 {
                assert_relative_eq!(point.velocity[i], u[i] / u_m, epsilon = 1e-6);
                let below = FILM / 870.0 / u_m * (mass(*s, i) - (s + 0.5) * whole[i]);
                assert_relative_eq!(point.mass_below[i], below, epsilon = 1e-6);
                let tau = film.stress(*s)[i];
                let growth = 2.0 * tau * (1.0 + 2.0 * film.thinning * film.square(*s));
                let by = film.h * problem.fluid.stress_scale() * growth / (film.mu)(*s);
                assert_relative_eq!(point.by_stress[i], by, max_relative = 1e-5);
            }
            let shear = film.h * film.square(*s) * film.fluidity(*s);
            assert_relative_eq!(point.shear, shear, max_relative = 1e-5);
            // ∂ρ/∂T = −870 · 7e-4
            let along = (u[0] * film.g[0] + u[1] * film.g[1]) / film.h;
            let compression = film.h * t / rho(t) * 870.0 * 7e-4 * along;
            assert_relative_eq!(point.compression, compression, max_relative = 1e-5);
        }
        // With the temperature of a node the heat changes by itself, and by the stress.
        for (m, slope) in found.stress_slopes.iter().enumerate().take(nodes.len()) {
            let [up, down] = [1e-3, -1e-3].map(|by| column(Some(m), by));
            for (k, point) in found.heights.iter().enumerate().take(heights.n()) {
                let difference = (up.heights[k].shear - down.heights[k].shear) / 2e-3;
                let change = point.shear * found.thinning[m] * heights.shapes[k][m]
                    + point.by_stress[0] * slope[0]
                    + point.by_stress[1] * slope[1];
                assert_relative_eq!(change, difference, epsilon = 1e-5 * point.shear);
            }
        }
    }
}

/// A film whose flow is held, at temperatures `warmer` than the profile by a function of s. With `held`, the conductance is that of the
/// profile itself.
fn film_at(problem: &Problem, held: bool, warmer: impl Fn(f64) -> f64) -> FilmColumn {
    let heat = problem.heat.as_ref().unwrap();
    let column = |held_conductance: Option<f64>, warmer: &dyn Fn(f64) -> f64| {
        let place = place(problem, held_conductance, |_, s| profile(s) + warmer(s));
        column_at(problem, heat, &place)
    };
    let conductance = column(None, &|_| 0.0).conductance;
    column(held.then_some(conductance), &warmer)
}

/// In pure rolling the pressure drives the same flow through a warmer film, whatever the fluid and the profile; at the old gradient it
/// would be more than twice as much. A Newtonian film is heated by the stress of the gradient that this takes.
///
/// Theory: The flow is held.
#[test]
fn a_held_flow_is_that_of_the_film_before() {
    for thins in [false, true] {
        let mut case = case(thins);
        case.motion = Motion::straight(case.motion.entrainment_speed, 0.0);
        let problem = problem(&case);
        let heights = &problem.plan.heat.as_ref().unwrap().column.heights;
        let mean = |column: &FilmColumn, i: usize| -> f64 {
            let points = column.heights.iter().zip(heights.weights());
            points.map(|(point, w)| w * point.velocity[i]).sum()
        };
        let warmer = |s: f64| 35.0 + 20.0 * s - 60.0 * s * s;
        let before = film_at(&problem, false, |_| 0.0);
        let same = film_at(&problem, true, |_| 0.0);
        let (free, held) = (
            film_at(&problem, false, warmer),
            film_at(&problem, true, warmer),
        );
        for i in 0..2 {
            // the plane's velocity is that of entrainment
            let driven = |column: &FilmColumn| mean(column, i) - [1.0, 0.0][i];
            assert_relative_eq!(driven(&held), driven(&before), max_relative = 1e-6);
            assert_relative_eq!(driven(&same), driven(&before), max_relative = 1e-12);
            assert!(driven(&free).abs() > 2.0 * driven(&before).abs());
        }
        if thins {
            continue;
        }
        // κ = Ψ/Ψ_warm, Ψ = ∫(s − s̄)²/μ ds; t = κ h∇p (s − s̄), Q = |t|²/μ
        let p = PRESSURE * problem.scales.pressure;
        let h = FILM * problem.scales.film;
        let law = &case.lubricant.viscosity;
        let fluidity = |s: f64, by: f64| (-law.ln_viscosity(p, profile(s) + by * warmer(s))).exp();
        let [[_, cold], [centre, warm]] = [0.0, 1.0].map(|by| {
            let centre = below(0.5, |s| s * fluidity(s, by)) / below(0.5, |s| fluidity(s, by));
            let conductance = below(0.5, |s| (s - centre).powi(2) * fluidity(s, by));
            [centre, conductance]
        });
        assert!(cold < 0.5 * warm, "{cold} {warm}");
        let unit = h * problem.scales.pressure / problem.scales.length;
        let gradient = GRADIENT[0].hypot(GRADIENT[1]) * unit * cold / warm;
        for (point, s) in held.heights.iter().zip(heights.points()) {
            let heat = h * (gradient * (s - centre)).powi(2) * fluidity(*s, 1.0);
            assert_relative_eq!(point.shear, heat, max_relative = 1e-5);
        }
    }
}

/// With the temperature of a node the heat of a held flow changes by itself, by the stress at mid-film, and by the pressure gradient.
///
/// Theory: The flow is held.
#[test]
fn heat_of_a_held_flow_by_temperature() {
    for (thins, slide) in [(false, 0.0), (false, SLIDE), (true, 0.0), (true, SLIDE)] {
        let mut case = case(thins);
        case.motion.slide_to_roll_ratio = slide;
        let problem = problem(&case);
        let column = &problem.plan.heat.as_ref().unwrap().column;
        let n = column.film.n();
        let away = |s: f64| 15.0 + 10.0 * s;
        let found = film_at(&problem, true, away);
        for m in 0..n {
            let node = problem.fluid.nodes().unwrap().points()[m];
            let [up, down] = [1e-3, -1e-3].map(|by| {
                let nudge = move |s: f64| if s == node { by } else { 0.0 };
                film_at(&problem, true, move |s| away(s) + nudge(s))
            });
            for (k, point) in found.heights.iter().enumerate().take(column.heights.n()) {
                let difference = (up.heights[k].shear - down.heights[k].shear) / 2e-3;
                let change = point.shear * found.thinning[m] * column.heights.shapes[k][m]
                    + point.by_stress[0] * found.stress_slopes[m][0]
                    + point.by_stress[1] * found.stress_slopes[m][1]
                    + point.by_gradient_factor * found.gradient_factor_slopes[m];
                let largest = found.heights.iter().fold(0.0_f64, |m, h| m.max(h.shear));
                assert_relative_eq!(change, difference, epsilon = 1e-5 * largest);
            }
        }
    }
}

/// A film of k = 0.13 W/(m·K) [1 − 2e-3/K (T − 313.15 K)] conducts k/h at each height by the temperature there, not by that of the inlet.
#[test]
fn the_film_conducts_by_its_own_temperature() {
    let problem = problem(&case(false));
    let heat = problem.heat.as_ref().unwrap();
    let heights = &problem.plan.heat.as_ref().unwrap().column.heights;
    let factor = LinearFactor::new(ISOTHERMAL, -2e-3, 0.0).unwrap();
    let conductivity = ConductivityLaw::linear(0.13, factor).unwrap();
    let law = Heat {
        conductivity,
        ..heat.clone()
    };
    let place = place(&problem, None, |_, s| profile(s));
    let found = column_at(&problem, &law, &place);
    let h = FILM * law.film;
    let mut largest = 0.0_f64;
    for (point, s) in found.heights.iter().zip(heights.points()) {
        let rise = profile(*s) - ISOTHERMAL;
        largest = largest.max(rise.abs());
        let k = 0.13 * (1.0 - 2e-3 * rise);
        assert_relative_eq!(point.conduction, k / h, max_relative = 1e-6);
    }
    assert!(largest > 5.0, "{largest}");
}

/// A line contact whose oil is glass in the middle (α = 40 1/GPa at 0.9 GPa, viscosity e^73 times that at ambient pressure), sheared by
/// Eyring's law: heat of h τ γ̇ with τ = τ_0 asinh(μγ̇/τ_0) at every height, by hand, where nothing drives the oil but sliding; and finite
/// where the pressure falls steeply.
#[test]
fn heat_of_a_film_that_is_all_but_solid() {
    let text = "[contact]\nkind = \"line\"\nradius = \"7.9 mm\"\nload = \"181 kN/m\"\n\
         [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\nentrainment_speed = \"0.1 m/s\"\nslide_to_roll_ratio = 1.0\n\
         [lubricant]\ntemperature = \"60 degC\"\ndensity = { law = \"dowson-higginson\", rho_0 = \"860 kg/m^3\", reference_temperature = \"60 degC\", beta = \"7e-4 1/K\" }\nviscosity = { law = \"roelands\", mu_0 = \"8.65 mPa.s\", alpha = \"40 1/GPa\", reference_temperature = \"60 degC\", beta = \"0.035 1/K\" }\nthermal_conductivity = \"0.13 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\nshear_thinning = { law = \"ree-eyring\", tau_0 = \"6 MPa\" }\n\
         [thermal]\n";
    let case = read(text);
    let problem = problem(&case);
    let law = problem.heat.as_ref().unwrap();
    let heights = &problem.plan.heat.as_ref().unwrap().column.heights;
    for pressure in [0.2, 0.5, 0.8, 0.9, 1.0, 1.1] {
        for gradient in [0.0, -0.1, -1.0, -30.0] {
            let place = FilmPlace {
                pressure_rate: 0.0,
                at: [0.0; 2],
                pressure,
                pressure_gradient: [gradient, 0.0],
                film: 0.03,
                filling: 1.0,
                temperature: [case.lubricant.temperature; MOST_NODES],
                held_conductance: None,
            };
            let found = column_at(&problem, law, &place);
            let held = FilmPlace {
                held_conductance: Some(found.conductance),
                ..place
            };
            let held = column_at(&problem, law, &held);
            println!("{pressure} {gradient} {found:?}");
            let h = place.film * law.film;
            let mu = case
                .lubricant
                .viscosity
                .viscosity(pressure * law.pressure, case.lubricant.temperature);
            let rate = case.motion.entrainment_speed / h;
            let stress = 6e6 * (mu * rate / 6e6).asinh();
            let of = |column: &FilmColumn| column.heights[..heights.n()].to_vec();
            for point in of(&found).iter().chain(&of(&held)) {
                assert!(
                    point.shear.is_finite() && point.compression.is_finite(),
                    "{pressure} {gradient}"
                );
                if gradient == 0.0 {
                    assert_relative_eq!(point.shear, h * stress * rate, max_relative = 1e-3);
                }
            }
        }
    }
}
