"""When heads move while people talk in meetings (AMI), and when the voice alone moves ours.

    python -m benchmarks.prosody_gestures.ami [--ami FOLDER] [--turns N]

AMI's recordings are not here, only its words in time. So the model hears a monotonous stand-in: voiced and even in
words, silent between them, with f0 falling by a fifth from pause to pause. All it can tell is where phrases begin, go
on and end. The rules read the same turns with their words; the prosody mode moves the head as they do. N turns of the
meetings that `benchmarks.bml.ami_heads` holds out, drawn by chance, of people who are seen. F of movements, nods,
shakes and others alike, that begin within a word of one of the person's; chance moves all of a turn's round it by one
random time. Beside them, what phrases alone tell: a movement as each begins, or on its last word.
"""

import argparse
from collections.abc import Mapping, Sequence
from itertools import islice, pairwise
from pathlib import Path

import numpy as np

from benchmarks.bml.ami_heads import (
    AMI,
    BEFORE_S,
    drawn_turns,
    interval,
    movements_of,
    performed_turn,
    read_meetings,
    split,
)
from benchmarks.bml.schedule import Stages
from benchmarks.prosody_gestures.strokes import DRAWS
from training.prosody_gestures.train import FILE
from understudy.files import resource_folder
from understudy.model import FRAME_SHIFT_S, FloatArray, Word
from understudy.prosody_gestures.semi_markov import FRAME_S
from understudy.prosody_gestures.voice_model import VoiceModel

LOUD_DB, SILENT_DB = -25.0, -65.0
HIGHEST_HZ, FALL = 140.0, 0.2
FALL_S = 3.0
PAUSE_S = 0.2
NAMES = ("the rules, with the words", "the voice's stand-in", "where phrases begin", "on phrases' last words")


def stand_in(words: Sequence[Word]) -> tuple[FloatArray, FloatArray]:
    """Energy and f0 of a voice that says the words without any stress."""
    frames = int((interval(words[-1]).end_s + BEFORE_S) / FRAME_SHIFT_S)
    energy_db, f0_hz = np.full(frames, SILENT_DB), np.zeros(frames)
    phrase_s, before_s = interval(words[0]).start_s, interval(words[0]).start_s
    for span in map(interval, words):
        if span.start_s - before_s > PAUSE_S:
            phrase_s = span.start_s
        first, last = (round(time_s / FRAME_SHIFT_S) for time_s in (span.start_s, span.end_s))
        energy_db[first:last] = LOUD_DB
        f0_hz[first:last] = HIGHEST_HZ * (1 - FALL * min(1.0, (span.start_s - phrase_s) / FALL_S))
        before_s = span.end_s
    return energy_db, f0_hz


def places(words: Sequence[Word], times_s: FloatArray) -> FloatArray:
    """The words at which movements begin."""
    ends_s = np.array([interval(word).end_s for word in words])
    return np.minimum(np.searchsorted(ends_s, times_s), len(words) - 1)


Turns = Sequence[tuple[Sequence[Word], FloatArray]]
"""The words of each turn from its own time, and when the person's head begins to move."""


def agreement(turns: Turns, found: Sequence[FloatArray]) -> tuple[float, float, float]:
    """F, precision and recall of movements that begin within a word of the person's."""
    hits = met = told = asked = 0
    for (words, heads_s), ours_s in zip(turns, found, strict=True):
        apart = np.abs(places(words, ours_s)[:, None] - places(words, heads_s)[None]) <= 1
        hits, met = hits + int(apart.any(axis=1).sum()), met + int(apart.any(axis=0).sum())
        told, asked = told + len(ours_s), asked + len(heads_s)
    precision, recall = hits / max(told, 1), met / max(asked, 1)
    return 2 * precision * recall / max(precision + recall, 1e-9), precision, recall


def moved_round(words: Sequence[Word], times_s: FloatArray, generator: np.random.Generator) -> FloatArray:
    first_s, last_s = interval(words[0]).start_s, interval(words[-1]).end_s
    moved: FloatArray = first_s + (times_s - first_s + generator.uniform(0, last_s - first_s)) % (last_s - first_s)
    return moved


def phrase_edges(words: Sequence[Word]) -> tuple[FloatArray, FloatArray]:
    """When each stretch between pauses begins, and when its last word does."""
    spans = [interval(word) for word in words]
    paused = [other.start_s - one.end_s > PAUSE_S for one, other in pairwise(spans)]
    begins = [span.start_s for span, pause in zip(spans, [True, *paused], strict=True) if pause]
    ends = [span.start_s for span, pause in zip(spans, [*paused, True], strict=True) if pause]
    return np.array(begins), np.array(ends)


def read_turns(folder: Path, count: int) -> tuple[Turns, Mapping[str, list[FloatArray]]]:
    """The turns, and by what moves the head when it begins to in each."""
    _, held_out = split(read_meetings(folder))
    model, stages = VoiceModel.load(resource_folder("models") / "prosody_gestures" / FILE), Stages.load("default")
    seen = (
        (person, turn)
        for person, turn in drawn_turns(held_out)
        if person.heads and person.sees(interval(turn[0]).start_s)
    )
    turns: list[tuple[Sequence[Word], FloatArray]] = []
    found: Mapping[str, list[FloatArray]] = {name: [] for name in NAMES}
    for seed, (person, turn) in enumerate(islice(seen, count)):
        utterance, _, behaviors = performed_turn(stages, turn, seed)
        begin_s, last_s = interval(turn[0]).start_s - BEFORE_S, interval(turn[-1]).end_s
        heads = [head.interval.start_s - begin_s for head in person.heads if begin_s <= head.interval.start_s < last_s]
        turns.append((utterance.words, np.array(heads)))
        rules = np.array([movement.interval.start_s for movement in movements_of(behaviors, frozenset())])
        path = model.decode(*stand_in(utterance.words))["head"]
        voice = np.array([each.start * FRAME_S for each in path if each.state > 0])
        for name, times_s in zip(NAMES, (rules, voice, *phrase_edges(utterance.words)), strict=True):
            found[name].append(times_s)
    return turns, found


def report(name: str, turns: Turns, found: Sequence[FloatArray]) -> None:
    """A row, with chance."""
    f, precision, recall = agreement(turns, found)
    generator, chances = np.random.default_rng(0), list[float]()
    for _ in range(DRAWS):
        moved = [moved_round(words, own, generator) for (words, _), own in zip(turns, found, strict=True)]
        chances.append(agreement(turns, moved)[0])
    chance = f"chance {np.mean(chances):.3f} ± {np.std(chances):.3f}"
    count = sum(map(len, found))
    print(f"{name:28s} F {f:.3f} ({chance}), precision {precision:.3f}, recall {recall:.3f}, {count} movements")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ami", type=Path, default=AMI)
    parser.add_argument("--turns", type=int, default=300)
    arguments = parser.parse_args()
    turns, found = read_turns(arguments.ami, arguments.turns)
    print(f"{len(turns)} turns, {sum(len(heads) for _, heads in turns)} movements of people's heads")
    for name, each in found.items():
        report(name, turns, each)


if __name__ == "__main__":
    main()
