"""Draws a contact sheet for the lines of a report that are most urgent to check.

They are in `OUT/thumbnails`, named after the hashes of their input, so that a line performed again gets a new one.
"""

import io
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from ..model.formats import MotionFormat
from .layout import file_name
from .manifest.entries import ManifestEntry, State
from .reports.html_report import Thumbnail
from .reports.writing import in_order_of_attention
from .work.jobs import LineJob, OutputTarget

FOLDER = "thumbnails"
WIDTH_PIXELS = 640
_HASH_LETTERS = 10


def thumbnail_paths(entries: Sequence[ManifestEntry], count: int) -> dict[str, str]:
    """The paths of the sheets for the first `count` lines that are done, relative to the output folder, by line id."""
    done = [entry for entry in in_order_of_attention(entries) if entry.state is State.DONE]
    return {
        entry.id: f"{FOLDER}/{file_name(entry.id)}-{(entry.input_hash + entry.settings_hash)[:_HASH_LETTERS]}.png"
        for entry in done[:count]
    }


def thumbnail_jobs(jobs: Sequence[LineJob], paths: dict[str, str], out: Path) -> Iterator[LineJob]:
    """Jobs for the sheets that do not exist yet."""
    for job in jobs:
        path = paths.get(job.id)
        if path is not None and not (out / path).is_file():
            yield replace(job, targets=(OutputTarget(MotionFormat.SHEET, path),))


def remove_other_thumbnails(paths: dict[str, str], out: Path) -> None:
    """Removes sheets of lines that are no longer pictured; a linked folder, which may hold others, is left alone."""
    if (out / FOLDER).is_symlink():
        return
    kept = {out / path for path in paths.values()}
    for path in (out / FOLDER).glob("*.png"):
        if path not in kept:
            path.unlink(missing_ok=True)


def read_thumbnails(paths: dict[str, str], out: Path) -> dict[str, Thumbnail]:
    """The sheets that exist, scaled down for the report, by line id."""
    there = {name: path for name, path in paths.items() if (out / path).is_file()}
    return {name: Thumbnail(path, _small((out / path).read_bytes())) for name, path in there.items()}


def _small(png: bytes) -> bytes:
    from PIL import Image

    picture = Image.open(io.BytesIO(png))
    picture.thumbnail((WIDTH_PIXELS, WIDTH_PIXELS))
    content = io.BytesIO()
    picture.save(content, format="PNG")
    return content.getvalue()
