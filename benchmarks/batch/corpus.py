"""A script of any length from the speech in ../shared, its recordings repeated where needed.

TIMIT (8 speakers, 10 sentences each, as it is spelt), six recordings of books and speeches, and RAVDESS (16 actors, two
sentences in several moods).
"""

import csv
from collections.abc import Iterator
from itertools import cycle, islice
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SPEECH = ROOT.parent / "shared" / "data" / "speech"
RAVDESS = {"01": "Kids are talking by the door.", "02": "Dogs are sitting by the door."}


def recordings(speech: Path) -> list[tuple[Path, str, str]]:
    """Each recording with its speaker and its words."""
    return [*_timit(speech), *_lines(speech), *_ravdess(speech)]


def write_script(folder: Path, lines: int, speech: Path = SPEECH) -> Path:
    """Makes `lines.csv` and the folder `audio` of links to the recordings; lines repeat in order."""
    audio = folder / "audio"
    audio.mkdir(parents=True)
    script = folder / "lines.csv"
    with script.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["id", "character", "text"])
        for number, (path, speaker, text) in enumerate(islice(cycle(recordings(speech)), lines)):
            name = f"line{number:05}"
            (audio / f"{name}{path.suffix}").symlink_to(path)
            writer.writerow([name, speaker, text])
    return script


def _timit(speech: Path) -> Iterator[tuple[Path, str, str]]:
    for path in sorted((speech / "timit").glob("dr*/*.flac")):
        yield path, path.parent.name, " ".join(path.with_suffix(".txt").read_text().split()[2:])


def _lines(speech: Path) -> Iterator[tuple[Path, str, str]]:
    for path in sorted((speech / "lines").glob("*.flac")):
        yield path, path.stem.split("-")[0], path.with_suffix(".txt").read_text(encoding="utf-8").strip()


def _ravdess(speech: Path) -> Iterator[tuple[Path, str, str]]:
    with (speech / "labels.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["corpus"] == "ravdess":
                yield speech / row["file"], f"actor{row['speaker']}", RAVDESS[row["sentence"]]
