"""The effect of each number of `benches/thresholds.toml`: builds the program with the number made larger and smaller,
and compares both with the unchanged program, pair by pair. See `make thresholds`.

A copy of the tracked files is changed and built under `target/thresholds`; the working tree is not touched. An
interrupted run continues: answers are kept by the program that gave them.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tomllib

import cases
import runner
import verdicts
from ours import Homolog
from plan import DEFAULT
from tables import table

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SETS = [
    *["real_warp8", "real_cross", "real_resample", "resample_noise", "bean_warp8", "bean_cut", "narrow4"],
    *["bent_120", "bodies_posed", "bodies_unlike", "landmarked_molar", "part_copy", "part_other", "analytic_star_10_1000"],
    *["mirrored", "ellipsoid", "unlike_hippocampus_putamen", "symmetric_cube", "solid_ellipsoid", "bumped_prolate"],
]
"""Sets that cover every route of a pair and every kind of verdict."""
SAME_DEG = 1.0
SAME_SHARE = 0.02
"""Two answers differ if their rotation errors or their shares of vertices within one edge differ by more than this."""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--data", default="data")
    parser.add_argument("--eval", default="eval")
    parser.add_argument("--by", type=float, default=1.25, help="factor by which each number is made larger and smaller")
    parser.add_argument("--only", help="comma-separated names of numbers")
    parser.add_argument("--sets", help="comma-separated sets of pairs")
    parser.add_argument("--cases", type=int, default=3, help="pairs of a set")
    parser.add_argument("--limit", type=float, default=120, help="seconds that one answer may take")
    parser.add_argument("--work", default=os.path.join(ROOT, "target/thresholds"))
    parser.add_argument("--out", help="default: WORK/thresholds.md")
    return parser.parse_args()


def changed(text, name, value):
    """`text` with the number `name` set to `value`: a constant, or a member in the defaults of settings."""
    number = r"[-+0-9.e_]+"
    for pattern in (rf"(const {name}: \w+ = ){number}(;)", rf"(\b{name}: ){number}([ ,])"):
        found, n = re.subn(pattern, lambda m: f"{m[1]}{value}{m[2]}", text)
        if n:
            return found
    raise ValueError(f"no number {name}")


def literal(before, value):
    """`value` as a Rust literal of the type of `before`."""
    return str(max(1, round(value))) if isinstance(before, int) else repr(float(f"{value:.6g}"))


class Builds:
    """Programs built from a copy of the tracked files."""

    def __init__(self, work):
        self.tree, self.work = os.path.join(work, "tree"), work
        names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.decode()
        for name in filter(None, names.split("\0")):
            source, copy = os.path.join(ROOT, name), os.path.join(self.tree, name)
            if not os.path.isfile(source):
                continue
            os.makedirs(os.path.dirname(copy), exist_ok=True)
            with open(source, "rb") as file:
                wanted = file.read()
            # Unchanged files keep their modification time, so that they are not rebuilt.
            if not os.path.exists(copy) or open(copy, "rb").read() != wanted:
                shutil.copyfile(source, copy)

    def build(self, name, threshold=None, value=None):
        """The path of the program built with `threshold` set to `value`."""
        path = os.path.join(self.work, "programs", name)
        changes = []
        if threshold:
            file = os.path.join(self.tree, threshold["file"])
            with open(file) as opened:
                before = opened.read()
            changes = [(file, before)]
            with open(file, "w") as opened:
                opened.write(changed(before, threshold["name"], value))
        try:
            command = ["cargo", "build", "--release", "--locked", "--quiet", "-p", "homolog"]
            environment = {**os.environ, "CARGO_TARGET_DIR": os.path.join(self.work, "build")}
            subprocess.run(command, cwd=self.tree, env=environment, check=True)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            shutil.copy(os.path.join(self.work, "build/release/homolog"), path)
        finally:
            for file, text in changes:
                with open(file, "w") as opened:
                    opened.write(text)
        return path


def measured(program, made, names, given):
    run = runner.Runner(made, Homolog(program, given.limit), given.work, given.limit, [])
    run.run([(DEFAULT, name, False) for name in names], quiet=True)
    return [run.record(DEFAULT, name) for name in names]


def differ(a, b):
    """Whether two answers to one pair differ by more than rounding."""
    if a["status"] != b["status"]:
        return True
    of = lambda record, figure: record.get("scores", {}).get(figure)
    apart = lambda figure: abs((of(a, figure) or 0) - (of(b, figure) or 0))
    return apart("rot_deg") > SAME_DEG or apart("point_w1") > SAME_SHARE


def judged(record):
    right, reliable = verdicts.is_right(record), verdicts.is_reliable(record)
    return right, bool(reliable)


def row(threshold, value, before, after):
    answers = sum(differ(a, b) for a, b in zip(before, after))
    of = lambda records, wanted: sum(judged(r) == wanted for r in records)
    verdict = sum(judged(a)[1] != judged(b)[1] for a, b in zip(before, after))
    gained = of(after, (True, True)) - of(before, (True, True))
    wrong = of(after, (False, True)) - of(before, (False, True))
    return [f"`{threshold['name']}`", str(threshold["value"]), value, str(answers), str(verdict), f"{gained:+d}", f"{wrong:+d}"]


def main():
    given = arguments()
    with open(os.path.join(ROOT, "benches/thresholds.toml"), "rb") as file:
        ledger = tomllib.load(file)["threshold"]
    wanted = given.only.split(",") if given.only else [t["name"] for t in ledger]
    if unknown := set(wanted) - {t["name"] for t in ledger}:
        print(f"thresholds: the ledger has no {', '.join(sorted(unknown))}", file=sys.stderr)
        return 1
    made = cases.Cases(given.data, given.eval, os.path.join(ROOT, "target/accuracy/cases"))
    sets = given.sets.split(",") if given.sets else SETS
    names = [name for kind in sets for name in made.first(kind, given.cases)]
    builds = Builds(given.work)
    before = measured(builds.build("as_it_is"), made, names, given)
    rows = []
    for number, threshold in enumerate(ledger):
        if threshold["name"] not in wanted:
            continue
        for name, factor in (("larger", given.by), ("smaller", 1 / given.by)):
            value = literal(threshold["value"], threshold["value"] * factor)
            program = builds.build(f"{number}_{name}", threshold, value)
            rows.append(row(threshold, value, before, measured(program, made, names, given)))
            print(" ".join(rows[-1]), flush=True)
    reliable = sum(judged(r) == (True, True) for r in before)
    text = (
        f"# What each number decides\n\n`make thresholds`: each number of the ledger is multiplied and divided by {given.by:g}; {len(names)} pairs of "
        f"{len(sets)} sets, of which {reliable} are right and reliable with the numbers as they are. An answer changes if its rotation error does by "
        f"more than {SAME_DEG:g}°, or its share of points within one edge by more than {SAME_SHARE:g}.\n\n"
    )
    header = ["number", "is", "becomes", "answers that change", "verdicts that change", "right and reliable", "wrong and reliable"]
    out = given.out or os.path.join(given.work, "thresholds.md")
    with open(out, "w") as file:
        file.write(text + table(header, rows))
    print(f"report: {out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
