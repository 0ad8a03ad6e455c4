"""From figures to tables: Markdown for readers, CSV with every figure and its spread, JSON with provenance."""

import csv
import json
import os

import numpy as np

import bodies
import parts
import report_sets
import report_shapes
import scores
import verdicts
from cases import CUT_SHARE, NOISE_SHARE, ROBUSTNESS
from peer_answers import write_peers
from peers import PEERS
from plan import ABLATION, DEFAULT, MANY, OURS, ROBUST_OURS, ROBUST_PEERS, ablated, read_variants
from reach import to_reach
from summary import CORRECT_DEG, summarize
from tables import TITLES, mean_text, spread_text, table, title

ENV_NOTE = "target/accuracy-env/missing-peers.txt"

def write(found, out):
    write_json(os.path.join(out, "pairs.json"), rounded(flattened(found)))
    write_json(os.path.join(out, "provenance.json"), found["provenance"])
    write_peers(os.path.join(out, "peers.csv"), found["records"])
    with open(os.path.join(out, "accuracy.csv"), "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["set", "method", "figure", "n", "mean", "low95", "high95", "median", "worst"])
        for (method, kind), summary in found["summaries"].items():
            for figure, s in summary.items():
                if isinstance(s, dict) and "mean" in s:
                    row = [s["n"], *(f"{s[k]:.6g}" for k in ("mean", "low", "high", "median", "worst"))]
                    table.writerow([kind, method, figure, *row])
    with open(os.path.join(out, "README.md"), "w") as file:
        file.write(markdown(found))


def write_json(path, document):
    with open(path, "w") as file:
        json.dump(document, file, separators=(",", ":"))
        file.write("\n")


def rounded(value):
    """A document with all numbers rounded to six digits, more than their precision."""
    if isinstance(value, dict):
        return {key: rounded(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(inner) for inner in value]
    return float(f"{value:.6g}") if isinstance(value, float) else value


def flattened(found):
    join = lambda table: {f"{method} | {kind}": row for (method, kind), row in table.items()}
    records = [{k: v for k, v in r.items() if k not in ("bins", "key")} for r in found["records"]]
    for record in records:
        if "message" in record:
            record["message"] = record["message"][-160:]
    return {
        **found,
        "summaries": join(found["summaries"]),
        "there_and_back": join(found["there_and_back"]),
        "records": records,
    }


def taken_text(found):
    taken = [r for r in found["records"] if r.get("taken_from")]
    if not taken:
        return ""
    names = lambda key: ", ".join(sorted({r[key] for r in taken}))
    return f" {len(taken)} answers of peers ({names('method')}) in sets without seconds are those of the report of {names('taken_from')}."


def markdown(found):
    p = found["provenance"]
    parts = [
        f"# Accuracy, {p['date']}\n",
        f"`{p['command']}`, {p['machine']}; {p['program']}; {p['n_label_volumes']} label volumes, "
        f"{p['cases_a_set']} pairs a set (three times as many re-sampled copies and pairs of two subjects, ten times as many "
        "of 1,000 vertices with noise; half as many in the sections on consistency, unlike pairs and ablation, there also "
        "three times as many of two subjects, and of symmetric solids and of each width of warps; of units and landmarks "
        "as their tables say).\n",
        "Each figure is the mean over pairs with its bootstrap 95 % interval; where three stand, they are the mean, "
        "the median and the worst. An edge is the mean edge length of the target. `accuracy.csv` has all figures, "
        "`pairs.json` (not in the repository) each pair; `benches/accuracy/README.md` says how they are made."
        + taken_text(found)
        + "\n",
        main_table(found),
        spread_section(found),
        robustness_section(found),
        report_sets.scale_section(found),
        report_sets.deformation_section(found),
        report_shapes.analytic_section(found),
        report_sets.body_section(found),
        report_sets.landmark_section(found),
        calibration_section(found),
        report_sets.calibration_section(found),
        consistency_section(found),
        unlike_section(found),
        report_sets.verdict_section(found),
        report_shapes.solid_section(found),
        ablation_section(found),
    ]
    return "\n".join(part for part in parts if part)


TO_REACH = ["goals of the project, two cores", "1.00", "0.42", "0.98", "0.46", "0.967", "0.12", "0.75", "", ""]


def main_table(found):
    at = lambda method, kind, figure: (found["summaries"].get((method, kind)) or {}).get(figure)
    base_seconds, base_peak = timing(found, DEFAULT)
    rows = []
    for method in [*OURS, *(PEERS if found["with_peers"] else [])]:
        if method in PEERS and PEERS[method].run is None:
            rows.append([title(method), f"not run: {why_missing(method)}", *[""] * 8])
            continue
        summary = [found["summaries"].get((method, kind)) for kind in ("real_warp4", "real_cross")]
        if not any(summary):
            rows.append([title(method), "not run this time", *[""] * 8])
            continue
        first = next(s for s in summary if s)
        if "answered" not in first["status"]:
            rows.append([title(method), f"{next(iter(first['status']))}: {first['message']}"[:150], *[""] * 8])
            continue
        seconds, peak = timing(found, method)
        rotation = at(method, "real_resample", "rot_deg")
        rows.append(
            [
                title(method),
                mean_text(at(method, "real_warp4", "w1")),
                mean_text(at(method, "real_warp4", "err_mm")),
                mean_text(at(method, "real_warp8", "w1")),
                mean_text(at(method, "real_warp8", "err_mm")),
                mean_text(at(method, "real_cross", "label"), 3),
                f"{rotation['median']:.2f}" if rotation else "",
                f"{seconds:.2f} ({seconds / base_seconds:.2f})" if seconds and base_seconds else "",
                f"{peak / 1e6:.0f} ({peak / base_peak:.2f})" if peak and base_peak else "",
                shares_within(found, method),
            ]
        )
    header = [
        "",
        "warp 4 %: within one edge",
        "warp 4 %: error, mm",
        "warp 8 %: within one edge",
        "warp 8 %: error, mm",
        "two subjects: label agreement",
        "copy: rotation error, deg (median)",
        "seconds a pair (median; multiple of homolog balanced)",
        "peak memory, MB (multiple of homolog balanced)",
        "pose within 10°: copies / two subjects",
    ]
    text = (
        "Our methods run as one command on two cores (`rigid` on one), their seconds and memory are those of the whole "
    )
    text += "process, files and all; a peer has one core, and its seconds begin when the surfaces are in its memory. "
    text += (
        "Vertex to vertex; sub-vertex answers are in the next table.\n\n"
    )
    own = [f"homolog {m} {s['median']:.2f} s" for m in OURS if (s := at(m, "real_warp4", "own_seconds"))]
    text += f"By the result's own clock (`timings_ms.total`, warp 4 %, median): {', '.join(own)}.\n"
    return "## Comparison with other programs\n\n" + table(header, [*rows, TO_REACH]) + "\n" + text


def timing(found, method):
    """Medians over all timed pairs."""
    kinds = ("real_warp4", "real_warp8", "real_cross", "real_resample")
    chosen = [
        r
        for r in found["records"]
        if r["method"] == method and r["status"] == "answered" and r["case"].split("/")[0] in kinds
    ]
    if not chosen:
        return None, None
    return float(np.median([r["seconds"] for r in chosen])), float(np.median([r["peak_bytes"] for r in chosen]))


def shares_within(found, method):
    shares = [(found["summaries"].get((method, k)) or {}).get("within_10_deg") for k in ("real_resample", "real_cross")]
    return " / ".join(f"{s['mean']:.2f}" if s else "" for s in shares)


def why_missing(method):
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", ENV_NOTE)
    try:
        with open(root) as file:
            for line in file:
                package, _, reason = line.rstrip("\n").partition("\t")
                if package == PEERS[method].package:
                    return f"no wheel of {package} for this machine"
    except OSError:
        pass
    return f"{PEERS[method].package} was not there when this was written"


def spread_section(found):
    rows = []
    for method in [*OURS, *(m for m in PEERS if PEERS[m].dense)]:
        for kind in ("real_warp4", "real_warp8"):
            summary = found["summaries"].get((method, kind))
            if summary and summary["w1"]:
                rows.append(
                    [
                        title(method),
                        TITLES[kind],
                        spread_text(summary["w1"]),
                        spread_text(summary["err_mm"]),
                        spread_text(summary["point_w1"]),
                        spread_text(summary["point_err_mm"]),
                        spread_text(summary["stretch"], 3),
                        spread_text(summary["cover"]),
                    ]
                )
    header = [
        "",
        "pairs",
        "within one edge",
        "error, mm",
        "points: within one edge",
        "points: error, mm",
        "edges torn to over 3 lengths",
        "target vertices hit",
    ]
    text = "Points are where a method moves a source vertex, before it is rounded to a vertex of the target.\n\n"
    return "## Dense answers: mean, median, worst\n\n" + text + table(header, rows) + "\n![](within_one_edge.png)\n"


def robustness_section(found):
    kinds = ["real_resample", "real_cross", "real_warp8", *ROBUSTNESS]
    rows = []
    for method in [*OURS, *(m for m in PEERS if m in ROBUST_PEERS)]:
        cells, any_cell = [], False
        for kind in kinds:
            summary = found["summaries"].get((method, kind))
            share = summary and summary.get("within_10_deg")
            if not share:
                cells.append("")
                continue
            any_cell = True
            refused = summary["status"].get("refused", 0)
            failed = summary["status"].get("failed", 0) + summary["status"].get("out of time", 0)
            note = (f", {refused} refused" if refused else "") + (f", {failed} failed" if failed else "")
            cells.append(f"{share['mean']:.2f}{note}")
        if any_cell and (method in ROBUST_OURS or method in ROBUST_PEERS):
            rows.append([title(method), *cells])
    text = (
        f"Share of pairs whose rotation is within {CORRECT_DEG}° of the truth, which for warps is the least-squares "
        "rigid part of the true map, and for two subjects trimmed ICP from the scanner pose, which favors ICP; a pair "
        "without an answer is a failure. "
        f"Noise: each coordinate of each target vertex moves by {NOISE_SHARE:.0%} of the diagonal (standard "
        f"deviation). Cut: {CUT_SHARE:.0%} of the target's area is gone at one end, so it is open. "
        "Half density: the target has half its vertices.\n\n"
    )
    return (
        "## Registration that must hold\n\n"
        + text
        + table(["", *(TITLES[k] for k in kinds)], rows)
        + "\n![](robustness.png)\n"
    )


def calibration_section(found):
    rows = [[f"homolog {m}", f"{c['error']:.3f}", str(c["n_pairs"])] for m, c in found["calibration"].items()]
    if not rows:
        return ""
    text = (
        "Confidence against the share of vertices within one edge of the truth, warps and copies together, in ten "
        "equal bins. The expected calibration error is the mean over vertices of how far a bin's mean confidence is "
        "from its share (0.05 at most is asked for).\n\n"
    )
    return (
        "## Calibration\n\n"
        + text
        + table(["", "expected calibration error", "pairs"], rows)
        + "\n![](reliability.png)\n"
    )


def consistency_section(found):
    rows = [
        [
            title(m),
            TITLES[k],
            spread_text(row["within_one_edge"]),
            to_reach("there_and_back", k) if m == DEFAULT else "",
            spread_text(row["median_edges"]),
        ]
        for (m, k), row in found["there_and_back"].items()
    ]
    if not rows:
        return ""
    text = (
        "Source and target exchanged, and the two maps put behind one another: how far from itself a source vertex "
        "comes back.\n\n"
    )
    header = [
        "",
        "pairs",
        "back within one edge: mean; median; worst",
        "to reach",
        "median distance, edges: mean; median; worst",
    ]
    return "## There and back\n\n" + text + table(header, rows)


def unlike_section(found):
    if not found["unlike"]:
        return ""
    rows = []
    for kind, said in found["unlike"].items():
        number = lambda name: "" if said[name] is None else f"{said[name]:.2f}"
        told = "; ".join(told_of(said["reliability"])) or "no such field"
        rows.append(
            [
                TITLES[kind],
                str(said["n"]),
                *(number(k) for k in ("mean_confidence", "outlier_share", "inlier_ratio", "surface_mean_mm")),
                told,
            ]
        )
    header = [
        "target",
        "pairs",
        "mean confidence",
        "share of outliers",
        "inlier ratio",
        "surface distance, mm",
        "`reliability`",
    ]
    text = (
        f"What the result of `{DEFAULT}` says (medians over pairs) where the target is the same structure, and where "
        "it is not.\n\n"
    )
    return "## Pairs that do not match\n\n" + text + table(header, rows)


def told_of(values, name=""):
    """A summary of one entry over several results: words with their counts, numbers by their median."""
    values = [v for v in values if v is not None]
    if values and isinstance(values[0], dict):
        return [text for key in values[0] for text in told_of([v.get(key) for v in values], f"{key} ")]
    words = [str(v) for v in values]
    numbers = [v for v in values if isinstance(v, (int, float)) and not isinstance(v, bool)]
    if numbers:
        return [f"{name}{np.median(numbers):.2f}"]
    return [f"{name}`{word[:60]}` {words.count(word)} of {len(words)}" for word in sorted(set(words))[:4]]


FIGURE_OF = {
    "real_cross": "label",
    **{kind: "err_diag_pct" for kind in bodies.KINDS},
    **{kind: "within_10_deg" for kind in parts.KINDS},
}
"""The figure of a set in the ablation; of other sets the share of vertices within one edge."""
FIGURE_TITLES = {
    "w1": "within one edge",
    "label": "label agreement",
    "err_diag_pct": "error, % of the diagonal",
    "within_10_deg": "pose within 10°",
}


def ablation_section(found):
    if not any(r["method"].startswith("variant: ") for r in found["records"]):
        return "## Ablation\n\nNot run for this report.\n"
    tables = [
        (road_table if group == "road" else ablation_table)(found, group, variants)
        for group, variants in read_variants().items()
    ]
    text = f"`{DEFAULT}` with one part changed (`benches/accuracy/variants.json`), on the same pairs.\n\n"
    return "## Ablation\n\n" + text + "\n\n".join(tables)


def road_table(found, group, variants):
    """The effect of each part of the route on each set: error, calibration error, verdicts, time."""
    rows = []
    for kind in ABLATION[group]:
        figure = FIGURE_OF.get(kind, "w1")
        for name in variants:
            of_set = [r for r in found["records"] if r["method"] == f"variant: {name}" and r["case"].split("/")[0] == kind]
            records = of_set[: ablated(found["n"], kind)]
            if not records:
                continue
            summary = summarize(records)
            answered = [r for r in records if r["status"] == "answered"]
            said = sum(bool((r.get("reliability") or {}).get("reliable")) for r in answered)
            wrong = sum(map(verdicts.is_wrong_yet_reliable, answered))
            gaps = [
                abs(r["mean_confidence"] - r["scores"]["point_w1"])
                for r in answered
                if "point_w1" in r["scores"] and r.get("mean_confidence") is not None
            ]
            rows.append(
                [
                    f"{TITLES[kind]}: {FIGURE_TITLES[figure]}" if name == next(iter(variants)) else "",
                    name,
                    mean_text(summary[figure], 3),
                    mean_text(scores.spread(gaps, False), 3) if gaps else "",
                    f"{said} of {len(records)}" + (f", {wrong} of them wrong" if wrong else ""),
                    mean_text(summary["cpu_seconds"]),
                ]
            )
    titles = ["set", "", "figure", "confidence off by", "reliable", "processor seconds"]
    text = (
        "Confidence is off by the mean over pairs of the difference between a pair's mean confidence and its share of corresponding "
        "points within one edge.\n\n"
    )
    return text + table(titles, rows)


def ablation_table(found, group, variants):
    kinds = ABLATION[group]
    figures = [FIGURE_OF.get(kind, "w1") for kind in kinds]
    rows = []
    # If the ablation has more pairs than the sections above, the default is one of its variants.
    of_default = {} if {} in variants.values() else {DEFAULT: {}}
    for name, parameters in {**of_default, **variants}.items():
        method = name if name == DEFAULT else f"variant: {name}"
        of_method = [r for r in found["records"] if r["method"] == method]
        cells = []
        for kind, figure in zip(kinds, figures):
            records = [r for r in of_method if r["case"].split("/")[0] == kind][: ablated(found["n"], kind)]
            summary = summarize(records) if records else None
            cells.append(mean_text(summary[figure], 3) if summary and summary[figure] else "refused" if summary else "")
        seconds = [r["seconds"] for r in of_method if r["status"] == "answered" and r["case"].split("/")[0] in kinds]
        change = json.dumps(parameters).strip("{}").replace('"', "")
        rows.append([name, f"`{change}`" if change else "", *cells, f"{np.median(seconds):.2f}" if seconds else ""])
    titles = [f"{TITLES[kind]}: {FIGURE_TITLES[figure]}" for kind, figure in zip(kinds, figures)]
    return table(["", "parameters", *titles, "seconds"], rows)
