"""Exports the face alone: as a Live Link Face CSV, ARKit's 52 blendshapes and the rotations of head and eyes; and the
visemes as a timed list, as lip-sync tools exchange them.

Conventions of the CSV: one row per frame. Timecodes count from the first frame of the motion:
hours:minutes:seconds:frame.thousandth of a frame. Angles are in radians; yaw to the character's left, pitch up and roll
towards its left shoulder are positive. The head's angles are in the world, the eyes' relative to the head.

Conventions of the list: each line is a time in seconds of the audio, a tab and a viseme that lasts until the next line
(the format of Rhubarb Lip Sync); the last line is `sil`, as are gaps between visemes.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from ...model import FloatArray, Viseme
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


SILENCE = "sil"


def to_viseme_text(visemes: Sequence[Viseme], duration_s: float) -> bytes:
    """The list as text; `duration_s` is the audio's duration."""
    return "".join(f"{start_s:.3f}\t{label}\n" for start_s, label in _changes(visemes, duration_s)).encode()


def _changes(visemes: Sequence[Viseme], duration_s: float) -> Iterator[tuple[float, str]]:
    """The start time of each viseme, with silences in the gaps."""
    shown, until_s = None, 0.0
    for each in visemes:
        if each.interval.start_s > until_s + 5e-4 and shown != SILENCE:
            yield until_s, SILENCE
            shown = SILENCE
        if each.label != shown:
            yield each.interval.start_s, each.label
        shown, until_s = each.label, each.interval.end_s
    if shown != SILENCE:
        yield until_s, SILENCE
    if duration_s > until_s:
        yield duration_s, SILENCE
