//! The page that says which parts of the picture are exact, statistical, approximate or art.

use crate::app::controls::bindings::Bindings;
use bevy_egui::egui;
use lightfall_core::scene::promises::{
    CLOSED_MAX, CLOSED_SPINNING_P99, MINO_DELAY, STAR_FLUX_SPINNING,
};

/// The exact parts, with the errors that the program promises.
fn exact() -> [String; 8] {
    [
        format!(
            "Where light goes: every pixel of the background is a null geodesic of Schwarzschild or Kerr. Its error is the \
             smallest turn of the pixel's ray that explains the answer. In closed form (closed) the turn is below {CLOSED_MAX:e} \
             rad without spin, a thousandth of a pixel of preset 2 or less. With spin it is within {CLOSED_SPINNING_P99:e} rad for \
             99 of 100 rays, and within some 1e-5 rad for nearly every ray. Some rays exceed these bounds in extreme scenes: \
             around a nearly extremal hole, next to the horizon or inside it, or for an observer nearly as fast as light. The \
             ray inspector measures the error for the pixel that you click."
        ),
        "The shadow's edge, the order of the images, and which rays are captured. The same turn measures their errors.".into(),
        "The shift g of light from the disk and from the sky: gravity, Doppler and aberration together, for any observer.".into(),
        format!(
            "How the disk moves, and when you see it: matter goes round on circular orbits of Schwarzschild or Kerr, the rotation \
             shears what it carries, and each point is seen as it was when its light left. The travel time of this light is \
             accurate to {MINO_DELAY} r_s/c for the place that is found (closed and mino)."
        ),
        "Limb darkening: the flux of each place stays what it is, and is spread over the directions as by an atmosphere that \
         scatters light on electrons (within 0.25 %).".into(),
        "The observer: at rest, with zero angular momentum, in orbit or in free fall, and boosted. Its frame decides what is seen.".into(),
        "Black-body colours: Planck's law and the CIE 1931 observer.".into(),
        format!(
            "The stars: 9096 of the Bright Star Catalogue, at their true places and with their true brightness. Each image is a \
             point with the magnification of its light: right to {STAR_FLUX_SPINNING} for 99 of 100 images, less next to a caustic."
        ),
    ]
}

const STATISTICS: [&str; 2] = [
    "The disk's filaments: a random pattern with the spread, the tilt and the lifetime that simulations of turbulence find. It \
     solves no equation of motion. On average it keeps the flux of every radius. The same seed and time give the same disk.",
    "Stars fainter than V = 6, and the Milky Way: as many stars as are counted, with their colours and their crowding toward \
     the galaxy's plane, but at random places; and the light of a model of the galaxy.",
];

const ART: [&str; 6] = [
    "The contrast and the colours of the Milky Way, and the shapes and the brightness of its nebulae, after photographs.",
    "How the light of a picture of your own is shifted: as that of a black body of its colour.",
    "The disk's brightness, its temperature and the light that it lets through.",
    "The contrast of the filaments, the streaks, and the size and strength of the hot spot.",
    "How fast the disk's clock runs.",
    "Exposure, bloom and the tone curve.",
];

pub(super) fn show(ui: &mut egui::Ui, bindings: &Bindings) {
    let key = |id| bindings.label(id);
    let unfinished = format!(
        "The methods verlet and kerr-schild, kept for comparison, are only as accurate as their steps allow. Some of their rays \
         stay unfinished, which {} shows.",
        key("view.unfinished")
    );
    let approximate = [
        "The disk is infinitely thin, and no light comes from inside the innermost stable orbit.",
        "A ray shows the first two places where it meets the disk. Around a spinning hole there can be a third one, the image of \
         order 2, which is left out.",
        "Each pixel has one ray, and 4, 16 or 64 where an edge passes. Filaments finer than a pixel are averaged over it, which \
         leaves less than half of the error that they would have otherwise.",
        &unfinished,
        "The probe is in front of everything: it is not lensed, and its lamps imitate the disk only roughly.",
        "Flying the camera by hand moves it from place to place; only the ship and a fall move as bodies do. The camera's observer is at rest there, or moves as the scene says.",
    ];
    let cells = format!(
        "The cells, the few tones and the dither pattern; {} removes them.",
        key("picture.bypass")
    );
    let art = [&ART[..], &[&cells, "The probe's design."]].concat();
    list(ui, "Exact, to the error stated", &exact());
    list(ui, "Statistics", &STATISTICS);
    list(ui, "Approximate", &approximate);
    list(ui, "Art", &art);
    let effects = ["lensing", "doppler", "beaming", "gravitational_shift"];
    let keys = effects.map(|effect| bindings.label(&format!("light.{effect}")));
    ui.weak(format!(
        "Effects that are switched off ({}) break the physics on purpose.",
        keys.join(", ")
    ));
}

fn list(ui: &mut egui::Ui, title: &str, items: &[impl AsRef<str>]) {
    ui.strong(title);
    for item in items {
        ui.horizontal_top(|ui| {
            ui.label("•");
            ui.add(egui::Label::new(item.as_ref()).wrap());
        });
    }
    ui.add_space(10.0);
}
