//! Scripts that run a sweep on a cluster. The cluster's own program schedules; a worker is one command on one chunk.

use super::cost::Cost;
use super::execute::Program;
use std::fmt::Write;
use std::path::Path;

/// Shortest time of a chunk in s: a scheduler takes seconds for each.
const SHORTEST: f64 = 600.0;

/// How a sweep is divided among workers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chunks {
    /// Number of chunks.
    pub number: usize,
    /// Time of a chunk in s, as estimated.
    pub seconds: f64,
}

impl Chunks {
    /// Chunks of at least ten minutes each, at most as many as an array of jobs may have.
    pub fn of(cost: Cost, runs: usize, most: usize) -> Self {
        let seconds = 3600.0 * cost.core_hours;
        let number = ((seconds / SHORTEST) as usize).min(runs).min(most).max(1);
        Self {
            number,
            seconds: seconds / number as f64,
        }
    }
}

/// What a script needs to know.
#[derive(Clone, Copy, Debug)]
pub struct Script<'a> {
    /// The program `gouge`.
    pub program: &'a Program,
    /// The sweep file.
    pub file: &'a Path,
    /// Folder of the sweep.
    pub out: &'a Path,
    /// The chunks.
    pub chunks: Chunks,
    /// Most workers at a time.
    pub workers: usize,
    /// Time limit of a worker in minutes.
    pub minutes: u64,
}

/// Seconds before the time limit at which a worker is told to stop.
const NOTICE: u64 = 60;

impl Script<'_> {
    fn command(&self, chunk: &str) -> String {
        let quoted = |path: &Path| shell_quoted(&path.display().to_string());
        let first = self.program.arguments.iter();
        let first = first.map(|argument| shell_quoted(&argument.to_string_lossy()) + " ");
        format!(
            "{} {}sweep work {} --out {} --chunk \"{chunk}\" --chunks {}",
            quoted(&self.program.file),
            first.collect::<String>(),
            quoted(self.file),
            quoted(self.out),
            self.chunks.number
        )
    }

    /// An array job for Slurm. Before its time limit a worker leaves checkpoints and is queued again.
    pub fn slurm(&self) -> String {
        let mut text = String::from("#!/bin/bash\n");
        let options = [
            "--job-name=gouge-sweep".to_owned(),
            format!("--array=0-{}%{}", self.chunks.number - 1, self.workers),
            "--ntasks=1".to_owned(),
            "--cpus-per-task=1".to_owned(),
            format!("--time={}", self.minutes),
            format!("--signal=B:TERM@{NOTICE}"),
            "--requeue".to_owned(),
            "--open-mode=append".to_owned(),
            format!("--output={}/slurm-%A_%a.log", self.out.display()),
        ];
        for option in options {
            let _ = writeln!(text, "#SBATCH {option}");
        }
        let _ = write!(
            text,
            "{} &\nworker=$!\ntrap 'kill -TERM $worker' TERM\n\
             wait $worker\nstatus=$?\n\
             # A trapped signal ends the first wait; the worker still writes its checkpoints.\n\
             while kill -0 $worker 2> /dev/null; do wait $worker; status=$?; done\n\
             if [ $status -eq 130 ]; then\n    \
             scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_${{SLURM_ARRAY_TASK_ID}}\"\nfi\n\
             exit $status\n",
            self.command("$SLURM_ARRAY_TASK_ID")
        );
        text
    }

    /// A script that submits an array of tasks to HyperQueue. A task whose worker is lost is started again.
    pub fn hyperqueue(&self) -> String {
        format!(
            "#!/bin/bash\n\
             exec hq submit --name=gouge-sweep --array=0-{} --cpus=1 --crash-limit=100 \\\n    \
             --time-limit={}min -- bash -c {}\n",
            self.chunks.number - 1,
            self.minutes,
            shell_quoted(&format!("exec {}", self.command("$HQ_TASK_ID")))
        )
    }
}

fn shell_quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', r"'\''"))
}
