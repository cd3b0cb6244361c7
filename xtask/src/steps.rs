//! Steps: programs that are run, shown and timed.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::failure::Failure;

/// The steps of one command.
pub(crate) struct Steps {
    root: PathBuf,
    taken: Vec<(String, Duration)>,
}

impl Steps {
    /// No steps yet, in the workspace that cargo runs this program for.
    pub(crate) fn new() -> Result<Self, Failure> {
        let manifest = env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
        let root = manifest.as_deref().and_then(Path::parent).map(Path::to_owned);
        match root.or_else(|| env::current_dir().ok()) {
            Some(root) => Ok(Self { root, taken: Vec::new() }),
            None => Err(Failure::Setup("run this as `cargo xtask` in the repository".into())),
        }
    }

    /// The repository.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// Cargo, in the repository.
    pub(crate) fn cargo(&self) -> Command {
        let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.current_dir(&self.root);
        cargo
    }

    /// Builds a program of the workspace, with cargo's own messages shown.
    pub(crate) fn build(&mut self, name: &str) -> Result<(), Failure> {
        let mut build = self.build_command(name);
        self.run(&format!("building {name}"), &mut build)
    }

    /// A program of the workspace, up to date and ready for arguments.
    pub(crate) fn tool(&mut self, name: &str) -> Result<Command, Failure> {
        let mut build = self.build_command(name);
        self.quiet(&format!("building {name}"), &mut build)?;

        // Cargo puts it beside this program.
        let own = env::current_exe().map_err(|source| Failure::Start { program: name.into(), source })?;
        let mut tool = Command::new(own.with_file_name(format!("{name}{}", env::consts::EXE_SUFFIX)));
        tool.current_dir(&self.root);
        Ok(tool)
    }

    /// Selects the whole workspace so that cargo resolves the same features as for the tests: otherwise the large
    /// dependencies would be built a second time.
    fn build_command(&self, name: &str) -> Command {
        let mut build = self.cargo();
        build.args(["build", "--workspace", "--bin", name]);
        build
    }

    /// Runs a program with its output shown.
    pub(crate) fn run(&mut self, title: &str, command: &mut Command) -> Result<(), Failure> {
        println!("> {title}");
        let status = self.timed(title, || command.status()).map_err(|source| start(command, source))?;
        if status.success() { Ok(()) } else { Err(Failure::Step { title: title.into() }) }
    }

    /// Runs two programs at a time: the first with its output shown, then what the second wrote.
    pub(crate) fn run_beside(
        &mut self,
        title: &str,
        [(first_name, first), (second_name, second)]: [(&str, &mut Command); 2],
    ) -> Result<(), Failure> {
        println!("> {title}: {first_name}, and {second_name} beside it");
        second.stdin(Stdio::null());
        let (shown, beside) = self.timed(title, || {
            thread::scope(|scope| {
                let beside = scope.spawn(|| second.output());
                (first.status(), beside.join())
            })
        });
        let beside = beside.map_err(|_| Failure::Step { title: format!("{title} {second_name}") })?;
        let beside = beside.map_err(|source| start(second, source))?;
        println!("> {title}: {second_name}");
        print!("{}", String::from_utf8_lossy(&beside.stdout));
        eprint!("{}", String::from_utf8_lossy(&beside.stderr));
        let shown = shown.map_err(|source| start(first, source))?;
        for (name, passed) in [(first_name, shown.success()), (second_name, beside.status.success())] {
            if !passed {
                return Err(Failure::Step { title: format!("{title} {name}") });
            }
        }
        Ok(())
    }

    /// Runs a program with its output shown only if it fails, and returns what it wrote.
    pub(crate) fn quiet(&mut self, title: &str, command: &mut Command) -> Result<Output, Failure> {
        command.stdin(Stdio::null());
        let output = self.timed(title, || command.output()).map_err(|source| start(command, source))?;
        if output.status.success() {
            return Ok(output);
        }
        print!("{}", String::from_utf8_lossy(&output.stdout));
        eprint!("{}", String::from_utf8_lossy(&output.stderr));
        Err(Failure::Step { title: title.into() })
    }

    /// Times a part of the command; parts of one title add up.
    pub(crate) fn timed<T>(&mut self, title: &str, part: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = part();
        let elapsed = start.elapsed();
        match self.taken.iter_mut().find(|(earlier, _)| earlier == title) {
            Some((_, sum)) => *sum += elapsed,
            None => self.taken.push((title.into(), elapsed)),
        }
        result
    }

    /// Prints in one line how long each step took.
    pub(crate) fn summary(&self) {
        let shown = self.taken.iter().map(|(title, time)| format!("{title} {:.1} s", time.as_secs_f64()));
        println!("> {}", shown.collect::<Vec<_>>().join(", "));
    }
}

fn start(command: &Command, source: std::io::Error) -> Failure {
    Failure::Start { program: command.get_program().to_string_lossy().into_owned(), source }
}
