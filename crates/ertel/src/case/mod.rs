//! Case files: what to solve, read from TOML into SI.
//!
//! ```toml
//! title = "Steel ball on steel disc"
//!
//! [contact]
//! kind = "circular"                 # or "line"; the load is then per length, "50 kN/m"
//! radius = "16 mm"                  # reduced radius of curvature
//! load = "100 N"                    # or hertz_pressure = "1 GPa"
//!
//! [bodies]                          # a name from the solids database, or a table
//! body_1 = "steel"
//! body_2 = { youngs_modulus = "210 GPa", poissons_ratio = 0.3 }
//!
//! [motion]                          # or body_1_speed and body_2_speed
//! entrainment_speed = "0.8 m/s"     # (u_1 + u_2)/2
//! slide_to_roll_ratio = 0.0         # (u_2 - u_1)/entrainment speed
//!
//! [lubricant]                       # name = "..." takes a fluid from the database
//! temperature = "40 degC"
//! density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
//! viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "22 1/GPa" }
//! ```
//!
//! `[stress]` asks for the stresses in the bodies, `[wear]` for their wear. `[surface_roughness]` describes rough surfaces and their asperities. `kind = "roller"` also needs `length` and `profile`.
//!
//! `[machine]` describes a bearing, a gear or a cam instead of `[contact]` and `[motion]`.
//!
//! `lubricant = "squalane-pip"` with a top-level `temperature = "40 degC"` is short for a `[lubricant]`
//! table with `name` and `temperature`. `[thermal]` switches heat on, `[inlet]` limits the oil that arrives. `[mesh]`, `[solver]` and `[output]` are optional; everything
//! physical is required. `[transient]` describes changes in time, `[[surface]]` reliefs and measured surfaces. `[curve]` varies one quantity over a list or range ([`curve`]). Numbers carry units. Unknown keys are errors.

mod approach;
mod asperities;
mod bodies;
mod builder;
mod check;
mod contact;
mod course;
pub mod curve;
mod described;
mod echo;
mod files;
mod friction;
mod geometry;
mod inlet;
mod inputs;
mod interferogram;
mod lubricant;
mod machine;
mod motion;
mod params;
mod roller;
mod roughness;
mod sections;
mod set;
mod settings;
mod stress;
pub mod study;
mod surface;
mod thermal;
mod time_warnings;
mod transient;
mod usual;
mod wear;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use ertel_input::csv::CsvParams;
use ertel_input::{Document, InputError, Inputs, Table, keys};
use ertel_rheology::ShearThinning;
use ertel_rheology::database::DatabaseError;

use crate::contact::{Contact, Hertz, Motion, Supply, reduced_modulus};
use crate::mixed::Asperities;
use crate::params::{
    ElasticModel, LinearSolver, MeshParams, OutputParams, SolverParams, ThermalParams,
};

use crate::layers::Coated;
use crate::stress::StressParams;
use crate::warning::{Warning, WarningKind, silence};
use crate::wear::WearParams;
pub use bodies::{Body, BodyLayer};
pub use builder::{CaseBuilder, Setting};
pub use check::{finite_volumes_refuse, mesh_of_bodies as check_mesh_of_bodies};
pub use curve::Curve;
pub use described::{
    BodyEcho, CaseEcho, EstimateEcho, FluidEcho, HeatEcho, LayerEcho, MachineEcho, ThermalEcho,
};
pub use inputs::Origin;
pub use lubricant::Lubricant;
pub use machine::{
    BearingMechanics, CamMechanics, ContactKind, Contamination, GearLimits, GearMechanics,
    LifeInputs, MachineAxis, MachineContact, MachineContacts, Mechanics, RINGS, RatingBasis,
    WholeMachine,
};
pub use params::{read_mesh, read_solver};
use settings::Settings;
pub use study::Study;
pub use study::read_named;
pub use surface::{
    LEAST_POINTS as LEAST_MAP_POINTS, MOST_POINTS as MOST_MAP_POINTS, SurfaceEcho, SurfaceRelief,
};
pub use thermal::read as read_thermal;
pub use thermal::{Heat, SolidHeat};
pub use transient::{Reference, Transient, contact_with};
pub(crate) use usual::question_of_state;

/// Everything a solve needs, in SI.
#[derive(Clone, Debug)]
pub struct Case {
    /// Title for pictures and reports; empty if the file gives none.
    pub title: String,
    /// Shape, radius and load.
    pub contact: Contact,
    /// The plane, disc or ring.
    pub body_1: Body,
    /// The ball or roller.
    pub body_2: Body,
    /// Smallest radius of curvature of either body along x and along y, m, convex or concave; infinite where the case says none.
    pub body_radii: [f64; 2],
    /// Composite rms roughness of both surfaces σ = √(σ_1² + σ_2²), m, if given.
    pub roughness: Option<f64>,
    /// Its conversion from Ra or Rz, one sentence each.
    pub roughness_rules: Vec<String>,
    /// Asperities of the surfaces, if described; then there is a roughness, too.
    pub asperities: Option<Asperities>,
    /// Speeds.
    pub motion: Motion,
    /// The machine that contact and motion were computed from, if the file gives one.
    pub machine: Option<MachineEcho>,
    /// Whether friction follows the shear-thinning law of the lubricant while the films are Newtonian.
    pub friction_by_law: bool,
    /// How much oil reaches the contact.
    pub supply: Supply,
    /// Lubricant and its temperature.
    pub lubricant: Lubricant,
    /// Mesh and elements.
    pub mesh: MeshParams,
    /// Solver settings.
    pub solver: SolverParams,
    /// Heat in film and bodies, if the file requests it; [`Case::thermal`] also considers `solver.isothermal`.
    pub thermal: Option<ThermalParams>,
    /// Stresses in the bodies, if the file asks for them.
    pub stress: Option<StressParams>,
    /// Wear over a sliding distance, if the file asks for it.
    pub wear: Option<WearParams>,
    /// Output settings.
    pub output: OutputParams,
    /// Warnings about the input.
    pub warnings: Vec<Warning>,
    /// The case file as read, kept with the results; empty for a case made in code.
    pub source: String,
    /// Its keys and values as given, quantities with their units; null for a case made in code.
    pub given: serde_json::Value,
    /// Where its quantities come from; `None` for a case made in code.
    pub origin: Option<Arc<Origin>>,
    /// Reliefs of the surfaces, m.
    pub reliefs: Vec<SurfaceRelief>,
    /// Changes in time, if the file gives any; [`crate::run::transient`] solves them, [`crate::run::solve`] the case without it.
    pub transient: Option<Arc<Transient>>,
    /// The points of `[curve]`, each a separate case; [`crate::run`] solves the case without them.
    pub curve: Option<Curve>,
    /// The machine of which the contact is the governing one, if the file describes one without a choice of its contacts.
    pub whole: Option<Arc<WholeMachine>>,
    /// The contacts of that machine, each a separate case, as [`crate::study::solve_machine`] solves them; `None` with a `[curve]`, whose
    /// points have them, and for the points of a study before they are solved ([`Study::whole_point`] has them).
    pub contacts: Option<Arc<MachineContacts>>,
}

/// Wave numbers times the half-width of which layers have the modulus of the dry contact, of lines and others: half-widths of coated dry contacts by integral
/// equations come out to 10 % and 4 %.
const WAVES: [f64; 2] = [1.6, 2.9];
/// Rounds of modulus and half-width, each of which takes a third or more off the error.
const ROUNDS: usize = 40;

impl Case {
    /// Reads a case file.
    ///
    /// # Errors
    ///
    /// [`InputError`] with file, line and key: a file that cannot be read, bad syntax, unknown or missing
    /// keys, wrong units, values that no contact can have, and a Hertz pressure outside 1 kPa to 5 GPa.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::from_document(&Document::read(path)?, folder)
    }

    /// A case to be made in code, key by key.
    pub fn builder() -> CaseBuilder {
        CaseBuilder::default()
    }

    /// Reads the text of a case file; tables of data it names are found in `folder`. Errors call it `name`.
    ///
    /// # Errors
    ///
    /// As [`Case::read`].
    pub fn from_text(name: &str, text: &str, folder: &Path) -> Result<Self, InputError> {
        Self::from_document(&Document::parse(name, text)?, folder)
    }

    /// Reads a case from a parsed document; tables of data it names are found in `folder`.
    ///
    /// # Errors
    ///
    /// As [`Case::read`].
    pub fn from_document(document: &Document, folder: &Path) -> Result<Self, InputError> {
        Self::known_from_document(document, folder)
            .map_err(|error| keys::unknown_first(document, keys::CASE, error))
    }

    fn known_from_document(document: &Document, folder: &Path) -> Result<Self, InputError> {
        let mut case = Self::without_curve(document, folder, BTreeMap::new())?;
        case.curve = curve::read(document, folder, &case)?;
        let draws_none = (case.curve.as_ref()).is_some_and(|curve| !curve.folders);
        if draws_none && case.output.interferogram.is_some() {
            let text = "[output.interferogram] is drawn only in the folders of the points: set folders = true in [curve]";
            case.warn([Warning::new(WarningKind::NoEffect, text)]);
        }
        if case.curve.is_none() {
            case.read_contacts(document, folder, &BTreeMap::new())?;
        }
        Ok(case)
    }

    /// Reads the contacts of a whole machine, with other values, SI, at the key paths `replaced`.
    fn read_contacts(
        &mut self,
        document: &Document,
        folder: &Path,
        replaced: &BTreeMap<String, f64>,
    ) -> Result<(), InputError> {
        if let Some(whole) = &self.whole {
            let contacts = machine::contacts(document, folder, self, whole, replaced)?;
            self.contacts = Some(Arc::new(contacts));
        }
        Ok(())
    }

    /// The case with other values, SI, at the key paths `replaced`.
    fn without_curve(
        document: &Document,
        folder: &Path,
        replaced: BTreeMap<String, f64>,
    ) -> Result<Self, InputError> {
        let inputs = Inputs::replacing(replaced);
        let mut case = Self::of_sections(document, folder, &inputs)?;
        case.origin = Some(Arc::new(Origin::new(document, folder, inputs)?));
        case.reliefs = surface::read(&mut document.root(), &case, folder)?;
        case.transient = transient::read(&mut document.root(), &case, folder)?.map(Arc::new);
        if case.transient.is_some() {
            // One contact is followed through all of them.
            case.whole = None;
        }
        case.warnings
            .extend(surface::check(&case, &mut document.root())?);
        case.warnings.extend(time_warnings::warnings(&case));
        case.warnings.extend(check::inputs_of_machine(&case));
        case.warnings.extend(check::slow_spin(&case));
        let mut unusual = usual::warnings(case.inputs(), document);
        unusual.extend(usual::of_data(&case, &unusual));
        case.warnings.extend(unusual);
        let uncertain: Vec<&str> = (case.inputs().iter())
            .filter(|input| {
                input.uncertainty.is_some()
                    && lubricant::TEMPERATURE_KEYS.contains(&input.key.as_str())
            })
            .map(|input| input.key.as_str())
            .collect();
        let ignored = (case.lubricant).temperature_ignored(uncertain, "has an uncertainty");
        case.warn(ignored);
        Ok(case)
    }

    /// The case of all sections but `[curve]`, `[transient]` and `[[surface]]`, which depend on the others.
    fn of_sections(
        document: &Document,
        folder: &Path,
        inputs: &Inputs,
    ) -> Result<Self, InputError> {
        let mut root = document.root_noted_by(Some(inputs.recorder()));
        let title = root.optional_str("title")?.unwrap_or_default().to_owned();
        let tables = geometry::Tables::of(&mut root)?;
        let bodies = (root.required_table("bodies"))
            .map_err(|error| sections::missing(&root, "bodies", error))?;
        let bodies = bodies::read(bodies, folder)?;
        let surfaces = root.optional_table("surface_roughness")?;
        let surfaces = roughness::read(surfaces, bodies.roughness)?;
        let modulus = reduced_modulus(bodies.body_1.elasticity, bodies.body_2.elasticity);
        let steel = machine::Steel {
            reduced_modulus: modulus,
            density: bodies.body_2.density,
            materials: [bodies.body_1.elasticity, bodies.body_2.elasticity],
        };
        let mut geometry = tables.read(&mut root, &steel, bodies.shapes.as_ref(), folder)?;
        let settings = Settings::read(&mut root, folder, &mut geometry, modulus)?;
        for key in ["curve", "transient", "surface"] {
            root.contains(key);
        }
        // The table of a comparison has no effect on a solve, but its keys are checked.
        if let Some(table) = root.optional_table("compare")? {
            CsvParams::of_table(table)?;
        }
        let wear = root.optional_table("wear")?;
        root.read_correlations()?;
        geometry.tables.clone().finish()?;
        root.finish()?;
        let mut case = Self {
            title,
            contact: geometry.contact,
            body_1: bodies.body_1,
            body_2: bodies.body_2,
            body_radii: geometry.body_radii,
            roughness: surfaces.roughness,
            roughness_rules: surfaces.rules,
            asperities: surfaces.asperities,
            motion: geometry.motion,
            machine: geometry.machine,
            friction_by_law: settings.friction_by_law,
            supply: settings.supply,
            lubricant: settings.lubricant,
            mesh: settings.mesh,
            solver: settings.solver,
            thermal: settings.thermal,
            stress: settings.stress,
            wear: None,
            output: settings.output,
            warnings: [geometry.warnings, settings.warnings].concat(),
            source: document.text().to_owned(),
            given: echo::json_of(document.tree()),
            origin: None,
            reliefs: Vec::new(),
            transient: None,
            curve: None,
            whole: geometry.whole.map(Arc::new),
            contacts: None,
        };
        case.check_sections(document, geometry.tables.main(), &geometry.hertz)?;
        if let Some(table) = wear {
            check::wear(&case, &table, &mut document.root())?;
            case.wear = Some(wear::read(table, &case.motion)?);
        }
        Ok(case)
    }

    /// Checks sections against each other; `contact` is the table of the contact, `hertz` its dry contact.
    fn check_sections(
        &mut self,
        document: &Document,
        contact: &Table<'_>,
        hertz: &Hertz,
    ) -> Result<(), InputError> {
        check::body_of_wide_contact(self, contact)?;
        let mut root = document.root();
        check::finite_elements_of_soft_bodies(self, &root)?;
        check::layers(self, &mut root)?;
        let solver = root.optional_table("solver")?;
        let mesh = root.optional_table("mesh")?;
        let thermal = root.optional_table("thermal")?;
        check::asperities(self, root.optional_table("surface_roughness")?.as_ref())?;
        check::finite_volumes(self, solver.as_ref(), mesh.as_ref(), thermal.as_ref())?;
        let of_sections = std::mem::take(&mut self.warnings);
        let mut warnings = check::warnings(self, hertz);
        warnings.extend(of_sections);
        warnings.extend(self.asperities.iter().flat_map(asperities::warnings));
        if let Some(table) = &mesh {
            warnings.extend(check_mesh_of_bodies(self, table)?);
        }
        if let Some(table) = &thermal {
            warnings.extend(thermal::check(self, table)?);
        }
        self.warnings = warnings;
        Ok(())
    }

    /// Adds warnings; those that the case silences are marked.
    fn warn(&mut self, more: impl IntoIterator<Item = Warning>) {
        self.warnings.extend(more);
        silence(&mut self.warnings, &self.output.silence);
    }

    /// The shear thinning in effect: none for a Newtonian lubricant, and none with `solver.newtonian`.
    pub fn shear_thinning(&self) -> Option<&ShearThinning> {
        let thinning = self.lubricant.shear_thinning.as_ref();
        thinning.filter(|_| !self.solver.newtonian)
    }

    /// The shear thinning of friction: that of the films, or for Newtonian films that of the lubricant where
    /// [`Case::friction_by_law`].
    pub fn friction_thinning(&self) -> Option<&ShearThinning> {
        let thinning = self.lubricant.shear_thinning.as_ref();
        thinning.filter(|_| self.friction_by_law || !self.solver.newtonian)
    }

    /// How the bodies are computed: as half-spaces, unless the case chooses otherwise or needs results that only a body
    /// can give.
    pub fn elastic_model(&self) -> ElasticModel {
        let needs_body = self.solver.linear == LinearSolver::Monolithic || self.output.body_field;
        self.solver.elasticity.unwrap_or(match needs_body {
            true => ElasticModel::Equivalent,
            false => ElasticModel::HalfSpace,
        })
    }

    /// Reduced modulus E' of both bodies, Pa; with layers that of homogeneous bodies which are as compliant under waves as long as the contact.
    pub fn reduced_modulus(&self) -> f64 {
        let bare = reduced_modulus(self.body_1.elasticity, self.body_2.elasticity);
        if self.layers().iter().all(|layers| layers.is_empty()) {
            return bare;
        }
        let bodies = self.coated();
        let substrates: f64 = bodies.iter().map(Coated::of_long_waves).sum();
        let contact = self.contact.along_motion();
        let wave = match contact.kind.is_line() {
            true => WAVES[0],
            false => WAVES[1],
        };
        (0..ROUNDS).fold(bare, |modulus, _| {
            let hertz = Hertz::new(&contact, modulus);
            let smaller = hertz
                .half_width_y
                .map_or(hertz.half_width, |b| b.min(hertz.half_width));
            let compliance = bodies.iter().map(|body| body.normal(wave / smaller));
            bare * substrates / compliance.sum::<f64>()
        })
    }

    /// Reliefs of a contact that does not change in time.
    pub fn standing_reliefs(&self) -> &[SurfaceRelief] {
        match self.transient {
            None => &self.reliefs,
            Some(_) => &[],
        }
    }

    /// Both bodies with their layers, SI.
    pub fn coated(&self) -> [Coated; 2] {
        [&self.body_1, &self.body_2].map(Body::coated)
    }

    /// Layers of both bodies.
    pub fn layers(&self) -> [&[BodyLayer]; 2] {
        [&self.body_1, &self.body_2].map(|body| body.layers.as_slice())
    }

    /// Parts of the case that finite volumes alone solve, in words; `None` where there are none.
    pub fn only_by_volumes(&self) -> Option<&'static str> {
        match self.layers() {
            _ if !self.standing_reliefs().is_empty() => Some("reliefs"),
            _ if self.asperities.is_some() => Some("asperities"),
            [[], []] => None,
            _ => Some("layers on the bodies"),
        }
    }

    /// Density of the lubricant at the Hertz pressure over that at ambient pressure.
    pub fn relative_density(&self) -> f64 {
        self.lubricant.relative_density(self.hertz().pressure)
    }

    /// The dry contact.
    pub fn hertz(&self) -> Hertz {
        Hertz::new(&self.contact, self.reduced_modulus())
    }
}

/// Error at a name that is not in the database.
fn unknown<'t>(table: &'t Table<'_>, key: &'t str) -> impl Fn(DatabaseError) -> InputError + 't {
    move |error| match error {
        DatabaseError::Unknown {
            choices,
            near,
            help,
            ..
        } => {
            let error = table.unknown_name_like(key, &choices, near);
            help.into_iter().fold(error, InputError::with_help)
        }
        DatabaseError::Data(error) => error,
        DatabaseError::File { .. } | DatabaseError::Folder { .. } => {
            table.error(key, error.to_string())
        }
    }
}

#[cfg(test)]
mod ellipse_tests;
#[cfg(test)]
mod motion_tests;
#[cfg(test)]
mod plausible_tests;
#[cfg(test)]
mod roller_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod thermal_tests;
