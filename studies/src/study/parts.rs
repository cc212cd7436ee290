//! The sweeps of which the study consists.

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Blocks of 25 mm, four seeds.
    Small,
    /// Blocks of 100 mm with four seeds, of 25 mm with 32.
    Full,
}

/// A sweep of the study.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name, also of its folder.
    pub name: &'static str,
    /// Its sweep file.
    pub sweep: String,
}

/// The sweep files; `SEEDS` stands for the seeds.
const SWEEPS: [(&str, &str); 5] = [
    (
        "corrected-small",
        include_str!("sweeps/corrected-small.toml"),
    ),
    ("thesis-small", include_str!("sweeps/thesis-small.toml")),
    ("variants-small", include_str!("sweeps/variants-small.toml")),
    ("corrected-full", include_str!("sweeps/corrected-full.toml")),
    ("thesis-full", include_str!("sweeps/thesis-full.toml")),
];

/// The parts of a study, in the order in which they are run.
pub fn parts(scale: Scale) -> Vec<Part> {
    let seeds = |name: &str| match (scale, name) {
        (Scale::Small, _) | (Scale::Full, "corrected-full" | "thesis-full") => "0..4",
        (Scale::Full, _) => "0..32",
    };
    let is_run = |name: &str| scale == Scale::Full || name.ends_with("-small");
    let part = |(name, text): (&'static str, &str)| Part {
        name,
        sweep: text.replace("SEEDS", seeds(name)),
    };
    let all = SWEEPS.into_iter().filter(|(name, _)| is_run(name));
    all.map(part).collect()
}
