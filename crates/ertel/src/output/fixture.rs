//! A made-up solution with the shape of a real one, for tests: Hertz pressure with a spike and an
//! inlet tail, and a film with the horseshoe constriction.

use serde_json::json;

use crate::case::{BodyEcho, CaseEcho, FluidEcho};
use crate::contact::hertz::{deflection_profile, pressure_profile};
use crate::contact::{
    Contact, ContactKind, Groups, Hertz, Material, Motion, Scales, Shape, Supply,
};
use crate::params::{MeshParams, MeshPreset, SolverParams};
use crate::reference::film_formulas;
use crate::solution::Role;
use crate::solution::*;

pub(super) const MODULUS: f64 = 230.769_230_77e9;
pub(super) const FILM: f64 = 245e-9;
const STEEL: Material = Material {
    youngs_modulus: 210e9,
    poissons_ratio: 0.3,
};

pub(super) fn contact(kind: ContactKind) -> Contact {
    match kind {
        ContactKind::Circular => Contact::circular(0.016, 100.0),
        ContactKind::Elliptical => Contact::elliptical([0.016, 0.032], 100.0, 0.0),
        ContactKind::Line => Contact::line(0.015, 2e5),
        ContactKind::Roller => panic!("no made-up roller"),
    }
}

pub(super) fn case_echo(kind: ContactKind) -> CaseEcho {
    let steel = |role: &str| BodyEcho {
        name: format!("steel ({role})"),
        elasticity: STEEL,
    };
    CaseEcho {
        title: "Steel ball on steel plane, M ≈ 200, L ≈ 10".into(),
        given: json!({"contact": {"load": "100 N", "radius": "16 mm"}}),
        case_file: Some("[contact]\nload = \"100 N\"\nradius = \"16 mm\"\n".into()),
        contact: contact(kind),
        motion: Motion::straight(0.8, 0.5),
        machine: None,
        supply: Supply::Flooded,
        plane: steel("plane"),
        ball: steel("ball"),
        roughness: None,
        roughness_rules: Vec::new(),
        asperities: None,
        fluid: FluidEcho {
            name: "thesis oil".into(),
            viscosity_law: "Roelands".into(),
            shear_thinning: None,
            density_law: "Dowson-Higginson".into(),
            viscosity: 0.04,
            density: 870.0,
            pressure_viscosity: 22e-9,
            pressure_viscosity_asymptotic: Some(18.2e-9),
            estimates: Vec::new(),
        },
        temperature: 313.15,
        mesh: MeshParams::preset(MeshPreset::Normal, kind),
        solver: SolverParams::default(),
        thermal: None,
    }
}

/// Pressure over p_h at X, Y.
fn pressure(x: f64, y: f64) -> f64 {
    let r = x.hypot(y);
    let tail = if x < 0.0 {
        0.06 * (-(r - 0.95).powi(2) / 0.03).exp()
    } else {
        0.0
    };
    let spike = 0.35 * (-(r - 0.86_f64).powi(2) / 4e-4).exp() * (x / r.max(1e-9)).max(0.0).powi(2);
    pressure_profile(r) * (1.0 - 0.03 * x) + tail + spike
}

/// Film in m at X, Y; `gap` is the length a²/R.
fn film(kind: ContactKind, x: f64, y: f64, gap: f64) -> f64 {
    let r = x.hypot(y);
    let open = 0.5 * r * r + deflection_profile(kind, r) - deflection_profile(kind, 0.0);
    let lobe = match kind {
        ContactKind::Line => f64::from(u8::from(x > 0.0)),
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => {
            (0.5 + 0.9 * y.abs() / r.max(1e-9) - 0.45)
                .clamp(0.0, 1.0)
                .max(f64::from(u8::from(x > 0.0)) * 0.55)
                * f64::from(u8::from(x > -0.5))
        }
    };
    let dip = 0.6 * lobe * (-(r - 0.93).powi(2) / 6e-3).exp();
    FILM * (1.0 - dip) * (1.0 - 0.04 * x) + gap * open.max(0.0)
}

pub(super) fn solution(kind: ContactKind) -> Solution {
    let contact = contact(kind);
    let hertz = Hertz::new(&contact, MODULUS);
    let (a, p_h) = (hertz.half_width, hertz.pressure);
    let gap = a * a / contact.radius;
    let groups = Groups::new(&contact, MODULUS, 0.04, 0.8, 22e-9);
    let n = 60;
    // Denser towards the contact
    let xs: Vec<f64> = (0..=2 * n)
        .map(|i| f64::from(i) / f64::from(n) - 1.0)
        .map(|t| {
            if t < 0.0 {
                -4.5 * (-t).powf(1.4)
            } else {
                1.8 * t.powf(1.1)
            }
        })
        .collect();
    let ys: Vec<f64> = match kind {
        ContactKind::Line => vec![0.0],
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => (0..=n)
            .map(|j| -3.0 * (1.0 - f64::from(j) / f64::from(n)).powf(1.3))
            .collect(),
    };
    let nodes: Vec<[f64; 2]> = ys
        .iter()
        .flat_map(|y| xs.iter().map(move |x| [*x, *y]))
        .collect();
    let id = |i: usize, j: usize| (j * xs.len() + i) as u32;
    let cells: Vec<[u32; 3]> = match kind {
        ContactKind::Line => (0..xs.len() - 1)
            .map(|i| [id(i, 0), id(i + 1, 0), 0])
            .collect(),
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => (0..ys.len() - 1)
            .flat_map(|j| (0..xs.len() - 1).map(move |i| (i, j)))
            .flat_map(|(i, j)| {
                [
                    [id(i, j), id(i + 1, j), id(i + 1, j + 1)],
                    [id(i, j), id(i + 1, j + 1), id(i, j + 1)],
                ]
            })
            .collect(),
    };
    let pressures: Vec<f64> = nodes.iter().map(|[x, y]| p_h * pressure(*x, *y)).collect();
    let films: Vec<f64> = nodes.iter().map(|[x, y]| film(kind, *x, *y, gap)).collect();
    let deflections: Vec<f64> = nodes
        .iter()
        .map(|[x, y]| gap * deflection_profile(kind, x.hypot(*y)))
        .collect();
    let viscosities: Vec<f64> = pressures.iter().map(|p| 0.04 * (15e-9 * p).exp()).collect();
    let densities: Vec<f64> = pressures
        .iter()
        .map(|p| 870.0 * (1.0 + 0.6e-9 * p / (1.0 + 1.7e-9 * p)))
        .collect();
    let middle = nodes.len() - xs.len();
    let centreline = Centreline {
        x: xs.iter().map(|x| a * x).collect(),
        pressure: pressures[middle..].to_vec(),
        film_thickness: films[middle..].to_vec(),
        deflection: deflections[middle..].to_vec(),
        viscosity: viscosities[middle..].to_vec(),
        density: densities[middle..].to_vec(),
        hertz_pressure: xs.iter().map(|x| p_h * pressure_profile(*x)).collect(),
        shear: shear(xs.len()),
    };
    let located = |value: f64, x: f64, y: f64| Located {
        value,
        error: Some(5e-3 * value),
        resolved: true,
        x: a * x,
        y: a * y,
        place_error: Some(0.02 * a),
        place_resolved: true,
    };
    let lowest = films.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = pressures.iter().copied().fold(0.0, f64::max);
    let dim = kind.body_dimension() - 1;
    let linear = |values: &[f64]| {
        let corners = cells.iter().flat_map(|c: &[u32; 3]| &c[..=dim]);
        Polynomials {
            order: 1,
            values: corners.map(|n| values[*n as usize]).collect(),
        }
    };
    let elements = ElementFields {
        dim,
        vertices: nodes.iter().map(|p| p.map(|x| a * x)).collect(),
        pressure: linear(&pressures),
        film_thickness: linear(&films),
        temperatures: None,
        cells: cells.clone(),
    };
    let mut measured = Measured {
        half_width: a,
        ..Measured::default()
    };
    for (figure, value) in [(Figure::FilmCentral, FILM), (Figure::FilmMinimum, lowest)] {
        measured.figures.set(figure, Reading::new(value));
        measured.bars.set(
            figure,
            Bar {
                value: 0.8e-9,
                place: None,
            },
        );
    }
    Solution {
        measured,
        shape: Shape::new(&contact, &hertz, &Motion::straight(0.8, 0.5)),
        hertz,
        reduced_modulus: MODULUS,
        groups,
        groups_asymptotic: Some(Groups::new(&contact, MODULUS, 0.04, 0.8, 18.2e-9)),
        scales: Scales::new(&contact, &hertz, &Motion::straight(0.8, 0.5), 0.04, 870.0),
        extents: [4.5, 1.8, 3.0],
        summary: Summary {
            film_central: Estimate {
                value: FILM,
                error: Some(0.8e-9),
            },
            film_minimum: Estimate {
                value: lowest,
                error: Some(1.1e-9),
            },
            film_minimum_at: located(lowest, 0.3, -0.88),
            film_centreline_minimum: located(0.47 * FILM, 0.93, 0.0),
            pressure_maximum: located(highest, -0.05, 0.0),
            pressure_central: located(highest, -0.05, 0.0),
            pressure_ridge: None,
            spike: Some(located(0.86 * p_h, 0.86, 0.0)),
            outlet_position: bar(1.05 * a),
            pressure_minimum: -1.3e3,
            film_balance_error: 2e-4,
            load_balance_error: 3e-12,
            rigid_separation: -1.4e-6,
        },
        starvation: None,
        roller: None,
        mixed: None,
        traction: Traction {
            coefficient: bar(0.035),
            coefficient_body_1: bar(0.034),
            coefficient_body_2: bar(0.036),
            force: bar(3.5),
            across: None,
            moment: None,
            friction_power: bar(0.28),
            shear_stress_maximum: bar(2.2e7),
            beyond_first_limit: Some(bar(0.93)),
            beyond_second_limit: None,
        },
        thermal: None,
        sensitivities: None,
        uncertainty: None,
        summed_to: SummedTo {
            body_end_x: contact.radius,
            body_end_y: (kind != ContactKind::Line).then_some(contact.radius_y),
            ends_with_bodies: false,
        },
        checks: Checks {
            power: Balance::of(1.251, 1.25),
            rolling: Balance::of(2.5e-4, 2.5e-4),
            load: 3e-12,
            mass: 2e-4,
            heat: None,
        },
        film_reduction: Some(FilmReduction {
            central: bar(0.31),
            minimum: bar(0.28),
        }),
        formulas: film_formulas(&contact, &groups, 1.2),
        centreline,
        surface: SurfaceField {
            points: nodes.iter().map(|p| p.map(|x| a * x)).collect(),
            order: 1,
            elements: (cells.iter().flat_map(|c| &c[..=dim])).copied().collect(),
            cells,
            pressure: pressures,
            film_thickness: films,
            deflection: deflections,
            viscosity: viscosities,
            density: densities,
            shear: shear(nodes.len()),
        },
        elements,
        body: Some(body(kind, a)),
        history: history(),
        stats: Stats {
            warm: false,
            levels: vec![level(300, 7), level(2500, 4)],
            wall_seconds: 8.4,
            peak_memory: Some(412 << 20),
        },
        left_out: Neglected {
            heat: Some(NeglectedHeat {
                film_factor: Some(0.97),
                film_factor_missing: None,
                temperature_rise: 2.0,
                is_lower_bound: false,
            }),
            inertia: 7e-6,
            plasticity: 0.24,
            lambda: None,
        },
        unresolved: Vec::new(),
        warnings: vec![
            "the pressure leaves the range of the viscosity data (0.7 GPa)"
                .to_owned()
                .into(),
        ],
    }
}

/// One linear tetrahedron or triangle of size a.
fn body(kind: ContactKind, a: f64) -> BodyField {
    let n = kind.body_dimension() + 1;
    let corners = [[0.0; 3], [a, 0.0, 0.0], [0.0, 0.0, -a], [0.0, a, 0.0]];
    let lowered = [[0.0, 0.0, -1e-6], [0.0; 3], [0.0; 3], [0.0; 3]];
    BodyField {
        points: corners[..n].to_vec(),
        cells: vec![(0..n as u32).collect()],
        displacement: lowered[..n].to_vec(),
    }
}

fn shear(n: usize) -> ShearFields {
    ShearFields {
        stress_mid: vec![1e6; n],
        stress_body_1: vec![0.9e6; n],
        stress_body_2: vec![1.1e6; n],
        stress_across: Default::default(),
        rate_mid: vec![1e5; n],
        generalized_viscosity: vec![10.0; n],
    }
}

/// A figure with an error bar of 2 %.
fn bar(value: f64) -> Estimate {
    Estimate {
        value,
        error: Some(0.02 * value),
    }
}

fn level(n: usize, newton_iterations: usize) -> LevelStats {
    let mut figures = Figures::default();
    for (figure, value) in [
        (Figure::FilmCentral, FILM),
        (Figure::FilmMinimum, 0.5 * FILM),
        (Figure::PressureMaximum, 1e9),
    ] {
        figures.note(figure, Reading::new(value));
    }
    LevelStats {
        converged: true,
        n_body_cells: 10 * n,
        n_contact_elements: n,
        n_pressure_dofs: 5 * n,
        n_displacement_dofs: 40 * n,
        n_contact_dofs: 2 * n,
        pressure_order: 3,
        role: Role::Final,
        newton_iterations,
        krylov_iterations: 9 * newton_iterations,
        factorisations: newton_iterations,
        figures,
        estimate: None,
        seconds: Timings {
            mesh: 0.2,
            operator: 1.1,
            assembly: 0.6,
            factorisation: 0.5,
            krylov: 0.3,
            heat: 0.0,
            other: 0.1,
            estimate: 0.0,
        },
    }
}

fn history() -> Vec<IterationRecord> {
    let record = |level: usize, iteration: usize, residual: f64| IterationRecord {
        level,
        pressure_order: 3,
        penalty_share: 1.0,
        iteration,
        residual,
        update: 0.3 * residual.sqrt(),
        step: 1.0,
        krylov_iterations: 9,
        film_central: FILM,
        heat: None,
    };
    let first = [0.7, 0.2, 0.05, 8e-3, 3e-4, 1e-6, 1e-11].into_iter();
    let second = [0.02, 6e-4, 1e-6, 4e-12].into_iter();
    let number = |level| move |(i, r): (usize, f64)| record(level, i + 1, r);
    first
        .enumerate()
        .map(number(0))
        .chain(second.enumerate().map(number(1)))
        .collect()
}
