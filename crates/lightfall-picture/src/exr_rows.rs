//! EXR files that are written some rows at a time. They are the files that
//! [`write_exr`](super::write_exr) writes.

use super::file::PictureError;
use super::headless::check_not_asked_to_end;
use super::open_exr::{Linear, file_attributes, layer};
use super::{Channels, ExrCompression, exr_header};
use exr::block::chunk::Chunk;
use exr::block::writer::ChunksWriter;
use exr::block::{BlockIndex, UncompressedBlock};
use exr::image::write::channels::{ChannelsWriter, WritableChannels};
use exr::image::write::layers::WritableLayers;
use exr::meta::header::Header;
use exr::prelude::Vec2;
use glam::UVec2;
use lightfall_platform::storage::{NewFile, WriteError};
use lightfall_render::{Captured, LIGHT_BYTES};
use rayon::prelude::*;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Maximum size of a header, in bytes: a preset has a few kilobytes.
const MAX_HEADER: u64 = 1 << 20;

/// Fewest rows that are traced and encoded at once: with fewer, a graphics card mostly waits.
const MIN_ROWS_AT_ONCE: u32 = 16;

/// Most of them, so that a machine with many threads needs no more memory.
const MAX_ROWS_AT_ONCE: u32 = 64;

/// What takes the next rows of a picture: their light, and the numbers of each channel.
pub(super) type TakeRows<'a> =
    &'a mut dyn FnMut(Captured, Vec<Vec<f32>>) -> Result<(), PictureError>;

/// The number of rows that are traced and encoded at once: a block of the file on each thread, if that
/// is neither too few rows nor too many.
#[must_use]
pub fn rows_at_once(compression: ExrCompression) -> u32 {
    let in_block = compression.method().scan_lines_per_block() as u32;
    let [min, max] = [MIN_ROWS_AT_ONCE, MAX_ROWS_AT_ONCE].map(|rows| rows.div_ceil(in_block));
    in_block * (rayon::current_num_threads() as u32).clamp(min, max)
}

/// Writes an EXR of this size whose rows `draw` gives from the top, in runs that are whole blocks long,
/// except the last one. `picture` is what the file says of it, without rows. The file appears under its
/// name only when it is complete.
///
/// # Errors
/// Those of `draw`; or the encoding failed, or the file cannot be written.
pub(super) fn write_exr_rows(
    path: &Path,
    size: UVec2,
    picture: &Linear,
    draw: impl FnOnce(TakeRows) -> Result<(), PictureError>,
) -> Result<(), PictureError> {
    let headers = layer(picture.without_rows(), size).infer_headers(&file_attributes(size));
    let mut file = NewFile::create(path)?;
    // The crate's own errors know nothing of those of `draw`.
    let mut failure = None;
    let mut blocks = 0;
    let written = exr::block::write(
        BufWriter::new(file.file()),
        headers,
        true,
        |meta, chunks| {
            let header = &meta.headers[0];
            let drawn = draw(&mut |light, samples| {
                // Tracing the rays of a strip takes as long as drawing it, which checks this itself.
                check_not_asked_to_end()?;
                let in_block = header.compression.scan_lines_per_block();
                let rows = picture.with_rows((blocks * in_block) as u32, light, samples);
                let encoded = encoded(rows, header, blocks)
                    .map_err(|error| PictureError::encode(path, &error))?;
                for chunk in encoded {
                    chunks
                        .write_chunk(blocks, chunk)
                        .map_err(|error| written_fault(path, error))?;
                    blocks += 1;
                }
                Ok(())
            });
            drawn.map_err(|error| {
                failure = Some(error);
                exr::error::Error::Aborted
            })
        },
    );
    if let Some(error) = failure {
        return Err(error);
    }
    written.map_err(|error| written_fault(path, error))?;
    sort_header(&mut file, path)?;
    Ok(file.finish()?)
}

/// The blocks of some rows, compressed. The first of them is the block of this number in the file.
fn encoded(rows: Linear, header: &Header, first: usize) -> exr::error::Result<Vec<Chunk>> {
    let size = rows.light.size;
    let layer = layer(rows, size);
    let own_headers = layer.infer_headers(&file_attributes(size));
    let own = &own_headers[0];
    let writer = layer.channel_data.create_writer(own);
    let in_block = header.compression.scan_lines_per_block();
    let height = size.y as usize;
    let blocks: Vec<usize> = (0..height.div_ceil(in_block)).collect();
    blocks
        .into_par_iter()
        .map(|block| {
            let top = block * in_block;
            let mut index = BlockIndex {
                layer: 0,
                pixel_position: Vec2(0, top),
                pixel_size: Vec2(size.x as usize, in_block.min(height - top)),
                level: Vec2(0, 0),
            };
            let data = writer.extract_uncompressed_block(own, index);
            index.pixel_position = Vec2(0, (first + block) * in_block);
            UncompressedBlock { index, data }.compress_to_chunk(std::slice::from_ref(header))
        })
        .collect()
}

fn written_fault(path: &Path, error: exr::error::Error) -> PictureError {
    match error {
        exr::error::Error::Io(error) => WriteError::new(path, error).into(),
        error => PictureError::encode(path, &error),
    }
}

/// Sorts the attributes of the header, whose order would differ in every run.
fn sort_header(file: &mut NewFile, path: &Path) -> Result<(), PictureError> {
    let written = |error| PictureError::from(WriteError::new(path, error));
    let file = file.file();
    let mut start = Vec::new();
    file.seek(SeekFrom::Start(0)).map_err(written)?;
    Read::by_ref(file)
        .take(MAX_HEADER)
        .read_to_end(&mut start)
        .map_err(written)?;
    exr_header::sort_attributes(&mut start)
        .ok_or_else(|| PictureError::encode(path, &"its header cannot be read"))?;
    file.seek(SeekFrom::Start(0)).map_err(written)?;
    file.write_all(&start).map_err(written)
}

/// The bytes of a pixel in the file before compression: light in half floats, and a number for each
/// channel.
#[must_use]
pub fn exr_pixel_bytes(channels: &Channels) -> u64 {
    LIGHT_BYTES as u64 + 4 * channels.list().len() as u64
}
