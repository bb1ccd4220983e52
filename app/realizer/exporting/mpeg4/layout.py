"""The ASCII layout of body and face animation parameters, as MPEG-4 players read it (docs/references.md).

The first line is `VERSION NAME FRAMES-A-SECOND FRAMES`. Of each frame there are two lines: the mask, a 1 for every
parameter that is set, then the frame's number and one integer for each of these.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

NAME = "understudy"

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


@dataclass(frozen=True, slots=True, eq=False)
class Parameters:
    """The integers (T, N) of the parameters that are set, by name."""

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
