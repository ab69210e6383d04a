//! A background thread that answers questions, so that no frame waits for slow work. A page in a
//! browser has one thread: there, a question is served when its answer is looked for.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

/// A background thread and the two channels to it. The thread ends after the worker is dropped, as
/// soon as it has served the questions it already holds.
pub struct Worker<Question, Answer> {
    questions: Sender<Question>,
    answers: Mutex<Receiver<Answer>>,
    thread: Thread,
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
            next_question(questions).map(|question| serve(question, answers))
        })
    }

    /// Starts a thread that serves only the latest question: those that were asked and replaced
    /// while it was busy are never served.
    pub fn serving_latest(
        mut serve: impl FnMut(Question, &Answers<Answer>) + Send + 'static,
    ) -> Self {
        Self::start(move |questions, answers| {
            let question = next_question(questions)?;
            let latest = questions.try_iter().last().unwrap_or(question);
            serve(latest, answers);
            Some(())
        })
    }

    /// Starts a thread that calls `serve_next` until it has no more questions.
    fn start(
        mut serve_next: impl FnMut(&Receiver<Question>, &Answers<Answer>) -> Option<()> + Send + 'static,
    ) -> Self {
        let (questions, asked) = channel();
        let (answer, answers) = channel();
        let answer = Answers(answer);
        Self {
            questions,
            answers: Mutex::new(answers),
            thread: Thread::start(move || serve_next(&asked, &answer)),
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
        self.thread.serve_waiting();
        take(&self.answers.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// A background thread with one question at a time. It is asked again when the question changes, and
/// its newest answer is kept.
pub struct Follower<Question, Answer> {
    worker: Worker<Question, (Question, Answer)>,
    asked: Option<Question>,
    newest: Option<(Question, Answer)>,
}

impl<Question: Clone + PartialEq + Send + 'static, Answer: Send + 'static>
    Follower<Question, Answer>
{
    /// Starts a thread that answers with this function.
    pub fn new(answer: impl Fn(&Question) -> Answer + Send + 'static) -> Self {
        Self {
            worker: Worker::serving_latest(move |question, answers| {
                let answer = answer(&question);
                answers.send((question, answer));
            }),
            asked: None,
            newest: None,
        }
    }

    /// Takes in a new answer, and asks the question unless it is the one asked last.
    pub fn follow(&mut self, question: Question) {
        self.newest = self.worker.latest_answer().or(self.newest.take());
        if self.asked.as_ref() != Some(&question) {
            self.worker.ask(question.clone());
            self.asked = Some(question);
        }
    }

    /// The newest answer, after its question.
    pub fn newest(&self) -> Option<&(Question, Answer)> {
        self.newest.as_ref()
    }

    /// The answer to the question asked last. `None` while it is awaited.
    pub fn answer(&self) -> Option<&Answer> {
        let (question, answer) = self.newest.as_ref()?;
        (self.asked.as_ref() == Some(question)).then_some(answer)
    }
}

/// The thread, which runs by itself.
#[cfg(not(target_arch = "wasm32"))]
struct Thread;

#[cfg(not(target_arch = "wasm32"))]
impl Thread {
    /// Starts a thread that calls `serve_next` until it gives nothing.
    fn start(mut serve_next: impl FnMut() -> Option<()> + Send + 'static) -> Self {
        std::thread::spawn(move || while serve_next().is_some() {});
        Self
    }

    fn serve_waiting(&self) {}
}

/// What stands in for the thread in a browser.
#[cfg(target_arch = "wasm32")]
struct Thread(Mutex<Box<dyn FnMut() -> Option<()> + Send>>);

#[cfg(target_arch = "wasm32")]
impl Thread {
    fn start(serve_next: impl FnMut() -> Option<()> + Send + 'static) -> Self {
        Self(Mutex::new(Box::new(serve_next)))
    }

    /// Serves a question, if one waits.
    fn serve_waiting(&self) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)();
    }
}

/// Waits for a question. `None` if nobody can ask one any more.
#[cfg(not(target_arch = "wasm32"))]
fn next_question<Question>(questions: &Receiver<Question>) -> Option<Question> {
    questions.recv().ok()
}

/// The question that waits, if one does.
#[cfg(target_arch = "wasm32")]
fn next_question<Question>(questions: &Receiver<Question>) -> Option<Question> {
    questions.try_recv().ok()
}
