//! The numbers of an inspected ray, in few enough digits to read. Copying gives all digits.

use super::ray_worker::GpuState;
use crate::app::ui::number::six_digits;
use bevy_egui::egui;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::reports::inspection::{Difference, Inspection, Record};

/// The row that answers how true the picture is at this pixel.
const OFF_BY: &str = "GPU's ray is off by";

pub(super) fn show(ui: &mut egui::Ui, numbers: &Inspection, gpu: &GpuState) {
    egui::Grid::new("numbers")
        .num_columns(2)
        .spacing([10.0, 2.0])
        .striped(true)
        .show(ui, |ui| {
            let mut row = |name: &str, value: Option<String>| {
                if let Some(value) = value {
                    ui.label(name);
                    ui.monospace(value);
                    ui.end_row();
                }
            };
            let cpu = &numbers.cpu;
            row("outcome", Some(outcome(cpu).into()));
            // How true the picture is comes first.
            match gpu {
                GpuState::Waiting => row(OFF_BY, Some("waiting for the GPU".into())),
                GpuState::Failed(reason) => row(OFF_BY, Some(reason.clone())),
                GpuState::Done => {}
            }
            if let Some(difference) = numbers.difference {
                differences(&mut row, &difference, numbers);
            }
            row(
                "order of the image",
                numbers.order.map(|order| order.to_string()),
            );
            row("half-turns", Some(format!("{:.4}", numbers.half_turns)));
            row(
                "closest r",
                Some(format!("{} r_s", six_digits(numbers.closest_r))),
            );
            // Inside the horizon the energy at infinity of some light is negative. b, L/E and E have
            // the same sign.
            let backward = numbers.impact_parameter.is_some_and(|b| b < 0.0);
            row(
                if backward {
                    "b, of energy E < 0"
                } else {
                    "impact parameter b"
                },
                numbers
                    .impact_parameter
                    .map(|b| format!("{} r_s", six_digits(b))),
            );
            row(
                "lambda = L/E",
                numbers
                    .lambda
                    .map(|lambda| format!("{} r_s", six_digits(lambda))),
            );
            row(
                "eta = Q/E²",
                numbers.eta.map(|eta| format!("{} r_s²", six_digits(eta))),
            );
            let sky = [cpu.sky_x, cpu.sky_y, cpu.sky_z]
                .into_iter()
                .collect::<Option<Vec<_>>>();
            row(
                "sky direction",
                sky.map(|sky| {
                    sky.iter()
                        .map(|x| format!("{x:.4}"))
                        .collect::<Vec<_>>()
                        .join(" ")
                }),
            );
            let hits = [
                (
                    "1st",
                    cpu.hit1_r,
                    cpu.hit1_phi,
                    cpu.hit1_g,
                    numbers.hit1_temperature_k,
                    numbers.hit1_delay,
                ),
                (
                    "2nd",
                    cpu.hit2_r,
                    cpu.hit2_phi,
                    cpu.hit2_g,
                    numbers.hit2_temperature_k,
                    numbers.hit2_delay,
                ),
            ];
            for (which, r, phi, g, temperature, delay) in hits {
                let place = r.zip(phi).map(|(r, phi)| {
                    format!("r {} r_s, phi {:.2}°", six_digits(r), phi.to_degrees())
                });
                row(&format!("{which} disk hit"), place);
                let light = g
                    .zip(temperature)
                    .map(|(g, t)| format!("g {}, {t:.0} K to {:.0} K", six_digits(g), g * t));
                row("   its light", light);
                row(
                    "   emitted before",
                    delay.map(|delay| format!("{} r_s/c", six_digits(delay))),
                );
            }
            row(
                "reference",
                Some(format!(
                    "{} steps, residual {:.1e}",
                    cpu.steps, cpu.residual
                )),
            );
            let answer = numbers
                .gpu
                .as_ref()
                .map(|gpu| format!("{} steps, residual {:.1e}", gpu.steps, gpu.residual));
            row("GPU", answer);
        });
}

fn differences(
    row: &mut impl FnMut(&str, Option<String>),
    difference: &Difference,
    numbers: &Inspection,
) {
    if !difference.same_class {
        row(
            "GPU says",
            numbers.gpu.as_ref().map(|gpu| outcome(gpu).into()),
        );
    }
    let backward = difference.backward.zip(difference.backward_px);
    row(
        OFF_BY,
        backward.map(|(turn, pixels)| format!("{turn:.1e} rad = {pixels:.1e} px")),
    );
    row(
        "GPU off in the sky",
        difference.sky.map(|angle| format!("{angle:.1e} rad")),
    );
    row(
        "GPU off in hit r, g",
        difference
            .hit_r
            .zip(difference.hit_g)
            .map(|(r, g)| format!("{r:.1e}, {g:.1e}")),
    );
}

/// What the ray shows, in words.
fn outcome(record: &Record) -> &'static str {
    match (record.outcome, record.hit1_r) {
        (Outcome::Sky, Some(_)) => "disk, then sky",
        (Outcome::Captured, Some(_)) => "disk, then the hole",
        (Outcome::Captured, None) => "captured by the hole",
        (other, _) => other.word(),
    }
}
