"""The joints of Understudy's skeleton by name: VRM 1.0's humanoid bones, which its clips animate."""

SIDES = ("left", "right")
FINGERS = ("Thumb", "Index", "Middle", "Ring", "Little")

TRUNK = ("hips", "spine", "chest", "upperChest", "neck", "head")
SIDED = (
    *("Eye", "Shoulder", "UpperArm", "LowerArm", "Hand"),
    *("ThumbMetacarpal", "ThumbProximal", "ThumbDistal"),
    *(finger + part for finger in FINGERS[1:] for part in ("Proximal", "Intermediate", "Distal")),
    *("UpperLeg", "LowerLeg", "Foot", "Toes"),
)
JOINTS = (*TRUNK, *(side + part for part in SIDED for side in SIDES))

NEEDED = ("hips", "head", *(side + part for part in ("UpperArm", "LowerArm", "Hand") for side in SIDES))
"""Joints without which an armature is not a humanoid that can perform."""

HEAD = frozenset({"neck", "head"})
EYES = frozenset({"leftEye", "rightEye"})
