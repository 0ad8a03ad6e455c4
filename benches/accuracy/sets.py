"""Names of groups of sets for `--sets`, which also takes single sets."""

import analytic
import bodies
import capsules
import coarse
import landmarked
import parts
import people
import scaled
import solids
import structures
import symmetries
import warped
from cases import FAMILY, REAL, ROBUSTNESS, UNLIKE

GROUPS = {
    "real": REAL,
    "robustness": ROBUSTNESS,
    "scale": scaled.KINDS,
    "narrow": ["real_narrow2", "narrow4"],
    "width": warped.WIDTH_KINDS,
    "bent": capsules.KINDS,
    "bodies": bodies.KINDS,
    "people": people.KINDS,
    "symmetric": solids.KINDS,
    "solids": symmetries.SYMMETRIC,
    "bumped": symmetries.BUMPED,
    **symmetries.BY_GROUP,
    "analytic": analytic.OTHER,
    "analytic_star": analytic.STAR,
    "unlike": structures.KINDS,
    "noise": coarse.KINDS,
    "parts": parts.KINDS,
    "landmarked": landmarked.KINDS,
}
KINDS = [*REAL, "real_narrow2", *ROBUSTNESS, *UNLIKE, *FAMILY, *(f"swapped_{kind}" for kind in REAL)]


def expanded(text):
    """The sets that a comma-separated list of sets and groups names."""
    found = []
    for name in text.split(","):
        if name not in GROUPS and name not in KINDS:
            raise ValueError(f"no set {name}; there are {', '.join([*GROUPS, *KINDS])}")
        found += GROUPS.get(name, [name])
    return list(dict.fromkeys(found))
