//! Reading and changing single fields by their keys, as the panel and the undo do.

use super::error::Refusal;
use super::field::Field;
use super::fields::{FIELDS, field};
use super::value::Value;
use super::{Method, Scene};

impl Scene {
    /// Every field with its value, in the order of the table.
    pub fn values(&self) -> impl Iterator<Item = (&'static Field, Value)> {
        FIELDS.iter().map(|field| (field, field.get(self)))
    }

    /// This scene, traced by another method.
    #[must_use]
    pub fn with_method(&self, method: Method) -> Self {
        Self {
            method,
            ..self.clone()
        }
    }

    /// This scene with some fields set to other values. Unknown keys are ignored.
    ///
    /// # Errors
    /// The first value of the wrong kind, or the first field that the others do not allow.
    pub fn with<'a>(
        &self,
        changes: impl IntoIterator<Item = (&'a str, Value)>,
    ) -> Result<Self, Refusal> {
        let mut scene = self.clone();
        let mut changed = Vec::new();
        for (key, value) in changes {
            if let Some(field) = field(key) {
                field.set(&mut scene, value)?;
                changed.push(field);
            }
        }
        match scene.check() {
            Ok(()) => Ok(scene),
            Err(refusal) => Err(refusal.blaming(&changed, &scene)),
        }
    }

    /// The fields in which `after` differs from this scene, each with its value here.
    pub fn differences(&self, after: &Self) -> Vec<(&'static str, Value)> {
        let both = self.values().zip(after.values());
        both.filter(|((_, before), (_, after))| before != after)
            .map(|((field, before), _)| (field.key, before))
            .collect()
    }
}

impl Refusal {
    /// The same refusal, blamed on the changed field that narrows the range, so that the message
    /// names the field that the user changed. A refused field that was itself changed keeps the
    /// blame.
    fn blaming(self, changed: &[&'static Field], scene: &Scene) -> Self {
        let narrows = |field: &&&Field| {
            self.because
                .as_ref()
                .is_some_and(|because| because.keys.contains(&field.key))
        };
        let own = changed.iter().any(|field| field.key == self.key);
        let culprit = changed.iter().filter(|_| !own).find(narrows);
        let blamed = culprit.map(|field| Box::new((field.key, field.get(scene).quoted())));
        Self { blamed, ..self }
    }
}
