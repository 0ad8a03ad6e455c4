"""Figures to reach, from `reach.json`: a table for each column, with sets or patterns of sets as keys."""

import fnmatch
import json
import os

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "reach.json")) as file:
    TABLES = json.load(file)


def to_reach(column, kind):
    """The text of the first pattern that fits the set; empty if there is no figure to reach."""
    return next((text for pattern, text in TABLES[column].items() if fnmatch.fnmatch(kind, pattern)), "")
