"""Trains the model of mouth shapes from frames of sound, on TIMIT's hand-labelled phones, and ships it.

    python -m training.live.mouth [--timit FOLDER] [--output models/live] [--held-out N]

One Gaussian a shape, all with the same covariance: that is, linear discriminants. The share of right frames is told on
the last N speakers, whom the shipped model has not heard either.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path
from types import MappingProxyType

import numpy as np

from understudy.acoustic.signal.decoding import decode
from understudy.acoustic.stage import audio_limits
from understudy.live.mouth import FEATURES, SHIFT_S, MouthFeatures
from understudy.model import SAMPLE_RATE_HZ, FloatArray
from understudy.settings import Settings

WINDOW_S = 0.025
RIDGE = 1e-2
SHAPES = MappingProxyType(
    {
        "sil": "h# pau epi",
        "PP": "p b m em pcl bcl",
        "FF": "f v",
        "TH": "th dh",
        "DD": "t d tcl dcl dx",
        "kk": "k g kcl gcl ng eng",
        "CH": "ch jh sh zh",
        "SS": "s z",
        "nn": "n en nx l el",
        "RR": "r er axr",
        "aa": "aa ah ay aw ax ax-h",
        "E": "eh ae ey",
        "I": "ih iy ix y",
        "O": "ao ow oy",
        "U": "uh uw ux w",
    }
)
_SHAPE_OF = MappingProxyType({phone: shape for shape, phones in SHAPES.items() for phone in phones.split()})


def examples(folder: Path) -> Iterator[tuple[FloatArray, str]]:
    """The rows of a speaker's recordings, each with its shape, where its phone has one."""
    for path in sorted(folder.glob("*.flac")):
        audio, _ = decode(path.read_bytes(), audio_limits(Settings()))
        phones = [line.split() for line in path.with_suffix(".phn").read_text().splitlines()]
        ends = np.array([int(end) for _, end, _ in phones]) / SAMPLE_RATE_HZ
        for place, row in enumerate(MouthFeatures().hear(audio.samples)):
            at = int(np.searchsorted(ends, place * SHIFT_S + WINDOW_S / 2, side="right"))
            shape = _SHAPE_OF.get(phones[min(at, len(phones) - 1)][2])
            if shape:
                yield row, shape


def fitted(rows: FloatArray, shapes: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Weights (features × shapes) and bias (shapes), every shape as likely as any other: a rare one is seen too."""
    names = list(SHAPES)
    means = np.array([rows[shapes == name].mean(axis=0) for name in names])
    within = sum(np.cov(rows[shapes == name].T, bias=True) * (shapes == name).mean() for name in names)
    weights = np.linalg.solve(within + RIDGE * np.eye(FEATURES), means.T)
    shares = np.array([(shapes == name).mean() for name in names])
    return weights, np.log(shares) / 2 - 0.5 * (means.T * weights).sum(axis=0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--timit", type=Path, default=Path("../shared/data/speech/timit"))
    parser.add_argument("--output", type=Path, default=Path("models/live"))
    parser.add_argument("--held-out", type=int, default=2)
    arguments = parser.parse_args()
    speakers = sorted(path for path in arguments.timit.iterdir() if path.is_dir())
    heard, unheard = speakers[: -arguments.held_out], speakers[-arguments.held_out :]
    rows, shapes = map(np.array, zip(*(each for folder in heard for each in examples(folder)), strict=True))
    weights, bias = fitted(rows, shapes)
    arguments.output.mkdir(parents=True, exist_ok=True)
    unfinished = arguments.output / "mouth.unfinished"
    with unfinished.open("wb") as file:
        arrays = {"weights": weights.astype(np.float32), "bias": bias.astype(np.float32)}
        np.savez_compressed(file, visemes=np.array(list(SHAPES)), **arrays)  # type: ignore[arg-type]
    unfinished.rename(arguments.output / "mouth.npz")
    rows, shapes = map(np.array, zip(*(each for folder in unheard for each in examples(folder)), strict=True))
    found = np.array(list(SHAPES))[(rows @ weights + bias).argmax(axis=1)]
    named, count = np.unique(shapes, return_counts=True)
    print(f"{len(heard)} speakers; right on {len(unheard)} others: {(found == shapes).mean():.3f} of frames")
    print(f"always the commonest ({named[count.argmax()]}): {count.max() / count.sum():.3f}")
    for name in SHAPES:
        own = shapes == name
        print(f"  {name:3s} {(found[own] == name).mean():.2f} of {own.sum()}")


if __name__ == "__main__":
    main()
