//! The loading screen of the page, and what it says when the program cannot go on.

/// A state of the page, which its style sheet knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// The program draws.
    Running,
    /// The program has ended with a fault.
    Failed,
}

/// Puts the page into a state.
pub fn show_state(state: State) {
    let word = match state {
        State::Running => "running",
        State::Failed => "failed",
    };
    let root = super::document()
        .ok()
        .and_then(|page| page.document_element());
    if let Some(root) = root {
        // A page without the attribute keeps its loading screen.
        root.set_attribute("data-state", word).ok();
    }
}

/// Says on the page why the program has ended.
pub fn report(message: &str) {
    let place = super::document()
        .ok()
        .and_then(|page| page.get_element_by_id("message"));
    if let Some(place) = place {
        place.set_text_content(Some(message));
    }
    show_state(State::Failed);
}
