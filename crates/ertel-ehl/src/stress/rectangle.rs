//! Half-space under uniform pressure and shear on rectangles, in closed form.
//!
//! ```text
//!   G, Φ, Ω: potentials of a load f whose waves are f e^(−kz) over k, k², k³
//!   pressure:     σ_xx = Φ_xx + 2ν Φ_yy − z G_xx    σ_yy = Φ_yy + 2ν Φ_xx − z G_yy    σ_zz = G_z − z G_zz
//!                 σ_xy = (1 − 2ν) Φ_xy − z G_xy     σ_xz = −z G_xz                    σ_yz = −z G_yz
//!   shear on the  σ_xx = 2 G_x − 2ν Ω_xyy + z Φ_xxx    σ_yy = −2ν Ω_xxx + z Φ_xyy     σ_zz = −z G_xz
//!   body along x: σ_xy = G_y + 2ν Ω_xxy + z Φ_xxy      σ_xz = G_z − z G_xx            σ_yz = −z G_xy
//!   of a corner at (X, Y), times 2π: G_x = ln(R + Y)   Φ_xy = −ln(R + z)   Ω_xyy = −Y/(R + z)   G_z = −arctan(X Y/(z R))
//! ```
//! The rectangle is the sum over its corners with alternating signs. Boussinesq and Cerruti; the pressure after Love (1929), the shear as in
//! Vergne (1985).

use std::f64::consts::PI;

use crate::layers::Harmonic;

/// Derivatives of the potentials at a corner, times 2π.
struct Corner {
    g: [f64; 3],
    /// G_xx, G_yy, G_xy, G_xz, G_yz.
    gg: [f64; 5],
    /// Φ_xx, Φ_yy, Φ_xy.
    ff: [f64; 3],
    /// Φ_xxx, Φ_xxy, Φ_xyy, Φ_yyy.
    fff: [f64; 4],
    /// Ω_xxx, Ω_xxy, Ω_xyy, Ω_yyy.
    ooo: [f64; 4],
}

/// Distances from a corner or an edge below this count as this: there the shear under a step of a shear load has no limit.
const NEAREST: f64 = 1e-150;

/// R + u without cancellation; `rest` is R² − u².
fn sum(r: f64, u: f64, rest: f64) -> f64 {
    let sum = if u >= 0.0 { r + u } else { rest / (r - u) };
    sum.max(NEAREST)
}

impl Corner {
    fn new(x: f64, y: f64, z: f64) -> Corner {
        let [xx, yy, zz] = [x * x, y * y, z * z];
        let r = (xx + yy + zz).sqrt().max(NEAREST);
        let (rx, ry, rz) = (sum(r, x, yy + zz), sum(r, y, xx + zz), r + z);
        let g_z = -(x * y).atan2(z * r);
        // R − z without cancellation.
        let less = (xx + yy) / rz;
        let f_xx = -(x * y * less).atan2(xx * r + z * yy);
        let (g_x, g_y) = (ry.ln(), rx.ln());
        let (g_xz, g_yz) = (z / (r * ry), z / (r * rx));
        let (f_xyy, f_xxy) = (-y / (r * rz), -x / (r * rz));
        let (o_xyy, o_xxy) = (-y / rz, -x / rz);
        Corner {
            g: [g_x, g_y, g_z],
            gg: [x / (r * ry), y / (r * rx), 1.0 / r, g_xz, g_yz],
            ff: [f_xx, g_z - f_xx, -rz.ln()],
            fff: [g_xz - f_xyy, f_xxy, f_xyy, g_yz - f_xxy],
            ooo: [-g_x - o_xyy, o_xxy, o_xyy, -g_y - o_xxy],
        }
    }
}

/// The part of a corner in the stresses at a depth z under unit pressure, unit shear along x and unit shear along y; (x, y): from the corner to
/// the point. Terms that vanish in the sum over the corners of a rectangle are left out.
pub(super) fn corner(x: f64, y: f64, z: f64, nu: f64) -> [[f64; 6]; 3] {
    let Corner {
        g: [g_x, g_y, g_z],
        gg: [g_xx, g_yy, g_xy, g_xz, g_yz],
        ff: [f_xx, f_yy, f_xy],
        fff: [f_xxx, f_xxy, f_xyy, f_yyy],
        ooo: [o_xxx, o_xxy, o_xyy, o_yyy],
    } = Corner::new(x, y, z);
    let two = 2.0 * nu;
    let pressure = [
        f_xx + two * f_yy - z * g_xx,
        f_yy + two * f_xx - z * g_yy,
        g_z + z * (g_xx + g_yy),
        (1.0 - two) * f_xy - z * g_xy,
        -z * g_xz,
        -z * g_yz,
    ];
    let shear_x = [
        2.0 * g_x - two * o_xyy + z * f_xxx,
        z * f_xyy - two * o_xxx,
        -z * g_xz,
        g_y + two * o_xxy + z * f_xxy,
        g_z - z * g_xx,
        -z * g_xy,
    ];
    let shear_y = [
        z * f_xxy - two * o_yyy,
        2.0 * g_y - two * o_xxy + z * f_yyy,
        -z * g_yz,
        g_x + two * o_xyy + z * f_xyy,
        -z * g_xy,
        g_z - z * g_yy,
    ];
    [pressure, shear_x, shear_y].map(|all| all.map(|s| s / (2.0 * PI)))
}

/// Derivatives of the potentials at a corner, times 2π: G_x, G_y, G_z, then Φ_xx, Φ_yy, Φ_xy, then Ω_xxx, Ω_xxy, Ω_xyy, Ω_yyy.
pub(super) type Image = [f64; 10];

/// Those of an image at a depth.
pub(super) fn image(x: f64, y: f64, z: f64) -> Image {
    let Corner { g, ff, ooo, .. } = Corner::new(x, y, z);
    std::array::from_fn(|i| match i {
        0..3 => g[i],
        3..6 => ff[i - 3],
        _ => ooo[i - 6],
    })
}

/// The part of a corner in the stresses of images with these weights, as [`corner`] has that of the loads themselves.
pub(super) fn images<'a>(
    images: impl Iterator<Item = (&'a Image, &'a Harmonic)>,
    nu: f64,
) -> [[f64; 6]; 3] {
    let mut sum = [[0.0; 6]; 3];
    for (potentials, [f, df, ddf, g, dg, ddg, t, dt]) in images {
        let [g_x, g_y, g_z, f_xx, f_yy, f_xy, o_xxx, o_xxy, o_xyy, o_yyy] = potentials;
        let (e, eta) = (nu * (ddf - f), nu * (g - ddg));
        let parts = [
            [
                -ddf * f_xx - e * f_yy,
                -ddf * f_yy - e * f_xx,
                f * g_z,
                -(ddf - e) * f_xy,
                -df * g_x,
                -df * g_y,
            ],
            [
                ddg * o_xxx - (eta + 2.0 * t) * o_xyy,
                (ddg + 2.0 * t) * o_xyy - eta * o_xxx,
                g * g_x,
                (ddg + eta + t) * o_xxy - t * o_yyy,
                dg * f_xx - dt * f_yy,
                (dg + dt) * f_xy,
            ],
            [
                (ddg + 2.0 * t) * o_xxy - eta * o_yyy,
                ddg * o_yyy - (eta + 2.0 * t) * o_xxy,
                g * g_y,
                (ddg + eta + t) * o_xyy - t * o_xxx,
                (dg + dt) * f_xy,
                dg * f_yy - dt * f_xx,
            ],
        ];
        for (sum, part) in sum.iter_mut().flatten().zip(parts.into_iter().flatten()) {
            *sum += part / (2.0 * PI);
        }
    }
    sum
}

/// Signs of the stresses where x and where y changes its sign, of the three loads of [`corner`] on a rectangle about the origin.
pub(super) const PARITY: [[[f64; 6]; 2]; 3] = [
    [
        [1.0, 1.0, 1.0, -1.0, -1.0, 1.0],
        [1.0, 1.0, 1.0, -1.0, 1.0, -1.0],
    ],
    [
        [-1.0, -1.0, -1.0, 1.0, 1.0, -1.0],
        [1.0, 1.0, 1.0, -1.0, 1.0, -1.0],
    ],
    [
        [1.0, 1.0, 1.0, -1.0, -1.0, 1.0],
        [-1.0, -1.0, -1.0, 1.0, -1.0, 1.0],
    ],
];
