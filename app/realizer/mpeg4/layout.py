"""The ASCII layout of body and face animation parameters, as MPEG-4 players read it (docs/references.md).

The first line is `VERSION NAME FRAMES-A-SECOND FRAMES`. Of each frame there are two lines: the mask, a 1 for every
parameter that is set, then the frame's number and one integer for each of these.

Our joints as those of MPEG-4's body, and rotations as angles about its axes, whatever a decoder makes of them.

Angles are from the pose in which a body stands with its arms down, palms to the thighs; each joint's axes are the
world's there (X to its left, Y up, Z forward). Our spine has three joints, which are the vertebrae L3, T10 and T6; the
neck is C4.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ...errors import InputError
from ...model import FloatArray
from ..gestures.hand_shapes import THUMB_HINGE

NAME = "understudy"
MOST_RATE_HZ = 1000

SIDES = (("l", "left"), ("r", "right"))
_PAIRED = (
    *("hip_flexion", "hip_abduct", "hip_twisting", "knee_flexion", "knee_twisting", "ankle_flexion", "ankle_twisting"),
    *("subtalar_flexion", "midtarsal_twisting", "metatarsal_flexion", "sternoclavicular_abduct"),
    *("sternoclavicular_rotate", "acromioclavicular_abduct", "acromioclavicular_rotate", "shoulder_flexion"),
    *("shoulder_abduct", "shoulder_twisting", "elbow_flexion", "elbow_twisting", "wrist_flexion", "wrist_pivot"),
    "wrist_twisting",
)
_VERTEBRAE = (
    "skullbase",
    *(f"v{part}{number}" for part, count in (("c", 7), ("t", 12), ("l", 5)) for number in range(1, count + 1)),
)
_FINGER = ("0_flexion", "1_flexion", "1_pivot", "1_twisting", "2_flexion", "3_flexion")


def _both(names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(f"{side}_{name}" for name in names for side, _ours in SIDES)


BAPS: tuple[str, ...] = (
    *(f"sacroiliac_{turn}" for turn in ("tilt", "torsion", "roll")),
    *_both(_PAIRED),
    *(f"{bone}_{turn}" for bone in _VERTEBRAE for turn in ("roll", "torsion", "tilt")),
    *_both(tuple(f"{finger}{part}" for finger in ("pinky", "ring", "middle", "index") for part in _FINGER)),
    *_both(tuple(f"thumb{part}" for part in _FINGER[1:])),
    *(f"HumanoidRoot_tr_{way}" for way in ("vertical", "lateral", "frontal")),
    *(f"HumanoidRoot_rt_body_{turn}" for turn in ("turn", "roll", "tilt")),
)
"""The 186 body animation parameters in the order of their columns."""

FAPS: tuple[str, ...] = (
    *("viseme", "expression", "open_jaw", "lower_t_midlip", "raise_b_midlip", "stretch_l_cornerlip"),
    *("stretch_r_cornerlip", "lower_t_lip_lm", "lower_t_lip_rm", "raise_b_lip_lm", "raise_b_lip_rm"),
    *("raise_l_cornerlip", "raise_r_cornerlip", "thrust_jaw", "shift_jaw", "push_b_lip", "push_t_lip"),
    *("depress_chin", "close_t_l_eyelid", "close_t_r_eyelid", "close_b_l_eyelid", "close_b_r_eyelid"),
    *("yaw_l_eyeball", "yaw_r_eyeball", "pitch_l_eyeball", "pitch_r_eyeball", "thrust_l_eyeball"),
    *("thrust_r_eyeball", "dilate_l_pupil", "dilate_r_pupil", "raise_l_i_eyebrow", "raise_r_i_eyebrow"),
    *("raise_l_m_eyebrow", "raise_r_m_eyebrow", "raise_l_o_eyebrow", "raise_r_o_eyebrow", "squeeze_l_eyebrow"),
    *("squeeze_r_eyebrow", "puff_l_cheek", "puff_r_cheek", "lift_l_cheek", "lift_r_cheek", "shift_tongue_tip"),
    *("raise_tongue_tip", "thrust_tongue_tip", "raise_tongue", "tongue_roll", "head_pitch", "head_yaw", "head_roll"),
    *("lower_t_midlip_o", "raise_b_midlip_o", "stretch_l_cornerlip_o", "stretch_r_cornerlip_o"),
    *("lower_t_lip_lm_o", "lower_t_lip_rm_o", "raise_b_lip_lm_o", "raise_b_lip_rm_o", "raise_l_cornerlip_o"),
    *("raise_r_cornerlip_o", "stretch_l_nose", "stretch_r_nose", "raise_nose", "bend_nose", "raise_l_ear"),
    *("raise_r_ear", "pull_l_ear", "pull_r_ear"),
)
"""The 68 face animation parameters in the order of their columns."""


FIELDS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "viseme": ("viseme_select1", "viseme_select2", "viseme_blend", "viseme_def"),
        "expression": (
            *("expression_select1", "expression_intensity1", "expression_select2", "expression_intensity2"),
            *("init_face", "expression_def"),
        ),
    }
)
"""The integers of parameters that have several; all others have one."""


@dataclass(frozen=True, slots=True, eq=False)
class Parameters:
    """The integers (T, N) of the parameters that are set, by name; one with several stands as often, in their order."""

    names: tuple[str, ...]
    values: NDArray[np.int64]


def parameter_file(version: str, ending: str, rate_hz: int, every: tuple[str, ...], found: Parameters) -> bytes:
    """The file; `every` are all parameters in the order of columns, of which those found are set in every frame."""
    order = sorted(range(len(found.names)), key=lambda place: every.index(found.names[place]))
    mask = " ".join("1" if name in found.names else "0" for name in every)
    lines = [f"{version} {NAME}{ending} {rate_hz} {len(found.values)}"]
    for frame, row in enumerate(found.values[:, order].tolist()):
        lines += [mask, " ".join(map(str, (frame, *row)))]
    return ("\n".join(lines) + "\n").encode()


@dataclass(frozen=True, slots=True, eq=False)
class ReadParameters:
    """A file: its version, its rate, and the numbers (T,) of each parameter that it sets anywhere, by name; those with
    several by the names of `FIELDS`. Where a frame does not set one, it stays as it was, 0 at first."""

    version: str
    rate_hz: float
    frames: int
    numbers: Mapping[str, FloatArray]


def read_parameter_file(content: bytes, every: tuple[str, ...], name: str) -> ReadParameters:
    """A file of the parameters `every`; raises InputError `mpeg4_wrong` with the line that cannot be read."""
    lines = [line.split() for line in content.decode("latin-1").splitlines() if line.strip()]
    version, rate_hz, frames = _first_line(lines[0] if lines else [], name)
    if len(lines) < 1 + 2 * frames:
        raise _unreadable(
            name, len(lines), f"the file ends too soon; its first line announces {frames} frames of two lines"
        )
    rows, now = [], dict[str, float]()
    for frame in range(frames):
        place = 1 + 2 * frame
        now |= _frame(lines[place], lines[place + 1], every, f"{name}:{place + 1}")
        rows.append(dict(now))
    found = {key: np.array([row.get(key, 0.0) for row in rows]) for key in now}
    return ReadParameters(version, rate_hz, frames, found)


def _first_line(told: Sequence[str], name: str) -> tuple[str, float, int]:
    try:
        version, _name, rate, count = told
        rate_hz, frames = float(rate), int(count)
    except ValueError:
        raise _unreadable(name, 1, "the first line is VERSION NAME FRAMES-A-SECOND FRAMES") from None
    if not (0 < rate_hz <= MOST_RATE_HZ and frames > 0):
        raise _unreadable(name, 1, f"{rate} frames a second, {count} frames; give 1 to {MOST_RATE_HZ}, and 1 or more")
    return version, rate_hz, frames


def _frame(mask: Sequence[str], told: Sequence[str], every: tuple[str, ...], place: str) -> dict[str, float]:
    if len(mask) != len(every) or set(mask) - {"0", "1"}:
        raise InputError("mpeg4_wrong", f"{place}: a mask of {len(every)} columns of 0 or 1 is expected", field="bml")
    names = [name for name, is_set in zip(every, mask, strict=True) if is_set == "1"]
    fields = [field for name in names for field in FIELDS.get(name, (name,))]
    if len(told) - 1 == len(names):  # one number for each, as some write visemes and expressions too
        fields = [FIELDS[name][0] if name in FIELDS else name for name in names]
    try:
        numbers = [float(number) for number in told[1:]]
    except ValueError:
        numbers = []
    if len(numbers) != len(fields) or not np.isfinite(numbers).all():
        message = f"{place}: {len(told) - 1} numbers follow the mask, which asks for {len(fields)}"
        raise InputError("mpeg4_wrong", message, field="bml")
    return dict(zip(fields, numbers, strict=True))


def _unreadable(name: str, line: int, message: str) -> InputError:
    return InputError("mpeg4_wrong", f"{name}:{line}: {message}", field="bml")


TRUNK: Mapping[str, str] = MappingProxyType(
    {"spine": "vl3", "chest": "vt10", "upperChest": "vt6", "neck": "vc4", "head": "skullbase"}
)
"""The vertebra that each joint of our trunk is."""

FINGERS: Mapping[str, str] = MappingProxyType({"Index": "index", "Middle": "middle", "Ring": "ring", "Little": "pinky"})
FINGER_BENDS = (("Intermediate", "2_flexion"), ("Distal", "3_flexion"))
THUMB_BENDS = (("Proximal", "thumb2_flexion"), ("Distal", "thumb3_flexion"))

FINGER_HINGE: FloatArray = np.array([0.0, 0.0, 1.0])
"""The axis about which the outer joints of a finger bend, of the left hand towards its back."""


def euler_rad(rotations: Rotation, order: str) -> FloatArray:
    """The angles (T, 3) about three axes, each as the turns before leave it. Where the first and the last are one axis,
    the last is 0."""
    matrices = rotations.as_matrix()
    i, j, k = ("XYZ".index(axis) for axis in order)
    parity = 1.0 if (j - i) % 3 == 1 else -1.0
    sine = np.clip(parity * matrices[:, i, k], -1.0, 1.0)
    locked = np.abs(sine) > 1 - 1e-12
    first = np.arctan2(-parity * matrices[:, j, k], matrices[:, k, k])
    last = np.arctan2(-parity * matrices[:, i, j], matrices[:, i, i])
    alone = np.arctan2(parity * matrices[:, k, j], matrices[:, j, j])
    return np.stack([np.where(locked, alone, first), np.arcsin(sine), np.where(locked, 0.0, last)], axis=1)


def angle_about(rotations: Rotation, axis: FloatArray) -> FloatArray:
    """The angles (T,) about an axis, which may be more than 90°."""
    quaternions = rotations.as_quat()
    return np.asarray(2 * np.arctan2(quaternions[:, :3] @ (axis / np.linalg.norm(axis)), quaternions[:, 3]))


def arms_down(side: str) -> Rotation:
    """The turn of an arm from the T-pose to hanging."""
    return Rotation.from_euler("z", -90.0 if side == "left" else 90.0, degrees=True)


def thumb_hinge(side: str) -> FloatArray:
    """The axis, in the T-pose, about which the outer joints of a thumb bend."""
    return np.asarray(THUMB_HINGE if side == "left" else THUMB_HINGE * (1.0, -1.0, -1.0))
