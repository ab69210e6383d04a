//! The words of a journey: the title and captions over the picture, and those of its end.

use super::JourneyPlayer;

/// Seconds for which the title is shown at the beginning.
const TITLE_SECONDS: f64 = 4.5;

/// Words over the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Words<'a> {
    /// One line.
    pub text: &'a str,
    /// Whether this is the journey's title.
    pub is_title: bool,
    /// Seconds since it appeared.
    pub since: f64,
    /// Seconds until it goes.
    pub left: f64,
}

impl JourneyPlayer {
    /// The title and the text of the card at the end.
    #[must_use]
    pub fn last_words(&self) -> [&str; 2] {
        let title = match self.journey.title.trim() {
            "" => "The journey ends here",
            title => title,
        };
        [title, &self.journey.ending]
    }

    /// What to show over the picture now: the title at the beginning, then the captions, with the
    /// seconds since it appeared and until it goes. None without a flight, and at a stop, which has words
    /// of its own.
    #[must_use]
    pub fn words(&self) -> Option<Words<'_>> {
        self.flight.as_ref()?;
        if self.waits_at().is_some() {
            return None;
        }
        let title = self.journey.title.trim();
        if let Some(caption) = self.journey.caption_at(self.time) {
            let since = self.time - caption.time;
            Some(Words {
                text: &caption.text,
                is_title: false,
                since,
                left: caption.seconds - since,
            })
        } else if self.time < TITLE_SECONDS && !title.is_empty() && self.left == 0 {
            Some(Words {
                text: title,
                is_title: true,
                since: self.time,
                left: TITLE_SECONDS - self.time,
            })
        } else {
            None
        }
    }
}
