//! The fitted formula as text, LaTeX and code.

use super::{FilmFit, FilmForm, FilmKind};
use crate::reference::ElasticExponents;
use crate::words::digits;

/// Significant digits of factors.
const DIGITS: usize = 5;

/// Numbers of the factor of ellipticity and angle: 2/a, a/2, 1 − a − 2d, e and f.
struct Ellipse {
    n: String,
    half: String,
    d: String,
    e: String,
    f: String,
}

impl FilmFit {
    /// Of that form.
    fn ellipse(&self) -> Option<Ellipse> {
        if self.form != FilmForm::Elliptical {
            return None;
        }
        let [_, a, _, d, e, f] = self.values()[..] else {
            return None;
        };
        let number = |value: f64| format!("{value:.4}");
        Some(Ellipse {
            n: number(2.0 / a),
            half: number(0.5 * a),
            d: number(1.0 - a - 2.0 * d),
            e: number(e),
            f: number(f),
        })
    }

    fn symbol(&self) -> &'static str {
        match self.kind {
            FilmKind::Central => "h_c",
            FilmKind::Minimum => "h_min",
        }
    }

    fn latex_symbol(&self) -> &'static str {
        match self.kind {
            FilmKind::Central => "h_c",
            FilmKind::Minimum => "h_{\\min}",
        }
    }

    /// Value of a constant with the digits that formulas show.
    fn constant(&self, i: usize) -> String {
        self.constants[i].map_or_else(String::new, |e| digits(e.value, DIGITS))
    }

    /// Symbol, unit and exponent of the variables that a power law has.
    fn powers(&self) -> impl Iterator<Item = (&'static str, &'static str, String)> {
        let variables = self.form.variables().iter();
        let n = match self.form {
            // The ratio and the angle have no powers.
            FilmForm::Elliptical => 3,
            FilmForm::Moes
            | FilmForm::HamrockDowson(_)
            | FilmForm::Blend(_)
            | FilmForm::Speed
            | FilmForm::SpeedLoad(_) => variables.len(),
        };
        variables
            .take(n)
            .zip(&self.constants[1..])
            .filter_map(|(variable, exponent)| {
                let exponent = format!("{:.4}", (*exponent)?.value);
                Some((variable.symbol, variable.unit, exponent))
            })
    }

    /// The formula as text.
    pub fn text(&self) -> String {
        let (h, c) = (self.symbol(), self.constant(0));
        let scale = match self.form {
            FilmForm::Moes => "R √(2U)",
            FilmForm::HamrockDowson(_) => "R",
            FilmForm::Elliptical => "R_x",
            FilmForm::Speed | FilmForm::SpeedLoad(_) => "m",
            FilmForm::Blend(contact) => {
                let [m, n, l] = ElasticExponents::of(contact).in_order();
                let (c_2, s) = (self.constant(1), self.constant(2));
                return format!(
                    "{h} = R √(2U) [({c} M^({m}))^{s} + ({c_2} M^({n}) L^({l}))^{s}]^(1/{s})"
                );
            }
        };
        let mut text = format!("{h} = {c} {scale}");
        for (symbol, unit, exponent) in self.powers() {
            text += &match unit {
                "" => format!(" {symbol}^{exponent}"),
                unit => format!(" ({symbol}/(1 {unit}))^{exponent}"),
            };
        }
        if let Some(Ellipse { n, half, d, e, f }) = self.ellipse() {
            text += &format!(
                " [(1 - exp(-{e} D^{f}))^{n} cos²θ + (D^{d} (1 - exp(-{e} D^(-{f}))))^{n} sin²θ]^{half}, D = R_y/R_x"
            );
        }
        text
    }

    /// The formula in LaTeX.
    pub fn latex(&self) -> String {
        let (h, c) = (self.latex_symbol(), latex_number(&self.constant(0)));
        let scale = match self.form {
            FilmForm::Moes => "R \\sqrt{2U}",
            FilmForm::HamrockDowson(_) => "R",
            FilmForm::Elliptical => "R_x",
            FilmForm::Speed | FilmForm::SpeedLoad(_) => "\\mathrm{m}",
            FilmForm::Blend(contact) => {
                let [m, n, l] = ElasticExponents::of(contact).in_order();
                let (c_2, s) = (latex_number(&self.constant(1)), self.constant(2));
                return format!(
                    "{h} = R \\sqrt{{2U}} \\left[\\left({c}\\, M^{{{m}}}\\right)^{{{s}}} + \
                     \\left({c_2}\\, M^{{{n}}} L^{{{l}}}\\right)^{{{s}}}\\right]^{{1/{s}}}"
                );
            }
        };
        let mut text = format!("{h} = {c}\\, {scale}");
        for (symbol, unit, exponent) in self.powers() {
            text += &match unit {
                "" => format!("\\, {symbol}^{{{exponent}}}"),
                unit => format!(
                    "\\, \\left(\\frac{{{symbol}}}{{1\\,\\mathrm{{{unit}}}}}\\right)^{{{exponent}}}"
                ),
            };
        }
        if let Some(Ellipse { n, half, d, e, f }) = self.ellipse() {
            text += &format!(
                " \\left[\\left(1 - e^{{-{e} D^{{{f}}}}}\\right)^{{{n}}} \\cos^2\\theta + \\left(D^{{{d}}} \\left(1 - \
                 e^{{-{e} D^{{-{f}}}}}\\right)\\right)^{{{n}}} \\sin^2\\theta\\right]^{{{half}}}, \\quad D = R_y/R_x"
            );
        }
        text
    }

    /// The formula as Python code, in SI.
    pub fn code(&self) -> String {
        let (h, c) = (self.symbol(), self.constant(0));
        let scale = match self.form {
            FilmForm::Moes => " * R * (2 * U) ** 0.5",
            FilmForm::HamrockDowson(_) => " * R",
            FilmForm::Elliptical => " * R_x",
            FilmForm::Speed | FilmForm::SpeedLoad(_) => "",
            FilmForm::Blend(contact) => {
                let [m, n, l] = ElasticExponents::of(contact).in_order();
                let (c_2, s) = (self.constant(1), self.constant(2));
                return format!(
                    "{h} = R * (2 * U) ** 0.5 * (({c} * M ** ({m})) ** {s} + ({c_2} * M ** ({n}) * L ** ({l})) ** {s}) \
                     ** (1 / {s})"
                );
            }
        };
        let mut text = format!("{h} = {c}{scale}");
        for (symbol, _, exponent) in self.powers() {
            text += &format!(" * {symbol} ** ({exponent})");
        }
        if let Some(Ellipse { n, half, d, e, f }) = self.ellipse() {
            text += &format!(
                " * ((1 - exp(-{e} * (R_y / R_x) ** {f})) ** {n} * cos(theta) ** 2 + ((R_y / R_x) ** ({d}) * (1 - exp(-{e} * \
                 (R_x / R_y) ** {f}))) ** {n} * sin(theta) ** 2) ** {half}"
            );
        }
        text
    }
}

/// `4.5 \cdot 10^{-8}` of `4.5e-8`.
fn latex_number(text: &str) -> String {
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
        None => text.to_owned(),
    }
}
