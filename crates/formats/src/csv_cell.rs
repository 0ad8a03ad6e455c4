//! Cells of tables as CSV with text that people or files wrote.
//!
//! A spreadsheet computes a cell that begins with `=`, `+`, `-` or `@`, so that a name or a reason could open an address or start
//! a program where the table is opened. Such text gets an apostrophe in front, which spreadsheets take for "this is text".
//! Numbers are written by their own writers, without this.

/// What a spreadsheet takes for the beginning of a formula, also in the wide forms of East Asian keyboards; a tab and line ends are
/// skipped by some before they look.
const BEGINS_FORMULA: [char; 11] = ['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'];

/// Text as a cell of CSV (RFC 4180): with an apostrophe in front where a spreadsheet would compute it, and in quotation marks
/// where it has commas, quotation marks or line ends. A negative number stays as it is.
///
/// [`text_of_cell`] is its inverse once the quotation marks are gone. `O(n)`.
pub fn text_cell(text: &str) -> String {
    let text = if is_computed(text) { format!("'{text}") } else { text.to_owned() };
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// The text that [`text_cell`] wrote, from a cell without its quotation marks: the apostrophe in front of what a spreadsheet would
/// compute is removed.
pub fn text_of_cell(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|text| is_computed(text)).unwrap_or(cell)
}

/// Whether text gets an apostrophe: if it begins a formula, also after apostrophes of its own, so that none is lost on the way back.
fn is_computed(text: &str) -> bool {
    let rest = text.trim_start_matches('\'');
    let is_number = rest.starts_with('-') && rest.parse::<f64>().is_ok_and(f64::is_finite);
    rest.starts_with(BEGINS_FORMULA) && !is_number
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_spreadsheet_would_compute_is_text() {
        for (text, cell) in [
            ("=HYPERLINK(\"//x\";\"y\")", "\"'=HYPERLINK(\"\"//x\"\";\"\"y\"\")\""),
            ("=1+1", "'=1+1"),
            ("+1", "'+1"),
            ("-rf", "'-rf"),
            ("-1+cmd|' /C calc'!A0", "'-1+cmd|' /C calc'!A0"),
            ("-inf", "'-inf"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("\t=1", "'\t=1"),
            ("\r=1", "\"'\r=1\""),
            ("＝1", "'＝1"),
            ("'=1", "''=1"),
        ] {
            assert_eq!(text_cell(text), cell, "{text:?}");
        }
        for text in ["", "a", "-1.5", "-2e-3", "a=b", "O'Neil", "'quoted'", "1,5", "say \"x\""] {
            assert!(!text_cell(text).trim_start_matches('"').starts_with("'-"), "{text}");
            assert_eq!(text_cell(text).trim_matches('"').replace("\"\"", "\""), text.trim_matches('"'), "{text}");
        }
    }

    #[test]
    fn text_comes_back_as_it_was() {
        for text in ["=1", "'=1", "''@x", "'", "''", "-1", "'-1", "-x", "plain", "\t-", "'a", ""] {
            // None of them needs quotation marks.
            assert_eq!(text_of_cell(&text_cell(text)), text);
        }
    }
}
