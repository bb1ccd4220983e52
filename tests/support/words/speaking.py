"""Faces for the tests: visemes of phones said one after the other, and a body that stands still beneath the face."""

from pathlib import Path

import numpy as np

from understudy.behavior.speech import visemes
from understudy.model import Behavior, Channel, FloatArray, Interval, Phone, Schedule, SyncPoints, Viseme, Word
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.face.blendshapes import face_weights
from understudy.realizer.face.face_tables import INDEX, FaceTables
from understudy.realizer.geometry.rotations import IDENTITY

TABLES = FaceTables.load(Path(__file__).resolve().parents[3] / "lexicon" / "face.yaml")
SKELETON = Skeleton.standing()
START_S = 0.5
"""When the first phone begins: the mouth is at rest before."""


def said(phones: str, *, phone_s: float = 0.1, emphasis: float = 1.0) -> tuple[Viseme, ...]:
    """The visemes of these phones, with half a second of silence on either side."""
    labels = phones.split()
    bounds_s = [START_S + number * phone_s for number in range(len(labels) + 1)]
    spoken = tuple(Phone(label, Interval(*bounds_s[k : k + 2])) for k, label in enumerate(labels))
    word = Word(0, phones, Interval(bounds_s[0], bounds_s[-1]), spoken, emphasis=emphasis)
    return visemes((word,), bounds_s[-1] + 0.5)[0]


def times(end_s: float, rate_hz: int = 60) -> FloatArray:
    return np.arange(0, end_s + 1e-9, 1 / rate_hz)


def still(times_s: FloatArray) -> BodyMotion:
    rotations = np.tile(IDENTITY, (len(times_s), len(SKELETON.names), 1))
    return BodyMotion(times_s, rotations, np.zeros((len(times_s), 3)))


def shown(lexeme: str, *, amount: float | None = None, kind: Channel = Channel.FACE, start_s: float = 0.2) -> Behavior:
    """A face that is whole from 0.4 to 1.0 s, if nothing else is said."""
    sync = SyncPoints(start=start_s, ready=start_s + 0.2, relax=start_s + 0.8, end=start_s + 1.2)
    return Behavior("face1", kind, lexeme, sync, 0, 0, 1.0, amount=amount)


def faced(
    spoken: tuple[Viseme, ...] = (), behaviors: tuple[Behavior, ...] = (), *, end_s: float = 2.0, seed: int = 1
) -> FloatArray:
    """The face's weights at 60 frames a second."""
    schedule = Schedule(behaviors, end_s, visemes=spoken)
    return face_weights(TABLES, schedule, still(times(end_s)), SKELETON, seed=seed)


def shape(shapes: FloatArray, name: str, at_s: float) -> float:
    """The weight of a shape at the frame nearest to a time."""
    return float(shapes[round(at_s * 60), INDEX[name]])


def middle_s(spoken: tuple[Viseme, ...], label: str) -> float:
    """The middle of the first viseme of that label."""
    interval = next(viseme.interval for viseme in spoken if viseme.label == label)
    return (interval.start_s + interval.end_s) / 2
