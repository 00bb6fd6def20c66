//! The keys of cases and studies: kind, bounds, default, usual range and meaning of each value.
//!
//! The schema for editors, questions about unusual values, the form of the page in the browser and the tables of the reference pages are
//! generated from these rows. The readers do not use them: tests compare both.

mod case;
mod describe;
mod lubricant;
mod machine;
mod settings;
mod unknown;

use std::sync::LazyLock;

use ertel_quantity::{Dimension as D, Dimension};

pub use case::{
    AXIS, CASE, CONTACT, COURSE, CURVE, INLET, MOTION, ROUGHNESS, STUDY, SURFACE, TRANSIENT,
};
pub use describe::{plain, table, table_of_laws};
pub use lubricant::{
    CONDUCTIVITIES, DENSITIES, HEAT_CAPACITIES, LUBRICANT, SHEAR_LAWS, VISCOSITIES,
};
pub use machine::MACHINES;
pub use settings::{
    CODES, COMPARE, HARDNESS, INTERFEROGRAM, MESH, OUTPUT, SOLVER, STRESS, THERMAL,
};
pub use unknown::{unknown_first, unknown_path};

use crate::Bounds;
use crate::usual::Usual;

/// Keys of one table that mean the same, in the order of the reference.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The keys.
    pub keys: &'static [&'static str],
    /// Kind of the value.
    pub kind: Kind,
    /// Bounds of a number that are the same in every case.
    pub bounds: Option<Bounds>,
    /// Default, where that is the same in every case: a value of TOML, of a choice its word.
    pub default: Option<&'static str>,
    /// Usual range; for a key of several dimensions, one for each of them.
    pub usual: &'static [Usual],
    /// Meaning of the value, as Markdown; [`Row::description`] adds choices, bounds and default.
    pub words: &'static str,
    /// Whether the table of the reference has this row; the text around it describes the others.
    pub is_listed: bool,
}

/// Kinds of values.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A text.
    Text,
    /// `true` or `false`.
    Switch,
    /// An integer.
    Count,
    /// A number.
    Number,
    /// A number that is shown in per cent.
    Share,
    /// A list of numbers.
    Numbers,
    /// With a unit of one of these.
    Quantity(&'static [Dimension]),
    /// A list of such.
    Quantities(&'static [Dimension]),
    /// A length, or one of these words.
    QuantityOr(&'static [&'static str]),
    /// A list of pairs of numbers.
    Points,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// One of these words, in any case of letters, or one of their other names.
    AnyCase(&'static [&'static str]),
    /// A list of these words.
    Choices(&'static [&'static str]),
    /// A table.
    Table(&'static [Row]),
    /// A list of tables.
    Tables(&'static [Row]),
    /// A table with the key `law`.
    Law(&'static Laws),
    /// The same, or a constant of this dimension in its place.
    LawOr(&'static Laws, Dimension),
    /// The name of a fluid.
    Fluid,
    /// The same, or a table.
    FluidOrTable(&'static [Row]),
    /// The name of a solid.
    Solid,
    /// The same, or a table.
    SolidOrTable(&'static [Row]),
    /// A table with the key `kind`, which says which of the other keys it has.
    Machine(&'static [(&'static str, &'static [Row])]),
    /// A number, or a quantity of the key that it belongs to.
    Scalar,
    /// A table of texts whose keys are free.
    Texts,
    /// A list.
    List,
}

/// The laws of a property, and the keys of all of them.
#[derive(Debug)]
pub struct Laws {
    /// The laws.
    pub laws: &'static [Law],
    /// Their keys, without those of tables.
    pub keys: &'static [Row],
}

/// A law, its keys in backquotes.
#[derive(Debug)]
pub struct Law {
    /// Its name, the value of `law`.
    pub name: &'static str,
    /// Required keys.
    pub needs: &'static str,
    /// Optional keys.
    pub optional: &'static str,
}

impl Laws {
    /// The keys of all laws: their own, and those of tables.
    pub fn tables(&self) -> Vec<&'static [Row]> {
        let of_tables = self.laws.iter().find(|law| law.name == "table");
        let of_tables = of_tables.map(|_| lubricant::TABLE_KEYS);
        std::iter::once(self.keys).chain(of_tables).collect()
    }

    /// The keys of one of the laws.
    pub fn keys_of(&self, law: &Law) -> Vec<&'static str> {
        let words = |text: &'static str| text.split('`').skip(1).step_by(2);
        let is_key =
            |word: &&str| (self.tables().into_iter().flatten()).any(|row| row.keys.contains(word));
        (words(law.needs).chain(words(law.optional)))
            .filter(is_key)
            .collect()
    }
}

impl Kind {
    /// The rows of the tables of this kind, each table separately.
    pub fn tables(self) -> Vec<&'static [Row]> {
        match self {
            Self::Table(rows)
            | Self::Tables(rows)
            | Self::FluidOrTable(rows)
            | Self::SolidOrTable(rows) => vec![rows],
            Self::Law(laws) | Self::LawOr(laws, _) => laws.tables(),
            Self::Machine(machines) => machines.iter().map(|(_, rows)| *rows).collect(),
            _ => Vec::new(),
        }
    }
}

const LENGTH: Kind = Kind::Quantity(&[D::LENGTH]);
const SPEED: Kind = Kind::Quantity(&[D::SPEED]);
const TIME: Kind = Kind::Quantity(&[D::TIME]);
const ANGLE: Kind = Kind::Quantity(&[D::ANGLE]);
const ROTATION: Kind = Kind::Quantity(&[D::ANGULAR_SPEED]);
const FORCE: Kind = Kind::Quantity(&[D::FORCE]);
const TEMPERATURE: Kind = Kind::Quantity(&[D::TEMPERATURE]);
const PRESSURE: Kind = Kind::Quantity(&[D::PRESSURE]);
const VISCOSITY: Kind = Kind::Quantity(&[D::VISCOSITY]);
const KINEMATIC: Kind = Kind::Quantity(&[D::KINEMATIC_VISCOSITY]);
const DENSITY: Kind = Kind::Quantity(&[D::DENSITY]);
const PER_PRESSURE: Kind = Kind::Quantity(&[D::INVERSE_PRESSURE]);
const PER_KELVIN: Kind = Kind::Quantity(&[D::INVERSE_TEMPERATURE]);
const KELVIN: Kind = Kind::Quantity(&[D::TEMPERATURE_DIFFERENCE]);

fn collect(path: &str, rows: &'static [Row], found: &mut Vec<(String, &'static Row)>) {
    for row in rows {
        for key in row.keys {
            let path = match path {
                "" => (*key).to_owned(),
                path => format!("{path}.{key}"),
            };
            for table in row.kind.tables() {
                collect(&path, table, found);
            }
            found.push((path, row));
        }
    }
}

/// All keys of cases by their key paths.
pub fn all() -> &'static [(String, &'static Row)] {
    static ALL: LazyLock<Vec<(String, &Row)>> = LazyLock::new(|| {
        let mut found = Vec::new();
        collect("", CASE, &mut found);
        found
    });
    &ALL
}

/// The rows of a key path: of the path from the top of a case; else of those that end with it, as in files of own data.
pub fn rows_of(path: &str) -> Vec<&'static Row> {
    let of = |is_it: &dyn Fn(&str) -> bool| -> Vec<&'static Row> {
        let found = all().iter().filter(|(own, _)| is_it(own));
        found.map(|(_, row)| *row).collect()
    };
    let whole = of(&|own| own == path);
    if !whole.is_empty() {
        return whole;
    }
    of(&|own| {
        own.strip_suffix(path)
            .is_some_and(|head| head.ends_with('.'))
    })
}

const fn first<T: Copy>(list: &[T]) -> Option<T> {
    match list {
        [first, ..] => Some(*first),
        [] => None,
    }
}

/// Rows, each as `keys: kind, bounds [low, high], default value, usual [ranges] => words;` with absent parts omitted; with
/// `, aside words` instead of `=> words` the table of the reference omits the row.
macro_rules! rows {
    ($($(#[$doc:meta])* $vis:vis $name:ident {
        $($($key:ident),+: $kind:expr
            $(, bounds [$low:expr, $high:expr])? $(, default $default:literal)? $(, usual [$($usual:expr),+])?
            $(=> $words:literal)? $(, aside $aside:literal)?;)*
    })*) => {$(
        $(#[$doc])* $vis static $name: &[$crate::keys::Row] = &[$($crate::keys::Row {
            keys: &[$(stringify!($key)),+],
            kind: $kind,
            bounds: $crate::keys::first(&[$($crate::Bounds::closed($low, $high))?]),
            default: $crate::keys::first(&[$($default)?]),
            usual: &[$($($usual),+)?],
            words: concat!($($words)? $($aside)?),
            is_listed: !concat!($($words)?).is_empty(),
        }),*];
    )*};
}
use rows;
