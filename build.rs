//! Tells the program which commit it was built from: `HOMOLOG_COMMIT` of the environment if set (container builds),
//! else that of the checkout, else `unknown`. Works without git. Lists the files of the dashboard, which are built into it.

use std::path::Path;
use std::process::Command;
use std::{env, fs, io};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    // Set by cargo-fuzz.
    println!("cargo:rustc-check-cfg=cfg(fuzzing)");
    println!("cargo:rerun-if-env-changed=HOMOLOG_COMMIT");
    let stated = env::var("HOMOLOG_COMMIT").ok().map(|c| c.trim().to_owned()).filter(|c| !c.is_empty());
    let commit = stated.or_else(checkout).unwrap_or_else(|| "unknown".to_owned());
    println!("cargo:rustc-env=HOMOLOG_COMMIT={commit}");
    if let Err(error) = list_page_files() {
        println!("cargo:warning=the dashboard in dashboard/dist cannot be built in: {error}");
    }
}

/// Writes the table of the files in dashboard/dist, with their content, as Rust.
fn list_page_files() -> io::Result<()> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("dashboard/dist");
    println!("cargo:rerun-if-changed={}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(&folder)? {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    let mut table = "static FILES: &[PageFile] = &[\n".to_owned();
    for name in names {
        let path = folder.join(&name);
        table += &format!("PageFile {{ name: {name:?}, bytes: include_bytes!({path:?}) }},\n");
    }
    fs::write(Path::new(&env::var("OUT_DIR").unwrap_or_default()).join("page_files.rs"), table + "];\n")
}

/// Commit of the checkout that this package is the root of; one around it is none of ours.
fn checkout() -> Option<String> {
    let root = env::var("CARGO_MANIFEST_DIR").ok()?;
    let root = Path::new(&root);
    if !root.join(".git").exists() {
        return None;
    }
    let git = |arguments: &[&str]| -> Option<String> {
        let output = Command::new("git").arg("-C").arg(root).args(arguments).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    // The log of HEAD grows with every commit and checkout. A path that does not exist would rebuild every time.
    for name in ["HEAD", "logs/HEAD", "packed-refs"] {
        if let Some(path) = git(&["rev-parse", "--git-path", name]).map(|p| root.join(p)).filter(|p| p.exists()) {
            println!("cargo:rerun-if-changed={}", path.display());
        }
    }
    git(&["rev-parse", "--short=12", "HEAD"]).filter(|c| !c.is_empty())
}
