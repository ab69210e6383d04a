//! A background thread that answers questions, so that no frame waits for slow work.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

/// A background thread and the two channels to it. The thread ends after the worker is dropped, as
/// soon as it has served the questions it already holds.
pub struct Worker<Question, Answer> {
    questions: Sender<Question>,
    answers: Mutex<Receiver<Answer>>,
}

/// Where the thread puts its answers. One question may have none, one or several answers.
pub struct Answers<Answer>(Sender<Answer>);

impl<Answer> Answers<Answer> {
    /// Hands an answer to the worker's owner.
    pub fn send(&self, answer: Answer) {
        // An answer without an owner is dropped: the window is closing.
        self.0.send(answer).ok();
    }
}

impl<Question: Send + 'static, Answer: Send + 'static> Worker<Question, Answer> {
    /// Starts a thread that serves every question, in the order they were asked.
    pub fn serving_all(mut serve: impl FnMut(Question, &Answers<Answer>) + Send + 'static) -> Self {
        Self::start(move |questions, answers| {
            for question in questions {
                serve(question, &answers);
            }
        })
    }

    /// Starts a thread that serves only the latest question: those that were asked and replaced
    /// while it was busy are never served.
    pub fn serving_latest(
        mut serve: impl FnMut(Question, &Answers<Answer>) + Send + 'static,
    ) -> Self {
        Self::start(move |questions, answers| {
            while let Ok(question) = questions.recv() {
                let latest = questions.try_iter().last().unwrap_or(question);
                serve(latest, &answers);
            }
        })
    }

    fn start(run: impl FnOnce(Receiver<Question>, Answers<Answer>) + Send + 'static) -> Self {
        let (questions, asked) = channel();
        let (answer, answers) = channel();
        std::thread::spawn(move || run(asked, Answers(answer)));
        Self {
            questions,
            answers: Mutex::new(answers),
        }
    }

    /// Asks a question. Returns at once.
    pub fn ask(&self, question: Question) {
        // A thread that has panicked gives no answer; its panic message is already in the log.
        self.questions.send(question).ok();
    }

    /// The oldest answer that has not been taken yet, if there is one.
    pub fn next_answer(&self) -> Option<Answer> {
        self.with_answers(|answers| answers.try_recv().ok())
    }

    /// The newest answer, if there is one that has not been taken yet. Older answers are dropped.
    pub fn latest_answer(&self) -> Option<Answer> {
        self.with_answers(|answers| answers.try_iter().last())
    }

    /// Waits for the first answer that `is_wanted` accepts and drops those before it. `None` if the
    /// thread has ended without giving one.
    pub fn wait_for(&self, is_wanted: impl FnMut(&Answer) -> bool) -> Option<Answer> {
        self.with_answers(|answers| answers.iter().find(is_wanted))
    }

    fn with_answers<T>(&self, take: impl FnOnce(&Receiver<Answer>) -> T) -> T {
        take(&self.answers.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
