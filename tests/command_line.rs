//! The command line itself: help, completions, manual pages, version.

use std::process::{Command, Output};

const GOUGE: &str = env!("CARGO_BIN_EXE_gouge");

fn gouge(arguments: &[&str]) -> Output {
    let output = Command::new(GOUGE).args(arguments).output();
    output.expect("the program starts")
}

fn said(arguments: &[&str]) -> String {
    let output = gouge(arguments);
    assert!(output.status.success(), "{arguments:?}");
    String::from_utf8(output.stdout).expect("text")
}

/// Names of all commands, from the help of the program.
fn commands() -> Vec<String> {
    let help = said(&["--help"]);
    let lines = help
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty());
    let first = |line: &str| line.split_whitespace().next().map(str::to_owned);
    lines
        .filter_map(first)
        .filter(|name| name != "help")
        .collect()
}

#[test]
fn every_command_shows_examples_that_it_accepts() {
    let commands = commands();
    assert_eq!(commands.len(), 12, "{commands:?}");
    let mut examples = 0;
    for command in commands.iter().map(Some).chain([None]) {
        let help = match command {
            Some(name) => said(&[name, "--help"]),
            None => said(&["--help"]),
        };
        for line in help
            .lines()
            .filter_map(|line| line.strip_prefix("  gouge "))
        {
            // The remark of an example begins after two spaces; what follows a pipe is the shell's.
            let line = line.split("   ").next().expect("a part");
            for part in format!("gouge {line}").split('|') {
                let part = part.split('>').next().expect("a part").trim();
                let Some(arguments) = part.strip_prefix("gouge ") else {
                    continue;
                };
                let arguments: Vec<String> = arguments
                    .split(' ')
                    .map(|word| word.trim_matches('\'').to_owned())
                    .collect();
                let mut arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
                arguments.push("--help");
                assert!(gouge(&arguments).status.success(), "{arguments:?}");
                examples += 1;
            }
        }
    }
    assert!(examples > 25, "{examples}");
}

#[test]
fn manual_pages_name_every_command_and_every_option() {
    let commands = commands();
    let page = said(&["man"]).replace(r"\-", "-");
    assert!(page.contains(".TH gouge 1"), "{page}");
    for command in &commands {
        assert!(page.contains(&format!("gouge-{command}(1)")), "{command}");
        let own = said(&["man", command]).replace(r"\-", "-");
        let help = said(&[command, "--help"]);
        let options = help
            .split_whitespace()
            .filter(|word| word.starts_with("--"));
        for option in options.map(|word| word.trim_matches(|c: char| !c.is_alphabetic())) {
            let is_of_an_example = ["format", "output"].contains(&option);
            assert!(
                own.contains(option) || is_of_an_example,
                "{command} {option}"
            );
        }
    }
    let refused = gouge(&["man", "nonsense"]);
    assert_eq!(refused.status.code(), Some(2));
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(message.contains("must be one of: run, links"), "{message}");
}

#[test]
fn completions_know_every_command_in_every_shell() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let text = said(&["completions", shell]);
        for command in commands() {
            assert!(text.contains(&command), "{shell} {command}");
        }
    }
}

#[test]
fn the_version_tells_the_commit_and_the_instructions() {
    let text = said(&["--version"]);
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("gouge 0.1.0 (commit "), "{text}");
    assert!(lines[1].starts_with("compiled for: portable"), "{text}");
    let list = |line: &str| -> Vec<String> {
        let names = line.split_once(": ").expect("a list").1;
        names.split(", ").map(str::to_owned).collect()
    };
    let (compiled, own) = (list(lines[1]), list(lines[2]));
    assert!(own.iter().all(|name| compiled.contains(name)), "{text}");
}
