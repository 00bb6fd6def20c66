//! Continuation strategies: from a contact that is easily solved to the case's own, by one quantity at a time.
//!
//! A strategy is a function from the outline of a problem to a list of stages; it is empty where it does not apply. What each
//! cures stands with it, and in docs/theory/isothermal-contact.md. [`fallbacks`] is the order in which they are tried.

pub(super) mod diffusion;
pub(super) mod finer_mesh;
pub(super) mod halfway;
pub(super) mod lower_order;
pub(super) mod shear_law;
pub(super) mod sliding;
pub(super) mod speed;
pub(super) mod viscosity_exponent;

#[cfg(test)]
pub(super) mod tests;

use super::stage::Stage;

/// What strategies know of a problem.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// The usual stages: start, comparisons, solution; never empty.
    pub usual: Vec<Stage>,
    /// Whether shear rates grow exponentially with the stress (Eyring, limiting stress).
    pub exponential: bool,
    /// Whether runs that go round in circles are given up early on refined meshes, too.
    pub impatient: bool,
    /// Whether films are much thinner at the ends of the contact than in its middle, as under a roller.
    pub has_steep_ends: bool,
    /// ρ_r of stages that do not converge without, and of meshes refined for the pressure alone; 0 where there is none.
    pub ridge_diffusion: f64,
    /// Whether the surfaces slide.
    pub slides: bool,
    /// Whether the mesh is refined locally after the first solution.
    pub refined: bool,
}

/// A strategy laid out for a problem.
#[derive(Clone, Debug)]
pub(super) struct Fallback {
    /// What it changes step by step, in words for users.
    pub name: &'static str,
    /// Whether it goes on from the usual start, so that it is of no use where that has failed.
    pub needs_start: bool,
    /// Its stages; never empty.
    pub stages: Vec<Stage>,
}

impl Outline {
    /// The start.
    pub fn start(&self) -> &Stage {
        &self.usual[0]
    }

    /// The solution.
    pub fn last(&self) -> &Stage {
        &self.usual[self.usual.len() - 1]
    }

    /// The usual stages, none of them given up early: what was is tried in earnest.
    pub fn in_earnest(&self) -> Vec<Stage> {
        let earnest = |stage: &Stage| Stage {
            given_up_early: false,
            ..*stage
        };
        self.usual.iter().map(earnest).collect()
    }

    /// What leads from a start to the case, whatever the start: by the shear law where that is the difficulty, else by
    /// diffusion.
    fn path_from_start(&self) -> Vec<Stage> {
        match self.exponential {
            true => shear_law::at_full_sliding(self),
            false => diffusion::diffusion(self),
        }
    }
}

/// What is tried, in turn, when the first start or the final stage does not converge. First what changes least: the mesh and the
/// start stay while the difficulty itself (heat, shear law, spike) is led up to; then other starts, other meshes, other orders.
pub(super) fn fallbacks(outline: &Outline) -> Vec<Fallback> {
    let mut fallbacks = Vec::new();
    let mut push = |name, needs_start, stages: Vec<Stage>| {
        if !stages.is_empty() {
            fallbacks.push(Fallback {
                name,
                needs_start,
                stages,
            });
        }
    };
    if outline.exponential {
        push(
            "shear law, sliding, then the rest of the shear law",
            true,
            shear_law::through_sliding(outline),
        );
        push(
            "shear law, then sliding",
            true,
            shear_law::before_sliding(outline),
        );
        let from_start = [
            &[*outline.start()],
            &shear_law::at_full_sliding(outline)[..],
        ];
        push("shear law", true, from_start.concat());
    } else {
        if outline.has_steep_ends {
            push("speed", false, speed::speed(outline));
        }
        push("sliding", true, sliding::sliding(outline));
        push("diffusion", true, diffusion::diffusion(outline));
    }
    push(
        "viscosity exponent",
        false,
        viscosity_exponent::viscosity_exponent(outline),
    );
    push("finer rim", false, finer_mesh::finer_rim(outline));
    push(
        "finer rim and viscosity exponent",
        false,
        finer_mesh::finer_rim_and_viscosity_exponent(outline),
    );
    for order in (1..outline.last().pressure_order).rev() {
        // What has failed with as low an order already is not tried again.
        let needs_start = order >= outline.start().pressure_order;
        let stages = lower_order::lower_order(outline, order);
        push("lower pressure order", needs_start, stages);
    }
    fallbacks
}
