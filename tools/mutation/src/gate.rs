//! The tests of the gate as programs that are run directly.

use crate::Outcome;
use crate::kernel::Kernel;
use crate::results::{Fate, Results};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::time::{Duration, Instant};

/// Tests that are not run: those that read the sources, which differ in the copy; those that start the
/// program; the thorough half of the register; and long ones whose subject has a quick check.
const SKIPPED: [&str; 15] = [
    "perturbation::",
    "code_size::",
    "layering::",
    "equations::",
    "commands::",
    "program::",
    "bad_input::",
    "nothing_lost::",
    "register::thorough::",
    "pay_for_use::a_recorded_state_continues_with_the_same_bits",
    "estimators::the_radial_distribution_of_an_ideal_gas_is_corrected_for_edges",
    "estimators::an_ideal_gas_has_no_excess_entropy",
    "collisions::restitution_of_truncated_kelvin_voigt",
    "strips::a_step_in_one_thread_allocates_nothing",
    "strips::bits_do_not_depend_on_threads",
];

/// Time limit of a test, in units of its time without a fault.
const PATIENCE: f64 = 10.0;
/// What is added to the time limit, in s.
const GRACE: f64 = 10.0;

/// Shell script that runs a program with at most 8 GiB of memory, because a fault may allocate any amount.
const LIMITED: &str = "ulimit -v 8388608; exec \"$@\"";

/// Environment in which random tests draw the same cases for each fault and write no files if they fail.
const FIXED: [(&str, &str); 4] = [
    ("PROPTEST_RNG_SEED", "1"),
    ("PROPTEST_MAX_SHRINK_ITERS", "0"),
    ("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1"),
    ("INSTA_UPDATE", "no"),
];

/// A test: its program and its name.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Test {
    /// Index of the program.
    program: usize,
    /// Name of the test.
    name: String,
    /// Run time in s without a fault.
    seconds: f64,
    /// The switches that the test meets.
    uses: Vec<usize>,
}

/// All tests, fast ones first.
#[derive(Debug, Serialize, Deserialize)]
pub struct Tests(Vec<Test>);

/// The programs of the gate.
pub struct Gate {
    programs: Vec<PathBuf>,
    folder: PathBuf,
}

/// How a run of tests ended.
enum End {
    Passed,
    Failed(String),
    Late,
}

impl Gate {
    /// Build the gate of the copied workspace with a profile of cargo.
    ///
    /// # Errors
    /// A workspace that does not compile.
    pub fn build(copy: &Path, profile: &str, kernel: Kernel) -> Outcome<Self> {
        let [package, test, folder] = kernel.gate();
        let output = cargo(copy)
            .args(["test", "--no-run", "--message-format=json"])
            .args(["--profile", profile, "-p", package, "--test", test])
            .stderr(Stdio::inherit())
            .output()?;
        let text = String::from_utf8_lossy(&output.stdout);
        if !output.status.success() {
            return Err(complaint(&errors(&text)).into());
        }
        let mut programs: Vec<PathBuf> = text
            .lines()
            .filter_map(|line| program(line, test))
            .collect();
        programs.sort();
        Ok(Self {
            programs,
            folder: copy.join(folder),
        })
    }

    /// A name that distinguishes this gate from others.
    pub fn name(&self) -> String {
        let of = |path: &PathBuf| {
            let modified = fs::metadata(path).and_then(|data| data.modified());
            format!("{} {modified:?}", path.display())
        };
        self.programs.iter().map(of).collect::<Vec<_>>().join(" ")
    }

    /// The switches that each test meets, from an earlier run or by running each test once.
    ///
    /// # Errors
    /// A test that fails without a fault.
    pub fn learn(
        &self,
        folder: &Path,
        jobs: usize,
        switches: usize,
        results: &mut Results,
    ) -> Outcome<Tests> {
        if let Some(tests) = results.tests() {
            return Ok(tests);
        }
        let names = self.names()?;
        println!("{} tests, {switches} switches", names.len());
        let (next, found) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
        let work = || -> Outcome<()> {
            loop {
                let number = next.fetch_add(1, Ordering::Relaxed);
                let Some((program, name)) = names.get(number) else {
                    return Ok(());
                };
                let log = folder.join(format!("used-{number}"));
                let test = self.observe(*program, name, &log)?;
                found
                    .lock()
                    .map_err(|_| "another job has failed")?
                    .push(test);
            }
        };
        std::thread::scope(|scope| -> Outcome<()> {
            let running: Vec<_> = (0..jobs).map(|_| scope.spawn(work)).collect();
            for job in running {
                job.join().map_err(|_| "a job has failed")??;
            }
            Ok(())
        })?;
        let mut found = found.into_inner().map_err(|_| "a job has failed")?;
        found.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let tests = Tests(found);
        results.keep_tests(&tests)?;
        Ok(tests)
    }

    /// Run one test, and run it again to record the switches that it meets. Recording takes memory and time: a test
    /// of memory use may fail then, and the time is not that of the test.
    fn observe(&self, program: usize, name: &str, log: &Path) -> Outcome<Test> {
        let start = Instant::now();
        if let End::Failed(test) = self.run(program, &[name], &[], None)? {
            return Err(format!("{test} fails as it is").into());
        }
        let seconds = start.elapsed().as_secs_f64();
        let _ = fs::remove_file(log);
        let variable = ("GOUGE_FAULTS_MET", log.to_string_lossy().into_owned());
        self.run(program, &[name], &[variable], None)?;
        let text = fs::read_to_string(log).unwrap_or_default();
        let _ = fs::remove_file(log);
        let uses = text.lines().map(str::parse).collect::<Result<_, _>>()?;
        Ok(Test {
            program,
            name: name.to_owned(),
            seconds,
            uses,
        })
    }

    /// All tests that are not skipped, with their programs.
    fn names(&self) -> Outcome<Vec<(usize, String)>> {
        let mut names = Vec::new();
        for (number, program) in self.programs.iter().enumerate() {
            let output = Command::new(program)
                .args(["--list", "--format", "terse"])
                .current_dir(&self.folder)
                .output()?;
            let text = String::from_utf8(output.stdout)?;
            let tests = text.lines().filter_map(|line| line.strip_suffix(": test"));
            let wanted = tests.filter(|name| !SKIPPED.iter().any(|skip| name.contains(skip)));
            names.extend(wanted.map(|name| (number, name.to_owned())));
        }
        Ok(names)
    }

    /// Switch on a fault and run the tests that meet its switch until one fails.
    ///
    /// # Errors
    /// A program that cannot be run.
    pub fn try_fault(&self, switch: usize, tests: &Tests) -> Outcome<Fate> {
        let meets = |test: &&Test| test.uses.contains(&switch);
        let users: Vec<&Test> = tests.0.iter().filter(meets).collect();
        if users.is_empty() {
            return Ok(Fate::Unused);
        }
        let variable = [("GOUGE_FAULT", switch.to_string())];
        // Start with few tests per program run, and increase their number as long as none fails.
        let (mut from, mut size) = (0, 8);
        while from < users.len() {
            let batch = &users[from..users.len().min(from + size)];
            let mut by_program: BTreeMap<usize, (Vec<&str>, f64)> = BTreeMap::new();
            for test in batch {
                let (names, seconds) = by_program.entry(test.program).or_default();
                names.push(&test.name);
                *seconds = seconds.max(test.seconds);
            }
            for (program, (names, seconds)) in by_program {
                let limit = Duration::from_secs_f64(GRACE + PATIENCE * seconds);
                match self.run(program, &names, &variable, Some(limit))? {
                    End::Passed => {}
                    End::Failed(test) => return Ok(Fate::Caught(test)),
                    End::Late => return Ok(Fate::Endless),
                }
            }
            from += size;
            size *= 2;
        }
        Ok(Fate::Survived)
    }

    /// Run tests of a program, one after another, until one fails or takes longer than the limit.
    fn run(
        &self,
        program: usize,
        names: &[&str],
        variables: &[(&str, String)],
        limit: Option<Duration>,
    ) -> Outcome<End> {
        if names.is_empty() {
            return Ok(End::Passed);
        }
        let mut child = Command::new("sh")
            .args(["-c", LIMITED, "sh"])
            .arg(&self.programs[program])
            .args(["--exact", "--test-threads=1"])
            .envs(FIXED)
            .args(names)
            .envs(variables.iter().map(|(name, value)| (*name, value)))
            .current_dir(&self.folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let end = watch(&mut child, limit);
        let _ = child.kill();
        let status = child.wait()?;
        match end {
            Some(end) => Ok(end),
            None if status.success() => Ok(End::Passed),
            None => Ok(End::Failed(format!("one of {}", names.join(", ")))),
        }
    }
}

/// Cargo in the copied workspace, with its own target folder.
pub fn cargo(copy: &Path) -> Command {
    let mut command = Command::new(env!("CARGO"));
    command.current_dir(copy).env_remove("CARGO_TARGET_DIR");
    command
}

/// Read the output of a program until a test fails or nothing is printed within the time limit; `None` at the end of
/// the output.
fn watch(child: &mut Child, limit: Option<Duration>) -> Option<End> {
    let output = BufReader::new(child.stdout.take()?);
    let (send, receive) = mpsc::channel();
    std::thread::spawn(move || {
        for line in output.lines().map_while(Result::ok) {
            if send.send(line).is_err() {
                return;
            }
        }
    });
    loop {
        let line = match limit {
            None => receive.recv().ok()?,
            Some(limit) => match receive.recv_timeout(limit) {
                Ok(line) => line,
                Err(mpsc::RecvTimeoutError::Disconnected) => return None,
                Err(mpsc::RecvTimeoutError::Timeout) => return Some(End::Late),
            },
        };
        if let Some(test) = line
            .strip_prefix("test ")
            .and_then(|rest| rest.strip_suffix(" ... FAILED"))
        {
            return Some(End::Failed(test.to_owned()));
        }
    }
}

/// The program of a test that a message of cargo names.
fn program(line: &str, test: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    let is_test = message["profile"]["test"].as_bool()?;
    let name = message["target"]["name"].as_str()?;
    let wanted = is_test && name == test;
    wanted.then(|| message["executable"].as_str().map(PathBuf::from))?
}

/// The errors among the messages of cargo.
pub fn errors(text: &str) -> Vec<serde_json::Value> {
    let error = |line: &str| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        let message = &message["message"];
        (message["level"].as_str()? == "error").then(|| message.clone())
    };
    text.lines().filter_map(error).collect()
}

/// The text of the compiler's errors.
pub fn complaint(errors: &[serde_json::Value]) -> String {
    let rendered = errors.iter().filter_map(|one| one["rendered"].as_str());
    let all: Vec<&str> = rendered.collect();
    format!("the copy does not compile\n{}", all.join("\n"))
}
