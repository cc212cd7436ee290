//! Runs the runs of a sweep, several at a time, each in a process of its own.

use super::plan::{Planned, open};
use super::state::{CAUSE, State, Status};
use gouge_runner::error::Error;
use rustix::process::{Pid, Signal, kill_process};
use std::ffi::OsString;
use std::io::Read;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Time between looks at a running process.
const PATIENCE: Duration = Duration::from_millis(2);
/// Time between attempts while another process runs the same run.
const PAUSE: Duration = Duration::from_millis(200);
/// Time without a change in the folder of a run after which nobody runs it any more.
const SILENCE: Duration = Duration::from_secs(60);
/// Status of a process that was interrupted.
const INTERRUPTED: i32 = 130;

/// How the program `gouge` is started.
#[derive(Clone, Debug)]
pub struct Program {
    /// The file that is started.
    pub file: PathBuf,
    /// Its first arguments, before those of the command line.
    pub arguments: Vec<OsString>,
}

impl Program {
    /// The file of this process; if it cannot be found, the program of that name on the path.
    pub fn of_this_process() -> Self {
        Self {
            file: std::env::current_exe().unwrap_or_else(|_| PathBuf::from("gouge")),
            arguments: Vec::new(),
        }
    }
}

/// How runs are executed.
#[derive(Clone, Copy, Debug)]
pub struct Execution<'a> {
    /// The program `gouge`.
    pub program: &'a Program,
    /// Folder of the sweep.
    pub out: &'a Path,
    /// Number of runs at a time.
    pub jobs: usize,
    /// Set when the sweep is to stop; the running processes then leave checkpoints and end.
    pub stop: &'a AtomicBool,
}

/// What is known when a run ends.
#[derive(Clone, Debug)]
pub struct Progress {
    /// Name of the run.
    pub name: String,
    /// Its state.
    pub state: State,
}

/// Execute all runs that are not final; a run that was begun continues from its checkpoint. `report` is called after
/// each.
///
/// # Errors
/// A process that cannot be started, a failure of the file system, or an interruption.
pub fn execute(
    runs: &[Planned],
    execution: Execution,
    report: &(dyn Fn(Progress) + Sync),
) -> Result<(), Error> {
    let open = open(runs, execution.out);
    let waiting: Mutex<Vec<&Planned>> = Mutex::new(open.into_iter().rev().collect());
    let failure: Mutex<Option<Error>> = Mutex::new(None);
    let next = || match (execution.stop.load(Ordering::Relaxed), waiting.lock()) {
        (false, Ok(mut waiting)) => waiting.pop(),
        _ => None,
    };
    let fail = |error| {
        execution.stop.store(true, Ordering::Relaxed);
        if let Ok(mut failure) = failure.lock() {
            failure.get_or_insert(error);
        }
    };
    let work = || {
        while let Some(run) = next() {
            let name = run.name.clone();
            match execute_one(run, execution) {
                Ok(state) => report(Progress { name, state }),
                Err(error) => fail(error),
            }
        }
    };
    std::thread::scope(|scope| {
        (0..execution.jobs.min(runs.len())).for_each(|_| drop(scope.spawn(work)));
    });
    let failure = failure.into_inner().unwrap_or_default();
    match (failure, execution.stop.load(Ordering::Relaxed)) {
        (Some(error), _) => Err(error),
        (None, true) => Err(Error::Stopped(execution.out.to_owned())),
        (None, false) => Ok(()),
    }
}

/// Execute a run. While another process runs it, such as one that a killed sweep left behind, wait for that one.
fn execute_one(run: &Planned, execution: Execution) -> Result<State, Error> {
    let folder = run.folder(execution.out);
    let failed = |error| Error::file("run", &execution.program.file, error);
    loop {
        let child = command(run, &folder, execution).spawn().map_err(failed)?;
        let (code, said) = wait(child, execution.stop).map_err(failed)?;
        let is_stopped = execution.stop.load(Ordering::Relaxed);
        if !said.contains("is in use by") || is_stopped || !is_active(&folder) {
            return state_after(&folder, code, &said, is_stopped);
        }
        std::thread::sleep(PAUSE);
    }
}

fn command(run: &Planned, folder: &Path, execution: Execution) -> Command {
    let mut command = Command::new(&execution.program.file);
    command.args(&execution.program.arguments);
    // As one word, so that the name of a folder may begin like an option.
    let mut out = OsString::from("--out=");
    out.push(folder);
    command.arg("run").arg(&run.scene).arg(out);
    command.args(["--resume", "--quiet", "--accept-untrusted", "--data-only"]);
    for one in &run.overrides {
        command.arg("--set").arg(one);
    }
    // In a group of its own, so that Ctrl-C reaches only this process, which tells the others once.
    command.process_group(0);
    // One thread a run: runs side by side use the cores better than threads do.
    command.env("GOUGE_THREADS", "1");
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    command
}

/// Whether something in a folder changed lately. A run writes a checkpoint every few seconds.
fn is_active(folder: &Path) -> bool {
    let Ok(files) = std::fs::read_dir(folder) else {
        return false;
    };
    let age = |file: std::fs::DirEntry| file.metadata().ok()?.modified().ok()?.elapsed().ok();
    let mut ages = files.flatten().filter_map(age);
    ages.any(|age| age < SILENCE)
}

/// The state of a run whose process ended with a status and some words.
fn state_after(
    folder: &Path,
    code: Option<i32>,
    said: &str,
    is_stopped: bool,
) -> Result<State, Error> {
    let state = State::of(folder);
    if state.status.is_final() || code == Some(INTERRUPTED) || is_stopped {
        return Ok(state);
    }
    let said = said.trim();
    if said.contains("is in use by") {
        let cause = said.trim_start_matches("gouge: ").to_owned();
        return Ok(State { cause, ..state });
    }
    if code == Some(2) || state.status == Status::Waiting {
        let path = folder.join(CAUSE);
        let cause = said.trim_start_matches("gouge: ");
        let write = || std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, cause));
        write().map_err(|error| Error::file("write", &path, error))?;
        return Ok(State::of(folder));
    }
    Ok(State {
        cause: format!("the process ended with {code:?}: {said}"),
        ..state
    })
}

/// Wait for a process; its status and what it said. When the sweep is to stop, so is the process, with a checkpoint.
fn wait(mut child: Child, stop: &AtomicBool) -> std::io::Result<(Option<i32>, String)> {
    let stderr = child.stderr.take();
    let said = std::thread::spawn(move || {
        let mut said = String::new();
        let read = stderr.map(|mut stderr| stderr.read_to_string(&mut said));
        read.transpose().map(|_| said)
    });
    let mut is_told = false;
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if stop.load(Ordering::Relaxed) && !is_told {
            is_told = true;
            if let Some(process) = Pid::from_raw(child.id().cast_signed()) {
                // If it has ended already, there is nobody to tell.
                let _ = kill_process(process, Signal::TERM);
            }
        }
        std::thread::sleep(PATIENCE);
    };
    let said = said.join().unwrap_or_else(|_| Ok(String::new()))?;
    Ok((status.code(), said))
}

/// Remove the outputs of runs that failed or were refused, so that they are run again; their folders.
///
/// # Errors
/// Failures of the file system.
pub fn retry(runs: &[Planned], out: &Path) -> Result<Vec<PathBuf>, Error> {
    let mut all = Vec::new();
    for folder in runs.iter().map(|run| run.folder(out)) {
        if matches!(State::of(&folder).status, Status::Failed | Status::Refused) {
            std::fs::remove_dir_all(&folder)
                .map_err(|error| Error::file("remove", &folder, error))?;
            all.push(folder);
        }
    }
    Ok(all)
}
