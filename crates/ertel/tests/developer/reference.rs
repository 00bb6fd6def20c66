//! The tables of the reference pages are those of the keys.

use ertel::figures::{bearing, cam, element, gears, machine, path, turn};
use ertel::solution::Figure;
use ertel::warning::{Severity, WarningKind};
use ertel_input::keys::{self, Row, table, table_of_laws};
use ertel_rheology::data_sheet::{BaseOil, Estimate};

use super::pages::generated;

/// Rows before and from the one with this key.
fn split(rows: &'static [Row], key: &str) -> (&'static [Row], &'static [Row]) {
    let at = rows.iter().position(|row| row.keys.contains(&key));
    rows.split_at(at.unwrap_or_else(|| panic!("no row of {key}")))
}

/// The figures of the registry, their units in point and in line contacts.
#[test]
fn the_table_of_figures_is_the_registry() {
    let mut text = String::from("| name | figure | unit | place |\n|---|---|---|---|\n");
    for figure in Figure::ALL {
        let unit = match [false, true].map(|is_line| figure.unit(is_line)) {
            ["", _] => "–".to_owned(),
            [unit, of_line] if unit == of_line => unit.to_owned(),
            units => units.join(", "),
        };
        let place = if figure.has_place() { "yes" } else { "" };
        let title = figure.title();
        text.push_str(&format!(
            "| `{}` | {title} | {unit} | {place} |\n",
            figure.name()
        ));
    }
    generated("docs/reference/results.md", "figures", &text);
}

/// Every figure of a machine is in the table, and no other is; likewise those at each contact.
#[test]
fn the_tables_of_machines_have_every_figure() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(root.join("../../docs/reference/results.md")).unwrap();
    let of_machines = [machine::ALL, bearing::ALL, gears::ALL, cam::ALL].concat();
    let of_contacts = [path::ALL, element::ALL, turn::ALL].concat();
    for (heading, figures) in [
        ("### Figures of machines", of_machines),
        ("### Figures at each contact", of_contacts),
    ] {
        let names = figures.into_iter().map(|f| f.name.to_owned());
        let names: std::collections::BTreeSet<String> = names.collect();
        let (_, table) = page.split_once(heading).unwrap();
        let (table, _) = table.split_once("\n##").unwrap();
        let rows = table.lines().filter(|line| line.starts_with("| `"));
        let first = rows.filter_map(|row| row.split('|').nth(1));
        let listed: std::collections::BTreeSet<String> = first
            .flat_map(|cell| cell.split('`').skip(1).step_by(2).map(str::to_owned))
            .collect();
        assert!(names.len() > 20, "{names:?}");
        assert_eq!(listed, names);
    }
}

/// Estimated properties of each kind of base oil, with the range.
#[test]
fn the_tables_of_base_oils_are_those_of_the_source() {
    let number = |value: f64| format!("{}", (value * 1e4).round() / 1e4).replace('-', "−");
    let range = |e: Estimate| match [e.below, e.above].map(|share| number(100.0 * share)) {
        [below, above] if below == above => format!("± {below} %"),
        [below, above] => format!("−{below} to +{above} %"),
    };
    let scaled = |e: Estimate, unit: f64| format!("{} | {}", number(e.value / unit), range(e));
    let mut tables = [
        "| oil | `β`, 1/K | range | `k₀`, W/(m·K) | range | `(ρ c)₀`, MJ/(m³·K) | range | `τ₀`, MPa | range | `Λ` | range |\n".to_owned()
            + &"|---".repeat(11)
            + "|\n",
        "| oil | `T_R`, K | `d₁`, `d₂`, 1/GPa | `k₁`, `k₂`, 1/GPa | `β₀`, 1/K | `b₁`, 1/GPa; `b₂`, 1/GPa² |\n".to_owned()
            + &"|---".repeat(6)
            + "|\n",
    ];
    for oil in [BaseOil::Mineral, BaseOil::Pao, BaseOil::Ester, BaseOil::Pag] {
        let (name, heat, shear) = (oil.name(), oil.heat(), oil.shear());
        let expansion = oil.expansion();
        tables[0] += &format!(
            "| {name} | {:e} | {} | {} | {} | {} | {} |\n",
            expansion.value,
            range(expansion),
            scaled(heat.conductivity, 1.0),
            scaled(heat.volumetric_heat, 1e6),
            scaled(shear.eyring_stress, 1e6),
            scaled(shear.pressure_coefficient, 1.0),
        );
        let [d_1, d_2, k_1, k_2, b_1] =
            [heat.d_1, heat.d_2, heat.k_1, heat.k_2, heat.b_1].map(|value| number(value * 1e9));
        tables[1] += &format!(
            "| {name} | {} | {d_1}, {d_2} | {k_1}, {k_2} | {:e} | {b_1}; {} |\n",
            heat.reference_temperature,
            heat.beta_0,
            number(heat.b_2 * 1e18),
        );
    }
    generated("docs/theory/rheology.md", "base oils", &tables.join("\n"));
}

/// The page of warnings, and the codes of the schema, are the registry.
#[test]
fn the_page_of_warnings_is_the_registry() {
    let mut text = String::from("| code | meaning | limit | what to do |\n|---|---|---|---|\n");
    for kind in WarningKind::ALL {
        let mark = match kind.severity() {
            Severity::Note => " (note)",
            Severity::Caution => "",
            Severity::Unusable => " (!)",
        };
        let e = kind.explanation();
        text.push_str(&format!(
            "| `{kind}`{mark} | {} | {} | {} |\n",
            e.meaning, e.limit, e.remedy
        ));
    }
    generated("docs/reference/warnings.md", "warnings", &text);
    let all = WarningKind::ALL
        .iter()
        .filter(|kind| kind.may_be_silenced());
    let codes: Vec<&str> = all.map(|kind| kind.code()).collect();
    assert_eq!(keys::CODES, codes);
}

#[test]
fn tables_of_the_reference_are_those_of_the_keys() {
    let (contact, rollers) = split(keys::CONTACT, "length");
    let (lubricant, sheet) = split(keys::LUBRICANT, "kinematic_viscosity_40");
    let page = "docs/reference/case-file.md";
    for (name, rows) in [
        ("sections", keys::CASE),
        ("contact", contact),
        ("rollers", rollers),
        ("surface_roughness", keys::ROUGHNESS),
        ("motion", keys::MOTION),
        ("inlet", keys::INLET),
        ("lubricant", lubricant),
        ("thermal", keys::THERMAL),
        ("stress", keys::STRESS),
        ("wear", keys::WEAR),
        ("hardness", keys::HARDNESS),
        ("residual_stress", keys::RESIDUAL_STRESS),
        ("layer", keys::LAYER),
        ("mesh", keys::MESH),
        ("solver", keys::SOLVER),
        ("output", keys::OUTPUT),
        ("interferogram", keys::INTERFEROGRAM),
        ("transient", keys::TRANSIENT),
        ("course", keys::COURSE),
        ("surface", keys::SURFACE),
        ("curve", keys::CURVE),
        ("compare", keys::COMPARE),
    ] {
        generated(page, name, &table(rows));
    }
    for (name, rows) in keys::MACHINES {
        generated(page, name, &table(rows));
    }
    let page = "docs/reference/lubricant-laws.md";
    for (name, laws) in [
        ("density", &keys::DENSITIES),
        ("viscosity", &keys::VISCOSITIES),
        ("shear_thinning", &keys::SHEAR_LAWS),
        ("thermal_conductivity", &keys::CONDUCTIVITIES),
        ("heat_capacity", &keys::HEAT_CAPACITIES),
    ] {
        generated(page, name, &table_of_laws(laws));
    }
    generated(page, "data sheet", &table(sheet));
    generated("docs/guide/studies.md", "axes", &table(keys::AXIS));
}
