//! From loads to the figures of a body.

use super::body::{Body, Both, Contact, Reference, Sampled};
use super::measures::{layers, lives, shakedown};
use super::results::BodyStresses;
use super::sections::{profile, section};
use super::{Depths, Load};

/// The stresses of a body.
pub fn analyse(contact: &Contact<'_>, body: &Body<'_>, reference: &Reference) -> BodyStresses {
    let cut = contact.cut;
    let fine = sampled(contact, body, body.load, &contact.x, contact.depths);
    let thinned = contact.thinned(body.coarse);
    let coarse = sampled(
        contact,
        body,
        body.coarse,
        &thinned,
        contact.depths.coarser(),
    );
    let both = Both {
        fine: &fine,
        coarse: &coarse,
        relative: contact.relative_error,
    };
    let von_mises = both.extreme(&|level| level.von_mises, 0.0);
    BodyStresses {
        poissons_ratio: body.poisson,
        traction: body.traction,
        von_mises,
        largest_shear: both.extreme(&|level| level.largest_shear, 0.0),
        tension: both.extreme(&|level| level.tension, 0.0),
        orthogonal_half_range: both.extreme(&|level| contact.half_range(level), cut),
        dang_van: both.largest(&|layer| layer.dang_van, cut),
        shakedown: shakedown(contact, &both),
        utilisation: (body.hardness)
            .map(|_| both.largest(&|layer| layer.utilisation.unwrap_or(0.0), 0.0)),
        lives: lives(contact, &both, reference),
        axis: profile(contact, body, &fine.levels, [0.0, 0.0]),
        below_largest: profile(contact, body, &fine.levels, [von_mises.x, von_mises.y]),
        section: section(contact, &fine.levels),
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
    let levels = load.levels(x, &depths, body.poisson);
    Sampled {
        layers: layers(contact, body, &depths, &levels),
        depths,
        levels,
    }
}
