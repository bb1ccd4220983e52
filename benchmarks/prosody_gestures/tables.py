"""Repeats RTS' tables 3.1 and 3.2: speed of the decoder and similarity of its result with steps m and n best states.

    python -m benchmarks.prosody_gestures.tables [--paired FOLDER] [--performed FOLDER] [--clusters N] [--model NAME …]
        [--trials N]

Real-time factor: processor time of the decode over the length of the speech, unit selection and features left out, as
theirs. Similarity: the share of frames in the state of the full decode (m = 1, n = all). Models: on the paired
recordings kinds of arm movements, found by clustering, with labels of intonation phrases (RTS) or mixtures over prosody
(AHG), learnt from one session and decoded on the other, both ways; on our own schedules one state a gesture lexeme,
TIMIT's speakers left out in fours. "Drawn" is what the mixtures' model itself might say: paths drawn from it, and
features from these, so that the voice tells as much as the model believes.

"As printed" is Algorithm 1 with the n best states of the frame before, whatever the duration; theirs are their figures
on their machine and data. At the end the live decoder: m = 1, n = all, and what its bound costs.
"""

import argparse
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType

import numpy as np

from training.prosody_gestures.parts import learn_part
from training.prosody_gestures.performed import SYNC_POINTS
from training.prosody_gestures.performed_lines import read_performed
from understudy.library.motion_models import Learning, read_pairs
from understudy.model import FloatArray
from understudy.models import load_realizer
from understudy.motion_models.model import LABELS
from understudy.motion_models.scoring import Trial as LeftOut
from understudy.motion_models.scoring import left_out_trials
from understudy.prosody_gestures.live_decoder import Commitment, LiveDecoder
from understudy.prosody_gestures.semi_markov import (
    FRAME_S,
    IntArray,
    MixtureEmissions,
    Segment,
    SemiMarkovModel,
    segments_of,
    similarity,
    states_by_frame,
)
from understudy.prosody_gestures.trellis import EVERYTHING, Search
from understudy.prosody_gestures.voice_model import decode

THEIRS = MappingProxyType(
    {
        10: "3 .4383/51, 4 .4779/56, 5 .5043/57, 6 .5472/57, 7 .6165/59, 8 .7067/57, 9 .7689/59, 10 .8103/59, "
        "11 .8548/59, 12 .8615/59",
        9: "3 .6520/59, 4 .7050/59, 5 .7303/59, 6 .7660/59, 7 .8501/62, 8 .9724/61, 9 .7723/63",
        8: "3 .5723/56, 4 .6360/51, 5 .6525/54, 6 .6872/55, 7 .7417/55, 8 .8436/59, 9 .9610/59",
        7: "3 .7331/58, 4 .8065/60, 5 .8393/58, 6 .8805/59, 7 .9754/58",
        6: "3 .8513/58, 4 .9066/58, 5 .9351/56, 6 .9663/58",
        5: "3 .8930/64",
    }
)
"""n, real-time factor / similarity in %, for each m."""

MODELS = ("labels", "mixtures", "drawn", "own")
BOUNDS_S = (0.1, 0.2, 0.4, 0.8, 1.6)

Decoder = Callable[[SemiMarkovModel, FloatArray], tuple[Segment, ...]]


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A model, and the log likelihoods of a recording that it has not heard (frames × states)."""

    model: SemiMarkovModel
    log_likelihoods: FloatArray


def as_printed(model: SemiMarkovModel, log_likelihoods: FloatArray, search: Search) -> tuple[Segment, ...]:
    """Algorithm 1, every predecessor among the n best states of the frame before, at whatever boundary it ended."""
    frames, states = log_likelihoods.shape
    emitted = np.vstack([np.zeros(states), np.cumsum(log_likelihoods, axis=0)])
    scores, lasted, before = (np.zeros((frames + 1, states), dtype=kind) for kind in (np.float64, np.intp, np.intp))
    best = np.arange(states)
    columns = np.arange(states)
    for now in range(1, frames + 1):
        durations = np.arange(1, min(model.longest_frames, now) + 1, search.step)
        chains = scores[now - durations][:, best, None] + model.log_transition[best]
        chains[durations == now] = model.log_initial
        chosen = chains.argmax(axis=1)
        through = np.take_along_axis(chains, chosen[:, None], axis=1)[:, 0]
        total = through + model.log_duration[:, durations - 1].T + emitted[now] - emitted[now - durations]
        longest = total.argmax(axis=0)
        scores[now], lasted[now] = total[longest, columns], durations[longest]
        before[now] = best[chosen[longest, columns]]
        best = np.argsort(-scores[now])[: search.best]
    state, end, path = int(scores[frames].argmax()), frames, list[Segment]()
    while end > 0:
        frames_lasted, previous = int(lasted[end, state]), int(before[end, state])
        path.append(Segment(state, end - frames_lasted, frames_lasted))
        end, state = end - frames_lasted, previous
    return tuple(path[::-1])


def paired_trials(folder: Path, kinds: int, most: int | None) -> tuple[list[Trial], list[Trial]]:
    """Each session's recordings, `most` of them, by models of the others': with labels, with mixtures."""
    pairs = read_pairs(folder, load_realizer())
    left_out, _ = left_out_trials(pairs, Learning(kinds))
    tested: list[LeftOut] = []
    for session in sorted({each.pair.session for each in left_out}):
        tested += [each for each in left_out if each.pair.session == session][:most]
    return _trials(tested, LABELS), _trials(tested, "p")


def _trials(tested: Sequence[LeftOut], features: str) -> list[Trial]:
    return [
        Trial(
            replace(each.model.kinds, emissions=each.model.emissions[features]),
            each.model.log_likelihoods(each.pair.voice, features),
        )
        for each in tested
    ]


def drawn_trials(mixed: Sequence[Trial], seed: int = 0) -> list[Trial]:
    """Paths and features drawn from the trials' models, as long as their recordings."""
    generator, trials = np.random.default_rng(seed), list[Trial]()
    for trial in mixed:
        model, emissions = trial.model, trial.model.emissions
        assert isinstance(emissions, MixtureEmissions), "features are drawn from mixtures"
        states, chances = list[int](), model.log_initial
        while len(states) < len(trial.log_likelihoods):
            state = int(generator.choice(len(chances), p=np.exp(chances)))
            frames = 1 + int(generator.choice(model.longest_frames, p=np.exp(model.log_duration[state])))
            states, chances = [*states, *[state] * frames], model.log_transition[state]
        kinds = [generator.choice(len(weights), p=np.exp(weights)) for weights in emissions.log_weights[states]]
        means, variances = emissions.means[states, kinds], emissions.variances[states, kinds]
        features = means + generator.normal(size=means.shape) * np.sqrt(variances)
        trials.append(Trial(model, emissions.log_likelihoods(features)))
    return trials


def own_trials(performed: Path, folds: int = 4) -> list[Trial]:
    """Lines of TIMIT by models of its other speakers' and RAVDESS': a state for rest, and for each lexeme met twice."""
    lines = read_performed(performed, ("timit", "ravdess"))
    lexemes = [_lexemes(performed / f"{line.speaker}-{line.name}.npz") for line in lines]
    met = Counter(lexeme for each in lexemes for lexeme, _, _ in each)
    states = ("rest", *sorted(lexeme for lexeme, times in met.items() if times > 1))
    paths = [_phrases(each, states, len(line.rows)) for each, line in zip(lexemes, lines, strict=True)]
    speakers = sorted({line.speaker for line in lines if line.speaker.startswith("timit")})
    trials = []
    for fold in range(folds):
        held_out = set(speakers[fold::folds])
        examples = [(line.rows, path) for line, path in zip(lines, paths, strict=True) if line.speaker not in held_out]
        part = learn_part("hands", states, [(rows, segments_of(path)) for rows, path in examples])
        trials += [Trial(part.model, part.log_likelihoods(line.rows)) for line in lines if line.speaker in held_out]
    return trials


def _lexemes(path: Path) -> list[tuple[str, float, float]]:
    with np.load(path) as arrays:
        gestures = arrays["kind"] == "gesture"
        bounds = arrays["sync_s"][gestures][:, [SYNC_POINTS.index("start"), SYNC_POINTS.index("end")]]
        return [
            (str(lexeme), float(each[0]), float(each[1]))
            for lexeme, each in zip(arrays["lexeme"][gestures], bounds, strict=True)
        ]


def _phrases(lexemes: Sequence[tuple[str, float, float]], states: Sequence[str], frames: int) -> IntArray:
    path = np.zeros(frames, dtype=np.intp)
    for lexeme, start_s, end_s in lexemes:
        if lexeme in states:
            path[round(start_s / FRAME_S) : round(end_s / FRAME_S)] = states.index(lexeme)
    return path


def measured(trials: Sequence[Trial], decoder: Decoder, full: Sequence[IntArray]) -> tuple[float, float]:
    """Real-time factor and similarity over all trials."""
    began_s = time.process_time()
    found = [decoder(trial.model, trial.log_likelihoods) for trial in trials]
    spent_s = time.process_time() - began_s
    frames = sum(len(trial.log_likelihoods) for trial in trials)
    alike = similarity(np.concatenate([states_by_frame(path) for path in found]), np.concatenate(list(full)))
    return spent_s / (frames * FRAME_S), alike


def lived(model: SemiMarkovModel, log_likelihoods: FloatArray, commitment: Commitment) -> tuple[Segment, ...]:
    """The pieces of a live decode."""
    decoder = LiveDecoder(model, EVERYTHING, commitment)
    pieces = [piece for frame in log_likelihoods for piece in decoder.push(frame)]
    return tuple(piece.segment for piece in [*pieces, *decoder.finish()])


def report(name: str, trials: Sequence[Trial]) -> None:
    """The tables of one model."""
    full = [states_by_frame(decode(trial.model, trial.log_likelihoods)) for trial in trials]
    factor, _ = measured(trials, decode, full)
    frames, states = sum(map(len, full)), len(trials[0].model.states)
    held = len(set(np.concatenate(full).tolist()))
    print(f"\n{name}: {frames * FRAME_S / 60:.1f} minutes, {states} states, of which the full decode takes {held}")
    print(f"m = 1, n = all: {factor:.4f}")
    print("  m   n   theirs        as printed    ours")
    for step, row in THEIRS.items():
        for cell in row.split(", "):
            best, their_factor, their_share = cell.replace("/", " ").split()
            search = Search(step, int(best))
            printed = measured(trials, partial(as_printed, search=search), full)
            ours = measured(trials, partial(decode, search=search), full)
            cells = "   ".join(f"{factor:.4f}/{100 * share:5.1f}" for factor, share in (printed, ours))
            print(f"{step:3d} {best:>3s}   {their_factor:>6s}/{their_share}     {cells}", flush=True)
    for search in (Search(1, 3), Search(1, 12), Search(2), Search(2, 12), Search(3), Search(5)):
        factor, share = measured(trials, partial(decode, search=search), full)
        print(
            f"{search.step:3d} {search.best or 'all':>3}                                {factor:.4f}/{100 * share:5.1f}"
        )
    for bound_s in BOUNDS_S:
        commitment = Commitment(round(bound_s / FRAME_S), 4, beam=8.0)
        factor, share = measured(trials, partial(lived, commitment=commitment), full)
        print(f"live, decided within {bound_s:.1f} s: {factor:.4f}/{100 * share:5.1f}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--paired", type=Path, default=Path("../shared/data/paired/tilburg"))
    parser.add_argument("--performed", type=Path)
    parser.add_argument("--clusters", type=int, default=40)
    parser.add_argument("--trials", type=int, help="so many recordings of each session are decoded")
    parser.add_argument("--model", nargs="+", choices=MODELS, default=MODELS)
    arguments = parser.parse_args()
    if set(arguments.model) - {"own"}:
        labelled, mixed = paired_trials(arguments.paired, arguments.clusters, arguments.trials)
        if "labels" in arguments.model:
            report("paired recordings, labels of intonation phrases", labelled)
        if "mixtures" in arguments.model:
            report("paired recordings, mixtures", mixed)
        if "drawn" in arguments.model:
            report("drawn from the mixtures' models", drawn_trials(mixed))
    if "own" in arguments.model and arguments.performed:
        report("our own schedules, TIMIT", own_trials(arguments.performed))


if __name__ == "__main__":
    main()
