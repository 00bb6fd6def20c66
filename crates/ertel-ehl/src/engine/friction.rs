//! Shear of the film: stresses, rates, traction and friction power.
//!
//! ```text
//!   τ_z at mid-film and at both walls: S τ, S(τ ∓ G/2),  S = a p_h/R, τ and G of the closure; along and across the motion
//!   traction coefficients = ∫τ_zx dA / load, ∫τ_zy dA / load      (Habchi 2008, eq. 4.15)
//!   moment about the contact normal = ∫x τ_zy − y τ_zx dA         of the stress at mid-film
//!   work of the surfaces = ∫ u_2·τ_2 − u_1·τ_1 dA = ∫ Δu·τ + h ū·∇p dA         friction power
//!   dissipation = ∫∫ τ·γ̇ dz dA = ∫ h S²/μ₁ ∫t·tf ds dA
//! ```
//! All of these end where the bodies end ([`super::region`]). Two identities bound their errors:
//!
//! ```text
//!   work = dissipation + ∮ g m·n dl,  g = ∫dp/ρ         ∇·m = 0 of the mass flow m; round the end of the sum, where p is not zero
//!   ∫ h ∂p/∂x dA = −∫ p ∂h_0/∂x dA                      round all of the film: a half-space exerts no net force on itself, ∫ p ∂δ/∂x dA = 0
//! ```
//!
//! Theory: Traction and heat.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::around::around;
use super::flux::mass_flux;
use super::region::Region;
use super::shear::{PointShear, Shear};
use super::{Film, Point, PointFields, Problem};
use crate::contact::{Shape, Symmetry};
use crate::film::FilmFluid;

/// Integrals of the shear over the contact area, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Traction coefficients, along and across the motion, from the stress at mid-film, body 1 and body 2.
    pub coefficients: [[f64; 2]; 3],
    /// Traction force at mid-film, likewise, N or N/m.
    pub force: [f64; 2],
    /// Moment of the traction at mid-film about the contact normal, N m, and the sum of the sizes of its parts.
    pub moment: [f64; 2],
    /// Work of the surfaces on the film, W or W/m.
    pub work: f64,
    /// Dissipation by shear, W or W/m.
    pub dissipation: f64,
    /// Traction coefficient at body 2 less that at body 1, along the motion.
    pub rolling: f64,
    /// Largest shear stress anywhere in the film, Pa.
    pub stress_maximum: f64,
    /// Shares of the Hertz zone where the stress is beyond each Newtonian limit of the fluid; `None` where it has
    /// no such limit.
    pub beyond: [Option<f64>; 2],
}

/// The same over parts of the contact area, and over all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictions {
    /// As far as the bodies reach.
    pub here: Friction,
    /// Over a shorter distance: the difference shows the influence of the end. Equal to `here` for lines and rollers that end before the
    /// bodies do.
    pub shorter: Friction,
    /// Over all of the contact area and its surroundings.
    pub whole: Friction,
    /// Whether the bodies end on the contact area.
    pub is_cut: bool,
    /// Whether the sums end where the bodies do, on the contact area or around it.
    pub ends_with_bodies: bool,
    /// Work of the surfaces around the contact area, W or W/m.
    pub work_around: f64,
    /// Work that flows out with the pressure where the bodies end, W or W/m; of isothermal films.
    pub through_end: f64,
    /// −∫p ∂h_0/∂x dA over the load, which `whole.rolling` should be; between rough surfaces of the pressure of oil and asperities, plus ∫(g − h) ∂p/∂x dA of the oil.
    pub offset: f64,
}

impl Frictions {
    /// Error of the work balance of the surfaces, W or W/m; of isothermal films.
    pub fn power_misfit(&self) -> f64 {
        self.here.work - self.here.dissipation - self.through_end
    }

    /// Error of the traction coefficient at either wall, by the load's own position.
    pub fn wall_misfit(&self) -> f64 {
        0.5 * (self.whole.rolling - self.offset)
    }
}

/// The sums that they are made of, over some elements.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    force: [[f64; 2]; 3],
    moment: [f64; 2],
    work: f64,
    rolling: f64,
    offset: f64,
    power: f64,
    stress_maximum: f64,
    zone: f64,
    beyond: [f64; 2],
}

impl Sums {
    fn and(self, other: Sums) -> Sums {
        Sums {
            force: [0, 1, 2]
                .map(|k: usize| [0, 1].map(|i: usize| self.force[k][i] + other.force[k][i])),
            moment: [0, 1].map(|k: usize| self.moment[k] + other.moment[k]),
            work: self.work + other.work,
            rolling: self.rolling + other.rolling,
            offset: self.offset + other.offset,
            power: self.power + other.power,
            stress_maximum: self.stress_maximum.max(other.stress_maximum),
            zone: self.zone + other.zone,
            beyond: [0, 1].map(|k: usize| self.beyond[k] + other.beyond[k]),
        }
    }
}

/// Whether there may be traction across the motion: not in contacts with equal halves, nor along a cylinder whose surface does
/// not slide there.
pub fn is_skewed(shape: &Shape, fluid: &FilmFluid) -> bool {
    let halves_differ = !shape.is_line() && shape.symmetry == Symmetry::Full;
    halves_differ || !fluid.slide().is_along_x()
}

/// Contribution of a point to the sums.
struct Part<'a> {
    fields: &'a PointFields,
    shear: &'a PointShear,
    /// Work of the surfaces there, W/m².
    work: f64,
    /// P ∂G/∂X − (g − H) ∂p/∂X, g: the gap that flows between rough surfaces.
    offset: f64,
    /// Stresses that its largest one is compared with, where it lies in the Hertz zone.
    limits: Option<[Option<f64>; 2]>,
}

impl Sums {
    /// Adds a point that represents an area, whose gap may be partly filled.
    fn add(&mut self, area: f64, point: &Part) {
        if area == 0.0 {
            return;
        }
        let s = point.shear;
        self.offset += area * point.offset;
        // Oil in a partly filled gap is sheared on the share of the area that it wets.
        let area = area * point.fields.filling();
        let sums = self.force.iter_mut().flatten();
        for (sum, stress) in sums.zip(s.stress.into_iter().flatten()) {
            *sum += area * stress;
        }
        let [x, y] = point.fields.place;
        let turning = x * s.stress[0][1] - y * s.stress[0][0];
        self.moment[0] += area * turning;
        self.moment[1] += area * turning.abs();
        self.work += area * point.work;
        self.rolling += area * s.difference[0];
        self.power += area * s.power;
        let largest = s.equivalent.into_iter().fold(0.0, f64::max);
        self.stress_maximum = self.stress_maximum.max(largest);
        let Some(limits) = point.limits else {
            return;
        };
        self.zone += area;
        for (sum, limit) in self.beyond.iter_mut().zip(limits) {
            if limit.is_some_and(|l| largest > l) {
                *sum += area;
            }
        }
    }
}

/// Traction and friction of a film.
pub fn friction<Plan>(problem: &Problem<Plan>, fluid: &FilmFluid, film: &impl Film) -> Frictions {
    let (scales, shape) = (&problem.scales, &problem.shape);
    let entrainment = &problem.entrainment;
    let speed = scales.entrainment_speed();
    // Δu = σ a p_h/R h/μ in the units of Ω.
    let sliding = fluid.stress_scale() * scales.film / scales.viscosity;
    let constant = fluid.newtonian_limits(0.0);
    let of_group = |shear: &mut Shear, points: &Vec<Point>| {
        let mut sums = [Sums::default(); 3];
        for point in points {
            let fields = &point.fields;
            let [x, y] = fields.place;
            let s = shear.at(fields);
            let slide = fluid.slide().at([x, y]).map(|s| sliding * s);
            let mean = entrainment.at([x, y]).map(|u| speed * u);
            let work = |i: usize| slide[i] * s.stress[0][i] + mean[i] * s.difference[i];
            let part = Part {
                work: work(0) + work(1),
                offset: fields.total_pressure() * shape.gap.at([x, y]).gradient[0]
                    - fields.excess * fields.pressure_gradient[0],
                limits: (point.in_zone).then(|| match fluid.limits_depend_on_pressure() {
                    true => fluid.newtonian_limits(fields.pressure),
                    false => constant,
                }),
                fields,
                shear: &s,
            };
            let [here, shorter] = point.within;
            for (sums, share) in sums.iter_mut().zip([here, shorter, 1.0]) {
                sums.add(point.area * share, &part);
            }
        }
        (sums, points.iter().any(|point| point.within[0] != 1.0))
    };
    let around = around(problem, film);
    let groups = film.points().groups();
    // Added up in order: the sums do not depend on the threads.
    let found: Vec<([Sums; 3], bool)> = (groups.par_iter().chain([&around]))
        .with_min_len(BATCH)
        .map_init(|| Shear::new(fluid, scales), of_group)
        .collect();
    let is_cut = found.iter().any(|(_, cut)| *cut);
    let ends_with_bodies = is_cut || !around.is_empty();
    let mut sums = [Sums::default(); 3];
    for (of_group, _) in &found {
        sums = [0, 1, 2].map(|k: usize| sums[k].and(of_group[k]));
    }
    let area = scales.area(shape);
    let load = scales.load * scales.pressure;
    let of = |sums: &Sums| Friction {
        coefficients: sums.force.map(|force| force.map(|force| force / load)),
        force: sums.force[0].map(|force| force * area),
        moment: sums.moment.map(|moment| moment * area * scales.length),
        work: sums.work * area,
        dissipation: sums.power * area,
        rolling: sums.rolling / load,
        stress_maximum: sums.stress_maximum,
        beyond: [0, 1].map(|k: usize| constant[k].map(|_| sums.beyond[k] / sums.zone)),
    };
    let [here, shorter, whole] = &sums;
    let through_end = match is_cut {
        true => through_end(problem, fluid, film),
        false => 0.0,
    };
    Frictions {
        here: of(here),
        shorter: of(if ends_with_bodies { shorter } else { here }),
        whole: of(whole),
        is_cut,
        ends_with_bodies,
        work_around: (found.last().filter(|_| !around.is_empty()))
            .map_or(0.0, |([here, ..], _)| here.work * area),
        through_end: through_end * scales.pressure * speed * scales.film / scales.length * area,
        offset: -whole.offset * fluid.stress_scale() / load,
    }
}

/// Places round the end of a sum.
const END_POINTS: usize = 720;

/// ∮ g m·n dl, g = ∫dP/ρ̄, round the end of a region over the part that is solved; beyond the contact area there is no pressure.
fn through_end<Plan>(problem: &Problem<Plan>, fluid: &FilmFluid, film: &impl Film) -> f64 {
    let region = Region::of(&problem.shape);
    let through = |place: [f64; 2], normal: [f64; 2]| {
        let Some(f) = film.at(place) else {
            return 0.0;
        };
        let volume = |p: f64| 1.0 / fluid.local(p, f.temperature.as_deref()).point().density[0];
        let p = f.pressure;
        let g = p / 6.0 * (volume(0.0) + 4.0 * volume(0.5 * p) + volume(p));
        let flux = mass_flux(fluid, problem.scales.lambda, &problem.entrainment, &f);
        g * (flux[0] * normal[0] + flux[1] * normal[1])
    };
    let middles = (0..END_POINTS).map(|i| (i as f64 + 0.5) / END_POINTS as f64);
    let whole = problem.shape.symmetry == Symmetry::Full;
    if problem.shape.is_line() {
        let end = region.along();
        return through([-end, 0.0], [-1.0, 0.0]) + through([end, 0.0], [1.0, 0.0]);
    }
    if region.end_at(0.0).is_some() {
        let angle = if whole { 2.0 * PI } else { PI };
        let step = angle / END_POINTS as f64;
        return middles
            .filter_map(|t| region.end_at((t - 1.0) * angle))
            .map(|(place, normal)| step * through(place, normal))
            .sum();
    }
    // Along a roller, whose film ends with it.
    let half = (problem.shape.zone.roller.as_ref()).map_or(0.0, |roller| roller.half_length());
    let length = if whole { 2.0 * half } else { half };
    let end = region.along();
    middles
        .map(|t| t * length - half)
        .map(|y| through([-end, y], [-1.0, 0.0]) + through([end, y], [1.0, 0.0]))
        .sum::<f64>()
        * length
        / END_POINTS as f64
}

/// Groups of points that a thread takes at a time.
const BATCH: usize = 16;
