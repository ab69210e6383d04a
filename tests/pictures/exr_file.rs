//! EXR files as they are written and read back, without a graphics adapter.

use super::layers::LAYERS;
use exr::prelude::{
    AttributeValue, Compression, FlatSamples, Text, Vec2, WritableImage, f16,
    read_first_flat_layer_from_file,
};
use glam::UVec2;
use lightfall_core::gpu::Layers;
use lightfall_core::scene::{Scene, SkyMode, presets};
use lightfall_picture::{
    CHANNELS, ChannelNames, Channels, ExrCompression, ExrForm, Linear, MissingValues, Transparent,
    write_exr,
};
use lightfall_platform::storage::{PictureRecord, embedded_preset, preset_pieces};
use lightfall_render::Captured;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const SIZE: UVec2 = UVec2::new(37, 21);

/// Numbers of every kind that a channel may hold.
fn number(at: usize) -> f32 {
    match at % 7 {
        0 => f32::NAN,
        1 => f32::INFINITY,
        2 => -0.0,
        _ => (at as f32 * 0.618).sin() * 1e3_f32.powi(at as i32 % 5 - 2),
    }
}

/// The share of the picture's shader on a pixel.
fn share(at: usize) -> f32 {
    (at % 5) as f32 / 4.0
}

/// A picture of this scene with all channels of rays.
fn write(path: &Path, scene: &Scene, form: ExrForm, commit: Option<&str>) {
    let channels: Channels = "all".parse().unwrap();
    let pixels = (SIZE.x * SIZE.y) as usize;
    let samples = (0..channels.list().len())
        .map(|channel| (0..pixels).map(|pixel| number(channel + pixel)).collect())
        .collect();
    let half = |number: f32| f16::from_f32(number).to_bits();
    let light = |at: usize| half(number(at).abs().min(6e4));
    let picture = Linear {
        scene,
        record: PictureRecord {
            preset: scene.to_preset(),
            texts: vec![("lightfall.adapter", "an adapter".repeat(40))],
            panorama: None,
        },
        light: Captured {
            size: SIZE,
            rgba: (0..pixels)
                .map(|at| [light(at), light(at + 3), light(at + 5), half(share(at))])
                .collect(),
            depth: None,
        },
        first_row: 0,
        channels: &channels,
        samples,
        form,
        commit,
        fps: Some(24.0),
    };
    write_exr(path, picture).unwrap();
}

/// The bits of every channel, by name, and the compression.
fn read(path: &Path) -> (BTreeMap<String, Vec<u32>>, Compression) {
    let layer = read_first_flat_layer_from_file(path).unwrap().layer_data;
    let bits = |samples: FlatSamples| match samples {
        FlatSamples::F16(all) => all.into_iter().map(|it| it.to_bits().into()).collect(),
        FlatSamples::F32(all) => all.into_iter().map(f32::to_bits).collect(),
        FlatSamples::U32(all) => all,
    };
    let channels = layer.channel_data.list.into_iter();
    let channels = channels.map(|it| (it.name.to_string(), bits(it.sample_data)));
    (channels.collect(), layer.encoding.compression)
}

#[test]
fn every_compression_keeps_every_bit_and_a_picture_has_the_same_bytes_each_time() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let scene = Scene::default();
    let words = ["zip", "zips", "piz", "rle", "none"];
    assert_eq!(ExrCompression::WORDS, words);
    let mut sizes = Vec::new();
    for (word, method) in words.into_iter().zip([
        Compression::ZIP16,
        Compression::ZIP1,
        Compression::PIZ,
        Compression::RLE,
        Compression::Uncompressed,
    ]) {
        let compression = ExrCompression::from_word(word).unwrap();
        let form = ExrForm {
            compression,
            ..ExrForm::default()
        };
        // Each map of attributes has an order of its own, also within one process.
        let bytes = [0, 1, 2, 3].map(|_| {
            write(&at(word), &scene, form, None);
            fs::read(at(word)).unwrap()
        });
        assert!(bytes.iter().all(|other| *other == bytes[0]), "{word}");
        let (channels, found) = read(&at(word));
        assert_eq!(found, method);
        assert_eq!(channels.len(), 4 + CHANNELS.len());
        for (place, channel) in CHANNELS.iter().enumerate() {
            let expected: Vec<u32> = (0..(SIZE.x * SIZE.y) as usize)
                .map(|pixel| number(place + pixel).to_bits())
                .collect();
            assert!(
                channels[channel.name] == expected,
                "{word}: {}",
                channel.name
            );
        }
        sizes.push(bytes[0].len());
    }
    // Without a loss and without compression a picture has more bytes than its numbers.
    assert!(sizes[4] > (4 * CHANNELS.len() + 8) * (SIZE.x * SIZE.y) as usize);
}

#[test]
fn zero_takes_the_place_of_nan_alone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.exr");
    for names in ChannelNames::ALL {
        let form = ExrForm {
            missing: MissingValues::Zero,
            names,
            ..ExrForm::default()
        };
        write(&file, &Scene::default(), form, None);
        let (channels, _) = read(&file);
        let name = match names {
            ChannelNames::Layers => "hit1_radius.Y",
            ChannelNames::Version01 => "hit1.r",
        };
        let place = CHANNELS
            .iter()
            .position(|channel| [channel.name, channel.old_name].contains(&name))
            .unwrap();
        let expected: Vec<u32> = (0..(SIZE.x * SIZE.y) as usize)
            .map(|pixel| number(place + pixel))
            .map(|it| if it.is_nan() { 0.0 } else { it }.to_bits())
            .collect();
        assert!(channels[name] == expected);
        assert!(expected.contains(&f32::INFINITY.to_bits()));
    }
}

#[test]
fn a_picture_is_opaque_unless_a_part_of_it_is_to_be_transparent() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.exr");
    let alpha = |transparent| {
        let form = ExrForm {
            transparent,
            ..ExrForm::default()
        };
        write(&file, &Scene::default(), form, None);
        let (channels, _) = read(&file);
        channels["A"].clone()
    };
    let bits = |share: f32| u32::from(f16::from_f32(share).to_bits());
    assert!(alpha(None).into_iter().all(|found| found == bits(1.0)));
    for transparent in Transparent::ALL {
        let expected = (0..(SIZE.x * SIZE.y) as usize).map(|at| bits(share(at)));
        assert!(
            alpha(Some(transparent)).into_iter().eq(expected),
            "{transparent:?}"
        );
    }
}

#[test]
fn a_picture_has_the_layers_of_what_its_scene_shows() {
    let layers = |scenes: Vec<Scene>| -> Vec<String> {
        let channels = Channels::default().with_layers_of(scenes);
        assert!(channels.of_rays().is_empty());
        let names = channels.list().iter().map(|channel| channel.name);
        let layers = names.filter_map(|name| name.strip_suffix(".A"));
        let layers: Vec<String> = layers.map(str::to_owned).collect();
        // Four channels for each layer, and the share of the hole.
        assert_eq!(channels.list().len(), 4 * layers.len() + 1);
        assert_eq!(channels.of_layers().len(), channels.list().len());
        let last = channels.list().last().map(|channel| channel.name);
        assert_eq!(last, Some("cover_hole.Y"));
        layers
    };
    let preset = |number: &str| presets::find(number).unwrap().scene(&[]).unwrap();
    let with_sky = |number: &str, mode: SkyMode| {
        let mut scene = preset(number);
        scene.sky.mode = mode;
        scene
    };
    let of = |number: &str, mode: SkyMode| layers(vec![with_sky(number, mode)]);
    let [sky, stars, hit1, hit2, volume, probe] = LAYERS;
    assert_eq!(of("2", SkyMode::Stars), [sky, stars, hit1, hit2]);
    assert_eq!(of("2", SkyMode::Procedural), [sky, hit1, hit2]);
    assert_eq!(of("2", SkyMode::Off), [hit1, hit2]);
    // Before a picture there are stars only where the scene asks for them.
    let mut picture = with_sky("2", SkyMode::Picture);
    assert_eq!(layers(vec![picture.clone()]), [sky, hit1, hit2]);
    picture.sky.stars = true;
    assert_eq!(layers(vec![picture]), [sky, stars, hit1, hit2]);
    assert_eq!(of("14", SkyMode::Stars), [sky, stars, volume]);
    assert_eq!(of("18", SkyMode::Off), [hit1, hit2, volume]);
    assert_eq!(of("6", SkyMode::Off), [hit1, hit2, probe]);
    // All frames of a sequence have the layers that any of them has.
    let off = with_sky("2", SkyMode::Off);
    let both = vec![off.clone(), with_sky("14", SkyMode::Grid)];
    assert_eq!(layers(both), [sky, hit1, hit2, volume]);
    // The picture's own shader draws what nobody asks to divide.
    let plain: Channels = "all".parse().unwrap();
    assert_eq!(plain.of_rays().len(), CHANNELS.len());
    assert_eq!(plain.drawn_layers(ExrForm::default()), None);
    let divided = plain.with_layers_of([off]);
    assert_eq!(divided.drawn_layers(ExrForm::default()), Some(Layers::ALL));
    let form = ExrForm {
        transparent: Some(Transparent::Sky),
        ..ExrForm::default()
    };
    let without_sky = Layers::ALL.without(Layers::SKY).without(Layers::STARS);
    assert_eq!(divided.drawn_layers(form), Some(without_sky));
}

/// The lines of a preset that the header keeps.
fn kept(preset: &str) -> String {
    let is_kept = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
    preset.split_inclusive('\n').filter(is_kept).collect()
}

/// ffmpeg 5.1 reads 255 bytes of a text that it does not know, and takes the rest for pixels.
#[test]
fn no_text_of_the_header_is_longer_than_255_bytes_and_the_pieces_of_a_preset_join() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.exr");
    let commit = "c\u{f6}mmit".repeat(100);
    // Characters of one to four bytes, so that pieces cannot all end where 255 bytes do; and more than
    // a hundred pieces, whose names have three digits.
    for title in [
        "",
        "short",
        &"a\u{e4}\u{5149}\u{1f30c}".repeat(300),
        &"x\u{5149}".repeat(8000),
    ] {
        let scene = Scene {
            title: title.to_owned(),
            ..Scene::default()
        };
        write(&file, &scene, ExrForm::default(), Some(&commit));
        let bytes = fs::read(&file).unwrap();
        let joined = embedded_preset(&bytes).unwrap();
        assert!(joined == kept(&scene.to_preset()), "{joined}");
        let other = read_first_flat_layer_from_file(&file)
            .unwrap()
            .layer_data
            .attributes
            .other;
        let mut texts = 0;
        for (name, value) in other {
            if let AttributeValue::Text(text) = value {
                let text = text.as_slice();
                assert!(
                    (1..=255).contains(&text.len()),
                    "{name}: {} bytes",
                    text.len()
                );
                assert!(std::str::from_utf8(text).is_ok(), "{name}");
                texts += 1;
            }
        }
        assert!(texts > CHANNELS.len() + 8, "{texts}");
        assert_eq!(title.len() > 20_000, texts > 130, "{texts} texts");
    }
}

#[test]
fn pieces_end_at_line_ends_wherever_a_line_fits_into_one() {
    let line = |length: usize| "k".repeat(length - 1) + "\n";
    let pieces = |lengths: &[usize]| -> Vec<usize> {
        let preset: String = lengths.iter().map(|length| line(*length)).collect();
        let pieces = preset_pieces(&preset);
        let joined: String = pieces.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(joined, preset);
        pieces.iter().map(|(_, text)| text.len()).collect()
    };
    assert_eq!(pieces(&[100, 155, 2]), [255, 2]);
    assert_eq!(pieces(&[100, 156]), [100, 156]);
    assert_eq!(pieces(&[10, 256, 10]), [10, 255, 11]);
    assert_eq!(pieces(&[600]), [255, 255, 90]);
}

#[test]
fn the_preset_in_one_piece_of_version_0_1_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("old.exr");
    let preset = Scene::default().to_preset();
    assert!(preset.len() > 255);
    let channels =
        exr::prelude::SpecificChannels::rgb(|_: Vec2<usize>| (0.5_f32, 0.5_f32, 0.5_f32));
    let mut image = exr::prelude::Image::from_channels((4, 3), channels);
    let text = AttributeValue::Text(Text::from_slice_unchecked(preset.as_bytes()));
    let other = &mut image.layer_data.attributes.other;
    other.insert(Text::from("lightfall.preset"), text);
    image.write().to_file(&file).unwrap();
    assert_eq!(embedded_preset(&fs::read(&file).unwrap()), Some(preset));
}
