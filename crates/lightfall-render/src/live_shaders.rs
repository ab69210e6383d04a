//! The shaders of the passes while their files are edited: the texts are linked again from a folder
//! when one of its files changes. Without such a folder they are those that the program was built
//! with, and nothing here runs.
//!
//! A text that is not valid never reaches Bevy: the shaders before it stay, and with them the last
//! picture.

use bevy::prelude::*;
use lightfall_core::gpu::{ShaderFault, ShaderFiles, ShaderText};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use std::{fs, io};

/// Time between two looks at the folder.
const INTERVAL: Duration = Duration::from_millis(300);

/// The shaders of the passes, and the folder that they are linked from.
#[derive(Resource, Default)]
pub struct LiveShaders {
    folder: Option<Folder>,
    shaders: Vec<LiveShader>,
    news: ShaderNews,
}

/// The outcome of the edits so far.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ShaderNews {
    /// How often an edit has changed a shader.
    pub reloads: u32,
    /// What is wrong with the files as they are.
    pub fault: Option<String>,
}

/// A folder of WGSL files.
struct Folder {
    path: PathBuf,
    /// Its files as they were last read without a fault.
    files: Option<ShaderFiles>,
    /// When each file was written, at the last look.
    times: Vec<(PathBuf, SystemTime)>,
    /// The time of the last look since the start.
    looked: Option<Duration>,
}

/// A shader that Bevy knows.
struct LiveShader {
    id: AssetId<Shader>,
    name: &'static str,
    built_in: ShaderText,
    /// Its text at present.
    source: String,
}

impl LiveShaders {
    /// Shaders that are linked from a folder, if one is given.
    #[must_use]
    pub fn new(folder: Option<PathBuf>) -> Self {
        let folder = folder.map(|path| Folder {
            path,
            files: None,
            times: Vec::new(),
            looked: None,
        });
        Self {
            folder,
            ..Self::default()
        }
    }

    /// The outcome of the edits so far.
    #[must_use]
    pub fn news(&self) -> &ShaderNews {
        &self.news
    }

    /// The source of a shader that a pass asks for: as the folder has it, or as it was built in
    /// where that has a fault.
    pub(super) fn source(&mut self, text: &ShaderText) -> String {
        let files = self
            .folder
            .as_ref()
            .and_then(|folder| folder.files.as_ref());
        match files.map(|files| linked(text, files)) {
            None => text.source(),
            Some(Ok(source)) => source,
            Some(Err(fault)) => {
                self.news.fault = Some(fault.to_string());
                text.source()
            }
        }
    }

    /// Remembers a shader that Bevy has, so that a new text can replace it.
    pub(super) fn remember(
        &mut self,
        id: AssetId<Shader>,
        name: &'static str,
        built_in: ShaderText,
        source: String,
    ) {
        if self.folder.is_none() {
            return;
        }
        self.shaders.retain(|shader| shader.id != id);
        self.shaders.push(LiveShader {
            id,
            name,
            built_in,
            source,
        });
    }

    /// Whether there is a folder.
    pub(super) fn is_watching(shaders: Res<Self>) -> bool {
        shaders.folder.is_some()
    }

    /// Reads the folder again if a file has changed since the last look, and returns the shaders
    /// that have another text. `now` is the time since the start.
    pub(super) fn look(&mut self, now: Duration) -> Vec<(AssetId<Shader>, Shader)> {
        let Some(folder) = &mut self.folder else {
            return Vec::new();
        };
        if folder.looked.is_some_and(|looked| now < looked + INTERVAL) {
            return Vec::new();
        }
        folder.looked = Some(now);
        let mut times = Vec::new();
        let found = add_times(&folder.path, &mut times);
        // A file that is being replaced is not there for a moment.
        if found.is_err() || times == folder.times {
            return Vec::new();
        }
        folder.times = times;
        match relinked(&folder.path, &self.shaders) {
            Ok((files, sources)) => {
                folder.files = Some(files);
                self.news.fault = None;
                self.take(sources)
            }
            Err(fault) => {
                self.news.fault = Some(fault);
                Vec::new()
            }
        }
    }

    /// Takes new sources, and returns the shaders whose source differs from the present one.
    fn take(&mut self, sources: Vec<String>) -> Vec<(AssetId<Shader>, Shader)> {
        let mut changed = Vec::new();
        for (shader, source) in self.shaders.iter_mut().zip(sources) {
            if shader.source != source {
                shader.source.clone_from(&source);
                changed.push((shader.id, Shader::from_wgsl(source, shader.name)));
            }
        }
        self.news.reloads += u32::from(!changed.is_empty());
        changed
    }
}

/// Adds the shader of a pass.
pub(super) fn add_shader(
    app: &mut App,
    handle: &Handle<Shader>,
    text: ShaderText,
    name: &'static str,
) {
    let source = text.source();
    let shader = Shader::from_wgsl(source.clone(), name);
    let mut shaders = app.world_mut().resource_mut::<Assets<Shader>>();
    if let Err(error) = shaders.insert(handle.id(), shader) {
        error!("the shader {name} could not be added: {error}");
    }
    let mut live = app.world_mut().get_resource_or_init::<LiveShaders>();
    live.remember(handle.id(), name, text, source);
}

/// The files of a folder, and the source of each shader that is linked from them.
fn relinked(folder: &Path, shaders: &[LiveShader]) -> Result<(ShaderFiles, Vec<String>), String> {
    let files = ShaderFiles::read(folder).map_err(|error| error.to_string())?;
    let sources = shaders.iter().map(|shader| {
        // A source that has not changed is valid.
        let source = shader.built_in.linked_from(&files).source();
        if source == shader.source {
            Ok(source)
        } else {
            linked(&shader.built_in, &files)
        }
    });
    let sources: Result<_, ShaderFault> = sources.collect();
    Ok((files, sources.map_err(|fault| fault.to_string())?))
}

/// The source of a shader that is linked from these files.
fn linked(built_in: &ShaderText, files: &ShaderFiles) -> Result<String, ShaderFault> {
    let text = built_in.linked_from(files);
    // A page in a browser has no folder.
    #[cfg(not(target_arch = "wasm32"))]
    text.validate_in_place_of(built_in)?;
    Ok(text.source())
}

/// Adds the times at which the files of a folder were written.
fn add_times(folder: &Path, times: &mut Vec<(PathBuf, SystemTime)>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let about = entry.metadata()?;
        if about.is_dir() {
            add_times(&entry.path(), times)?;
        } else {
            times.push((entry.path(), about.modified()?));
        }
    }
    Ok(())
}
