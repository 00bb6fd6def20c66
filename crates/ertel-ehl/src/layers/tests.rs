//! Layers against values from outside, and their limits.

use approx::assert_relative_eq;

use super::{Coated, Images, Layer, Plane};
use crate::contact::Material;

fn material(youngs_modulus: f64, poissons_ratio: f64) -> Material {
    Material {
        youngs_modulus,
        poissons_ratio,
    }
}

/// Layers by modulus, Poisson's ratio and thickness, on a body of modulus 1.
pub(crate) fn coated(layers: &[[f64; 3]], poisson: f64) -> Coated {
    let layer = |[e, nu, thickness]: &[f64; 3]| Layer {
        thickness: *thickness,
        material: material(*e, *nu),
    };
    Coated {
        layers: layers.iter().map(layer).collect(),
        substrate: material(1.0, poisson),
    }
}

/// Layers (E, ν, thickness), ν of the substrate, and rows of wave number and response.
type Stack = (&'static [[f64; 3]], f64, [[f64; 2]; 4]);

/// C/C of the substrate by an exact linear system of all interface conditions, for one to three layers: wave number and w k G/((1 − ν) p) of the
/// substrate.
const STACKS: &[Stack] = &[
    (
        &[[2.0, 0.3, 1.0]],
        0.3,
        [
            [0.02, 0.992_984_707],
            [0.1, 0.969_496_593],
            [1.0, 0.739_808_802],
            [3.0, 0.516_889_779],
        ],
    ),
    (
        &[[2.0, 0.3, 0.5], [2.0, 0.3, 0.5]],
        0.3,
        [
            [0.02, 0.992_984_707],
            [0.1, 0.969_496_593],
            [1.0, 0.739_808_802],
            [3.0, 0.516_889_779],
        ],
    ),
    (
        &[[3.0, 0.25, 0.5], [0.5, 0.35, 0.5]],
        0.3,
        [
            [0.02, 0.997_914_345],
            [0.1, 0.992_256_045],
            [1.0, 1.034_766_84],
            [3.0, 0.621_041_901],
        ],
    ),
    (
        &[[4.0, 0.22, 0.2], [2.0, 0.25, 0.3], [1.5, 0.28, 0.5]],
        0.3,
        [
            [0.02, 0.994_122_752],
            [0.1, 0.973_766_79],
            [1.0, 0.763_537_223],
            [3.0, 0.488_190_868],
        ],
    ),
    (
        &[[0.05, 0.48, 1.0]],
        0.3,
        [
            [0.02, 1.014_340_65],
            [0.1, 1.080_573_35],
            [1.0, 5.176_431_31],
            [3.0, 15.260_466_3],
        ],
    ),
];

#[test]
fn stacks_under_waves() {
    for (layers, poisson, rows) in STACKS {
        let body = coated(layers, *poisson);
        for [k, known] in rows {
            let found = body.normal(*k) / body.of_long_waves();
            assert_relative_eq!(found, *known, max_relative = 1e-8);
        }
    }
}

/// E₁/E₂, ν₁, ν₂, kh; normal displacement by pressure, displacement along by shear, and along by pressure, over those of the uppermost layer (the last
/// one over p/2kG₁), by an exact linear system.
const HARMONIC: &[[f64; 7]] = &[
    [
        0.1,
        0.3,
        0.3,
        0.01,
        0.1038179636,
        0.1146314633,
        0.04069618181,
    ],
    [0.25, 0.3, 0.3, 0.5, 0.4130336403, 0.7377799673, 0.110751806],
    [0.5, 0.3, 0.3, 3.0, 0.9729907247, 0.9856559494, 0.3725320163],
    [1.0, 0.3, 0.3, 0.5, 1.0, 1.0, 0.4],
    [1.0, 0.2, 0.4, 0.1, 0.908122456, 0.8793485708, 0.2946034531],
    [1.0, 0.2, 0.4, 1.5, 1.029181813, 0.9991866098, 0.6146103218],
];

#[test]
fn layer_under_waves_of_pressure_and_shear() {
    for [e, nu_1, nu_2, kh, normal, along, across] in HARMONIC {
        let body = coated(&[[*e, *nu_1, 1.0]], *nu_2);
        let found = body.compliance(*kh);
        let shear = e / (2.0 * (1.0 + nu_1));
        let factor = shear / (1.0 - nu_1);
        for (own, known) in [
            (found[(1, 0)] * factor, normal),
            (-found[(0, 1)] * factor, along),
            (-2.0 * shear * found[(0, 0)], across),
        ] {
            assert_relative_eq!(own, *known, max_relative = 2e-9);
        }
    }
}

/// No layer, a layer of the same material, one of no thickness, and one without end.
#[test]
fn limits() {
    let bare = coated(&[], 0.3);
    for k in [1e-3, 1.0, 40.0] {
        let of = |layers: &[[f64; 3]]| coated(layers, 0.3).normal(k);
        let known = 0.91;
        assert_relative_eq!(bare.normal(k), known, max_relative = 1e-14);
        assert_relative_eq!(of(&[[1.0, 0.3, 0.7]]), known, max_relative = 1e-13);
        assert_relative_eq!(of(&[[3.0, 0.2, 1e-12]]), known, max_relative = 1e-9);
        let thick = 0.96 / 3.0;
        assert_relative_eq!(of(&[[3.0, 0.2, 1e6]]), thick, max_relative = 1e-13);
    }
}

/// Images meet the waves of all stacks between those of their fit, the longest one exactly.
#[test]
fn images_deflect_like_layers() {
    for (layers, poisson, _) in STACKS {
        let body = coated(layers, *poisson);
        let images = Images::of(&[body.clone(), coated(&[], 0.2)]);
        let other = 0.96;
        let size = body.of_long_waves().max(body.of_short_waves());
        for i in 0..200 {
            let k = 1e-5 * 1e7_f64.powf(f64::from(i) / 199.0);
            let error = images.normal(k) - other - body.normal(k);
            assert!(error.abs() < 1e-7 * size, "{layers:?} {k} {error}");
        }
        let far = images.normal(0.0) - other;
        assert_relative_eq!(far, body.of_long_waves(), max_relative = 1e-9);
    }
}

/// f' and f'' are the derivatives of f by the depth, in all layers, and t' that of t; the surface carries the loads.
#[test]
fn stresses_under_waves() {
    let (step, k) = (1e-5, 1.3);
    for (layers, poisson, _) in STACKS {
        let body = coated(layers, *poisson);
        let ends: Vec<f64> = std::iter::once(0.0).chain(body.interfaces()).collect();
        for (part, top) in ends.iter().enumerate() {
            let planes = [-1.0, 0.0, 1.0].map(|i| Plane {
                depth: top + 0.1 + i * step,
                part,
            });
            let found = body.harmonic(k, &planes);
            for (function, derivative) in [(0, 1), (1, 2), (3, 4), (4, 5), (6, 7)] {
                let slope = (found[2][function] - found[0][function]) / (2.0 * k * step);
                assert_relative_eq!(slope, found[1][derivative], epsilon = 1e-8);
            }
        }
        let surface = body.harmonic(
            k,
            &[Plane {
                depth: 0.0,
                part: 0,
            }],
        )[0];
        for (i, known) in [(0, 1.0), (1, 0.0), (3, 0.0), (4, 1.0), (7, -1.0)] {
            assert_relative_eq!(surface[i], known, epsilon = 1e-12);
        }
    }
}
