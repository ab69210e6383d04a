//! The card over the picture that says where a flight has ended.

use bevy::prelude::*;

/// What the card says. Empty while there is no card.
#[derive(Resource, Default)]
pub(crate) struct EndCard {
    pub(crate) title: String,
    pub(crate) text: String,
}

impl EndCard {
    pub(crate) fn show(&mut self, title: &str, text: &str) {
        *self = Self {
            title: title.into(),
            text: text.into(),
        };
    }

    pub(crate) fn close(&mut self) {
        *self = Self::default();
    }

    pub(crate) fn is_open(&self) -> bool {
        !self.title.is_empty()
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<EndCard>()
        .add_systems(PreUpdate, close_end_card.after(bevy::input::InputSystems));
}

/// The next key or click closes the card.
fn close_end_card(
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
    mut end_card: ResMut<EndCard>,
) {
    let used =
        keys.get_just_pressed().next().is_some() || buttons.get_just_pressed().next().is_some();
    if used && end_card.is_open() {
        end_card.close();
    }
}
