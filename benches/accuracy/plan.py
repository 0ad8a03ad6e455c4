"""The plan of a run: methods and cases, the most useful first."""

import json
import os

import analytic
import bodies
import capsules
import landmarked
import parts
import people
import symmetries
import warped
from cases import FAMILY, REAL, ROBUSTNESS, UNLIKE
from coarse import KINDS as NOISY
from solids import KINDS as SYMMETRIC
from peers import PEERS

OURS = {"balanced": 2, "rigid": 1}
"""Our methods and their numbers of cores."""
DEFAULT = "balanced"
MANY = {"real_cross": 3, "real_resample": 3, **{kind: 10 for kind in NOISY}}
"""Factors on the number of pairs of these sets, to detect a wrong pose in one of thirty, and because labels vary
most."""
ROBUST_OURS = [DEFAULT, "rigid"]
ROBUST_PEERS = ["icp", "lattice", "fgr", "ransac", "kiss"]
SWAPPED = ["real_warp4", "real_warp8", "real_cross"]
SWAPPED_PEERS = ["icp", "bcpd", "cpd", "functional_maps"]
DENSE_PEERS = ["icp", "bcpd"]
"""Peers on the sets of dense truth and of landmarks."""
DENSE = ["real_narrow2", "narrow4", *warped.WIDTH_KINDS, *capsules.KINDS, *bodies.KINDS, *landmarked.KINDS]
"""Sets, beside the real ones, on which dense peers run."""
HALF = [*warped.WIDTH_KINDS, *SYMMETRIC]
COUNTS = {kind: 6 for kind in symmetries.KINDS}
"""Most pairs of these sets, whose indices take turns in samplings."""
TURNS = {kind: 32 for kind in analytic.KINDS}
"""Pairs of these sets in every run: eight indices have every width with every shape. Vertices of one pair share an error
of its pose, so the calibration error of eight pairs is mostly chance."""
ABLATION = {
    "real": ["real_warp4", "real_warp8", "real_cross"],
    "road": [
        *["real_warp8", "real_cross", "real_resample", "resample_noise", "bean_warp8", "analytic_star_10_3000"],
        *["bent_120", "bodies_posed", "bodies_animals", "bodies_build"],
    ],
    "parts": parts.KINDS,
}
"""The sets on which each group of variants is measured."""


def read_variants():
    """Groups of named variants: parameters of the default method with a part switched off."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "variants.json")) as file:
        return json.load(file)


def variant(name):
    """The parameters of one variant."""
    return next(variants[name] for variants in read_variants().values() if name in variants)


def our_parameters(method):
    """Parameters of one of our methods. A method can also be written `variant: NAME`, and can end in
    parameters of its own, each written ` --set KEY=VALUE`."""
    method, *changes = method.split(" --set ")
    if method.startswith("variant: "):
        parameters = {"method": DEFAULT, **variant(method.removeprefix("variant: "))}
    else:
        parameters = {"method": method}
    parameters.update(change.split("=", 1) for change in changes)
    return parameters


def cores_of(method):
    return OURS.get(method, OURS[DEFAULT])


def ablated(n, kind):
    """Number of pairs of a set in the ablation: twice as many parts, for narrower intervals."""
    if kind in ABLATION["real"]:
        return max(n // 2, 1) * MANY.get(kind, 1)
    return 2 * n if kind in parts.KINDS else count_of(kind, n)


def count_of(kind, n):
    """Number of pairs of a set other than the real ones, for the default method."""
    if kind in TURNS:
        return TURNS[kind]
    if kind in COUNTS:
        return min(COUNTS[kind], n)
    return max(n // 2, 1) if kind in HALF else n * MANY.get(kind, 1)


def tasks(cases, n, with_peers, with_ablation=True):
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
    # People need assets that are installed on request.
    for kind in ["real_narrow2", *(kind for kind in FAMILY if kind not in people.KINDS)]:
        add([DEFAULT], kind, count_of(kind, n), False)
    for group, variants in read_variants().items() if with_ablation else ():
        for kind in ABLATION[group]:
            add([f"variant: {name}" for name in variants], kind, ablated(n, kind), False)
    if with_peers:
        for kind in REAL:
            add([p for p in PEERS if PEERS[p].run], kind, n * MANY.get(kind, 1), True)
        for kind in ROBUSTNESS:
            add(ROBUST_PEERS, kind, n, False)
        for kind in DENSE:
            add(DENSE_PEERS, kind, half if kind in HALF else n, False)
        for kind in SWAPPED:
            add(SWAPPED_PEERS, f"swapped_{kind}", half, False)
    return found
