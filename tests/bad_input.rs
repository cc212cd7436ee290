//! Invalid input: every error names file, line, key, value and what is accepted.
//!
//! The cases are data: `bad_input/NAME.txt` lists mistakes in the valid scene `bad_input/NAME.toml`.
//! A case is a paragraph of lines that begin with a mark; `\n`, `\r` and `\xNN` stand for bytes.
//!
//! | mark | meaning |
//! |---|---|
//! | `#` | a comment |
//! | `-`, `+` | the first text in the scene is replaced by the second |
//! | `$` | an override, `KEY=VALUE` |
//! | `@` | a CSV file of the scene is replaced: its name, a space, its content |
//! | `=` | the message after file and line; the line is the one that ends with `# here`, or else the first |
//! | `!` | the message from the name of the CSV file on |
//! | `>` | the whole message |
//!
//! ` ... ` in an expected message stands for any text.

use crate::program::{gouge, stderr};
use gouge_runner::scene::{Overrides, Scene};
use rand::RngExt;
use rand_pcg::Pcg64;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Longest time that the program may take to reject its input.
const PATIENCE: Duration = Duration::from_secs(20);

/// CSV files of the scenes `bad_input/beside.toml` and `bad_input/grains.toml`.
const BESIDE: [(&str, &str); 5] = [
    (
        "p.csv",
        "x,y,radius,vx,role\n0,0,1e-3,0,free\n2e-3,0,1e-3,0,free\n3.9e-3,0,1e-3,0,fixed\n",
    ),
    ("b.csv", "i,j,strength_factor\n0,1,1.0\n"),
    (
        "c.csv",
        "i,j,initial_angle_i,initial_angle_j\n1,2,0.1,0.2\n",
    ),
    ("n.csv", "x,y,area\n0,0,4e-8\n2e-4,0,4e-8\n0,2e-4,4e-8\n"),
    ("nb.csv", "i,j\n0,1\n0,2\n"),
];

/// A mistake and the message that it must cause.
#[derive(Clone, Debug, Default)]
struct Case {
    scene: Vec<u8>,
    overrides: Vec<String>,
    beside: Vec<(String, Vec<u8>)>,
    /// `FOLDER` stands for the folder of the scene.
    expected: String,
}

/// A folder in which invalid scenes are tested one after another.
struct Bench {
    folder: TempDir,
    failures: Vec<String>,
}

impl Bench {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        Self {
            folder,
            failures: Vec::new(),
        }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Test a case with all commands that take a scene.
    fn check(&mut self, case: &Case) {
        let scene = self.path("scene.toml");
        std::fs::write(&scene, &case.scene).expect("the folder is writable");
        let beside = BESIDE.iter().map(|(name, text)| (*name, text.as_bytes()));
        let replaced = case
            .beside
            .iter()
            .map(|(name, bytes)| (name.as_str(), &bytes[..]));
        for (name, bytes) in beside.chain(replaced) {
            std::fs::write(self.path(name), bytes).expect("the folder is writable");
        }
        let folder = self.folder.path().display().to_string();
        let expected = format!("gouge: {}", case.expected.replace("FOLDER", &folder));
        self.refuses(&scene, &case.overrides, &expected);
    }

    /// Check that all commands that take a scene reject it with the expected message.
    fn refuses(&mut self, scene: &Path, overrides: &[String], expected: &str) {
        let out = self.path("out");
        for command in ["run", "links", "stability"] {
            let mut program = gouge();
            program.arg(command).arg(scene);
            for text in overrides {
                program.arg("--set").arg(text);
            }
            if command == "run" {
                program.arg("--out").arg(&out);
            }
            let output = within(PATIENCE, program);
            let said = stderr(&output);
            let is_refused = output.status.code() == Some(2)
                && output.stdout.is_empty()
                && matches(&said, expected)
                && !said.contains("panicked")
                && said.len() < 2000
                && !said.trim_end().contains(|c: char| c.is_control())
                && !out.exists();
            if !is_refused {
                let (status, said) = (output.status, said.chars().take(600).collect::<String>());
                self.failures.push(format!(
                    "{command} {overrides:?}\nexpected {expected}\nfound {status} {said}"
                ));
                let _ = std::fs::remove_dir_all(&out);
                return;
            }
        }
    }

    fn finish(self) {
        let number = self.failures.len();
        assert!(
            number == 0,
            "{number} failures:\n\n{}",
            self.failures.join("\n")
        );
    }
}

/// Output of a program, which is killed after the given time.
fn within(patience: Duration, mut command: Command) -> Output {
    let command = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    let began = Instant::now();
    // The output is short enough to fit into the pipes.
    while child.try_wait().expect("the program is ours").is_none() {
        if began.elapsed() > patience {
            let _ = child.kill();
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    child.wait_with_output().expect("the program is ours")
}

/// Whether a message begins with the expected text, in which ` ... ` stands for any text.
fn matches(said: &str, expected: &str) -> bool {
    let mut parts = expected.split(" ... ");
    let begins = parts.next().is_some_and(|first| said.starts_with(first));
    begins && parts.all(|part| said.contains(part))
}

/// The bytes of a text of a case, with escapes replaced.
fn bytes_of(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.bytes().next() {
        let (byte, used) = match rest.as_bytes() {
            [b'\\', b'n', ..] => (b'\n', 2),
            [b'\\', b'r', ..] => (b'\r', 2),
            [b'\\', b'x', ..] => (u8::from_str_radix(&rest[2..4], 16).expect("hex"), 4),
            _ => (first, 1),
        };
        bytes.push(byte);
        rest = rest.get(used..).expect("cases are ASCII");
    }
    bytes
}

fn replaced(scene: &str, old: &str, new: &str) -> String {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("scenes of cases are UTF-8");
    let (old, new) = (text(bytes_of(old)), text(bytes_of(new)));
    assert!(scene.contains(&old), "no such text: {old}");
    scene.replacen(&old, &new, 1)
}

/// The case that a paragraph describes.
fn case(scene: &str, paragraph: &str) -> Option<Case> {
    let mut scene = scene.to_owned();
    let (mut case, mut old) = (Case::default(), "");
    for line in paragraph.lines() {
        let (mark, text) = (&line[..1], line.get(2..).unwrap_or_default());
        match mark {
            "-" => old = text,
            "+" => scene = replaced(&scene, old, text),
            "@" => {
                let (name, content) = text.split_once(' ').expect("a name and a content");
                case.beside.push((name.to_owned(), bytes_of(content)));
            }
            "=" => {
                let marked = scene.lines().position(|line| line.ends_with("# here"));
                case.expected = format!("FOLDER/scene.toml:{}: {text}", 1 + marked.unwrap_or(0));
            }
            "!" => case.expected = format!("FOLDER/{text}"),
            ">" => case.expected = text.to_owned(),
            "$" => case.overrides.push(text.to_owned()),
            _ => {}
        }
    }
    case.scene = scene.into_bytes();
    (!case.expected.is_empty()).then_some(case)
}

/// Test all cases of a list and return their number.
fn check_list(scene: &str, list: &str) -> usize {
    let mut bench = Bench::new();
    // The scene itself is valid, so each error is due to the one mistake.
    let path = bench.path("scene.toml");
    std::fs::write(&path, scene).expect("the folder is writable");
    for (name, text) in BESIDE {
        std::fs::write(bench.path(name), text).expect("the folder is writable");
    }
    let output = crate::program::run(&["links", path.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", stderr(&output));
    let cases: Vec<Case> = list
        .split("\n\n")
        .filter_map(|text| case(scene, text))
        .collect();
    cases.iter().for_each(|case| bench.check(case));
    bench.finish();
    cases.len()
}

#[test]
fn mistakes_in_a_scene_with_every_table_are_named() {
    let list = include_str!("bad_input/full.txt");
    assert!(check_list(include_str!("bad_input/full.toml"), list) > 130);
}

#[test]
fn mistakes_in_a_set_up_are_named() {
    let list = include_str!("bad_input/made.txt");
    assert!(check_list(include_str!("bad_input/made.toml"), list) > 50);
}

#[test]
fn mistakes_in_scenes_of_contact_dynamics_are_named() {
    let list = include_str!("bad_input/polygons.txt");
    assert!(check_list(include_str!("bad_input/polygons.toml"), list) > 30);
    let list = include_str!("bad_input/packings.txt");
    assert!(check_list(include_str!("bad_input/packings.toml"), list) > 12);
}

#[test]
fn mistakes_in_scenes_of_peridynamic_grains_are_named() {
    let list = include_str!("bad_input/grains.txt");
    assert!(check_list(include_str!("bad_input/grains.toml"), list) > 50);
}

#[test]
fn mistakes_in_csv_files_are_named() {
    let list = include_str!("bad_input/beside.txt");
    assert!(check_list(include_str!("bad_input/beside.toml"), list) > 35);
}

#[test]
fn mistakes_in_overrides_are_named() {
    let list = include_str!("bad_input/overrides.txt");
    assert!(check_list(include_str!("bad_input/full.toml"), list) > 50);
}

/// The override that sets the value shown in the expected message of a case, if the message shows the whole value.
fn same_mistake(case: &Case) -> Option<String> {
    let (_, message) = case
        .expected
        .strip_prefix("FOLDER/scene.toml:")?
        .split_once(": ")?;
    let (key, rest) = message.split_once(" = ")?;
    let (value, _) = rest.split_once(": ")?;
    let not_toml = ["...", "[array of", "{table}", "\\u{", "#"];
    let is_toml = !not_toml.iter().any(|part| value.contains(part));
    let key = key.replace('[', ".").replace(']', "");
    (is_toml && !message.contains("must be TOML")).then(|| format!("{key}={value}"))
}

#[test]
fn an_override_leads_to_the_error_of_the_same_value_in_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let lists = [
        (
            include_str!("bad_input/full.toml"),
            include_str!("bad_input/full.txt"),
        ),
        (
            include_str!("bad_input/made.toml"),
            include_str!("bad_input/made.txt"),
        ),
    ];
    let cases = lists.iter().flat_map(|(scene, list)| {
        let cases = list.split("\n\n").filter_map(|text| case(scene, text));
        cases.filter_map(|case| Some((same_mistake(&case)?, case.scene)))
    });
    let mut number = 0;
    for (text, scene) in cases {
        let overrides = Overrides::parse(&[&text]).expect("usable overrides");
        let parse = |overrides: &Overrides| {
            Scene::parse_with("scene.toml", &scene, folder.path(), overrides)
                .expect_err("the scene has a mistake")
        };
        let (of_file, of_override) = (parse(&Overrides::default()), parse(&overrides));
        assert_eq!(of_override.accepted, of_file.accepted, "{text}");
        let expected = format!("--set {text}: {}", of_file.accepted);
        assert_eq!(of_override.to_string(), expected);
        number += 1;
    }
    assert!(number > 150, "{number}");
}

/// Pseudo-random bytes.
fn noise(number: usize) -> Vec<u8> {
    let mut source = Pcg64::new(11, 12);
    (0..number).map(|_| source.random::<u8>()).collect()
}

/// Pseudo-random characters, from a line feed to far beyond ASCII.
fn text_noise(number: usize) -> Vec<u8> {
    let mut source = Pcg64::new(13, 14);
    let mut one = || match source.random::<u32>() % 8 {
        0..6 => char::from(10 + (source.random::<u32>() % 117) as u8),
        _ => char::from_u32(source.random::<u32>() % 0x3000).unwrap_or('\n'),
    };
    (0..number).map(|_| one()).collect::<String>().into_bytes()
}

/// Size of a file far larger than any scene, in bytes.
const MANY: usize = 1 << 20;

fn many(text: &str, number: usize) -> Vec<u8> {
    text.repeat(number).into_bytes()
}

/// Files that are empty, random or truncated, with the expected messages.
fn no_scenes() -> [(Vec<u8>, &'static str); 11] {
    [
        (vec![], "scene.toml:1: time: missing"),
        (b"\n\n\n".to_vec(), "scene.toml:1: time: missing"),
        (b"# nothing\n".to_vec(), "scene.toml:1: time: missing"),
        (b"\xef\xbb\xbf".to_vec(), "scene.toml:1: time: missing"),
        (vec![0; 1000], "scene.toml:1: \\0\\0"),
        (vec![b' '; MANY], "scene.toml:1: time: missing"),
        (vec![b'\n'; MANY], "scene.toml:1: time: missing"),
        (
            noise(10 * MANY),
            "scene.toml:1: byte 0x ... must be a TOML file in UTF-8",
        ),
        (text_noise(10 * MANY), "scene.toml:1: ... must be TOML"),
        (
            b"title = \"a\"\n\nx = \"\xff\"\n".to_vec(),
            "scene.toml:3: byte 0xff: must be a TOML",
        ),
        (
            b"title = \"\"\"\nnever\nends\n".to_vec(),
            "scene.toml:4: must be TOML: invalid multi-line basic string",
        ),
    ]
}

/// Files in which something is repeated very often, with the expected messages.
fn repetitive_scenes() -> [(Vec<u8>, &'static str); 13] {
    [
        (many("[", 100_000), "scene.toml:1: [[[ ... must be TOML"),
        (many("a = [", 1), "scene.toml:1: a = [: must be TOML"),
        (
            [b"a = ".to_vec(), many("[", 100_000)].concat(),
            "scene.toml:1: a = [[[ ... must be TOML",
        ),
        (
            [b"a = ".to_vec(), many("{a=", 100_000)].concat(),
            "scene.toml:1: a = {a={a= ... must be TOML",
        ),
        (
            [many("a.", 100_000), b"a = 1".to_vec()].concat(),
            "scene.toml:1: a",
        ),
        (
            [b"[".to_vec(), many("a.", 100_000), b"a]".to_vec()].concat(),
            "scene.toml:1: ",
        ),
        (
            many("[[a]]\n", 100_000),
            "scene.toml:1: a = [array of 100000]: unknown key",
        ),
        (
            many("[a.b]\n", 2),
            "scene.toml:2: [a.b]: must be TOML: duplicate key",
        ),
        (
            many("x = 1\n", MANY / 6),
            "scene.toml:2: x = 1: must be TOML: duplicate key",
        ),
        (
            [b"title = \"".to_vec(), vec![b'a'; MANY]].concat(),
            "scene.toml:1: title = \"aaa",
        ),
        (
            [b"a = ".to_vec(), vec![b'9'; MANY]].concat(),
            "scene.toml:1: a = 999 ... unknown key",
        ),
        (
            [b"[time]\nend = ".to_vec(), vec![b'9'; MANY]].concat(),
            "scene.toml:2: time.end = 999 ... 64 bits",
        ),
        (vec![b'a'; MANY], "scene.toml:1: aaa ... must be TOML"),
    ]
}

#[test]
fn files_that_are_not_scenes_are_refused() {
    let mut bench = Bench::new();
    for (scene, expected) in no_scenes().into_iter().chain(repetitive_scenes()) {
        bench.check(&Case {
            scene,
            expected: format!("FOLDER/{expected}"),
            ..Case::default()
        });
    }
    bench.finish();
}

#[test]
fn scenes_that_cannot_be_read_are_refused() {
    let mut bench = Bench::new();
    let folder = bench.folder.path().to_owned();
    let below = folder.join("file");
    std::fs::write(&below, "").expect("the folder is writable");
    for path in [
        &folder,
        &folder.join("missing.toml"),
        &below.join("x.toml"),
        Path::new(""),
    ] {
        let expected = format!(
            "gouge: {}: must be a readable scene file or one of the built-in scenes granite-fault, ",
            path.display()
        );
        bench.refuses(path, &[], &expected);
    }
    let expected = "gouge: granite: must be a readable scene file or one of the built-in scenes";
    bench.refuses(Path::new("granite"), &[], expected);
    bench.finish();
}

#[test]
fn unusable_arguments_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let out = out.to_str().expect("UTF-8");
    let cases: [(&[&str], &str); 16] = [
        (&[], "Usage"),
        (&["fly"], "fly"),
        (&["run"], "SCENE"),
        (&["run", "head-on"], "--out"),
        (&["run", "--out", out], "SCENE"),
        (&["run", "head-on", "--out"], "--out"),
        (&["run", "head-on", "--out", ""], "--out"),
        (&["run", "head-on", "--out", out, "--restart"], "--restart"),
        (&["run", "head-on", "oblique", "--out", out], "oblique"),
        (&["run", "heads-on", "--out", out], "heads-on"),
        (&["links"], "SCENE"),
        (&["links", "head-on", "--set"], "--set"),
        (&["scenes", "head-on", "--set", "time.step=1"], "--set"),
        (&["stability", "no-such-scene"], "no-such-scene"),
        (&["scenes", "no-such-scene"], "granite-fault"),
        (
            &["verify", "--only", "no-such-check", "--out", out],
            "no check matches",
        ),
    ];
    for (arguments, expected) in cases {
        let mut program = gouge();
        program.args(arguments).current_dir(folder.path());
        let output = within(PATIENCE, program);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(expected), "{arguments:?}: {said}");
        assert!(!said.contains("panicked"), "{arguments:?}: {said}");
    }
    assert!(
        std::fs::read_dir(folder.path())
            .expect("ours")
            .next()
            .is_none()
    );
}
