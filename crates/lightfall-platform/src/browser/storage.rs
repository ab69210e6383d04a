//! Texts that the browser keeps for this page.

/// The storage of this page.
pub struct Storage(web_sys::Storage);

impl Storage {
    /// The storage, unless the browser or its user denies it.
    #[must_use]
    pub fn open() -> Option<Self> {
        super::window().ok()?.local_storage().ok()?.map(Self)
    }

    /// The text of a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<String> {
        self.0.get_item(key).ok()?
    }

    /// Keeps a text under a key.
    ///
    /// # Errors
    /// The storage is full.
    pub fn set(&self, key: &str, text: &str) -> Result<(), ()> {
        self.0.set_item(key, text).map_err(drop)
    }

    /// Forgets a key.
    pub fn remove(&self, key: &str) {
        self.0.remove_item(key).ok();
    }

    /// Every key.
    #[must_use]
    pub fn keys(&self) -> Vec<String> {
        let count = self.0.length().unwrap_or(0);
        let keys = (0..count).filter_map(|index| self.0.key(index).ok()?);
        keys.collect()
    }
}
