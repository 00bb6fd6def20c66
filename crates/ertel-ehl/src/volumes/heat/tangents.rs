//! Derivatives of film and heat of a grid by an input.
//!
//! ```text
//!   ẋ = (Ẇ, Ṫ) of one input:     ẋ = g + G ẋ        one round of film and heat as in [`super::rounds`], by the input and by ẋ itself
//!
//!   ∂F/∂q q̇ = −(∂F/∂W Ẇ + ∂F/∂θ)                   film: pressures and separation at fixed temperatures (W of [`super::warmth`])
//!   Ṫ ← Ṫ − (∂R/∂T)⁻¹ (∂R/∂T Ṫ + ∂R/∂q q̇ + ∂R/∂θ)    heat of film and bodies
//!   Ẇ ← ∂W/∂q q̇ + ∂W/∂T Ṫ + ∂W/∂θ
//! ```
//! Products with derivatives are differences from the solution, and include every effect of an input. Krylov's method solves for ẋ instead of
//! further rounds, and its subspace is reused for other inputs ([`Recycled`]). Farther from a point contact than `NEAR` the film hardly heats up: there only the temperatures
//! change, not the effects of shear thinning and heating.

use ertel_fem::linear::gmres::{GmresParams, dot};
use ertel_fem::linear::recycled::Recycled;
use std::sync::OnceLock;

use super::columns::{Columns, Films};
use super::flow::Flow;
use super::rounds::{Rounds, lacking, largest_rise};
use super::temperatures::{Bodies, Temperatures, change, column, missing, note_flux};
use super::temperatures::{Effort, Warm};
use super::transport::{Sweeps, Transport};
use super::warm_up;
use super::warmth::Warmth;
use crate::engine::sensitivity::NoDerivative;
use crate::film::Nodal;
use crate::forms::energy::Heat;
use crate::volumes::level::Level;
use crate::volumes::step::{Equation, Inverse};
use crate::volumes::system::{Linearised, State, System};

/// Tolerance of ẋ: for squalane on glass, derivatives differ from those with a tenth of it and a hundredth of [`OF_WALLS`] by less than 4e-4 of the largest. The first inputs on the coarsest grid of a roller take more than 40 iterations; later ones reuse their directions.
const COUPLED: GmresParams = GmresParams {
    tolerance: 1e-4,
    max_iterations: 150,
    twice: false,
};

/// Tolerance of the temperatures in a round: the contributions of an input and of ẋ to the residual need the same inverse, or the fixed point changes. With 1e-2
/// the derivatives of the central film differed from those of whole solves by 2 % of the largest.
const OF_WALLS: GmresParams = GmresParams {
    tolerance: 1e-4,
    max_iterations: 80,
    twice: false,
};

/// Sweeps of the temperatures on patches and on lines: Krylov's method resolves the rest where the film recirculates. The recirculating inlets of lines are so long that after two sweeps
/// 150 directions of ẋ are not enough; with sixteen, all inputs of a line together took 71 to 148 directions on a grid, with 60 sweeps 64 to 134.
const SWEEPS: [usize; 2] = [2, 16];

/// Step of differences along ẋ, over its largest part, in shares of warmth and of the largest rise of the temperature.
const STEP: f64 = 1e-5;

/// Parts of ẋ and q̇ that are rounding.
const ROUNDING: f64 = 1e-11;

/// Half-widths from the centre of a point contact, in the plane in which the zone is the unit circle, within which stress and heat are evaluated again. With squalane and with glycerol
/// on glass the exponents of the films over speed differ from those without a limit by 0.0012, with 2 half-widths by 0.006; the run with squalane took 39 CPU s with 2, 57 with 4 and 63
/// without a limit. The warm inlet of a line is longer: there 4 half-widths leave 0.007 and 2 leave 0.04. Lines and rollers have no limit.
const NEAR: f64 = 4.0;

/// Film and heat of a grid with an input a little above its value, or at the solution.
pub struct WarmSide<'a> {
    /// Its heat.
    pub rounds: Rounds<'a>,
    /// The film equation.
    pub system: System,
    /// Pressures.
    pub state: State,
    /// Bodies.
    pub bodies: Bodies,
    /// Temperatures.
    pub temperatures: Temperatures,
    /// Rise of their means over those of the solution, K, by the inlet temperatures of bodies and lubricant.
    above: f64,
}

impl<'a> WarmSide<'a> {
    /// The solution itself.
    pub fn own(rounds: Rounds<'a>, level: &Level, warm: &Warm) -> WarmSide<'a> {
        WarmSide {
            rounds,
            system: level.system.clone(),
            state: level.settled(),
            bodies: warm.bodies.clone(),
            temperatures: warm.temperatures.clone(),
            above: 0.0,
        }
    }

    /// With the temperatures of the solution where they are unknown, and those of this side beyond; `before` is this side on the grid before. Where bodies and lubricant come warmer than those of the
    /// solution with `heat`, all its temperatures are raised with them: the remaining change is small compared with it.
    pub fn new(
        rounds: Rounds<'a>,
        (mut system, state): (System, State),
        before: Option<&Level>,
        (level, warm): (&Level, &Warm),
        heat: &Heat,
    ) -> WarmSide<'a> {
        let (bodies, mut temperatures) = rounds.start(&system, before, Some(&warm.bodies));
        let (own, f) = (&warm.temperatures, warm.temperatures.n_nodes());
        let [of_side, of_own] = [rounds.heat, heat].map(|heat| column(heat, f));
        let raised: Nodal = std::array::from_fn(|m| of_side[m] - of_own[m]);
        let above = system
            .fluid
            .nodes()
            .map_or(0.0, |nodes| nodes.mean(&raised));
        system.warmth = (level.system.warmth.iter())
            .map(|warmth| warmth.warmer(above))
            .collect();
        for [i, j] in system.grid.nodes() {
            if system.grid.is_unknown(i, j) {
                let k = system.grid.index(i, j);
                let nodes = own.film[k * f..][..f].iter().zip(&raised);
                for (t, (own, raised)) in temperatures.film[k * f..][..f].iter_mut().zip(nodes) {
                    *t = own + raised;
                }
                for (flux, own) in temperatures.flux.iter_mut().zip(&own.flux) {
                    flux[k] = own[k];
                }
            }
        }
        WarmSide {
            rounds,
            system,
            state,
            bodies,
            temperatures,
            above,
        }
    }

    /// Updates it to its solution. Heat made and carried off stays that of the neighbouring solution `warm`.
    fn into_level(mut self, by: &Moved, wetted: &[bool], rise: f64, warm: &Warm) -> Level {
        self.state.moved(&by.film, 1.0, wetted);
        self.system.settle(&mut self.state);
        let (of_warmth, of_temperatures) = by.parts(&self.system);
        move_warmth(&mut self.system, of_warmth, 1.0, rise);
        let mut temperatures = self.temperatures;
        add(&mut temperatures.film, of_temperatures, rise);
        for (flux, by) in temperatures.flux.iter_mut().zip(&by.flux) {
            add(flux, by, 1.0);
        }
        Level {
            films: self.system.films(&self.state),
            warm: Some(Warm {
                bodies: self.bodies,
                temperatures,
                account: warm.account.clone(),
                effort: Effort::default(),
            }),
            system: self.system,
            state: self.state,
            patch: None,
            contents: OnceLock::new(),
        }
    }
}

fn move_warmth(system: &mut System, parts: &[f64], share: f64, rise: f64) {
    for (warmth, by) in (system.warmth.iter_mut()).zip(parts.chunks_exact(Warmth::PARTS)) {
        *warmth = warmth.plus(by, share, rise);
    }
}

fn add(values: &mut [f64], by: &[f64], share: f64) {
    for (value, by) in values.iter_mut().zip(by) {
        *value += share * by;
    }
}

/// Derivatives that a round updates.
struct Moved {
    /// q̇: pressures and separation.
    film: Vec<f64>,
    /// ẋ: parts of the warmth of all nodes, then temperatures over the largest rise.
    x: Vec<f64>,
    /// Heat into both bodies.
    flux: [Vec<f64>; 2],
}

impl Moved {
    fn parts(&self, system: &System) -> (&[f64], &[f64]) {
        self.x.split_at(Warmth::PARTS * system.grid.n_nodes())
    }

    fn add(&mut self, other: &Moved, share: f64) {
        add(&mut self.film, &other.film, share);
        add(&mut self.x, &other.x, share);
        for (flux, by) in self.flux.iter_mut().zip(&other.flux) {
            add(flux, by, share);
        }
    }
}

/// A grid at the solution, and how inputs are solved for there.
struct Coupled<'a, 'p> {
    own: &'a WarmSide<'a>,
    at: &'a Linearised,
    equation: &'a Equation<'a>,
    inverse: Inverse<'a, 'p>,
    /// Nodes near the contact.
    near: Vec<bool>,
    /// The energy equation, its residual and that of the walls.
    columns: &'a Columns,
    transport: &'a Transport<'a>,
    residual: Vec<f64>,
    walls: [Vec<f64>; 2],
    /// Heat into both bodies, and warmth, at the solution.
    flux: [Vec<f64>; 2],
    warmth: Vec<Warmth>,
    /// Largest rise of the temperature, K: that by which ẋ counts temperatures.
    rise: f64,
    /// Directions of the film equation, and how exactly it is solved.
    films: Recycled,
    of_films: GmresParams,
    /// Directions of the equations of the walls.
    heats: Recycled,
}

/// Solutions a little above each input on a grid, the first or a later one, whose solution is `own` with the heat `warm`; `None` for an input without effect on the first.
///
/// # Errors
/// Of each input: when its linear equations are not solved.
pub fn solve<'a>(
    (own, warm): (&WarmSide, &Warm),
    (at, equation, inverse): (&Linearised, &Equation, Inverse),
    (of_films, is_first): (GmresParams, bool),
    inputs: impl Iterator<Item = Option<WarmSide<'a>>>,
) -> Vec<Option<Result<Level, NoDerivative>>> {
    let of = own.rounds.film_heat(&own.system);
    let grid = &own.system.grid;
    let films: Vec<f64> = at.nodes.iter().map(|node| node.film).collect();
    let temperature = &own.temperatures.film;
    let columns = Columns::new(
        &of,
        &Films {
            pressure: own.state.oil(),
            rubbing: &own.system.rubbing(&own.state, own.rounds.heat),
            film: &films,
            missing: &lacking(&own.system, &own.state, at),
            temperature,
            held: &[],
            pressure_rate: &[],
        },
    );
    let transport = Transport::new(&of, &columns, &at.faces, temperature);
    let residual = Flow::new(&of, &columns, &at.faces).residual(temperature);
    let mut heated = own.temperatures.clone();
    note_flux(&residual, transport.unknown(), of.nodes(), &mut heated);
    let near = grid.nodes().map(|[i, j]| {
        let [x, y] = grid.on_axes(i, j);
        match &grid.rows {
            None if grid.is_line() => true,
            None => x.hypot(y * grid.spacing[0] / grid.spacing[1]) < NEAR,
            Some(_) => !grid.is_end(j),
        }
    });
    let mut coupled = Coupled {
        near: near.collect(),
        columns: &columns,
        transport: &transport,
        walls: missing(grid, &own.bodies, of.nodes(), &heated),
        residual,
        flux: heated.flux,
        warmth: warm_up::warmth(&own.system, own.state.oil(), &films, temperature),
        rise: largest_rise(&own.temperatures, own.rounds.heat),
        own,
        at,
        equation,
        inverse,
        films: Recycled::default(),
        of_films,
        heats: Recycled::default(),
    };
    let mut directions = (Recycled::default(), Vec::new());
    inputs
        .map(|side| {
            coupled
                .level((side?, is_first), &mut directions, warm)
                .transpose()
        })
        .collect()
}

impl Coupled<'_, '_> {
    /// The solution above an input; `None` for an input without effect. The rounds of all directions of ẋ so far are kept.
    fn level(
        &mut self,
        (side, is_first): (WarmSide, bool),
        (directions, rounds): &mut (Recycled, Vec<Moved>),
        warm: &Warm,
    ) -> Result<Option<Level>, NoDerivative> {
        let n = Warmth::PARTS * self.near.len() + self.own.temperatures.film.len();
        let mut moved = self.round(&side, &vec![0.0; n], 1.0)?;
        let size = dot(&moved.x, &moved.x).max(dot(&moved.film, &moved.film));
        // An input without effect on the first grid has none on the others.
        if is_first && size < ROUNDING * ROUNDING {
            return Ok(None);
        }
        if !warm.effort.settled {
            // Nodes whose temperatures have not converged have no derivatives; the next grids compute those that count.
            moved.x.fill(0.0);
            moved.flux.iter_mut().for_each(|flux| flux.fill(0.0));
            return Ok(Some(side.into_level(
                &moved,
                &self.at.wetted,
                self.rise,
                warm,
            )));
        }
        let mut failed = None;
        let own = self.own;
        let apply = |x: &[f64], y: &mut [f64]| {
            let largest = x.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            match self.round(own, x, STEP / largest) {
                Ok(round) => {
                    for ((y, x), by) in y.iter_mut().zip(x).zip(&round.x) {
                        *y = x - by;
                    }
                    rounds.push(round);
                }
                Err(error) => failed = Some(error),
            }
        };
        let solved = directions.solve(apply, |_| (), &moved.x, &mut vec![0.0; n], COUPLED);
        // A direction that is only rounding is not kept.
        rounds.truncate(directions.shares().len());
        if let Some(error) = failed {
            return Err(error);
        }
        solved.map_err(|_| NoDerivative::LinearSolver)?;
        for (round, share) in rounds.iter().zip(directions.shares()) {
            moved.add(round, *share);
        }
        Ok(Some(side.into_level(
            &moved,
            &self.at.wetted,
            self.rise,
            warm,
        )))
    }

    /// A round by the difference of a side from the solution, and by `x` over a step.
    fn round(&mut self, side: &WarmSide, x: &[f64], step: f64) -> Result<Moved, NoDerivative> {
        let n = self.near.len();
        let (of_warmth, of_temperatures) = x.split_at(Warmth::PARTS * n);
        let own = self.own;
        let slopes = |from: &[f64], to: &[f64]| -> Vec<f64> {
            from.iter()
                .zip(to)
                .map(|(from, to)| (to - from) / step)
                .collect()
        };
        // Film.
        let mut system = side.system.clone();
        move_warmth(&mut system, of_warmth, step, self.rise);
        let mut state = side.state.clone();
        let mut at = system.linearise_nearby(&state, self.at, &self.near);
        let mut rows = system.rows_between(self.at, self.at, &at);
        rows.iter_mut().for_each(|row| *row /= step);
        let load = (at.missing_load - self.at.missing_load) / step;
        let right = self.equation.right(&rows, load);
        let mut film = vec![0.0; n + 1];
        let (equation, inverse) = (self.equation, &mut self.inverse);
        let apply = |x: &[f64], y: &mut [f64]| equation.apply(x, y);
        (self.films)
            .solve(
                apply,
                |r| inverse.solve(r),
                &right,
                &mut film,
                self.of_films,
            )
            // The tolerance of a right side at rounding level is that level.
            .map_or_else(
                |error| match error.residual * dot(&right, &right).sqrt() < ROUNDING {
                    true => Ok(()),
                    false => Err(NoDerivative::LinearSolver),
                },
                |_| Ok(()),
            )?;
        state.moved(&film, step, &self.at.wetted);
        system.settle(&mut state);
        own.system.move_on(&mut at, self.at, &film, step);
        // Heat.
        let mut temperatures = side.temperatures.clone();
        add(&mut temperatures.film, of_temperatures, step * self.rise);
        let of = side.rounds.film_heat(&system);
        let films: Vec<f64> = at.nodes.iter().map(|node| node.film).collect();
        let moved = Films {
            pressure: state.oil(),
            rubbing: &system.rubbing(&state, side.rounds.heat),
            film: &films,
            missing: &lacking(&system, &state, &at),
            temperature: &temperatures.film.clone(),
            held: &[],
            pressure_rate: &[],
        };
        let columns = (self.columns).nearby(&of, &moved, &own.temperatures.film, &self.near);
        let flow = Flow::new(&of, &columns, &at.faces);
        let residual = flow.residual(&temperatures.film);
        note_flux(
            &residual,
            self.transport.unknown(),
            of.nodes(),
            &mut temperatures,
        );
        let walls = missing(&system.grid, &side.bodies, of.nodes(), &temperatures);
        let heats = &mut self.heats;
        let by_krylov =
            |apply: &dyn Fn(&[f64], &mut [f64]), right: &[f64], walls: &mut [f64]| match heats
                .solve(apply, |_| (), right, walls, OF_WALLS)
            {
                Ok(info) => info.iterations,
                Err(error) => error.iterations,
            };
        let change = change(
            self.transport,
            &own.system.grid,
            &own.bodies,
            (
                &slopes(&residual, &self.residual),
                &[0, 1].map(|b: usize| slopes(&self.walls[b], &walls[b])),
            ),
            Sweeps::Count(SWEEPS[usize::from(own.system.grid.is_line())]),
            by_krylov,
        );
        add(&mut temperatures.film, &change.temperature, step);
        let mut flux = [0, 1].map(|b: usize| slopes(&self.flux[b], &temperatures.flux[b]));
        for (flux, by) in flux.iter_mut().zip(&change.flux) {
            add(flux, by, 1.0);
        }
        // Effect on the film.
        let rebuilt = warm_up::at(&system, (state.oil(), &films), &temperatures.film, |k| {
            self.near[k]
        });
        let mean = |temperatures: &Temperatures, k: usize| {
            let nodes = of.fluid.nodes();
            nodes.map_or(0.0, |nodes| {
                nodes.mean(&temperatures.profile(k).temperature)
            })
        };
        let mut next = Vec::with_capacity(x.len());
        for (k, rebuilt) in rebuilt.iter().enumerate() {
            let before = &self.warmth[k];
            let by_heat = || before.warmer(mean(&temperatures, k) - mean(&own.temperatures, k));
            let rebuilt = rebuilt.unwrap_or_else(by_heat);
            next.extend(rebuilt.minus(&before.warmer(side.above), step, self.rise));
        }
        let further = of_temperatures.iter().zip(&change.temperature);
        next.extend(further.map(|(x, by)| x + by / self.rise));
        Ok(Moved {
            film,
            x: next,
            flux,
        })
    }
}
