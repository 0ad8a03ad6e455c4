//! Any bytes, read as a file of any format: no panic, nothing that takes a second, no large allocation (`make fuzz` sets the
//! limits of both).
#![no_main]

use homolog_formats::{ReadLimits, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = read(bytes, None, &ReadLimits::default());
});
