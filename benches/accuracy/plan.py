"""What is run: which method on which case, in the order in which it is most useful to have it."""

import json
import os

from cases import REAL, ROBUSTNESS, UNLIKE
from peers import PEERS

OURS = {"balanced": 2, "fast": 2, "accurate": 2, "rigid": 1}
"""Our methods and the cores that each is given."""
DEFAULT = "balanced"
MANY = {"real_cross": 3, "real_resample": 3}
"""Sets of so many times as many pairs: a pose that is lost in one of thirty must be seen, and labels vary most."""
ROBUST_OURS = [DEFAULT, "rigid"]
ROBUST_PEERS = ["icp", "lattice", "fgr", "ransac", "kiss"]
SWAPPED = ["real_warp4", "real_warp8", "real_cross"]
SWAPPED_PEERS = ["icp", "bcpd", "cpd", "functional_maps"]
ABLATION = ["real_warp4", "real_warp8", "real_cross"]


def read_variants():
    """Named sets of parameters over the default method, each with a part switched off."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "variants.json")) as file:
        return json.load(file)


def our_parameters(method, kind):
    """Parameters of one of our methods, or of a variant written `variant: NAME`, on a set of cases."""
    if method.startswith("variant: "):
        parameters = {"method": DEFAULT, **read_variants()[method.removeprefix("variant: ")]}
    else:
        parameters = {"method": method}
    if kind.endswith("_cut"):
        parameters["input.allow_boundary"] = True
    return parameters


def cores_of(method):
    return OURS.get(method, OURS[DEFAULT])


def tasks(cases, n, with_peers):
    """`(method, case name, is timed)` without repetition; the smaller studies take half as many cases."""
    half = max(n // 2, 1)
    found = []
    add = lambda methods, kind, count, timed: found.extend(
        (method, name, timed) for name in cases.first(kind, count) for method in methods
    )
    for kind in REAL:
        add(OURS, kind, n * MANY.get(kind, 1), True)
    for kind in SWAPPED:
        add([DEFAULT], f"swapped_{kind}", half, False)
    for kind in UNLIKE:
        add([DEFAULT], kind, half, False)
    for kind in ROBUSTNESS:
        add(ROBUST_OURS, kind, n, False)
    for kind in ABLATION:
        add([f"variant: {name}" for name in read_variants()], kind, half * MANY.get(kind, 1), False)
    if with_peers:
        for kind in REAL:
            add([p for p in PEERS if PEERS[p].run], kind, n * MANY.get(kind, 1), True)
        for kind in ROBUSTNESS:
            add(ROBUST_PEERS, kind, n, False)
        for kind in SWAPPED:
            add(SWAPPED_PEERS, f"swapped_{kind}", half, False)
    return found
