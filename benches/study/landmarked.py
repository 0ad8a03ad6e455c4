"""Specimens with landmarks that people placed, as files for `homolog study`, and the maps that a study finds of them."""

import csv
from pathlib import Path

import numpy as np

from running import run, table
from surfaces import gifti, write_ply


def moved_onto(source, target, weights, reflected=False):
    """The source without its size, rotated onto the target without its size; the remaining distance."""
    def plain(points):
        points = points - weights @ points
        return points / np.sqrt(weights @ (points**2).sum(1))
    source, target = plain(source), plain(target)
    u, singular, v = np.linalg.svd((source * weights[:, None]).T @ target)
    signs = np.ones(3)
    signs[2] = np.sign(np.linalg.det(u @ v)) * (-1 if reflected else 1)
    return 2 - 2 * float(singular @ signs)


class Specimens:
    """Those of one kind: a table for `homolog study`, and their landmarks in the coordinates of the first one's side."""

    def __init__(self, place, kind, out):
        self.out, self.rows, self.landmarks = Path(out), [], []
        (self.out / "surfaces").mkdir(parents=True, exist_ok=True)
        for path in sorted(Path(place, kind).glob("*.npz")):
            data = np.load(path)
            vertices, faces, marks = (data[key].astype(of) for key, of in (("V", float), ("F", int), ("L", float)))
            equal = np.full(len(marks), 1 / len(marks))
            first = self.landmarks[0] if self.landmarks else marks
            # Of the two, the side whose landmarks fit those of the first specimen.
            same, other = (moved_onto(marks, first, equal, reflected) for reflected in (False, True))
            side = "left" if same <= other else "right"
            self.landmarks.append(marks * ([1, 1, 1] if side == "left" else [-1, 1, 1]))
            file = (self.out / "surfaces" / f"{path.stem}.ply").resolve()
            write_ply(file, vertices, faces)
            self.rows.append({"id": path.stem, "file": file, "side": side})
        if len({row["side"] for row in self.rows}) == 1:
            for row in self.rows:
                del row["side"]
        self.names = [row["id"] for row in self.rows]

    def study(self, binary, folder, *options):
        """The mean, the faces, and the template on each specimen, of a study in this folder; missing ones are None."""
        run([binary, "study", table(self.out / "specimens.csv", self.rows), "--out", folder, *options])
        mean, faces = gifti(folder / "mean.surf.gii")
        maps = []
        for row in self.rows:
            path = folder / f"subjects/{row['id']}.surf.gii"
            # Surfaces are in the coordinates of their files: those of the other side are mirrored again.
            side = np.array([-1 if row.get("side") == "right" else 1, 1, 1])
            maps.append(gifti(path)[0].astype(float) * side if path.exists() else None)
        return mean.astype(float), faces, maps


def quality(folder, names):
    """The row of each specimen in the quality control of the study in this folder."""
    rows = {row["id"]: row for row in csv.DictReader(open(folder / "quality.csv"))}
    return [rows[name] for name in names]
