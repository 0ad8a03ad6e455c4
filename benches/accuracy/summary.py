"""From answers to figures: results of each method on each set, and their provenance."""

import datetime
import os
import platform
import subprocess
import sys

import numpy as np

import scores
import verdicts
from cases import UNLIKE
from peers import PEERS
from plan import DEFAULT, OURS
from runner import peer_fingerprint

HIGHER = {"w1", "w2", "label", "point_w1", "within_5_pct", "within_10_deg", "cover"}
FIGURES = [
    "w1",
    "w2",
    "err_mm",
    "point_w1",
    "point_err_mm",
    "point_err_edges",
    "err_diag_pct",
    "err_area_pct",
    "within_5_pct",
    "beyond_2_spreads",
    "landmark_pct",
    "landmark_worst_mm",
    "mean_confidence",
    "label",
    "cover",
    "stretch",
    "rot_deg",
    "surf_mm",
    "seconds",
    "cpu_seconds",
    "own_seconds",
    "peak_bytes",
]
CORRECT_DEG = 10


def value(record, figure):
    if record["status"] != "answered":
        return None
    return record["scores"].get(figure, record.get(figure)) if figure != "within_10_deg" else None


def is_close(record):
    return record["status"] == "answered" and record["scores"].get("rot_deg", 180) <= CORRECT_DEG


def summarize(records):
    """Every figure of the records of one method on one set. A pair without an answer is left out of the figures of
    answers, and counts as a failure in the share within 10 degrees."""
    found = {}
    for figure in FIGURES:
        values = [v for v in (value(r, figure) for r in records) if v is not None]
        found[figure] = scores.spread(values, figure in HIGHER)
    has_pose = not any(r.get("of_case") or verdicts.kind_of(r) in verdicts.EXPECTED for r in records)
    if any("rot_deg" in r.get("scores", {}) for r in records if r["status"] == "answered") or (
        has_pose and not any(r["status"] == "answered" for r in records)
    ):
        found["within_10_deg"] = scores.spread([is_close(r) for r in records], True)
    statuses = [r["status"] for r in records]
    found["status"] = {status: statuses.count(status) for status in sorted(set(statuses))}
    messages = sorted({r["message"] for r in records if r.get("message")})
    found["message"] = messages[0] if messages else None
    return found


def collect(run, tasks, n, with_peers):
    by_set = {}
    for method, name, _ in tasks:
        record = run.record(method, name)
        if record:
            by_set.setdefault((method, name.split("/")[0]), []).append(record)
    summaries = {key: summarize(records) for key, records in by_set.items()}
    return {
        "provenance": provenance(run, n),
        "n": n,
        "with_peers": with_peers,
        "summaries": summaries,
        "calibration": {m: calibration(by_set, m) for m in OURS if calibration(by_set, m)},
        "sets": {kind: of_set(records) for (m, kind), records in by_set.items() if m == DEFAULT},
        "there_and_back": there_and_back(run, by_set),
        "unlike": unlike(by_set),
        "records": [record for records in by_set.values() for record in records],
    }


def of_set(records):
    """Confidence and verdicts of the default method on one set."""
    rows = [r["bins"] for r in records if r.get("bins")]
    pooled = None
    if rows:
        bins = np.sum(rows, axis=0)
        n = bins[0].sum()
        pooled = {"error": scores.calibration_error(bins), "interval": scores.calibration_interval(rows), "n_pairs": len(rows)}
        pooled |= {"confidence": float(bins[1].sum() / n), "hits": float(bins[2].sum() / n)}
    return {"n": len(records), "calibration": pooled, "verdicts": counted_verdicts(records)}


def counted_verdicts(records):
    """Numbers of right and wrong answers that are reliable; None if right and wrong cannot be told apart."""
    answered = [r for r in records if r["status"] == "answered"]
    judged = [(verdicts.is_right(r), verdicts.is_reliable(r)) for r in answered]
    if any(right is None or reliable is None for right, reliable in judged):
        return None
    expected = verdicts.kind_of(records[0]) in verdicts.EXPECTED
    if not judged and not expected:
        return None
    count = lambda *verdict: judged.count(verdict)
    return {
        "right_reliable": count(True, True),
        "right_unreliable": count(True, False),
        "wrong_reliable": count(False, True),
        "wrong_unreliable": count(False, False),
        "no_answer": len(records) - len(answered),
        "expected_reason": sum(map(verdicts.gives_expected_reason, answered)) if expected else None,
    }


def calibration(by_set, method):
    rows = [
        record["bins"]
        for kind in ("real_warp4", "real_warp8", "real_resample")
        for record in by_set.get((method, kind), [])
        if record.get("bins")
    ]
    if not rows:
        return None
    bins = np.sum(rows, axis=0)
    return {"bins": bins.tolist(), "error": scores.calibration_error(bins), "n_pairs": len(rows)}


def there_and_back(run, by_set):
    found = {}
    for (method, kind), records in by_set.items():
        if not kind.startswith("swapped_"):
            continue
        shares, medians = [], []
        for record in records:
            name = record["case"].removeprefix("swapped_")
            forth, back = run.arrays(method, name).get("map"), run.arrays(method, record["case"]).get("map")
            if forth is None or back is None:
                continue
            off = scores.there_and_back(run.cases.load(name), forth, back)
            shares.append(float((off <= 1).mean()))
            medians.append(float(np.median(off)))
        if shares:
            key = (method, kind.removeprefix("swapped_"))
            found[key] = {"within_one_edge": scores.spread(shares, True), "median_edges": scores.spread(medians, False)}
    return found


def unlike(by_set):
    """The numbers of the result about its own answer, for pairs that match and pairs that do not."""
    found = {}
    for kind in ["real_resample", "real_cross", *UNLIKE]:
        records = [r for r in by_set.get((DEFAULT, kind), []) if r["status"] == "answered"]
        if records:
            said = {}
            for name in ("mean_confidence", "outlier_share", "inlier_ratio", "surface_mean_mm"):
                values = [r[name] for r in records if r.get(name) is not None]
                said[name] = float(np.median(values)) if values else None
            said["reliability"] = [r.get("reliability") for r in records]
            said["n"] = len(records)
            found[kind] = said
    return found


def command_output(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def processor():
    try:
        with open("/proc/cpuinfo") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown"


def provenance(run, n):
    here = os.path.dirname(os.path.abspath(__file__))
    from importlib.metadata import PackageNotFoundError, version

    versions = {}
    for package in ("numpy", "scipy", "scikit-image", *{p.package for p in PEERS.values() if p.package}):
        try:
            versions[package] = version(package)
        except PackageNotFoundError:
            versions[package] = None
    return {
        "date": datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d"),
        "program": run.homolog.version,
        "program_sha256": run.homolog.fingerprint,
        "commit_of_the_benchmark": command_output("git", "-C", here, "rev-parse", "--short", "HEAD"),
        "command": f"make accuracy CASES={n}" + (" OURS_ONLY=1" if "--ours-only" in sys.argv else "")
        + (", without the ablation" if "--no-ablation" in sys.argv else ""),
        "machine": f"{processor()}, {len(os.sched_getaffinity(0))} cores, {memory_gib():.0f} GiB, {platform.system()}",
        "python": platform.python_version(),
        "packages": versions,
        "peers": peer_fingerprint(),
        "n_label_volumes": len(run.cases.files),
        "cases_a_set": n,
    }


def memory_gib():
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
