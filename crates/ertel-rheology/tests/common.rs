//! Laws of oils that several tests use.

#[path = "../../ertel-quantity/tests/common/near.rs"]
mod near;

use ertel_rheology::density::{BulkModulusSoftening, Murnaghan, TaitVolume};
use ertel_rheology::viscosity::{
    Doolittle, GlassTransition, Hybrid, ImprovedYasutomi, ModifiedWlf, OccupiedVolume,
};
use ertel_rheology::{DensityLaw, ViscosityLaw};

pub use near::near;

/// Reference temperature, coefficients of the bulk modulus and of its slope, expansivity.
pub fn softening([reference, modulus, slope, expansivity]: [f64; 4]) -> BulkModulusSoftening {
    BulkModulusSoftening {
        reference_temperature: reference,
        bulk_modulus_coefficient: modulus,
        bulk_modulus_slope_coefficient: slope,
        expansivity,
    }
}

/// Constants of the traction oil Shell T9 as a public program prints them.
pub fn t9_density() -> DensityLaw {
    let thermal = softening([298.0, 6.09e-3, 0.0, 7.734e-4]);
    DensityLaw::Murnaghan(Murnaghan::new(872.0, 9.234e9, 10.545, Some(thermal)).unwrap())
}

/// Constants of a gear oil 80W-90 as two public programs print them, units repaired.
pub fn gear_oil() -> ImprovedYasutomi {
    ImprovedYasutomi {
        glass: GlassTransition {
            glass_viscosity: 1e12,
            glass_temperature: 201.45,
            a_1: 210.6,
            a_2: 0.455e-9,
            c_1: 16.372,
            c_2: 29.99,
        },
        b_1: 7.606e-9,
        b_2: -0.4193,
    }
}

pub fn hybrid() -> Hybrid {
    Hybrid {
        mu_0: 0.03,
        a_0: 12e-9,
        q: 3.0,
        fragility: 20.0,
        divergence_pressure: 3e9,
    }
}

/// The viscosity of squalane by Doolittle's law over a volume after Tait.
pub fn squalane(volume: TaitVolume) -> ViscosityLaw {
    let thermal = OccupiedVolume {
        reference_temperature: 313.0,
        expansivity: -9.599e-4,
    };
    ViscosityLaw::Doolittle(Doolittle::new(0.0705, 4.2, 0.658, Some(thermal), volume).unwrap())
}

/// An oil after the modified WLF law.
pub fn wlf_oil() -> ViscosityLaw {
    let constants = ModifiedWlf {
        glass: GlassTransition {
            glass_viscosity: 1e12,
            glass_temperature: 273.15 - 73.86,
            a_1: 19.17,
            a_2: 4.07e-9,
            c_1: 16.04,
            c_2: 18.18,
        },
        b_1: 0.23,
        b_2: 0.0249e-6,
    };
    ViscosityLaw::ModifiedWlf(ModifiedWlf::new(constants).unwrap())
}
