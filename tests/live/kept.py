"""How much a stream keeps: the length of every list, queue, table and array of its state."""

from collections import deque
from collections.abc import Collection, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum

import numpy as np

SHARED = ("models", "realizer", "model", "part", "table", "placer", "rates", "tuning", "voicing")
"""Attributes that all streams share, or that only draw."""


def kept(state: object, name: str = "") -> dict[str, int]:
    """By the path of attributes to it. A queue that drops the oldest counts as full."""
    if isinstance(state, np.ndarray):
        return {name: state.size}
    if isinstance(state, deque) and state.maxlen is not None:
        return {name: state.maxlen}
    if isinstance(state, Collection) and not isinstance(state, str | bytes):
        parts = state.values() if isinstance(state, Mapping) else state
        inside = [kept(part, name + "[]") for part in parts]
        return {name: len(state)} | {path: sum(each.get(path, 0) for each in inside) for path in set().union(*inside)}
    if not type(state).__module__.startswith("understudy.") or isinstance(state, Enum):
        return {}
    names = [each.name for each in fields(state)] if is_dataclass(state) else list(vars(state))
    found = (kept(getattr(state, each), f"{name}.{each}") for each in names if each.strip("_") not in SHARED)
    return {path: length for each in found for path, length in each.items()}


def grown(before: list[dict[str, int]], after: list[dict[str, int]]) -> set[str]:
    """What is longer at every moment after than at any before."""
    most = {path: max(each.get(path, 0) for each in before) for path in set().union(*before, *after)}
    return {path for path, length in most.items() if all(each.get(path, 0) > length for each in after)}
