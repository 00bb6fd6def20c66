//! The forms of film formulas.

use std::borrow::Cow;

use crate::contact::Family;
use crate::reference::{ElasticExponents, Fraction};

/// The closed family of forms. Groups are those of [`crate::contact::Groups`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmForm {
    /// In Moes' groups, with the exponents of similarity for the rest (Habchi 2008, eqs. 6.3, 6.4).
    ///
    /// h = c R √(2U) M^a L^b
    Moes,
    /// In the groups of Hamrock and Dowson (1977), for circular contacts without the term of ellipticity, and of Dowson and
    /// Higginson (1966) for line contacts.
    ///
    /// h = c R U^a G^b W^d
    HamrockDowson(Family),
    /// The elastic-isoviscous and the elastic-piezoviscous asymptote, blended: the central film of elastic bodies from L = 0
    /// on, with the exponents of Nijenbanning, Venner and Moes (1994) and, in line contacts, Moes.
    ///
    /// h = R √(2U) [(c_1 M^m)^s + (c_2 M^n L^(3/4))^s]^(1/s)
    ///
    /// m = -2/15, n = -1/12; in line contacts m = -1/5, n = -1/8
    Blend(Family),
    /// Over the entrainment speed u alone, as rigs measure it.
    ///
    /// h = c (u/(1 m/s))^a
    Speed,
    /// Over entrainment speed u and load F, in line contacts per length, w.
    ///
    /// h = c (u/(1 m/s))^a (F/(1 N))^b
    SpeedLoad(Family),
    /// Ellipses with the motion at any angle, in the groups along the principal direction nearest to it: the shape of
    /// Chittenden et al. (1985) along either axis, and between the axes what the components of the speed make of these.
    ///
    /// ```text
    ///   h = c R_x U^a G^b W^d [S(D)^(2/a) cos²θ + (D^(1−a−2d) S(1/D))^(2/a) sin²θ]^(a/2)
    ///   D = R_y/R_x,  S(D) = 1 − exp(−e D^f)
    /// ```
    Elliptical,
}

/// A variable of a form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Symbol.
    pub symbol: &'static str,
    /// Its word in messages.
    pub name: &'static str,
    /// Unit; empty for a group.
    pub unit: &'static str,
}

const fn group(symbol: &'static str) -> Variable {
    Variable {
        symbol,
        name: symbol,
        unit: "",
    }
}

const MOES: &[Variable] = &[group("M"), group("L")];
const GROUPS: &[Variable] = &[group("U"), group("G"), group("W")];
const ELLIPSES: &[Variable] = &[
    group("U"),
    group("G"),
    group("W"),
    group("R_y/R_x"),
    Variable {
        symbol: "θ",
        name: "the angle",
        unit: "rad",
    },
];
const SPEED: Variable = Variable {
    symbol: "u",
    name: "the speed",
    unit: "m/s",
};
const SPEED_AND_FORCE: &[Variable] = &[
    SPEED,
    Variable {
        symbol: "F",
        name: "the load",
        unit: "N",
    },
];
const SPEED_AND_LINE_LOAD: &[Variable] = &[
    SPEED,
    Variable {
        symbol: "w",
        name: "the load",
        unit: "N/m",
    },
];

/// Reason why a form is not available.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FormError {
    /// There is no form of this name.
    #[error("there is no form `{0}`; the forms are {names}", names = FilmForm::NAMES.join(", "))]
    Name(String),
    /// It differs with the shape of the contact, which is not known.
    #[error(
        "the form `{0}` depends on the shape of the contact: a column `load_N` (circular) or `load_N_per_m` (line) is needed"
    )]
    Shape(String),
}

impl FilmForm {
    /// Names of the forms.
    pub const NAMES: [&'static str; 6] = [
        "moes",
        "hamrock-dowson",
        "elliptical",
        "blend",
        "speed",
        "speed-load",
    ];

    /// The form of this name, for contacts of this shape.
    ///
    /// # Errors
    ///
    /// [`FormError`].
    pub fn named(name: &str, contact: Option<Family>) -> Result<FilmForm, FormError> {
        let shape = || contact.ok_or_else(|| FormError::Shape(name.to_owned()));
        match name {
            "moes" => Ok(Self::Moes),
            "hamrock-dowson" => Ok(Self::HamrockDowson(shape()?)),
            "elliptical" => Ok(Self::Elliptical),
            "blend" => Ok(Self::Blend(shape()?)),
            "speed" => Ok(Self::Speed),
            "speed-load" => Ok(Self::SpeedLoad(shape()?)),
            _ => Err(FormError::Name(name.to_owned())),
        }
    }

    /// The formula with letters for its constants.
    pub fn formula(self) -> Cow<'static, str> {
        match self {
            Self::Moes => "h = c R √(2U) M^a L^b".into(),
            Self::HamrockDowson(_) => "h = c R U^a G^b W^d".into(),
            Self::Blend(contact) => {
                let [m, n, l] = ElasticExponents::of(contact).in_order();
                format!("h = R √(2U) [(c_1 M^({m}))^s + (c_2 M^({n}) L^({l}))^s]^(1/s)").into()
            }
            Self::Speed => "h = c (u/(1 m/s))^a".into(),
            Self::SpeedLoad(Family::Cylinder) => "h = c (u/(1 m/s))^a (w/(1 N/m))^b".into(),
            Self::SpeedLoad(Family::Point) => "h = c (u/(1 m/s))^a (F/(1 N))^b".into(),
            Self::Elliptical => {
                "h = c R_x U^a G^b W^d [(1 - exp(-e D^f))^(2/a) cos²θ + (D^(1-a-2d) (1 - exp(-e D^(-f))))^(2/a) sin²θ]^(a/2), \
                 D = R_y/R_x"
                    .into()
            }
        }
    }

    /// Names of the constants.
    pub fn constants(self) -> &'static [&'static str] {
        match self {
            Self::Moes | Self::SpeedLoad(_) => &["c", "a", "b"],
            Self::HamrockDowson(_) => &["c", "a", "b", "d"],
            Self::Blend(_) => &["c_1", "c_2", "s"],
            Self::Speed => &["c", "a"],
            Self::Elliptical => &["c", "a", "b", "d", "e", "f"],
        }
    }

    /// Whether each constant is above zero by its meaning.
    pub fn positive(self) -> &'static [bool] {
        match self {
            Self::Moes | Self::SpeedLoad(_) => &[true, false, false],
            Self::HamrockDowson(_) => &[true, false, false, false],
            Self::Blend(_) => &[true; 3],
            Self::Speed => &[true, false],
            Self::Elliptical => &[true, true, false, false, true, true],
        }
    }

    /// Unit of the first constant.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Speed | Self::SpeedLoad(_) => "m",
            Self::Moes | Self::HamrockDowson(_) | Self::Blend(_) | Self::Elliptical => "",
        }
    }

    /// The variables; in power laws each has an exponent, in this order. Those of ellipses are of the contact seen
    /// from the principal direction x that is nearest to the motion: θ lies between 0 and 45 degrees.
    pub fn variables(self) -> &'static [Variable] {
        match self {
            Self::Moes | Self::Blend(_) => MOES,
            Self::HamrockDowson(_) => GROUPS,
            Self::Elliptical => ELLIPSES,
            Self::Speed => &SPEED_AND_FORCE[..1],
            Self::SpeedLoad(Family::Cylinder) => SPEED_AND_LINE_LOAD,
            Self::SpeedLoad(Family::Point) => SPEED_AND_FORCE,
        }
    }

    /// Film thickness by the form, m, with the constants in the order of [`Self::constants`].
    pub fn film(self, constants: &[f64], state: &FilmState) -> f64 {
        if self == Self::Elliptical {
            return elliptical(constants, state);
        }
        if let Self::Blend(contact) = self {
            let [c_1, c_2, s] = [constants[0], constants[1], constants[2]];
            let [m, l] = [state.variables[0], state.variables[1]];
            let exponents = ElasticExponents::of(contact).in_order();
            let [isoviscous_m, piezoviscous_m, piezoviscous_l] = exponents.map(Fraction::value);
            let isoviscous = c_1 * m.powf(isoviscous_m);
            let piezoviscous = c_2 * m.powf(piezoviscous_m) * l.powf(piezoviscous_l);
            // The larger one outside, so that no power overflows.
            let larger = isoviscous.max(piezoviscous);
            let sum = (isoviscous / larger).powf(s) + (piezoviscous / larger).powf(s);
            return state.scale * larger * sum.powf(1.0 / s);
        }
        let powers = state.variables.iter().zip(&constants[1..]);
        powers.fold(constants[0] * state.scale, |h, (v, e)| h * v.powf(*e))
    }
}

/// Factor of ellipticity and angle, for D = R_y/R_x (-) and the angle θ (rad) of the motion to x.
///
/// ```text
///   Φ = [(1 − exp(−e D^f))^(2/a) cos²θ + (D^(1−a−2d) (1 − exp(−e D^(−f))))^(2/a) sin²θ]^(a/2)
/// ```
/// The first term is the film of a motion along x in the form of Chittenden et al. 1985 (f = 2/3), the second one that of a
/// motion along y in the same groups: R_y = D R_x, U_y = U/D, W_y = W/D². Films rise with u^a, so h^(2/a) of the two
/// components of the speed add up as the squares of these do: a circle does not feel the angle, a long cylinder
/// feels the component across its axis alone.
pub(super) fn factor([a, d, e, f]: [f64; 4], ratio: f64, angle: f64) -> f64 {
    // ln(1 − exp(−e D^f))
    let shape = |power: f64| (-(-e * ratio.powf(power)).exp_m1()).ln();
    let along = shape(f);
    let sine = angle.sin();
    if sine == 0.0 {
        return along.exp();
    }
    let across = (1.0 - a - 2.0 * d) * ratio.ln() + shape(-f);
    // The larger film outside, so that no power overflows.
    let (larger, n) = (along.max(across), 2.0 / a);
    let term = |film: f64, share: f64| share * (n * (film - larger)).exp();
    let sum = term(along, 1.0 - sine * sine) + term(across, sine * sine);
    (larger + sum.ln() / n).exp()
}

/// Film by the form, m, with the constants c, a, b, d, e, f and the variables U, G, W, R_y/R_x and θ of a state.
fn elliptical(constants: &[f64], state: &FilmState) -> f64 {
    let &[c, a, b, d, e, f] = constants else {
        panic!("six constants, not {}", constants.len());
    };
    let &[u, g, w, ratio, angle] = &state.variables[..] else {
        panic!("five variables, not {}", state.variables.len());
    };
    let power_law = c * state.scale * u.powf(a) * g.powf(b) * w.powf(d);
    power_law * factor([a, d, e, f], ratio, angle)
}

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

/// A film with its variables.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmState {
    /// Film thickness h, m.
    pub film: f64,
    /// Length scale of the formula, m: R √(2U), R or 1 m.
    pub scale: f64,
    /// The variables of the form, in its order, SI.
    pub variables: Vec<f64>,
    /// Error bar as a share of the film, where it has one.
    pub error: Option<f64>,
}
