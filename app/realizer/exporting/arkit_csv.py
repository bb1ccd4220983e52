"""Exports the face as a Live Link Face CSV: ARKit's 52 blendshapes and the rotations of head and eyes.

Conventions: one row per frame. Timecodes count from the first frame of the motion:
hours:minutes:seconds:frame.thousandth of a frame. Angles are in radians; yaw to the character's left, pitch up and roll
towards its left shoulder are positive. The head's angles are in the world, the eyes' relative to the head.
"""

import numpy as np

from ...model import FloatArray
from ..body.motion import SHAPES, Motion
from ..body.skeleton import Skeleton, forward
from ..geometry.rotations import rotate

_EYE = ("Blink", "LookDown", "LookIn", "LookOut", "LookUp", "Squint", "Wide")
_BOTH_SIDES = ("Smile", "Frown", "Dimple", "Stretch")
COLUMNS: tuple[str, ...] = (
    *(f"Eye{name}{side}" for side in ("Left", "Right") for name in _EYE),
    *("JawForward", "JawRight", "JawLeft", "JawOpen", "MouthClose", "MouthFunnel", "MouthPucker"),
    *("MouthRight", "MouthLeft"),
    *(f"Mouth{name}{side}" for name in _BOTH_SIDES for side in ("Left", "Right")),
    *("MouthRollLower", "MouthRollUpper", "MouthShrugLower", "MouthShrugUpper"),
    *(f"Mouth{name}{side}" for name in ("Press", "LowerDown", "UpperUp") for side in ("Left", "Right")),
    *("BrowDownLeft", "BrowDownRight", "BrowInnerUp", "BrowOuterUpLeft", "BrowOuterUpRight"),
    *("CheekPuff", "CheekSquintLeft", "CheekSquintRight", "NoseSneerLeft", "NoseSneerRight", "TongueOut"),
)
"""The blendshapes in the order of Live Link Face."""

TURNS: tuple[str, ...] = tuple(
    f"{part}{turn}" for part in ("Head", "LeftEye", "RightEye") for turn in ("Yaw", "Pitch", "Roll")
)


def to_arkit_csv(motion: Motion, skeleton: Skeleton) -> bytes:
    """The CSV as UTF-8 text."""
    header = ",".join(("Timecode", "BlendShapeCount", *COLUMNS, *TURNS))
    order = [SHAPES.index(name[0].lower() + name[1:]) for name in COLUMNS]
    values = np.concatenate([motion.shapes[:, order], _turns(motion, skeleton)], axis=1)
    row = ",".join(["%s", str(values.shape[1]), *["%.6f"] * values.shape[1]])
    rate = motion.frame_rate_hz
    lines = [
        row % (_timecode(frame, rate), *frame_values) for frame, frame_values in enumerate((values + 0.0).tolist())
    ]
    return "\n".join([header, *lines, ""]).encode()


def _turns(motion: Motion, skeleton: Skeleton) -> FloatArray:
    """Yaw, pitch and roll (T, 9) of the head and both eyes."""
    head = skeleton.index["head"]
    above = frozenset(_up_from(skeleton, head))
    _places, turned = forward(skeleton, motion.body.rotations, motion.body.hips_m, above)
    eyes = [motion.body.rotations[:, skeleton.index[eye]] for eye in ("leftEye", "rightEye")]
    return np.concatenate([_yaw_pitch_roll(turn) for turn in (turned[:, head], *eyes)], axis=1)


def _up_from(skeleton: Skeleton, joint: int) -> list[int]:
    return [] if joint < 0 else [joint, *_up_from(skeleton, skeleton.parents[joint])]


def _yaw_pitch_roll(turns: FloatArray) -> FloatArray:
    ahead, up, left = (rotate(turns, np.broadcast_to(np.eye(3)[k], (*turns.shape[:-1], 3))) for k in (2, 1, 0))
    yaw = np.arctan2(ahead[..., 0], ahead[..., 2])
    pitch = np.arcsin(np.clip(ahead[..., 1], -1, 1))
    roll = -np.arctan2(left[..., 1], up[..., 1])
    return np.stack([yaw, pitch, roll], axis=-1)


def _timecode(frame: int, rate_hz: int) -> str:
    seconds, within = divmod(frame, rate_hz)
    return f"{seconds // 3600:02d}:{seconds // 60 % 60:02d}:{seconds % 60:02d}:{within:02d}.000"
