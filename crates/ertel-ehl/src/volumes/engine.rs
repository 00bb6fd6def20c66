//! Solves a problem by finite volumes: one grid after the other until both films reach the target error.

use ertel_fem::platform::Instant;
use std::sync::OnceLock;

use super::contents::Arrival;
use super::edges::effects;
use super::ending::balance_error;
use super::extremes::lowest;
use super::far_pressure::Beyond;
use super::figures::{central, figures, note_films};
use super::heat::rounds::Rounds;
use super::level::{Level, convolution, first_state, first_system, refined};
use super::newton::{NewtonInfo, NewtonParams, newton};
use super::patches::{first_cells, grid};
use super::plan::{LEAST_GRIDS, Plan, newton_params};
use super::preconditioner::{Pattern, pattern};
use super::pseudo_time::march;
use super::rows::RING;
use super::system::{State, System};
use crate::contact::Symmetry;
use crate::engine::bars::{Slowest, bar, bars, gap_of, is_settled};
use crate::engine::figures::sizes;
use crate::engine::{Observer, Problem, SolveError};
use crate::solution::{Figure, Figures, LevelStats, Measured, Role, Timings};

/// Grids from coarse to fine, Newton's method on each.
#[derive(Clone, Copy, Debug, Default)]
pub struct FiniteVolumes;

/// A solution by finite volumes.
pub struct Volumes {
    /// The grids, coarse to fine.
    pub levels: Vec<Level>,
    /// Effort and figures of each.
    pub stats: Vec<LevelStats>,
    /// Whether Newton's method did not converge on a further grid.
    pub stopped: bool,
    /// Relative changes of central and minimum film where the film continues outside the edges of the contact area.
    pub edge_effects: [f64; 2],
    /// Net outflow of the wetted part of the finest grid, over the flow through the centre.
    pub balance_error: f64,
}

/// Grids from which figures and their error bars are computed.
pub const BAR_GRIDS: usize = 3;

/// Second attempt of Newton's method on a grid where it did not converge: largest change of a pressure, and most iterations.
const RETRY: (f64, usize) = (0.05, 100);

/// Most nodes of a grid on which a failed attempt is followed by others where coarser grids are an answer. A factorisation of 77,000 unknowns takes as long as all grids
/// before; an ellipse at 2 GPa and a ball with a layer of 38 nm had no answer after 60 s. Films in time are not tried on larger grids.
const MOST_NODES_OF_RETRIES: usize = 50_000;

/// Speed factors of the continuation on a first grid where the second attempt fails, too. On finer grids they have not helped: the films of
/// the grid before are a better start than those of another speed.
const SPEEDS: [f64; 4] = [64.0, 16.0, 4.0, 1.0];

/// Continuation in the softness of a law whose shear rate grows exponentially with the stress, where a grid does not converge at once.
const SOFTNESS: [f64; 6] = [243.0, 81.0, 27.0, 9.0, 3.0, 1.0];

/// Imbalance of a node, over the entrained flow, above which a law whose shear rate grows exponentially with the stress is immediately solved by
/// continuation. Attempts that converge stay below 10; others exceed 1e6 within two iterations and diverge.
const DIVERGED_IMBALANCE: f64 = 1e4;

/// Newton's method on a grid: directly, with shorter steps, by continuation from higher speeds, or as the end of a film in time, which comes second in starved contacts.
fn solve_on(
    problem: &Problem<Plan>,
    system: &mut System,
    state: &mut State,
    level: usize,
    observer: &mut dyn Observer,
) -> Result<NewtonInfo, SolveError> {
    let pattern = pattern(system)?;
    let about = (level, problem.scales.film);
    let params = &newton_params(problem, level);
    let start = state.clone();
    let is_large = system.grid.n_nodes() > MOST_NODES_OF_RETRIES;
    let only_once = is_large && level >= LEAST_GRIDS;
    let at_once = NewtonParams {
        factorises: !only_once,
        most_imbalance: match problem.fluid.is_exponential() {
            true => DIVERGED_IMBALANCE,
            false => f64::INFINITY,
        },
        ..*params
    };
    let mut all = newton(system, &pattern, state, &at_once, about, observer);
    if only_once {
        return ended(all);
    }
    if system.rough.is_some() && level > 0 && !all.converged && !all.interrupted {
        state.clone_from(&start);
        raise(problem, system, state);
        let damped = damped(params);
        all = all.and(newton(system, &pattern, state, &damped, about, observer));
    }
    if !problem.plan.continues {
        return ended(all);
    }
    // Coarse grids of lines may fail; on their fine ones, films in time have not been tried.
    let may_march = !problem.shape.is_line() && !is_large;
    // In starved contacts, shorter steps move the meniscus by a node each, and higher speeds diverge: first grids took twice as many iterations.
    let has_layer = matches!(system.arrival, Arrival::Layer(_));
    if may_march && has_layer && !all.converged && !all.interrupted {
        state.clone_from(&start);
        all = all.and(march(system, &pattern, state, params, about, observer));
    }
    if !all.converged && !all.interrupted {
        state.clone_from(&start);
        all = all.and(continued(
            problem,
            (system, state),
            &pattern,
            level,
            observer,
        ));
    }
    if !all.converged && !all.interrupted && may_march && !has_layer {
        *state = start;
        all = all.and(march(system, &pattern, state, params, about, observer));
    }
    ended(all)
}

/// Newton's method on a grid with shorter steps, or by continuation from softer laws or higher speeds; `state` holds the start.
fn continued(
    problem: &Problem<Plan>,
    (system, state): (&mut System, &mut State),
    pattern: &Pattern,
    level: usize,
    observer: &mut dyn Observer,
) -> NewtonInfo {
    let about = (level, problem.scales.film);
    let params = &newton_params(problem, level);
    let start = state.clone();
    let mut all = NewtonInfo::default();
    let patient = NewtonParams {
        largest_change: RETRY.0.min(newton_params(problem, 0).largest_change),
        max_iterations: RETRY.1,
        ..*params
    };
    let slowly = [(1.0, 1.0, &patient)];
    let softly = SOFTNESS.map(|softness| (1.0, softness, params));
    let faster = SPEEDS.map(|factor| (factor, 1.0, params));
    let softly: &[_] = match problem.fluid.is_exponential() {
        true => &softly,
        false => &[],
    };
    let attempts: [&[(f64, f64, &NewtonParams)]; 3] = match level {
        0 => [softly, &slowly, &faster],
        _ => [softly, &slowly, &[]],
    };
    for attempt in attempts {
        if all.converged || all.interrupted {
            break;
        }
        if attempt.is_empty() {
            continue;
        }
        *state = start.clone();
        for (speed, softness, params) in attempt {
            system.lambda = speed * problem.scales.lambda;
            system.fluid = problem.fluid.with_softness(*softness);
            let info = newton(system, pattern, state, params, about, observer);
            all = all.and(info);
            if info.interrupted || !info.converged {
                break;
            }
        }
    }
    system.lambda = problem.scales.lambda;
    system.fluid = problem.fluid.clone();
    all
}

fn ended(info: NewtonInfo) -> Result<NewtonInfo, SolveError> {
    match info.interrupted {
        true => Err(SolveError::Interrupted),
        false => Ok(info),
    }
}

/// Damped steps, and as many as the second attempt may take.
fn damped(params: &NewtonParams) -> NewtonParams {
    NewtonParams {
        damped: true,
        max_iterations: RETRY.1,
        ..*params
    }
}

/// Lifts the surfaces to at least the film of the start at the centre. Gaps between rough surfaces grow ever more slowly as these approach: from a coarse grid on which they overlap
/// too far, Newton's steps lift them by many times the film; from above they close in.
fn raise(problem: &Problem<Plan>, system: &System, state: &mut State) {
    let Some(rough) = &system.rough else {
        return;
    };
    let films = system.films(state);
    let [i, j] = system.grid.centre();
    let centre = films[system.grid.index(i, j)];
    let lowest = films.into_iter().fold(centre, f64::min);
    let least = rough.least_start();
    let missing = (problem.start_film - centre).max(least - lowest);
    state.separation += missing.max(0.0);
    system.settle(state);
}

/// Takes pressures and contents of a similar solution on the same first grid, and its film at the centre.
fn start_from(system: &System, state: &mut State, similar: &Level) {
    if similar.system.grid != system.grid {
        return;
    }
    *state = similar.state.clone();
    let [i, j] = system.grid.centre();
    let centre = system.grid.index(i, j);
    state.separation += similar.films[centre] - system.films(state)[centre];
}

/// Relative errors of the films of a level, from those before.
fn film_errors(stats: &[LevelStats]) -> [f64; 2] {
    let mut newest = stats.iter().rev().map(|level| &level.figures);
    let of_grids = [(); 3].map(|()| newest.next());
    let values = |figure| gap_of(of_grids, figure);
    let settled = is_settled(values(Figure::FilmMinimum));
    [Figure::FilmCentral, Figure::FilmMinimum].map(|figure| {
        let values = values(figure);
        let here = values[0].unwrap_or(f64::NAN);
        match bar(values, settled, Slowest::OF_FILMS) {
            Some(error) if here > 0.0 => error / here,
            _ => f64::INFINITY,
        }
    })
}

impl FiniteVolumes {
    /// Solves a problem from the dry contact.
    ///
    /// # Errors
    /// When it does not converge, or the user wants to stop.
    pub fn solve(
        self,
        problem: &Problem<Plan>,
        observer: &mut dyn Observer,
    ) -> Result<Volumes, SolveError> {
        self.solve_from(problem, None, observer)
    }

    /// Solves a problem from a solution of a similar one on the same first grid. Finer grids start from the grid before: a solution of the other problem there is no nearer, and Newton's
    /// method ended with mass balances open by 5 %.
    ///
    /// # Errors
    /// As [`FiniteVolumes::solve`].
    pub fn solve_from(
        self,
        problem: &Problem<Plan>,
        similar: Option<&Volumes>,
        observer: &mut dyn Observer,
    ) -> Result<Volumes, SolveError> {
        let [mut h, _] = first_cells(problem);
        let mut found = Volumes {
            levels: Vec::new(),
            stats: Vec::new(),
            stopped: false,
            edge_effects: [0.0; 2],
            balance_error: f64::NAN,
        };
        let most = problem.plan.max_unknowns;
        let least = problem.plan.least_grids[usize::from(problem.shape.is_line())];
        let mut given_up = f64::NAN;
        // Grids before the first one without convergence, where they are an answer.
        let mut answer = None;
        for n in 0..problem.plan.most_grids {
            let clock = Instant::now();
            let first = found.levels.first().map(|level| &level.system.grid);
            let grid = grid(problem, h, first);
            let unknowns = grid
                .nodes()
                .filter(|[i, j]| grid.is_unknown(*i, *j))
                .count();
            if unknowns > most && n >= LEAST_GRIDS {
                break;
            }
            observer.grid(n, unknowns);
            let deflection = convolution(problem, &grid);
            let (mut system, mut state) = match found.levels.last_mut() {
                None => {
                    let mut system = first_system(problem, grid, deflection);
                    let mut state = first_state(problem, &system);
                    if let Some(beyond) = Beyond::of(problem, &system.grid) {
                        beyond.note(&problem.shape, &mut system, &mut state);
                        beyond.start(&problem.shape, &system, &mut state);
                    }
                    (system, state)
                }
                Some(before) => refined(problem, before, grid, deflection),
            };
            if let (0, Some(similar)) = (n, similar.and_then(|similar| similar.levels.first())) {
                start_from(&system, &mut state, similar);
            }
            let rounds = Rounds::new(problem, problem.plan.heat);
            let start =
                (rounds.as_ref()).map(|rounds| rounds.start(&system, found.levels.last(), None));
            if let (Some(rounds), Some((_, temperatures)), true) = (&rounds, &start, n > 0) {
                rounds.warm_up(&mut system, &state, temperatures);
            }
            let operator = clock.elapsed().as_secs_f64();
            let begun = problem.shape.is_line().then(|| state.clone());
            let mut info = solve_on(problem, &mut system, &mut state, n, observer)?;
            let mut warm = None;
            if let (Some(rounds), Some(start), true) = (&rounds, start, info.converged) {
                let again =
                    |system: &mut System, state: &mut State, observer: &mut dyn Observer| {
                        solve_on(problem, system, state, n, observer)
                    };
                match rounds.run(
                    (n, problem.plan.target_error, n + 1 < LEAST_GRIDS),
                    (&mut system, &mut state),
                    start,
                    again,
                    observer,
                ) {
                    Ok((found, infos)) => {
                        info = infos.into_iter().fold(info, NewtonInfo::and);
                        warm = Some(found);
                    }
                    Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                    Err(error) if found.levels.len() < LEAST_GRIDS => return Err(error),
                    Err(_) => info.converged = false,
                }
            }
            let mut newest = found.stats.iter().rev().take(BAR_GRIDS);
            let has_answer = found.levels.len() >= LEAST_GRIDS && newest.all(|l| l.converged);
            if !info.converged && has_answer {
                answer = answer.or(Some(found.levels.len()));
            }
            if let (Some(begun), false, true) = (begun, info.converged, n + BAR_GRIDS < least) {
                // Too coarse for the film: the next grid starts from the same state.
                state = begun;
                given_up = info.change;
            } else if !info.converged {
                if let Some(n) = answer {
                    found.levels.truncate(n);
                    found.stats.truncate(n);
                    if let Some(before) = found.levels.last_mut() {
                        before.patch = None;
                    }
                    found.stopped = true;
                    break;
                }
                return Err(SolveError::GridNotConverged {
                    level: n,
                    iterations: info.iterations,
                    change: info.change,
                    has_reliefs: problem.shape.gap.has_reliefs(),
                });
            }
            found.levels.push(Level {
                films: system.films(&state),
                system,
                state,
                patch: None,
                contents: OnceLock::new(),
                warm,
            });
            check_ends(problem, &found.levels)?;
            let cells = found.levels[n].system.grid.n_nodes();
            let [assembly, factorisation, krylov] = info.seconds;
            let heat = (found.levels[n].warm.as_ref()).map_or(0.0, |warm| warm.effort.seconds);
            let known = operator + assembly + factorisation + krylov + heat;
            found.stats.push(LevelStats {
                seconds: Timings {
                    operator,
                    assembly,
                    factorisation,
                    krylov,
                    heat,
                    other: clock.elapsed().as_secs_f64() - known,
                    ..Timings::default()
                },
                ..stats(problem, &found.levels, info, [cells, unknowns])
            });
            let [central, minimum] = film_errors(&found.stats);
            let is_fine = h <= problem.plan.largest_cell;
            if central.max(minimum) <= problem.plan.target_error && n + 1 >= least && is_fine {
                break;
            }
            h *= 0.5;
        }
        // All figures of the grids that the error bars use; these must be solutions.
        let n = found.levels.len();
        let first = n.saturating_sub(BAR_GRIDS);
        if let Some(l) = (first..n).find(|l| !found.stats[*l].converged) {
            return Err(SolveError::GridNotConverged {
                level: l,
                iterations: found.stats[l].newton_iterations,
                change: given_up,
                has_reliefs: problem.shape.gap.has_reliefs(),
            });
        }
        for l in first..n {
            found.stats[l].figures = figures(problem, &found.levels[..=l]);
        }
        found.edge_effects = effects(problem, &found.levels)?;
        found.balance_error = (found.levels.last()).map_or(f64::NAN, |level| {
            balance_error(&level.system, &level.system.linearise(&level.state))
        });
        Ok(found)
    }
}

/// Smallest relative errors reported for the central film and for all other figures. Where the flow crosses the grid at an angle, contents spread over a cell to
/// the sides: a first-order error in addition to the second-order one, which may have the other sign. Measured on a ball whose grid is turned: up to
/// a fifth of a cell in the central film, up to one in the minimum film and the friction at the walls. With heat, the tolerance of the film-heat coupling.
pub fn least_shares(problem: &Problem<Plan>, cell: f64, warm: bool) -> [f64; 2] {
    let is_straight = problem.shape.zone.turn.is_none() && problem.entrainment.spin == 0.0;
    let of_arrival = match Arrival::of(problem) {
        Arrival::Layer(_) if !is_straight => [0.25 * cell, cell],
        _ => [0.0; 2],
    };
    let of_rounds = match warm {
        true => problem.plan.heat.in_force(problem.plan.target_error),
        false => 0.0,
    };
    of_arrival.map(|share| share.max(of_rounds))
}

/// Relative error of central and minimum film over the remaining error of the film at the ridge where Newton's method ends (measured: see [`Ends::of`]). No figure is more accurate, however
/// close those of the grids are.
pub(super) const RIDGE_ERROR_SHARE: f64 = 0.02;

/// Share of the central film below which the ends of a roller count as without film, and the grids needed to decide it: coarse ones have films below zero at steep ends.
const NO_FILM: f64 = 0.02;
const GRIDS_OF_ENDS: usize = 6;

/// Whether the contact of a roller runs over its end, as the last two grids have found.
///
/// # Errors
/// If it does: the pressure is zero there, and the surfaces touch.
fn check_ends(problem: &Problem<Plan>, levels: &[Level]) -> Result<(), SolveError> {
    // Between rough surfaces asperities bear the pressure there.
    let is_smooth_roller = problem.shape.zone.roller.is_some() && problem.rough.is_none();
    if !is_smooth_roller || levels.len() < GRIDS_OF_ENDS {
        return Ok(());
    }
    let at_end = |n: usize| {
        let levels = &levels[..n];
        let (h_c, lowest) = (central(levels), lowest(levels)?);
        let (h_m, [_, y]) = (lowest.film, lowest.place);
        let rows = levels[n - 1].system.grid.rows.as_ref()?;
        let presses_in = (rows.ends().iter()).any(|end| (end - y).abs() < rows.step(RING));
        (presses_in && h_m < NO_FILM * h_c).then_some((y, h_m))
    };
    let n = levels.len();
    match at_end(n - 1).and(at_end(n)) {
        None => Ok(()),
        Some((y, film)) => Err(SolveError::EndCarries {
            place: y * problem.scales.length,
            film: film * problem.scales.film,
        }),
    }
}

/// Effort and films of the last grid.
fn stats(
    problem: &Problem<Plan>,
    levels: &[Level],
    info: NewtonInfo,
    [cells, unknowns]: [usize; 2],
) -> LevelStats {
    let mut figures = Figures::default();
    note_films(&mut figures, problem, levels);
    LevelStats {
        converged: info.converged,
        n_body_cells: 0,
        n_contact_elements: cells,
        n_pressure_dofs: unknowns,
        n_displacement_dofs: 0,
        n_contact_dofs: cells,
        pressure_order: 1,
        role: Role::Final,
        newton_iterations: info.iterations,
        krylov_iterations: info.krylov_iterations,
        factorisations: info.iterations,
        figures,
        seconds: Timings::default(),
    }
}

impl Volumes {
    /// Figures with error bars, SI.
    pub fn measured(&self, problem: &Problem<Plan>) -> Measured {
        let mut newest = self.stats.iter().rev().map(|level| &level.figures);
        let of_grids = [(); 3].map(|()| newest.next());
        let finest = self.levels.last();
        let cell = finest.map_or(0.0, |level| level.system.grid.spacing[0]);
        let warm = finest.is_some_and(|level| level.warm.is_some());
        let [central, minimum] = self.edge_effects;
        let of_edges = [central, central.max(minimum)];
        let least = least_shares(problem, cell, warm);
        let of_end = RIDGE_ERROR_SHARE * problem.plan.newton.ends.film;
        let least = [0, 1].map(|i: usize| least[i].max(of_edges[i]).max(of_end));
        let measured = Measured {
            figures: of_grids[0].copied().unwrap_or_default(),
            bars: bars(of_grids, cell * problem.scales.length, least),
            half_width: problem.scales.length,
        };
        let sizes = sizes(problem);
        let measured = measured.without_rounding(&sizes).within_limits(&sizes);
        match problem.shape.symmetry {
            Symmetry::Half => measured.with_mirrored_end(),
            Symmetry::Full => measured,
        }
    }
}
