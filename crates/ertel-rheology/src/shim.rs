//! Shim.
#[derive(Debug, Clone)]
/// x
pub struct ConductivityLaw(pub f64);
#[derive(Debug, Clone)]
/// x
pub struct HeatCapacityLaw(pub f64);
impl ConductivityLaw {
    /// x
    pub fn conductivity(&self, _: f64, _: f64) -> f64 { self.0 }
    /// x
    pub fn constant(k: f64) -> Result<Self, crate::LawError> { Ok(Self(k)) }
}
impl HeatCapacityLaw {
    /// x
    pub fn heat_capacity(&self, _: f64, _: f64) -> f64 { self.0 }
    /// x
    pub fn constant(k: f64) -> Result<Self, crate::LawError> { Ok(Self(k)) }
}
