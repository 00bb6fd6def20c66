//! The summary report.

use std::path::Path;

use super::figure::{BODIES, estimate, number, percent, percent_or_power, power};
use super::lines::{Lines, NAME_WIDTH, Table, VALUE_WIDTH, two_columns};
use super::results::write_section;
use super::{heat, inputs, mixed, stress, surfaces, wear};
use crate::case::CaseEcho;
use crate::contact::roller::Profile;
use crate::contact::{Contact, ContactKind, Groups, Hertz, Supply};
use crate::params::Method;
use crate::plausible::neglected::words;
use crate::solution::{Balance, Estimate, Figure, FormulaFilm, Section, Solution, Timings};
use crate::words::{CELSIUS, digits, force, length, pressure};

/// The report as text: the case in SI, Hertz contact, groups, results compared with published formulas,
/// effort, warnings and, where given, the folder of the files.
pub fn report(case: &CaseEcho, solution: &Solution, folder: Option<&Path>) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    write_case(&mut out, case);
    write_contact(
        &mut out,
        (&case.contact, &solution.hertz),
        solution.reduced_modulus,
        &solution.groups,
        solution.groups_asymptotic.as_ref(),
    );
    write_results(&mut out, solution);
    if let Some(thermal) = &solution.thermal {
        heat::write_results(&mut out, solution, thermal);
    }
    stress::write_results(&mut out, solution);
    wear::write_results(&mut out, solution);
    write_checks(&mut out, solution);
    inputs::write(&mut out, solution);
    write_formulas(&mut out, solution);
    write_effort(&mut out, solution);
    out.warnings(&solution.warnings);
    if let Some(folder) = folder {
        out.heading("Files");
        out.line(&folder.display().to_string());
    }
    out.text()
}

pub(super) fn write_case(out: &mut Lines, case: &CaseEcho) {
    let shape = match case.contact.kind {
        ContactKind::Circular => "circular (ball on plane)",
        ContactKind::Elliptical => "elliptical",
        ContactKind::Line => "line (cylinder on plane)",
        ContactKind::Roller => "roller of finite length (on plane)",
    };
    if let Some(machine) = &case.machine {
        out.heading("From the machine");
        for (name, value) in &machine.rows {
            out.row(name, value);
        }
    }
    out.heading("Case");
    out.row("contact", shape);
    match case.contact.kind {
        ContactKind::Elliptical => {
            out.row("radius R_x", length(case.contact.radius));
            out.row("radius R_y", length(case.contact.radius_y));
            let angle = case.contact.entrainment_angle.to_degrees();
            out.row(
                "angle of entrainment to x",
                format!("{} deg", digits(angle, 6)),
            );
        }
        ContactKind::Circular | ContactKind::Line | ContactKind::Roller => {
            out.row("radius R", length(case.contact.radius));
        }
    }
    let is_line = case.contact.kind.is_line();
    out.row("load", force(case.contact.load, is_line, 6));
    if let Some(roller) = &case.contact.roller {
        out.row("length l", length(roller.length));
        out.row("profile", roller.profile.name());
        let [left, right] = [-0.5, 0.5].map(|share| {
            let [drop, _] = roller.profile.drop(roller.length, share * roller.length);
            length(drop)
        });
        match roller.profile.is_symmetric() {
            true => out.row("  drop at the ends", left),
            false => out.row("  drop at y < 0, at y > 0", format!("{left}, {right}")),
        }
        let tilt = digits(1e3 * roller.misalignment, 6);
        out.row("misalignment θ", format!("{tilt} mrad"));
        let per_length = force(case.contact.line_load(), true, 6);
        out.row("load per length F/l", per_length);
    }
    for (role, body) in BODIES.into_iter().zip([&case.body_1, &case.body_2]) {
        let e = &body.elasticity;
        let text = format!(
            "{}, E {}, ν {}",
            body.name,
            pressure(e.youngs_modulus),
            digits(e.poissons_ratio, 4)
        );
        out.row(role, text);
        for layer in &body.layers {
            let e = &layer.elasticity;
            let text = format!(
                "{}, {} thick, E {}, ν {}",
                layer.name,
                length(layer.thickness),
                pressure(e.youngs_modulus),
                digits(e.poissons_ratio, 4)
            );
            out.row("  layer", text);
        }
    }
    if let Some(sigma) = case.roughness {
        out.row("composite roughness σ (rms)", length(sigma));
        for rule in &case.roughness_rules {
            out.line(rule);
        }
    }
    if let Some(asperities) = &case.asperities {
        out.row("asperities", mixed::describe(asperities));
    }
    surfaces::write(out, &case.surfaces);
    let motion = &case.motion;
    out.row(
        "entrainment speed u_m",
        format!("{} m/s", digits(motion.entrainment_speed, 6)),
    );
    out.row("slide-to-roll ratio", digits(motion.slide_to_roll_ratio, 6));
    if motion.slide_to_roll_ratio_across != 0.0 {
        let ratio = digits(motion.slide_to_roll_ratio_across, 6);
        out.row("  across the entrainment", ratio);
    }
    if motion.spin != [0.0; 2] {
        let [one, two] = motion.spin.map(|w| digits(w, 6));
        let text = format!("{} {one} rad/s, {} {two} rad/s", BODIES[0], BODIES[1]);
        out.row("spin about the contact normal", text);
    }
    out.row(
        "surface speeds",
        format!(
            "{} {} m/s, {} {} m/s",
            BODIES[0],
            digits(motion.body_1_speed(), 6),
            BODIES[1],
            digits(motion.body_2_speed(), 6)
        ),
    );
    match case.supply {
        Supply::Flooded => {}
        Supply::OilLayer { thickness } => out.row("oil layer on both surfaces", length(thickness)),
        Supply::Meniscus { distance } => {
            out.row("meniscus upstream of the centre", length(distance));
        }
    }
    let fluid = &case.fluid;
    out.row(
        "lubricant",
        format!(
            "{}: viscosity {}, density {}",
            fluid.name, fluid.viscosity_law, fluid.density_law
        ),
    );
    if let Some(law) = &fluid.shear_thinning {
        let left_out = if case.solver.newtonian {
            " (neglected: solver.newtonian)"
        } else {
            ""
        };
        out.row("shear thinning", format!("{law}{left_out}"));
    }
    let temperature = |kelvin: f64| {
        let celsius = digits(kelvin - CELSIUS, 5);
        format!("{celsius} °C ({} K)", digits(kelvin, 6))
    };
    match case.supply_temperature {
        None => out.row("temperature", temperature(case.temperature)),
        Some(supplied) => {
            out.row("temperature of the oil", temperature(supplied));
            let of_teeth = temperature(case.temperature) + ", that of the teeth";
            out.row("temperature of the films", of_teeth);
        }
    }
    out.row("ambient viscosity", viscosity(fluid.viscosity));
    out.row(
        "ambient density",
        format!("{} kg/m³", digits(fluid.density, 5)),
    );
    let coefficient = |alpha: f64| format!("{} 1/GPa", digits(1e9 * alpha, 4));
    out.row(
        "pressure-viscosity coefficient",
        coefficient(fluid.pressure_viscosity),
    );
    if let Some(alpha) = fluid.pressure_viscosity_asymptotic {
        out.row("  asymptotic, α*", coefficient(alpha));
    }
    for estimate in &fluid.estimates {
        let range = estimate.note.split(": ").next().unwrap_or_default();
        let unit = if estimate.unit == "1" {
            ""
        } else {
            &estimate.unit
        };
        let value = format!("{} {unit}", estimate.value);
        out.row(
            &estimate_in_words(&estimate.key),
            format!("{} ({range})", value.trim_end()),
        );
    }
    if let Some(thermal) = &case.thermal {
        heat::write(out, thermal);
    }
}

/// Description of an estimated key; in a blend, with the name of the component.
fn estimate_in_words(key: &str) -> String {
    let words = match key {
        "density.beta" => "thermal expansion β",
        "pressure_viscosity_coefficient" => "pressure-viscosity coefficient",
        "thermal_conductivity.k_0" => "thermal conductivity",
        "heat_capacity.rho_c_0" => "volumetric heat capacity",
        "shear_thinning.tau_0" => "Eyring stress τ_0",
        "shear_thinning.limit.lambda" => "limiting stress over pressure Λ",
        _ => {
            return match key.split_once('.') {
                Some((part, key)) if part != "blend" && key.starts_with("pressure_viscosity") => {
                    format!("pressure-viscosity coefficient, {part}")
                }
                _ => key.replace('_', " "),
            };
        }
    };
    words.to_owned()
}

/// The dry contact and its groups; `groups_asymptotic` are those with α*, the modulus in Pa.
pub(super) fn write_contact(
    out: &mut Lines,
    (contact, hertz): (&Contact, &Hertz),
    reduced_modulus: f64,
    g: &Groups,
    groups_asymptotic: Option<&Groups>,
) {
    out.heading("Dry contact (Hertz)");
    write_hertz(out, contact, hertz, reduced_modulus);
    out.row("reduced modulus E'", pressure(reduced_modulus));
    out.heading("Dimensionless groups");
    out.row("Moes", moes(g));
    if let Some(groups) = groups_asymptotic {
        out.row("  with α*", moes(groups));
    }
    out.row(
        "Hamrock-Dowson",
        format!(
            "W {}   U {}   G {}",
            power(g.load),
            power(g.speed),
            digits(g.material, 4)
        ),
    );
}

/// Size and pressure of the dry contact: for a roller, of a line under the mean load per length, and of its crown.
pub(super) fn write_hertz(out: &mut Lines, contact: &Contact, hertz: &Hertz, reduced_modulus: f64) {
    let of_line = match &contact.roller {
        Some(_) => ", mean load per length",
        None => "",
    };
    let row = |name: &str| format!("{name}{of_line}");
    out.row(&row("half-width a"), length(hertz.half_width));
    out.row(&row("largest pressure p_h"), pressure(hertz.pressure));
    let Some(roller) = &contact.roller else {
        return;
    };
    let Profile::Crown { crown_radius } = roller.profile else {
        return;
    };
    let ellipse = Contact::elliptical([contact.radius, crown_radius], contact.load, 0.0);
    let ellipse = Hertz::new(&ellipse, reduced_modulus);
    // Only if the contact of the crown is shorter than the roller.
    let ends_before = (ellipse.half_width_y).is_some_and(|b| 2.0 * b < roller.length);
    if ends_before && roller.misalignment == 0.0 {
        let text = format!(
            "{}, {} long",
            pressure(ellipse.pressure),
            length(2.0 * ellipse.half_width_y.unwrap_or_default())
        );
        out.row("largest pressure of the crown, an ellipse", text);
    }
}

fn moes(groups: &Groups) -> String {
    format!(
        "M {}   L {}",
        digits(groups.moes_load, 4),
        digits(groups.moes_material, 4)
    )
}

pub(super) fn write_results(out: &mut Lines, solution: &Solution) {
    out.heading("Results");
    write_section(out, solution, Section::Film);
    mixed::write_lambda(out, solution);
    write_section(out, solution, Section::Pressure);
    write_starvation(out, solution);
    write_section(out, solution, Section::Roller);
    if let Some(r) = &solution.film_reduction {
        out.row(
            "film reduction by shear thinning",
            format!("h_c {}, h_min {}", percent(r.central), percent(r.minimum)),
        );
    }
    write_section(out, solution, Section::Traction);
    write_integration_limits(out, solution);
    write_section(out, solution, Section::Shear);
    mixed::write_asperities(out, solution);
    out.row("neglected by the model", words(&solution.left_out));
}

/// Balance errors of the solution.
fn write_checks(out: &mut Lines, solution: &Solution) {
    let (c, is_point) = (&solution.checks, !solution.shape.is_line());
    let unit = if is_point { "W" } else { "W/m" };
    out.heading("Checks of the solution (separate from the error bars)");
    let balance = |b: &Balance, what: &str| {
        two_columns(
            &percent_or_power(b.error),
            &format!("{} {what} {}", digits(b.value, 4), digits(b.other, 4)),
        )
    };
    let becomes = match solution.thermal {
        None => format!("{unit} of the surfaces, dissipated"),
        Some(_) => format!("{unit} of the surfaces, heat of shear and compression"),
    };
    out.row("power balance error", balance(&c.power, &becomes));
    out.row(
        "rolling resistance balance error",
        balance(&c.rolling, "from wall shear, from the load offset"),
    );
    out.row("load balance error", percent_or_power(c.load));
    out.row("mass balance error", percent_or_power(c.mass));
    if let Some(heat) = c.heat {
        out.row("heat balance error", percent_or_power(heat));
    }
}

fn write_starvation(out: &mut Lines, solution: &Solution) {
    let Some(s) = &solution.starvation else {
        return;
    };
    let ratio = |ratio: Option<Estimate>| ratio.map_or("not known".to_owned(), number);
    let of =
        |film: Option<Estimate>| film.map_or(String::new(), |h| format!("of {}", estimate(&h)));
    out.row(
        "h_c over the flooded film",
        two_columns(&ratio(s.ratio_central), &of(s.film_central_flooded)),
    );
    out.row(
        "h_min over the flooded film",
        two_columns(&ratio(s.ratio_minimum), &of(s.film_minimum_flooded)),
    );
    match s.meniscus_position {
        Some(_) => write_section(out, solution, Section::Supply),
        None => out.row(
            Figure::MeniscusPosition.words(),
            "inlet edge of the contact area",
        ),
    }
}

/// The extent over which traction, moment and friction power are integrated, if it ends with the bodies.
fn write_integration_limits(out: &mut Lines, solution: &Solution) {
    let summed = &solution.summed_to;
    if summed.ends_with_bodies {
        let ends = match summed.body_end_y {
            Some(y) if y != summed.body_end_x => {
                format!("x ±{}, y ±{}", length(summed.body_end_x), length(y))
            }
            Some(_) => format!("{} from the centre", length(summed.body_end_x)),
            None => format!("x ±{}", length(summed.body_end_x)),
        };
        out.row(
            "  integrated up to",
            format!("{ends}, the edge of the bodies"),
        );
    }
}

pub(super) fn write_formulas(out: &mut Lines, solution: &Solution) {
    if solution.formulas.is_empty() {
        return;
    }
    let s = &solution.summary;
    // The distance of the mean planes of rough surfaces may vanish.
    let gaps = [Figure::MeanGapCentral, Figure::MeanGapMinimum].map(|gap| solution.figure(gap));
    let films = [s.film_central, s.film_minimum];
    let films = [0, 1].map(|i: usize| gaps[i].as_ref().map_or(films[i].value, |gap| gap.value));
    let cell = |formula: Option<f64>, film: f64| match formula {
        Some(h) => format!("{} ({:+.1} %)", length(h), 100.0 * (h / film - 1.0)),
        None => "–".to_owned(),
    };
    let contacts = match (&gaps[0], &solution.starvation) {
        (Some(_), _) => " of smooth surfaces",
        (None, Some(_)) => " of flooded contacts",
        (None, None) => "",
    };
    let computed = if gaps[0].is_some() {
        "mean gap"
    } else {
        "film"
    };
    out.heading(&format!(
        "Published formulas{contacts} (difference from the computed {computed})"
    ));
    let row = |f: &FormulaFilm| {
        vec![
            f.name.to_owned(),
            cell(f.central, films[0]),
            cell(f.minimum, films[1]),
        ]
    };
    out.table(Table {
        head: ["", "central", "minimum"].map(str::to_owned).to_vec(),
        rows: solution.formulas.iter().map(row).collect(),
        widths: vec![(NAME_WIDTH, 0), (VALUE_WIDTH, 2), (0, 0)],
    });
    for f in &solution.formulas {
        out.note(f.source);
    }
}

pub(super) fn write_effort(out: &mut Lines, solution: &Solution) {
    out.heading("Effort");
    out.row("method", solution.stats.method.words());
    let part = match solution.stats.method {
        Method::FiniteElements => "stage",
        Method::FiniteVolumes => "grid",
    };
    for (i, level) in solution.stats.levels.iter().enumerate() {
        out.row(
            &format!("{part} {}", i + 1),
            format!(
                "{} pressure{} unknowns, {} Newton iterations, h_c {}",
                level.n_pressure_dofs,
                // A half-space has none.
                match level.n_displacement_dofs {
                    0 => String::new(),
                    n => format!(" and {n} displacement"),
                },
                level.newton_iterations,
                length(level.films()[0])
            ),
        );
    }
    let levels = &solution.stats.levels;
    let seconds = |part: fn(&Timings) -> f64| levels.iter().map(|l| part(&l.seconds)).sum::<f64>();
    let wall = solution.stats.wall_seconds;
    let mut parts = vec![
        ("mesh", seconds(|t| t.mesh)),
        ("elastic operator", seconds(|t| t.operator)),
        ("assembly", seconds(|t| t.assembly)),
        ("preconditioner", seconds(|t| t.factorisation)),
        ("Krylov", seconds(|t| t.krylov)),
    ];
    if solution.thermal.is_some() {
        parts.push(("temperatures", seconds(|t| t.heat)));
    }
    parts.push(("other", wall - seconds(Timings::known)));
    let parts: Vec<String> = (parts.into_iter())
        .map(|(name, s)| format!("{name} {s:.2}"))
        .collect();
    out.row(
        "wall time",
        format!("{} s: {}", digits(wall, 3), parts.join(", ")),
    );
    if let Some(bytes) = solution.stats.peak_memory {
        out.row(
            "peak memory",
            format!("{} MB", digits(bytes as f64 / 1e6, 3)),
        );
    }
}

fn viscosity(value: f64) -> String {
    if value < 1.0 {
        format!("{} mPa·s", digits(1e3 * value, 4))
    } else {
        format!("{} Pa·s", digits(value, 4))
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use crate::warning::{Warning, WarningKind};

    #[test]
    fn viscosities_are_readable() {
        assert_eq!(viscosity(0.04), "40 mPa·s");
        assert_eq!(viscosity(4.0), "4 Pa·s");
    }

    /// Known figures: a and p_h from Hertz's formulas for glass on steel, speeds 0.5 (1 ± 0.05), the groups by hand,
    /// and 264.1/245 − 1 = 7.8 %.
    #[test]
    fn report_holds_the_case_and_the_results() {
        let (case, mut solution) = sample::circle().clone();
        sample::set(&mut solution, Figure::FilmCentral, 245e-9, 0.8e-9);
        solution.formulas[0].central = Some(264.1e-9);
        solution.warnings = vec![Warning::new(
            WarningKind::PressureRange,
            "the pressure leaves the range",
        )];
        let text = report(&case, &solution, Some(Path::new("results/ball")));
        for expected in [
            "body 1 0.475 m/s, body 2 0.525 m/s",
            "84.6 µm",
            "333.6 MPa",
            "M 29.8   L 6.497",
            "245.0 ± 0.8 nm",
            "264.1 nm (+7.8 %)",
            "! the pressure leaves",
            "results/ball",
        ] {
            assert!(text.contains(expected), "{expected} is missing in\n{text}");
        }
    }
}
