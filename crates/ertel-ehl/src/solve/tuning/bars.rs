//! Error bars of figures other than the films.

/// Error bar over the difference of two meshes.
pub const SAFETY: f64 = 2.0;

/// The same of the heat of shear, to which a spike too narrow for both meshes gives a share.
pub const SAFETY_OF_POWER: f64 = 4.0;

/// Least error bar of a figure, relative to its size, over the larger relative bar of the films: differences can vanish
/// by chance.
pub const SHARE_OF_FILM_BAR: f64 = 1.0;

/// The same over the root-mean-square error of the pressure, for what is integrated over the contact.
pub const SHARE_OF_PRESSURE: f64 = 0.1;

/// The same for the largest pressure in the middle of the contact: load missing at a ridge is carried by the rest of the contact.
pub const SHARE_OF_PRESSURE_IN_MIDDLE: f64 = 0.02;

/// The same for the place where the film breaks off, behind a ridge.
pub const SHARE_OF_PRESSURE_AT_OUTLET: f64 = 0.5;

/// Least relative error bar of the heat of shear over the error of the films from unresolved pressures: the power that a spike dissipates grows
/// with its height.
pub const SHARE_OF_UNRESOLVED_IN_POWER: f64 = 20.0;

/// The same for the rolling friction, which has the pressure gradients.
pub const SHARE_OF_PRESSURE_IN_FRICTION: f64 = 0.3;

/// Least error bar of a pressure over the root-mean-square error of the cells around it.
pub const SHARE_OF_LOCAL: f64 = 1.5;

/// Least relative error bar of the largest shear stress over the relative one of the largest pressure: viscosity is
/// exponential in the pressure.
pub const SHARE_OF_PRESSURE_MAXIMUM: f64 = 5.0;

/// Error bar of the traction at the walls and of the friction power over the rolling friction beyond the edges of the contact area.
pub const SHARE_OF_BEYOND: f64 = 1.5;

/// Error bar of the heat carried off, in heat made by shear, over the share of the distance that edges set by hand cut off: there heat enters
/// and leaves with the lubricant.
pub const SHARE_OF_CUT: f64 = 0.2;

/// The same of heat by compression, in itself.
pub const SHARE_OF_CUT_COMPRESSION: f64 = 3.0;

/// Least error bar of the largest shear stress over the error of the pressure gradients.
pub const SHARE_OF_SLOPE: f64 = 1.0;

/// Least error bar of a largest or lowest temperature over how far the linear elements around it are from recovered ones.
pub const SHARE_OF_LOCAL_TEMPERATURE: f64 = 1.0;

/// Least error bar of a mean temperature over the root mean square of the same in the Hertz zone: most of it cancels.
pub const SHARE_OF_TEMPERATURE: f64 = 0.1;

/// Factor on least error bars where there is no other mesh.
pub const ALONE: f64 = 3.0;
