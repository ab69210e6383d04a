//! What keys and buttons mean: the controls, what each does, and what each is bound to. Nothing
//! here reads a device or draws.

pub(crate) mod bindings;
pub(crate) mod buttons;
pub(crate) mod control;
mod default_keys;
pub(crate) mod edits;
pub(crate) mod empty_view;
pub(crate) mod helm;
pub(crate) mod key_feedback;
pub(crate) mod key_labels;
pub(crate) mod keys;
pub(crate) mod kiosk;
pub(crate) mod lesson;
pub(crate) mod refusal;
pub(crate) mod sections;
pub(crate) mod statement;
pub(crate) mod table;
pub(crate) mod text_keys;
