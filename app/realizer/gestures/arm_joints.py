"""The joints of an arm from collarbone to fingertips, and the independently moving parts that a gesture can define."""

from ...model import Hand
from ..body.skeleton import FINGERS

_PHALANGES = ("Proximal", "Intermediate", "Distal")
FINGER_JOINTS: tuple[str, ...] = tuple(
    finger + phalanx
    for finger in FINGERS
    for phalanx in (("Metacarpal", "Proximal", "Distal") if finger == "Thumb" else _PHALANGES)
)
PARTS: tuple[str, ...] = ("Shoulder", "UpperArm", "Elbow", "LowerArm", "Hand", *FINGER_JOINTS)
"""The rows of a `PartialPose`: the joints of an arm, with the lower arm split into the elbow's hinge and the twist."""


def arm_joints(side: Hand) -> tuple[str, ...]:
    """The nineteen joints of an arm in the skeleton's order, from the collarbone to the little finger's tip."""
    return tuple(side.value + name for name in PARTS if name != "Elbow")
