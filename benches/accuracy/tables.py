"""Cells and tables of the report, in Markdown."""

import analytic
import capsules
import scaled
import solids
import symmetries
import warped
from peers import PEERS
from plan import DEFAULT

REAL_TITLES = {
    "real_warp4": "warp 4 %",
    "real_warp8": "warp 8 %",
    "real_cross": "two subjects",
    "real_resample": "re-sampled copy",
}
TITLES = {
    **REAL_TITLES,
    "resample_noise": "copy, noise",
    "resample_cut": "copy, end cut",
    "resample_half": "copy, half density",
    "bean_noise": "bean, noise",
    "bean_cut": "bean, end cut",
    "bean_half": "bean, half density",
    "bean_warp8": "bean, warp 8 %",
    "mirrored": "mirrored copy",
    "ellipsoid": "ellipsoid of its size",
    "anterior_part": "another subject's anterior part",
    "part_copy": "half and re-sampled whole",
    "part_other": "half and another subject's whole",
    "end_copy": "end of 30 % and re-sampled whole",
    "end_other": "end of 30 % and another subject's whole",
    "to_end_copy": "re-sampled whole and end of 30 %",
    "to_end_other": "another subject's whole and end of 30 %",
    "real_narrow2": "narrow warp 2 %",
    "narrow4": "narrow warp 4 %",
    "noise1000": "1,000 vertices, noise",
    "noise1000_bean": "bean of 1,000 vertices, noise",
    "unlike_hippocampus_putamen": "hippocampus and putamen",
    "unlike_femur_vertebra": "femur and vertebra",
    "landmarked_femur": "femurs",
    "landmarked_molar": "molars",
    "landmarked_molar_equal_size": "molars, equal size",
    "landmarked_vertebra": "vertebrae",
    "landmarked_mouse_skull": "mouse skulls",
    **{kind: f"capsule bent by {kind.removeprefix('bent_')}°" for kind in capsules.KINDS},
    "bodies_posed": "person in two poses",
    "bodies_animals": "animal in two poses",
    "bodies_build": "two individuals in two poses",
    "bodies_unlike": "two individuals as of two species",
    **{kind: f"{kind.removeprefix('symmetric_')}, sampled twice" for kind in solids.KINDS},
    **{kind: f"{kind.removeprefix('solid_')} of varied dimensions" for kind in symmetries.SYMMETRIC},
    **{kind: f"{kind.removeprefix('bumped_')} with a bump" for kind in symmetries.BUMPED},
    **{kind: analytic.title(kind) for kind in analytic.KINDS},
    **{kind: f"warp 4 %, kernels {kind.removeprefix('width_')} wide" for kind in warped.WIDTH_KINDS},
    **{kind: f"in units of {kind.removeprefix('scale_')}" for kind in scaled.KINDS},
    **{f"swapped_{kind}": f"{name}, exchanged" for kind, name in REAL_TITLES.items()},
}


def title(method):
    if method in PEERS:
        return PEERS[method].title
    return f"**homolog {method}**" if method == DEFAULT else f"homolog {method}"


def mean_text(s, digits=2):
    return "" if not s else f"{s['mean']:.{digits}f} [{s['low']:.{digits}f}, {s['high']:.{digits}f}]"


def spread_text(s, digits=2):
    return "" if not s else f"{mean_text(s, digits)}; {s['median']:.{digits}f}; {s['worst']:.{digits}f}"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def failures_text(summary):
    """Number of pairs without an answer, and one of the reasons."""
    lost = ", ".join(f"{n} {status}" for status, n in summary["status"].items() if status != "answered")
    return f"{lost}, for example: {reason(summary['message'])}" if lost and summary["message"] else lost


def reason(message):
    """The first part of a message: the reason, without place and advice."""
    return message.strip().partition("\n")[0].removeprefix("homolog: ").partition(";")[0]
