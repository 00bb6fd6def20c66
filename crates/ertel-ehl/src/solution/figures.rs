//! The figures of a solve, mesh by mesh, and their error bars.

use serde::ser::{SerializeMap, Serializer};
use serde::{Deserialize, Serialize};

use super::{Estimate, Located, WIDEST};

use super::figure_kinds::Scope;
pub use super::figure_kinds::{ErrorClass, Kind, Section};

/// Declares the figures, each in one row: the attributes used by the report, the page, the tables, the documents and Python.
macro_rules! figures {
    ($($(#[$doc:meta])* $variant:ident, $name:literal, $symbol:literal, $words:literal, $kind:ident, $section:ident, $class:ident, $place:ident;)*) => {
        /// A figure that carries an error bar.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Figure {
            $($(#[$doc])* $variant,)*
        }

        impl Figure {
            /// Every figure, in the order of the report.
            pub const ALL: [Figure; [$($name),*].len()] = [$(Figure::$variant),*];

            /// Name in results, tables and Python.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Figure::$variant => $name,)*
                }
            }

            /// Symbol of those that are shown first; empty of the others.
            pub fn symbol(self) -> &'static str {
                match self {
                    $(Figure::$variant => $symbol,)*
                }
            }

            /// Description, as in the report.
            pub fn words(self) -> &'static str {
                match self {
                    $(Figure::$variant => $words,)*
                }
            }

            /// Physical quantity, which sets unit and number format.
            pub fn kind(self) -> Kind {
                match self {
                    $(Figure::$variant => Kind::$kind,)*
                }
            }

            /// Section of the report.
            pub fn section(self) -> Section {
                match self {
                    $(Figure::$variant => Section::$section,)*
                }
            }

            /// Lower bound of its error bar.
            pub fn error_class(self) -> ErrorClass {
                match self {
                    $(Figure::$variant => ErrorClass::$class,)*
                }
            }

            /// Whether it is somewhere on the contact area; else it belongs to the whole contact, or its place is known beforehand.
            pub fn has_place(self) -> bool {
                match self {
                    $(Figure::$variant => Scope::$place == Scope::Place,)*
                }
            }

        }
    };
}

figures! {
    /// Film thickness at the centre of the contact.
    FilmCentral, "film_central", "h_c", "central film thickness", Length, Film, Film, Whole;
    /// Smallest film thickness.
    FilmMinimum, "film_minimum", "h_min", "minimum film thickness", Length, Film, Film, Place;
    /// Smallest film thickness on the centreline.
    FilmCentrelineMinimum, "film_centreline_minimum", "", "minimum film on the centreline", Length, Film, FilmOnCentreline, Place;
    /// Mean gap of rough surfaces at the centre of the contact.
    MeanGapCentral, "mean_gap_central", "", "central mean gap", Length, Film, Integral, Whole;
    /// Smallest mean gap of rough surfaces.
    MeanGapMinimum, "mean_gap_minimum", "", "smallest mean gap", Length, Film, Integral, Place;
    /// Mean film thickness over the Hertz zone.
    FilmZoneMean, "film_zone_mean", "", "mean film in the Hertz zone", Length, Film, Integral, Whole;
    /// Largest pressure.
    PressureMaximum, "pressure_maximum", "p_max", "largest pressure", PeakPressure, Pressure, LargestPressure, Place;
    /// Top of the smooth hill of the pressure on which the centre of the contact lies.
    PressureCentral, "pressure_central", "p_c", "smooth pressure maximum", PeakPressure, Pressure, CentralPressure, Place;
    /// Largest pressure of the ridge before the outlet of a point contact, or of another pressure hill next to the central one.
    PressureRidge, "pressure_ridge", "", "pressure ridge at the outlet", PeakPressure, Pressure, PressureRidge, Place;
    /// Largest pressure over the quarter of a roller at its end y < 0.
    EdgePressureLeft, "edge_pressure_left", "", "largest pressure, end y < 0", PeakPressure, Roller, EdgePressureLeft, Place;
    /// The same at its end y > 0.
    EdgePressureRight, "edge_pressure_right", "", "largest pressure, end y > 0", PeakPressure, Roller, EdgePressureRight, Place;
    /// Moment of the pressure about the middle of a roller.
    RollerMoment, "roller_moment", "", "moment about the middle", Moment, Roller, Integral, Whole;
    /// Distance of the resultant of the pressure from the middle of a roller.
    LoadPosition, "load_position", "", "resultant force at y", Offset, Roller, Integral, Whole;
    /// Pressure spike near the outlet on the centreline.
    PressureSpike, "pressure_spike", "", "pressure spike (centreline)", PeakPressure, Pressure, Spike, Place;
    /// Where the film breaks on the centreline.
    OutletPosition, "outlet_position", "", "outlet boundary (centreline)", Position, Pressure, Outlet, Whole;
    /// Where the gap is fully flooded from, on the centreline.
    MeniscusPosition, "meniscus_position", "", "fully flooded from (centreline)", Position, Supply, Meniscus, Whole;
    /// Traction coefficient from the stress at mid-film.
    TractionCoefficient, "traction_coefficient", "µ", "traction coefficient", Coefficient, Traction, Integral, Whole;
    /// The same from the stress at the surface of body 1.
    TractionCoefficientBody1, "traction_coefficient_body_1", "", "traction coefficient, body 1", Coefficient, Traction, WallTraction, Whole;
    /// The same from the stress at the surface of body 2.
    TractionCoefficientBody2, "traction_coefficient_body_2", "", "traction coefficient, body 2", Coefficient, Traction, WallTraction, Whole;
    /// Traction force at mid-film: N, or N/m.
    TractionForce, "traction_force", "", "traction force", Force, Traction, Integral, Whole;
    /// Traction coefficient across the motion, from the stress at mid-film.
    TractionCoefficientAcross, "traction_coefficient_across", "", "traction across the motion", Coefficient, Traction, Integral, Whole;
    /// The same from the stress at the surface of body 1.
    TractionCoefficientAcrossBody1, "traction_coefficient_across_body_1", "", "traction across, body 1", Coefficient, Traction, WallTraction, Whole;
    /// The same from the stress at the surface of body 2.
    TractionCoefficientAcrossBody2, "traction_coefficient_across_body_2", "", "traction across, body 2", Coefficient, Traction, WallTraction, Whole;
    /// Traction force across the motion at mid-film: N, or N/m.
    TractionForceAcross, "traction_force_across", "", "traction force across", Force, Traction, Integral, Whole;
    /// Moment of the traction at mid-film about the contact normal.
    TractionMoment, "traction_moment", "", "moment about the contact normal", Moment, Traction, Integral, Whole;
    /// Work of the surfaces on the film: W, or W/m.
    FrictionPower, "friction_power", "", "friction power", Power, Traction, FrictionPower, Whole;
    /// Load of the asperities over the whole load.
    AsperityLoadShare, "asperity_load_share", "L", "load on asperities", Share, Asperities, Integral, Whole;
    /// Friction of the asperities over the load, along the motion.
    FrictionAsperities, "friction_asperities", "", "friction of asperities", Coefficient, Asperities, Integral, Whole;
    /// The same across the motion.
    FrictionAsperitiesAcross, "friction_asperities_across", "", "friction of asperities, across", Coefficient, Asperities, Integral, Whole;
    /// Friction of film and asperities over the load, along the motion.
    FrictionTotal, "friction_total", "", "friction of film and asperities", Coefficient, Asperities, Integral, Whole;
    /// Largest shear stress anywhere in the film.
    ShearStressMaximum, "shear_stress_maximum", "", "largest shear stress", Stress, Shear, ShearStress, Whole;
    /// Share of the Hertz zone where stress thins the fluid.
    BeyondFirstLimit, "beyond_first_limit", "", "Hertz zone thinned by shear", Share, Shear, ShareOfZone, Whole;
    /// Share where it brings the fluid to its second plateau.
    BeyondSecondLimit, "beyond_second_limit", "", "Hertz zone on the second plateau", Share, Shear, ShareOfZone, Whole;
    /// Largest temperature of the film.
    FilmTemperatureMaximum, "film_temperature_maximum", "T_max", "largest film temperature", Temperature, Temperature, FilmHottest, Place;
    /// Smallest temperature of the film.
    FilmTemperatureLowest, "film_temperature_lowest", "", "lowest film temperature", Temperature, Temperature, FilmColdest, Place;
    /// Mean temperature of the film over the Hertz zone.
    FilmTemperatureMean, "film_temperature_mean", "", "mean film temperature", Temperature, Temperature, MeanTemperature, Whole;
    /// Largest temperature of the surface of body 1.
    TemperatureBody1Maximum, "temperature_body_1_maximum", "", "largest temperature of body 1", Temperature, Temperature, Body1Hottest, Place;
    /// Its mean over the Hertz zone.
    TemperatureBody1Mean, "temperature_body_1_mean", "", "mean temperature of body 1", Temperature, Temperature, MeanTemperature, Whole;
    /// Largest temperature of the surface of body 2.
    TemperatureBody2Maximum, "temperature_body_2_maximum", "", "largest temperature of body 2", Temperature, Temperature, Body2Hottest, Place;
    /// Its mean over the Hertz zone.
    TemperatureBody2Mean, "temperature_body_2_mean", "", "mean temperature of body 2", Temperature, Temperature, MeanTemperature, Whole;
    /// Heat made by shear: W, or W/m.
    HeatShear, "heat_shear", "", "heat made by shear", Power, Heat, HeatShear, Whole;
    /// Heat made by the friction of asperities: W, or W/m.
    HeatAsperities, "heat_asperities", "", "heat made by asperities", Power, Heat, Integral, Whole;
    /// Heat made by compression, less what expansion takes: W, or W/m.
    HeatCompression, "heat_compression", "", "heat made by compression", Power, Heat, HeatCompression, Whole;
    /// Heat carried off by body 1: W, or W/m.
    HeatToBody1, "heat_to_body_1", "", "heat carried off by body 1", Power, Heat, HeatCarried, Whole;
    /// Heat carried off by body 2: W, or W/m.
    HeatToBody2, "heat_to_body_2", "", "heat carried off by body 2", Power, Heat, HeatCarried, Whole;
    /// Heat carried off by the lubricant: W, or W/m.
    HeatByFilm, "heat_by_film", "", "heat carried off by the film", Power, Heat, HeatCarried, Whole;
    /// Largest stress after von Mises in body 1.
    VonMisesBody1, "von_mises_body_1", "", "largest von Mises stress, body 1", Stress, Stress, OfBodies, Place;
    /// Largest shear stress in body 1.
    LargestShearBody1, "largest_shear_body_1", "", "largest shear stress, body 1", Stress, Stress, OfBodies, Place;
    /// Largest principal stress in body 1.
    TensionBody1, "tension_body_1", "", "largest tension, body 1", Stress, Stress, OfBodies, Place;
    /// Largest half range of the orthogonal shear in body 1.
    OrthogonalShearBody1, "orthogonal_shear_body_1", "", "half range of orthogonal shear, body 1", Stress, Stress, OfBodies, Place;
    /// Largest index of Dang Van in body 1.
    DangVanBody1, "dang_van_body_1", "", "Dang Van's index, body 1", Stress, Stress, OfBodies, Whole;
    /// Largest index of Dang Van near the surface of body 1.
    NearSurfaceDangVanBody1, "near_surface_dang_van_body_1", "", "Dang Van's index near the surface, body 1", Stress, Stress, OfBodies, Whole;
    /// Largest stress after von Mises over the yield strength in body 1.
    UtilisationBody1, "utilisation_body_1", "", "von Mises over yield strength, body 1", Share, Stress, OfBodies, Whole;
    /// Largest shear on the interfaces of the layers of body 1.
    InterfaceShearBody1, "interface_shear_body_1", "", "largest shear on interfaces, body 1", Stress, Stress, OfBodies, Place;
    /// Largest σ_zz on the interfaces of the layers of body 1.
    InterfacePullBody1, "interface_pull_body_1", "", "largest normal stress on interfaces, body 1", Stress, Stress, OfBodies, Place;
    /// Largest stress after von Mises in body 2.
    VonMisesBody2, "von_mises_body_2", "", "largest von Mises stress, body 2", Stress, Stress, OfBodies, Place;
    /// Largest shear stress in body 2.
    LargestShearBody2, "largest_shear_body_2", "", "largest shear stress, body 2", Stress, Stress, OfBodies, Place;
    /// Largest principal stress in body 2.
    TensionBody2, "tension_body_2", "", "largest tension, body 2", Stress, Stress, OfBodies, Place;
    /// Largest half range of the orthogonal shear in body 2.
    OrthogonalShearBody2, "orthogonal_shear_body_2", "", "half range of orthogonal shear, body 2", Stress, Stress, OfBodies, Place;
    /// Largest index of Dang Van in body 2.
    DangVanBody2, "dang_van_body_2", "", "Dang Van's index, body 2", Stress, Stress, OfBodies, Whole;
    /// Largest index of Dang Van near the surface of body 2.
    NearSurfaceDangVanBody2, "near_surface_dang_van_body_2", "", "Dang Van's index near the surface, body 2", Stress, Stress, OfBodies, Whole;
    /// Largest stress after von Mises over the yield strength in body 2.
    UtilisationBody2, "utilisation_body_2", "", "von Mises over yield strength, body 2", Share, Stress, OfBodies, Whole;
    /// Largest shear on the interfaces of the layers of body 2.
    InterfaceShearBody2, "interface_shear_body_2", "", "largest shear on interfaces, body 2", Stress, Stress, OfBodies, Place;
    /// Largest σ_zz on the interfaces of the layers of body 2.
    InterfacePullBody2, "interface_pull_body_2", "", "largest normal stress on interfaces, body 2", Stress, Stress, OfBodies, Place;
}

impl Figure {
    /// Those that are traced to the inputs, by derivatives or samples; of the pressure its smooth maximum: at a ridge, derivatives are those of
    /// the mesh.
    pub const TRACED: [Figure; 5] = [
        Figure::FilmCentral,
        Figure::FilmMinimum,
        Figure::PressureCentral,
        Figure::TractionCoefficient,
        Figure::FilmTemperatureMaximum,
    ];

    /// Its SI unit; in line contacts forces and powers are per metre of their length.
    pub fn unit(self, is_line: bool) -> &'static str {
        self.kind().unit(is_line)
    }

    /// Words and symbol: `central film thickness h_c`.
    pub fn title(self) -> String {
        format!("{} {}", self.words(), self.symbol())
            .trim_end()
            .to_owned()
    }
}

/// The same of a largest pressure: a mesh too coarse for a peak cuts it off, and the value is only a lower bound.
const WIDEST_OF_PEAK: f64 = 0.1;

/// Widest bar of a place, over the half-width of the contact.
pub const WIDEST_OF_PLACE: f64 = 0.25;

impl Figure {
    /// Whether it is a largest pressure, which a mesh too coarse for its peak cuts off.
    pub fn is_peak(self) -> bool {
        self.kind() == Kind::PeakPressure
    }

    /// Largest error bar with which it is shown as a number, over its size.
    pub fn widest_bar(self) -> f64 {
        match self.is_peak() {
            true => WIDEST_OF_PEAK,
            false => WIDEST,
        }
    }
}

/// Scales of a contact, relative to which figures count as zero.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// Load, N or N/m.
    pub load: f64,
    /// Half-width, m.
    pub length: f64,
    /// Hertz pressure, Pa.
    pub pressure: f64,
    /// Entrainment speed, m/s.
    pub speed: f64,
}

/// Share of the scales of a contact below which a figure is rounding error, shown as zero.
pub const ROUNDING: f64 = 1e-9;

impl Figure {
    /// Size below which a figure is shown as zero, SI.
    pub fn zero_below(self, sizes: &Sizes) -> f64 {
        let size = match self.kind() {
            Kind::Length
            | Kind::Temperature
            | Kind::Rise
            | Kind::AngularSpeed
            | Kind::Duration
            | Kind::Revolutions => 0.0,
            Kind::Speed => sizes.speed.abs(),
            Kind::PeakPressure | Kind::Stress => sizes.pressure,
            Kind::Moment => sizes.load * sizes.length,
            Kind::Position | Kind::Offset => sizes.length,
            Kind::Force => sizes.load,
            Kind::Power => sizes.load * sizes.speed.abs(),
            Kind::Coefficient | Kind::Share | Kind::Angle => 1.0,
        };
        ROUNDING * size
    }
}

/// One entry for each figure that exists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerFigure<T>([Option<T>; Figure::ALL.len()]);

/// The figures of one mesh, SI.
pub type Figures = PerFigure<Reading>;

/// Their error bars.
pub type Bars = PerFigure<Bar>;

/// A figure as read off a mesh, SI.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Reading {
    /// The figure.
    pub value: f64,
    /// Reference of relative errors: the size of the figure; for temperatures that of the rise.
    pub size: f64,
    /// Where it is, m.
    pub place: Option<[f64; 2]>,
    /// Change when the integral is truncated at half the distance, to be added to the error bar.
    pub cut: f64,
    /// Violation of an exact identity, which the error bar must cover.
    pub misfit: f64,
}

/// Half-widths of the error bar of a figure, SI.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Bar {
    /// Of its value.
    pub value: f64,
    /// Of its place, m; `None` where it has none.
    pub place: Option<f64>,
}

/// The figures of a solution with their bars.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Measured {
    /// The figures.
    #[serde(with = "in_order")]
    pub figures: Figures,
    /// The error bars that could be estimated.
    #[serde(with = "in_order")]
    pub bars: Bars,
    /// Half-width of the contact, m, which decides whether a place is resolved.
    pub half_width: f64,
}

/// All of them in their order, for files of our own.
mod in_order {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::PerFigure;

    pub fn serialize<T: Serialize, S: Serializer>(
        of: &PerFigure<T>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(&of.0)
    }

    pub fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<PerFigure<T>, D::Error> {
        let all = Vec::<Option<T>>::deserialize(deserializer)?;
        let n = all.len();
        let known = all.try_into().map(PerFigure);
        known.map_err(|_| D::Error::invalid_length(n, &"one for each figure"))
    }
}

impl<T> Default for PerFigure<T> {
    fn default() -> Self {
        PerFigure(std::array::from_fn(|_| None))
    }
}

impl<T: Copy> PerFigure<T> {
    /// The entry of a figure.
    pub fn get(&self, figure: Figure) -> Option<T> {
        self.0[figure as usize]
    }

    /// Sets the entry of a figure.
    pub fn set(&mut self, figure: Figure, about: T) {
        self.0[figure as usize] = Some(about);
    }
}

impl Reading {
    /// A figure without a place.
    pub fn new(value: f64) -> Reading {
        Reading {
            value,
            size: value.abs(),
            place: None,
            cut: 0.0,
            misfit: 0.0,
        }
    }

    /// A figure of a temperature: errors are relative to its rise, K.
    pub fn of_rise(value: f64, rise: f64) -> Reading {
        Reading {
            size: rise.abs(),
            ..Reading::new(value)
        }
    }

    /// The same figure at a place, m.
    pub fn at(self, place: [f64; 2]) -> Reading {
        Reading {
            place: Some(place),
            ..self
        }
    }
}

impl Figures {
    /// Notes a figure, unless it is not finite: an unconverged stage may have such.
    pub fn note(&mut self, figure: Figure, reading: Reading) {
        let mut place = reading.place.iter().flatten();
        if reading.value.is_finite() && place.all(|x| x.is_finite()) {
            self.set(figure, reading);
        }
    }

    /// The value of a figure, SI.
    pub fn value(&self, figure: Figure) -> Option<f64> {
        self.get(figure).map(|reading| reading.value)
    }
}

/// As its name.
impl Serialize for Figure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// By name, with places as `<name>_at`.
impl Serialize for Figures {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for figure in Figure::ALL {
            let Some(reading) = self.get(figure) else {
                continue;
            };
            map.serialize_entry(figure.name(), &reading.value)?;
            if let Some(place) = reading.place {
                map.serialize_entry(&format!("{}_at", figure.name()), &place)?;
            }
        }
        map.end()
    }
}

impl Measured {
    /// The same with zeros where figures and bars are rounding errors.
    pub fn without_rounding(mut self, sizes: &Sizes) -> Measured {
        for figure in Figure::ALL {
            let Some(reading) = self.figures.get(figure) else {
                continue;
            };
            let below = figure.zero_below(sizes);
            if reading.value.abs() >= below {
                continue;
            }
            self.figures.set(
                figure,
                Reading {
                    value: 0.0,
                    ..reading
                },
            );
            if let Some(bar) = self.bars.get(figure).filter(|bar| bar.value < below) {
                self.bars.set(figure, Bar { value: 0.0, ..bar });
            }
        }
        self
    }

    /// Adds to each bar the change of its figure to another solution.
    pub fn widen_by_changes(&mut self, other: &Measured) {
        for figure in Figure::ALL {
            let values = [self, other].map(|of| of.figures.value(figure));
            if let ([Some(own), Some(other)], Some(bar)) = (values, self.bars.get(figure)) {
                let value = bar.value + (other - own).abs();
                self.bars.set(figure, Bar { value, ..bar });
            }
        }
    }

    /// A figure with its bar, if there is one.
    pub fn find(&self, figure: Figure) -> Option<Estimate> {
        Some(self.find_located(figure)?.estimate())
    }

    /// A figure that every solution has; not a number where it is missing, which no result may hold.
    pub fn estimate(&self, figure: Figure) -> Estimate {
        self.located(figure).estimate()
    }

    /// Whether its error bar, if any, is narrow enough to show the figure as a number.
    pub fn is_resolved(&self, figure: Figure) -> bool {
        let pair = self.figures.get(figure).zip(self.bars.get(figure));
        pair.is_none_or(|(reading, bar)| {
            // Temperatures: the rise, at least one kelvin. All others: the value, also that of a component much smaller than the other.
            let size = match figure.kind() {
                Kind::Temperature => reading.size.max(LEAST_RISE),
                // The distance of the mean planes of rough surfaces may vanish.
                Kind::Length => reading.size.max(reading.value.abs()),
                _ => reading.value.abs(),
            };
            bar.value <= figure.widest_bar() * size
        })
    }

    /// A figure with its bar and its place, if there is one.
    pub fn find_located(&self, figure: Figure) -> Option<Located> {
        let reading = self.figures.get(figure)?;
        let bar = self.bars.get(figure);
        let [x, y] = reading.place.unwrap_or_default();
        let place_error = bar.and_then(|bar| bar.place);
        let resolved = self.is_resolved(figure);
        let near = place_error.is_none_or(|e| e <= WIDEST_OF_PLACE * self.half_width);
        Some(Located {
            value: reading.value,
            error: bar.map(|bar| bar.value),
            resolved,
            x,
            y,
            place_error,
            // There may be a higher one elsewhere.
            place_resolved: near && (resolved || figure != Figure::PressureMaximum),
        })
    }

    /// The same of a figure that every solution has; not a number where it is missing.
    pub fn located(&self, figure: Figure) -> Located {
        self.find_located(figure).unwrap_or(Located {
            value: f64::NAN,
            error: None,
            resolved: true,
            x: f64::NAN,
            y: f64::NAN,
            place_error: None,
            place_resolved: true,
        })
    }
}

/// Rise of temperature that counts, K.
pub const LEAST_RISE: f64 = 1.0;

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand, of 100 N at 1 m/s on 0.1 mm: a coefficient of 3e-10 and a power of 9e-8 W are rounding, one of 3e-9 and 1e-3 W are not; a bar
    /// that is more than that stays.
    #[test]
    fn rounding_is_zero() {
        let sizes = Sizes {
            load: 100.0,
            length: 1e-4,
            pressure: 1e9,
            speed: 1.0,
        };
        let shown = |figure, value: f64, bar: f64| {
            let mut measured = Measured::default();
            measured.figures.note(figure, Reading::new(value));
            measured.bars.set(
                figure,
                Bar {
                    value: bar,
                    place: None,
                },
            );
            let found = measured.without_rounding(&sizes).estimate(figure);
            (found.value, found.error.unwrap())
        };
        assert_eq!(shown(Figure::TractionCoefficient, 3e-10, 1e-11), (0.0, 0.0));
        assert_eq!(
            shown(Figure::TractionCoefficient, -3e-9, 1e-11),
            (-3e-9, 1e-11)
        );
        assert_eq!(shown(Figure::TractionCoefficient, 3e-10, 0.01), (0.0, 0.01));
        assert_eq!(shown(Figure::FrictionPower, 9e-8, 1e-9), (0.0, 0.0));
        assert_eq!(shown(Figure::FrictionPower, 1e-3, 1e-9), (1e-3, 1e-9));
        assert_eq!(shown(Figure::FilmCentral, 1e-13, 1e-15), (1e-13, 1e-15));
    }

    /// A bar of half of a figure leaves a number, one of more does not; a peak is a number with a tenth, and a temperature by its rise.
    #[test]
    fn bars_say_what_is_resolved() {
        let resolved = |figure, reading: Reading, bar: f64| {
            let mut measured = Measured::default();
            measured.figures.note(figure, reading);
            measured.bars.set(
                figure,
                Bar {
                    value: bar,
                    place: None,
                },
            );
            measured.is_resolved(figure)
        };
        let film = Reading::new(2e-7);
        assert!(resolved(Figure::FilmMinimum, film, 0.9e-7));
        // One of two components, whose errors are relative to both: judged by its own value.
        let component = Reading {
            size: 0.01,
            ..Reading::new(-3e-6)
        };
        assert!(!resolved(Figure::TractionCoefficient, component, 4e-5));
        assert!(resolved(Figure::TractionCoefficient, component, 1e-6));
        assert!(!resolved(Figure::FilmMinimum, film, 1.1e-7));
        let peak = Reading::new(1e9);
        assert!(resolved(Figure::PressureMaximum, peak, 0.9e8));
        assert!(!resolved(Figure::PressureMaximum, peak, 3.4e8));
        let hot = |value: f64| Reading {
            size: value - 300.0,
            ..Reading::new(value)
        };
        assert!(resolved(Figure::FilmTemperatureMaximum, hot(340.0), 15.0));
        assert!(!resolved(Figure::FilmTemperatureMaximum, hot(340.0), 25.0));
        assert!(resolved(Figure::FilmTemperatureMaximum, hot(300.1), 0.4));
    }

    #[test]
    fn figures_are_written_by_name_with_their_places() {
        let mut figures = Figures::default();
        figures.note(Figure::FilmCentral, Reading::new(2e-7));
        figures.note(Figure::PressureSpike, Reading::new(8e8).at([1e-4, 0.0]));
        figures.note(Figure::FrictionPower, Reading::new(f64::NAN));
        let json = serde_json::to_value(figures).unwrap();
        let expected = serde_json::json!({ "film_central": 2e-7, "pressure_spike": 8e8, "pressure_spike_at": [1e-4, 0.0] });
        assert_eq!(json, expected);
        for (i, figure) in Figure::ALL.into_iter().enumerate() {
            assert_eq!(figure as usize, i);
            assert!(!Figure::ALL[..i].iter().any(|f| f.name() == figure.name()));
        }
    }
}
