"""Draws contact sheets: the mannequin in key poses, from the front and three quarters, with times and words.

Characters are drawn as they stand, side by side and to one scale. Needs matplotlib, the extra `understudy[plot]`;
command line and HTTP API check for it.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...model import Channel, FloatArray, Hand, Schedule, Word
from ...model.figure import PLAIN, Looks
from ..arms.rest_poses import rest_pose
from ..body.motion import SHAPES, Motion
from ..body.skeleton import Skeleton, arm_joints, forward
from ..geometry.rotations import IDENTITY, rotate
from ..mannequin.skinning import Mannequin, posed
from .rasterizer import Camera, ColouredMesh, draw, joined

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BACKGROUND = np.array([0.80, 0.81, 0.82])
FRONT = Camera((0.0, 1.14, 0.0), 1.62)
THREE_QUARTERS = Camera((0.0, 1.14, 0.0), 1.62, azimuth=np.radians(48), elevation=np.radians(8))
BODY_HEIGHT, FACE_HEIGHT, CELL_WIDTH, CAPTION_HEIGHT = 300, 200, 260, 44
CHART_HEIGHT, CHART_MARGIN, NARROWEST_CHART = 240, 45, 640
COLUMNS = 8
AT_MOST = 24
TOGETHER_S = 0.1
SHOWN = (Channel.GESTURE, Channel.HEAD, Channel.FACE, Channel.GAZE, Channel.POSTURE)
"""The channels shown, most important first."""

FACE_ABOVE_HEAD_M = np.array([0.0, 0.09, 0.0])
DOTS_PER_INCH = 100
_COMPRESSION = 3
"""Of 0 to 9: more takes longer, for a tenth fewer bytes."""

_LIGHT_STEPS = 4096
"""How finely linear light is told apart: enough for each of the 256 display values but the darkest few."""


@dataclass(frozen=True, slots=True, eq=False)
class Still:
    """A pose and its caption: `rotations` (J, 4), and `shapes` (52,) of the face, by default all 0."""

    caption: str
    rotations: FloatArray
    hips_m: FloatArray | None = None
    shapes: FloatArray | None = None


def draw_sheet(
    motion: Motion,
    skeleton: Skeleton,
    moments: Sequence[tuple[float, str]],
    *,
    looks: Looks = PLAIN.looks,
    faces: bool = True,
) -> bytes:
    """The poses at the given times (seconds, caption), as PNG."""
    body = motion.body
    frames = [int(np.argmin(np.abs(body.times_s - time_s))) for time_s, _caption in moments]
    stills = [
        Still(f"{time_s:.2f} s  {caption}", body.rotations[frame], body.hips_m[frame], motion.shapes[frame])
        for frame, (time_s, caption) in zip(frames, moments, strict=True)
    ]
    return draw_stills(stills, skeleton, looks=looks, faces=faces)


def moments_of(motion: Motion, schedule: Schedule, *, at_most: int = AT_MOST) -> tuple[tuple[float, str], ...]:
    """The peaks of the realized behaviours, for a sheet: time, and caption with the word spoken then.

    The peak is the stroke, else `ready`, else the start. Peaks within `TOGETHER_S` are combined. Of more than
    `at_most`, gestures are preferred to head movements, these to faces, gazes and postures. Motion without behaviours
    has `at_most` moments at equal distances.
    """
    chosen: list[tuple[float, str]] = []
    shown = [behavior for behavior in schedule.behaviors if behavior.kind in SHOWN and behavior.id in motion.realized]
    for behavior in sorted(shown, key=lambda each: SHOWN.index(each.kind)):
        sync = motion.realized[behavior.id]
        peak_s = next(at for at in (sync.stroke, sync.ready, sync.start) if at is not None)
        near = next((k for k, (time_s, _caption) in enumerate(chosen) if abs(time_s - peak_s) < TOGETHER_S), None)
        if near is not None:
            chosen[near] = (chosen[near][0], f"{chosen[near][1]} + {behavior.lexeme}")
        elif len(chosen) < at_most:
            chosen.append((peak_s, behavior.lexeme))
    moments = sorted(chosen) or _spread(motion, at_most if not schedule.behaviors else 1)
    return tuple((time_s, f"{caption}\n{_word_at(schedule.words, time_s)}") for time_s, caption in moments)


def _spread(motion: Motion, count: int) -> list[tuple[float, str]]:
    """Moments at equal distances, for motion of which nothing says what it shows."""
    times_s = motion.body.times_s
    places = [round(number * (len(times_s) - 1) / max(count - 1, 1)) for number in range(count)]
    return [(float(times_s[place]), "") for place in dict.fromkeys(places)]


def _word_at(words: Sequence[Word], time_s: float) -> str:
    """The word spoken at this time."""
    said = (word for word in words if word.interval and word.interval.start_s <= time_s < word.interval.end_s)
    return next((f"“{word.text}”" for word in said), "")


def draw_stills(
    stills: Sequence[Still],
    skeleton: Skeleton,
    *,
    looks: Looks = PLAIN.looks,
    faces: bool = True,
    columns: int = COLUMNS,
    charts: Sequence[Callable[[Axes], None]] = (),
) -> bytes:
    """The poses side by side, at most `columns` per row, and below them a row for each chart, as PNG."""
    mannequin = Mannequin.around(skeleton, looks)
    cells = [cell(mannequin, still, faces=faces) for still in stills]
    return draw_cells(cells, stills, columns=columns, charts=charts)


def draw_cells(
    cells: list[NDArray[np.uint8]],
    stills: Sequence[Still],
    *,
    columns: int = COLUMNS,
    charts: Sequence[Callable[[Axes], None]] = (),
) -> bytes:
    """Pictures of the stills beside each other with their captions, and below them the charts, as PNG."""
    columns = min(columns, len(stills))
    blank = np.broadcast_to(display(BACKGROUND), cells[0].shape)
    cells = cells + [blank] * (-len(cells) % columns)
    rows = [np.concatenate(cells[k : k + columns], axis=1) for k in range(0, len(cells), columns)]
    return _lettered(np.concatenate(rows), stills, columns, charts)


def cell(
    mannequin: Mannequin, still: Still, *, faces: bool, cameras: tuple[Camera, ...] = (FRONT, THREE_QUARTERS)
) -> NDArray[np.uint8]:
    """The views of one pose above each other, and space for the caption, in display values."""
    hips_m = mannequin.skeleton.offsets_m[0] if still.hips_m is None else still.hips_m
    shapes = np.zeros(len(SHAPES)) if still.shapes is None else still.shapes
    surfaces = posed(mannequin, still.rotations, hips_m, shapes)
    coloured = (
        ColouredMesh(
            each.positions_m,
            each.normals,
            each.triangles,
            np.broadcast_to(mannequin.colours[part.material], each.normals.shape),
        )
        for part, each in zip(mannequin.parts, surfaces, strict=True)
    )
    figure = joined(tuple(coloured))
    views = [(camera, BODY_HEIGHT) for camera in cameras]
    if faces:
        views.append((_face_camera(mannequin.skeleton, still, hips_m), FACE_HEIGHT))
    pictures = [draw(figure, camera, height=height, width=CELL_WIDTH, ground=BACKGROUND) for camera, height in views]
    caption = np.broadcast_to(display(BACKGROUND), (CAPTION_HEIGHT, CELL_WIDTH, 3))
    return np.concatenate([*(display(picture) for picture in pictures), caption])


def _face_camera(skeleton: Skeleton, still: Still, hips_m: FloatArray) -> Camera:
    """A close-up of the head from the front."""
    places_m, turns = forward(skeleton, still.rotations, hips_m)
    head = skeleton.index["head"]
    middle = places_m[head] + rotate(turns[head], FACE_ABOVE_HEAD_M)
    return Camera((float(middle[0]), float(middle[1]), float(middle[2])), 0.30)


def _lettered(
    picture: NDArray[np.uint8], stills: Sequence[Still], columns: int, charts: Sequence[Callable[[Axes], None]]
) -> bytes:
    """The picture with its captions, above the charts, as PNG."""
    from matplotlib.figure import Figure

    (height, width), rows = picture.shape[:2], -(-len(stills) // columns)
    wide, high = max(width, NARROWEST_CHART * bool(charts)), height + CHART_HEIGHT * len(charts)
    figure = Figure(figsize=(wide / DOTS_PER_INCH, high / DOTS_PER_INCH), dpi=DOTS_PER_INCH)
    axes = figure.add_axes((0, 1 - height / high, width / wide, height / high), xlim=(0, width), ylim=(height, 0))
    axes.set_axis_off()
    for number, still in enumerate(stills):
        row, column = divmod(number, columns)
        left, bottom = column * CELL_WIDTH, (row + 1) * height / rows
        axes.text(left + CELL_WIDTH / 2, bottom - 4, still.caption, ha="center", va="bottom", fontsize=7.5)
    for number, chart in enumerate(charts):
        bottom = high - height - (number + 1) * CHART_HEIGHT + CHART_MARGIN
        chart(figure.add_axes((0.1, bottom / high, 0.88, (CHART_HEIGHT - CHART_MARGIN - 10) / high)))
    drawn = io.BytesIO()
    figure.savefig(drawn, format="rgba", dpi=DOTS_PER_INCH, facecolor="none")
    return _png(picture, np.frombuffer(drawn.getbuffer(), dtype=np.uint8).reshape(high, wide, 4))


def _png(picture: NDArray[np.uint8], drawn: NDArray[np.uint8]) -> bytes:
    """A picture at the top of a white sheet, and over it what is drawn (height, width, 4)."""
    from PIL import Image

    sheet = np.full((*drawn.shape[:2], 3), 255, dtype=np.uint8)
    sheet[: len(picture), : picture.shape[1]] = picture
    there = np.nonzero(drawn[..., 3])
    over, cover = drawn[there][:, :3], drawn[there][:, 3:] / 255
    sheet[there] = np.round(cover * over + (1 - cover) * sheet[there])
    content = io.BytesIO()
    Image.fromarray(sheet).save(content, format="png", compress_level=_COMPRESSION)
    return content.getvalue()


def display(light: FloatArray) -> NDArray[np.uint8]:
    """Linear light converted to display values."""
    steps = np.linspace(0, 1, _LIGHT_STEPS)
    shown = np.round(255 * steps ** (1 / 2.2)).astype(np.uint8)
    return np.asarray(shown[(np.clip(light, 0, 1) * (_LIGHT_STEPS - 1) + 0.5).astype(np.uint16)])


_WHOLE = (Camera((0.0, 1.0, 0.0), 2.12), Camera((0.0, 1.0, 0.0), 2.12, azimuth=np.radians(48)))
AT_SIDE = "at_side"


def draw_characters(bodies: Mapping[str, tuple[Skeleton, Looks]]) -> bytes:
    """Each body, by the name of its character, from the front, three quarters and in close-up, as PNG."""
    stills = [Still(name, _standing(skeleton)) for name, (skeleton, _looks) in bodies.items()]
    cells = [
        cell(Mannequin.around(skeleton, looks), still, faces=True, cameras=_WHOLE)
        for still, (skeleton, looks) in zip(stills, bodies.values(), strict=True)
    ]
    return draw_cells(cells, stills)


def _standing(skeleton: Skeleton) -> FloatArray:
    """The rotations (J, 4) of a body with its arms at its sides."""
    rotations = np.tile(IDENTITY, (len(skeleton.names), 1))
    for side in (Hand.LEFT, Hand.RIGHT):
        rotations[skeleton.chain(*arm_joints(side))] = rest_pose(skeleton, side, AT_SIDE).rotations
    return rotations
