"""The parts of the body that behaviours occupy."""

from enum import StrEnum


class Channel(StrEnum):
    """The part of the body a behaviour occupies; two behaviours compete only on the same channel."""

    GESTURE = "gesture"
    HEAD = "head"
    GAZE = "gaze"
    FACE = "face"
    EYES = "eyes"
    POSTURE = "posture"


class Hand(StrEnum):
    """Which hand a gesture takes."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"
