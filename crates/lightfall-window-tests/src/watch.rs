//! Writes down the state after every frame.

use crate::answers::{Answers, read_answer};
use crate::kept_picture::KeptPicture;
use crate::orders::Orders;
use crate::shown;
use bevy::diagnostic::FrameCount;
use bevy::prelude::*;
use bevy::window::{CursorGrabMode, CursorOptions, PrimaryWindow, WindowMode};
use bevy_egui::{EguiContext, EguiFullOutput, EguiPostUpdateSet};
use lightfall::app::{
    CockpitSound, FramePacing, FreeFall, JourneyPlayer, Layout, Menu, PathLine, ShipFlight,
};
use lightfall_core::optics::ship::Apsides;
use lightfall_render::{Comparison, ComparisonMode, DrawnScene, Progress};
use std::path::PathBuf;
use watched::{ShipState, State, fields_of};

/// The file for the state.
#[derive(Resource)]
struct StateFile(PathBuf);

pub fn add(app: &mut App, file: PathBuf) {
    app.insert_resource(StateFile(file)).add_systems(
        PostUpdate,
        write_state
            .after(read_answer)
            .before(EguiPostUpdateSet::ProcessOutput),
    );
}

fn write_state(
    (frame, file): (Res<FrameCount>, Res<StateFile>),
    scene: Res<DrawnScene>,
    mut egui: Query<(&mut EguiContext, &EguiFullOutput)>,
    (orders, answers, kept): (Res<Orders>, Res<Answers>, Res<KeptPicture>),
    (player, fall): (Res<JourneyPlayer>, Res<FreeFall>),
    (ship, path, sound): (Res<ShipFlight>, Res<PathLine>, Res<CockpitSound>),
    (progress, pacing): (Res<Progress>, Res<FramePacing>),
    (menu, comparison, layout): (Res<Menu>, Res<Comparison>, Res<Layout>),
    window: Single<(&Window, &CursorOptions), With<PrimaryWindow>>,
    mut last: Local<State>,
    mut last_size: Local<UVec2>,
) {
    let (window, cursor) = *window;
    let size = scene.picture.size();
    let rests = *progress == Progress::Done && !pacing.running && *last_size == size;
    *last_size = size;
    let fields = if scene.is_changed() {
        fields_of(scene.scene())
    } else {
        std::mem::take(&mut last.scene)
    };
    *last = State {
        frame: frame.0,
        rested: if rests { last.rested + 1 } else { 0 },
        keys: answers.keys,
        orders: orders.count,
        scene: fields,
        texts: shown::texts(egui.iter().map(|(_, output)| output)),
        widgets: egui
            .iter_mut()
            .flat_map(|(mut context, _)| shown::widgets(&mut context))
            .collect(),
        boxes: layout
            .taken()
            .iter()
            .map(|taken| (taken.name.to_owned(), shown::place(taken.place)))
            .collect(),
        answer: answers.last.clone(),
        journey: player.is_playing().then(|| player.time()),
        falls: fall.is_moving(),
        ship: ship_state(&ship),
        volume: sound.readings.volume,
        path_points: path.drawn(),
        pace: fall.rate(1.0),
        progress: format!("{:?}", *progress),
        resting: pacing.resting,
        menu: menu.is_open(),
        comparison: match comparison.0.as_ref().map(|(_, mode)| *mode) {
            None => String::new(),
            Some(ComparisonMode::SideBySide { .. }) => "side by side".into(),
            Some(ComparisonMode::TwoPictures) => "two pictures".into(),
            Some(ComparisonMode::Difference { gain }) => format!("difference times {gain}"),
        },
        grabs_mouse: cursor.grab_mode != CursorGrabMode::None && !cursor.visible,
        shows_pointer: cursor.visible,
        full_screen: window.mode != WindowMode::Windowed,
        kept: kept.differs(),
    };
    // Renamed when it is complete, so that nobody reads half of it.
    let part = file.0.with_extension("part");
    let json = serde_json::to_vec(&*last).expect("a state is written");
    std::fs::write(&part, json)
        .and_then(|()| std::fs::rename(part, &file.0))
        .expect("the folder of the state can be written to");
}

fn ship_state(ship: &ShipFlight) -> Option<ShipState> {
    let flight = &ship.voyage()?.flight;
    let apsides = Apsides::of(&flight.ship);
    let attempt = ship.attempt();
    Some(ShipState {
        own_time: flight.ship.proper_time(),
        periapsis: apsides.periapsis,
        apoapsis: apsides.apoapsis,
        acceleration: flight.acceleration().length(),
        rapidity_used: flight.rocket.used(),
        pace: ship.pace(),
        hold: ship
            .hold()
            .map_or_else(String::new, |hold| format!("{hold:?}")),
        heading: ship
            .heading()
            .map_or_else(String::new, |heading| format!("{heading:?}")),
        mission: attempt.map_or_else(Default::default, |attempt| {
            [
                attempt.mission.name.clone(),
                format!("{:?}", attempt.outcome()),
            ]
        }),
    })
}
