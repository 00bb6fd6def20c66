//! Pairs of gears and cams from a case file to their figures.

use approx::assert_relative_eq;
use ertel::case::{Case, Mechanics};
use ertel::figures::{Definition, path, turn};
use ertel::machine::{MachineFigures, estimate};
use ertel::solution::Figure;
use ertel::study::MachineSolution;

use crate::common::text::read;
use crate::common::{assert_figures, near, solved_machine, value};

const REST: &str = concat!(
    "[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n",
    "[lubricant]\ntemperature = \"90 degC\"\ndensity = { law = \"dowson-higginson\", rho_0 = \"860 kg/m^3\" }\nviscosity = { law = \"roelands\", mu_0 = \"20 mPa.s\", alpha = \"16 1/GPa\" }\nshear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }\n",
    "[mesh]\npreset = \"coarse\"\n"
);

/// FZG gears under a light load.
const GEARS: &str = concat!(
    "title = \"FZG C14\"\n",
    "[machine]\nkind = \"spur-gear\"\ntemplate = \"FZG-C14\"\npinion_torque = \"40 N.m\"\npinion_speed = \"2000 rpm\"\nposition = \"path\"\npoints = 2\nload_sharing = \"thirds\"\nbulk_temperature = \"100 degC\"\nscuffing_temperature = \"300 degC\"\npinion_ra = \"0.3 um\"\nwheel_ra = \"0.5 um\"\npermissible_lambda = 0.2\n"
);

const CAM: &str = concat!(
    "title = \"Eccentric disc\"\n",
    "[machine]\nkind = \"cam\"\nfollower = \"flat\"\nbase_radius = \"18 mm\"\neccentricity = \"4 mm\"\ncam_speed = \"1500 rpm\"\nwidth = \"12 mm\"\nload = \"500 N\"\nangle = \"turn\"\npoints = 4\n"
);

fn solve(machine: &str) -> (Case, MachineSolution, MachineFigures) {
    solved_machine(format!("{machine}{REST}"))
}

fn figure(solved: &MachineSolution, contact: usize, figure: Figure) -> f64 {
    solved
        .solution(contact)
        .unwrap()
        .figure(figure)
        .unwrap()
        .value
}

/// A figure at every contact, all of which have one.
fn contact_figure(figures: &MachineFigures, of: Definition) -> Vec<f64> {
    let entry = figures.at_contacts.find(of).unwrap();
    entry.values.iter().map(|v| v.unwrap().value).collect()
}

/// The bars of a few contacts cover the values from many: they include the distance of the contacts.
#[test]
fn bars_of_losses_cover_the_distance_of_contacts() {
    let losses = |points: usize| {
        let points = format!("points = {points}");
        let (_, _, found) = solve(&GEARS.replace("points = 2", &points));
        [
            "friction_power",
            "friction_power_sliding",
            "friction_power_rolling",
        ]
        .map(|name| found.find(name).unwrap().estimate)
    };
    let many = losses(40);
    for points in [6, 12] {
        for (few, many) in losses(points).iter().zip(&many) {
            let (off, bar) = ((few.value - many.value).abs(), few.error.unwrap());
            let least = many.error.unwrap();
            assert!(off < bar + least, "{points}: {few:?} {many:?}");
            assert!(bar >= least, "{points}: {few:?} {many:?}");
        }
    }
}

/// Losses by a sum of 20 000 parts with the shares 1/3 to 2/3 and 1; the flash temperature of fast bodies by the formula of ISO/TS 6336-20 with its factor 1.11.
#[test]
fn a_short_path_of_gears() {
    let (case, solved, found) = solve(GEARS);
    let Mechanics::Gears(gears) = &case.whole.as_ref().unwrap().mechanics else {
        panic!("gears")
    };
    // A, B, C, D and E.
    assert_eq!(gears.path.len(), 5);
    let at = |figure_: Figure| -> Vec<(f64, f64)> {
        let path = gears.path.iter().enumerate();
        path.map(|(i, p)| (p.position, figure(&solved, i, figure_)))
            .collect()
    };
    let friction = at(Figure::TractionCoefficient);
    let power = at(Figure::FrictionPower);
    let between = |of: &[(f64, f64)], s: f64| {
        let after = of.iter().position(|(x, _)| *x >= s).unwrap_or(4).max(1);
        let ((from, a), (to, b)) = (of[after - 1], of[after]);
        a + (b - a) * (s - from) / (to - from)
    };
    let [a, b, d, e] = [0, 1, 3, 4].map(|i| gears.path[i].position);
    // 16 and 24 teeth, α = 20°, m = 4.5 mm: r_b1 = 33.8289 mm, p = 13.2846 mm.
    let base = 36e-3 * 20_f64.to_radians().cos();
    let pitch = std::f64::consts::PI * 4.5e-3 * 20_f64.to_radians().cos();
    let omega = 2000.0 * std::f64::consts::TAU / 60.0;
    let force = 40.0 / base;
    let load = |s: f64| {
        let share = match s {
            s if s < b => (1.0 + (s - a) / (b - a)) / 3.0,
            s if s > d => (1.0 + (e - s) / (e - d)) / 3.0,
            _ => 1.0,
        };
        share * force
    };
    let resistance: Vec<(f64, f64)> = (gears.path.iter().zip(&friction).zip(&power))
        .map(|((p, (s, mu)), (_, lost))| {
            let rest = lost - mu.abs() * p.load_per_length * (p.u_2 - p.u_1).abs();
            (*s, rest / p.entrainment_speed)
        })
        .collect();
    // Friction has one sign before the pitch point and the other behind it: its size is what is linear between the contacts.
    let sizes: Vec<(f64, f64)> = friction.iter().map(|(s, mu)| (*s, mu.abs())).collect();
    let (mut sliding, mut rolling, mut weight) = (0.0, 0.0, 0.0);
    let n = 20_000;
    for i in 0..n {
        let s = a + (f64::from(i) + 0.5) / f64::from(n) * (e - a);
        let step = (e - a) / f64::from(n) / pitch;
        let slide = omega * (1.0 + 16.0 / 24.0) * s.abs() * load(s) * step;
        sliding += between(&sizes, s) * slide;
        weight += slide;
        let [one, two] = gears.pair.curvature_radii(s);
        let mean = 0.5 * omega * (one + two / 1.5);
        rolling += between(&resistance, s) * mean * 14e-3 * step;
    }
    assert_figures(
        &found,
        &[
            ("friction_power_rolling", rolling, 2e-3),
            ("friction_power_sliding", sliding, 2e-3),
            ("friction_coefficient_mean", sliding / weight, 2e-3),
        ],
    );
    let total = value(&found, "friction_power");
    assert_relative_eq!(total, sliding + rolling, max_relative = 2e-3);
    let efficiency = 1.0 - total / (40.0 * omega);
    assert_figures(&found, &[("mesh_efficiency", efficiency, 1e-9)]);
    assert!(efficiency > 0.97 && efficiency < 0.9999, "{efficiency}");

    let steel = |body: &ertel::case::Body| {
        let conductivity = body.thermal_conductivity.as_ref().unwrap();
        let capacity = body.heat_capacity.as_ref().unwrap();
        (conductivity.conductivity(0.0, 373.15)
            * body.density.unwrap()
            * capacity.heat_capacity(0.0, 373.15))
        .sqrt()
    };
    let effusivity = steel(&case.body_1);
    let flashes = gears.path.iter().zip(&friction).map(|(p, (_, mu))| {
        let heat = mu.abs() * p.load_per_length * (p.u_2 - p.u_1).abs();
        1.11 * heat / ((2.0 * p.half_width).sqrt() * effusivity * (p.u_1.sqrt() + p.u_2.sqrt()))
    });
    let flashes: Vec<f64> = flashes.collect();
    let flash = flashes.iter().copied().fold(0.0, f64::max);
    // The norm's formula is that of infinite Péclet numbers.
    assert_figures(&found, &[("flash_temperature", flash, 0.05)]);
    let hottest = value(&found, "contact_temperature");
    near(hottest, 373.15 + value(&found, "flash_temperature"), 1e-9);
    // Oil at 90 °C, teeth at 100 °C, scuffing at 300 °C.
    assert_figures(
        &found,
        &[("scuffing_safety", 210.0 / (hottest - 363.15), 1e-9)],
    );
    let thinnest = (0..5).map(|i| figure(&solved, i, Figure::FilmMinimum));
    let thinnest = thinnest.fold(f64::INFINITY, f64::min);
    let lambda = thinnest / 0.4e-6;
    assert_figures(
        &found,
        &[
            ("specific_film_minimum", lambda, 1e-9),
            ("micropitting_safety", lambda / 0.2, 1e-9),
        ],
    );
    // GEARpie has H_V = 0.1950 of C14 after Ohlendorf.
    assert!((value(&found, "loss_factor_ohlendorf") - 0.1950).abs() < 6e-5);
    assert!(found.find("friction_coefficient_schlenk").is_some());
    let highest = gears
        .path
        .iter()
        .map(|p| p.hertz_pressure)
        .fold(0.0, f64::max);
    assert_eq!(value(&found, "hertz_pressure_maximum"), highest);

    // Along the path: A, B with both loads, C, D with both loads, E.
    let entry = |name: &str| -> Vec<Option<f64>> {
        let all = &found.at_contacts.all;
        let entry = all.iter().find(|entry| entry.figure.name == name);
        let values = &entry.unwrap_or_else(|| panic!("no {name}")).values;
        values.iter().map(|v| v.map(|v| v.value)).collect()
    };
    let own = [0, 2, 3, 4, 6];
    let (rise, hot) = (entry("flash_temperature"), entry("contact_temperature"));
    let (film, power_of) = (entry("specific_film"), entry("friction_power"));
    assert_eq!(rise.len(), 7);
    for (i, place) in own.into_iter().enumerate() {
        let by_norm = flashes[i];
        near(rise[place].unwrap() + 1e-6, by_norm + 1e-6, 0.1);
        near(hot[place].unwrap(), 373.15 + rise[place].unwrap(), 1e-9);
        let lambda = figure(&solved, i, Figure::FilmMinimum) / 0.4e-6;
        assert_relative_eq!(film[place].unwrap(), lambda, max_relative = 1e-12);
        assert_relative_eq!(power_of[place].unwrap(), power[i].1, max_relative = 1e-12);
    }
    assert!(rise[3].unwrap() < 1e-9, "{rise:?}");
    let largest = rise.iter().map(|r| r.unwrap()).fold(0.0, f64::max);
    assert_eq!(largest, value(&found, "flash_temperature"));
    // Beyond B and D with 2/3 of the load and the same friction: Q and 1/√a of the formula by hand, (2/3)^(3/4); no film is solved there.
    for (beyond, own) in [(1, 2), (5, 4)] {
        let ratio = rise[beyond].unwrap() / rise[own].unwrap();
        assert_relative_eq!(ratio, (2.0_f64 / 3.0).powf(0.75), max_relative = 2e-2);
        assert_eq!(film[beyond], None);
    }
    let table = ertel::output::machine_table(&solved, &found.at_contacts);
    assert_eq!(table.lines().count(), 8);
    let head = table.lines().next().unwrap();
    for title in [
        "roll_angle_rad",
        "load_share",
        "specific_sliding_pinion",
        "friction_coefficient",
        "flash_temperature_K",
        "flash_temperature_error_K",
        "contact_temperature_K",
        "specific_film",
    ] {
        assert!(head.split(',').any(|own| own == title), "{title} in {head}");
    }
    let once = head
        .split(',')
        .filter(|own| *own == "friction_power_W_per_m");
    assert_eq!(once.count(), 1);
    let document = ertel::output::machine_json(&case.echo(), &solved, &found).unwrap();
    let at_contacts = &document["contact_figures"];
    assert_eq!(at_contacts["label"][1], "B");
    assert_eq!(at_contacts["beyond"][1], "before");
    assert_eq!(at_contacts["beyond"][5], "after");
    assert!(at_contacts["figures"]["specific_film"]["value"][1].is_null());
    let of_json = at_contacts["figures"]["flash_temperature"]["value"][1].as_f64();
    assert_eq!(of_json, rise[1]);
}

/// Closed forms of C14: contact ratio by the lengths of its path; Schlenk's friction; flash temperatures by the formula of ISO/TS 6336-20 with that friction; minimum films after
/// Dowson and Higginson, h/R = 2.65 G^0.54 U^0.7 W^−0.13, from the lubricant at 100 °C, over the mean Ra.
#[test]
fn gears_by_closed_forms() {
    let case = read(format!("{GEARS}{REST}"));
    let Mechanics::Gears(gears) = &case.whole.as_ref().unwrap().mechanics else {
        panic!("gears")
    };
    let found = estimate(&case).unwrap();
    let figures = &found.figures;
    let [a, e] = [0, 4].map(|i| gears.path[i].position);
    let pitch = std::f64::consts::PI * 4.5e-3 * 20_f64.to_radians().cos();
    assert_figures(
        figures,
        &[("transverse_contact_ratio", (e - a) / pitch, 1e-9)],
    );
    assert!((value(figures, "loss_factor_ohlendorf") - 0.1950).abs() < 6e-5);

    // w in N/mm, v_ΣC in m/s, ρ_C in mm, 20 mPa·s and 0.4 µm.
    let at_c = &gears.path[2];
    let force = 40.0 / (36e-3 * 20_f64.to_radians().cos());
    let speed = at_c.u_1 + at_c.u_2;
    let load = 1e-3 * force / 14e-3 / (speed * 1e3 * at_c.reduced_radius);
    let schlenk = 0.048 * load.powf(0.2) * 20_f64.powf(-0.05) * 0.4_f64.powf(0.25);
    assert_figures(figures, &[("friction_coefficient_schlenk", schlenk, 1e-6)]);

    let body = &case.body_1;
    let conductivity = body.thermal_conductivity.as_ref().unwrap();
    let capacity = body.heat_capacity.as_ref().unwrap();
    let effusivity = (conductivity.conductivity(0.0, 373.15)
        * body.density.unwrap()
        * capacity.heat_capacity(0.0, 373.15))
    .sqrt();
    let viscosity = case.lubricant.ambient_viscosity();
    let (mut flash, mut film) = (0.0_f64, f64::INFINITY);
    // E' = E/(1 − ν²).
    let modulus = 210e9 / (1.0 - 0.09);
    for p in &gears.path {
        let heat = schlenk * p.load_per_length * (p.u_2 - p.u_1).abs();
        let root = (2.0 * p.half_width).sqrt() * effusivity * (p.u_1.sqrt() + p.u_2.sqrt());
        flash = flash.max(1.11 * heat / root);
        let r = p.reduced_radius;
        let [g, u, w] = [
            16e-9 * modulus,
            viscosity * p.entrainment_speed / (modulus * r),
            p.load_per_length / (modulus * r),
        ];
        film = film.min(2.65 * r * g.powf(0.54) * u.powf(0.7) * w.powf(-0.13));
    }
    let hottest = value(figures, "contact_temperature");
    assert_figures(
        figures,
        &[
            ("flash_temperature", flash, 0.05),
            (
                "contact_temperature",
                373.15 + value(figures, "flash_temperature"),
                1e-9,
            ),
            ("scuffing_safety", 210.0 / (hottest - 363.15), 1e-9),
            ("film_minimum", film, 1e-3),
            ("specific_film_minimum", film / 0.4e-6, 1e-3),
            ("micropitting_safety", film / 0.4e-6 / 0.2, 1e-3),
        ],
    );
    let absent: Vec<&str> = found.absent.iter().map(|(figure, _)| figure.name).collect();
    assert_eq!(
        absent,
        [
            "friction_coefficient_mean",
            "friction_power",
            "mesh_loss",
            "mesh_efficiency"
        ]
    );
    // The shares 1/3 to 2/3 and 1, and the largest of the flash temperatures along the path.
    let shares = contact_figure(figures, path::LOAD_SHARE);
    near(shares[0], 1.0 / 3.0, 1e-9);
    let pitch = (figures.at_contacts.places.iter()).position(|place| place.at == 0.0);
    near(shares[pitch.unwrap()], 1.0, 1e-9);
    let rises = contact_figure(figures, path::FLASH_TEMPERATURE);
    let most = rises.into_iter().fold(0.0, f64::max);
    assert_eq!(most, value(figures, "flash_temperature"));
}

/// Without the limits and the roughness the estimate says what to give.
#[test]
fn an_estimate_says_what_it_needs() {
    let bare = GEARS
        .replace("scuffing_temperature = \"300 degC\"\n", "")
        .replace(
            "pinion_ra = \"0.3 um\"\nwheel_ra = \"0.5 um\"\npermissible_lambda = 0.2\n",
            "",
        );
    let found = estimate(&read(format!("{bare}{REST}"))).unwrap();
    let needs = |name: &str| {
        let absent = found.absent.iter().find(|(figure, _)| figure.name == name);
        absent.unwrap_or_else(|| panic!("{name}")).1
    };
    assert_eq!(needs("scuffing_safety"), "give `scuffing_temperature`");
    assert_eq!(needs("micropitting_safety"), "give `permissible_lambda`");
    for name in ["flash_temperature", "specific_film_minimum"] {
        assert_eq!(needs(name), "give `pinion_ra` and `wheel_ra`");
    }
    assert_eq!(needs("mesh_loss"), "needs a solve");
}

/// An eccentric disc, s = e cos θ, under 500 N: T = F e at a right angle, no pressure angle; a flat follower is entrained with ω (r_b + s + 2 s'')/2 =
/// ω (9 − 2 cos θ) mm, which does not reverse.
#[test]
fn a_cam_by_closed_forms() {
    let case = read(format!("{CAM}{REST}"));
    let found = estimate(&case).unwrap();
    assert_figures(&found.figures, &[("torque_maximum", 500.0 * 4e-3, 1e-4)]);
    assert_eq!(value(&found.figures, "pressure_angle_maximum"), 0.0);
    let omega = 1500.0 * std::f64::consts::TAU / 60.0;
    for force in contact_figure(&found.figures, turn::FOLLOWER_FORCE) {
        near(force, 500.0, 1e-12);
    }
    let speeds = contact_figure(&found.figures, turn::ENTRAINMENT_SPEED);
    for (i, speed) in speeds.into_iter().enumerate() {
        let theta = std::f64::consts::TAU * i as f64 / 4.0;
        near(speed.abs(), omega * 1e-3 * (9.0 - 2.0 * theta.cos()), 1e-6);
    }
    let Mechanics::Cam(cam) = &case.whole.as_ref().unwrap().mechanics else {
        panic!("a cam")
    };
    assert!(cam.reversals.is_empty());
}

/// With heat the temperatures of the teeth are those that were solved: the hottest flank of all contacts is the contact temperature of S_B, and Blok's is given in addition.
#[test]
fn solved_flanks_are_the_contact_temperature() {
    let (_, solved, found) = solved_machine(format!("{GEARS}{REST}").replace(
        "[mesh]",
        "thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n[thermal]\n[mesh]",
    ));
    let flanks = [
        Figure::TemperatureBody1Maximum,
        Figure::TemperatureBody2Maximum,
    ];
    let hottest = (0..5).flat_map(|i| flanks.map(|flank| figure(&solved, i, flank)));
    let hottest = hottest.fold(0.0, f64::max);
    assert_eq!(value(&found, "contact_temperature"), hottest);
    assert_figures(
        &found,
        &[
            ("flash_temperature", hottest - 373.15, 1e-9),
            ("scuffing_safety", 210.0 / (hottest - 363.15), 1e-9),
        ],
    );
    let blok = value(&found, "flash_temperature_blok");
    assert_figures(&found, &[("contact_temperature_blok", 373.15 + blok, 1e-9)]);
    // The oil enters at the temperature of the teeth, 373.15 K: nothing is colder, but for half a kelvin of this coarse mesh.
    for i in 0..5 {
        assert!(figure(&solved, i, Figure::FilmTemperatureLowest) > 372.65);
    }
}

/// The mean of four angles is within the bar; those at 90° and 270° differ only in the direction of the follower, which has no effect on speeds.
#[test]
fn a_turn_of_a_cam() {
    let (case, solved, found) = solve(CAM);
    let contacts = &case.whole.as_ref().unwrap().contacts;
    assert_eq!(contacts.len(), 4);
    let power: f64 = (0..4)
        .map(|i| figure(&solved, i, Figure::FrictionPower) * 12e-3 / 4.0)
        .sum();
    let turn = found.find("friction_power").unwrap().estimate;
    let off = (turn.value - power).abs();
    assert!(off < turn.error.unwrap(), "{power} {turn:?}");
    let omega = 1500.0 * std::f64::consts::TAU / 60.0;
    assert_figures(&found, &[("friction_torque", turn.value / omega, 1e-9)]);
    // F e of an eccentric disc, at 90°.
    assert_figures(&found, &[("torque_maximum", 2.0, 1e-9)]);
    let films = (0..4).map(|i| figure(&solved, i, Figure::FilmMinimum));
    let thinnest = films.fold(f64::INFINITY, f64::min);
    assert_figures(&found, &[("film_minimum", thinnest, 1e-12)]);
    // u_m = (ω/2)(r_b − e cos θ) is least at 0°, the nose.
    assert_eq!(value(&found, "film_minimum_angle"), 0.0);
    // Over the turn: F = 500 N, u_m as above, s of an eccentric disc e cos θ and no pressure angle under a flat follower.
    let entry = |figure| {
        let values = &found.at_contacts.find(figure).unwrap().values;
        values.iter().map(|v| v.unwrap().value).collect::<Vec<_>>()
    };
    for (i, contact) in contacts.iter().enumerate() {
        let cosine = contact.place.cos();
        let entrainment = 0.5 * omega * (18e-3 - 4e-3 * cosine);
        near(
            entry(turn::ENTRAINMENT_SPEED)[i].abs(),
            entrainment.abs(),
            1e-9,
        );
        near(entry(turn::FOLLOWER_FORCE)[i], 500.0, 1e-9);
        near(entry(turn::LIFT)[i] + 1.0, 1.0 + 4e-3 * cosine, 1e-12);
        assert!(entry(turn::PRESSURE_ANGLE)[i].abs() < 1e-12);
    }
}
