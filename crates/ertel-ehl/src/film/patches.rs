//! Properties over pressure and temperature, read from polynomials on a grid of patches.
//!
//! ```text
//!   v(P, T) ≈ Σ c_kl xᵏ yˡ,   x, y ∈ [−1, 1] the coordinates of a patch
//! ```
//! interpolates the laws at Chebyshev points. A patch is computed on first use; the laws themselves
//! are evaluated where it would not be accurate, and beyond the grid.

use std::sync::OnceLock;

use super::thermal::Jet2;

/// Patches to each p_h, and how far they reach, in p_h.
const PER_UNIT: f64 = 32.0;
const REACH: f64 = 1.5;

/// Size of a patch, K, and the lowest and highest temperature of the grid, from a given one.
const SIZE: f64 = 8.0;
const LOWEST: f64 = -64.0;
const HIGHEST: f64 = 416.0;

/// Coefficients by P and by T.
const NP: usize = 10;
const NT: usize = 8;

/// Errors of value, of slopes and of curvatures, by units of P and by patches of T, that a patch may have at its
/// corners and its middle. Those of the curvatures, which only the Jacobian uses, are mostly round-off.
const ERRORS: [f64; 3] = [1e-12, 1e-9, 1e-6];

type Coefficients = [[f64; NT]; NP];

/// ρ̄ and ln μ̄ on one patch.
#[derive(Clone, Debug)]
struct Patch([Coefficients; 2]);

/// The grid.
#[derive(Clone, Debug)]
pub(super) struct Patches {
    /// Lowest temperature, K.
    lowest: f64,
    /// `[p * n_temperature + t]`; empty where the laws are no smooth functions.
    patches: Vec<OnceLock<Option<Box<Patch>>>>,
}

/// Numbers of patches by P and T.
const N_PRESSURE: usize = (REACH * PER_UNIT) as usize;
const N_TEMPERATURE: usize = ((HIGHEST - LOWEST) / SIZE) as usize;

/// The laws: ρ̄ and ln μ̄ at P and T (K).
pub(super) trait Laws {
    /// Values.
    fn values(&self, pressure: f64, temperature: f64) -> [f64; 2];
    /// Values and derivatives.
    fn jets(&self, pressure: f64, temperature: f64) -> [Jet2; 2];
}

impl Patches {
    /// Patches around a temperature in K, or none.
    pub fn new(temperature: f64, smooth: bool) -> Patches {
        let n = if smooth {
            N_PRESSURE * N_TEMPERATURE
        } else {
            0
        };
        Patches {
            lowest: temperature + LOWEST,
            patches: vec![OnceLock::new(); n],
        }
    }

    /// The properties at one P ≥ 0.
    pub fn at<'a, L: Laws>(&'a self, laws: &'a L, pressure: f64) -> Isobar<'a, L> {
        Isobar {
            table: self,
            laws,
            pressure,
            index: usize::MAX,
            by_temperature: None,
        }
    }

    fn patch(&self, laws: &impl Laws, p: usize, t: usize) -> Option<&Patch> {
        if p >= N_PRESSURE || t >= N_TEMPERATURE {
            return None;
        }
        let patch = self.patches.get(p * N_TEMPERATURE + t)?;
        patch.get_or_init(|| self.make(laws, p, t)).as_deref()
    }

    #[cold]
    fn make(&self, laws: &impl Laws, p: usize, t: usize) -> Option<Box<Patch>> {
        let ([x_nodes, by_p], [y_nodes, by_t]) = (interpolation::<NP>(), interpolation::<NT>());
        let place = |x: f64, y: f64| {
            let pressure = (p as f64 + 0.5 + 0.5 * x) / PER_UNIT;
            (pressure, self.lowest + (t as f64 + 0.5 + 0.5 * y) * SIZE)
        };
        // The change from the middle is interpolated: powers cancel, and round-off with them.
        let (pressure, temperature) = place(0.0, 0.0);
        let middle = laws.values(pressure, temperature);
        let mut patch = Patch([[[0.0; NT]; NP]; 2]);
        for i in 0..NP {
            // over T at the pressure of node i
            let mut row = [[0.0; NT]; 2];
            for j in 0..NT {
                let (pressure, temperature) = place(x_nodes[0][i], y_nodes[0][j]);
                let values = laws.values(pressure, temperature);
                for ((row, value), middle) in row.iter_mut().zip(values).zip(middle) {
                    for l in 0..NT {
                        row[l] += by_t[l][j] * (value - middle);
                    }
                }
            }
            for (coefficients, row) in patch.0.iter_mut().zip(&row) {
                for k in 0..NP {
                    for l in 0..NT {
                        coefficients[k][l] += by_p[k][i] * row[l];
                    }
                }
            }
        }
        for (coefficients, middle) in patch.0.iter_mut().zip(middle) {
            coefficients[0][0] += middle;
        }
        let places = [
            [-1.0, -1.0],
            [-1.0, 1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [0.0, 0.0],
        ];
        let good = places.into_iter().all(|[x, y]| {
            let (pressure, temperature) = place(x, y);
            let ours = patch.over_temperature(x).map(|v| jet(&v, y));
            let theirs = laws.jets(pressure, temperature);
            ours.iter().zip(&theirs).all(|(a, b)| {
                let close = |a: f64, b: f64, unit: f64, k: usize| {
                    (a - b).abs() * unit <= ERRORS[k] * (1.0 + b.abs() * unit)
                };
                close(a.value, b.value, 1.0, 0)
                    && close(a.p, b.p, 1.0, 1)
                    && close(a.t, b.t, SIZE, 1)
                    && close(a.pp, b.pp, 1.0, 2)
                    && close(a.pt, b.pt, SIZE, 2)
            })
        });
        good.then(|| Box::new(patch))
    }
}

impl Patch {
    /// Coefficients by yˡ of the values and their first two derivatives by P at x.
    #[inline(always)]
    fn over_temperature(&self, x: f64) -> [[[f64; NT]; 3]; 2] {
        let scale = 2.0 * PER_UNIT;
        self.0.each_ref().map(|coefficients| {
            let (mut value, mut first, mut half) = ([0.0; NT], [0.0; NT], [0.0; NT]);
            for row in coefficients.iter().rev() {
                for l in 0..NT {
                    half[l] = half[l] * x + first[l];
                    first[l] = first[l] * x + value[l];
                    value[l] = value[l] * x + row[l];
                }
            }
            [
                value,
                first.map(|v| v * scale),
                half.map(|v| v * (2.0 * scale * scale)),
            ]
        })
    }
}

/// Value and derivatives at y.
#[inline(always)]
fn jet([value, by_p, by_pp]: &[[f64; NT]; 3], y: f64) -> Jet2 {
    let mut jet = Jet2::default();
    for l in (0..NT).rev() {
        jet.t = jet.t * y + jet.value;
        jet.pt = jet.pt * y + jet.p;
        jet.value = jet.value * y + value[l];
        jet.p = jet.p * y + by_p[l];
        jet.pp = jet.pp * y + by_pp[l];
    }
    jet.t *= 2.0 / SIZE;
    jet.pt *= 2.0 / SIZE;
    jet
}

/// The properties at one pressure.
pub(super) struct Isobar<'a, L> {
    table: &'a Patches,
    laws: &'a L,
    pressure: f64,
    /// Patch by T that was used last, and its polynomials there.
    index: usize,
    by_temperature: Option<[[[f64; NT]; 3]; 2]>,
}

impl<L: Laws> Isobar<'_, L> {
    /// ρ̄ and ln μ̄ at a temperature in K.
    #[inline(always)]
    pub fn at(&mut self, temperature: f64) -> [Jet2; 2] {
        let place = (temperature - self.table.lowest) * (1.0 / SIZE);
        // below the grid: nowhere
        let index = if place >= 0.0 {
            place as usize
        } else {
            N_TEMPERATURE
        };
        if index != self.index {
            self.index = index;
            let p = self.pressure * PER_UNIT;
            let x = 2.0 * (p - p.floor()) - 1.0;
            let patch = self.table.patch(self.laws, p as usize, index);
            self.by_temperature = patch.map(|patch| patch.over_temperature(x));
        }
        match &self.by_temperature {
            Some(by_temperature) => {
                let y = 2.0 * (place - place.floor()) - 1.0;
                by_temperature.each_ref().map(|v| jet(v, y))
            }
            None => self.laws.jets(self.pressure, temperature),
        }
    }
}

/// N Chebyshev points (as the first row) and the matrix from values there to coefficients of powers.
fn interpolation<const N: usize>() -> [[[f64; N]; N]; 2] {
    let angle = |i: usize| std::f64::consts::PI * (i as f64 + 0.5) / N as f64;
    let mut nodes = [[0.0; N]; N];
    nodes[0] = std::array::from_fn(|i| angle(i).cos());
    // Powers of each Chebyshev polynomial: T_{n+1} = 2x T_n − T_{n−1}.
    let mut powers = [[0.0; N]; N];
    for n in 0..N {
        for k in 0..N {
            powers[n][k] = match n {
                0 => f64::from(u8::from(k == 0)),
                1 => f64::from(u8::from(k == 1)),
                _ => {
                    let shifted = if k > 0 {
                        2.0 * powers[n - 1][k - 1]
                    } else {
                        0.0
                    };
                    shifted - powers[n - 2][k]
                }
            };
        }
    }
    let mut matrix = [[0.0; N]; N];
    for k in 0..N {
        for i in 0..N {
            for n in 0..N {
                let weight = if n == 0 { 1.0 } else { 2.0 } / N as f64;
                matrix[k][i] += powers[n][k] * weight * (n as f64 * angle(i)).cos();
            }
        }
    }
    [nodes, matrix]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::cell::Cell;

    /// Laws in closed form; counts how often their derivatives are asked for.
    struct Smooth {
        corner: f64,
        asked: Cell<usize>,
    }

    impl Laws for Smooth {
        fn values(&self, p: f64, t: f64) -> [f64; 2] {
            self.jets(p, t).map(|jet| jet.value)
        }

        fn jets(&self, p: f64, t: f64) -> [Jet2; 2] {
            self.asked.set(self.asked.get() + 1);
            // ln μ̄ = 2000 (1 + p)/(t − 100), ρ̄ = ln(1 + p/2) + |t − corner|/100
            let (u, side) = (t - 100.0, (t - self.corner).signum());
            let rho = Jet2 {
                value: (1.0 + 0.5 * p).ln() + side * (t - self.corner) / 100.0,
                p: 0.5 / (1.0 + 0.5 * p),
                t: side / 100.0,
                pp: -0.25 / (1.0 + 0.5 * p).powi(2),
                pt: 0.0,
            };
            let ln_mu = Jet2 {
                value: 2000.0 * (1.0 + p) / u,
                p: 2000.0 / u,
                t: -2000.0 * (1.0 + p) / (u * u),
                pp: 0.0,
                pt: -2000.0 / (u * u),
            };
            [rho, ln_mu]
        }
    }

    #[test]
    fn patches_match_closed_forms() {
        let laws = Smooth {
            corner: 403.0,
            asked: Cell::new(0),
        };
        let table = Patches::new(313.0, true);
        for i in 0..400 {
            for j in 0..23 {
                // beyond both ends of the grid, too
                let (p, t) = (i as f64 * 0.0041, 240.0 + 22.3 * j as f64);
                let ours = table.at(&laws, p).at(t);
                for (a, b) in ours.iter().zip(laws.jets(p, t)) {
                    assert_relative_eq!(a.value, b.value, max_relative = 1e-13, epsilon = 1e-13);
                    assert_relative_eq!(a.p, b.p, max_relative = 1e-9, epsilon = 1e-9);
                    assert_relative_eq!(a.t, b.t, max_relative = 1e-9, epsilon = 1e-10);
                    assert_relative_eq!(a.pp, b.pp, epsilon = 1e-6);
                    assert_relative_eq!(a.pt, b.pt, max_relative = 1e-8, epsilon = 1e-9);
                }
            }
        }
    }

    /// The corner of the density at 403 K is left to the laws, others are not.
    #[test]
    fn corners_are_left_to_the_laws() {
        let laws = Smooth {
            corner: 403.0,
            asked: Cell::new(0),
        };
        let table = Patches::new(313.0, true);
        let asked = |t: f64| {
            table.at(&laws, 0.5).at(t);
            let before = laws.asked.get();
            table.at(&laws, 0.5).at(t);
            laws.asked.get() - before
        };
        assert_eq!(asked(402.0), 1);
        assert_eq!(asked(380.0), 0);
        assert_eq!(asked(313.0 + HIGHEST + 1.0), 1);
        assert_eq!(asked(313.0 + LOWEST - 1.0), 1);
    }
}
