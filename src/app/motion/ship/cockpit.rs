//! What the instruments of the ship's cockpit read, for its sound.

use super::ship_flight::ShipFlight;
use crate::app::session::speaker;
use crate::app::state::light_meter::LightMeter;
use crate::app::state::preferences::Preferences;
use crate::app::state::sound::CockpitSound;
use bevy::prelude::*;
use lightfall_core::optics::ship::Clocks;
use lightfall_core::optics::sound::{Readings, flux_of_exposure};
use lightfall_render::CurrentScene;

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(speaker::plugin)
        .add_systems(Update, read_instruments.after(super::advance_ship));
}

/// Reads the instruments while a pilot flies the ship and its time passes. The rest is silence.
fn read_instruments(
    time: Res<Time>,
    ship: Res<ShipFlight>,
    preferences: Res<Preferences>,
    scene: Res<CurrentScene>,
    meter: Res<LightMeter>,
    mut own_meter: Local<LightMeter>,
    mut sound: ResMut<CockpitSound>,
) {
    let settings = &preferences.settings;
    let listens = ship.moves() && settings.volume > 0.0;
    let Some(voyage) = ship.voyage().filter(|_| listens) else {
        sound.readings.volume = 0.0;
        return;
    };
    // The picture's light meter measures only where it chooses the exposure.
    let exposure = if scene.picture.automatic_exposure && !settings.reduced_motion {
        meter.chosen()
    } else {
        own_meter.follow(scene.scene(), time.delta_secs_f64());
        own_meter.chosen()
    };
    let flight = &voyage.flight;
    sound.readings = Readings {
        home_light: Clocks::new(&flight.ship).home_light,
        thrust: flight.acceleration().length() / flight.rocket.max_acceleration(),
        flux: flux_of_exposure(exposure - scene.picture.exposure_bias),
        volume: settings.volume,
    };
}
