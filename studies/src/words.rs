//! Numbers in words for people: durations and counts.

/// A duration in s with a fitting unit.
pub fn duration(seconds: f64) -> String {
    let [minutes, hours] = [seconds / 60.0, seconds / 3600.0];
    match seconds {
        ..0.1 => format!("{seconds:.3} s"),
        ..10.0 => format!("{seconds:.1} s"),
        ..120.0 => format!("{seconds:.0} s"),
        ..7200.0 => format!("{minutes:.0} min"),
        _ => format!("{hours:.1} h"),
    }
}

/// A number of things.
pub fn counted(number: usize, thing: &str) -> String {
    match number {
        1 => format!("1 {thing}"),
        _ => format!("{number} {thing}s"),
    }
}
