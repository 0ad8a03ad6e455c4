"""Runs one command and writes its wall time, processor time and peak memory as JSON.

    python -I -S measured.py LIMIT_S REPORT STDOUT STDERR COMMAND...

A separate program because a process inherits the peak memory of its parent: this one is small. Standard library only.
"""

import json
import os
import signal
import sys
import time


def main():
    limit, report, out, err = sys.argv[1:5]
    command = sys.argv[5:]
    flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC
    redirect = [(os.POSIX_SPAWN_OPEN, 1, out, flags, 0o644), (os.POSIX_SPAWN_OPEN, 2, err, flags, 0o644)]
    begin = time.monotonic()
    child = os.posix_spawn(command[0], command, os.environ, file_actions=redirect)
    signal.signal(signal.SIGALRM, lambda *_: os.kill(child, signal.SIGKILL))
    signal.setitimer(signal.ITIMER_REAL, float(limit))
    _, status, usage = os.wait4(child, 0)
    wall = time.monotonic() - begin
    signal.setitimer(signal.ITIMER_REAL, 0)
    answer = {
        "seconds": wall,
        "cpu_seconds": usage.ru_utime + usage.ru_stime,
        # Linux counts in KiB.
        "peak_bytes": usage.ru_maxrss * 1024,
        "exit_code": os.waitstatus_to_exitcode(status),
        "out_of_time": wall >= float(limit),
    }
    with open(report, "w") as file:
        json.dump(answer, file)


main()
