//! Stresses of bodies with layers: the half-space of the material of each plane, and images of the loads.
//!
//! The difference between a wave in a layered body and one in a half-space of the material of the plane is a sum of waves that have passed an interface. It is met by images at
//! depths z_m, as the deflection is ([`crate::layers`]), whose stresses are closed forms, so that no load is repeated:
//!
//! ```text
//!   f − f_bare ≈ Σ f_m e^(−k z_m)    likewise f', f'', g, g', g'', t, t' of every plane
//!   lines:   σ_zz = −f_m E_p + g_m H_q    σ_xz = −f'_m H_p − g'_m E_q    σ_xx = f''_m E_p − g''_m H_q    E = −Im G(x + i z_m)/π    H = −Re G(x + i z_m)/π
//!   grids, pressure:   σ_zz = f G_z    σ_xz = −f' G_x    σ_yz = −f' G_y    σ_xy = −(f'' − e) Φ_xy    σ_xx = −f'' Φ_xx − e Φ_yy    e = ν (f'' − f)
//!   grids, shear q_x:  σ_zz = g G_x    σ_xz = g' Φ_xx − t' Φ_yy    σ_yz = (g' + t') Φ_xy           η = ν (g − g'')
//!                      σ_xx = g'' Ω_xxx − (η + 2t) Ω_xyy    σ_yy = (g'' + 2t) Ω_xyy − η Ω_xxx    σ_xy = (g'' + η + t) Ω_xxy − t Ω_yyy
//! ```

use std::f64::consts::PI;

use super::line::{Potentials, plane_strain};
use super::{Depths, Stress};
use crate::contact::Material;
use crate::layers::{Coated, Fit, Harmonic, Plane, geometric};

/// How a body responds at planes.
pub struct Response {
    /// Depths of the images; none without layers.
    pub(super) images: Vec<f64>,
    /// The planes.
    pub(super) planes: Vec<PlaneResponse>,
}

/// The material of a plane and its images.
pub(super) struct PlaneResponse {
    pub(super) depth: f64,
    pub(super) poisson: f64,
    /// f, f', f'', g, g', g'', t, t' of each image.
    pub(super) weights: Vec<Harmonic>,
}

/// The shallowest image over the thickness of the uppermost layer, and the deepest one over that of all layers and the largest depth.
const SHALLOWEST: f64 = 0.5;
const DEEPEST: f64 = 40.0;
/// Steps of the logarithm of the depths of images, and of the wave numbers that they are fitted to.
const STEP: f64 = 0.2;
const WAVE_STEP: f64 = 0.05;
/// The shortest wave over the shallowest image, and the longest over the deepest one.
const SHORTEST: f64 = 40.0;
const LONGEST: f64 = 0.01;

impl Response {
    /// Of a half-space of one material.
    pub fn bare(poissons_ratio: f64, depths: &Depths) -> Response {
        // The modulus has no effect.
        let substrate = Material {
            youngs_modulus: 1.0,
            poissons_ratio,
        };
        let layers = Vec::new();
        Response::new(&Coated { layers, substrate }, depths)
    }

    /// Of a body at all depths.
    pub fn new(body: &Coated, depths: &Depths) -> Response {
        Response::at(body, &depths.all(), depths.largest)
    }

    /// Of a body at planes down to a depth.
    pub(super) fn at(body: &Coated, planes: &[Plane], largest: f64) -> Response {
        let poisson = |plane: &Plane| body.material(plane.part).poissons_ratio;
        let bare = |plane: &Plane| PlaneResponse {
            depth: plane.depth,
            poisson: poisson(plane),
            weights: Vec::new(),
        };
        let mut response = Response {
            images: Vec::new(),
            planes: planes.iter().map(bare).collect(),
        };
        let (Some(first), Some(thickness)) = (body.layers.first(), body.interfaces().pop()) else {
            return response;
        };
        let ends = [
            SHALLOWEST * first.thickness,
            DEEPEST * (thickness + largest),
        ];
        let count = |step: f64, [from, to]: [f64; 2]| ((to / from).ln() / step).ceil() as usize + 1;
        let waves = [LONGEST / ends[1], SHORTEST / ends[0]];
        let fit = Fit::new(
            geometric(ends, count(STEP, ends)),
            geometric(waves, count(WAVE_STEP, waves)),
        );
        let rest: Vec<Vec<Harmonic>> = (fit.waves.iter())
            .map(|k| difference(body, *k, planes))
            .collect();
        for (i, plane) in response.planes.iter_mut().enumerate() {
            plane.weights = vec![[0.0; 8]; fit.depths.len()];
            for component in 0..8 {
                let values: Vec<f64> = rest.iter().map(|all| all[i][component]).collect();
                let weights = fit.weights(&values);
                for (own, weight) in plane.weights.iter_mut().zip(weights.iter()) {
                    own[component] = *weight;
                }
            }
        }
        response.images = fit.depths;
        response
    }

    /// Stresses of all planes below x of a line contact, from G and −G' of its loads at x + iz.
    pub(super) fn line(&self, potentials: impl Fn(f64) -> Potentials) -> Vec<Stress> {
        let images: Vec<Potentials> = self.images.iter().map(|z| potentials(*z)).collect();
        let plane = |plane: &PlaneResponse| {
            let nu = plane.poisson;
            let mut stress = plane_strain(&potentials(plane.depth), plane.depth, nu);
            for (image, [f, df, ddf, g, dg, ddg, ..]) in images.iter().zip(&plane.weights) {
                let [p, q] = image.first.map(|g| g * (-1.0 / PI));
                let xx = ddf * p.im - ddg * q.re;
                let zz = g * q.re - f * p.im;
                let xz = -df * p.re - dg * q.im;
                stress += Stress([xx, nu * (xx + zz), zz, 0.0, xz, 0.0]);
            }
            stress
        };
        self.planes.iter().map(plane).collect()
    }
}

/// Waves at planes less those of half-spaces of the materials there.
pub(super) fn difference(body: &Coated, k: f64, planes: &[Plane]) -> Vec<Harmonic> {
    let mut all = body.harmonic(k, planes);
    for (own, plane) in all.iter_mut().zip(planes) {
        let bare = Coated {
            layers: Vec::new(),
            substrate: body.material(plane.part),
        };
        let other = bare.harmonic(k, &[Plane { part: 0, ..*plane }]);
        for (own, other) in own.iter_mut().zip(other[0]) {
            *own -= other;
        }
    }
    all
}
