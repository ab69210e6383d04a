//! Lookup tables for other programs: their files, read and interpolated as those programs do, against the
//! curves themselves.

use half::f16;
use lightfall_core::optics::lut::{HighRange, Look, Lut, LutForm};
use lightfall_core::optics::spectrum;
use lightfall_core::scene::ToneCurve;

/// The exposure of the tables under test.
const EV: f64 = 3.5;

/// Light of the colours that scenes have: mixtures of two black bodies, from 2^-12 to `most` after exposure.
fn lights(most: f64) -> Vec<[f64; 3]> {
    const COUNT: usize = 12;
    let temperature = |i: usize| 1700.0 * 15f64.powf(i as f64 / (COUNT - 1) as f64);
    let colour = |i: usize| {
        let colour = spectrum::colour(temperature(i));
        let largest = colour.into_iter().fold(0.0, f64::max);
        // Deep reds are outside the gamut.
        colour.map(|channel| (channel / largest).max(0.0))
    };
    let mut lights = Vec::new();
    for (a, b) in (0..COUNT).flat_map(|a| (a..COUNT).map(move |b| (a, b))) {
        for share in [0.25, 0.6] {
            let (a, b) = (colour(a), colour(b));
            let mixed = [0, 1, 2].map(|i| a[i] * share + b[i] * (1.0 - share));
            // Steps that share no divisor with those of a table.
            for step in 0..150 {
                let whole = 12.0 + most.log2();
                let scale = (whole * f64::from(step) / 150.37 - 12.0).exp2();
                lights.push(mixed.map(|channel| channel * scale));
            }
        }
    }
    lights
}

/// A cube of codes, of which red changes fastest.
struct Nodes {
    side: usize,
    codes: Vec<[f64; 3]>,
}

impl Nodes {
    fn at(&self, [red, green, blue]: [usize; 3]) -> [f64; 3] {
        self.codes[red + self.side * (green + self.side * blue)]
    }

    /// Tetrahedral interpolation (Kasson, Nin, Plouffe and Hafner 1995, section 3): from the lower corner
    /// of a cell along the axes in the order of their shares.
    fn interpolate(&self, place: [f64; 3]) -> [f64; 3] {
        let last = (self.side - 1) as f64;
        let scaled = place.map(|x| x.clamp(0.0, 1.0) * last);
        let mut corner = scaled.map(|x| (x as usize).min(self.side - 2));
        let shares = [0, 1, 2].map(|i| scaled[i] - corner[i] as f64);
        let mut axes = [0, 1, 2];
        axes.sort_by(|a, b| shares[*b].total_cmp(&shares[*a]));
        let mut code = self.at(corner);
        for axis in axes {
            let before = self.at(corner);
            corner[axis] += 1;
            let after = self.at(corner);
            for i in 0..3 {
                code[i] += shares[axis] * (after[i] - before[i]);
            }
        }
        code
    }
}

/// Linear interpolation in a table with rising inputs.
fn linear(inputs: &[f64], outputs: &[f64], x: f64) -> f64 {
    let after = inputs.partition_point(|input| *input < x);
    if after == 0 {
        return outputs[0];
    }
    if after == inputs.len() {
        return outputs[after - 1];
    }
    let share = (x - inputs[after - 1]) / (inputs[after] - inputs[after - 1]);
    outputs[after - 1] + share * (outputs[after] - outputs[after - 1])
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace()
        .map(|word| word.parse().unwrap())
        .collect()
}

fn triples(numbers: &[f64]) -> Vec<[f64; 3]> {
    numbers
        .chunks(3)
        .map(|rgb| [rgb[0], rgb[1], rgb[2]])
        .collect()
}

/// What reads a table of this form: from light before exposure to codes.
fn reader(lut: Lut, form: LutForm) -> Box<dyn Fn([f64; 3]) -> [f64; 3]> {
    let text = lut.text(form);
    match form {
        LutForm::Csp => {
            let body = text.strip_prefix("CSPLUTV100\n3D\n").unwrap();
            let all = numbers(body);
            let knots = all[0] as usize;
            let inputs = all[1..=knots].to_vec();
            let outputs = all[1 + knots..=2 * knots].to_vec();
            let rest = &all[3 * (1 + 2 * knots)..];
            let nodes = Nodes {
                side: rest[0] as usize,
                codes: triples(&rest[3..]),
            };
            Box::new(move |light: [f64; 3]| {
                let place = light.map(|x| linear(&inputs, &outputs, x.powf(0.25)));
                nodes.interpolate(place)
            })
        }
        LutForm::Clf => {
            let of_array = |text: &str| {
                let (_, text) = text.split_once("<Array").unwrap();
                let (_, text) = text.split_once('>').unwrap();
                let (inside, rest) = text.split_once("</Array>").unwrap();
                (numbers(inside), rest.to_owned())
            };
            let (shaper, rest) = of_array(&text);
            let (cube, _) = of_array(&rest);
            assert_eq!(shaper.len(), 1 << 16);
            let side = (cube.len() as f64 / 3.0).cbrt().round() as usize;
            // Blue changes fastest in the file.
            let in_file = triples(&cube);
            let codes = (0..side * side * side).map(|number| {
                let [red, green, blue] =
                    [number % side, number / side % side, number / (side * side)];
                in_file[blue + side * (green + side * red)]
            });
            let nodes = Nodes {
                side,
                codes: codes.collect(),
            };
            // The lights of a picture are half floats, which are places of the table.
            Box::new(move |light: [f64; 3]| {
                nodes.interpolate(light.map(|x| shaper[usize::from(half(x).to_bits())]))
            })
        }
        LutForm::Cube => {
            let is_number = |line: &&str| !line.starts_with("LUT");
            let body: Vec<&str> = text.lines().filter(is_number).collect();
            let word = |key: &str, number: usize| {
                let line = text.lines().find(|line| line.starts_with(key)).unwrap();
                line.split(' ').nth(number).unwrap().parse::<f64>().unwrap()
            };
            let steps = word("LUT_1D_SIZE", 1) as usize;
            let most = word("LUT_1D_INPUT_RANGE", 2);
            let rows = triples(&numbers(&body.join(" ")));
            let inputs: Vec<f64> = (0..steps)
                .map(|step| most * step as f64 / (steps - 1) as f64)
                .collect();
            let outputs: Vec<f64> = rows[..steps].iter().map(|row| row[0]).collect();
            let nodes = Nodes {
                side: word("LUT_3D_SIZE", 1) as usize,
                codes: rows[steps..].to_vec(),
            };
            Box::new(move |light: [f64; 3]| {
                nodes.interpolate(light.map(|x| linear(&inputs, &outputs, x)))
            })
        }
    }
}

/// The largest half float that is not above a positive number.
fn half(x: f64) -> f16 {
    let nearest = f16::from_f64(x);
    if nearest.to_f64() <= x {
        nearest
    } else {
        f16::from_bits(nearest.to_bits() - 1)
    }
}

/// The mean, the 99.9th percentile and the largest of the errors, in steps of a code of which there are
/// `steps`.
fn errors(look: Look, form: LutForm, most: f64, steps: f64) -> [f64; 3] {
    let lut = Lut {
        look,
        exposure_ev: EV,
    };
    let read = reader(lut, form);
    let mut errors = Vec::new();
    for light in lights(most) {
        let light = light.map(|x| half(x / EV.exp2()).to_f64());
        let found = read(light).map(|code| code.clamp(0.0, 1.0));
        let wanted = look.shown(light.map(|x| x as f32), EV.exp2());
        for i in 0..3 {
            errors.push((found[i] - wanted[i]).abs() * steps);
        }
    }
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    [
        mean,
        errors[errors.len() * 999 / 1000],
        errors[errors.len() - 1],
    ]
}

/// A cube of 65 places a side cannot follow the bends of the neutral and the soft curve to less than a few
/// of 255 levels. The bounds are those of an independent computation in Python, rounded up.
#[test]
fn tables_give_the_levels_of_the_tone_curves() {
    for curve in ToneCurve::ALL {
        let look = Look::Screen(curve);
        for (form, most) in [
            (LutForm::Csp, 4000.0),
            (LutForm::Clf, 4000.0),
            (LutForm::Cube, 60.0),
        ] {
            let [mean, p999, largest] = errors(look, form, most, 255.0);
            println!("{curve:?}, {form:?}: {mean:.3}, {p999:.2}, {largest:.2}");
            let bounds = match curve {
                ToneCurve::Neutral | ToneCurve::Soft => [0.15, 2.8, 5.0],
                ToneCurve::Aces | ToneCurve::Reinhard => [0.08, 0.5, 2.0],
            };
            assert!(
                mean < bounds[0] && p999 < bounds[1] && largest < bounds[2],
                "{curve:?}, {form:?}: {mean}, {p999}, {largest}"
            );
        }
    }
}

/// HDR10 has 1024 steps, of which seven are below what an eye tells apart in a picture.
#[test]
fn tables_give_the_codes_of_hdr10() {
    let look = Look::High(HighRange::default());
    for form in [LutForm::Csp, LutForm::Clf] {
        let [mean, p999, largest] = errors(look, form, 4000.0, 1023.0);
        println!("{form:?}: {mean:.3}, {p999:.2}, {largest:.2}");
        assert!(
            mean < 0.4 && p999 < 5.5 && largest < 9.0,
            "{form:?}: {mean}, {p999}, {largest}"
        );
    }
}

/// White light has the level that the curve's formula for one channel gives.
#[test]
fn a_tone_curve_of_three_channels_is_that_of_one_for_white() {
    for curve in ToneCurve::ALL {
        for step in -20..20 {
            let light = (0.5 * f64::from(step)).exp2();
            // The neutral curve takes an offset from the light first.
            let offset = match curve {
                ToneCurve::Neutral if light < 0.08 => light - 6.25 * light * light,
                ToneCurve::Neutral => 0.04,
                _ => 0.0,
            };
            let [red, green, blue] = curve.toned([light; 3]);
            let wanted = curve.level(light - offset);
            // The matrices of the soft curve and of ACES have five digits.
            for level in [red, green, blue] {
                assert!(
                    (level - wanted).abs() < 2e-4,
                    "{curve:?}, {light}: {level}, and not {wanted}"
                );
            }
        }
    }
}

/// Codes of the perceptual quantizer that Rec. ITU-R BT.2408-7, table 1, lists: 58 % for diffuse white, and
/// 75 % for 1000 cd/m^2.
#[test]
fn hdr10_has_white_at_203_nits_and_rolls_off_to_the_peak() {
    let range = HighRange::default();
    let white = |light: f64| range.codes([light; 3]);
    for code in white(1.0) {
        assert!((code - 0.58).abs() < 0.005, "{code}");
    }
    for code in white(1e6) {
        assert!((code - 0.7518).abs() < 5e-4, "{code}");
    }
    assert_eq!(white(0.0), [0.0; 3]);
    let mut before = 0.0;
    for step in 0..400 {
        let [code, ..] = white((f64::from(step) / 20.0 - 10.0).exp2());
        assert!(code >= before - 1e-12, "it falls at step {step}");
        before = code;
    }
    // The whole code needs no shoulder.
    let whole = HighRange { peak: 10_000.0 };
    let [code, ..] = whole.codes([10_000.0 / 203.0; 3]);
    assert!((code - 1.0).abs() < 1e-3, "{code}");
}
