//! The kinds of warnings: code, severity, and the explanation of each.

use std::fmt;

use serde::{Deserialize, Serialize};

/// How much a warning matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Worth knowing, but no reason to doubt a result.
    Note,
    /// Figures may differ from those of the real contact; the user decides.
    Caution,
    /// Some figures are wrong or missing: such a warning cannot be silenced.
    Unusable,
}

impl Severity {
    /// The word of messages.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Caution | Severity::Unusable => "warning",
        }
    }
}

/// Explanation of a kind, as printed by `ertel explain`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// Meaning of the warning.
    pub meaning: &'static str,
    /// When it is raised, and the source of that limit.
    pub limit: &'static str,
    /// Remedy.
    pub remedy: &'static str,
}

/// Kinds as `/// meaning` of the code, `Name "code" Severity, meaning, limit, remedy;`.
macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident $code:literal $severity:ident, $meaning:literal, $limit:literal, $remedy:literal;)*) => {
        /// Kind of a warning. Its code is stable: case files name it in `[output] silence`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum WarningKind {
            $($(#[$doc])* $name,)*
        }

        impl WarningKind {
            /// All kinds, in the order of the reference.
            pub const ALL: &[WarningKind] = &[$(WarningKind::$name),*];

            /// The code, as in JSON.
            pub fn code(self) -> &'static str {
                match self { $(WarningKind::$name => $code,)* }
            }

            /// How much it matters.
            pub fn severity(self) -> Severity {
                match self { $(WarningKind::$name => Severity::$severity,)* }
            }

            /// Its meaning, limit and remedy.
            pub fn explanation(self) -> Explanation {
                match self {
                    $(WarningKind::$name => Explanation { meaning: $meaning, limit: $limit, remedy: $remedy },)*
                }
            }
        }
    };
}

kinds! {
    // Input.
    /// A value of the case far from those of such contacts.
    UnusualInput "unusual-input" Caution,
        "A value differs from those usual for such contacts by more than a factor of ten.",
        "Ten times outside the usual range of the key, which the schema (`ertel schema`) shows.",
        "Check the unit and the power of ten.";
    /// A key that has no effect in this case.
    // Journals of earlier versions.
    #[serde(alias = "other")]
    NoEffect "no-effect" Caution,
        "A key of the case has no effect with the other settings.",
        "A rule of the case file, docs/reference/case-file.md.",
        "Remove the key, or add the setting that the message names.";
    /// A temperature that was changed, of which the laws of the lubricant know nothing.
    TemperatureIgnored "temperature-ignored" Caution,
        "A temperature is given or varied, but a law of the lubricant does not depend on temperature.",
        "Constants that hold at one temperature are used at another, or heat acts on a law without temperature.",
        "Use an oil whose law depends on temperature: `iso_vg`, two viscosities of a data sheet, or one marked so by `ertel fluids`.";
    /// Surfaces that move in opposite directions.
    OppositeMotion "opposite-motion" Caution,
        "The surfaces move in opposite directions.",
        "Slide-to-roll ratio beyond 2: u_1 u_2 = u_m^2 (1 - S^2/4) < 0.",
        "Check the signs of both speeds.";
    /// A contact too wide for the parabola of Hertz theory.
    WideContact "wide-contact" Caution,
        "The contact is not small compared with the bodies: the parabolic gap and the half-spaces are approximations.",
        "Half-width beyond 0.2 of the reduced radius, or 0.3 of the radius of a body, where the gap between two circles exceeds that between parabolas by 3/4 (y/R)^2 = 7 %.",
        "Reduce the load, or compare with a finite-element model of the bodies.";
    /// Pressures beyond what the bodies bear.
    Strength "strength" Caution,
        "The pressure deforms the bodies permanently; ertel computes them as elastic.",
        "`hertz_pressure_limit` of the weaker body, else 4.2 GPa (point) or 4.0 GPa (line), the static limit of hardened bearing steel (ISO 76).",
        "Reduce the load, or give the limit of the material.";
    /// Numbers of asperities unlike those of measured surfaces.
    AsperityData "asperity-data" Caution,
        "A number of the asperities differs from those quoted for engineering surfaces.",
        "Asperity group 0.03 to 0.07; rms height over asperity radius 1e-4 to 1e-2 (range usually quoted with Greenwood and Tripp's model).",
        "Check the roughness data.";
    /// Changes made to a measured profile.
    MeasuredProfile "measured-profile" Caution,
        "The measured profile of a roller was levelled, averaged, shifted or made monotone before it was used.",
        "Any change of the measured heights.",
        "Compare the reported changes with the accuracy of the instrument.";
    /// A map of a surface that does not cover the contact area.
    SmallMap "small-map" Caution,
        "A map of a surface is smaller than the contact area, or lies outside it: the rest of the surface is smooth.",
        "More than 1 % of the dry contact area beyond the map without its rim.",
        "Measure a larger area, give a smaller `taper`, or see the figures as those of a rough patch.";
    /// A roller whose pressure reaches its ends.
    RollerEnds "roller-ends" Caution,
        "The relief of the roller is so small that the contact reaches its ends, where half-spaces are stiffer than real bodies.",
        "Drop at the ends below 75 % of that for uniform pressure.",
        "Increase the relief.";
    /// Teeth that mesh badly.
    Gears "gears" Caution,
        "The gears have a geometry that meshes badly, or a setting without effect.",
        "Involute geometry: undercut, tips that reach roots, contact below the form diameter.",
        "Check teeth, profile shift, tip diameters and centre distance.";

    // Data of the lubricant.
    /// Pressures beyond the lubricant's data.
    PressureRange "pressure-range" Caution,
        "The pressure in the contact exceeds that of the measurements behind the lubricant's data.",
        "Upper end of the measured range; `ertel fluids show` names its source.",
        "Use data measured at higher pressure; films depend on the inlet, where pressures are low, traction on the whole contact.";
    /// Pressures beyond those that are stated for the lubricant's law in general: hardly any contact stays below.
    LawRange "law-range" Note,
        "The pressure in the contact exceeds the range stated for the viscosity law in general. Nearly every contact does this.",
        "Range in the publication of the law (Roelands 1963).",
        "Nothing for films, which form at low pressure. For traction give a shear-thinning law with a limiting stress.";
    /// A viscosity beyond the glass transition.
    Glass "glass" Unusable,
        "The viscosity law makes a glass of the lubricant: friction and shear stress are not to be used.",
        "1e12 Pa.s at the Hertz pressure, the glass transition of Yasutomi, Bair and Winer (1984).",
        "Give a shear-thinning law with a limiting stress, or a viscosity law measured at high pressure.";
    /// Temperatures beyond the lubricant's data, at the inlet.
    TemperatureRange "temperature-range" Caution,
        "The temperature of the oil lies outside the measurements behind the lubricant's data.",
        "Measured range; `ertel fluids show` names its source.",
        "Use data that cover this temperature.";
    /// The same in the film where it is hottest.
    HottestFilm "hottest-film" Caution,
        "The film becomes hotter than the measurements behind the lubricant's data cover.",
        "More than 1 K above the measured range.",
        "Use data that cover this temperature; traction depends on it more than the film.";
    /// The same in the film where it is coldest.
    ColdestFilm "coldest-film" Caution,
        "The film becomes colder than the measurements behind the lubricant's data cover.",
        "More than 1 K below the measured range.",
        "Use data that cover this temperature.";
    /// A film that a law thins whose constants are estimated.
    EstimatedThinning "estimated-thinning" Caution,
        "The estimated shear-thinning law changes the film. Its constants come from traction at high pressure and are not verified for the inlet, where the film forms.",
        "A change of the film beyond 2 %.",
        "Give a measured law, or compute films with `[solver] newtonian = true`.";

    // Films and surfaces.
    /// A film too thin for a continuum.
    ThinFilm "thin-film" Caution,
        "The film is so thin that surfaces touch or that the lubricant is no continuum.",
        "10 nm, the roughness of the best bearings; 5 nm, ten molecular layers (Habchi 2008, section 6.2).",
        "Use the minimum film as an indication only; give the roughness for mixed lubrication.";
    /// A film that is not small compared with the radius.
    ThickFilm "thick-film" Unusable,
        "The film is not small compared with the radius of the bodies: Reynolds' equation and the parabolic gap do not hold.",
        "Film beyond 0.01 of the smallest radius, where the surfaces are inclined by 0.14.",
        "Check speed, viscosity and load.";
    /// A film that roughness pierces.
    Roughness "roughness" Caution,
        "The film does not separate the rough surfaces; the film is that of smooth ones.",
        "Minimum film below 3 times the composite rms roughness (mixed), 0.05 (boundary; Zhu and Wang 2012).",
        "Give `asperity_group` and `rms_height_to_asperity_radius` for the load and friction of asperities.";
    /// Asperities that lift the surfaces off the film of a formula.
    AsperityLoad "asperity-load" Caution,
        "The asperities would carry so much of the load that the film of the formulas, that of smooth surfaces, is not theirs.",
        "Estimated load share of the asperities beyond 10 %.",
        "Solve the case: oil and asperities then share the load.";
    /// A contact area that reaches beyond the bodies.
    // Journals of earlier versions.
    #[serde(alias = "wide-area-unfelt")]
    WideArea "wide-area" Note,
        "The film forms so far from the centre that the computed inlet is longer than the body. It is computed as flooded and parabolic up to there.",
        "Contact area beyond the radius of a body.",
        "Nothing: friction is summed to the end of the bodies, and its error bar includes what the outer half of them adds.";

    // Neglected effects.
    /// Heat that an isothermal contact neglects.
    HeatLeftOut "heat-left-out" Caution,
        "The contact is isothermal, yet shear heats the inlet or friction heats the film so much that films or losses are too high.",
        "Mean rise beyond 10 K (oils lose 3 to 5 % of their viscosity per kelvin), or a thermal reduction factor below 0.9.",
        "Add `[thermal]`.";
    /// Inertia of the lubricant.
    Inertia "inertia" Caution,
        "Inertia or turbulence of the film may count; Reynolds' equation has neither.",
        "Reynolds number beyond 2000 (Habchi 2008, section 6.1), or inertia beyond 0.1 of the viscous forces.",
        "Take films as indications.";
    /// Effects that the formulas of an estimate neglect.
    EstimateScope "estimate-scope" Caution,
        "The formulas of an estimate neglect a part of the case.",
        "Starved inlet, shear thinning, or the points of a curve.",
        "`ertel solve` includes it.";

    // Friction and heat that cannot be true.
    /// Friction that no lubricant transmits.
    Friction "friction" Unusable,
        "The computed friction is beyond that of any lubricant: friction, stress and heat are not to be used. The film is not affected.",
        "Traction coefficient beyond 0.15 (traction fluids reach 0.12; Habchi 2008 computes none above 0.08), or shear stress beyond 0.1 of the pressure (limiting stresses measured are 0.03 to 0.1; Johnson, Contact Mechanics, 10.4).",
        "Give a shear-thinning law with a limiting stress (`shear_thinning = { law = \"estimate\" }` next to `base_oil`), and `[thermal]`.";
    /// A shear stress of rolling beyond what lubricants bear, where film and pressure hardly feel it.
    RollingStress "rolling-stress" Note,
        "The shear stress of pure rolling at the pressure spike is beyond that of lubricants: do not use this stress. Film and pressure hardly depend on it.",
        "Shear stress beyond 0.1 of the Hertz pressure, without sliding.",
        "Give a shear-thinning law with a limiting stress.";
    /// A film that is colder before the contact than all that flows in.
    ColdInlet "cold-inlet" Unusable,
        "The film before the contact is colder than the oil and both bodies, which is impossible: the mesh does not resolve the temperature there.",
        "2 % of the largest rise, and at least 1 K, below the coldest inflow.",
        "Move the inlet edge nearer (`[mesh] inlet`), or lower `[mesh] target_error`.";
    /// Heat that is lost or gained on the way.
    HeatBalance "heat-balance" Unusable,
        "Bodies and film carry off another heat than friction generates: the mesh does not resolve the thermal boundary layer.",
        "Heat balance open by more than 1 %.",
        "Use a finer mesh, or a nearer inlet edge.";
    /// A body that is cut off at a depth that heat reaches.
    BodyDepth "body-depth" Caution,
        "A body is at rest or slow, so that heat reaches the depth at which it is cut off at its bulk temperature: temperatures depend on that depth.",
        "Diffusion depth beyond `[thermal] depth`, with a surface rise beyond 0.5 K.",
        "Set `[thermal] depth` to where the temperature is known.";

    // Convergence and error bars.
    /// An error bar of the central film beyond the target.
    CentralFilmError "central-film-error" Caution,
        "The error bar of the central film is wider than the target.",
        "`[mesh] target_error`, else 5 %.",
        "Raise `[mesh] max_unknowns`, or move edges outward if the message asks for it.";
    /// An error bar of the minimum film beyond the target.
    MinimumFilmError "minimum-film-error" Caution,
        "The error bar of the minimum film is wider than the target.",
        "`[mesh] target_error`, else 5 %.",
        "Raise `[mesh] max_unknowns`, or move edges outward if the message asks for it.";
    /// Films without an error bar.
    NoErrorBar "no-error-bar" Caution,
        "Films have no error bar.",
        "No coarser mesh converged, or `[solver] error_estimate = false`.",
        "Set `error_estimate = true`, or a finer mesh.";
    /// A largest pressure that the mesh does not resolve.
    Spike "spike" Caution,
        "The largest pressure is that of a spike that the mesh does not resolve. The film does not depend on it.",
        "A change beyond 5 % between the last two meshes.",
        "Use `pressure_central`, or a finer mesh.";
    /// The other method, where the first one did not converge or resolve a film.
    Method "method" Note,
        "The first method did not converge or did not resolve a film; the other one (finite elements or finite volumes) did.",
        "Newton's method, or the error bars of the films, of the first one.",
        "Nothing. `[solver] method` chooses the method.";
    /// Newton's method or elements that end short of what was asked for.
    Convergence "convergence" Caution,
        "The solver stopped short of the accuracy or of the order of elements that was asked for.",
        "Residual of Newton's method.",
        "Use a finer mesh.";
    /// Elements of the first order, whose errors are larger than their bars.
    FirstOrder "first-order" Caution,
        "First-order elements have larger errors than their bars show.",
        "Measured on a roller: 3 and 4 times the differences that the bars are made of.",
        "Use `[mesh] pressure_order` 2 or more and `elastic_order = 2`.";
    /// An outlet edge before the end of the film.
    OutletEdge "outlet-edge" Unusable,
        "The film reaches the outlet edge of the contact area without breaking.",
        "Film boundary within 0.02 half-widths of the edge.",
        "Move the edge outward (`[mesh] outlet`).";
    /// An inlet edge that starves the contact.
    InletEdge "inlet-edge" Unusable,
        "The contact area begins so near that the film is starved by it.",
        "Film at the inlet edge below 20 times the central film.",
        "Move the edge outward (`[mesh] inlet`).";
    /// Sensitivities or uncertainties that were not computed.
    Sensitivities "sensitivities" Caution,
        "Sensitivities, or the uncertainty of the figures from some input, could not be computed.",
        "The message names input and reason.",
        "Vary the input in a study, or use `--monte-carlo`.";

    // Time.
    /// How long what changes at the inlet edge takes to the contact.
    OnItsWay "on-its-way" Note,
        "The oil layer changes at the inlet edge and reaches the contact later.",
        "Distance over the entrainment speed at the start.",
        "Nothing.";
    /// A change at the inlet edge that does not arrive within the duration.
    OilLayerLate "oil-layer-late" Caution,
        "The oil layer changes at the inlet edge, but the change does not reach the contact within the duration.",
        "Distance over the entrainment speed at the start, beyond `duration`.",
        "Extend `[transient] duration`, or move the inlet edge nearer.";
    /// A film that gains or loses oil in a step.
    MassBalance "mass-balance" Unusable,
        "The film gains or loses oil in a time step.",
        "1 % of the flow through the centre; beyond 5 % no figure of the instant is resolved.",
        "See the column `mass_error`; use shorter steps or a finer mesh.";
    /// A checkpoint that cannot be written.
    Checkpoint "checkpoint" Caution,
        "The checkpoint of a run in time cannot be written; the run continues.",
        "An error of the file system.",
        "Check space and permissions.";

    // Machines.
    /// Contacts of a machine that were not solved.
    NotSolved "not-solved" Unusable,
        "Contacts of a machine were not solved; totals do not include them.",
        "No convergence, radii that Hertz theory does not cover, or pressures outside 1 kPa to 5 GPa.",
        "See the reason in the message; `[mesh]` and `[solver]` change how contacts are solved.";
    /// A follower that leaves its cam.
    ContactLost "contact-lost" Unusable,
        "The follower leaves the cam.",
        "Contact force below zero.",
        "Stiffen or preload the spring, or lower the speed.";
    /// A pressure angle at which followers jam.
    PressureAngle "pressure-angle" Caution,
        "The pressure angle of the cam is steep: the follower pushes sideways and may jam in its guide.",
        "30 degrees of a follower in a straight guide, 45 degrees of an arm (Norton 2002, chapter 7; VDI 2142).",
        "Enlarge the base radius, lower the offset, or spread the rise over a wider angle.";
    /// Lifts with too few digits for their curvature.
    LiftDigits "lift-digits" Unusable,
        "The last digit of the table of lifts does not determine the radius of curvature, and so neither pressures nor films.",
        "Bar of the reduced radius beyond half of it.",
        "Give lifts with more digits, or a closed form of the motion.";
    /// Rollers as lines whose heaviest slice carries much more than the mean.
    UnevenRoller "uneven-roller" Caution,
        "Rollers are solved as lines under their mean load per length, but one slice carries much more.",
        "Heaviest slice beyond 1.5 times the mean.",
        "Set `roller_contacts = \"finite\"`.";
    /// Data without which figures of a machine are omitted.
    MissingData "missing-data" Caution,
        "A figure of the machine is not computed, or neglects an effect, because data are missing.",
        "The message names the key.",
        "Give the data.";
    /// A bearing outside the range of a rating.
    RatingRange "rating-range" Unusable,
        "The bearing is outside the range of a rating; lives or ratings are missing.",
        "Range of the standard that the message names.",
        "Use the manufacturer's ratings.";
    /// A speed beyond what bearing makers recommend.
    BearingSpeed "bearing-speed" Caution,
        "The bearing turns faster than makers recommend for its kind with a standard cage.",
        "Speed factor n d_m beyond 5e5 mm/min (balls), 4.5e5 (cylindrical) or 3.5e5 (tapered rollers): SKF, General catalogue, 2006, page 238; NSK's limits in oil are about a fifth higher.",
        "Ask the maker for the limiting speed.";
    /// A suffix of a designation that would change the figures, which are computed without it.
    DesignationSuffix "designation-suffix" Caution,
        "A suffix of the designation names something that the bearing is computed without.",
        "Ceramic balls (HC), sets of bearings (DB, DF, DT), clearances that are not in the tables.",
        "Follow the message.";
    /// A model of friction outside its range.
    FrictionModelRange "friction-model-range" Caution,
        "A model of the friction torque is omitted: the oil is too thick for it at this speed.",
        "The rolling part of SKF's model no longer rises with the viscosity.",
        "Compare with another model, or warm the oil.";
    /// An oil temperature that does not agree with the heat of the contacts.
    OilTemperature "oil-temperature" Caution,
        "The heat of the contacts leads to another temperature than that of the oil.",
        "A difference beyond 2 K by the thermal resistance of the case.",
        "Set the oil to a temperature between both and solve again.";
}

impl WarningKind {
    /// Whether it is worth knowing, but no reason to doubt a result: shown quietly.
    pub fn is_note(self) -> bool {
        self.severity() == Severity::Note
    }

    /// Whether a case may silence it.
    pub fn may_be_silenced(self) -> bool {
        self.severity() != Severity::Unusable
    }

    /// Whether a case that silences these kinds silences it.
    pub(super) fn is_silenced_by(self, silence: &[WarningKind]) -> bool {
        silence.contains(&self) && self.may_be_silenced()
    }

    /// Whether warnings of this kind are about different things, so that only equal texts are one warning.
    pub(super) fn has_own_words(self) -> bool {
        matches!(
            self,
            WarningKind::UnusualInput
                | WarningKind::NoEffect
                | WarningKind::EstimateScope
                | WarningKind::Sensitivities
                | WarningKind::NotSolved
                | WarningKind::MissingData
        )
    }

    /// The kind with a code.
    pub fn with_code(code: &str) -> Option<WarningKind> {
        Self::ALL.iter().copied().find(|kind| kind.code() == code)
    }
}

impl fmt::Display for WarningKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Codes are the names in JSON, and each occurs once.
    #[test]
    fn codes_are_those_of_json() {
        for (i, kind) in WarningKind::ALL.iter().enumerate() {
            assert_eq!(serde_json::to_value(kind).unwrap(), kind.code());
            assert_eq!(WarningKind::with_code(kind.code()), Some(*kind));
            assert!(!WarningKind::ALL[..i].contains(kind));
        }
    }

    /// Warnings about unusable figures cannot be silenced.
    #[test]
    fn unusable_figures_are_not_silenced() {
        assert!(!WarningKind::Friction.may_be_silenced());
        assert!(!WarningKind::HeatBalance.may_be_silenced());
        assert!(WarningKind::PressureRange.may_be_silenced());
    }
}
