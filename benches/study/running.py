"""What measurements of studies share: subjects, runs of the program, and figures, which are kept."""

import csv
import json
import os
import platform
import subprocess
import sys
import time
from pathlib import Path


class Bench:
    def __init__(self, binary, data, out):
        self.binary = str(binary)
        # Absolute: paths in tables of subjects are relative to the table.
        self.out = Path(out).resolve()
        self.out.mkdir(parents=True, exist_ok=True)
        self.files = sorted(Path(data, "hippocampus").glob("*.nii.gz"))
        self.figures_at = self.out / "figures.json"
        self.figures = json.loads(self.figures_at.read_text()) if self.figures_at.exists() else {}

    def begin(self):
        said = subprocess.run([self.binary, "--version"], capture_output=True, text=True)
        self.say("run", machine=machine(), version=said.stdout.strip(), load=os.getloadavg()[0])

    def say(self, part, **values):
        self.figures.setdefault(part, {}).update(values)
        self.figures_at.write_text(json.dumps(self.figures, indent=1))
        print(part, json.dumps(values), flush=True)

    def study(self, cohort, folder, *options):
        """Seconds, seconds of processors, and the largest memory, MiB, of one run."""
        return run([self.binary, "study", cohort, "--out", folder, *options])

    def spread(self, n):
        """`n` of the subjects, evenly."""
        return [self.files[k * len(self.files) // n] for k in range(n)]


def run(command):
    before = time.monotonic()
    process = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"{' '.join(map(str, command[:3]))} failed: {errors[-2000:]}")
    return time.monotonic() - before, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def table(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    return path


def document(folder):
    return json.loads((folder / "study.json").read_text())


def stem(path):
    return path.name.split(".")[0]


def model_figures(folder):
    """What a finished study says of its model, for a few numbers of modes."""
    found = document(folder)["found"]
    model = found["model"]
    at = lambda key: {str(m): round(model[key][m - 1], 4) for m in (1, 5, 10, 20) if m <= len(model[key])}
    return {
        "subjects": found["subjects"],
        "total_variance_mm2": round(sum(model["variances_mm2"]), 4),
        "compactness": at("compactness"),
        "generalization_mm": at("generalization_mm"),
        "specificity_mm": at("specificity_mm"),
        "consistency": found["consistency"],
        "dice": found["dice"],
    }


def machine():
    with open("/proc/cpuinfo") as info:
        model = next((line.split(":")[1].strip() for line in info if line.startswith("model name")), platform.machine())
    return f"{model}, {os.cpu_count()} cores"
