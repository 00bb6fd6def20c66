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
//!   ∫ h ∂p/∂x dA = −∫ p ∂h_0/∂x dA                      round all of the film: a half-space presses itself nowhere, ∫ p ∂δ/∂x dA = 0
//! ```
//!
//! Theory: Traction and heat.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::far_field::far_field;
use super::flux::mass_flux;
use super::region::Region;
use super::{Extents, Film, Point, PointFields, Problem};
use crate::contact::{Outline, Scales, Shape, Symmetry};
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::solution::BeyondEdges;

/// Shear of the film at one point, SI.
#[derive(Clone, Copy, Debug)]
pub struct PointShear {
    /// τ_zx and τ_zy at mid-film, plane and ball, Pa.
    pub stress: [[f64; 2]; 3],
    /// Sizes of the whole stress vector there, Pa.
    pub equivalent: [f64; 3],
    /// Generalized viscosity at mid-film, Pa·s.
    pub viscosity: f64,
    /// Stress at the ball less that at the plane, h∇p, Pa.
    pub difference: [f64; 2],
    /// Heat of friction per area, W/m².
    pub power: f64,
}

/// Evaluates the shear of a film.
pub struct Shear<'a> {
    fluid: &'a FilmFluid,
    scales: &'a Scales,
    rule: CrossFilm,
}

impl<'a> Shear<'a> {
    /// Of a fluid.
    pub fn new(fluid: &'a FilmFluid, scales: &'a Scales) -> Shear<'a> {
        Shear {
            fluid,
            scales,
            rule: CrossFilm::default(),
        }
    }

    /// Shear at a point.
    pub fn at(&mut self, f: &PointFields) -> PointShear {
        let fluid = self.fluid.local(f.pressure, f.temperature.as_deref());
        let mu = fluid.point().viscosity[0];
        let (g, omega) = fluid.demands(f.place, f.pressure_gradient, f.film);
        let film = fluid.flow(g, omega, &mut self.rule);
        let mid = film.mid_stress;
        let scale = self.fluid.stress_scale();
        let at = |s: f64| [0, 1].map(|i| scale * (mid[i] + s * g[i]));
        let stresses = [at(0.0), at(-0.5), at(0.5)];
        let viscosity = mu * self.scales.viscosity;
        let squared = mid[0] * mid[0] + mid[1] * mid[1];
        PointShear {
            stress: stresses,
            equivalent: stresses.map(|t| t[0].hypot(t[1])),
            viscosity: viscosity / fluid.relative_fluidity(0.0, squared),
            difference: g.map(|g| scale * g),
            power: f.film * self.scales.film * scale * scale / viscosity * film.work,
        }
    }
}

/// Integrals of the shear over the contact area, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Traction coefficients, along and across the motion, from the stress at mid-film, plane and ball.
    pub coefficients: [[f64; 2]; 3],
    /// Traction force at mid-film, likewise, N or N/m.
    pub force: [f64; 2],
    /// Moment of the traction at mid-film about the contact normal, N m, and the sum of the sizes of its parts.
    pub moment: [f64; 2],
    /// Work of the surfaces on the film, W or W/m.
    pub work: f64,
    /// What shear dissipates, W or W/m.
    pub dissipation: f64,
    /// Traction coefficient at the ball less that at the plane, along the motion.
    pub rolling: f64,
    /// Largest shear stress anywhere in the film, Pa.
    pub stress_maximum: f64,
    /// Shares of the Hertz zone where the stress is beyond each Newtonian limit of the fluid; `None` where it has
    /// no such limit.
    pub beyond: [Option<f64>; 2],
}

/// The same over parts of the contact area, and what they should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frictions {
    /// As far as the bodies reach.
    pub here: Friction,
    /// Over a shorter distance: what lies between tells how much the end counts. The same again where the contact area ends before the
    /// bodies do.
    pub shorter: Friction,
    /// Over all of the contact area.
    pub whole: Friction,
    /// Whether the bodies end on the contact area.
    pub is_cut: bool,
    /// Work that flows out with the pressure where the bodies end, W or W/m; of isothermal films.
    pub through_end: f64,
    /// −∫p ∂h_0/∂x dA over the load, which `whole.rolling` should be.
    pub offset: f64,
}

impl Frictions {
    /// Work of the surfaces less all that becomes of it, W or W/m; of isothermal films.
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

/// Whether anything may pull across the motion: not where both halves of a contact are alike, nor along a cylinder whose surface does
/// not slide there.
pub fn is_askew(shape: &Shape, fluid: &FilmFluid) -> bool {
    let halves_differ = !shape.is_line() && shape.symmetry == Symmetry::Full;
    halves_differ || !fluid.slide().is_along_x()
}

/// What a point adds to the sums.
struct Part<'a> {
    fields: &'a PointFields,
    shear: &'a PointShear,
    /// Work of the surfaces there, W/m².
    work: f64,
    /// P ∂G/∂X.
    offset: f64,
    /// Stresses that its largest one is compared with, where it lies in the Hertz zone.
    limits: Option<[Option<f64>; 2]>,
}

impl Sums {
    /// Adds a point that stands for an area, whose gap may not be full.
    fn add(&mut self, area: f64, point: &Part) {
        if area == 0.0 {
            return;
        }
        let s = point.shear;
        self.offset += area * point.offset;
        // Oil that does not fill the gap shears on the share of the area that it wets.
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
                offset: fields.pressure * shape.gap.at([x, y]).gradient[0],
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
    // Added up in order: the sums do not depend on the threads.
    let found: Vec<([Sums; 3], bool)> = (film.points().groups())
        .par_iter()
        .with_min_len(BATCH)
        .map_init(|| Shear::new(fluid, scales), of_group)
        .collect();
    let is_cut = found.iter().any(|(_, cut)| *cut);
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
        shorter: of(if is_cut { shorter } else { here }),
        whole: of(whole),
        is_cut,
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

/// What rolling drags along between the edges r_0 of the contact area and the distance r_1 to which it would go without being set by hand, where the
/// surfaces are parabolas and rigid:
///
/// ```text
///   P = −c λ X/H²,  X < 0:   ∫½H ∂P/∂X dA = πcλ ln(r_1/r_0),  H = r²/2,  c = 1/5    around a sphere
///                                         = 3cλ (1/r_0 − 1/r_1),  H = X²/2,  c = 1/3    along a cylinder
/// ```
/// (Kapitza 1955), by both walls against the motion; `reach` is r_1 at the inlet and at the side, in half-widths, `stress_scale` a p_h/R in Pa. Around a sphere it
/// grows without end with r_1.
pub fn beyond_edges(
    shape: &Shape,
    extents: &Extents,
    reach: [f64; 2],
    stress_scale: f64,
    scales: &Scales,
) -> BeyondEdges {
    let edge = extents.inlet.abs();
    // Nothing is dragged along beyond the bodies.
    let reach = [
        reach[0].min(shape.ends[0]),
        reach[1].min(shape.ends[1] / shape.zone.axis_ratio),
    ];
    let further = match shape.outline() {
        Outline::Ellipse => (reach[0] / edge).max(reach[1] / extents.side),
        Outline::Strip | Outline::Roller(_) => reach[0] / edge,
    };
    if further <= 1.0 {
        return BeyondEdges::default();
    }
    // Over the part that is solved, as the load.
    let drag = scales.lambda
        * far_field(&shape.gap)[0]
        * match shape.outline() {
            // Over rings as stretched as the Hertz zone, or stretched in any other way.
            Outline::Ellipse => {
                PI * further.ln()
                    / (shape.symmetry.multiplicity() * shape.gap.curvature_ratio.sqrt())
            }
            Outline::Strip => 3.0 * (1.0 - 1.0 / further) / edge,
            // The cylinder's, all along the part that is solved.
            Outline::Roller(roller) => {
                let length = 2.0 * roller.half_length();
                3.0 * (1.0 - 1.0 / further) / edge * length / shape.symmetry.multiplicity()
            }
        };
    let speed = scales.entrainment_speed();
    BeyondEdges {
        traction: drag * stress_scale / (scales.load * scales.pressure),
        // Of both walls, at the mean speed.
        power: 2.0 * drag * stress_scale * scales.area(shape) * speed,
        cut: 1.0 - 1.0 / further,
    }
}

/// Groups of points that a thread takes at a time.
const BATCH: usize = 16;

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::contact::{Gap, HertzZone, Inlet, Turn};

    /// The far field by quadrature in ring and angle, ½H ∂P/∂X by differences, over the half of a ball and the line of a roller.
    #[test]
    fn drag_beyond_the_edges() {
        let scales = Scales {
            length: 2e-4,
            pressure: 1e9,
            film: 2.5e-6,
            viscosity: 0.04,
            density: 870.0,
            lambda: 0.01,
            elastic_stress: 8e10,
            load: PI / 3.0,
        };
        let extents = |inlet, side| Extents {
            inlet,
            outlet: 1.5,
            side,
            body_width: 60.0,
            body_depth: 60.0,
        };
        let slope = |p: &dyn Fn(f64) -> f64, x: f64| (p(x + 1e-4) - p(x - 1e-4)) / 2e-4;
        let n = 2000;
        let radii = (0..n).map(|i| {
            (
                3.0 + 6.0 * (f64::from(i) + 0.5) / f64::from(n),
                6.0 / f64::from(n),
            )
        });
        let [mut ball, mut barrel, mut roller] = [0.0; 3];
        let ellipse = Shape {
            dim: 2,
            gap: Gap {
                curvature_ratio: 0.3,
                turn: Turn::NONE,
                terms: Vec::new(),
            },
            zone: HertzZone {
                axis_ratio: 1.7,
                turn: Turn::NONE,
                roller: None,
            },
            symmetry: Symmetry::Full,
            inlet: Inlet::Flooded,
            ends: [f64::INFINITY; 2],
        };
        for (r, width) in radii {
            for k in 0..64 {
                // A quarter of the plane: X < 0, one side of Y = 0
                let angle = 0.5 * PI * (f64::from(k) + 0.5) / 64.0;
                let (x, y) = (-r * angle.cos(), r * angle.sin());
                let film = |x: f64| 0.5 * (x * x + y * y);
                let p = |x: f64| -0.2 * scales.lambda * x / film(x).powi(2);
                ball += 0.5 * PI / 64.0 * r * width * 0.5 * film(x) * slope(&p, x);
                // Both sides, in rings 1.7 times as wide as long
                let film = |x: f64| ellipse.gap.value([x, 1.7 * y]);
                let p = |x: f64| -scales.lambda / 3.6 * x / film(x).powi(2);
                barrel += PI / 64.0 * 1.7 * r * width * 0.5 * film(x) * slope(&p, x);
            }
            let p = |x: f64| -scales.lambda / 3.0 * x / (0.5 * x * x).powi(2);
            roller += width * 0.25 * r * r * slope(&p, -r);
        }
        let unit = 1.25e7;
        for (shape, reach, drag) in [
            (Shape::CIRCULAR, [9.0, 6.0], ball),
            (ellipse, [9.0, 6.0], barrel),
            (Shape::LINE, [9.0, 0.0], roller),
        ] {
            let found = beyond_edges(&shape, &extents(-3.0, 4.0), reach, unit, &scales);
            let traction = drag * unit / (scales.load * scales.pressure);
            assert_relative_eq!(found.traction, traction, max_relative = 1e-4);
            // 2 F u of a force F, with the entrainment speed u = λa³p_h/(12 μ R²).
            let speed = 0.01 * 8e-12 * 1e9 / (12.0 * 0.04 * 0.016 * 0.016);
            let force = drag * unit * scales.area(&shape);
            assert_relative_eq!(found.power, 2.0 * force * speed, max_relative = 1e-4);
            assert_relative_eq!(found.cut, 2.0 / 3.0, max_relative = 1e-12);
        }
        let own = beyond_edges(
            &Shape::CIRCULAR,
            &extents(-9.0, 6.0),
            [9.0, 6.0],
            unit,
            &scales,
        );
        assert_eq!(own, BeyondEdges::default());
    }
}
