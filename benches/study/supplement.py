"""Writes the study of asymmetry with a known effect as a supplement of a paper would report it: tables, methods and a figure.

Usage: supplement.py OUT NAME, with the folder of `study.py --parts asymmetry` and the path of the result without `.md` and `.png`."""

import csv
import html
import json
import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.append(str(Path(__file__).parent.parent / "accuracy"))
from geometry import vertex_areas
from running import document
from surfaces import gifti, maps, patch

MEASURES = {
    "normal_displacement": "normal displacement, mm",
    "thickness": "local thickness, mm",
    "log_area": "logarithm of local area",
}
PATCH_MM = 12.0


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def markdown(head, lines):
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in [head, ["---"] * len(head), *lines])


def p_value(p):
    return "< 0.001" if p < 0.001 else f"{p:.3f}"


def spread_of(values):
    mean, digits = np.mean(values), 2 if np.mean(values) < 100 else 0
    return f"{mean:.{digits}f} ± {np.std(values, ddof=1):.{digits}f}"


def methods(folder):
    """What the program's own report says of how the study was done."""
    page = (folder / "report.html").read_text()
    section = page[page.index(">Methods<") + len(">Methods<"):]
    paragraphs = re.findall(r"<p[^>]*>(.*?)</p>", section, flags=re.S)
    texts = [" ".join(html.unescape(re.sub(r"<[^>]+>", "", each)).split()) for each in paragraphs]
    return "\n\n".join(each for each in texts if each and not each.startswith(("In the parameters", "All parameters", "{")))


def crossings(points, values, faces, level):
    """The line on which linearly interpolated values reach a level: a segment for each face that it crosses."""
    segments = []
    for face in faces[(values[faces] > level).any(1) & (values[faces] <= level).any(1)]:
        ends = []
        for i, j in zip(face, np.roll(face, 1)):
            if (values[i] > level) != (values[j] > level):
                share = (level - values[i]) / (values[j] - values[i])
                ends.append(points[i] + share * (points[j] - points[i]))
        segments.append(ends)
    return segments


def figure(folder, path):
    """The effect of each measure on the mean surface, from above and from below; what is not significant is pale."""
    vertices, faces = gifti(folder / "mean.surf.gii")
    weight = patch(vertices.astype(float), PATCH_MM)
    vertices = vertices.astype(float) - vertices.mean(0)
    # The long axis lies horizontally and the middle axis vertically.
    _, axes = np.linalg.eigh(np.cov(vertices.T))
    axes = axes[:, ::-1] * [1, 1, np.sign(np.linalg.det(axes[:, ::-1]))]
    flat = vertices @ axes
    panels, views = plt.subplots(2, 3, figsize=(11, 5.2))
    a, b, c = (flat[faces[:, k]] for k in range(3))
    facing = np.cross(b - a, c - a)
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    for column, (measure, title) in enumerate(MEASURES.items()):
        arrays = maps(folder, f"{measure}.right-left")
        limit = np.percentile(np.abs(arrays["effect"]), 99)
        for row, sign in enumerate((1, -1)):
            view = views[row, column]
            seen = np.where(sign * facing[:, 2] > 0)[0]
            seen = seen[np.argsort(sign * flat[faces[seen], 2].mean(1))]
            colors = plt.cm.RdBu_r(0.5 + 0.5 * np.clip(arrays["effect"][faces[seen]].mean(1) / limit, -1, 1))[:, :3]
            significant = (arrays["p_local"][faces[seen]] < 0.05).mean(1)[:, None] > 0.5
            shade = 0.55 + 0.45 * sign * facing[seen, 2:3]
            colors = np.where(significant, colors, 0.75 + 0.25 * colors) * shade
            corners = flat[faces[seen]][:, :, :2] * [sign, 1]
            view.add_collection(matplotlib.collections.PolyCollection(corners, facecolors=colors, edgecolors=colors, linewidths=0.3))
            border = crossings(flat[:, :2] * [sign, 1], weight, faces[seen], 0.5)
            view.add_collection(matplotlib.collections.LineCollection(border, colors="black", linewidths=1))
            view.set_aspect("equal")
            view.autoscale()
            view.axis("off")
        views[0, column].set_title(f"{title}\nright − left, ±{limit:.2f}", fontsize=10)
    panels.tight_layout()
    panels.savefig(path, dpi=80, metadata={"Software": None})


def main(out, name):
    folder, figures = out / "asymmetry-known", json.loads((out / "figures.json").read_text())
    study, known = document(folder), figures["asymmetry known"]
    vertices, faces = gifti(folder / "mean.surf.gii")
    areas = vertex_areas(vertices.astype(float), faces)
    subjects, effects, model, quality = (rows(folder / f"{each}.csv") for each in ("subjects", "effects", "model", "quality"))
    side = lambda key, which: spread_of([float(row[key]) for row in subjects if row["side"] == which])
    whole = {"volume_mm3": "volume, mm³", "area_mm2": "area, mm²", "centroid_size_mm": "centroid size, mm"}
    table_1 = markdown(["", "left", "right"], [[title, side(key, "left"), side(key, "right")] for key, title in whole.items()])
    lines = []
    for row in effects:
        effect, low, high, g, g_low, g_high = (float(row[key]) for key in ("effect", "low", "high", "hedges_g", "g_low", "g_high"))
        lines.append([row["variable"], f"{effect:.2f} ({low:.2f} to {high:.2f})", p_value(float(row["p"])), f"{g:.2f} ({g_low:.2f} to {g_high:.2f})"])
    table_2 = markdown(["variable", "right − left (95 % interval)", "p", "Hedges' g (95 % interval)"], lines)
    lines = []
    for measure, title in MEASURES.items():
        arrays, of, none = maps(folder, f"{measure}.right-left"), figures[f"asymmetry known {measure}"], figures[f"asymmetry none {measure}"]
        share = areas[arrays["p_local"] < 0.05].sum() / areas.sum()
        lines.append([title, p_value(of["smallest_p_tfce"]), f"{100 * share:.1f} %", of["effect_in_patch_mm"], of["median_se"],
                      of["sensitivity"], of["false_discoveries"], p_value(none["smallest_p_tfce"])])
    table_3 = markdown(["measure", "smallest corrected p", "of the surface significant", "effect in the patch", "standard error there",
                        "of the patch found", "found outside", "smallest p without the effect"], lines)
    table_4 = markdown(["modes", "compactness", "generalization, mm", "specificity, mm"],
                       [[m["modes"], f"{float(m['compactness']):.3f}", f"{float(m['generalization_mm']):.3f}", f"{float(m['specificity_mm']):.3f}"]
                        for m in model if int(m["modes"]) in (1, 2, 5, 10)])
    residuals = [float(row["residual_mm"]) for row in quality]
    flagged = [row for row in quality if row["flags"]]
    figure(folder, name.with_suffix(".png"))
    name.with_suffix(".md").write_text(f"""# Supplement: left against right in {known["pairs"]} made-up pairs with a known effect

What a paper would report of a study of asymmetry by `homolog study --effect side`, where the truth is known. {figures["run"]["version"]},
{figures["run"]["machine"]}. `make study PARTS=asymmetry DATA=dir` computes it again and writes this page.

## Data

{known["pairs"]} hippocampi from label volumes, each sampled twice on grids half a voxel apart and each side deformed by a random smooth displacement of
its own (Gaussian process, width 12 mm, standard deviation 0.3 mm), so that the two sides differ as two sides of a person might, without
a mean difference. The right side is thinned by up to 0.5 mm in a patch of {PATCH_MM:.0f} mm around the highest point of the middle of the structure ({-known["put_in_patch_mm"]:.2f} mm
on average where it moves by more than half), and mirrored. The same pairs without the patch are the control.

**Table 1.** Mean ± standard deviation of {len(subjects) // 2} surfaces a side.

{table_1}

## Methods, as the program's report states them

{methods(folder)}

## Quality control

{sum(row["place"] == "model" for row in quality)} of {len(quality)} surfaces are in the model; {len(flagged)} were flagged ({", ".join(sorted({flag for row in flagged for flag in row["flags"].split("; ")}))})
and kept. Mean distance from a subject's surface to the template deformed onto it: {np.mean(residuals):.3f} mm, at most {max(residuals):.3f} mm. The template has
{len(vertices)} vertices. Shape model, leave-one-out:

{table_4}

## Results

**Table 2.** Whole structures. Only the volume and what follows from it should differ.

{table_2}

**Table 3.** At vertices: p corrected for the whole surface by threshold-free cluster enhancement with {study["settings"]["analysis"]["permutations"]} sign flips.
A vertex is significant where this p and the false discovery rate are both below 0.05. Of the patch found: share of the vertices that move by
more than half and are significant. Found outside: of all significant vertices, the share that does not move at all. The measures are not corrected for one another.

{table_3}

![Effects on the mean surface]({name.name}.png)

**Figure.** Effect on the mean surface, seen along its shortest axis from both ends: blue inwards, thinner or smaller on the right. Pale: not
significant. Line: where the patch moves by half of its depth.
""")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
