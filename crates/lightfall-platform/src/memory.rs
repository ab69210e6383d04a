//! How much memory the program may still take.

/// The memory that the program can still take before the system refuses it, in bytes: the least of
/// what is free, what the control group leaves, and what the limit of address space leaves. `None` where
/// the system does not say.
#[must_use]
pub fn free_memory() -> Option<u64> {
    let free = table_value("/proc/meminfo", "MemAvailable:").map(|kibibytes| kibibytes << 10);
    let limits = [free, left_by_group(), left_by_limit()];
    limits.into_iter().flatten().min()
}

/// What the control group of this process leaves (Linux, version 2).
fn left_by_group() -> Option<u64> {
    let number = |name: &str| -> Option<u64> {
        let text = std::fs::read_to_string(format!("/sys/fs/cgroup/{name}")).ok()?;
        text.trim().parse().ok()
    };
    Some(number("memory.max")?.saturating_sub(number("memory.current")?))
}

/// What the limit of address space leaves (`ulimit -v`).
fn left_by_limit() -> Option<u64> {
    let limit = table_value("/proc/self/limits", "Max address space")?;
    let taken = table_value("/proc/self/status", "VmSize:")? << 10;
    Some(limit.saturating_sub(taken))
}

/// The first number in the line of a file that begins with these words.
fn table_value(file: &str, words: &str) -> Option<u64> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(words))?;
    line.split_whitespace().next()?.parse().ok()
}
