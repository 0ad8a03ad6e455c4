//! Content negotiation: the media type that `Accept` prefers (RFC 9110, section 12.5.1).

use axum::http::{HeaderMap, header};

/// Most ranges of an `Accept` header that are read; more than any client sends.
const MAX_RANGES: usize = 64;

/// The index of the offered media type that `Accept` prefers, the first among equals. The first type if the header is
/// absent or has no readable range. `None` if the client accepts none of them.
///
/// `offered` are types without parameters. The most specific of the ranges that match a type decides. Parameters other
/// than `q` are not compared, because no type is offered in two variants.
pub(super) fn preferred(headers: &HeaderMap, offered: &[&str]) -> Option<usize> {
    let lines = headers.get_all(header::ACCEPT).iter().filter_map(|value| value.to_str().ok());
    let ranges: Vec<Range> = lines.flat_map(|line| line.split(',')).take(MAX_RANGES).filter_map(Range::parse).collect();
    if ranges.is_empty() {
        return Some(0);
    }
    let mut best: Option<(usize, u16)> = None;
    for (index, media_type) in offered.iter().enumerate() {
        let quality = quality(&ranges, media_type);
        if quality > best.map_or(0, |(_, q)| q) {
            best = Some((index, quality));
        }
    }
    best.map(|(index, _)| index)
}

fn quality(ranges: &[Range], media_type: &str) -> u16 {
    let matching = ranges.iter().filter_map(|range| Some((range.specificity(media_type)?, range.quality)));
    // If a range is given twice, the higher quality counts.
    matching.max().map_or(0, |(_, quality)| quality)
}

/// One entry of the header.
#[derive(Debug, PartialEq)]
struct Range {
    /// In lower case.
    kind: String,
    subtype: String,
    /// In thousandths.
    quality: u16,
}

impl Range {
    /// `None` if it is not a media range; the other ranges still count.
    fn parse(text: &str) -> Option<Range> {
        let mut parts = text.split(';');
        let (kind, subtype) = parts.next()?.trim().split_once('/')?;
        let is_token = |word: &str| !word.is_empty() && word.bytes().all(|b| b.is_ascii_graphic());
        if !is_token(kind) || !is_token(subtype) || (kind == "*" && subtype != "*") {
            return None;
        }
        let mut quality = 1000;
        for parameter in parts {
            if let Some((name, value)) = parameter.split_once('=')
                && name.trim().eq_ignore_ascii_case("q")
            {
                quality = thousandths(value.trim())?;
            }
        }
        Some(Range { kind: kind.to_ascii_lowercase(), subtype: subtype.to_ascii_lowercase(), quality })
    }

    /// How specifically the range matches this type; `None` if it does not match.
    fn specificity(&self, media_type: &str) -> Option<u8> {
        let (kind, subtype) = media_type.split_once('/')?;
        match (self.kind.as_str(), self.subtype.as_str()) {
            ("*", "*") => Some(0),
            (k, "*") if k == kind => Some(1),
            (k, s) if k == kind && s == subtype => Some(2),
            _ => None,
        }
    }
}

/// A quality value, `0` to `1` with at most three decimals.
fn thousandths(text: &str) -> Option<u16> {
    let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
    if decimals.len() > 3 || !decimals.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let decimals: u16 = format!("{decimals:0<3}").parse().ok()?;
    match whole {
        "0" => Some(decimals),
        "1" if decimals == 0 => Some(1000),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    const OFFERED: [&str; 4] = ["application/json", "text/csv", "application/x-npy", "model/ply"];

    fn choice(lines: &[&'static str]) -> Option<&'static str> {
        let mut headers = HeaderMap::new();
        for line in lines {
            headers.append(header::ACCEPT, HeaderValue::from_static(line));
        }
        preferred(&headers, &OFFERED).map(|index| OFFERED[index])
    }

    #[test]
    fn the_best_quality_wins_and_the_first_among_equals() {
        for (accept, expected) in [
            ("*/*", "application/json"),
            ("text/csv", "text/csv"),
            ("TEXT/CSV; header=present", "text/csv"),
            ("model/*", "model/ply"),
            ("application/json;q=0.5, text/csv;q=0.9", "text/csv"),
            ("application/json;q=0.5,text/csv;q=0.5", "application/json"),
            ("text/csv;q=0.1, */*;q=0.2", "application/json"),
            ("text/html, application/xhtml+xml, */*;q=0.8", "application/json"),
            ("application/*;q=0.3, application/x-npy;q=0.4", "application/x-npy"),
            ("application/*, application/json;q=0", "application/x-npy"),
            ("text/csv ; q=1.000", "text/csv"),
            ("image/png, text/csv;Q=0.001", "text/csv"),
        ] {
            assert_eq!(choice(&[accept]), Some(expected), "{accept}");
        }
        assert_eq!(choice(&["text/csv;q=0.2", "model/ply;q=0.3"]), Some("model/ply"), "lines are joined");
    }

    #[test]
    fn none_is_chosen_where_none_is_accepted() {
        for accept in ["image/png", "text/html, image/*", "*/*;q=0", "application/json;q=0", "text/plain"] {
            assert_eq!(choice(&[accept]), None, "{accept}");
        }
    }

    #[test]
    fn invalid_ranges_are_ignored() {
        for accept in ["", ",,", "json", "*/csv", "text/csv;q=2", "text/csv;q=0.1234", "text/csv;q=x", "/"] {
            assert_eq!(choice(&[accept]), Some("application/json"), "{accept}");
        }
        assert_eq!(choice(&[]), Some("application/json"));
        assert_eq!(choice(&["nonsense, text/csv"]), Some("text/csv"));
    }
}
