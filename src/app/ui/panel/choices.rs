//! The words of enumerations on the panel: what each choice is called, and what it means.

/// Whether the panel offers a choice. The reference cannot draw a picture.
#[must_use]
pub(super) fn is_offered(key: &str, word: &str) -> bool {
    (key, word) != ("method", "reference")
}

/// What a choice of a field is called, and what it means in one line. A choice without an entry is
/// called by its word in a preset.
#[must_use]
pub fn choice(key: &str, word: &'static str) -> [&'static str; 2] {
    match (key, word) {
        ("method", "auto") => [
            "Best for this scene (auto)",
            "The closed form, with or without spin",
        ],
        ("method", "verlet") => [
            "Verlet steps (verlet)",
            "Small steps in space, without spin; the article's method",
        ],
        ("method", "closed") => [
            "Closed form (closed)",
            "Elliptic functions, with or without spin; no steps, and nothing to set",
        ],
        ("method", "mino") => [
            "Mino time (mino)",
            "Steps in Mino time, with or without spin; the independent second method",
        ],
        ("method", "kerr-schild") => [
            "Kerr-Schild steps (kerr-schild)",
            "Runge-Kutta steps in ingoing coordinates, for comparison",
        ],
        ("method", "reference") => [
            "Reference (reference)",
            "In double precision on the processor; it draws no picture",
        ],
        ("view", "colour") => ["Light", "What the camera sees"],
        ("view", "unfinished") => [
            "Light, unfinished marked",
            "Rays that ran out of steps are magenta",
        ],
        ("view", "classes") => [
            "Fate of each ray",
            "Sky, hole or disk, and how often the ray crosses the disk",
        ],
        ("view", "residual") => ["Residual", "How far each ray strays from being light-like"],
        ("view", "order") => ["Order of the image", "Half-turns of the ray about the hole"],
        ("view", "delay") => [
            "Delay of the light",
            "How long the light of the disk was under way",
        ],
        ("view", "redshift") => ["Redshift", "Observed over emitted frequency"],
        ("view", "error") => ["Error", "Difference from the reference, in pixels"],
        ("view", "steps") => ["Steps", "How many steps each ray takes"],
        ("observer.kind", "static") => [
            "At rest",
            "Hovers at one place; not possible very near a spinning hole",
        ],
        ("observer.kind", "zamo") => [
            "Zero angular momentum",
            "Hovers at one distance, and is carried round by the hole's spin",
        ],
        ("observer.kind", "orbit") => ["Circular orbit", "Circles freely in the plane of the disk"],
        ("observer.kind", "rain") => [
            "Free fall",
            "Falls freely from far away; the only one inside the horizon",
        ],
        ("disk.model", "newtonian") => ["Newtonian", "The thin disk of Newtonian gravity"],
        ("disk.model", "page-thorne") => [
            "Relativistic",
            "The thin disk around a spinning hole, after Page and Thorne 1974",
        ],
        ("disk.structure", "none") => ["None", "A smooth disk, on which nothing moves"],
        ("disk.structure", "turbulent") => [
            "Turbulent",
            "Filaments that the rotation shears into trailing spirals",
        ],
        ("disk.structure", "streaks") => [
            "Streaks",
            "Longer filaments with more contrast, as in films",
        ],
        ("disk.limb", "none") => ["None", "As bright from the side as from above"],
        ("disk.limb", "electron-scattering") => [
            "Scattering",
            "Darker from the side, as light scattered on electrons is; Chandrasekhar 1960",
        ],
        ("hot_spot.kind", "none") => ["None", "No hot spot"],
        ("hot_spot.kind", "rigid") => [
            "Keeps its shape",
            "All of it goes round as fast as its middle",
        ],
        ("hot_spot.kind", "sheared") => ["Sheared", "The rotation draws it out into an arc"],
        ("picture.tone_curve", "neutral") => ["Neutral", "Exact colours, and a short way to white"],
        ("picture.tone_curve", "soft") => ["Soft", "A long way to white, on which colours fade"],
        ("picture.tone_curve", "aces") => ["ACES", "Film-like: more contrast, and hues that turn"],
        ("picture.tone_curve", "reinhard") => ["Reinhard", "Colours never fade to white"],
        ("sky.mode", "stars") => ["Stars", "The stars and the Milky Way as seen from Earth"],
        ("sky.mode", "procedural") => [
            "Article's stars",
            "Stars at random places, stretched by the bending",
        ],
        ("sky.mode", "grid") => ["Grid", "Lines of celestial latitude and longitude"],
        ("sky.mode", "off") => ["None", "A black sky"],
        _ => [word, ""],
    }
}
