//! A table as CSV (RFC 4180), at full precision.

use super::document::{Cell, Column, Table, with_unit};
use super::statistics::Summary;
use homolog_formats::csv_cell::text_cell;

/// A statistic of a summary: its name and its accessor.
type Part = (&'static str, fn(&Summary) -> f64);

/// The columns into which a column of summaries is split.
const PARTS: [Part; 6] = [
    ("n", |s| s.n as f64),
    ("mean", |s| s.mean),
    ("sd", |s| s.sd),
    ("q1", |s| s.q1),
    ("median", |s| s.median),
    ("q3", |s| s.q3),
];

/// The table with a line of headings; a column of summaries becomes six columns.
pub(super) fn csv(table: &Table) -> String {
    let spreads: Vec<bool> = (0..table.columns.len())
        .map(|k| table.rows.iter().any(|row| matches!(row.get(k), Some(Cell::Spread(_)))))
        .collect();
    let mut text = String::new();
    let headings = table.columns.iter().zip(&spreads).flat_map(|(column, &spread)| headings(column, spread));
    line(&mut text, headings);
    for row in &table.rows {
        line(&mut text, row.iter().zip(&spreads).flat_map(|(cell, &spread)| fields(cell, spread)));
    }
    text
}

fn headings(column: &Column, spread: bool) -> Vec<String> {
    if !spread {
        return vec![text_cell(&column.heading())];
    }
    let part = |part: &str| {
        let unit = column.unit.as_deref().filter(|_| part != "n");
        text_cell(&with_unit(&format!("{} {part}", column.name), unit))
    };
    PARTS.iter().map(|(name, _)| part(name)).collect()
}

fn fields(cell: &Cell, spread: bool) -> Vec<String> {
    let one = match cell {
        Cell::Spread(s) => return PARTS.iter().map(|(_, value)| value(s).to_string()).collect(),
        Cell::Count(n) => n.to_string(),
        Cell::Number(value) => value.to_string(),
        Cell::Text(words) => text_cell(words),
        Cell::Missing(()) => String::new(),
    };
    let mut fields = vec![one];
    if spread {
        fields.resize(PARTS.len(), String::new());
    }
    fields
}

fn line(text: &mut String, fields: impl Iterator<Item = String>) {
    text.push_str(&fields.collect::<Vec<_>>().join(","));
    text.push_str("\r\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_quoted_and_summaries_become_six_columns() {
        let table = Table {
            id: "t".to_owned(),
            title: "T".to_owned(),
            columns: vec![Column::plain("name"), Column::new("error", "mm", 2)],
            rows: vec![
                vec![Cell::text("a, \"b\""), Cell::spread(Summary::of([1.0, 2.0]))],
                vec![Cell::text("=c"), Cell::Missing(())],
            ],
        };
        let text = csv(&table);
        let mut lines = text.split("\r\n");
        let heading = "name,error n,error mean (mm),error sd (mm),error q1 (mm),error median (mm),error q3 (mm)";
        assert_eq!(lines.next(), Some(heading));
        assert!(lines.next().unwrap().starts_with("\"a, \"\"b\"\"\",2,1.5,0.707"));
        assert_eq!(lines.next(), Some("'=c,,,,,,"));
    }
}
