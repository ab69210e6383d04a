//! Where the program says why it ends.

use lightfall::commands::StandardError;

/// On Windows a standard error exists or not, leads to a console or not, and a console has a number
/// of programs that use it: 1 after a double click, 2 in a shell, 0 for a terminal that is no console
/// of Windows.
#[test]
fn a_message_box_is_shown_only_where_nobody_reads_standard_error() {
    for (exists, is_terminal, processes, expected, is_read) in [
        (true, true, 2, StandardError::Terminal, true),
        (true, true, 0, StandardError::Terminal, true),
        (true, true, 1, StandardError::OwnConsole, false),
        // A script or a test that reads what is said must not wait for a click.
        (true, false, 1, StandardError::Redirected, true),
        (true, false, 0, StandardError::Redirected, true),
        (false, false, 0, StandardError::Nowhere, false),
    ] {
        let found = StandardError::of(exists, is_terminal, processes);
        assert_eq!((found, found.is_read()), (expected, is_read));
    }
}
