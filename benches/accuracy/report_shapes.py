"""Sections of the report on surfaces given by formulas: symmetric solids without and with a bump, and analytic warps."""

import analytic
import scores
import symmetries
import verdicts
from plan import DEFAULT
from roles import role_of
from tables import TITLES, failures_text, mean_text, table

SAMPLINGS = [symmetries.sampling_of(index) for index in (0, 1)]


def solid_section(found):
    rows = []
    for group, kinds in symmetries.GROUPS.items():
        for name in kinds:
            cells = [
                counted(found, f"{first}_{name}", sampling, is_good)
                for first, is_good in (("solid", verdicts.gives_expected_reason), ("bumped", is_right_and_reliable))
                for sampling in SAMPLINGS
            ]
            if any(cells):
                wrong = sum(map(verdicts.is_wrong_yet_reliable, answers(found, f"bumped_{name}")))
                rows.append([name, group.upper(), role_of(f"solid_{name}"), *cells, str(wrong)])
    if not rows:
        return ""
    text = (
        "Solids whose dimensions, densities and poses differ between pairs, sampled twice. Without a bump no pose can be told "
        "from its symmetric ones, and the verdict must be `ambiguous_pose`; with one, the answer must be right (rotation within "
        f"{2 * verdicts.RIGHT_DEG}°) and reliable. Numbers of the program may be fitted on the sets of role fit alone.\n\n"
    )
    header = ["solid", "group", "role"]
    header += [f"`ambiguous_pose`, {sampling}" for sampling in SAMPLINGS]
    header += [f"with a bump: right and reliable, {sampling}" for sampling in SAMPLINGS]
    return "## Symmetric solids, and with a bump\n\n" + text + table([*header, "with a bump: wrong, reliable"], rows)


def answers(found, kind):
    return [
        r
        for r in found["records"]
        if r["method"] == DEFAULT and verdicts.kind_of(r) == kind and r["status"] == "answered"
    ]


def is_right_and_reliable(record):
    return bool(verdicts.is_right(record) and verdicts.is_reliable(record))


def counted(found, kind, sampling, is_good):
    """Number of pairs of a set with this sampling and a good verdict; a pair without an answer counts as having
    none."""
    is_so = lambda record: symmetries.sampling_of(int(record["case"].split("/")[1])) == sampling
    n = sum(r["method"] == DEFAULT and verdicts.kind_of(r) == kind and is_so(r) for r in found["records"])
    return f"{sum(map(is_good, filter(is_so, answers(found, kind))))} of {n}" if n else ""


def analytic_section(found):
    rows = []
    for kind in analytic.KINDS:
        summary, said = found["summaries"].get((DEFAULT, kind)), found["sets"].get(kind)
        if not summary:
            continue
        pooled, judged = said["calibration"], said["verdicts"]
        rows.append(
            [
                TITLES[kind],
                role_of(kind),
                str(said["n"]),
                mean_text(summary["w1"]),
                mean_text(summary["point_w1"]),
                mean_text(summary["point_err_edges"]),
                f"{pooled['confidence']:.3f}" if pooled else "",
                f"{pooled['error']:.3f} [{pooled['interval'][0]:.3f}, {pooled['interval'][1]:.3f}]" if pooled else "",
                mean_text(summary["beyond_2_spreads"], 3),
                f"{judged['right_reliable']} and {judged['wrong_reliable']}" if judged else "",
                failures_text(summary),
            ]
        )
    if not rows:
        return ""
    text = (
        "Smooth closed surfaces given by formulas and their copies after smooth warps, each side sampled on its own with its vertices "
        f"exactly on the surface. The kernels of the warps are {', '.join(map(str, analytic.WIDTHS))} diagonals wide in equal parts. "
        f"Errors beyond two stated spreads would be {scores.expected_beyond(2):.3f} of all if they were as the program assumes "
        "(Student's t with 8 degrees of freedom in the tangent plane).\n\n"
    )
    header = [
        "pairs",
        "role",
        "number",
        "within one edge",
        "points: within one edge",
        "points: error, edges",
        "mean confidence",
        "expected calibration error",
        "beyond two spreads",
        "right and wrong, `reliable`",
        "no answer",
    ]
    return "## Analytic surfaces without noise\n\n" + text + table(header, rows)
