"""Draws six lines, front and three quarters at even steps of time, to judge by eye how alive the bodies look.

    python -m benchmarks.realizer.line_sheets FOLDER PREFIX [--character NAME] [--seed N]

Writes FOLDER/PREFIX-LINE.png for each of `LINES`, small enough for docs/images: `WIDTH` pixels, `COLOURS` colours.
Needs matplotlib (`understudy[plot]`), which brings pillow.
"""

import argparse
import io
from pathlib import Path

import numpy as np
from PIL import Image

from benchmarks.realizer.liveliness import realized_lines, recorded_lines
from understudy.models import load_realizer
from understudy.realizer.pictures.contact_sheet import draw_sheet

LINES = ("jfk", "austen-0880", "meld-test-239-10", "meld-test-156-2", "style-dev-03", "style-dev-13")
MOMENTS = 8
WIDTH, COLOURS = 1600, 48


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("prefix")
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    options = arguments.parse_args()
    lines = {name: line for name, line in recorded_lines().items() if name in LINES}
    realizer = load_realizer()
    performer = realizer.performer(options.character)
    for name, realized in zip(lines, realized_lines(realizer, lines, options.character, options.seed), strict=True):
        motion = realized.motion
        at_s = np.linspace(0.0, realized.schedule.duration_s, MOMENTS)
        moments = [(float(time_s), name) for time_s in at_s]
        picture = draw_sheet(motion, performer.skeleton, moments, looks=performer.looks, faces=False)
        path = options.folder / f"{options.prefix}-{name}.png"
        path.write_bytes(compact(picture))
        print(f"{path}: {path.stat().st_size // 1000} kB")


def compact(picture: bytes) -> bytes:
    """The picture in fewer pixels and colours."""
    image = Image.open(io.BytesIO(picture)).convert("RGB")
    small = image.resize((WIDTH, round(image.height * WIDTH / image.width)), Image.Resampling.LANCZOS)
    content = io.BytesIO()
    small.quantize(COLOURS, dither=Image.Dither.NONE).save(content, "PNG", optimize=True)
    return content.getvalue()


if __name__ == "__main__":
    main()
