//! The graphics device is lost while the program runs.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{STATUS_BAR, TITLE, WINDOW, program};
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::PollType;
use bevy::render::renderer::RenderDevice;
use bevy::render::{Render, RenderApp, RenderSystems};
use lightfall_core::gpu::driver_advice;

/// Whether the device is to be destroyed in this frame.
#[derive(Resource, Clone, Default, ExtractResource)]
struct Destroy(bool);

fn destroy(wanted: If<Res<Destroy>>, device: Res<RenderDevice>) {
    if wanted.0.0 {
        // Between two frames, and after every buffer that Bevy is reading has been read: a buffer
        // that a loss takes away stays readable, one that is destroyed does not.
        let _ = device.poll(PollType::wait_indefinitely());
        device.wgpu_device().destroy();
        // What this answers is the loss itself.
        let _ = device.poll(PollType::wait_indefinitely());
    }
}

/// The program with an additional key: keypad 7 destroys the device. This is no test: the test below
/// starts it as another process, because a window needs a main thread and its own display.
#[test]
#[ignore = "started by the test of device loss"]
fn started_program_that_loses_its_device() {
    let mut app = program();
    app.init_resource::<Destroy>()
        .add_plugins(ExtractResourcePlugin::<Destroy>::default())
        .add_systems(
            Update,
            |keys: Res<ButtonInput<KeyCode>>, mut destroy: ResMut<Destroy>| {
                destroy.0 = keys.just_pressed(KeyCode::Numpad7);
            },
        );
    app.sub_app_mut(RenderApp)
        .add_systems(Render, destroy.in_set(RenderSystems::Cleanup));
    // As the command ends, with its sentence.
    if let Err(sentence) = lightfall::app::run(app) {
        eprintln!("lightfall: {sentence}");
        std::process::exit(1);
    }
}

/// Opens the program above.
fn open() -> Desktop {
    let program = std::env::current_exe().unwrap();
    let only = [
        "--exact",
        "device_loss::started_program_that_loses_its_device",
        "--ignored",
        "--test-threads=1",
        "--nocapture",
    ];
    Desktop::open_program(&program, &only)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_lost_device_is_replaced_and_the_scene_stays() {
    let mut desktop = open();
    // Without the lines at the bottom: the window says there what happened.
    let changed = |a: &Shot, b: &Shot| a.changed(b, 0..WINDOW.0, TITLE..WINDOW.1 - 2 * STATUS_BAR);
    // A scene that is not the one it began with, meshes and lamps in it, and a panel over it. Each key
    // must show before the next one: while a shader compiles, the picture before it is at rest.
    let mut before = desktop.first_picture();
    for key in ["6", "t", "p"] {
        desktop.press(key);
        before = desktop.settled(key, |shot| changed(shot, &before) > 0.01);
    }
    for loss in 1..=2 {
        desktop.press("KP_Home");
        desktop.wait("the loss", || {
            desktop.stderr().matches("opening it again").count() == loss
        });
        desktop.settled(&format!("loss {loss}"), |shot| {
            changed(shot, &before) == 0.0
        });
        assert!(desktop.running(), "{}", desktop.stderr());
    }
    // It still responds to keys.
    desktop.press("F2");
    desktop.settled("F2", |shot| changed(shot, &before) > 0.05);
    desktop.press("F2");
    desktop.settled("F2 again", |shot| changed(shot, &before) == 0.0);
    assert!(
        !desktop.stderr().contains("panicked"),
        "{}",
        desktop.stderr()
    );
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_device_that_is_lost_again_and_again_ends_the_program_with_what_to_do() {
    let mut desktop = open();
    desktop.first_picture();
    // Five losses within a minute are recovered from, the sixth is one too many.
    for loss in 1..=5 {
        desktop.press("KP_Home");
        desktop.wait("the loss", || {
            desktop.stderr().matches("opening it again").count() == loss
        });
        desktop.frames(2);
        assert!(desktop.running(), "loss {loss}: {}", desktop.stderr());
    }
    desktop.press("KP_Home");
    let status = desktop.program.wait().unwrap();
    let stderr = desktop.stderr();
    let sentence = format!(
        "lightfall: the graphics device was lost more than 5 times within a minute: {}, or choose another adapter with \
         --gpu\n",
        driver_advice::with_old_driver("linux")
    );
    assert_eq!(status.code(), Some(1), "{stderr}");
    assert!(stderr.ends_with(&sentence), "{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
}
