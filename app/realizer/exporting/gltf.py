"""Builds binary glTF 2.0 files: arrays become accessors in one buffer, described by a JSON tree.

Conventions: numbers are little-endian, every buffer view starts at a multiple of four bytes, and equal arrays are
stored once.
"""

import json
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ...version import __version__
from ..body.skeleton import Skeleton
from ..mannequin.surface import IntArray

Json: TypeAlias = "str | int | float | bool | Sequence[Json] | Mapping[str, Json] | None"
Target = Literal["ARRAY_BUFFER", "ELEMENT_ARRAY_BUFFER"]

FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT, UNSIGNED_INT = 5126, 5121, 5123, 5125
_TARGETS = {"ARRAY_BUFFER": 34962, "ELEMENT_ARRAY_BUFFER": 34963}
_SHAPES = {(): "SCALAR", (2,): "VEC2", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}
_MAGIC, _VERSION, _JSON_CHUNK, _BINARY_CHUNK = 0x46546C67, 2, 0x4E4F534A, 0x004E4942


_LARGE = 2**16
"""Bytes from which on arrays are neither compared with others nor copied before they are written."""


@dataclass(frozen=True, slots=True, eq=False)
class _Converted:
    """An array that is written as 32-bit floats."""

    values: FloatArray

    def __len__(self) -> int:
        return 4 * self.values.size

    def content(self) -> bytes:
        return self.values.astype("<f4", copy=False).tobytes()


Chunk: TypeAlias = bytes | _Converted
"""A part of the buffer."""


class Accessors:
    """Collects the accessors of a file and the content of its buffer.

    `views`, `accessors` and `content` are those that the file already has, in one buffer. Large arrays are converted
    one by one as the file is written, so that ten minutes are in memory once; until then they must not change.
    """

    def __init__(self, views: Sequence[Json] = (), accessors: Sequence[Json] = (), content: bytes = b"") -> None:
        self._views = list(views)
        self._accessors: list[Json] = list(accessors)
        self._chunks: list[Chunk] = [content, b"\0" * (-len(content) % 4)]
        self._length = len(content) + -len(content) % 4
        self._known: dict[tuple[str, str, bytes], int] = {}

    def floats(self, values: FloatArray, *, bounds: bool = False, target: Target | None = None) -> int:
        """Add 32-bit floats (N, …), with their minimum and maximum if `bounds`; returns the accessor's index."""
        if 4 * values.size >= _LARGE and not bounds:
            self._described(_Converted(values), values, FLOAT, target)
            return len(self._accessors) - 1
        return self._add(values.astype("<f4", copy=False), FLOAT, bounds=bounds, target=target)

    def indices(self, triangles: IntArray) -> int:
        """Add the vertex indices of triangles (F, 3)."""
        flat = triangles.reshape(-1)
        if flat.max(initial=0) < 2**16 - 1:
            return self._add(flat.astype("<u2"), UNSIGNED_SHORT, target="ELEMENT_ARRAY_BUFFER")
        return self._add(flat.astype("<u4"), UNSIGNED_INT, target="ELEMENT_ARRAY_BUFFER")

    def joints(self, joints: IntArray) -> int:
        """Add the joints (V, 4) that influence each vertex."""
        return self._add(joints.astype("<u1"), UNSIGNED_BYTE, target="ARRAY_BUFFER")

    def displacements(self, values: FloatArray) -> int:
        """Add a sparse accessor of vectors (V, 3), most of which are zero."""
        stored = values.astype("<f4")
        where = np.flatnonzero(np.any(stored != 0, axis=1))
        accessor: dict[str, Json] = {
            "componentType": FLOAT,
            "count": len(stored),
            "type": "VEC3",
            "min": stored.min(axis=0).tolist(),
            "max": stored.max(axis=0).tolist(),
        }
        if len(where):
            accessor["sparse"] = {
                "count": len(where),
                "indices": {"bufferView": self._view(where.astype("<u2").tobytes()), "componentType": UNSIGNED_SHORT},
                "values": {"bufferView": self._view(stored[where].tobytes())},
            }
        self._accessors.append(accessor)
        return len(self._accessors) - 1

    def tree(self) -> dict[str, Json]:
        """The JSON of buffer, buffer views and accessors."""
        return {
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": self._length}],
        }

    @property
    def length(self) -> int:
        """The length of the buffer in bytes."""
        return self._length

    def write(self, file: BytesIO) -> None:
        """Write the buffer."""
        file.writelines(chunk.content() if isinstance(chunk, _Converted) else chunk for chunk in self._chunks)

    def _add(
        self, stored: NDArray[np.generic], component: int, *, bounds: bool = False, target: Target | None = None
    ) -> int:
        content = stored.tobytes()
        key = (str(stored.shape), str((stored.dtype, bounds, target)), content)
        if key in self._known:
            return self._known[key]
        accessor = self._described(content, stored, component, target)
        if bounds:
            ends = {"min": stored.min(axis=0), "max": stored.max(axis=0)}
            accessor |= {name: np.atleast_1d(end).tolist() for name, end in ends.items()}
        if len(content) < _LARGE:
            self._known[key] = len(self._accessors) - 1
        return len(self._accessors) - 1

    def _described(
        self, content: Chunk, values: NDArray[np.generic], component: int, target: Target | None
    ) -> dict[str, Json]:
        """The accessor of these values (N, …), added as the last one; `content` is a view of its own."""
        accessor: dict[str, Json] = {
            "bufferView": self._view(content, target),
            "componentType": component,
            "count": len(values),
            "type": _SHAPES[values.shape[1:]],
        }
        self._accessors.append(accessor)
        return accessor

    def _view(self, content: Chunk, target: Target | None = None) -> int:
        view: dict[str, Json] = {"buffer": 0, "byteOffset": self._length, "byteLength": len(content)}
        if target:
            view["target"] = _TARGETS[target]
        padding = -len(content) % 4
        self._chunks += [content, b"\0" * padding]
        self._length += len(content) + padding
        self._views.append(view)
        return len(self._views) - 1


def to_glb_bytes(tree: Mapping[str, Json], accessors: Accessors) -> bytes:
    """The GLB file of a JSON tree, completed by the accessors' part, and the buffer."""
    asset = {"version": "2.0", "generator": f"Understudy {__version__}"}
    described = json.dumps({"asset": asset, **tree, **accessors.tree()}, separators=(",", ":")).encode()
    described += b" " * (-len(described) % 4)
    length, file = accessors.length, BytesIO()
    file.write(struct.pack("<III", _MAGIC, _VERSION, 12 + 8 + len(described) + 8 + length))
    file.write(struct.pack("<II", len(described), _JSON_CHUNK) + described)
    file.write(struct.pack("<II", length, _BINARY_CHUNK))
    accessors.write(file)
    return file.getvalue()


def joint_nodes(skeleton: Skeleton) -> list[dict[str, Json]]:
    """A node for each joint, in the skeleton's order, in the T-pose."""
    nodes: list[dict[str, Json]] = []
    for joint, name in enumerate(skeleton.names):
        children = [child for child, parent in enumerate(skeleton.parents) if parent == joint]
        node: dict[str, Json] = {"name": name, "translation": [float(part) for part in skeleton.offsets_m[joint]]}
        nodes.append(node | ({"children": children} if children else {}))
    return nodes


class Tracks:
    """The channels and samplers of an animation with linear interpolation. A constant track gets one key."""

    def __init__(self, accessors: Accessors, times_s: FloatArray) -> None:
        """`times_s` (T,) must increase strictly, starting at 0."""
        self._accessors = accessors
        self._times_s = times_s
        self._channels: list[Json] = []
        self._samplers: list[Json] = []

    def add(self, node: int, path: str, values: FloatArray, *, keys: Sequence[int] | None = None) -> None:
        """Add the values (T, …) of a node's rotation, translation or weights, or of them only the frames `keys`."""
        stored = values.astype(np.float32, copy=False)
        moves = bool(np.any(stored != stored[:1]))
        frames = slice(0, 1) if not moves else slice(None) if keys is None else list(keys)
        kept, times_s = values[frames], self._times_s[frames]
        if path == "weights":
            kept = kept.reshape(-1)
        sampler: Json = {
            "input": self._accessors.floats(times_s, bounds=True),
            "output": self._accessors.floats(kept),
            "interpolation": "LINEAR",
        }
        self._samplers.append(sampler)
        self._channels.append({"sampler": len(self._samplers) - 1, "target": {"node": node, "path": path}})

    def tree(self) -> dict[str, Json]:
        """The JSON of the animation."""
        return {"channels": self._channels, "samplers": self._samplers}
