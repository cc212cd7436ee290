//! The program `gouge`.

use gouge::studies::sweep::Program;
use mimalloc::MiMalloc;
use std::process::ExitCode;

/// Aligns the columns of large worlds to cache lines and puts them into huge pages.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

fn main() -> ExitCode {
    let status = gouge::command_line(&Program::of_this_process(), std::env::args_os());
    ExitCode::from(status)
}
