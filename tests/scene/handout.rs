//! The handout of the ray inspector: an XML document whose texts are those of the inspector.

use glam::DVec3;
use lightfall::app::plane_handout;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;
use lightfall_core::scene::presets::find;
use roxmltree::{Document, Node};

fn ray(scene: &Scene, direction: [f64; 3]) -> Inspected {
    let direction = DVec3::from_array(direction).normalize();
    Inspected::new(scene, direction, Some([100.0, 50.0]), 120.0).unwrap()
}

fn scene() -> Scene {
    let mut scene = find("above").unwrap().plain_scene().clone();
    (scene.camera.r, scene.camera.theta_deg) = (20.0, 80.0);
    scene
}

fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let is_text = |node: &Node| node.has_tag_name("text");
    let texts = document.descendants().filter(is_text);
    texts
        .map(|node| node.text().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn a_handout_is_xml_and_says_the_numbers_of_the_ray() {
    let mut scene = scene();
    scene.title = "Rays & <angles> of \"light\"".into();
    let inspected = ray(&scene, [-0.979337, -0.03, -0.2]);
    let svg = plane_handout(&scene, std::slice::from_ref(&inspected), Units::Hole).unwrap();
    let texts = texts(&svg);
    assert_eq!(texts[0], scene.title);
    let hit = inspected.trace.hits[0].unwrap();
    let [r, g] = [hit.r, hit.g].map(four_digits);
    let says = |words: &str| texts.iter().any(|text| text.contains(words));
    // In the figure, and in the list of numbers.
    assert!(says(&format!("r = {r} r_s, g = {g}")), "{texts:?}");
    assert!(
        says(&format!("r {r} r_s")) && says(&format!("g {g}, ")),
        "{texts:?}"
    );
    assert!(says(&format!(
        "{} times as bright",
        four_digits(hit.g.powi(4))
    )));
    assert!(says("Light from the disk.") && says("Grey: the disk."));

    scene.disk.enabled = false;
    let passes = ray(&scene, [-0.991626, -0.129145, 0.0]);
    let svg = plane_handout(&scene, std::slice::from_ref(&passes), Units::Hole).unwrap();
    let texts = self::texts(&svg);
    let says = |words: &str| texts.iter().any(|text| text.contains(words));
    let angle = four_digits(passes.numbers.deflection.unwrap().to_degrees());
    let [b, closest] = [
        passes.numbers.impact_parameter.unwrap(),
        passes.numbers.closest_r,
    ]
    .map(four_digits);
    assert!(
        says(&format!("deflection {angle}°")) && says(&format!("b = {b} r_s")),
        "{texts:?}"
    );
    assert!(
        says(&format!("closest r = {closest} r_s")) && !says("Grey"),
        "{texts:?}"
    );
    assert_eq!(plane_handout(&scene, &[], Units::Hole), None);
}

/// A black and white copy loses nothing: there are no colours, and no light ink on the white page.
#[test]
fn a_handout_has_no_colours_and_no_faint_lines() {
    let scene = scene();
    for direction in [
        [-0.979337, -0.03, -0.2],
        [-0.991626, -0.129145, 0.0],
        [-1.0, 0.0, 0.0],
    ] {
        let inspected = ray(&scene, direction);
        let svg = plane_handout(&scene, &[inspected], Units::Hole).unwrap();
        let document = Document::parse(&svg).unwrap();
        let mut lines = 0;
        for node in document.descendants().filter(Node::is_element) {
            for ink in ["fill", "stroke"]
                .iter()
                .filter_map(|key| node.attribute(*key))
            {
                assert!(["none", "#fff", "#000", "#888"].contains(&ink), "{ink}");
            }
            let opacity = node.attribute("stroke-opacity");
            if let Some(opacity) = opacity.map(|opacity| opacity.parse::<f64>().unwrap()) {
                assert!(opacity > 0.4, "{opacity}");
                lines += 1;
            }
        }
        assert!(lines > 10, "{lines} lines");
        // Every place is a number.
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}

/// No value of the left column reaches into the right one, whatever the font: digits of Helvetica and Arial
/// are 0.556 of the text's size wide, and few letters are wider.
#[test]
fn the_numbers_of_a_handout_stay_in_their_columns() {
    let scene = scene();
    for direction in [[-0.979337, -0.03, -0.2], [-0.979337, -0.03, 0.2]] {
        let inspected = ray(&scene, direction);
        let svg = plane_handout(&scene, &[inspected], Units::Hole).unwrap();
        let document = Document::parse(&svg).unwrap();
        let page = document.root_element().children();
        let texts: Vec<(f64, f64, &str)> = page
            .filter(|node| node.has_tag_name("text"))
            .map(|node| {
                let size = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
                (size("x"), size("font-size"), node.text().unwrap())
            })
            .collect();
        let mut columns: Vec<f64> = texts.iter().map(|(x, ..)| *x).collect();
        columns.sort_by(f64::total_cmp);
        columns.dedup();
        let [margin, left, right, _] = columns[..] else {
            panic!("{columns:?}")
        };
        assert!(margin < left);
        let values = texts.iter().filter(|(x, ..)| *x == left);
        let mut count = 0;
        for (x, size, text) in values {
            let end = x + 0.556 * size * text.chars().count() as f64;
            assert!(end < right, "{text}: {end} {right}");
            count += 1;
        }
        assert!(count > 3, "{texts:?}");
        assert!(texts.iter().any(|(.., text)| text.contains(" K")));
    }
}

#[test]
fn a_radial_ray_is_not_turned_at_all() {
    let mut scene = scene();
    scene.disk.enabled = false;
    scene.title.clear();
    for r in [1.5, 20.0] {
        scene.camera.r = r;
        let outward = ray(&scene, [1.0, 0.0, 0.0]);
        let svg = plane_handout(&scene, &[outward], Units::Hole).unwrap();
        let texts = texts(&svg);
        assert!(
            texts.iter().any(|text| text.contains("turned by 0°.")),
            "{texts:?}"
        );
        assert!(texts.iter().all(|text| !text.contains("e-")), "{texts:?}");
    }
}

#[test]
fn a_handout_names_the_physics_that_is_switched_off() {
    let mut scene = scene();
    let handed_out = |scene: &Scene| {
        let inspected = ray(scene, [-0.979337, -0.03, -0.2]);
        plane_handout(scene, &[inspected], Units::Hole).unwrap()
    };
    assert!(!handed_out(&scene).contains("Physics off"));
    scene.effects.doppler = false;
    let texts = texts(&handed_out(&scene));
    assert!(
        texts.contains(&"Physics off: Doppler shift".to_owned()),
        "{texts:?}"
    );
}
