//! Plays the cockpit's sound on the system's audio device, which is open only while there is
//! something to hear. A thread opens it, because that can take long, and the device's own thread
//! asks for samples: neither ever waits for a frame.

use crate::app::state::sound::{CockpitSound, SoundFault};
use bevy::prelude::*;
use cpal::traits::{DeviceTrait, HostTrait, StreamTrait};
use cpal::{
    BufferSize, BuildStreamError, DefaultStreamConfigError, Device, FromSample, OutputCallbackInfo,
    SampleFormat, SizedSample, Stream, StreamConfig,
};
use lightfall_core::optics::sound::{Cockpit, Readings};
use std::fmt::Display;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, OnceLock};
use std::thread;

/// The device is closed after so many seconds of silence: long after the sound has faded.
const CLOSE_SECONDS: f32 = 4.0;
/// Samples that the device is asked to take at once, where it can: some hundredths of a second, so
/// that neither the sound is late nor a busy machine interrupts it.
const BUFFER_FRAMES: u32 = 1024;
/// Chooses the engine's noise and the moments of the clicks.
const SEED: u64 = 1;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<CockpitSound>()
        .init_resource::<SoundFault>()
        .init_resource::<Speaker>()
        .add_systems(PostUpdate, play);
}

/// The readings, shared with the thread that asks for samples. Each is a number of its own: it does
/// no harm if one is a frame newer than another.
#[derive(Default)]
struct Shared {
    readings: [AtomicU64; 4],
    /// Why there is no sound. It is said once.
    fault: OnceLock<String>,
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

    fn say(&self, fault: &impl Display) {
        let sentence = format!("No sound: {fault}; everything else goes on");
        if self.fault.set(sentence.clone()).is_ok() {
            warn!("{sentence}");
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
fn play(
    time: Res<Time<Real>>,
    sound: Res<CockpitSound>,
    mut speaker: ResMut<Speaker>,
    mut said: ResMut<SoundFault>,
) {
    speaker.shared.write(sound.readings);
    if said.0.is_none() {
        // The settings show it beside the volume.
        if let Some(fault) = speaker.shared.fault.get() {
            said.0 = Some(fault.clone());
        }
    }
    if sound.readings.volume > 0.0 && sound.may_play {
        speaker.silence = 0.0;
        if speaker.open.is_none() {
            let (open, close) = channel();
            let shared = speaker.shared.clone();
            let thread = thread::Builder::new().name("sound".into());
            if let Err(fault) = thread.spawn(move || keep_open(&shared, &close)) {
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
fn keep_open(shared: &Arc<Shared>, close: &Receiver<()>) {
    // ALSA's library would print its own lines when there is no device.
    #[cfg(target_os = "linux")]
    let _kept = alsa::Output::local_error_handler();
    match open(shared) {
        // Nothing is ever sent: the channel ends when its other end is dropped.
        Ok(_stream) => drop(close.recv()),
        Err(fault) => shared.say(&fault),
    }
}

/// A stream that plays on the system's device.
fn open(shared: &Arc<Shared>) -> Result<Stream, String> {
    const NO_DEVICE: &str = "there is no audio device";
    let device = cpal::default_host().default_output_device();
    let device = device.ok_or(NO_DEVICE)?;
    let usual = device
        .default_output_config()
        .map_err(|fault| match fault {
            DefaultStreamConfigError::DeviceNotAvailable => NO_DEVICE.to_owned(),
            other => other.to_string(),
        })?;
    let build = match usual.sample_format() {
        SampleFormat::F32 => build_stream::<f32>,
        SampleFormat::I32 => build_stream::<i32>,
        SampleFormat::I16 => build_stream::<i16>,
        SampleFormat::U8 => build_stream::<u8>,
        other => {
            return Err(format!(
                "the audio device takes samples of the kind {other}"
            ));
        }
    };
    let mut config = usual.config();
    config.buffer_size = BufferSize::Fixed(BUFFER_FRAMES);
    let stream = build(&device, &config, shared).or_else(|_| {
        config.buffer_size = BufferSize::Default;
        build(&device, &config, shared)
    });
    let stream = stream.map_err(|fault| fault.to_string())?;
    stream.play().map_err(|fault| fault.to_string())?;
    Ok(stream)
}

/// A stream of one kind of samples. Every channel plays the same.
fn build_stream<T: SizedSample + FromSample<f32>>(
    device: &Device,
    config: &StreamConfig,
    shared: &Arc<Shared>,
) -> Result<Stream, BuildStreamError> {
    let mut cockpit = Cockpit::new(config.sample_rate, SEED);
    let channels = usize::from(config.channels.max(1));
    let (readings, faults) = (shared.clone(), shared.clone());
    device.build_output_stream(
        config,
        move |frames: &mut [T], _: &OutputCallbackInfo| {
            cockpit.read(readings.read());
            for frame in frames.chunks_mut(channels) {
                frame.fill(T::from_sample(cockpit.sample()));
            }
        },
        move |fault| faults.say(&fault),
        None,
    )
}
