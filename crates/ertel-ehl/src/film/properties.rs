//! Density and low-shear viscosity over pressure, prepared for many evaluations.

use std::sync::Arc;

use ertel_rheology::Scalar;
use ertel_rheology::density::DensityLaw;
use ertel_rheology::viscosity::ViscosityLaw;
use num_dual::Dual2_64;

use super::patches::{Isobar, Laws, Patches};
use super::quintic::Quintic;
use super::thermal::Jet2;

/// ρ̄ and ln μ̄ at P ≥ 0, each with two derivatives by P. Smooth laws are read from a table.
#[derive(Clone, Debug)]
pub(super) struct Properties {
    pub density: DensityLaw,
    pub viscosity: ViscosityLaw,
    /// K.
    pub temperature: f64,
    /// p_h, Pa.
    pub pressure_scale: f64,
    /// ρ_R, kg/m³.
    pub density_scale: f64,
    /// ln(μ_R / Pa·s).
    pub ln_viscosity_scale: f64,
    table: Arc<Table>,
    /// Cells of the table to each p_h.
    per_unit: f64,
    /// Density of the table's unit, and viscosity of it as a logarithm, in units of the scales.
    table_units: [f64; 2],
    /// The same over temperature, too.
    patches: Patches,
}

/// Cells over pressure; `None` where the law itself is evaluated.
type Table = Vec<Option<[Quintic; 2]>>;

/// Cells to each p_h, and how far the table reaches, in p_h.
const PER_UNIT: f64 = 512.0;
const REACH: f64 = 1.5;

/// Error of a cell at its middle above which the law itself is evaluated instead.
const INTERPOLATION_ERROR: f64 = 1e-13;

impl Properties {
    pub fn new(
        density: &DensityLaw,
        viscosity: &ViscosityLaw,
        temperature: f64,
        [pressure_scale, density_scale, viscosity_scale]: [f64; 3],
    ) -> Properties {
        // Tables of data have corners.
        let smooth = density.tabulated_range().is_none() && viscosity.tabulated_range().is_none();
        let mut properties = Properties {
            density: density.clone(),
            viscosity: viscosity.clone(),
            temperature,
            pressure_scale,
            density_scale,
            ln_viscosity_scale: viscosity_scale.ln(),
            table: Arc::default(),
            per_unit: PER_UNIT,
            table_units: [1.0, 0.0],
            patches: Patches::new(temperature, smooth),
        };
        if smooth {
            properties.table = Arc::new(properties.tabulate());
        }
        properties
    }

    /// Those of the same laws at the same temperature in other scales, with the same table; `None` for other laws.
    pub fn rescaled(
        &self,
        density: &DensityLaw,
        viscosity: &ViscosityLaw,
        temperature: f64,
        [pressure_scale, density_scale, viscosity_scale]: [f64; 3],
    ) -> Option<Properties> {
        let same = self.density == *density
            && self.viscosity == *viscosity
            && self.temperature == temperature;
        same.then(|| {
            let ln_viscosity_scale = viscosity_scale.ln();
            let scales = [
                self.pressure_scale,
                self.density_scale,
                self.ln_viscosity_scale,
            ];
            Properties {
                // They are made in the scales.
                patches: match scales == [pressure_scale, density_scale, ln_viscosity_scale] {
                    true => self.patches.clone(),
                    false => Patches::new(temperature, !self.table.is_empty()),
                },
                pressure_scale,
                density_scale,
                ln_viscosity_scale,
                per_unit: self.per_unit * (pressure_scale / self.pressure_scale),
                table_units: [
                    self.table_units[0] * (self.density_scale / density_scale),
                    self.table_units[1] + (self.ln_viscosity_scale - ln_viscosity_scale),
                ],
                ..self.clone()
            }
        })
    }

    /// Those of the same laws at another temperature in K, in the same scales.
    pub fn at_bulk(&self, temperature: f64) -> Properties {
        let units = [
            self.pressure_scale,
            self.density_scale,
            self.ln_viscosity_scale.exp(),
        ];
        Properties::new(&self.density, &self.viscosity, temperature, units)
    }

    fn tabulate(&self) -> Table {
        let width = 1.0 / PER_UNIT;
        let node = |i: usize| {
            let jets = self.exact(i as f64 * width);
            jets.map(|[v, v1, v2]| [v, v1 * width, v2 * width * width])
        };
        let n = (REACH * PER_UNIT) as usize;
        let nodes: Vec<_> = (0..=n).map(node).collect();
        let cell = |i: usize| {
            let cells = [0, 1].map(|k: usize| Quintic::new(nodes[i][k], nodes[i + 1][k]));
            let middle = self.exact((i as f64 + 0.5) * width);
            let good = (0..2).all(|k| {
                let error = (cells[k].at(0.5)[0] - middle[k][0]).abs();
                error < INTERPOLATION_ERROR * (1.0 + middle[k][0].abs())
            });
            good.then_some(cells)
        };
        (0..n).map(cell).collect()
    }

    /// ρ̄ and ln μ̄ at P ≥ 0.
    #[inline]
    pub fn at(&self, pressure: f64) -> [[f64; 3]; 2] {
        let x = pressure * self.per_unit;
        if let Some(Some(cells)) = self.table.get(x as usize) {
            let t = x - x.floor();
            let jet = |cell: &Quintic, factor: f64, shift: f64| {
                let [v, v1, v2] = cell.at(t);
                let slope = factor * self.per_unit;
                [factor * v + shift, slope * v1, slope * self.per_unit * v2]
            };
            let [density, ln_viscosity] = self.table_units;
            return [
                jet(&cells[0], density, 0.0),
                jet(&cells[1], 1.0, ln_viscosity),
            ];
        }
        self.exact(pressure)
    }

    /// ρ̄ and ln μ̄ over temperature at P ≥ 0.
    #[inline]
    pub fn over_temperature(&self, pressure: f64) -> Isobar<'_, Properties> {
        self.patches.at(self, pressure)
    }

    /// The same from the laws.
    pub fn exact(&self, pressure: f64) -> [[f64; 3]; 2] {
        let p = Dual2_64::from_re(pressure).derivative();
        self.of(p, Dual2_64::from_re(self.temperature))
            .map(|v| [v.re, v.v1, v.v2])
    }

    /// ρ̄ and ln μ̄ from the laws at P and a temperature in K.
    pub fn of<D: Scalar>(&self, pressure: D, temperature: D) -> [D; 2] {
        let p = pressure * self.pressure_scale;
        let rho = self.density.density(p, temperature) / self.density_scale;
        let ln_mu = self.viscosity.ln_viscosity(p, temperature) - self.ln_viscosity_scale;
        [rho, ln_mu]
    }
}

impl Laws for Properties {
    fn values(&self, pressure: f64, temperature: f64) -> [f64; 2] {
        self.of(pressure, temperature)
    }

    fn jets(&self, pressure: f64, temperature: f64) -> [Jet2; 2] {
        [0, 1].map(|k: usize| Jet2::of(|p, t| self.of(p, t)[k], pressure, temperature))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A table in other scales against the laws in them.
    #[test]
    fn rescaled_table_matches_the_laws() {
        let density = DensityLaw::dowson_higginson(870.0).unwrap();
        let viscosity = ViscosityLaw::roelands(0.04, 2.2e-8).unwrap();
        let own = Properties::new(&density, &viscosity, 313.0, [1e9, 870.0, 0.04]);
        // Its patches are made before those of the other.
        for i in 0..40 {
            assert!(own.over_temperature(0.03 * f64::from(i)).at(320.0)[0].value > 0.0);
        }
        let scales = [1.3e9, 900.0, 0.05];
        let other = own.rescaled(&density, &viscosity, 313.0, scales).unwrap();
        for i in 0..997 {
            let p = i as f64 * 0.0013;
            for (ours, exact) in other.at(p).into_iter().zip(other.exact(p)) {
                assert_relative_eq!(ours[0], exact[0], max_relative = 1e-13, epsilon = 1e-13);
                assert_relative_eq!(ours[1], exact[1], max_relative = 1e-10);
                assert_relative_eq!(ours[2], exact[2], max_relative = 1e-6, epsilon = 1e-7);
            }
            let warm = other.over_temperature(p).at(321.0);
            for (ours, exact) in warm.into_iter().zip(other.jets(p, 321.0)) {
                assert_relative_eq!(
                    ours.value,
                    exact.value,
                    max_relative = 1e-11,
                    epsilon = 1e-11
                );
            }
        }
        assert!(own.rescaled(&density, &viscosity, 314.0, scales).is_none());
    }

    /// Table and laws between the nodes, and beyond the table's end.
    #[test]
    fn table_matches_the_laws() {
        let density = DensityLaw::dowson_higginson(870.0).unwrap();
        for viscosity in [
            ViscosityLaw::barus(0.04, 2.2e-8).unwrap(),
            ViscosityLaw::roelands(0.04, 2.2e-8).unwrap(),
        ] {
            let properties = Properties::new(&density, &viscosity, 313.0, [1e9, 870.0, 0.04]);
            assert!(properties.table.iter().all(Option::is_some));
            for i in 0..997 {
                let p = i as f64 * 0.0017;
                let (ours, exact) = (properties.at(p), properties.exact(p));
                for (ours, exact) in ours.into_iter().zip(exact) {
                    assert_relative_eq!(ours[0], exact[0], max_relative = 1e-13, epsilon = 1e-13);
                    assert_relative_eq!(ours[1], exact[1], max_relative = 1e-10);
                    assert_relative_eq!(ours[2], exact[2], max_relative = 1e-6, epsilon = 1e-7);
                }
            }
        }
    }

    /// The patches and the laws between their nodes.
    #[test]
    fn patches_match_the_laws() {
        let density = DensityLaw::dowson_higginson(870.0).unwrap();
        for viscosity in [
            ViscosityLaw::barus(0.04, 2.2e-8).unwrap(),
            ViscosityLaw::roelands(0.04, 2.2e-8).unwrap(),
        ] {
            let properties = Properties::new(&density, &viscosity, 313.0, [1e9, 870.0, 0.04]);
            for i in 0..500 {
                let (p, t) = (i as f64 * 0.0029, 280.0 + (i % 37) as f64 * 4.3);
                let (ours, exact) = (properties.over_temperature(p).at(t), properties.jets(p, t));
                for (ours, exact) in ours.into_iter().zip(exact) {
                    let value = exact.value;
                    assert_relative_eq!(ours.value, value, max_relative = 1e-12, epsilon = 1e-12);
                    assert_relative_eq!(ours.p, exact.p, max_relative = 1e-9, epsilon = 1e-10);
                    assert_relative_eq!(ours.t, exact.t, max_relative = 1e-9, epsilon = 1e-10);
                    assert_relative_eq!(ours.pp, exact.pp, max_relative = 1e-6, epsilon = 1e-6);
                    assert_relative_eq!(ours.pt, exact.pt, max_relative = 1e-7, epsilon = 1e-8);
                }
            }
        }
    }
}
