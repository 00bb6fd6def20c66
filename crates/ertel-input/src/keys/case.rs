//! Cases and studies as a whole, contact, bodies and motion.

use ertel_quantity::Dimension as D;

use super::Kind::{
    Choice, Count, FluidOrTable, List, Machine, Number, Quantities, Quantity, QuantityOr, Scalar,
    Solid, SolidOrTable, Switch, Table, Tables, Text,
};
use super::lubricant::{CONDUCTIVITY, CORRELATION, HEAT_CAPACITY, LUBRICANT};
use super::machine::{MACHINES, PROFILE};
use super::rows;
use super::settings::{COMPARE, MESH, OUTPUT, SOLVER, STRESS, THERMAL};
use super::{ANGLE, LENGTH, PRESSURE, ROTATION, SPEED, TEMPERATURE, TIME};
use crate::usual::{
    COATINGS, GROOVES, HEIGHTS, HERTZ_PRESSURE, LENGTHS, LINE_LOAD, LOAD, MODULUS, OIL_LAYER,
    RADII, RELIEFS, SOLID_CONDUCTIVITY, SOLID_DENSITY, SPECIFIC_HEATS, SPEEDS,
};

rows! {
    /// A case.
    pub CASE {
        title: Text => "text for report and pictures; optional";
        contact: Table(CONTACT) => "kind, size and load of the contact";
        motion: Table(MOTION) => "speeds of both surfaces";
        machine: Machine(MACHINES) => "dimensions, loads and speeds of a machine element, instead of `[contact]` and `[motion]`";
        bodies: Table(BODIES) => "both bodies: elastic constants, thermal properties, radii of ellipses, composite roughness";
        surface_roughness: Table(ROUGHNESS) => "optional: rough surfaces and their asperities, which share the load with the oil";
        stress: Table(STRESS) => "optional: this section, even if empty, asks for the stresses in both bodies, in time at the output times";
        wear: Table(WEAR) => "optional: wear of the bodies over a sliding distance, which changes the contact";
        inlet: Table(INLET) => "optional: how much oil reaches the contact; without this section the inlet is fully flooded";
        lubricant: FluidOrTable(LUBRICANT) => "the lubricant by its name, its laws or its data sheet, and the temperature of the film";
        temperature: TEMPERATURE => "temperature of the film, where `lubricant` is a name";
        thermal: Table(THERMAL) => "optional: this section, even if empty, makes the contact thermal (energy equation of film and bodies)";
        mesh: Table(MESH) => "optional: target of the refinement, or sizes of the cells; lengths are in Hertz half-widths";
        solver: Table(SOLVER) => "optional: numerical method, tolerances and limits";
        output: Table(OUTPUT) => "optional: folder, formats and additional files of the results";
        transient: Table(TRANSIENT) => "optional: time; what changes in it, from the steady contact on";
        surface: Tables(SURFACE) => "optional: dents, bumps, grooves, ridges, waves and maps of heights on a body, with which they move";
        curve: Table(CURVE) => "optional: a list or range of one quantity; the case is solved at each value in turn";
        compare: Table(COMPARE) => "optional: how the table of `ertel compare` is read";
        correlation: Tables(CORRELATION) => "optional: correlations between uncertain inputs";
    }
    /// `[contact]`.
    pub CONTACT {
        kind: Choice(&["circular", "line", "elliptical", "roller"]) => r#"`"circular"` (ball on plane), `"line"` (long cylinder on plane),
            `"elliptical"` (bodies with two radii each) or [`"roller"`](#rollers) (cylinder of finite length)"#;
        radius: LENGTH, usual [RADII] => "reduced radius of curvature R, 1 um to 1 km (circular, line, roller)";
        radius_x, radius_y: LENGTH, usual [RADII] => r"reduced radii along x and y (elliptical), unless `[bodies]` gives the radii of both
            bodies; ratio at most 1000 to 1";
        entrainment_angle: ANGLE => r#"direction of the entrainment velocity from x towards y, `"30 deg"` or in rad (elliptical; along x if
            absent)"#;
        load: Quantity(&[D::FORCE, D::FORCE_PER_LENGTH]), usual [LOAD, LINE_LOAD] => r#"load F, a force (circular, elliptical, roller); load per
            length w, such as `"50 kN/m"` (line)"#;
        hertz_pressure: PRESSURE, usual [HERTZ_PRESSURE] => r"largest pressure of the dry contact, instead of `load`; for a roller that of the
            line contact under F/l";
        length: LENGTH, usual [LENGTHS] => "length l; at least four half-widths of the contact";
        profile: Table(PROFILE) => "total drop z(y) of roller and raceway from the cylinder; its `kind` is one of those below";
        misalignment: ANGLE => r#"tilt θ of the axis, `"0.01 deg"` or in rad, at most 0.1 rad; a positive tilt loads the end y > 0 more. 0 if
            absent"#;
    }
    /// `[motion]`.
    pub MOTION {
        entrainment_speed: SPEED, usual [SPEEDS] => r"u_m = (u_1 + u_2)/2 of the speeds of `body_1` and `body_2`, positive: the inlet lies at
            x < 0. Zero is an error: without entrainment there is no steady film";
        slide_to_roll_ratio: Number => r"(u_2 - u_1)/u_m with u_2 the speed of `body_2` and u_1 that of `body_1`; any sign; above 2 in absolute
            value the surfaces move in opposite directions, which gives a warning";
        slide_to_roll_ratio_across: Number => r"the same for the velocities across the entrainment direction, (v_2 - v_1)/u_m, from x towards y;
            optional, 0";
        body_1_speed, body_2_speed: SPEED, aside "speeds of both bodies, instead of entrainment speed and slide-to-roll ratios";
        plane_speed, ball_speed: SPEED, aside "older names of `body_1_speed` and `body_2_speed`";
        skew_angle: ANGLE, aside "angle from the velocity of body 1 to that of body 2; optional, 0";
        body_1_spin, body_2_spin: ROTATION => r"angular velocities of both surfaces about the contact normal, from x towards y, in `rad/s` or
            `rpm`; optional, 0. Not in line contacts; the speed that their mean gives to the edge of the Hertz zone is at most half of u_m";
    }
    BODIES {
        body_1: SolidOrTable(BODY), aside "the disc, ring, wheel or tappet";
        body_2: SolidOrTable(BODY), aside "the ball, roller, pinion or cam";
        plane, ball: SolidOrTable(BODY), aside "older names of `body_1` and `body_2`";
        roughness: LENGTH, usual [HEIGHTS], aside "composite rms roughness of both surfaces σ = √(σ_1² + σ_2²), 0.01 nm to 1 mm; optional";
        axes_angle: ANGLE, aside "from the x axis of body 1 to that of body 2";
    }
    BODY {
        name: Solid, aside "a solid of the database, or your own file";
        youngs_modulus: PRESSURE, usual [MODULUS], aside "Young's modulus E";
        poissons_ratio: Number, aside "Poisson's ratio ν, above -1 and below 0.5";
        hertz_pressure_limit: PRESSURE, aside "largest Hertz pressure that the body bears: beyond it a warning; optional";
        density: Quantity(&[D::DENSITY]), usual [SOLID_DENSITY], aside "density, for thermal contacts";
        thermal_conductivity: CONDUCTIVITY, usual [SOLID_CONDUCTIVITY], aside "thermal conductivity, for thermal contacts";
        heat_capacity: HEAT_CAPACITY, usual [SPECIFIC_HEATS], aside "heat capacity, for thermal contacts";
        radius_x, radius_y: QuantityOr(&["flat"]), usual [GROOVES], aside "principal radii of a body of an elliptical contact: positive for
            convex, negative for concave";
        layers: Tables(LAYER), aside "bonded layers from the surface of the body down";
    }
    /// `layers` of a body.
    pub LAYER {
        thickness: LENGTH => "thickness, 1 nm to 10 mm; all layers of a body together at most the radius of the contact";
        name: Solid => "a solid of the database, or your own file";
        youngs_modulus: PRESSURE, usual [MODULUS] => "Young's modulus E; with `name` instead of that of the solid";
        poissons_ratio: Number => "Poisson's ratio ν, likewise";
        hertz_pressure_limit: PRESSURE, aside "largest Hertz pressure, without effect here";
        density: Quantity(&[D::DENSITY]), usual [SOLID_DENSITY], aside "density";
        thermal_conductivity: CONDUCTIVITY, usual [SOLID_CONDUCTIVITY], aside "thermal conductivity";
        heat_capacity: HEAT_CAPACITY, usual [SPECIFIC_HEATS], aside "heat capacity";
    }
    /// `[surface_roughness]`.
    pub ROUGHNESS {
        body_1_rms_height, body_2_rms_height: LENGTH, usual [HEIGHTS] => r"rms heights of both surfaces, 0 to 1 mm, both or neither; instead of
            `roughness` in `[bodies]`";
        body_1_ra, body_2_ra, body_1_rq, body_2_rq, body_1_rz, body_2_rz: LENGTH, usual [HEIGHTS] => r"instead of an rms height, for each body
            one of them: Rq is the rms height; Ra is taken as σ/1.25, as of normally distributed heights; Rz is taken as 6 Ra (DIN 3991),
            between 4 and 8 Ra by other quotations, so σ is uncertain by −25 to +50 %. The report shows the rule";
        asperity_law: Choice(&["greenwood-tripp", "greenwood-williamson", "persson", "table"]), default "greenwood-tripp" => r#"pressure of the asperities over the distance of the
            mean planes: `"greenwood-tripp"` (default), elastic summits on both surfaces; `"greenwood-williamson"`, on one of them; `"persson"`,
            exponential, of randomly rough surfaces with `rms_slope`; `"table"`, from `asperity_distances` and `asperity_pressures`"#;
        asperity_group: Number => r"σβη, composite rms height times tip radius times density of asperities; above 0, below 1; usually 0.03 to
            0.07, else a warning";
        rms_height_to_asperity_radius: Number => r"σ/β, composite rms height over tip radius; above 0, below 1; usually 1e-4 to 1e-2, else a
            warning";
        rms_slope: Number => r#"composite rms slope, the root of the mean square of the gradient of the heights in both directions, with `asperity_law = "persson"`; above
            0, below 10"#;
        decay_length_to_rms_height: Number, bounds [0.05, 5.0], default "0.45" => r"u_0/σ, the distance over which the pressure of Persson's law falls to 1/e over the
            composite rms height{}; 0.4 to 0.5 of self-affine surfaces";
        pressure_factor: Number => r"β, the pressure of Persson's law over E* where the mean planes meet; above 0, below 10; default 0.195 times `rms_slope`, that of one
            band of wavelengths";
        asperity_distances: Quantities(&[D::LENGTH]) => "distances of the mean planes of a table, increasing; negative where the planes overlap";
        asperity_pressures: Quantities(&[D::PRESSURE]) => r"asperity pressures at these distances, falling, from at least the Hertz pressure to less than 0.1 % of it";
        hardness: PRESSURE => r"optional: hardness of the softer surface, as a pressure; asperities bear no more than it on the area that touches";
        boundary_friction_coefficient: Number, bounds [0.0, 2.0] => "friction of the asperities over their load{}; optional, for the friction of
            film and asperities";
        flow: Choice(&["average-gap", "distance", "patir-cheng"]), default "average-gap" => r#"the gap through which the oil flows between asperities: `"average-gap"` (default),
            the mean gap, which valleys keep open however close the surfaces are, so that oil is conserved; `"distance"`, that of the mean planes, none where they
            overlap; `"patir-cheng"`, the mean gap with flow factors. The choice changes the load of the asperities by up to a quarter of the whole load; without the
            key the report adds the results of `"distance"`"#;
        orientation: Choice(&["1/9", "1/6", "1/3", "1", "3", "6", "9"]), default "1" => r#"correlation length of the heights along the motion over that across it, with
            `flow = "patir-cheng"`: `"1"` (default) isotropic, above 1 grooves along the motion"#;
    }
    /// `[wear]`.
    pub WEAR {
        body_1_wear_coefficient, body_2_wear_coefficient: Number, bounds [0.0, 1.0] => r"dimensionless coefficient k of Archard's law{}: worn volume = k × load of the asperities
            × sliding distance / hardness. A body wears if it has one. A specific wear rate w (m²/N, or 1e-9 times mm³/(N m)) is k = w × hardness";
        body_1_hardness, body_2_hardness: PRESSURE => r#"hardness H of a body that wears, as a pressure, such as `"7 GPa"`"#;
        body_1_track_length, body_2_track_length: LENGTH => r"length of the track of a body that wears and moves through the contact, 2π times the radius of the track; not of a
            body at rest, which has a scar";
        sliding_distance: LENGTH => "distance by which the surfaces slide over each other";
        duration: TIME => "instead of it: time over which they slide";
        step: Number, bounds [1e-3, 0.5], default "0.1" => r"largest depth that both bodies together lose in a step, over the composite rms height{}; the error bars of the results contain
            those of the steps";
        max_steps: Count, bounds [1.0, 100_000.0], default "400" => "maximum number of steps";
    }
    /// `[inlet]`.
    pub INLET {
        oil_layer: LENGTH, usual [OIL_LAYER] => r"thickness of the oil on both surfaces together, at ambient density (0.1 nm to 10 mm). Its
            product with the entrainment speed is the oil supply per width. The meniscus position and the side flow around the contact are
            computed";
        meniscus_distance: LENGTH, usual [COATINGS] => r"distance from the centre to a straight meniscus across the motion, downstream of which
            the gap is filled; larger than the half-width of the dry contact. The mesh ends there, so `[mesh] inlet` must not be given; not for
            ellipses whose axes are at an angle to the motion";
    }
    /// `[transient]`.
    pub TRANSIENT {
        duration: TIME => r#"length of the time that is solved; it begins with the steady contact of `[contact]` and `[motion]`, unless `start = "apart"`. For a pair of
            teeth along its path and a cam over a turn: optional, by default the whole path or turn"#;
        tolerance: Number, bounds [1e-4, 0.05], default "3e-3" => "relative error of the films from the time steps{}; grid errors are in addition";
        output_times: Quantities(&[D::TIME]) => "times whose centrelines are written to `profiles.csv`; default: eleven at equal intervals";
        entrainment_speed, slide_to_roll_ratio: Table(COURSE) => "how the speed, or the ratio, changes; one that is not given stays at its value in `[motion]`";
        body_1_speed, body_2_speed: Table(COURSE) => "how the speeds of the bodies change, instead of both";
        slide_to_roll_ratio_across: Table(COURSE) => "how the ratio of the velocities across the entrainment changes; in addition to `entrainment_speed` and `slide_to_roll_ratio`";
        body_1_spin, body_2_spin: Table(COURSE) => "how the angular velocities of the bodies about the contact normal change, of point contacts; not with heat";
        load: Table(COURSE) => "how the load changes";
        radius: Table(COURSE) => "how the radius of a ball on a plane or of a cylinder changes";
        temperature: Table(COURSE) => "how the temperature of oil and bodies changes; with `[thermal]`, that of the oil at the inlet, to which the bodies keep their difference";
        oil_layer: Table(COURSE) => "how the supplied oil layer changes at the inlet edge of the contact area; for contacts with `oil_layer` in `[inlet]`";
        cavities: Choice(&["refilled", "conserved"]), default "refilled" => r#"content of the gap where the film has broken, in a contact with a flooded inlet: `"refilled"` (default), full, as in steady contacts;
            `"conserved"`, the oil that has flowed in, so that a cavity that comes back to the inlet starves the contact"#;
        at_rest: Switch, default "false" => "`true`: the surfaces do not move along the contact, as where a ball falls on a plane; `[motion]` then has no effect";
        start: Choice(&["steady", "apart"]), default "steady" => r"initial state: the steady contact, or separated bodies without pressure between them";
        gap: LENGTH => "initial central gap of separated bodies, 1 nm to 10 mm";
        approach_velocity: SPEED => "approach velocity at t = 0; for a body with `mass`";
        mass: Quantity(&[D::MASS, D::MASS.per(D::LENGTH)]) => "mass m of the body that moves along the normal; of a line contact per length. Without it the film carries the load at each instant";
        damping: Quantity(&[D::FORCE.per(D::SPEED), D::FORCE.per(D::SPEED).per(D::LENGTH)]) => "damping c of its motion, in N.s/m, of a line contact per length; 0 if absent";
        stiffness: Quantity(&[D::FORCE_PER_LENGTH, D::FORCE_PER_LENGTH.per(D::LENGTH)]) => "stiffness k of its spring, unloaded at t = 0; of a line contact per length; 0 if absent";
        approach: Table(COURSE) => "approach of the bodies since t = 0, instead of the load and of `mass`; it begins at 0";
    }
    /// How a quantity changes in time.
    pub COURSE {
        course: Choice(&["table", "ramp", "sine", "step"]) => r"linear interpolation of `times` and `values`; a ramp from the value of the case at `start` to `to`
            at `end`; a sine about the value of the case; a step to `to` at `at`";
        times: Quantities(&[D::TIME]) => "increasing times of a table, from 0 to the end of the duration at least";
        values: List => "the values at these times";
        file: Text => "a CSV file with a column of the time and one of the quantity (or `value`) with their units, instead of both lists";
        interpolation: Choice(&["linear", "smooth"]), default "linear" => r"`smooth`: monotone cubics through the rows of a table. Linear interpolation has a
            kink at each row, after which the time steps are short";
        start: TIME => "when a ramp or a sine begins; 0 if absent";
        end: TIME => "when a ramp ends";
        to: Scalar => "value at the end of a ramp, or after a step";
        at: TIME => "time of a step";
        amplitude: Scalar => "amplitude of a sine";
        period: TIME => "its period";
    }
    /// `[[surface]]`.
    pub SURFACE {
        kind: Choice(&["dent", "bump", "groove", "ridge", "waves", "map", "generated"]) => r"round; straight; waves that begin at a first crest and fade out ahead of it
            over a wavelength; heights from a file; a self-affine surface with random phases";
        body: Choice(&["body_1", "body_2"]) => "the body that it moves with";
        radius: LENGTH, usual [RELIEFS] => "r_0 of a dent or a bump, whose height falls to zero at 1.2 r_0";
        half_width: LENGTH, usual [RELIEFS] => "the same of a groove or a ridge, across it";
        depth: LENGTH, usual [HEIGHTS] => "depth of a dent or a groove in its middle";
        height: LENGTH, usual [HEIGHTS] => "height of a bump or a ridge in its middle";
        wavelength: LENGTH, usual [RELIEFS] => "length of the waves";
        amplitude: LENGTH, usual [HEIGHTS] => "amplitude of the waves";
        pitch: LENGTH, usual [RELIEFS] => r"distance at which a dent or bump is repeated against the motion behind the first one, a groove or ridge across itself (to both sides if it lies
            along the motion); not less than its whole width, 2.4 r_0; optional";
        count: Count, bounds [1.0, 1e6] => "number of them with `pitch`, the first included; unlimited if absent";
        pitch_across: LENGTH, usual [RELIEFS] => "the same of dents and bumps across the motion, half of them on either side of `y`";
        count_across: Count, bounds [1.0, 1e6] => "number of them with `pitch_across`, the first included";
        file: Text => "a file with the heights of a map: rows of heights, points, CSV, SDF or X3P ([formats](#maps))";
        layout: Choice(&["rows", "points"]), default "rows" => "content of a line of a plain text file: a row of heights, or x, y and z of a point";
        spacing, row_spacing: LENGTH, usual [RELIEFS] => "distances of the points in a row, and of the rows, of a text in rows; `row_spacing` is `spacing` if absent";
        height_unit: Text => "unit of the heights of a plain text file, such as `\"um\"`";
        length_unit: Text => "unit of the coordinates of points in a plain text file";
        missing_share: Number, bounds [0.0, 0.5], default "0.05" => "share of the points of a map that may have no height{}; they are interpolated by a membrane through their neighbours";
        level: Choice(&["none", "mean", "plane", "quadratic"]), default "plane" => "form that is subtracted from a map, by least squares";
        high_pass: LENGTH, usual [RELIEFS] => "cutoff of a Gaussian high-pass filter of a map, with half the amplitude at this wavelength; optional";
        low_pass: LENGTH, usual [RELIEFS] => r"cutoff of a Gaussian low-pass filter of a map; the grids resolve this wavelength, without it twice the distance of
            points";
        length, width: LENGTH, usual [RELIEFS] => "sides of a generated surface, along its rows and across them; line contacts have no width";
        rolloff_wavelength: LENGTH, usual [RELIEFS] => "wavelength above which the spectral density of a generated surface is constant";
        shortest_wavelength: LENGTH, usual [RELIEFS] => "wavelength below which the spectral density is zero";
        hurst_exponent: Number, bounds [0.0, 1.0] => "Hurst exponent between these wavelengths";
        rms_height: LENGTH, usual [HEIGHTS] => "root mean square height Sq of a generated surface";
        anisotropy: Number, bounds [0.01, 100.0], default "1" => "ratio of the hill lengths along and across the rows";
        seed: Count, bounds [0.0, 4294967295.0] => "random seed: the same seed gives the same heights";
        taper: LENGTH, usual [RELIEFS] => "width over which the heights of a map or a generated surface fall to zero along the rim, by a cosine; a tenth of the shorter side if absent";
        direction: ANGLE, default "0 deg" => r"direction across a groove or a ridge, in which waves follow each other, or of the rows of a map, from the motion: -90 to 90
            degrees, of maps -180 to 180; 0 where grooves and waves lie across the motion";
        x: LENGTH => "where its middle, or its first crest, lies at t = 0; negative before the contact";
        y: LENGTH, default "0 m" => "the same across the motion";
    }
    /// `[curve]`.
    pub CURVE {
        quantity: Choice(&[
            "motion.entrainment_speed", "motion.slide_to_roll_ratio", "motion.body_1_speed", "motion.body_2_speed", "motion.ball_speed",
            "motion.plane_speed", "contact.load", "contact.hertz_pressure", "contact.radius", "inlet.oil_layer",
            "inlet.meniscus_distance", "lubricant.temperature", "temperature", "machine.ball_diameter", "machine.ball_radius",
            "machine.load", "machine.hertz_pressure", "machine.ball_speed", "machine.disc_speed", "machine.entrainment_speed",
            "machine.slide_to_roll_ratio", "machine.slide_to_roll_ratio_across", "machine.body_1_speed", "machine.body_2_speed",
            "machine.skew_angle", "machine.body_1_spin", "machine.body_2_spin", "machine.pitch_diameter",
            "machine.inner_groove_curvature", "machine.outer_groove_curvature", "machine.contact_angle", "machine.inner_ring_speed",
            "machine.outer_ring_speed", "machine.ball_load", "machine.radial_clearance", "machine.radial_load", "machine.axial_load",
            "machine.axial_preload", "machine.moment", "machine.misalignment", "machine.dynamic_load_rating",
            "machine.static_load_rating", "machine.fatigue_load_limit", "machine.contamination_factor", "machine.reliability",
            "machine.thermal_resistance", "machine.ambient_temperature", "machine.roller_diameter", "machine.roller_length",
            "machine.roller_load", "machine.module", "machine.pressure_angle", "machine.face_width", "machine.pinion_torque",
            "machine.pinion_speed", "machine.load_share", "machine.addendum_pinion", "machine.addendum_wheel",
            "machine.pinion_profile_shift", "machine.wheel_profile_shift", "machine.centre_distance", "machine.pinion_tip_diameter",
            "machine.wheel_tip_diameter", "machine.pinion_root_diameter", "machine.wheel_root_diameter", "machine.pinion_face_width",
            "machine.wheel_face_width", "machine.tip_relief", "machine.pinion_tip_relief", "machine.wheel_tip_relief",
            "machine.tip_relief_length", "machine.tooth_stiffness", "machine.blank_factor", "machine.pinion_bore_diameter",
            "machine.wheel_bore_diameter", "machine.bulk_temperature", "machine.scuffing_temperature", "machine.permissible_lambda",
            "machine.pinion_ra", "machine.wheel_ra", "machine.oil_factor", "machine.normal_module", "machine.normal_pressure_angle",
            "machine.helix_angle", "machine.base_radius", "machine.lift", "machine.lift_acceleration", "machine.cam_speed",
            "machine.width", "machine.top_dwell", "machine.lift_tolerance", "machine.eccentricity", "machine.follower_radius",
            "machine.follower_offset", "machine.roller_slip", "machine.pivot_x", "machine.pivot_y", "machine.arm_length",
            "machine.spring_rate", "machine.preload", "machine.moving_mass", "machine.extra_force",
        ]) => r"key path of the quantity to vary, which the case must contain; the curve replaces its value. One of";
        values: List => "2 to 1000 different values, in the order of solving";
        from, to: Number => "instead of `values`: a range, ends included; decreasing ranges are allowed";
        points: Count => "number of points of the range";
        spacing: Choice(&["linear", "log"]), default "linear" => "equal steps or equal ratios";
        folders: Switch, default "false" => "`true`: also write the full results of each point in a separate folder";
        newtonian: Switch, default "false" => r"`true`: each point is also solved without shear thinning, for comparison (an error for a
            lubricant without shear thinning, and for whole machines)";
        isothermal: Switch, default "false" => r"`true`: each point is also solved without heat, for comparison (an error for a case without
            heat, and for whole machines)";
    }
    /// A study.
    pub STUDY {
        title: Text => "text for report and pictures";
        case: Text => "the base case";
        points: Text => "a table of points";
        axis: Tables(AXIS) => "what varies";
    }
    /// `[[axis]]` of a study.
    pub AXIS {
        key: Text => "path of the input: `contact.load`, `lubricant.name`, `mesh.target_error`. The base case need not contain it";
        values: List => r#"a list: quantities with units, numbers, names, switches, tables such as `{ law = "barus", ... }`; all of one type"#;
        from, to: Scalar => "a range instead of the list; values between the ends are rounded to six digits";
        points: Count => "number of points of the range, ends included";
        spacing: Choice(&["linear", "log"]), default "linear" => "equal steps or equal ratios";
        zip: Text => r"axes with the same name here vary together, value by value; single values may repeat, whole points may not; all other
            axes are combined with each other (full factorial), the last one varying fastest";
    }
}
