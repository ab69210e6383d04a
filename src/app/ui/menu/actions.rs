//! What the menu's entries are called, and what they do.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{Action, AppCommand};
use crate::app::controls::table::control_named;
use crate::app::motion::ship::{Measures, quantity_name};
use crate::app::state::helm::CommandSender;
use crate::app::state::lesson_draft::LessonDraft;
use crate::app::state::lessons::{GuidedJourney, Lessons, StartJourney};
use crate::app::state::menu::{Menu, MenuEntry, MenuList};
use crate::app::state::missions::{Missions, StartMission};
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::settings::Settings;
use crate::app::state::toast::Toast;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use lightfall_core::numbers::counted;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::mission::Mission;
use lightfall_core::scene::presets::PRESETS;
use lightfall_platform::IN_BROWSER;

/// The menu, and what its entries act on.
#[derive(SystemParam)]
pub(super) struct MenuActions<'w> {
    pub(super) menu: ResMut<'w, Menu>,
    pub(super) missions: ResMut<'w, Missions>,
    lessons: ResMut<'w, Lessons>,
    draft: Res<'w, LessonDraft>,
    guided: Res<'w, GuidedJourney>,
    starts: MessageWriter<'w, StartMission>,
    flights: MessageWriter<'w, StartJourney>,
    editor: SceneEditor<'w>,
    commands: CommandSender<'w>,
}

/// An entry's name, and the control that does the same, whose key the entry shows. Empty for an
/// entry without a control.
pub(super) fn name_and_control(entry: MenuEntry) -> [String; 2] {
    let words = match entry {
        MenuEntry::Resume => ["Resume", "fly.escape"],
        MenuEntry::Places => ["Places", ""],
        MenuEntry::Missions => ["Missions", "ship.missions"],
        MenuEntry::Lessons => ["Lessons", ""],
        // Missions and lessons have their titles from the lists.
        MenuEntry::Mission(_) | MenuEntry::Lesson(_) => ["", ""],
        MenuEntry::AddStop => ["Add this view as a stop", "lesson.add_stop"],
        MenuEntry::SaveLesson => ["Save my lesson", "lesson.save"],
        MenuEntry::NewLesson => ["Begin a new lesson", ""],
        MenuEntry::Journey => ["Guided journey", "journey.again"],
        MenuEntry::Ship => ["Fly the ship", "ship.fly"],
        MenuEntry::LetGo => ["Let go: fall or orbit", "motion.let_go"],
        MenuEntry::Help => ["Help: all keys", "window.help"],
        MenuEntry::Settings => ["Settings", ""],
        MenuEntry::PhotoMode => ["Photo mode", "window.hide"],
        MenuEntry::FullScreen => ["Full screen", "window.fullscreen"],
        MenuEntry::Quit => ["Quit", "window.quit"],
        MenuEntry::Back => ["Back", ""],
        MenuEntry::Place(place) => {
            let preset = &PRESETS[place];
            let title = preset.plain_scene().title.clone();
            return [title, format!("preset.{}", preset.number)];
        }
    };
    words.map(str::to_owned)
}

/// The units of a mission's texts: everyday ones are for the mass of its own hole.
fn units_of(mission: &Mission, settings: &Settings) -> Units {
    let mass = HoleMass::of_suns(mission.hole.mass_suns);
    settings.units().for_mass(mass)
}

impl MenuActions<'_> {
    /// What stands at the left and at the right of an entry.
    pub(super) fn words(
        &self,
        entry: MenuEntry,
        bindings: &Bindings,
        settings: &Settings,
    ) -> [String; 2] {
        let [name, control] = name_and_control(entry);
        let flies = self.commands.helm.has_ship();
        match entry {
            MenuEntry::Ship if flies => ["Leave the ship".into(), bindings.first_name(&control)],
            MenuEntry::LetGo if flies => ["Engine off".into(), bindings.first_name(&control)],
            MenuEntry::Mission(index) => self.mission_words(index, settings),
            MenuEntry::Lesson(index) => self.lesson_words(index),
            MenuEntry::SaveLesson => {
                let stops = counted(self.draft.stops(), "stop");
                let saved = if self.draft.has_changed {
                    ""
                } else {
                    ", saved"
                };
                let state = match self.draft.stops() {
                    0 => "no stop yet".into(),
                    _ => format!("{stops}{saved}"),
                };
                let key = bindings.first_name(&control);
                [format!("{name}: {state}"), key]
            }
            MenuEntry::Place(_) => [name, bindings.label(&control)],
            _ => [name, bindings.first_name(&control)],
        }
    }

    /// A mission's title, and the best that was reached in it: its three lamps, all dark before the first
    /// success.
    fn mission_words(&self, index: usize, settings: &Settings) -> [String; 2] {
        let Some(mission) = self.missions.list.get(index) else {
            return Default::default();
        };
        let best = self.missions.results.best(&mission.name);
        let measures = Measures::new(mission, units_of(mission, settings));
        let reached = best.map_or_else(
            || "not reached, lamps ○○○".into(),
            |best| {
                let lamps = "●".repeat(best.lamps) + &"○".repeat(3 - best.lamps.min(3));
                let par = best.par.filter(|(_, value)| value.is_finite());
                let par = par.map_or_else(String::new, |(quantity, value)| {
                    let amount = measures.short_amount(quantity, value);
                    format!("{} {amount}  ", quantity_name(quantity))
                });
                format!("{par}lamps {lamps}")
            },
        );
        [mission.title.clone(), reached]
    }

    /// A lesson's title, and how many stops it has, if any.
    fn lesson_words(&self, index: usize) -> [String; 2] {
        let Some(lesson) = self.lessons.0.get(index) else {
            return Default::default();
        };
        let title = match lesson.title.trim() {
            "" => "Without a title",
            title => title,
        };
        let stops = match lesson.stops.len() {
            0 => String::new(),
            stops => counted(stops, "stop"),
        };
        [title.to_owned(), stops]
    }

    /// The line below the entries.
    pub(super) fn hint(&self, bindings: &Bindings, settings: &Settings) -> String {
        const KEYS: &str = "Up, Down and Enter choose";
        let file = self.missions.results.file().filter(|_| !IN_BROWSER);
        if let MenuEntry::Lesson(index) = self.menu.selected()
            && let Some(lesson) = self.lessons.0.get(index)
            && !lesson.teaches.is_empty()
        {
            return bindings.with_keys(&lesson.teaches);
        }
        if let MenuEntry::Mission(index) = self.menu.selected()
            && let Some(mission) = self.missions.list.get(index)
        {
            let text = match mission.teaches.as_str() {
                "" => mission.brief.as_str(),
                teaches => teaches,
            };
            let units = units_of(mission, settings);
            return bindings.with_keys(&units.in_text(text));
        }
        match (self.menu.list(), file) {
            (MenuList::Missions(_), Some(file)) => {
                format!("{KEYS}. Results are kept in {}", file.display())
            }
            _ => KEYS.into(),
        }
    }

    /// Does what an entry says.
    pub(super) fn choose(&mut self, entry: MenuEntry) {
        match entry {
            MenuEntry::Places => return self.menu.show_places(),
            MenuEntry::Missions => {
                let editor = &mut self.editor;
                return show_missions(&mut self.menu, &mut self.missions, |fault| {
                    editor.say(fault);
                });
            }
            MenuEntry::Mission(index) => {
                if let Some(mission) = self.missions.list.get(index) {
                    self.starts.write(StartMission(Box::new(mission.clone())));
                }
            }
            MenuEntry::Lessons => {
                let faults = self.lessons.read();
                if !faults.is_empty() {
                    self.editor.say(faults.join("\n"));
                }
                return self.menu.show_lessons(self.lessons.0.len());
            }
            MenuEntry::Lesson(index) => {
                if let Some(lesson) = self.lessons.0.get(index) {
                    self.flights.write(StartJourney(Box::new(lesson.clone())));
                }
            }
            MenuEntry::Journey => {
                let guided = self.guided.0.clone();
                self.flights.write(StartJourney(Box::new(guided)));
            }
            MenuEntry::NewLesson => self.commands.send(AppCommand::NewLesson),
            MenuEntry::Back => return self.menu.go_back(),
            MenuEntry::Resume => {}
            MenuEntry::Place(place) => {
                let scene = PRESETS[place].plain_scene().clone();
                self.editor.load("", Ok(scene));
            }
            MenuEntry::Settings => {
                self.commands.send(AppCommand::Settings);
            }
            _ => {
                let [_, control] = name_and_control(entry);
                if let Some(Action::Do(command)) = control_named(&control).map(|it| it.action) {
                    self.commands.send(command);
                }
            }
        }
        self.menu.close();
    }
}

/// Opens the menu at its list of missions when the key is pressed.
pub(super) fn open_missions(
    mut commands: MessageReader<AppCommand>,
    mut menu: ResMut<Menu>,
    mut missions: ResMut<Missions>,
    mut toast: ResMut<Toast>,
) {
    if AppCommand::Missions.count(&mut commands) > 0 {
        menu.open();
        show_missions(&mut menu, &mut missions, |fault| toast.say(fault));
    }
}

/// Shows the list of missions, which is read again, and says what is wrong with the user's own ones.
fn show_missions(menu: &mut Menu, missions: &mut Missions, say: impl FnOnce(String)) {
    let faults = missions.read();
    if !faults.is_empty() {
        say(faults.join("\n"));
    }
    menu.show_missions(missions.list.len());
    // Where one goes on. With all of them reached, and none flown, it is the first.
    if let Some(index) = missions.first_choice() {
        menu.select(MenuEntry::Mission(index));
    }
}
