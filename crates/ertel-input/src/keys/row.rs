//! Rows of the reference: keys, kind of the value, bounds and words.

use ertel_quantity::{Dimension as D, Dimension};

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

pub(super) const LENGTH: Kind = Kind::Quantity(&[D::LENGTH]);
pub(super) const SPEED: Kind = Kind::Quantity(&[D::SPEED]);
pub(super) const TIME: Kind = Kind::Quantity(&[D::TIME]);
pub(super) const ANGLE: Kind = Kind::Quantity(&[D::ANGLE]);
pub(super) const ROTATION: Kind = Kind::Quantity(&[D::ANGULAR_SPEED]);
pub(super) const FORCE: Kind = Kind::Quantity(&[D::FORCE]);
pub(super) const TEMPERATURE: Kind = Kind::Quantity(&[D::TEMPERATURE]);
pub(super) const PRESSURE: Kind = Kind::Quantity(&[D::PRESSURE]);
pub(super) const VISCOSITY: Kind = Kind::Quantity(&[D::VISCOSITY]);
pub(super) const KINEMATIC: Kind = Kind::Quantity(&[D::KINEMATIC_VISCOSITY]);
pub(super) const DENSITY: Kind = Kind::Quantity(&[D::DENSITY]);
pub(super) const PER_PRESSURE: Kind = Kind::Quantity(&[D::INVERSE_PRESSURE]);
pub(super) const PER_KELVIN: Kind = Kind::Quantity(&[D::INVERSE_TEMPERATURE]);
pub(super) const KELVIN: Kind = Kind::Quantity(&[D::TEMPERATURE_DIFFERENCE]);

pub(super) const fn first<T: Copy>(list: &[T]) -> Option<T> {
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
            bounds: $crate::keys::row::first(&[$($crate::Bounds::closed($low, $high))?]),
            default: $crate::keys::row::first(&[$($default)?]),
            usual: &[$($($usual),+)?],
            words: concat!($($words)? $($aside)?),
            is_listed: !concat!($($words)?).is_empty(),
        }),*];
    )*};
}
pub(super) use rows;
