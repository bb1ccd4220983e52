"""A performed line as a moving picture for a page: animated WebP, 12 frames a second, the words below.

    .venv/bin/python examples/film.py examples/example.flac examples/example.txt -o docs/images/performed.webp

Our own body is drawn by the realizer's rasterizer, as on contact sheets.
"""

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import understudy
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.mannequin.skinning import Mannequin
from understudy.realizer.pictures.contact_sheet import Still, cell
from understudy.realizer.pictures.rasterizer import Camera

RATE_HZ = 12
VIEW = Camera((0.0, 1.17, 0.0), 1.45, azimuth=np.radians(25), elevation=np.radians(5))
QUALITY = 70
SHOWN_WORDS = 5


def main() -> None:
    """Performs, realizes, draws and writes."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("audio", type=Path)
    parser.add_argument("text_file", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    asked = parser.parse_args()
    with understudy.load() as models:
        performance = understudy.perform(models, asked.audio, asked.text_file.read_text(encoding="utf-8").strip())
        motion = understudy.realize(models, performance).motion
    spoken = [(word.interval.start_s, word.text) for word in performance.utterance.words if word.interval]
    first, *others = list(frames(motion, spoken))
    pace = {"duration": round(1000 / RATE_HZ), "loop": 0}
    first.save(asked.output, "WEBP", save_all=True, append_images=others, quality=QUALITY, method=6, **pace)


def frames(motion: Motion, spoken: Sequence[tuple[float, str]]) -> Iterator[Image.Image]:
    """The body at each time, with the words about then below it."""
    body, mannequin = motion.body, Mannequin.around(Skeleton.standing())
    font = ImageFont.load_default(size=15)
    for time_s in np.arange(0, float(body.times_s[-1]), 1 / RATE_HZ):
        frame = int(np.abs(body.times_s - time_s).argmin())
        still = Still("", body.rotations[frame], body.hips_m[frame], motion.shapes[frame])
        picture = Image.fromarray(cell(mannequin, still, faces=False, cameras=(VIEW,)))
        middle, height = picture.width / 2, picture.height
        words = caption(spoken, float(time_s))
        ImageDraw.Draw(picture).text((middle, height - 24), words, fill="black", font=font, anchor="mm")
        yield picture


def caption(spoken: Sequence[tuple[float, str]], time_s: float) -> str:
    """The phrase of a few words that is being spoken."""
    begun = max((place for place, (start_s, _word) in enumerate(spoken) if start_s <= time_s), default=0)
    first = begun - begun % SHOWN_WORDS
    return " ".join(word for _start_s, word in spoken[first : first + SHOWN_WORDS])


if __name__ == "__main__":
    main()
