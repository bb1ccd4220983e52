"""The face for programs that listen to Epic's Live Link Face app, Unreal's Live Link among them: a datagram a frame.

Nobody has published the layout. This one is what three readers of others, independent of each other, agree on
(think-biq/LLV, ForeverAnApple/LiveLinkVRCFaceTracking, PyLiveLinkFace 0.1, which has read ours), all big-endian:

    version (a byte: 6), device id and subject name (each: length as int32, UTF-8), frame number (int32), part of a
    frame (float), frame rate (int32 over int32), how many values follow (a byte: 61), the values (float each)

Values come in the order of Unreal's EARFaceBlendShape: the 52 shapes of ARKit in [0, 1], then yaw, pitch and roll of
the head and of either eye. A fourth reader's table, of a Godot plugin, has jaw and mouth go right before left; Unreal's
own and the others' have left first, and so has this. Which way the angles turn those readers do not say, so they are
zero; the direction of the eyes is sent as shapes.
"""

import struct
import uuid

from ...model import FloatArray
from ...realizer.face.face_tables import INDEX
from ..body import BodyFrame

PORT = 11111
SUBJECT = "Understudy"
VERSION, VALUES = 6, 61
_SIDED_EYE = ("Blink", "LookDown", "LookIn", "LookOut", "LookUp", "Squint", "Wide")
_SIDED_MOUTH = ("Smile", "Frown", "Dimple", "Stretch")
_LIPS = ("RollLower", "RollUpper", "ShrugLower", "ShrugUpper")
_SIDES = ("Left", "Right")

ORDER: tuple[str, ...] = (
    *(f"eye{name}{side}" for side in _SIDES for name in _SIDED_EYE),
    *("jawForward", "jawLeft", "jawRight", "jawOpen"),
    *("mouthClose", "mouthFunnel", "mouthPucker", "mouthLeft", "mouthRight"),
    *(f"mouth{name}{side}" for name in _SIDED_MOUTH for side in _SIDES),
    *(f"mouth{name}" for name in _LIPS),
    *(f"mouth{name}{side}" for name in ("Press", "LowerDown", "UpperUp") for side in _SIDES),
    *("browDownLeft", "browDownRight", "browInnerUp", "browOuterUpLeft", "browOuterUpRight"),
    *("cheekPuff", "cheekSquintLeft", "cheekSquintRight", "noseSneerLeft", "noseSneerRight", "tongueOut"),
)
"""The shapes as they are sent."""

_ANGLES = (0.0,) * (VALUES - len(ORDER))
_COLUMNS = [INDEX[name] for name in ORDER]


class LiveLinkFaceWriter:
    """Makes datagrams of frames; receivers distinguish them by `device`, the same each time if none is given."""

    def __init__(self, frame_rate_hz: int, *, subject: str = SUBJECT, device: uuid.UUID | None = None) -> None:
        self._rate_hz = frame_rate_hz
        named = device or uuid.uuid5(uuid.NAMESPACE_DNS, f"{subject}.understudy.invalid")
        self._head = struct.pack(">B", VERSION) + _string(str(named).upper()) + _string(subject)

    def datagrams(self, frame: BodyFrame) -> list[bytes]:
        """The frame as one datagram."""
        shapes: FloatArray = frame.shapes[_COLUMNS]
        number = round(frame.at_s * self._rate_hz)
        timed = struct.pack(">ifiiB", number, 0.0, self._rate_hz, 1, VALUES)
        return [self._head + timed + struct.pack(f">{VALUES}f", *shapes.tolist(), *_ANGLES)]


def _string(text: str) -> bytes:
    content = text.encode()
    return struct.pack(">i", len(content)) + content
