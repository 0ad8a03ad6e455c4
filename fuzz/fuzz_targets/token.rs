//! Any bytes as API keys and bearer tokens: no panic, and no answer but a short refusal.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| homolog::http::fuzzed::token(bytes));
