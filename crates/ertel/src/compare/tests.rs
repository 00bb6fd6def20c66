use super::*;
use crate::contains::contains;
use crate::solution::Estimate;

const CASE: &str = r#"
title = "Ball on disc"
lubricant = "squalane-pip"
temperature = "40 degC"
[contact]
kind = "circular"
radius = "9.525 mm"
load = "20 N"
[bodies]
body_1 = "glass"
body_2 = "steel"
[motion]
entrainment_speed = "1 m/s"
slide_to_roll_ratio = 0.0
"#;

fn read_with(text: &str, params: &ReadParams) -> Result<Measured, MeasuredError> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    Measured::read(
        &write("case.toml", CASE),
        &write("measured.csv", text),
        params,
    )
}

fn read(text: &str) -> Result<Measured, MeasuredError> {
    read_with(text, &ReadParams::default())
}

fn refused(text: &str, words: &[&str]) {
    let message = read(text).expect_err(text).to_string();
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in\n{message}");
    }
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} {b}");
}

#[test]
fn columns_set_the_case_and_name_the_measured_figures() {
    let measured = read(
        "# a rig\nspeed [mm/s];load_N;temperature (degC);SRR [%];contact.radius_mm;central film [nm];film_central_uncertainty [%];comment\n\
         100;20;40;50;10;70,5;2;first\n\n300;21;41;-50;10;150;;second\n",
    );
    let measured = measured.unwrap();
    let [first, second] = &measured.rows[..] else {
        panic!()
    };
    assert_eq!((first.line, second.line), (3, 5));
    let film = first.figures[0].unwrap();
    close(film.value, 70.5e-9);
    close(film.uncertainty.unwrap(), 0.02 * 70.5e-9);
    assert_eq!(second.figures[0].unwrap().uncertainty, None);
    assert!(first.figures[1..].iter().all(Option::is_none));
    let case = &measured.study.points[1].case;
    close(case.motion.entrainment_speed, 0.3);
    close(case.motion.slide_to_roll_ratio, -0.5);
    close(case.contact.load, 21.0);
    close(case.contact.radius, 0.01);
    close(case.lubricant.temperature, 314.15);
    let headers: Vec<&str> = measured
        .study
        .columns
        .iter()
        .map(|c| c.header.as_str())
        .collect();
    assert_eq!(
        headers,
        [
            "motion.entrainment_speed_m_per_s",
            "motion.slide_to_roll_ratio",
            "contact.load_N",
            "temperature_K",
            "contact.radius_m"
        ]
    );
}

#[test]
fn repeated_readings_are_one_point() {
    let measured = read("speed [m/s],film_minimum [nm]\n1,100\n2,200\n1,110\n1.0,120\n").unwrap();
    let points: Vec<usize> = measured.rows.iter().map(|row| row.point).collect();
    assert_eq!(points, [0, 1, 0, 0]);
    assert_eq!(measured.study.points.len(), 2);
    assert!(measured.has(Measurand::FilmMinimum) && !measured.has(Measurand::FilmCentral));
}

#[test]
fn a_bad_table_is_refused_with_its_place() {
    for (text, words) in [
        ("", &["measured.csv:1:1", "empty", "film_central"][..]),
        (
            "speed [m/s],film_central\n1,100\n",
            &[":1:2", "has no unit", "nm"],
        ),
        (
            "speed,film_central [nm]\n1,100\n",
            &[":1:1", "has no unit", "m/s"],
        ),
        ("speed [m/s],film_central [N]\n1,100\n", &[":1:2", "length"]),
        (
            "speed [m/s],film_central [furlong]\n1,100\n",
            &[":1:2", "furlong"],
        ),
        (
            "speed [m/s],flim [nm]\n1,100\n",
            &[":1:2", "unknown column", "film_central", "--ignore"],
        ),
        ("speed [m/s],\n1,100\n", &[":2:2", "no title"]),
        (
            "speed [m/s],load [N]\n1,100\n",
            &[":1:1", "no column is a measured figure"],
        ),
        ("film_central [nm]\n100\n", &[":1:1", "what was varied"]),
        (
            "speed [m/s],film_central [nm]\n",
            &[":1:1", "no measurements"],
        ),
        (
            "speed [m/s],film_central [nm]\n1,\n",
            &[":2:2", "nothing was measured"],
        ),
        (
            "speed [m/s],film_central [nm]\n1,much\n",
            &[":2:2", "not a number"],
        ),
        (
            "speed [m/s],film_central [nm]\n1,nan\n",
            &[":2:2", "nothing was measured"],
        ),
        (
            "speed [m/s],film_central [nm]\n1,-5\n",
            &[":2:2", "impossible"],
        ),
        (
            "speed [m/s],film_central [nm]\n1,0\n",
            &[":2:2", "impossible"],
        ),
        ("speed [m/s],film_central [m]\n1,5\n", &[":2:2", "10 mm"]),
        ("speed [m/s],film_central [nm]\n,5\n", &[":2:1", "empty"]),
        (
            "speed [m/s],film_central [nm]\n-,5\n",
            &[":2:1", "not a number"],
        ),
        ("speed [m/s],traction [1]\n1,20\n", &[":2:2", "traction"]),
        (
            "speed [m/s],rolling_speed [m/s],film_central [nm]\n1,1,5\n",
            &[":1:2", "second column"],
        ),
        (
            "speed [m/s],speed [mm/s],film_central [nm]\n1,1,5\n",
            &[":1:2", "second column"],
        ),
        (
            "load [N],contact.load [N],film_central [nm]\n1,1,5\n",
            &[":1:2", "second column"],
        ),
        (
            "speed [m/s],film_central_uncertainty [nm]\n1,5\n",
            &[":1:2", "no column of its values"],
        ),
        (
            "speed [m/s],film_central [nm],film_central_uncertainty\n1,5,1\n",
            &[":1:3", "no unit", "%"],
        ),
        (
            "speed [m/s],film_central [nm],film_central_uncertainty [nm]\n1,5,-1\n",
            &[":2:3", "negative"],
        ),
        (
            "speed [m/s],traction_coefficient,film_central [nm],film_central_uncertainty [nm]\n1,0.05,,1\n",
            &[":2:4", "without its value"],
        ),
        // Errors of the case about a value point to its cell.
        (
            "speed [m/s],film_central [nm]\n1,5\n2000,5\n",
            &["measured.csv:3:1", "entrainment_speed", "point 2"],
        ),
        ("load [m],film_central [nm]\n1,5\n", &[":1:1", "force"]),
        (
            "contact.size [mm],film_central [nm]\n1,5\n",
            &["contact.size", "unknown"],
        ),
        (
            "output.vtu,film_central [nm]\ntrue,5\n",
            &["output.vtu", "cannot be an axis"],
        ),
    ] {
        refused(text, words);
    }
    let ignored = |name: &str| ReadParams {
        table: ertel_input::csv::CsvParams {
            ignored: vec![name.to_owned()],
            ..Default::default()
        },
        ..ReadParams::default()
    };
    let text = "speed [m/s],film_central [nm],humidity\n1,5,wet\n";
    assert!(read_with(text, &ignored("humidity")).is_ok());
    let message = read_with(text, &ignored("rain")).unwrap_err().to_string();
    contains(&message, "no column `rain`");
    contains(&message, "humidity");
}

/// The layout of an EHD2 export with a few of the readings of `demo_2.txt` and `demo_12.txt` of github.com/moritzploss/tribology.
const EHD: &str = "\u{feff}EHD261 Test Data File\r\nDisc track radius:\t37.000\r\nLubricant name:\t\r\n\r\n\
Step 1 \"New spacer zero step\" started at 09/03/2017 17:23\r\nStep type\tFILM_ZERO\tStep description\tNew spacer zero step\r\n\
       Ball load = 19.9 N\r\nSpacer thickness = 605.8 nm\r\n\r\n\
Step 2 \"New film step\" started at 09/03/2017 17:28\r\nStep type\tFILM\tStep description\tNew film step\r\n\
Rolling Speed (mm/s)\tAverage Film (nm)\t\tStep Time (s)\tLube Temp (°C)\tPot Temp (°C)\tBall Load (N)\t\tBall Speed 1\tDisc Speed 1\t\
Rolling Speed (mm/s)\tSliding Speed (mm/s)\tSRR (%)\tTraction Force (N)\tTraction Coeff (-)\tAverage Film (nm)\tStandard Deviation (nm)\t\
Image file name\t\r\n\
19.9\t4.1\t\t23\t100.6\t92.0\t19.931\t\t19.95\t19.95\t19.95\t0.00\t0.000\t0.0114\t\t4.1\t0.53\t\t\r\n\
857.7\t41.1\t\t37\t40.5\t41.2\t20.127\t\t857.72\t857.62\t857.67\t-0.10\t-0.012\t\t\t41.1\t0.00\t\t\r\n\
10.0\t-0.4\t\t40\t40.5\t41.2\t20.127\t\t10.0\t10.0\t10.00\t0.00\t0.000\t\t\t-0.4\t0.10\t\t\r\n\r\n\
Step 3 \"Zero check\" started at 09/03/2017 17:33\r\nStep type\tZERO_CHECK\tStep description\tZero check\r\n            Film thickness = 1.5 nm\r\n\r\n\
All steps completed, test completed normally at 09/03/2017 17:34";

#[test]
fn films_of_an_ehd2_export_are_read() {
    let measured = read(EHD).unwrap();
    let [first, second] = &measured.rows[..] else {
        panic!("{:?}", measured.rows)
    };
    assert_eq!((first.line, second.line), (13, 14));
    // A deviation of zero is that of a single reading.
    close(first.figures[0].unwrap().value, 4.1e-9);
    close(first.figures[0].unwrap().uncertainty.unwrap(), 0.53e-9);
    assert_eq!(second.figures[0].unwrap().uncertainty, None);
    let case = &measured.study.points[1].case;
    close(case.motion.entrainment_speed, 0.85767);
    // The ball is faster by 0.10 mm/s: body 2 is.
    close(case.motion.slide_to_roll_ratio, 0.00012);
    close(case.contact.load, 20.127);
    close(case.lubricant.temperature, 40.5 + 273.15);
    let notes = measured.notes.join("\n");
    for words in [
        "step 2",
        "other sign",
        "not above zero are omitted (line 15)",
    ] {
        assert!(notes.contains(words), "{notes}");
    }
    let pot = ReadParams {
        probe: Probe::Pot,
        ..ReadParams::default()
    };
    close(
        read_with(EHD, &pot).unwrap().study.points[1]
            .case
            .lubricant
            .temperature,
        41.2 + 273.15,
    );
}

/// An ETM file: a step that only takes time, and a traction step, in the layout of `ETM_slim_mapper.txt` there.
const ETM: &str = "Step 1 started at 06/05/2019 19:48:30\n\
Step type\tBodTimed\tStep description\t40degree\tStep duration\t00:01:00\n\
Step Time (s)\tTraction Coeff (-)\t\tLube RTD Temp (degC)\tPot RTD Temp (degC)\tBall Load (N)\tRolling Speed (mm/s)\tSRR (%)\n\
1\t0.0028\t\t40.1\t40.1\t97.775\t50.13\t-0.251\n\n\
Step 2 started at 06/05/2019 20:00:00\n\
Step type\tTraction\tStep description\ttraction\n\
SRR (%)\tTraction Coeff (-)\t\tLube RTD Temp (degC)\tPot RTD Temp (degC)\tBall Load (N)\tRolling Speed (mm/s)\tSRR (%)\n\
10\t0.031\t\t40.2\t40.1\t98.1\t999.8\t10.02\n\
20\t0.042\t\t40.3\t40.1\t98.2\t1000.1\t20.01\n";

#[test]
fn tractions_of_an_etm_export_are_read() {
    let measured = read(ETM).unwrap();
    assert_eq!(measured.rows.len(), 2);
    assert!(
        measured
            .notes
            .iter()
            .any(|n| n.contains("step 1 (BodTimed) is omitted"))
    );
    close(measured.rows[0].figures[2].unwrap().value, 0.031);
    close(
        measured.study.points[0].case.motion.slide_to_roll_ratio,
        -0.1002,
    );
    let step = |n| ReadParams {
        steps: vec![n],
        ..ReadParams::default()
    };
    assert_eq!(read_with(ETM, &step(1)).unwrap().rows.len(), 1);
    let message = read_with(ETM, &step(7)).unwrap_err().to_string();
    contains(&message, "no step 7");
    contains(&message, "1 (BodTimed), 2 (Traction)");
}

#[test]
fn a_bad_export_is_refused_with_its_place() {
    let replaced = |from: &str, to: &str| {
        assert!(EHD.contains(from));
        EHD.replace(from, to)
    };
    refused(
        &replaced("\t20.127\t\t857", "\tmuch\t\t857"),
        &[":14:7", "not a number"],
    );
    refused(
        &replaced("\t20.127\t\t857", "\t\t\t857"),
        &[":14:7", "empty"],
    );
    refused(
        &replaced("Ball Load (N)", "Load"),
        &["no measurement was found", "Ball Load (N)"],
    );
    refused(
        &replaced("\t857.67\t", "\t-857.67e9\t"),
        &[":14:48", "entrainment_speed"],
    );
    let turned = read(&replaced("\t857.67\t", "\t-857.67\t")).unwrap();
    close(
        turned.study.points[1].case.motion.entrainment_speed,
        0.85767,
    );
    let notes = turned.notes.join("\n");
    contains(&notes, "step 2: line 14: reversed motion, turned");
    refused("EHD261 Test Data File\n", &["no measurement was found"]);
}

fn compared(measured: f64, u: Option<f64>, computed: Option<(f64, f64)>) -> Option<Compared> {
    Some(Compared {
        measured: Measurement {
            value: measured,
            uncertainty: u,
        },
        computed: computed.map(|(value, error)| Estimate {
            value,
            error: Some(error),
        }),
    })
}

/// By hand: d = 0.1, -0.05, 0, and 3 + 4 make 5.
#[test]
fn statistics_are_those_of_the_relative_differences() {
    let rows = [
        compared(100.0, Some(8.0), Some((110.0, 6.0))),
        compared(200.0, Some(3.0), Some((190.0, 4.0))),
        compared(400.0, None, Some((400.0, 1.0))),
        compared(500.0, Some(1.0), None),
        compared(0.0, Some(0.5), Some((0.1, 0.0))),
        None,
    ];
    let s = Statistics::of(&rows);
    assert_eq!(
        (s.n_measured, s.n_compared, s.n_with_uncertainty),
        (5, 3, 4)
    );
    close(s.bias.unwrap(), 0.05 / 3.0);
    close(s.rms.unwrap(), (0.0125f64 / 3.0).sqrt());
    close(s.worst.unwrap(), 0.1);
    assert_eq!(s.worst_row, Some(0));
    // 10 of √(8² + 6²) is within, 10 of 5 is not.
    assert_eq!((s.n_within, s.n_judged), (3, 4));
    close(rows[1].unwrap().uncertainty().unwrap(), 5.0);
    // Rigs give tractions without a sign.
    close(
        compared(0.05, None, Some((-0.06, 0.0)))
            .unwrap()
            .difference()
            .unwrap(),
        0.2,
    );
    assert_eq!(Statistics::of(&[None]).bias, None);
}
