//! A curve in the terminal, in Braille characters: eight dots a character, two across and four down.

/// Dots of a Braille character by column and row, as Unicode numbers them.
const DOTS: [[u32; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];

/// Lines of a plot of `values` over their index; `marks` are indices named on the axis. The scale is logarithmic if all
/// values are positive and the largest is more than ten times the smallest, otherwise linear. Empty with fewer than two
/// finite values.
pub(super) fn plot(values: &[f64], marks: &[usize], width: usize, height: usize) -> Vec<String> {
    let finite: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let (width, height) = (width.max(2), height.max(2));
    if finite.len() < 2 {
        return Vec::new();
    }
    let low = finite.iter().copied().fold(f64::INFINITY, f64::min);
    let high = finite.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let logarithmic = low > 0.0 && high > 10.0 * low;
    let scale = |v: f64| if logarithmic { v.ln() } else { v };
    let span = if high > low { scale(high) - scale(low) } else { 1.0 };
    let (columns, rows) = (2 * width, 4 * height);
    let column_of = |k: usize| k * (columns - 1) / (values.len() - 1).max(1);
    let row_of = |v: f64| (((scale(high) - scale(v)) / span) * (rows - 1) as f64).round() as usize;
    let mut cells = vec![vec![0u32; width]; height];
    let mut last: Option<(usize, usize)> = None;
    for (k, &v) in values.iter().enumerate() {
        if !v.is_finite() {
            last = None;
            continue;
        }
        let (x, y) = (column_of(k), row_of(v));
        let (x0, y0) = last.unwrap_or((x, y));
        let steps = x.abs_diff(x0).max(y.abs_diff(y0)).max(1);
        for step in 0..=steps {
            let along = |a: usize, b: usize| {
                let (a, b) = (a as f64, b as f64);
                (a + (b - a) * step as f64 / steps as f64).round() as usize
            };
            let (x, y) = (along(x0, x), along(y0, y));
            cells[y / 4][x / 2] |= DOTS[x % 2][y % 4];
        }
        last = Some((x, y));
    }
    let mut lines = Vec::with_capacity(height + 1);
    for (k, row) in cells.iter().enumerate() {
        let label = match k {
            0 => format!("{high:.2}"),
            k if k + 1 == height => format!("{low:.2}"),
            k if k == height / 2 && logarithmic => "(logarithmic)".to_owned(),
            _ => String::new(),
        };
        // The last value is printed behind the end of the curve.
        let end = last.filter(|&(_, y)| y / 4 == k).and(finite.last()).map_or_else(String::new, |v| format!(" {v:.2}"));
        let curve: String = row.iter().map(|&bits| char::from_u32(0x2800 + bits).unwrap_or(' ')).collect();
        lines.push(format!("{label:>13} ┤{curve}{end}"));
    }
    let mut axis = vec!['─'; width];
    for &mark in marks.iter().filter(|&&m| m < values.len()) {
        axis[column_of(mark) / 2] = '┴';
    }
    lines.push(format!("{:>13} └{}", "", axis.into_iter().collect::<String>()));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_falling_line_goes_from_corner_to_corner() {
        let lines = plot(&[1.0, 0.0], &[0], 2, 2);
        assert_eq!(lines.len(), 3);
        assert!(lines[1].ends_with(" 0.00"), "{lines:?}");
        let first: Vec<char> = lines[0].chars().collect();
        let second: Vec<char> = lines[1].chars().collect();
        assert!(first[first.len() - 2] != '\u{2800}' && second[second.len() - 6] != '\u{2800}');
        assert!(lines[2].ends_with("└┴─"));
    }

    #[test]
    fn a_wide_range_is_drawn_on_a_logarithmic_scale() {
        // Equal ratios form a straight line, so the middle value is in the middle row.
        let lines = plot(&[10_000.0, 100.0, 1.0], &[], 3, 3);
        assert!(lines[1].chars().any(|c| ('\u{2801}'..='\u{28ff}').contains(&c)), "{lines:?}");
    }

    #[test]
    fn constants_and_gaps_are_drawn_and_an_empty_line_is_not() {
        assert_eq!(plot(&[2.0; 40], &[], 10, 3).len(), 4);
        assert_eq!(plot(&[2.0, f64::NAN, 3.0], &[7], 10, 3).len(), 4);
        assert!(plot(&[], &[], 10, 3).is_empty());
        assert!(plot(&[f64::INFINITY, 1.0], &[], 10, 3).is_empty());
    }
}
