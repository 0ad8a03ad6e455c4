"""The sets `part_*` and `end_*`: one half, or one end of 30 %, of a hippocampus, open at the cut, and the whole of a
re-sampled copy or of another subject; and `to_*`: the whole and such an end.

The two ends take turns. For another subject the true pose is the generator's estimate: the two whole surfaces aligned
by trimmed ICP from their poses in the scanner.
"""

from scipy.spatial import cKDTree

import geometry

WHOLE = {"part_copy": "real_resample", "part_other": "real_cross", "end_copy": "real_resample", "end_other": "real_cross"}
EXCHANGED = {"to_end_copy": "end_copy", "to_end_other": "end_other"}
KINDS = [*WHOLE, *EXCHANGED]
KEPT = True
CUT = {"part_copy": 0.5, "part_other": 0.5, "end_copy": 0.7, "end_other": 0.7}
"""The share of the area that is cut off."""


def names(cases, kind, n):
    return cases.first_of_genus_0(kind, n)


def make(cases, kind, index):
    if kind in EXCHANGED:
        return geometry.swapped(cases.load(f"{EXCHANGED[kind]}/{index}"))
    index = int(index)
    case = cases.load(f"{WHOLE[kind]}/{index}")
    new = {key: case[key] for key in ("F2", "V2", "R", "t", "genus0", "lb") if key in case}
    new["V1"], new["F1"] = geometry.cut_end(case["V1"], case["F1"], CUT[kind], index % 2 == 0)
    kept = cKDTree(case["V1"]).query(new["V1"])[1]
    new.update({key: case[key][kept] for key in ("gtpos", "la") if key in case})
    return geometry.finished(new)
