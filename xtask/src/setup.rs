//! What the machine must have before anything is drawn: a Vulkan driver, its loader, the SPIR-V validator.

use std::env;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::failure::Failure;
use crate::steps::Steps;

/// Debian packages of a Vulkan driver that draws on any CPU, the loader and the validator.
const PACKAGES: [&str; 3] = ["mesa-vulkan-drivers", "libvulkan1", "spirv-tools"];

/// Finds what is missing, and installs it where that can be done without asking.
pub(crate) fn run(steps: &mut Steps) -> Result<(), Failure> {
    // Other systems bring Metal or Direct3D; the runtime uses those.
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    let missing = steps.timed("setup", missing);
    if missing.is_empty() {
        return Ok(());
    }
    let machine = Machine {
        root: is_root(),
        interactive: io::stdin().is_terminal() && env::var_os("CI").is_none_or(|value| value.is_empty()),
        apt: find_program("apt-get").is_some(),
        sudo: find_program("sudo").is_some(),
    };
    let list = missing.join(", ");
    let stop = |why: &str| Failure::Setup(format!("missing: {list}; {why}"));
    let agreed = match machine.remedy() {
        Remedy::Install => true,
        Remedy::Ask => {
            println!("missing: {list}");
            ask(&format!("run `{}` now?", machine.command()))?
        }
        Remedy::Print => false,
        Remedy::Describe => {
            return Err(stop(
                "install a Vulkan driver (Mesa's lavapipe draws on any CPU), the Vulkan loader libvulkan.so.1 and \
                 spirv-val with your system's package manager",
            ));
        }
    };
    if !agreed {
        return Err(stop(&format!("install them with\n\n    {}\n", machine.command())));
    }

    println!("> installing {}", PACKAGES.join(" "));
    steps.timed("installing packages", || install(&machine))?;
    match self::missing().as_slice() {
        [] => Ok(()),
        left => Err(Failure::Setup(format!("still missing after the installation: {}", left.join(", ")))),
    }
}

/// What is known of the machine.
#[derive(Debug, Clone, Copy)]
struct Machine {
    root: bool,
    interactive: bool,
    apt: bool,
    sudo: bool,
}

/// What to do about something missing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Remedy {
    /// Install it.
    Install,
    /// Show the command and ask.
    Ask,
    /// Show the command and stop.
    Print,
    /// Say what is needed and stop.
    Describe,
}

impl Machine {
    fn remedy(&self) -> Remedy {
        match (self.apt, self.root, self.interactive) {
            (false, ..) => Remedy::Describe,
            (true, true, false) => Remedy::Install,
            (true, true, true) => Remedy::Ask,
            (true, false, true) if self.sudo => Remedy::Ask,
            (true, false, _) => Remedy::Print,
        }
    }

    /// The command that installs everything, as a user would type it.
    fn command(&self) -> String {
        let sudo = if self.root { "" } else { "sudo " };
        let packages = PACKAGES.join(" ");
        format!("{sudo}apt-get update && {sudo}apt-get install -y --no-install-recommends {packages}")
    }
}

fn install(machine: &Machine) -> Result<(), Failure> {
    let mut install = vec!["install", "-y", "-qq", "--no-install-recommends"];
    install.extend(PACKAGES);
    for arguments in [vec!["update", "-qq"], install] {
        let mut command = Command::new(if machine.root { "apt-get" } else { "sudo" });
        if !machine.root {
            command.arg("apt-get");
        }
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
        let status =
            command.status().map_err(|source| Failure::Start { program: "apt-get".into(), source })?;
        if !status.success() {
            return Err(Failure::Setup(format!(
                "the installation failed; mend it and run `{}`",
                machine.command()
            )));
        }
    }
    Ok(())
}

fn ask(question: &str) -> Result<bool, Failure> {
    print!("{question} [y/N] ");
    let mut answer = String::new();
    let read = io::stdout().flush().and_then(|()| io::stdin().read_line(&mut answer));
    read.map_err(|source| Failure::Start { program: "the question".into(), source })?;
    Ok(matches!(answer.trim(), "y" | "Y" | "yes"))
}

/// What cannot be found, in words.
fn missing() -> Vec<&'static str> {
    let mut missing = Vec::new();
    if !has_driver(&driver_places()) {
        missing.push("a Vulkan driver");
    }
    if !has_loader() {
        missing.push("the Vulkan loader libvulkan.so.1");
    }
    if find_program("spirv-val").is_none() {
        missing.push("spirv-val");
    }
    missing
}

/// Files and folders where the Vulkan loader looks for driver manifests.
fn driver_places() -> Vec<PathBuf> {
    // Variables that name the drivers take the place of the search.
    for variable in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"] {
        if let Some(value) = env::var_os(variable).filter(|value| !value.is_empty()) {
            return env::split_paths(&value).collect();
        }
    }
    let home = env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
    let from = |variable: &str, usual: &str| env::var_os(variable).unwrap_or_else(|| usual.into());
    let mut roots = vec![home.join(".config"), home.join(".local/share"), PathBuf::from("/etc")];
    roots.extend(env::split_paths(&from("XDG_CONFIG_DIRS", "/etc/xdg")));
    roots.extend(env::split_paths(&from("XDG_DATA_DIRS", "/usr/local/share:/usr/share")));
    roots.into_iter().map(|root| root.join("vulkan/icd.d")).collect()
}

/// Whether some place is a driver manifest or a folder that holds one.
fn has_driver(places: &[PathBuf]) -> bool {
    let is_manifest =
        |path: &Path| path.extension().is_some_and(|extension| extension == "json") && path.is_file();
    places.iter().any(|place| {
        let entries = fs::read_dir(place).into_iter().flatten().flatten();
        is_manifest(place) || entries.map(|entry| entry.path()).any(|path| is_manifest(&path))
    })
}

fn has_loader() -> bool {
    // Ask the linker's cache, then look where distributions put libraries.
    let cache = ["ldconfig", "/sbin/ldconfig", "/usr/sbin/ldconfig"]
        .into_iter()
        .find_map(|program| Command::new(program).arg("-p").stderr(Stdio::null()).output().ok());
    if cache.is_some_and(|cache| String::from_utf8_lossy(&cache.stdout).contains("libvulkan.so.1")) {
        return true;
    }
    let own = env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let usual = [
        "/usr/lib",
        "/usr/lib64",
        "/lib",
        "/usr/local/lib",
        "/usr/lib/x86_64-linux-gnu",
        "/usr/lib/aarch64-linux-gnu",
    ];
    let mut folders = env::split_paths(&own).chain(usual.map(PathBuf::from));
    folders.any(|folder| folder.join("libvulkan.so.1").exists())
}

fn find_program(name: &str) -> Option<PathBuf> {
    let folders = env::var_os("PATH")?;
    env::split_paths(&folders).map(|folder| folder.join(name)).find(|path| path.is_file())
}

fn is_root() -> bool {
    let id = Command::new("id").arg("-u").output();
    id.is_ok_and(|id| id.stdout.trim_ascii() == b"0")
}

#[cfg(test)]
mod tests {
    use super::{Machine, Remedy, has_driver};
    use std::path::PathBuf;

    const MACHINE: Machine = Machine { root: true, interactive: false, apt: true, sudo: false };

    #[test]
    fn only_root_without_a_terminal_installs_unasked() {
        assert_eq!(MACHINE.remedy(), Remedy::Install);
        assert_eq!(Machine { interactive: true, ..MACHINE }.remedy(), Remedy::Ask);
        assert_eq!(Machine { root: false, ..MACHINE }.remedy(), Remedy::Print);
        assert_eq!(Machine { root: false, sudo: true, ..MACHINE }.remedy(), Remedy::Print);
        assert_eq!(Machine { root: false, sudo: true, interactive: true, ..MACHINE }.remedy(), Remedy::Ask);
        assert_eq!(Machine { root: false, interactive: true, ..MACHINE }.remedy(), Remedy::Print);
        assert_eq!(Machine { apt: false, ..MACHINE }.remedy(), Remedy::Describe);
    }

    #[test]
    fn the_command_is_exact() {
        let packages = "mesa-vulkan-drivers libvulkan1 spirv-tools";
        let install = format!("apt-get install -y --no-install-recommends {packages}");
        assert_eq!(MACHINE.command(), format!("apt-get update && {install}"));
        assert_eq!(
            Machine { root: false, ..MACHINE }.command(),
            format!("sudo apt-get update && sudo {install}")
        );
    }

    #[test]
    fn folders_without_a_manifest_hold_no_driver() {
        let own = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        assert!(!has_driver(&[own.clone(), own.join("missing"), own.join("Cargo.toml")]));
    }
}
