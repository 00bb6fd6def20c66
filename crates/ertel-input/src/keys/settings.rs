//! `[thermal]`, `[mesh]`, `[solver]` and `[output]`.

use ertel_quantity::Dimension as D;

use super::Kind::{
    Choice, Choices, Count, Number, Numbers, Points, Quantities, Quantity, Share, Switch, Table,
    Text,
};
use super::rows;
use super::{LENGTH, TEMPERATURE};
use crate::usual::{COATINGS, LIGHT};

/// Codes of warnings that may be silenced; a test holds them against the registry of warnings.
pub const CODES: &[&str] = &[
    "unusual-input",
    "no-effect",
    "temperature-ignored",
    "opposite-motion",
    "wide-contact",
    "strength",
    "asperity-data",
    "measured-profile",
    "small-map",
    "roller-ends",
    "gears",
    "pressure-range",
    "law-range",
    "temperature-range",
    "hottest-film",
    "coldest-film",
    "estimated-thinning",
    "thin-film",
    "roughness",
    "asperity-load",
    "wide-area",
    "heat-left-out",
    "inertia",
    "estimate-scope",
    "rolling-stress",
    "body-depth",
    "central-film-error",
    "minimum-film-error",
    "no-error-bar",
    "spike",
    "method",
    "convergence",
    "first-order",
    "sensitivities",
    "on-its-way",
    "oil-layer-late",
    "checkpoint",
    "pressure-angle",
    "uneven-roller",
    "missing-data",
    "bearing-speed",
    "designation-suffix",
    "friction-model-range",
    "oil-temperature",
];

rows! {
    /// `[thermal]`.
    pub THERMAL {
        depth: Number, bounds [0.1, 300.0], default "3.15" => "depth of both bodies in the energy equation, in half-widths";
        body_1_temperature, body_2_temperature: TEMPERATURE => r"(`plane_temperature` and `ball_temperature` are older names) temperatures of
            the bodies far from the contact; default the temperature of the lubricant";
        plane_temperature, ball_temperature: TEMPERATURE, aside "older names of `body_1_temperature` and `body_2_temperature`";
        film_order: Count, bounds [2.0, 10.0], default "8" => "polynomial order of the temperature across the film";
        solid_elements: Count, bounds [1.0, 64.0], default "4" => "number of cubic elements over the depth of each body, thinner towards the film";
        surface_order: Count, bounds [1.0, 2.0], default "1" => "Lagrange order of the temperature in the plane of motion";
        tolerance: Number, bounds [1e-10, 0.1], default "1e-4" => r"convergence criterion of the film-temperature coupling: relative change of
            temperature rise, film and pressure, and the estimated remaining error";
        max_iterations: Count, bounds [1.0, 10_000.0], default "40" => "maximum number of rounds of that coupling";
        profiles: Points, default "[[-1, 0], [0, 0], [0.9, 0]]" => r"points at which profiles across the film are written, in half-widths{};
            `[]` for none. In a line contact y is 0";
        field: Switch, default "false" => "`true`: write the temperature of the whole film and of both bodies";
    }
    /// `[stress]`.
    pub STRESS {
        depth: LENGTH => "largest depth of the planes, 10 nm to 1 m; default three times the smaller half-width of the dry contact";
        planes: Count, bounds [10.0, 400.0], default "60" => "number of planes below the surface, denser towards it";
        cut_depth: LENGTH => r"depth from which fatigue is counted, 10 nm to 1 m; default a tenth of the smaller half-width. Lives are also given
            for half and for twice the cut";
        fatigue_limit: Quantity(&[D::PRESSURE]) => "fatigue limit τ_u of the life integral, 0 to 10 GPa; default zero";
        dang_van_weight: Number, bounds [0.0, 2.0], default "0.3" => "weight α of the hydrostatic stress in Dang Van's index";
        fatemi_socie_weight: Number, bounds [0.0, 2.0], default "1" => "weight κ of the normal stress in Fatemi and Socie's parameter";
        body_1_hardness, body_2_hardness: Table(HARDNESS) => r"hardness of the body over depth: `surface`, `core` and `case_depth`, or a
            table `depth` and `hardness`, or `uniform`";
        body_1_residual_stress, body_2_residual_stress: Table(RESIDUAL_STRESS) => r"residual stress of the body over depth: `depth`, `along` and `across`, or
            a `file` with these columns";
    }
    /// `[stress.body_1_residual_stress]`.
    pub RESIDUAL_STRESS {
        depth: Quantities(&[D::LENGTH]) => "ascending depths, from 0 to 1 m; a depth that is given twice is a jump";
        along, across: Quantities(&[D::PRESSURE]) => "residual stress at these depths along and across the motion, tension positive, -20 to 20 GPa; linear between them, constant outside";
        file: Text => "instead: a CSV table with the columns depth, along and across, each with its unit";
    }
    /// `[stress.body_1_hardness]`.
    pub HARDNESS {
        surface, core: Number, bounds [10.0, 2000.0] => "hardness of surface and core of a case-hardened body, HV; surface above, core below 550";
        case_depth: LENGTH => "depth at which it has 550 HV, 10 nm to 1 m";
        depth: Quantities(&[D::LENGTH]) => "instead: increasing depths of a table, to the core";
        hardness: Numbers => "hardness at these depths, HV, 10 to 2000; none below that of the last depth, the core";
        uniform: Number, bounds [10.0, 2000.0] => "instead: hardness of a body that is equally hard at all depths, HV";
    }
    /// `[mesh]`.
    pub MESH {
        target_error: Share, bounds [2e-4, 0.1], default "0.2 %" => r#"error of central and minimum film at which grids and meshes are no longer refined,
            in per cent, `"0.5 %"`, or as a ratio{}, 1 % for the contacts of a whole bearing. Cannot be combined with `preset`, explicit cell sizes or growth"#;
        max_unknowns: Count, bounds [1e3, 2e6] => r"approximate limit of the pressure unknowns in this refinement{}; default 30,000, twice that where both halves of a contact are solved, of finite volumes 400,000, with
            finite-element bodies 16,000. If a limit is reached before the target, a warning names it, and the error bar is correspondingly
            wider. Case files from before the half-space operator counted displacements here: their numbers are still valid, and allow finer
            meshes";
        preset: Choice(&["coarse", "normal", "fine"]) => r#"`"coarse"`, `"normal"` or `"fine"`: sets the cell sizes below, without refinement;
            `"normal"` is used if a size is given or `solver.error_estimate` is off"#;
        hertz_size, constriction_size, edge_size: Number => r"cell sizes in the Hertz zone, at the constriction and side lobes, and at the
            edge of the contact area";
        rim_size: Number => r"cell size around the rim of the Hertz zone, in the inlet and outlet boundary layers of the film; from the expected
            film if absent";
        growth, depth_growth: Number, bounds [0.05, 2.0] => r"growth of the cell size with distance along the surface, and with depth{};
            half-spaces do not use the latter (with a warning)";
        inlet, outlet, side: Number => r"edges of the contact area: x < -1, x > 1, and |y| > 1 for circular and elliptical contacts (for a
            roller its ends); chosen from the expected film if absent, the side of an
            ellipse wide across the motion no farther than its bodies";
        body_width, body_depth: Number, bounds [8.0, 600.0] => r"size of a finite-element body, in half-widths{}; 60 if absent, more for thick
            films. No effect on half-spaces (with a warning)";
        pressure_order: Count, bounds [1.0, 5.0] => "Lagrange order of the pressure";
        elastic_order: Count, bounds [1.0, 5.0] => r"Lagrange order of the deflection{}: for half-spaces that of the pressure (default) or higher;
            for finite-element bodies 1 or 2 (default)";
    }
    /// `[solver]`.
    pub SOLVER {
        method: Choice(&["finite-elements", "finite-volumes"]) => r#"`"finite-elements"`, as in Habchi's thesis, or `"finite-volumes"`
            ([theory](../theory/finite-volumes.md)), for line, circular and elliptical contacts of half-spaces and rollers of finite length, flooded or starved, with heat, too. If absent: finite volumes, but finite elements for lines with heat whose stress has no limit, for contacts that finite volumes do not solve, and where a key is given that only elements have ([why](../decisions/0039-elements-and-volumes.md)). A case that one method does not solve is left to the other; so is one whose films finite elements do not resolve with default edges and without `max_unknowns`. A note says so. With
            `"finite-volumes"` the keys of finite elements are errors"#;
        formulation: Choice(&["gls", "supg", "galerkin"]), default "gls" => "weak form of the Reynolds equation";
        isotropic_diffusion: Number, bounds [0.0, 10.0], default "0" => "coefficient ρ_id of the isotropic diffusion";
        elastic_stabilisation: Switch, default "true" => r"`true`: GLS and SUPG include the elastic deflection as well as the compression;
            `false`: as printed in the thesis ([why](../decisions/0006-elastic-stabilisation.md))";
        penalty: Number, bounds [1.0, 1e15], default "1e4" => "cavitation penalty ξ₀";
        penalty_scaling: Choice(&["film", "constant", "element-squared", "inverse-element-squared"]), default "film"
            => "how the penalty depends on the element size";
        elasticity: Choice(&["half-space", "equivalent", "two-bodies"]) => r#"`"half-space"` (default): the deflection of both bodies by integrals
            over the contact area; or finite-element bodies, as in the thesis: `"equivalent"`, one body that deflects like both, or
            `"two-bodies"`. If the key is absent, `linear = "monolithic"` and `body_field = true` select `"equivalent"`; with `"half-space"` they
            are errors ([why](../decisions/0011-half-space-operator.md))"#;
        linear: Choice(&["condensed", "monolithic"]), default "condensed" => r#"`"condensed"` (default) or `"monolithic"`: both give the same
            solution; the latter is much slower in 3D and only for finite-element bodies"#;
        tolerance: Number, bounds [1e-11, 1e-2], default "1e-8" => "tolerance of the relative residual and the pressure update";
        max_iterations: Count, bounds [1.0, 10_000.0], default "60" => "maximum number of Newton iterations on one mesh";
        error_estimate: Switch, default "true" => r"estimate errors and report error bars; if `false`, the mesh is that of `preset` and only
            the last mesh is solved with the element orders of the case";
        newtonian: Switch, default "false" => "`true`: neglect shear thinning and use the low-shear viscosity; in machines friction still follows [the law](#friction-of-machines)";
        isothermal: Switch, default "false" => "`true`: neglect the heat of a case that has `[thermal]`";
    }
    /// `[output]`.
    pub OUTPUT {
        folder: Text => "result folder; default `results/<name of the case file>`; the option `--output` has priority";
        pictures: Choices(&["svg", "pdf", "png"]), default "[\"svg\"]" => r#"formats of pictures, a list of `"svg"`, `"pdf"` and `"png"`{}; `[]`
            for none"#;
        body_field: Switch, default "false" => r"`true`: write the displacement of the whole body, `body.vtu`{}. It needs a finite-element body,
            which is used if `solver.elasticity` is absent; the solver uses only the surface, so the body is factorised again for this file";
        netcdf: Switch, default "false" => r"`true`: write the fields on a regular grid and all figures as [netCDF](results.md#resultnc), `result.nc`; of a case in time
            at the output times";
        vtu: Switch, default "false" => r"`true`, of a case with [`[transient]`](#transient): write pressure and film at each output time as VTU files and `fields.pvd`, which
            lists them ([content](results.md#cases-in-time))";
        animation: Switch, default "false" => r"`true`, of a case with `[transient]`: write the film over the output times as an animated picture, `animation.png`";
        sensitivities: Switch => r"sensitivities of the results to each input ([below](#uncertain-inputs)). Default: all that cost little
            compared with the solve, and in curves and studies only if an input has an uncertainty; `true`: also for thermal contacts and for
            the length of rollers; `false`: none";
        interferogram: Table(INTERFEROGRAM) => r"a table: draw the film of a point contact as an [interferogram](#interferograms),
            `interferogram.png` and `interferogram.svg`";
        silence: Choices(CODES) => r#"codes of warnings and notes that are counted in JSON but not shown, such as `["law-range"]` ([codes](warnings.md)). Warnings
            of figures that are not to be used cannot be silenced"#;
    }
    /// `[output.interferogram]`.
    pub INTERFEROGRAM {
        wavelength: LENGTH, usual [LIGHT] => "wavelength of one colour, in vacuum; the image is then grey";
        wavelengths: Quantities(&[D::LENGTH]), usual [LIGHT] => r#"in its place: the wavelengths of the red, green and blue channels,
            `["650 nm", "550 nm", "450 nm"]`"#;
        light: Choice(&["cie-rgb"]) => r#"in their place: `"cie-rgb"`, the primaries of CIE 1931, 700 nm, 546.1 nm and 435.8 nm"#;
        refractive_index: Number, bounds [1.0, 4.0] => "n of the oil at ambient pressure";
        follows_density: Switch, default "false" => "`true`: n rises with the density by Lorentz and Lorenz, (n² - 1)/(n² + 2) ∝ ρ";
        spacer_thickness: LENGTH, usual [COATINGS] => "thickness of a transparent layer on the disc; none if absent";
        spacer_refractive_index: Number, bounds [1.0, 4.0] => "n of that layer";
        phase_change: Quantity(&[D::ANGLE]) => r#"phase change by the reflections: with `"180 deg"` zero film thickness is dark, with `"0 deg"` it
            is bright"#;
        visibility: Number, bounds [0.0, 1.0] => "contrast of the fringes{}; if absent, both beams are equally strong";
    }
    /// `[compare]`.
    pub COMPARE {
        columns: super::Kind::Texts => r"table of quantities or keys of the case and the titles of their columns; a unit follows a colon where the title has
            none; `#4` is the fourth column";
        ignore: super::Kind::List => "titles of columns to ignore";
        decimal: super::lubricant::DECIMAL => r#"`"point"` or `"comma"`: the decimal mark, where the numbers of the table leave it open"#;
    }
}
