"""Performs recordings by the rules, and saves the behaviours with the prosody as training data.

    python -m training.prosody_gestures.performed OUT [--speech FOLDER] [--ravdess N] [--directing FOLDER]

Performs the English recordings with a text of FOLDER (default ../shared/data/speech): TIMIT, `lines`, and N of RAVDESS
an actor, drawn by chance; with --directing also the lines that three directors read, in both modes, to be measured on
and never learnt from. OUT takes a file a line, `CORPUS-SPEAKER-NAME.npz`, written whole or not at all; lines that are
there already are not performed again. Some second of processor time a line.
"""

import argparse
import csv
import json
import random
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from understudy.errors import UnderstudyError
from understudy.model import Analysis, Line, Mode, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import analyze, perform_analysis
from understudy.settings import Settings

SPEECH = Path("../shared/data/speech")
SENTENCES = {"01": "Kids are talking by the door.", "02": "Dogs are sitting by the door."}
"""What RAVDESS' actors say."""

SYNC_POINTS = ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end")


@dataclass(frozen=True, slots=True)
class Recording:
    """A recording and its text; `mode` is how it is performed."""

    corpus: str
    speaker: str
    name: str
    path: Path
    text: str
    mode: Mode = Mode.SEMANTIC

    @property
    def file_name(self) -> str:
        return f"{self.corpus}-{self.speaker}-{self.name}.npz"


def timit(speech: Path) -> Iterator[Recording]:
    for path in sorted((speech / "timit").glob("*/*.flac")):
        text = path.with_suffix(".txt").read_text().split(maxsplit=2)[2].strip()
        yield Recording("timit", path.parent.name.split("-")[1], path.stem, path, text)


def lines(speech: Path) -> Iterator[Recording]:
    for path in sorted((speech / "lines").glob("*.flac")):
        yield Recording("lines", path.stem.split("-")[0], path.stem, path, path.with_suffix(".txt").read_text().strip())


def ravdess(speech: Path, count: int) -> Iterator[Recording]:
    """`count` recordings of each actor."""
    by_speaker = defaultdict(list)
    with (speech / "labels.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            if row["corpus"] == "ravdess":
                by_speaker[row["speaker"]].append(row)
    for speaker, rows in sorted(by_speaker.items()):
        for row in random.Random(speaker).sample(rows, min(count, len(rows))):
            path = speech / row["file"]
            yield Recording("ravdess", speaker, path.stem, path, SENTENCES[row["sentence"]])


def directed(directing: Path) -> Iterator[Recording]:
    """The directors' lines, performed from the meaning and from the stress."""
    for line in map(json.loads, (directing / "dev-lines.jsonl").read_text().splitlines()):
        text = " ".join(word.split(":", 1)[1] for word in line["words"])
        for mode in (Mode.SEMANTIC, Mode.PROSODY):
            yield Recording(mode.value, "dev", line["id"], directing / "audio" / f"{line['id']}.flac", text, mode)


def kept(analysis: Analysis, performance: Performance) -> dict[str, object]:
    """What a line's file holds. Times are seconds, NaN where a point is not set; contours have a row each .01 s."""
    assert analysis.heard is not None, "recordings are heard"
    behaviors = [behavior for behavior in performance.behaviors if behavior.kept]
    words = [word for word in performance.utterance.words if word.interval]
    memberships = analysis.heard.agitation
    return {
        "f0_hz": analysis.heard.contours.f0_hz.astype(np.float32),
        "energy_db": analysis.heard.contours.energy_db.astype(np.float32),
        "agitation": np.array([memberships.low, memberships.medium, memberships.high]),
        "duration_s": np.array(performance.utterance.duration_s),
        "word": np.array([word.index for word in words]),
        "word_s": np.array([(word.interval.start_s, word.interval.end_s) for word in words if word.interval]),
        "kind": np.array([behavior.kind.value for behavior in behaviors]),
        "lexeme": np.array([behavior.lexeme for behavior in behaviors]),
        "hand": np.array([behavior.hand.value if behavior.hand else "" for behavior in behaviors]),
        "by_itself": np.array([behavior.rule is None for behavior in behaviors]),
        "sync_s": np.array(
            [[_or_nan(getattr(behavior.sync, point)) for point in SYNC_POINTS] for behavior in behaviors]
        ).reshape(-1, len(SYNC_POINTS)),
    }


def _or_nan(time_s: float | None) -> float:
    return float("nan") if time_s is None else time_s


def perform_all(recordings: list[Recording], output: Path) -> None:
    output.mkdir(parents=True, exist_ok=True)
    with Understudy.load(Settings()) as understudy:
        for recording in recordings:
            path = output / recording.file_name
            if path.exists():
                continue
            try:
                analysis = analyze(understudy, Line(recording.path.read_bytes(), recording.text))
            except UnderstudyError as error:
                print(f"{recording.path}: {error.message}", flush=True)
                continue
            performance = perform_analysis(understudy, analysis, Options(mode=recording.mode))
            unfinished = path.with_suffix(".unfinished")
            with unfinished.open("wb") as file:
                np.savez_compressed(file, **kept(analysis, performance))  # type: ignore[arg-type]
            unfinished.rename(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--speech", type=Path, default=SPEECH)
    parser.add_argument("--ravdess", type=int, default=15)
    parser.add_argument("--directing", type=Path)
    arguments = parser.parse_args()
    recordings = [*timit(arguments.speech), *lines(arguments.speech), *ravdess(arguments.speech, arguments.ravdess)]
    if arguments.directing:
        recordings += directed(arguments.directing)
    perform_all(recordings, arguments.output)


if __name__ == "__main__":
    main()
