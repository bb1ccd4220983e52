"""The joints of an arm, from the collarbone to the fingertips, and the parts that a gesture can say something of."""

from ...model import Hand
from ..body.skeleton import FINGERS

_PHALANGES = ("Proximal", "Intermediate", "Distal")
FINGER_JOINTS: tuple[str, ...] = tuple(
    finger + phalanx
    for finger in FINGERS
    for phalanx in (("Metacarpal", "Proximal", "Distal") if finger == "Thumb" else _PHALANGES)
)
PARTS: tuple[str, ...] = ("Shoulder", "UpperArm", "Elbow", "LowerArm", "Hand", *FINGER_JOINTS)
"""The rows of a `PartialPose`: an arm's joints, but the lower arm's rotation as the elbow's hinge, then its twist."""


def arm_joints(side: Hand) -> tuple[str, ...]:
    """The nineteen joints of an arm in the skeleton's order, from the collarbone to the little finger's tip."""
    return tuple(side.value + name for name in PARTS if name != "Elbow")
