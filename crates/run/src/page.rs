//! Frame of every page that the program writes: one HTML file that loads nothing. Its policy allows only its own script
//! and style, named by their hashes, and pictures that the script itself makes.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// A page.
#[derive(Debug, Clone, Copy)]
pub struct Page<'a> {
    /// Title of the window.
    pub title: &'a str,
    /// Heading.
    pub heading: &'a str,
    /// Style sheet.
    pub style: &'a str,
    /// Script; it finds `data` as JSON in the element `data`.
    pub script: &'a str,
    /// HTML after the heading.
    pub body: &'a str,
    /// Input of the script; it may contain any text.
    pub data: &'a Value,
}

impl Page<'_> {
    /// The page as HTML. Title, heading and body are HTML already ([`escaped`]).
    pub fn html(&self) -> String {
        let Page { title, heading, style, script, body, data } = self;
        let data = embedded(data);
        let policy = format!(
            "default-src 'none'; script-src '{}'; style-src '{}'; img-src data:; base-uri 'none'; form-action 'none'",
            hash(script),
            hash(style)
        );
        format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"referrer\" content=\"no-referrer\">\n<title>{title}</title>\n\
             <style>{style}</style>\n</head>\n<body>\n<main>\n<h1>{heading}</h1>\n\
             {body}</main>\n<script type=\"application/json\" id=\"data\">{data}</script>\n\
             <script>{script}</script>\n</body>\n</html>\n"
        )
    }
}

/// A source of a content security policy: the hash of an inline element.
pub(crate) fn hash(text: &str) -> String {
    format!("sha256-{}", BASE64.encode(Sha256::digest(text)))
}

/// JSON as the content of a `script` element. Characters that could end the element, or that scripts treat as line
/// breaks, are written as JSON escapes; they occur only inside strings, so the value stays the same.
///
/// Linear in the length of the JSON.
fn embedded(data: &Value) -> String {
    let json = data.to_string();
    let mut text = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            '<' => text.push_str("\\u003c"),
            '>' => text.push_str("\\u003e"),
            '&' => text.push_str("\\u0026"),
            '\u{2028}' => text.push_str("\\u2028"),
            '\u{2029}' => text.push_str("\\u2029"),
            c => text.push(c),
        }
    }
    text
}

/// Text escaped for HTML content and attributes.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn data_is_embedded_without_a_character_of_markup_and_stays_what_it_is() {
        let texts = ["</script><meta>", "<!--<script>", "]]>", "&lt;", "a\u{2028}b\u{2029}c", "\\u003c", "\"'\\"];
        for text in texts {
            let data = json!({ text: [text, 1.5] });
            let page = Page { title: "", heading: "", style: "", script: "", body: "", data: &data }.html();
            let (_, rest) = page.split_once("id=\"data\">").unwrap();
            let inside = rest.split_once('<').unwrap().0;
            assert!(rest[inside.len()..].starts_with("</script>\n<script>"), "{text} leaves the element");
            assert!(!inside.contains(['>', '&', '\u{2028}', '\u{2029}']), "{inside}");
            assert_eq!(serde_json::from_str::<Value>(inside).unwrap(), data);
        }
    }
}
