//! Obeys the orders that arrive on standard input.

use bevy::input::touch::{TouchInput, TouchPhase};
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::window::{FileDragAndDrop, PrimaryWindow};
use lightfall::app::{DiskClock, Preferences};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::load;
use lightfall_render::CurrentScene;
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use watched::{Order, Stroke};

/// The lines that have arrived.
#[derive(Resource)]
struct Lines(Mutex<Receiver<String>>);

/// The orders of this frame, and the number of those before.
#[derive(Resource, Default)]
pub struct Orders {
    /// Those of this frame.
    pub new: Vec<Order>,
    /// The number of all so far.
    pub count: u32,
}

/// The least time that a frame takes, in seconds.
#[derive(Resource, Default)]
struct FrameSeconds(f64);

pub fn plugin(app: &mut App) {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        for line in std::io::stdin().lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    app.insert_resource(Lines(Mutex::new(receiver)))
        .init_resource::<Orders>()
        .init_resource::<FrameSeconds>()
        .add_systems(First, (receive_orders, (touch, drop_files)).chain())
        .add_systems(Update, (show_scene, size_texts))
        .add_systems(Last, slow_down);
}

fn receive_orders(lines: Res<Lines>, mut orders: ResMut<Orders>, mut commands: Commands) {
    let lines = lines.0.lock().expect("no other system panicked");
    orders.new = lines
        .try_iter()
        .map(|line| serde_json::from_str(&line).expect("a line is an order"))
        .collect();
    orders.count += orders.new.len() as u32;
    for order in &orders.new {
        if let Order::Step(seconds) = order {
            let step = Duration::from_secs_f64(*seconds);
            commands.insert_resource(TimeUpdateStrategy::ManualDuration(step));
        }
    }
}

fn size_texts(orders: Res<Orders>, mut preferences: ResMut<Preferences>) {
    for order in &orders.new {
        if let Order::TextSize(scale) = order {
            preferences.settings.ui_scale = *scale;
        }
    }
}

fn slow_down(orders: Res<Orders>, mut frame: ResMut<FrameSeconds>) {
    for order in &orders.new {
        if let Order::Slow(seconds) = order {
            frame.0 = *seconds;
        }
    }
    std::thread::sleep(Duration::from_secs_f64(frame.0));
}

fn touch(
    orders: Res<Orders>,
    window: Single<Entity, With<PrimaryWindow>>,
    mut touches: MessageWriter<TouchInput>,
) {
    for order in &orders.new {
        if let Order::Touch(id, stroke, place) = *order {
            touches.write(TouchInput {
                phase: match stroke {
                    Stroke::Down => TouchPhase::Started,
                    Stroke::Move => TouchPhase::Moved,
                    Stroke::Up => TouchPhase::Ended,
                },
                position: place.into(),
                window: *window,
                force: None,
                id,
            });
        }
    }
}

fn drop_files(
    orders: Res<Orders>,
    window: Single<Entity, With<PrimaryWindow>>,
    mut drops: MessageWriter<FileDragAndDrop>,
) {
    for order in &orders.new {
        if let Order::Drop(file) = order {
            drops.write(FileDragAndDrop::DroppedFile {
                window: *window,
                path_buf: file.clone(),
            });
        }
    }
}

fn show_scene(orders: Res<Orders>, mut scene: ResMut<CurrentScene>, mut clock: ResMut<DiskClock>) {
    for order in &orders.new {
        if let Order::Show(preset) = order {
            let shown = load("the order", preset, &[]).expect("an order holds a preset");
            scene.0 = Drawable::new(shown).expect("an order's scene can be drawn");
            clock.set(scene.disk.time);
        }
    }
}
