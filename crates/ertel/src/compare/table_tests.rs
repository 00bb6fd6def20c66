//! Tables of rigs in the formats that people, spreadsheets and instruments write.

use ertel_input::csv::ColumnMap;

use super::*;
use crate::case::Case;

const CONTACT: &str = r#"
[contact]
kind = "circular"
radius = "9.525 mm"
load = "30 N"
[motion]
entrainment_speed = "3 m/s"
slide_to_roll_ratio = 0.0
"#;

const REST: &str = r#"
[bodies]
body_1 = "steel"
body_2 = "steel"
[lubricant]
name = "squalane-pip"
temperature = "50 degC"
"#;

fn read_case(case: &str, table: &[u8], params: &ReadParams) -> Result<Measured, MeasuredError> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    let case = write("case.toml", format!("{case}{REST}").as_bytes());
    Measured::read(&case, &write("rig.csv", table), params)
}

fn read(table: &str) -> Result<Measured, MeasuredError> {
    read_case(CONTACT, table.as_bytes(), &ReadParams::default())
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs().max(1e-9)
}

/// Speeds of 0.5 and 1 m/s in all tables; each figure as it is measured there.
fn check(name: &str, measured: &Measured, figure: Measurand, values: [f64; 2]) {
    assert_eq!(measured.rows.len(), 2, "{name}");
    for (row, (speed, value)) in measured.rows.iter().zip([0.5, 1.0].into_iter().zip(values)) {
        let case: &Case = &measured.study.points[row.point].case;
        assert!(
            near(case.motion.entrainment_speed, speed),
            "{name}: {}",
            case.motion.entrainment_speed
        );
        let found = row.figures[figure as usize].unwrap_or_else(|| panic!("{name}: {row:?}"));
        assert!(near(found.value, value), "{name}: {found:?}");
    }
}

#[test]
fn one_table_of_films_in_many_spellings() {
    for table in [
        "speed [m/s],film_central [nm]\n0.5,120\n1.0,300\n",
        "speed_m_per_s,film_central_nm\n0.5,120\n1,300\n",
        "speed_mm_s;film_central_um\n500;0,12\n1000;0,3\n",
        "u [m/s];h_c [nm]\n0,5;120\n1,0;300\n",
        "v (mm/s)\thc (nm)\n500\t120\n1000\t300\n",
        "Entrainment speed / m/s,Central film thickness / nm\n0.5,120\n1,300\n",
        "Entrainment speed / (m/s),h0/nm\n0.5,120\n1,300\n",
        "Mean speed in m/s;Central film thickness h_c in µm\n0,5;0,12\n1;0,3\n",
        "Rolling velocity, mm/sec;Central film, nm\n500;120\n1000;300\n",
        "Geschwindigkeit [m/s];Zentrale Filmdicke [nm]\n0,5;120\n1,0;300\n",
        "Wälzgeschwindigkeit u / m/s;Zentrale Schmierfilmdicke h_c / nm\n0,5;120\n1,0;300\n",
        "mittlere Geschwindigkeit in m/s;Schmierfilmdicke in nm\n0,5;120\n1,0;300\n",
        "u;h\nm/s;nm\n0.5;120\n1.0;300\n",
        "Speed,Film\n[m/s],[nm]\n0.5,120\n1.0,300\n",
        "Speed (m/s),Film (nm)\n0.5,120\n1,300\n",
        "Speed [mm/s],Film thickness [micron]\n500,0.12\n1000,0.3\n",
        "sep=;\nSpeed [m/s];Film thickness [nm]\n0,5;120\n1,0;300\n",
        "EHD test 12\nOperator: Müller\nBall 3/4\"; disc 46 mm\nSpeed [m/s];Film [nm]\n0,5;120\n1,0;300\n",
        "No.,Time [s],Speed [m/s],Film [nm],Comment\n1,10,0.5,120,first\n2,20,1.0,300,\n",
        ",Speed [m/s],Film [nm]\n0,0.5,120\n1,1.0,300\n",
        "speed [m/s];film_central [nm];;\r\n0,5;120;;\r\n1,0;300;;\r\n2,0;n/a;;\r\n;;;\r\n",
        "Speed [m/s]  Film [nm]\n0.5  120\n1.0  300\n",
        "# u_m_per_s h_c_nm\n0.5 120\n1 300\n",
        "speed [m/s],film_central [nm],film_central_uncertainty [%]\n0.5,120,-\n1.0,300,5\n",
        "motion.entrainment_speed / m/s,film_central / nm\n0.5,120\n1,300\n",
        "motion.entrainment_speed;film_central\nm/s;nm\n0,5;120\n1;300\n",
        "speed [ft/s],film_central [nm]\n1.640419947506561679790026246719160,120\n3.28083989501312335958005249343832,300\n",
    ] {
        let measured = read(table).unwrap_or_else(|error| panic!("{table}\n{error}"));
        check(table, &measured, Measurand::FilmCentral, [120e-9, 300e-9]);
    }
    for table in [
        "speed [m/s],minimum film [nm]\n0.5,120\n1,300\n",
        "u [m/s];hmin [nm]\n0,5;120\n1;300\n",
        "Geschwindigkeit [m/s];minimale Schmierfilmdicke h_min [nm]\n0,5;120\n1;300\n",
    ] {
        let measured = read(table).unwrap_or_else(|error| panic!("{table}\n{error}"));
        check(table, &measured, Measurand::FilmMinimum, [120e-9, 300e-9]);
    }
}

#[test]
fn one_table_of_tractions_in_many_spellings() {
    for table in [
        "speed [m/s],load [N],temperature [°C],slide_to_roll_ratio [%],traction_coefficient [-]\n0.5,20,40,50,0.052\n1.0,20,40,50,0.047\n",
        "u [m/s],F [N],T [°C],SRR [%],µ\n0.5,20,40,50,0.052\n1.0,20,40,50,0.047\n",
        "v [m/s];W [N];T [C];SRR;COF\n0,5;20;40;0,5;0,052\n1,0;20;40;0,5;0,047\n",
        "Speed;Load;Temp;SRR;COF\nmm/s;N;°C;%;-\n500;20;40;50;0.052\n1000;20;40;50;0.047\n",
        "Geschwindigkeit [m/s];Normalkraft [N];Öltemperatur [°C];Schlupf [%];Reibwert [-]\n0,5;20;40;50;0,052\n1,0;20;40;50;0,047\n",
        "Geschwindigkeit / m/s;Last / N;Temperatur / °C;Schlupf / %;Reibungszahl / -\n0,5;20;40;50;0,052\n1,0;20;40;50;0,047\n",
        "Rolling Speed (mm/s)\tBall Load (N)\tLube Temp (°C)\tSRR (%)\tTraction Coeff (-)\n500\t20\t40\t50\t0.052\n1000\t20\t40\t50\t0.047\n",
        "Entrainment speed in m/s,Normal force in kN,Temperature in K,Slide-to-roll ratio in %,Friction coefficient\n0.5,0.02,313.15,50,0.052\n1,0.02,313.15,50,0.047\n",
        "speed (m/s),load (lbf),temperature (°F),slide roll ratio (%),coefficient of friction ( - )\n0.5,4.496178874158,104,50,0.052\n1,4.496178874158,104,50,0.047\n",
    ] {
        let measured = read(table).unwrap_or_else(|error| panic!("{table}\n{error}"));
        check(table, &measured, Measurand::Traction, [0.052, 0.047]);
        let case = &measured.study.points[0].case;
        assert!(
            (case.contact.load - 20.0).abs() < 1e-6,
            "{table} {}",
            case.contact.load
        );
        assert!(near(case.lubricant.temperature, 313.15), "{table}");
        assert!(near(case.motion.slide_to_roll_ratio, 0.5), "{table}");
    }
    let measured = read("u [m/s];Schlupf [%];Film [nm]\n1;5;100\n").unwrap();
    let notes = measured.notes.join("\n");
    for words in [
        "`Schlupf [%]` is read as the slide-to-roll ratio",
        "`Film [nm]` is read as the central film",
    ] {
        assert!(notes.contains(words), "{notes}");
    }
}

#[test]
fn columns_are_assigned_by_the_user() {
    let params = |maps: &[&str]| ReadParams {
        table: ertel_input::csv::CsvParams {
            columns: maps
                .iter()
                .map(|map| ColumnMap::parse(map).unwrap())
                .collect(),
            ..Default::default()
        },
        ..ReadParams::default()
    };
    for (table, maps) in [
        (
            "Speed [m/s],Film (nm)\n0.5,120\n1,300\n",
            &["film=Film (nm)"][..],
        ),
        (
            "Drive,Result\n0.5,120\n1,300\n",
            &["speed=Drive:m/s", "h_c=Result:nm"],
        ),
        ("x;x\n0.5;120\n1;300\n", &["u=#1:m/s", "film_central=#2:nm"]),
        // The mean of three readings, and a second film column.
        (
            "Speed [m/s],Film [nm],Film thickness [nm]\n0.5,1,120\n1,2,300\n",
            &["film=Film thickness [nm]"],
        ),
    ] {
        let measured = read_case(CONTACT, table.as_bytes(), &params(maps));
        let measured = measured.unwrap_or_else(|error| panic!("{table}\n{error}"));
        check(table, &measured, Measurand::FilmCentral, [120e-9, 300e-9]);
    }
    // The same in the case.
    let case = format!(
        "{CONTACT}\n[compare]\ncolumns = {{ speed = \"Drive:m/s\", film = \"Result:nm\" }}\nignore = [\"x\"]\n"
    );
    let table = b"Drive,Result,x\n0.5,120,1\n1,300,1\n";
    let measured = read_case(&case, table, &ReadParams::default()).unwrap();
    check(
        "in the case",
        &measured,
        Measurand::FilmCentral,
        [120e-9, 300e-9],
    );
    let wrong = case.replace("ignore", "ignored");
    let error = read_case(&wrong, table, &ReadParams::default())
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("ignored") && error.contains("ignore"),
        "{error}"
    );
    let table = "Speed [m/s],R,film_central [nm]\n0.5,10,120\n1,10,300\n";
    let measured = read_case(CONTACT, table.as_bytes(), &params(&["contact.radius=R:mm"])).unwrap();
    assert!(near(measured.study.points[0].case.contact.radius, 0.01));
    let error = read(table).unwrap_err().to_string();
    for words in [":1:2", "unknown column `R`", "--column", "--ignore"] {
        assert!(error.contains(words), "{error}");
    }
}

/// Turning all speeds turns u and u_2 - u_1: their ratio stays.
#[test]
fn reversed_rows_are_turned_and_rows_at_rest_omitted() {
    let table = "speed [m/s],srr [%],film_central [nm]\n-0.5,10,120\n0.5,10,121\n0,10,1\n1.0,10,300\n-2,10,nan\n";
    let measured = read(table).unwrap();
    assert_eq!(measured.rows.len(), 3);
    assert_eq!(
        measured.study.points.len(),
        2,
        "a turned point is the same point"
    );
    let case = &measured.study.points[0].case;
    assert!(near(case.motion.entrainment_speed, 0.5) && near(case.motion.slide_to_roll_ratio, 0.1));
    let notes = measured.notes.join("\n");
    for words in [
        "line 2: reversed motion, turned",
        "line 4: at rest, omitted",
        "nothing was measured in line 6",
    ] {
        assert!(notes.contains(words), "{notes}");
    }
    let spinning = CONTACT.replace("[motion]\n", "[motion]\nbody_1_spin = \"1 rad/s\"\n");
    let measured = read_case(&spinning, table.as_bytes(), &ReadParams::default()).unwrap();
    assert_eq!(measured.rows.len(), 2);
    assert!(
        measured
            .notes
            .iter()
            .any(|n| n.contains("line 2: reversed motion, omitted"))
    );
}

const MACHINES: [(&str, &str, &str); 3] = [
    (
        "kind = \"ball-on-disc\"\nball_diameter = \"19.05 mm\"\nload = \"20 N\"\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0\n",
        "speed [m/s],load [N],temperature [degC],film [nm]\n0.5,20,60,120\n1,25,60,300\n",
        "machine.entrainment_speed",
    ),
    (
        "kind = \"ball-bearing\"\nring = \"inner\"\nball_diameter = \"9.525 mm\"\npitch_diameter = \"46 mm\"\ncontact_angle = \"0 deg\"\n\
         inner_groove_curvature = 0.52\nouter_groove_curvature = 0.52\nball_load = \"300 N\"\ninner_ring_speed = \"3000 rpm\"\n",
        "machine.inner_ring_speed [rpm],load [N],film_central [nm]\n1000,300,120\n2000,310,300\n",
        "machine.inner_ring_speed",
    ),
    (
        "kind = \"roller-bearing\"\nring = \"inner\"\nroller_diameter = \"10 mm\"\npitch_diameter = \"50 mm\"\nroller_length = \"10 mm\"\n\
         roller_load = \"1 kN\"\ninner_ring_speed = \"3000 rpm\"\n",
        "machine.inner_ring_speed / rpm,load / kN,film_central / nm\n1000,1,120\n2000,1.1,300\n",
        "machine.inner_ring_speed",
    ),
];

#[test]
fn machines_are_compared() {
    for (machine, table, key) in MACHINES {
        let case = format!("[machine]\n{machine}");
        let measured = read_case(&case, table.as_bytes(), &ReadParams::default());
        let measured = measured.unwrap_or_else(|error| panic!("{machine}{error}"));
        assert_eq!(measured.study.points.len(), 2);
        assert!(
            measured
                .study
                .columns
                .iter()
                .any(|column| column.key == key),
            "{:?}",
            measured.study.columns
        );
    }
    let (bearing, ..) = MACHINES[1];
    let table = b"speed [m/s],film [nm]\n1,100\n";
    let error = read_case(
        &format!("[machine]\n{bearing}"),
        table,
        &ReadParams::default(),
    );
    let error = error.unwrap_err().to_string();
    for words in [":1:1", "follows from `machine.inner_ring_speed`"] {
        assert!(error.contains(words), "{error}");
    }
}

/// By hand: u = 1 m/s and a ratio of 0.2 are speeds of 1.1 and 0.9 m/s.
#[test]
fn speeds_of_both_surfaces_are_replaced() {
    let disc = "[machine]\nkind = \"ball-on-disc\"\nball_diameter = \"19.05 mm\"\nload = \"30 N\"\nball_speed = \"1.1 m/s\"\n\
                disc_speed = \"0.9 m/s\"\n";
    let speeds = "body_1_speed = \"0.9 m/s\"\nbody_2_speed = \"1.1 m/s\"\n";
    let motion = CONTACT.replace(
        "entrainment_speed = \"3 m/s\"\nslide_to_roll_ratio = 0.0\n",
        speeds,
    );
    for case in [disc, &motion] {
        for (table, ratios) in [
            ("u [m/s],h_c [nm]\n0.5,120\n1,300\n", [0.2, 0.2]),
            ("u [m/s],srr,h_c [nm]\n0.5,0,120\n1,0.5,300\n", [0.0, 0.5]),
        ] {
            let measured = read_case(case, table.as_bytes(), &ReadParams::default());
            let measured = measured.unwrap_or_else(|error| panic!("{case}{error}"));
            check(table, &measured, Measurand::FilmCentral, [120e-9, 300e-9]);
            for (point, ratio) in measured.study.points.iter().zip(ratios) {
                assert!(
                    (point.case.motion.slide_to_roll_ratio - ratio).abs() < 1e-9,
                    "{table}"
                );
            }
        }
        let table = b"srr [%],traction\n0,0\n10,0.05\n";
        let measured = read_case(case, table, &ReadParams::default()).unwrap();
        let motion = measured.study.points[1].case.motion;
        assert!(near(motion.entrainment_speed, 1.0) && near(motion.slide_to_roll_ratio, 0.1));
    }
}
