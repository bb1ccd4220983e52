"""Teaches the network that hears a line's focus: models/focus/focus.npz (models/focus/README.md).

    python -m training.focus DELIVERIES_FOLDER REAL_FOLDER --lines DELIVERIES.jsonl [--output models/focus/focus.npz]
        [--without VOICE]

The folders are made by `training/focus/speaking.py` and `training/focus/refocusing.py`. `--without` leaves a voice out,
for `benchmarks/acoustic/focus.py`. Needs torch.
"""

import argparse
import json
import pickle
from pathlib import Path

import numpy as np

from training.focus.hearing import ROOT, HeardLine, hear, usual_seconds
from training.focus.network import Lesson, arrays, taught
from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.focus.focus_model import FocusModel
from understudy.acoustic.focus.listeners import Listeners

NETWORKS = 3
ROUNDS = 40
WITHOUT_FOCUS = 2.0
"""What real speech as it is counts beside a line with a known focus."""


def main() -> None:
    """Hears the recordings, teaches and writes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deliveries", type=Path)
    parser.add_argument("real", type=Path)
    parser.add_argument("--lines", type=Path, required=True)
    parser.add_argument("--output", type=Path, default=ROOT / "models" / "focus" / "focus.npz")
    parser.add_argument("--without", action="append", default=[], metavar="VOICE")
    options = parser.parse_args()
    heard = heard_lines((options.deliveries, options.real), options.lines)
    model = teach([line for line in heard if line.voice not in options.without])
    write(model, options.output)


def heard_lines(folders: tuple[Path, ...], lines: Path) -> list[HeardLine]:
    """The recordings of all folders; what was heard once is kept in each folder's `heard.pickle`."""
    entries = map(json.loads, lines.read_text().splitlines())
    texts = {entry["id"]: " ".join(word.split(":", 1)[1] for word in entry["words"]) for entry in entries}
    listeners = Listeners.load(ROOT / "models" / "focus" / "emphases.onnx")
    found: list[HeardLine] = []
    with Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner:
        for folder in folders:
            kept = folder / "heard.pickle"
            if not kept.exists():
                kept.write_bytes(pickle.dumps(list(hear(folder, texts, (aligner, listeners)))))
            found += pickle.loads(kept.read_bytes())
    return found


def teach(heard: list[HeardLine]) -> FocusModel:
    """The model taught on these lines."""
    lessons = [Lesson.of(line, WITHOUT_FOCUS) for line in heard]
    return FocusModel(
        usual_seconds(), **arrays([taught(lessons, seed=seed, rounds=ROUNDS) for seed in range(NETWORKS)])
    )


def write(model: FocusModel, path: Path) -> None:
    """Writes the file that `FocusModel.load` reads."""
    layers = {
        name: np.asarray(getattr(model, name), np.float32)
        for name in ("first", "first_bias", "second", "second_bias", "last", "last_bias")
    }
    phones = np.array(list(model.usual_s))
    usual_s = np.array(list(model.usual_s.values()))
    np.savez_compressed(path, allow_pickle=False, **layers, phones=phones, usual_s=usual_s)


if __name__ == "__main__":
    main()
