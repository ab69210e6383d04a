//! Reports the outcome of an edit of the shaders' files while the program runs.

use crate::app::state::toast::Toast;
use bevy::prelude::*;
use lightfall_platform::log::say;
use lightfall_render::{LiveShaders, ShaderNews};
use std::time::Duration;

/// How long a fault stays, unless it is mended or something else is said.
const FAULT_DURATION: Duration = Duration::from_secs(24 * 3600);

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, say_shader_news);
}

fn say_shader_news(live: Res<LiveShaders>, mut said: Local<ShaderNews>, mut toast: ResMut<Toast>) {
    let news = live.news();
    if *said == *news {
        return;
    }
    if let Some(fault) = &news.fault {
        let sentence = format!("The last shaders stay, because of {fault}");
        say(format_args!("lightfall: {sentence}"));
        toast.say_for(FAULT_DURATION, sentence);
    } else {
        toast.say("The shaders have been read again.");
    }
    *said = news.clone();
}
