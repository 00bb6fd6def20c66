//! Cases, bodies and meshes that several verifications share.
#![allow(dead_code)]

#[path = "../../../ertel-quantity/tests/common/contains.rs"]
mod contains;
#[path = "../../../ertel-quantity/tests/common/near.rs"]
mod near;
pub mod rigid;
pub mod text;

use std::f64::consts::PI;

pub use contains::contains;
pub use near::near;

use ertel::case::{Body, Case, Lubricant};
use ertel::contact::roller::{Profile, Roller};
use ertel::contact::{Contact, ContactKind, Hertz, Material, Motion, Shape, reduced_modulus};
use ertel::engine::NoObserver;
use ertel::machine::{MachineFigures, figures};
use ertel::params::{MeshParams, MeshPreset, OutputParams, SolverParams, ThermalParams};
use ertel::solution::Solution;
use ertel::solve::discretisation::LevelSizes;
use ertel::study::{MachineSolution, solve_machine};
use ertel_rheology::density::{DowsonHigginson, ThermalExpansion};
use ertel_rheology::viscosity::Cheng;
use ertel_rheology::{ConductivityLaw, DensityLaw, HeatCapacityLaw, ViscosityLaw};

/// Steel.
pub const STEEL: Material = Material {
    youngs_modulus: 210e9,
    poissons_ratio: 0.3,
};

/// Glass of optical rigs.
pub const GLASS: Material = Material {
    youngs_modulus: 81e9,
    poissons_ratio: 0.208,
};

/// A short crowned roller, tilted by a milliradian.
pub fn roller() -> Roller {
    Roller {
        length: 1.2e-3,
        profile: Profile::Crown { crown_radius: 0.2 },
        misalignment: 1e-3,
    }
}

/// Steel on steel in a mineral oil after Roelands and Dowson-Higginson: R = 16 mm, 0.8 m/s; load
/// in N (circular) or N/m (line).
pub fn case(kind: ContactKind, load: f64) -> Case {
    let steel = Body::elastic("steel", STEEL);
    Case {
        stress: None,
        roughness_rules: Vec::new(),
        title: String::new(),
        contact: match kind {
            ContactKind::Elliptical => Contact::elliptical([0.016, 0.024], load, 0.4),
            ContactKind::Roller => Contact::of_roller(0.016, load, roller()),
            kind => Contact::of_one_radius(kind, 0.016, load),
        },
        body_1: steel.clone(),
        body_2: steel,
        body_radii: [f64::INFINITY; 2],
        roughness: None,
        asperities: None,
        motion: Motion::straight(0.8, 0.0),
        lubricant: Lubricant {
            name: None,
            temperature: 313.15,
            supply_temperature: None,
            density: DensityLaw::dowson_higginson(870.0).unwrap(),
            viscosity: ViscosityLaw::roelands(0.04, 22e-9).unwrap(),
            shear_thinning: None,
            thermal_conductivity: None,
            typical_conductivity: None,
            heat_capacity: None,
            temperature_ranges: Vec::new(),
            estimates: Vec::new(),
            is_shear_by_kind: false,
        },
        mesh: MeshParams::preset(MeshPreset::Coarse, kind),
        solver: SolverParams::default(),
        thermal: None,
        output: OutputParams {
            body_field: false,
            ..OutputParams::default()
        },
        warnings: Vec::new(),
        source: String::new(),
        given: serde_json::Value::Null,
        reliefs: Vec::new(),
        wear: None,
        transient: None,
        curve: None,
        whole: None,
        contacts: None,
        origin: None,
        machine: None,
        friction_by_law: false,
        supply: ertel::contact::Supply::Flooded,
    }
}

/// The same case with heat: a lubricant that temperature thins and expands, and the thermal data of steel and
/// glass after Habchi 2008, table 5.2.
pub fn heated(mut case: Case) -> Case {
    let body = |elasticity: Material, [density, conductivity, heat_capacity]: [f64; 3]| Body {
        density: Some(density),
        thermal_conductivity: Some(ConductivityLaw::constant(conductivity).unwrap()),
        heat_capacity: Some(HeatCapacityLaw::constant(heat_capacity).unwrap()),
        ..Body::elastic("heated", elasticity)
    };
    case.body_1 = body(GLASS, [2510.0, 1.114, 858.0]);
    case.body_2 = body(STEEL, [7850.0, 46.0, 470.0]);
    case.lubricant.density = DensityLaw::DowsonHigginson(
        DowsonHigginson::new(
            870.0,
            Some(ThermalExpansion {
                temperature_coefficient: 7e-4,
                reference_temperature: 313.15,
            }),
        )
        .unwrap(),
    );
    case.lubricant.viscosity =
        ViscosityLaw::Cheng(Cheng::new(0.04, 12e-9, 4000.0, 3e-6, 313.15).unwrap());
    case.lubricant.thermal_conductivity = Some(ConductivityLaw::constant(0.14).unwrap());
    case.lubricant.heat_capacity = Some(HeatCapacityLaw::constant(2000.0).unwrap());
    case.thermal = Some(ThermalParams::default());
    case
}

/// The same with load and pressure-viscosity coefficient from Moes's groups M and L
/// (U = μ₀u_m/(E'R); line: w = M E'R √(2U), circular: F = M E'R² (2U)^¾; α = L (2U)^(−¼)/E').
pub fn moes_case(kind: ContactKind, m: f64, l: f64) -> Case {
    let mut case = case(kind, 1.0);
    let modulus = reduced_modulus(case.body_1.elasticity, case.body_2.elasticity);
    let (viscosity, radius) = (0.04, case.contact.radius);
    let speed = 2.0 * viscosity * case.motion.entrainment_speed / (modulus * radius);
    case.contact.load = match kind {
        ContactKind::Line => m * modulus * radius * speed.sqrt(),
        ContactKind::Roller => m * modulus * radius * speed.sqrt() * roller().length,
        ContactKind::Circular | ContactKind::Elliptical => {
            m * modulus * radius * radius * speed.powf(0.75)
        }
    };
    let alpha = l / (speed.powf(0.25) * modulus);
    case.lubricant.viscosity = ViscosityLaw::roelands(viscosity, alpha).unwrap();
    case
}

/// Hertz pressure of a case, Pa.
pub fn hertz_pressure(case: &Case) -> f64 {
    Hertz::new(&case.contact, case.reduced_modulus()).pressure
}

/// The solution of a case that converges.
pub fn solved(case: &Case) -> Solution {
    ertel::run::solve(case, &mut NoObserver).unwrap_or_else(|e| panic!("{e}\n{}", case.source))
}

/// The case of a machine, its contacts, all of them solved, and its figures.
pub fn solved_machine(text: impl AsRef<str>) -> (Case, MachineSolution, MachineFigures) {
    let case = text::read(text);
    let solved = solve_machine(case.contacts.as_ref().unwrap(), &mut NoObserver);
    assert_eq!(solved.n_failed(), 0);
    let found = figures(&case, &solved);
    (case, solved, found)
}

/// The value of a figure of a machine.
pub fn value(found: &MachineFigures, name: &str) -> f64 {
    let figure = found.find(name).unwrap_or_else(|| panic!("no {name}"));
    figure.estimate.value
}

/// Figures of a machine by name, each within a relative tolerance.
pub fn assert_figures(found: &MachineFigures, expected: &[(&str, f64, f64)]) {
    for (name, expected, tolerance) in expected {
        let value = value(found, name);
        assert!(
            (value - expected).abs() <= tolerance * value.abs().max(expected.abs()),
            "{name}: {value}, expected {expected}"
        );
    }
}

/// Geometry of a line or a circular contact.
pub fn shape(kind: ContactKind) -> Shape {
    match kind {
        ContactKind::Line => Shape::LINE,
        ContactKind::Circular => Shape::CIRCULAR,
        ContactKind::Elliptical | ContactKind::Roller => {
            ertel::run::problem(&case(kind, 50.0)).shape
        }
    }
}

/// Pseudo-random numbers in [−1, 1].
pub fn noise(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    (0..n)
        .map(|_| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        })
        .collect()
}

/// A body of Young's modulus E/(R p_h/a) and Poisson's ratio.
pub fn material(youngs_modulus: f64, poissons_ratio: f64) -> Material {
    Material {
        youngs_modulus,
        poissons_ratio,
    }
}

/// Bodies whose reduced modulus E'/(R p_h/a) is that of a contact in Hertz's scales: π (circular),
/// 4 (line); 2/E' = Σ (1 − ν²)/E, shared equally.
pub fn hertz_bodies(kind: ContactKind, poissons_ratios: &[f64]) -> Vec<Material> {
    let reduced = match kind {
        ContactKind::Circular | ContactKind::Elliptical => PI,
        ContactKind::Line | ContactKind::Roller => 4.0,
    };
    (poissons_ratios.iter())
        .map(|nu| {
            let modulus = 0.5 * reduced * (1.0 - nu * nu) * poissons_ratios.len() as f64;
            Material {
                youngs_modulus: modulus,
                poissons_ratio: *nu,
            }
        })
        .collect()
}

/// Cells of one size on the contact area, which grow into the body.
pub fn uniform(size: f64) -> LevelSizes {
    LevelSizes {
        hertz: size,
        constriction: size,
        rim: size,
        outlet_rim: size,
        rim_width: 0.0,
        edge: size,
        growth: 1.0,
        depth_growth: 1.0,
    }
}

/// Largest difference of two lists over the largest value of the second.
pub fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let scale = b.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let off = a
        .iter()
        .zip(b)
        .fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()));
    off / scale
}
