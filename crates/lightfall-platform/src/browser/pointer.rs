//! The mouse, which a page may hold until the user presses Esc.

/// Whether the page holds the mouse.
#[must_use]
pub fn pointer_is_locked() -> bool {
    super::document().is_ok_and(|page| page.pointer_lock_element().is_some())
}
