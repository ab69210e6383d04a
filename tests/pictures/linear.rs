//! Pictures of linear light, as the files that the program writes, read back.

use super::{pixel, plain, preset};
use exr::prelude::{AttributeValue, FlatSamples, f16, read_first_flat_layer_from_file};
use glam::{DVec2, DVec3, UVec2};
use lightfall_core::accuracy::{Ray, Truth};
use lightfall_core::optics::trace::{Hit, Outcome, Trace};
use lightfall_core::scene::{DiskModel, DiskStructure, Scene, ToneCurve};
use lightfall_picture::{CHANNELS, Channel, render};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// An EXR file: size, channels and the texts of its header.
pub struct Linear {
    size: UVec2,
    channels: BTreeMap<String, FlatSamples>,
    pub texts: BTreeMap<String, String>,
}

impl Linear {
    pub fn read(file: &Path) -> Self {
        let image = read_first_flat_layer_from_file(file).unwrap();
        let layer = image.layer_data;
        let text = |value: &AttributeValue| match value {
            AttributeValue::Text(text) => {
                Some(String::from_utf8(text.as_slice().to_vec()).unwrap())
            }
            _ => None,
        };
        Self {
            size: UVec2::new(layer.size.0 as u32, layer.size.1 as u32),
            channels: layer
                .channel_data
                .list
                .into_iter()
                .map(|c| (c.name.to_string(), c.sample_data))
                .collect(),
            texts: layer
                .attributes
                .other
                .iter()
                .filter_map(|(k, v)| Some((k.to_string(), text(v)?)))
                .collect(),
        }
    }

    /// Whether there is a channel of this name.
    pub fn has(&self, name: &str) -> bool {
        self.channels.contains_key(name)
    }

    /// A channel as numbers.
    pub fn values(&self, name: &str) -> Vec<f64> {
        self.channels[name].values_as_f32().map(f64::from).collect()
    }

    /// The preset of the header, joined from its pieces.
    pub fn preset(&self) -> String {
        let is_piece = |(name, _): &(&String, &String)| name.starts_with("lightfall.preset.");
        self.texts
            .iter()
            .filter(is_piece)
            .map(|(_, text)| text.as_str())
            .collect()
    }

    pub fn light(&self) -> [Vec<f64>; 3] {
        ["R", "G", "B"].map(|name| self.values(name))
    }
}

/// Runs the program itself.
pub fn run(folder: &Path, line: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lightfall"));
    command.current_dir(folder).args(line.split_whitespace());
    let output = command.output().unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    output
}

/// Renders a scene by the program itself.
pub fn program(folder: &Path, scene: &Scene, options: &str) {
    fs::write(folder.join("scene.toml"), scene.to_preset()).unwrap();
    run(folder, &format!("render --preset scene.toml {options}"));
}

pub fn linear(scene: &Scene, options: &str) -> Linear {
    let folder = tempfile::tempdir().unwrap();
    program(folder.path(), scene, &format!("-o a.exr {options}"));
    Linear::read(&folder.path().join("a.exr"))
}

/// Linear light of a pixel's half floats, as the chain keeps them.
pub fn rgb([r, g, b, _]: [u16; 4]) -> DVec3 {
    DVec3::from([r, g, b].map(|bits| f16::from_bits(bits).to_f64()))
}

/// The code of linear light in sRGB (IEC 61966-2-1).
pub fn srgb(light: f64) -> f64 {
    if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    }
}

/// A small picture of a preset.
pub fn small(number: usize) -> Scene {
    let mut scene = preset(number);
    (scene.picture.width, scene.picture.height) = (320, 180);
    (scene.picture.grid_width, scene.picture.grid_height) = (160, 90);
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn linear_light_through_exposure_and_tone_curve_is_the_plain_picture() {
    // With the probe in front, whose pixels have four samples.
    let (mut scene, size) = plain(small(6));
    scene.picture.exposure_ev = -4.0;
    scene.picture.tone_curve = ToneCurve::Neutral;
    let still = render(&scene, size).unwrap();
    let linear = linear(&scene, "");
    assert_eq!(linear.size, size);
    let light = linear.light();
    let mut compared = 0;
    for (i, (x, y)) in (0..size.y)
        .flat_map(|y| (0..size.x).map(move |x| (x, y)))
        .enumerate()
    {
        let exposed = [0, 1, 2].map(|c| light[c][i] / 16.0);
        // Khronos PBR Neutral (Khronos 2024): below its shoulder at 0.76 nothing but an offset is
        // taken away.
        let least = exposed.into_iter().fold(f64::INFINITY, f64::min);
        let offset = if least < 0.08 {
            least - 6.25 * least * least
        } else {
            0.04
        };
        let mapped = exposed.map(|channel| channel - offset);
        if mapped.into_iter().any(|channel| channel > 0.75) {
            continue;
        }
        for (channel, shown) in mapped.into_iter().zip(pixel(&still, x, y)) {
            // Eight bits are rounded up or down, by noise; before that half floats are off by a
            // two-thousandth, a tenth of a level.
            let expected = 255.0 * srgb(channel);
            assert!(
                (expected - f64::from(shown)).abs() < 1.1,
                "{expected} and {shown} at {x}, {y}"
            );
            compared += u32::from(shown > 0);
        }
    }
    assert!(
        compared > 20_000,
        "only {compared} values that are not black"
    );
    assert!(linear.values("A").iter().all(|alpha| *alpha == 1.0));
}

#[test]
#[ignore = "needs a graphics adapter"]
fn neither_bloom_nor_exposure_nor_cells_touch_linear_light() {
    let mut scene = small(6);
    // Which edges are worth refining depends on the exposure.
    scene.picture.antialias = false;
    let first = linear(&scene, "");
    scene.picture.bloom = 0.9;
    scene.picture.exposure_ev = 3.0;
    scene.picture.levels = 4;
    scene.picture.bypass = true;
    assert!(linear(&scene, "").light() == first.light());
    scene.camera.phi_deg += 1.0;
    assert!(
        linear(&scene, "").light() != first.light(),
        "nothing changes it, so this tests nothing"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn channels_have_the_names_and_kinds_that_others_rely_on() {
    let kind = |samples: &FlatSamples| match samples {
        FlatSamples::F16(_) => "half",
        FlatSamples::F32(_) => "float",
        FlatSamples::U32(_) => "uint",
    };
    let listed = |options: &str| {
        let linear = linear(&small(2), &format!("--size 32x18 {options}"));
        let kinds: Vec<_> = linear
            .channels
            .iter()
            .map(|(name, samples)| format!("{name} {}", kind(samples)))
            .collect();
        kinds.join(", ")
    };
    assert_eq!(listed(""), "A half, B half, G half, R half");
    assert_eq!(
        listed("--aov all"),
        "A half, B half, G half, R half, depth.Z float, hit1_azimuth.Y float, hit1_delay.Y float, hit1_radius.Y float, \
         hit1_shift.Y float, hit1_temperature.Y float, hit2_azimuth.Y float, hit2_delay.Y float, hit2_radius.Y float, \
         hit2_shift.Y float, hit2_temperature.Y float, outcome.Y float, residual.Y float, sky_direction.X float, \
         sky_direction.Y float, sky_direction.Z float, steps.Y float"
    );
    // `all` leaves out what a scene without matter with depth has no numbers for; a name does not.
    assert_eq!(
        listed("--aov all,medium.tau"),
        listed("--aov medium_depth.Y,all")
    );
    assert!(listed("--aov all,medium.tau").contains("medium_depth.Y float, outcome.Y float"));
    let of_matter = listed("--set disk.thickness=0.06 --aov all")
        .matches("medium_")
        .count();
    assert_eq!(of_matter, 8);
    for both in [
        "outcome,hit2,sky.z,hit2.g",
        "outcome.Y,hit2,sky_direction.Z",
    ] {
        assert_eq!(
            listed(&format!("--aov {both}")),
            "A half, B half, G half, R half, hit2_azimuth.Y float, hit2_delay.Y float, hit2_radius.Y float, hit2_shift.Y float, \
             hit2_temperature.Y float, outcome.Y float, sky_direction.Z float"
        );
    }
    assert_eq!(
        listed("--aov all --aov-names 0.1"),
        "A half, B half, G half, R half, depth float, hit1.T float, hit1.g float, hit1.phi float, hit1.r float, \
         hit1.t float, hit2.T float, hit2.g float, hit2.phi float, hit2.r float, hit2.t float, outcome uint, residual float, sky.x float, \
         sky.y float, sky.z float, steps uint"
    );
}

/// What the channels say of every ray, as the traces they were.
fn traces(linear: &Linear) -> Vec<Trace> {
    let in_file = |channel: &&Channel| linear.channels.contains_key(channel.name);
    let channels: BTreeMap<&str, Vec<f64>> = CHANNELS
        .iter()
        .filter(in_file)
        .map(|channel| (channel.old_name, linear.values(channel.name)))
        .collect();
    let of = |name: &str, i: usize| Some(channels[name][i]).filter(|value| !value.is_nan());
    let hit = |which: usize, i: usize| {
        let [r, phi, g] = ["r", "phi", "g"].map(|part| of(&format!("hit{which}.{part}"), i));
        Some(Hit {
            r: r?,
            phi: phi.unwrap(),
            g: g.unwrap(),
            delay: of(&format!("hit{which}.t"), i),
        })
    };
    let trace = |i: usize| Trace {
        outcome: match channels["outcome"][i] {
            0.0 => Outcome::Sky,
            1.0 => Outcome::Captured,
            2.0 => Outcome::Unfinished,
            other => panic!("outcome {other}"),
        },
        sky: of("sky.x", i).map(|x| DVec3::new(x, channels["sky.y"][i], channels["sky.z"][i])),
        hits: [hit(1, i), hit(2, i)],
        steps: channels["steps"][i] as u32,
        residual: channels["residual"][i],
    };
    (0..(linear.size.x * linear.size.y) as usize)
        .map(trace)
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn channels_say_of_each_pixel_what_the_reference_says_of_its_ray() {
    // Errors as docs/ACCURACY.md states them, for 99 of 100 rays and at the spinning hole's default
    // setting.
    for (number, spin, bound) in [(2, 0.0, 3e-7), (3, 0.9, 6e-6)] {
        let mut scene = small(number);
        scene.hole.spin = spin;
        let linear = linear(&scene, "--aov all --size 97x53");
        (scene.picture.width, scene.picture.height) = (97, 53);
        let size = DVec2::new(97.0, 53.0);
        let middles = (0..53)
            .flat_map(|y| (0..97).map(move |x| DVec2::new(f64::from(x), f64::from(y)) + 0.5));
        let truth = Truth::of(
            &scene,
            middles
                .map(|at| Ray::toward(scene.camera.looking(at, size)))
                .collect(),
        )
        .unwrap();
        let given = traces(&linear);
        let mut turns: Vec<f64> = truth
            .judge(&given)
            .iter()
            .map(|error| error.backward)
            .collect();
        turns.sort_by(f64::total_cmp);
        let at_99 = turns[turns.len() * 99 / 100];
        assert!(
            at_99 < bound,
            "spin {spin}: 99 of 100 rays within {at_99} rad"
        );
        // The judge looks at radius and g, not at the azimuth, which is as exact: a turn moves it
        // by some times as much.
        let azimuths = truth
            .traces
            .iter()
            .zip(&given)
            .flat_map(|(truth, given)| truth.hits.iter().zip(&given.hits));
        let azimuths: Vec<f64> = azimuths
            .filter_map(|(truth, given)| Some((truth.as_ref()?.phi - given.as_ref()?.phi).abs()))
            .map(|turn| turn.min(std::f64::consts::TAU - turn))
            .collect();
        let wrong = azimuths
            .iter()
            .filter(|turn| **turn > 100.0 * bound)
            .count();
        assert!(
            azimuths.len() > 300 && wrong * 50 < azimuths.len(),
            "{wrong} of {} azimuths",
            azimuths.len()
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn temperatures_are_those_of_the_matter_where_light_leaves_it() {
    let mut scene = small(2);
    scene.disk.model = DiskModel::Newtonian;
    (scene.disk.inner, scene.disk.temperature_k) = (4.0, 12_000.0);
    (scene.disk.follow_isco, scene.disk.keep_accretion) = (false, false);
    // Those of the disk without its structure.
    for structure in [DiskStructure::None, DiskStructure::Turbulent] {
        scene.disk.structure = structure;
        let linear = linear(&scene, "--aov hit1,hit2");
        let mut compared = 0;
        for hit in ["hit1", "hit2"] {
            for (r, kelvin) in linear
                .values(&format!("{hit}_radius.Y"))
                .iter()
                .zip(linear.values(&format!("{hit}_temperature.Y")))
            {
                assert_eq!(r.is_nan(), kelvin.is_nan());
                if !r.is_nan() {
                    // T = T_scale F^(1/4), F = x^3 (1 - sqrt x); f32's rounding of r counts for
                    // more next to the edge.
                    let x = 4.0 / r;
                    let flux = x.powi(3) * (1.0 - x.sqrt());
                    let tolerance = 12_000.0 * (1e-6 + 1e-7 / (1.0 - x).max(1e-7));
                    assert!(
                        (12_000.0 * flux.powf(0.25) - kelvin).abs() < tolerance,
                        "{structure:?}: {kelvin} K at {r}"
                    );
                    compared += 1;
                }
            }
        }
        assert!(compared > 5_000, "{compared}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn depth_is_the_probes_distance_where_it_is_and_infinite_elsewhere() {
    let mut scene = small(6);
    // Of single rays: whether a pixel beside the probe is refined depends on what the probe covers.
    scene.picture.antialias = false;
    // Straight ahead, four before the camera, and half a unit long.
    (
        scene.camera.yaw_deg,
        scene.camera.pitch_deg,
        scene.camera.roll_deg,
    ) = (0.0, 0.0, 0.0);
    scene.probe.r = scene.camera.r - 4.0;
    (scene.probe.theta_deg, scene.probe.phi_deg, scene.probe.size) =
        (scene.camera.theta_deg, scene.camera.phi_deg, 0.5);
    for antialias in [true, false] {
        scene.probe.antialias = antialias;
        let with = linear(&scene, "--aov depth");
        let without = linear(
            &Scene {
                probe: lightfall_core::scene::Probe {
                    enabled: false,
                    ..scene.probe
                },
                ..scene.clone()
            },
            "--aov depth",
        );
        assert!(
            without
                .values("depth.Z")
                .iter()
                .all(|depth| *depth == f64::INFINITY)
        );
        let depth = with.values("depth.Z");
        let middle = depth[(90 * 320 + 160) as usize];
        // The body is 0.13 of its length thick.
        assert!((middle - (4.0 - 0.065)).abs() < 0.03, "{middle}");
        let (light, behind) = (with.light(), without.light());
        let (mut craft, mut stray) = (0, 0);
        for (i, depth) in depth.iter().enumerate() {
            let same = (0..3).all(|c| light[c][i] == behind[c][i]);
            assert!(depth.is_infinite() || (3.5..4.5).contains(depth), "{depth}");
            craft += u32::from(depth.is_finite());
            stray += u32::from(depth.is_infinite() != same);
        }
        assert!(craft > 100, "{craft} pixels of the probe");
        // At its edge a pixel of several samples may show it in part although its middle does not.
        assert!(
            stray == 0 || antialias && stray < craft / 2,
            "{stray} pixels, antialias {antialias}"
        );
    }
}

/// The header's attributes in the order of the file, by name, with their lengths.
fn attributes(bytes: &[u8]) -> Vec<(String, usize)> {
    let text = |at: usize| {
        let end = at + bytes[at..].iter().position(|byte| *byte == 0).unwrap();
        (String::from_utf8(bytes[at..end].to_vec()).unwrap(), end + 1)
    };
    let mut found = Vec::new();
    let mut at = 8;
    while bytes[at] != 0 {
        let (name, kind) = text(at);
        let (_, size) = text(kind);
        let length = u32::from_le_bytes(bytes[size..size + 4].try_into().unwrap()) as usize;
        found.push((name, length));
        at = size + 4 + length;
    }
    found
}

/// ffmpeg 5.1 reads 255 bytes of a text that it does not know, and takes the rest for pixels.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_same_scene_gives_the_same_bytes_with_short_texts_in_order() {
    let mut scene = small(5);
    scene.title = "光".repeat(200);
    let bytes = [0, 1, 2].map(|_| {
        let folder = tempfile::tempdir().unwrap();
        program(folder.path(), &scene, "--aov all --size 40x30 -o a.exr");
        fs::read(folder.path().join("a.exr")).unwrap()
    });
    assert!(bytes[0] == bytes[1] && bytes[0] == bytes[2], "bytes differ");
    let frames = [0, 1].map(|_| {
        let folder = tempfile::tempdir().unwrap();
        let options = "--journey none --frames 3..4 --fps 24 --aov all --size 40x30 -o a-#.exr";
        program(folder.path(), &scene, options);
        ["a-3.exr", "a-4.exr"].map(|name| fs::read(folder.path().join(name)).unwrap())
    });
    assert!(frames[0] == frames[1], "bytes of frames differ");
    let attributes = attributes(&bytes[0]);
    assert!(attributes.is_sorted());
    let own = attributes
        .iter()
        .filter(|(name, _)| name.starts_with("lightfall."));
    assert!(own.clone().count() > 20, "{attributes:?}");
    for (name, length) in own {
        assert!(*length <= 255, "{name} has {length} bytes");
    }
}
