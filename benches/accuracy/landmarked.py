"""The sets `landmarked_*`: structures other than hippocampi, with manual landmarks.

The pairs come from the unmodified `landmarked_cases.py` in EVAL. A landmark of the source is moved with the nearest
source vertex; its error is the distance between the corresponding point and the landmark of the target, in percent of
the square root of the target's area.
"""

import importlib.util
import os

import numpy as np

import geometry

COUNTS = {"femur": 10, "molar": 12, "molar_equal_size": 12, "vertebra": 5, "mouse_skull": 5}
"""Sets, and the most pairs of each. `molar_equal_size`: the source is scaled to the target's area."""
KINDS = [f"landmarked_{name}" for name in COUNTS]
KEPT = False


def generator():
    return importlib.import_module("landmarked_cases")


def folder(cases):
    return os.path.join(cases.data, "landmarked")


def structure_of(kind):
    return kind.removeprefix("landmarked_").removesuffix("_equal_size")


def names(cases, kind, n):
    most = COUNTS[kind.removeprefix("landmarked_")]
    return [f"{kind}/{k}" for k in range(min(n, most, count(cases, structure_of(kind))))]


def count(cases, structure):
    """Number of pairs of a structure; zero if the data or their generator are missing."""
    if not os.path.isdir(os.path.join(folder(cases), structure)) or not importlib.util.find_spec("landmarked_cases"):
        return 0
    return len(generator().load_pairs(structure, folder(cases)))


def make(cases, kind, index):
    structure = structure_of(kind)
    a, b = generator().load_pairs(structure, folder(cases))[int(index)]
    case = generator().load_case(structure, a, b, folder(cases))
    for k in (1, 2):
        case[f"V{k}"], case[f"F{k}"] = geometry.without_missing_positions(case[f"V{k}"], case[f"F{k}"])
    if kind.endswith("_equal_size"):
        factor = case["root"] / generator().root_area(case["V1"], case["F1"])
        center = case["V1"].mean(0)
        for name in ("V1", "L1"):
            case[name] = center + factor * (case[name] - center)
    return case


def is_one(case):
    return "L1" in case


def of_case(case):
    """Error of the best rigid transform of the landmarks, and error that comes from nearest vertices alone."""
    return {
        "landmark_rigid_pct": generator().rigid(case)["mean_pct"],
        "landmark_floor_pct": generator().floor(case)["mean_pct"],
    }


def of_answer(case, answer):
    images = answer.get("points")
    if images is None:
        if "map" not in answer:
            return {}
        images = case["V2"][np.maximum(answer["map"], 0)]
    # A vertex without a corresponding point counts as one whose image is the center of the target.
    lost = ~np.isfinite(images).all(1)
    if "map" in answer:
        lost |= answer["map"] < 0
    images = np.where(lost[:, None], case["V2"].mean(0), images)
    found = generator().score(case, images)
    return {"landmark_pct": found["mean_pct"], "landmark_worst_mm": found["worst_mm"]}
