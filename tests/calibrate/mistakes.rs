//! Mistakes in calibration files: file, line, key, value and what is accepted, before anything is run.

use super::command::{Folder, STUDY};

/// What is replaced by what, and what the error says.
type Mistake = [&'static str; 3];

const KEYS: [Mistake; 16] = [
    [
        "[0.05, 20.0]",
        "[20.0, 0.05]",
        "study.toml:4: parameter.range = [20.0, 0.05]: must be two finite numbers",
    ],
    [
        "[0.05, 20.0]",
        "[-1, 20.0]\nscale = \"log\"",
        "study.toml:5: parameter.scale = \"log\": a logarithmic scale needs a positive range",
    ],
    [
        "[0.05, 20.0]",
        "[1e-300, 1e300]",
        "study.toml:4: parameter.range = [1e-300, 1e300]: must be narrower",
    ],
    [
        "[0.05, 20.0]",
        "[-1.7e308, 1.7e308]",
        "study.toml:4: parameter.range = [-1.7e308, 1.7e308]: must be narrower",
    ],
    [
        "[0.05, 20.0]",
        "[1.0, 1.0000001]",
        "study.toml:4: parameter.range = [1.0, 1.0000001]: must be wider",
    ],
    [
        "[0.05, 20.0]",
        "[0.05]",
        "study.toml:4: parameter.range = [0.05]: must be",
    ],
    [
        "[0.05, 20.0]",
        "\"wide\"",
        "study.toml:4: parameter.range = \"wide\": must be an array",
    ],
    [
        "range = [0.05, 20.0]",
        "",
        "study.toml:2: parameter.range: missing",
    ],
    [
        "key = \"contact.normal.damping\"",
        "key = 3",
        "study.toml:3: parameter.key = 3: must be a key, a list of keys, or a table",
    ],
    [
        "sd = 0.06",
        "sd = 0.0",
        "study.toml:16: target.sd = 0.0: must be a positive number",
    ],
    [
        "sd = 0.06",
        "sd = inf",
        "study.toml:16: target.sd = inf: must be a positive number",
    ],
    [
        "sd = 0.06",
        "sd = 1e308",
        "study.toml:16: target.sd = 1e308: must be a positive number",
    ],
    [
        "value = 0.83",
        "value = 1e200",
        "study.toml:15: target.value = 1e200: must be zero, or",
    ],
    [
        "points = 8",
        "points = 2",
        "study.toml:21: design.points = 2: must be from 4 to 4096",
    ],
    [
        "points = 8",
        "point = 8",
        "study.toml:21: design.point = 8: unknown key; accepted here: points, waves, predictive, repetitions",
    ],
    [
        "points = 8",
        "points = -8",
        "study.toml:21: design.points = -8: must be an integer",
    ],
];

const SOURCES: [Mistake; 10] = [
    [
        "\"Durda et al. 2011\"",
        "\" \"",
        "study.toml:17: target.source = \" \": must name who",
    ],
    [
        "source = \"Durda et al. 2011\"",
        "",
        "study.toml:13: target.source: must name who",
    ],
    [
        "verified = true",
        "verified = \"yes\"",
        "study.toml:18: target.verified = \"yes\": must be true or false",
    ],
    [
        "quantity = \"restitution\"\nvalue",
        "quantity = \"angle\"\nvalue",
        "study.toml:14: target.quantity = \"angle\": must be one of restitution",
    ],
    ["value = 0.83", "", "nobody measured restitution"],
    [
        "[design]",
        "[budget]\nruns = 10\n[design]",
        "budget.runs = 10",
    ],
    [
        "[design]",
        "[budget]\ncore_hours = 1e-12\n[design]",
        "budget.core_hours = 1e-12",
    ],
    [
        "[design]",
        "[budget]\ncore_hours = nan\n[design]",
        "study.toml:21: budget.core_hours = nan: must be a finite number, zero or greater",
    ],
    [
        "[design]",
        "[[parameter]]\nkey = \"contact.normal.damping\"\nname = \"other\"\nrange = [1, 2]\n[design]",
        "study.toml:21: parameter.key = \"contact.normal.damping\": must be given once",
    ],
    [
        "[design]",
        "[[parameter]]\nkey = \"material.damping\"\nrange = [1, 2]\n[design]",
        "parameter.name",
    ],
];

const SCENES: [Mistake; 13] = [
    [
        "head-on",
        "no-such-scene",
        "study.toml:8: test.scene = \"no-such-scene\": no-such-scene: must be a readable scene file",
    ],
    [
        "contact.normal.damping",
        "contact.normal.dampings",
        "study.toml:3: parameter.key = \"contact.normal.dampings\": --set contact.normal.dampings=",
    ],
    [
        "time.step=1e-8",
        "time.step=0",
        "study.toml:9: test.set = [\"time.step=0\", \"time.end=12e-6\"]: --set time.step=0: must be",
    ],
    [
        "time.step=1e-8",
        "time.step",
        "study.toml:9: test.set = [\"time.step\"",
    ],
    [
        "scene = \"head-on\"",
        "scene = \"head-on\"\nseeds = \"0..2\"",
        "study.toml:9: test.seeds = \"0..2\": --set setup.seed=0",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "quantity = \"restitution\"\nclosed_form = \"hexagonal-modulus\"\n\n",
        "study.toml:12: test.observe.closed_form = \"hexagonal-modulus\": this closed form is for varying",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "quantity = \"restitution\"\n[[test.observe]]\nquantity = \"repose-angle\"\n\n",
        "study.toml:13: test.observe.quantity = \"repose-angle\": needs a scene with fixed grains",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "quantity = \"restitution\"\n[[test.observe]]\ncolumn = \"strain_xx\"\nstatistic = \"last\"\n\n",
        "study.toml:13: test.observe.column = \"strain_xx\": must be a column of the series: time, kinetic",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "quantity = \"restitution\"\n[[test.observe]]\ncolumn = \"kinetic\"\n\n",
        "study.toml:12: test.observe.statistic: a column needs one of mean, deviation",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "column = \"time\"\nstatistic = \"at-level\"\nagainst = \"kinetic\"\n\n",
        "test.observe.level: belongs to the statistic at-level, which needs it",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "quantity = \"restitution\"\n[[test.observe]]\nquantity = \"restitution\"\n\n",
        "study.toml:12: test.observe.name: must be given once",
    ],
    [
        "quantity = \"restitution\"\n\n",
        "quantity = \"restitutions\"\n\n",
        "study.toml:11: test.observe.quantity = \"restitutions\": must be one of friction, friction-margin",
    ],
    ["[[test]]", "[[test]", "must be TOML"],
];

#[test]
fn mistakes_in_a_calibration_are_named() {
    for [from, to, words] in KEYS.into_iter().chain(SOURCES).chain(SCENES) {
        assert!(STUDY.contains(from), "{from}");
        let folder = Folder::new(&STUDY.replacen(from, to, 1));
        let (status, _, said) = folder.calibrate("out", &[]);
        assert_eq!(status, Some(2), "{words}: {said}");
        assert!(said.contains(words), "{words}: {said}");
        assert!(!folder.path("out/runs").exists(), "{words}");
    }
}
