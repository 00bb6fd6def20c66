//! Suggestions for names that are not in the database.

use crate::data_sheet::ISO_VG_NAMES;

/// Suggestion for an unknown name.
pub(super) struct Meant<'c> {
    /// The nearest known name.
    pub near: Option<&'c str>,
    /// Advice to use another key instead of a name.
    pub help: Option<String>,
}

/// Other names of solids: small letters and digits alone, as [`plain`] makes them; their name here.
const SOLIDS: &[(&str, &str)] = &[
    ("stahl", "steel"),
    ("acier", "steel"),
    ("acero", "steel"),
    ("acciaio", "steel"),
    ("bearingsteel", "bearing-steel"),
    ("waelzlagerstahl", "bearing-steel"),
    ("100cr6", "bearing-steel"),
    ("52100", "bearing-steel"),
    ("aisi52100", "bearing-steel"),
    ("suj2", "bearing-steel"),
    ("gcr15", "bearing-steel"),
    ("16mncr5", "gear-steel"),
    ("20mncr5", "gear-steel"),
    ("18crnimo76", "gear-steel"),
    ("17crnimo6", "gear-steel"),
    ("casehardenedsteel", "gear-steel"),
    ("einsatzstahl", "gear-steel"),
    ("si3n4", "silicon-nitride"),
    ("siliciumnitrid", "silicon-nitride"),
    ("siliziumnitrid", "silicon-nitride"),
    ("glas", "glass"),
    ("verre", "glass"),
    ("bk7", "glass"),
    ("sodalime", "soda-lime-glass"),
    ("floatglass", "soda-lime-glass"),
    ("saphir", "sapphire"),
    ("adi", "austempered-ductile-iron"),
    ("nylon", "pa66"),
    ("nylon66", "pa66"),
    ("polyamide66", "pa66"),
    ("polyamid66", "pa66"),
    ("acetal", "pom"),
    ("delrin", "pom"),
    ("polyoxymethylene", "pom"),
    ("polyetheretherketone", "peek"),
    ("diamondlikecarbon", "dlc"),
    ("tin", "titanium-nitride"),
    ("titannitrid", "titanium-nitride"),
    ("crn", "chromium-nitride"),
    ("chromnitrid", "chromium-nitride"),
];

/// The same of fluids.
const FLUIDS: &[(&str, &str)] = &[
    ("wasser", "water"),
    ("h2o", "water"),
    ("glycerin", "glycerol"),
    ("glycerine", "glycerol"),
    ("glyzerin", "glycerol"),
    ("fva3a", "fva-3"),
    ("fvanr3", "fva-3"),
    ("nh3", "ammonia"),
    ("lox", "liquid-oxygen"),
    ("decane", "n-decane"),
    ("dodecane", "n-dodecane"),
    ("5p4e", "polyphenyl-ether-5p4e"),
    ("80w90", "gear-oil-80w-90"),
    ("sae80w90", "gear-oil-80w-90"),
    ("sae30", "turbine-oil-sae-30"),
];

/// Words of base oils in a name, and what `base_oil` calls them.
const BASE_OILS: &[(&str, &str)] = &[
    ("mineral", "mineral"),
    ("naphthen", "naphthenic"),
    ("paraffin", "mineral"),
    ("hlp", "mineral"),
    ("clp", "mineral"),
    ("pao", "PAO"),
    ("polyalphaolefin", "PAO"),
    ("ester", "ester"),
    ("pag", "PAG"),
    ("polyglycol", "PAG"),
    ("polyglykol", "PAG"),
    ("polyalkyleneglycol", "PAG"),
];

/// Small letters and digits alone, umlauts as two letters.
pub(crate) fn plain(name: &str) -> String {
    let lower = name.to_lowercase();
    let spelt = lower
        .replace('ä', "ae")
        .replace('ö', "oe")
        .replace('ü', "ue")
        .replace('ß', "ss");
    spelt.chars().filter(char::is_ascii_alphanumeric).collect()
}

/// The grade of ISO 3448 that a text names: `VG220`, `iso vg 46`, `ISO-46`, `HLP 46`, `46`; `None` of other texts and grades.
pub(crate) fn grade(text: &str) -> Option<f64> {
    let plain = plain(text);
    let marks = ["isovg", "vg", "iso", "hlpd", "hvlp", "hlp", "clp", "hees"];
    let rest = (marks.iter())
        .find_map(|mark| plain.split_once(mark).map(|(_, rest)| rest))
        .unwrap_or(&plain);
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    let grade: f64 = digits.parse().ok()?;
    ISO_VG_NAMES.contains(&grade).then_some(grade)
}

/// The kind of base oil whose name is a part of a text, such as `PAO 6`; `None` where there are several kinds, or none.
pub(crate) fn base_oil_in(text: &str) -> Option<&'static str> {
    let plain = plain(text);
    let found = |kind: &&str| {
        let words = BASE_OILS.iter().filter(|(_, oil)| oil == kind);
        words.into_iter().any(|(word, _)| plain.contains(word))
    };
    let kinds = ["mineral", "PAO", "ester", "PAG", "naphthenic"];
    match kinds.iter().filter(|kind| found(kind)).collect::<Vec<_>>()[..] {
        [kind] => Some(kind),
        _ => None,
    }
}

/// Suggestion for `name`, which is none of `choices`.
pub(super) fn meant<'c>(kind: &str, name: &str, choices: &[&'c str]) -> Meant<'c> {
    let wanted = plain(name);
    let is_fluid = kind == "fluid";
    let others = if is_fluid { FLUIDS } else { SOLIDS };
    let of_name = |name: &str| choices.iter().copied().find(|choice| *choice == name);
    let same = choices
        .iter()
        .copied()
        .find(|choice| plain(choice) == wanted);
    let other = others.iter().find(|(other, _)| *other == wanted);
    let known = same.or_else(|| other.and_then(|(_, name)| of_name(name)));
    if !is_fluid {
        let help = "a material of your own is a table: { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }";
        return Meant {
            near: known.or_else(|| nearest(&wanted, choices)),
            help: Some(help.to_owned()),
        };
    }
    let base_oil = BASE_OILS
        .iter()
        .find(|(word, _)| wanted.contains(word))
        .map(|(_, oil)| *oil);
    let looks_like_grade = ["iso", "vg", "hlp", "clp"]
        .iter()
        .any(|mark| wanted.contains(mark));
    let grade = grade(name).filter(|_| looks_like_grade && known.is_none());
    let sheet = |grade: Option<f64>, oil: &str| {
        let viscosity = match grade {
            Some(grade) => format!("iso_vg = {grade}"),
            None => {
                "kinematic_viscosity_40 = \"46 mm^2/s\", kinematic_viscosity_100 = \"6.9 mm^2/s\""
                    .to_owned()
            }
        };
        format!("lubricant = {{ temperature = \"40 degC\", {viscosity}, base_oil = \"{oil}\" }}")
    };
    if let Some(grade) = grade {
        let ending = base_oil.unwrap_or("mineral");
        let near = of_name(&format!("iso-vg-{grade}-{}", ending.to_lowercase()));
        return Meant {
            near,
            help: Some(format!(
                "an oil of a grade is a data sheet: {}",
                sheet(Some(grade), ending)
            )),
        };
    }
    if known.is_none()
        && base_oil
            .is_some_and(|_| wanted.len() < 16 && !wanted.chars().any(|c| c.is_ascii_digit()))
    {
        return Meant {
            near: None,
            help: Some(format!(
                "a kind of base oil alone does not define an oil; give its data sheet: {}",
                sheet(None, base_oil.unwrap_or_default())
            )),
        };
    }
    Meant {
        near: known.or_else(|| nearest(&wanted, choices)),
        help: Some(format!(
            "an oil that is not in the list is given by its data sheet, {}, or by a law",
            sheet(None, base_oil.unwrap_or("mineral"))
        )),
    }
}

/// The choice most like a name; a part of a name counts as much as a likeness of the whole: `squalane`, `fluid-a`.
fn nearest<'c>(wanted: &str, choices: &[&'c str]) -> Option<&'c str> {
    let similarity = |choice: &str| {
        let choice = plain(choice);
        let part = wanted.len() >= 3 && choice.contains(wanted);
        if part {
            1.0
        } else {
            strsim::jaro_winkler(&choice, wanted)
        }
    };
    let near = choices
        .iter()
        .copied()
        .max_by(|a, b| similarity(a).total_cmp(&similarity(b)));
    near.filter(|near| similarity(near) > 0.8)
}

#[cfg(test)]
mod tests {
    use super::super::{fluid_names, solid_names};
    use super::*;

    #[test]
    fn names_are_those_that_people_type() {
        for (name, near) in [
            ("Steel", "steel"),
            ("STEEL", "steel"),
            ("stahl", "steel"),
            ("100Cr6", "bearing-steel"),
            ("AISI 52100", "bearing-steel"),
            ("18CrNiMo7-6", "gear-steel"),
            ("Gear Steel", "gear-steel"),
            ("Si3N4", "silicon-nitride"),
            ("silicon nitride", "silicon-nitride"),
            ("Glas", "glass"),
            ("Delrin", "pom"),
            ("stel", "steel"),
        ] {
            let meant = meant("solid", name, &solid_names());
            assert_eq!(meant.near, Some(near), "{name}");
        }
        for (name, near, help) in [
            (
                "iso-vg-46",
                Some("iso-vg-46-mineral"),
                "iso_vg = 46, base_oil = \"mineral\"",
            ),
            (
                "VG220",
                Some("iso-vg-220-mineral"),
                "iso_vg = 220, base_oil = \"mineral\"",
            ),
            (
                "ISO VG 68",
                Some("iso-vg-68-mineral"),
                "iso_vg = 68, base_oil = \"mineral\"",
            ),
            (
                "iso vg 320 PAO",
                Some("iso-vg-320-pao"),
                "base_oil = \"PAO\"",
            ),
            (
                "HLP 46",
                Some("iso-vg-46-mineral"),
                "iso_vg = 46, base_oil = \"mineral\"",
            ),
            ("VG 1000", None, "iso_vg = 1000, base_oil = \"mineral\""),
            ("vg 220 pag", None, "iso_vg = 220, base_oil = \"PAG\""),
            ("Mineral", None, "base_oil = \"mineral\""),
            ("pag", None, "base_oil = \"PAG\""),
            ("FVA3", Some("fva-3"), "data sheet"),
            ("Wasser", Some("water"), "data sheet"),
            ("Glycerin", Some("glycerol"), "data sheet"),
            ("squalane", Some("squalane-pip"), "data sheet"),
            ("80W-90", Some("gear-oil-80w-90"), "data sheet"),
            ("PAO4", Some("pao-4"), "data sheet"),
        ] {
            let meant = meant("fluid", name, &fluid_names());
            assert_eq!(meant.near, near, "{name}");
            assert!(meant.help.unwrap().contains(help), "{name}");
        }
    }

    #[test]
    fn grades_are_read_in_words() {
        for (text, expected) in [
            ("46", Some(46.0)),
            ("VG 46", Some(46.0)),
            ("ISO VG 680", Some(680.0)),
            ("iso-vg-2", Some(2.0)),
            ("VG 45", None),
            ("oil", None),
        ] {
            assert_eq!(grade(text), expected, "{text}");
        }
    }
}
