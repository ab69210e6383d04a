//! The background thread behind the error map, the inspector, the clipboard and screenshots.

use lightfall_platform::worker::Worker;
use std::sync::mpsc::channel;
use std::time::Duration;

/// Far longer than any of these threads needs.
const PATIENCE: Duration = Duration::from_secs(30);

#[test]
fn every_question_is_served_in_order() {
    let worker = Worker::serving_all(|question: u32, answers| answers.send(question * 10));
    for question in 1..=4 {
        worker.ask(question);
    }
    assert_eq!(worker.wait_for(|&answer| answer == 40), Some(40));
    // The wait has dropped the first three answers.
    assert_eq!(worker.next_answer(), None);

    for question in 5..=7 {
        worker.ask(question);
    }
    let mut answers = Vec::new();
    while answers.len() < 3 {
        answers.extend(worker.wait_for(|_| true));
    }
    assert_eq!(answers, [50, 60, 70]);
}

#[test]
fn questions_replaced_while_the_thread_is_busy_are_never_served() {
    let (begin, begun) = channel();
    let (release, released) = channel();
    let worker = Worker::serving_latest(move |question: u32, answers| {
        begin.send(()).unwrap();
        released.recv().unwrap();
        answers.send(question);
    });
    worker.ask(1);
    begun.recv_timeout(PATIENCE).unwrap();
    for question in 2..=9 {
        worker.ask(question);
    }
    for _ in 0..2 {
        release.send(()).unwrap();
    }
    let answers = [worker.wait_for(|_| true), worker.wait_for(|_| true)];
    assert_eq!(answers, [Some(1), Some(9)]);
}

#[test]
fn the_latest_answer_drops_those_before_it() {
    let worker = Worker::serving_latest(|(), answers| {
        for answer in 1..=3 {
            answers.send(answer);
        }
        answers.send(0);
    });
    assert_eq!(worker.latest_answer(), None);
    worker.ask(());
    assert_eq!(worker.wait_for(|&answer| answer == 2), Some(2));
    // Whether 3 and 0 are both there is up to the thread; the last to come is always 0.
    let mut last = None;
    while last != Some(0) {
        last = worker.latest_answer().or(last);
    }
    assert_eq!(worker.latest_answer(), None);
}

#[test]
fn the_thread_ends_when_the_worker_is_dropped() {
    let (alive, ended) = channel::<()>();
    let worker = Worker::serving_all(
        move |(), answers: &lightfall_platform::worker::Answers<()>| {
            let _ = &alive;
            answers.send(());
        },
    );
    worker.ask(());
    drop(worker);
    // The sender lives as long as the thread's closure.
    assert_eq!(
        ended.recv_timeout(PATIENCE),
        Err(std::sync::mpsc::RecvTimeoutError::Disconnected)
    );
}

#[test]
fn waiting_for_a_thread_that_has_panicked_ends() {
    let worker: Worker<(), ()> = Worker::serving_all(|(), _| panic!("as the test asks"));
    worker.ask(());
    assert_eq!(worker.wait_for(|()| true), None);
    worker.ask(());
    assert_eq!(worker.latest_answer(), None);
}
