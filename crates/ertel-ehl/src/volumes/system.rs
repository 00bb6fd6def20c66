//! The film equation on a grid, and its linearisation for Newton's method.
//!
//! ```text
//!   G_i = Σ F through the faces of node i / its area + ∂m_i/∂T,    P_i ≥ 0,  G_i ≥ 0,  P_i G_i = 0
//!   H = H_0 + G + δ_outer + K P,    ΣP dA = load of the grid
//! ```
//! Where the film has cavitated, P = 0 and the outflow exceeds the inflow; elsewhere they are equal. Between rough surfaces P is that of oil and
//! asperities, and the oil bears the rest p = P − p_a(H) ≥ 0, to which all of that applies ([`super::touching`]).

use std::sync::Arc;

use rayon::prelude::*;

use super::contents::{Arrival, Edges, distribute};
use super::deflection::Deflection;
use super::faces::{Face, Resistance, face};
use super::far_pressure::Beyond;
use super::grid::{Grid, slopes};
use super::heat::warmth::Warmth;
use super::node::Node;
use super::passing::Passing;
use super::rows::RING;
use super::storage::Storage;
use super::thinning::Thinned;
use super::touching::{Touch, parts, touching};
use crate::contact::Planar;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::mixed::Rough;

/// A film on a grid: data that do not change during a solve.
#[derive(Clone)]
pub struct System {
    /// The nodes.
    pub grid: Grid,
    /// Deflection by the pressures of the grid.
    pub convolution: Arc<Deflection>,
    /// Gap and deflection by pressures beyond the grid, at the nodes.
    pub gap: Vec<f64>,
    /// Load that the grid carries.
    pub load: f64,
    /// The gap beyond its edges, where the contact area does not end there.
    pub beyond: Option<Beyond>,
    /// Oil that enters along its edges where the film has cavitated.
    pub edges: Edges,
    /// The fluid.
    pub fluid: FilmFluid,
    /// λ.
    pub lambda: f64,
    /// ū.
    pub entrainment: Planar,
    /// How oil arrives.
    pub arrival: Arrival,
    /// Temperature-dependent film coefficients at the nodes; none where there is one temperature.
    pub warmth: Vec<Warmth>,
    /// Mass of the film at earlier instants; none in steady contacts.
    pub storage: Option<Storage>,
    /// The force balance of the pressures.
    pub balance: Balance,
    /// Rough surfaces, whose asperities bear a part of the pressures.
    pub rough: Option<Rough>,
}

/// The force balance: s_p (load − ∫P) + s_h H_0 + g = 0. A steady contact bears its load; in time a body may move by its inertia, or as it is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// s_p.
    pub load: f64,
    /// s_h.
    pub separation: f64,
    /// g.
    pub given: f64,
}

impl Balance {
    /// The load.
    pub const LOAD: Balance = Balance {
        load: 1.0,
        separation: 0.0,
        given: 0.0,
    };

    /// The missing oil.
    fn missing(&self, load: f64, separation: f64) -> f64 {
        self.load * load + self.separation * separation + self.given
    }
}

/// Pressures and separation.
#[derive(Clone, Debug)]
pub struct State {
    /// P at all nodes.
    pub pressure: Vec<f64>,
    /// P of the oil at all nodes; none between smooth surfaces, where it is all of P.
    pub oil: Vec<f64>,
    /// H_0.
    pub separation: f64,
    /// Where the film had not broken after the last step.
    pub wetted: Vec<bool>,
    /// Oil that the flow carries away from each node where the film has cavitated, infinite where the gap is full; none where all gaps are.
    pub contents: Vec<f64>,
}

impl State {
    /// P of the oil.
    pub fn oil(&self) -> &[f64] {
        match self.oil.is_empty() {
            true => &self.pressure,
            false => &self.oil,
        }
    }

    /// Sets the pressure of a node to that of oil alone.
    pub fn give(&mut self, k: usize, pressure: f64) {
        self.pressure[k] = pressure;
        if let Some(oil) = self.oil.get_mut(k) {
            *oil = pressure;
        }
    }

    /// Moves on by some of the changes of pressures, where the film is wetted, and of the separation. Where the film has cavitated the pressure is exactly zero, without the
    /// residual of the linear solver: the next grid would take that for a filled gap. Between rough surfaces asperities press there; [`System::settle`] then
    /// gives the oil its part.
    pub fn moved(&mut self, changes: &[f64], share: f64, wetted: &[bool]) {
        let is_rough = !self.oil.is_empty();
        for (p, (change, wetted)) in self.pressure.iter_mut().zip(changes.iter().zip(wetted)) {
            if *wetted || is_rough {
                *p += share * change;
            }
        }
        self.separation += share * changes[wetted.len()];
    }
}

/// The equation at a state.
pub struct Linearised {
    /// Fields at the nodes.
    pub nodes: Vec<Node>,
    /// Asperities there, none between smooth surfaces.
    pub touching: Vec<Touch>,
    /// Shear thinning there, none for Newtonian films.
    pub thinned: Vec<Thinned>,
    /// Faces towards the next node along the first direction, and along the second.
    pub faces: [Vec<Face>; 2],
    /// G.
    pub outflow: Vec<f64>,
    /// Nodes whose pressure is solved for: unknown, and not where the film has broken.
    pub wetted: Vec<bool>,
    /// Contents for these pressures; none where all gaps are full.
    pub contents: Vec<f64>,
    /// How they change.
    pub passing: Passing,
    /// Residual of the force balance.
    pub missing_load: f64,
    /// c_0 of the storage, 0 where time does not count.
    pub storage_rate: f64,
}

impl Linearised {
    /// r at a node.
    pub(super) fn slack_at(&self, k: usize) -> f64 {
        self.touching.get(k).map_or(0.0, |of| of.slack)
    }

    /// r at all nodes with pressure unknown; `None` between smooth surfaces.
    pub(super) fn slack(&self) -> Option<Vec<f64>> {
        (!self.touching.is_empty()).then(|| self.touching.iter().map(|of| of.slack).collect())
    }

    /// Whether a node holds as much as its gap.
    fn is_full(&self, k: usize) -> bool {
        (self.contents.get(k)).is_none_or(|content| *content >= self.nodes[k].mass)
    }
}

/// Nodes, and rows of them, that a thread takes at a time.
const BATCH: usize = 1024;
const ROWS: usize = 8;

impl System {
    /// H at the nodes.
    pub fn films(&self, state: &State) -> Vec<f64> {
        let mut films = self.deflection(&state.pressure);
        for (film, gap) in films.iter_mut().zip(&self.gap) {
            *film += gap + state.separation;
        }
        films
    }

    /// Deflection by pressures of the grid.
    fn deflection(&self, pressure: &[f64]) -> Vec<f64> {
        self.convolution.apply(&self.grid.within_edges(pressure))
    }

    /// ∫P over the grid.
    pub fn integral(&self, pressure: &[f64]) -> f64 {
        let sum: f64 = (self.grid.nodes().zip(pressure))
            .map(|([i, j], p)| self.grid.share(i, j) * self.grid.length(1, j) * p)
            .sum();
        sum * self.grid.spacing[0]
    }

    /// The equation and its derivatives at a state.
    pub fn linearise(&self, state: &State) -> Linearised {
        self.linearise_by(state, |nodes| self.thinned(nodes, state.oil(), |_| true))
    }

    /// The same where it differs little from another state and system: shear thinning is evaluated again only at the nodes that are `near`.
    pub fn linearise_nearby(&self, state: &State, other: &Linearised, near: &[bool]) -> Linearised {
        self.linearise_by(state, |nodes| {
            let mut thinned = self.thinned(nodes, state.oil(), |k| near[k]);
            for (k, (own, other)) in thinned.iter_mut().zip(&other.thinned).enumerate() {
                if !near[k] {
                    *own = *other;
                }
            }
            thinned
        })
    }

    fn linearise_by(&self, state: &State, thinned: impl Fn(&[Node]) -> Vec<Thinned>) -> Linearised {
        let films = self.films(state);
        let pressures = [&state.pressure[..], state.oil()];
        let touching = touching(self.rough.as_ref(), &self.grid, pressures, &films);
        let nodes = self.nodes(state, &films, &touching, |_| true);
        let thinned = thinned(&nodes);
        let mut faces = [0, 1].map(|direction| self.faces(&nodes, &thinned, direction, |_| true));
        let grid = &self.grid;
        let stored = self.storage.as_ref().map(|storage| (storage, &nodes[..]));
        let contents = match state.contents.is_empty() {
            true => Vec::new(),
            false => distribute(grid, &mut faces, stored, &state.wetted, &state.contents),
        };
        let held = |k: usize| match contents.get(k) {
            Some(content) => content.min(nodes[k].mass),
            None => nodes[k].mass,
        };
        let mut outflow = self.balance(|direction, k| faces[direction][k].flux);
        self.store(&mut outflow, |k, storage| {
            storage.rate * held(k) + storage.past[k]
        });
        let fills = |k: usize| match contents.get(k) {
            Some(content) => content.is_infinite(),
            None => outflow[k] < 0.0,
        };
        let wetted: Vec<bool> = (grid.nodes().enumerate())
            .map(|(k, [i, j])| self.may_press(i, j) && (state.wetted[k] || fills(k)))
            .collect();
        let passing = match contents.is_empty() {
            true => Passing::default(),
            false => Passing::new(grid, &faces, &wetted, |k| match stored {
                Some((storage, nodes)) if contents[k] < nodes[k].mass => storage.rate,
                _ => 0.0,
            }),
        };
        Linearised {
            contents,
            passing,
            missing_load: {
                let missing = self.load - self.integral(&state.pressure);
                self.balance.missing(missing, state.separation)
            },
            storage_rate: self.storage.as_ref().map_or(0.0, |storage| storage.rate),
            nodes,
            touching,
            thinned,
            faces,
            outflow,
            wetted,
        }
    }

    /// Faces of full gaps around nodes where some are not; no others.
    pub fn faces_around(&self, state: &State, films: &[f64], full: &[bool]) -> [Vec<Face>; 2] {
        let nx = self.grid.n[0];
        let mut near = vec![false; full.len()];
        for k in (0..full.len()).filter(|k| !full[*k]) {
            // Fluxes depend on two nodes on either side.
            for reach in [0, 1, 2, nx, 2 * nx] {
                near[k.saturating_sub(reach)] = true;
                near[(k + reach).min(full.len() - 1)] = true;
            }
        }
        let pressures = [&state.pressure[..], state.oil()];
        let touching = touching(self.rough.as_ref(), &self.grid, pressures, films);
        let nodes = self.nodes(state, films, &touching, |k| near[k]);
        let thinned = self.thinned(&nodes, state.oil(), |k| near[k]);
        [0, 1].map(|direction| {
            let step = [1, nx][direction];
            self.faces(&nodes, &thinned, direction, |k| !full[k] || !full[k + step])
        })
    }

    /// The selected nodes.
    fn nodes(
        &self,
        state: &State,
        films: &[f64],
        touching: &[Touch],
        wanted: impl Fn(usize) -> bool + Sync,
    ) -> Vec<Node> {
        (state.oil().par_iter().zip(films).enumerate())
            .with_min_len(BATCH)
            .map(|(k, (p, film))| match touching.get(k) {
                _ if !wanted(k) => Node::default(),
                None => self.node(k, *p, *film),
                Some(of) => Node {
                    ln_passage: of.ln_passage,
                    ..self.node(k, *p, of.gap[0])
                },
            })
            .collect()
    }

    /// Shear thinning at the selected nodes.
    fn thinned(
        &self,
        nodes: &[Node],
        pressure: &[f64],
        wanted: impl Fn(usize) -> bool + Sync,
    ) -> Vec<Thinned> {
        if self.fluid.is_newtonian() {
            return Vec::new();
        }
        let grid = &self.grid;
        let nx = grid.n[0];
        let of_node = |rule: &mut CrossFilm, k: usize| {
            if !wanted(k) {
                return Thinned::default();
            }
            let [i, j] = [k % nx, k / nx];
            let gradient = slopes(grid, pressure, i, j);
            let slide = self.fluid.slide().at(grid.place(i, j));
            let node = (&nodes[k], grid.spacing[0]);
            let slide = grid.turn.to_axes(slide);
            let warmth = self.warmth.get(k).map(|warmth| warmth.flow);
            Thinned::at(&self.fluid, node, gradient, slide, warmth, rule)
        };
        (0..nodes.len())
            .into_par_iter()
            .with_min_len(BATCH)
            .map_init(CrossFilm::default, of_node)
            .collect()
    }

    /// Whether a node is unknown and there may be pressure.
    fn may_press(&self, i: usize, j: usize) -> bool {
        let grid = &self.grid;
        grid.is_unknown(i, j)
            && !grid.is_end(j)
            && (self.arrival).may_press(grid.place(i, j)[0], grid.spacing[0])
    }

    /// The gap that flows at a distance H.
    #[inline]
    pub fn gap_at(&self, film: f64) -> f64 {
        self.rough.as_ref().map_or(film, |rough| rough.gap(film)[0])
    }

    /// ρ̄H at the nodes, of the gap that flows.
    pub fn masses(&self, state: &State, films: &[f64]) -> Vec<f64> {
        (state.oil().par_iter().zip(films).enumerate())
            .with_min_len(BATCH)
            .map(|(k, (p, h))| self.node(k, *p, self.gap_at(*h)).mass)
            .collect()
    }

    fn node(&self, k: usize, pressure: f64, film: f64) -> Node {
        let warmth = self.warmth.get(k);
        let point = match warmth {
            None => self.fluid.at(pressure),
            Some(warmth) => self.fluid.at_temperature(pressure, warmth.temperature),
        };
        let ([mut rho, mut rho_p, _], [mut mu, mut mu_p, _]) = (point.density, point.viscosity);
        if let Some(warmth) = warmth {
            (rho, rho_p) = (warmth.density * rho, warmth.density * rho_p);
            // Without shear thinning, the viscosity alone determines it.
            if self.fluid.is_newtonian() {
                (mu, mu_p) = (mu / warmth.flow[0], mu_p / warmth.flow[0]);
            }
        }
        Node {
            pressure,
            film,
            density: [rho, rho_p],
            ln_viscosity: [mu.ln(), mu_p / mu],
            mass: rho * film,
            mass_by: [rho_p * film, rho],
            ln_passage: [[0.0; 2]; 2],
        }
    }

    /// The selected faces from each node to the next one along a direction; none where no unknown node has them.
    fn faces(
        &self,
        nodes: &[Node],
        thinned: &[Thinned],
        direction: usize,
        wanted: impl Fn(usize) -> bool + Sync,
    ) -> Vec<Face> {
        let grid = &self.grid;
        let [nx, ny] = grid.n;
        let step = [1, nx][direction];
        let inner = grid.inner_rows();
        let (columns, rows) = match direction {
            0 => (RING - 1..nx - RING, inner),
            _ if grid.is_line() => return vec![Face::default(); grid.n_nodes()],
            _ => (RING..nx - RING, RING - 1..inner.end.min(ny - 1)),
        };
        let middle = [[0.5, 0.0], [0.0, 0.5]][direction];
        let mut faces = vec![Face::default(); grid.n_nodes()];
        let chunks = faces.par_chunks_mut(nx).enumerate().with_min_len(ROWS);
        chunks.for_each(|(j, faces)| {
            if !rows.contains(&j) {
                return;
            }
            for i in columns.clone() {
                let k = grid.index(i, j);
                if !wanted(k) {
                    continue;
                }
                let [x, y] = grid.on_axes(i, j);
                let at = [
                    x + middle[0] * grid.spacing[0],
                    y + middle[1] * grid.step(1, j),
                ];
                let velocity = grid
                    .turn
                    .to_axes(self.entrainment.at(grid.turn.to_motion(at)));
                let drift = match (self.warmth.get(k), self.warmth.get(k + step)) {
                    (Some(a), Some(b)) => 0.5 * (a.drift[direction] + b.drift[direction]),
                    _ => 0.0,
                };
                // No entrainment across the rows of a half.
                let u = match grid.half && direction == 1 {
                    true => 0.0,
                    false => velocity[direction] + drift,
                };
                let behind = (k + 2 * step).min(nodes.len() - 1);
                let beyond = [&nodes[k - step], &nodes[behind]];
                let spacing = grid.step(direction, j);
                let ends = [k, k + step];
                let resistance =
                    ends.map(|k| Resistance::new(&nodes[k], thinned.get(k), direction));
                let nodes = ends.map(|k| &nodes[k]);
                faces[i] = face(nodes, resistance, beyond, u, self.lambda, spacing);
            }
        });
        faces
    }

    /// Net outflow through the faces of each unknown node, over its area.
    fn balance(&self, through: impl Fn(usize, usize) -> f64 + Sync) -> Vec<f64> {
        let grid = &self.grid;
        let [nx, ny] = grid.n;
        let dx = grid.spacing[0];
        let mut sums = vec![0.0; grid.n_nodes()];
        let rows = sums.par_chunks_mut(nx).enumerate().with_min_len(ROWS);
        rows.for_each(|(j, sums)| {
            let dy = grid.length(1, j);
            for (i, sum) in sums.iter_mut().enumerate() {
                if !grid.is_unknown(i, j) {
                    continue;
                }
                let k = grid.index(i, j);
                let along = through(0, k) - through(0, k - 1);
                // Beyond the centreline of a half all is mirrored.
                let across = match grid.half && j + 1 == ny {
                    _ if grid.is_line() => 0.0,
                    true => -2.0 * through(1, k - nx),
                    false => through(1, k) - through(1, k - nx),
                };
                *sum = along / dx + across / dy;
            }
        });
        sums
    }

    /// Adds the storage at each unknown node to its balance.
    fn store(&self, balance: &mut [f64], stored: impl Fn(usize, &Storage) -> f64) {
        let Some(storage) = &self.storage else {
            return;
        };
        for ((k, [i, j]), sum) in self.grid.nodes().enumerate().zip(balance) {
            if self.grid.is_unknown(i, j) {
                *sum += stored(k, storage);
            }
        }
    }

    /// Change of G by changes of the pressures and of the separation; contents follow.
    pub fn change(&self, at: &Linearised, pressure: &[f64], separation: f64) -> Vec<f64> {
        self.change_by(at, pressure, &self.change_of_film(pressure, separation))
    }

    pub(super) fn change_of_film(&self, pressure: &[f64], separation: f64) -> Vec<f64> {
        let mut film = self.deflection(pressure);
        film.iter_mut().for_each(|h| *h += separation);
        film
    }

    /// Moves films and flows of `at`, which differs little from `own`, on by a share of changes of the pressures and of the separation at `own`.
    pub fn move_on(&self, at: &mut Linearised, own: &Linearised, changes: &[f64], share: f64) {
        let n = self.grid.n_nodes();
        let (pressure, separation) = (&changes[..n], changes[n]);
        let film = self.change_of_film(pressure, separation);
        let mut parts = parts(&own.touching, pressure, &film);
        if let (Some([oil, _]), true) = (&mut parts, share != 0.0) {
            // Oil of broken nodes is none, before and after.
            for (k, oil) in oil.iter_mut().enumerate() {
                *oil += (at.slack_at(k) - own.slack_at(k)) / share;
            }
        }
        let (pressure, film) = match &parts {
            None => (pressure, &film[..]),
            Some([oil, gap]) => (&oil[..], &gap[..]),
        };
        for (node, change) in at.nodes.iter_mut().zip(film) {
            node.film += share * change;
        }
        let through = self.change_through(own, pressure, film);
        for (direction, faces) in at.faces.iter_mut().enumerate() {
            // Those of unknown nodes.
            let of_own = own.faces[direction].iter().map(|face| face.by_pressure);
            let known = |by: &[f64; 2]| *by != [0.0; 2];
            for (k, (face, _)) in faces
                .iter_mut()
                .zip(of_own)
                .enumerate()
                .filter(|(_, (_, by))| known(by))
            {
                face.flux += share * through(direction, k);
            }
        }
    }

    /// Right sides of the linearised equation at `at` that lead from a neighbouring equation at the same pressures, `side`, to one of the same residual as `own`. Where
    /// the film has broken oil presses with nothing in both: changes of the asperities there change P alone.
    pub(super) fn rows_between(
        &self,
        at: &Linearised,
        own: &Linearised,
        side: &Linearised,
    ) -> Vec<f64> {
        let mut rows: Vec<f64> = (own.outflow.iter().zip(&side.outflow))
            .map(|(own, side)| own - side)
            .collect();
        let slack: Vec<f64> = (0..rows.len())
            .map(|k| side.slack_at(k) - own.slack_at(k))
            .collect();
        if !at.touching.is_empty() {
            let by_slack = self.change_of_oil(at, &slack, &vec![0.0; slack.len()]);
            rows.iter_mut()
                .zip(by_slack)
                .for_each(|(row, by)| *row -= by);
        }
        for ((row, wetted), slack) in rows.iter_mut().zip(&at.wetted).zip(slack) {
            *row = if *wetted { *row } else { -slack };
        }
        rows
    }

    /// The same by changes of pressures and films.
    pub(super) fn change_by(&self, at: &Linearised, pressure: &[f64], film: &[f64]) -> Vec<f64> {
        match parts(&at.touching, pressure, film) {
            None => self.change_of_oil(at, pressure, film),
            Some([oil, gap]) => self.change_of_oil(at, &oil, &gap),
        }
    }

    /// The same by changes of the pressures of the oil and of the gaps that flow.
    pub(super) fn change_of_oil(
        &self,
        at: &Linearised,
        pressure: &[f64],
        film: &[f64],
    ) -> Vec<f64> {
        let mut change = self.balance(self.change_through(at, pressure, film));
        self.store(&mut change, |k, storage| {
            if !at.is_full(k) {
                return 0.0;
            }
            let [by_pressure, by_film] = at.nodes[k].mass_by;
            storage.rate * (by_pressure * pressure[k] + by_film * film[k])
        });
        at.passing.follow(&mut change);
        change
    }

    /// Change of the flux through the faces.
    fn change_through<'a>(
        &'a self,
        at: &'a Linearised,
        pressure: &'a [f64],
        film: &'a [f64],
    ) -> impl Fn(usize, usize) -> f64 + Sync + 'a {
        let nx = self.grid.n[0];
        let mass: Vec<f64> = (at.nodes.iter().zip(pressure.iter().zip(film)))
            .map(|(node, (p, h))| node.mass_by[0] * p + node.mass_by[1] * h)
            .collect();
        let resistance = self.resistance_by_gradient(at, pressure);
        move |direction, k| {
            let face = &at.faces[direction][k];
            let step = [1, nx][direction];
            let next = k + step;
            let [uu, u, d] = face.by_mass;
            // Without entrainment the upstream node may be outside the grid.
            let entrained = match (face.by_mass == [0.0; 3], face.from_second) {
                (true, _) => 0.0,
                (_, false) => uu * mass[k - step] + u * mass[k] + d * mass[next],
                (_, true) => uu * mass[next + step] + u * mass[next] + d * mass[k],
            };
            face.by_pressure[0] * pressure[k]
                + face.by_pressure[1] * pressure[next]
                + face.by_film[0] * film[k]
                + face.by_film[1] * film[next]
                + entrained
                + match (resistance.get(k), resistance.get(next)) {
                    (Some(here), Some(there)) => {
                        let [a, b] = [here, there].map(|of| of[direction]);
                        face.by_resistance[0] * a[0]
                            + face.by_resistance[1] * b[0]
                            + face.by_oblique * (a[1] + b[1])
                    }
                    _ => 0.0,
                }
        }
    }

    /// Changes of l and c along both directions at the nodes as the gradient of the pressure changes, none where nothing thins.
    fn resistance_by_gradient(&self, at: &Linearised, pressure: &[f64]) -> Vec<[[f64; 2]; 2]> {
        let grid = &self.grid;
        let nx = grid.n[0];
        let of_node = |(k, thinned): (usize, &Thinned)| {
            let gradient = slopes(grid, pressure, k % nx, k / nx);
            let along = |[.., x, y]: [f64; 5]| x * gradient[0] + y * gradient[1];
            [0, 1].map(|d: usize| [-along(thinned.ln_flow[d]), along(thinned.oblique[d])])
        };
        (at.thinned.par_iter().enumerate())
            .with_min_len(BATCH)
            .map(of_node)
            .collect()
    }
}
