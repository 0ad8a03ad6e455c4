"""The quick mode: chosen sets, the default method, one line for each set as soon as it is complete. Writes no
report."""

import re

import numpy as np

import roles
import scores
import verdicts
from plan import DEFAULT
from tables import reason

COLUMNS = [
    ("pairs", 5),
    ("answered", 8),
    ("reliable", 8),
    ("rot. med", 8),
    ("rot. max", 8),
    ("<= 5 deg", 8),
    ("wrong yet reliable", 18),
    ("1 edge", 6),
    ("  points", 8),
    ("edges", 6),
    ("diag %", 6),
    ("area %", 6),
    ("<= 5 %", 6),
    ("label", 6),
    ("conf.", 6),
    ("ECE", 6),
    ("> 2 s", 6),
    ("back", 6),
    ("lm %", 6),
    ("rigid %", 7),
    ("floor %", 7),
    ("s", 6),
]
"""Column titles and widths."""
EXPLANATION = """\
reliable: answers that call themselves so
rot.: rotation error, degrees; a pair without an answer is not within 5
wrong yet reliable: answers that are wrong (verdicts.py) and call themselves reliable
1 edge: share of vertices within one edge of the truth, by target vertex and by corresponding point
edges: mean error of the corresponding points, in edges
diag %, area %: the same (by target vertex where there are no points), percent of the target's diagonal and of the
      root of its area
<= 5 %: share of the corresponding points within 5 % of the target's diagonal of the truth
conf., ECE: mean confidence and its expected calibration error
> 2 s: share of corresponding points that are off by more than two of their stated spreads; {expected:.3f} where they are right
lm %: mean landmark error, percent of the root of the area; rigid %, floor %: what the best rigid transform of the
      landmarks themselves and the nearest vertices leave
back: sets swapped_*: share of source vertices that the maps there and back return within one edge
s: median seconds
"""

TITLES_OF_ROLES = {"fit": "sets on which numbers are fitted", "report": "sets on which nothing is fitted"}


def run(runner, cases, chosen, n, methods=(DEFAULT,)):
    chosen = sorted(chosen, key=roles.role_of)
    width = max(map(len, chosen)) + max(len(m) if m != DEFAULT else 0 for m in methods) + 1
    print(f"{EXPLANATION.format(expected=scores.expected_beyond(2))}\n{'':{width}} " + " ".join(f"{title:>{w}}" for title, w in COLUMNS))
    shown = None
    for kind in chosen:
        if roles.role_of(kind) != shown:
            shown = roles.role_of(kind)
            print(f"-- {TITLES_OF_ROLES[shown]}", flush=True)
        names = cases.first(kind, n)
        wanted = names + [name.removeprefix("swapped_") for name in names if name.startswith("swapped_")]
        runner.run([(method, name, False) for name in wanted for method in methods], quiet=True)
        for method in methods:
            records = [runner.record(method, name) for name in names]
            label = kind if method == DEFAULT else f"{kind} {method}"
            back = [share for name in names if (share := returned(runner, cases, method, name)) is not None]
            print(line(label, width, [r for r in records if r], back), flush=True)


def returned(runner, cases, method, name):
    """Share of vertices that return to within one edge, for a pair of a set `swapped_*`."""
    if not name.startswith("swapped_"):
        return None
    forward = name.removeprefix("swapped_")
    forth, back = (runner.arrays(method, n).get("map") for n in (forward, name))
    if forth is None or back is None:
        return None
    return float((scores.there_and_back(cases.load(forward), forth, back) <= 1).mean())


def line(label, width, records, back):
    if not records:
        return f"{label:{width}} no pairs"
    answered = [r for r in records if r["status"] == "answered"]
    of_case = [r["of_case"] for r in records if r.get("of_case")]
    values = lambda name: [v for r in answered if (v := r["scores"].get(name, r.get(name))) is not None]
    of_pairs = lambda name: [pair[name] for pair in of_case if name in pair]
    mean = lambda found, digits=3: f"{np.mean(found):.{digits}f}" if found else ""
    rotations = values("rot_deg")
    said = [r["reliability"] for r in answered if isinstance(r.get("reliability"), dict)]
    bins = [r["bins"] for r in answered if r.get("bins")]
    cells = [
        str(len(records)),
        str(len(answered)),
        str(sum(bool(v["reliable"]) for v in said)) if said else "",
        f"{np.median(rotations):.2f}" if rotations else "",
        f"{max(rotations):.1f}" if rotations else "",
        str(sum(r <= 5 for r in rotations)) if rotations else "",
        str(sum(map(verdicts.is_wrong_yet_reliable, answered))) if said else "",
        mean(values("w1")),
        mean(values("point_w1")),
        mean(values("point_err_edges")),
        mean(values("err_diag_pct"), 2),
        mean(values("err_area_pct"), 2),
        mean(values("within_5_pct")),
        mean(values("label")),
        mean(values("mean_confidence")),
        f"{scores.calibration_error(np.sum(bins, axis=0)):.3f}" if bins else "",
        mean(values("beyond_2_spreads")),
        mean(back),
        mean(values("landmark_pct"), 2),
        mean(of_pairs("landmark_rigid_pct"), 2),
        mean(of_pairs("landmark_floor_pct"), 2),
        f"{np.median(values('seconds')):.2f}" if answered else "",
    ]
    text = f"{label:{width}} " + " ".join(f"{cell:>{w}}" for cell, (_, w) in zip(cells, COLUMNS))
    return "  ".join([text, *told(said), *failures(records)])


def told(said):
    """The reasons of unreliable answers, and how often each is given."""
    given = [name for verdict in said for name in verdict.get("reasons", [])]
    return [f"{name} {given.count(name)}" for name in sorted(set(given))]


def failures(records):
    """Pairs without an answer, grouped by reason without its numbers, each group with its first message."""
    said = {}
    for record in records:
        if record["status"] != "answered":
            message = reason(record.get("message", ""))
            said.setdefault((record["status"], re.sub(r"\d+", "", message)), []).append(message)
    return [f"[{len(messages)} {status}: {messages[0]}]" for (status, _), messages in said.items()]
