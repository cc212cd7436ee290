//! Processor time, so that other programs on the machine matter less.

/// Seconds of processor time of this thread.
#[cfg(unix)]
pub fn now() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Seconds since 1970, where processor time is not known.
#[cfg(not(unix))]
pub fn now() -> f64 {
    let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    since.map_or(0.0, |time| time.as_secs_f64())
}

/// Seconds that an action took, and its result.
pub fn time<T>(action: impl FnOnce() -> T) -> (f64, T) {
    let start = now();
    let result = action();
    (now() - start, result)
}
