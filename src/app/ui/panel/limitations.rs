//! The page that says what is exact, what is approximate and what is art.

use bevy_egui::egui;

const EXACT: [&str; 5] = [
    "Where light goes: every pixel of the background is a null geodesic of Schwarzschild or Kerr. The turn of a \
     pixel's ray that would explain its error is measured. Without spin (closed) it is below 1e-6 rad, a two-thousandth of a \
     pixel. With spin (mino) it is, for 99 of 100 rays, within 6e-6 rad at the default setting, a few thousandths of a pixel, and \
     within 2e-6 at the tightest, quality.max_error_px = 0.0001. The ray inspector measures it for the pixel you click.",
    "The shadow's edge, the order of the images, and which rays are captured.",
    "Shift g of the disk's light and of the sky's: gravity, Doppler and aberration together, for any observer.",
    "The observer: at rest, with zero angular momentum, in orbit, in free fall, boosted; its frame decides what is seen.",
    "Black-body colours: Planck's law through the CIE 1931 observer.",
];

const APPROXIMATE: [&str; 6] = [
    "The disk is infinitely thin, on circular orbits, steady: no turbulence, no light delay, no light of its own inside the \
     innermost stable orbit.",
    "One sample a pixel: rings thinner than a pixel break into dashes.",
    "verlet and kerr-schild, kept for comparison, are as exact as their steps; some of their rays stay unfinished (F11).",
    "The probe is in front of everything: it is not lensed, and its lamps stand for the disk only roughly.",
    "Flying by hand moves the camera from place to place; its observer is at rest there, or moves as the scene says.",
    "Stars are points with a spot a few pixels wide; their magnification by the lens is not followed.",
];

const ART: [&str; 5] = [
    "The disk's brightness, its temperature and the 4 % of light that it lets through.",
    "The stars: they are drawn by lot, not taken from a catalogue.",
    "Exposure, bloom and tone mapping.",
    "The cells, the few tones and the dither pattern (F7 takes them away).",
    "The probe's looks.",
];

pub(super) fn show(ui: &mut egui::Ui) {
    list(ui, "Exact, to the error stated", &EXACT);
    list(ui, "Approximate", &APPROXIMATE);
    list(ui, "Art", &ART);
    ui.weak("Effects that are switched off (L, Z, X, C) break the physics on purpose.");
}

fn list(ui: &mut egui::Ui, title: &str, items: &[&str]) {
    ui.strong(title);
    for item in items {
        ui.horizontal_top(|ui| {
            ui.label("•");
            ui.add(egui::Label::new(*item).wrap());
        });
    }
    ui.add_space(10.0);
}
