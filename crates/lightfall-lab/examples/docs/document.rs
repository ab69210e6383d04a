//! A document with marked blocks: `<!-- table NAME -->` or `<!-- source FILE -->`, the block, and
//! `<!-- end -->`.

use crate::measured::provenance;

const OPEN: &str = "<!-- ";
const CLOSE: &str = " -->";
const END: &str = "<!-- end -->";

/// The text with every block rendered: a table by `table`, and the line about a source by its CSV file.
pub fn rendered(
    text: &str,
    table: impl Fn(&str) -> Result<String, String>,
) -> Result<String, String> {
    let mut parts: Vec<&str> = text.split(END).collect();
    let rest = parts.pop().unwrap_or_default();
    let mut result = String::new();
    for part in parts {
        let mark = part.rsplit_once(OPEN);
        let (before, block) = mark.ok_or_else(|| format!("{END} without a mark before it"))?;
        let (mark, _) = block.split_once(CLOSE).unwrap_or((block, ""));
        let inside = match mark.split_once(' ') {
            Some(("table", name)) => table(name)?,
            Some(("source", file)) => provenance(file)?,
            _ => {
                return Err(format!(
                    "{OPEN}{mark}{CLOSE} is neither a table nor a source"
                ));
            }
        };
        let inside = inside.trim();
        result += &format!("{before}{OPEN}{mark}{CLOSE}\n{inside}\n{END}");
    }
    Ok(result + rest)
}
