"""Executes the plan. Answers are kept, so an interrupted run continues."""

import functools
import hashlib
import json
import os
import pickle
import re
import subprocess
import sys
import threading
import time

import numpy as np

import geometry
import scores
from peer_answers import read_peers
from peers import PEERS
from plan import cores_of, our_parameters

HERE = os.path.dirname(os.path.abspath(__file__))


class Answers:
    """One JSON line for each answer in `results.jsonl`, its arrays in files of their own; a later line replaces an
    earlier one."""

    def __init__(self, folder):
        self.folder = folder
        os.makedirs(os.path.join(folder, "answers"), exist_ok=True)
        self.path = os.path.join(folder, "results.jsonl")
        self.records, self.lock = {}, threading.Lock()
        if os.path.exists(self.path):
            with open(self.path) as file:
                for line in file:
                    # The last line is incomplete if a run was killed while writing it.
                    if line.endswith("\n"):
                        record = json.loads(line)
                        self.records[record["key"]] = record

    def array_path(self, key):
        return os.path.join(self.folder, "answers", re.sub(r"[/\s]", "_", key) + ".npz")

    def add(self, record, arrays):
        if arrays:
            np.savez_compressed(self.array_path(record["key"]), **arrays)
        with self.lock, open(self.path, "a") as file:
            file.write(json.dumps(record) + "\n")
            self.records[record["key"]] = record

    def arrays(self, key):
        path = self.array_path(key)
        if not os.path.exists(path):
            return {}
        with np.load(path) as stored:
            return {name: stored[name] for name in stored.files}


class Worker:
    """The process of one peer on one core."""

    def __init__(self, name, core, log):
        command = [sys.executable, os.path.join(HERE, "peer_worker.py"), name, str(core)]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, text=True)
        self.first = self._answer()

    def _answer(self):
        line = self.process.stdout.readline()
        return json.loads(line) if line else {"status": "failed", "message": "the peer's process ended"}

    def ask(self, task):
        if self.first["status"] != "ready":
            return dict(self.first)
        try:
            self.process.stdin.write(json.dumps(task) + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        return self._answer()

    def close(self):
        try:
            self.process.stdin.close()
        except BrokenPipeError:
            pass
        self.process.wait()


class Runner:
    def __init__(self, cases, homolog, folder, limit_s, refresh):
        self.cases, self.homolog, self.limit_s = cases, homolog, limit_s
        self.answers = Answers(folder)
        self.folder, self.refresh = folder, set(refresh)
        self.done, self.total, self.begin, self.quiet = 0, 0, time.monotonic(), False

    def key(self, method, case):
        """Our answers are keyed by the program's bytes and the parameters, those of peers by their version and the code
        that calls them."""
        if method in PEERS:
            return f"{method}@{peer_fingerprint()}|{case}"
        parameters = json.dumps(our_parameters(method), sort_keys=True)
        return f"{method}@{self.homolog.fingerprint}-{short_hash(parameters.encode())}|{case}"

    def record(self, method, case):
        return self.answers.records.get(self.key(method, case))

    def arrays(self, method, case):
        return self.answers.arrays(self.key(method, case))

    def take(self, report, tasks):
        """Copies answers of peers from a report with the same peers, unless they are already here. Not copied: answers
        with reported times, which are comparable on one machine only, and answers whose maps in both directions are
        composed."""
        with open(os.path.join(report, "provenance.json")) as file:
            made_by = json.load(file).get("peers", "not named")
        if made_by != peer_fingerprint():
            raise ValueError(f"the peers of {report} are not these: {made_by}, now {peer_fingerprint()}")
        known = read_peers(os.path.join(report, "peers.csv"))
        for method, case, timed in tasks:
            is_missing = method in PEERS and self.record(method, case) is None
            if is_missing and not timed and not case.startswith("swapped_") and (method, case) in known:
                self.answers.add({"key": self.key(method, case), **known[method, case], "taken_from": os.path.basename(report)}, {})

    def run(self, tasks, quiet=False):
        """Ours first, alone on the machine; then timed peers, alone; then the others, two in parallel."""
        self.quiet = quiet
        missing = [t for t in tasks if t[0] in self.refresh or self.record(t[0], t[1]) is None]
        missing = list(dict.fromkeys(missing))
        self.total, self.begin = len(missing), time.monotonic()
        if not quiet:
            print(f"{len(tasks)} answers, {len(missing)} of them to be computed", flush=True)
        cores = sorted(os.sched_getaffinity(0))
        for method, case, _ in (t for t in missing if t[0] not in PEERS):
            self.one_of_ours(method, case, set(cores[: cores_of(method)]))
        self.peers([t for t in missing if t[0] in PEERS and t[2]], cores[:1])
        self.peers([t for t in missing if t[0] in PEERS and not t[2]], cores[:2])

    def one_of_ours(self, method, name, cores):
        case = self.cases.load(name)
        record, arrays = self.homolog.match(case, our_parameters(method), cores)
        self.keep(method, name, case, record, arrays)

    def peers(self, tasks, cores):
        by_peer = {}
        for method, name, _ in tasks:
            by_peer.setdefault(method, []).append(name)
        queue = list(by_peer.items())
        threads = [threading.Thread(target=self.peers_on_core, args=(queue, core)) for core in cores]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def peers_on_core(self, queue, core):
        while True:
            try:
                method, names = queue.pop(0)
            except IndexError:
                return
            with open(os.path.join(self.folder, f"{method}.log"), "a") as log:
                worker = Worker(method, core, log)
                for name in names:
                    self.one_of_a_peer(worker, method, name, core)
                worker.close()

    def one_of_a_peer(self, worker, method, name, core):
        case = self.cases.load(name)
        given = {key: case[key] for key in ("V1", "F1", "V2", "F2")}
        # Noise lengthens the edges of a surface, so they are no measure of its sampling.
        given["edge"] = min(geometry.mean_edge(case[f"V{k}"], case[f"F{k}"]) for k in (1, 2))
        at = lambda ending: os.path.join(self.folder, f"exchange-{core}.{ending}")
        with open(at("pkl"), "wb") as file:
            pickle.dump(given, file)
        record = worker.ask({"case": at("pkl"), "answer": at("npz"), "limit_s": self.limit_s})
        arrays = {}
        if record["status"] == "answered":
            with np.load(at("npz")) as stored:
                arrays = {key: stored[key] for key in stored.files}
            if not all(np.isfinite(values).all() for values in arrays.values()):
                record, arrays = {**record, "status": "failed", "message": "numbers that are not finite"}, {}
        self.keep(method, name, case, record, arrays)

    def keep(self, method, name, case, record, arrays):
        record = {"key": self.key(method, name), "method": method, "case": name, **record}
        record["of_case"] = scores.of_case(case)
        if arrays:
            record["scores"] = scores.of_answer(self.cases, case, arrays)
            record["bins"] = scores.reliability_bins(case, arrays)
        self.answers.add(record, arrays)
        self.done += 1
        if self.quiet:
            return
        spent = time.monotonic() - self.begin
        left = spent / self.done * (self.total - self.done)
        figures = " ".join(
            f"{key} {record['scores'][key]:.3g}"
            for key in ("rot_deg", "w1", "label", "landmark_pct")
            if key in record.get("scores", {})
        )
        took = f"{record['seconds']:.2f} s" if "seconds" in record else ""
        print(
            f"[{self.done}/{self.total}, about {left / 60:.0f} min left] {method:16} {name:18} "
            f"{record['status']} {took} {figures} {record.get('message', '')[-120:]}",
            flush=True,
        )


def short_hash(data):
    return hashlib.sha256(data).hexdigest()[:8]


@functools.cache
def peer_fingerprint():
    parts = []
    for name in ("peers.py", "bcpd.py", "peers.txt", "requirements.txt"):
        with open(os.path.join(HERE, name), "rb") as file:
            parts.append(file.read())
    return short_hash(b"".join(parts))
