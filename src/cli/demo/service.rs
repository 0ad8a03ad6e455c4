//! The service as a child process of the demo: started on a free port, stopped when the demo ends.

use super::client::ServiceClient;
use crate::cli::error::CliError;
use crate::cli::interrupt::Interrupt;
use std::fs;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// How long the service may take to be ready, and to stop.
const READY_WITHIN: Duration = Duration::from_secs(60);
const STOP_WITHIN: Duration = Duration::from_secs(15);

/// A running service; it is stopped when dropped.
pub(super) struct ServiceProcess {
    child: Child,
    address: SocketAddr,
    log: PathBuf,
}

impl ServiceProcess {
    /// Starts this program as `serve` with its data in `data_dir` and its messages in `log`, and waits until it is ready.
    pub(super) fn start(data_dir: &Path, log: &Path, interrupt: &Interrupt) -> Result<Self, CliError> {
        let failed = |what: &str, e: std::io::Error| CliError::Failed(format!("{what}: {e}"));
        let program = std::env::current_exe().map_err(|e| failed("cannot find this program on disk", e))?;
        let messages = fs::File::create(log).map_err(|e| CliError::write(log, e))?;
        let address = free_address().map_err(|e| failed("no free port on 127.0.0.1", e))?;
        let mut command = Command::new(&program);
        command
            .arg("serve")
            .arg("--listen")
            .arg(address.to_string())
            .arg("--data-dir")
            .arg(data_dir)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(messages);
        // A Ctrl-C at the terminal reaches the whole group; the demo stops the service itself, after its last request.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let child = command.spawn().map_err(|e| failed("cannot start the service", e))?;
        let mut service = ServiceProcess { child, address, log: log.to_owned() };
        service.wait_until_ready(interrupt)?;
        Ok(service)
    }

    pub(super) fn url(&self) -> String {
        format!("http://{}", self.address)
    }

    /// Asks the service to stop and waits until it has.
    pub(super) fn stop(mut self) {
        self.end();
    }

    /// Fails if the service has exited.
    pub(super) fn check_running(&mut self) -> Result<(), CliError> {
        match self.child.try_wait() {
            Ok(None) => Ok(()),
            Ok(Some(status)) => {
                Err(CliError::Failed(format!("the service exited unexpectedly ({status})\n{}", self.last_messages())))
            }
            Err(e) => Err(CliError::Failed(format!("cannot get the status of the service: {e}"))),
        }
    }

    fn wait_until_ready(&mut self, interrupt: &Interrupt) -> Result<(), CliError> {
        let client = ServiceClient::new(&self.url(), Duration::from_secs(2));
        let began = Instant::now();
        while began.elapsed() < READY_WITHIN {
            self.check_running()?;
            if interrupt.is_set() {
                return Err(CliError::Interrupted);
            }
            if client.get("/readyz").is_ok_and(|answer| answer.status == 200) {
                return Ok(());
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        Err(CliError::Failed(format!("the service was not ready after {READY_WITHIN:?}\n{}", self.last_messages())))
    }

    fn last_messages(&self) -> String {
        let text = fs::read_to_string(&self.log).unwrap_or_default();
        let lines: Vec<_> = text.lines().collect();
        let last = lines[lines.len().saturating_sub(10)..].join("\n");
        format!("last lines of its log ({}):\n{last}", self.log.display())
    }

    fn end(&mut self) {
        if self.child.try_wait().ok().flatten().is_some() {
            return;
        }
        if self.ask_to_stop() {
            let began = Instant::now();
            while began.elapsed() < STOP_WITHIN {
                if self.child.try_wait().ok().flatten().is_some() {
                    return;
                }
                std::thread::sleep(Duration::from_millis(20));
            }
        }
        // Killing it loses nothing: leases and fsync cover crashes.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    #[cfg(unix)]
    fn ask_to_stop(&self) -> bool {
        i32::try_from(self.child.id())
            .ok()
            .and_then(rustix::process::Pid::from_raw)
            .is_some_and(|pid| rustix::process::kill_process(pid, rustix::process::Signal::TERM).is_ok())
    }

    #[cfg(not(unix))]
    fn ask_to_stop(&self) -> bool {
        false
    }
}

impl Drop for ServiceProcess {
    fn drop(&mut self) {
        self.end();
    }
}

/// An address that was free a moment ago. If another program takes it first, the service reports that.
fn free_address() -> std::io::Result<SocketAddr> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?.local_addr()
}
