//! Oil behind the film: only the oil that leaves the film is sheared there.

use crate::common::text::read;
use approx::assert_relative_eq;
use ertel::engine::NoObserver;
use ertel::params::Method;
use ertel::run::solve;
use ertel::solution::{Estimate, Solution};

const METHODS: [Method; 2] = [Method::FiniteElements, Method::FiniteVolumes];

/// A contact of steel with an oil of constant viscosity, its edges where they are given, solved by a method.
fn solved(contact: &str, motion: &str, mesh: &str, method: Method) -> Solution {
    let text = format!(
        "lubricant = {{ temperature = \"40 degC\", density = {{ law = \"constant\", rho_0 = \"870 kg/m^3\" }}, viscosity = {{ law = \"constant\", mu_0 = \
         \"40 mPa.s\" }} }}\n[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n[motion]\nentrainment_speed = \"1 m/s\"\n\
         slide_to_roll_ratio = 0.5\n{motion}\n[mesh]\n{mesh}\n"
    );
    let mut case = read(text);
    case.solver.method = Some(method);
    solve(&case, &mut NoObserver).unwrap()
}

/// Whether figures are the same within their bars.
fn assert_alike(found: &[Estimate]) {
    for (k, one) in found.iter().enumerate() {
        for other in &found[k + 1..] {
            let bars = one.error.unwrap() + other.error.unwrap();
            assert!((one.value - other.value).abs() < bars, "{found:?}");
        }
    }
}

/// A cylinder that hardly deforms has the film h₀ = 4.89497 u μ R/w under Reynolds' condition, which breaks at x₀ = 0.47513 W, W = √(2Rh₀) (Martin, Engineering 102,
/// 1916, 119). With x = W tan γ, h = h₀/cos²γ the sheared oil before and behind it, of which the gap is filled by the share h(γ₀)/h, gives
///
/// ```text
///   ∫θ dx/h = W/h₀ (γ₀ + ½π + [½(½π − γ₀) − ¼ sin 2γ₀]/cos²γ₀)
/// ```
/// as far as the bodies reach, which cuts off W/h₀ times 1/x and h(γ₀)/h₀ · ⅓/x³, wherever the edges of the contact area are.
///
/// Theory: Behind the film.
#[test]
fn a_rigid_cylinder_shears_the_oil_behind_it() {
    let (load, radius) = (200.0_f64, 0.016);
    let film = 4.894_97 * 0.04 * radius / load;
    let width = (2.0 * radius * film).sqrt();
    let (gamma, half) = (0.475_13_f64.atan(), std::f64::consts::FRAC_PI_2);
    let broken = 1.0 / gamma.cos().powi(2);
    let behind = broken * (0.5 * (half - gamma) - 0.25 * (2.0 * gamma).sin());
    let end = radius / width;
    let sum = gamma + half + behind - 1.0 / end - broken / (3.0 * end.powi(3));
    let exact = 0.04 * 0.5 * width / film * sum / load;
    let contact = "kind = \"line\"\nradius = \"16 mm\"\nload = \"200 N/m\"";
    let half_width = (8.0 * load * radius / (std::f64::consts::PI * 2.2e11)).sqrt();
    for method in METHODS {
        for outlet in [None, Some(1.5), Some(2.5)] {
            let mesh = outlet.map_or(String::new(), |x| {
                format!("outlet = {}", x * width / half_width)
            });
            let found = solved(contact, "", &mesh, method).traction.coefficient;
            println!("{method:?} {outlet:?}: {found:?}, {exact}");
            assert!((found.value - exact).abs() < found.error.unwrap() + 2e-3 * exact);
        }
    }
}

/// A light ball has one traction and friction power wherever the outlet edge is, by both methods.
///
/// Theory: Behind the film.
#[test]
fn the_outlet_edge_does_not_count() {
    let contact = "kind = \"circular\"\nradius = \"6.35 mm\"\nload = \"2 N\"";
    for method in METHODS {
        let found = [3.0, 10.0, 30.0].map(|outlet| {
            let mesh = format!("outlet = {outlet}\ntarget_error = 0.01");
            solved(contact, "", &mesh, method).traction
        });
        println!("{method:?}: {:?}", found.each_ref().map(|t| t.coefficient));
        assert_alike(&found.each_ref().map(|t| t.coefficient));
        assert_alike(&found.each_ref().map(|t| t.friction_power));
    }
}

/// The moment of spin is summed as far as the bodies reach: one value wherever the edges are.
///
/// Theory: Traction and heat.
#[test]
fn edges_do_not_decide_on_the_moment_of_spin() {
    let contact = "kind = \"circular\"\nradius = \"10 mm\"\nload = \"60 N\"";
    let spin = "body_1_spin = \"-1000 rad/s\"\nbody_2_spin = \"1500 rad/s\"";
    let found = ["", "inlet = -20\nside = 20\noutlet = 2"].map(|mesh| {
        let mesh = format!("{mesh}\ntarget_error = 0.02");
        solved(contact, spin, &mesh, Method::FiniteVolumes).traction
    });
    let moments = found.each_ref().map(|t| t.moment.unwrap());
    println!("{moments:?}");
    assert_alike(&moments);
    // Compared with the uncertainty from the end of the bodies, the edges count for little.
    assert_relative_eq!(moments[0].value, moments[1].value, max_relative = 0.01);
}
