//! Confinement of a child before it reads any bytes of clients: files, connections, programs, other processes.
//!
//! There are two barriers, each as strong as the kernel supports: Landlock, which controls files and connections, and a
//! filter of system calls, which also controls processes. The filter lists the refused calls, not the allowed ones: a
//! new version of the system's library may use other calls to compute, but it needs none of the refused ones. The child
//! keeps its memory, its threads, and the pipe to the parent.

use super::messages::Confinement;

/// Confines this process permanently, as far as the kernel can. Must be called while the process has one thread.
pub(super) fn enter() -> Confinement {
    #[cfg(target_os = "linux")]
    return Confinement { landlock: linux::refuse_files().unwrap_or(false), seccomp: linux::refuse_calls().is_some() };
    #[cfg(not(target_os = "linux"))]
    Confinement::default()
}

/// Tries what [`enter`] refuses. Returns the names of the actions that succeeded. Leaves nothing behind.
pub(super) fn attempt() -> Vec<String> {
    let mut possible = Vec::new();
    let mut note = |what: &str, done: bool| {
        if done {
            possible.push(what.to_owned());
        }
    };
    note("read a file", std::fs::File::open("/proc/self/status").is_ok());
    note("list a folder", std::fs::read_dir("/").is_ok());
    let path = std::env::temp_dir().join(format!("homolog-{}", std::process::id()));
    let written = std::fs::OpenOptions::new().write(true).create_new(true).open(&path).is_ok();
    note("write a file", written);
    if written {
        let _ = std::fs::remove_file(&path);
    }
    note("make a folder", std::fs::create_dir(&path).is_ok_and(|()| std::fs::remove_dir(&path).is_ok()));
    note("listen on a port", std::net::TcpListener::bind("127.0.0.1:0").is_ok());
    // Nobody listens on this port, but a socket that can be created gets the answer "refused".
    let connected = std::net::TcpStream::connect("127.0.0.1:9");
    let refused = |error: &std::io::Error| error.kind() == std::io::ErrorKind::ConnectionRefused;
    note("connect", connected.is_ok() || connected.is_err_and(|error| refused(&error)));
    note("send a datagram", std::net::UdpSocket::bind("127.0.0.1:0").is_ok());
    note("make a pair of sockets", std::os::unix::net::UnixStream::pair().is_ok());
    note("start a program", std::process::Command::new("/proc/self/exe").arg("--version").output().is_ok());
    #[cfg(target_os = "linux")]
    linux::attempt(&mut note);
    possible
}

#[cfg(target_os = "linux")]
mod linux {
    use landlock::{ABI, AccessFs, AccessNet, Ruleset, RulesetAttr as _, RulesetError, RulesetStatus, Scope};
    use landlock::{Access as _, RulesetCreatedAttr as _};
    use seccompiler::{
        BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter, SeccompRule,
        apply_filter,
    };
    use std::collections::BTreeMap;

    /// The requested version of Landlock; an older kernel restricts the part that it supports.
    const ASKED: ABI = ABI::V6;

    /// System calls that no computation makes.
    const REFUSED: &[libc::c_long] = &[
        // Files.
        libc::SYS_openat,
        libc::SYS_openat2,
        libc::SYS_open_by_handle_at,
        libc::SYS_name_to_handle_at,
        libc::SYS_mkdirat,
        libc::SYS_mknodat,
        libc::SYS_unlinkat,
        libc::SYS_renameat,
        libc::SYS_renameat2,
        libc::SYS_linkat,
        libc::SYS_symlinkat,
        libc::SYS_fchmodat,
        libc::SYS_fchownat,
        libc::SYS_utimensat,
        libc::SYS_truncate,
        libc::SYS_memfd_create,
        libc::SYS_inotify_init1,
        libc::SYS_fanotify_init,
        // File systems.
        libc::SYS_mount,
        libc::SYS_umount2,
        libc::SYS_move_mount,
        libc::SYS_open_tree,
        libc::SYS_fsopen,
        libc::SYS_fsconfig,
        libc::SYS_fsmount,
        libc::SYS_fspick,
        libc::SYS_pivot_root,
        libc::SYS_chroot,
        libc::SYS_unshare,
        libc::SYS_setns,
        // Connections; open ones stay open.
        libc::SYS_socket,
        libc::SYS_socketpair,
        libc::SYS_connect,
        libc::SYS_bind,
        libc::SYS_listen,
        libc::SYS_accept,
        libc::SYS_accept4,
        libc::SYS_sendmsg,
        libc::SYS_sendmmsg,
        // Programs and other processes.
        libc::SYS_execve,
        libc::SYS_execveat,
        libc::SYS_ptrace,
        libc::SYS_process_vm_readv,
        libc::SYS_process_vm_writev,
        libc::SYS_kill,
        libc::SYS_tkill,
        libc::SYS_rt_sigqueueinfo,
        libc::SYS_rt_tgsigqueueinfo,
        libc::SYS_pidfd_open,
        libc::SYS_pidfd_send_signal,
        libc::SYS_pidfd_getfd,
        libc::SYS_shmget,
        libc::SYS_shmat,
        libc::SYS_msgget,
        libc::SYS_semget,
        libc::SYS_mq_open,
        // The process's own limits.
        libc::SYS_setrlimit,
        // Powerful and rarely used interfaces of the kernel.
        libc::SYS_bpf,
        libc::SYS_perf_event_open,
        libc::SYS_userfaultfd,
        libc::SYS_io_uring_setup,
        libc::SYS_io_uring_enter,
        libc::SYS_io_uring_register,
        libc::SYS_keyctl,
        libc::SYS_add_key,
        libc::SYS_request_key,
        libc::SYS_init_module,
        libc::SYS_finit_module,
        libc::SYS_delete_module,
        libc::SYS_kexec_load,
        libc::SYS_reboot,
        libc::SYS_swapon,
        libc::SYS_swapoff,
        libc::SYS_syslog,
        libc::SYS_personality,
    ];

    /// Older names of these calls, which other processors do not have.
    #[cfg(target_arch = "x86_64")]
    const REFUSED_OLDER: &[libc::c_long] = &[
        libc::SYS_open,
        libc::SYS_creat,
        libc::SYS_mkdir,
        libc::SYS_mknod,
        libc::SYS_rmdir,
        libc::SYS_unlink,
        libc::SYS_rename,
        libc::SYS_link,
        libc::SYS_symlink,
        libc::SYS_chmod,
        libc::SYS_chown,
        libc::SYS_lchown,
        libc::SYS_utime,
        libc::SYS_utimes,
        libc::SYS_inotify_init,
        libc::SYS_fork,
        libc::SYS_vfork,
        libc::SYS_uselib,
        libc::SYS_ioperm,
        libc::SYS_iopl,
        libc::SYS_modify_ldt,
    ];
    #[cfg(not(target_arch = "x86_64"))]
    const REFUSED_OLDER: &[libc::c_long] = &[];

    /// Whether the kernel now refuses every file and, if it is recent, every connection.
    pub(super) fn refuse_files() -> Result<bool, RulesetError> {
        let rules = Ruleset::default()
            .handle_access(AccessFs::from_all(ASKED))?
            .handle_access(AccessNet::from_all(ASKED))?
            .scope(Scope::from_all(ASKED))?;
        // No rule allows anything.
        let status = rules.create()?.no_new_privs(true).restrict_self()?;
        Ok(status.ruleset != RulesetStatus::NotEnforced)
    }

    /// Refuses the calls; `None` if the kernel has no filters, or none for this processor.
    pub(super) fn refuse_calls() -> Option<()> {
        let mut rules: BTreeMap<i64, Vec<SeccompRule>> =
            REFUSED.iter().chain(REFUSED_OLDER).map(|&call| (call, Vec::new())).collect();
        let rule = |argument, operator, value| {
            let condition = SeccompCondition::new(argument, SeccompCmpArgLen::Qword, operator, value).ok()?;
            SeccompRule::new(vec![condition]).ok()
        };
        // Threads are allowed, processes are not.
        let thread = libc::CLONE_THREAD as u64;
        rules.insert(libc::SYS_clone, vec![rule(0, SeccompCmpOp::MaskedEq(thread), 0)?]);
        // Reading its own limits is allowed.
        rules.insert(libc::SYS_prlimit64, vec![rule(2, SeccompCmpOp::Ne, 0)?]);
        // Aborting itself is allowed.
        rules.insert(libc::SYS_tgkill, vec![rule(0, SeccompCmpOp::Ne, u64::from(std::process::id()))?]);
        apply(rules, libc::EPERM)?;
        // The arguments of `clone3` are in memory, where a filter cannot see them; the library then uses the older
        // `clone`.
        apply(BTreeMap::from([(libc::SYS_clone3, Vec::new())]), libc::ENOSYS)
    }

    fn apply(rules: BTreeMap<i64, Vec<SeccompRule>>, answer: libc::c_int) -> Option<()> {
        let refused = SeccompAction::Errno(u32::try_from(answer).ok()?);
        let arch = std::env::consts::ARCH.try_into().ok()?;
        let filter = SeccompFilter::new(rules, SeccompAction::Allow, refused, arch).ok()?;
        let program = BpfProgram::try_from(filter).ok()?;
        apply_filter(&program).ok()
    }

    pub(super) fn attempt(note: &mut impl FnMut(&str, bool)) {
        use rustix::process::{Pid, Resource, Signal, getrlimit, kill_process, setrlimit};
        note("raise its limits", setrlimit(Resource::Data, getrlimit(Resource::Data)).is_ok());
        // Processes ignore signal 28 (SIGWINCH) unless they ask for it.
        let parent = rustix::process::getppid().unwrap_or(Pid::INIT);
        note("send a signal", kill_process(parent, Signal::WINCH).is_ok());
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn no_call_is_named_twice() {
            let mut calls: Vec<_> = REFUSED.iter().chain(REFUSED_OLDER).collect();
            let n_calls = calls.len();
            calls.sort();
            calls.dedup();
            assert_eq!(calls.len(), n_calls);
        }
    }
}
