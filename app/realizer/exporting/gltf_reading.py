"""Reads glTF files: the parts of an avatar's JSON tree that are used (glTF 2.0 §5; VRM 1.0 and VRM 0's bone tables),
the rotations of its animations and the bind pose of its skins.

Files are untrusted. Indices of nodes, meshes and views are non-negative integers; that they exist is checked with the
tree (`understudy.realizer.avatars.reading`), and every number of an accessor, view and node before it is used
(`_Numbers`). Other content is not checked and is passed on unchanged. Quaternions x y z w, seconds. Only rotations of
animations are read, since translations do not change a joint's angles.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, Strict, ValidationError

from ...model import FloatArray
from ..geometry.rotations import normalized, slerp

LARGEST = 1e6
"""No coordinate, and no scale, of a usable avatar is larger."""

_LONGEST_KEY = 40

Number = Annotated[float, Strict(), Field(ge=-LARGEST, le=LARGEST, allow_inf_nan=False)]
Index = Annotated[int, Strict(), Field(ge=0, lt=2**31)]


class _Part(BaseModel):
    model_config = ConfigDict(frozen=True, defer_build=True)


class Node(_Part):
    """A node with its transform: `matrix`, by columns, or the three others."""

    name: str = ""
    children: tuple[Index, ...] = ()
    mesh: Index | None = None
    matrix: Annotated[tuple[Number, ...], Field(min_length=16, max_length=16)] | None = None
    translation: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)
    rotation: tuple[Number, Number, Number, Number] = (0.0, 0.0, 0.0, 1.0)
    scale: tuple[Number, Number, Number] = (1.0, 1.0, 1.0)


class Primitive(_Part):
    """A part of a mesh, with its morph targets."""

    targets: tuple[Any, ...] = ()
    extras: Any = None


class Mesh(_Part):
    """Exporters write the names of morph targets into the `extras` of the mesh, or of its first primitive."""

    primitives: Annotated[tuple[Primitive, ...], Field(min_length=1)]
    extras: Any = None

    def target_names(self) -> list[str]:
        """The names of its morph targets; none if there is not one for each."""
        count = len(self.primitives[0].targets)
        for extras in (self.extras, self.primitives[0].extras):
            names = extras.get("targetNames") if isinstance(extras, dict) else None
            if isinstance(names, list) and len(names) == count:
                return [str(name) for name in names]
        return []


class Buffer(_Part):
    """The data in the file itself; a buffer elsewhere has a `uri`."""

    byte_length: Annotated[Index, Field(alias="byteLength")]
    uri: None = None


class View(_Part):
    """A part of the buffer."""

    buffer: Annotated[int, Strict(), Field(ge=0, le=0)]
    byte_offset: Annotated[Index, Field(alias="byteOffset")] = 0
    byte_length: Annotated[Index, Field(alias="byteLength")]


class Accessor(_Part):
    """An array in a view, or in none where it is all zeros or sparse."""

    view: Annotated[Index | None, Field(alias="bufferView")] = None


class VrmBone(_Part):
    node: Index


class NamedBone(VrmBone):
    bone: str


class Humanoid1(_Part):
    human_bones: Annotated[dict[str, VrmBone], Field(alias="humanBones")]


class Vrm1(_Part):
    humanoid: Humanoid1


class Humanoid0(_Part):
    human_bones: Annotated[tuple[NamedBone, ...], Field(alias="humanBones")] = ()


class Vrm0(_Part):
    humanoid: Humanoid0 = Humanoid0()


class Extensions(_Part):
    vrm1: Annotated[Vrm1 | None, Field(alias="VRMC_vrm")] = None
    vrm0: Annotated[Vrm0 | None, Field(alias="VRM")] = None


class AvatarFile(_Part):
    """The file's JSON tree."""

    asset: dict[str, Any] = {}
    nodes: Annotated[tuple[Node, ...], Field(min_length=1)]
    meshes: tuple[Mesh, ...] = ()
    buffers: Annotated[tuple[Buffer, ...], Field(min_length=1, max_length=1)]
    views: Annotated[tuple[View, ...], Field(alias="bufferViews")] = ()
    accessors: tuple[Accessor, ...] = ()
    extensions: Extensions = Extensions()

    @classmethod
    def of(cls, tree: object) -> "AvatarFile":
        """Raises ValueError that says what is wrong, and where."""
        try:
            return cls.model_validate(tree)
        except ValidationError as error:
            found = error.errors()[0]
        where = ".".join(str(step)[:_LONGEST_KEY] for step in found["loc"])
        told = f"{where or 'it'}: {found['msg'][0].lower()}{found['msg'][1:]}"
        raise ValueError(told.encode(errors="backslashreplace").decode())


MOST_KEYS = 200_000
_FLOAT, _BYTE, _UBYTE, _SHORT, _USHORT = 5126, 5120, 5121, 5122, 5123
_TYPES: Mapping[int, tuple[str, float]] = {
    _FLOAT: ("<f4", 1.0),
    _BYTE: ("<i1", 127.0),
    _UBYTE: ("<u1", 255.0),
    _SHORT: ("<i2", 32767.0),
    _USHORT: ("<u2", 65535.0),
}
"""The numbers of a component, and what a normalized one is divided by."""
_COLUMNS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class _GltfPart(BaseModel):
    model_config = ConfigDict(frozen=True, defer_build=True)


class _View(_GltfPart):
    byte_offset: Annotated[Index, Field(alias="byteOffset")] = 0
    byte_length: Annotated[Index, Field(alias="byteLength")]
    byte_stride: Annotated[Index | None, Field(alias="byteStride")] = None


class _Accessor(_GltfPart):
    view: Annotated[Index, Field(alias="bufferView")]
    byte_offset: Annotated[Index, Field(alias="byteOffset")] = 0
    component: Annotated[Literal[5120, 5121, 5122, 5123, 5126], Field(alias="componentType")]
    count: Annotated[int, Field(ge=1, le=MOST_KEYS)]
    type: Literal["SCALAR", "VEC3", "VEC4", "MAT4"]
    sparse: None = None


class _Sampler(_GltfPart):
    input: Index
    output: Index
    interpolation: Literal["LINEAR", "STEP", "CUBICSPLINE"] = "LINEAR"


class _Target(_GltfPart):
    node: Index | None = None
    path: str


class _Channel(_GltfPart):
    sampler: Index
    target: _Target


class _Animation(_GltfPart):
    name: str = ""
    channels: tuple[_Channel, ...]
    samplers: tuple[_Sampler, ...]


class _Skin(_GltfPart):
    joints: tuple[Index, ...]
    bind: Annotated[Index | None, Field(alias="inverseBindMatrices")] = None


class _Tracks(_GltfPart):
    animations: tuple[_Animation, ...] = ()
    skins: tuple[_Skin, ...] = ()


@dataclass(frozen=True, slots=True)
class _Numbers:
    """The accessors of a file and its buffer."""

    tree: Mapping[str, Any]
    content: bytes

    def array(self, number: int, kind: str) -> FloatArray:
        """The values (N, columns) of an accessor of this type. Raises ValueError."""
        accessor = _Accessor.model_validate(_at(self.tree, "accessors", number))
        if accessor.type != kind:
            raise ValueError(f"accessors.{number} is {accessor.type}, where {kind} is wanted")
        view = _View.model_validate(_at(self.tree, "bufferViews", accessor.view))
        form, scale = _TYPES[accessor.component]
        width = np.dtype(form).itemsize * _COLUMNS[kind]
        stride = view.byte_stride or width
        start, needed = view.byte_offset + accessor.byte_offset, stride * (accessor.count - 1) + width
        if stride < width or start + needed > min(len(self.content), view.byte_offset + view.byte_length):
            raise ValueError(f"accessors.{number} goes beyond its view")
        shape, strides = (accessor.count, _COLUMNS[kind]), (stride, np.dtype(form).itemsize)
        found = np.ndarray(shape, form, self.content, start, strides).astype(np.float64) / scale
        if not np.isfinite(found).all():
            raise ValueError(f"accessors.{number} holds a value that is not a number")
        return found


def bind_matrices(tree: Mapping[str, Any], content: bytes) -> dict[int, FloatArray]:
    """Where each joint node of the skins is in the bind pose: transforms (4, 4) in the space of the mesh; none
    of a node without an inverse bind matrix. Raises ValueError for what cannot be read."""
    found: dict[int, FloatArray] = {}
    for skin in _tracks(tree).skins:
        if skin.bind is not None:
            inverses = _Numbers(tree, content).array(skin.bind, "MAT4").reshape(-1, 4, 4).transpose(0, 2, 1)
            for node, matrix in zip(skin.joints, inverses, strict=False):
                if abs(np.linalg.det(matrix)) > 0:
                    found.setdefault(node, np.linalg.inv(matrix))
    return found


def animation_names(tree: Mapping[str, Any]) -> tuple[str, ...]:
    """What the animations are called, in order. Raises ValueError."""
    return tuple(animation.name for animation in _tracks(tree).animations)


def rotations_at(tree: Mapping[str, Any], content: bytes, animation: int, time_s: float) -> dict[int, FloatArray]:
    """The local rotation (4,) at `time_s` of each node that an animation turns. Raises ValueError."""
    played, numbers = _tracks(tree).animations[animation], _Numbers(tree, content)
    return dict(_turned(played, numbers, time_s))


def _turned(played: _Animation, numbers: _Numbers, time_s: float) -> Iterator[tuple[int, FloatArray]]:
    for channel in played.channels:
        if channel.target.path == "rotation" and channel.target.node is not None:
            if channel.sampler >= len(played.samplers):
                raise ValueError(f"an animation has no sampler {channel.sampler}")
            sampler = played.samplers[channel.sampler]
            times_s = numbers.array(sampler.input, "SCALAR")[:, 0]
            values = numbers.array(sampler.output, "VEC4")
            if sampler.interpolation == "CUBICSPLINE":
                values = values[1::3]  # between the tangents; the curve between two keys is taken as straight
            if len(values) != len(times_s):
                raise ValueError(f"an animation has {len(times_s)} times and {len(values)} rotations")
            yield channel.target.node, _between(times_s, values, time_s, stepped=sampler.interpolation == "STEP")


def _between(times_s: FloatArray, values: FloatArray, time_s: float, *, stepped: bool) -> FloatArray:
    last = int(np.clip(np.searchsorted(times_s, time_s, side="right") - 1, 0, len(times_s) - 1))
    following = min(last + 1, len(times_s) - 1)
    step_s = times_s[following] - times_s[last]
    share = 0.0 if stepped or step_s <= 0 else float(np.clip((time_s - times_s[last]) / step_s, 0.0, 1.0))
    return slerp(_unit(values[last]), _unit(values[following]), np.array(share))


def _unit(value: FloatArray) -> FloatArray:
    if np.linalg.norm(value) < 0.5:
        raise ValueError("an animation has an invalid rotation")
    return normalized(value)


def _at(tree: Mapping[str, Any], name: str, number: int) -> object:
    listed = tree.get(name, [])
    if not isinstance(listed, list) or number >= len(listed):
        raise ValueError(f"there is no {name}.{number}")
    return listed[number]


def _tracks(tree: Mapping[str, Any]) -> _Tracks:
    try:
        return _Tracks.model_validate({name: tree[name] for name in ("animations", "skins") if name in tree})
    except ValidationError as error:
        found = error.errors()[0]
    where = ".".join(str(step)[:40] for step in found["loc"])
    raise ValueError(f"{where}: {found['msg']}".encode(errors="backslashreplace").decode())
