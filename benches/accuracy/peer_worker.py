"""Runs one peer on cases that arrive as lines of JSON on the standard input, one answer line each.

    {"case": PICKLE, "answer": NPZ, "limit_s": SECONDS}  ->  {"status": ..., "seconds": ..., "peak_bytes": ...}

Imports are done once and not counted. Each run is a forked child, so that a crash or the limit ends only that run, and
its peak memory is its own (including that of the imports, as in a program of the peer's).
"""

import json
import os
import pickle
import signal
import sys
import time
from importlib import import_module
from types import SimpleNamespace


def run(peer, task, report):
    with open(task["case"], "rb") as file:
        case = SimpleNamespace(**pickle.load(file))
    begin, cpu = time.monotonic(), time.process_time()
    answer = peer.run(case)
    seconds, cpu = time.monotonic() - begin, time.process_time() - cpu
    import_module("numpy").savez(task["answer"], **answer)
    os.write(report, json.dumps({"status": "answered", "seconds": seconds, "cpu_seconds": cpu}).encode())


def in_child(peer, task):
    read_end, write_end = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read_end)
        # Output of peers must not mix with the answers.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        try:
            run(peer, task, write_end)
        except Exception as error:
            os.write(write_end, json.dumps({"status": "failed", "message": repr(error)[:300]}).encode())
        os._exit(0)
    os.close(write_end)
    signal.signal(signal.SIGALRM, lambda *_: os.kill(child, signal.SIGKILL))
    signal.setitimer(signal.ITIMER_REAL, task["limit_s"])
    _, status, usage = os.wait4(child, 0)
    signal.setitimer(signal.ITIMER_REAL, 0)
    with os.fdopen(read_end, "rb") as pipe:
        said = pipe.read()
    if said:
        answer = json.loads(said)
    elif os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGKILL:
        answer = {"status": "out of time", "message": f"no answer within {task['limit_s']} s"}
    else:
        answer = {"status": "failed", "message": f"ended with status {status}"}
    return {**answer, "peak_bytes": usage.ru_maxrss * 1024}


def main():
    core = int(sys.argv[2])
    os.sched_setaffinity(0, {core})
    for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS", "TBB_NUM_THREADS"):
        os.environ[pool] = "1"
    import peers

    peer = peers.PEERS[sys.argv[1]]
    out = os.fdopen(os.dup(1), "w", buffering=1)
    try:
        for module in ("scipy.spatial", peer.module):
            if module:
                import_module(module)
    except Exception as error:
        print(json.dumps({"status": "missing", "message": repr(error)[:300]}), file=out)
        return
    print(json.dumps({"status": "ready"}), file=out)
    for line in sys.stdin:
        print(json.dumps(in_child(peer, json.loads(line))), file=out)


main()
