//! Rays in and traces out.

use std::io::{self, BufReader, Read, Write};

use glam::{DVec3, dvec3};
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::accuracy::rays::{HEADER, NUMBERS, RayReader, TraceWriter, is_closed_pipe};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::{Hit, Outcome, Trace};
use lightfall_core::scene::Scene;

fn rays(text: &str) -> Vec<DVec3> {
    RayReader::new(text.as_bytes(), "rays.csv")
        .collect::<Result<_, _>>()
        .unwrap()
}

fn fault(text: &str) -> String {
    let mut reader = RayReader::new(text.as_bytes(), "rays.csv");
    let error = reader
        .find_map(Result::err)
        .expect("an error was wanted")
        .to_string();
    assert!(reader.next().is_none(), "it reads on after an error");
    error
}

#[test]
fn numbers_follow_the_columns_of_a_trace() {
    let scene = Scene::default();
    let reference = Reference::new(&scene).unwrap();
    let mut bytes = Vec::new();
    let mut writer = TraceWriter::with_numbers(&mut bytes).unwrap();
    let mut plain = Vec::new();
    let mut short = TraceWriter::new(&mut plain).unwrap();
    // Past the hole, and into it.
    for direction in [dvec3(-0.9, -0.1, 0.4).normalize(), DVec3::NEG_X] {
        let ray = Inspected::new(&scene, direction, None, 20.0).unwrap();
        let trace = reference.trace_with_delays(direction);
        writer.write_with_numbers(&trace, &ray.numbers).unwrap();
        short.write(&trace).unwrap();
    }
    writer.finish().unwrap();
    short.finish().unwrap();
    let [text, plain] = [bytes, plain].map(|bytes| String::from_utf8(bytes).unwrap());
    for (line, short) in text.lines().zip(plain.lines()) {
        assert!(line.starts_with(&format!("{short},")), "{line}");
        assert_eq!(line.split(',').count(), HEADER.len() + NUMBERS.len());
    }
    let numbers = |line: &str| -> Vec<Option<f64>> {
        let fields = line.split(',').skip(HEADER.len());
        fields.map(|field| field.parse().ok()).collect()
    };
    let lines: Vec<_> = text.lines().skip(1).map(numbers).collect();
    let [past, into] = &lines[..] else {
        panic!("two rays")
    };
    // b = r sin(alpha)/sqrt(1 - 1/r) for an observer at rest.
    let r = scene.camera.r;
    let sine = (0.1_f64.powi(2) + 0.4_f64.powi(2)).sqrt() / 0.98_f64.sqrt();
    let b = r * sine / (1.0 - 1.0 / r).sqrt();
    assert!((past[0].unwrap() - b).abs() < 1e-9 * b, "{past:?} {b}");
    let g = 1.0 / (1.0 - 1.0 / r).sqrt();
    assert!((past[6].unwrap() - g).abs() < 1e-12, "{past:?}");
    assert!(past[3].unwrap() > 0.0 && past[5].unwrap() > 1.5);
    assert_eq!((into[3], into[6]), (None, None));
    assert_eq!(into[5], Some(1.0));
}

#[test]
fn a_header_is_skipped_where_there_is_one() {
    let bare = rays("1,0,0\n0,1,0\n");
    assert_eq!(bare, [DVec3::X, DVec3::Y]);
    for header in [
        "er,etheta,ephi",
        " er, etheta ,ephi ",
        "\"er\",\"etheta\",\"ephi\"",
        "\u{feff}er,etheta,ephi",
    ] {
        assert_eq!(rays(&format!("{header}\n1,0,0\n0,1,0")), bare, "{header}");
    }
}

#[test]
fn blank_lines_and_other_line_ends_make_no_difference() {
    assert_eq!(
        rays("\n\r\n1,0,0\r\n  \n\n0,0,-2\r\n\n"),
        [DVec3::X, DVec3::NEG_Z]
    );
}

#[test]
fn no_rays_are_no_error() {
    assert!(rays("").is_empty() && rays("\n\n").is_empty() && rays("er,etheta,ephi\n").is_empty());
}

#[test]
fn a_ray_of_any_length_becomes_a_unit_vector() {
    let expected = dvec3(1.0, -2.0, 2.0) / 3.0;
    for scale in ["", "e300", "e-300", "e307", "e-323"] {
        let ray = rays(&format!("1{scale},-2{scale},2{scale}"))[0];
        // Two roundings and a square root: a few units of the last place. 1e-323 is 2 of the least
        // subnormal and 2e-323 is 4 of them, so that even there the ratios are exact.
        assert!((ray - expected).length() < 1e-15, "{scale}: {ray}");
    }
    assert_eq!(rays("5e-324,0,0"), [DVec3::X]);
    assert_eq!(
        rays("1.7976931348623157e308,1e-320,0"),
        [dvec3(1.0, 0.0, 0.0)]
    );
    assert_eq!(rays("+1,-0.,.0"), [DVec3::X]);
}

#[test]
fn the_error_about_a_wrong_line_names_its_number() {
    let number = "it must be a finite number";
    let columns = "is refused: a ray has three values, er,etheta,ephi, and here are";
    let zero = "0,0,0 is refused: it has no direction, and a ray may have any length but zero";
    for (text, sentence) in [
        ("1,0", format!("line 1: \"1,0\" {columns} 2")),
        ("1,0,0\n\n1 0 0", format!("line 3: \"1 0 0\" {columns} 1")),
        (
            "er,etheta,ephi\n1,0,0,0",
            format!("line 2: \"1,0,0,0\" {columns} 4"),
        ),
        (
            "0;-0,1;1",
            format!(
                "line 1: \"0;-0,1;1\" {columns} 2; write commas between the values, and points in decimals"
            ),
        ),
        (
            "0\n-0.1\n1",
            format!(
                "line 1: \"0\" {columns} 1; PowerShell splits an unquoted 0,-0.1,1 into lines: put it in quotes"
            ),
        ),
        ("1,0,0,", format!("line 1: \"1,0,0,\" {columns} 4")),
        (
            "1,x,0",
            format!("line 1: etheta = \"x\" is refused: {number}"),
        ),
        ("1,0,", format!("line 1: ephi = \"\" is refused: {number}")),
        (
            "NaN,0,0",
            format!("line 1: er = \"NaN\" is refused: {number}"),
        ),
        (
            "1,0,0\r\n\r\n0,-inf,0",
            format!("line 3: etheta = \"-inf\" is refused: {number}"),
        ),
        (
            "1e999,0,0",
            format!("line 1: er = \"1e999\" is refused: {number}"),
        ),
        (
            "1,0,0\ner,etheta,ephi",
            format!("line 2: er = \"er\" is refused: {number}"),
        ),
        (
            "er,etheta,ephi\ner,etheta,ephi",
            format!("line 2: er = \"er\" is refused: {number}"),
        ),
        (
            "ephi,er,etheta\n1,0,0",
            format!("line 1: er = \"ephi\" is refused: {number}"),
        ),
        ("0,0,0", format!("line 1: {zero}")),
        ("1,0,0\n-0,0.0,1e-999", format!("line 2: {zero}")),
        (
            "1,\"0,0\n1,0,0",
            format!("line 1: etheta = \"\\\"0\" is refused: {number}"),
        ),
    ] {
        assert_eq!(fault(text), format!("rays.csv: {sentence}"), "{text:?}");
    }
}

#[test]
fn bytes_that_are_not_text_are_an_error() {
    let error = RayReader::new(&b"\xff\xfe1,0,0\n"[..], "rays.csv")
        .next()
        .unwrap()
        .unwrap_err()
        .to_string();
    assert!(error.starts_with("rays.csv: line 1: er = "), "{error}");
}

#[test]
fn an_endless_line_does_not_fill_the_memory() {
    let endless = BufReader::new(io::repeat(b'1'));
    let error = RayReader::new(endless, "rays.csv")
        .next()
        .unwrap()
        .unwrap_err()
        .to_string();
    assert_eq!(
        error,
        "rays.csv: line 1 is longer than 4096 bytes; a ray is a line er,etheta,ephi"
    );
}

#[test]
fn rays_are_read_one_by_one_before_the_file_ends() {
    // A reader that must not be asked beyond its second line.
    struct Then;
    impl Read for Then {
        fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
            Err(io::ErrorKind::UnexpectedEof.into())
        }
    }
    let mut reader = RayReader::new(BufReader::new(b"1,0,0\n0,1,0\n".chain(Then)), "rays.csv");
    assert_eq!(reader.next().unwrap().unwrap(), DVec3::X);
    assert_eq!(reader.next().unwrap().unwrap(), DVec3::Y);
    let error = reader.next().unwrap().unwrap_err().to_string();
    assert!(
        error.starts_with("rays.csv: line 3 cannot be read: "),
        "{error}"
    );
}

fn written(traces: &[Trace]) -> String {
    let mut bytes = Vec::new();
    let mut writer = TraceWriter::new(&mut bytes).unwrap();
    traces.iter().for_each(|trace| writer.write(trace).unwrap());
    writer.finish().unwrap();
    String::from_utf8(bytes).unwrap()
}

const CAPTURED: Trace = Trace {
    outcome: Outcome::Captured,
    sky: None,
    hits: [None, None],
    steps: 7,
    residual: 0.0,
};

#[test]
fn the_columns_are_those_of_the_contract() {
    let header = "outcome,sky_x,sky_y,sky_z,hit1_r,hit1_phi,hit1_g,hit2_r,hit2_phi,hit2_g,\
        steps,residual,hit1_t,hit2_t\n";
    assert_eq!(written(&[]), header);
    assert_eq!(HEADER.join(",") + "\n", header);
}

#[test]
fn missing_values_are_empty_fields() {
    let sky = Trace {
        outcome: Outcome::Sky,
        sky: Some(DVec3::NEG_Y),
        ..CAPTURED
    };
    let hit = Hit {
        r: 3.5,
        phi: -1.25,
        g: 0.75,
        delay: None,
    };
    let unfinished = Trace {
        outcome: Outcome::Unfinished,
        hits: [Some(hit), None],
        ..CAPTURED
    };
    let delayed = Trace {
        hits: [
            Some(Hit {
                delay: Some(20.5),
                ..hit
            }),
            None,
        ],
        ..unfinished
    };
    let text = written(&[CAPTURED, sky, unfinished, delayed]);
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(
        lines,
        [
            "captured,,,,,,,,,,7,0.0,,",
            "sky,0.0,-1.0,0.0,,,,,,,7,0.0,,",
            "unfinished,,,,3.5,-1.25,0.75,,,,7,0.0,,",
            "unfinished,,,,3.5,-1.25,0.75,,,,7,0.0,20.5,"
        ]
    );
}

#[test]
fn every_number_is_read_back_unchanged() {
    let sky = dvec3(1.0 / 3.0, f64::MIN_POSITIVE / 8.0, -1.0 + f64::EPSILON);
    let hits = [
        [3.0 + f64::EPSILON * 2.0, std::f64::consts::PI, 0.1 + 0.2],
        [1e300, -1e-300, 1.0],
    ];
    let delays = [100.0 / 3.0, 1e-17];
    let trace = Trace {
        sky: Some(sky),
        hits: [0, 1].map(|i| {
            let [r, phi, g] = hits[i];
            Some(Hit {
                r,
                phi,
                g,
                delay: Some(delays[i]),
            })
        }),
        residual: f64::MAX,
        steps: u32::MAX,
        ..CAPTURED
    };
    let text = written(&[trace]);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let record = reader.records().next().unwrap().unwrap();
    let numbers: Vec<f64> = record
        .iter()
        .skip(1)
        .map(|field| field.parse().unwrap())
        .collect();
    let expected = [
        &sky.to_array()[..],
        &hits[0],
        &hits[1],
        &[f64::from(u32::MAX), f64::MAX],
        &delays,
    ]
    .concat();
    assert_eq!(numbers, expected);
    assert!(
        text.len() < 400,
        "digits beyond the shortest, or zeros in place of an exponent: {text}"
    );
}

/// A pipe whose reader has gone after some bytes.
struct Closed(usize);

impl Write for Closed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0 == 0 {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let taken = bytes.len().min(self.0);
        self.0 -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_closed_pipe_differs_from_other_errors_and_from_success() {
    let mut writer = TraceWriter::new(Closed(100)).unwrap();
    let error = (0..100_000)
        .find_map(|_| writer.write(&CAPTURED).err())
        .expect("the pipe is closed");
    assert!(is_closed_pipe(&error));
    let mut writer = TraceWriter::new(Closed(10)).unwrap();
    writer.write(&CAPTURED).unwrap();
    assert!(
        is_closed_pipe(&writer.finish().unwrap_err()),
        "the last lines are flushed and their error is reported"
    );
    assert!(!is_closed_pipe(&io::ErrorKind::StorageFull.into()));
}
