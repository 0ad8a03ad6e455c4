//! Units of length stated by files: by name in dedicated fields, and in free text such as the comments of an OBJ file,
//! where programs write `1 unit = 1000 mm`, `File units = meters` or `UNITS=mm`.

/// A unit of length of a file, in millimeters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    pub(super) mm: f64,
}

impl Unit {
    /// `None` if a length cannot have this unit.
    fn new(mm: f64) -> Option<Self> {
        (1e-9..=1e9).contains(&mm).then_some(Unit { mm })
    }

    /// Note of a report on converted coordinates; `None` for millimeters, which are not converted.
    pub(super) fn note(self) -> Option<String> {
        let Unit { mm } = self;
        (mm != 1.0).then(|| {
            format!("the file states that its unit of length is {mm} mm; the coordinates were multiplied by {mm} to be in mm")
        })
    }
}

/// The unit named by a word, alone or in forms like `mm`, `"mm"`, `Millimeters`, `µm`.
pub(super) fn named(word: &str) -> Option<Unit> {
    let word = word.trim_matches(|c: char| c.is_whitespace() || "\"'.,;()[]".contains(c)).to_lowercase();
    let mm = match word.as_str() {
        "nm" | "nanometer" | "nanometers" | "nanometre" | "nanometres" => 1e-6,
        "um" | "µm" | "μm" | "micron" | "microns" | "micrometer" | "micrometers" | "micrometre" | "micrometres" => {
            1e-3
        }
        "mm" | "millimeter" | "millimeters" | "millimetre" | "millimetres" => 1.0,
        "cm" | "centimeter" | "centimeters" | "centimetre" | "centimetres" => 10.0,
        "dm" | "decimeter" | "decimeters" | "decimetre" | "decimetres" => 100.0,
        "m" | "meter" | "meters" | "metre" | "metres" => 1000.0,
        "in" | "inch" | "inches" => 25.4,
        "ft" | "foot" | "feet" => 304.8,
        _ => return None,
    };
    Some(Unit { mm })
}

/// Whether a field of this name holds a unit of length as a string.
pub(super) fn is_field(name: &str) -> bool {
    let letters: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    let known = ["unit", "units", "unitslabel", "lengthunit", "lengthunits", "unitoflength", "spaceunit", "spaceunits"];
    let coordinates =
        ["coordinateunit", "coordinateunits", "unitsofcoordinates", "pointunits", "unitname", "unitsystem"];
    known.iter().chain(&coordinates).any(|known| letters.eq_ignore_ascii_case(known))
}

/// A word of free text.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Word {
    Number(f64),
    Unit(f64),
    /// The word `unit` or `units`.
    Own,
    Per,
    /// A word that may stand between the others, such as `=` or `is`.
    Joining,
    /// A word for the measured lengths, such as `coordinates`.
    Lengths,
    Other,
}

fn word(text: &str) -> Word {
    if let Ok(number) = text.parse::<f64>()
        && number.is_finite()
        && number > 0.0
    {
        return Word::Number(number);
    }
    match text.to_lowercase().as_str() {
        "unit" | "units" | "lengthunit" | "lengthunits" | "length_unit" | "length_units" => Word::Own,
        "per" => Word::Per,
        "is" | "are" | "equal" | "equals" | "to" | "of" | "length" | "measure" | "used" => Word::Joining,
        "coordinates" | "dimensions" | "vertices" | "positions" | "points" | "lengths" | "distances"
        | "measurements" => Word::Lengths,
        _ => named(text).map_or(Word::Other, |unit| Word::Unit(unit.mm)),
    }
}

/// Largest length of a line that is searched for a unit, bytes.
const MAX_LINE_BYTES: usize = 1000;

/// [`stated`] for a raw line of the file, which is not copied if it is long.
pub(super) fn stated_in(line: &[u8]) -> Option<Unit> {
    if line.len() > MAX_LINE_BYTES { None } else { stated(&String::from_utf8_lossy(line).replace('\0', " ")) }
}

/// The unit that a line of free text states; `None` if it states none.
pub(super) fn stated(line: &str) -> Option<Unit> {
    // This rejects most comments.
    if !line.is_ascii() && !line.contains(['µ', 'μ']) || line.len() > MAX_LINE_BYTES {
        return None;
    }
    let separators = |c: char| c.is_whitespace() || "=:,;()[]\"'#/".contains(c);
    let words: Vec<Word> = line.split(separators).filter(|text| !text.is_empty()).map(word).collect();
    let own = words.iter().position(|&word| word == Word::Own);
    own.and_then(|at| by_own_word(&words, at)).or_else(|| of_lengths(&words))
}

/// `1 unit = 1000 mm`, `units: mm`, `1000 units per meter`, `1 mm = 1 unit`.
fn by_own_word(words: &[Word], at: usize) -> Option<Unit> {
    let before = match words[..at] {
        [.., Word::Number(number)] => Some(number),
        _ => None,
    };
    let mut after = words[at + 1..].iter().filter(|&&word| word != Word::Joining).peekable();
    let is_per = after.next_if(|&&word| word == Word::Per).is_some();
    match (after.next(), after.next()) {
        // `File units in inches`.
        (Some(Word::Unit(25.4)), Some(Word::Unit(mm))) => Unit::new(mm / before.unwrap_or(1.0)),
        (Some(Word::Unit(mm)), Some(Word::Number(number))) if is_per => Unit::new(mm / number),
        (Some(Word::Number(number)), Some(Word::Unit(mm))) => Unit::new(number * mm / before.unwrap_or(1.0)),
        (Some(Word::Unit(mm)), _) => Unit::new(mm / before.unwrap_or(1.0)),
        (None, _) => match words[..at] {
            [.., Word::Number(value), Word::Unit(mm), Word::Number(number)] => Unit::new(value * mm / number),
            _ => None,
        },
        _ => None,
    }
}

/// `all coordinates are in cm`.
fn of_lengths(words: &[Word]) -> Option<Unit> {
    let at = words.iter().position(|&word| word == Word::Lengths)?;
    let mut after = words[at + 1..].iter().filter(|&&word| word != Word::Joining);
    match (after.next(), after.next()) {
        (Some(Word::Unit(25.4)), Some(&Word::Unit(mm))) => Unit::new(mm),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_programs_write_of_their_units_is_understood() {
        let cases: [(&str, Option<f64>); 24] = [
            ("# 1 unit = 1000 mm", Some(1000.0)),
            ("# 1 unit = 1 m", Some(1000.0)),
            ("# File units = meters", Some(1000.0)),
            ("## File units = Inches", Some(25.4)),
            ("#units: Centimeters", Some(10.0)),
            ("comment units mm", Some(1.0)),
            ("# Unit is micrometer", Some(1e-3)),
            ("# units: µm", Some(1e-3)),
            ("solid part UNITS=cm", Some(10.0)),
            ("# 1000 units per meter", Some(1.0)),
            ("# units per meter: 100", Some(10.0)),
            ("# 1 mm = 1000 units", Some(1e-3)),
            ("# 10 units = 1 cm", Some(1.0)),
            ("# all coordinates are in cm", Some(10.0)),
            ("# coordinates in inches", Some(25.4)),
            ("# units in inches", Some(25.4)),
            ("# units (feet)", Some(304.8)),
            ("# unit normals", None),
            ("# Vertices: 246", None),
            ("# 5 points in a row", None),
            ("surface, millimeters", None),
            ("# one unit = one voxel", None),
            ("# 1 unit = 0 mm", None),
            ("# exported in 2024", None),
        ];
        for (text, mm) in cases {
            let found = stated(text).map(|unit| unit.mm);
            let same = match (found, mm) {
                (Some(found), Some(mm)) => (found / mm - 1.0).abs() < 1e-12,
                (found, mm) => found == mm,
            };
            assert!(same, "{text}: {found:?}, expected {mm:?}");
        }
    }
}
