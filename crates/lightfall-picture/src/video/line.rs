//! Lines for a shell, which make something of a film or a film of pictures.

use std::path::Path;

/// A file's name, quoted for a shell if necessary. With a dash at its beginning, ffmpeg would take it for
/// an option, and with a colon in its first part for a protocol.
#[must_use]
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-%+=:,@".contains(c);
    let first = word.split('/').next().unwrap_or_default();
    let word = if word.starts_with('-') || first.contains(':') && Path::new(word).is_relative() {
        format!("./{word}")
    } else {
        word.to_owned()
    };
    if word.chars().all(plain) {
        word
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

/// A file's name as the value of an option in a description of filters: ffmpeg reads the value, and before
/// that the description.
#[must_use]
pub fn filter_value(name: &str) -> String {
    escaped(&escaped(name, "\\':"), "\\'[],;")
}

fn escaped(text: &str, special: &str) -> String {
    let escape = |c: char| special.contains(c).then_some('\\').into_iter().chain([c]);
    text.chars().flat_map(escape).collect()
}

/// Lines that make pages' and messages' moving pictures of a film: AVIF, WebP and GIF.
#[must_use]
pub fn loop_lines(film: &Path) -> [String; 3] {
    let name = |file: &Path| quoted(&file.display().to_string());
    let line = |options: &str, extension: &str| {
        format!(
            "ffmpeg -i {} {options} {}",
            name(film),
            name(&film.with_extension(extension))
        )
    };
    [
        line("-c:v libsvtav1 -crf 30 -pix_fmt yuv420p10le", "avif"),
        line(
            "-vf scale=480:-2 -c:v libwebp_anim -quality 80 -loop 0",
            "webp",
        ),
        line(
            "-vf 'fps=source_fps/2,scale=320:-2:flags=lanczos,split[a][b];[a]palettegen[p];[b][p]paletteuse' -loop 0",
            "gif",
        ),
    ]
}
