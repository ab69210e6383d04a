//! Camera paths that are refused: wrong tables, and places where the observer cannot exist.

use crate::random::Random;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::load_camera_path;

fn fault(text: &str) -> String {
    load_camera_path("cam.csv", text, 30.0)
        .unwrap_err()
        .to_string()
}

#[test]
fn a_wrong_table_is_refused_with_its_line_what_stands_there_and_what_is_allowed() {
    let rows = "a camera path is a line of column names and from 2 to 130000 rows below it, and this one has";
    let polar = |row: &str| format!("# path\nframe,r,theta_deg,phi_deg\n3,20,80,0\n{row}\n");
    let fields = "and the first line names 4 columns; commas stand between fields, and numbers have decimal points";
    let place =
        "x,y,z = 0,0,0 is refused: it must be a place whose r is a number from 0.1 to 10000000 r_s";
    for (text, sentence) in [
        (String::new(), format!("{rows} 0 rows")),
        ("# nothing\n\n".into(), format!("{rows} 0 rows")),
        (polar(""), format!("{rows} 1 row")),
        ("r,theta_deg,phi_deg".into(), "line 1: the column time_s is missing: a camera path needs time_s, or the numbers of frames in frame".into()),
        ("frame,fov_deg".into(), "line 1: the column r is missing: a camera path needs r,theta_deg,phi_deg or x,y,z".into()),
        ("frame,r,theta_deg".into(), "line 1: the column phi_deg is missing: r,theta_deg,phi_deg belong together".into()),
        ("frame,x,y,z,qw,qx,qy".into(), "line 1: the column qz is missing: qw,qx,qy,qz belong together".into()),
        ("frame,x,y,z,yaw_deg".into(), "line 1: the column pitch_deg is missing: yaw_deg,pitch_deg,roll_deg belong together".into()),
        ("frame,x,y,z,x".into(), "line 1: the column x is there twice".into()),
        (polar("4,20,80"), format!("line 4: the row has 3 fields, {fields}")),
        (polar("4,20,5,80,0"), format!("line 4: the row has 5 fields, {fields}")),
        (polar("4;20;80;0"), format!("line 4: the row has 1 field, {fields}")),
        (polar("3,20,80,0"), "line 4: frame = 3 is refused: it must be above the number of the row before".into()),
        (polar("4.5,20,80,0"), "line 4: frame = 4.5 is refused: it must be a whole number of a frame, from 0 to 999999999".into()),
        (polar("-1,20,80,0"), "line 4: frame = -1 is refused: it must be a whole number of a frame, from 0 to 999999999".into()),
        (polar("999999999,20,80,0"), "line 4: frame = 999999999 is refused: it must be within 86400 seconds after the beginning, at 30 frames a second".into()),
        (polar("4,far,80,0"), "line 4: r = \"far\" is refused: it must be a number from 0.1 to 10000000 r_s".into()),
        (polar("4,0,80,0"), "line 4: r = 0 is refused: it must be a number from 0.1 to 10000000 r_s".into()),
        (polar("4,20,200,0"), "line 4: theta_deg = 200 is refused: it must be a number from 0 to 180 degrees".into()),
        (polar("4,20,80,NaN"), "line 4: phi_deg = NaN is refused: it must be a finite number".into()),
        (polar("4,20,80,"), "line 4: phi_deg = \"\" is refused: it must be a finite number".into()),
        ("time_s,x,y,z\n-1,1,0,0".into(), "line 2: time_s = -1 is refused: it must be a number of seconds from 0 to 86400".into()),
        ("time_s,x,y,z\n1,1,0,0\n1.0,1,0,0".into(), "line 3: time_s = 1.0 is refused: it must be above the time of the row before".into()),
        ("time_s,x,y,z\n1,0,0,0".into(), format!("line 2: {place}")),
        (
            "frame,x,y,z,qw,qx,qy,qz\n0,9,0,0,1,1,0,0".into(),
            "line 2: qw,qx,qy,qz = 1,1,0,0 is refused: it must be a quaternion of length 1".into(),
        ),
        (
            "frame,x,y,z,observer\n0,9,0,0,ship".into(),
            "line 2: observer = \"ship\" is refused: it must be one of static, zamo, orbit, rain".into(),
        ),
        (
            "frame,x,y,z,vx,vy,vz\n0,9,0,0,0.9,0.9,0".into(),
            "line 2: vx,vy,vz = 0.9,0.9,0 is refused: it must be three numbers, [outward, toward growing theta, toward \
             growing phi], of length below 1 c"
                .into(),
        ),
        (
            "frame,x,y,z,vx,vy,vz\n0,9,0,0,0.9,0,0\n1,9,0,0,0,0.9,0".into(),
            "line 3: vx,vy,vz = 0,0.9,0 is refused: it must be nearer to that of the row before: on the way there it \
             would reach 1 c"
                .into(),
        ),
        (
            "frame,x,y,z,exposure_ev\n0,9,0,0,30".into(),
            "line 2: exposure_ev = 30 is refused: it must be a number from -20 to 20 powers of two".into(),
        ),
    ] {
        assert_eq!(fault(&text), format!("cam.csv: {sentence}"), "{text}");
    }
    let unknown = fault("frame,x,y,z,theta");
    let start = "cam.csv: line 1: \"theta\" is no column of a camera path; did you mean theta_deg?; its first line \
                 names columns of frame,time_s,r,";
    assert!(unknown.starts_with(start), "{unknown}");
}

/// An hour and a half at 24 frames a second, as many as one run draws.
#[test]
fn a_path_has_at_most_as_many_rows_as_a_run_has_frames() {
    let rows: String = (0..130_000)
        .map(|frame| format!("{frame},20,80,{}\n", 0.01 * f64::from(frame)))
        .collect();
    let text = format!("frame,r,theta_deg,phi_deg\n{rows}");
    let path = load_camera_path("cam.csv", &text, 24.0).unwrap();
    assert_eq!(path.duration, 129_999.0 / 24.0);
    let sentence =
        load_camera_path("cam.csv", &format!("{text}130000,20,80,0\n"), 24.0).unwrap_err();
    assert_eq!(
        sentence.to_string(),
        "cam.csv: line 130002: a camera path is a line of column names and from 2 to 130000 rows below it, and this \
         one has 130001 rows"
    );
}

#[test]
fn a_place_where_the_observer_cannot_exist_is_told_by_its_line() {
    let check = |text: &str| {
        let path = load_camera_path("cam.csv", text, 30.0).unwrap();
        path.check(&Scene::default(), 0.0, Drawable::new)
            .unwrap_err()
            .place
    };
    let rows = |last: &str| {
        format!("time_s,r,theta_deg,phi_deg,observer\n1,20,80,0,static\n\n2,{last},80,0,static\n")
    };
    assert_eq!(check(&rows("0.5")), "line 4 (time_s = 2)");
    // Hovering holds until the second row, which is inside the horizon: r falls below 1 after 26/32 of the way.
    let falls = "time_s,r,theta_deg,phi_deg,observer\n1,20,80,0,static\n2,0.5,80,0,rain\n";
    assert_eq!(check(falls), "between lines 2 and 3 (time_s = 1.8125)");
}

/// Every text is a path or a sentence, never a panic.
#[test]
fn a_randomly_garbled_table_is_a_path_or_is_refused_in_one_sentence() {
    let text = "frame,time_s,x,y,z,qw,qx,qy,qz,observer,vx,vy,vz,disk_time,exposure_ev\n\
                0,0,9,0,1,1,0,0,0,rain,0,0,0,1,2\n1,1,8,0,1,1,0,0,0,static,0,0.1,0,2,3\n";
    load_camera_path("cam.csv", text, 30.0).unwrap();
    let mut random = Random::new();
    let mut below = |count: usize| random.integer(0, count as u32 - 1) as usize;
    let replacements = [
        "", ",", "\n", "#", "\"", "-", "e", "9", "ä", "\u{feff}", " ", "1e999", "nan",
    ];
    for _ in 0..5000 {
        let mut garbled: Vec<char> = text.chars().collect();
        for _ in 0..3 {
            let at = below(garbled.len());
            let new = replacements[below(replacements.len())];
            garbled.splice(at..=at, new.chars());
        }
        let garbled: String = garbled.into_iter().collect();
        if let Err(error) = load_camera_path("cam.csv", &garbled, 30.0) {
            let sentence = error.to_string();
            assert!(
                sentence.starts_with("cam.csv: ") && !sentence.contains('\n'),
                "{sentence}"
            );
        }
    }
}
