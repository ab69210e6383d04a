//! From a scene to the text of a preset: complete, with comments, and read back by `load` as the
//! same scene.

use std::fmt::Write;

use super::Scene;

impl Scene {
    /// The scene as TOML, every field with its meaning and what it may be.
    pub fn to_preset(&self) -> String {
        let mut text = String::new();
        let mut table = "";
        for (field, value) in self.values() {
            let (head, name) = field.key.split_once('.').unwrap_or(("", field.key));
            if head != table {
                text += &format!("\n[{head}]\n");
                table = head;
            }
            let allowed = field.allowed_in(self.range(field).0);
            writeln!(text, "# {}: {allowed}.\n{name} = {value}", field.about)
                .expect("writing to a String cannot fail");
        }
        text
    }
}
