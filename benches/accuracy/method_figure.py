"""The figure of docs/method.md: one match of two phantom subjects, from `homolog phantom` and `homolog match` alone.

target/accuracy-env/bin/python benches/accuracy/method_figure.py [OUT.png] [KEY=VALUE ...]
"""

import json
import os
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from scipy.spatial import cKDTree

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAIR = ["--kind", "surface", "--subject", "3", "--target-subject", "5", "--rotate-seed", "7"]
LIGHT = np.array([0.3, -0.5, 0.8]) / np.linalg.norm([0.3, -0.5, 0.8])


def read_ply(path):
    """Positions and triangles of a binary or ASCII PLY as this project writes it: vertices first, float or double."""
    with open(path, "rb") as file:
        head, _, body = file.read().partition(b"end_header\n")
    lines = head.decode().splitlines()
    n_vertices, n_faces = (int(line.split()[2]) for line in lines if line.startswith("element"))
    if "ascii" in lines[1]:
        rows = body.decode().splitlines()
        vertices = np.array([row.split()[:3] for row in rows[:n_vertices]], float)
        return vertices, np.array([row.split()[1:4] for row in rows[n_vertices : n_vertices + n_faces]], int)
    vertex = next(k for k, line in enumerate(lines) if line.startswith("element vertex"))
    sizes = {"double": "<f8", "float": "<f4", "float64": "<f8", "float32": "<f4"}
    names = []
    for line in lines[vertex + 1 :]:
        if not line.startswith("property"):
            break
        names.append((line.split()[2], sizes[line.split()[1]]))
    rows = np.frombuffer(body, np.dtype(names), n_vertices)
    vertices = np.stack([rows[axis] for axis in "xyz"], 1).astype(float)
    faces = np.frombuffer(body[rows.nbytes :], np.dtype([("n", "u1"), ("corners", "<i4", 3)]), n_faces)
    return vertices, faces["corners"].astype(int)


def matched(binary, folder, sets):
    subprocess.run([binary, "phantom", *PAIR, "--out", folder], check=True, stdout=subprocess.DEVNULL)
    files = [os.path.join(folder, f"{side}.ply") for side in ("source", "target")]
    command = [binary, "match", *files, "--json", *(f"--set={s}" for s in sets)]
    document = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    return *(read_ply(file) for file in files), document


def colors_of_place(vertices):
    """A color for each place: red along the first principal axis, green and blue along the others."""
    along = (vertices - vertices.mean(0)) @ np.linalg.svd(vertices - vertices.mean(0), full_matrices=False)[2].T
    share = (along - along.min(0)) / np.ptp(along, axis=0)
    # Bands along the structure, so that the eye sees where they go.
    bands = 0.82 + 0.18 * np.sign(np.sin(share[:, 0] * 9 * 2 * np.pi))
    return plt.cm.turbo(0.06 + 0.88 * share[:, 0])[:, :3] * bands[:, None] * (0.75 + 0.25 * share[:, 1:2])


def show(panel, vertices, faces, vertex_colors, box, title):
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    shade = 0.55 + 0.45 * np.clip(normals @ LIGHT, 0, 1)
    colors = vertex_colors[faces].mean(1) * shade[:, None]
    panel.add_collection3d(
        Poly3DCollection(corners, facecolors=np.clip(colors, 0, 1), edgecolors="none", linewidths=0, antialiaseds=False)
    )
    center = (vertices.max(0) + vertices.min(0)) / 2
    for k, limits in enumerate((panel.set_xlim, panel.set_ylim, panel.set_zlim)):
        limits(center[k] - box, center[k] + box)
    panel.set_box_aspect((1, 1, 1), zoom=1.6)
    panel.view_init(elev=35, azim=-60)
    panel.set_axis_off()
    panel.set_title(title, fontsize=11, y=0.93)


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "docs/method.png")
    binary = os.environ.get("HOMOLOG", os.path.join(ROOT, "target/release/homolog"))
    with tempfile.TemporaryDirectory() as folder:
        (source, source_faces), (target, target_faces), document = matched(binary, folder, sys.argv[2:])
    matrix = np.array(document["transform"]["matrix"], float).reshape(4, 4)
    table = document["correspondences"]
    images = np.zeros(len(source), int)
    images[table["source"]] = [0 if j is None else j for j in table["target"]]
    confidence = np.zeros(len(source))
    confidence[table["source"]] = table["confidence"]
    moved = source @ matrix[:3, :3].T + matrix[:3, 3]
    places = colors_of_place(source)
    # A target vertex takes the color of the source vertex whose image is nearest to it.
    carried = places[cKDTree(target[images]).query(target)[1]]
    figure = plt.figure(figsize=(13, 3.2))
    box = 0.5 * max(np.ptp(source, axis=0).max(), np.ptp(target, axis=0).max())
    panels = [figure.add_subplot(1, 4, k + 1, projection="3d") for k in range(4)]
    show(panels[0], source, source_faces, places, box, "source, as given")
    show(panels[1], moved, source_faces, places, box, "source, moved rigidly")
    show(panels[2], target, target_faces, carried, box, "target, colored by the map")
    low = min(0.5, float(confidence.min()))
    scale = plt.Normalize(low, 1)
    show(panels[3], moved, source_faces, plt.cm.viridis(scale(confidence))[:, :3], box, "confidence, on the source")
    figure.subplots_adjust(left=0, right=0.95, bottom=0, top=1, wspace=0)
    bar = figure.colorbar(plt.cm.ScalarMappable(scale, "viridis"), cax=figure.add_axes((0.955, 0.25, 0.01, 0.5)))
    bar.ax.tick_params(labelsize=8)
    figure.savefig(out, dpi=110, bbox_inches="tight")
    angle = document["transform"]["rotation_angle_deg"]
    print(f"{out}: rotation {angle:.1f} deg, mean confidence {confidence.mean():.2f}")


main()
