//! The changes of the scene, so that they can be undone.

use bevy::prelude::Resource;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Scene, Value};
use std::collections::VecDeque;
use std::time::Duration;

/// The largest number of changes that are kept.
const MAX_CHANGES: usize = 64;

/// Changes of the same fields that follow each other within this time count as one change: a
/// dragged slider makes one in every frame.
const MERGE_TIME: Duration = Duration::from_millis(700);

/// The scene as it was loaded, and the changes since.
#[derive(Resource, Clone, Debug)]
pub struct History {
    /// The scene that switches and `Reset` return to.
    loaded: Scene,
    past: VecDeque<Change>,
}

/// One change.
#[derive(Clone, Debug)]
struct Change {
    before: Scene,
    kind: ChangeKind,
    /// The loaded scene before the change.
    loaded: Scene,
    at: Duration,
}

/// What a change was, and with it what undoing it restores.
#[derive(Clone, Debug)]
enum ChangeKind {
    /// Fields were set; the values before. Only these are restored, so that what was flown since is
    /// kept, and so are the exposure and the time that go on by themselves.
    Edit(Vec<(&'static str, Value)>),
    /// A flight, whose end is not known yet. Where the camera was and how it moved is restored.
    Departure { by_hand: bool },
    /// A flight that began in another scene. The whole scene is restored.
    DepartureElsewhere,
}

impl History {
    /// The history of a scene that was just loaded.
    #[must_use]
    pub fn new(loaded: Scene) -> Self {
        Self {
            loaded,
            past: VecDeque::new(),
        }
    }

    /// The scene as it was loaded.
    #[must_use]
    pub fn loaded(&self) -> &Scene {
        &self.loaded
    }

    /// Notes a change made at the time `at`, counted from any fixed start.
    pub fn note(&mut self, before: &Scene, after: &Scene, at: Duration) {
        let mut fields = before.differences(after);
        if fields.is_empty() {
            return;
        }
        // The light meter takes the place of an exposure by hand, which undoing restores.
        if !before.picture.automatic_exposure && after.picture.automatic_exposure {
            let exposure = Value::Float(before.picture.exposure_ev);
            fields.push(("picture.exposure_ev", exposure));
        }
        if let Some(last) = self.past.back_mut()
            && at.saturating_sub(last.at) < MERGE_TIME
            && last.loaded == self.loaded
            && let ChangeKind::Edit(edited) = &last.kind
            && edited
                .iter()
                .map(|(key, _)| key)
                .eq(fields.iter().map(|(key, _)| key))
        {
            last.at = at;
            return;
        }
        self.push(before, ChangeKind::Edit(fields), at);
    }

    /// Notes that a flight is about to lead the camera away.
    pub fn note_departure(&mut self, before: &Scene, at: Duration) {
        self.push(before, ChangeKind::Departure { by_hand: false }, at);
    }

    /// Notes that a flight is about to begin in the scene `start`, which is loaded in place of
    /// `before`.
    pub fn note_departure_elsewhere(&mut self, before: &Scene, start: &Scene, at: Duration) {
        self.push(before, ChangeKind::DepartureElsewhere, at);
        self.loaded = start.clone();
    }

    /// Notes that the hand is about to lead the camera away. All flying by hand since the last
    /// other change is one departure.
    pub fn note_departure_by_hand(&mut self, before: &Scene, at: Duration) {
        let goes_on = self
            .past
            .back()
            .is_some_and(|last| matches!(last.kind, ChangeKind::Departure { by_hand: true }));
        if !goes_on {
            self.push(before, ChangeKind::Departure { by_hand: true }, at);
        }
    }

    fn push(&mut self, before: &Scene, kind: ChangeKind, at: Duration) {
        if self.past.len() == MAX_CHANGES {
            self.past.pop_front();
        }
        self.past.push_back(Change {
            before: before.clone(),
            kind,
            loaded: self.loaded.clone(),
            at,
        });
    }

    /// Notes that another scene was loaded in place of `before`.
    pub fn note_loaded(&mut self, before: &Scene, after: &Scene, at: Duration) {
        self.note(before, after, at);
        self.loaded = after.clone();
    }

    /// The scene `now` without the last change. None if there is no change left. Where the camera
    /// has since flown to a place that does not allow this, the place of the change is restored
    /// too. The change is forgotten, even if it cannot be undone.
    ///
    /// # Errors
    /// Why the scene without the change cannot be drawn.
    pub fn undo(&mut self, now: &Scene) -> Option<Result<Drawable, String>> {
        let Change {
            before,
            kind,
            loaded,
            ..
        } = self.past.pop_back()?;
        let undone = match &kind {
            ChangeKind::Edit(fields) => now
                .with(fields.iter().cloned())
                .map_err(|refusal| refusal.to_string()),
            ChangeKind::DepartureElsewhere => Ok(before.clone()),
            ChangeKind::Departure { .. } => {
                let mut scene = Scene {
                    camera: before.camera,
                    observer: before.observer,
                    ..now.clone()
                };
                // A journey may have changed it.
                scene.disk.rate = before.disk.rate;
                Ok(scene)
            }
        };
        let undone = undone
            .and_then(|scene| Drawable::new(scene).map_err(|reason| reason.to_string()))
            .or_else(|reason| Drawable::new(before).map_err(|_| reason));
        Some(undone.inspect(|_| self.loaded = loaded))
    }
}
