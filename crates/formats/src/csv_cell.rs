//! CSV cells with text from people or files.
//!
//! A spreadsheet computes a cell that begins with `=`, `+`, `-` or `@`, so a name or a reason could open an address or
//! start a program where the table is opened. Such text gets a leading apostrophe, which marks text in spreadsheets.
//! Numbers are written without it, by other writers.

/// Characters that begin a formula in spreadsheets, including the wide forms of East Asian keyboards; some spreadsheets
/// skip tabs and line ends first.
const BEGINS_FORMULA: [char; 11] = ['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'];

/// Text as a cell of CSV (RFC 4180): with a leading apostrophe if a spreadsheet would compute it, and in quotation
/// marks if it contains commas, quotation marks or line ends. A negative number is unchanged.
///
/// [`text_of_cell`] is the inverse after removal of the quotation marks. `O(n)`.
pub fn text_cell(text: &str) -> String {
    let text = if is_computed(text) { format!("'{text}") } else { text.to_owned() };
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// The text passed to [`text_cell`], from a cell without its quotation marks: removes the apostrophe in front of a
/// formula.
pub fn text_of_cell(cell: &str) -> &str {
    cell.strip_prefix('\'').filter(|text| is_computed(text)).unwrap_or(cell)
}

/// Whether text gets an apostrophe: if it begins a formula, also after apostrophes of its own, so that the inverse
/// loses none.
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
            // None of these texts needs quotation marks.
            assert_eq!(text_of_cell(&text_cell(text)), text);
        }
    }
}
