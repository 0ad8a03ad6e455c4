"""What a set is for, from `roles.json`: numbers of the program may be fitted on sets of `fit`, never on those of `report`.

The file has patterns of sets for each role; the first role with a pattern that fits counts.
"""

import fnmatch
import json
import os

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "roles.json")) as file:
    ROLES = json.load(file)


def role_of(kind):
    """`fit` or `report`. A set that no pattern names is an error: whoever adds one says what it is for."""
    for role, patterns in ROLES.items():
        if any(fnmatch.fnmatch(kind, pattern) for pattern in patterns):
            return role
    raise KeyError(f"roles.json names no role of the set {kind}")
