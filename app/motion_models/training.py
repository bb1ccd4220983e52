"""Learns a motion model from pairs: phrases and their kinds by clustering the arms' motion, then by counting."""

from collections.abc import Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ..errors import InputError
from ..model import FloatArray
from ..model.performance import Progress, no_progress
from ..prosody_gestures.estimation import Counts, CountSmoothing, MixtureOptions, count, count_labels, fit_mixtures
from ..prosody_gestures.semi_markov import FRAME_S, Emissions, IntArray, Segment, SemiMarkovModel, states_by_frame
from .clustering import STRETCH_FRAMES, ParallelBranches, cluster_correlation, fewest_clusters, learn_branches
from .model import FEATURES, LABELS, Fusion, MotionModel, arm_angles, units_of
from .pairs import Pair, with_common_joints

LONGEST_FRAMES = 200
"""D_max of AHG, 5 s; RTS has 10 s."""

CHOICES = (10, 20, 30, 40, 50)
"""The numbers of kinds that are compared (AHG Fig. 3)."""

LABELS_OF_PROSODY = 20
"""M_p, the kinds of intonation phrases, which RTS does not tell."""

_STRETCHES_A_KIND = 3
_FEWEST_KINDS = 2
_SMOOTHING = CountSmoothing(added=0.01)


@dataclass(frozen=True, slots=True)
class Learning:
    """`kinds` of movements, chosen by correlation (AHG §4.1) unless given; `seed` of the clustering."""

    kinds: int | None = None
    seed: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Learnt:
    """A model, the movements' clusters, how streams were scaled, and what each pair was segmented into."""

    model: MotionModel
    movements: "MotionSegmenter"
    paths: tuple[list[Segment], ...]


@dataclass(frozen=True, slots=True, eq=False)
class MotionSegmenter:
    """Segments motion: arms' angles and their changes (AHG eq. 1, 2), scaled by `mean` and `deviation`."""

    mean: FloatArray
    deviation: FloatArray
    branches: ParallelBranches

    def segment(self, pair: Pair) -> list[Segment]:
        """The phrases of a pair's motion."""
        return self.branches.segment((_stream(pair) - self.mean) / self.deviation)


def learn(pairs: Sequence[Pair], learning: Learning = Learning(), progress: Progress = no_progress) -> Learnt:
    """Raises InputError `pairs_wrong` where there is too little motion."""
    pairs = with_common_joints(pairs)
    streams = [_stream(pair) for pair in pairs]
    everything = np.concatenate(streams)
    mean, deviation = everything.mean(axis=0), everything.std(axis=0) + 1e-9
    scaled = [(stream - mean) / deviation for stream in streams]
    kinds = learning.kinds or chosen_kinds(pairs, scaled, learning.seed, progress)
    _require_enough(scaled, kinds)
    progress(f"cluster into {kinds} kinds")
    movements = MotionSegmenter(mean, deviation, learn_branches(scaled, kinds, seed=learning.seed))
    paths = [movements.branches.segment(stream) for stream in scaled]
    progress("learn when they occur")
    model = _model(pairs, paths, kinds, learning.seed)
    return Learnt(model, movements, tuple(paths))


def kinds_possible(streams: Sequence[FloatArray]) -> int:
    """How many kinds can be told apart in so much motion."""
    return sum(len(stream) // STRETCH_FRAMES for stream in streams) // _STRETCHES_A_KIND


def chosen_kinds(pairs: Sequence[Pair], streams: Sequence[FloatArray], seed: int, progress: Progress) -> int:
    """The fewest of `CHOICES` whose clusters keep the correlation of the movements with affect; with less motion than
    the least of them needs, as many as it has."""
    most = kinds_possible(streams)
    choices = [number for number in CHOICES if number <= most]
    if len(choices) < 2:
        return choices[0] if choices else max(_FEWEST_KINDS, most)
    return fewest_clusters(*kept_correlations(pairs, streams, choices, seed, progress))


def kept_correlations(
    pairs: Sequence[Pair],
    streams: Sequence[FloatArray],
    choices: Sequence[int],
    seed: int = 0,
    progress: Progress = no_progress,
) -> tuple[dict[int, FloatArray], FloatArray]:
    """The correlation of angles and affect within so many clusters, and over all frames (AHG Fig. 3)."""
    angles = np.concatenate([arm_angles(pair.joints, pair.rotations) for pair in pairs])
    affect = np.concatenate([pair.voice.affect for pair in pairs])
    kept = {}
    for number in choices:
        progress(f"try {number} kinds")
        branches = learn_branches(streams, number, seed=seed)
        labels = np.concatenate([states_by_frame(branches.segment(stream)) for stream in streams])
        kept[number] = cluster_correlation(angles, affect, labels)
    return kept, cluster_correlation(angles, affect, np.zeros(len(angles), dtype=np.intp))


def _stream(pair: Pair) -> FloatArray:
    angles = arm_angles(pair.joints, pair.rotations)
    return np.concatenate([angles, np.gradient(angles, axis=0)], axis=1)


def _require_enough(streams: Sequence[FloatArray], kinds: int) -> None:
    stretches = sum(len(stream) // STRETCH_FRAMES for stream in streams)
    if stretches < kinds:
        seconds = sum(map(len, streams)) * FRAME_S
        needed_s = kinds * STRETCH_FRAMES * FRAME_S
        message = f"{seconds:.1f} s of motion are too little for {kinds} kinds: give {needed_s:.1f} s or fewer --kinds"
        raise InputError("pairs_wrong", message, field="kinds")


def _model(pairs: Sequence[Pair], paths: Sequence[list[Segment]], kinds: int, seed: int) -> MotionModel:
    fusion = _fusion(pairs)
    counts = _without_unseen(count(paths, kinds, LONGEST_FRAMES, _SMOOTHING), paths)
    states = np.concatenate([states_by_frame(path) for path in paths])
    emissions: dict[str, Emissions] = {}
    for name in FEATURES:
        frames = np.concatenate([fusion.features(pair.voice, name) for pair in pairs])
        emissions[name] = fit_mixtures([frames[states == kind] for kind in range(kinds)], MixtureOptions(seed=seed))
    spoken = [fusion.features(pair.voice, "p") for pair in pairs]
    intonation = learn_branches(spoken, min(LABELS_OF_PROSODY, max(2, kinds_possible(spoken))), seed=seed)
    labelled = [states_by_frame(intonation.segment(stream)) for stream in spoken]
    emissions[LABELS] = count_labels(zip(paths, labelled, strict=True), kinds, len(intonation.means))
    return MotionModel(
        about=_about(pairs, kinds, seed),
        joints=pairs[0].joints,
        kinds=SemiMarkovModel(
            tuple(map(str, range(kinds))),
            counts.log_initial,
            counts.log_transition,
            counts.log_duration,
            emissions["p"],
        ),
        emissions=MappingProxyType(emissions),
        fusion=fusion,
        intonation=intonation,
        units=tuple(
            unit
            for pair, path in zip(pairs, paths, strict=True)
            for unit in units_of(path, pair.joints, pair.rotations, pair.voice.affect)
        ),
    )


def _fusion(pairs: Sequence[Pair]) -> Fusion:
    both = np.concatenate([np.concatenate([pair.voice.prosody, pair.voice.affect], axis=1) for pair in pairs])
    mean, deviation = both.mean(axis=0), both.std(axis=0) + 1e-9
    axes = np.linalg.svd((both - mean) / deviation, full_matrices=False)[2][:2].T
    return Fusion(mean, deviation, axes)


def _without_unseen(counts: Counts, paths: Sequence[Sequence[Segment]]) -> Counts:
    """A kind without units cannot be shown, so it is never entered."""
    seen: IntArray = np.unique([each.state for path in paths for each in path])
    initial, transition = counts.log_initial.copy(), counts.log_transition.copy()
    unseen = np.setdiff1d(np.arange(len(initial)), seen)
    initial[unseen], transition[:, unseen] = -np.inf, -np.inf
    return Counts(initial, transition, counts.log_duration)


def _about(pairs: Sequence[Pair], kinds: int, seed: int) -> str:
    minutes = sum(len(pair.voice) for pair in pairs) * FRAME_S / 60
    sessions = len({pair.session for pair in pairs})
    return (
        f"{kinds} kinds of movements of {len(pairs)} recordings of {sessions} sessions, {minutes:.1f} min, seed {seed}"
    )
