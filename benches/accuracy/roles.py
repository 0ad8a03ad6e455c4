"""The role of each set, from `roles.json`: numbers of the program may be fitted on sets of `fit`, never on those of
`report`.

The file has patterns of sets for each role; the first role with a matching pattern counts.
"""

import fnmatch
import json
import os

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "roles.json")) as file:
    ROLES = json.load(file)


def role_of(kind):
    """`fit` or `report`. A set without a pattern is an error: a new set needs a role."""
    for role, patterns in ROLES.items():
        if any(fnmatch.fnmatch(kind, pattern) for pattern in patterns):
            return role
    raise KeyError(f"roles.json names no role of the set {kind}")
