"""Where the voice alone puts strokes, against directors, the rules and chance.

    python -m benchmarks.prosody_gestures.strokes PERFORMED [--directing FOLDER] [--folds N]

PERFORMED is the folder of `training.prosody_gestures.performed` with --directing. First, on speakers left out: models
learnt from the other folds' speakers, their strokes against those of the rules on the same recordings, a hit where
both begin on words at most one apart. Then, with the shipped model, the directors' lines by score.py: strokes within a
word of a director's. Each beside the prosody mode (directors' lines only) and chance: the same strokes, all of a line's
moved round it by one random time, so that their number and spacing stay. Live strokes are those announced; one counts
where it is, "late" where it can be performed at the earliest, when it was announced. "Beaten" are the beats that a live
stream makes of what is announced, f0 as late as it comes at the latest.
"""

import argparse
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.behavior.directing import AFTER_STROKE_S, READERS, load_score
from benchmarks.prosody_gestures.tables import lived as committed
from training.prosody_gestures.performed_lines import HANDS, STROKE, PerformedLine, learn, read_performed, strokes_of
from training.prosody_gestures.train import CORPORA, FILE
from understudy.acoustic.pitch.streaming import LATEST_S as PITCH_LATEST_S
from understudy.files import resource_folder
from understudy.live.agenda import Placer
from understudy.live.movements import LiveEvent, Movements
from understudy.live.table import FILE as LIVE
from understudy.live.table import LiveTable
from understudy.model import DEFAULT_CHARACTER, FRAME_SHIFT_S, Behavior
from understudy.models import load_characters
from understudy.prosody_gestures.live_gestures import COMMITMENT, LiveGestures
from understudy.prosody_gestures.prosody import features, in_context, raw_frames
from understudy.prosody_gestures.semi_markov import FRAME_S, states_by_frame
from understudy.prosody_gestures.voice_model import VoiceModel, decode

DRAWS = 20
CHUNK_FRAMES = 4
"""Contours are heard .04 s at a time."""

Strokes = Sequence[tuple[float, float]]
"""Where each stroke begins and ends, in seconds."""


def decoded(model: VoiceModel, line: PerformedLine) -> Strokes:
    """The strokes of the full decode."""
    found = strokes_of(model.decode(line.energy_db, line.f0_hz)["hands"])
    return [(stroke.start * FRAME_S, stroke.end * FRAME_S) for stroke in found]


def lived(model: VoiceModel, line: PerformedLine) -> tuple[Strokes, Strokes]:
    """The strokes that are announced live: where they are, and when they can be performed."""
    live, states = LiveGestures(model), list[tuple[str, float, float]]()
    for first in range(0, len(line.f0_hz) + CHUNK_FRAMES, CHUNK_FRAMES):
        last = first + CHUNK_FRAMES
        ended = first >= len(line.f0_hz)
        phases = live.finish() if ended else live.hear(line.energy_db[first:last], line.f0_hz[first:last])
        told = (phase for phase in phases if phase.part == "hands" and not phase.decided)
        states += [(phase.state, phase.start_s, max(phase.start_s, last * FRAME_SHIFT_S)) for phase in told]
    states.append(("", line.duration_s, line.duration_s))
    found = [(one[1], other[1]) for one, other in pairwise(states) if one[0] == HANDS[STROKE]]
    late = [(one[2], one[2] + other[1] - one[1]) for one, other in pairwise(states) if one[0] == HANDS[STROKE]]
    return found, late


def beats_of(model: VoiceModel, line: PerformedLine, movements: Movements) -> Strokes:
    """The strokes of the beats of a live stream."""
    live, beats = LiveGestures(model), dict[str, Behavior]()
    for first in range(0, len(line.f0_hz), CHUNK_FRAMES):
        last = first + CHUNK_FRAMES
        now_s = last * FRAME_SHIFT_S + PITCH_LATEST_S
        phases = live.hear(line.energy_db[first:last], line.f0_hz[first:last])
        for phase in phases:
            if phase.part == "hands" and not phase.decided:
                beats |= {
                    each.id: each
                    for each in movements.moved(LiveEvent(phase.part, phase.state, phase.start_s, now_s), now_s)
                }
    syncs = (each.sync for each in beats.values())
    return [(sync.stroke_start or 0.0, sync.stroke_end or 0.0) for sync in syncs]


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
    live = {line.name: lived(model, line) for line in lines}
    report("the voice alone, live", judge, {each: where for each, (where, _) in live.items()}, lines)
    characters = load_characters()
    table = LiveTable.load(resource_folder("lexicon") / LIVE, characters.behavior_names)
    character = characters.named(DEFAULT_CHARACTER)
    beats = {line.name: beats_of(model, line, Movements(table, Placer.of(character, 0))) for line in lines}
    report("the voice alone, live, late", judge, {each: when for each, (_, when) in live.items()}, lines)
    report("the voice alone, live, beaten", judge, beats, lines)
    report_decided(model, lines)


def report_decided(model: VoiceModel, lines: Sequence[PerformedLine]) -> None:
    """How much of what is decided live, as shipped, is the full decode, and what that costs; of all parts."""
    told = alike = 0
    spent_s = 0.0
    for line in lines:
        rows = in_context(features(raw_frames(line.energy_db, line.f0_hz)))
        for part in model.parts:
            likelihoods = part.log_likelihoods(rows)
            full = states_by_frame(decode(part.model, likelihoods))
            began_s = time.process_time()
            decided = states_by_frame(committed(part.model, likelihoods, COMMITMENT))
            spent_s += time.process_time() - began_s
            told, alike = told + len(full), alike + int((full == decided).sum())
    factor = spent_s * len(model.parts) / (told * FRAME_S)
    print(f"decided live: {100 * alike / told:.1f} % of frames as the full decode, {factor:.4f} × real time")


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
