"""The sets `noise1000*`: about 1,000 vertices and noise on the target. They test whether wrong poses are reported
unreliable.

`noise1000` are copies of different hippocampi, `noise1000_bean` one synthetic bean in many poses with as many draws of
the noise. A pose is wrong if its rotation is off by more than 5 degrees.
"""

import numpy as np
from scipy.spatial.transform import Rotation

import geometry

KINDS = ["noise1000", "noise1000_bean"]
KEPT = True
N_VERTICES = 1000
NOISE_SHARE = 0.02


def names(cases, kind, n):
    return cases.first_of_genus_0(kind, n)


def make(cases, kind, index):
    index = int(index)
    if kind == "noise1000":
        case = cases.load(f"real_resample/{index}")
        turn = np.eye(3)
    else:
        case = cases.load("bean_plain/0")
        turn = Rotation.random(random_state=8800 + index).as_matrix()
    draws = np.random.default_rng(300 + index)
    new = {"R": turn @ case["R"], "t": turn @ case["t"], "genus0": case["genus0"]}
    for k in (1, 2):
        new[f"V{k}"], new[f"F{k}"] = geometry.decimated(case[f"V{k}"], case[f"F{k}"], N_VERTICES)
    new["V2"] = new["V2"] @ turn.T
    new["V2"] = new["V2"] + draws.normal(0, NOISE_SHARE * case["diag"], new["V2"].shape)
    return geometry.finished(new)
