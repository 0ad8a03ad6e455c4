"""Whether an answer is right, and whether its `reliability` is correct."""

from cases import UNLIKE
from coarse import KINDS as NOISY
from solids import KINDS as SYMMETRIC
from structures import KINDS as STRUCTURES
from symmetries import BUMPED
from symmetries import SYMMETRIC as SOLIDS

EXPECTED = {
    **{kind: "ambiguous_pose" for kind in [*SYMMETRIC, *SOLIDS]},
    **{kind: "unlike_shape" for kind in STRUCTURES},
    **{kind: None for kind in UNLIKE},
    "mirrored": "other_handedness",
}
"""Sets whose answers must not be reliable, with the reason that must be among the given ones; None: any reason."""
RIGHT_DEG = 5
RIGHT_SHARE = 0.5
RIGHT_LABELS = 0.8
SAME_END_DEG = 45
PARTS_OF_OTHERS = ["part_other", "end_other", "to_end_other"]
RIGID = [
    *["real_resample", "resample_noise", "resample_cut", "resample_half", "bean_noise", "bean_cut", "bean_half"],
    *["part_copy", "end_copy", "to_end_copy", *NOISY],
]


def kind_of(record):
    return record["case"].split("/")[0]


def is_right(record):
    """Whether an answer is right; None if this cannot be decided.

    Copies: the rotation is within 5 degrees. Deformed pairs: half of the vertices are within two edges of the truth.
    Two subjects and any other pair with a rigid truth: within 10 degrees, as the rigid truth itself is an estimate.
    Solids with a bump: also within 10 degrees, which decides between the symmetric poses of the solid. A part and
    another subject's whole: labels agree at four fifths of the vertices, or, without labels, the rotation is within 45
    degrees, which distinguishes the two ends although the rigid truth of a part differs from that of the whole.
    """
    kind, found = kind_of(record), record.get("scores", {})
    if kind in EXPECTED:
        return False
    if kind in RIGID or "/real_resample" in record["case"]:
        return found.get("rot_deg", 180) <= RIGHT_DEG
    if kind in BUMPED:
        return found.get("rot_deg", 180) <= 2 * RIGHT_DEG
    if kind in PARTS_OF_OTHERS:
        return found["label"] >= RIGHT_LABELS if "label" in found else found.get("rot_deg", 180) <= SAME_END_DEG
    if "w2" in found:
        return found["w2"] >= RIGHT_SHARE
    if "rot_deg" in found:
        return found["rot_deg"] <= 2 * RIGHT_DEG
    return None


def is_reliable(record):
    said = record.get("reliability")
    return bool(said["reliable"]) if isinstance(said, dict) else None


def is_wrong_yet_reliable(record):
    return is_right(record) is False and bool(is_reliable(record))


def gives_expected_reason(record):
    """Whether an answer that must not be reliable is unreliable for the expected reason."""
    reason = EXPECTED[kind_of(record)]
    said = record.get("reliability") or {}
    return not said.get("reliable", True) and (reason is None or reason in said.get("reasons", []))
