"""Frames for programs that show VRM avatars, by the Virtual Motion Capture protocol (protocol.vmc.info): every bone and
every shape in each frame, for datagrams get lost.

VMC is Unity's: left-handed, Y up, the avatar faces +Z and its left is -X. Ours is right-handed with the left at +X, so
x is mirrored: places (-x, y, z), rotations (x, -y, -z, w). Bones go by Unity's names (HumanBodyBones), places are local
to the parent.

Messages and bundles of Open Sound Control 1.0, as bytes: strings end in zeros and fill words of four bytes, numbers are
big-endian, a bundle's messages each follow their length.
"""

import struct
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ...realizer.body.motion import SHAPES
from ...realizer.body.skeleton import Skeleton
from ...realizer.face.face_tables import INDEX
from ..body import BodyFrame

PORT = 39539

_THUMBS: Mapping[str, str] = MappingProxyType({"Metacarpal": "Proximal", "Proximal": "Intermediate"})
"""VRM's names of a thumb's bones, and Unity's."""

_HEAD = frozenset({"neck", "head", "leftEye", "rightEye"})

_PRESETS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "A": ("jawOpen",),
        "O": ("mouthFunnel",),
        "U": ("mouthPucker",),
        "Blink_L": ("eyeBlinkLeft",),
        "Blink_R": ("eyeBlinkRight",),
        "Joy": ("mouthSmileLeft", "mouthSmileRight"),
    }
)
"""VRM's presets that ours amount to, each the mean of some of our shapes."""


class VmcFace(StrEnum):
    """Whose shapes are sent: VRM's presets, the 52 of ARKit by the names of Perfect Sync, or none."""

    PRESETS = "presets"
    ARKIT = "arkit"
    NONE = "none"


@dataclass(frozen=True, slots=True)
class VmcParts:
    """What is sent. Without the `head` (and neck and eyes) another program may track it."""

    head: bool = True
    face: VmcFace = VmcFace.PRESETS


class VmcWriter:
    """Makes datagrams of frames."""

    def __init__(self, skeleton: Skeleton, parts: VmcParts = VmcParts()) -> None:
        names = [name for name in skeleton.names if parts.head or name not in _HEAD]
        self._rows = [skeleton.names.index(name) for name in names]
        offsets_m = _mirrored_places(np.asarray(skeleton.offsets_m)[self._rows])
        self._places_m = [tuple(place) for place in offsets_m.tolist()]
        self._heads = [message_head("/VMC/Ext/Bone/Pos", "sfffffff", unity_name(name)) for name in names]
        self._shapes = _shapes_of(parts.face)
        self._root = message(message_head("/VMC/Ext/Root/Pos", "sfffffff", "root"), (0, 0, 0, 0, 0, 0, 1))
        self._time = message_head("/VMC/Ext/T", "f")
        self._ok = message_head("/VMC/Ext/OK", "i") + b"\0\0\0\1"
        self._apply = message_head("/VMC/Ext/Blend/Apply", "")

    def datagrams(self, frame: BodyFrame) -> list[bytes]:
        """The frame as bundles of less than 1,400 bytes, the face applied last."""
        return list(bundles(self._messages(frame)))

    def _messages(self, frame: BodyFrame) -> Iterator[bytes]:
        yield self._ok
        yield message(self._time, (frame.at_s,))
        yield self._root
        rotations = (frame.rotations[self._rows] * (1, -1, -1, 1)).tolist()
        hips_m = _mirrored_places(frame.hips_m).tolist()
        for row, head, place_m, rotation in zip(self._rows, self._heads, self._places_m, rotations, strict=True):
            yield message(head, (*(place_m if row else hips_m), *rotation))
        for head, columns in self._shapes:
            yield message(head, (float(frame.shapes[columns].mean()),))
        if self._shapes:
            yield self._apply


def unity_name(joint: str) -> str:
    """A joint's name among Unity's bones: LeftUpperArm, and LeftThumbIntermediate for VRM's leftThumbProximal."""
    before, thumb, part = joint.partition("Thumb")
    name = f"{before}{thumb}{_THUMBS.get(part, part)}" if thumb else joint
    return name[0].upper() + name[1:]


def _shapes_of(face: VmcFace) -> list[tuple[bytes, list[int]]]:
    """The heads of the messages, and which of our shapes each is the mean of."""
    arkit = {name[0].upper() + name[1:]: (name,) for name in SHAPES}
    named = {VmcFace.PRESETS: _PRESETS, VmcFace.ARKIT: arkit, VmcFace.NONE: {}}[face]
    return [
        (message_head("/VMC/Ext/Blend/Val", "sf", name), [INDEX[shape] for shape in shapes])
        for name, shapes in named.items()
    ]


def _mirrored_places(places_m: FloatArray) -> FloatArray:
    return np.asarray(places_m * (-1, 1, 1))


MOST_BYTES = 1400
"""A datagram this small is not cut into pieces on its way through usual networks."""

_NOW = struct.pack(">Q", 1)
_BUNDLE = b"#bundle\0" + _NOW
_LENGTH = struct.Struct(">i")


def message(head: bytes, numbers: Iterable[float] = ()) -> bytes:
    """A message whose address, types and strings are packed already (`message_head`), with its floats."""
    values = tuple(numbers)
    return head + struct.pack(f">{len(values)}f", *values)


def message_head(address: str, types: str, *strings: str) -> bytes:
    """What comes before a message's numbers. `types` are those of all arguments, the strings (s) first."""
    return b"".join(map(_padded, (address, f",{types}", *strings)))


def bundles(messages: Iterable[bytes], most_bytes: int = MOST_BYTES) -> Iterator[bytes]:
    """As few bundles as have room for the messages in their order, none larger than `most_bytes`."""
    held = _BUNDLE
    for each in messages:
        element = _LENGTH.pack(len(each)) + each
        if len(held) + len(element) > most_bytes and held != _BUNDLE:
            yield held
            held = _BUNDLE
        held += element
    yield held


def _padded(text: str) -> bytes:
    content = text.encode("ascii") + b"\0"
    return content + b"\0" * (-len(content) % 4)
