//! The page of read-outs: what the observer would note down, in units of the hole and for a hole of
//! some mass.

use crate::app::motion::free_fall::FreeFall;
use crate::app::state::settings::{HOLE_MASSES, Settings};
use bevy_egui::egui;
use lightfall_core::optics::readout::Readout;
use lightfall_core::optics::readout::si::{HoleMass, MASSES};
use lightfall_core::scene::Scene;
use std::time::{Duration, Instant};

/// Read-outs of a moving observer are made anew this often: they are to be read.
const AGE: Duration = Duration::from_millis(150);

/// What the page remembers.
#[derive(Default)]
pub(super) struct State {
    last: Option<(Scene, Instant, Result<Readout, String>)>,
}

impl State {
    fn readout(&mut self, scene: &Scene) -> &Result<Readout, String> {
        let stale = self
            .last
            .as_ref()
            .is_none_or(|(seen, made, _)| seen != scene && made.elapsed() > AGE);
        if stale {
            self.last = None;
        }
        let fresh = || {
            (
                scene.clone(),
                Instant::now(),
                Readout::new(scene).map_err(|error| error.to_string()),
            )
        };
        &self.last.get_or_insert_with(fresh).2
    }
}

pub(super) fn show(
    ui: &mut egui::Ui,
    state: &mut State,
    scene: &Scene,
    voyage: &FreeFall,
    settings: &mut Settings,
) {
    let mass = choose_mass(ui, settings);
    ui.separator();
    let readout = match state.readout(scene) {
        Ok(readout) => *readout,
        Err(reason) => {
            ui.colored_label(ui.visuals().error_fg_color, reason);
            return;
        }
    };
    let si = readout.in_si(mass);
    let none = || "none here".to_owned();
    let speed =
        |speed: Option<f64>| speed.map_or_else(none, |speed| format!("{} c", number(speed)));
    let [theta, phi] = readout.angles_deg;
    table(
        ui,
        "Place, Boyer-Lindquist",
        &[
            ("r", format!("{} r_s", number(readout.r))),
            ("", format!("{} km", number(si.r_km))),
            ("theta", format!("{theta:.3}°")),
            ("phi", format!("{phi:.3}°")),
        ],
    );
    let kind = scene.observer.kind.properties().motion_in_full;
    table(
        ui,
        "Observer",
        &[
            ("kind", kind.into()),
            ("speed, seen at rest", speed(readout.speed_for_static)),
            ("speed, seen by zamo", speed(readout.speed_for_zamo)),
            (
                "d tau / dt",
                readout.time_dilation.map_or_else(none, number),
            ),
            (
                "acceleration felt",
                format!("{} c²/r_s", number(readout.acceleration)),
            ),
            ("", format!("{} g", number(si.acceleration_g))),
            ("tide", format!("{} c²/r_s²", number(readout.tide))),
            ("", format!("{} g per metre", number(si.tide_g_per_metre))),
        ],
    );
    let ahead = readout.ahead.map(|light| {
        [
            (
                "comes from",
                if light.from_disk {
                    "the disk".to_owned()
                } else {
                    "the sky".into()
                },
            ),
            ("shift g", number(light.shift)),
            (
                "of it by gravity",
                light.gravitational_shift.map_or_else(none, number),
            ),
        ]
    });
    let dark = [("comes from", "nowhere: the hole".to_owned())];
    table(
        ui,
        "Light from straight ahead",
        ahead.as_ref().map_or(&dark[..], |rows| &rows[..]),
    );
    table(
        ui,
        "The hole",
        &[
            (
                "shadow's radius",
                format!("{:.4}°", readout.shadow_radius.to_degrees()),
            ),
            ("r_s", format!("{} km", number(mass.metres() / 1000.0))),
            ("r_s / c", format!("{} s", number(mass.seconds()))),
        ],
    );
    clocks(ui, voyage, mass);
}

fn clocks(ui: &mut egui::Ui, voyage: &FreeFall, mass: HoleMass) {
    let Some(worldline) = voyage.worldline() else {
        ui.weak("F lets go: the observer falls or orbits, and her clocks show here.");
        return;
    };
    let both = |time: f64| {
        format!(
            "{} r_s/c = {} s",
            number(time),
            number(time * mass.seconds())
        )
    };
    let far = match worldline.coordinate_time() {
        Some(far) => ("far time", both(far)),
        None => ("ingoing time", both(worldline.ingoing_time())),
    };
    table(
        ui,
        "Clocks since letting go",
        &[("own time", both(worldline.proper_time())), far],
    );
}

fn table(ui: &mut egui::Ui, title: &str, rows: &[(&str, String)]) {
    ui.strong(title);
    egui::Grid::new(title)
        .num_columns(2)
        .min_col_width(130.0)
        .spacing([10.0, 3.0])
        .show(ui, |ui| {
            for (name, value) in rows {
                ui.label(*name);
                ui.monospace(value);
                ui.end_row();
            }
        });
    ui.add_space(8.0);
}

fn choose_mass(ui: &mut egui::Ui, settings: &mut Settings) -> HoleMass {
    let suns = &mut settings.hole_mass_suns;
    ui.horizontal_wrapped(|ui| {
        ui.label("mass");
        for mass in MASSES {
            ui.selectable_value(suns, mass.suns, mass.name);
        }
        let speed = *suns * 0.01;
        let own = egui::DragValue::new(suns)
            .range(HOLE_MASSES[0]..=HOLE_MASSES[1])
            .speed(speed)
            .suffix(" suns");
        ui.add(own.custom_formatter(|suns, _| number(suns)));
    });
    HoleMass {
        name: "chosen",
        suns: *suns,
    }
}

/// A number in six digits.
fn number(x: f64) -> String {
    if x == 0.0 || (1e-3..1e6).contains(&x.abs()) {
        let whole = x.abs().max(1.0).log10().floor() as usize;
        let digits = format!("{x:.*}", 5_usize.saturating_sub(whole));
        return if digits.contains('.') {
            digits.trim_end_matches('0').trim_end_matches('.').into()
        } else {
            digits
        };
    }
    format!("{x:.4e}")
}
