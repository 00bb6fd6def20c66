//! Asperities of `[surface_roughness]`: the law of their pressure, its numbers, and the gap that flows.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use crate::mixed::{Asperities, AsperityLaw, Flow, ORIENTATIONS, Persson, PressureTable, Summits};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, pressure};

/// σβη is a share of the surface: asperities of more than all of it were mistaken.
const GROUP: Bounds = Bounds::open(0.0, 1.0);
/// Asperities are far wider than high.
const HEIGHT_TO_RADIUS: Bounds = Bounds::open(0.0, 1.0);
/// Friction of bare metals in vacuum is larger, but without lubricant.
const BOUNDARY_FRICTION: (&str, Bounds) =
    ("boundary_friction_coefficient", Bounds::closed(0.0, 2.0));
/// From soft metals to diamond.
const HARDNESS: (&str, Bounds) = ("hardness", Bounds::closed(1e7, 2e11));
/// Distances of mean planes that overlap are negative.
const DISTANCE: Bounds = Bounds::closed(-1e-3, 1e-3);
/// Asperity pressures that count.
const PRESSURE: Bounds = Bounds::closed(1e-3, 1e12);

/// σβη and σ/β as usually quoted for engineering surfaces after Greenwood and Tripp (1970); quoted second-hand, and only to find errors
/// of the decimal point.
const USUAL_GROUP: [f64; 2] = [0.03, 0.07];
const USUAL_HEIGHT_TO_RADIUS: [f64; 2] = [1e-4, 1e-2];

/// Composite rms slope: numerical contacts and measured surfaces reach about 1.
const RMS_SLOPE: Bounds = Bounds::open(0.0, 10.0);
/// u_0/σ and β of Persson's law.
const DECAY: Bounds = Bounds::closed(0.05, 5.0);
const PRESSURE_FACTOR: Bounds = Bounds::open(0.0, 10.0);

const FLOW: &str = "flow";
const ORIENTATION: &str = "orientation";
const LAW: &str = "asperity_law";
const SUMMITS: [&str; 2] = ["asperity_group", "rms_height_to_asperity_radius"];
const PERSSON: [&str; 3] = ["rms_slope", "decay_length_to_rms_height", "pressure_factor"];
const TABLE: [&str; 2] = ["asperity_distances", "asperity_pressures"];

/// All keys of asperities.
pub(super) const KEYS: [&str; 12] = [
    LAW,
    SUMMITS[0],
    SUMMITS[1],
    PERSSON[0],
    PERSSON[1],
    PERSSON[2],
    TABLE[0],
    TABLE[1],
    HARDNESS.0,
    BOUNDARY_FRICTION.0,
    FLOW,
    ORIENTATION,
];

/// Laws of the asperity pressure, by their name.
#[derive(Clone, Copy, Default, PartialEq)]
enum LawName {
    #[default]
    GreenwoodTripp,
    GreenwoodWilliamson,
    Persson,
    Table,
}

const LAWS: [(&str, LawName); 4] = [
    ("greenwood-tripp", LawName::GreenwoodTripp),
    ("greenwood-williamson", LawName::GreenwoodWilliamson),
    ("persson", LawName::Persson),
    ("table", LawName::Table),
];

impl LawName {
    /// Keys of its numbers.
    fn keys(self) -> &'static [&'static str] {
        match self {
            LawName::GreenwoodTripp | LawName::GreenwoodWilliamson => &SUMMITS,
            LawName::Persson => &PERSSON,
            LawName::Table => &TABLE,
        }
    }
}

/// The key by which asperities are described.
pub(super) fn given_key(table: &mut Table<'_>) -> &'static str {
    let keys = [SUMMITS[0], LAW];
    let given = keys.into_iter().find(|key| table.contains(key));
    given.unwrap_or(SUMMITS[0])
}

/// Refuses numbers of another law than the chosen one.
fn refuse_other_numbers(table: &mut Table<'_>, chosen: LawName) -> Result<(), InputError> {
    for (name, law) in LAWS {
        let keys = law.keys().iter();
        let mut others = keys.filter(|key| !chosen.keys().contains(key));
        if let Some(other) = others.find(|key| table.contains(key)) {
            let problem = format!("`{other}` is not a number of this law of asperities");
            let help = format!("write `{LAW} = \"{name}\"`, or remove it");
            return Err(table.error(other, problem).with_help(help));
        }
    }
    Ok(())
}

/// The law of the asperity pressure with its numbers; `None` where the case describes no asperities.
fn law(table: &mut Table<'_>) -> Result<Option<AsperityLaw>, InputError> {
    let name = table.optional_choice(LAW, &LAWS)?;
    let chosen = name.unwrap_or_default();
    refuse_other_numbers(table, chosen)?;
    if name.is_none() && !chosen.keys().iter().any(|key| table.contains(key)) {
        return Ok(None);
    }
    let law = match chosen {
        LawName::GreenwoodTripp => AsperityLaw::GreenwoodTripp(summits(table)?),
        LawName::GreenwoodWilliamson => AsperityLaw::GreenwoodWilliamson(summits(table)?),
        LawName::Persson => AsperityLaw::Persson(persson(table)?),
        LawName::Table => AsperityLaw::Table(pressures(table)?),
    };
    Ok(Some(law))
}

fn summits(table: &mut Table<'_>) -> Result<Summits, InputError> {
    let [group, ratio] = SUMMITS;
    Ok(Summits {
        asperity_group: table.required_number(group, GROUP)?,
        rms_height_to_asperity_radius: table.required_number(ratio, HEIGHT_TO_RADIUS)?,
    })
}

fn persson(table: &mut Table<'_>) -> Result<Persson, InputError> {
    let [slope, decay, factor] = PERSSON;
    Ok(Persson::new(
        table.required_number(slope, RMS_SLOPE)?,
        table.optional_number(decay, DECAY)?,
        table.optional_number(factor, PRESSURE_FACTOR)?,
    ))
}

fn pressures(table: &mut Table<'_>) -> Result<PressureTable, InputError> {
    let [distances, pressures] = TABLE;
    let own = (
        table.required_quantities(distances, Dimension::LENGTH, DISTANCE)?,
        table.required_quantities(pressures, Dimension::PRESSURE, PRESSURE)?,
    );
    PressureTable::new(own.0, own.1).map_err(|problem| table.error(pressures, problem))
}

/// The asperities, if the case describes them.
pub(super) fn read(table: &mut Table<'_>) -> Result<Option<Asperities>, InputError> {
    let flow = table.optional_choice(FLOW, &Flow::ALL)?;
    let orientation = table.optional_choice(ORIENTATION, &ORIENTATIONS)?;
    if orientation.is_some() && flow != Some(Flow::PatirCheng) {
        return Err(table
            .error(
                ORIENTATION,
                "only flow factors depend on the orientation of the roughness",
            )
            .with_help(format!("write `{FLOW} = \"patir-cheng\"`, or remove it")));
    }
    let Some(law) = law(table)? else {
        let [group, ratio] = SUMMITS;
        for (key, problem) in [
            (
                BOUNDARY_FRICTION.0,
                "boundary friction is that of asperities, which are not described",
            ),
            (
                FLOW,
                "the gap that flows is that between asperities, which are not described",
            ),
            (
                HARDNESS.0,
                "the hardness limits the pressure of asperities, which are not described",
            ),
        ] {
            if table.contains(key) {
                return Err(table.error(key, problem).with_help(format!(
                    "`{group}` and `{ratio}` describe them, or another `{LAW}`"
                )));
            }
        }
        return Ok(None);
    };
    Ok(Some(Asperities {
        law,
        hardness: table.optional_quantity(HARDNESS.0, Dimension::PRESSURE, HARDNESS.1)?,
        boundary_friction_coefficient: table
            .optional_number(BOUNDARY_FRICTION.0, BOUNDARY_FRICTION.1)?,
        flow: flow.unwrap_or_default(),
        flow_is_chosen: flow.is_some(),
        orientation: (flow == Some(Flow::PatirCheng)).then(|| orientation.unwrap_or_default()),
    }))
}

/// Share of the Hertz pressure at the last distance of a table above which films lie beyond it.
const LEAST_PRESSURE: f64 = 1e-3;

/// Refuses a table of pressures that the contact leaves, and a hardness at which the bodies themselves yield; `hertz` is the largest pressure of the dry
/// contact, Pa.
pub(super) fn check_range(
    asperities: &Asperities,
    table: &Table<'_>,
    hertz: f64,
) -> Result<(), InputError> {
    if asperities.hardness.is_some_and(|hardness| hardness < hertz) {
        let contact = pressure(hertz);
        return Err(table
            .error(
                HARDNESS.0,
                format!("the contact presses with up to {contact}: at this hardness the bodies yield, not only their asperities"),
            )
            .with_help("give the hardness as a pressure, such as \"7 GPa\", or remove it"));
    }
    let AsperityLaw::Table(law) = &asperities.law else {
        return Ok(());
    };
    let [first, .., last] = law.asperity_pressures[..] else {
        return Ok(());
    };
    if first < hertz {
        let problem = format!(
            "the table ends at {}, but the contact presses with up to {}",
            pressure(first),
            pressure(hertz)
        );
        return Err(table.error(TABLE[1], problem).with_help(
            "continue it to smaller distances, below zero where the mean planes overlap, or choose another `asperity_law`",
        ));
    }
    if last > LEAST_PRESSURE * hertz {
        let problem = format!(
            "the last pressure of the table, {}, is {} % of that of the contact: thicker films lie beyond it",
            pressure(last),
            digits(100.0 * last / hertz, 2)
        );
        return Err(table.error(TABLE[1], problem).with_help(format!(
            "continue it to larger distances, down to {}, or choose another `{LAW}`",
            pressure(LEAST_PRESSURE * hertz)
        )));
    }
    Ok(())
}

/// Numbers that measured surfaces seldom have.
pub(super) fn warnings(asperities: &Asperities) -> Vec<Warning> {
    let (AsperityLaw::GreenwoodTripp(summits) | AsperityLaw::GreenwoodWilliamson(summits)) =
        &asperities.law
    else {
        return Vec::new();
    };
    let [group, ratio] = SUMMITS;
    let values = [
        (group, summits.asperity_group, USUAL_GROUP),
        (
            ratio,
            summits.rms_height_to_asperity_radius,
            USUAL_HEIGHT_TO_RADIUS,
        ),
    ];
    let outside =
        (values.into_iter()).filter(|(_, value, [low, high])| value < low || value > high);
    outside
        .map(|(key, value, [low, high])| {
            let text = format!(
                "{key} = {} is outside {low} to {high}, the range usually quoted for engineering surfaces",
                digits(value, 4)
            );
            Warning::beyond(WarningKind::AsperityData, (value / high).max(low / value), text)
        })
        .collect()
}
