//! Starts on another mesh.
//!
//! Cures films thinner than foreseen, whose pressure builds up over a length that the first mesh does not resolve: Roelands at
//! M = 10,000, L = 10 has half of the formula's film.

use super::{Outline, diffusion, shear_law, viscosity_exponent};
use crate::solve::sequence::stage::Stage;

/// The start and what follows from it, with cells half as long on the rim and at the constriction; where the mesh is not
/// refined, on the case's own, which is finer than that of the start.
pub(super) fn finer_rim(outline: &Outline) -> Vec<Stage> {
    let sizes = match outline.refined {
        true => outline.last().sizes.with_finer_rim(),
        false => outline.last().sizes,
    };
    let on_finer = |stage: &Stage| Stage { sizes, ..*stage };
    let mut stages = vec![on_finer(outline.start())];
    if outline.exponential {
        let from_start = shear_law::at_full_sliding(outline);
        stages.extend(from_start.iter().map(on_finer));
    } else {
        stages.extend(diffusion::steps(&stages[0], outline.last()));
        stages.extend(outline.in_earnest().last().map(on_finer));
    }
    stages
}

/// The same from a start at the least viscosity exponent.
pub(super) fn finer_rim_and_viscosity_exponent(outline: &Outline) -> Vec<Stage> {
    let finer = finer_rim(outline);
    let mut stages = viscosity_exponent::steps(&finer[0]);
    stages.extend(&finer[1..]);
    stages
}
