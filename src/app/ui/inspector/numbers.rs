//! The numbers of an inspected ray, rounded for reading. A copy of them has all digits.

mod matter;

use bevy_egui::egui;
use lightfall_core::accuracy::inspection::{Difference, Inspected, Inspection};
use lightfall_core::accuracy::rays::Record;
use lightfall_core::numbers::{four_digits, short_number};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::trace::{Hit, Outcome};
use lightfall_core::scene::Scene;

/// The row that says how accurate the picture is at this pixel.
const GPU_ERROR: &str = "GPU error";

/// Angles in radians, and shares of a length, that are rounding and nothing else: a pixel's direction is
/// known to f32's 1.2e-7, and b is the root of a sum in f64, which a radial ray leaves at 1e-8.
const ROUNDING: f64 = 1.2e-7;

/// A number, or 0 where it is nothing but rounding beside a number of this size.
pub(super) fn without_rounding(number: f64, size: f64) -> f64 {
    if number.abs() < ROUNDING * size {
        0.0
    } else {
        number
    }
}

/// An angle by which light is turned, given in radians, in degrees.
pub(super) fn turned_by(radians: f64) -> String {
    format!(
        "{}°",
        four_digits(without_rounding(radians, 1.0).to_degrees())
    )
}

/// A row with a help, because light from the sky sweeps a half-turn even without gravity.
const HALF_TURNS: &str = "half-turns";
const ABOUT_HALF_TURNS: &str = "The angle that the ray sweeps about the hole, in half-turns. The \
    order of the image counts the whole ones. A straight ray that comes from the sky and passes the \
    hole sweeps nearly one, so the direct image of the sky has up to 1.";

/// Rows of names and values.
#[derive(Default)]
struct Rows(Vec<(String, String)>);

impl Rows {
    fn add(&mut self, name: &str, value: Option<String>) {
        self.0.extend(value.map(|value| (name.to_owned(), value)));
    }

    fn show(&self, ui: &mut egui::Ui, id: &str) {
        egui::Grid::new(id)
            .num_columns(2)
            .spacing([10.0, 2.0])
            .striped(true)
            .show(ui, |ui| {
                for (name, value) in &self.0 {
                    let label = ui.label(name);
                    if name == HALF_TURNS {
                        label.on_hover_text(ABOUT_HALF_TURNS);
                    }
                    ui.monospace(value);
                    ui.end_row();
                }
            });
    }
}

/// Shows what the ray shows and where it has been and, unless words are simple, what only specialists
/// ask for.
pub(super) fn show(
    ui: &mut egui::Ui,
    ray: &Inspected,
    scene: &Scene,
    gpu_fault: Option<&str>,
    units: Units,
) {
    light_and_path(ray, scene, units).show(ui, "numbers");
    if !units.are_simple() {
        ui.add_space(6.0);
        ui.strong("For specialists");
        constants_and_errors(ray, scene, gpu_fault).show(ui, "constants and errors");
    }
}

/// What the ray shows and where it has been, as rows of names and values.
pub(super) fn rows(ray: &Inspected, scene: &Scene, units: Units) -> Vec<(String, String)> {
    light_and_path(ray, scene, units).0
}

fn light_and_path(ray: &Inspected, scene: &Scene, units: Units) -> Rows {
    let numbers = &ray.numbers;
    let opaque = scene.disk.transmission == 0.0;
    let cpu = &numbers.cpu;
    let length = |length| units.length(length, four_digits);
    let mut rows = Rows::default();
    match &numbers.matter {
        Some(matter) => matter::add_stretches(&mut rows, matter, cpu, units),
        None => {
            rows.add("shows", Some(outcome(cpu, opaque).into()));
            add_hits(&mut rows, ray, scene, units);
        }
    }
    if let Some(g) = numbers.sky_g {
        let name = format!("sky, {}", shift_in_words(g));
        rows.add(&name, Some(format!("g {}", four_digits(g))));
        rows.add("   beaming g⁴", beaming(scene, g));
    }
    rows.add("deflection", numbers.deflection.map(turned_by));
    let mut turned = format!("{:.3}", numbers.half_turns);
    if let Some(order) = numbers.order {
        turned += &format!(", order {order}");
    }
    rows.add(HALF_TURNS, Some(turned));
    let closest = if cpu.outcome == Outcome::Captured {
        "none: comes from the horizon".into()
    } else {
        length(numbers.closest_r)
    };
    let approach = if opaque && cpu.hit1_r.is_some() {
        "closest, without disk"
    } else {
        "closest approach"
    };
    rows.add(approach, Some(closest));
    rows
}

/// The places where the ray meets a disk without thickness.
fn add_hits(rows: &mut Rows, ray: &Inspected, scene: &Scene, units: Units) {
    let (numbers, trace) = (&ray.numbers, &ray.trace);
    let length = |length| units.length(length, four_digits);
    let temperatures = [numbers.hit1_temperature_k, numbers.hit2_temperature_k];
    let hits = ["first", "second"].into_iter().zip(trace.hits);
    for ((which, hit), temperature) in hits.zip(temperatures) {
        let Some(Hit { r, phi, g, delay }) = hit else {
            continue;
        };
        let place = match units {
            Units::Hole => format!("r {}, phi {:.1}°", length(r), phi.to_degrees()),
            Units::Everyday(_) => format!("{} from the hole", length(r)),
        };
        rows.add(&format!("{which} disk hit"), Some(place));
        let light =
            temperature.map(|t| format!("g {}, {t:.0} K seen as {:.0} K", four_digits(g), g * t));
        rows.add(&format!("   {}", shift_in_words(g)), light);
        rows.add("   beaming g⁴", beaming(scene, g));
        let earlier = |delay| format!("{} earlier", units.time(delay, four_digits));
        rows.add("   emitted", delay.map(earlier));
    }
}

/// The factor of the whole power of light with this shift.
fn beaming(scene: &Scene, g: f64) -> Option<String> {
    let beamed = scene.effects.beaming;
    beamed.then(|| format!("{} times as bright", four_digits(g.powi(4))))
}

fn shift_in_words(g: f64) -> &'static str {
    if g > 1.0 { "blueshift" } else { "redshift" }
}

fn constants_and_errors(ray: &Inspected, scene: &Scene, gpu_fault: Option<&str>) -> Rows {
    let (numbers, trace) = (&ray.numbers, &ray.trace);
    let opaque = scene.disk.transmission == 0.0;
    let mut rows = Rows::default();
    // Inside the horizon the energy at infinity of some light is negative. b, L/E and E have the same
    // sign.
    let impact = if numbers.impact_parameter.is_some_and(|b| b < 0.0) {
        "b, of energy E < 0"
    } else {
        "impact parameter b"
    };
    let r = scene.camera.r;
    let length = |length| measured(without_rounding(length, r), "r_s");
    rows.add(impact, numbers.impact_parameter.map(length));
    rows.add("lambda = L/E", numbers.lambda.map(length));
    // eta is the square of a length.
    let eta = |eta| measured(without_rounding(eta, ROUNDING * r * r), "r_s²");
    rows.add("eta = Q/E²", numbers.eta.map(eta));
    let sky = trace
        .sky
        .map(|sky| format!("{:.3} {:.3} {:.3}", sky.x, sky.y, sky.z));
    rows.add("sky direction", sky);
    if numbers.gpu.is_none() {
        let reason = gpu_fault.unwrap_or("waiting for the GPU");
        rows.add(GPU_ERROR, Some(reason.into()));
    }
    if let Some(difference) = numbers.difference {
        differences(&mut rows, &difference, numbers, opaque);
    }
    if let Some(light) = &numbers.matter {
        matter::add_errors(&mut rows, light);
    }
    rows.add("reference", Some(work(&numbers.cpu)));
    rows.add("GPU", numbers.gpu.as_ref().map(work));
    rows
}

fn differences(rows: &mut Rows, difference: &Difference, numbers: &Inspection, opaque: bool) {
    if !difference.same_class {
        let gpu = numbers.gpu.as_ref();
        rows.add("GPU says", gpu.map(|gpu| outcome(gpu, opaque).into()));
    }
    let backward = difference.backward.zip(difference.backward_px);
    let backward =
        backward.map(|(turn, pixels)| format!("{} rad = {} px", size(turn), short_number(pixels)));
    rows.add(GPU_ERROR, backward);
    let sky = difference.sky.map(|angle| format!("{} rad", size(angle)));
    rows.add("GPU error, sky", sky);
    let hit = difference.hit_r.zip(difference.hit_g);
    let hit = hit.map(|(r, g)| format!("{}, {}", size(r), size(g)));
    rows.add("GPU error, disk r, g", hit);
    let delay = difference
        .hit_t
        .map(|delay| format!("{} r_s/c", size(delay)));
    rows.add("GPU error, emitted", delay);
}

/// A number with its unit.
fn measured(number: f64, unit: &str) -> String {
    format!("{} {unit}", four_digits(number))
}

/// An error with two digits.
fn size(error: f64) -> String {
    if error == 0.0 {
        "0".into()
    } else {
        format!("{error:.1e}")
    }
}

/// The steps of a trace, and its residual. A closed form has neither.
fn work(record: &Record) -> String {
    let steps = match record.steps {
        0 => return "no steps".into(),
        1 => "1 step".into(),
        steps => format!("{steps} steps"),
    };
    format!("{steps}, residual {}", size(record.residual))
}

/// What the ray shows, in words. An opaque disk hides what is behind it.
fn outcome(record: &Record, opaque: bool) -> &'static str {
    match (record.outcome, record.hit1_r) {
        (Outcome::Sky, Some(_)) if opaque => "disk (without it: sky)",
        (Outcome::Captured, Some(_)) if opaque => "disk (without it: the hole)",
        (Outcome::Sky, Some(_)) => "disk, then sky",
        (Outcome::Captured, Some(_)) => "disk, then the hole",
        (Outcome::Captured, None) => "captured by the hole",
        (other, _) => other.word(),
    }
}
