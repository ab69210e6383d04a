//! The page of read-outs: what the observer would measure, in units of the hole and, for a hole of
//! a chosen mass, in SI units.

use crate::app::controls::bindings::Bindings;
use crate::app::motion::free_fall::FreeFall;
use crate::app::state::settings::{HOLE_MASSES, Settings};
use crate::app::ui::help::RADIUS_UNIT;
use crate::app::ui::number::{from_words, in_words};
use bevy_egui::egui;
use lightfall_core::numbers::duration_in_words;
use lightfall_core::optics::disk::inner_period;
use lightfall_core::optics::readout::si::{HoleMass, MASSES};
use lightfall_core::optics::readout::{HotSpotReadout, Readout};
use lightfall_core::scene::{ObserverKind, Scene};
use std::time::Duration;
use web_time::Instant;

/// Time between two read-outs of a moving observer, long enough to read them.
const MIN_AGE: Duration = Duration::from_millis(150);

/// Widths of the names and of the values, in points.
const NAME_WIDTH: f32 = 164.0;
const VALUE_WIDTH: f32 = 212.0;

/// What the page remembers.
#[derive(Default)]
pub(super) struct ReadoutsPage {
    last: Option<(Scene, Instant, Result<Readout, String>)>,
}

impl ReadoutsPage {
    fn readout(&mut self, scene: &Scene) -> &Result<Readout, String> {
        let needed = scene.for_readouts();
        let stale = self
            .last
            .as_ref()
            .is_none_or(|(seen, made, _)| *seen != needed && made.elapsed() > MIN_AGE);
        if stale {
            self.last = None;
        }
        let fresh = || {
            (
                needed,
                Instant::now(),
                Readout::new(scene).map_err(|error| error.to_string()),
            )
        };
        &self.last.get_or_insert_with(fresh).2
    }

    pub(super) fn show(
        &mut self,
        ui: &mut egui::Ui,
        scene: &Scene,
        free_fall: &FreeFall,
        bindings: &Bindings,
        settings: &mut Settings,
    ) {
        let mass = choose_mass(ui, settings);
        ui.separator();
        match self.readout(scene) {
            Ok(readout) => {
                tables(ui, readout, scene.observer.kind, mass);
                if let Some(spot) = &readout.hot_spot {
                    echo(ui, spot, mass);
                }
                clocks(ui, free_fall, bindings, mass);
                disk(ui, scene, mass);
            }
            Err(reason) => {
                ui.colored_label(ui.visuals().error_fg_color, reason);
            }
        }
    }
}

fn tables(ui: &mut egui::Ui, readout: &Readout, kind: ObserverKind, mass: HoleMass) {
    let si = readout.in_si(mass);
    let none = || "not defined here".to_owned();
    let speed =
        |speed: Option<f64>| speed.map_or_else(none, |speed| format!("{} c", in_words(speed)));
    let [theta, phi] = readout.angles_deg;
    table(
        ui,
        "Place",
        &[
            ("Distance", format!("{} r_s", in_words(readout.r))),
            ("", format!("{} km", in_words(si.r_km))),
            ("Above the equator", format!("{:.3}°", 90.0 - theta)),
            ("Around the hole", format!("{phi:.3}°")),
        ],
    );
    let kind = kind.properties().motion_in_full;
    table(
        ui,
        "Observer",
        &[
            ("Motion", kind.into()),
            ("Speed past a hovering one", speed(readout.speed_for_static)),
            (
                "Speed past one of zero angular momentum",
                speed(readout.speed_for_zamo),
            ),
            (
                "Your clock, per far-away second",
                readout.time_dilation.map_or_else(none, in_words),
            ),
            (
                "Acceleration felt",
                format!("{} c²/r_s", in_words(readout.acceleration)),
            ),
            ("", format!("{} g", in_words(si.acceleration_g))),
            ("Tide", format!("{} c²/r_s²", in_words(readout.tide))),
            ("", format!("{} g per metre", in_words(si.tide_g_per_metre))),
        ],
    );
    let ahead = readout.ahead.map(|light| {
        [
            (
                "Comes from",
                if light.from_disk {
                    "the disk".to_owned()
                } else {
                    "the sky".into()
                },
            ),
            ("Shift g", in_words(light.shift)),
            (
                "Part of gravity",
                light.gravitational_shift.map_or_else(none, in_words),
            ),
        ]
    });
    let dark = [(
        "Comes from",
        "none: the shadow lies straight ahead".to_owned(),
    )];
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
                "Radius of the shadow",
                format!("{:.4}°", readout.shadow_radius.to_degrees()),
            ),
            ("r_s", format!("{} km", in_words(mass.metres() / 1000.0))),
            ("r_s / c", format!("{} s", in_words(mass.seconds()))),
        ],
    );
}

/// How long the hot spot takes for a turn, how long the light of its direct image was under way,
/// and by how much the light of each further image is older than that of the one before.
fn echo(ui: &mut egui::Ui, spot: &HotSpotReadout, mass: HoleMass) {
    let both = |time: f64| format!("{} r_s/c = {}", in_words(time), in_minutes(time, mass));
    let known = |time: Option<f64>| time.map_or_else(|| "not known here".into(), both);
    let [direct, once, twice] = spot.delays;
    let later = |first: Option<f64>, second: Option<f64>| {
        known(first.zip(second).map(|(first, second)| second - first))
    };
    table(
        ui,
        "Hot spot and its light echo",
        &[
            ("One turn", both(spot.period)),
            ("Direct light, under way for", known(direct)),
            ("Around the hole, older by", later(direct, once)),
            ("Once more around, older by", later(once, twice)),
        ],
    );
}

/// A time in r_s/c as minutes, or as seconds where it is short.
fn in_minutes(time: f64, mass: HoleMass) -> String {
    let seconds = time * mass.seconds();
    if seconds >= 60.0 {
        format!("{} min", in_words(seconds / 60.0))
    } else {
        format!("{} s", in_words(seconds))
    }
}

fn clocks(ui: &mut egui::Ui, free_fall: &FreeFall, bindings: &Bindings, mass: HoleMass) {
    let Some(worldline) = free_fall.worldline() else {
        ui.weak(format!(
            "{} lets go: the observer falls or orbits, and its clocks appear here.",
            bindings.label("motion.let_go")
        ));
        return;
    };
    let both = |time: f64| {
        format!(
            "{} r_s/c = {} s",
            in_words(time),
            in_words(time * mass.seconds())
        )
    };
    let far = match worldline.coordinate_time() {
        Some(far) => ("Far time", both(far)),
        None => ("Ingoing time", both(worldline.ingoing_time())),
    };
    table(
        ui,
        "Clocks since the observer was let go",
        &[("Own time", both(worldline.proper_time())), far],
    );
}

/// The disk's clock, and how long an orbit at its inner edge takes.
fn disk(ui: &mut egui::Ui, scene: &Scene, mass: HoleMass) {
    if !scene.disk.enabled {
        return;
    }
    let in_seconds = |time: f64| duration_in_words(time * mass.seconds());
    let mut rows = Vec::new();
    if scene.disk_moves() {
        let rate = scene.disk.rate;
        rows.extend([
            (
                "Time at the camera",
                format!("{:.1} r_s/c", scene.disk.time),
            ),
            ("One second here", format!("{} r_s/c", in_words(rate))),
            ("", format!("{} for {}", in_seconds(rate), mass.name)),
        ]);
    }
    if let Some(period) = inner_period(scene) {
        rows.extend([
            (
                "Orbit at the inner edge",
                format!("{} r_s/c", in_words(period)),
            ),
            ("", in_seconds(period)),
        ]);
        if scene.disk_moves() && scene.disk.rate > 0.0 {
            rows.push((
                "On the screen",
                format!("{} s", in_words(period / scene.disk.rate)),
            ));
        }
    }
    table(ui, "The disk", &rows);
}

fn table(ui: &mut egui::Ui, title: &str, rows: &[(&str, String)]) {
    ui.strong(title);
    egui::Grid::new(title)
        .num_columns(2)
        .spacing([10.0, 3.0])
        .show(ui, |ui| {
            for (name, value) in rows {
                let label = cell(ui, NAME_WIDTH, egui::RichText::new(*name));
                if *name == "r_s" {
                    label.on_hover_text(RADIUS_UNIT);
                }
                cell(ui, VALUE_WIDTH, egui::RichText::new(value).monospace());
                ui.end_row();
            }
        });
    ui.add_space(8.0);
}

/// A text of a table, in as many lines as it needs.
fn cell(ui: &mut egui::Ui, width: f32, text: egui::RichText) -> egui::Response {
    ui.vertical(|ui| {
        ui.set_width(width);
        ui.add(egui::Label::new(text).wrap())
    })
    .inner
}

fn choose_mass(ui: &mut egui::Ui, settings: &mut Settings) -> HoleMass {
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
    HoleMass::of_suns(*suns)
}
