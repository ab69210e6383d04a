//! The page of read-outs: what the observer would measure, in units of the hole and, for a chosen
//! mass, in SI units.

use super::flight_readouts;
use super::mass_choice::choose_mass;
use crate::app::controls::bindings::Bindings;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::ship::ShipFlight;
use crate::app::state::settings::Settings;
use crate::app::ui::help::RADIUS_UNIT;
use bevy_egui::egui;
use lightfall_core::numbers::{duration_in_words, in_words};
use lightfall_core::optics::disk::inner_period;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::readout::{HotSpotReadout, Readout};
use lightfall_core::scene::{ObserverKind, Scene};
use std::time::Duration;
use web_time::Instant;

/// Minimum time between two read-outs of a moving observer, long enough to read them.
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
    /// The read-out of a scene, or the last one if it is not old enough to be replaced.
    fn readout(&mut self, scene: &Scene) -> &Result<Readout, String> {
        let needed = scene.for_readouts();
        self.last
            .take_if(|(seen, made, _)| *seen != needed && made.elapsed() > MIN_AGE);
        let (_, _, readout) = self.last.get_or_insert_with(|| {
            let readout = Readout::new(scene).map_err(|error| error.to_string());
            (needed, Instant::now(), readout)
        });
        readout
    }

    pub(super) fn show(
        &mut self,
        ui: &mut egui::Ui,
        scene: &Scene,
        (free_fall, ship): (&FreeFall, &ShipFlight),
        bindings: &Bindings,
        settings: &mut Settings,
    ) {
        if ship.mass().is_some() {
            ui.weak("The hole has the mission's mass.");
        } else {
            choose_mass(ui, settings);
        }
        let (mass, units) = (ship.hole_mass(settings), ship.units(settings));
        ui.separator();
        if let Some(voyage) = ship.voyage() {
            flight_readouts::show(ui, &voyage.flight.ship, (mass, units));
        }
        match self.readout(scene) {
            Ok(readout) => {
                tables(ui, readout, scene.observer.kind, (mass, units));
                if let Some(spot) = &readout.hot_spot {
                    echo(ui, spot, (mass, units));
                }
                if !ship.is_flown() {
                    clocks(ui, free_fall, bindings, (mass, units));
                }
                disk(ui, scene, (mass, units));
            }
            Err(reason) => {
                ui.colored_label(ui.visuals().error_fg_color, reason);
            }
        }
    }
}

/// A number with its unit.
fn measured(number: f64, unit: &str) -> String {
    format!("{} {unit}", in_words(number))
}

fn tables(
    ui: &mut egui::Ui,
    readout: &Readout,
    kind: ObserverKind,
    (mass, units): (HoleMass, Units),
) {
    let si = readout.in_si(mass);
    let none = || "not defined here".to_owned();
    let speed = |speed: Option<f64>| speed.map_or_else(none, |speed| measured(speed, "c"));
    let [theta, phi] = readout.angles_deg;
    let pair = |name, own: String, everyday: String| {
        let rows = [
            own_units(name, own, units),
            Some((name_beside(name, units), everyday)),
        ];
        rows.into_iter().flatten()
    };
    let mut place: Vec<_> = pair(
        "Distance",
        measured(readout.r, "r_s"),
        measured(si.r_km, "km"),
    )
    .collect();
    place.push(("Above the equator", format!("{:.3}°", 90.0 - theta)));
    place.push(("Around the hole", format!("{phi:.3}°")));
    table(ui, "Place", &place);
    let past_zamo = "Speed past one of zero angular momentum";
    let clock = readout.time_dilation.map_or_else(none, in_words);
    let mut observer = vec![
        ("Motion", kind.properties().motion_in_full.into()),
        ("Speed past a hovering one", speed(readout.speed_for_static)),
    ];
    observer.extend(own_units(past_zamo, speed(readout.speed_for_zamo), units));
    observer.push(("Your clock, per far-away second", clock));
    observer.extend(pair(
        "Acceleration felt",
        measured(readout.acceleration, "c²/r_s"),
        measured(si.acceleration_g, "g"),
    ));
    observer.extend(pair(
        "Tide",
        measured(readout.tide, "c²/r_s²"),
        measured(si.tide_g_per_metre, "g per metre"),
    ));
    table(ui, "Observer", &observer);
    let ahead = match readout.ahead {
        Some(light) => {
            let from = if light.from_disk {
                "the disk"
            } else {
                "the sky"
            };
            let gravity = light.gravitational_shift.map_or_else(none, in_words);
            vec![
                ("Comes from", from.to_owned()),
                ("Shift g", in_words(light.shift)),
                ("Part of gravity", gravity),
            ]
        }
        None => vec![("Comes from", "none: the shadow lies straight ahead".into())],
    };
    table(ui, "Light from straight ahead", &ahead);
    let shadow = readout.shadow_radius.to_degrees();
    table(
        ui,
        "The hole",
        &[
            ("Radius of the shadow", format!("{shadow:.4}°")),
            ("r_s", measured(mass.metres() / 1000.0, "km")),
            ("r_s / c", measured(mass.seconds(), "s")),
        ],
    );
}

/// The period of the hot spot's orbit, the travel time of the light of its direct image, and the delay
/// of each further image after the one before.
fn echo(ui: &mut egui::Ui, spot: &HotSpotReadout, (mass, units): (HoleMass, Units)) {
    let both = |time: f64| match units {
        Units::Hole => format!("{} = {}", measured(time, "r_s/c"), in_minutes(time, mass)),
        Units::Everyday(_) => in_minutes(time, mass),
    };
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

/// A time in r_s/c as minutes, or as seconds if it is short.
fn in_minutes(time: f64, mass: HoleMass) -> String {
    let seconds = time * mass.seconds();
    if seconds >= 60.0 {
        measured(seconds / 60.0, "min")
    } else {
        measured(seconds, "s")
    }
}

fn clocks(
    ui: &mut egui::Ui,
    free_fall: &FreeFall,
    bindings: &Bindings,
    (mass, units): (HoleMass, Units),
) {
    let Some(worldline) = free_fall.worldline() else {
        ui.weak(format!(
            "{} lets go: the observer falls or orbits, and its clocks appear here.",
            bindings.label("motion.let_go")
        ));
        return;
    };
    let both = |time: f64| clock(time, (mass, units));
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

/// What a clock shows, in units of the hole and in seconds.
pub(super) fn clock(time: f64, (mass, units): (HoleMass, Units)) -> String {
    let seconds = measured(time * mass.seconds(), "s");
    match units {
        Units::Hole => format!("{} = {seconds}", measured(time, "r_s/c")),
        Units::Everyday(_) => units.time(time, in_words),
    }
}

/// The disk's clock, and the period of an orbit at its inner edge.
fn disk(ui: &mut egui::Ui, scene: &Scene, (mass, units): (HoleMass, Units)) {
    if !scene.disk.enabled {
        return;
    }
    let in_seconds = |time: f64| duration_in_words(time * mass.seconds());
    let (time, rate) = (scene.disk.time, scene.disk.rate);
    let (own, beside) = (
        |name, value| own_units(name, value, units),
        |name| name_beside(name, units),
    );
    let mut rows = Vec::new();
    if scene.disk_moves() {
        let time = units.time(time, |time| format!("{time:.1}"));
        rows.push(("Time at the camera", time));
        rows.extend(own("One second here", measured(rate, "r_s/c")));
        rows.push((
            beside("One second here"),
            format!("{} for {}", in_seconds(rate), mass.name),
        ));
    }
    if let Some(period) = inner_period(scene) {
        rows.extend(own("Orbit at the inner edge", measured(period, "r_s/c")));
        rows.push((beside("Orbit at the inner edge"), in_seconds(period)));
        if scene.disk_moves() && rate > 0.0 {
            rows.push(("On the screen", measured(period / rate, "s")));
        }
    }
    table(ui, "The disk", &rows);
}

/// The row with a quantity in the hole's units. None where words are simple.
fn own_units(name: &'static str, value: String, units: Units) -> Option<(&'static str, String)> {
    (!units.are_simple()).then_some((name, value))
}

/// The name of the row with the same quantity in everyday units, which follows [`own_units`].
fn name_beside(name: &'static str, units: Units) -> &'static str {
    if units.are_simple() { name } else { "" }
}

pub(super) fn table(ui: &mut egui::Ui, title: &str, rows: &[(&str, String)]) {
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

/// A text in a table, wrapped at this width.
fn cell(ui: &mut egui::Ui, width: f32, text: egui::RichText) -> egui::Response {
    ui.vertical(|ui| {
        ui.set_width(width);
        ui.add(egui::Label::new(text).wrap())
    })
    .inner
}
