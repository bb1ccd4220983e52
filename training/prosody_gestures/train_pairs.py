"""Learns gestures from the voice from recordings with motion, instead of from the rules' schedules.

    python -m training.prosody_gestures.train_pairs FOLDER OUTPUT [--clusters N] [--joints LEFT_ARM LEFT_FOREARM …]

FOLDER holds pairs (`training.prosody_gestures.motion_pairs`); --joints are the names that the BVH files give the four
joints of the arms. The kinds of movements are found by clustering; their number, unless it is given, is the fewest that
keep the correlation of the movements with the voice's affect (AHG §4.1). OUTPUT takes `voice.npz`, whose part "hands"
has the states "phrase 0", "phrase 1", …, and `units.npz`, their recorded movements, for `unit_selection`: `state`,
`frames` and `affect` (units × 3) of each unit, and all their `angles` (frames × angles), one unit after another.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from training.prosody_gestures.motion_pairs import BVH_JOINTS, MotionPair, movements, read_pairs
from understudy.model import FloatArray
from understudy.prosody_gestures.affect import AffectModel
from understudy.prosody_gestures.clustering import (
    ParallelBranches,
    cluster_correlation,
    fewest_clusters,
    learn_branches,
)
from understudy.prosody_gestures.context import in_context
from understudy.prosody_gestures.prosody import raw_frames
from understudy.prosody_gestures.semi_markov import FRAME_S, Segment, states_by_frame
from understudy.prosody_gestures.voice_model import VoiceModel, learn_part
from understudy.resources import resource_folder

CHOICES = (10, 20, 30, 40, 50)


def affects_of(pairs: Sequence[MotionPair]) -> list[FloatArray]:
    """The affect of each recording's frames (frames × 3), as its voice tells."""
    model = AffectModel.load(resource_folder("models") / "prosody_gestures" / "affect.npz")
    return [model.estimate(raw_frames(pair.energy_db, pair.f0_hz))[: len(pair.angles)] for pair in pairs]


def correlations(
    pairs: Sequence[MotionPair], affects: Sequence[FloatArray], clusters: Sequence[int]
) -> tuple[dict[int, FloatArray], FloatArray]:
    """Of angles and affect, within so many clusters, and over all frames (AHG Fig. 3)."""
    angles, affect, streams = np.concatenate([pair.angles for pair in pairs]), np.concatenate(affects), movements(pairs)
    kept = {}
    for number in clusters:
        paths = _segmented(learn_branches(streams, number), streams)
        labels = np.concatenate([states_by_frame(path) for path in paths])
        kept[number] = cluster_correlation(angles, affect, labels)
    return kept, cluster_correlation(angles, affect, np.zeros(len(angles), dtype=np.intp))


def train(pairs: Sequence[MotionPair], clusters: int) -> tuple[VoiceModel, list[list[Segment]]]:
    """The model of so many kinds of movements, and the path that it learnt from in each recording."""
    streams = movements(pairs)
    paths = _segmented(learn_branches(streams, clusters), streams)
    rows = [in_context(pair.features) for pair in pairs]
    states = tuple(f"phrase {state}" for state in range(clusters))
    return VoiceModel((learn_part("hands", states, list(zip(rows, paths, strict=True))),)), paths


def _segmented(branches: ParallelBranches, streams: Sequence[FloatArray]) -> list[list[Segment]]:
    return [branches.segment(stream) for stream in streams]


def save_units(
    path: Path, pairs: Sequence[MotionPair], affects: Sequence[FloatArray], paths: Sequence[Sequence[Segment]]
) -> None:
    """The units of all recordings. Written to a temporary name, then renamed."""
    units = [(each, affect[each.start : each.end]) for own, affect in zip(paths, affects, strict=True) for each in own]
    unfinished = path.with_suffix(".unfinished")
    with unfinished.open("wb") as file:
        np.savez_compressed(
            file,
            state=np.array([segment.state for segment, _ in units]),
            frames=np.array([segment.frames for segment, _ in units]),
            affect=np.stack([affect.mean(axis=0) for _, affect in units]),
            angles=np.concatenate([pair.angles for pair in pairs]).astype(np.float32),
        )
    unfinished.rename(path)


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("output", type=Path)
    parser.add_argument("--clusters", type=int)
    parser.add_argument("--joints", nargs=4, default=BVH_JOINTS)
    options = parser.parse_args(arguments)
    pairs = read_pairs(options.folder, options.joints)
    affects = affects_of(pairs)
    clusters = options.clusters or fewest_clusters(*correlations(pairs, affects, CHOICES))
    model, paths = train(pairs, clusters)
    options.output.mkdir(parents=True, exist_ok=True)
    model.save(options.output / "voice.npz")
    save_units(options.output / "units.npz", pairs, affects, paths)
    minutes = sum(len(pair.angles) for pair in pairs) * FRAME_S / 60
    print(f"{options.output}: {clusters} kinds of movements from {len(pairs)} recordings, {minutes:.1f} minutes")


if __name__ == "__main__":
    main()
