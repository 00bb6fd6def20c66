//! Unit expressions: symbols with prefixes, products, quotients, integer powers.

use super::symbols::{PREFIXES, SYMBOLS, usual_spelling};
use super::{Dimension, saybolt};

/// Why a unit expression cannot be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum UnitError {
    /// No such unit symbol.
    #[error("unknown unit `{symbol}`{}", suggestion(near))]
    Unknown {
        /// The symbol as written.
        symbol: String,
        /// Known symbols that look alike, best first; may be empty.
        near: Vec<String>,
    },
    /// A product follows a slash without parentheses.
    #[error("`{unit}` can be read in two ways; write parentheses, as in `J/(kg.K)`")]
    Ambiguous {
        /// The unit as written.
        unit: String,
    },
    /// Not a unit expression.
    #[error("`{unit}` is not a unit: {reason}")]
    Malformed {
        /// The unit as written.
        unit: String,
        /// The problem.
        reason: &'static str,
    },
}

fn suggestion(near: &[String]) -> String {
    match near {
        [] => String::new(),
        names => format!("; did you mean {}?", names.join(" or ")),
    }
}

/// A unit: its dimension and its conversion to SI, `SI value = factor · (number + offset)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    dimension: Dimension,
    /// SI units per unit, as numerator and denominator: 1/GPa is 1 / 1e9, exactly.
    numerator: f64,
    denominator: f64,
    /// Zero of the scale, in this unit; non-zero for degC and degF only.
    offset: f64,
    /// Seconds of the Saybolt viscometer, which are no multiple of anything.
    is_saybolt: bool,
}

/// How a product after a slash is read.
#[derive(Clone, Copy, PartialEq)]
enum AfterSlash {
    /// Not at all.
    Refuse,
    /// As a whole below the line, `J/kg K` as J/(kg·K).
    Divide,
}

impl Unit {
    const ONE: Self = Self {
        dimension: Dimension::DIMENSIONLESS,
        numerator: 1.0,
        denominator: 1.0,
        offset: 0.0,
        is_saybolt: false,
    };

    /// Reads a unit expression; the empty text is the unit 1.
    ///
    /// # Errors
    ///
    /// [`UnitError`] for an unknown symbol, an ambiguous quotient or anything that is not a unit expression.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        Self::read(text, AfterSlash::Refuse)
    }

    /// Reads a unit expression where one of dimension `expected` is needed, which settles what [`Unit::parse`] alone cannot: a product
    /// after a slash, and revolutions without their name, `1/min`. The unit read may measure something else.
    ///
    /// # Errors
    ///
    /// As [`Unit::parse`].
    pub fn parse_as(text: &str, expected: Dimension) -> Result<Self, UnitError> {
        let unit = match Self::parse(text) {
            Err(error @ UnitError::Ambiguous { .. }) => {
                return match Self::read(text, AfterSlash::Divide) {
                    Ok(unit) if unit.dimension.same_exponents(expected) => Ok(unit),
                    _ => Err(error),
                };
            }
            unit => unit?,
        };
        let is_rate = unit.dimension == Dimension::SHEAR_RATE && normalise(text).contains("min");
        if expected == Dimension::ANGULAR_SPEED && is_rate {
            return Ok(Self {
                dimension: Dimension::ANGULAR_SPEED,
                numerator: unit.numerator * std::f64::consts::TAU,
                ..unit
            });
        }
        Ok(unit)
    }

    fn read(text: &str, after_slash: AfterSlash) -> Result<Self, UnitError> {
        let plain = normalise(text);
        if plain.is_empty() {
            return Ok(Self::ONE);
        }
        if saybolt::NAMES.contains(&plain.as_str()) {
            return Ok(Self {
                dimension: Dimension::KINEMATIC_VISCOSITY,
                is_saybolt: true,
                ..Self::ONE
            });
        }
        let mut parser = Parser {
            rest: &plain,
            unit: text.trim(),
            depth: 0,
            after_slash,
        };
        let unit = parser.expression()?;
        if parser.rest.is_empty() {
            Ok(unit)
        } else {
            Err(parser.malformed("a closing parenthesis without an opening one"))
        }
    }

    /// Whether it is the second of a Saybolt viscometer.
    pub(super) fn is_saybolt(&self) -> bool {
        self.is_saybolt
    }

    /// Its dimension.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// `number` of this unit in SI; `40` of `degC` is 313.15 (K).
    #[must_use]
    pub fn to_si(&self, number: f64) -> f64 {
        if self.is_saybolt {
            return saybolt::kinematic_viscosity(number, saybolt::FAHRENHEIT_100);
        }
        (number + self.offset) * self.numerator / self.denominator
    }

    /// A difference of `number` of this unit in SI; `40` of `degC` is 40 (K). NaN of Saybolt seconds, whose differences are none.
    #[must_use]
    pub fn difference_to_si(&self, number: f64) -> f64 {
        if self.is_saybolt {
            return f64::NAN;
        }
        number * self.numerator / self.denominator
    }

    /// `value` (SI) in this unit; the inverse of [`Unit::to_si`].
    #[must_use]
    pub fn from_si(&self, value: f64) -> f64 {
        if self.is_saybolt {
            return saybolt::seconds(value, saybolt::FAHRENHEIT_100);
        }
        value * self.denominator / self.numerator - self.offset
    }

    fn of_symbol(name: &str) -> Option<Self> {
        let name = usual_spelling(name);
        if let Some(symbol) = SYMBOLS.iter().find(|symbol| symbol.name == name) {
            let offset = match name {
                "degC" => 273.15,
                "degF" => 459.67,
                _ => 0.0,
            };
            return Some(Self {
                dimension: symbol.dimension,
                numerator: symbol.numerator,
                denominator: symbol.denominator,
                offset,
                is_saybolt: false,
            });
        }
        let prefix = name.chars().next()?;
        let &(_, numerator, denominator) = PREFIXES.iter().find(|(p, ..)| *p == prefix)?;
        let symbol = SYMBOLS.iter().find(|symbol| {
            symbol.name == &name[prefix.len_utf8()..] && symbol.prefixes.contains(prefix)
        })?;
        Some(Self {
            dimension: symbol.dimension,
            numerator: symbol.numerator * numerator,
            denominator: symbol.denominator * denominator,
            offset: 0.0,
            is_saybolt: false,
        })
    }

    fn times(self, other: Self, power: i8) -> Self {
        let (up, down) = if power < 0 {
            (other.denominator, other.numerator)
        } else {
            (other.numerator, other.denominator)
        };
        let size = i32::from(power).abs();
        Self {
            dimension: self.dimension.times(other.dimension.power(power)),
            numerator: self.numerator * up.powi(size),
            denominator: self.denominator * down.powi(size),
            offset: 0.0,
            is_saybolt: false,
        }
    }
}

/// One spelling for each sign: micro, degree, product, quotient, powers.
fn normalise(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut in_superscript = false;
    let mut signs = text.trim().chars().peekable();
    while let Some(c) = signs.next() {
        let superscript = match c {
            '⁻' => Some('-'),
            '⁰' => Some('0'),
            '¹' => Some('1'),
            '²' => Some('2'),
            '³' => Some('3'),
            '⁴' => Some('4'),
            _ => None,
        };
        if let Some(digit) = superscript {
            if !in_superscript {
                plain.push('^');
            }
            plain.push(digit);
        } else {
            match c {
                'µ' | 'μ' => plain.push('u'),
                '°' | 'º' | '˚' => {
                    plain.push_str("deg");
                    // "° C"
                    while signs.peek() == Some(&' ') {
                        signs.next();
                    }
                }
                '℃' => plain.push_str("degC"),
                '℉' => plain.push_str("degF"),
                'Å' => plain.push('Å'),
                '·' | '⋅' | '×' | '∙' | '•' => plain.push('.'),
                '∕' | '⁄' => plain.push('/'),
                '−' => plain.push('-'),
                '\u{a0}' | '\u{202f}' | '\u{2009}' => plain.push(' '),
                // "ft-lbf"; before a digit it is a minus.
                '-' if signs.peek().is_some_and(|next| next.is_alphabetic()) => plain.push('.'),
                _ => plain.push(c),
            }
        }
        in_superscript = superscript.is_some();
    }
    let mut plain = plain
        .replace("**", "^")
        .replace('*', ".")
        .replace(" per ", "/");
    for (spaced, joined) in [
        ("deg C", "degC"),
        ("deg F", "degF"),
        ("degrees C", "degC"),
        ("degrees F", "degF"),
    ] {
        if plain.starts_with(spaced) {
            plain.replace_range(..spaced.len(), joined);
        }
    }
    plain
}

/// Known symbols, with prefixes, that differ from `name` by letter case or by one edit.
fn near_symbols(name: &str) -> Vec<String> {
    let all = SYMBOLS.iter().flat_map(|symbol| {
        let plain = std::iter::once(symbol.name.to_owned());
        plain.chain(
            symbol
                .prefixes
                .chars()
                .map(|p| format!("{p}{}", symbol.name)),
        )
    });
    let mut near: Vec<(usize, String)> = all
        .filter_map(|known| {
            let rank = if known.eq_ignore_ascii_case(name) {
                0
            } else if name.len() > 2 && strsim::osa_distance(&known, name) == 1 {
                1
            } else {
                return None;
            };
            Some((rank, known))
        })
        .collect();
    // Two symbols written together: mPas, Nm, mK, kgK.
    for split in 1..name.len() {
        if name.is_char_boundary(split) {
            let (first, second) = name.split_at(split);
            if Unit::of_symbol(first).is_some() && Unit::of_symbol(second).is_some() {
                near.push((0, format!("{first}.{second}")));
            }
        }
    }
    match name {
        "Cst" | "csT" => near.push((0, "cSt".to_owned())),
        "r" | "tr" | "turns" => near.push((0, "rev".to_owned())),
        "mu" | "mü" | "my" => near.push((0, "um".to_owned())),
        _ => {}
    }
    near.sort_by_key(|(rank, _)| *rank);
    let best = near.first().map_or(0, |(rank, _)| *rank);
    near.into_iter()
        .filter(|(rank, _)| *rank == best)
        .map(|(_, known)| known)
        .take(4)
        .collect()
}

/// Recursive descent over
///
/// ```text
/// expression = ["1"] { ("." | " " | "/") factor }
/// factor     = (symbol | "(" expression ")") [["^"] ["-"] digits]
/// ```
struct Parser<'a> {
    rest: &'a str,
    unit: &'a str,
    depth: usize,
    after_slash: AfterSlash,
}

impl Parser<'_> {
    fn malformed(&self, reason: &'static str) -> UnitError {
        UnitError::Malformed {
            unit: self.unit.to_owned(),
            reason,
        }
    }

    fn skip_spaces(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn expression(&mut self) -> Result<Unit, UnitError> {
        self.skip_spaces();
        let mut unit = if self.rest.starts_with('/') {
            Unit::ONE
        } else {
            self.factor()?
        };
        let mut divided = false;
        loop {
            let spaced = self.rest.starts_with(' ');
            self.skip_spaces();
            let power = match self.rest.chars().next() {
                None | Some(')') => return Ok(unit),
                Some('/') => -1,
                Some('.') => 1,
                Some(_) if spaced => 1,
                Some(_) => return Err(self.malformed("a sign that does not belong in a unit")),
            };
            if self.rest.starts_with(['/', '.']) {
                self.rest = &self.rest[1..];
                self.skip_spaces();
            }
            let power = match (divided && power == 1, self.after_slash) {
                (false, _) => power,
                (true, AfterSlash::Divide) => -1,
                (true, AfterSlash::Refuse) => {
                    return Err(UnitError::Ambiguous {
                        unit: self.unit.to_owned(),
                    });
                }
            };
            divided |= power == -1;
            unit = unit.times(self.factor()?, power);
        }
    }

    fn factor(&mut self) -> Result<Unit, UnitError> {
        let base = if let Some(inner) = self.rest.strip_prefix('(') {
            if self.depth > 8 {
                return Err(self.malformed("too many parentheses"));
            }
            self.rest = inner;
            self.depth += 1;
            let unit = self.expression()?;
            self.depth -= 1;
            self.rest = self
                .rest
                .strip_prefix(')')
                .ok_or_else(|| self.malformed("a parenthesis is not closed"))?;
            unit
        } else if let Some(rest) = self.rest.strip_prefix('1') {
            self.rest = rest;
            return Ok(Unit::ONE);
        } else {
            let end = self
                .rest
                .find(|c: char| !(c.is_alphabetic() || c == '%'))
                .unwrap_or(self.rest.len());
            if end == 0 {
                return Err(self.malformed("a unit symbol is missing"));
            }
            let (name, rest) = self.rest.split_at(end);
            self.rest = rest;
            Unit::of_symbol(name).ok_or_else(|| UnitError::Unknown {
                symbol: name.to_owned(),
                near: near_symbols(name),
            })?
        };
        match self.exponent()? {
            Some(power) => Ok(Unit::ONE.times(base, power)),
            None => Ok(base),
        }
    }

    fn exponent(&mut self) -> Result<Option<i8>, UnitError> {
        let caret = self.rest.starts_with('^');
        let digits = self.rest.trim_start_matches('^');
        let sign = usize::from(digits.starts_with('-'));
        let n_digits = digits[sign..]
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(digits.len() - sign);
        if n_digits == 0 {
            if caret || sign == 1 {
                return Err(self.malformed("a power must be a whole number, as in `m^3` or `s^-1`"));
            }
            return Ok(None);
        }
        let (power, rest) = digits.split_at(sign + n_digits);
        if caret && rest.starts_with('.') && rest[1..].starts_with(|c: char| c.is_ascii_digit()) {
            return Err(self.malformed("a power must be a whole number, as in `m^3` or `s^-1`"));
        }
        self.rest = rest;
        match power.parse::<i8>() {
            Ok(0) => Err(self.malformed("a power of zero")),
            Ok(power) if power.abs() <= 9 => Ok(Some(power)),
            _ => Err(self.malformed("a power beyond 9")),
        }
    }
}
