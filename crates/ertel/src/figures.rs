//! The figures of machines and of whole runs: their registry, and the rows in which results hold them. Those of single contacts are in [`Figure`].

pub mod at_contacts;

use crate::mark::Marked;
use crate::solution::{Figure, Kind};

/// Attributes of a figure, used by reports, pages, tables, documents and Python.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Name in results and Python: `friction_torque`.
    pub name: &'static str,
    /// Description, as in the report.
    pub words: &'static str,
    /// Physical quantity, which sets unit and number format.
    pub kind: Kind,
    /// Part of the report.
    pub section: Section,
}

/// Parts of the report of a machine, in their order, and the figures of whole runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Loads and motion.
    Mechanics,
    /// Films over roughness.
    Films,
    /// Friction, power and heat.
    Friction,
    /// Surface and bulk temperatures.
    Temperature,
    /// Safety against damage.
    Safety,
    /// Rating life.
    Life,
    /// At each contact of a machine: in tables and pictures, not in the report.
    Contacts,
    /// Of a run: extremes, means and final values of figures that have error bars.
    Instants,
    /// Of a run: figures without error bars.
    Run,
}

impl Section {
    /// Sections of the report of a machine.
    pub const OF_MACHINES: [Section; 6] = [
        Section::Mechanics,
        Section::Films,
        Section::Friction,
        Section::Temperature,
        Section::Safety,
        Section::Life,
    ];

    /// Its heading.
    pub fn heading(self) -> &'static str {
        match self {
            Section::Mechanics => "Loads and motion",
            Section::Films => "Films",
            Section::Friction => "Friction",
            Section::Temperature => "Temperature",
            Section::Safety => "Safety",
            Section::Life => "Life",
            Section::Contacts => "Contacts",
            Section::Instants | Section::Run => "Results",
        }
    }
}

/// A figure of a machine or of a whole run, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its attributes.
    pub figure: Definition,
    /// Its SI unit; empty of a pure number.
    pub unit: &'static str,
    /// Value, error bar and marks. The bar is that of the solved contacts and of their distance in place or time; `None` where it comes from a formula
    /// alone.
    pub estimate: Marked,
    /// Instant, s; `None` for machines and for means.
    pub time: Option<f64>,
    /// Source of the formula, or omitted parts.
    pub source: &'static str,
}

impl Definition {
    /// A row of a whole machine, whose forces and powers are never per length; `source` is that of the formula, or states omitted parts.
    pub(crate) fn row(self, estimate: impl Into<Marked>, source: &'static str) -> Row {
        Row {
            figure: self,
            unit: self.kind.unit(false),
            estimate: estimate.into(),
            time: None,
            source,
        }
    }

    /// Whether it belongs to a run in time.
    pub fn is_of_run(&self) -> bool {
        matches!(self.section, Section::Instants | Section::Run)
    }

    /// Whether tables have a column for its error bar.
    pub fn has_bar(&self) -> bool {
        self.section != Section::Run
    }
}

/// The row of a figure with this name.
pub fn find<'a>(rows: &'a [Row], name: &str) -> Option<&'a Row> {
    rows.iter().find(|row| row.figure.name == name)
}

/// Description of a contact's or a run's figure by its name in tables; the name with spaces for others, which machines describe differently.
pub fn words_of(name: &str) -> String {
    let contact = Figure::ALL.into_iter().find(|figure| figure.name() == name);
    let of_run = || run::ALL.iter().find(|figure| figure.name == name);
    (contact.map(Figure::words))
        .or_else(|| Some(of_run()?.words))
        .map_or_else(|| name.replace('_', " "), str::to_owned)
}

/// Declares the figures of several groups, each in one row.
macro_rules! definitions {
    ($($(#[$doc:meta])* $group:ident { $($figure:ident, $name:literal, $words:literal, $kind:ident, $section:ident;)* })*) => {
        $(
            $(#[$doc])*
            pub mod $group {
                use super::{Definition, Kind, Section};

                $(
                    #[doc = concat!("`", $name, "`: ", $words, ".")]
                    pub const $figure: Definition = Definition {
                        name: $name,
                        words: $words,
                        kind: Kind::$kind,
                        section: Section::$section,
                    };
                )*

                /// All of them.
                pub const ALL: &[Definition] = &[$($figure),*];
            }
        )*
    };
}

definitions! {
    /// Figures of more than one kind of machine.
    machine {
        FILM_CENTRAL, "film_central", "smallest central film", Length, Films;
        FILM_MINIMUM, "film_minimum", "smallest film", Length, Films;
        LAMBDA_MINIMUM, "lambda_minimum", "λ (minimum film / σ)", Coefficient, Films;
        ASPERITY_LOAD_SHARE_MAXIMUM, "asperity_load_share_maximum", "largest load share of asperities", Share, Films;
        HERTZ_PRESSURE_MAXIMUM, "hertz_pressure_maximum", "largest Hertz pressure", Stress, Mechanics;
        VON_MISES_MAXIMUM, "von_mises_maximum", "largest von Mises stress in a body", Stress, Mechanics;
        ORTHOGONAL_SHEAR_MAXIMUM, "orthogonal_shear_maximum", "largest half range of orthogonal shear", Stress, Mechanics;
        FRICTION_POWER_ROLLING, "friction_power_rolling", "power lost by rolling", Power, Friction;
    }

    /// Figures of rolling bearings.
    bearing {
        ELEMENT_LOAD_MAXIMUM, "element_load_maximum", "maximum rolling-element load", Force, Mechanics;
        SLICE_LOAD_RATIO, "slice_load_ratio", "its heaviest slice over the mean of the roller", Coefficient, Mechanics;
        RIB_LOAD_MAXIMUM, "rib_load_maximum", "largest load of a roller on the rib", Force, Mechanics;
        FRICTION_POWER_SPIN, "friction_power_spin", "power lost by spin", Power, Friction;
        FRICTION_POWER_DIFFERENTIAL_SLIP, "friction_power_differential_slip", "power lost by differential slip", Power, Friction;
        FRICTION_POWER, "friction_power", "power lost in all contacts", Power, Friction;
        FRICTION_TORQUE, "friction_torque", "friction torque of all contacts", Moment, Friction;
        FRICTION_TORQUE_SKF, "friction_torque_skf", "for comparison: torque, SKF model", Moment, Friction;
        FRICTION_TORQUE_PALMGREN, "friction_torque_palmgren", "for comparison: torque, Palmgren model", Moment, Friction;
        BEARING_TEMPERATURE, "bearing_temperature", "temperature from the heat of the contacts", Temperature, Temperature;
        STATIC_SAFETY_FACTOR, "static_safety_factor", "static safety C_0/P_0", Coefficient, Safety;
        KAPPA, "kappa", "viscosity ratio κ", Coefficient, Life;
        DYNAMIC_LOAD_RATING, "dynamic_load_rating", "dynamic load rating C", Force, Life;
        EQUIVALENT_LOAD, "equivalent_load", "equivalent load P", Force, Life;
        BASIC_RATING_LIFE, "basic_rating_life", "basic rating life L_10", Revolutions, Life;
        BASIC_RATING_LIFE_TIME, "basic_rating_life_time", "basic rating life L_10h", Duration, Life;
        STATIC_LOAD_RATING, "static_load_rating", "static load rating C_0", Force, Life;
        REFERENCE_RATING_LIFE, "reference_rating_life", "reference rating life L_10r", Revolutions, Life;
        REFERENCE_RATING_LIFE_TIME, "reference_rating_life_time", "reference rating life L_10rh", Duration, Life;
        REFERENCE_EQUIVALENT_LOAD, "reference_equivalent_load", "reference equivalent load P_ref", Force, Life;
        FATIGUE_LOAD_LIMIT, "fatigue_load_limit", "fatigue load limit C_u", Force, Life;
        CONTAMINATION_FACTOR, "contamination_factor", "contamination factor e_C", Coefficient, Life;
        LIFE_FACTOR, "life_factor", "life factor a_ISO", Coefficient, Life;
        RELIABILITY_FACTOR, "reliability_factor", "reliability factor a_1", Coefficient, Life;
        MODIFIED_RATING_LIFE, "modified_rating_life", "modified rating life L_nmr", Revolutions, Life;
        MODIFIED_RATING_LIFE_TIME, "modified_rating_life_time", "modified rating life L_nmrh", Duration, Life;
    }

    /// Figures of pairs of gears.
    gears {
        TRANSVERSE_CONTACT_RATIO, "transverse_contact_ratio", "transverse contact ratio", Coefficient, Mechanics;
        OVERLAP_RATIO, "overlap_ratio", "overlap ratio", Coefficient, Mechanics;
        TOTAL_CONTACT_RATIO, "total_contact_ratio", "total contact ratio", Coefficient, Mechanics;
        HERTZ_PRESSURE_MAXIMUM_POSITION, "hertz_pressure_maximum_position", "at the distance from the pitch point", Length, Mechanics;
        FILM_MINIMUM_POSITION, "film_minimum_position", "smallest film at the distance from the pitch point", Length, Films;
        FRICTION_COEFFICIENT_MEAN, "friction_coefficient_mean", "mean coefficient of friction of sliding", Coefficient, Friction;
        FRICTION_POWER_SLIDING, "friction_power_sliding", "power lost by sliding", Power, Friction;
        FRICTION_POWER, "friction_power", "power lost in the mesh", Power, Friction;
        MESH_LOSS, "mesh_loss", "over the power at the pinion", Share, Friction;
        MESH_EFFICIENCY, "mesh_efficiency", "efficiency of the mesh", Share, Friction;
        LOSS_FACTOR, "loss_factor", "loss factor H_V of this load sharing", Coefficient, Friction;
        LOSS_FACTOR_OHLENDORF, "loss_factor_ohlendorf", "loss factor H_V after Ohlendorf", Coefficient, Friction;
        FRICTION_COEFFICIENT_SCHLENK, "friction_coefficient_schlenk", "mean coefficient of friction after Schlenk", Coefficient, Friction;
        FRICTION_POWER_MODELS, "friction_power_models", "power lost after Ohlendorf and Schlenk", Power, Friction;
        BULK_TEMPERATURE, "bulk_temperature", "bulk temperature of the teeth", Temperature, Temperature;
        FLASH_TEMPERATURE, "flash_temperature", "largest flash temperature (rise)", Rise, Temperature;
        FLASH_TEMPERATURE_POSITION, "flash_temperature_position", "at the distance from the pitch point", Length, Temperature;
        CONTACT_TEMPERATURE, "contact_temperature", "largest contact temperature", Temperature, Temperature;
        FLASH_TEMPERATURE_BLOK, "flash_temperature_blok", "flash temperature after Blok, to compare", Rise, Temperature;
        CONTACT_TEMPERATURE_BLOK, "contact_temperature_blok", "contact temperature after Blok, to compare", Temperature, Temperature;
        SCUFFING_SAFETY, "scuffing_safety", "safety against scuffing S_B", Coefficient, Safety;
        SPECIFIC_FILM_MINIMUM, "specific_film_minimum", "smallest specific film λ_GF", Coefficient, Safety;
        MICROPITTING_SAFETY, "micropitting_safety", "safety against micropitting S_λ", Coefficient, Safety;
    }

    /// Figures of cams.
    cam {
        HERTZ_PRESSURE_MAXIMUM_ANGLE, "hertz_pressure_maximum_angle", "at the angle of the cam", Angle, Mechanics;
        PRESSURE_ANGLE_MAXIMUM, "pressure_angle_maximum", "largest pressure angle", Angle, Mechanics;
        TORQUE_MAXIMUM, "torque_maximum", "largest torque of the follower's force", Moment, Mechanics;
        FILM_MINIMUM_ANGLE, "film_minimum_angle", "smallest film at the angle of the cam", Angle, Films;
        FRICTION_POWER, "friction_power", "mean power lost over a turn", Power, Friction;
        FRICTION_TORQUE, "friction_torque", "mean friction torque", Moment, Friction;
    }

    /// Figures along the path of contact of a pair of gears.
    path {
        ROLL_DISTANCE, "roll_distance", "distance along the line of action from the pinion's base circle", Length, Contacts;
        ROLL_ANGLE, "roll_angle", "roll angle of the pinion", Angle, Contacts;
        LOAD_SHARE, "load_share", "load share X", Coefficient, Contacts;
        LOAD, "load", "load per length of contact line", Force, Contacts;
        HERTZ_PRESSURE, "hertz_pressure", "Hertz pressure", Stress, Contacts;
        SLIDING_SPEED, "sliding_speed", "sliding speed of the pinion's flank against the wheel's", Speed, Contacts;
        SPECIFIC_SLIDING_PINION, "specific_sliding_pinion", "specific sliding ζ of the pinion", Coefficient, Contacts;
        SPECIFIC_SLIDING_WHEEL, "specific_sliding_wheel", "specific sliding ζ of the wheel", Coefficient, Contacts;
        FRICTION_COEFFICIENT, "friction_coefficient", "coefficient of friction, its size", Coefficient, Contacts;
        FRICTION_POWER, "friction_power", "friction power", Power, Contacts;
        FLASH_TEMPERATURE, "flash_temperature", "flash temperature (rise)", Rise, Contacts;
        CONTACT_TEMPERATURE, "contact_temperature", "contact temperature", Temperature, Contacts;
        FLASH_TEMPERATURE_BLOK, "flash_temperature_blok", "flash temperature after Blok, to compare", Rise, Contacts;
        SPECIFIC_FILM, "specific_film", "specific film λ_GF", Coefficient, Contacts;
    }

    /// Figures of the elements of a bearing at both rings.
    element {
        ELEMENT_LOAD, "element_load", "load of the element on the ring", Force, Contacts;
        CONTACT_ANGLE, "contact_angle", "contact angle", Angle, Contacts;
        SPIN_SPEED, "spin_speed", "spin of the element against the ring", AngularSpeed, Contacts;
        ELEMENT_SPEED, "element_speed", "speed of the element about its axis, seen from the cage", AngularSpeed, Contacts;
        ORBIT_SPEED, "orbit_speed", "speed of the element's orbit", AngularSpeed, Contacts;
        ATTITUDE, "attitude", "inclination of the element's axis to that of the bearing", Angle, Contacts;
        CENTRIFUGAL_FORCE, "centrifugal_force", "centrifugal force of the element", Force, Contacts;
        GYROSCOPIC_MOMENT, "gyroscopic_moment", "gyroscopic moment of the element", Moment, Contacts;
        RIB_LOAD, "rib_load", "load of the element on the rib", Force, Contacts;
    }

    /// Figures of a cam over a turn.
    turn {
        LIFT, "lift", "lift of the follower", Length, Contacts;
        FOLLOWER_FORCE, "follower_force", "force along the motion of the follower", Force, Contacts;
        PRESSURE_ANGLE, "pressure_angle", "pressure angle", Angle, Contacts;
        ENTRAINMENT_SPEED, "entrainment_speed", "entrainment speed, negative where it runs against the turning of the cam", Speed, Contacts;
        SLIDING_SPEED, "sliding_speed", "sliding speed of the cam against the follower", Speed, Contacts;
    }

    /// Figures of whole runs in time.
    run {
        FILM_CENTRAL_LOWEST, "film_central_lowest", "lowest central film thickness", Length, Instants;
        FILM_CENTRAL_HIGHEST, "film_central_highest", "highest central film thickness", Length, Instants;
        FILM_CENTRAL_LAST, "film_central_last", "central film thickness at the end", Length, Instants;
        FILM_MINIMUM_LOWEST, "film_minimum_lowest", "lowest minimum film thickness", Length, Instants;
        MEAN_GAP_MINIMUM_LOWEST, "mean_gap_minimum_lowest", "lowest mean gap", Length, Instants;
        FILM_MINIMUM_LAST, "film_minimum_last", "minimum film thickness at the end", Length, Instants;
        PRESSURE_MAXIMUM_HIGHEST, "pressure_maximum_highest", "highest pressure maximum", PeakPressure, Instants;
        TRACTION_COEFFICIENT_HIGHEST, "traction_coefficient_highest", "highest traction coefficient", Coefficient, Instants;
        TRACTION_COEFFICIENT_MEAN, "traction_coefficient_mean", "mean traction coefficient", Coefficient, Instants;
        ASPERITY_LOAD_SHARE_HIGHEST, "asperity_load_share_highest", "highest load share of asperities", Share, Instants;
        FRICTION_TOTAL_HIGHEST, "friction_total_highest", "highest friction of film and asperities", Coefficient, Instants;
        FRICTION_TOTAL_MEAN, "friction_total_mean", "mean friction of film and asperities", Coefficient, Instants;
        FRICTION_POWER_MEAN, "friction_power_mean", "mean friction power", Power, Instants;
        FILM_TEMPERATURE_MAXIMUM_HIGHEST, "film_temperature_maximum_highest", "highest film temperature", Temperature, Instants;
        VON_MISES_BODY_1_HIGHEST, "von_mises_body_1_highest", "highest von Mises stress, body 1", Stress, Instants;
        VON_MISES_BODY_2_HIGHEST, "von_mises_body_2_highest", "highest von Mises stress, body 2", Stress, Instants;
        NEAR_SURFACE_DANG_VAN_BODY_1_HIGHEST, "near_surface_dang_van_body_1_highest", "highest Dang Van's index near the surface, body 1", Stress, Instants;
        NEAR_SURFACE_DANG_VAN_BODY_2_HIGHEST, "near_surface_dang_van_body_2_highest", "highest Dang Van's index near the surface, body 2", Stress, Instants;
        AMPLITUDE_RATIO_LOWEST, "amplitude_ratio_lowest", "lowest amplitude ratio of the waves", Coefficient, Run;
        AMPLITUDE_RATIO_HIGHEST, "amplitude_ratio_highest", "highest amplitude ratio of the waves", Coefficient, Run;
        AMPLITUDE_RATIO_LAST, "amplitude_ratio_last", "amplitude ratio of the waves at the end", Coefficient, Run;
        FILM_FORCE_HIGHEST, "film_force_highest", "highest film force", Force, Run;
        APPROACH_HIGHEST, "approach_highest", "largest approach", Length, Run;
        COEFFICIENT_OF_RESTITUTION, "coefficient_of_restitution", "coefficient of restitution", Coefficient, Run;
        MASS_ERROR_HIGHEST, "mass_error_highest", "largest mass error of a step", Share, Run;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Among the figures of one result no name occurs twice; where results of several kinds share a name, they share quantity and section.
    #[test]
    fn names_are_unique() {
        let of_machines = [bearing::ALL, gears::ALL, cam::ALL].map(|own| [machine::ALL, own]);
        for groups in of_machines.into_iter().chain([[run::ALL, &[]]]) {
            let names: Vec<&str> = groups.into_iter().flatten().map(|f| f.name).collect();
            for (i, name) in names.iter().enumerate() {
                assert!(!names[..i].contains(name), "{name} twice");
            }
        }
        let all = [machine::ALL, bearing::ALL, gears::ALL, cam::ALL].concat();
        for figure in &all {
            for other in all.iter().filter(|other| other.name == figure.name) {
                let same = (figure.kind, figure.section);
                assert_eq!((other.kind, other.section), same, "{}", figure.name);
            }
            assert!(!figure.is_of_run());
        }
        for group in [path::ALL, element::ALL, turn::ALL] {
            for (i, figure) in group.iter().enumerate() {
                let is_named = |other: &&Definition| other.name == figure.name;
                assert!(!group[..i].iter().any(|other| is_named(&other)));
                assert_eq!(figure.section, Section::Contacts);
                let of_machine = all.iter().find(is_named);
                assert!(of_machine.is_none_or(|other| other.kind == figure.kind));
            }
        }
        for figure in run::ALL {
            let contact = Figure::ALL.into_iter().any(|of| of.name() == figure.name);
            let machine = all.iter().any(|of| of.name == figure.name);
            assert!(
                figure.is_of_run() && !contact && !machine,
                "{}",
                figure.name
            );
        }
    }

    #[test]
    fn names_in_words() {
        assert_eq!(words_of("film_minimum"), "minimum film thickness");
        assert_eq!(words_of("approach_highest"), "largest approach");
        assert_eq!(words_of("friction_torque"), "friction torque");
    }
}
