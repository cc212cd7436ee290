//! The allocator of `gouge`, which here counts allocated bytes.

use cap::Cap;
use mimalloc::MiMalloc;

#[global_allocator]
static ALLOCATOR: Cap<MiMalloc> = Cap::new(MiMalloc, usize::MAX);

/// Number of bytes that remain allocated after a call, and the result of the call.
pub fn kept<T>(make: impl FnOnce() -> T) -> (usize, T) {
    let before = ALLOCATOR.allocated();
    let made = make();
    (ALLOCATOR.allocated().saturating_sub(before), made)
}

/// Number of bytes that are allocated during a call, and the result of the call.
pub fn asked<T>(make: impl FnOnce() -> T) -> (usize, T) {
    let before = ALLOCATOR.total_allocated();
    let made = make();
    (ALLOCATOR.total_allocated() - before, made)
}
