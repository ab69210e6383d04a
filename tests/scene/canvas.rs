//! The picture in windows of every size: it fills them with even cells, or pixel by pixel.

use bevy::math::{URect, UVec2};
use lightfall::app::{Canvas, PictureShape, Resolution};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::fit;
use lightfall_core::scene::{Frame, MAX_PICTURE_SIDE, MAX_PIXELS_PER_CELL, Picture, Scene};
use lightfall_render::{Letterbox, PictureArea, RestingSizes, letterbox};

use crate::random::Random;

/// Windows of common screens, of odd sizes, an ultra-wide one and an upright one.
const WINDOWS: [(u32, u32); 12] = [
    (1440, 810),
    (1366, 768),
    (700, 450),
    (1600, 900),
    (2560, 1440),
    (1920, 1080),
    (3840, 2160),
    (3440, 1440),
    (5120, 1440),
    (600, 1000),
    (1001, 601),
    (200, 150),
];

#[test]
fn cells_fill_every_window_and_are_all_of_one_size() {
    let picture = Picture::default();
    for (width, height) in WINDOWS {
        let window = UVec2::new(width, height);
        let drawn = fit(&picture, window, u64::MAX);
        let Letterbox { offset, extent } = letterbox(&drawn, window);
        let scale = extent.as_uvec2() / drawn.grid();
        let name = format!("{width}x{height}: {drawn:?}");
        assert_eq!(extent, (drawn.grid() * scale).as_vec2(), "{name}");
        assert_eq!(scale.x, scale.y, "{name}");
        // Nothing of the window is left free, and less than one cell lies beyond each edge.
        let beyond = offset + extent - window.as_vec2();
        for side in [-offset, beyond] {
            assert!(side.min_element() >= 0.0, "{name}");
            assert!(side.max_element() < scale.x as f32, "{name}");
        }
        // Two pixels to a cell, as the scene has.
        assert_eq!(drawn.size(), 2 * drawn.grid(), "{name}");
        // The nearest whole number of pixels to 270 rows of cells.
        let scale = f64::from(scale.y);
        let exact = f64::from(height) / 270.0;
        assert!((scale - exact).abs() <= 0.5 || scale == 1.0, "{name}");
    }
}

#[test]
fn common_screens_have_these_cells() {
    let cells = |width, height| {
        let window = UVec2::new(width, height);
        let grid = fit(&Picture::default(), window, u64::MAX).grid();
        (grid.x, grid.y, window.y.div_ceil(grid.y))
    };
    assert_eq!(cells(1440, 810), (480, 270, 3));
    assert_eq!(cells(1920, 1080), (480, 270, 4));
    assert_eq!(cells(1366, 768), (456, 256, 3));
    assert_eq!(cells(1600, 900), (534, 300, 3));
    assert_eq!(cells(2560, 1440), (512, 288, 5));
    assert_eq!(cells(700, 450), (350, 225, 2));
    assert_eq!(cells(3440, 1440), (688, 288, 5));
    assert_eq!(cells(600, 1000), (150, 250, 4));
}

#[test]
fn without_cells_the_picture_has_the_windows_pixels_or_as_many_as_are_allowed() {
    let picture = Picture {
        bypass: true,
        ..Picture::default()
    };
    for (width, height) in WINDOWS {
        let window = UVec2::new(width, height);
        assert_eq!(fit(&picture, window, u64::MAX).size(), window);
        let max_pixels = 400_000;
        let drawn = fit(&picture, window, max_pixels).size();
        // Rounding each side to whole pixels adds half a row and half a column at most.
        let pixels = u64::from(drawn.x) * u64::from(drawn.y);
        assert!(pixels <= max_pixels + u64::from(drawn.x + drawn.y));
        let filled = Letterbox {
            offset: bevy::math::Vec2::ZERO,
            extent: window.as_vec2(),
        };
        let drawn = fit(&picture, window, max_pixels);
        assert_eq!(letterbox(&drawn, window), filled, "{window}: {drawn:?}");
    }
}

#[test]
fn the_presets_own_shape_has_a_frame_and_its_own_cells() {
    let scene = Drawable::new(Scene::default()).unwrap();
    let mut resolution = Resolution::default();
    let size = UVec2::new(1366, 768);
    resolution.set_canvas(Canvas {
        size,
        window: size,
        shape: PictureShape::Preset,
        max_pixels: u64::MAX,
    });
    let drawn = resolution.at_rest(&scene.picture);
    assert_eq!(drawn, scene.picture);
    let Letterbox { offset, extent } = letterbox(&drawn, size);
    assert_eq!((offset.x, offset.y), (203.0, 114.0));
    assert_eq!((extent.x, extent.y), (960.0, 540.0));
}

#[test]
fn random_pictures_in_random_windows_can_be_drawn_and_keep_their_own_size() {
    let mut random = Random::new();
    for case in 0..4000 {
        let mut scene = Scene::default();
        let picture = &mut scene.picture;
        picture.bypass = random.of(&[true, false]);
        for (side, cells) in [
            (&mut picture.width, &mut picture.grid_width),
            (&mut picture.height, &mut picture.grid_height),
        ] {
            let longest = random.of(&[1, 70, 1000, MAX_PICTURE_SIDE]);
            *side = random.integer(1, longest);
            *cells = random.integer(side.div_ceil(MAX_PIXELS_PER_CELL), *side);
        }
        let own = Drawable::new(scene).unwrap();
        let longest = random.of(&[3, 100, 3000, 20_000]);
        let mut resolution = Resolution::default();
        let window = UVec2::new(random.integer(1, longest), random.integer(1, longest));
        resolution.set_canvas(Canvas {
            size: UVec2::new(random.integer(1, window.x), window.y),
            window,
            shape: random.of(&[PictureShape::Window, PictureShape::Preset]),
            max_pixels: random.of(&[1, 400_000, u64::MAX]),
        });
        resolution.set_share(f64::from(random.integer(4, 16)) / 16.0);
        let drawn = resolution.at_rest(&own.picture);
        let mut rest = own.scene().clone();
        rest.picture = drawn;
        assert!(Drawable::new(rest).is_ok(), "case {case}: {drawn:?}");
        let drawn = own.shown_in(&resolution.frame(&own));
        // The drawn scene has the sizes that are wanted: no size was refused.
        assert_eq!(
            resolution.frame(&own),
            Frame::of(&drawn),
            "case {case}: {resolution:?}"
        );
        assert_eq!(drawn.check(), Ok(()), "case {case}: {resolution:?}");
        assert_eq!(drawn.shown_in(&Frame::of(&own)), own, "case {case}");
    }
}

#[test]
fn a_coarser_picture_lies_where_it_lies_at_rest() {
    // The picture of the preset's shape has bars; any other fills the window.
    for (shape, fills) in [(PictureShape::Window, true), (PictureShape::Preset, false)] {
        for ((width, height), bypass) in WINDOWS
            .into_iter()
            .flat_map(|window| [(window, false), (window, true)])
        {
            let window = UVec2::new(width, height);
            let own = Picture {
                bypass,
                ..Picture::default()
            };
            let mut resolution = Resolution::default();
            resolution.set_canvas(Canvas {
                size: window,
                window,
                shape,
                max_pixels: 400_000,
            });
            let at_rest = resolution.at_rest(&own);
            let area = PictureArea {
                part: URect::from_corners(UVec2::ZERO, window),
                at_rest: Some(RestingSizes {
                    size: at_rest.size(),
                    grid: at_rest.grid(),
                }),
            };
            let resting = letterbox(&at_rest, window);
            if bypass && fills {
                assert_eq!(resting.extent, window.as_vec2(), "{window}");
            }
            let scene = Drawable::new(Scene {
                picture: own,
                ..Scene::default()
            })
            .unwrap();
            for sixteenths in 4..16 {
                resolution.set_share(f64::from(sixteenths) / 16.0);
                let frame = resolution.frame(&scene);
                let drawn = scene.shown_in(&frame).picture;
                let shown = area.letterbox(&drawn, window);
                assert_eq!(shown, resting, "{window}, {shape:?}: {drawn:?}");
            }
        }
    }
}
