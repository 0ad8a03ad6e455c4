//! Any bytes, read as a file of any format: no panic, nothing that takes a second (`make fuzz` sets the limit, with room for the
//! sanitizer), and no more memory than 64 times the file and 16 MiB.
#![no_main]

use homolog_formats::{ReadLimits, read};
use libfuzzer_sys::fuzz_target;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicIsize, Ordering::Relaxed};

/// Counts what is held, and the most that was. Everything here runs on one thread, but for the clock of libFuzzer.
struct Counting;

static HELD: AtomicIsize = AtomicIsize::new(0);
static MOST: AtomicIsize = AtomicIsize::new(0);

// SAFETY: every call is passed on to the system's allocator with the same arguments; counting allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let size = layout.size() as isize;
        MOST.fetch_max(HELD.fetch_add(size, Relaxed) + size, Relaxed);
        // SAFETY: the caller's promise about `layout` is passed on.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size() as isize, Relaxed);
        // SAFETY: `place` was allocated above with this layout.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Bytes that a reader may hold for each byte of the file, inflated if it is compressed, and in any case.
const BYTES_PER_BYTE: usize = 64;
const BYTES_ALWAYS: usize = 16 << 20;
/// What compressed files may inflate to where memory is counted, since their proportion is not known here.
const INFLATED: usize = 256 << 10;

/// The name decides where the content does not.
const NAMES: [Option<&str>; 15] = [
    None,
    Some("a.nii"),
    Some("a.mgh"),
    Some("a.nrrd"),
    Some("a.mha"),
    Some("a.dcm"),
    Some("lh.white"),
    Some("a.gii"),
    Some("a.ply"),
    Some("a.stl"),
    Some("a.vtk"),
    Some("a.vtp"),
    Some("a.obj"),
    Some("a.off"),
    Some("a.mz3"),
];

fuzz_target!(|bytes: &[u8]| {
    // Chosen by the length, so that no byte of the file is spent on it.
    let name = NAMES[bytes.len() / 2 % NAMES.len()];
    if bytes.len() % 2 == 0 {
        let _ = read(bytes, name, &ReadLimits::default());
        return;
    }
    let limits = ReadLimits { max_inflated_bytes: INFLATED, ..ReadLimits::default() };
    let before = HELD.load(Relaxed);
    MOST.store(before, Relaxed);
    let _ = read(bytes, name, &limits);
    let held = MOST.load(Relaxed) - before;
    let most = BYTES_PER_BYTE * bytes.len().max(INFLATED) + BYTES_ALWAYS;
    assert!(held <= most as isize, "{held} bytes were held for a file of {} bytes", bytes.len());
});
