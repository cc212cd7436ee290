//! Examples at the end of the help of each command.

pub const ALL: &str = "\
Examples:
  gouge scenes                                          what there is to run
  gouge run granite-fault-small --out out/small         run a built-in scene
  gouge scenes head-on > mine.toml                      a scene of your own to start from
  gouge run mine.toml --out out/mine --set time.step=1e-8
  gouge verify --only collision                         is it right?

Exit status: 0 success; 1 a run or a check failed, or a comparison differs; 2 invalid input; 3 the run finished, but its
energy balance shows that the results cannot be trusted; 130 interrupted.";

pub const RUN: &str = "\
Examples:
  gouge run granite-fault-small --out out/small
  gouge run granite-fault-small --out out/pressed --set driving.pressure=28e6
  gouge run granite-fault-small --out out/frictionless --set 'contact.tangential={}'
  gouge run granite-fault --out out/fault --resume      continue after Ctrl-C or a kill
  gouge scenes head-on | gouge run - --out out/piped";

pub const LINKS: &str = "\
Examples:
  gouge links head-on
  gouge links granite-fault-small > links.csv";

pub const STABILITY: &str = "\
Examples:
  gouge stability granite-fault-small
  gouge stability head-on --set contact.normal.stiffness=1e9";

pub const COMPARE: &str = "\
Examples:
  gouge compare mine.toml dump.lammpstrj
  gouge compare mine.toml particles.csv --tolerance 1e-9 --tolerance vx=1e-6";

pub const SWEEP: &str = "\
Examples:
  gouge sweep laws.toml --out out/laws --plan           what it would cost
  gouge sweep laws.toml --out out/laws --jobs 2
  gouge sweep status laws.toml --out out/laws
  gouge sweep export slurm laws.toml --out out/laws > slurm.sh";

pub const STUDY: &str = "\
Examples:
  gouge study thesis --out out/thesis --plan            what it would cost
  gouge study thesis --out out/thesis";

pub const CALIBRATE: &str = "\
Examples:
  gouge calibrate --list
  gouge calibrate rebound --out out/rebound
  gouge calibrate rebound --print > mine.toml           a calibration of your own to start from
  gouge calibrate rebound --recover --out out/recover   are its intervals right?";

pub const REPLAY: &str = "\
Examples:
  gouge replay cases --out results.json
  gouge replay cases --out results.json --quiet         list only cases without a result

A case that cannot be solved is listed, and the results of the others are written; the exit status is then 1.";

pub const VERIFY: &str = "\
Examples:
  gouge verify
  gouge verify --only collision --out out/collisions";

pub const SCENES: &str = "\
Examples:
  gouge scenes
  gouge scenes granite-fault > fault.toml
  gouge scenes lammps                                   stored runs of another program";

pub const COMPLETIONS: &str = "\
Examples:
  gouge completions bash > ~/.local/share/bash-completion/completions/gouge
  gouge completions zsh > ~/.zfunc/_gouge
  gouge completions fish > ~/.config/fish/completions/gouge.fish";

pub const MAN: &str = "\
Examples:
  gouge man > ~/.local/share/man/man1/gouge.1
  gouge man run | man -l -";
