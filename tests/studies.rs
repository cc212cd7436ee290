//! Estimators and tests of studies, on samples whose truth is known.

use approx::assert_relative_eq;
use gouge_studies::decay::Decay;
use gouge_studies::statistics::{Mean, holm, rising, slope};
use gouge_studies::study::{STUDIES, Scale, Study, known};
use gouge_studies::sweep::plan;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::collections::BTreeMap;
use std::f64::consts::{PI, SQRT_2, TAU};
use std::path::Path;

/// A normal number, by Box and Muller.
fn normal(random: &mut Pcg64) -> f64 {
    let (u, v): (f64, f64) = (random.random(), random.random());
    (-2.0 * (1.0 - u).ln()).sqrt() * (TAU * v).cos()
}

/// Friction that rises to a peak of 0.9 at 1 ms and decays to 0.4 at 300 per second, sampled every 0.2 ms, with errors.
fn decaying(mut error: impl FnMut() -> f64) -> [Vec<f64>; 2] {
    let times: Vec<f64> = (0..120).map(|sample| 2e-4 * f64::from(sample)).collect();
    let at = |t: &f64| match *t < 1e-3 - 1e-9 {
        true => 900.0 * t,
        false => 0.4 + 0.5 * (-300.0 * (t - 1e-3)).exp() + error(),
    };
    let friction = times.iter().map(at).collect();
    [times, friction]
}

#[test]
fn an_exact_decay_is_found_exactly() {
    let [times, friction] = decaying(|| 0.0);
    let decay = Decay::fit(&times, &friction).expect("a fit");
    assert_relative_eq!(decay.peak, 0.9, epsilon = 1e-12);
    assert_relative_eq!(decay.peak_time, 1e-3, epsilon = 1e-15);
    assert_relative_eq!(decay.limit, 0.4, epsilon = 1e-6);
    assert_relative_eq!(decay.rate, 300.0, max_relative = 1e-5);
    assert!(decay.deviation() < 1e-6);
}

#[test]
fn the_interval_of_the_limit_covers_the_truth_as_often_as_stated() {
    let mut random = Pcg64::seed_from_u64(7);
    let repetitions = 100;
    let covered = (0..repetitions).filter(|_| {
        // Correlated errors: each remembers a half of the one before.
        let mut error = 0.0;
        let mut first = true;
        let [times, friction] = decaying(|| {
            error = 0.5 * error + 0.02 * normal(&mut random);
            // The peak is known, because its error would move the whole fit.
            if std::mem::take(&mut first) {
                0.2
            } else {
                error
            }
        });
        let mut friction = friction;
        friction[5] = 0.9;
        let high = friction.iter().skip(6).copied().fold(0.0, f64::max);
        friction[5] = friction[5].max(high + 1e-9);
        let decay = Decay::fit(&times, &friction).expect("a fit");
        (decay.limit - 0.4).abs() <= decay.limit_margin()
    });
    // 95 of 100 within three standard deviations, and some allowance for the bootstrap of short blocks.
    let covered = covered.count();
    assert!((85..=100).contains(&covered), "{covered} of {repetitions}");
}

#[test]
fn student_intervals_and_tests_are_as_rare_wrong_as_they_say() {
    let mut random = Pcg64::seed_from_u64(1);
    let repetitions = 4000;
    let (mut outside, mut rejected) = (0, 0);
    for _ in 0..repetitions {
        let values: Vec<f64> = (0..4).map(|_| normal(&mut random)).collect();
        let mean = Mean::of(&values).expect("values");
        let [low, high] = mean.interval(0.9);
        outside += u32::from(low > 0.0 || high < 0.0);
        rejected += u32::from(mean.p_greater() < 0.05);
    }
    // 10 % and 5 %, within four standard deviations.
    assert!((324..=476).contains(&outside), "{outside}");
    assert!((145..=255).contains(&rejected), "{rejected}");
    let single = Mean::of(&[3.0]).expect("a value");
    assert_eq!(single.p_greater(), 1.0);
    assert_eq!(single.interval(0.9), [f64::NEG_INFINITY, f64::INFINITY]);
}

#[test]
fn holm_adjusts_the_example_of_textbooks() {
    let adjusted = holm(&[0.01, 0.04, 0.03, 0.005]);
    for (found, expected) in adjusted.iter().zip([0.03, 0.06, 0.06, 0.02]) {
        assert_relative_eq!(*found, expected, epsilon = 1e-15);
    }
}

#[test]
fn jonckheere_finds_trends_and_no_others() {
    let mut random = Pcg64::seed_from_u64(3);
    let mut groups = |trend: f64| -> Vec<Vec<f64>> {
        let mut value = |place: u32| trend * f64::from(place) + normal(&mut random);
        (0..6)
            .map(|place| (0..3).map(|_| value(place)).collect())
            .collect()
    };
    let rejected = (0..2000).filter(|_| rising(&groups(0.0)) < 0.05).count();
    // 5 % within four standard deviations.
    assert!((61..=139).contains(&rejected), "{rejected}");
    let strong = groups(1.0);
    assert!(rising(&strong) < 1e-4);
    let reversed: Vec<Vec<f64>> = strong.iter().rev().cloned().collect();
    assert_relative_eq!(rising(&strong) + rising(&reversed), 1.0, epsilon = 1e-12);
}

#[test]
fn the_slope_of_a_line_is_its_slope() {
    let points: Vec<[f64; 2]> = [0.3, 1.7, 2.0, 9.0].map(|x| [x, 2.0 - 0.7 * x]).into();
    assert_relative_eq!(slope(&points), -0.7, epsilon = 1e-14);
}

#[test]
fn scenes_accept_every_run_of_every_study() {
    for study in STUDIES {
        for scale in [Scale::Small, Scale::Full] {
            let folder = tempfile::tempdir().expect("a folder");
            for one in study.prepare(scale, folder.path()).expect("sweeps") {
                let name = one.part.name;
                let runs = plan(&one.sweep, &folder.path().join(name)).expect("a plan");
                for run in runs {
                    let scene = run.load();
                    assert!(
                        scene.is_ok(),
                        "{name}: {:?}: {:?}",
                        run.overrides,
                        scene.err()
                    );
                }
            }
        }
    }
}

/// Verdicts on made-up runs, by the beginning of the claim.
fn verdicts(folder: &Path, friction: impl Fn(&str, f64, u64) -> f64) -> BTreeMap<String, String> {
    let mut table = "part,run,law,pressure,setup.seed,status,friction,heat\n".to_owned();
    for law in ["none", "HW", "CS"] {
        for p in [0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0] {
            for seed in 0..6 {
                let mu = friction(law, p, seed);
                // Heat that grows with the root of the pressure.
                let heat = (1.0 + 0.01 * seed as f64) * p.sqrt();
                table += &format!(
                    "corrected-small,{law}-{p}-{seed},{law},{p},{seed},done,{mu},{heat}\n"
                );
            }
        }
    }
    let rows = concluded("thesis", folder, &table).into_iter();
    rows.map(|row| {
        (
            row["claim"].chars().take(24).collect(),
            row["verdict"].clone(),
        )
    })
    .collect()
}

/// The table of claims of a study on made-up runs.
fn concluded(study: &str, folder: &Path, runs: &str) -> Vec<BTreeMap<String, String>> {
    std::fs::write(folder.join("runs.csv"), runs).expect("a table");
    let out = folder.join("out");
    std::fs::create_dir_all(&out).expect("a folder");
    let study = Study::named(study).expect("a study");
    study.conclude(&[], &[folder], &out).expect("conclusions");
    let reader = csv::Reader::from_path(out.join("claims.csv")).expect("claims");
    let rows = reader.into_deserialize::<BTreeMap<String, String>>();
    rows.map(|row| row.expect("a row")).collect()
}

#[test]
fn rocks_are_compared_on_the_same_packings_and_pressures() {
    let mut runs = "part,run,pressure,setup.seed,status,friction,strength\n".to_owned();
    let raised = [("model-granite", 0.0), ("granite", 0.02), ("basalt", 0.2)];
    for seed in 0..6 {
        for p in [0.05, 0.4] {
            for (rock, more) in raised {
                // A lost run costs its packing, not the claim.
                if (rock, seed, p) == ("model-granite", 5, 0.4) {
                    continue;
                }
                // What packings and pressures do to friction is far larger than the difference between rocks.
                let mu = 0.5 * f64::from(seed) - p + more;
                runs += &format!("{rock}-fault,{rock}-{p}-{seed},{p},{seed},done,{mu},\n");
            }
        }
        for (rock, strength) in [("granite", 7e6), ("tonalite", 60e6)] {
            let strength = strength * (1.0 + 0.01 * f64::from(seed));
            runs += &format!("{rock}-tension,{rock}-{seed},,{seed},done,,{strength}\n");
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    let verdict = |row: &BTreeMap<String, String>| (row["part"].clone(), row["verdict"].clone());
    let found = concluded("rocks", folder.path(), &runs);
    let found: BTreeMap<String, String> = found.iter().map(verdict).collect();
    let expected = [
        ("basalt-fault", "refuted"),
        ("granite-fault", "holds"),
        ("granite-tension", "holds"),
        ("tonalite-tension", "refuted"),
    ];
    assert_eq!(
        found,
        BTreeMap::from(expected.map(|(a, b)| (a.to_owned(), b.to_owned())))
    );
}

#[test]
fn claims_are_judged_by_what_the_runs_show() {
    let folder = tempfile::tempdir().expect("a folder");
    let noise = |law: &str, p: f64, seed: u64| {
        let mut random = Pcg64::seed_from_u64(
            seed + (1e4 * p) as u64 + 1000 * law.len() as u64 + u64::from(law == "CS"),
        );
        0.01 * normal(&mut random)
    };
    let rubs = |law: &str| if law == "none" { 0.0 } else { 0.3 };
    // Friction that falls in the middle and is flat at both ends, and is raised by internal friction.
    let flat = |p: f64| -0.2 * p.clamp(0.05, 0.6).ln();
    let found = verdicts(folder.path(), |law, p, seed| {
        rubs(law) + flat(p) + noise(law, p, seed)
    });
    assert_eq!(found["Internal friction raises"], "holds");
    assert_eq!(found["It makes no difference w"], "holds");
    assert_eq!(found["The coefficient of frict"], "holds");
    assert_eq!(found["At very low and very hig"], "holds");
    assert_eq!(found["Heat grows more slowly t"], "holds");
    // The opposite of each.
    let apart = |law: &str| if law == "HW" { -0.3 } else { 0.0 };
    let found = verdicts(folder.path(), |law, p, seed| {
        apart(law) + 0.2 * p.ln() + noise(law, p, seed)
    });
    assert_eq!(found["Internal friction raises"], "refuted");
    assert_eq!(found["It makes no difference w"], "refuted");
    assert_eq!(found["The coefficient of frict"], "refuted");
    // Friction that falls everywhere contradicts that it does not at the ends.
    let found = verdicts(folder.path(), |law, p, seed| {
        -0.2 * p.ln() + noise(law, p, seed)
    });
    assert_eq!(found["At very low and very hig"], "refuted");
    // Nothing but scatter shows nothing.
    let found = verdicts(folder.path(), |law, p, seed| 30.0 * noise(law, p, seed));
    assert_eq!(found["Internal friction raises"], "undecided");
    assert_eq!(found["The coefficient of frict"], "undecided");
}

#[test]
fn the_distributions_of_the_strength_study_have_one_mean() {
    // The mean is 280 MPa pi E[s^2] E[min(r_i, r_j)^2], by sampling.
    let mut random = Pcg64::seed_from_u64(11);
    let radii = [2.0 / (1.0 + SQRT_2), 4.0 / (2.0 + SQRT_2)];
    let number = 400_000;
    let mut strength = || {
        let mut radius = || 1e-3 * random.random_range(radii[0]..radii[1]);
        let least: f64 = f64::min(radius(), radius());
        let factor: f64 = random.random_range(0.9..1.1);
        280e6 * PI * (factor * least).powi(2)
    };
    let mean = (0..number).map(|_| strength()).sum::<f64>() / f64::from(number);
    // One standard error is 0.03 %.
    assert_relative_eq!(mean, 790.3, max_relative = 1.5e-3);
    for (shape, scale) in [(5.0, 860.7), (2.0, 891.8_f64)] {
        let quantile = |u: f64| scale * (-(1.0 - u).ln()).powf(1.0 / shape);
        let uniform = (0..number).map(|k| (f64::from(k) + 0.5) / f64::from(number));
        let mean = uniform.map(quantile).sum::<f64>() / f64::from(number);
        assert_relative_eq!(mean, 790.3, max_relative = 1e-4);
    }
}

/// A table of runs of the study of media, and a table of curves.
const EARLIER: [&str; 2] = [
    "part,run,medium,law,pressure,setup.seed,status,cause,friction,steps\n\
     media,a,air,HW,0.05,0,done,,0.3,100\n",
    "run,time,friction,heat\na,1e-3,0.4,0.1\n",
];

/// Mistakes in them: the table, what is replaced by what, and what the error says.
const MISTAKES: [(usize, [&str; 3]); 10] = [
    (0, [EARLIER[0], "", "runs.csv:1: run: missing"]),
    (0, [EARLIER[0], "garbage\n1\n", "runs.csv:1: run: missing"]),
    (0, ["status", "state", "runs.csv:1: status: missing"]),
    (0, ["medium", "fluid", "runs.csv:1: medium: missing"]),
    (
        0,
        [
            "done",
            "over",
            "runs.csv:2: status = over: must be one of waiting",
        ],
    ),
    (
        0,
        [
            "0.3",
            "much",
            "runs.csv:2: friction = much: must be a number",
        ],
    ),
    (
        0,
        ["100", "1oo", "runs.csv:2: steps = 1oo: must be a number"],
    ),
    (
        0,
        ["media,a", "media,", "runs.csv:2: run: must not be empty"],
    ),
    (1, [EARLIER[1], "", "curves.csv:1: run: missing"]),
    (
        1,
        [
            "0.4",
            "high",
            "curves.csv:2: friction = high: must be a number",
        ],
    ),
];

#[test]
fn mistakes_in_tables_of_earlier_studies_are_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let study = Study::named("media").expect("a study");
    let prepared = study.prepare(Scale::Small, &folder.path().join("out"));
    let prepared = prepared.expect("sweeps");
    let check = |[runs, curves]: [&str; 2]| {
        std::fs::write(folder.path().join("runs.csv"), runs).expect("a file");
        std::fs::write(folder.path().join("curves.csv"), curves).expect("a file");
        known(study, &[folder.path()], &prepared).map_err(|error| error.to_string())
    };
    let found = check(EARLIER).expect("tables");
    assert!(found.len() == 1 && found.contains("a"));
    let short = [EARLIER[0], "media,b\n"].concat();
    let said = check([&short, EARLIER[1]]).expect_err("a short row");
    assert!(said.contains("runs.csv:3: must be CSV"), "{said}");
    for (table, [from, to, words]) in MISTAKES {
        let mut tables = EARLIER.map(str::to_owned);
        tables[table] = tables[table].replacen(from, to, 1);
        let said = check([&tables[0], &tables[1]]).expect_err(words);
        assert!(said.contains(words), "{words}: {said}");
    }
}
