//! Names of quantities in the titles of columns, in English and German.

/// Names of a quantity.
struct Names {
    /// The name by which the program calls it.
    own: &'static str,
    /// Other names, separated by commas, as those below.
    others: &'static str,
    /// Symbols; they may also follow or precede a name.
    symbols: &'static str,
    /// Ambiguous names; a note states the quantity assumed.
    open: &'static str,
}

/// Written as [`fold`] writes them.
const NAMES: &[Names] = &[
    Names {
        own: "pressure",
        others: "druck, ueberdruck, gauge pressure, pressure gauge, hydrostatic pressure, hydrostatischer druck, messdruck, press",
        symbols: "p, pg, p g",
        open: "",
    },
    Names {
        own: "absolute pressure",
        others: "pressure absolute, pressure abs, abs pressure, absolutdruck, absoluter druck, druck absolut, druck abs",
        symbols: "p abs, pabs",
        open: "",
    },
    Names {
        own: "temperature",
        others: "temp, temperatur, oil temperature, oil temp, lubricant temperature, lube temperature, lube temp, oeltemperatur, \
                 oel temperatur, schmierstofftemperatur, fluid temperature, test temperature, prueftemperatur, inlet temperature, \
                 oil inlet temperature, bath temperature, badtemperatur",
        symbols: "t, theta, ϑ, θ, t oil, toil",
        open: "",
    },
    Names {
        own: "viscosity",
        others: "dynamic viscosity, viscosity dynamic, dyn viscosity, absolute viscosity, shear viscosity, low shear viscosity, \
                 newtonian viscosity, visc, viskositaet, dynamische viskositaet, dyn viskositaet, viskositaet dynamisch, \
                 viskositaet dyn",
        symbols: "eta, η, mu, µ",
        open: "",
    },
    Names {
        own: "kinematic viscosity",
        others: "viscosity kinematic, kin viscosity, kinematische viskositaet, kin viskositaet, viskositaet kinematisch, viskositaet kin",
        symbols: "nu, ν, kv",
        open: "",
    },
    Names {
        own: "density",
        others: "mass density, dichte, massendichte",
        symbols: "rho, ρ",
        open: "",
    },
    Names {
        own: "entrainment speed",
        others: "rolling speed, speed, mean speed, mean rolling speed, mean entrainment speed, average speed, entrainment velocity, \
                 entraining velocity, entraining speed, rolling velocity, mean velocity, velocity, geschwindigkeit, \
                 mittlere geschwindigkeit, rollgeschwindigkeit, waelzgeschwindigkeit",
        symbols: "u, v, um, u m, ue, u e, vm, v m, u mean, ur, u r",
        open: "",
    },
    Names {
        own: "slide to roll ratio",
        others: "srr, slide roll ratio, slide to roll, sliding to rolling ratio, slide rolling ratio, slip to roll ratio, \
                 gleit waelz verhaeltnis, gleit roll verhaeltnis",
        symbols: "",
        open: "slip, schlupf, slip ratio, sliding ratio",
    },
    Names {
        own: "load",
        others: "normal load, applied load, contact load, ball load, test load, normal force, contact force, force, line load, \
                 load per length, last, pruefkraft, normalkraft, belastung, kraft, normallast, linienlast, streckenlast",
        symbols: "f, w, fn, f n",
        open: "",
    },
    Names {
        own: "film central",
        others: "central film, central film thickness, film thickness central, film central thickness, central thickness, \
                 central oil film thickness, zentrale filmdicke, zentrale schmierfilmdicke, zentraler schmierfilm, \
                 schmierfilmdicke zentral, filmdicke zentral",
        symbols: "hc, h c, hcen, h cen, h0, h 0, h central, hcentral",
        open: "film, film thickness, thickness, average film, average film thickness, mean film thickness, mean film, \
                 oil film thickness, oil film, lubricant film thickness, lubricant film, filmdicke, schmierfilm, schmierfilmdicke, \
                 schmierspalthoehe, schmierspalt, h",
    },
    Names {
        own: "film minimum",
        others: "minimum film, minimum film thickness, film thickness minimum, film minimum thickness, min film, min film thickness, \
                 film min, film thickness min, minimum thickness, minimale filmdicke, minimale schmierfilmdicke, \
                 kleinste schmierfilmdicke, schmierfilmdicke minimal, filmdicke minimal",
        symbols: "hmin, h min",
        open: "",
    },
    Names {
        own: "traction coefficient",
        others: "traction, traction coeff, coefficient of traction, friction coefficient, friction coeff, coefficient of friction, \
                 coeff of friction, friction, cof, reibwert, reibungszahl, reibzahl, reibungskoeffizient, reibbeiwert, \
                 traktionskoeffizient, traktion, traktionsbeiwert",
        symbols: "mu, µ",
        open: "",
    },
    Names {
        own: "time",
        others: "elapsed time, time elapsed, elapsed, timestamp, zeit, messzeit, laufzeit",
        symbols: "t",
        open: "",
    },
    Names {
        own: "angle",
        others: "cam angle, camshaft angle, cam rotation, rotation, winkel, drehwinkel, nockenwinkel, nockenwellenwinkel",
        symbols: "theta, ϑ, θ, phi, φ",
        open: "",
    },
    Names {
        own: "lift",
        others: "valve lift, cam lift, follower lift, tappet lift, lifter rise, displacement, follower displacement, hub, ventilhub, \
                 nockenhub, stoesselhub",
        symbols: "s, h",
        open: "",
    },
    // Places on a surface, and its heights.
    Names {
        own: "x",
        others: "x position, length, distance, position, lateral, lateral position, trace length, scan length, laenge, strecke, weg, \
                 abstand, taststrecke, messstrecke",
        symbols: "",
        open: "",
    },
    Names {
        own: "y",
        others: "y position, width, breite",
        symbols: "",
        open: "",
    },
    Names {
        own: "z",
        others: "z height, height, heights, profile, profile height, surface height, elevation, topography, hoehe, hoehen, profil, \
                 profilhoehe",
        symbols: "",
        open: "",
    },
];

/// Words next to a name that do not change its meaning.
const FILLERS: [&str; 6] = [
    "measured",
    "gemessen",
    "gemessene",
    "gemessener",
    "actual",
    "istwert",
];

/// Endings of the names of uncertainties.
const UNCERTAINTIES: [&str; 2] = [" uncertainty", " unsicherheit"];

/// How sure a name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Match {
    /// It leaves open which quantity of its kind is meant.
    Open,
    /// It is a symbol.
    Symbol,
    /// It is a name of the quantity.
    Name,
}

/// A name in small letters, with blanks for the signs between words and without umlauts: `Dyn. Viskosität_` is `dyn viskositaet`.
pub(super) fn fold(name: &str) -> String {
    let mut folded = String::with_capacity(name.len());
    for c in name.chars().flat_map(char::to_lowercase) {
        match c {
            'ä' => folded.push_str("ae"),
            'ö' => folded.push_str("oe"),
            'ü' => folded.push_str("ue"),
            'ß' => folded.push_str("ss"),
            // A combining diaeresis.
            '\u{308}' => folded.push('e'),
            'μ' => folded.push('µ'),
            c if c.is_alphanumeric() || c == '%' => folded.push(c),
            _ if folded.ends_with(' ') || folded.is_empty() => {}
            _ => folded.push(' '),
        }
    }
    folded.truncate(folded.trim_end().len());
    folded
}

/// Whether a folded name is one of the quantity that the program calls `own`, and how sure that is.
pub(super) fn matches(folded: &str, own: &str) -> Option<Match> {
    if let Some(of) = own.strip_suffix(" uncertainty") {
        let head = UNCERTAINTIES
            .iter()
            .find_map(|end| folded.strip_suffix(end))?;
        return matches(head, of);
    }
    let is_folded = own
        .bytes()
        .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b' ');
    if folded == own || (!is_folded && folded == fold(own)) {
        return Some(Match::Name);
    }
    let names = NAMES.iter().find(|names| names.own == own)?;
    let without_fillers = || {
        let words = folded.split(' ').filter(|word| !FILLERS.contains(word));
        words.collect::<Vec<_>>().join(" ")
    };
    names.matches(folded).or_else(|| {
        let plain = without_fillers();
        (plain != folded).then(|| names.matches(&plain)).flatten()
    })
}

/// The names of a list.
fn each(list: &str) -> impl Iterator<Item = &str> {
    list.split_terminator(", ")
}

/// Whether a name is in a list.
fn has(list: &str, name: &str) -> bool {
    each(list).any(|own| own == name)
}

impl Names {
    fn matches(&self, folded: &str) -> Option<Match> {
        if folded == self.own || has(self.others, folded) {
            return Some(Match::Name);
        }
        if has(self.symbols, folded) {
            return Some(Match::Symbol);
        }
        if has(self.open, folded) {
            return Some(Match::Open);
        }
        // `Druck p`, `η dynamische Viskosität`.
        each(self.symbols).find_map(|symbol| {
            let behind = folded
                .strip_suffix(symbol)
                .and_then(|rest| rest.strip_suffix(' '));
            let before = || {
                folded
                    .strip_prefix(symbol)
                    .and_then(|rest| rest.strip_prefix(' '))
            };
            let rest = behind.or_else(before)?;
            (rest == self.own || has(self.others, rest) || has(self.open, rest))
                .then_some(Match::Name)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_both_languages() {
        for (name, own, expected) in [
            ("Dyn. Viskosität", "viscosity", Some(Match::Name)),
            (
                "dynamische Viskosita\u{308}t η",
                "viscosity",
                Some(Match::Name),
            ),
            ("ν", "kinematic viscosity", Some(Match::Symbol)),
            ("ν", "viscosity", None),
            ("Öltemperatur", "temperature", Some(Match::Name)),
            ("Temperatur ϑ", "temperature", Some(Match::Name)),
            ("h_c", "film central", Some(Match::Symbol)),
            (
                "Central film thickness, h_c",
                "film central",
                Some(Match::Name),
            ),
            ("Schmierfilmdicke", "film central", Some(Match::Open)),
            ("Film", "film minimum", None),
            ("μ", "traction coefficient", Some(Match::Symbol)),
            ("COF", "traction coefficient", Some(Match::Name)),
            (
                "Slide-to-roll ratio",
                "slide to roll ratio",
                Some(Match::Name),
            ),
            ("Measured speed", "entrainment speed", Some(Match::Name)),
            ("disc speed", "entrainment speed", None),
            (
                "h_c uncertainty",
                "film central uncertainty",
                Some(Match::Symbol),
            ),
            (
                "motion.entrainment_speed",
                "motion.entrainment speed",
                Some(Match::Name),
            ),
            ("viscosity ratio", "viscosity", None),
            ("film central error", "film central", None),
        ] {
            let found = matches(&fold(name), own);
            assert_eq!(found, expected, "{name}");
        }
    }

    #[test]
    fn names_are_written_as_they_are_folded() {
        for names in NAMES {
            for list in [names.others, names.symbols, names.open] {
                for name in each(list) {
                    assert_eq!(fold(name), name);
                }
            }
        }
    }
}
