"""The accuracy table: our methods and the peers on the same pairs, in one run. See README.md."""

import argparse
import datetime
import os
import sys

import cases
import energies
import figures
import plan
import quick
import report
import runner
import sets
import summary
from ours import Homolog
from peers import PEERS

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", default="data", help="folder with hippocampus/*.nii.gz, label volumes")
    parser.add_argument("--eval", default="eval", help="folder with real_cases.py, the generator of cases")
    parser.add_argument("--binary", default=os.path.join(ROOT, "target/release/homolog"))
    parser.add_argument("--work", default=os.path.join(ROOT, "target/accuracy"), help="cases and answers are kept here")
    parser.add_argument("--cases-cache", help="folder of cases that real_cases.py has made already")
    parser.add_argument("--out", help="default: docs/accuracy/DATE")
    parser.add_argument("--cases", type=int, help="pairs of a set; default 10, or 5 with --ours-only")
    parser.add_argument("--limit", type=float, default=120, help="seconds that one answer may take")
    parser.add_argument("--ours-only", action="store_true", help="no peers")
    parser.add_argument("--no-ablation", action="store_true", help="no variants of the default method")
    parser.add_argument("--only", action="append", help="run this method alone; may be repeated")
    parser.add_argument("--refresh", action="append", default=[], help="compute this method's answers anew")
    parser.add_argument("--sets", help="quick mode: a line for each of these sets or groups of sets, and no report")
    parser.add_argument("--set", action="append", default=[], help="quick mode: KEY=VALUE, a parameter of the match")
    parser.add_argument("--energies", metavar="PROGRAM", help="the energy of the truth against what minimizers find")
    parser.add_argument("--peers-of", metavar="REPORT", help="a folder docs/accuracy/DATE: take the untimed answers of its peers")
    parser.add_argument("--report-only", action="store_true", help="write the report of the answers that are there")
    return parser.parse_args()


def complain_of_missing(given):
    faults = []
    if not os.path.exists(given.binary):
        faults.append(f"no program {given.binary}: `make accuracy` builds it")
    if not os.path.isdir(os.path.join(given.data, "hippocampus")):
        faults.append(
            f"no folder {os.path.join(given.data, 'hippocampus')}: name with DATA=dir a folder whose subfolder "
            "hippocampus has label volumes (*.nii.gz), such as those of the Medical Segmentation Decathlon, task 4"
        )
    if not os.path.exists(os.path.join(given.eval, "real_cases.py")):
        faults.append(f"no {os.path.join(given.eval, 'real_cases.py')}: name its folder with EVAL=dir")
    for fault in faults:
        print(f"accuracy: missing: {fault}", file=sys.stderr)
    return bool(faults)


def run_quickly(given, run, made):
    try:
        chosen = sets.expanded(given.sets)
    except ValueError as error:
        print(f"accuracy: {error}", file=sys.stderr)
        return 1
    methods = given.only or [plan.DEFAULT, *([] if given.ours_only else plan.DENSE_PEERS)]
    settings = "".join(f" --set {change}" for change in given.set)
    methods = [method if method in PEERS else method + settings for method in methods]
    quick.run(run, made, chosen, given.cases or 5, methods)
    return 0


def main():
    given = arguments()
    if complain_of_missing(given):
        return 1
    cache = given.cases_cache or os.path.join(given.work, "cases")
    made = cases.Cases(given.data, given.eval, cache)
    homolog = Homolog(given.binary, given.limit)
    run = runner.Runner(made, homolog, given.work, given.limit, given.refresh)
    if given.energies:
        folder, out = os.path.join(given.work, "energies"), os.path.join(given.work, "energies.csv")
        chosen = sets.expanded(given.sets or energies.SETS)
        energies.run(given.energies, made, chosen, given.cases or 5, folder, out)
        return 0
    if given.sets:
        return run_quickly(given, run, made)
    n = given.cases or (5 if given.ours_only else 10)
    tasks = plan.tasks(made, n, not given.ours_only, not given.no_ablation)
    if given.peers_of:
        try:
            run.take(given.peers_of, tasks)
        except (OSError, ValueError) as error:
            print(f"accuracy: --peers-of: {error}", file=sys.stderr)
            return 1
    if not given.report_only:
        run.run([task for task in tasks if not given.only or task[0] in given.only])
    out = given.out or os.path.join(ROOT, "docs/accuracy", datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d"))
    os.makedirs(out, exist_ok=True)
    found = summary.collect(run, tasks, n, not given.ours_only)
    figures.draw(found, out)
    report.write(found, out)
    print(f"report: {os.path.join(out, 'README.md')}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
