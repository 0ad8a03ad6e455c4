//! What every page that the program writes has in common: one HTML file that loads nothing. Its policy allows its own script and
//! style, named by their hashes, and nothing else.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
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
    /// JSON without `</`.
    pub data: &'a str,
}

impl Page<'_> {
    /// The page as HTML. Title, heading and body are HTML already ([`escaped`]).
    pub fn html(&self) -> String {
        let Page { title, heading, style, script, body, data } = self;
        let policy = format!(
            "default-src 'none'; script-src '{}'; style-src '{}'; base-uri 'none'; form-action 'none'",
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

/// Text escaped for HTML content and attributes.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
