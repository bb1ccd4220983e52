"""A sheet of rendered moments, a row a line, each picture with its frame, camera and caption burnt in."""

import os
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy
import numpy as np

COLUMNS = 3
"""Of the sheet: so many pictures a line has at most."""
GAP_PIXELS = 6
Pixels = np.ndarray[Any, np.dtype[np.float32]]


@dataclass(frozen=True, slots=True)
class Panel:
    """A frame, the camera it is seen by, and what is written under it."""

    frame: int
    camera: Any
    caption: str


def render_sheet(rows: Sequence[Sequence[Panel]], output: Path, *, samples: int, width: int) -> None:
    """Renders rows of panels by Cycles on the processor, which needs no display, and puts them on one sheet."""
    _choose_settings(samples, width)
    with tempfile.TemporaryDirectory() as folder:
        pictures = [[_rendered(panel, Path(folder) / "picture.png") for panel in row] for row in rows]
    _save(_sheet(pictures), output)


def _choose_settings(samples: int, width: int) -> None:
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = samples, True
    scene.render.resolution_x, scene.render.resolution_y = width, width * 9 // 16
    scene.render.use_persistent_data = True
    scene.render.use_sequencer = False
    scene.render.image_settings.file_format = "PNG"
    scene.view_settings.view_transform = "Standard"
    for name in ("date", "time", "render_time", "scene", "filename", "frame", "camera", "lens", "memory"):
        setattr(scene.render, f"use_stamp_{name}", name in {"frame", "camera"})
    scene.render.use_stamp = scene.render.use_stamp_note = True
    scene.render.stamp_font_size = max(width // 38, 8)
    scene.render.stamp_background, scene.render.stamp_foreground = (0.0, 0.0, 0.0, 0.75), (1.0, 1.0, 1.0, 1.0)


def _rendered(panel: Panel, path: Path) -> Pixels:
    """The picture, as rows from the bottom upwards."""
    scene = bpy.context.scene
    scene.frame_set(panel.frame)
    scene.camera, scene.render.stamp_note_text = panel.camera, panel.caption
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    width, height = image.size
    pixels = np.empty(width * height * 4, dtype=np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)


def _sheet(rows: Sequence[Sequence[Pixels]]) -> Pixels:
    """The pictures in their rows, the first at the top left, on white."""
    height, width, _parts = rows[0][0].shape
    sheet = np.ones((len(rows) * (height + GAP_PIXELS) - GAP_PIXELS, COLUMNS * (width + GAP_PIXELS) - GAP_PIXELS, 4))
    for number, row in enumerate(rows):
        below = (len(rows) - 1 - number) * (height + GAP_PIXELS)
        for column, picture in enumerate(row):
            left = column * (width + GAP_PIXELS)
            sheet[below : below + height, left : left + width] = picture
    return sheet.astype(np.float32)


def _save(sheet: Pixels, output: Path) -> None:
    height, width, _parts = sheet.shape
    image = bpy.data.images.new("sheet", width, height)
    image.pixels.foreach_set(sheet.ravel())
    unfinished = output.with_name(f".{output.name}")
    image.filepath_raw, image.file_format = str(unfinished), "PNG"
    image.save()
    os.replace(unfinished, output)
