pub(crate) mod history;
pub(crate) mod last_pose;
pub(crate) mod settings;
pub(crate) mod toast;
