//! From loads to the figures of a body.

use super::body::{Body, Both, Contact, Reference, Sampled};
use super::measures::{layers, lives, shakedown};
use super::results::{BodyStresses, Interface, PartStresses};
use super::sections::{profile, section};
use super::{Depths, Load, Response};

/// The stresses of a body.
pub fn analyse(contact: &Contact<'_>, body: &Body<'_>, reference: &Reference) -> BodyStresses {
    let cut = contact.cut;
    let depths = contact.depths(body.coated);
    let coarser = depths.coarser();
    let fine = sampled(contact, body, body.load, &contact.x, depths);
    let thinned = contact.thinned(body.coarse);
    let coarse = sampled(contact, body, body.coarse, &thinned, coarser);
    let both = Both {
        fine: &fine,
        coarse: &coarse,
        body,
        relative: contact.relative_error,
    };
    let von_mises = both.extreme(&|level| level.von_mises, 0.0);
    BodyStresses {
        poissons_ratio: body.coated.substrate.poissons_ratio,
        traction: body.traction,
        von_mises,
        largest_shear: both.extreme(&|level| level.largest_shear, 0.0),
        tension: both.extreme(&|level| level.tension, 0.0),
        orthogonal_half_range: both.extreme(&|level| contact.half_range(level), cut),
        dang_van: both.largest(&|layer| layer.dang_van, cut),
        near_surface_dang_van: both.largest_above(&|layer| layer.dang_van, cut),
        shakedown: shakedown(contact, &both),
        total_von_mises: (body.residual)
            .map(|_| both.largest(&|layer| layer.total_von_mises.unwrap_or(0.0), 0.0)),
        utilisation: (body.hardness)
            .map(|_| both.largest(&|layer| layer.utilisation.unwrap_or(0.0), 0.0)),
        lives: lives(contact, &both, reference),
        parts: parts(&both),
        interfaces: interfaces(&both),
        axis: profile(contact, body, &fine, [0.0, 0.0]),
        below_largest: profile(contact, body, &fine, [von_mises.x, von_mises.y]),
        section: section(contact, &fine),
        layers: fine.layers,
    }
}

fn sampled(
    contact: &Contact<'_>,
    body: &Body<'_>,
    load: &Load,
    x: &[f64],
    depths: Depths,
) -> Sampled {
    let response = Response::new(body.coated, &depths);
    let levels = load.levels(x, &response);
    Sampled {
        layers: layers(contact, body, &depths, &levels),
        depths,
        response,
        levels,
    }
}

/// The largest stresses in each layer and in the substrate of a body with layers.
fn parts(both: &Both<'_>) -> Vec<PartStresses> {
    let layers = both.body.coated.layers.len();
    let of = |part: usize| PartStresses {
        layer: (part < layers).then_some(part + 1),
        von_mises: both.extreme_in(&|level| level.von_mises, part),
        largest_shear: both.extreme_in(&|level| level.largest_shear, part),
        tension: both.extreme_in(&|level| level.tension, part),
        utilisation: (both.body.hardness)
            .map(|_| both.largest_in(&|layer| layer.utilisation.unwrap_or(0.0), part)),
    };
    match layers {
        0 => Vec::new(),
        _ => (0..both.fine.depths.n_parts()).map(of).collect(),
    }
}

/// The largest tractions on each interface.
fn interfaces(both: &Both<'_>) -> Vec<Interface> {
    let below = both.fine.depths.n_parts() - 1;
    (0..below)
        .map(|part| Interface {
            interface: part + 1,
            shear: both.extreme_at(&|level| level.shear, part),
            pull: both.extreme_at(&|level| level.pull, part),
        })
        .collect()
}
