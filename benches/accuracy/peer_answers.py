"""The answers of peers as a table, from which a later run takes those whose times are not reported."""

import csv

from peers import PEERS

# Figures of an answer of a peer that do not depend on the machine; `of_case` are those of the pair.
PEER_FIGURES = {
    "scores": [
        "rot_deg", "surf_mm", "cover", "stretch", "rigid_label", "label", "w1", "w2", "w5", "err_mm", "err", "err_diag_pct",
        "err_area_pct", "within_5_pct", "point_err_mm", "point_err_edges", "point_w1", "landmark_pct", "landmark_worst_mm",
    ],
    "of_case": ["landmark_rigid_pct", "landmark_floor_pct"],
}  # fmt: skip


def write_peers(path, records):
    """The answers of peers, without their times, for `--peers-of`."""
    with open(path, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["method", "case", "status", *(name for part in PEER_FIGURES.values() for name in part)])
        for record in records:
            if record["method"] in PEERS:
                figures = [
                    f"{record[part][name]:.6g}" if name in record.get(part, {}) else ""
                    for part, names in PEER_FIGURES.items()
                    for name in names
                ]
                table.writerow([record["method"], record["case"], record["status"], *figures])


def read_peers(path):
    """Answers of peers by method and case, from a table of `write_peers`."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    parts = lambda row: {p: {n: float(row[n]) for n in names if row[n]} for p, names in PEER_FIGURES.items()}
    return {(row["method"], row["case"]): {k: row[k] for k in ("method", "case", "status")} | parts(row) for row in rows}
