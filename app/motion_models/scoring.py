"""How near the motion of a model comes to recorded motion (AHG §4), and how near a quick search to the full one (RTS
§3.1).

Correlations are first canonical ones, a recording each (AHG's tables), and over all recordings together, each about its
own mean. Streams as smooth and as short as these correlate by chance as well: `chance` has the counterpart moved round
by a quarter, a half and three quarters of its recording, so that it lasts as long and moves as it does, at other times.
Divergences are symmetric ones, in nats, over all recordings
together: of the shares of kinds in frames, of durations whatever the kind, and of durations kind by kind, weighed by
the kinds' frames in the original. Energies are kinetic ones of the arms, the sum of squared angular velocities over
joints in rad²/s², and the score is the mean difference from the original's frame by frame.
"""

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..errors import InputError
from ..model import FloatArray
from ..model.performance import Progress, no_progress
from ..prosody_gestures.semi_markov import FRAME_S, Segment, similarity, states_by_frame
from ..prosody_gestures.trellis import EVERYTHING, Search
from ..realizer.geometry.rotations import to_rotation_vector
from .clustering import canonical_correlation, energy_difference, kinetic_energy, symmetric_divergence
from .model import FEATURES, LABELS, SCENARIOS, MotionModel, Scenario, arm_angles
from .pairs import Pair, arms_of, with_common_joints
from .performing import move
from .training import Learning, MotionSegmenter, learn

AFFECTS = ("activation", "valence", "dominance")


@dataclass(frozen=True, slots=True)
class Correlation:
    """The mean and the standard deviation over recordings, the mean by chance, and both over all recordings
    together."""

    mean: float
    deviation: float
    chance: float
    together: float
    together_by_chance: float


@dataclass(frozen=True, slots=True)
class FeatureScore:
    """A set of features: its correlation with the original movement (AHG Table 2); the divergence of kinds and of
    durations, all together and kind by kind, between its path and the original's (Table 3)."""

    movement: Correlation
    kinds: float
    durations: float
    durations_by_kind: float


@dataclass(frozen=True, slots=True)
class ScenarioScore:
    """A scenario's motion: its correlation with the original (AHG Table 4) and with affect (Table 5), its difference of
    kinetic energy from the original's and its own energy, rad²/s² (Fig. 4)."""

    movement: Correlation
    affect: Mapping[str, Correlation]
    energy_difference: float
    energy: float


@dataclass(frozen=True, slots=True)
class SearchScore:
    """A search: its time over that of the recording (RTS Table 3.1), and the share of frames in which it finds the same
    kind as the full search (Table 3.2)."""

    search: Search
    real_time_factor: float
    similarity: float


@dataclass(frozen=True, slots=True)
class Scores:
    """`energy` is that of the original; `left_out` says whether models had not heard the sessions that they moved."""

    recordings: int
    minutes: float
    left_out: str
    energy: float
    features: Mapping[str, FeatureScore]
    scenarios: Mapping[str, ScenarioScore]
    searches: tuple[SearchScore, ...] = ()


class Trial:
    """A recording, a model, and what the recording's own motion is segmented into by the model's kinds."""

    def __init__(self, pair: Pair, model: MotionModel, movements: MotionSegmenter) -> None:
        self.pair, self.model = pair, model
        self.original = movements.segment(pair)

    @cached_property
    def angles(self) -> FloatArray:
        return arm_angles(self.pair.joints, self.pair.rotations)

    @cached_property
    def paths(self) -> Mapping[str, tuple[Segment, ...]]:
        return {name: self.model.path(self.pair.voice, name) for name in (*FEATURES, LABELS)}

    def synthesised(self, scenario: Scenario) -> FloatArray:
        """The arms' rotations (frames × 4 × 4)."""
        moved = move(self.model, self.pair.voice, scenario)
        return arms_of(moved.joints, moved.rotations)


def left_out_trials(
    pairs: Sequence[Pair], learning: Learning, progress: Progress = no_progress
) -> tuple[list[Trial], str]:
    """Each recording with a model of the other sessions (AHG §4.2), or of the other recordings where there is only one
    session; and which of both. Raises InputError `pairs_wrong` for a single recording."""
    pairs = with_common_joints(pairs)
    by: tuple[str, Callable[[Pair], str]] = ("session", lambda pair: pair.session)
    if len({pair.session for pair in pairs}) == 1:
        by = ("recording", lambda pair: pair.name)
    groups = sorted({by[1](pair) for pair in pairs})
    if len(groups) == 1:
        raise InputError(
            "pairs_wrong", "a single recording; give at least two, so that one can be left out", field="folder"
        )
    trials = []
    for number, group in enumerate(groups, start=1):
        progress(f"leave out {number}/{len(groups)}")
        learnt = learn([pair for pair in pairs if by[1](pair) != group], learning, progress)
        own = [pair for pair in pairs if by[1](pair) == group]
        trials += [Trial(pair, learnt.model, learnt.movements) for pair in own]
    return trials, by[0]


def scored(
    trials: Sequence[Trial],
    left_out: str,
    scenarios: Sequence[str],
    searches: Sequence[Search] = (),
    progress: Progress = no_progress,
) -> Scores:
    """The measures of all trials."""
    arms = [arms_of(trial.pair.joints, trial.pair.rotations) for trial in trials]
    features = {}
    for name in (*FEATURES, LABELS):
        progress(f"decode {name}")
        features[name] = _feature_score(trials, name)
    by_scenario = {}
    for name in scenarios:
        progress(f"move {name}")
        by_scenario[name] = _scenario_score(trials, arms, SCENARIOS[name])
    progress("search")
    return Scores(
        recordings=len(trials),
        minutes=sum(map(len, arms)) * FRAME_S / 60,
        left_out=left_out,
        energy=_mean_energy(arms),
        features=features,
        scenarios=by_scenario,
        searches=tuple(_search_scores(trials, searches)) if searches else (),
    )


def _feature_score(trials: Sequence[Trial], name: str) -> FeatureScore:
    observed = [_observed(trial, name) for trial in trials]
    kinds, durations, by_kind = _divergences(trials, name)
    return FeatureScore(correlation_of(observed, [trial.angles for trial in trials]), kinds, durations, by_kind)


def _observed(trial: Trial, name: str) -> FloatArray:
    """The features; labels as a column for each."""
    if name != LABELS:
        return trial.model.fusion.features(trial.pair.voice, name)
    return np.eye(len(trial.model.intonation.means))[trial.model.labels(trial.pair.voice)]


def _scenario_score(trials: Sequence[Trial], arms: Sequence[FloatArray], scenario: Scenario) -> ScenarioScore:
    made = [trial.synthesised(scenario) for trial in trials]
    angles = [_angles(each) for each in made]
    affects = [trial.pair.voice.affect for trial in trials]
    return ScenarioScore(
        movement=correlation_of(angles, [trial.angles for trial in trials]),
        affect={
            name: correlation_of(angles, [each[:, place, None] for each in affects])
            for place, name in enumerate(AFFECTS)
        },
        energy_difference=float(
            np.mean([energy_difference(one, other, FRAME_S) for one, other in zip(made, arms, strict=True)])
        ),
        energy=_mean_energy(made),
    )


def _angles(arms: FloatArray) -> FloatArray:
    return to_rotation_vector(arms).reshape(len(arms), -1)


def _mean_energy(motions: Sequence[FloatArray]) -> float:
    return float(np.mean([kinetic_energy(each, FRAME_S).mean() for each in motions]))


_MOVED_BY = (0.25, 0.5, 0.75)
"""By what shares of a recording its counterpart is moved round for chance."""


def correlation_of(ones: Sequence[FloatArray], others: Sequence[FloatArray]) -> Correlation:
    """The correlation of the streams of recordings with their counterparts, which are as long."""
    own = _by_recording(ones, others)
    moved = [[np.roll(each, round(share * len(each)), axis=0) for each in others] for share in _MOVED_BY]
    return Correlation(
        mean=float(np.mean(own)),
        deviation=float(np.std(own)),
        chance=float(np.mean([_by_recording(ones, each) for each in moved])),
        together=canonical_correlation(_centred(ones), _centred(others)),
        together_by_chance=float(np.mean([canonical_correlation(_centred(ones), _centred(each)) for each in moved])),
    )


def _by_recording(ones: Sequence[FloatArray], others: Sequence[FloatArray]) -> list[float]:
    return [canonical_correlation(one, other) for one, other in zip(ones, others, strict=True)]


def _centred(streams: Sequence[FloatArray]) -> FloatArray:
    return np.concatenate([each - each.mean(axis=0) for each in streams])


def _divergences(trials: Sequence[Trial], name: str) -> tuple[float, float, float]:
    """Of kinds, of durations, and of durations kind by kind. A model's kinds are its own: models are taken one by one
    and averaged by their recordings."""
    models = {id(trial.model): trial.model for trial in trials}
    totals, weights = np.zeros(3), 0
    for key, model in models.items():
        own = [trial for trial in trials if id(trial.model) == key]
        totals += len(own) * np.array(_divergences_of(own, name, model.kinds.log_duration.shape))
        weights += len(own)
    kinds, durations, by_kind = (totals / weights).tolist()
    return kinds, durations, by_kind


def _divergences_of(trials: Sequence[Trial], name: str, shape: tuple[int, ...]) -> tuple[float, float, float]:
    counted = [
        _counted(paths, shape) for paths in ([each.original for each in trials], [each.paths[name] for each in trials])
    ]
    (frames, lasting), (other_frames, other_lasting) = counted
    by_kind = [_share_divergence(one, other) for one, other in zip(lasting, other_lasting, strict=True)]
    return (
        _share_divergence(frames, other_frames),
        _share_divergence(lasting.sum(axis=0), other_lasting.sum(axis=0)),
        float(frames @ np.array(by_kind) / frames.sum()),
    )


def _counted(paths: Sequence[Sequence[Segment]], shape: tuple[int, ...]) -> tuple[FloatArray, FloatArray]:
    """The frames of each kind, and how often it lasts how long (kinds × durations in frames)."""
    frames, lasting = np.zeros(shape[0]), np.zeros(shape)
    for each in (segment for path in paths for segment in path):
        frames[each.state] += each.frames
        lasting[each.state, min(each.frames, shape[1]) - 1] += 1
    return frames, lasting


def _share_divergence(one: FloatArray, other: FloatArray) -> float:
    return symmetric_divergence(one / max(one.sum(), 1), other / max(other.sum(), 1))


def _search_scores(trials: Sequence[Trial], searches: Sequence[Search]) -> Iterator[SearchScore]:
    """Decoding alone, as RTS has it: units take much less time."""
    full = np.concatenate([states_by_frame(trial.paths[LABELS]) for trial in trials])
    for search in (EVERYTHING, *searches):
        began_s = time.process_time()
        found = [states_by_frame(trial.model.path(trial.pair.voice, LABELS, search)) for trial in trials]
        factor = (time.process_time() - began_s) / (len(full) * FRAME_S)
        yield SearchScore(search, factor, similarity(np.concatenate(found), full))
