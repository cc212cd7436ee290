//! The allocator of `gouge`, which here counts what it gives.

use cap::Cap;
use mimalloc::MiMalloc;

#[global_allocator]
static ALLOCATOR: Cap<MiMalloc> = Cap::new(MiMalloc, usize::MAX);

/// Bytes that are kept when something is done, and what was made.
pub fn kept<T>(make: impl FnOnce() -> T) -> (usize, T) {
    let before = ALLOCATOR.allocated();
    let made = make();
    (ALLOCATOR.allocated().saturating_sub(before), made)
}

/// Bytes that are asked for while something is done, and what was made.
pub fn asked<T>(make: impl FnOnce() -> T) -> (usize, T) {
    let before = ALLOCATOR.total_allocated();
    let made = make();
    (ALLOCATOR.total_allocated() - before, made)
}
