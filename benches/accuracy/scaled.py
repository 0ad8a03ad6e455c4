"""The set `scale`: the same pairs in other units of length, on which answers must not depend.

Positions of both surfaces are multiplied by a factor; vertices, faces and the true rotation are unchanged.
"""

from geometry import LENGTHS

FACTORS = [0.001, 0.01, 0.1, 0.3, 1, 3, 10, 100, 1000]
KINDS = [f"scale_{factor:g}" for factor in FACTORS]
ORIGINS = {"real_resample": 1, "real_warp8": 2}
"""Sets whose first pairs are scaled, and how many of each."""
KEPT = False


def factor_of(kind):
    return float(kind.removeprefix("scale_"))


def names(cases, kind, _n):
    origins = [name for origin, count in ORIGINS.items() for name in cases.first(origin, count)]
    return [f"{kind}/{name.replace('/', '-')}" for name in origins]


def make(cases, kind, index):
    factor = factor_of(kind)
    case = dict(cases.load(index.replace("-", "/")))
    for name in LENGTHS:
        if name in case:
            case[name] = case[name] * factor
    case["area"] = case["area"] * factor**2
    return case
