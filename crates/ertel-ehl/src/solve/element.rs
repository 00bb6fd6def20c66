//! Residual and Jacobian of the film equations on one element.

use ertel_fem::kernel as declare_kernel;
use ertel_fem::linear::dense::vectorised;
use ertel_fem::space::Affine;

use super::discretisation::Discretisation;
use super::state::{FilmConstants, State};
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, TemperatureProfile};
use crate::forms::dual::Dual;
use crate::forms::flow::{
    PointSliding, PointState, Properties, generalized, newtonian, pressure_stress, sliding_stress,
    thermal,
};
use crate::forms::reynolds::{ElementConstants, TestCoefficients, reynolds_point};

/// Sums for each pressure node in addition to the blocks: ∂R/∂H0, R, entrainment, and its share of ∫(τR)².
pub const N_SUMS: usize = 4;

/// Coefficients of a test function: W, W_x, W_y, ΔW, κW.
const N_TEST: usize = 5;

/// Lists of the pressure shape functions: those five and, where the flow needs them, W_xx, W_xy, W_yy.
const N_LISTS: usize = 8;

/// Quantities of the equation at a point: P, P_x, P_y, κP, H, H_x, H_y, and then ΔP in
/// Newtonian films, P_xx, P_xy, P_yy in others.
const NEWTONIAN: usize = 8;
const GENERALIZED: usize = 10;

/// Source term of the manufactured solutions.
type Source<'a> = Option<&'a (dyn Fn([f64; 3]) -> f64 + Sync)>;

/// [`Assembler::element`] for one size of lists.
type Kernel<'a> = fn(&Assembler<'a>, usize, &mut Element, &mut [f64], &mut [[f64; N_SUMS]]);

/// Everything that the elements of one assembly share.
pub struct Assembler<'a> {
    d: &'a Discretisation,
    fluid: &'a FilmFluid,
    constants: &'a FilmConstants,
    state: &'a State,
    source: Source<'a>,
    /// Share of the length over which a gap fills up.
    filling: f64,
    /// Share of the diffusion at a ridge.
    ridge: f64,
    kernel: Kernel<'a>,
}

/// Scratch memory of one element, by quadrature point.
#[derive(Default)]
pub struct Element {
    points: Vec<Point>,
    rule: CrossFilm,
    /// [`N_LISTS`] of each pressure node, lists padded with zeros.
    pressure: Vec<f64>,
    /// N, N_x, N_y of each deflection node, alike.
    deflection: Vec<f64>,
}

/// State at a quadrature point, then the integrand of the equation.
#[derive(Clone, Copy)]
struct Point {
    /// (X, Y).
    place: [f64; 3],
    /// P, P_x, P_y, κP, H, H_x, H_y, P_xx or ΔP, P_xy, P_yy.
    state: [f64; GENERALIZED],
    /// Coefficients of the test function.
    value: [f64; N_TEST],
    /// Their derivatives by the state.
    slopes: [[f64; GENERALIZED]; N_TEST],
    /// ρ̄Hū.
    entrainment: [f64; 2],
    /// τR.
    missed: f64,
}

impl<'a> Assembler<'a> {
    /// Assembles at a state.
    pub fn new(
        d: &'a Discretisation,
        fluid: &'a FilmFluid,
        constants: &'a FilmConstants,
        state: &'a State,
        source: Source<'a>,
    ) -> Assembler<'a> {
        // Loops of known length: nodes of an element, rounded up to whole vectors.
        let kernel = if fluid.is_newtonian() && d.heat.is_none() {
            kernel::<NEWTONIAN>(d)
        } else {
            kernel::<GENERALIZED>(d)
        };
        Assembler {
            d,
            fluid,
            constants,
            state,
            source,
            filling: 1.0,
            ridge: 1.0,
            kernel,
        }
    }

    /// The same where a gap fills up over a share of the length.
    #[must_use]
    pub fn filling_over(&self, share: f64) -> Assembler<'a> {
        Assembler {
            filling: share,
            ..*self
        }
    }

    /// The same without the diffusion at a ridge.
    #[must_use]
    pub fn without_ridge_diffusion(&self) -> Assembler<'a> {
        Assembler {
            ridge: 0.0,
            ..*self
        }
    }

    /// One element: `block` is overwritten with [∂R/∂P | ∂R/∂δ], `sums` with the rest, for each pressure node.
    pub fn element(
        &self,
        c: usize,
        element: &mut Element,
        block: &mut [f64],
        sums: &mut [[f64; N_SUMS]],
    ) {
        (self.kernel)(self, c, element, block, sums);
    }

    /// The same with lists of nodes padded to `N` and `M`, and `S` quantities at a point.
    fn padded<const N: usize, const M: usize, const S: usize>(
        &self,
        c: usize,
        element: &mut Element,
        block: &mut [f64],
        sums: &mut [[f64; N_SUMS]],
    ) {
        let d = self.d;
        let order = d.pressure.element.order();
        let oil_layer = d.contact.shape.inlet.layer().copied();
        let mut local =
            (self.constants).on_element(d.contact.cell(c), order, oil_layer, d.share_at_ridge(c));
        local.ridge_diffusion *= self.ridge;
        local.filling_length *= self.filling;
        element.points.clear();
        element.pressure.resize(d.rule.len() * N_LISTS * N, 0.0);
        element.deflection.resize(d.rule.len() * 3 * M, 0.0);
        vectorised(Interpolate::<N, M, S> {
            assembler: self,
            c,
            element,
        });
        for (q, point) in element.points.iter_mut().enumerate() {
            let source = self.source.map_or(0.0, |f| f(point.place));
            let rule = &mut element.rule;
            match &d.heat {
                None => vectorised(Integrand::<S> {
                    point,
                    fluid: self.fluid,
                    local: &local,
                    source,
                    rule,
                }),
                Some(heat) => {
                    let profile = heat.profile_at(d, self.state, c, q);
                    vectorised(ThermalIntegrand {
                        point,
                        fluid: self.fluid,
                        profile: &profile,
                        local: &local,
                        source,
                        rule,
                    });
                }
            }
        }
        vectorised(Integrate::<N, M, S> {
            assembler: self,
            c,
            element,
            block,
            sums,
        });
    }

    /// Shape functions and state at the quadrature points.
    #[inline(always)]
    fn interpolate<const N: usize, const M: usize, const S: usize>(
        &self,
        c: usize,
        element: &mut Element,
    ) {
        let (d, state) = (self.d, self.state);
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let map = &d.contact.maps[c];
        let metric = Metric::new(map);
        let mut pressures = [0.0; N];
        for (p, node) in pressures.iter_mut().zip(d.pressure.nodes_of(c)) {
            *p = state.pressure[*node as usize];
        }
        let mut deflections = [0.0; M];
        let mut places = [[0.0; M]; 2];
        for (j, node) in d.contact.deflection.nodes_of(c).iter().enumerate() {
            deflections[j] = state.deflection[*node as usize];
            for a in 0..2 {
                places[a][j] = d.contact.deflection.points[*node as usize][a];
            }
        }
        let p_lists = element.pressure.chunks_exact_mut(N_LISTS * N);
        let w_lists = element.deflection.chunks_exact_mut(3 * M);
        for (q, (p_list, w_list)) in p_lists.zip(w_lists).enumerate() {
            let table = &d.pressure_table;
            for j in 0..n {
                let k = q * n + j;
                let [gx, gy] = metric.gradient(&table.gradients[k]);
                p_list[j] = table.values[k];
                p_list[N + j] = gx;
                p_list[2 * N + j] = gy;
                p_list[3 * N + j] = metric.laplacian(&table.hessians[k]);
                p_list[4 * N + j] = d.pressure_unresolved[k];
                if S == GENERALIZED {
                    let second = metric.second(&table.hessians[k]);
                    for (l, value) in second.into_iter().enumerate() {
                        p_list[(5 + l) * N + j] = value;
                    }
                }
            }
            let table = &d.deflection_table;
            for j in 0..m {
                let k = q * m + j;
                let [gx, gy] = metric.gradient(&table.gradients[k]);
                w_list[j] = table.values[k];
                w_list[M + j] = gx;
                w_list[2 * M + j] = gy;
            }
            let p: [f64; N_LISTS] = std::array::from_fn(|a| {
                if a < N_TEST || S == GENERALIZED {
                    dot::<N>(&p_list[a * N..(a + 1) * N], &pressures)
                } else {
                    0.0
                }
            });
            let curvature = if S == GENERALIZED {
                [p[5], p[6], p[7]]
            } else {
                [p[3], 0.0, 0.0]
            };
            let w: [f64; 3] =
                std::array::from_fn(|a| dot::<M>(&w_list[a * M..(a + 1) * M], &deflections));
            let [x, y] = places.map(|x| dot::<M>(&w_list[..M], &x));
            let place = [x, y, 0.0];
            let gap = d.contact.shape.gap.at([x, y]);
            let [gap_x, gap_y] = gap.gradient;
            let h = state.rigid_separation + gap.value + w[0];
            element.points.push(Point {
                place,
                state: [
                    p[0],
                    p[1],
                    p[2],
                    p[4],
                    h,
                    gap_x + w[1],
                    gap_y + w[2],
                    curvature[0],
                    curvature[1],
                    curvature[2],
                ],
                value: [0.0; N_TEST],
                slopes: [[0.0; GENERALIZED]; N_TEST],
                entrainment: [0.0; 2],
                missed: 0.0,
            });
        }
    }

    /// Sums over the quadrature points.
    #[inline(always)]
    fn integrate<const N: usize, const M: usize, const S: usize>(
        &self,
        c: usize,
        element: &Element,
        block: &mut [f64],
        sums: &mut [[f64; N_SUMS]],
    ) {
        let d = self.d;
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let determinant = d.contact.maps[c].determinant;
        let mut by_pressure = [[0.0; N]; N];
        let mut by_deflection = [[0.0; M]; N];
        sums.fill([0.0; N_SUMS]);
        let p_lists = element.pressure.chunks_exact(N_LISTS * N);
        let w_lists = element.deflection.chunks_exact(3 * M);
        let points = element.points.iter().zip(&d.rule.weights);
        for (((point, weight), p_list), w_list) in points.zip(p_lists).zip(w_lists) {
            let scale = weight * determinant;
            let p: [&[f64; N]; N_LISTS] = std::array::from_fn(|a| list(p_list, a));
            let w: [&[f64; M]; 3] = std::array::from_fn(|a| list(w_list, a));
            for i in 0..n {
                let test: [f64; N_TEST] = std::array::from_fn(|a| scale * p[a][i]);
                let mut by = [0.0; S];
                for (t, slopes) in test.iter().zip(&point.slopes) {
                    for k in 0..S {
                        by[k] += t * slopes[k];
                    }
                }
                let row = &mut by_pressure[i];
                for j in 0..N {
                    row[j] += (by[0] * p[0][j] + by[1] * p[1][j])
                        + (by[2] * p[2][j] + by[3] * p[4][j])
                        + if S == GENERALIZED {
                            by[7] * p[5][j] + by[8] * p[6][j] + by[9] * p[7][j]
                        } else {
                            by[7] * p[3][j]
                        };
                }
                let row = &mut by_deflection[i];
                for j in 0..M {
                    row[j] += by[4] * w[0][j] + by[5] * w[1][j] + by[6] * w[2][j];
                }
                let value: f64 = test.iter().zip(&point.value).map(|(t, v)| t * v).sum();
                let sums = &mut sums[i];
                sums[0] += by[4];
                sums[1] += value;
                sums[2] += test[1] * point.entrainment[0] + test[2] * point.entrainment[1];
                sums[3] += test[0] * point.missed * point.missed;
            }
        }
        for (i, row) in block.chunks_exact_mut(n + m).enumerate() {
            row[..n].copy_from_slice(&by_pressure[i][..n]);
            row[n..].copy_from_slice(&by_deflection[i][..m]);
        }
    }
}

declare_kernel! {
    Interpolate ['a, 'b, const N: usize, const M: usize, const S: usize] ['a, 'b, N, M, S]
    (assembler: &'b Assembler<'a>, c: usize, element: &'b mut Element) -> () {
        assembler.interpolate::<N, M, S>(c, element)
    }
}

declare_kernel! {
    Integrate ['a, 'b, const N: usize, const M: usize, const S: usize] ['a, 'b, N, M, S]
    (
        assembler: &'b Assembler<'a>,
        c: usize,
        element: &'b Element,
        block: &'b mut [f64],
        sums: &'b mut [[f64; N_SUMS]],
    ) -> () {
        assembler.integrate::<N, M, S>(c, element, block, sums)
    }
}

declare_kernel! {
    Integrand ['a, const S: usize] ['a, S]
    (
        point: &'a mut Point,
        fluid: &'a FilmFluid,
        local: &'a ElementConstants,
        source: f64,
        rule: &'a mut CrossFilm,
    ) -> () {
        integrand::<S>(point, fluid, local, source, rule)
    }
}

declare_kernel! {
    ThermalIntegrand ['a] ['a]
    (
        point: &'a mut Point,
        fluid: &'a FilmFluid,
        profile: &'a TemperatureProfile,
        local: &'a ElementConstants,
        source: f64,
        rule: &'a mut CrossFilm,
    ) -> () {
        thermal_integrand(point, fluid, profile, local, source, rule)
    }
}

/// Kernel for the lists of a discretisation: loops of known length, nodes rounded up to whole vectors.
fn kernel<'a, const S: usize>(d: &Discretisation) -> Kernel<'a> {
    match (d.pressure_table.n_nodes, d.deflection_table.n_nodes) {
        (0..=4, 0..=4) => Assembler::padded::<4, 4, S>,
        (0..=4, 5..=8) => Assembler::padded::<4, 8, S>,
        (5..=8, 0..=8) => Assembler::padded::<8, 8, S>,
        (0..=8, 9..=12) => Assembler::padded::<8, 12, S>,
        (9..=12, 0..=8) => Assembler::padded::<12, 8, S>,
        (9..=12, 9..=12) => Assembler::padded::<12, 12, S>,
        (13..=16, 0..=8) => Assembler::padded::<16, 8, S>,
        (0..=16, 0..=16) => Assembler::padded::<16, 16, S>,
        (17.., 0..=8) => Assembler::padded::<24, 8, S>,
        _ => Assembler::padded::<24, 24, S>,
    }
}

/// The integrand and its derivatives at a point.
#[inline(always)]
fn integrand<const S: usize>(
    point: &mut Point,
    fluid: &FilmFluid,
    local: &ElementConstants,
    source: f64,
    rule: &mut CrossFilm,
) {
    let s = point.variables::<S>();
    let properties = fluid.at(point.state[0]);
    let m = Properties::around(s.pressure, &properties);
    let flow = if S == GENERALIZED {
        let slide = PointSliding::new(fluid.slide(), point.at());
        let g = pressure_stress(&s).map(|g| g.re);
        let omega = sliding_stress(&s, &m, slide.value).map(|omega| omega.re);
        let closure = fluid.close(point.state[0], g, omega, rule);
        generalized(&s, &m, local.lambda, &slide, &closure)
    } else {
        newtonian(&s, &m, local.lambda)
    };
    let velocity = local.entrainment.at(point.at());
    point.keep(
        &reynolds_point(&s, &m, &flow, local, velocity, source),
        velocity.map(|u| properties.density[0] * u),
    );
}

/// The same where the temperature varies.
#[inline(always)]
fn thermal_integrand(
    point: &mut Point,
    fluid: &FilmFluid,
    profile: &TemperatureProfile,
    local: &ElementConstants,
    source: f64,
    rule: &mut CrossFilm,
) {
    let s = point.variables::<GENERALIZED>();
    let film = fluid.thermal(point.state[0], profile);
    let m = Properties::around(s.pressure, &film.point());
    let slide = PointSliding::new(fluid.slide(), point.at());
    let g = pressure_stress(&s).map(|g| g.re);
    let omega = sliding_stress(&s, &m, slide.value).map(|omega| omega.re);
    let closure = fluid.close_thermal(point.state[0], &film, g, omega, rule);
    let flow = thermal(&s, &m, local.lambda, &slide, &closure, &film.density);
    let velocity = local.entrainment.at(point.at());
    point.keep(
        &reynolds_point(&s, &m, &flow, local, velocity, source),
        velocity.map(|u| film.density.by_p[0] * u),
    );
}

impl Point {
    /// The state, each quantity an independent variable.
    #[inline(always)]
    fn variables<const S: usize>(&self) -> PointState<Dual<S>> {
        let x = |k: usize| Dual::<S>::variable(self.state[k], k);
        let zero = Dual::from(0.0);
        let curvature = if S == GENERALIZED {
            [x(7), x(8), x(9)]
        } else {
            [x(7), zero, zero]
        };
        PointState {
            pressure: x(0),
            pressure_gradient: [x(1), x(2)],
            pressure_unresolved: x(3),
            film: x(4),
            film_gradient: [x(5), x(6)],
            pressure_curvature: curvature,
        }
    }

    /// (X, Y).
    #[inline(always)]
    fn at(&self) -> [f64; 2] {
        [self.place[0], self.place[1]]
    }

    /// Keeps the integrand, and the entrainment of ρ̄ū.
    #[inline(always)]
    fn keep<const S: usize>(&mut self, t: &TestCoefficients<Dual<S>>, carried: [f64; 2]) {
        let test = [
            t.value,
            t.gradient[0],
            t.gradient[1],
            t.laplacian,
            t.unresolved,
        ];
        self.value = test.map(|t| t.re);
        for (slopes, t) in self.slopes.iter_mut().zip(&test) {
            slopes[..S].copy_from_slice(&t.slopes);
        }
        self.entrainment = carried.map(|c| c * self.state[4]);
        self.missed = t.missed.re;
    }
}

/// Derivatives by (X, Y) from those by reference coordinates.
pub(super) struct Metric {
    inverse: [[f64; 2]; 2],
    /// Σ_m ∂ξ_a/∂x_m ∂ξ_b/∂x_m: 11, 12 twice, 22.
    products: [f64; 3],
}

impl Metric {
    #[inline(always)]
    pub(super) fn new(map: &Affine) -> Metric {
        let i = &map.inverse;
        let product = |a: usize, b: usize| i[a][0] * i[b][0] + i[a][1] * i[b][1];
        Metric {
            inverse: [[i[0][0], i[0][1]], [i[1][0], i[1][1]]],
            products: [product(0, 0), 2.0 * product(0, 1), product(1, 1)],
        }
    }

    #[inline(always)]
    pub(super) fn gradient(&self, reference: &[f64; 3]) -> [f64; 2] {
        let i = &self.inverse;
        [0, 1].map(|m: usize| i[0][m] * reference[0] + i[1][m] * reference[1])
    }

    /// xx, xy, yy.
    #[inline(always)]
    pub(super) fn second(&self, reference: &[[f64; 3]; 3]) -> [f64; 3] {
        let i = &self.inverse;
        let entry = |a: usize, b: usize| {
            let mut sum = 0.0;
            for (k, row) in i.iter().enumerate() {
                for (l, other) in i.iter().enumerate() {
                    sum += row[a] * other[b] * reference[k][l];
                }
            }
            sum
        };
        [entry(0, 0), entry(0, 1), entry(1, 1)]
    }

    #[inline(always)]
    pub(super) fn laplacian(&self, reference: &[[f64; 3]; 3]) -> f64 {
        let [p11, p12, p22] = self.products;
        p11 * reference[0][0] + p12 * reference[0][1] + p22 * reference[1][1]
    }
}

/// The a-th list of `N` numbers.
#[inline(always)]
fn list<const N: usize>(lists: &[f64], a: usize) -> &[f64; N] {
    lists[a * N..(a + 1) * N].try_into().expect("N numbers")
}

/// Σ a_j b_j, four sums side by side; `N` is a multiple of four.
#[inline(always)]
fn dot<const N: usize>(a: &[f64], b: &[f64; N]) -> f64 {
    let mut sums = [0.0; 4];
    for (a, b) in a.chunks_exact(4).zip(b.chunks_exact(4)) {
        for l in 0..4 {
            sums[l] += a[l] * b[l];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
