//! How the questions of a lesson were answered since it began.

use super::JourneyPlayer;
use lightfall_core::numbers::counted;

/// How often the question of a stop was answered, and whether rightly in the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Tries {
    count: u32,
    is_right: bool,
}

/// Which answer it is: the number of its question among those of the lesson, and that of the try, both
/// counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotedAnswer {
    /// The question.
    pub question: usize,
    /// The try.
    pub tries: u32,
}

impl JourneyPlayer {
    /// Notes an answer to the question of the stop at which the journey waits. None where nothing is asked,
    /// and after the right answer.
    pub fn note_answer(&mut self, is_right: bool) -> Option<NotedAnswer> {
        let (stop, number) = self.waits_at()?;
        stop.question.as_ref()?;
        let question = self.questions_until(number);
        let tries = self.answers.entry(number).or_default();
        if tries.is_right {
            return None;
        }
        tries.count += 1;
        tries.is_right = is_right;
        Some(NotedAnswer {
            question,
            tries: tries.count,
        })
    }

    /// How many questions were answered rightly, at once and later, in a sentence. None where nobody has
    /// answered, as where a teacher asks a class.
    #[must_use]
    pub fn score(&self) -> Option<String> {
        let all = self.questions_until(self.journey.stops.len());
        let right = |at_once: bool| {
            let answers = self.answers.values();
            answers
                .filter(|it| it.is_right && (it.count == 1) == at_once)
                .count()
        };
        let later = match right(false) {
            0 => String::new(),
            later => format!(", {later} after more tries"),
        };
        let left = match all.saturating_sub(right(true) + right(false)) {
            0 => String::new(),
            left => format!(", {left} not solved"),
        };
        let questions = counted(all, "question");
        let sentence = format!("{} of {questions} right at once{later}{left}.", right(true));
        (!self.answers.is_empty()).then_some(sentence)
    }

    /// The number of questions of the first stops, so many of them.
    fn questions_until(&self, stops: usize) -> usize {
        let stops = self.journey.stops.iter().take(stops);
        stops.filter(|stop| stop.question.is_some()).count()
    }
}
