//! The names of controls in texts of missions.

use super::bindings::Bindings;
use super::table::control_named;

impl Bindings {
    /// A text in which the name of a control in braces, such as `{fly.forward}`, stands for its key.
    #[must_use]
    pub fn with_keys(&self, text: &str) -> String {
        let mut parts = text.split('{');
        let mut words = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            match part.split_once('}') {
                Some((id, after)) if control_named(id).is_some() => {
                    words += &self.first_label(id);
                    words += after;
                }
                _ => {
                    words.push('{');
                    words += part;
                }
            }
        }
        words
    }
}
