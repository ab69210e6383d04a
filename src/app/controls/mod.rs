pub(crate) mod bindings;
pub(crate) mod buttons;
pub(crate) mod edits;
pub(crate) mod keys;
pub(crate) mod table;
