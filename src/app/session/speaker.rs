//! Plays the cockpit's sound on the system's audio device, which is open only while there is
//! something to hear. A thread opens it, because that can take long, and the device's own thread
//! asks for samples: neither ever waits for a frame.

use crate::app::state::sound::CockpitSound;
use bevy::prelude::*;
use lightfall_core::optics::sound::{Cockpit, Readings};
use rodio::{ChannelCount, DeviceSinkBuilder, Sample, SampleRate, Source};
use std::error::Error;
use std::num::NonZero;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Duration;

/// The device is closed after so many seconds of silence: long after the sound has faded.
const CLOSE_SECONDS: f32 = 4.0;
/// Samples between two looks at the readings: five milliseconds or so.
const READ_EVERY: u32 = 256;
/// Chooses the engine's noise and the moments of the clicks.
const SEED: u64 = 1;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<CockpitSound>()
        .init_resource::<Speaker>()
        .add_systems(PostUpdate, play);
}

/// The readings, shared with the thread that asks for samples. Each is a number of its own: it does
/// no harm if one is a frame newer than another.
#[derive(Default)]
struct Shared {
    readings: [AtomicU64; 4],
    /// Whether it was said that there is no sound. Once is enough.
    was_said: AtomicBool,
}

impl Shared {
    fn write(&self, readings: Readings) {
        let Readings {
            home_light,
            thrust,
            flux,
            volume,
        } = readings;
        for (shared, value) in self.readings.iter().zip([home_light, thrust, flux, volume]) {
            shared.store(value.to_bits(), Ordering::Relaxed);
        }
    }

    fn read(&self) -> Readings {
        let value = |i: usize| f64::from_bits(self.readings[i].load(Ordering::Relaxed));
        Readings {
            home_light: value(0),
            thrust: value(1),
            flux: value(2),
            volume: value(3),
        }
    }

    fn say(&self, fault: &dyn Error) {
        if !self.was_said.swap(true, Ordering::Relaxed) {
            let causes = std::iter::successors(Some(fault), |fault| fault.source());
            let causes: Vec<String> = causes.map(ToString::to_string).collect();
            warn!("no sound: {}; everything else goes on", causes.join(": "));
        }
    }
}

/// The audio device, if it is open.
#[derive(Resource, Default)]
struct Speaker {
    shared: Arc<Shared>,
    /// Dropping this closes the device.
    open: Option<Sender<()>>,
    /// Seconds of silence.
    silence: f32,
}

/// Hands the readings on, and opens and closes the device.
fn play(time: Res<Time<Real>>, sound: Res<CockpitSound>, mut speaker: ResMut<Speaker>) {
    speaker.shared.write(sound.readings);
    if sound.readings.volume > 0.0 && sound.may_play {
        speaker.silence = 0.0;
        if speaker.open.is_none() {
            let (open, close) = channel();
            let shared = speaker.shared.clone();
            let thread = thread::Builder::new().name("sound".into());
            if let Err(fault) = thread.spawn(move || keep_open(shared, &close)) {
                speaker.shared.say(&fault);
            }
            speaker.open = Some(open);
        }
    } else if speaker.open.is_some() {
        speaker.silence += time.delta_secs();
        if speaker.silence > CLOSE_SECONDS {
            speaker.open = None;
        }
    }
}

/// Opens the system's device and lets it play until the other end of the channel is dropped.
fn keep_open(shared: Arc<Shared>, close: &Receiver<()>) {
    // ALSA's library would print its own lines when there is no device.
    #[cfg(target_os = "linux")]
    let _kept = alsa::Output::local_error_handler();
    let on_fault = {
        let shared = shared.clone();
        move |fault| shared.say(&fault)
    };
    let opened = DeviceSinkBuilder::from_default_device()
        .and_then(|device| device.with_error_callback(on_fault).open_sink_or_fallback());
    match opened {
        Ok(mut device) => {
            device.log_on_drop(false);
            let rate = device.config().sample_rate();
            device.mixer().add(Voices {
                cockpit: Cockpit::new(rate.get(), SEED),
                shared,
                rate,
                left: 0,
            });
            // It is an error that the other end is dropped, and nothing is ever sent.
            close.recv().ok();
        }
        Err(fault) => shared.say(&fault),
    }
}

/// The cockpit's voices as rodio plays them.
struct Voices {
    cockpit: Cockpit,
    shared: Arc<Shared>,
    rate: SampleRate,
    /// Samples until the readings are looked at.
    left: u32,
}

impl Iterator for Voices {
    type Item = Sample;

    fn next(&mut self) -> Option<Sample> {
        if self.left == 0 {
            self.cockpit.read(self.shared.read());
            self.left = READ_EVERY;
        }
        self.left -= 1;
        Some(self.cockpit.sample())
    }
}

impl Source for Voices {
    fn current_span_len(&self) -> Option<usize> {
        None
    }

    fn channels(&self) -> ChannelCount {
        NonZero::<u16>::MIN
    }

    fn sample_rate(&self) -> SampleRate {
        self.rate
    }

    fn total_duration(&self) -> Option<Duration> {
        None
    }
}
