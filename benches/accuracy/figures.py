"""The figures of the report."""

import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from cases import ROBUSTNESS
from peers import PEERS
from plan import DEFAULT, DENSE_PEERS, OURS, ROBUST_OURS, ROBUST_PEERS
from warped import RMS_SHARE, WIDTH_KINDS, WIDTHS

OUR_COLOR, PEER_COLOR, TARGET_COLOR = "#1b6ca8", "#9aa5ae", "#c0392b"
TO_REACH = {"real_warp4": 0.88, "real_warp8": 0.65}
NAMES = {
    "icp": "multi-start ICP",
    "bcpd": "BCPD",
    "cpd": "CPD",
    "functional_maps": "functional maps",
    "lattice": "pose lattice",
    "fgr": "FGR",
    "ransac": "RANSAC on FPFH",
    "kiss": "KISS-Matcher",
}


def draw(found, out):
    within_one_edge(found, os.path.join(out, "within_one_edge.png"))
    robustness(found, os.path.join(out, "robustness.png"))
    if any((DEFAULT, kind) in found["summaries"] for kind in WIDTH_KINDS):
        width(found, os.path.join(out, "width.png"))
    if found["calibration"]:
        reliability(found, os.path.join(out, "reliability.png"))


def saved(figure, path):
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)


def within_one_edge(found, path):
    """Every pair is a dot, the mean a bar."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 4), sharex=True)
    methods = [*(m for m in reversed(PEERS) if PEERS[m].dense), *reversed(OURS)]
    methods = [m for m in methods if any((m, k) in found["summaries"] for k in TO_REACH)]
    for panel, (kind, reach) in zip(panels, TO_REACH.items()):
        for y, method in enumerate(methods):
            values = [
                r["scores"]["w1"]
                for r in found["records"]
                if r["method"] == method and r["case"].split("/")[0] == kind and "w1" in r.get("scores", {})
            ]
            if values:
                color = OUR_COLOR if method in OURS else PEER_COLOR
                panel.barh(y, np.mean(values), color=color, alpha=0.55, height=0.7)
                panel.plot(values, np.full(len(values), y), ".", color=color, markersize=7, markeredgewidth=0)
        panel.axvline(reach, color=TARGET_COLOR, linewidth=1, linestyle="--")
        panel.set_yticks(range(len(methods)), [NAMES.get(m, f"homolog {m}") for m in methods])
        panel.set_xlim(0, 1)
        panel.set_title(f"smooth warp of {kind[-1]} % of the diagonal")
        panel.set_xlabel("vertices within one edge of the truth (dashed: to reach)")
    panels[1].set_yticklabels([])
    saved(figure, path)


def robustness(found, path):
    """Shares within 10 degrees, in a grid of methods and conditions."""
    kinds = ["real_resample", "real_cross", "real_warp8", *ROBUSTNESS]
    methods = [m for m in [*ROBUST_OURS, *ROBUST_PEERS] if any((m, k) in found["summaries"] for k in kinds)]
    shares = np.full((len(methods), len(kinds)), np.nan)
    refused = np.zeros(shares.shape, int)
    for i, method in enumerate(methods):
        for j, kind in enumerate(kinds):
            share = (found["summaries"].get((method, kind)) or {}).get("within_10_deg")
            if share:
                shares[i, j] = share["mean"]
                refused[i, j] = found["summaries"][method, kind]["status"].get("refused", 0)
    figure, panel = plt.subplots(figsize=(11, 0.55 * len(methods) + 1.6))
    panel.imshow(shares, vmin=0, vmax=1, cmap="RdYlGn", aspect="auto", alpha=0.75)
    for i, j in np.argwhere(~np.isnan(shares)):
        note = f"\n{refused[i, j]} refused" if refused[i, j] else ""
        panel.text(j, i, f"{shares[i, j]:.2f}{note}", ha="center", va="center", fontsize=9)
    panel.set_xticks(range(len(kinds)), [k.replace("real_", "").replace("_", "\n") for k in kinds], fontsize=9)
    panel.set_yticks(range(len(methods)), [NAMES.get(m, f"homolog {m}") for m in methods])
    panel.set_title("share of pairs whose rotation is within 10° of the truth")
    saved(figure, path)


def width(found, path):
    """Share within one edge against the width of a warp's kernels, and the mean confidence."""
    figure, panel = plt.subplots(figsize=(7, 4))
    lines = [(DEFAULT, "point_w1", "-", "homolog, points"), (DEFAULT, "w1", ":", "homolog, vertices")]
    lines += [(DEFAULT, "mean_confidence", "--", "homolog, mean confidence")]
    lines += [(peer, "w1", "-", f"{NAMES[peer]}, vertices") for peer in DENSE_PEERS]
    for method, name, style, label in lines:
        spreads = [(found["summaries"].get((method, kind)) or {}).get(name) for kind in WIDTH_KINDS]
        points = [(x, s["mean"], s["low"], s["high"]) for x, s in zip(WIDTHS, spreads) if s]
        if not points:
            continue
        x, mean, low, high = np.array(points).T
        color = TARGET_COLOR if name == "mean_confidence" else OUR_COLOR if method in OURS else PEER_COLOR
        alpha = 0.5 if method == "icp" else 1
        panel.plot(x, mean, style, color=color, alpha=alpha, marker=".", label=label)
        if name != "w1":
            panel.fill_between(x, low, high, color=color, alpha=0.12, linewidth=0)
    panel.set_xscale("log")
    panel.set_xticks(WIDTHS, [f"{width:g}" for width in WIDTHS])
    panel.minorticks_off()
    panel.set_ylim(0, 1.02)
    panel.set_xlabel("standard deviation of the kernels, share of the diagonal")
    panel.set_ylabel("share of vertices within one edge; mean confidence")
    panel.set_title(f"warps of {RMS_SHARE:.0%} of the diagonal")
    panel.legend(frameon=False)
    saved(figure, path)


def reliability(found, path):
    """Reliability diagrams; below them the number of vertices in each bin."""
    methods = [m for m in [DEFAULT, *OURS] if m in found["calibration"]]
    methods = list(dict.fromkeys(methods))
    figure, panels = plt.subplots(
        2,
        len(methods),
        figsize=(3.1 * len(methods) + 0.5, 4.3),
        sharex=True,
        sharey="row",
        squeeze=False,
        height_ratios=[3, 1],
    )
    for (top, bottom), method in zip(panels.T, methods):
        n, confidence, hits = np.array(found["calibration"][method]["bins"])
        full = n > 0
        top.plot([0, 1], [0, 1], color="black", linewidth=0.8, linestyle=":")
        at, share = confidence[full] / n[full], hits[full] / n[full]
        top.plot(at, share, color=OUR_COLOR, linewidth=0.8, alpha=0.5)
        # The area of a dot is the share of vertices in its bin.
        top.scatter(at, share, s=8 + 200 * n[full] / n.sum(), color=OUR_COLOR, clip_on=False, zorder=3, linewidths=0)
        top.set_title(f"{method}: error {found['calibration'][method]['error']:.3f}")
        top.set_xlim(0, 1)
        top.set_ylim(0, 1)
        bottom.bar((np.arange(len(n)) + 0.5) / len(n), n / n.sum(), width=0.9 / len(n), color=PEER_COLOR)
        bottom.set_xlabel("confidence")
    panels[0, 0].set_ylabel("share within one edge")
    panels[1, 0].set_ylabel("share of vertices")
    saved(figure, path)
