//! What the window says of the ship.

pub(super) use super::mission_words::{End, brief, end, first_keys};

use super::frame::News;
use super::pace::Stop;
use super::ship_flight::{HoldKind, ShipFlight};
use crate::app::controls::bindings::Bindings;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::numbers::{four_digits, percent};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Heading, Hold};
use lightfall_core::scene::mission::Look;

/// Why time runs no faster far from the hole.
const FAR: &str = "You come away: time runs no faster than your distance grows by half in a second";

/// A heading in words.
pub(crate) fn heading_words(heading: Heading) -> &'static str {
    match heading {
        Heading::Prograde => "prograde",
        Heading::Retrograde => "retrograde",
        Heading::Hole => "the hole",
        Heading::Outward => "outward",
        Heading::Star(_) => "a star",
        Heading::Observer(_) => "a direction",
    }
}

/// What the keys that turn the nose say: where it turns to, and the row through which they lead.
pub(super) fn facing(heading: Option<Heading>, ship: &Ship) -> String {
    format!("{}\n{}", turned_to(heading, ship), headings_row(heading))
}

/// Every heading, with the chosen one in brackets.
fn headings_row(chosen: Option<Heading>) -> String {
    let row = [
        "hole",
        "prograde",
        "retrograde",
        "outward",
        "star",
        "gyroscopes",
    ];
    let place = match chosen {
        Some(Heading::Hole) => Some(0),
        Some(Heading::Prograde) => Some(1),
        Some(Heading::Retrograde) => Some(2),
        Some(Heading::Outward) => Some(3),
        Some(Heading::Star(_)) => Some(4),
        // No key leads to a direction on the observer's axes.
        Some(Heading::Observer(_)) => None,
        None => Some(5),
    };
    let mark = |(index, name): (usize, &str)| {
        if Some(index) == place {
            format!("[{name}]")
        } else {
            name.to_owned()
        }
    };
    row.into_iter()
        .enumerate()
        .map(mark)
        .collect::<Vec<_>>()
        .join(" · ")
}

/// What the key that switches the engine off says. The nose followed this heading.
pub(super) fn engine_off(followed: Option<Heading>) -> String {
    match followed {
        None => "Engine off: you fall freely".into(),
        Some(heading) => format!(
            "Engine off: you fall freely. The nose does not follow {} any more: the gyroscopes hold it",
            heading_words(heading)
        ),
    }
}

fn turned_to(heading: Option<Heading>, ship: &Ship) -> String {
    match heading {
        Some(Heading::Star(_)) => "Nose: to the star ahead".into(),
        Some(heading) if heading.direction(ship).is_none() => format!(
            "Nose: {}, but the ship stands still",
            heading_words(heading)
        ),
        Some(Heading::Prograde) => "Nose: prograde, along your motion".into(),
        Some(Heading::Retrograde) => "Nose: retrograde, against your motion".into(),
        Some(Heading::Hole) => "Nose: to the hole".into(),
        Some(heading) => format!("Nose: {}", heading_words(heading)),
        None => "Nose: held by the gyroscopes".into(),
    }
}

/// What the key that turns the pilot's head says.
pub(super) fn looking(look: Look, bindings: &Bindings) -> String {
    let key = bindings.first_label("scene.spin");
    match look {
        Look::Hole => {
            format!("You look at the hole; the nose stays where it points ({key}: ahead)")
        }
        Look::Nose => format!("You look along the nose ({key}: at the hole)"),
    }
}

/// What a key of a hold says where the engine cannot push.
pub(super) fn no_thrust(ship: &ShipFlight) -> &'static str {
    if ship.is_empty() {
        "The tank is empty: nothing can hold the ship"
    } else {
        "The ship has no engine: nothing can hold it"
    }
}

/// What a thrust key says while the flight is paused.
pub(super) fn paused_push(bindings: &Bindings) -> String {
    let pause = bindings.label("motion.pause");
    format!("Paused: the engine waits until {pause} goes on")
}

/// What a thrust key says where the engine cannot push, with what still works.
pub(super) fn no_push(ship: &ShipFlight, bindings: &Bindings) -> String {
    let why = if ship.is_empty() {
        "The tank is empty: nothing pushes the ship. You can turn, and {fly.face} keeps a heading;"
    } else {
        "The ship has no engine: nothing pushes it."
    };
    let back = if ship.attempt().is_some() {
        "{scene.undo} goes back, {journey.again} begins again"
    } else {
        "{scene.undo} goes back to where you took the ship"
    };
    bindings.with_keys(&format!(
        "{why} {{motion.slower}} and {{motion.faster}} change time; {back}"
    ))
}

/// What a key of a hold says after it has begun, with the fuel that it takes, or ended. In an orbit the hole
/// drifts out of view, so the key that looks at it is named there.
pub(super) fn holding(
    ship: &ShipFlight,
    kind: HoldKind,
    units: Units,
    bindings: &Bindings,
) -> String {
    let at = |r: f64| units.length(r, four_digits);
    let takes = ship.hold_takes().map_or_else(String::new, |[takes, left]| {
        let lacks = if takes > left { ": too little" } else { "" };
        let [takes, left] = [takes, left].map(percent);
        match ship.hold() {
            // The change to an orbit is all that it takes; standing still takes more each moment.
            Some(Hold::Hover(_)) => format!(
                " (stopping takes {takes} of a full tank, and holding more; fuel {left}{lacks})"
            ),
            _ => format!(" (takes {takes} of a full tank; fuel {left}{lacks})"),
        }
    });
    let key = bindings.first_label("scene.spin");
    let look = match ship.look() {
        Look::Nose if !key.is_empty() => format!("; {key} looks at the hole"),
        Look::Nose | Look::Hole => String::new(),
    };
    match ship.hold() {
        Some(Hold::Orbit(r)) => format!("Holds the orbit at {}{takes}{look}", at(r)),
        Some(Hold::Hover(r)) => format!("Holds still at {}{takes}", at(r)),
        Some(Hold::Zamo(r)) => format!(
            "Holds the radius {}: nothing stands still in the ergosphere",
            at(r)
        ),
        None if kind == HoldKind::Orbit => "The orbit is not held any more".into(),
        None => "The place is not held any more".into(),
    }
}

/// What taking the controls says.
pub(super) fn boarded(bindings: &Bindings) -> String {
    let key = |id| bindings.first_label(id);
    let [forward, orbit, look, still, off, leave] = [
        "fly.forward",
        "fly.orbit",
        "scene.spin",
        "scene.observer",
        "motion.let_go",
        "ship.fly",
    ]
    .map(key);
    format!(
        "You fly the ship: {forward} pushes, {orbit} holds the orbit, {look} looks at the hole, {still} holds still, {off} stops the engine; {leave} leaves it"
    )
}

/// How fast the ship's time passes.
pub(super) fn pace(ship: &ShipFlight, units: Units) -> String {
    let rate = units.time(ship.rate(), four_digits);
    let pace = multiple(ship.pace());
    if ship.is_far() {
        return format!("{FAR}, {rate} in it");
    }
    format!("Time: {pace} × the usual pace, {rate} a second")
}

/// A multiple of the usual pace, which is a power of two.
pub(crate) fn multiple(pace: f64) -> String {
    if pace < 1.0 {
        format!("1/{:.0}", 1.0 / pace)
    } else {
        format!("{pace:.0}")
    }
}

/// What has happened in a frame.
pub(super) fn news(news: News, ship: &ShipFlight, bindings: &Bindings) -> String {
    let faster = bindings.first_label("motion.faster");
    let passes = if faster.is_empty() {
        String::new()
    } else {
        format!(" ({faster} passes the next ones)")
    };
    match news {
        News::Refused(refusal) => format!("The engine is off: {refusal}"),
        News::Far => FAR.into(),
        News::LittleFuel => "Fuel: less than 20 % is left".into(),
        News::Empty => "The tank is empty".into(),
        News::NoPush => no_push(ship, bindings),
        News::Slowed(Stop::Low) => format!("The lowest point: time runs as usual{passes}"),
        News::Slowed(Stop::High) => format!("The highest point: time runs as usual{passes}"),
        News::Slowed(Stop::Goal) => "The goal's radius: time runs as usual".into(),
        News::Slowed(Stop::Horizon) => "Near the horizon: time runs as usual".into(),
    }
}

/// Where and when the flight has ended, for the end card.
pub(super) fn ending(ship: &ShipFlight, units: Units) -> String {
    let Some(voyage) = ship.voyage() else {
        return String::new();
    };
    let ship = &voyage.flight.ship;
    let r = units.length(ship.place().r, four_digits);
    let clock = units.time(ship.proper_time(), four_digits);
    if ship.place().r > ship.kerr().horizon() {
        return format!(
            "You are {r} from the hole, and your clock says {clock}. The ship flies no farther."
        );
    }
    format!(
        "You are {r} from the centre, inside the horizon. Your clock says {clock}. Deeper in, blueshift grows without limit, and no picture would be true."
    )
}
