"""The energy of the truth against what minimizers find, on the sets with known truth: `run --energies`.

Writes the pairs as files, runs the laboratory's program `energies` on them, and prints for every set, energy and
minimizer how far the energies lie apart and how far the labels are from the truth; last, Spearman's rank correlation between
energy and error over all minimizers and cases.
"""

import csv
import os
import subprocess

import numpy as np
from scipy.stats import spearmanr

from geometry import write_ply

SETS = "real_resample,real_warp4,real_warp8,bodies,bent"


def run(program, cases, chosen, n, folder, out):
    os.makedirs(folder, exist_ok=True)
    for stale in os.listdir(folder):
        os.remove(os.path.join(folder, stale))
    for kind in chosen:
        for name in cases.first(kind, n):
            write(cases.load(name), os.path.join(folder, name.replace("/", "-")))
    lines = subprocess.run([program, folder], check=True, stdout=subprocess.PIPE, text=True).stdout
    with open(out, "w") as file:
        file.write(lines)
    report(list(csv.DictReader(lines.splitlines())))


def write(case, path):
    truth = case["gtpos"] if "gtpos" in case else case["V1"] @ case["R"].T + case["t"]
    write_ply(f"{path}_s.ply", case["V1"], case["F1"])
    write_ply(f"{path}_t.ply", case["V2"], case["F2"])
    np.asarray(truth).astype("<f8").tofile(f"{path}.truth")


def report(lines):
    set_of = lambda line: line["case"].rstrip("0123456789").rstrip("-_")
    kinds = list(dict.fromkeys(map(set_of, lines)))
    energies = list(dict.fromkeys(line["energy"] for line in lines))
    value = lambda line, name: float(line[name])
    for energy in energies:
        print(f"\n{energy}: E(truth), E(truth relaxed), E(found), E(truth relaxed) - E(found), error in % of the diagonal")
        for kind in kinds:
            of_kind = [line for line in lines if set_of(line) == kind and line["energy"] == energy]
            for minimizer in dict.fromkeys(line["minimizer"] for line in of_kind):
                of = [line for line in of_kind if line["minimizer"] == minimizer]
                mean = lambda name: np.mean([value(line, name) for line in of])
                gap = mean("relaxed") - mean("found")
                print(
                    f"  {kind:16} {minimizer:42} {len(of):3} {mean('truth'):9.0f} {mean('relaxed'):9.0f} "
                    f"{mean('found'):9.0f} {gap:+9.0f} {mean('error_pct'):7.2f}"
                )
        of = [line for line in lines if line["energy"] == energy]
        excess = [value(line, "found") / value(line, "relaxed") - 1 for line in of]
        error = [value(line, "error_pct") for line in of]
        within = []
        for case in dict.fromkeys(line["case"] for line in of):
            pairs = [(value(line, "found"), value(line, "error_pct")) for line in of if line["case"] == case]
            within.append(spearmanr(*zip(*pairs))[0])
        print(
            f"  rank correlation of excess energy and error: {spearmanr(excess, error)[0]:.2f} over all, "
            f"{np.nanmedian(within):.2f} within a case (median of {len(within)})"
        )
        lower = [line for line in of if value(line, "found") < value(line, "relaxed")]
        wrong = [line for line in lower if value(line, "error_pct") > 5]
        print(f"  labelings below the relaxed truth: {len(lower)} of {len(of)}, {len(wrong)} of them wrong by more than 5 %")
