"""Energy of the truth and of the labelings of all minimizers, on the sets with known truth: `run --energies`.

Writes the pairs as files, runs the laboratory's program `energies` on them, and prints for every set, energy and
minimizer the difference of the energies and the error of the labels. Last, it prints Spearman's rank correlation
between energy and error over all cases and all minimizers that do not start at the truth, in three forms: the mean
energy of a variable against the error; the energy over the lowest of the case against the error over that of the
relaxed truth (conditional modes from the truth); and both over those of the relaxed truth, because the labels nearest
to the truth are not equally good in all cases.
"""

import csv
import os
import subprocess

import numpy as np
from scipy.stats import spearmanr

from geometry import write_ply

FROM_TRUTH = "conditional modes from the truth"
STARTS = " from form ", " from extremities "
"""Parts of the names of minimizations from one of several forms or assignments; `propagation (form)` is the lowest of
these."""
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
        begun_at_truth = {line["case"]: value(line, "error_pct") for line in of if line["minimizer"] == FROM_TRUTH}
        is_one_start = lambda line: any(start in line["minimizer"] for start in STARTS)
        minimizers = [line for line in of if line["minimizer"] != FROM_TRUTH and not is_one_start(line)]

        lowest = {}
        for line in minimizers:
            lowest[line["case"]] = min(value(line, "found"), lowest.get(line["case"], np.inf))
        of_variable = lambda line: value(line, "found") / value(line, "variables")
        over_lowest = lambda line: value(line, "found") / lowest[line["case"]]
        over_truth = lambda line: value(line, "found") / value(line, "relaxed")
        error = lambda line: value(line, "error_pct")
        error_over_truth = lambda line: error(line) / begun_at_truth[line["case"]]
        correlation = lambda lines, x, y: spearmanr([x(line) for line in lines], [y(line) for line in lines])[0]
        print(f"  rank correlation of energy and error over minimizers and cases ({len(minimizers)}), over all labelings ({len(of)}):")
        for what, x, y in [
            ("mean energy of a variable, error", of_variable, error),
            ("energy over the lowest of the case, error over that of the relaxed truth", over_lowest, error_over_truth),
            ("both over those of the relaxed truth", over_truth, error_over_truth),
        ]:
            print(f"    {correlation(minimizers, x, y):5.2f} {correlation(of, x, y):5.2f}  {what}")
        within = [correlation([line for line in of if line["case"] == case], over_truth, error) for case in begun_at_truth]
        print(f"  within a case {np.nanmedian(within):.2f} (all labelings, median of {len(within)})")
        lower = [line for line in of if value(line, "found") < value(line, "relaxed")]
        wrong = [line for line in lower if value(line, "error_pct") > 5]
        print(f"  labelings below the relaxed truth: {len(lower)} of {len(of)}, {len(wrong)} of them wrong by more than 5 %")
