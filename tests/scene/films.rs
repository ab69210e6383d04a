//! Films: what ffmpeg is told, and what is refused before anything is drawn.

use super::program::{program, program_with};
use glam::UVec2;
use lightfall_core::scene::Scene;
use lightfall_picture::{
    Codec, Container, FilmForm, Format, Frames, PngBits, Sequence, filter_value, loop_lines,
    numbered_pictures,
};
use std::fs;
use std::path::Path;

/// A film of small pictures with 16 bits.
pub fn form(container: Container, codec: Codec) -> FilmForm {
    FilmForm {
        container,
        codec,
        size: UVec2::new(98, 64),
        fps: 24.0,
        bits: PngBits::Sixteen,
        is_of_whole_sky: false,
    }
}

#[test]
fn a_films_format_and_codec_follow_its_name() {
    for (name, container, codec) in [
        ("a.mp4", Container::Mp4, Codec::H264),
        ("a.b.MOV", Container::Mov, Codec::Prores),
        ("a.webm", Container::Webm, Codec::Av1),
    ] {
        assert_eq!(Container::of(Path::new(name)), Some(container));
        assert_eq!(Format::of(Path::new(name)).unwrap(), Format::Film);
        assert_eq!(container.codecs()[0], codec);
    }
    assert_eq!(Container::of(Path::new("mp4")), None);
    assert_eq!(Container::of(Path::new("a.png")), None);
    assert!(Format::Film.holds_sequence() && Format::Apng.holds_sequence());
    assert!(!Format::Png.holds_sequence() && !Format::Exr.holds_sequence());
}

#[test]
fn ffmpeg_is_told_the_pictures_the_colours_and_the_codec() {
    let said = |form: FilmForm| form.arguments().join(" ");
    let sdr = "setparams=color_primaries=bt709:color_trc=bt709:colorspace=gbr:range=pc,\
               zscale=m=709:r=limited:d=error_diffusion";
    let input = "-v error -nostdin -y -f rawvideo -pixel_format rgb48le -video_size 98x64 -framerate 24 -i pipe:0";
    assert_eq!(
        said(form(Container::Mp4, Codec::H264)),
        format!(
            "{input} -vf format=gbrp16le,{sdr},format=yuv420p -c:v libx264 -preset slow -crf 16 \
             -movflags +faststart -f mp4"
        )
    );
    assert_eq!(
        said(form(Container::Mov, Codec::Prores)),
        format!(
            "{input} -vf format=gbrp16le,{sdr},format=yuv444p10le -c:v prores_ks -profile:v 4444 -vendor apl0 \
             -movflags +faststart -f mov"
        )
    );
    assert_eq!(
        said(form(Container::Webm, Codec::Av1)),
        format!(
            "{input} -vf format=gbrp16le,{sdr},format=yuv420p10le -c:v libsvtav1 -preset 6 -crf 24 -f webm"
        )
    );
    let hdr = said(form(Container::Mp4, Codec::Hdr10));
    for part in [
        "color_primaries=bt2020:color_trc=smpte2084:colorspace=gbr:range=pc,zscale=m=2020_ncl:r=limited",
        "-c:v libx265 -crf 16 -tag:v hvc1",
        "hdr10=1:repeat-headers=1:colorprim=bt2020:transfer=smpte2084:colormatrix=bt2020nc:range=limited",
        "max-cll=1000,400",
    ] {
        assert!(hdr.contains(part), "{hdr}");
    }
}

#[test]
fn eight_bits_odd_sides_and_the_whole_sky_change_what_ffmpeg_is_told() {
    let mut odd = form(Container::Mp4, Codec::H264);
    (odd.size, odd.bits, odd.fps) = (UVec2::new(97, 64), PngBits::Eight, 23.976);
    let said = odd.arguments().join(" ");
    assert!(said.contains("-pixel_format rgb24 -video_size 97x64 -framerate 23.976 "));
    assert!(said.contains(" -vf pad=ceil(iw/2)*2:ceil(ih/2)*2,format=gbrp,setparams="));
    // The mark is added to a file whose index stands at the end, and ffmpeg copies an MPEG-4 with it.
    for (container, codec, first) in [
        (Container::Mp4, Codec::H264, "-f mp4"),
        (Container::Webm, Codec::Av1, "-f mp4"),
        (Container::Mov, Codec::Prores, "-f mov"),
    ] {
        let mut sky = form(container, codec);
        sky.is_of_whole_sky = true;
        let said = sky.arguments().join(" ");
        assert!(
            said.ends_with(first) && !said.contains("faststart"),
            "{said}"
        );
    }
    let [before, between] = form(Container::Mp4, Codec::Hdr10).copy_arguments();
    assert_eq!(before.join(" "), "-v error -nostdin -y -i");
    assert_eq!(
        between.join(" "),
        "-c copy -strict unofficial -tag:v hvc1 -movflags +faststart -f mp4"
    );
}

/// As ffmpeg 5.1 takes them: the value of an option, in a description of filters.
#[test]
fn names_in_filters_and_lines_are_escaped() {
    assert_eq!(
        filter_value("my o'ut:x,y[1]/t.csp"),
        r"my o\\\'ut\\:x\,y\[1\]/t.csp"
    );
    let [avif, webp, gif] = loop_lines(Path::new("my disk.mp4"));
    assert!(avif.starts_with("ffmpeg -i 'my disk.mp4' -c:v libsvtav1 "));
    assert!(webp.ends_with(" -loop 0 'my disk.webp'"));
    assert!(gif.contains("palettegen") && gif.ends_with(" 'my disk.gif'"));
}

#[test]
fn what_a_film_cannot_be_is_refused_before_anything_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let sky = "render --set camera.projection=equirectangular --frames 0..1";
    let cube = "render --set camera.projection=cube --size 96x64 --frames 0..1";
    for (line, sentence) in [
        (
            "render -o a.mp4".to_owned(),
            "-o: a film holds the frames of a sequence, so --frames A..B must name them",
        ),
        (
            "render --frames 0..1 -o a.webm --codec h264".into(),
            "--codec h264: a .webm can hold av1",
        ),
        (
            "render --frames 0..1 -o a.png --codec h264".into(),
            "--codec is for a film: the file's name must end in .mp4, .mov or .webm",
        ),
        (
            "render -o a.exr --ffmpeg ffmpeg".into(),
            "--ffmpeg is for a film: the file's name must end in .mp4, .mov or .webm",
        ),
        (
            "render --frames 0..1 -o a.mp4 --aov sky".into(),
            "--aov is for pictures of linear light: the file's name must end in .exr",
        ),
        (
            format!("{sky} --size 66x33 -o a.mp4"),
            "--size: a film of the whole sky has even sides, and not 66x33",
        ),
        (
            format!("{cube} -o a.mp4 --codec hdr10"),
            "--codec hdr10: a film of the sides of a cube has no HDR; --codec h264 has the same pictures",
        ),
        (
            "render --frames 0..1 -o a.mp4 --codec hdr10 --bits 16".into(),
            "--bits: a film in HDR10 has ten bits",
        ),
        (
            "render --frames 0..1 -o a.mp4 --codec hdr10 --cells on".into(),
            "--cells on: a film in HDR10 has no cells",
        ),
        (
            "video a-#.png -o a.png".into(),
            "a.png: the name of a film must end in .mp4, .mov or .webm",
        ),
        (
            "video a-#.png -o a.mp4".into(),
            "a-#.png: there is no such picture; the first one could be a-0.png",
        ),
        (
            "video a.mp4 -o b.mp4".into(),
            "a.mp4: the pictures of a film are numbered .png or .exr files, such as flight-####.png",
        ),
        (
            "lut -o a.lut".into(),
            "a.lut: the name of a table must end in .csp for ffmpeg, .clf for OpenColorIO, or .cube for DaVinci Resolve",
        ),
        (
            "lut -o a.cube --hdr 1000".into(),
            "--hdr 1000: a .cube reaches only to light 64; .csp and .clf have codes of HDR10",
        ),
    ] {
        assert_eq!(
            program(folder.path(), &line, ""),
            (2, String::new(), format!("lightfall: {sentence}\n")),
            "{line}"
        );
    }
}

#[test]
fn a_loop_that_does_not_close_is_refused_with_what_closes_it() {
    let folder = tempfile::tempdir().unwrap();
    let living = "render --preset 2 --set disk.structure=turbulent";
    let spot = "--set hot_spot.kind=rigid --set hot_spot.r=6 --set disk.rate=5";
    for (line, part) in [
        (
            "render --preset 2 --loop 1.01 --fps 30 -o a-#.png".to_owned(),
            "--loop 1.01: a loop has a whole number of frames",
        ),
        (
            "render --preset 2 --loop 2 --journey j.toml -o a-#.png".into(),
            "--loop 2: a journey does not end where it begins",
        ),
        (
            format!("{living} --set disk.rate=0 --loop 2 -o a-#.png"),
            "--loop 2: the disk's clock stands still",
        ),
        (
            format!("{living} --set disk.rate=0.1 --loop 2 -o a-#.png"),
            "--loop 2: disk.period = 0.2",
        ),
        (
            format!("{living} --set jet.enabled=true --loop 2 -o a-#.png"),
            "--loop 2: the jets do not repeat",
        ),
        (
            format!("{living} {spot} --loop 2 -o a-#.png"),
            "--loop 2: the hot spot goes around",
        ),
        (
            format!("{living} {spot} --set hot_spot.kind=sheared --loop 2 -o a-#.png"),
            "--loop 2: a sheared hot spot does not repeat",
        ),
    ] {
        let (status, stdout, stderr) = program(folder.path(), &line, "");
        assert!(
            status == 2 && stdout.is_empty() && stderr.starts_with(&format!("lightfall: {part}")),
            "{line}: {stderr}"
        );
    }
}

#[test]
fn a_camera_that_turns_is_where_it_began_after_a_loop() {
    let mut sequence = Sequence::new(
        None,
        "0..3".parse::<Frames>().unwrap(),
        1.0,
        Path::new("a.png"),
    )
    .unwrap();
    sequence.turn = Some(4.0);
    let mut scene = Scene::default();
    scene.camera.phi_deg = 170.0;
    let azimuth = |number| sequence.scene(&scene, number).camera.phi_deg;
    assert_eq!(
        [0, 1, 2, 3, 4].map(azimuth),
        [170.0, -100.0, -10.0, 80.0, 170.0]
    );
}

#[test]
fn without_ffmpeg_a_film_is_refused_before_anything_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let path = ("PATH", folder.path());
    let none = ("LIGHTFALL_FFMPEG", Path::new(""));
    let found = program_with(
        &[path, none],
        folder.path(),
        "render --frames 0..1 -o a.mp4",
        "",
    );
    let sentence = "lightfall: ffmpeg was not found; install it, name it with --ffmpeg, or draw numbered pictures \
                    with -o flight-####.png\n";
    assert_eq!(found, (1, String::new(), sentence.into()));
    let found = program(
        folder.path(),
        "render --frames 0..1 -o a.mp4 --ffmpeg nowhere/ffmpeg",
        "",
    );
    let sentence = "lightfall: --ffmpeg nowhere/ffmpeg: it cannot be run: there is no such file\n";
    assert_eq!(found, (1, String::new(), sentence.into()));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn the_pictures_of_a_film_have_no_gap() {
    let folder = tempfile::tempdir().unwrap();
    let here = |name: &str| folder.path().join(name);
    for name in [
        "a2-08.png",
        "a2-09.png",
        "a2-100.png",
        "a2-010.png",
        "b.png",
    ] {
        fs::write(here(name), "").unwrap();
    }
    let found = numbered_pictures(&here("a2-##.png")).unwrap_err();
    assert!(
        found.ends_with("a2-10.png is missing: the pictures of a film have no gaps"),
        "{found}"
    );
    for number in 10..100 {
        fs::write(here(&format!("a2-{number}.png")), "").unwrap();
    }
    let found = numbered_pictures(&here("a2-##.png")).unwrap();
    assert_eq!(found.len(), 93);
    assert_eq!(found[0], here("a2-08.png"));
    assert_eq!(found[92], here("a2-100.png"));
}
