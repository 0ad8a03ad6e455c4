"""Bodies for `bodies.py`: bones with joints, the solids around them, and the ranges of the joints.

Axes of the rest pose: x to the body's left, y up, z to the front; lengths in mm. Bodies are bilaterally symmetric: the
left side is specified and mirrored. Front and back differ (nose, belly, feet, thumbs), so left and right can be told
apart as in a real body.
"""

import dataclasses

import numpy as np
from scipy.special import logsumexp

MIRROR = np.array([-1.0, 1.0, 1.0])


@dataclasses.dataclass
class Bone:
    """A rigid part that rotates about its joint, which belongs to its parent."""

    name: str
    parent: int
    joint: np.ndarray
    axis: np.ndarray
    """Unit vector along the bone."""
    group: str
    """Bones of one group, left and right alike, get the same factors of length and thickness."""


@dataclasses.dataclass
class Solid:
    """A tapered capsule from `a` to `b`, or an ellipsoid about `a` if `radii` has three entries."""

    bone: int
    a: np.ndarray
    b: np.ndarray
    radii: np.ndarray

    def distances(self, points):
        """Approximate signed distance, negative inside."""
        if len(self.radii) == 3:
            away = points - self.a
            scaled = np.linalg.norm(away / self.radii, axis=1)
            steep = np.linalg.norm(away / self.radii**2, axis=1)
            return scaled * (scaled - 1) / np.maximum(steep, 1e-9)
        along = self.b - self.a
        t = np.clip((points - self.a) @ along / (along @ along), 0, 1)
        away = points - self.a - t[:, None] * along
        return np.linalg.norm(away, axis=1) - (self.radii[0] + t * (self.radii[1] - self.radii[0]))


class Body:
    """Bones and the smooth union of the solids around them."""

    def __init__(self, blend, weight_blend, spacing):
        """Distances over which solids merge and over which bones share influence; spacing of the sampling; all in mm."""
        self.blend, self.weight_blend, self.spacing = blend, weight_blend, spacing
        self.bones, self.solids, self.number = [], [], {}

    def bone(self, name, parent, joint, axis, group=None):
        """Adds a bone; a bone whose name begins with `left_` is also added on the right."""
        joint, axis = np.array(joint, float), np.array(axis, float)
        axis = axis / np.linalg.norm(axis)
        self._bone(name, parent, joint, axis, group or name.removeprefix("left_"))
        if name.startswith("left_"):
            self._bone(right(name), right(parent), joint * MIRROR, axis * MIRROR, group or name.removeprefix("left_"))

    def _bone(self, name, parent, joint, axis, group):
        self.number[name] = len(self.bones)
        self.bones.append(Bone(name, self.number.get(parent, -1), joint, axis, group))

    def capsule(self, bone, a, b, *radii):
        self._solid(bone, a, b, radii if len(radii) == 2 else radii * 2)

    def ellipsoid(self, bone, center, radii):
        self._solid(bone, center, center, radii)

    def _solid(self, bone, a, b, radii):
        """Adds a solid, on both sides if the bone has a side or the solid is off the middle."""
        a, b, radii = (np.array(values, float) for values in (a, b, radii))
        self.solids.append(Solid(self.number[bone], a, b, radii))
        if bone.startswith("left_") or a[0] or b[0]:
            self.solids.append(Solid(self.number[right(bone)], a * MIRROR, b * MIRROR, radii))

    def distances(self, points):
        return np.stack([solid.distances(points) for solid in self.solids], 1)

    def outside(self, points):
        """The smooth union of the solids, negative inside."""
        return -self.blend * logsumexp(-self.distances(points) / self.blend, axis=1)

    def normals(self, points):
        """Gradient of `outside`."""
        step = 1e-3
        here = self.outside(points)
        return np.stack([self.outside(points + offset) - here for offset in step * np.eye(3)], 1) / step

    def weights(self, points):
        """The weight of each bone at each point: smooth, and a function of the position in the rest pose only."""
        near = -self.distances(points) / self.weight_blend
        near = np.exp(near - near.max(1, keepdims=True))
        found = np.zeros((len(points), len(self.bones)))
        for solid, column in zip(self.solids, near.T):
            found[:, solid.bone] += column
        return found / found.sum(1, keepdims=True)

    def posed(self, points, turns, scales=None):
        """Linear blend skinning: `turns` has a rotation matrix for each bone, relative to its parent.

        `scales` has the factors along and across each bone that make another individual of this one.
        """
        linear, places = [], []
        for k, bone in enumerate(self.bones):
            parent_turn = np.eye(3) if bone.parent < 0 else turned[bone.parent]
            if k == 0:
                turned = []
            turned.append(parent_turn @ turns[k])
            along, across = (1.0, 1.0) if scales is None else scales[k]
            onto = np.outer(bone.axis, bone.axis)
            linear.append(turned[k] @ (along * onto + across * (np.eye(3) - onto)))
            p = bone.parent
            places.append(bone.joint if p < 0 else places[p] + linear[p] @ (bone.joint - self.bones[p].joint))
        weights = self.weights(points)
        moved = np.zeros_like(points)
        for k, bone in enumerate(self.bones):
            moved += weights[:, k, None] * ((points - bone.joint) @ linear[k].T + places[k])
        return moved


def right(name):
    return "right_" + name.removeprefix("left_") if name.startswith("left_") else name


def person(draws):
    """A person of about 1.7 m with arms and legs apart; proportions vary between individuals."""
    length = lambda mm: mm * draws.uniform(0.9, 1.1)
    thick = draws.uniform(0.9, 1.12)
    radius = lambda mm: mm * thick * draws.uniform(0.93, 1.08)
    body = Body(blend=12.0, weight_blend=45.0, spacing=12.0)
    hip_y, waist, torso = 930.0, length(110), length(150)
    chest_y = hip_y + waist + torso
    shoulder = np.array([length(180), chest_y + length(195), -15.0])
    neck = np.array([0, shoulder[1] + 40, -15.0])
    head = neck + [0, length(95), 15]
    arm = np.array([np.cos(0.25), -np.sin(0.25), 0.0])
    elbow = shoulder + length(285) * arm
    wrist = elbow + length(255) * arm
    hand = length(165)
    leg = np.array([np.sin(0.14), -np.cos(0.14), 0.0])
    hip = np.array([95.0, hip_y - 10, 0])
    knee = hip + length(430) * leg
    ankle = knee + length(410) * leg
    foot = length(185)

    body.bone("pelvis", None, [0, hip_y, 0], [0, 1, 0])
    body.bone("abdomen", "pelvis", [0, hip_y + waist, 0], [0, 1, 0])
    body.bone("chest", "abdomen", [0, chest_y, 0], [0, 1, 0])
    body.bone("neck", "chest", neck, [0, 1, 0])
    body.bone("head", "neck", head, [0, 1, 0])
    body.bone("left_upper_arm", "chest", shoulder, arm)
    body.bone("left_forearm", "left_upper_arm", elbow, arm)
    body.bone("left_hand", "left_forearm", wrist, arm)
    body.bone("left_thigh", "pelvis", hip, leg)
    body.bone("left_shin", "left_thigh", knee, leg)
    body.bone("left_foot", "left_shin", ankle, [0, 0, 1])

    body.ellipsoid("pelvis", [0, hip_y + 15, 0], [radius(155), 110, radius(105)])
    body.ellipsoid("pelvis", [70, hip_y - 30, -55], [radius(78)] * 3)
    middle = hip_y + waist + torso / 2
    body.ellipsoid("abdomen", [0, middle, 0], [radius(138), 0.55 * (waist + torso), radius(98)])
    body.ellipsoid("abdomen", [0, middle - 20, 45], [radius(100), 105, radius(75) * draws.uniform(0.9, 1.3)])
    up = (shoulder[1] - chest_y) / 195
    body.ellipsoid("chest", [0, chest_y + 105 * up, 0], [radius(165), 165 * up, radius(108)])
    body.ellipsoid("chest", [72, chest_y + 110 * up, 58], [radius(68)] * 3)
    body.capsule("chest", shoulder * [0.2, 1, 1], shoulder * [0.75, 1, 1], radius(62))
    body.capsule("neck", neck - [0, 20, 0], head + [0, 10, 0], radius(56))
    size = draws.uniform(0.93, 1.08)
    body.ellipsoid("head", head + np.array([0, 85, 12]) * size, size * np.array([77, 110, 97]))
    body.capsule("head", head + np.array([0, 25, 50]) * size, head + np.array([0, 35, 65]) * size, 46 * size)
    body.capsule("head", head + np.array([0, 85, 105]) * size, head + np.array([0, 62, 124]) * size, 12 * size, 18 * size)

    body.capsule("left_upper_arm", shoulder, elbow, radius(54), radius(43))
    body.capsule("left_forearm", elbow, wrist, radius(43), radius(31))
    front, across = np.array([0, 0, 1.0]), radius(22)
    for side in (-1, 1):
        start = wrist + 25 * arm + 0.7 * side * across * front
        body.capsule("left_hand", start, wrist + (hand - 22) * arm + 0.8 * side * across * front, radius(23), radius(18))
    body.capsule("left_hand", wrist + 25 * arm + 20 * front, wrist + 75 * arm + 68 * front, radius(20), radius(16))

    body.capsule("left_thigh", hip, knee, radius(86), radius(58))
    body.capsule("left_shin", knee, ankle, radius(57), radius(40))
    body.capsule("left_shin", knee + 70 * leg - 22 * front, knee + 190 * leg - 14 * front, radius(50), radius(42))
    down = np.array([0, -45.0, 0])
    body.capsule("left_foot", ankle + down - 35 * front, ankle + down * 1.2 + foot * front, radius(40), radius(32))
    body.capsule("left_foot", ankle, ankle + down * 1.1 + 0.5 * foot * front, radius(38), radius(34))
    return body


def animal(draws):
    """A four-legged animal, 0.6 m at the withers; proportions vary between individuals."""
    length = lambda mm: mm * draws.uniform(0.88, 1.12)
    thick = draws.uniform(0.9, 1.12)
    radius = lambda mm: mm * thick * draws.uniform(0.93, 1.08)
    body = Body(blend=9.0, weight_blend=40.0, spacing=8.5)
    unit = lambda *axis: np.array(axis) / np.linalg.norm(axis)
    hind_z = -260.0
    loin, front = hind_z + length(130), hind_z + length(290)
    withers = front + length(190)
    neck_axis, head_axis, tail_axis = unit(0, 0.75, 0.65), unit(0, -0.25, 0.97), unit(0, -0.35, -0.95)
    neck = np.array([0, 620.0, withers + 20])
    head = neck + length(220) * neck_axis
    arm_axis, fore_axis = unit(0.06, -0.97, -0.2), unit(0.06, -1, 0.08)
    shoulder = np.array([80.0, 505, withers - 30])
    elbow = shoulder + length(205) * arm_axis
    wrist = elbow + length(190) * fore_axis
    thigh_axis, shin_axis = unit(0.08, -0.93, 0.35), unit(0.05, -0.85, -0.5)
    hip = np.array([72.0, 520, hind_z - 20])
    knee = hip + length(195) * thigh_axis
    hock = knee + length(175) * shin_axis
    tail = [np.array([0, 590.0, hind_z - 95])]
    for _ in range(2):
        tail.append(tail[-1] + length(120) * tail_axis)

    body.bone("pelvis", None, [0, 560, hind_z], [0, 0, 1])
    body.bone("abdomen", "pelvis", [0, 565, loin], [0, 0, 1])
    body.bone("chest", "abdomen", [0, 565, front], [0, 0, 1])
    body.bone("neck", "chest", neck, neck_axis)
    body.bone("head", "neck", head, head_axis)
    for k, parent in enumerate(["pelvis", "tail_0", "tail_1"]):
        body.bone(f"tail_{k}", parent, tail[k], tail_axis, "tail")
    body.bone("left_upper_arm", "chest", shoulder, arm_axis)
    body.bone("left_forearm", "left_upper_arm", elbow, fore_axis)
    body.bone("left_forepaw", "left_forearm", wrist, [0, -1, 0])
    body.bone("left_thigh", "pelvis", hip, thigh_axis)
    body.bone("left_shin", "left_thigh", knee, shin_axis)
    body.bone("left_hindpaw", "left_shin", hock, [0, -1, 0])

    z = np.array([0, 0, 1.0])
    body.ellipsoid("pelvis", [0, 560, hind_z], [radius(100), radius(105), 150])
    middle = (loin + front) / 2
    body.ellipsoid("abdomen", [0, 545, middle], [radius(102), radius(102), 0.9 * (front - hind_z) / 2 + 40])
    body.ellipsoid("abdomen", [0, 500, middle], [radius(85), radius(80) * draws.uniform(0.9, 1.2), 130])
    body.ellipsoid("chest", [0, 540, (front + withers) / 2 + 10], [radius(115), radius(138), (withers - front) / 2 + 100])
    body.capsule("neck", neck - 30 * neck_axis, head, radius(80), radius(58))
    size = draws.uniform(0.9, 1.12)
    body.ellipsoid("head", head + size * (10 * neck_axis + 25 * head_axis), size * np.array([64, 66, 88]))
    muzzle = head + size * 70 * head_axis
    body.capsule("head", muzzle, muzzle + length(95) * head_axis, 44 * size, 31 * size)
    ear = head + size * np.array([40, 50, 0])
    body.capsule("head", ear, ear + length(75) * unit(0.35, 0.9, -0.2), 24 * size, 15 * size)
    for k in range(3):
        end = tail[k + 1] if k < 2 else tail[2] + length(120) * tail_axis
        body.capsule(f"tail_{k}", tail[k], end, radius(36 - 6 * k), radius(30 - 6 * k))
    body.capsule("left_upper_arm", shoulder, elbow, radius(60), radius(40))
    body.capsule("left_forearm", elbow, wrist, radius(38), radius(27))
    ground = wrist + np.array([0, -60.0, 0])
    body.capsule("left_forepaw", wrist, ground, radius(28), radius(30))
    body.capsule("left_forepaw", ground, ground + 45 * z, radius(31), radius(27))
    body.capsule("left_thigh", hip, knee, radius(74), radius(44))
    body.capsule("left_shin", knee, hock, radius(42), radius(27))
    ground = hock + np.array([0, -120.0, 10])
    body.capsule("left_hindpaw", hock, ground, radius(27), radius(28))
    body.capsule("left_hindpaw", ground, ground + 50 * z, radius(31), radius(27))
    return body


# For each bone, the ranges of its angles about x, y and z, degrees, for the left side; the right side is mirrored.
PERSON_REST = {
    "left_upper_arm": [(-10, 10), (-15, 10), (-35, -5)],
    "left_forearm": [(0, 0), (-25, -5), (0, 0)],
    "left_thigh": [(-12, 5), (-5, 5), (-2, 6)],
    "left_shin": [(3, 15), (0, 0), (0, 0)],
    "chest": [(-4, 6), (-6, 6), (-3, 3)],
    "head": [(-8, 8), (-10, 10), (-4, 4)],
}
PERSON_FAR = {
    "pelvis": [(0, 0), (0, 0), (0, 0)],
    "abdomen": [(-10, 35), (-28, 28), (-14, 14)],
    "chest": [(-8, 30), (-28, 28), (-14, 14)],
    "neck": [(-12, 18), (-22, 22), (-10, 10)],
    "head": [(-15, 18), (-25, 25), (-10, 10)],
    "left_upper_arm": [(-35, 35), (-85, 10), (-60, 55)],
    "left_forearm": [(-20, 20), (-95, -15), (0, 0)],
    "left_hand": [(-15, 15), (-20, 20), (-35, 35)],
    "left_thigh": [(-85, 20), (-20, 20), (0, 25)],
    "left_shin": [(5, 90), (0, 0), (0, 0)],
    "left_foot": [(-20, 25), (0, 0), (0, 0)],
}
ANIMAL_REST = {
    "chest": [(-5, 5), (-6, 6), (-4, 4)],
    "neck": [(-10, 10), (-10, 10), (0, 0)],
    "head": [(-10, 10), (-8, 8), (0, 0)],
    "tail_0": [(-10, 10), (-12, 12), (0, 0)],
    "left_upper_arm": [(-14, 14), (0, 0), (0, 4)],
    "left_forearm": [(-12, 0), (0, 0), (0, 0)],
    "left_thigh": [(-14, 14), (0, 0), (0, 4)],
    "left_shin": [(-5, 10), (0, 0), (0, 0)],
}
ANIMAL_FAR = {
    "abdomen": [(-15, 18), (-30, 30), (-14, 14)],
    "chest": [(-15, 18), (-30, 30), (-14, 14)],
    "neck": [(-35, 45), (-45, 45), (-15, 15)],
    "head": [(-30, 35), (-35, 35), (-20, 20)],
    "tail_0": [(-30, 45), (-45, 45), (0, 0)],
    "tail_1": [(-40, 40), (-45, 45), (0, 0)],
    "tail_2": [(-40, 40), (-45, 45), (0, 0)],
    "left_upper_arm": [(-60, 45), (-10, 10), (0, 22)],
    "left_forearm": [(-85, 5), (0, 0), (0, 0)],
    "left_forepaw": [(-10, 60), (0, 0), (0, 0)],
    "left_thigh": [(-65, 40), (-10, 10), (0, 22)],
    "left_shin": [(-30, 45), (0, 0), (0, 0)],
    "left_hindpaw": [(-50, 25), (0, 0), (0, 0)],
}
