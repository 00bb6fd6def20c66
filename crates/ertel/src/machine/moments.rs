//! Frictional moments of bearings by the models of catalogues, for comparison with the computed films.

use ertel_machines::bearing::friction::{
    PalmgrenOil, SkfMoment, SkfParams, SkfState, palmgren_load, palmgren_moment, skf_moment,
};
use ertel_machines::bearing::{Geometry, life};

use super::collected::Collected;
use crate::case::BearingMechanics;
use crate::figures::bearing::{FRICTION_TORQUE_PALMGREN, FRICTION_TORQUE_SKF};
use crate::warning::WarningKind;
use crate::words::digits;

/// Adds them where the bearing has a series; viscosity in m²/s, C_0 and P_0 in N.
pub(super) fn add(
    mechanics: &BearingMechanics,
    viscosity: f64,
    [static_rating, static_load]: [f64; 2],
    out: &mut Collected,
) {
    let Some(entry) = &mechanics.entry else {
        return;
    };
    let [radial, axial] = mechanics.loads;
    let speed = mechanics.speeds.relative();
    let axial_factor = match &mechanics.bearing.geometry {
        Geometry::TaperedRoller(roller) => {
            life::roller_factors(roller.cup_angle).map_or(0.0, |factors| factors.axial)
        }
        Geometry::Ball(_) | Geometry::CylindricalRoller(_) => 0.0,
    };
    let state = SkfState {
        bore: entry.boundary.bore,
        outside: entry.boundary.outside,
        speed,
        viscosity,
        radial,
        axial,
        static_rating,
        axial_factor,
    };
    let params = SkfParams {
        replenishment: if mechanics.life.is_grease { 6e-8 } else { 3e-8 },
        ..SkfParams::default()
    };
    let series = entry.designation.series;
    let skf = skf_moment(series, &state, &params).ok();
    if skf.is_some_and(|moment| !moment.rises_with_viscosity()) {
        out.warn(WarningKind::FrictionModelRange, format!(
            "SKF's model of the torque is omitted: at {} mm²/s and this speed its torque falls with rising viscosity, outside its range",
            digits(1e6 * viscosity, 3)
        ));
    }
    if let Some(moment) = skf.filter(SkfMoment::rises_with_viscosity) {
        out.add(
            FRICTION_TORQUE_SKF,
            moment.total(),
            match series.is_tapered() {
                true => {
                    "SKF: a mineral oil, without seals and churning; the sliding part includes the rib, the rolling part cage and oil"
                }
                false => {
                    "SKF: a mineral oil, without seals and churning; the rolling part includes cage and oil"
                }
            },
        );
    }
    let supply = match mechanics.life.is_grease {
        true => PalmgrenOil::Grease,
        false => PalmgrenOil::Bath,
    };
    let mean = entry.boundary.mean_diameter();
    let load = palmgren_load(series, radial, axial, axial_factor);
    let moment = (series
        .palmgren_factors(supply, static_load, static_rating)
        .ok())
    .and_then(|factors| palmgren_moment(factors, mean, speed, viscosity, load).ok());
    if let Some(moment) = moment {
        out.add(
            FRICTION_TORQUE_PALMGREN,
            moment.total(),
            "Palmgren: with the churning of an oil bath, or run-in grease (Schaeffler HR 1, 2006)",
        );
    }
}
