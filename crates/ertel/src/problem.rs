//! From a case to its dimensionless problem: scales, equations, meshes, stages.

mod area;
mod outlet;
mod reliefs;
mod thinning;

use crate::case::{Body, Case, SolidHeat};
use crate::contact::starvation::starved_film;
use crate::contact::{
    Contact, Family, Groups, Hertz, Inlet, Material, OilLayer, Outline, Planar, Scales, Shape,
    Supply, equivalent_body,
};
use crate::elastic::Elasticity;
use crate::film::FilmFluid;
use crate::forms::energy::{BodyHeat, Heat};
use crate::layers::Layer;
use crate::mixed::Rough;
use crate::params::{
    DEFAULT_MAX_UNKNOWNS, DEFAULT_MAX_UNKNOWNS_OF_BODIES, ElasticModel, Formulation, MeshParams,
};
use crate::reference::{moes_line_film, nijenbanning_venner_moes_film};
use crate::solution::Role;
use crate::solve::discretisation::LevelSizes;
use crate::solve::heat::column::Column;
use crate::solve::heat::coupling::CouplingParams;
use crate::solve::newton_level::NewtonParams;
use crate::solve::sequence::{HeatPlan, Plan, Problem, Stage, Target};
use crate::solve::state::FilmConstants;
pub use reliefs::{largest_cell, with_reliefs};

/// Dimensionless problem of a case.
pub fn problem(case: &Case) -> Problem {
    make(case, None)
}

/// The same for a case close to that of `own`, with which it shares tabulated properties of the fluid: for residuals, not for solves.
pub fn nearby_problem(case: &Case, own: &Problem) -> Problem {
    make(case, Some(own))
}

fn make(case: &Case, own: Option<&Problem>) -> Problem {
    let contact = case.contact.along_motion();
    let hertz = Hertz::new(&contact, case.reduced_modulus());
    let shape = Shape::near(&contact, &hertz, &case.motion, own.map(|own| &own.shape));
    let mut scales = scales(case, (&contact, &hertz, &shape));
    let shape = shape.with_inlet(inlet(case, &scales));
    let shape = reliefs::with_reliefs(shape, case.standing_reliefs(), &mut scales);
    let flooded_film = predicted_film(case) / scales.film;
    let start_film = starved_film(
        contact.kind.family(),
        flooded_film,
        &case.supply,
        scales.length,
        scales.film,
    );
    let mesh_film = thinning::film_of_mesh(case, start_film * scales.film) / scales.film;
    let elasticity = elasticity(case, &scales);
    let (heat, heat_plan) = heat(case, &scales).unzip();
    let (fluid, friction) = fluids(case, own.map(|own| &own.fluid), &scales, heat_plan.as_ref());
    let reach = area::reach(
        contact.kind.family(),
        case.elastic_model(),
        heat.is_some(),
        flooded_film,
    );
    let rough = rough(case, &scales);
    let extents = area::extents(reach, &case.mesh, flooded_film, &shape);
    let family = contact.kind.family();
    let mut extents = area::of_rough(extents, &case.mesh, family, rough.as_ref());
    if let Supply::Meniscus { distance } = case.supply {
        extents.inlet = -distance / scales.length;
    }
    let far_outlet =
        matches!(shape.outline(), Outline::Ellipse) && outlet::is_far(extents.outlet, flooded_film);
    let constants = film_constants(case, &scales, start_film, far_outlet);
    let plan = Plan {
        stages: stages(
            (&case.mesh, rim_finesse(case)),
            mesh_film,
            constants,
            case.solver.error_estimate,
            case.shear_thinning().is_some(),
            heat.is_some(),
        ),
        mesh_film,
        thinned_share: mesh_film / start_film,
        newton: NewtonParams {
            update_tolerance: case.solver.tolerance,
            residual_tolerance: case.solver.tolerance,
            max_iterations: case.solver.max_iterations,
            ..NewtonParams::default()
        },
        linear: case.solver.linear,
        target: target(case, &shape),
        heat: heat_plan,
    };
    Problem {
        extents,
        reach: [reach.inlet, reach.side],
        elasticity,
        fluid,
        friction,
        entrainment: case.motion.entrainment(scales.length),
        load: scales.load,
        start_film: START_FILM * start_film,
        heat,
        rough,
        scales,
        plan,
        shape,
    }
}

/// Rough surfaces of a case that describes their asperities.
fn rough(case: &Case, scales: &Scales) -> Option<Rough> {
    let (asperities, rms_height) = (case.asperities.as_ref()?, case.roughness?);
    Some(Rough::new(
        asperities,
        rms_height,
        case.reduced_modulus(),
        scales,
    ))
}

fn inlet(case: &Case, scales: &Scales) -> Inlet {
    match case.supply {
        Supply::Flooded => Inlet::Flooded,
        Supply::Meniscus { .. } => Inlet::Meniscus,
        Supply::OilLayer { thickness } => Inlet::Layer(OilLayer {
            thickness: thickness / scales.film,
            lambda: scales.lambda,
        }),
    }
}

/// Elastic response of the bodies.
fn elasticity(case: &Case, scales: &Scales) -> Elasticity {
    let materials = [&case.body_1, &case.body_2].map(|body| body.elasticity);
    let model = case.elastic_model();
    let bodies = match model {
        ElasticModel::Equivalent => vec![equivalent_body(materials[0], materials[1])],
        ElasticModel::TwoBodies | ElasticModel::HalfSpace => materials.to_vec(),
    };
    let bodies: Vec<Material> = (bodies.into_iter())
        .map(|body| body.over(scales.elastic_stress))
        .collect();
    let order = case.mesh.elastic_order;
    match model {
        ElasticModel::HalfSpace => {
            Elasticity::half_space(order.unwrap_or(1).max(case.mesh.pressure_order), &bodies)
                .with_layers(layers(case, scales))
        }
        _ => Elasticity::finite_elements(order.unwrap_or(2).min(2), &bodies),
    }
}

/// The layers of both bodies, lengths in half-widths.
fn layers(case: &Case, scales: &Scales) -> Vec<Vec<Layer>> {
    let scaled = |layer: Layer| Layer {
        thickness: layer.thickness / scales.length,
        material: layer.material.over(scales.elastic_stress),
    };
    let bodies = [&case.body_1, &case.body_2].map(Body::coated).into_iter();
    bodies
        .map(|body| body.layers.into_iter().map(scaled).collect())
        .collect()
}

/// The fluid of the film, close to `own` if given, and that of friction where it follows another law.
fn fluids(
    case: &Case,
    own: Option<&FilmFluid>,
    scales: &Scales,
    heat: Option<&HeatPlan>,
) -> (FilmFluid, Option<FilmFluid>) {
    let lubricant = &case.lubricant;
    let sliding = case.motion.sliding(scales.length);
    let (density, viscosity) = (&lubricant.density, &lubricant.viscosity);
    let (temperature, thinning) = (lubricant.temperature, case.shear_thinning());
    let mut fluid = match own {
        Some(own) => own.nearby(density, viscosity, temperature, thinning, &sliding, scales),
        None => FilmFluid::new(density, viscosity, temperature, scales)
            .with_shear(thinning, &sliding, scales),
    };
    if let Some(plan) = heat {
        fluid = fluid.with_nodes(plan.column.film.clone());
    }
    let friction = (case.friction_thinning())
        .filter(|_| thinning.is_none())
        .map(|law| fluid.clone().with_shear(Some(law), &sliding, scales));
    (fluid, friction)
}

/// Constants of the film equation; `start_film` over the scale of films.
fn film_constants(
    case: &Case,
    scales: &Scales,
    start_film: f64,
    far_outlet: bool,
) -> FilmConstants {
    let solver = &case.solver;
    FilmConstants {
        lambda: scales.lambda,
        entrainment: case.motion.entrainment(scales.length),
        formulation: solver.formulation,
        isotropic_diffusion: solver.isotropic_diffusion,
        elastic_stabilisation: solver.elastic_stabilisation,
        penalty: solver.penalty,
        penalty_scaling: solver.penalty_scaling,
        film_scale: start_film,
        far_outlet,
    }
}

/// Accuracy to which the meshes of a case are halved, if it has one.
fn target(case: &Case, shape: &Shape) -> Option<Target> {
    let error = case.mesh.target_error?;
    let most = match case.elastic_model() {
        ElasticModel::HalfSpace => DEFAULT_MAX_UNKNOWNS,
        _ => DEFAULT_MAX_UNKNOWNS_OF_BODIES,
    };
    // Where both halves are solved, each counts.
    let parts = match shape.is_line() {
        true => 1,
        false => (2.0 / shape.symmetry.multiplicity()) as usize,
    };
    Some(Target {
        error,
        max_unknowns: case.mesh.max_unknowns.unwrap_or(parts * most),
    })
}

/// Heat of a case and how it is solved for, if it counts and its data are complete.
fn heat(case: &Case, scales: &Scales) -> Option<(Heat, HeatPlan)> {
    let data = case.heat().ok().flatten()?;
    let params = data.params;
    let u_m = case.motion.entrainment_speed;
    let [first, second] = case.motion.surfaces(scales.length);
    let body = |solid: &SolidHeat, velocity: Planar| BodyHeat {
        density: solid.density,
        conductivity: solid.conductivity.clone(),
        heat_capacity: solid.heat_capacity.clone(),
        layers: solid.heat_layers(),
        velocity,
        bulk_temperature: solid.temperature,
    };
    let heat = Heat {
        conductivity: data.conductivity.clone(),
        heat_capacity: data.heat_capacity.clone(),
        bodies: [body(&data.body_1, first), body(&data.body_2, second)],
        inlet_temperature: case.lubricant.temperature,
        length: scales.length,
        film: scales.film,
        pressure: scales.pressure,
        density: scales.density,
        viscosity: scales.viscosity,
        lambda: scales.lambda,
        entrainment_speed: u_m,
    };
    let penetration_depths =
        (heat.bodies.each_ref()).map(|b| b.diffusion_depth(scales.length).min(1.0));
    let column = Column::new(
        params.film_order,
        params.solid_elements,
        params.depth,
        penetration_depths,
    );
    let plan = HeatPlan {
        surface_order: params.surface_order,
        column,
        coupling: CouplingParams {
            tolerance: params.tolerance,
            max_rounds: params.max_iterations,
            ..CouplingParams::default()
        },
    };
    Some((heat, plan))
}

/// Size of the first cells on the outlet side of the rim over that on the other, where the mesh of half-spaces is halved.
///
/// The side lobes grow thinner with the load group than the central film that sets the sizes: h_min/h_c is 0.47 at M = 200, 0.30 at 2,000, 0.2
/// at 10,000 (L = 5 to 10), about as M^(−1/5). Cells of the length h^(2/3) follow them; on coarser ones the film there comes out negative, and
/// Newton's method cycles.
fn rim_finesse(case: &Case) -> f64 {
    let refined = case.mesh.target_error.is_some();
    let half_spaces = case.elastic_model() == ElasticModel::HalfSpace;
    if !(refined && half_spaces && case.contact.kind.family() == Family::Point) {
        return 1.0;
    }
    let load = groups(case, 0.0).moes_load;
    (MODERATE_LOAD / load).powf(2.0 / 15.0).clamp(0.5, 1.0)
}

/// Film of the start over that of the formula: a film that starts too thick closes in from the safe side.
const START_FILM: f64 = 1.5;

/// Load group up to which first meshes need no finer side lobes.
const MODERATE_LOAD: f64 = 200.0;

/// Groups of a case for a pressure-viscosity coefficient in 1/Pa.
pub fn groups(case: &Case, pressure_viscosity_coefficient: f64) -> Groups {
    Groups::new(
        &case.contact,
        case.reduced_modulus(),
        case.lubricant.ambient_viscosity(),
        case.motion.entrainment_speed,
        pressure_viscosity_coefficient,
    )
}

/// Central film, m, that the formulas of Moes (line) and Nijenbanning et al. (circular, elliptical) predict for an incompressible
/// lubricant: the basis of meshes and starts of solves. [`estimated_film`] is the estimate.
pub fn predicted_film(case: &Case) -> f64 {
    let slope = case
        .lubricant
        .viscosity
        .pressure_viscosity_slope(case.lubricant.temperature);
    let g = groups(case, slope.max(0.0));
    let [along, across] = case.contact.radii_along_and_across();
    let h = match case.contact.kind.family() {
        Family::Cylinder => moes_line_film(g.moes_load, g.moes_material),
        Family::Point => {
            nijenbanning_venner_moes_film(g.moes_load, g.moes_material, along / across)
        }
    };
    h * along * (2.0 * g.speed).sqrt()
}

/// Scales of the variables of a case whose first principal direction is the one nearest to the motion.
fn scales(case: &Case, of: (&Contact, &Hertz, &Shape)) -> Scales {
    let lubricant = &case.lubricant;
    Scales::new(
        of,
        &case.motion,
        lubricant.ambient_viscosity(),
        lubricant.ambient_density(),
    )
}

/// The same of the lubricant as it is compressed: divided by its relative density at the Hertz pressure.
pub fn estimated_film(case: &Case) -> f64 {
    predicted_film(case) / case.relative_density()
}

/// Cells of the fine mesh and of the coarse one, twice as large.
fn sizes(mesh: &MeshParams, rim_finesse: f64, film: f64) -> [LevelSizes; 2] {
    // A film thicker than the dry contact is flat sets the length √H over which pressure varies.
    let stretch = film.sqrt().max(1.0);
    // Outside its Hertz zone a dry contact gapes as the power 3/2 of the distance: within this
    // distance the gap is that of the film, and pressure builds up.
    let inlet_length = film.powf(2.0 / 3.0);
    let rim = (mesh.rim_size).unwrap_or(mesh.preset.rim_share() * inlet_length);
    let fine = LevelSizes {
        hertz: stretch * mesh.hertz_size,
        constriction: stretch * mesh.constriction_size,
        rim,
        outlet_rim: rim_finesse * rim,
        rim_width: inlet_length,
        edge: stretch * mesh.edge_size,
        growth: mesh.growth,
        depth_growth: mesh.depth_growth,
    };
    // The growth of the cells away from the contact makes errors, too: it is coarsened likewise, or
    // the error estimate would not see them.
    // Halved cells keep their growth.
    let doubled = |growth: f64| match mesh.target_error {
        Some(_) => growth,
        None => (2.0 * growth).min(LARGEST_GROWTH).max(growth),
    };
    let coarse = LevelSizes {
        hertz: 2.0 * fine.hertz,
        constriction: 2.0 * fine.constriction,
        rim: 2.0 * fine.rim,
        outlet_rim: 2.0 * fine.outlet_rim,
        rim_width: fine.rim_width,
        edge: 2.0 * fine.edge,
        growth: doubled(fine.growth),
        depth_growth: doubled(fine.depth_growth),
    };
    [fine, coarse]
}

/// A diffusive quadratic start on the coarse mesh, then the case's own discretisation on the
/// coarse mesh (for the error estimate) and on the fine one. A fluid that stress thins starts as if it did
/// not, and its Newtonian film on the coarse mesh is kept for comparison.
fn stages(
    (mesh, rim_finesse): (&MeshParams, f64),
    film: f64,
    constants: FilmConstants,
    error_estimate: bool,
    thins: bool,
    heats: bool,
) -> Vec<Stage> {
    let [fine, coarse] = sizes(mesh, rim_finesse, film);
    let start = FilmConstants {
        formulation: Formulation::Gls,
        isotropic_diffusion: constants.isotropic_diffusion.max(START_DIFFUSION),
        ..constants
    };
    let order = mesh.pressure_order;
    let solution = Stage {
        sizes: fine,
        halvings: 0,
        pressure_order: order,
        constants,
        newtonian: false,
        heated: heats,
        role: Role::Final,
    };
    let start = Stage {
        sizes: coarse,
        pressure_order: order.min(2),
        constants: start,
        newtonian: thins,
        heated: false,
        role: Role::Start,
        ..solution
    };
    let mut stages = vec![start];
    stages.extend(thins.then_some(Stage {
        sizes: coarse,
        newtonian: true,
        heated: false,
        role: Role::Comparison,
        ..solution
    }));
    stages.extend(heats.then_some(Stage {
        sizes: coarse,
        heated: false,
        role: Role::Isothermal,
        ..solution
    }));
    if mesh.target_error.is_some() {
        // The coarse mesh is halved.
        let first = Stage {
            sizes: coarse,
            ..solution
        };
        stages.push(first);
        return stages;
    }
    let estimate = Stage {
        sizes: coarse,
        role: Role::Estimate,
        ..solution
    };
    stages.extend(error_estimate.then_some(estimate));
    stages.push(solution);
    stages
}

/// Growth of cells that coarse stages do not exceed: cells that grow by more than their distance can
/// step over a fine zone.
const LARGEST_GROWTH: f64 = 0.9;

/// Isotropic diffusion of the first stage: it only has to start the next one.
const START_DIFFUSION: f64 = 2.0;

#[cfg(test)]
mod tests {
    use std::path::Path;

    use ertel_input::Document;

    use super::*;

    /// The failure of a Newtonian contact does not mention shear thinning; that of a contact which thins far more than oils do does.
    #[test]
    fn only_thinning_fluids_are_said_to_thin() {
        let share = |lubricant: &str| {
            let text = format!(
                "lubricant = {{ temperature = \"40 degC\", {lubricant} }}\n[contact]\nkind = \"circular\"\nradius = \"16 mm\"\nload = \"100 N\"\n\
                 [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n[motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.2\n"
            );
            let document = Document::parse("case.toml", text).unwrap();
            let case = Case::from_document(&document, Path::new("")).unwrap();
            problem(&case).plan.thinned_share
        };
        assert_eq!(share("name = \"iso-vg-32-mineral\""), 1.0);
        let thinning = "name = \"iso-vg-32-mineral\", shear_thinning = { law = \"ree-eyring\", tau_0 = \"1 kPa\" }";
        assert!(share(thinning) < 0.5, "{}", share(thinning));
    }

    /// By hand: cells of the side lobes go as M^(−2/15) from M = 200 on, down to a half; only where half-spaces are refined.
    #[test]
    fn first_meshes_are_finer_at_the_side_lobes_of_heavy_loads() {
        let at = |load: f64, more: &str| {
            let text = format!(
                "lubricant = \"squalane-pip\"\ntemperature = \"40 degC\"\n[contact]\nkind = \"circular\"\nradius = \"16 mm\"\nload = \"{load:e} N\"\n\
                 [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n[motion]\nentrainment_speed = \"0.01 m/s\"\nslide_to_roll_ratio = 0.0\n{more}"
            );
            let document = Document::parse("case.toml", text).unwrap();
            let case = Case::from_document(&document, Path::new("")).unwrap();
            let sizes = problem(&case).plan.stages.last().unwrap().sizes;
            (groups(&case, 0.0).moes_load, sizes.outlet_rim / sizes.rim)
        };
        let (one, _) = at(1.0, "");
        let of = |m: f64, more: &str| at(m / one, more).1;
        for (m, ratio) in [(10.0, 1.0), (199.0, 1.0), (6400.0, 0.6300), (1e5, 0.5)] {
            approx::assert_relative_eq!(of(m, ""), ratio, max_relative = 1e-4);
        }
        for more in [
            "[mesh]\npreset = \"normal\"\n",
            "[solver]\nelasticity = \"equivalent\"\n",
        ] {
            assert_eq!(of(6400.0, more), 1.0);
        }
    }
}
