//! Inputs of a rating life other than loads and speeds: ratings, cleanliness, reliability, and how the oil comes to the bearing.

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::bearing::life::{Cleanliness, GuideCleanliness};
use ertel_quantity::Dimension;

/// Ratings, N.
const RATING: Bounds = Bounds::open(0.0, 1e9);
/// Thermal resistances, K/W.
const RESISTANCE: Bounds = Bounds::closed(1e-6, 1e6);
/// Temperatures of the surroundings, K.
const TEMPERATURE: Bounds = Bounds::closed(100.0, 1000.0);

/// How clean the lubricant is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contamination {
    /// e_C itself.
    Factor(f64),
    /// A class of cleanliness of a grease.
    Grease(Cleanliness),
    /// A class of cleanliness of any lubricant, by the middle of its guide values.
    Guide(GuideCleanliness),
}

/// Input for ratings, cleanliness and heat.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LifeInputs {
    /// C, N, instead of the computed one.
    pub dynamic_rating: Option<f64>,
    /// C_0, N, likewise.
    pub static_rating: Option<f64>,
    /// C_u, N, likewise.
    pub fatigue_limit: Option<f64>,
    /// Contamination; without it the modified life is omitted.
    pub contamination: Option<Contamination>,
    /// Reliability, per cent; 90 where absent.
    pub reliability: Option<f64>,
    /// Whether the lubricant has effective extreme-pressure additives.
    pub additives: bool,
    /// Whether it is a grease, for the models of friction.
    pub is_grease: bool,
    /// Thermal resistance from the bearing to its surroundings, K/W, and their temperature, K.
    pub cooling: Option<[f64; 2]>,
    /// Whether the contacts are solved at the temperature that their heat leads to, and not at that of the lubricant.
    pub heat_balance: bool,
}

/// Reads the keys.
pub(super) fn read(table: &mut Table<'_>) -> Result<LifeInputs, InputError> {
    let mut rating = |key: &str| table.optional_quantity(key, Dimension::FORCE, RATING);
    let [dynamic_rating, static_rating, fatigue_limit] = [
        rating("dynamic_load_rating")?,
        rating("static_load_rating")?,
        rating("fatigue_load_limit")?,
    ];
    let factor = table.optional_number("contamination_factor", Bounds::above_to(0.0, 1.0))?;
    let classes = [
        ("high", Cleanliness::High),
        ("normal", Cleanliness::Normal),
        ("typical-contamination", Cleanliness::Typical),
        ("severe-contamination", Cleanliness::Severe),
        ("very-severe-contamination", Cleanliness::VerySevere),
    ];
    let class = table.optional_choice("grease_cleanliness", &classes)?;
    let guides = [
        ("extreme", GuideCleanliness::Extreme),
        ("high", GuideCleanliness::High),
        ("normal", GuideCleanliness::Normal),
        ("slight-contamination", GuideCleanliness::Slight),
        ("typical-contamination", GuideCleanliness::Typical),
        ("severe-contamination", GuideCleanliness::Severe),
        ("very-severe-contamination", GuideCleanliness::VerySevere),
    ];
    let guide = table.optional_choice("cleanliness", &guides)?;
    let given = [
        factor.map(|f| ("contamination_factor", Contamination::Factor(f))),
        class.map(|class| ("grease_cleanliness", Contamination::Grease(class))),
        guide.map(|class| ("cleanliness", Contamination::Guide(class))),
    ];
    let mut given = given.into_iter().flatten();
    let contamination = given.next();
    if let (Some((first, _)), Some((second, _))) = (contamination, given.next()) {
        return Err(table.error(
            first,
            format!("`{first}` and `{second}` give the same quantity; keep one of them"),
        ));
    }
    let contamination = contamination.map(|(_, contamination)| contamination);
    let reliability = table.optional_number("reliability", Bounds::closed(90.0, 99.95))?;
    let additives = table.optional_bool("ep_additives")?.unwrap_or(false);
    let supplies = [("oil-bath", false), ("grease", true)];
    let is_grease = table
        .optional_choice("lubrication", &supplies)?
        .unwrap_or(class.is_some());
    let per_watt = Dimension::TEMPERATURE_DIFFERENCE.per(Dimension::POWER);
    let resistance = table.optional_quantity("thermal_resistance", per_watt, RESISTANCE)?;
    let cooling = match resistance {
        Some(resistance) => Some([
            resistance,
            table.required_quantity("ambient_temperature", Dimension::TEMPERATURE, TEMPERATURE)?,
        ]),
        None => None,
    };
    let heat_balance = table.optional_bool("heat_balance")?.unwrap_or(false);
    if heat_balance && cooling.is_none() {
        return Err(table.missing("thermal_resistance").with_help(
            "the temperature of a bearing in balance of heat needs `thermal_resistance` and `ambient_temperature`",
        ));
    }
    Ok(LifeInputs {
        dynamic_rating,
        static_rating,
        fatigue_limit,
        contamination,
        reliability,
        additives,
        is_grease,
        cooling,
        heat_balance,
    })
}
