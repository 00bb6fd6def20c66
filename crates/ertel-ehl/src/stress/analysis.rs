//! From loads to the figures of a body.

use super::depths::{between, crest};
use super::hardness::YIELD_PER_HARDNESS;
use super::life::{Criterion, Volume, lundberg_palmgren};
use super::results::{
    AtDepth, BodyStresses, DryContact, Extreme, Layer, Lives, Profile, Section, Shakedown,
    StressParams,
};
use super::{Depths, Hardness, HertzLoad, Level, Load, Peak, dang_van, fatemi_socie};

/// Settings and geometry that both bodies share.
pub struct Contact<'a> {
    /// Settings.
    pub params: &'a StressParams,
    /// Depths of the planes.
    pub depths: Depths,
    /// Depth from which lives are computed.
    pub cut: f64,
    /// Points of a passage, of a grid its own.
    pub x: Vec<f64>,
    /// Whether it is a line or a roller.
    pub is_line: bool,
    /// Hertz pressure, Pa.
    pub pressure: f64,
    /// How far along x the section is kept, m.
    pub reach: f64,
}

/// A body.
pub struct Body<'a> {
    /// Its load.
    pub load: &'a Load,
    /// The same half as dense.
    pub coarse: &'a Load,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Traction along x over the load.
    pub traction: f64,
    /// Hardness over depth.
    pub hardness: Option<&'a Hardness>,
}

/// Yield strength in shear over that in tension, after von Mises.
const SHEAR_YIELD: f64 = 0.577_350_269_189_625_8;
/// Multiples of the cut in depth at which lives are shown.
const CUTS: [f64; 3] = [0.5, 1.0, 2.0];
/// Most columns of a section.
const COLUMNS: usize = 200;

/// The stresses of a body; `reference`: the levels of the frictionless dry contact.
pub fn analyse(contact: &Contact<'_>, body: &Body<'_>, reference: &[Level]) -> BodyStresses {
    let Contact { depths, cut, .. } = contact;
    let levels = body.load.levels(&contact.x, depths, body.poisson);
    let coarse_depths = depths.coarser();
    let thinned: Vec<f64> = match body.coarse {
        Load::Grid(load) => load.centres[0].clone(),
        _ => contact.x.iter().copied().step_by(2).collect(),
    };
    let coarse = (body.coarse).levels(&thinned, &coarse_depths, body.poisson);
    let extreme = |pick: &dyn Fn(&Level) -> Peak, from: f64| {
        let found = largest(depths, &levels, pick, from);
        let other = largest(&coarse_depths, &coarse, pick, from);
        Extreme {
            error: (found.value - other.value).abs(),
            depth_error: (found.depth - other.depth).abs(),
            ..found
        }
    };
    let von_mises = extreme(&|level| level.von_mises, 0.0);
    let layers = layers(contact, body, &levels);
    let below = |pick: &dyn Fn(&Layer) -> f64, from: f64| {
        let values: Vec<f64> = layers.iter().map(pick).collect();
        let first = (depths.index(from).ceil() as usize).min(values.len() - 1);
        let (value, t) = crest(values.len() - first, |i| values[first + i]);
        AtDepth {
            value,
            depth: depths.at(first as f64 + t),
        }
    };
    let own = Volume {
        depths,
        levels: &levels,
        is_line: contact.is_line,
    };
    BodyStresses {
        poissons_ratio: body.poisson,
        traction: body.traction,
        von_mises,
        largest_shear: extreme(&|level| level.largest_shear, 0.0),
        tension: extreme(&|level| level.tension, 0.0),
        orthogonal_half_range: extreme(&|level| level.half_range, *cut),
        dang_van: below(&|layer| layer.dang_van, *cut),
        shakedown: (contact.is_line).then(|| {
            let shear = extreme(&|level| level.orthogonal, 0.0);
            shakedown(contact, body, &levels, shear)
        }),
        utilisation: (body.hardness).map(|_| below(&|l| l.utilisation.unwrap_or(0.0), 0.0)),
        lives: lives(contact, &own, reference),
        layers,
        axis: profile(contact, body, &levels, [0.0, 0.0]),
        below_largest: profile(contact, body, &levels, [von_mises.x, von_mises.y]),
        section: section(contact, &levels),
    }
}

/// The largest value over the depths from one on, without bars.
fn largest(depths: &Depths, levels: &[Level], pick: &dyn Fn(&Level) -> Peak, from: f64) -> Extreme {
    let first = (depths.index(from).ceil() as usize).min(levels.len() - 1);
    let (value, t) = crest(levels.len() - first, |i| pick(&levels[first + i]).value);
    let t = first as f64 + t;
    let at = pick(&levels[t.round() as usize]);
    Extreme {
        value,
        error: 0.0,
        x: at.x,
        y: at.y,
        depth: depths.at(t),
        depth_error: 0.0,
    }
}

/// The levels with what they mean.
fn layers(contact: &Contact<'_>, body: &Body<'_>, levels: &[Level]) -> Vec<Layer> {
    use rayon::prelude::*;
    let params = contact.params;
    (levels.par_iter().enumerate())
        .map(|(t, level)| {
            let depth = contact.depths.at(t as f64);
            let hardness = body.hardness.map(|hardness| hardness.at(depth));
            let strength = hardness.map(|hardness| hardness * YIELD_PER_HARDNESS);
            Layer {
                depth,
                von_mises: level.von_mises.value,
                largest_shear: level.largest_shear.value,
                tension: level.tension.value,
                orthogonal_half_range: level.half_range.value,
                dang_van: dang_van(&level.middle, params.dang_van).index,
                fatemi_socie: strength
                    .map(|strength| fatemi_socie(&level.middle, params.fatemi_socie, strength)),
                hardness,
                utilisation: strength.map(|strength| level.von_mises.value / strength),
            }
        })
        .collect()
}

fn shakedown(
    contact: &Contact<'_>,
    body: &Body<'_>,
    levels: &[Level],
    shear: Extreme,
) -> Shakedown {
    let safety = body.hardness.map(|hardness| {
        let at = |(t, level): (usize, &Level)| {
            let strength = hardness.at(contact.depths.at(t as f64)) * YIELD_PER_HARDNESS;
            SHEAR_YIELD * strength / level.orthogonal.value
        };
        levels
            .iter()
            .enumerate()
            .map(at)
            .fold(f64::INFINITY, f64::min)
    });
    Shakedown {
        shear,
        pressure_over_yield: contact.pressure / shear.value,
        safety,
    }
}

fn lives(contact: &Contact<'_>, own: &Volume<'_>, reference: &[Level]) -> Vec<Lives> {
    let other = Volume {
        levels: reference,
        ..*own
    };
    let cut_depth = CUTS.map(|factor| factor * contact.cut);
    let limit = contact.params.fatigue_limit;
    (Criterion::ALL.into_iter())
        .map(|criterion| Lives {
            criterion,
            cut_depth,
            integral: cut_depth.map(|cut| own.integral_life(&other, criterion, cut, limit)),
            largest_stress: cut_depth.map(|cut| own.stress_life(&other, criterion, cut)),
        })
        .collect()
}

/// Stresses below a place; on a grid below the centre of its cell.
fn profile(contact: &Contact<'_>, body: &Body<'_>, levels: &[Level], place: [f64; 2]) -> Profile {
    let rows = body.load.rows();
    let nearest = |places: &[f64], at: f64| {
        let distance = |i: &usize| (places[*i] - at).abs();
        let all = 0..places.len();
        all.min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    };
    let row = nearest(&rows, place[1]);
    let (x, y) = match body.load {
        Load::Grid(load) => (
            load.centres[0][nearest(&load.centres[0], place[0])],
            rows[row],
        ),
        _ => (place[0], 0.0),
    };
    let depth = contact.depths.all();
    Profile {
        x,
        y,
        stress: (depth.iter())
            .map(|z| body.load.at([x, y, *z], body.poisson))
            .collect(),
        orthogonal_range: (levels.iter())
            .map(|level| 2.0 * level.rows[row].half_range)
            .collect(),
        depth,
    }
}

fn section(contact: &Contact<'_>, levels: &[Level]) -> Section {
    let near = |i: &usize| contact.x[*i].abs() <= contact.reach;
    let columns: Vec<usize> = (0..contact.x.len()).filter(near).collect();
    let step = columns.len().div_ceil(COLUMNS).max(1);
    let columns: Vec<usize> = columns.into_iter().step_by(step).collect();
    Section {
        x: columns.iter().map(|i| contact.x[*i]).collect(),
        depth: contact.depths.all(),
        stress: (levels.iter())
            .flat_map(|level| columns.iter().map(|i| level.middle[*i]))
            .collect(),
    }
}

/// The largest stresses of a frictionless dry contact, which are below its centre; `rolls_along_minor`: whether it moves along its smaller half-width.
pub fn dry_contact(load: &HertzLoad, depths: &Depths, rolls_along_minor: bool) -> DryContact {
    let along: Vec<_> = (depths.all().iter())
        .map(|z| load.at(0.0, 0.0, *z))
        .collect();
    let largest = |values: Vec<f64>| {
        let (_, t) = crest(values.len(), |i| values[i]);
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
