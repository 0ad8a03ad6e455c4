//! A private PostgreSQL cluster in a temporary folder, on a separate loopback port, removed after the test.
//!
//! `initdb` runs once, into a template under `target/tmp`; a copy of it takes a third of the time. The server refuses
//! to run as root, in which case it runs as an unprivileged account that owns the folder. With `setpriv` the kernel
//! kills the server when the thread that started it ends, so that even a killed test leaves no server behind.

use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Maximum time for the server to start or to stop, on a loaded machine and after a crash.
const PATIENCE: Duration = crate::patience::PATIENCE;

/// A cluster with its server.
pub(crate) struct Cluster {
    installed: Installed,
    data: PathBuf,
    port: u16,
    server: Option<Child>,
    _folder: TempDir,
}

/// The folder of PostgreSQL's programs, and the account that runs them.
struct Installed {
    programs: PathBuf,
    account: Option<Account>,
    version: String,
}

/// An unprivileged account.
struct Account {
    name: &'static str,
    uid: u32,
    gid: u32,
}

impl Cluster {
    /// A new cluster with a running server, or the reason why it cannot be started.
    pub(crate) fn start() -> Result<Self, String> {
        Cluster::start_under(&std::env::temp_dir())
    }

    /// As [`Cluster::start`], in a folder under `parent`, for example on a small disk.
    pub(crate) fn start_under(parent: &Path) -> Result<Self, String> {
        let installed = Installed::find()?;
        let folder = tempfile::tempdir_in(parent).unwrap();
        installed.own(folder.path());
        let data = folder.path().join("cluster");
        copy(&installed.template(), &data);
        let mut cluster = Cluster { installed, data, port: 0, server: None, _folder: folder };
        // Another process may take the free port before the server does.
        for _ in 0..5 {
            cluster.port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
            if cluster.try_start() {
                return Ok(cluster);
            }
        }
        panic!("PostgreSQL does not start: {}", cluster.log());
    }

    pub(crate) fn port(&self) -> u16 {
        self.port
    }

    /// The URL of the cluster's only database.
    pub(crate) fn url(&self) -> String {
        Cluster::url_at(self.port)
    }

    /// The URL through another port.
    pub(crate) fn url_at(port: u16) -> String {
        format!("postgres://homolog@127.0.0.1:{port}/postgres")
    }

    /// Restarts the server on the same port and data.
    pub(crate) fn start_again(&mut self) {
        // After a kill, its orphaned processes hold the shared memory for a moment.
        let began = Instant::now();
        while !self.try_start() {
            assert!(began.elapsed() < PATIENCE, "PostgreSQL does not start: {}", self.log());
            std::thread::sleep(Duration::from_millis(200));
        }
    }

    /// Stops the server; transactions are rolled back.
    pub(crate) fn stop_fast(&mut self) {
        self.end(Signal::INT);
    }

    /// Stops the server as in a crash: the next start recovers from the log.
    pub(crate) fn stop_immediately(&mut self) {
        self.end(Signal::QUIT);
    }

    /// SIGKILL to the server's main process; the others notice and exit.
    pub(crate) fn kill(&mut self) {
        self.end(Signal::KILL);
    }

    /// SIGSTOP to all its processes: connections stay open, without answers.
    pub(crate) fn freeze(&self) {
        self.signal_all(Signal::STOP);
    }

    /// SIGCONT to all.
    pub(crate) fn thaw(&self) {
        self.signal_all(Signal::CONT);
    }

    /// Whether the server runs.
    pub(crate) fn is_running(&mut self) -> bool {
        self.server.as_mut().is_some_and(|server| server.try_wait().unwrap().is_none())
    }

    /// The end of the server's log.
    pub(crate) fn log(&self) -> String {
        let text = fs::read_to_string(self.log_path()).unwrap_or_default();
        let lines: Vec<_> = text.lines().collect();
        lines[lines.len().saturating_sub(20)..].join("\n")
    }

    fn log_path(&self) -> PathBuf {
        self.data.with_file_name("server.log")
    }

    fn try_start(&mut self) -> bool {
        let log = fs::File::options().create(true).append(true).open(self.log_path()).unwrap();
        let pid_file = self.data.join("postmaster.pid");
        let mut command = self.installed.command("postgres");
        command.arg("-D").arg(&self.data).arg("-p").arg(self.port.to_string());
        for setting in [
            "listen_addresses=127.0.0.1",
            "unix_socket_directories=",
            "fsync=on",
            "max_connections=200",
            "shared_buffers=32MB",
        ] {
            command.arg("-c").arg(setting);
        }
        command.stdin(Stdio::null()).stdout(log.try_clone().unwrap()).stderr(log);
        let mut server = command.spawn().unwrap();
        let began = Instant::now();
        loop {
            // The server writes its process id into the first line of this file and its status into the eighth.
            let status = fs::read_to_string(&pid_file).unwrap_or_default();
            let mut lines = status.lines();
            let is_its_own = lines.next() == Some(&server.id().to_string());
            if is_its_own && lines.nth(6).is_some_and(|line| line.trim() == "ready") {
                self.server = Some(server);
                return true;
            }
            if server.try_wait().unwrap().is_some() {
                return false;
            }
            assert!(began.elapsed() < PATIENCE, "PostgreSQL is not ready: {}", self.log());
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    fn end(&mut self, signal: Signal) {
        let Some(mut server) = self.server.take() else { return };
        let _ = kill_process(Pid::from_child(&server), signal);
        let began = Instant::now();
        while server.try_wait().unwrap().is_none() {
            assert!(began.elapsed() < PATIENCE, "PostgreSQL does not end: {}", self.log());
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    fn signal_all(&self, signal: Signal) {
        let server = self.server.as_ref().unwrap();
        let first = Pid::from_child(server);
        let mut all = vec![first];
        for entry in fs::read_dir("/proc").unwrap() {
            let Some(id) = entry.unwrap().file_name().to_str().and_then(|name| name.parse::<i32>().ok()) else {
                continue;
            };
            // The parent is the second field after the name, which is in parentheses and may contain any character.
            let stat = fs::read_to_string(format!("/proc/{id}/stat")).unwrap_or_default();
            let parent = stat.rsplit(')').next().and_then(|rest| rest.split_whitespace().nth(1));
            if parent == Some(&server.id().to_string()) {
                all.extend(Pid::from_raw(id));
            }
        }
        for process in all {
            let _ = kill_process(process, signal);
        }
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        if let Some(mut server) = self.server.take() {
            let _ = kill_process(Pid::from_child(&server), Signal::QUIT);
            let _ = kill_process(Pid::from_child(&server), Signal::CONT);
            let _ = server.wait();
        }
    }
}

impl Installed {
    fn find() -> Result<Self, String> {
        let mut folders: Vec<PathBuf> =
            std::env::var_os("PATH").map(|p| std::env::split_paths(&p).collect()).unwrap_or_default();
        folders.push("/usr/local/bin".into());
        let mut packaged: Vec<_> = fs::read_dir("/usr/lib/postgresql").into_iter().flatten().flatten().collect();
        packaged.sort_by_key(|version| std::cmp::Reverse(version.file_name()));
        folders.extend(packaged.iter().map(|version| version.path().join("bin")));
        let missing = "no PostgreSQL server (initdb) found; scripts/setup campaigns installs it";
        // The program may be a symbolic link; all programs are in the folder of its target.
        let initdb = folders.iter().find_map(|folder| folder.join("initdb").canonicalize().ok()).ok_or(missing)?;
        let programs = initdb.parent().filter(|p| p.join("postgres").exists()).ok_or(missing)?.to_owned();
        let account = if rustix::process::geteuid().is_root() {
            let accounts = fs::read_to_string("/etc/passwd").unwrap_or_default();
            Some(account_in(&accounts).ok_or("PostgreSQL refuses to run as root, and there is no account for it")?)
        } else {
            None
        };
        let version = Command::new(programs.join("postgres")).arg("--version").output().unwrap().stdout;
        let version = String::from_utf8(version).unwrap().replace(|c: char| !c.is_ascii_alphanumeric(), "-");
        Ok(Installed { programs, account, version })
    }

    /// A program of PostgreSQL, run by the account and killed with its parent.
    fn command(&self, program: &str) -> Command {
        let program = self.programs.join(program);
        let mut command = Command::new("setpriv");
        match &self.account {
            Some(account) => {
                command.args([
                    "--reuid",
                    &account.uid.to_string(),
                    "--regid",
                    &account.gid.to_string(),
                    "--clear-groups",
                ]);
            }
            None if Command::new("setpriv").arg("--version").output().is_err() => return Command::new(program),
            None => {}
        }
        command.args(["--pdeathsig", "KILL", "--"]).arg(program);
        command
    }

    fn own(&self, path: &Path) {
        if let Some(account) = &self.account {
            std::os::unix::fs::chown(path, Some(account.uid), Some(account.gid)).unwrap();
        }
    }

    /// The folder of an empty cluster, created on first use.
    fn template(&self) -> PathBuf {
        let owner = self.account.as_ref().map_or("self", |account| account.name);
        let template =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{owner}", self.version.trim_end_matches('-')));
        if template.exists() {
            return template;
        }
        let folder = tempfile::tempdir().unwrap();
        self.own(folder.path());
        let made = folder.path().join("template");
        let initdb = self
            .command("initdb")
            .arg("-D")
            .arg(&made)
            .args(["-U", "homolog", "-A", "trust", "-E", "UTF8", "--locale=C", "--no-sync"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(initdb.status.success(), "initdb: {}", String::from_utf8_lossy(&initdb.stderr));
        fs::create_dir_all(env!("CARGO_TARGET_TMPDIR")).unwrap();
        let draft = template.with_extension(std::process::id().to_string());
        copy(&made, &draft);
        // Another test may have created the template first; either can be used.
        if fs::rename(&draft, &template).is_err() {
            let _ = fs::remove_dir_all(&draft);
        }
        template
    }
}

/// Copies a folder and keeps its owner.
fn copy(from: &Path, to: &Path) {
    assert!(Command::new("cp").arg("-a").arg(from).arg(to).status().unwrap().success());
}

fn account_in(accounts: &str) -> Option<Account> {
    ["postgres", "nobody"].into_iter().find_map(|name| {
        let line = accounts.lines().find(|line| line.split(':').next() == Some(name))?;
        let mut numbers = line.split(':').skip(2).map_while(|field| field.parse().ok());
        Some(Account { name, uid: numbers.next()?, gid: numbers.next()? })
    })
}

#[test]
#[ignore = "needs PostgreSQL"]
fn a_cluster_restarts_on_its_port_however_it_ended() {
    let mut cluster = Cluster::start().unwrap();
    let port = cluster.port();
    for end in [Cluster::stop_fast, Cluster::stop_immediately, Cluster::kill] {
        assert!(cluster.is_running());
        assert!(std::net::TcpStream::connect(("127.0.0.1", port)).is_ok());
        end(&mut cluster);
        assert!(std::net::TcpStream::connect(("127.0.0.1", port)).is_err());
        cluster.start_again();
    }
    cluster.freeze();
    cluster.thaw();
}
