//! The Arrow IPC **file** format (`.arrow`, Feather version 2): one uncompressed record batch.
//!
//! Source: "Arrow Columnar Format", section "Serialization and Interprocess Communication", and the schemas
//! `Schema.fbs`, `Message.fbs` and `File.fbs`. The metadata are FlatBuffers; [`Flat`] encodes the few tables that plain
//! columns need, because the Arrow library is larger than all of this crate.

use super::PairColumns;
use super::vertex_arrays::{VertexArray, VertexValues};

const MAGIC: &[u8] = b"ARROW1";
/// The marker at the start of every message, before the length of its metadata.
const CONTINUATION: [u8; 4] = [0xff; 4];
/// Alignment of messages, bodies and buffers within the file.
const ALIGNMENT: usize = 8;
/// `MetadataVersion.V5`.
const VERSION: i16 = 4;

/// Supported column types.
#[derive(Clone, Copy)]
enum Column {
    Uint32,
    Int32,
    Uint8,
    Double,
    Bool,
}

/// Names and types, in order.
const COLUMNS: [(&str, Column); 12] = [
    ("source", Column::Uint32),
    ("target", Column::Uint32),
    ("confidence", Column::Double),
    ("inlier", Column::Bool),
    ("spread_mm", Column::Double),
    ("outlier", Column::Uint8),
    ("triangle_0", Column::Uint32),
    ("triangle_1", Column::Uint32),
    ("triangle_2", Column::Uint32),
    ("barycentric_0", Column::Double),
    ("barycentric_1", Column::Double),
    ("barycentric_2", Column::Double),
];

/// The columns `source` and `target` (uint32), `confidence` (float64), `inlier` (bool), `spread_mm` (float64) and
/// `outlier` (uint8), `triangle_0` to `triangle_2` (uint32), `barycentric_0` to `barycentric_2` (float64), none nullable.
pub fn write_arrow(pairs: &PairColumns<'_>) -> Vec<u8> {
    let n = pairs.len();
    let mut body = Body::default();
    body.add(pairs.source[..n].iter().flat_map(|v| v.to_le_bytes()));
    body.add(pairs.target[..n].iter().flat_map(|v| v.to_le_bytes()));
    body.add(pairs.confidence[..n].iter().flat_map(|v| v.to_le_bytes()));
    // Eight booleans per byte, the first in the lowest bit.
    let bits = pairs.inlier[..n].chunks(8);
    body.add(bits.map(|byte| byte.iter().enumerate().fold(0u8, |sum, (k, &bit)| sum | u8::from(bit) << k)));
    body.add(pairs.spread_mm[..n].iter().flat_map(|v| v.to_le_bytes()));
    body.add(pairs.outlier[..n].iter().copied());
    for corner in 0..3 {
        body.add(pairs.triangle[..n].iter().flat_map(|v| v[corner].to_le_bytes()));
    }
    for corner in 0..3 {
        body.add(pairs.barycentric[..n].iter().flat_map(|v| v[corner].to_le_bytes()));
    }

    arrow_file(&COLUMNS, n, &body)
}

/// Per-vertex arrays as a table: a column for each (int32, float64, uint8), none nullable; row `k` is vertex `k`.
pub fn write_arrow_table(arrays: &[VertexArray]) -> Vec<u8> {
    let n = arrays.iter().map(|array| array.values.len()).min().unwrap_or(0);
    let mut body = Body::default();
    let mut columns = Vec::new();
    for VertexArray { name, values } in arrays {
        let column = match values {
            VertexValues::Int(v) => {
                body.add(v[..n].iter().flat_map(|v| v.to_le_bytes()));
                Column::Int32
            }
            VertexValues::Real(v) => {
                body.add(v[..n].iter().flat_map(|v| v.to_le_bytes()));
                Column::Double
            }
            VertexValues::Byte(v) => {
                body.add(v[..n].iter().copied());
                Column::Uint8
            }
        };
        columns.push((*name, column));
    }
    arrow_file(&columns, n, &body)
}

/// A file with one record batch.
fn arrow_file(columns: &[(&str, Column)], n: usize, body: &Body) -> Vec<u8> {
    let mut file = MAGIC.to_vec();
    file.resize(ALIGNMENT, 0);
    message(&mut file, &schema_message(columns), &[]);
    let offset = file.len();
    let metadata_length = message(&mut file, &batch_message(n, body), &body.bytes);
    file.extend(CONTINUATION);
    file.extend([0; 4]); // the end of the stream of messages
    let footer = footer(columns, offset, metadata_length, body.bytes.len());
    file.extend(&footer);
    file.extend((footer.len() as u32).to_le_bytes());
    file.extend(MAGIC);
    file
}

/// Appends a message; returns the length of everything before its body.
fn message(file: &mut Vec<u8>, metadata: &[u8], body: &[u8]) -> usize {
    let padded = metadata.len().next_multiple_of(ALIGNMENT);
    file.extend(CONTINUATION);
    file.extend((padded as u32).to_le_bytes());
    file.extend(metadata);
    file.resize(file.len() + padded - metadata.len(), 0);
    file.extend(body);
    8 + padded
}

/// The buffers of a record batch: for each column an empty validity buffer, as nothing is null, and the values.
#[derive(Default)]
struct Body {
    bytes: Vec<u8>,
    places: Vec<[i64; 2]>,
}

impl Body {
    fn add(&mut self, values: impl Iterator<Item = u8>) {
        let offset = self.bytes.len();
        self.bytes.extend(values);
        self.places.push([offset as i64, 0]);
        self.places.push([offset as i64, (self.bytes.len() - offset) as i64]);
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNMENT), 0);
    }
}

fn schema_message(columns: &[(&str, Column)]) -> Vec<u8> {
    let mut flat = Flat::default();
    // Message: version, header type (1 = Schema), header, body length.
    let root = flat.root(&[Field::I16(VERSION), Field::U8(1), Field::Link, Field::I64(0)]);
    let schema = schema(columns, &mut flat);
    flat.link(root[0], schema);
    flat.bytes
}

/// The `Schema` table; returns its place.
fn schema(columns: &[(&str, Column)], flat: &mut Flat) -> usize {
    // Schema: endianness (0 = little), fields.
    let (place, links) = flat.table(&[Field::I16(0), Field::Link]);
    let (fields, slots) = flat.vector_of_links(columns.len());
    flat.link(links[0], fields);
    for (slot, (name, column)) in slots.into_iter().zip(columns) {
        // Type: 2 = Int, 3 = FloatingPoint, 6 = Bool.
        let kind = match column {
            Column::Uint32 | Column::Int32 | Column::Uint8 => 2,
            Column::Double => 3,
            Column::Bool => 6,
        };
        // Field: name, nullable, type's kind, type, dictionary, children.
        let (field, links) =
            flat.table(&[Field::Link, Field::U8(0), Field::U8(kind), Field::Link, Field::Absent, Field::Link]);
        flat.link(slot, field);
        let name = flat.string(name);
        flat.link(links[0], name);
        let (kind, _) = match column {
            Column::Uint32 => flat.table(&[Field::I32(32), Field::U8(0)]), // Int: width in bits, signed
            Column::Int32 => flat.table(&[Field::I32(32), Field::U8(1)]),
            Column::Uint8 => flat.table(&[Field::I32(8), Field::U8(0)]),
            Column::Double => flat.table(&[Field::I16(2)]), // FloatingPoint: precision (2 = double)
            Column::Bool => flat.table(&[]),
        };
        flat.link(links[1], kind);
        let (children, _) = flat.vector_of_links(0);
        flat.link(links[2], children);
    }
    place
}

fn batch_message(n_rows: usize, body: &Body) -> Vec<u8> {
    let mut flat = Flat::default();
    // Message: version, header type (3 = RecordBatch), header, body length.
    let root = flat.root(&[Field::I16(VERSION), Field::U8(3), Field::Link, Field::I64(body.bytes.len() as i64)]);
    // RecordBatch: length, nodes, buffers.
    let (batch, links) = flat.table(&[Field::I64(n_rows as i64), Field::Link, Field::Link]);
    flat.link(root[0], batch);
    // FieldNode: length, nulls; one for each column.
    let nodes = flat.vector_of_longs(&vec![[n_rows as i64, 0]; body.places.len() / 2]);
    flat.link(links[0], nodes);
    // Buffer: offset in the body, length.
    let buffers = flat.vector_of_longs(&body.places);
    flat.link(links[1], buffers);
    flat.bytes
}

fn footer(columns: &[(&str, Column)], offset: usize, metadata_length: usize, body_length: usize) -> Vec<u8> {
    let mut flat = Flat::default();
    // Footer: version, schema, dictionaries, record batches.
    let root = flat.root(&[Field::I16(VERSION), Field::Link, Field::Link, Field::Link]);
    let schema = schema(columns, &mut flat);
    flat.link(root[0], schema);
    let none = flat.vector_of_longs::<3>(&[]);
    flat.link(root[1], none);
    // Block: offset in the file, length of the metadata (32 bits and padding), length of the body.
    let blocks = flat.vector_of_longs(&[[offset as i64, metadata_length as i64, body_length as i64]]);
    flat.link(root[2], blocks);
    flat.bytes
}

/// A FlatBuffer written front to back: offsets point forward and are filled in when their destination is known.
#[derive(Default)]
struct Flat {
    bytes: Vec<u8>,
}

/// A field of a table, in the order of its schema.
#[derive(Clone, Copy)]
enum Field {
    Absent,
    U8(u8),
    I16(i16),
    I32(i32),
    I64(i64),
    /// A link to a later table, vector or string.
    Link,
}

impl Field {
    fn bytes(self) -> Vec<u8> {
        match self {
            Field::Absent => Vec::new(),
            Field::U8(v) => vec![v],
            Field::I16(v) => v.to_le_bytes().to_vec(),
            Field::I32(v) => v.to_le_bytes().to_vec(),
            Field::I64(v) => v.to_le_bytes().to_vec(),
            Field::Link => vec![0; 4],
        }
    }
}

impl Flat {
    /// The first table, to which the first four bytes of the buffer point; returns the places of its links.
    fn root(&mut self, fields: &[Field]) -> Vec<usize> {
        self.bytes.resize(4, 0);
        let (place, links) = self.table(fields);
        self.link(0, place);
        links
    }

    /// A table behind its vtable. Returns its place and the places of its links.
    fn table(&mut self, fields: &[Field]) -> (usize, Vec<usize>) {
        let vtable_length = 4 + 2 * fields.len();
        // The table is aligned for its widest field; its first four bytes lead back to the vtable.
        let vtable = (self.bytes.len() + vtable_length).next_multiple_of(8) - vtable_length;
        let place = vtable + vtable_length;
        let (mut inline, mut offsets, mut links) = (vec![0; 4], Vec::new(), Vec::new());
        for field in fields {
            let value = field.bytes();
            if value.is_empty() {
                offsets.push(0);
                continue;
            }
            inline.resize(inline.len().next_multiple_of(value.len()), 0);
            offsets.push(inline.len() as u16);
            if matches!(field, Field::Link) {
                links.push(place + inline.len());
            }
            inline.extend(value);
        }
        inline[..4].copy_from_slice(&(vtable_length as i32).to_le_bytes());
        self.bytes.resize(vtable, 0);
        self.bytes.extend((vtable_length as u16).to_le_bytes());
        self.bytes.extend((inline.len() as u16).to_le_bytes());
        self.bytes.extend(offsets.iter().flat_map(|o| o.to_le_bytes()));
        self.bytes.extend(inline);
        (place, links)
    }

    /// A vector of links; returns its place and the places of the links.
    fn vector_of_links(&mut self, n: usize) -> (usize, Vec<usize>) {
        let place = self.bytes.len().next_multiple_of(4);
        self.bytes.resize(place, 0);
        self.bytes.extend((n as u32).to_le_bytes());
        self.bytes.resize(place + 4 + 4 * n, 0);
        (place, (0..n).map(|k| place + 4 + 4 * k).collect())
    }

    /// A vector of structs of `N` 64-bit numbers.
    fn vector_of_longs<const N: usize>(&mut self, items: &[[i64; N]]) -> usize {
        // The elements are aligned; their number precedes them.
        let place = (self.bytes.len() + 4).next_multiple_of(8) - 4;
        self.bytes.resize(place, 0);
        self.bytes.extend((items.len() as u32).to_le_bytes());
        self.bytes.extend(items.iter().flatten().flat_map(|v| v.to_le_bytes()));
        place
    }

    fn string(&mut self, text: &str) -> usize {
        let place = self.bytes.len().next_multiple_of(4);
        self.bytes.resize(place, 0);
        self.bytes.extend((text.len() as u32).to_le_bytes());
        self.bytes.extend(text.as_bytes());
        self.bytes.push(0);
        place
    }

    /// Points the link at `from` to `to`, which lies behind it.
    fn link(&mut self, from: usize, to: usize) {
        self.bytes[from..from + 4].copy_from_slice(&((to - from) as u32).to_le_bytes());
    }
}
