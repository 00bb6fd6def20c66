//! Published film-thickness formulas, for comparison with the computed film.
//!
//! Every formula carries its source; the status of its constants is in docs/reference/command.md. The film is h = H R in metres;
//! groups follow [`Groups`].

pub mod biboulet_houpert;
mod chittenden;
mod dowson_higginson;
mod dowson_toyoda;
mod exponents;
mod hamrock_dowson;
mod moes_line;
mod nijenbanning_venner_moes;
pub mod thermal;
mod venner_isoviscous;

pub use chittenden::{chittenden_central, chittenden_minimum};
pub use dowson_higginson::{dowson_higginson_1966_line_minimum, dowson_higginson_line_minimum};
pub use dowson_toyoda::dowson_toyoda_line_central;
pub use exponents::{Asymptotes, ElasticExponents, Fraction};
pub use hamrock_dowson::{hamrock_dowson_central, hamrock_dowson_minimum};
pub use moes_line::{moes_line_asymptotes, moes_line_film};
pub use nijenbanning_venner_moes::{
    nijenbanning_venner_moes_asymptotes, nijenbanning_venner_moes_film,
};
pub use venner_isoviscous::venner_isoviscous_film;

use crate::contact::{Contact, ContactKind, Family, Groups};
use crate::solution::FormulaFilm;

impl ElasticExponents {
    /// Those of [`moes_line_asymptotes`] or
    /// [`nijenbanning_venner_moes_asymptotes`].
    pub fn of(family: Family) -> ElasticExponents {
        match family {
            Family::Point => nijenbanning_venner_moes::EXPONENTS,
            Family::Cylinder => moes_line::EXPONENTS,
        }
    }
}

impl Asymptotes {
    /// Each film converted by `to`.
    pub(crate) fn map(&self, to: impl Fn(f64) -> f64) -> Asymptotes {
        Asymptotes {
            isoviscous_rigid: to(self.isoviscous_rigid),
            isoviscous_elastic: to(self.isoviscous_elastic),
            piezoviscous_rigid: to(self.piezoviscous_rigid),
            piezoviscous_elastic: to(self.piezoviscous_elastic),
        }
    }
}

/// Largest material group L for which the isoviscous limit is listed.
const ISOVISCOUS_L: f64 = 1.0;

/// The closed family of formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmFormula {
    /// Hamrock and Dowson 1977, circles and wide ellipses, central and minimum film.
    HamrockDowson,
    /// Nijenbanning, Venner and Moes 1994, circles and ellipses, central film.
    NijenbanningVennerMoes,
    /// Isoviscous-elastic limit, circular, central film.
    VennerIsoviscous,
    /// Chittenden et al. 1985, ellipses with the motion at any angle, central and minimum film.
    Chittenden,
    /// Moes, line, central film.
    MoesLine,
    /// Dowson and Higginson 1977, line, minimum film.
    DowsonHigginson,
    /// Dowson and Higginson 1966, line, minimum film.
    DowsonHigginson1966,
    /// Dowson and Toyoda 1978, line, central film.
    DowsonToyoda,
}

impl FilmFormula {
    /// Every formula, in the order of the report.
    pub const ALL: [FilmFormula; 8] = [
        FilmFormula::HamrockDowson,
        FilmFormula::NijenbanningVennerMoes,
        FilmFormula::VennerIsoviscous,
        FilmFormula::Chittenden,
        FilmFormula::DowsonToyoda,
        FilmFormula::DowsonHigginson,
        FilmFormula::DowsonHigginson1966,
        FilmFormula::MoesLine,
    ];

    /// Whether the formula was made for a contact of this shape and direction of motion.
    pub fn applies(self, contact: &Contact) -> bool {
        let point = !contact.kind.is_cylinder();
        let along_an_axis = (2.0 * contact.entrainment_angle).sin().abs() < 1e-9;
        match self {
            // Fitted from circles to ellipses eight times as wide as long.
            FilmFormula::HamrockDowson => {
                let [along, across] = contact.radii_along_and_across();
                point && along_an_axis && across >= along * (1.0 - 1e-9)
            }
            FilmFormula::NijenbanningVennerMoes => point && along_an_axis,
            FilmFormula::VennerIsoviscous => contact.kind == ContactKind::Circular,
            FilmFormula::Chittenden => contact.has_two_radii(),
            FilmFormula::MoesLine
            | FilmFormula::DowsonHigginson
            | FilmFormula::DowsonHigginson1966
            | FilmFormula::DowsonToyoda => !point,
        }
    }

    /// Whether the films that the formula was fitted to are of an incompressible fluid. Those of a compressible one are thinner in the
    /// middle of the contact, where its mass fills less room, by the relative density at the Hertz pressure.
    pub fn is_incompressible(self) -> bool {
        match self {
            FilmFormula::NijenbanningVennerMoes
            | FilmFormula::VennerIsoviscous
            | FilmFormula::MoesLine => true,
            FilmFormula::HamrockDowson
            | FilmFormula::Chittenden
            | FilmFormula::DowsonHigginson
            | FilmFormula::DowsonHigginson1966
            | FilmFormula::DowsonToyoda => false,
        }
    }

    /// [`FilmFormula::film`] of a lubricant that has `relative_density` at the Hertz pressure, over that at ambient pressure.
    pub fn film_of_compressible(
        self,
        contact: &Contact,
        groups: &Groups,
        relative_density: f64,
    ) -> (Option<f64>, Option<f64>) {
        let (central, minimum) = self.film(contact, groups);
        match self.is_incompressible() {
            true => (central.map(|h| h / relative_density), minimum),
            false => (central, minimum),
        }
    }

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self {
            FilmFormula::HamrockDowson => "Hamrock-Dowson 1977",
            FilmFormula::NijenbanningVennerMoes => "Nijenbanning-Venner-Moes 1994",
            FilmFormula::VennerIsoviscous => "Venner isoviscous-elastic",
            FilmFormula::Chittenden => "Chittenden et al. 1985",
            FilmFormula::MoesLine => "Moes (line)",
            FilmFormula::DowsonHigginson => "Dowson-Higginson 1977",
            FilmFormula::DowsonHigginson1966 => "Dowson-Higginson 1966",
            FilmFormula::DowsonToyoda => "Dowson-Toyoda 1978",
        }
    }

    /// Source of the constants, and what the formula assumes.
    pub fn source(self) -> &'static str {
        match self {
            FilmFormula::HamrockDowson => hamrock_dowson::SOURCE,
            FilmFormula::NijenbanningVennerMoes => nijenbanning_venner_moes::SOURCE,
            FilmFormula::VennerIsoviscous => venner_isoviscous::SOURCE,
            FilmFormula::Chittenden => chittenden::SOURCE,
            FilmFormula::MoesLine => moes_line::SOURCE,
            FilmFormula::DowsonHigginson => dowson_higginson::SOURCE,
            FilmFormula::DowsonHigginson1966 => dowson_higginson::SOURCE_1966,
            FilmFormula::DowsonToyoda => dowson_toyoda::SOURCE,
        }
    }

    /// Central and minimum film in m, where the formula gives them.
    ///
    /// Outside its range (power laws in G of an isoviscous fluid, the isoviscous
    /// limit of a piezoviscous one) both are `None`.
    pub fn film(self, contact: &Contact, groups: &Groups) -> (Option<f64>, Option<f64>) {
        let [radius, across] = contact.radii_along_and_across();
        let ratio = radius / across;
        let (m, l) = (groups.moes_load, groups.moes_material);
        // h = H R √(2U) of the formulas in Moes' groups
        let moes_scale = radius * (2.0 * groups.speed).sqrt();
        let (central, minimum) = match self {
            FilmFormula::HamrockDowson => (
                Some(radius * hamrock_dowson_central(groups, contact.ellipticity())),
                Some(radius * hamrock_dowson_minimum(groups, contact.ellipticity())),
            ),
            FilmFormula::NijenbanningVennerMoes => (
                Some(moes_scale * nijenbanning_venner_moes_film(m, l, ratio)),
                None,
            ),
            FilmFormula::Chittenden => (
                Some(radius * chittenden_central(groups, ratio)),
                Some(radius * chittenden_minimum(groups, ratio)),
            ),
            FilmFormula::VennerIsoviscous if l <= ISOVISCOUS_L => {
                (Some(moes_scale * venner_isoviscous_film(m)), None)
            }
            FilmFormula::VennerIsoviscous => (None, None),
            FilmFormula::MoesLine => (Some(moes_scale * moes_line_film(m, l)), None),
            FilmFormula::DowsonHigginson => {
                (None, Some(radius * dowson_higginson_line_minimum(groups)))
            }
            FilmFormula::DowsonHigginson1966 => (
                None,
                Some(radius * dowson_higginson_1966_line_minimum(groups)),
            ),
            FilmFormula::DowsonToyoda => (Some(radius * dowson_toyoda_line_central(groups)), None),
        };
        let usable = |h: f64| h.is_finite() && h > 0.0;
        (
            central.filter(|h| usable(*h)),
            minimum.filter(|h| usable(*h)),
        )
    }
}

/// Every formula that applies to a contact, with films in m, those of incompressible fluids divided by the relative density at the Hertz
/// pressure.
pub fn film_formulas(
    contact: &Contact,
    groups: &Groups,
    relative_density: f64,
) -> Vec<FormulaFilm> {
    FilmFormula::ALL
        .into_iter()
        .filter(|formula| formula.applies(contact))
        .filter_map(|formula| {
            let (central, minimum) =
                formula.film_of_compressible(contact, groups, relative_density);
            (central.is_some() || minimum.is_some()).then(|| FormulaFilm {
                name: formula.name(),
                central,
                minimum,
                source: formula.source(),
            })
        })
        .collect()
}

#[cfg(test)]
mod tests;
