//! Tables in Markdown, for people.

use std::fmt::Display;

/// A table with this head: its columns, separated by `|`. So are the cells of each row.
pub fn table(head: &str, rows: impl IntoIterator<Item = impl Display>) -> String {
    let rule = "|---".repeat(head.split('|').count());
    let rows = rows.into_iter().map(|row| format!("| {row} |\n"));
    format!("| {head} |\n{rule}|\n") + &rows.collect::<String>()
}

/// The same with a line in front of each group of rows. A row has the name of its group, and cells.
pub(super) fn grouped_table<'a>(
    head: &str,
    rows: impl IntoIterator<Item = (&'a str, String)>,
) -> String {
    let rest = " |".repeat(head.split('|').count() - 1);
    let mut last = "";
    let rows = rows.into_iter().flat_map(|(group, row)| {
        let title = (group != last).then(|| format!("**{group}**{rest}"));
        last = group;
        title.into_iter().chain([row])
    });
    table(head, rows)
}
