//! The machine on which times were measured.

/// Processor, system and threads, as text.
pub fn words() -> String {
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let (architecture, system) = (std::env::consts::ARCH, std::env::consts::OS);
    let processor = processor().map_or(String::new(), |name| format!("{name}, "));
    format!("{processor}{architecture} {system}, {threads} threads")
}

/// Name of the processor, if the system reports it.
fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}
