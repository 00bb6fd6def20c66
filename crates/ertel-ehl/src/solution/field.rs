//! The fields of a contact, once: name, unit and symbol of each. Tables, VTK files and programs in other languages take them from here.

/// A field on the contact area or along its centreline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Field {
    /// Pressure; between rough surfaces that of oil and asperities together.
    Pressure,
    /// Pressure of asperities.
    AsperityPressure,
    /// Pressure of the dry contact.
    HertzPressure,
    /// Film thickness.
    FilmThickness,
    /// Elastic deflection of both bodies together.
    Deflection,
    /// Viscosity at rest, at the pressure of the point.
    Viscosity,
    /// Density.
    Density,
    /// Shear stress along the motion at mid-film.
    ShearStressMid,
    /// The same at body 1.
    ShearStressBody1,
    /// The same at body 2.
    ShearStressBody2,
    /// Size of the shear rate at mid-film.
    ShearRateMid,
    /// Generalized viscosity at mid-film.
    GeneralizedViscosityMid,
    /// Shear stress across the motion at mid-film.
    ShearStressAcrossMid,
    /// The same at body 1.
    ShearStressAcrossBody1,
    /// The same at body 2.
    ShearStressAcrossBody2,
    /// Temperature at mid-film.
    TemperatureMid,
    /// Mean temperature across the film.
    TemperatureMean,
    /// Temperature of the surface of body 1.
    TemperatureBody1,
    /// Temperature of the surface of body 2.
    TemperatureBody2,
}

impl Field {
    /// All of them.
    pub const ALL: [Field; 19] = [
        Field::Pressure,
        Field::AsperityPressure,
        Field::HertzPressure,
        Field::FilmThickness,
        Field::Deflection,
        Field::Viscosity,
        Field::Density,
        Field::ShearStressMid,
        Field::ShearStressBody1,
        Field::ShearStressBody2,
        Field::ShearRateMid,
        Field::GeneralizedViscosityMid,
        Field::ShearStressAcrossMid,
        Field::ShearStressAcrossBody1,
        Field::ShearStressAcrossBody2,
        Field::TemperatureMid,
        Field::TemperatureMean,
        Field::TemperatureBody1,
        Field::TemperatureBody2,
    ];

    /// Name of its column in tables and of its array in VTK files: the name, and the unit as `Pa_s` or `kg_per_m3`.
    pub fn column(self) -> &'static str {
        match self {
            Field::Pressure => "pressure_Pa",
            Field::AsperityPressure => "asperity_pressure_Pa",
            Field::HertzPressure => "hertz_pressure_Pa",
            Field::FilmThickness => "film_thickness_m",
            Field::Deflection => "deflection_m",
            Field::Viscosity => "viscosity_Pa_s",
            Field::Density => "density_kg_per_m3",
            Field::ShearStressMid => "shear_stress_mid_Pa",
            Field::ShearStressBody1 => "shear_stress_body_1_Pa",
            Field::ShearStressBody2 => "shear_stress_body_2_Pa",
            Field::ShearRateMid => "shear_rate_mid_per_s",
            Field::GeneralizedViscosityMid => "generalized_viscosity_mid_Pa_s",
            Field::ShearStressAcrossMid => "shear_stress_across_mid_Pa",
            Field::ShearStressAcrossBody1 => "shear_stress_across_body_1_Pa",
            Field::ShearStressAcrossBody2 => "shear_stress_across_body_2_Pa",
            Field::TemperatureMid => "temperature_mid_K",
            Field::TemperatureMean => "temperature_mean_K",
            Field::TemperatureBody1 => "temperature_body_1_K",
            Field::TemperatureBody2 => "temperature_body_2_K",
        }
    }

    /// Its SI unit, as `Pa.s` or `kg/m^3`.
    pub fn unit(self) -> &'static str {
        match self {
            Field::Pressure
            | Field::AsperityPressure
            | Field::HertzPressure
            | Field::ShearStressMid
            | Field::ShearStressBody1
            | Field::ShearStressBody2
            | Field::ShearStressAcrossMid
            | Field::ShearStressAcrossBody1
            | Field::ShearStressAcrossBody2 => "Pa",
            Field::FilmThickness | Field::Deflection => "m",
            Field::Viscosity | Field::GeneralizedViscosityMid => "Pa.s",
            Field::Density => "kg/m^3",
            Field::ShearRateMid => "1/s",
            Field::TemperatureMid
            | Field::TemperatureMean
            | Field::TemperatureBody1
            | Field::TemperatureBody2 => "K",
        }
    }

    /// Its name without the unit, as in Python: `film_thickness`.
    pub fn name(self) -> &'static str {
        let suffix = match self.unit() {
            "Pa" => "_Pa",
            "m" => "_m",
            "Pa.s" => "_Pa_s",
            "kg/m^3" => "_kg_per_m3",
            "1/s" => "_per_s",
            _ => "_K",
        };
        let column = self.column();
        column.strip_suffix(suffix).unwrap_or(column)
    }

    /// Its name in words, for axes and legends.
    pub fn words(self) -> &'static str {
        match self {
            Field::Pressure => "pressure",
            Field::AsperityPressure => "pressure of asperities",
            Field::HertzPressure => "pressure of the dry contact",
            Field::FilmThickness => "film thickness",
            Field::Deflection => "elastic deflection of both bodies",
            Field::Viscosity => "viscosity at rest",
            Field::Density => "density",
            Field::ShearStressMid => "shear stress at mid-film",
            Field::ShearStressBody1 => "shear stress at body 1",
            Field::ShearStressBody2 => "shear stress at body 2",
            Field::ShearRateMid => "shear rate at mid-film",
            Field::GeneralizedViscosityMid => "generalized viscosity at mid-film",
            Field::ShearStressAcrossMid => "shear stress across the motion at mid-film",
            Field::ShearStressAcrossBody1 => "shear stress across the motion at body 1",
            Field::ShearStressAcrossBody2 => "shear stress across the motion at body 2",
            Field::TemperatureMid => "temperature at mid-film",
            Field::TemperatureMean => "mean temperature of the film",
            Field::TemperatureBody1 => "surface temperature of body 1",
            Field::TemperatureBody2 => "surface temperature of body 2",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every column ends in its unit, and no two fields have one name.
    #[test]
    fn names_and_units() {
        for (i, field) in Field::ALL.into_iter().enumerate() {
            assert_ne!(field.name(), field.column());
            assert!(!field.words().is_empty() && !field.unit().is_empty());
            let others = Field::ALL[..i].iter();
            assert!(others.into_iter().all(|o| o.name() != field.name()));
        }
        assert_eq!(Field::Density.name(), "density");
        assert_eq!(Field::ShearRateMid.name(), "shear_rate_mid");
    }
}
