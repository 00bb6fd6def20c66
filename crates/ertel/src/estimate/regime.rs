//! Lubrication regime by Moes' asymptotes.

use serde::Serialize;

use crate::contact::{Contact, Family, Groups};
use crate::reference::{Asymptotes, moes_line_asymptotes, nijenbanning_venner_moes_asymptotes};

/// Lubrication regime.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regime {
    /// Constant viscosity, rigid bodies.
    IsoviscousRigid,
    /// Constant viscosity, elastic bodies ("soft EHL").
    IsoviscousElastic,
    /// Viscosity grows with pressure, rigid bodies.
    PiezoviscousRigid,
    /// Viscosity grows with pressure, elastic bodies ("hard EHL").
    PiezoviscousElastic,
}

impl Regime {
    /// For reports.
    pub fn name(self) -> &'static str {
        match self {
            Regime::IsoviscousRigid => "isoviscous-rigid",
            Regime::IsoviscousElastic => "isoviscous-elastic",
            Regime::PiezoviscousRigid => "piezoviscous-rigid",
            Regime::PiezoviscousElastic => "piezoviscous-elastic",
        }
    }
}

/// Ratio of two asymptotes from which the regime counts as shared.
const SHARED: f64 = 0.8;

/// A regime with the films that decide it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RegimeEstimate {
    /// The regime.
    pub regime: Regime,
    /// The regime that is nearly as near: its asymptote is within 20 %.
    pub neighbour: Option<Regime>,
    /// Central film of each asymptote, m.
    pub films: Asymptotes,
}

/// The regime of a contact of radius R, m.
///
/// A film formula over all regimes blends four asymptotes, h = max(max(IR, IE), min(PR, PE)) with I and P for isoviscous
/// and piezoviscous, R and E for rigid and elastic. Asymptotes of Nijenbanning, Venner and Moes 1994
/// (circular) and Moes (line). A lubricant that thins with pressure (L < 0) counts as isoviscous.
pub fn regime(contact: &Contact, groups: &Groups) -> RegimeEstimate {
    let (m, l) = (groups.moes_load, groups.moes_material.max(0.0));
    let [radius, across] = contact.radii_along_and_across();
    let a = match contact.kind.family() {
        Family::Point => nijenbanning_venner_moes_asymptotes(m, l, radius / across),
        Family::Cylinder => moes_line_asymptotes(m, l),
    };
    let rigid = (a.isoviscous_rigid, Regime::IsoviscousRigid);
    let elastic = (a.isoviscous_elastic, Regime::IsoviscousElastic);
    let (isoviscous, isoviscous_other) = order(rigid, elastic);
    let rigid = (a.piezoviscous_rigid, Regime::PiezoviscousRigid);
    let elastic = (a.piezoviscous_elastic, Regime::PiezoviscousElastic);
    let (piezoviscous_other, piezoviscous) = order(rigid, elastic);
    let (holds, across) = order(isoviscous, piezoviscous);
    let same_viscosity = if holds == isoviscous {
        isoviscous_other
    } else {
        piezoviscous_other
    };
    let closeness = |other: (f64, Regime)| f64::min(other.0 / holds.0, holds.0 / other.0);
    let near = if closeness(same_viscosity) > closeness(across) {
        same_viscosity
    } else {
        across
    };
    let scale = radius * (2.0 * groups.speed).sqrt();
    RegimeEstimate {
        regime: holds.1,
        neighbour: (closeness(near) > SHARED).then_some(near.1),
        films: a.map(|film| scale * film),
    }
}

/// The thicker film first.
fn order(a: (f64, Regime), b: (f64, Regime)) -> ((f64, Regime), (f64, Regime)) {
    if a.0 >= b.0 { (a, b) } else { (b, a) }
}
