//! Unit expressions: symbols with prefixes, products, quotients, integer powers.

use super::{Dimension, STANDARD_ATMOSPHERE};

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
        /// What is wrong.
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
}

/// A symbol, its SI dimension, factor numerator and denominator, and the prefixes it takes.
struct Symbol {
    name: &'static str,
    dimension: Dimension,
    numerator: f64,
    denominator: f64,
    prefixes: &'static str,
}

const fn symbol(
    name: &'static str,
    dimension: Dimension,
    numerator: f64,
    denominator: f64,
    prefixes: &'static str,
) -> Symbol {
    Symbol {
        name,
        dimension,
        numerator,
        denominator,
        prefixes,
    }
}

// K takes no prefix so that `W/mK` is refused and not read as watts per millikelvin.
const SYMBOLS: &[Symbol] = &[
    symbol("1", Dimension::DIMENSIONLESS, 1.0, 1.0, ""),
    symbol("%", Dimension::DIMENSIONLESS, 1.0, 1e2, ""),
    symbol("m", Dimension::LENGTH, 1.0, 1.0, "pnumcdk"),
    symbol("in", Dimension::LENGTH, 0.0254, 1.0, ""),
    symbol("ft", Dimension::LENGTH, 0.3048, 1.0, ""),
    symbol("g", Dimension::MASS, 1.0, 1e3, "numk"),
    symbol("s", Dimension::TIME, 1.0, 1.0, "pnum"),
    symbol("min", Dimension::TIME, 60.0, 1.0, ""),
    symbol("h", Dimension::TIME, 3600.0, 1.0, ""),
    symbol("Hz", Dimension::SHEAR_RATE, 1.0, 1.0, "kMG"),
    symbol("K", Dimension::TEMPERATURE, 1.0, 1.0, ""),
    symbol("degC", Dimension::TEMPERATURE, 1.0, 1.0, ""),
    symbol("degF", Dimension::TEMPERATURE, 5.0, 9.0, ""),
    symbol("rad", Dimension::ANGLE, 1.0, 1.0, "m"),
    symbol("deg", Dimension::ANGLE, std::f64::consts::PI, 180.0, ""),
    symbol(
        "rpm",
        Dimension::ANGULAR_SPEED,
        std::f64::consts::TAU,
        60.0,
        "",
    ),
    symbol("N", Dimension::FORCE, 1.0, 1.0, "numkMG"),
    symbol("lbf", Dimension::FORCE, 4.448_221_615_260_5, 1.0, ""),
    symbol("Pa", Dimension::PRESSURE, 1.0, 1.0, "numhkMGT"),
    symbol("bar", Dimension::PRESSURE, 1e5, 1.0, "mk"),
    symbol("atm", Dimension::PRESSURE, STANDARD_ATMOSPHERE, 1.0, ""),
    symbol("psi", Dimension::PRESSURE, 6_894.757_293_168_361, 1.0, "kM"),
    symbol("ksi", Dimension::PRESSURE, 6_894_757.293_168_361, 1.0, ""),
    symbol("J", Dimension::ENERGY, 1.0, 1.0, "numkMG"),
    symbol("W", Dimension::POWER, 1.0, 1.0, "numkMG"),
    symbol("P", Dimension::VISCOSITY, 1.0, 10.0, "mc"),
    symbol("St", Dimension::KINEMATIC_VISCOSITY, 1.0, 1e4, "mc"),
];

/// Prefix, power of ten as numerator and denominator.
const PREFIXES: &[(char, f64, f64)] = &[
    ('p', 1.0, 1e12),
    ('n', 1.0, 1e9),
    ('u', 1.0, 1e6),
    ('m', 1.0, 1e3),
    ('c', 1.0, 1e2),
    ('d', 1.0, 1e1),
    ('h', 1e2, 1.0),
    ('k', 1e3, 1.0),
    ('M', 1e6, 1.0),
    ('G', 1e9, 1.0),
    ('T', 1e12, 1.0),
];

impl Unit {
    const ONE: Self = Self {
        dimension: Dimension::DIMENSIONLESS,
        numerator: 1.0,
        denominator: 1.0,
        offset: 0.0,
    };

    /// Reads a unit expression; the empty text is the unit 1.
    ///
    /// # Errors
    ///
    /// [`UnitError`] for an unknown symbol, an ambiguous quotient or anything that is not a unit expression.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        let plain = normalise(text);
        if plain.is_empty() {
            return Ok(Self::ONE);
        }
        let mut parser = Parser {
            rest: &plain,
            unit: text.trim(),
            depth: 0,
        };
        let unit = parser.expression()?;
        if parser.rest.is_empty() {
            Ok(unit)
        } else {
            Err(parser.malformed("a closing parenthesis without an opening one"))
        }
    }

    /// What it measures.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// `number` of this unit in SI; `40` of `degC` is 313.15 (K).
    #[must_use]
    pub fn to_si(&self, number: f64) -> f64 {
        (number + self.offset) * self.numerator / self.denominator
    }

    /// A difference of `number` of this unit in SI; `40` of `degC` is 40 (K).
    #[must_use]
    pub fn difference_to_si(&self, number: f64) -> f64 {
        number * self.numerator / self.denominator
    }

    /// `value` (SI) in this unit; the inverse of [`Unit::to_si`].
    #[must_use]
    pub fn from_si(&self, value: f64) -> f64 {
        value * self.denominator / self.numerator - self.offset
    }

    fn of_symbol(name: &str) -> Option<Self> {
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
        }
    }
}

/// One spelling for each sign: micro, degree, product, powers.
fn normalise(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut in_superscript = false;
    for c in text.trim().chars() {
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
                '°' => plain.push_str("deg"),
                '℃' => plain.push_str("degC"),
                '·' | '⋅' | '×' => plain.push('.'),
                _ => plain.push(c),
            }
        }
        in_superscript = superscript.is_some();
    }
    plain.replace("**", "^").replace('*', ".")
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
        "C" | "celsius" | "Celsius" => near.push((0, "degC".to_owned())),
        "F" => near.push((0, "degF".to_owned())),
        "rev" | "revs" | "U" | "RPM" => near.push((0, "rpm".to_owned())),
        "micron" | "microns" => near.push((0, "um".to_owned())),
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
            if divided && power == 1 {
                return Err(UnitError::Ambiguous {
                    unit: self.unit.to_owned(),
                });
            }
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
            Ok(power) if power.abs() <= 9 => Ok(Some(power)),
            _ => Err(self.malformed("a power beyond 9")),
        }
    }
}
