//! Apache Parquet: one row group, an uncompressed plain page for each column.
//!
//! Source: "Apache Parquet format", README and `parquet.thrift`, and the compact protocol of Thrift. Hand-written
//! because the library takes longer to build than all other writers of this crate.

use super::PairColumns;
use super::vertex_arrays::{VertexArray, VertexValues};

const MAGIC: &[u8] = b"PAR1";

/// The values of a column.
enum Values {
    Uint32(Vec<u32>),
    Int32(Vec<i32>),
    Uint8(Vec<u8>),
    Double(Vec<f64>),
    Bool(Vec<bool>),
    Text(Vec<String>),
}

/// A column of a general table, not of vertices.
#[derive(Debug, Clone, PartialEq)]
pub enum TableColumn {
    /// Numbers; NaN for missing ones.
    Real(Vec<f64>),
    /// Text.
    Text(Vec<String>),
}

impl Values {
    /// `Type` and, for narrower or unsigned numbers, `ConvertedType`.
    fn kind(&self) -> (i64, Option<i64>) {
        match self {
            Values::Bool(_) => (0, None),
            Values::Int32(_) => (1, None),
            Values::Uint8(_) => (1, Some(11)),
            Values::Uint32(_) => (1, Some(13)),
            Values::Double(_) => (5, None),
            Values::Text(_) => (6, Some(0)),
        }
    }

    /// The encoding `PLAIN`.
    fn plain(&self) -> Vec<u8> {
        match self {
            Values::Uint32(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Values::Int32(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Values::Uint8(v) => v.iter().flat_map(|&x| u32::from(x).to_le_bytes()).collect(),
            Values::Double(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Values::Text(v) => {
                v.iter().flat_map(|text| (text.len() as u32).to_le_bytes().into_iter().chain(text.bytes())).collect()
            }
            // Eight booleans per byte, the first in the lowest bit.
            Values::Bool(v) => v
                .chunks(8)
                .map(|byte| byte.iter().enumerate().fold(0u8, |sum, (k, &bit)| sum | u8::from(bit) << k))
                .collect(),
        }
    }
}

/// The columns of [`super::arrow::write_arrow`].
pub fn write_parquet(pairs: &PairColumns<'_>) -> Vec<u8> {
    let n = pairs.len();
    let corner = |k: usize| Values::Uint32(pairs.triangle[..n].iter().map(|t| t[k]).collect());
    let weight = |k: usize| Values::Double(pairs.barycentric[..n].iter().map(|b| b[k]).collect());
    let columns = [
        ("source", Values::Uint32(pairs.source[..n].to_vec())),
        ("target", Values::Uint32(pairs.target[..n].to_vec())),
        ("confidence", Values::Double(pairs.confidence[..n].to_vec())),
        ("inlier", Values::Bool(pairs.inlier[..n].to_vec())),
        ("spread_mm", Values::Double(pairs.spread_mm[..n].to_vec())),
        ("outlier", Values::Uint8(pairs.outlier[..n].to_vec())),
        ("triangle_0", corner(0)),
        ("triangle_1", corner(1)),
        ("triangle_2", corner(2)),
        ("barycentric_0", weight(0)),
        ("barycentric_1", weight(1)),
        ("barycentric_2", weight(2)),
    ];
    file(&columns, n)
}

/// Per-vertex arrays as a table: a column for each (int32, float64, uint8), none nullable; row `k` is vertex `k`.
pub fn write_parquet_table(arrays: &[VertexArray]) -> Vec<u8> {
    let n = arrays.iter().map(|array| array.values.len()).min().unwrap_or(0);
    let columns: Vec<(&str, Values)> = arrays
        .iter()
        .map(|VertexArray { name, values }| {
            let values = match values {
                VertexValues::Int(v) => Values::Int32(v[..n].to_vec()),
                VertexValues::Real(v) => Values::Double(v[..n].to_vec()),
                VertexValues::Byte(v) => Values::Uint8(v[..n].to_vec()),
            };
            (*name, values)
        })
        .collect();
    file(&columns, n)
}

/// Columns of equal length with any names as a table (float64, UTF-8), none nullable.
pub fn write_parquet_columns(columns: &[(String, TableColumn)]) -> Vec<u8> {
    let length = |column: &TableColumn| match column {
        TableColumn::Real(values) => values.len(),
        TableColumn::Text(values) => values.len(),
    };
    let n = columns.iter().map(|(_, column)| length(column)).min().unwrap_or(0);
    let values = columns.iter().map(|(name, column)| {
        let values = match column {
            TableColumn::Real(values) => Values::Double(values[..n].to_vec()),
            TableColumn::Text(values) => Values::Text(values[..n].to_vec()),
        };
        (name.as_str(), values)
    });
    file(&values.collect::<Vec<_>>(), n)
}

fn file(columns: &[(&str, Values)], n_rows: usize) -> Vec<u8> {
    let mut file = MAGIC.to_vec();
    // Place of the page of each column, and its length with its header.
    let mut pages = Vec::new();
    for (_, values) in columns {
        let plain = values.plain();
        let start = file.len();
        // PageHeader: type (0 = data), sizes, header of the data page: number of values, encoding (0 = plain), encodings of
        // levels (3 = run lengths), which columns without null have none of.
        let mut header = Thrift::default();
        header.integer(1, 0).integer(2, plain.len() as i64).integer(3, plain.len() as i64);
        header.structure(5, |page| {
            page.integer(1, n_rows as i64).integer(2, 0).integer(3, 3).integer(4, 3);
        });
        file.extend(header.finished());
        file.extend(plain);
        pages.push((start, file.len() - start));
    }
    let footer = footer(columns, &pages, n_rows);
    file.extend(&footer);
    file.extend((footer.len() as u32).to_le_bytes());
    file.extend(MAGIC);
    file
}

/// `FileMetaData`.
fn footer(columns: &[(&str, Values)], pages: &[(usize, usize)], n_rows: usize) -> Vec<u8> {
    let mut meta = Thrift::default();
    meta.integer(1, 1);
    meta.structures(2, columns.len() + 1, |k, element| match k.checked_sub(1).map(|k| &columns[k]) {
        // The root: name, number of columns.
        None => {
            element.text(4, "schema").integer(5, columns.len() as i64);
        }
        // Type, repetition (0 = required), name, converted type.
        Some((name, values)) => {
            let (kind, converted) = values.kind();
            element.integer(1, kind).integer(3, 0).text(4, name);
            if let Some(converted) = converted {
                element.integer(6, converted);
            }
        }
    });
    meta.long(3, n_rows as i64);
    let total: usize = pages.iter().map(|page| page.1).sum();
    // One row group: columns, bytes, rows.
    meta.structures(4, 1, |_, group| {
        group.structures(1, columns.len(), |k, chunk| {
            let ((name, values), (start, length)) = (&columns[k], pages[k]);
            // Place and description of the column: type, encodings, path, codec (0 = none), values, bytes, place of the
            // page.
            chunk.long(2, start as i64).structure(3, |column| {
                column.integer(1, values.kind().0).integers(2, &[0, 3]).texts(3, &[name]).integer(4, 0);
                column.long(5, n_rows as i64).long(6, length as i64).long(7, length as i64).long(9, start as i64);
            });
        });
        group.long(2, total as i64).long(3, n_rows as i64);
    });
    meta.text(6, concat!("homolog ", env!("CARGO_PKG_VERSION")));
    meta.finished()
}

/// A structure in the compact protocol, field by field in ascending order.
#[derive(Default)]
struct Thrift {
    bytes: Vec<u8>,
    last: u8,
}

impl Thrift {
    const I32: u8 = 5;
    const I64: u8 = 6;
    const BINARY: u8 = 8;
    const LIST: u8 = 9;
    const STRUCT: u8 = 12;

    fn finished(mut self) -> Vec<u8> {
        self.bytes.push(0);
        self.bytes
    }

    /// The header of a field: the increment of its number, and its type.
    fn field(&mut self, number: u8, kind: u8) {
        self.bytes.push((number - self.last) << 4 | kind);
        self.last = number;
    }

    fn number(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.bytes.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.bytes.push(value as u8);
    }

    fn signed(&mut self, value: i64) {
        self.number((value << 1 ^ value >> 63) as u64);
    }

    fn list(&mut self, length: usize, kind: u8) {
        if length < 15 {
            self.bytes.push((length as u8) << 4 | kind);
        } else {
            self.bytes.push(0xf0 | kind);
            self.number(length as u64);
        }
    }

    fn string(&mut self, text: &str) {
        self.number(text.len() as u64);
        self.bytes.extend(text.as_bytes());
    }

    /// A number of 32 bits.
    fn integer(&mut self, number: u8, value: i64) -> &mut Self {
        self.field(number, Self::I32);
        self.signed(value);
        self
    }

    /// A number of 64 bits.
    fn long(&mut self, number: u8, value: i64) -> &mut Self {
        self.field(number, Self::I64);
        self.signed(value);
        self
    }

    fn text(&mut self, number: u8, text: &str) -> &mut Self {
        self.field(number, Self::BINARY);
        self.string(text);
        self
    }

    fn integers(&mut self, number: u8, values: &[i64]) -> &mut Self {
        self.field(number, Self::LIST);
        self.list(values.len(), Self::I32);
        values.iter().for_each(|&value| self.signed(value));
        self
    }

    fn texts(&mut self, number: u8, texts: &[&str]) -> &mut Self {
        self.field(number, Self::LIST);
        self.list(texts.len(), Self::BINARY);
        texts.iter().for_each(|text| self.string(text));
        self
    }

    fn structure(&mut self, number: u8, fill: impl FnOnce(&mut Thrift)) -> &mut Self {
        self.field(number, Self::STRUCT);
        let mut inner = Thrift::default();
        fill(&mut inner);
        self.bytes.extend(inner.finished());
        self
    }

    fn structures(&mut self, number: u8, n: usize, mut fill: impl FnMut(usize, &mut Thrift)) -> &mut Self {
        self.field(number, Self::LIST);
        self.list(n, Self::STRUCT);
        for k in 0..n {
            let mut inner = Thrift::default();
            fill(k, &mut inner);
            self.bytes.extend(inner.finished());
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_lists_are_as_compact_as_the_protocol_asks() {
        let mut thrift = Thrift::default();
        thrift.integer(1, -1).long(3, 300).integers(4, &[0, 3]).text(20, "ab");
        let expected = [0x15, 0x01, 0x26, 0xd8, 0x04, 0x19, 0x25, 0x00, 0x06];
        assert_eq!(thrift.bytes[..9], expected);
        let mut long = Thrift::default();
        long.structures(1, 16, |_, _| {});
        assert_eq!(long.finished(), [[0x19, 0xfc, 0x10].as_slice(), &[0; 17]].concat());
    }

    #[test]
    fn a_table_has_its_columns_one_after_the_other_and_its_footer_at_the_end() {
        let arrays = [
            VertexArray { name: "residual_mm", values: VertexValues::Real(vec![0.5, -1.25]) },
            VertexArray { name: "outlier", values: VertexValues::Byte(vec![0, 4]) },
        ];
        let table = write_parquet_table(&arrays);
        assert!(table.starts_with(MAGIC) && table.ends_with(MAGIC));
        let footer = u32::from_le_bytes(table[table.len() - 8..table.len() - 4].try_into().unwrap()) as usize;
        let (pages, footer) = table[..table.len() - 8].split_at(table.len() - 8 - footer);
        let holds = |part: &[u8], bytes: &[u8]| part.windows(bytes.len()).any(|w| w == bytes);
        assert!(holds(pages, &[0.5f64.to_le_bytes(), (-1.25f64).to_le_bytes()].concat()));
        assert!(pages.ends_with(&[0, 0, 0, 0, 4, 0, 0, 0]), "bytes take four each");
        assert!(holds(footer, b"residual_mm") && holds(footer, b"outlier"));
    }
}
