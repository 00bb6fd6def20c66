//! The fluidity of a shear-thinning fluid at one pressure, with its derivatives.
//!
//! ```text
//!   f(x, P) = A(S²x) B(k(P) x),  k = S²/τ_L²        x = |t|², stresses in units of S
//! ```
//! A is the thinning law, a function of stress alone, and B the limiting stress. A closure asks for A
//! hundreds of times; where A varies by powers it is read from a table.
//!
//! Theory: Evaluation of the law.

use std::sync::Arc;

use ertel_rheology::shear::{ReeEyring, ShearLaw, ShearThinning, StressLimit};
use num_dual::{Dual2_64, DualNum};

use super::lanes::Lanes;
use super::quintic::Quintic;
use super::stress_scales::{LimitScale, StressScales};

/// f and its derivatives by x and P.
#[derive(Clone, Copy, Debug, Default)]
pub struct Jet {
    /// f.
    pub f: f64,
    /// ∂f/∂x.
    pub x: f64,
    /// ∂f/∂P.
    pub p: f64,
    /// ∂²f/∂x².
    pub xx: f64,
    /// ∂²f/∂x∂P.
    pub xp: f64,
    /// ∂²f/∂P².
    pub pp: f64,
}

/// Relative fluidity f = μ₁/η at one pressure.
pub trait Fluidity {
    /// f and ∂f/∂x at the square of the stress, but for the factor of the height.
    fn slope(&self, stress_squared: f64) -> [f64; 2];
    /// Factor of f at heights s of the film.
    #[inline(always)]
    fn factors(&self, _s: Lanes) -> Lanes {
        Lanes::all(1.0)
    }
    /// The same at one height.
    #[inline(always)]
    fn factor(&self, s: f64) -> f64 {
        self.factors(Lanes::all(s)).0[0]
    }
    /// Requirements on a quadrature across the film.
    fn scales(&self) -> StressScales;
    /// Whether f is the same above and below mid-film.
    fn is_symmetric(&self) -> bool {
        true
    }
}

/// Relative fluidity that is the same at every height of the film.
pub trait UniformFluidity: Fluidity {
    /// f and its derivatives at the square of the stress.
    fn jet(&self, stress_squared: f64) -> Jet;
    /// Whether f depends on P.
    fn depends_on_pressure(&self) -> bool;
}

/// A shear-thinning law prepared for many evaluations.
#[derive(Debug)]
pub struct Thinning {
    /// The law.
    pub law: ShearThinning,
    table: Option<Arc<FluidityTable>>,
}

impl Thinning {
    /// Prepares a law.
    pub fn new(law: &ShearThinning) -> Thinning {
        let scales = law.scales(0.0);
        let table = match (&law.law, scales.knee) {
            (Some(thinning), Some(knee)) => Some(Arc::new(FluidityTable::new(thinning, knee))),
            _ => None,
        };
        Thinning {
            law: law.clone(),
            table,
        }
    }

    /// The same law with exponentials that grow less, by a factor `softness` ≥ 1 in the stress of an e-fold beyond a limiting
    /// stress, and by its root in Eyring's stress.
    ///
    /// ε = (1 − r₁²)/(2r₁), hence r₁ = √(1 + ε²) − ε
    pub fn softened(&self, softness: f64) -> Thinning {
        let limit = self.law.limit.as_ref().map(|limit| {
            let fold = softness * limit.e_fold();
            limit.softened(fold.hypot(1.0) - fold)
        });
        let law = match &self.law.law {
            Some(ShearLaw::ReeEyring(law)) => Some(ShearLaw::ReeEyring(ReeEyring {
                eyring_stress: softness.sqrt() * law.eyring_stress,
            })),
            law => law.clone(),
        };
        Thinning {
            law: ShearThinning { law, limit },
            table: self.table.clone(),
        }
    }

    /// The law at P, in units of a stress and a pressure, both in Pa.
    pub fn at(&self, pressure: f64, stress_unit: f64, pressure_unit: f64) -> PointThinning<'_> {
        let p = Dual2_64::from_re(pressure).derivative() * pressure_unit;
        let limit = self.law.limit.as_ref().map(|limit| {
            let relative = limit.limiting_stress(p) / stress_unit;
            let unit = Dual2_64::from_re(limit.ambient_limit).powi(2);
            (limit, (relative * relative).recip(), unit.re)
        });
        let scales = self.law.scales(p.re);
        let scaled = |stress: Option<f64>| stress.map(|s| s / stress_unit);
        PointThinning {
            thinning: self,
            square: stress_unit * stress_unit,
            limit,
            scales: StressScales {
                knee: scaled(scales.knee),
                growth: scaled(scales.growth),
                limit: scaled(scales.limit)
                    .zip(self.law.limit.as_ref())
                    .map(|(stress, limit)| LimitScale {
                        stress,
                        joint: stress * limit.joint,
                        fold: stress * limit.e_fold(),
                    }),
                variation: None,
            },
        }
    }

    /// A, A', A'' at the square of a stress, Pa².
    #[inline(always)]
    fn law(&self, square: f64) -> [f64; 3] {
        if let Some(table) = &self.table
            && let Some(jet) = table.at(square)
        {
            return jet;
        }
        self.law
            .law
            .as_ref()
            .map_or([1.0, 0.0, 0.0], |law| exact(law, square))
    }
}

fn exact(law: &ShearLaw, square: f64) -> [f64; 3] {
    let a = law.relative_fluidity(Dual2_64::from_re(square).derivative());
    [a.re, a.v1, a.v2]
}

/// A law at one pressure.
pub struct PointThinning<'a> {
    thinning: &'a Thinning,
    /// S², Pa².
    square: f64,
    /// The limit, k by P, τ_L0².
    limit: Option<(&'a StressLimit, Dual2_64, f64)>,
    scales: StressScales,
}

impl UniformFluidity for PointThinning<'_> {
    #[inline(always)]
    fn jet(&self, x: f64) -> Jet {
        let [a, a1, a2] = self.thinning.law(self.square * x);
        let (a1, a2) = (a1 * self.square, a2 * self.square * self.square);
        let Some((limit, k, unit)) = &self.limit else {
            return Jet {
                f: a,
                x: a1,
                xx: a2,
                ..Jet::default()
            };
        };
        let b = limit.factor(
            Dual2_64::from_re(k.re * x).derivative() * *unit,
            Dual2_64::from_re(0.0),
        );
        Jet {
            f: a * b.re,
            x: a1 * b.re + a * b.v1 * k.re,
            p: a * b.v1 * k.v1 * x,
            xx: a2 * b.re + 2.0 * a1 * b.v1 * k.re + a * b.v2 * k.re * k.re,
            xp: a1 * b.v1 * k.v1 * x + a * (b.v2 * k.re * k.v1 * x + b.v1 * k.v1),
            pp: a * (b.v2 * k.v1 * k.v1 * x * x + b.v1 * k.v2 * x),
        }
    }

    #[inline(always)]
    fn depends_on_pressure(&self) -> bool {
        self.limit.is_some()
    }
}

impl Fluidity for PointThinning<'_> {
    #[inline(always)]
    fn slope(&self, x: f64) -> [f64; 2] {
        if self.limit.is_some() {
            let jet = self.jet(x);
            return [jet.f, jet.x];
        }
        let [a, a1, _] = self.thinning.law(self.square * x);
        [a, a1 * self.square]
    }

    fn scales(&self) -> StressScales {
        self.scales
    }
}

/// Quintic Hermite interpolation of a law in x, on cells that grow with x: [`PER_BINADE`] between each
/// power of two and the next. Twice continuously differentiable.
#[derive(Debug)]
struct FluidityTable {
    /// Square of the knee's stress.
    unit: f64,
    /// Interpolants in the local coordinate, and its slope.
    cells: Vec<(Quintic, f64)>,
}

/// Cells to each power of two: 2⁵.
const PER_BINADE_LOG2: u32 = 5;
/// Powers of two of the stress's square, over the knee's, between which the table holds.
const LOWEST: i32 = -50;
const HIGHEST: i32 = 50;
/// Bits of a double's mantissa below the cell.
const LOCAL_BITS: u32 = 52 - PER_BINADE_LOG2;

impl FluidityTable {
    fn new(law: &ShearLaw, knee: f64) -> FluidityTable {
        let unit = knee * knee;
        let first = 2.0_f64.powi(LOWEST).to_bits() >> LOCAL_BITS;
        let n = ((HIGHEST - LOWEST) as u64) << PER_BINADE_LOG2;
        let node = |i: u64| f64::from_bits((first + i) << LOCAL_BITS);
        let at = |x: f64| {
            let [a, a1, a2] = exact(law, x * unit);
            [a, a1 * unit, a2 * unit * unit]
        };
        let cells = (0..n).map(|i| {
            let (low, high) = (node(i), node(i + 1));
            let w = high - low;
            let end = |x: f64| {
                let [a, a1, a2] = at(x);
                [a, a1 * w, a2 * w * w]
            };
            (Quintic::new(end(low), end(high)), 1.0 / w)
        });
        FluidityTable {
            unit,
            cells: cells.collect(),
        }
    }

    /// A and its derivatives at the square of a stress, Pa²; `None` outside the table.
    #[inline(always)]
    fn at(&self, square: f64) -> Option<[f64; 3]> {
        let bits = (square / self.unit).to_bits();
        let first = 2.0_f64.powi(LOWEST).to_bits() >> LOCAL_BITS;
        let cell = (bits >> LOCAL_BITS).wrapping_sub(first);
        let (quintic, slope) = self.cells.get(cell as usize)?;
        let local = bits & ((1 << LOCAL_BITS) - 1);
        let t = local as f64 * (1.0 / (1_u64 << LOCAL_BITS) as f64);
        let [value, first, second] = quintic.at(t);
        let scale = slope / self.unit;
        Some([value, first * scale, second * scale * scale])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use ertel_rheology::shear::{Carreau, CarreauYasuda, Rabinowitsch};

    /// The table against the law between its nodes, over sixteen decades of stress.
    #[test]
    fn table_matches_the_law() {
        let laws = [
            ShearLaw::Carreau(Carreau::new(1e4, 0.8, 2.198, 0.22).unwrap()),
            ShearLaw::Carreau(Carreau::new(3e6, 0.2, 2.0, 0.0).unwrap()),
            ShearLaw::CarreauYasuda(CarreauYasuda::new(1e5, 0.5, 2.0, 0.1).unwrap()),
            ShearLaw::Rabinowitsch(Rabinowitsch::new(1e6, 1.0 / 3.0).unwrap()),
        ];
        for law in laws {
            let thinning = Thinning::new(&ShearThinning::of(law.clone()));
            let knee = thinning.law.scales(0.0).knee.unwrap();
            for i in -3000..3000 {
                let square = knee * knee * (i as f64 * 0.01137).exp2();
                let [a, a1, a2] = thinning.law(square);
                let [e, e1, e2] = exact(&law, square);
                assert_relative_eq!(a, e, max_relative = 2e-12);
                // slopes as shares of a/x
                assert_relative_eq!(a1 * square, e1 * square, epsilon = 1e-9 * e);
                let square2 = square * square;
                assert_relative_eq!(a2 * square2, e2 * square2, epsilon = 3e-7 * e);
            }
        }
    }
}
