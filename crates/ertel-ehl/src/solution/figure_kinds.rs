//! Attributes of figures: quantity, section of the report, and lower bound of the error bar.

/// Physical quantity of a figure: its unit, and how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A film thickness or another length, m.
    Length,
    /// A place along the motion, m; shown in half-widths.
    Position,
    /// A distance from the middle of a roller, m.
    Offset,
    /// A largest pressure, Pa; a lower bound where the mesh does not resolve its peak.
    PeakPressure,
    /// A stress, Pa.
    Stress,
    /// A force over the load.
    Coefficient,
    /// A share; shown in per cent.
    Share,
    /// A force, N; in line contacts N/m.
    Force,
    /// A moment, N m.
    Moment,
    /// A power, W; in line contacts W/m.
    Power,
    /// A temperature, K.
    Temperature,
    /// A rise of a temperature, K.
    Rise,
    /// An angle, rad.
    Angle,
    /// A speed, m/s.
    Speed,
    /// An angular speed, rad/s.
    AngularSpeed,
    /// A time, s.
    Duration,
    /// A number of turns in millions.
    Revolutions,
}

impl Kind {
    /// SI unit, empty of pure numbers; line contacts have forces and powers per metre of their length.
    pub fn unit(self, is_line: bool) -> &'static str {
        match (self, is_line) {
            (Kind::Length | Kind::Position | Kind::Offset, _) => "m",
            (Kind::PeakPressure | Kind::Stress, _) => "Pa",
            (Kind::Coefficient | Kind::Share, _) => "",
            (Kind::Force, false) => "N",
            (Kind::Force, true) => "N/m",
            (Kind::Moment, _) => "N m",
            (Kind::Power, false) => "W",
            (Kind::Power, true) => "W/m",
            (Kind::Temperature | Kind::Rise, _) => "K",
            (Kind::Angle, _) => "rad",
            (Kind::Speed, _) => "m/s",
            (Kind::AngularSpeed, _) => "rad/s",
            (Kind::Duration, _) => "s",
            (Kind::Revolutions, _) => "million revolutions",
        }
    }
}

/// Section of the report that shows a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Film thicknesses.
    Film,
    /// Pressures.
    Pressure,
    /// Supply of oil.
    Supply,
    /// Ends and load of a roller.
    Roller,
    /// Traction and friction.
    Traction,
    /// Load and friction of asperities.
    Asperities,
    /// Shear of the film.
    Shear,
    /// Temperatures.
    Temperature,
    /// Sources and sinks of heat.
    Heat,
    /// Stresses in the bodies.
    Stress,
}

/// Lower bound of the error bar of a figure, in addition to the difference of two meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorClass {
    /// By its own adjoint error estimate.
    Film,
    /// By the errors of the films.
    FilmOnCentreline,
    /// By those and the error of the cells around the largest pressure.
    LargestPressure,
    /// Likewise around the smooth maximum.
    CentralPressure,
    /// Likewise around the ridge.
    PressureRidge,
    /// Likewise around the spike on the centreline.
    Spike,
    /// Likewise around the largest pressure at the end y < 0 of a roller.
    EdgePressureLeft,
    /// Likewise at the end y > 0.
    EdgePressureRight,
    /// By the largest pressure, and the pressure gradients.
    ShearStress,
    /// By films and pressure, for the place where the film breaks.
    Outlet,
    /// By the films, for the place from which the gap is filled.
    Meniscus,
    /// An integral over the contact: by the errors of films and pressure.
    Integral,
    /// Such an integral with pressure gradients in it, and with the part beyond edges set by hand.
    WallTraction,
    /// The same for the power of the surfaces.
    FrictionPower,
    /// The same for the heat of shear, to which an unresolved spike adds.
    HeatShear,
    /// An integral, with the flow through edges set by hand.
    HeatCompression,
    /// The same, with the heat that is made and not carried off.
    HeatCarried,
    /// A share of the Hertz zone: its boundary is known to a point of the rule.
    ShareOfZone,
    /// By the elements of the temperatures around the hottest place of the film.
    FilmHottest,
    /// Likewise around the coldest one.
    FilmColdest,
    /// Likewise around the hottest place of the surface of body 1.
    Body1Hottest,
    /// Likewise of body 2.
    Body2Hottest,
    /// By the root-mean-square error of the temperatures over the Hertz zone.
    MeanTemperature,
    /// Of the stresses in the bodies, which are computed from the solution and have their bars from there.
    OfBodies,
}

/// Whether a figure is read off at a place that it has alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scope {
    /// It is somewhere on the contact area.
    Place,
    /// It belongs to the whole contact, or to a place known beforehand.
    Whole,
}
