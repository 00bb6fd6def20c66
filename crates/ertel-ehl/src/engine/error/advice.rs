//! Advice after a failed solve.

use super::{HeatError, SolveError, Stopped};

impl SolveError {
    /// Advice for this failure; `None` where nothing failed, or where the message contains it.
    #[must_use]
    pub fn advice(&self) -> Option<&'static str> {
        match self {
            SolveError::NotConverged { reason, .. } => Some(reason.advice()),
            SolveError::GridNotConverged {
                has_reliefs: true, ..
            } => Some(
                "less relief in [[surface]] (amplitude, height, depth, or a longer low_pass), a thicker film or more load: a relief many times \
                 deeper than the film interrupts it; without [[surface]] the film of smooth bodies comes out",
            ),
            SolveError::GridNotConverged { .. } => Some(
                "[solver] method = \"finite-elements\", above all where the film is thick compared with the contact, whose area the first grid then \
                 covers with cells that are too large",
            ),
            SolveError::NotCoupled { contraction, .. } => Some(match *contraction < 1.0 {
                true => {
                    "more rounds ([thermal] max_iterations), since the changes shrink, or a larger [thermal] tolerance"
                }
                false => {
                    "less sliding or load to begin with: the heat that the film makes changes it by more than a round brings back; \
                     without [thermal] the isothermal film comes out"
                }
            }),
            SolveError::Heat(HeatError::Turns { .. }) => {
                Some("`method = \"finite-elements\"` in [solver]")
            }
            SolveError::Heat(HeatError::Overheated) => Some(
                "checking the constants of [lubricant.shear_thinning], less sliding, or a lower load: shear stresses within \
                 the range of the law",
            ),
            SolveError::Heat(_) => Some(
                "checking the lubricant's laws over the temperature ([lubricant] viscosity, density, thermal_conductivity), less \
                 sliding to begin with, or no [thermal], which gives the isothermal film",
            ),
            SolveError::Krylov(_) => Some(
                "another mesh ([mesh] preset = \"fine\", or the edges inlet, outlet and side nearer to the contact) or formulation \
                 ([solver] formulation = \"supg\")",
            ),
            SolveError::Factorisation(_) => Some(
                "checking the constants of the lubricant's laws, above all of the viscosity over the pressure, or a lower load",
            ),
            SolveError::EndCarries { .. } => Some(
                "more relief at the ends of the profile (kind = \"logarithmic\" with a design_load of this load or more falls off \
                 steeply enough without a tilt), less load or less misalignment; real ends are rounded, which a table can describe",
            ),
            SolveError::ReliefNotResolved { .. } => Some(
                "a larger [mesh] max_unknowns, or a longer low_pass, shortest_wavelength, wavelength or width in [[surface]]",
            ),
            SolveError::TooThin { help, .. } => Some(help),
            // Advice of a grid is the other method, which was tried.
            SolveError::BothFailed { first, second, .. } => [first, second]
                .into_iter()
                .find(|error| !matches!(***error, SolveError::GridNotConverged { .. }))
                .and_then(|error| error.advice()),
            SolveError::Worn { error: Some(_), .. } => Some(
                "a smaller [wear] step, or a shorter sliding distance, at which the figures are known",
            ),
            SolveError::Worn { error: None, .. } => {
                Some("a larger [wear] max_steps or step, or a shorter sliding distance")
            }
            SolveError::Thinned { .. } => Some(
                "checking the constants of [lubricant.shear_thinning] and their units (stresses of oils are 1 to 20 MPa; a second \
                 plateau mu_2 keeps blended oils from thinning without end), or less load or sliding to begin with",
            ),
            SolveError::MissingHeatData(_)
            | SolveError::Discretisation(_)
            | SolveError::Interrupted => None,
        }
    }
}

impl Stopped {
    /// Advice.
    #[must_use]
    pub fn advice(self) -> &'static str {
        match self {
            Stopped::NotFinite | Stopped::NoStep => {
                "a lower load, or checking the constants of the lubricant's laws (viscosity over the pressure, \
                 [lubricant.shear_thinning]): at the pressures of the iteration they have no finite value"
            }
            Stopped::Circling => {
                "a finer mesh ([mesh] preset = \"fine\"), another formulation ([solver] formulation = \"supg\"), or a smaller load to \
                 begin with"
            }
            Stopped::OutOfIterations => {
                "more iterations ([solver] max_iterations), since the updates still shrink, or a smaller load to begin with"
            }
            Stopped::NegativeFilm => {
                "smaller cells where the film is thinnest ([mesh] preset = \"fine\", or rim_size), or a thicker film: more viscous oil, \
                 faster motion"
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use ertel_fem::linear::gmres::GmresError;

    use super::*;

    fn stopped(reason: Stopped) -> SolveError {
        SolveError::NotConverged {
            level: 0,
            iterations: 1,
            residual: 1.0,
            update: 1.0,
            penalty_share: 1.0,
            reason,
        }
    }

    fn not_on_grid(has_reliefs: bool) -> SolveError {
        SolveError::GridNotConverged {
            level: 1,
            iterations: 130,
            change: 0.05,
            has_reliefs,
        }
    }

    fn not_coupled(contraction: f64) -> SolveError {
        SolveError::NotCoupled {
            part: "stage",
            level: 0,
            rounds: 40,
            change: 0.1,
            contraction,
        }
    }

    /// How far an attempt came is a number, or that it diverges.
    #[test]
    fn no_message_has_a_number_that_is_none() {
        let text = not_on_grid(false).to_string();
        assert!(text.ends_with("after 130 Newton iterations pressures still change by 5.0e-2 p_h"));
        for change in [f64::NAN, f64::INFINITY] {
            let error = SolveError::GridNotConverged {
                level: 1,
                iterations: 130,
                change,
                has_reliefs: false,
            };
            assert!(error.to_string().ends_with("the last attempt diverges"));
        }
    }

    /// The reasons of both methods are shown, and no method that was tried is advised.
    #[test]
    fn both_methods_are_named() {
        let both = SolveError::BothFailed {
            first: Box::new(stopped(Stopped::Circling)),
            method: "finite volumes",
            second: Box::new(not_coupled(2.0)),
        };
        let text = both.to_string();
        assert!(
            text.contains("; finite volumes failed, too: no convergence"),
            "{text}"
        );
        assert_eq!(both.advice(), Some(Stopped::Circling.advice()));
    }

    #[test]
    fn thinning_is_named_where_it_is_far_from_that_of_oils() {
        let thinned = SolveError::Thinned {
            error: Box::new(stopped(Stopped::Circling)),
            share: 0.0285,
        };
        assert!(thinned.to_string().contains("2.85 % of the Newtonian film"));
        assert!(thinned.advice().is_some_and(|text| text.contains("mu_2")));
        assert_ne!(thinned.advice(), stopped(Stopped::Circling).advice());
    }

    /// Each kind of failure has its own advice, which names what can be changed; only cycles of Newton's method ask for a finer
    /// mesh and another formulation, and no heat for either.
    #[test]
    fn advice_fits_the_failure() {
        let krylov = GmresError {
            iterations: 1,
            residual: 0.5,
        };
        let kinds = [
            (stopped(Stopped::NotFinite), "shear_thinning"),
            (stopped(Stopped::Circling), "supg"),
            (stopped(Stopped::OutOfIterations), "max_iterations"),
            (stopped(Stopped::NegativeFilm), "rim_size"),
            (not_coupled(0.9), "[thermal] max_iterations"),
            (not_coupled(1.1), "less sliding"),
            (SolveError::Heat(HeatError::Overheated), "shear_thinning"),
            (
                SolveError::Heat(HeatError::Turns { share: 0.3 }),
                "finite-elements",
            ),
            (
                SolveError::Heat(HeatError::NotFinite),
                "over the temperature",
            ),
            (SolveError::Krylov(krylov), "inlet, outlet and side"),
            (
                SolveError::EndCarries {
                    place: 0.01,
                    film: 0.0,
                },
                "relief",
            ),
            (
                SolveError::ReliefNotResolved {
                    cell: 0.02,
                    needed: 0.01,
                },
                "low_pass",
            ),
            (not_on_grid(false), "finite-elements"),
            // Elements have no reliefs.
            (not_on_grid(true), "in [[surface]]"),
        ];
        let mut seen = std::collections::BTreeSet::new();
        for (error, key) in &kinds {
            let advice = error.advice().expect("advice");
            assert!(advice.contains(key), "{error}: {advice}");
            assert!(seen.insert(advice), "the same for two kinds: {advice}");
            let of_mesh = advice.contains("preset");
            let meshes = matches!(
                error,
                SolveError::Krylov(_)
                    | SolveError::NotConverged {
                        reason: Stopped::Circling | Stopped::NegativeFilm,
                        ..
                    }
            );
            assert_eq!(of_mesh, meshes, "{error}: {advice}");
        }
        assert!(SolveError::Interrupted.advice().is_none());
        // The linear solver is an internal detail.
        assert!(!SolveError::Krylov(krylov).to_string().contains("GMRES"));
    }
}
