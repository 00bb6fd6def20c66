//! Film-thickness formulas from computed or measured films.

use std::f64::consts::SQRT_2;

use ertel_rheology::quantity::{Dimension, Unit};

use super::csv::{cells as cells_of, rows};
use super::data::{Column, DataError, unit_text};
use super::{MinimumError, minimise};
use crate::contact::ContactKind;
use crate::output::digits;
use crate::output::plot::{Axis, Chart, Look, PALETTE, Series, Side};

/// Condition number of the centred, scaled columns above which two exponents are called hardly separable: the intervals
/// are about this many times wider than those of independent variation.
const LARGEST_CONDITION: f64 = 30.0;
/// Ratio of largest to smallest M or L below which there is no variation to speak of.
const LEAST_VARIATION: f64 = 1.0 + 1e-6;

/// Which film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmKind {
    /// Central film h_c.
    Central,
    /// Minimum film h_min.
    Minimum,
}

impl FilmKind {
    /// Name, also that of the column after `film_`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Central => "central",
            Self::Minimum => "minimum",
        }
    }
}

/// A film with its groups.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmState {
    /// Moes' load group M.
    pub load: f64,
    /// Moes' material group L.
    pub material: f64,
    /// Speed group U.
    pub speed: f64,
    /// Reduced radius R, m.
    pub radius: f64,
    /// Film thickness h, m.
    pub film: f64,
}

impl FilmState {
    /// `h/(R √(2U))`.
    fn dimensionless(&self) -> f64 {
        self.film / (self.radius * SQRT_2 * self.speed.sqrt())
    }
}

/// Reads films from the text of a CSV file with the columns `film_central_m` or `film_minimum_m`, `moes_load`,
/// `moes_material`, `speed_group` and `radius_m`, which `radius` (m) replaces. Lines without a film are left out.
///
/// # Errors
///
/// Missing columns and numbers, with line and column; `None` if only the column of the film is missing.
pub fn read_films(
    file: &str,
    text: &str,
    kind: FilmKind,
    radius: Option<f64>,
) -> Result<Option<Vec<FilmState>>, DataError> {
    let at = |line, column, problem| DataError {
        file: file.to_owned(),
        line,
        column,
        problem,
    };
    let mut lines = rows(text);
    let (number, head, separator) = lines
        .next()
        .ok_or_else(|| at(1, 1, "the file is empty".to_owned()))?;
    let cells: Vec<&str> = cells_of(head, separator);
    let find = |name: &'static str, dimension: Dimension| {
        cells.iter().enumerate().find_map(|(index, cell)| {
            let unit = Unit::parse(&unit_text(cell, name)?).ok()?;
            let fits = unit.dimension().same_exponents(dimension);
            fits.then_some(Column { index, name, unit })
        })
    };
    let need = |name: &'static str, dimension: Dimension, help: &str| {
        find(name, dimension).ok_or_else(|| {
            let name = name.replace(' ', "_");
            let problem = format!(
                "there is no column `{name}`{help}; the columns are {}",
                cells.join(", ")
            );
            at(number, 1, problem)
        })
    };
    let none = Dimension::DIMENSIONLESS;
    let name = match kind {
        FilmKind::Central => "film central",
        FilmKind::Minimum => "film minimum",
    };
    let Some(film) = find(name, Dimension::LENGTH) else {
        return Ok(None);
    };
    let load = need("moes load", none, "")?;
    let material = need("moes material", none, "")?;
    let speed = need("speed group", none, "")?;
    let radius_column = match radius {
        Some(_) => None,
        None => Some(need(
            "radius",
            Dimension::LENGTH,
            " with a unit, such as `radius_m`, and no radius for all is given (`--radius`)",
        )?),
    };
    let mut states = Vec::new();
    for (line, row, _) in lines {
        let cells: Vec<&str> = cells_of(row, separator);
        if cells.get(film.index).is_none_or(|cell| cell.is_empty()) {
            continue;
        }
        let positive = |column: &Column| {
            let value = column
                .number(&cells)
                .map_err(|(column, problem)| at(line, column, problem))?;
            if value > 0.0 {
                return Ok(value);
            }
            let problem = format!(
                "{}: {value} has no logarithm: it must be above zero",
                column.name
            );
            Err(at(line, column.index + 1, problem))
        };
        states.push(FilmState {
            load: positive(&load)?,
            material: positive(&material)?,
            speed: positive(&speed)?,
            radius: match &radius_column {
                Some(column) => positive(column)?,
                None => radius.unwrap_or(f64::NAN),
            },
            film: positive(&film)?,
        });
    }
    Ok(Some(states))
}

/// A formula `h = c R √(2U) M^a L^b` with its constants given, such as a published one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerFormula {
    /// Factor c.
    pub factor: f64,
    /// Exponent a of M.
    pub load_exponent: f64,
    /// Exponent b of L.
    pub material_exponent: f64,
}

impl PowerFormula {
    /// `formula/film - 1`.
    pub fn deviation(&self, state: &FilmState) -> f64 {
        let powers =
            state.load.powf(self.load_exponent) * state.material.powf(self.material_exponent);
        self.factor * powers / state.dimensionless() - 1.0
    }
}

/// Which contact the films of a table belong to, by its column `load_N` or `load_N_per_m`; `None` without one of these.
pub fn contact_of_films(text: &str) -> Option<ContactKind> {
    let (_, head, separator) = rows(text).next()?;
    let cells = cells_of(head, separator);
    let has = |dimension: Dimension| {
        let unit = |cell: &&str| Unit::parse(&unit_text(cell, "load")?).ok();
        let mut units = cells.iter().filter_map(unit);
        units.any(|unit| unit.dimension().same_exponents(dimension))
    };
    match (has(Dimension::FORCE), has(Dimension::FORCE_PER_LENGTH)) {
        (true, false) => Some(ContactKind::Circular),
        (false, true) => Some(ContactKind::Line),
        _ => None,
    }
}

/// A number with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Lower and upper end.
    pub interval: [f64; 2],
}

/// The formula `h = c R √(2U) M^a L^b`.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmFit {
    /// Which film.
    pub kind: FilmKind,
    /// Factor c.
    pub factor: Estimate,
    /// Exponent a of M; `None` where M does not vary.
    pub load_exponent: Option<Estimate>,
    /// Exponent b of L; `None` where L does not vary.
    pub material_exponent: Option<Estimate>,
    /// Smallest and largest M.
    pub load_range: [f64; 2],
    /// Smallest and largest L.
    pub material_range: [f64; 2],
    /// `formula/film - 1` of every state.
    pub deviations: Vec<f64>,
    /// Confidence of the intervals.
    pub confidence: f64,
    /// What the data leave open.
    pub warnings: Vec<String>,
}

/// Why there is no formula.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FilmFitError {
    /// Too few films.
    #[error("{n_states} films cannot determine {n_unknowns} constants with their intervals; at least {} are needed", n_unknowns + 1)]
    TooFew {
        /// Number of films.
        n_states: usize,
        /// Number of constants.
        n_unknowns: usize,
    },
    /// M and L vary as one.
    #[error(
        "L is a power of M in all films: their exponents cannot be told apart; vary one without the other"
    )]
    Collinear,
    /// The confidence is no probability.
    #[error("the confidence {0} is not between 0 and 1")]
    Confidence(f64),
    /// The search did not end.
    #[error(transparent)]
    Minimum(#[from] MinimumError),
}

/// Fits `h = c R √(2U) M^a L^b` by least squares of `ln h`. An exponent whose group does not vary is left out; its power
/// is then part of c, and a warning says so.
///
/// # Errors
///
/// [`FilmFitError`].
pub fn fit_film(
    states: &[FilmState],
    kind: FilmKind,
    confidence: f64,
) -> Result<FilmFit, FilmFitError> {
    if !(confidence > 0.0 && confidence < 1.0) {
        return Err(FilmFitError::Confidence(confidence));
    }
    let range = |value: fn(&FilmState) -> f64| {
        let values = states.iter().map(value);
        values.fold([f64::INFINITY, 0.0f64], |[low, high], v| {
            [low.min(v), high.max(v)]
        })
    };
    let ranges = [range(|s| s.load), range(|s| s.material)];
    let varies = ranges.map(|[low, high]| high > LEAST_VARIATION * low);
    let axes: Vec<usize> = (0..2).filter(|i| varies[*i]).collect();
    if states.len() <= 1 + axes.len() {
        return Err(FilmFitError::TooFew {
            n_states: states.len(),
            n_unknowns: 1 + axes.len(),
        });
    }
    // Logarithms of M and L, as multiples of their spread about the mean: the unknowns are then of order one.
    let logs: Vec<[f64; 2]> = states
        .iter()
        .map(|s| [s.load.ln(), s.material.ln()])
        .collect();
    let n = states.len() as f64;
    let mean = |i: usize| logs.iter().map(|l| l[i]).sum::<f64>() / n;
    let means = [mean(0), mean(1)];
    let spread = ranges.map(|[low, high]| (high / low).ln());
    let film: Vec<f64> = states.iter().map(|s| s.dimensionless().ln()).collect();
    let centred = |x: &[f64], r: &mut [f64]| {
        for ((r, log), film) in r.iter_mut().zip(&logs).zip(&film) {
            *r = x[0] - film;
            for (x, i) in x[1..].iter().zip(&axes) {
                *r += x * (log[*i] - means[*i]) / spread[*i];
            }
        }
    };
    let start = vec![0.0; 1 + axes.len()];
    let minimum = minimise(states.len(), &start, confidence, centred)?;
    if minimum.condition > 1e6 {
        return Err(FilmFitError::Collinear);
    }
    let mut exponents = [None, None];
    for (j, i) in axes.iter().enumerate() {
        let [value, half] = [minimum.x[j + 1], minimum.half_widths[j + 1]].map(|v| v / spread[*i]);
        exponents[*i] = Some(Estimate {
            value,
            interval: [value - half, value + half],
        });
    }
    // c is the film at M = L = 1; once more without centring, for its interval.
    let plain = |x: &[f64], r: &mut [f64]| {
        for ((r, log), film) in r.iter_mut().zip(&logs).zip(&film) {
            *r = x[0] - film;
            for (x, i) in x[1..].iter().zip(&axes) {
                *r += x * log[*i] / spread[*i];
            }
        }
    };
    let mut start = minimum.x.clone();
    for (j, i) in axes.iter().enumerate() {
        start[0] -= minimum.x[j + 1] * means[*i] / spread[*i];
    }
    let at_one = minimise(states.len(), &start, confidence, plain)?;
    let (ln_c, half) = (at_one.x[0], at_one.half_widths[0]);
    let mut warnings = Vec::new();
    for (i, name) in ["M", "L"].into_iter().enumerate() {
        let [low, high] = ranges[i];
        if !varies[i] {
            warnings.push(format!(
                "{name} does not vary (it is {}): its exponent cannot be determined and its power is part of the factor",
                digits(low, 4)
            ));
        } else if let Some(Estimate {
            interval: [from, to],
            ..
        }) = exponents[i]
            && (to - from) * spread[i] > 0.2
        {
            warnings.push(format!(
                "the data hardly determine the exponent of {name}: with {name} from {} to {} it lies between {} and {}",
                digits(low, 4),
                digits(high, 4),
                digits(from, 3),
                digits(to, 3)
            ));
        }
    }
    if minimum.condition > LARGEST_CONDITION {
        warnings.push(format!(
            "M and L vary together (condition number {}): their exponents trade off",
            digits(minimum.condition, 2)
        ));
    }
    Ok(FilmFit {
        kind,
        factor: Estimate {
            value: ln_c.exp(),
            interval: [(ln_c - half).exp(), (ln_c + half).exp()],
        },
        load_exponent: exponents[0],
        material_exponent: exponents[1],
        load_range: ranges[0],
        material_range: ranges[1],
        deviations: minimum.residuals.iter().map(|r| r.exp_m1()).collect(),
        confidence,
        warnings,
    })
}

impl FilmFit {
    fn symbol(&self) -> &'static str {
        match self.kind {
            FilmKind::Central => "h_c",
            FilmKind::Minimum => "h_min",
        }
    }

    /// Symbol and exponent of the groups that the formula has.
    fn powers(&self) -> Vec<(&'static str, String)> {
        [("M", self.load_exponent), ("L", self.material_exponent)]
            .into_iter()
            .filter_map(|(name, exponent)| Some((name, format!("{:.4}", exponent?.value))))
            .collect()
    }

    /// The formula as text.
    pub fn text(&self) -> String {
        let mut text = format!(
            "{} = {} R √(2U)",
            self.symbol(),
            digits(self.factor.value, 5)
        );
        for (name, exponent) in self.powers() {
            text += &format!(" {name}^{exponent}");
        }
        text
    }

    /// The formula in LaTeX.
    pub fn latex(&self) -> String {
        let symbol = match self.kind {
            FilmKind::Central => "h_c",
            FilmKind::Minimum => "h_{\\min}",
        };
        let mut text = format!(
            "{symbol} = {}\\, R \\sqrt{{2U}}",
            digits(self.factor.value, 5)
        );
        for (name, exponent) in self.powers() {
            text += &format!("\\, {name}^{{{exponent}}}");
        }
        text
    }

    /// The formula as Python code.
    pub fn code(&self) -> String {
        let mut text = format!(
            "{} = {} * R * (2 * U) ** 0.5",
            self.symbol(),
            digits(self.factor.value, 5)
        );
        for (name, exponent) in self.powers() {
            text += &format!(" * {name} ** ({exponent})");
        }
        text
    }

    /// The same formula in the groups of Hamrock and Dowson, `h = k R U^u G^g W^w`, by `M = W (2U)^(-3/4)`, in line contacts
    /// `W (2U)^(-1/2)`, and `L = G (2U)^(1/4)`: the constants k, u, g, w. An exponent that is not determined is none.
    pub fn hamrock_dowson(&self, kind: ContactKind) -> [f64; 4] {
        let exponent = |e: Option<Estimate>| e.map_or(0.0, |e| e.value);
        let (a, b) = (
            exponent(self.load_exponent),
            exponent(self.material_exponent),
        );
        let speed = match kind {
            ContactKind::Circular => 0.5 - 0.75 * a + 0.25 * b,
            ContactKind::Line => 0.5 - 0.5 * a + 0.25 * b,
        };
        [self.factor.value * 2f64.powf(speed), speed, b, a]
    }

    /// Root mean square of the deviations.
    pub fn rms(&self) -> f64 {
        let n = self.deviations.len() as f64;
        (self.deviations.iter().map(|d| d * d).sum::<f64>() / n).sqrt()
    }

    /// Largest deviation by size.
    pub fn largest(&self) -> f64 {
        self.deviations
            .iter()
            .copied()
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))
            .unwrap_or(0.0)
    }
}

/// Films by the formula over the films given.
pub fn parity(fits: &[(FilmFit, Vec<FilmState>)], title: &str) -> Chart {
    let all: Vec<f64> = fits
        .iter()
        .flat_map(|(_, states)| states.iter().map(|s| 1e9 * s.film))
        .collect();
    let x = Axis::log_close_around("Film thickness *h* given (nm)", all.clone());
    let mut y = Axis::log_close_around("by the formula (nm)", all);
    (y.low, y.high) = (x.low, x.high);
    let mut chart = Chart::new(title, x, y);
    let (low, high) = (chart.x.low, chart.x.high);
    for (label, factor, look) in [
        ("equal", 1.0, Look::Line),
        ("±5 %", 1.05, Look::Dashed),
        ("", 0.95, Look::Dashed),
    ] {
        chart.series.push(Series {
            label: label.into(),
            points: vec![[low, factor * low], [high, factor * high]],
            look,
            colour: "#7f7f7f".into(),
            side: Side::Left,
        });
    }
    for (i, (fit, states)) in fits.iter().enumerate() {
        chart.series.push(Series {
            label: format!("{} film", fit.kind.name()),
            points: states
                .iter()
                .zip(&fit.deviations)
                .map(|(s, d)| [1e9 * s.film, 1e9 * s.film * (1.0 + d)])
                .collect(),
            look: Look::Circles,
            colour: PALETTE[i % PALETTE.len()].into(),
            side: Side::Left,
        });
    }
    chart
}
