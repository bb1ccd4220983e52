"""Exports a clip as JSON for game engines (schema in docs/motion-formats.md).

Conventions: metres, seconds from the first frame, quaternions x y z w local to the joint's parent, the T-pose is the
identity. A constant track has one value instead of one per frame. Numbers are formatted a few tracks at a time, so
that ten minutes need little memory.
"""

import io
import json
from collections.abc import Iterator
from itertools import chain, repeat

import numpy as np

from ...model import FloatArray
from ..body.motion import SHAPES, Motion
from ..body.skeleton import Skeleton
from ..face.face_tables import VISEMES
from ..geometry.rotations import with_continuous_signs
from .animations import events_json
from .fixed_decimals import RowFormat, written_rows
from .gltf import Json
from .retargeting import Rig

FORMAT, VERSION = "understudy-clip", 1
ROTATION_DECIMALS, PLACE_DECIMALS, WEIGHT_DECIMALS = 5, 4, 4
_NUMBERS_AT_ONCE = 100_000


def to_clip_json(motion: Motion, skeleton: Skeleton, rig: Rig, *, visemes: FloatArray | None = None) -> bytes:
    """The clip with the rig's joint names, one line per track.

    `visemes` are weights (T, 15) for rigs that have visemes as morph targets
    (`understudy.realizer.face.lips.viseme_weights`); they replace the blendshapes of the mouth.
    """
    content = io.BytesIO()
    content.write(b"{\n")
    for key, value in _head(motion, skeleton, rig).items():
        content.write(f"{json.dumps(key)}: {json.dumps(value)},\n".encode())
    [hips] = _tracks(motion.body.hips_m[None], PLACE_DECIMALS)
    content.write(b'"hips_m": ' + hips + b",\n")
    _write_tracks(content, "bones", _bones(motion, rig))
    content.write(b",\n")
    _write_tracks(content, "blendshapes", _weights(SHAPES, motion.shapes))
    if visemes is not None:
        content.write(b",\n")
        _write_tracks(content, "visemes", _weights(VISEMES, visemes))
    content.write(b"\n}\n")
    return content.getvalue()


def _head(motion: Motion, skeleton: Skeleton, rig: Rig) -> dict[str, Json]:
    """Everything but the tracks."""
    return {
        "format": FORMAT,
        "version": VERSION,
        "skeleton": _skeleton(skeleton, rig),
        "frames": len(motion.body.times_s),
        "duration_s": round(motion.duration_s, 6),
        **events_json(motion),
        "notices": [{"code": notice.code, "message": notice.message} for notice in motion.notices],
    }


def _skeleton(skeleton: Skeleton, rig: Rig) -> Json:
    names = list(rig.names.values())
    return {
        "name": rig.name,
        "unit_m": 1.0,
        "up": "+Y",
        "forward": "+Z",
        "rest": "T-pose",
        "joints": [
            {
                "name": rig.names[joint],
                "parent": names[parent] if parent >= 0 else None,
                "offset_m": [round(float(part), 6) for part in offset],
            }
            for joint, parent, offset in zip(skeleton.names, skeleton.parents, skeleton.offsets_m, strict=True)
        ],
    }


def _bones(motion: Motion, rig: Rig) -> Iterator[tuple[str, bytes]]:
    names = tuple(rig.names.values())
    for some in _groups(len(names), 4 * len(motion.body.times_s)):
        rotations = with_continuous_signs(motion.body.rotations[:, some])
        yield from zip(names[some], _tracks(rotations.swapaxes(0, 1), ROTATION_DECIMALS), strict=True)


def _weights(names: tuple[str, ...], weights: FloatArray) -> Iterator[tuple[str, bytes]]:
    for some in _groups(len(names), len(weights)):
        within = np.clip(weights[:, some], 0.0, 1.0)
        yield from zip(names[some], _tracks(within.T[:, :, None], WEIGHT_DECIMALS), strict=True)


def _groups(tracks: int, numbers: int) -> Iterator[slice]:
    """The tracks, of so many numbers each, in groups that are written at once."""
    size = max(1, _NUMBERS_AT_ONCE // numbers)
    return (slice(first, first + size) for first in range(0, tracks, size))


def _write_tracks(content: io.BytesIO, key: str, tracks: Iterator[tuple[str, bytes]]) -> None:
    """Write an object of tracks by name."""
    content.write(f"{json.dumps(key)}: {{".encode())
    separators = chain([""], repeat(","))
    content.writelines(
        f"{separator}\n  {json.dumps(name)}: ".encode() + track
        for separator, (name, track) in zip(separators, tracks, strict=False)
    )
    content.write(b"\n}")


def _tracks(tracks: FloatArray, decimals: int) -> Iterator[bytes]:
    """A JSON array of each of the tracks (K, T, N), whose elements are arrays, or values if N is 1; only the first
    element if all are equal."""
    row = RowFormat(decimals, "[", ",", "],") if tracks.shape[2] > 1 else RowFormat(decimals)
    rounded, end = np.round(tracks, decimals), row.after.encode()
    constant = (rounded == rounded[:, :1]).all(axis=(1, 2))
    for text, same in zip(written_rows(tracks, row), constant, strict=True):
        elements = text[: text.index(end) + len(end)] if same else text
        yield b"[" + elements[:-1] + b"]"
