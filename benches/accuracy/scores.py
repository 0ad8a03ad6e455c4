"""Scores of one answer, and their spread over cases."""

import numpy as np
from scipy.spatial import cKDTree

import geometry
import landmarked

N_BINS = 10
RESAMPLES = 2000
NEAR_SHARE = 0.05
"""Distance within which a point counts for `within_5_pct`, as a share of the target's diagonal."""
DEGREES_OF_FREEDOM = 8
"""Degrees of freedom of the errors assumed by the program: Student's t in the tangent plane."""


def expected_beyond(spreads, degrees=DEGREES_OF_FREEDOM):
    """Share of errors beyond `spreads` spreads under Student's t in a plane.

    With the scale s along each axis, an error is beyond r with the probability (1 + r² / (ν s²))^(−ν/2). A spread is
    the root mean square of the error's length, s √(2ν / (ν − 2)).
    """
    return (1 + 2 * spreads**2 / (degrees - 2)) ** (-degrees / 2)


def of_answer(cases, case, answer):
    """The generator's scores of an answer, and those of its sub-vertex points.

    A vertex without counterpart (-1) counts as wrong: it is scored with the target vertex farthest from the truth.
    """
    if landmarked.is_one(case):
        return landmarked.of_answer(case, answer)
    matrix = answer.get("matrix")
    transform = None if matrix is None else (matrix[:3, :3], matrix[:3, 3])
    vertex_map = answer.get("map")
    if vertex_map is not None and (vertex_map < 0).any():
        middle = case["V2"].mean(0)
        worst = int(np.linalg.norm(case["V2"] - middle, axis=1).argmax())
        vertex_map = np.where(vertex_map < 0, worst, vertex_map)
    if "R" not in case:
        transform = None
    labeled = "la" in case
    plain = case if labeled else {**case, "la": np.zeros(len(case["V1"])), "lb": np.zeros(len(case["V2"]))}
    found = cases.score(plain, transform, vertex_map)
    if not labeled:
        for name in ("label", "rigid_label"):
            found.pop(name, None)
    points = answer.get("points")
    if points is not None and "gtpos" in case:
        off = np.nan_to_num(np.linalg.norm(points - case["gtpos"], axis=1), nan=case["diag"])
        found["point_err_mm"] = float(off.mean())
        found["point_err_edges"] = found["point_err_mm"] / case["edge"]
        found["point_w1"] = float((off <= case["edge"]).mean())
        # A vertex without a point or a spread has no measurable error.
        stated = np.isfinite(points).all(1) & (answer.get("spread", np.zeros(len(points))) > 0)
        if stated.any():
            found["beyond_2_spreads"] = float((off[stated] > 2 * answer["spread"][stated]).mean())
    images = points if points is not None or vertex_map is None else case["V2"][vertex_map]
    if images is not None and "gtpos" in case:
        found.update(relative_errors(case, images))
    return {key: float(value) for key, value in found.items()}


def relative_errors(case, images):
    """Mean error in percent of two sizes of the target, and the share of images near the truth."""
    diagonal = geometry.diagonal(case["V2"])
    root = np.sqrt(geometry.face_areas(case["V2"], case["F2"]).sum())
    off = np.nan_to_num(np.linalg.norm(images - case["gtpos"], axis=1), nan=diagonal)
    return {
        "err_diag_pct": 100 * off.mean() / diagonal,
        "err_area_pct": 100 * off.mean() / root,
        "within_5_pct": (off <= NEAR_SHARE * diagonal).mean(),
    }


def of_case(case):
    """Figures of the pair itself, without any answer."""
    return landmarked.of_case(case) if landmarked.is_one(case) else {}


def reliability_bins(case, answer):
    """For each tenth of confidence: number of vertices, sum of confidences, number of vertices within one mean target
    edge of the truth."""
    if "confidence" not in answer or "map" not in answer or "gtpos" not in case:
        return None
    hit = np.linalg.norm(case["V2"][answer["map"]] - case["gtpos"], axis=1) <= case["edge"]
    hit &= answer["map"] >= 0
    confidence = np.clip(answer["confidence"], 0, 1)
    bins = np.minimum((confidence * N_BINS).astype(int), N_BINS - 1)
    count = lambda weights: np.bincount(bins, weights, N_BINS).tolist()
    return [count(np.ones(len(bins))), count(confidence), count(hit.astype(float))]


def calibration_error(bins):
    """Expected calibration error: mean over vertices of the difference between a bin's confidence and its share of
    hits."""
    n, confidence, hits = (np.array(row) for row in bins)
    return float(np.abs(confidence - hits).sum() / max(n.sum(), 1))


def calibration_interval(bins_of_pairs):
    """Bootstrap 95 % interval of the expected calibration error over pairs, within which errors of confidence are
    correlated."""
    bins = np.array(bins_of_pairs)
    draws = np.random.default_rng(0).integers(len(bins), size=(RESAMPLES, len(bins)))
    return [float(x) for x in np.quantile([calibration_error(bins[draw].sum(axis=0)) for draw in draws], [0.025, 0.975])]


def there_and_back(case, forth, back):
    """Distance between source vertices and their images under the forward and then the backward map, in mean source
    edges."""
    returned = back[np.maximum(forth, 0)]
    pairs = np.vstack([case["F1"][:, [0, 1]], case["F1"][:, [1, 2]], case["F1"][:, [2, 0]]])
    edge = np.linalg.norm(case["V1"][pairs[:, 0]] - case["V1"][pairs[:, 1]], axis=1).mean()
    off = np.linalg.norm(case["V1"][np.maximum(returned, 0)] - case["V1"], axis=1) / edge
    return np.where((forth < 0) | (returned < 0), np.inf, off)


def spread(values, higher_is_better):
    """Number, mean with its bootstrap 95 % interval over cases, median and worst value."""
    values = np.array(values, float)
    if not len(values):
        return None
    draws = np.random.default_rng(0).integers(len(values), size=(RESAMPLES, len(values)))
    low, high = np.quantile(values[draws].mean(1), [0.025, 0.975])
    return {
        "n": len(values),
        "mean": float(values.mean()),
        "low": float(low),
        "high": float(high),
        "median": float(np.median(values)),
        "worst": float(values.min() if higher_is_better else values.max()),
    }


def nearest_vertices(target, points):
    return cKDTree(target).query(points)[1]
