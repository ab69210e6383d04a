//! A gamepad without hardware. Its messages are Bevy's own, as the reader of the hardware writes
//! them.

use crate::orders::Orders;
use bevy::input::gamepad::{
    GamepadConnection, GamepadConnectionEvent, RawGamepadAxisChangedEvent,
    RawGamepadButtonChangedEvent, RawGamepadEvent,
};
use bevy::prelude::*;
use watched::{Order, Pad};

pub fn plugin(app: &mut App) {
    app.add_systems(First, use_gamepad);
}

fn use_gamepad(
    mut commands: Commands,
    orders: Res<Orders>,
    mut connections: MessageWriter<GamepadConnectionEvent>,
    mut raw: MessageWriter<RawGamepadEvent>,
    mut gamepad: Local<Option<Entity>>,
) {
    let pad = *gamepad.get_or_insert_with(|| commands.spawn_empty().id());
    for order in &orders.new {
        match *order {
            Order::Connect(true) => {
                let connection = GamepadConnection::Connected {
                    name: "Pad of the test".into(),
                    vendor_id: None,
                    product_id: None,
                };
                connections.write(GamepadConnectionEvent::new(pad, connection));
            }
            Order::Connect(false) => {
                let connection = GamepadConnection::Disconnected;
                connections.write(GamepadConnectionEvent::new(pad, connection));
            }
            Order::Push(part, value) => {
                raw.write(pushed(pad, part, value));
            }
            _ => {}
        }
    }
}

fn pushed(pad: Entity, part: Pad, value: f32) -> RawGamepadEvent {
    let axis = |axis| RawGamepadEvent::Axis(RawGamepadAxisChangedEvent::new(pad, axis, value));
    let button =
        |button| RawGamepadEvent::Button(RawGamepadButtonChangedEvent::new(pad, button, value));
    match part {
        Pad::LeftStickY => axis(GamepadAxis::LeftStickY),
        Pad::RightStickX => axis(GamepadAxis::RightStickX),
        Pad::South => button(GamepadButton::South),
        Pad::East => button(GamepadButton::East),
        Pad::North => button(GamepadButton::North),
        Pad::DPadLeft => button(GamepadButton::DPadLeft),
        Pad::DPadRight => button(GamepadButton::DPadRight),
        Pad::Start => button(GamepadButton::Start),
        Pad::RightTrigger => button(GamepadButton::RightTrigger),
        Pad::RightTrigger2 => button(GamepadButton::RightTrigger2),
    }
}
