//! From the text of a mission to the mission.

use super::error::{Fault, MissionError};
use super::keys::check_keys;
use super::text::{BurnText, HoleOfMission, Start, Text};
use super::{Burn, Face, Mission, Push, Until};
use crate::scene::Override;
use crate::scene::error::{SceneError, SceneFault};
use crate::scene::from_toml::table;
use crate::scene::presets;
use crate::scene::range::number;
use crate::scene::toml_fault::TomlFault;

/// Largest number of characters of a line of text, such as a title.
const MAX_LINE: usize = 120;
/// Largest number of characters of a longer text.
const MAX_TEXT: usize = 400;

const NOT_NEGATIVE: &str = "a finite number, not negative";
const POSITIVE: &str = "a finite number above 0";

/// Makes a mission of its TOML `text`. `origin` names it in messages.
///
/// # Errors
/// One sentence that names the file, the line or the key, what was given and what is allowed.
pub fn load(origin: &str, text: &str) -> Result<Mission, MissionError> {
    read(text).map_err(|fault| MissionError::new(origin, text, fault))
}

fn read(text: &str) -> Result<Mission, Fault> {
    table(text)?;
    let written: Text = toml::from_str(text).map_err(|error| toml_fault(text, &error))?;
    check_texts(&written)?;
    check_numbers(&written)?;
    check_keys(written.keys.as_deref().unwrap_or_default())?;
    if written.goal.is_empty() {
        return Err(Fault::NoGoal);
    }
    let goals = written.goal.iter().map(|goal| ("goal", &goal.all));
    let fails = written.fail.iter().map(|fail| ("fail", &fail.all));
    for (index, (table, conditions)) in goals.enumerate().chain(fails.enumerate()) {
        if conditions.is_empty() {
            let number = index + 1;
            return Err(Fault::NoCondition { table, number });
        }
    }
    let preset = presets::find(&written.preset).ok_or_else(|| Fault::Preset {
        given: written.preset.clone(),
    })?;
    let scene = preset
        .scene(&start_overrides(&written.hole, &written.start))
        .map_err(Fault::Start)?;
    let solution = written.solution.into_iter().enumerate();
    Ok(Mission {
        name: written.name,
        title: written.title,
        preset,
        hole: written.hole,
        ship: written.ship,
        start: written.start,
        brief: written.brief,
        teaches: written.teaches,
        keys: written.keys,
        goals: written.goal,
        fails: written.fail,
        captions: written.caption,
        hints: written.hint,
        questions: written.question,
        pars: written.par,
        ending: written.ending,
        solution: solution
            .map(|(index, burn)| read_burn(index + 1, burn))
            .collect::<Result<_, _>>()?,
        scene,
    })
}

fn toml_fault(text: &str, error: &toml::de::Error) -> Fault {
    SceneFault::from(TomlFault::new(text, error)).into()
}

/// What a mission sets in its preset: its hole and its observer, which faces the hole.
fn start_overrides(hole: &HoleOfMission, start: &Start) -> [Override; 9] {
    let [x, y, z] = start.velocity;
    [
        ("hole.spin", number(hole.spin)),
        ("camera.r", number(start.r)),
        ("camera.theta_deg", number(start.theta_deg)),
        ("camera.phi_deg", number(start.phi_deg)),
        ("camera.yaw_deg", "0".into()),
        ("camera.pitch_deg", "0".into()),
        ("camera.roll_deg", "0".into()),
        ("observer.kind", start.observer.word().into()),
        ("observer.velocity", format!("[{x:?}, {y:?}, {z:?}]")),
    ]
    .map(|(key, value)| Override::new("start", key, &value))
}

impl Mission {
    /// The mission with other fields of its scene, such as those of the picture.
    ///
    /// # Errors
    /// A field that the mission itself sets, or a value that the scene cannot have.
    pub fn with(mut self, overrides: &[Override]) -> Result<Self, SceneError> {
        if overrides.is_empty() {
            return Ok(self);
        }
        let own = start_overrides(&self.hole, &self.start);
        let is_own = |given: &&Override| own.iter().any(|own| own.key == given.key);
        if let Some(Override { option, key, .. }) = overrides.iter().find(is_own) {
            let (key, title) = (key.clone(), self.title);
            return Err(SceneError::new(
                option,
                SceneFault::SetByMission { key, title },
            ));
        }
        self.scene = self.preset.scene(&[&own, overrides].concat())?;
        Ok(self)
    }
}

fn check_texts(written: &Text) -> Result<(), Fault> {
    let name = &written.name;
    let is_name = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if name.is_empty() || name.len() > MAX_LINE || !name.chars().all(is_name) {
        return Err(Fault::Line {
            key: "name".into(),
            given: name.clone(),
            allowed: "small letters, digits and hyphens, at most 120",
        });
    }
    let line = |key: String, text: &String, most: usize, allowed| {
        let is_line = !text.trim().is_empty()
            && text.chars().count() <= most
            && !text.chars().any(char::is_control);
        is_line.then_some(()).ok_or_else(|| Fault::Line {
            key,
            given: text.chars().take(MAX_LINE).collect(),
            allowed,
        })
    };
    const SHORT: &str = "one line of at most 120 characters";
    const LONG: &str = "one line of at most 400 characters";
    line("title".into(), &written.title, MAX_LINE, SHORT)?;
    line("brief".into(), &written.brief, MAX_TEXT, LONG)?;
    if !written.teaches.is_empty() {
        line("teaches".into(), &written.teaches, MAX_TEXT, LONG)?;
    }
    line(
        "ending.success".into(),
        &written.ending.success,
        MAX_TEXT,
        LONG,
    )?;
    line(
        "ending.failure".into(),
        &written.ending.failure,
        MAX_TEXT,
        LONG,
    )?;
    let texts = [
        (
            "goal",
            written
                .goal
                .iter()
                .map(|goal| &goal.text)
                .collect::<Vec<_>>(),
        ),
        ("fail", written.fail.iter().map(|fail| &fail.text).collect()),
        (
            "caption",
            written
                .caption
                .iter()
                .map(|caption| &caption.text)
                .collect(),
        ),
        ("hint", written.hint.iter().map(|hint| &hint.text).collect()),
        (
            "question",
            written
                .question
                .iter()
                .map(|question| &question.text)
                .collect(),
        ),
    ];
    for (table, texts) in texts {
        for (index, text) in texts.into_iter().enumerate() {
            line(format!("{table} {}: text", index + 1), text, MAX_TEXT, LONG)?;
        }
    }
    Ok(())
}

fn check_numbers(written: &Text) -> Result<(), Fault> {
    let at_least = |key: String, value: f64| check(key, value, value >= 0.0, NOT_NEGATIVE);
    at_least("ship.rapidity".into(), written.ship.rapidity)?;
    at_least("ship.acceleration".into(), written.ship.acceleration)?;
    let exhaust = written.ship.exhaust;
    let is_exhaust = exhaust > 0.0 && exhaust <= 1.0;
    check(
        "ship.exhaust".into(),
        exhaust,
        is_exhaust,
        "above 0 and at most 1",
    )?;
    if let Some([theta, phi]) = written.start.star_deg {
        let is_polar = (0.0..=180.0).contains(&theta);
        let allowed = "from 0 to 180 degrees";
        check("start.star_deg: theta".into(), theta, is_polar, allowed)?;
        check("start.star_deg: phi".into(), phi, true, "a finite number")?;
        if written.start.face != Face::Star {
            return Err(Fault::Star {
                face: written.start.face.word(),
            });
        }
    }
    let suns = written.hole.mass_suns;
    check("hole.mass_suns".into(), suns, suns > 0.0, POSITIVE)?;
    for (index, goal) in written.goal.iter().enumerate() {
        at_least(format!("goal {}: hold", index + 1), goal.hold)?;
    }
    for (index, question) in written.question.iter().enumerate() {
        let key = |name| format!("question {}: {name}", index + 1);
        check(key("answer"), question.answer, true, "a finite number")?;
        let tolerance = question.tolerance;
        check(key("tolerance"), tolerance, tolerance > 0.0, POSITIVE)?;
    }
    for (index, par) in written.par.iter().enumerate() {
        check(
            format!("par {}: value", index + 1),
            par.value,
            true,
            "a finite number",
        )?;
    }
    Ok(())
}

fn check(key: String, value: f64, is_allowed: bool, allowed: &'static str) -> Result<(), Fault> {
    (is_allowed && value.is_finite())
        .then_some(())
        .ok_or_else(|| {
            let given = number(value);
            Fault::Number {
                key,
                given,
                allowed,
            }
        })
}

fn read_burn(place: usize, burn: BurnText) -> Result<Burn, Fault> {
    let coast = burn.coast.filter(|coast| *coast).map(|_| Push::Off);
    let pushes = [
        burn.thrust,
        coast,
        burn.hover.map(Push::Hover),
        burn.orbit.map(Push::Orbit),
    ];
    let push = only(place, pushes, "thrust, coast = true, hover and orbit")?;
    let passed = burn.duration.map(Until::Passed);
    let until = only(
        place,
        [burn.until.map(|until| until.0), passed],
        "until and for",
    )?;
    let acceleration = match (push, burn.a) {
        (Push::Off, None) => 0.0,
        (Push::Off, Some(_)) => {
            return Err(Fault::Choice {
                number: place,
                found: "both".into(),
                needed: "coast = true and a",
            });
        }
        (_, given) => given.unwrap_or(f64::NAN),
    };
    let key = |name| format!("solution {place}: {name}");
    check(key("a"), acceleration, acceleration >= 0.0, NOT_NEGATIVE)?;
    if let Until::Passed(time) = until {
        check(key("for"), time, time > 0.0, POSITIVE)?;
    }
    match push {
        Push::Hover(r) => check(key("hover"), r, r > 0.0, POSITIVE)?,
        Push::Orbit(r) => check(key("orbit"), r, r > 0.0, POSITIVE)?,
        Push::Axes(axes) => {
            let length = axes.iter().map(|x| x * x).sum::<f64>().sqrt();
            check(key("length of thrust"), length, length > 0.0, POSITIVE)?;
        }
        Push::Along(_) | Push::Off => {}
    }
    Ok(Burn {
        push,
        acceleration,
        until,
    })
}

/// The only one of these that is given.
fn only<T, const N: usize>(
    number: usize,
    given: [Option<T>; N],
    needed: &'static str,
) -> Result<T, Fault> {
    let mut given = given.into_iter().flatten();
    match (given.next(), given.next()) {
        (Some(only), None) => Ok(only),
        (first, _) => Err(Fault::Choice {
            number,
            found: if first.is_some() { "several" } else { "none" }.into(),
            needed,
        }),
    }
}
