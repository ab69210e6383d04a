//! The window's icon, for desktops that take it from the program.

use bevy::ecs::system::NonSendMarker;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy::winit::WINIT_WINDOWS;
use std::io::Cursor;
use winit::window::Icon;

/// The icon as a PNG with transparency.
const ICON: &[u8] = include_bytes!("../../../assets/icon/lightfall-64.png");

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, set_icon);
}

/// Gives the window its icon, once there is a window. Only the main thread may do this.
fn set_icon(
    window: Single<Entity, With<PrimaryWindow>>,
    mut done: Local<bool>,
    _main_thread: NonSendMarker,
) {
    if *done {
        return;
    }
    WINIT_WINDOWS.with_borrow(|windows| {
        if let Some(window) = windows.get_window(*window) {
            window.set_window_icon(icon());
            *done = true;
        }
    });
}

/// The icon. None if its file is no picture with four channels of eight bits.
fn icon() -> Option<Icon> {
    let mut reader = png::Decoder::new(Cursor::new(ICON)).read_info().ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    rgba.truncate(info.buffer_size());
    Icon::from_rgba(rgba, info.width, info.height).ok()
}
