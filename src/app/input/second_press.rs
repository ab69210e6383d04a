//! A key that would end a mission waits for a second press.

use std::time::Duration;

/// For how long the second press is waited for.
pub(super) const WAIT: Duration = Duration::from_secs(5);

/// The control whose second press is waited for, and since when.
#[derive(Default)]
pub(super) struct SecondPress(Option<(&'static str, Duration)>);

impl SecondPress {
    /// Whether a press of the control with this name is the second one. Another one is a first one, and
    /// the control's second press is waited for from `now` on.
    pub(super) fn confirms(&mut self, id: &'static str, now: Duration) -> bool {
        let first = self.0.take().filter(|(waiting, _)| *waiting == id);
        let confirms = first.is_some_and(|(_, since)| now.saturating_sub(since) <= WAIT);
        if !confirms {
            self.0 = Some((id, now));
        }
        confirms
    }
}
