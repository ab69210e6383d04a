//! Changes of single fields by their keys, as the panel and the undo make them.

use toml::{Table, Value};

use super::Scene;
use super::error::Refusal;
use super::fields::field;
use super::limits::given;

impl Scene {
    /// This scene with some fields set otherwise. A key that is none is passed over.
    ///
    /// # ErrorSummary
    /// The first value of the wrong type, or the first field that is not allowed beside the others.
    pub fn with<'a>(
        &self,
        changes: impl IntoIterator<Item = (&'a str, Value)>,
    ) -> Result<Self, Refusal> {
        let mut table =
            Table::try_from(self).expect("a scene is made of numbers, words and tables only");
        let mut changed = Vec::new();
        for (key, value) in changes {
            let Some(field) = field(key) else { continue };
            field.check_type(&value)?;
            let place = match key.split_once('.') {
                None => table.get_mut(key),
                Some((outer, inner)) => table.get_mut(outer).and_then(|outer| outer.get_mut(inner)),
            };
            changed.push((field.key, given(&value)));
            *place.expect("every key of the field table is a field of the scene") = value;
        }
        let scene: Self = table
            .try_into()
            .expect("every value was checked against the field table");
        scene.check().map(|()| scene).map_err(|refusal| {
            // Who drags one field is not told that it is another's fault.
            let culprit = |(key, _): &&(&'static str, String)| {
                refusal
                    .because
                    .as_ref()
                    .is_some_and(|because| because.keys.contains(key))
            };
            let own = changed.iter().any(|(key, _)| *key == refusal.key);
            let blamed = changed
                .iter()
                .filter(|_| !own)
                .find(culprit)
                .cloned()
                .map(Box::new);
            Refusal { blamed, ..refusal }
        })
    }

    /// The fields in which `after` differs from this scene, each with its value here.
    #[must_use]
    pub fn differences(&self, after: &Self) -> Vec<(&'static str, Value)> {
        let both = self.values().zip(after.values());
        both.filter(|((_, before), (_, after))| before != after)
            .map(|((field, before), _)| (field.key, before))
            .collect()
    }
}
