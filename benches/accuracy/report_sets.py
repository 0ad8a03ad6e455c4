"""Sections of the report on the sets other than real pairs: units, deformations, landmarks, verdicts, confidence."""

import numpy as np

import bodies
import capsules
import landmarked
import scaled
import scores
import warped
from coarse import KINDS as NOISY
from plan import DEFAULT, DENSE_PEERS
from reach import to_reach
from roles import role_of
from tables import TITLES, failures_text, mean_text, table, title
from verdicts import EXPECTED, RIGHT_DEG

DEFORMED = ["real_warp4", "real_warp8", "real_narrow2", "narrow4", *warped.WIDTH_KINDS, *capsules.KINDS]


def scale_section(found):
    rows, shares = [], []
    for kind in scaled.KINDS:
        records = [r for r in found["records"] if r["method"] == DEFAULT and r["case"].split("/")[0] == kind]
        if not records:
            continue
        cells = [f"{scaled.factor_of(kind):g}"]
        for origin in scaled.ORIGINS:
            chosen = [r for r in records if f"/{origin}-" in r["case"]]
            answered = [r["scores"] for r in chosen if r["status"] == "answered"]
            # For a pair without an answer the share of vertices within one edge is 0.
            share = sum(a["point_w1"] for a in answered) / len(chosen)
            shares.append((kind, origin, share))
            cells += [f"{share:.3f}", f"{max(a['rot_deg'] for a in answered):.2f}" if answered else ""]
        said = [r["reliability"]["reliable"] for r in records if isinstance(r.get("reliability"), dict)]
        rows.append([*cells, f"{sum(said)} of {len(records)}"])
    if not rows:
        return ""
    change = max_change(shares)
    text = (
        "The same pairs with all positions multiplied by a factor: an answer must not depend on it. Within one edge: "
        "corresponding points. "
        + (f"The largest difference in a column from factor 1 is {change:.3f}.\n\n" if change is not None else "\n\n")
    )
    header = [
        "factor",
        "copy: within one edge",
        "copy: rotation error, deg",
        "warps 8 %: within one edge (mean)",
        "warps 8 %: rotation error, deg (largest)",
        "`reliable`",
    ]
    return "## Units of length\n\n" + text + table(header, rows)


def max_change(shares):
    base = {origin: share for kind, origin, share in shares if scaled.factor_of(kind) == 1}
    return max((abs(share - base[origin]) for _, origin, share in shares), default=None) if base else None


def deformation_section(found):
    rows = []
    for kind in DEFORMED:
        for method in [DEFAULT, *DENSE_PEERS]:
            summary = found["summaries"].get((method, kind))
            if not summary:
                continue
            own = method == DEFAULT
            rows.append(
                [
                    TITLES[kind],
                    title(method),
                    str(sum(summary["status"].values())),
                    mean_text(summary["w1"]),
                    to_reach("within_one_edge", kind) if own else "",
                    mean_text(summary["point_w1"]),
                    mean_text(summary["point_err_edges"]),
                    mean_text(summary["err_mm"]),
                    mean_text(summary["mean_confidence"]),
                    mean_text(summary["beyond_2_spreads"], 3),
                    failures_text(summary),
                ]
            )
    if not rows:
        return ""
    text = (
        "Narrow warps have 60 kernels 0.06 to 0.09 of the diagonal wide, 2 % and 4 % RMS; the series of warps of 4 % "
        "differs in the width of its kernels alone. A capsule is bent along an arc in its middle part; the truth is "
        "known exactly. Points: before they are rounded to a vertex of the target. Beyond two spreads: share of points that are off "
        f"by more than two of their stated spreads; {scores.expected_beyond(2):.3f} if errors are as the program assumes.\n\n"
    )
    header = [
        "pairs",
        "",
        "number",
        "within one edge",
        "to reach",
        "points: within one edge",
        "points: error, edges",
        "error, mm",
        "mean confidence",
        "beyond two spreads",
        "no answer",
    ]
    return "## Deformations\n\n" + text + table(header, rows) + "\n![](width.png)\n"


def body_section(found):
    rows = []
    for kind in bodies.KINDS:
        said = found["sets"].get(kind)
        for method in [DEFAULT, *DENSE_PEERS]:
            summary = found["summaries"].get((method, kind))
            if not summary:
                continue
            judged = said["verdicts"] if method == DEFAULT and said else None
            rows.append(
                [
                    TITLES[kind],
                    title(method),
                    str(sum(summary["status"].values())),
                    mean_text(summary["err_diag_pct"]),
                    mean_text(summary["err_area_pct"]),
                    mean_text(summary["point_w1"] or summary["w1"]),
                    mean_text(summary["within_5_pct"]),
                    mean_text(summary["label"]),
                    f"{judged['right_reliable'] + judged['wrong_reliable']}" if judged else "",
                    failures_text(summary),
                ]
            )
    if not rows:
        return ""
    text = (
        "Bodies of solids around bones, of about 5,000 vertices: one surface near the rest pose, the other far from it. "
        "Errors are those of points before they are rounded to a vertex of the target, where a program gives such points, in "
        "percent of the target's diagonal and of the square root of its area. Same part: the bone that moves the source "
        "vertex most also moves the target vertex most; left and right are different parts.\n\n"
    )
    header = [
        "pairs",
        "",
        "number",
        "error, % of the diagonal",
        "error, % of the root of the area",
        "within one edge",
        "within 5 % of the diagonal",
        "same part",
        "`reliable`",
        "no answer",
    ]
    return "## Bodies in two poses\n\n" + text + table(header, rows)


def landmark_section(found):
    rows = []
    for kind in landmarked.KINDS:
        records = [r for r in found["records"] if r["method"] == DEFAULT and r["case"].split("/")[0] == kind]
        if not records:
            continue
        cell = lambda method: mean_text((found["summaries"].get((method, kind)) or {}).get("landmark_pct"), 1)
        of_pairs = lambda name: f"{np.mean([r['of_case'][name] for r in records]):.1f}"
        summary = found["summaries"][DEFAULT, kind]
        rows.append(
            [
                TITLES[kind],
                f"{summary['status'].get('answered', 0)} of {len(records)}",
                cell(DEFAULT),
                to_reach("landmark_pct", kind),
                *(cell(peer) for peer in DENSE_PEERS),
                of_pairs("landmark_rigid_pct"),
                of_pairs("landmark_floor_pct"),
                failures_text(summary),
            ]
        )
    if not rows:
        return ""
    text = (
        "Mean distance between the corresponding point of a landmark and the landmark that an expert placed on the "
        "target, in percent of the square root of the target's area. Means are over answered pairs; best rigid (the "
        "rigid transform that fits the landmarks themselves best) and nearest vertices (the least that vertices of "
        "the two surfaces allow) over all. People place such landmarks to about 1 to 2 %.\n\n"
    )
    header = [
        "pairs",
        "answered",
        title(DEFAULT),
        "to reach",
        *(title(peer) for peer in DENSE_PEERS),
        "best rigid",
        "nearest vertices",
        "no answer",
    ]
    return "## Landmarks on other structures, %\n\n" + text + table(header, rows)


def calibration_section(found):
    error = lambda pooled: f"{pooled['error']:.3f} [{pooled['interval'][0]:.3f}, {pooled['interval'][1]:.3f}]"
    rows = [
        [TITLES[kind], str(said["calibration"]["n_pairs"]), error(said["calibration"])]
        + [to_reach("calibration", kind), f"{said['calibration']['confidence']:.3f}", f"{said['calibration']['hits']:.3f}"]
        + [mean_text(found["summaries"][DEFAULT, kind]["beyond_2_spreads"], 3), role_of(kind)]
        for kind, said in found["sets"].items()
        if said["calibration"]
    ]
    if not rows:
        return ""
    header = ["pairs", "number", "expected calibration error", "to reach", "mean confidence", "share within one edge"]
    header += [f"beyond two spreads ({scores.expected_beyond(2):.3f} expected)", "role"]
    text = (
        "The intervals are over pairs. Vertices of one pair share what their confidences are off by, so few pairs have a calibration "
        "error even where confidences are right on average. Numbers of the program may be fitted on the sets of role fit alone.\n\n"
    )
    return f"### One set at a time, `{DEFAULT}`\n\n" + text + table(header, rows)


def verdict_section(found):
    rows = []
    for kind, said in found["sets"].items():
        if not said["verdicts"]:
            continue
        v = said["verdicts"]
        reason = ""
        if kind in EXPECTED:
            reason = f"{v['expected_reason']} ({EXPECTED[kind] or 'any'})"
        rows.append(
            [
                TITLES[kind],
                str(said["n"]),
                str(v["right_reliable"]),
                str(v["right_unreliable"]),
                str(v["wrong_reliable"]),
                to_reach("wrong_yet_reliable", kind),
                str(v["wrong_unreliable"]),
                str(v["no_answer"]),
                reason,
                to_reach("reason", kind),
                role_of(kind),
            ]
        )
    if not rows:
        return ""
    text = (
        "Whether `reliable` of the default method is true of right answers and false of wrong ones. A copy is right if "
        f"its rotation is within {RIGHT_DEG}°, a deformed pair if half of its vertices are within two edges of the "
        "truth, a pair of two subjects if its rotation is within 10° of an estimated truth, a solid with a bump if its rotation is "
        "within 10°. Symmetric and unlike pairs have no right answer; the reason that must be given stands in brackets.\n\n"
    )
    header = [
        "pairs",
        "number",
        "right, reliable",
        "right, not reliable",
        "wrong, reliable",
        "to reach",
        "wrong, not reliable",
        "no answer",
        "expected reason given",
        "to reach",
        "role",
    ]
    return "## Verdicts\n\n" + text + table(header, rows) + noise_text(found)


def noise_text(found):
    lines = []
    for kind in NOISY:
        said = found["sets"].get(kind)
        if said and said["verdicts"]:
            v = said["verdicts"]
            wrong = v["wrong_reliable"] + v["wrong_unreliable"]
            reach = to_reach("over_5_deg", kind)
            lines.append(
                f"{TITLES[kind].capitalize()} (2 % of the diagonal): {wrong + v['no_answer']} of {said['n']} poses are off "
                f"by more than {RIGHT_DEG}° or missing{f' (to reach: {reach})' if reach else ''}; "
                f"{v['wrong_reliable']} of them call themselves reliable."
            )
    return "\n" + "\n\n".join(lines) + "\n" if lines else ""
