"""Learns the models of gestures from the voice, from what the rules performed, and ships them.

    python -m training.prosody_gestures.train PERFORMED [--output models/prosody_gestures]

PERFORMED is the folder that `training.prosody_gestures.performed` filled; the directors' lines in it are not looked
at. How well a model does on speakers it has not heard is told by `python -m benchmarks.prosody_gestures.strokes`. To
learn from recordings with motion instead, see `training.prosody_gestures.train_pairs`.
"""

import argparse
from pathlib import Path

from training.prosody_gestures.performed_lines import learn, read_performed

CORPORA = ("timit", "lines", "ravdess")
FILE = "voice.npz"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("performed", type=Path)
    parser.add_argument("--output", type=Path, default=Path("models/prosody_gestures"))
    arguments = parser.parse_args()
    lines = read_performed(arguments.performed, CORPORA)
    arguments.output.mkdir(parents=True, exist_ok=True)
    path = arguments.output / FILE
    learn(lines).save(path)
    seconds = sum(line.duration_s for line in lines)
    speakers = len({line.speaker for line in lines})
    print(
        f"{path}: {path.stat().st_size / 1000:.0f} kB, from {len(lines)} lines of {speakers} speakers, {seconds:.0f} s"
    )


if __name__ == "__main__":
    main()
