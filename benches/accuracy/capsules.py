"""The sets `bent_*`: a straight capsule and a copy whose middle part is bent along a circular arc.

The capsule lies along x; lengths in mm. Bumps at fixed places break its symmetries. The bend keeps the length of the
center line and the cross-sections, so the corresponding point of each source vertex is known exactly.
"""

import numpy as np
from scipy.spatial.transform import Rotation

import geometry
import implicit

ANGLES_DEG = [90, 120, 150]
KINDS = [f"bent_{angle}" for angle in ANGLES_DEG]
KEPT = True
HALF_LENGTH, RADIUS = 20.0, 5.0
"""Half length and radius of the cylinder, mm, without the half-spheres at its ends."""
BENT_LENGTH = 24.0
"""Length of the bent part, mm. At 150 degrees the radius of the arc is 9.2 mm, so the inner side does not reach its
center."""
BUMPS = [
    # Position along x, angle about the axis, height, width (standard deviation).
    (-17.0, 20.0, 1.5, 2.5),
    (-9.0, 150.0, 1.2, 2.5),
    (3.0, 260.0, 1.3, 3.0),
    (13.0, 80.0, 1.0, 2.0),
    (21.0, 200.0, 1.5, 2.5),
]


def names(cases, kind, n):
    return cases.first_of_genus_0(kind, n)


def outside(points):
    """Distance to the capsule minus the height of the bumps."""
    ends = np.clip(points[:, 0], -HALF_LENGTH, HALF_LENGTH)
    away = points - np.stack([ends, np.zeros(len(points)), np.zeros(len(points))], 1)
    field = np.linalg.norm(away, axis=1) - RADIUS
    for along, angle, height, width in BUMPS:
        angle = np.radians(angle)
        center = np.array([along, RADIUS * np.cos(angle), RADIUS * np.sin(angle)])
        field -= height * np.exp(-((points - center) ** 2).sum(1) / (2 * width**2))
    return field


class Bend:
    """Bends the x axis to a straight line, an arc in the plane of x and y, and a straight line."""

    def __init__(self, angle):
        self.half, self.radius = angle / 2, BENT_LENGTH / angle
        self.center = np.array([0.0, self.radius])

    def arm(self, side):
        """The end of the arc at x > 0 (`side` 1) or x < 0 (-1), and the directions along and across the axis there."""
        phi = side * self.half
        end = self.center + self.radius * np.array([np.sin(phi), -np.cos(phi)])
        return end, np.array([np.cos(phi), np.sin(phi)]), np.array([-np.sin(phi), np.cos(phi)])

    def forward(self, points):
        x, y = points[:, 0], points[:, 1]
        phi = np.clip(x / self.radius, -self.half, self.half)
        rest = x - self.radius * phi
        along = np.stack([np.cos(phi), np.sin(phi)], 1)
        across = np.stack([-np.sin(phi), np.cos(phi)], 1)
        on_axis = self.center - self.radius * across
        return np.column_stack([on_axis + rest[:, None] * along + y[:, None] * across, points[:, 2]])

    def sources(self, points):
        """Up to three preimages of each point: on the arc and on the two arms; NaN for a missing one."""
        flat, z = points[:, :2], points[:, 2]
        away = flat - self.center
        phi = np.arctan2(away[:, 0], -away[:, 1])
        arc = np.column_stack([self.radius * phi, self.radius - np.linalg.norm(away, axis=1), z])
        yield np.where((np.abs(phi) <= self.half)[:, None], arc, np.nan)
        for side in (1, -1):
            end, along, across = self.arm(side)
            rest = (flat - end) @ along
            arm = np.column_stack([side * BENT_LENGTH / 2 + rest, (flat - end) @ across, z])
            yield np.where((side * rest >= 0)[:, None], arm, np.nan)


def make(cases, kind, index):
    index = int(index)
    angle_deg = int(kind.removeprefix("bent_"))
    bend = Bend(np.radians(angle_deg))
    draws = np.random.default_rng([angle_deg, index])
    turns = [Rotation.random(random_state=draws.integers(2**31)).as_matrix() for _ in range(3)]
    # The direction of the bend, relative to the bumps.
    roll = Rotation.from_euler("x", draws.uniform(0, 2 * np.pi)).as_matrix()
    bent = lambda points: bend.forward(points @ roll.T)
    vertices, faces = implicit.surface(outside, 28.0, 1.0, turns[0], draws.uniform(0, 1, 3))

    def outside_bent(points):
        return np.fmin.reduce([outside(known @ roll) for known in bend.sources(points)])

    others, other_faces = implicit.surface(
        lambda points: np.nan_to_num(outside_bent(points), nan=50.0), 32.0, 1.0, turns[1], draws.uniform(0, 1, 3)
    )
    turn, shift = turns[2], draws.normal(size=3) * 20
    new = dict(V1=vertices, F1=faces, V2=others @ turn.T + shift, F2=other_faces)
    new["gtpos"] = bent(vertices) @ turn.T + shift
    new["R"], new["t"] = cases.real.kabsch(vertices, new["gtpos"])
    new["genus0"] = bool(cases.real.genus0(vertices, faces) and cases.real.genus0(others, other_faces))
    return geometry.finished(new)
