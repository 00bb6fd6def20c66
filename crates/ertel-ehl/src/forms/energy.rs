//! The energy equation at a point of the contact: convection, conduction and heating at each height of the film, and
//! in the bodies.
//!
//! ```text
//!   film:    ρc h/a (u ∂T/∂X + v ∂T/∂Y) + c ω ∂T/∂s − k/h ∂²T/∂s² = h(Q_shear + Q_comp)  W/m²
//!            ω = −∇·(h∫_{−½}^s ρu ds'), the mass flow across the film
//!            Q_shear = τ·∂u/∂z,   Q_comp = −(T/ρ) ∂ρ/∂T (∂p/∂t + u ∂p/∂x + v ∂p/∂y)
//!   bodies:  ρc (u ∂T/∂X + v ∂T/∂Y) − k/a (∂²T/∂X² + ∂²T/∂Y² + ∂²T/∂Z²) = 0,   Z = z/a                 W/m²
//! ```
//! Habchi 2008, eqs. 5.11, 5.13, 5.14, and ω, which is neglected there: heat flows at a fixed share s of the film's thickness, and
//! lubricant crosses from one to another. Conduction along the film is neglected. Fluxes are continuous at the walls; each layer has
//! its own coordinate z. T is the absolute temperature in K.

mod heights;
mod held_flow;

use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;
use ertel_rheology::{ConductivityLaw, HeatCapacityLaw};

pub use heights::Heights;
use held_flow::Driven;

use crate::contact::Planar;
use crate::film::closure::{dot, solve};
use crate::film::cross_film::CrossFilm;
use crate::film::fluidity::Fluidity;
use crate::film::{FilmFluid, MOST_NODES, Nodal};
use crate::layers::HeatLayer;

/// A body in the energy equation.
#[derive(Clone, Debug)]
pub struct BodyHeat {
    /// Layers from the surface down, solved by finite volumes alone; the other data are those of the substrate.
    pub layers: Vec<HeatLayer>,
    /// Density, kg/m³.
    pub density: f64,
    /// Conductivity.
    pub conductivity: ConductivityLaw,
    /// Heat capacity.
    pub heat_capacity: HeatCapacityLaw,
    /// Velocity of its surface, m/s, at places in half-widths.
    pub velocity: Planar,
    /// Temperature far from the contact, K.
    pub bulk_temperature: f64,
}

impl BodyHeat {
    /// √(χ/(u a)), in half-widths a (m): the depth to which heat gets into the body while it moves on by a; without end of a body at rest.
    pub fn diffusion_depth(&self, length: f64) -> f64 {
        let t = self.bulk_temperature;
        let capacity = self.density * self.heat_capacity.heat_capacity(0.0, t);
        let diffusivity = self.conductivity.conductivity(0.0, t) / capacity;
        let [u, v] = self.velocity.centre;
        (diffusivity / (u.hypot(v) * length)).sqrt()
    }
}

/// Heat of a contact: thermal laws, and the scales that make its film dimensional.
#[derive(Clone, Debug)]
pub struct Heat {
    /// Conductivity of the lubricant.
    pub conductivity: ConductivityLaw,
    /// Heat capacity of the lubricant.
    pub heat_capacity: HeatCapacityLaw,
    /// Plane and ball.
    pub bodies: [BodyHeat; 2],
    /// Temperature of the lubricant where it enters, K.
    pub inlet_temperature: f64,
    /// Half-width a, m.
    pub length: f64,
    /// Film scale a²/R, m.
    pub film: f64,
    /// p_h, Pa.
    pub pressure: f64,
    /// ρ_R, kg/m³.
    pub density: f64,
    /// μ_R, Pa·s.
    pub viscosity: f64,
    /// λ of the Reynolds equation.
    pub lambda: f64,
    /// Entrainment speed, m/s.
    pub entrainment_speed: f64,
}

impl Heat {
    /// Of both surfaces, m/s.
    pub fn mean_velocity(&self) -> Planar {
        let [first, second] = self.bodies.each_ref().map(|body| body.velocity);
        first.plus(&second).times(0.5)
    }

    /// Inlet temperature at a height, K: that of the lubricant, near the walls that of the bodies. A jump there would make polynomials across the film undershoot all inlet temperatures;
    /// Bernstein polynomials fall monotonically, over about 1/order of the gap.
    ///
    /// ```text
    ///   T = T_inlet + (T_1 − T_inlet)(½ − s)^n + (T_2 − T_inlet)(½ + s)^n
    /// ```
    pub fn entering(&self, s: f64, order: usize) -> f64 {
        let inlet = self.inlet_temperature;
        let shares = [0.5 - s, 0.5 + s].map(|share| share.max(0.0).powi(order as i32));
        (self.bodies.iter().zip(shares)).fold(inlet, |t, (body, share)| {
            t + share * (body.bulk_temperature - inlet)
        })
    }
}

/// A place in one of the layers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Layer {
    /// Depth Z in body 1.
    Plane(f64),
    /// Height s in the film.
    Film(f64),
    /// Depth Z in body 2.
    Ball(f64),
}

/// Further heat at (X, Y) of a layer, for tests with known temperatures: W/m² by unit of s, or of Z.
pub type Source<'a> = Option<&'a (dyn Fn([f64; 2], Layer) -> f64 + Sync)>;

/// Heating and cooling of the film at one height.
#[derive(Clone, Copy, Debug, Default)]
pub struct FilmHeat {
    /// Velocity over the entrainment speed.
    pub velocity: [f64; 2],
    /// Temperature, K.
    pub temperature: f64,
    /// ρc h u_m/a, W/(m²·K): times the velocity, the convection.
    pub capacity: f64,
    /// k/h, W/(m²·K).
    pub conduction: f64,
    /// h Q_shear, W/m².
    pub shear: f64,
    /// h Q_comp, W/m².
    pub compression: f64,
    /// H∫ρ̄u over the film below less its share of the whole, (s + ½)H∫ρ̄u: its divergence is the flow across the film.
    pub mass_below: [f64; 2],
    /// Times the divergence of that and ∂T/∂s, the convection across the film, W/(m²·K).
    pub lift_capacity: f64,
    /// ∂(hQ_shear)/∂τ, W/m² by unit of stress.
    pub by_stress: [f64; 2],
    /// ∂(hQ_shear)/∂κ at a fixed τ, W/m².
    pub by_gradient_factor: f64,
}

/// The film at a point, height by height.
#[derive(Clone, Copy, Debug)]
pub struct FilmColumn {
    /// At each height.
    pub heights: [FilmHeat; MOST_NODES],
    /// −∂ln μ/∂T at the nodes: h Q_shear changes by itself times that and the shape function, at a fixed τ.
    pub thinning: Nodal,
    /// ∂τ/∂T of the temperature of each node.
    pub stress_slopes: [[f64; 2]; MOST_NODES],
    /// ∂κ/∂T of the temperature of each node; zero where no flow is held.
    pub gradient_factor_slopes: Nodal,
    /// Conductance Ψ at these temperatures and the pressure's own gradient, where none is held.
    pub conductance: f64,
}

impl FilmColumn {
    /// Where oil fills a share θ of the gap, it carries, conducts and heats by that share.
    fn scale(&mut self, filling: f64) {
        for point in &mut self.heights {
            point.capacity *= filling;
            point.conduction *= filling;
            point.shear *= filling;
            point.compression *= filling;
            point.mass_below = point.mass_below.map(|m| filling * m);
            point.by_stress = point.by_stress.map(|slope| filling * slope);
            point.by_gradient_factor *= filling;
        }
    }
}

/// Pressure and film thickness at a point, dimensionless.
#[derive(Clone, Copy, Debug)]
pub struct FilmPlace {
    /// (X, Y).
    pub at: [f64; 2],
    /// P.
    pub pressure: f64,
    /// ∇P.
    pub pressure_gradient: [f64; 2],
    /// ∂P/∂T over time in a/u_m; 0 of what is steady.
    pub pressure_rate: f64,
    /// H.
    pub film: f64,
    /// θ, the share of the gap that is filled with oil.
    pub filling: f64,
    /// Temperature at the nodes, K.
    pub temperature: Nodal,
    /// Conductance Ψ of the film whose flow is held (see the module `held_flow`); `None`: the pressure gradient is used as it is.
    pub held_conductance: Option<f64>,
}

/// Evaluates the film at a point.
pub fn film_column(
    fluid: &FilmFluid,
    heat: &Heat,
    heights: &Heights,
    place: &FilmPlace,
    rule: &mut CrossFilm,
) -> FilmColumn {
    vectorised(Evaluate {
        fluid,
        heat,
        heights,
        place,
        rule,
    })
}

kernel! {
    Evaluate ['a] ['a] (
        fluid: &'a FilmFluid,
        heat: &'a Heat,
        heights: &'a Heights,
        place: &'a FilmPlace,
        rule: &'a mut CrossFilm,
    ) -> FilmColumn {
        evaluate(fluid, heat, heights, place, rule)
    }
}

#[inline(always)]
fn evaluate(
    fluid: &FilmFluid,
    heat: &Heat,
    heights: &Heights,
    place: &FilmPlace,
    rule: &mut CrossFilm,
) -> FilmColumn {
    let thermal = fluid.thermal_values(place.pressure, &place.temperature);
    let law = fluid.thermal_law(place.pressure, &thermal);
    let mu = thermal.viscosity[0];
    let n = heights.n();
    let factors = law.factors_at(heights.points());
    let driven = Driven {
        law: &law,
        factors: &factors,
        heights,
        gradient: place.pressure_gradient.map(|p| place.film * p),
        slide: (fluid.slide().at(place.at)).map(|slide| slide * mu / place.film),
        viscosity: mu,
    };
    let flow = match place.held_conductance {
        Some(conductance) => driven.held(conductance, rule),
        None => driven.at(1.0, rule),
    };
    let tau = flow.mid_stress;
    let g = driven.gradient.map(|g| flow.factor * g);
    let h = place.film * heat.film;
    let stress = fluid.stress_scale();
    // S²/(μ_R μ̄), W/m³, and S/(μ_R μ̄), 1/s
    let rate_scale = stress / (heat.viscosity * mu);
    let mut column = FilmColumn {
        heights: [FilmHeat::default(); MOST_NODES],
        thinning: thermal.ln_viscosities[1].map(|v| -v),
        stress_slopes: [[0.0; 2]; MOST_NODES],
        gradient_factor_slopes: [0.0; MOST_NODES],
        conductance: flow.conductance,
    };
    let mut rates = [[0.0; 2]; MOST_NODES];
    let mut stiffness = [0.0; 3];
    let mut conductance_slopes = [0.0; MOST_NODES];
    let mut conductance_by_stress = [0.0; 2];
    for k in 0..n {
        let (s, w) = (heights.points()[k], heights.weights()[k]);
        let t = [0, 1].map(|i: usize| tau[i] + s * g[i]);
        let square = t[0] * t[0] + t[1] * t[1];
        let [f, by_square] = law.slope(square).map(|v| factors[k] * v);
        rates[k] = t.map(|t| f * t);
        let point = &mut column.heights[k];
        point.shear = h * stress * rate_scale * f * square;
        let slope = h * stress * rate_scale * 2.0 * (f + square * by_square);
        point.by_stress = t.map(|t| slope * t);
        point.by_gradient_factor = slope * s * dot(t, driven.gradient);
        stiffness[0] += w * (f + 2.0 * by_square * t[0] * t[0]);
        stiffness[1] += w * 2.0 * by_square * t[0] * t[1];
        stiffness[2] += w * (f + 2.0 * by_square * t[1] * t[1]);
        let weight = flow.weights[k];
        for (sum, t) in conductance_by_stress.iter_mut().zip(t) {
            *sum += weight * 2.0 * by_square * t;
        }
        for (m, slope) in conductance_slopes.iter_mut().enumerate() {
            *slope += weight * f * heights.shapes[k][m] * column.thinning[m];
        }
        for (m, slope) in column.stress_slopes.iter_mut().enumerate() {
            let share = w * heights.shapes[k][m] * column.thinning[m];
            slope[0] -= share * rates[k][0];
            slope[1] -= share * rates[k][1];
        }
    }
    for slope in &mut column.stress_slopes {
        *slope = solve(stiffness, *slope);
    }
    if place.held_conductance.is_some() {
        let answer = flow.conductance + flow.conductance_slope;
        for m in 0..MOST_NODES {
            let stress = &mut column.stress_slopes[m];
            let change = conductance_slopes[m] + dot(conductance_by_stress, *stress);
            let by_factor = -flow.factor * change / answer;
            column.gradient_factor_slopes[m] = by_factor;
            for (slope, by) in stress.iter_mut().zip(flow.mid_stress_slope) {
                *slope += by * by_factor;
            }
        }
    }
    let plane = (heat.bodies[0].velocity.at(place.at)).map(|u| u / heat.entrainment_speed);
    let by_speed = 12.0 * place.film / (heat.lambda * mu);
    let p = place.pressure * heat.pressure;
    for k in 0..n {
        let dot = |values: &Nodal| -> f64 {
            values
                .iter()
                .zip(&heights.shapes[k])
                .map(|(v, s)| v * s)
                .sum()
        };
        let mut velocity = plane;
        for (share, rate) in heights.below[k].iter().zip(&rates) {
            velocity[0] += by_speed * share * rate[0];
            velocity[1] += by_speed * share * rate[1];
        }
        let temperature = dot(&place.temperature);
        let rho = dot(&thermal.densities[0]);
        let by_temperature = dot(&thermal.densities[1]);
        let capacity = heat.heat_capacity.heat_capacity(p.max(0.0), temperature);
        let conductivity = heat.conductivity.conductivity(p.max(0.0), temperature);
        let point = &mut column.heights[k];
        let along =
            velocity[0] * place.pressure_gradient[0] + velocity[1] * place.pressure_gradient[1];
        let rise = place.pressure_rate + along;
        point.velocity = velocity;
        point.temperature = temperature;
        point.capacity = rho * heat.density * capacity * h * heat.entrainment_speed / heat.length;
        point.conduction = conductivity / h;
        // The flux at this height, to be summed up below.
        point.mass_below = velocity.map(|u| place.film * rho * u);
        point.lift_capacity =
            capacity * heat.density * heat.film * heat.entrainment_speed / heat.length;
        point.compression =
            -h * temperature / rho * by_temperature * rise * heat.pressure * heat.entrainment_speed
                / heat.length;
    }
    let total = |flux: &dyn Fn(usize) -> [f64; 2], weights: &[f64]| {
        let mut sum = [0.0; 2];
        for (l, w) in weights.iter().enumerate().take(n) {
            let [x, y] = flux(l);
            sum[0] += w * x;
            sum[1] += w * y;
        }
        sum
    };
    let fluxes = column.heights;
    let flux = |l: usize| fluxes[l].mass_below;
    let whole = total(&flux, heights.weights());
    for k in 0..n {
        let share = heights.points()[k] + 0.5;
        let below = total(&flux, &heights.below[k]);
        column.heights[k].mass_below = [0, 1].map(|i: usize| below[i] - share * whole[i]);
    }
    if place.filling < 1.0 {
        column.scale(place.filling);
    }
    column
}
