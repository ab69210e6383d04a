//! The arguments of `lightfall render` for sequences that several processes draw.

use clap::Args;
use lightfall_picture::Shard;

/// Which frames of a sequence a process draws, and what it writes of them.
#[derive(Clone, Debug, Default, PartialEq, Eq, Args)]
#[command(next_help_heading = "Many machines")]
pub struct FarmArgs {
    /// Draw the K-th of N parts of --frames: those whose place in the list is K, K + N, K + 2N and so on.
    /// Also writes a manifest NAME.K-of-N.jsonl
    #[arg(
        long,
        value_name = "K/N",
        requires = "frames",
        allow_hyphen_values = true
    )]
    pub shard: Option<Shard>,
    /// Draw only the frames whose files are missing or end too early. A file that holds another picture than
    /// these options draw is refused
    #[arg(long, requires = "frames")]
    pub resume: bool,
    /// Write NAME.jsonl beside the pictures: a line with frame, file, SHA-256, time, version, adapter and
    /// machine for each
    #[arg(long, requires = "frames")]
    pub manifest: bool,
}
