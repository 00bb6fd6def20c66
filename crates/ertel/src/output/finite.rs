//! Guard: no result with a number that is not finite leaves the program.

use crate::case::CaseEcho;
use crate::solution::{Estimate, FilmTemperatures, Located, ShearFields, Solution, Thermal};

/// Name of the first number that is not finite, or `None` if all are.
pub(super) fn first_not_finite(case: &CaseEcho, solution: &Solution) -> Option<String> {
    inputs(case)
        .chain(figures(solution))
        .chain(effort(solution))
        .find(|(_, value)| !value.is_finite())
        .map(|(name, _)| name)
        .or_else(|| fields(solution))
}

fn inputs(case: &CaseEcho) -> impl Iterator<Item = (String, f64)> {
    let named = [
        ("radius", case.contact.radius),
        ("load", case.contact.load),
        ("entrainment speed", case.motion.entrainment_speed),
        ("slide-to-roll ratio", case.motion.slide_to_roll_ratio),
        (
            "Young's modulus of the plane",
            case.plane.elasticity.youngs_modulus,
        ),
        (
            "Poisson's ratio of the plane",
            case.plane.elasticity.poissons_ratio,
        ),
        (
            "Young's modulus of the ball",
            case.ball.elasticity.youngs_modulus,
        ),
        (
            "Poisson's ratio of the ball",
            case.ball.elasticity.poissons_ratio,
        ),
        ("viscosity", case.fluid.viscosity),
        ("density", case.fluid.density),
        (
            "pressure-viscosity coefficient",
            case.fluid.pressure_viscosity,
        ),
        (
            "asymptotic pressure-viscosity coefficient",
            case.fluid.pressure_viscosity_asymptotic.unwrap_or(0.0),
        ),
        ("temperature", case.temperature),
        ("tolerance", case.solver.tolerance),
        ("cavitation penalty", case.solver.penalty),
        ("isotropic diffusion", case.solver.isotropic_diffusion),
    ];
    let mesh = &case.mesh;
    let sizes = [
        mesh.hertz_size,
        mesh.constriction_size,
        mesh.edge_size,
        mesh.growth,
        mesh.depth_growth,
    ];
    let chosen = [
        mesh.rim_size,
        mesh.inlet,
        mesh.outlet,
        mesh.side,
        mesh.body_width,
        mesh.body_depth,
    ]
    .into_iter()
    .flatten();
    let mesh = sizes
        .into_iter()
        .chain(chosen)
        .map(|v| ("mesh size".to_owned(), v));
    named
        .map(|(n, v)| (n.to_owned(), v))
        .into_iter()
        .chain(mesh.collect::<Vec<_>>())
}

fn figures(solution: &Solution) -> impl Iterator<Item = (String, f64)> {
    let s = &solution.summary;
    let mut list = vec![
        ("half-width", solution.hertz.half_width),
        ("Hertz pressure", solution.hertz.pressure),
        ("reduced modulus", solution.reduced_modulus),
        ("smallest pressure", s.pressure_minimum),
        ("film balance error", s.film_balance_error),
        ("load balance error", s.load_balance_error),
        ("rigid separation", s.rigid_separation),
        ("work of the surfaces", solution.checks.power.value),
        ("dissipation", solution.checks.power.other),
        ("rolling resistance", solution.checks.rolling.value),
        ("load offset", solution.checks.rolling.other),
        ("end of the bodies", solution.summed_to.body_end_x),
    ];
    let t = &solution.traction;
    let mut estimates = vec![
        ("central film thickness", s.film_central),
        ("minimum film thickness", s.film_minimum),
        ("outlet position", s.outlet_position),
        ("traction", t.coefficient),
        ("traction", t.coefficient_body_1),
        ("traction", t.coefficient_body_2),
        ("traction", t.force),
        ("friction power", t.friction_power),
        ("largest shear stress", t.shear_stress_maximum),
    ];
    let across = t.across.iter().flat_map(|t| {
        [
            t.coefficient,
            t.coefficient_body_1,
            t.coefficient_body_2,
            t.force,
        ]
    });
    estimates.extend(across.chain(t.moment).map(|e| ("traction across", e)));
    let shares = [t.beyond_first_limit, t.beyond_second_limit];
    estimates.extend(shares.into_iter().flatten().map(|e| ("thinned share", e)));
    if let Some(r) = solution.film_reduction {
        estimates.extend([r.central, r.minimum].map(|e| ("film reduction", e)));
    }
    let mut located = vec![
        ("place of the minimum film thickness", &s.film_minimum_at),
        (
            "minimum film thickness on the centreline",
            &s.film_centreline_minimum,
        ),
        ("largest pressure", &s.pressure_maximum),
        ("smooth pressure maximum", &s.pressure_central),
    ];
    located.extend((s.pressure_ridge.as_ref()).map(|ridge| ("pressure of the ridge", ridge)));
    if let Some(s) = &solution.starvation {
        let found = [
            s.film_central_flooded,
            s.film_minimum_flooded,
            s.ratio_central,
            s.ratio_minimum,
            s.meniscus_position,
        ];
        estimates.extend(found.into_iter().flatten().map(|e| ("starvation", e)));
    }
    if let Some(mixed) = &solution.mixed {
        estimates.extend([mixed.lambda_minimum, mixed.lambda_central].map(|e| (ROUGHNESS, e)));
        if let Some(asperities) = &mixed.asperities {
            list.push((ROUGHNESS, asperities.asperity_pressure_maximum));
            list.push((ROUGHNESS, asperities.asperity_load_share_limit));
            let loads = [asperities.asperity_load, asperities.asperity_load_share];
            estimates.extend(loads.map(|e| (ROUGHNESS, e)));
        }
        if let Some(f) = mixed.friction() {
            let along = [f.friction_fluid, f.friction_asperities, f.friction_total];
            let all = along.into_iter().chain(f.across.into_iter().flatten());
            estimates.extend(all.map(|e| (ROUGHNESS, e)));
        }
    }
    if let Some(roller) = &solution.roller {
        located.push(("edge pressure", &roller.edge_pressure_left));
        located.push(("edge pressure", &roller.edge_pressure_right));
        estimates.push(("moment of the roller", roller.roller_moment));
        estimates.push(("position of the load", roller.load_position));
    }
    located.extend(s.spike.iter().map(|spike| ("pressure spike", spike)));
    if let Some(thermal) = &solution.thermal {
        let (temperatures, places) = heat(thermal);
        estimates.extend(temperatures.into_iter().map(|e| (HEAT, e)));
        located.extend(places.into_iter().map(|at| (HEAT, at)));
        let (b, c) = (&thermal.balance, &thermal.coupling);
        let others = [thermal.inlet_temperature, b.error, c.contraction, c.change];
        list.extend(others.map(|v| (HEAT, v)));
    }
    for (name, at) in located {
        estimates.push((name, at.estimate()));
        list.extend([at.x, at.y].map(|v| (name, v)));
        list.extend(at.place_error.map(|v| (name, v)));
    }
    for (name, e) in estimates {
        list.push((name, e.value));
        list.extend(e.error.map(|v| (name, v)));
    }
    for groups in std::iter::once(&solution.groups).chain(&solution.groups_asymptotic) {
        let values = [
            groups.load,
            groups.speed,
            groups.material,
            groups.moes_load,
            groups.moes_material,
        ];
        list.extend(values.map(|v| ("dimensionless group", v)));
    }
    let scales = &solution.scales;
    let values = [
        scales.length,
        scales.pressure,
        scales.film,
        scales.viscosity,
        scales.density,
        scales.lambda,
        scales.elastic_stress,
        scales.load,
    ];
    list.extend(values.map(|v| ("scale", v)));
    list.extend(solution.extents.map(|v| ("extent of the contact area", v)));
    for formula in &solution.formulas {
        list.extend(formula.central.map(|v| (formula.name, v)));
        list.extend(formula.minimum.map(|v| (formula.name, v)));
    }
    list.into_iter().map(|(n, v)| (n.to_owned(), v))
}

const ROUGHNESS: &str = "roughness";
const HEAT: &str = "temperatures and heat";

/// Figures of temperatures and heat, without places and with.
fn heat(thermal: &Thermal) -> (Vec<Estimate>, [&Located; 4]) {
    let b = &thermal.balance;
    let mut list = vec![
        thermal.film_mean,
        thermal.body_1_mean,
        thermal.body_2_mean,
        b.shear,
        b.compression,
        b.to_body_1,
        b.to_body_2,
        b.by_film,
    ];
    if let Some(r) = &thermal.reduction {
        list.extend([r.film_central, r.film_minimum, r.isothermal_traction]);
        list.extend(r.traction);
    }
    let located = [
        &thermal.film_maximum,
        &thermal.film_lowest,
        &thermal.body_1_maximum,
        &thermal.body_2_maximum,
    ];
    (list, located)
}

/// Whether all temperatures and profiles are finite.
fn heat_fields_are_finite(thermal: &Thermal) -> bool {
    let fields = [&thermal.centreline, &thermal.surface].map(FilmTemperatures::columns);
    let columns = fields.into_iter().flatten().map(|(_, values)| values);
    let profiles = (thermal.profiles.iter()).flat_map(|p| {
        [
            p.z.as_slice(),
            &p.temperature,
            &p.velocity_x,
            &p.velocity_y,
            &p.shear_rate,
            &p.viscosity,
        ]
    });
    let field =
        (thermal.field.iter()).flat_map(|f| [f.points.as_flattened(), f.temperature.as_slice()]);
    columns
        .chain(profiles)
        .chain(field)
        .flatten()
        .all(|v| v.is_finite())
}

fn effort(solution: &Solution) -> impl Iterator<Item = (String, f64)> {
    let history = solution.history.iter().flat_map(|r| {
        [
            r.penalty_share,
            r.residual,
            r.update,
            r.step,
            r.film_central,
            r.heat.map_or(0.0, |heat| heat.change),
            r.heat.map_or(0.0, |heat| heat.temperature_rise),
        ]
        .map(|v| {
            (
                format!("iteration {} of stage {}", r.iteration, r.level + 1),
                v,
            )
        })
    });
    let levels = solution.stats.levels.iter().enumerate().flat_map(|(i, l)| {
        let t = &l.seconds;
        [
            l.films()[0],
            l.films()[1],
            t.mesh,
            t.operator,
            t.assembly,
            t.factorisation,
            t.krylov,
            t.heat,
            t.other,
        ]
        .map(|v| (format!("statistics of stage {}", i + 1), v))
    });
    let wall = ("wall time".to_owned(), solution.stats.wall_seconds);
    history.chain(levels).chain([wall])
}

fn fields(solution: &Solution) -> Option<String> {
    let (line, surface) = (&solution.centreline, &solution.surface);
    let arrays = [
        ("x along the centreline", &line.x),
        ("pressure along the centreline", &line.pressure),
        ("film thickness along the centreline", &line.film_thickness),
        ("deflection along the centreline", &line.deflection),
        ("viscosity along the centreline", &line.viscosity),
        ("density along the centreline", &line.density),
        ("Hertz pressure along the centreline", &line.hertz_pressure),
        ("pressure on the contact area", &surface.pressure),
        (
            "film thickness on the contact area",
            &surface.film_thickness,
        ),
        ("deflection on the contact area", &surface.deflection),
        ("viscosity on the contact area", &surface.viscosity),
        ("density on the contact area", &surface.density),
    ]
    .map(|(name, values)| (name, values.as_slice()));
    let shear = [&line.shear, &surface.shear].map(ShearFields::columns);
    let scalar = arrays
        .into_iter()
        .chain((shear.into_iter().flatten()).map(|(field, values)| (field.column(), values)))
        .find(|(_, values)| values.iter().any(|v| !v.is_finite()))
        .map(|(name, _)| name.to_owned());
    let elements = &solution.elements;
    let temperatures = elements.temperatures.iter().flat_map(|t| t.all());
    let elements_ok = [&elements.pressure, &elements.film_thickness]
        .into_iter()
        .chain(temperatures)
        .flat_map(|field| &field.values)
        .chain(elements.vertices.as_flattened())
        .all(|v| v.is_finite());
    let points_ok = surface.points.as_flattened().iter().all(|v| v.is_finite());
    let heat_ok = solution.thermal.as_ref().is_none_or(heat_fields_are_finite);
    let body_ok = solution.body.as_ref().is_none_or(|b| {
        let values = b
            .points
            .as_flattened()
            .iter()
            .chain(b.displacement.as_flattened());
        values.into_iter().all(|v| v.is_finite())
    });
    scalar
        .or_else(|| (!elements_ok).then(|| "fields of the pictures".to_owned()))
        .or_else(|| (!points_ok).then(|| "points of the contact area".to_owned()))
        .or_else(|| (!heat_ok).then(|| "temperatures of film and bodies".to_owned()))
        .or_else(|| (!body_ok).then(|| "displacement of the body".to_owned()))
}
