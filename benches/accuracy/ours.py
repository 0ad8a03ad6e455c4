"""The program under test: runs `homolog match` on two PLY files and reads the result document."""

import hashlib
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

import geometry

HERE = os.path.dirname(os.path.abspath(__file__))


class Homolog:
    """One built program; answers are kept by the hash of its bytes, so a new build is measured anew."""

    def __init__(self, path, limit_s):
        self.path, self.limit_s = os.path.abspath(path), limit_s
        with open(self.path, "rb") as file:
            self.fingerprint = hashlib.sha256(file.read()).hexdigest()[:12]
        self.version = subprocess.run([self.path, "--version"], capture_output=True, text=True).stdout.strip()

    def match(self, case, parameters, cores):
        """The record of one match and the arrays of its answer; `parameters` as `key: value`, `cores` a set."""
        sets = [f"--set={key}={as_text(value)}" for key, value in parameters.items()]
        with tempfile.TemporaryDirectory() as folder:
            at = lambda name: os.path.join(folder, name)
            geometry.write_ply(at("source.ply"), case["V1"], case["F1"])
            geometry.write_ply(at("target.ply"), case["V2"], case["F2"])
            command = [self.path, "match", at("source.ply"), at("target.ply"), "--json", *sets]
            launcher = [sys.executable, "-I", "-S", os.path.join(HERE, "measured.py"), str(self.limit_s)]
            files = [at("report.json"), at("stdout"), at("stderr")]
            # Affinity is inherited, and the program starts one thread for each core that it may use.
            subprocess.run(launcher + files + command, check=True, preexec_fn=lambda: os.sched_setaffinity(0, cores))
            with open(at("report.json")) as file:
                report = json.load(file)
            if report["exit_code"]:
                with open(at("stderr"), errors="replace") as file:
                    message = file.read()[-300:].strip().replace(folder + os.sep, "")
                # Exit code 2: a wrong parameter, or a surface that cannot be matched.
                status = "out of time" if report["out_of_time"] else "refused" if report["exit_code"] == 2 else "failed"
                return {**report, "status": status, "message": message}, {}
            with open(at("stdout")) as file:
                document = json.load(file)
        return {**report, "status": "answered", **summary(document)}, arrays(document, case)


def as_text(value):
    return value if isinstance(value, str) else json.dumps(value)


def columns(document):
    return document.get("correspondences") or {}


def arrays(document, case):
    """Transform, target vertex, confidence and, if the document has them, sub-vertex points and their spreads."""
    found = {"matrix": np.array(document["transform"]["matrix"], float).reshape(4, 4)}
    table = columns(document)
    if not table.get("target"):
        return found
    n = len(case["V1"])
    source = np.array(table.get("source", range(n)))
    placed = lambda values, empty: scattered(source, np.array(values), n, empty)
    # A vertex without a match in the answer keeps -1 and counts as wrong.
    found["map"] = placed([-1 if j is None else j for j in table["target"]], -1)
    if "confidence" in table:
        found["confidence"] = placed([0.0 if c is None else c for c in table["confidence"]], 0.0)
    if table.get("spread_mm"):
        found["spread"] = placed([np.nan if s is None else s for s in table["spread_mm"]], np.nan)
    points = sub_vertex_points(table, case)
    if points is not None:
        found["points"] = placed(points, np.nan)
    return found


def scattered(index, values, n, empty):
    out = np.full((n, *values.shape[1:]), empty, dtype=values.dtype)
    out[index] = values
    return out


def sub_vertex_points(table, case):
    """Points on the target, from coordinates or from the barycentric coordinates in a triangle."""
    for name in ("point", "point_mm", "image", "image_mm"):
        if table.get(name) and not isinstance(table[name], dict):
            return np.array(table[name], float)
    weights = table.get("barycentric")
    corners = table.get("triangle")
    if not weights or not corners:
        return None
    corners = np.array(corners)
    if corners.ndim == 1:
        corners = case["F2"][corners]
    return np.einsum("ik,ikd->id", np.array(weights, float), case["V2"][corners])


def summary(document):
    """The numbers of the document about its own answer."""
    table = columns(document)
    said = {
        "own_seconds": document["timings_ms"]["total"] / 1000,
        "stop_reason": document.get("stop_reason"),
        "reliability": document.get("reliability"),
        "surface_mean_mm": (document.get("surface_distance") or {}).get("mean_mm"),
        "surface_p95_mm": (document.get("surface_distance") or {}).get("p95_mm"),
        "inlier_ratio": (document.get("support") or {}).get("ratio"),
    }
    if table.get("confidence"):
        said["mean_confidence"] = float(np.mean([c or 0.0 for c in table["confidence"]]))
    if table.get("outlier"):
        said["outlier_share"] = float(np.mean([o not in (None, "none") for o in table["outlier"]]))
    return said
