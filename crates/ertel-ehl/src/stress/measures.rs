//! Strength, shakedown and lives from the planes of a body.

use rayon::prelude::*;

use super::body::{Body, Both, Contact, Reference, Sampled};
use super::depths::between;
use super::hardness::YIELD_PER_HARDNESS;
use super::life::{Criterion, Volume, lundberg_palmgren};
use super::results::{AtDepth, DryContact, Layer, Life, Lives, OverDepth, Shakedown, ShakedownBy};
use super::{Depths, HertzLoad, Level, dang_van, fatemi_socie};

/// Yield strength in shear over that in tension, after von Mises.
const SHEAR_YIELD: f64 = 0.577_350_269_189_625_8;
/// Multiples of the cut in depth at which lives are shown.
const CUTS: [f64; 3] = [0.5, 1.0, 2.0];

/// Share of its depth below an interface that is below it.
const BELOW: f64 = 1e-9;

/// The planes with what they mean.
pub(super) fn layers(
    contact: &Contact<'_>,
    body: &Body<'_>,
    depths: &Depths,
    levels: &[Level],
) -> Vec<Layer> {
    let params = contact.params;
    (levels.par_iter().enumerate())
        .map(|(t, level)| {
            let depth = depths.at(t as f64);
            let site = body.site(depths, t as f64);
            let hardness = body.hardness.map(|hardness| hardness.at(depth));
            let strength = hardness.map(|hardness| hardness * YIELD_PER_HARDNESS);
            // Below a jump on the planes that begin a part.
            let below = depths.part(t as f64).1 == Some(false);
            let given = body.residual.map(|residual| residual.at(depth, below));
            let residual = given.unwrap_or_default();
            let total = given.map(|residual| level.von_mises_with(residual));
            let many_passages = dang_van(level.middle(), residual, params.dang_van);
            // In lines and rollers residual stresses leave σ_xz as it is; elsewhere they may move the path of the deviator.
            let shakedown_shear = match contact.is_line {
                true => level.middle_orthogonal,
                false => many_passages.radius / 2.0_f64.sqrt(),
            };
            Layer {
                depth,
                site,
                von_mises: level.von_mises.value,
                largest_shear: level.largest_shear.value,
                tension: level.tension.value,
                orthogonal_half_range: contact.half_range(level).value,
                dang_van: many_passages.index,
                shakedown_shear,
                fatemi_socie: strength.map(|strength| {
                    fatemi_socie(level.middle(), residual, params.fatemi_socie, strength)
                }),
                hardness,
                residual: given.map(|residual| [residual.0[0], residual.0[1]]),
                total_von_mises: total,
                utilisation: strength
                    .map(|strength| total.unwrap_or(level.von_mises.value) / strength),
                shakedown_use: strength.map(|strength| shakedown_shear / (SHEAR_YIELD * strength)),
            }
        })
        .collect()
}

/// Shakedown by the least yield strength in shear of each depth.
pub(super) fn shakedown(contact: &Contact<'_>, both: &Both<'_>) -> Shakedown {
    let shear = both.largest(&|layer| layer.shakedown_shear, 0.0);
    let has_hardness = both.fine.layers.iter().any(|l| l.hardness.is_some());
    let inverse = |most: OverDepth| OverDepth {
        value: 1.0 / most.value,
        error: most.error / (most.value * most.value),
        ..most
    };
    Shakedown {
        by: match contact.is_line {
            true => ShakedownBy::OrthogonalShear,
            false => ShakedownBy::SmallestSphere,
        },
        shear,
        pressure_over_yield: contact.pressure / shear.value,
        safety: has_hardness
            .then(|| inverse(both.largest(&|layer| layer.shakedown_use.unwrap_or(0.0), 0.0))),
    }
}

/// Lives relative to those of the reference, with the difference from the coarser planes as bars.
pub(super) fn lives(contact: &Contact<'_>, both: &Both<'_>, reference: &Reference) -> Vec<Lives> {
    let is_line = contact.is_line;
    let cut_depth = CUTS.map(|factor| factor * contact.cut);
    let limit = contact.params.fatigue_limit;
    // Just below the last interface: layers are not counted.
    let top = both.body.coated.interfaces().pop();
    let top = top.map_or(0.0, |depth| depth * (1.0 + BELOW));
    if top >= contact.depth {
        return Vec::new();
    }
    let fine = Pair::new(both.fine, &reference.fine, is_line, top);
    let coarse = Pair::new(both.coarse, &reference.coarse, is_line, top);
    let life = |own: f64, other: Option<f64>| Life {
        value: own,
        error: other.map_or(own, |other| (own - other).abs())
            + fine.own.stress_exponent() * both.relative * own,
    };
    (Criterion::ALL.into_iter())
        .map(|criterion| Lives {
            criterion,
            cut_depth,
            integral: cut_depth.map(|cut| {
                let of = |pair: &Pair<'_>| {
                    (pair.own).integral_life(&pair.reference, criterion, cut, limit)
                };
                of(&fine).map(|own| life(own, of(&coarse)))
            }),
            largest_stress: cut_depth.map(|cut| {
                let of = |pair: &Pair<'_>| pair.own.stress_life(&pair.reference, criterion, cut);
                life(of(&fine), Some(of(&coarse)))
            }),
        })
        .collect()
}

/// A body and the reference of its lives.
struct Pair<'a> {
    own: Volume<'a>,
    reference: Volume<'a>,
}

impl<'a> Pair<'a> {
    fn new(sampled: &'a Sampled, reference: &'a [Level], is_line: bool, top: f64) -> Pair<'a> {
        let of = |levels: &'a [Level], top: f64| Volume {
            depths: &sampled.depths,
            levels,
            is_line,
            top,
        };
        Pair {
            own: of(&sampled.levels, top),
            reference: of(reference, 0.0),
        }
    }
}

/// The largest stresses of a frictionless dry contact, which are below its centre; `rolls_along_minor`: whether it moves along its smaller half-width.
pub fn dry_contact(load: &HertzLoad, depths: &Depths, rolls_along_minor: bool) -> DryContact {
    let along: Vec<_> = (depths.values().into_iter())
        .map(|z| load.at(0.0, 0.0, z))
        .collect();
    let largest = |values: Vec<f64>| {
        let (_, t) = depths.largest(0.0, |i| values[i]);
        AtDepth {
            value: between(&values, t),
            depth: depths.at(t),
        }
    };
    let ratio = (load.half_width_y).map_or(0.0, |b| load.half_width / b);
    DryContact {
        von_mises: largest(along.iter().map(|s| s.von_mises()).collect()),
        largest_shear: largest(along.iter().map(|s| s.largest_shear()).collect()),
        orthogonal_half_range: (rolls_along_minor && ratio <= 1.0).then(|| {
            let [shear, depth] = lundberg_palmgren(ratio);
            AtDepth {
                value: shear * load.pressure,
                depth: depth * load.half_width,
            }
        }),
    }
}
