//! Lightfall.
