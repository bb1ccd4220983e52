"""Repeats AHG's evaluation on the paired recordings: figure 3, tables 2 to 5, figure 4, theirs beside ours.

    python -m benchmarks.prosody_gestures.scenarios [--paired FOLDER] [--clusters N] [--choose]

One session (pair of people) is left out at a time; kinds of movements, models and units are of the other. f^p is the
prosody, f^a activation, valence and dominance, f^ap both, f^AP two principal components of it. S1 to S6: what drives
the decode, and whether affect adjusts the choice of units (α = 1) or not. Nobody has annotated these recordings: affect
is estimated from the voice (`understudy.prosody_gestures.affect`), so f^a holds no more than the voice does.

Correlations are first canonical ones, a recording each, mean and deviation. Streams as smooth as these correlate by
chance; "chance" has each recording's counterpart from the next recording. Divergences are of all recordings together:
of the shares of states, and of durations whatever the state. Figure 4 has the mean difference of kinetic energies,
radians² a second². With --choose, how much of the correlation of movements and affect clusters keep, by their number.
"""

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np

from training.prosody_gestures.motion_pairs import MotionPair, movements, read_pairs
from training.prosody_gestures.train_pairs import CHOICES, affects_of, correlations
from understudy.model import FloatArray
from understudy.prosody_gestures.affect import DIMENSIONS
from understudy.prosody_gestures.clustering import fewest_clusters, learn_branches
from understudy.prosody_gestures.correlation import canonical_correlation, energy_difference, symmetric_divergence
from understudy.prosody_gestures.counting import Smoothing, count
from understudy.prosody_gestures.mixtures import MixtureOptions, fit_mixtures
from understudy.prosody_gestures.semi_markov import FRAME_S, Segment, SemiMarkovModel, states_by_frame
from understudy.prosody_gestures.unit_selection import Pool, Unit, motion_of, paper_weights, select
from understudy.prosody_gestures.viterbi import decode
from understudy.prosody_gestures.voice_model import LONGEST_FRAMES

SCENARIOS = MappingProxyType(
    {"S1": ("ap", 1.0), "S2": ("ap", 0.0), "S3": ("p", 1.0), "S4": ("p", 0.0), "S5": ("a", 1.0), "S6": ("a", 0.0)}
)
THEIR_FEATURES = MappingProxyType(
    {"ap": (0.66, 3.69, 7.26), "p": (0.41, 5.28, 7.30), "a": (0.64, 5.19, 8.29), "AP": (0.47, 4.25, 7.71)}
)
"""Correlation with the original movement, divergence of states and of durations (their tables 2 and 3)."""

THEIR_MOVEMENTS = MappingProxyType(
    {
        "S1": (0.566, 0.520, 0.482, 0.516),
        "S2": (0.516, 0.449, 0.456, 0.483),
        "S3": (0.495, 0.354, 0.329, 0.308),
        "S4": (0.461, 0.292, 0.287, 0.299),
        "S5": (0.614, 0.585, 0.593, 0.588),
        "S6": (0.627, 0.545, 0.558, 0.541),
    }
)
"""Correlation of what is synthesised with the original, with activation, valence and dominance (tables 4 and 5)."""


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A recording with its affect, what it was segmented into, and for each feature set its features and decode."""

    pair: MotionPair
    affect: FloatArray
    original: list[Segment]
    features: Mapping[str, FloatArray]
    decoded: Mapping[str, Sequence[Segment]]
    pool: Pool


def feature_sets(
    pairs: Sequence[MotionPair], affects: Sequence[FloatArray], heard: Sequence[int]
) -> list[dict[str, FloatArray]]:
    """The four feature sets of each recording, scaled as over those that were heard."""
    prosody = _standardised([pair.features for pair in pairs], heard)
    affect = _standardised(affects, heard)
    both = [np.concatenate(parts, axis=1) for parts in zip(prosody, affect, strict=True)]
    axes = np.linalg.svd(np.concatenate([both[place] for place in heard]), full_matrices=False)[2][:2].T
    return [
        {"ap": all_, "p": own, "a": felt, "AP": all_ @ axes}
        for all_, own, felt in zip(both, prosody, affect, strict=True)
    ]


def _standardised(streams: Sequence[FloatArray], heard: Sequence[int]) -> list[FloatArray]:
    everything = np.concatenate([streams[place] for place in heard])
    mean, deviation = everything.mean(axis=0), everything.std(axis=0) + 1e-9
    return [(stream - mean) / deviation for stream in streams]


def trials_of(pairs: Sequence[MotionPair], affects: Sequence[FloatArray], clusters: int) -> list[Trial]:
    """All recordings, each decoded by what the other session taught."""
    streams, trials = movements(pairs), list[Trial]()
    for session in sorted({pair.session for pair in pairs}):
        heard = [place for place, pair in enumerate(pairs) if pair.session != session]
        branches = learn_branches([streams[place] for place in heard], clusters)
        paths = [branches.segment(streams[place]) for place in heard]
        sets = feature_sets(pairs, affects, heard)
        models = {
            name: _model(paths, [sets[place][name] for place in heard], clusters) for name in ("ap", "p", "a", "AP")
        }
        pool = Pool.of(
            [
                unit
                for path, place in zip(paths, heard, strict=True)
                for unit in _units(path, pairs[place], affects[place])
            ]
        )
        for place in (place for place, pair in enumerate(pairs) if pair.session == session):
            likelihoods = {name: model.emissions.log_likelihoods(sets[place][name]) for name, model in models.items()}
            decoded = {name: decode(model, likelihoods[name]) for name, model in models.items()}
            original = branches.segment(streams[place])
            trials.append(Trial(pairs[place], affects[place], original, sets[place], decoded, pool))
    return trials


def _model(paths: Sequence[list[Segment]], features: Sequence[FloatArray], states: int) -> SemiMarkovModel:
    frames, kinds = np.concatenate(features), np.concatenate([states_by_frame(path) for path in paths])
    emissions = fit_mixtures([frames[kinds == state] for state in range(states)], MixtureOptions())
    # A kind without units cannot be shown: it is never entered.
    counts = count(paths, states, LONGEST_FRAMES, Smoothing(added=0.01))
    unseen = np.bincount(kinds, minlength=states) == 0
    transition, initial = counts.log_transition.copy(), counts.log_initial.copy()
    transition[:, unseen], initial[unseen] = -np.inf, -np.inf
    return SemiMarkovModel(tuple(map(str, range(states))), initial, transition, counts.log_duration, emissions)


def _units(path: Sequence[Segment], pair: MotionPair, affect: FloatArray) -> list[Unit]:
    return [
        Unit(each.state, pair.angles[each.start : each.end], affect[each.start : each.end].mean(axis=0))
        for each in path
    ]


def synthesised(trial: Trial, scenario: str) -> FloatArray:
    """The angles of a scenario (frames × angles)."""
    name, alpha = SCENARIOS[scenario]
    path = trial.decoded[name]
    wanted = np.stack([trial.affect[each.start : each.end].mean(axis=0) for each in path])
    return motion_of(path, select(path, wanted, trial.pool, paper_weights(alpha)))


def alike(ones: Sequence[FloatArray], others: Sequence[FloatArray]) -> str:
    """Mean and deviation of canonical correlations, and the mean with the next recording's counterpart."""
    own = [canonical_correlation(one, other) for one, other in zip(ones, others, strict=True)]
    chance = []
    for one, other in zip(ones, [*others[1:], others[0]], strict=True):
        count_ = min(len(one), len(other))
        chance.append(canonical_correlation(one[:count_], other[:count_]))
    return f"{np.mean(own):.3f} ({np.std(own):.3f}), chance {np.mean(chance):.3f}"


def divergences(trials: Sequence[Trial], name: str, clusters: int) -> tuple[float, float]:
    """Of the shares of states in frames, and of durations."""
    shares, durations = [], []
    for paths in ([trial.original for trial in trials], [trial.decoded[name] for trial in trials]):
        states = np.concatenate([states_by_frame(path) for path in paths])
        frames = [min(segment.frames, LONGEST_FRAMES) for path in paths for segment in path]
        shares.append(np.bincount(states, minlength=clusters) / len(states))
        durations.append(np.bincount(frames, minlength=LONGEST_FRAMES + 1) / len(frames))
    return symmetric_divergence(*shares), symmetric_divergence(*durations)


def choose(pairs: Sequence[MotionPair], affects: Sequence[FloatArray]) -> None:
    """Figure 3: the correlation of angles and affect within clusters."""
    kept, whole = correlations(pairs, affects, CHOICES)
    for clusters, each in (*kept.items(), ("no", whole)):
        print(
            f"{clusters} clusters: "
            + ", ".join(f"{name} {value:.3f}" for name, value in zip(DIMENSIONS, each, strict=True))
        )
    print(f"fewest that keep the whole's: {fewest_clusters(kept, whole)} (theirs 40)", flush=True)


def report(trials: Sequence[Trial], clusters: int) -> None:
    """Tables 2 to 5 and figure 4."""
    original = [trial.pair.angles for trial in trials]
    print("\nfeatures and original movement: theirs, ours; divergence of states / durations: theirs, ours")
    for name, (theirs, *their_divergences) in THEIR_FEATURES.items():
        told, ours = (
            "/".join(f"{value:.2f}" for value in values)
            for values in (their_divergences, divergences(trials, name, clusters))
        )
        near = alike([trial.features[name] for trial in trials], original)
        print(f"f^{name:3s} {theirs:.2f}   {near}   {told}   {ours}", flush=True)
    print("\nsynthesised movement and the original, and affect: theirs, ours; difference of kinetic energy")
    others = [original, *([trial.affect[:, place, None] for trial in trials] for place in range(len(DIMENSIONS)))]
    for scenario, theirs_all in THEIR_MOVEMENTS.items():
        made = [synthesised(trial, scenario) for trial in trials]
        for name, theirs, other in zip(("movement", *DIMENSIONS), theirs_all, others, strict=True):
            print(f"{scenario}  {name:10s} {theirs:.3f}   {alike(made, other)}")
        energies = [energy_difference(one, other, FRAME_S) for one, other in zip(made, original, strict=True)]
        print(f"{scenario}  energy     {np.mean(energies):.2f}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--paired", type=Path, default=Path("../shared/data/paired/tilburg"))
    parser.add_argument("--clusters", type=int, default=40)
    parser.add_argument("--choose", action="store_true")
    arguments = parser.parse_args()
    pairs = read_pairs(arguments.paired)
    affects = affects_of(pairs)
    if arguments.choose:
        choose(pairs, affects)
    report(trials_of(pairs, affects, arguments.clusters), arguments.clusters)


if __name__ == "__main__":
    main()
