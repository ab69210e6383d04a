//! What has been done to the scene, so that it can be undone.

use bevy::prelude::Resource;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;
use std::collections::VecDeque;
use std::time::Duration;

/// Most changes that are kept.
pub const MAX_LENGTH: usize = 64;

/// Changes of the same fields within this time, as a slider that is dragged makes them, are one.
const ONE_CHANGE: Duration = Duration::from_millis(700);

/// The scene as it was loaded, and the changes since.
#[derive(Resource, Clone, Debug)]
pub struct History {
    /// What switches and `reset` come back to.
    loaded: Scene,
    past: VecDeque<Change>,
}

/// One change: the scene on both sides of it. Only the fields that differ are taken back, so that
/// flying on in between stays as it is.
#[derive(Clone, Debug)]
struct Change {
    before: Scene,
    /// None for a departure: where it leads is not known yet, and all that is taken back is where
    /// the camera was and how it moved.
    after: Option<Scene>,
    /// What was loaded before.
    loaded: Scene,
    at: Duration,
}

impl History {
    /// Begins with a scene that was just loaded.
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

    /// Notes a change made at the time `at` since some start.
    pub fn note(&mut self, before: &Scene, after: &Scene, at: Duration) {
        if before == after {
            return;
        }
        let keys = |a: &Scene, b: &Scene| {
            a.differences(b)
                .into_iter()
                .map(|(key, _)| key)
                .collect::<Vec<_>>()
        };
        if let Some(last) = self.past.back_mut()
            && at.saturating_sub(last.at) < ONE_CHANGE
            && last.loaded == self.loaded
            && let Some(middle) = &last.after
            && middle == before
            && keys(&last.before, middle) == keys(before, after)
        {
            (last.after, last.at) = (Some(after.clone()), at);
            return;
        }
        self.push(before, Some(after.clone()), at);
    }

    /// Notes that the camera is about to be led away from where it is.
    pub fn note_departure(&mut self, before: &Scene, at: Duration) {
        self.push(before, None, at);
    }

    fn push(&mut self, before: &Scene, after: Option<Scene>, at: Duration) {
        if self.past.len() == MAX_LENGTH {
            self.past.pop_front();
        }
        self.past.push_back(Change {
            before: before.clone(),
            after,
            loaded: self.loaded.clone(),
            at,
        });
    }

    /// Notes that another scene was loaded in place of `before`.
    pub fn note_loaded(&mut self, before: &Scene, after: &Scene, at: Duration) {
        self.note(before, after, at);
        self.loaded = after.clone();
    }

    /// What the scene `now` is without the last change; none if there is no change left. Where the
    /// camera has gone to a place that forbids it, the place of the change comes back, too. The
    /// change is forgotten, also where it cannot be undone.
    ///
    /// # Errors
    /// Why the scene without it cannot be drawn.
    pub fn undo(&mut self, now: &Scene) -> Option<Result<Drawable, String>> {
        let Change {
            before,
            after,
            loaded,
            ..
        } = self.past.pop_back()?;
        let undone = match &after {
            Some(after) => now
                .with(before.differences(after))
                .map_err(|refusal| refusal.to_string()),
            None => Ok(Scene {
                camera: before.camera,
                observer: before.observer,
                ..now.clone()
            }),
        };
        let undone = undone
            .and_then(|scene| Drawable::new(scene).map_err(|reason| reason.to_string()))
            .or_else(|reason| Drawable::new(before).map_err(|_| reason));
        Some(undone.inspect(|_| self.loaded = loaded))
    }
}
