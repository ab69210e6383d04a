//! The buffers of the uniforms that a scene's shaders read beside the scene's own numbers.

use bevy::platform::collections::HashMap;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};

/// The uniforms that scenes have needed so far, by their bindings.
#[derive(Default)]
pub(crate) struct InputBuffers(HashMap<u32, Input>);

struct Input {
    buffer: Buffer,
    contents: Vec<u8>,
}

impl InputBuffers {
    /// Writes what differs from the contents before. Returns whether a buffer is new.
    pub(super) fn write(
        &mut self,
        inputs: Vec<(u32, Vec<u8>)>,
        device: &RenderDevice,
        queue: &RenderQueue,
    ) -> bool {
        let before = self.0.len();
        for (binding, contents) in inputs {
            match self.0.get_mut(&binding) {
                Some(input) if input.contents == contents => {}
                Some(input) => {
                    queue.write_buffer(&input.buffer, 0, &contents);
                    input.contents = contents;
                }
                None => {
                    let buffer = device.create_buffer_with_data(&BufferInitDescriptor {
                        label: Some("input of a scene"),
                        contents: &contents,
                        usage: BufferUsages::UNIFORM
                            | BufferUsages::STORAGE
                            | BufferUsages::COPY_DST,
                    });
                    self.0.insert(binding, Input { buffer, contents });
                }
            }
        }
        self.0.len() > before
    }

    /// The buffer of a binding, if a scene has needed it.
    pub(crate) fn buffer(&self, binding: u32) -> Option<&Buffer> {
        self.0.get(&binding).map(|input| &input.buffer)
    }
}
