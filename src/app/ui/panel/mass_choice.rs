//! The choice of the hole's mass, which turns its units into kilometres, seconds and g.

use crate::app::state::settings::{HOLE_MASSES, Settings};
use bevy_egui::egui;
use lightfall_core::numbers::{from_words, in_words};
use lightfall_core::optics::readout::si::MASSES;

/// Shows the masses to choose from.
pub(super) fn choose_mass(ui: &mut egui::Ui, settings: &mut Settings) {
    let suns = &mut settings.hole_mass_suns;
    ui.horizontal_wrapped(|ui| {
        ui.label("Mass");
        for mass in MASSES {
            ui.selectable_value(suns, mass.suns, mass.name);
        }
        let speed = *suns * 0.01;
        let own = egui::DragValue::new(suns)
            .range(HOLE_MASSES[0]..=HOLE_MASSES[1])
            .speed(speed)
            .suffix(" suns");
        let own = own.custom_formatter(|suns, _| in_words(suns));
        ui.add(own.custom_parser(from_words));
    });
}
