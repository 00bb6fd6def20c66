//! Density and viscosity of the film for the dimensionless equations.

use std::sync::Arc;

use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;
use ertel_rheology::Scalar;
use ertel_rheology::density::DensityLaw;
use ertel_rheology::shear::ShearThinning;
use ertel_rheology::viscosity::ViscosityLaw;
use num_dual::{Dual2_64, DualNum};

use super::closure::{self, Closure, FilmFlow};
use super::cross_film::CrossFilm;
use super::fluidity::{Fluidity, PointThinning, Thinning};
use super::point::PointFluid;
use super::polynomial::{FilmNodes, Nodal};
use super::properties::Properties;
use super::stress_scales::StressScales;
use super::thermal::{Jet2, TemperatureProfile, ThermalFluid, ThermalLaw};
use super::thermal_closure::{ThermalClosure, close_thermal};
use crate::contact::{Planar, Scales};

/// Isothermal fluid in the scales of a contact.
///
/// Below ambient pressure (P < 0, an artefact of the cavitation penalty) the properties go on with
/// the slope they have at P = 0 and level off within a few per cent. A kink there would make the
/// stabilised equation jump where a quadrature point crosses P = 0, and a solution with a point on
/// the jump does not exist: Newton's method would step from one side to the other for ever.
#[derive(Clone, Debug)]
pub struct FilmFluid {
    properties: Arc<Properties>,
    /// a p_h/R, Pa.
    stress_scale: f64,
    /// How stress thins the fluid.
    shear_thinning: Option<Arc<Thinning>>,
    /// σ = λ Δu/(12 u_m), the sliding velocity's field.
    slide: Planar,
    /// Nodes across the film, if its temperature varies.
    nodes: Option<Arc<FilmNodes>>,
}

impl FilmFluid {
    /// Fluid with the given laws at a temperature in K.
    pub fn new(
        density: &DensityLaw,
        viscosity: &ViscosityLaw,
        temperature: f64,
        scales: &Scales,
    ) -> FilmFluid {
        let units = [scales.pressure, scales.density, scales.viscosity];
        let properties = Properties::new(density, viscosity, temperature, units);
        FilmFluid::with_properties(properties, scales)
    }

    fn with_properties(properties: Properties, scales: &Scales) -> FilmFluid {
        FilmFluid {
            properties: Arc::new(properties),
            stress_scale: scales.pressure * scales.film / scales.length,
            shear_thinning: None,
            slide: Planar::default(),
            nodes: None,
        }
    }

    /// A fluid with the same or other laws, in similar scales: tables of equal laws are shared.
    pub fn nearby(
        &self,
        density: &DensityLaw,
        viscosity: &ViscosityLaw,
        temperature: f64,
        shear_thinning: Option<&ShearThinning>,
        sliding: &Planar,
        scales: &Scales,
    ) -> FilmFluid {
        let units = [scales.pressure, scales.density, scales.viscosity];
        let shared = (self.properties).rescaled(density, viscosity, temperature, units);
        let fluid = match shared {
            Some(properties) => FilmFluid::with_properties(properties, scales),
            None => FilmFluid::new(density, viscosity, temperature, scales),
        };
        FilmFluid {
            shear_thinning: shear_thinning.map(|law| match &self.shear_thinning {
                Some(own) if own.law == *law => own.clone(),
                _ => Arc::new(Thinning::new(law)),
            }),
            ..fluid.with_shear(None, sliding, scales)
        }
    }

    /// The same fluid at another temperature in K, in the same scales.
    #[must_use]
    pub fn at_bulk(&self, temperature: f64) -> FilmFluid {
        FilmFluid {
            properties: Arc::new(self.properties.at_bulk(temperature)),
            ..self.clone()
        }
    }

    /// The same fluid thinned by stress, between surfaces that slide by a velocity over the entrainment speed. `None` leaves it
    /// Newtonian; then sliding makes stress only.
    pub fn with_shear(
        self,
        shear_thinning: Option<&ShearThinning>,
        sliding: &Planar,
        scales: &Scales,
    ) -> FilmFluid {
        FilmFluid {
            shear_thinning: shear_thinning.map(|law| Arc::new(Thinning::new(law))),
            slide: sliding.map(|s| scales.lambda * s / 12.0),
            ..self
        }
    }

    /// The same fluid at its low-shear viscosity.
    pub fn newtonian(&self) -> FilmFluid {
        FilmFluid {
            shear_thinning: None,
            ..self.clone()
        }
    }

    /// Whether the fluid is Newtonian.
    pub fn is_newtonian(&self) -> bool {
        self.shear_thinning.is_none()
    }

    /// The fluid at a point, for its pressure and, where heat counts, its temperature.
    pub fn local(&self, pressure: f64, temperature: Option<&TemperatureProfile>) -> LocalFluid<'_> {
        let thermal = temperature.map(|profile| self.thermal(pressure, profile));
        LocalFluid {
            fluid: self,
            pressure,
            point: (thermal.as_ref()).map_or_else(|| self.at(pressure), ThermalFluid::point),
            thermal,
        }
    }

    /// The fluid of a film of some temperature at P.
    #[inline(always)]
    pub fn thermal(&self, pressure: f64, profile: &TemperatureProfile) -> ThermalFluid {
        let nodes = self.nodes.as_ref().expect("a fluid with film nodes");
        let mut properties = self.properties.over_temperature(pressure.max(0.0));
        ThermalFluid::new(nodes, profile, |t| {
            self.in_force(pressure, properties.at(t))
        })
    }

    /// The same without derivatives by P and along X and Y.
    #[inline(always)]
    pub fn thermal_values(&self, pressure: f64, temperature: &Nodal) -> ThermalFluid {
        let nodes = self.nodes.as_ref().expect("a fluid with film nodes");
        let mut properties = self.properties.over_temperature(pressure.max(0.0));
        let profile = TemperatureProfile {
            temperature: *temperature,
            ..TemperatureProfile::default()
        };
        ThermalFluid::values(nodes, &profile, |t| {
            self.in_force(pressure, properties.at(t))
        })
    }

    /// ρ̄, μ̄ and their first two derivatives by P at a temperature in K.
    pub fn at_temperature(&self, pressure: f64, temperature: f64) -> PointFluid {
        let mut properties = self.properties.over_temperature(pressure.max(0.0));
        let [rho, ln_mu] = self.in_force(pressure, properties.at(temperature));
        let mu = ln_mu.value.exp();
        PointFluid {
            density: [rho.value, rho.p, rho.pp],
            viscosity: [mu, mu * ln_mu.p, mu * (ln_mu.p * ln_mu.p + ln_mu.pp)],
        }
    }

    /// ρ̄ and ln μ̄ of the fluid at P, or at P = 0 for pressures below.
    #[inline(always)]
    fn in_force(&self, pressure: f64, [mut rho, mut ln_mu]: [Jet2; 2]) -> [Jet2; 2] {
        if ln_mu.value > SOLID {
            let x = Dual2_64::from_re(ln_mu.value).derivative();
            ln_mu = ln_mu.through(jet(saturate(x)));
        }
        if pressure < 0.0 {
            let p = Dual2_64::from_re(pressure).derivative();
            for jet in [&mut rho, &mut ln_mu] {
                let beyond = level_off(p, 0.0, jet.p);
                jet.value += beyond.re;
                jet.p = beyond.v1;
                jet.pp = beyond.v2;
                jet.pt = 0.0;
            }
        }
        [rho, ln_mu]
    }

    /// The same fluid in films whose temperature is given at these nodes.
    pub fn with_nodes(self, nodes: FilmNodes) -> FilmFluid {
        FilmFluid {
            nodes: Some(Arc::new(nodes)),
            ..self
        }
    }

    /// Nodes across the film, where its temperature varies.
    pub fn nodes(&self) -> Option<&FilmNodes> {
        self.nodes.as_deref()
    }

    /// The law of a thermal film at P.
    pub fn thermal_law<'a>(&'a self, pressure: f64, fluid: &'a ThermalFluid) -> ThermalLaw<'a> {
        ThermalLaw {
            thinning: self.thinning_at(pressure),
            fluid,
        }
    }

    /// Flow across a thermal film at P, for G = H∇P and Ω = σμ̄/H with its standing viscosity.
    pub fn close_thermal(
        &self,
        pressure: f64,
        fluid: &ThermalFluid,
        pressure_stress: [f64; 2],
        sliding_stress: [f64; 2],
        rule: &mut CrossFilm,
    ) -> ThermalClosure {
        let law = self.thermal_law(pressure, fluid);
        if self.slide.is_along_x() {
            return vectorised(CloseThermal::<false> {
                law: &law,
                pressure_stress,
                sliding_stress,
                rule,
            });
        }
        vectorised(CloseThermal::<true> {
            law: &law,
            pressure_stress,
            sliding_stress,
            rule,
        })
    }

    /// a p_h/R, Pa: the unit of the stresses in the film.
    pub fn stress_scale(&self) -> f64 {
        self.stress_scale
    }

    /// Stresses, Pa, at which the fluid leaves its first and reaches its second Newtonian plateau at P.
    pub fn newtonian_limits(&self, pressure: f64) -> [Option<f64>; 2] {
        let pressure = pressure * self.properties.pressure_scale;
        (self.shear_thinning.as_ref()).map_or([None; 2], |t| t.law.newtonian_limits(pressure))
    }

    /// Whether these limits depend on the pressure.
    pub fn limits_depend_on_pressure(&self) -> bool {
        (self.shear_thinning.as_ref()).is_some_and(|t| t.law.depends_on_pressure())
    }

    /// The law at P.
    fn thinning_at(&self, pressure: f64) -> Option<PointThinning<'_>> {
        let thinning = self.shear_thinning.as_ref()?;
        Some(thinning.at(pressure, self.stress_scale, self.properties.pressure_scale))
    }

    /// Requirements on a quadrature across the film at P; `None` where the fluid is Newtonian.
    pub(super) fn stress_scales(&self, pressure: f64) -> Option<StressScales> {
        Some(self.thinning_at(pressure)?.scales())
    }

    /// Stresses, in units of a p_h/R, far below which there is no shear thinning at P, and where the fluidity has grown by a number of e-folds if it grows
    /// exponentially; `None` where the fluid is Newtonian.
    pub fn stresses_between(&self, pressure: f64, folds: f64) -> Option<[f64; 2]> {
        let scales = self.stress_scales(pressure)?;
        let limit = scales.limit.map(|limit| limit.fold.min(limit.stress));
        let smallest = [scales.knee, scales.growth, limit].into_iter().flatten();
        let beyond = scales.limit.map(|limit| limit.joint + folds * limit.fold);
        let growth = scales.growth.map(|growth| folds * growth);
        let largest = [beyond, growth].into_iter().flatten();
        Some([
            smallest.reduce(f64::min)?,
            largest.fold(f64::INFINITY, f64::min),
        ])
    }

    /// σ, by which Ω = σμ̄/H.
    pub fn slide(&self) -> &Planar {
        &self.slide
    }

    /// Whether the surfaces slide.
    pub fn slides(&self) -> bool {
        !self.slide.is_zero()
    }

    /// Flow across the film at P, for G = H∇P and Ω.
    pub fn close(
        &self,
        pressure: f64,
        pressure_stress: [f64; 2],
        sliding_stress: [f64; 2],
        rule: &mut CrossFilm,
    ) -> Closure {
        match self.thinning_at(pressure) {
            None => Closure::newtonian(pressure_stress, sliding_stress),
            Some(law) if self.slide.is_along_x() => vectorised(Close::<false> {
                law: &law,
                pressure_stress,
                sliding_stress,
                rule,
            }),
            Some(law) => vectorised(Close::<true> {
                law: &law,
                pressure_stress,
                sliding_stress,
                rule,
            }),
        }
    }

    /// The same fluid with shear rates that grow less with the stress where they grow exponentially, by a factor `softness` ≥ 1
    /// ([`Thinning::softened`]): an easier one, for continuation.
    pub fn with_softness(&self, softness: f64) -> FilmFluid {
        match &self.shear_thinning {
            Some(law) if softness != 1.0 => FilmFluid {
                shear_thinning: Some(Arc::new(law.softened(softness))),
                ..self.clone()
            },
            _ => self.clone(),
        }
    }

    /// The same fluid between surfaces that slide by another velocity over the entrainment speed of the scales.
    pub fn sliding_by(&self, sliding: &Planar, scales: &Scales) -> FilmFluid {
        FilmFluid {
            slide: sliding.map(|s| scales.lambda * s / 12.0),
            ..self.clone()
        }
    }

    /// Whether the shear rate grows exponentially with the stress: beyond a limit, or in Eyring's fluid.
    pub fn is_exponential(&self) -> bool {
        (self.shear_thinning.as_ref()).is_some_and(|law| law.law.is_exponential())
    }

    /// ρ̄, μ̄ and their first two derivatives by P.
    pub fn at(&self, pressure: f64) -> PointFluid {
        let [mut rho, ln_mu] = self.properties.at(pressure.max(0.0));
        let ln_mu = saturate(dual(ln_mu));
        let mut mu = ln_mu.exp();
        if pressure < 0.0 {
            let p = Dual2_64::from_re(pressure).derivative();
            rho = jet(level_off(p, rho[0], rho[1]));
            mu = level_off(p, 0.0, ln_mu.v1).exp() * mu.re;
        }
        PointFluid {
            density: rho,
            viscosity: jet(mu),
        }
    }
}

kernel! {
    CloseThermal ['a, const ACROSS: bool] ['a, ACROSS] (
        law: &'a ThermalLaw<'a>,
        pressure_stress: [f64; 2],
        sliding_stress: [f64; 2],
        rule: &'a mut CrossFilm,
    ) -> ThermalClosure {
        close_thermal::<ACROSS>(law, pressure_stress, sliding_stress, rule)
    }
}

kernel! {
    Close ['a, const ACROSS: bool] ['a, ACROSS] (
        law: &'a PointThinning<'a>,
        pressure_stress: [f64; 2],
        sliding_stress: [f64; 2],
        rule: &'a mut CrossFilm,
    ) -> Closure {
        closure::close::<ACROSS>(law, pressure_stress, sliding_stress, rule)
    }
}

/// The fluid at a point of the film and its flow there.
pub struct LocalFluid<'a> {
    fluid: &'a FilmFluid,
    pressure: f64,
    point: PointFluid,
    thermal: Option<ThermalFluid>,
}

impl LocalFluid<'_> {
    /// Density and viscosity; of a thermal film its mean density and the viscosity that stands for it.
    pub fn point(&self) -> &PointFluid {
        &self.point
    }

    /// The fluid across the film, where its temperature varies.
    pub fn thermal(&self) -> Option<&ThermalFluid> {
        self.thermal.as_ref()
    }

    /// G and Ω of a pressure gradient and a film thickness at a place.
    pub fn demands(
        &self,
        place: [f64; 2],
        pressure_gradient: [f64; 2],
        film: f64,
    ) -> ([f64; 2], [f64; 2]) {
        let omega = (self.fluid.slide.at(place)).map(|s| s * self.point.viscosity[0] / film);
        (pressure_gradient.map(|p| film * p), omega)
    }

    /// Stress and flow for G and Ω.
    pub fn flow(&self, g: [f64; 2], omega: [f64; 2], rule: &mut CrossFilm) -> FilmFlow {
        if let Some(thermal) = &self.thermal {
            let law = self.fluid.thermal_law(self.pressure, thermal);
            let moment_weight = |s: f64| thermal.moment_weight.by_p[0].at(s);
            return vectorised(|| closure::flow(&law, moment_weight, g, omega, rule));
        }
        match self.fluid.thinning_at(self.pressure) {
            None => FilmFlow {
                mid_stress: omega,
                flow: g.map(|g| g / 12.0),
                work: (omega[0] * omega[0] + omega[1] * omega[1])
                    + (g[0] * g[0] + g[1] * g[1]) / 12.0,
            },
            Some(law) => vectorised(|| closure::flow(&law, |s| s, g, omega, rule)),
        }
    }

    /// Flow and its derivatives for G and Ω.
    pub fn close(&self, g: [f64; 2], omega: [f64; 2], rule: &mut CrossFilm) -> Closure {
        match &self.thermal {
            None => self.fluid.close(self.pressure, g, omega, rule),
            Some(thermal) => {
                (self.fluid)
                    .close_thermal(self.pressure, thermal, g, omega, rule)
                    .closure
            }
        }
    }

    /// μ̄/η at a height of the film and the square of a stress, in units of a p_h/R.
    pub fn relative_fluidity(&self, s: f64, stress_squared: f64) -> f64 {
        if let Some(thermal) = &self.thermal {
            let law = self.fluid.thermal_law(self.pressure, thermal);
            return law.factor(s) * law.slope(stress_squared)[0];
        }
        (self.fluid.thinning_at(self.pressure)).map_or(1.0, |law| law.slope(stress_squared)[0])
    }
}

fn dual([re, v1, v2]: [f64; 3]) -> Dual2_64 {
    Dual2_64::new(re, v1, v2)
}

fn jet(v: Dual2_64) -> [f64; 3] {
    [v.re, v.v1, v.v2]
}

/// ln μ̄ above which the lubricant is effectively solid, and laws would overflow: e²⁰⁰ times
/// the ambient viscosity. Early iterates can reach it.
const SOLID: f64 = 200.0;

/// Levels off above [`SOLID`], with continuous slope: at most half of it more.
fn saturate<D: Scalar>(ln_viscosity: D) -> D {
    let excess = ln_viscosity - SOLID;
    if excess.re() <= 0.0 {
        return ln_viscosity;
    }
    excess / (excess * (2.0 / SOLID) + 1.0) + SOLID
}

/// Largest change of properties below ambient pressure: 5 % of density, and of viscosity.
const DEPTH: f64 = 0.05;

/// v₀ + v₁p/(1 − |v₁|p/d) for p < 0: value and slope of v at p = 0, never d below v₀.
fn level_off(p: Dual2_64, value: f64, slope: f64) -> Dual2_64 {
    p * slope / (-p * (slope.abs() / DEPTH) + 1.0) + value
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Contact, Hertz, Motion, Shape};
    use approx::assert_relative_eq;

    /// Values and slopes meet at P = 0, and nothing runs away below: ρ̄ = (1 + 2.266e-9 p)/
    /// (1 + 1.683e-9 p) and Barus' law have the slopes 5.83e-10 and 2.2e-8 1/Pa by hand.
    #[test]
    fn properties_pass_through_ambient_pressure() {
        let contact = Contact::circular(0.016, 100.0);
        let hertz = Hertz::new(&contact, 230e9);
        let shape = Shape::new(&contact, &hertz, &Motion::straight(1.0, 0.0));
        let scales = Scales::new(
            (&contact, &hertz, &shape),
            &Motion::straight(1.0, 0.0),
            0.04,
            870.0,
        );
        let density = DensityLaw::dowson_higginson(870.0).unwrap();
        let viscosity = ViscosityLaw::barus(0.04, 2.2e-8).unwrap();
        let fluid = FilmFluid::new(&density, &viscosity, 313.15, &scales);
        let p_h = hertz.pressure;
        for p in [-1e-9, 0.0, 1e-9] {
            let f = fluid.at(p);
            assert_relative_eq!(f.density[1], 5.83e-10 * p_h, max_relative = 0.03);
            assert_relative_eq!(f.viscosity[1], 2.2e-8 * p_h, max_relative = 1e-6);
        }
        let (below, above) = (fluid.at(-1e-10), fluid.at(1e-10));
        for (a, b) in [
            (below.density, above.density),
            (below.viscosity, above.viscosity),
        ] {
            assert_relative_eq!(a[0], b[0], max_relative = 1e-7);
            assert_relative_eq!(a[1], b[1], max_relative = 1e-7);
        }
        for p in [-1e-3, -1.0, -1e3] {
            let f = fluid.at(p);
            assert!((0.95..1.0).contains(&f.density[0]), "{p}");
            assert!((0.95..1.0).contains(&f.viscosity[0]), "{p}");
            assert!(f.density[1] > 0.0 && f.viscosity[1] > 0.0);
            // central differences
            let step = 1e-4 * p.abs();
            let difference = |v: fn(&PointFluid) -> [f64; 3], k: usize| {
                (v(&fluid.at(p + step))[k] - v(&fluid.at(p - step))[k]) / (2.0 * step)
            };
            for k in 0..2 {
                let d = difference(|f| f.density, k);
                assert_relative_eq!(f.density[k + 1], d, max_relative = 1e-5);
                let d = difference(|f| f.viscosity, k);
                assert_relative_eq!(f.viscosity[k + 1], d, max_relative = 1e-5);
            }
        }
    }
}
