"""Features of recordings under each condition, kept in a file, since measuring them takes far longer than training."""

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

import numpy as np

from training.agitation.conditions import Condition
from training.agitation.corpus import Recording, measure
from understudy.acoustic.agitation.utterance_features import FEATURE_SETS
from understudy.model import FloatArray

Measured = Mapping[str, Mapping[str, FloatArray]]
"""By feature set and condition; each of shape (recordings, features)."""


def measured(recordings: Sequence[Recording], conditions: Mapping[str, Condition], kept: Path | None) -> Measured:
    """The features as `measure` gives them, from `kept` where they stand there already; what is new is written to it.

    The file does not know when the features' definitions change: delete it then.
    """
    names = [f"{recording.corpus}/{recording.path.name}" for recording in recordings]
    known = _read(kept, names) if kept and kept.exists() else {}
    missing = {name: change for name, change in conditions.items() if f"paper {name}" not in known}
    for feature_set, features in measure(recordings, missing).items() if missing else ():
        known |= {f"{feature_set} {condition}": rows for condition, rows in features.items()}
    if kept and missing:
        np.savez(kept, allow_pickle=False, names=names, **known)
    return {name: {condition: known[f"{name} {condition}"] for condition in conditions} for name in FEATURE_SETS}


def _read(kept: Path, names: Collection[str]) -> dict[str, FloatArray]:
    """What the file holds for the recordings of these names, in their order."""
    with np.load(kept, allow_pickle=False) as arrays:
        rows = {name: row for row, name in enumerate(arrays["names"].tolist())}
        order = [rows[name] for name in names]
        return {key: arrays[key][order] for key in arrays.files if key != "names"}
