//! Continuation in the entrainment speed, λ from that of a much thicker film to that of the case.
//!
//! Cures contacts that have places much thinner than the rest: the steep ends of a roller. From the dry contact, Newton's method empties
//! them before the oil has come in, and has no way back, because what has no film lets no oil pass.

use super::Outline;
use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
use crate::solve::system::FilmConstants;
use crate::solve::tuning::continuation::{SPEEDS, THICKEST};

/// Exponent of the speed in the central film of heavily loaded contacts (Hamrock and Dowson, J. Lubr. Technol. 99 (1977), 264-276).
const FILM_EXPONENT: f64 = 0.67;

/// From a start at the highest speed, without its diffusion down to the case; nothing where the film is thick already.
pub(super) fn speed(outline: &Outline) -> Vec<Stage> {
    let (start, stages) = (outline.start(), outline.in_earnest());
    let film = |speed: f64| speed.powf(FILM_EXPONENT) * start.constants.film_scale;
    let speeds = SPEEDS.into_iter().filter(|speed| film(*speed) < THICKEST);
    let mut path: Vec<Stage> = Vec::new();
    for speed in speeds {
        let faster = |stage: &Stage| Stage {
            newtonian: start.newtonian,
            heated: false,
            constants: FilmConstants {
                lambda: speed * stage.constants.lambda,
                film_scale: film(speed),
                ..stage.constants
            },
            ..*stage
        };
        if path.is_empty() {
            path.push(faster(start));
        }
        path.push(Stage {
            cold: false,
            role: Role::Path,
            ..faster(&stages[stages.len() - 1])
        });
    }
    if !path.is_empty() {
        path.extend(&stages[1..]);
    }
    path
}
