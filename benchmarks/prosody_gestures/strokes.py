"""Where the voice alone puts strokes, against directors, the rules and chance.

    python -m benchmarks.prosody_gestures.strokes PERFORMED [--directing FOLDER] [--folds N]

PERFORMED is the folder of `training.prosody_gestures.performed` with --directing. First, on speakers left out: models
learnt from the other folds' speakers, their strokes against those of the rules on the same recordings, a hit where
both begin on words at most one apart. Then, with the shipped model, the directors' lines by score.py: strokes within a
word of a director's. Each beside the prosody mode (directors' lines only) and chance: the same strokes, all of a line's
moved round it by one random time, so that their number and spacing stay. Live decodes wait as the live mode does; a
stroke counts where it is, "late" where it can be performed at the earliest, when it was decided. The last rows have
other bounds than the shipped one.
"""

import argparse
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from benchmarks.acting.directing import AFTER_STROKE_S, READERS, load_score
from training.prosody_gestures.performed_lines import HANDS, STROKE, PerformedLine, learn, read_performed, strokes_of
from training.prosody_gestures.train import CORPORA, FILE
from understudy.model import FRAME_SHIFT_S
from understudy.prosody_gestures.live_decoder import Commitment
from understudy.prosody_gestures.live_gestures import COMMITMENT, LiveGestures
from understudy.prosody_gestures.semi_markov import FRAME_S
from understudy.prosody_gestures.voice_model import VoiceModel
from understudy.resources import resource_folder

DRAWS = 20
CHUNK_FRAMES = 4
"""Contours are heard .04 s at a time."""

OTHERS = MappingProxyType(
    {
        f"bound {frames * FRAME_S:.2f} s": Commitment(frames, each, 8.0)
        for frames, each in ((2, 2), (4, 4), (16, 4), (32, 8))
    }
)

Strokes = Sequence[tuple[float, float]]
"""Where each stroke begins and ends, in seconds."""


def decoded(model: VoiceModel, line: PerformedLine) -> Strokes:
    """The strokes of the full decode."""
    found = strokes_of(model.decode(line.energy_db, line.f0_hz)["hands"])
    return [(stroke.start * FRAME_S, stroke.end * FRAME_S) for stroke in found]


def lived(model: VoiceModel, line: PerformedLine, commitment: Commitment) -> tuple[Strokes, Strokes]:
    """The strokes of the live decode: where they are, and when they can be performed."""
    live, where, when = (
        LiveGestures(model, commitment=commitment),
        list[tuple[float, float]](),
        list[tuple[float, float]](),
    )
    for first in range(0, len(line.f0_hz) + CHUNK_FRAMES, CHUNK_FRAMES):
        last = first + CHUNK_FRAMES
        ended = first >= len(line.f0_hz)
        phases = live.finish() if ended else live.hear(line.energy_db[first:last], line.f0_hz[first:last])
        for phase in phases:
            if phase.part == "hands" and phase.state == HANDS[STROKE]:
                late_s = max(0.0, last * FRAME_SHIFT_S - phase.start_s)
                if phase.begins:
                    where.append((phase.start_s, phase.end_s))
                    when.append((phase.start_s + late_s, phase.end_s + late_s))
                else:
                    longer_s = phase.end_s - where[-1][1]
                    where[-1] = (where[-1][0], phase.end_s)
                    when[-1] = (when[-1][0], when[-1][1] + longer_s)
    return where, when


def moved_round(strokes: Strokes, line: PerformedLine, generator: np.random.Generator) -> Strokes:
    """All strokes of a line moved by one random time, round from its last word to its first."""
    first_s, last_s = line.word_s[0, 0], line.word_s[-1, 1]
    by_s = generator.uniform(0, last_s - first_s)
    moved = [first_s + (begin - first_s + by_s) % (last_s - first_s) for begin, _ in strokes]
    return [(begin, begin + end - start) for begin, (start, end) in zip(moved, strokes, strict=True)]


def word_at(line: PerformedLine, time_s: float) -> int:
    """The place of the word that is spoken at a time, or nearest to it."""
    outside = np.maximum(line.word_s[:, 0] - time_s, time_s - line.word_s[:, 1])
    return int(np.maximum(outside, 0).argmin())


def against_rules(found: Mapping[str, Strokes], lines: Sequence[PerformedLine]) -> tuple[float, float, float, int]:
    """F, precision, recall and number of strokes within a word of the rules'."""
    hits = met = told = asked = 0
    for line in lines:
        theirs = [word_at(line, begin) for begin, _ in line.strokes_s]
        ours = [word_at(line, begin) for begin, _ in found[line.name]]
        hits += sum(any(abs(one - other) <= 1 for other in theirs) for one in ours)
        met += sum(any(abs(one - other) <= 1 for other in ours) for one in theirs)
        told, asked = told + len(ours), asked + len(theirs)
    precision, recall = hits / max(told, 1), met / max(asked, 1)
    return 2 * precision * recall / max(precision + recall, 1e-9), precision, recall, told


class Directors:
    """score.py's judgement of strokes on the directors' lines."""

    def __init__(self, folder: Path) -> None:
        self._score: Any = load_score(folder, {})
        self._records = [self._score.read(folder / name) for name in READERS]

    def __call__(self, found: Mapping[str, Strokes], lines: Sequence[PerformedLine]) -> tuple[float, float, float, int]:
        total: Counter[str] = Counter()
        for line in lines:
            words = [int(line.words[word_at(line, end + AFTER_STROKE_S)]) for _, end in found[line.name]]
            gestures = [(word, ["present"]) for word in words]
            total += self._score.judge([record[line.name] for record in self._records], gestures)
        precision, recall = total["placed"] / max(total["n"], 1), total["met"] / total["moments"]
        return self._score.f_of(precision, recall), precision, recall, total["n"]


Judge = Callable[[Mapping[str, Strokes], Sequence[PerformedLine]], tuple[float, float, float, int]]


def report(name: str, judge: Judge, found: Mapping[str, Strokes], lines: Sequence[PerformedLine]) -> None:
    """A row of the table, with chance."""
    f, precision, recall, count = judge(found, lines)
    generator, chances = np.random.default_rng(0), []
    for _ in range(DRAWS):
        moved = {line.name: moved_round(found[line.name], line, generator) for line in lines}
        chances.append(judge(moved, lines)[0])
    seconds = sum(line.duration_s for line in lines)
    print(
        f"{name:34s} F {f:.3f} (chance {np.mean(chances):.3f} ± {np.std(chances):.3f}), precision {precision:.3f}, "
        f"recall {recall:.3f}, {count} strokes, {count / seconds:.2f} a second"
    )


def speakers_left_out(lines: Sequence[PerformedLine], folds: int) -> None:
    """Strokes on the lines of speakers that were left out, against the rules'."""
    speakers = sorted({line.speaker for line in lines})
    found: dict[str, Strokes] = {}
    for fold in range(folds):
        held_out = set(speakers[fold::folds])
        model = learn([line for line in lines if line.speaker not in held_out])
        found |= {line.name: decoded(model, line) for line in lines if line.speaker in held_out}
    for corpus in CORPORA:
        own = [line for line in lines if line.speaker.startswith(corpus)]
        report(f"speakers left out, {corpus}", against_rules, found, own)


def directors_lines(performed: Path, directing: Path) -> None:
    """Strokes on the directors' lines."""
    judge = Directors(directing)
    lines, beaten = read_performed(performed, ("semantic",)), read_performed(performed, ("prosody",))
    model = VoiceModel.load(resource_folder("models") / "prosody_gestures" / FILE)
    report("the rules", judge, {line.name: line.strokes_s.tolist() for line in lines}, lines)
    report("prosody mode", judge, {line.name: line.strokes_s.tolist() for line in beaten}, lines)
    report("the voice alone, full decode", judge, {line.name: decoded(model, line) for line in lines}, lines)
    for name, commitment in (("live", COMMITMENT), *OTHERS.items()):
        live = {line.name: lived(model, line, commitment) for line in lines}
        report(f"the voice alone, {name}", judge, {each: where for each, (where, _) in live.items()}, lines)
        report(f"the voice alone, {name}, late", judge, {each: when for each, (_, when) in live.items()}, lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("performed", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--folds", type=int, default=4)
    arguments = parser.parse_args()
    speakers_left_out(read_performed(arguments.performed, CORPORA), arguments.folds)
    directors_lines(arguments.performed, arguments.directing)


if __name__ == "__main__":
    main()
