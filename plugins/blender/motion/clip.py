"""A clip as Understudy writes it (docs/motion-formats.md, "Clip JSON"), as arrays.

Conventions: metres, Y up, the character faces +Z and its left is +X; the T-pose is the identity rotation of every
joint. Quaternions are w x y z here. Frame k is at `start_s + k / rate_hz` seconds of the recording.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import ceil, floor
from typing import Any

import numpy as np

from .rotations import Array, matrices


@dataclass(frozen=True, slots=True)
class Event:
    """A sync point as it was realized, in seconds of the recording."""

    behavior: str
    point: str
    time_s: float


@dataclass(frozen=True, slots=True)
class Decision:
    """A deviation from the BML and its reason; `behavior` is empty if it concerns no single behaviour."""

    behavior: str
    message: str


@dataclass(frozen=True, slots=True, eq=False)
class Clip:
    """A motion: local rotations (T, 4) by joint, places of the hips (T, 3), weights (T,) of the face's shapes and of
    visemes by name; `parents` and `offsets_m` are the skeleton, parents first; `decisions` and `notices` say what was
    changed or guessed on the way."""

    rate_hz: float
    start_s: float
    parents: Mapping[str, str]
    offsets_m: Mapping[str, Array]
    rotations: Mapping[str, Array]
    hips_m: Array
    shapes: Mapping[str, Array]
    visemes: Mapping[str, Array]
    events: tuple[Event, ...]
    decisions: tuple[Decision, ...] = ()
    notices: tuple[str, ...] = ()

    @property
    def frames(self) -> int:
        return len(self.hips_m)

    @property
    def end_s(self) -> float:
        """The time of the last frame."""
        return self.start_s + (self.frames - 1) / self.rate_hz

    def world_rotations(self) -> dict[str, Array]:
        """The rotation of each joint in the world (T, 3, 3)."""
        world: dict[str, Array] = {}
        for joint, parent in self.parents.items():
            local = matrices(self.rotations[joint])
            world[joint] = world[parent] @ local if parent else local
        return world

    def t_pose_m(self) -> dict[str, Array]:
        """The place of each joint in the T-pose."""
        places: dict[str, Array] = {}
        for joint, parent in self.parents.items():
            places[joint] = self.offsets_m[joint] + (places[parent] if parent else 0.0)
        return places

    def at_rate(self, rate_hz: float) -> "Clip":
        """The same motion with its frames on the beat of another rate, which has one at second 0 of the recording.

        Between two frames of the clip values are mixed; quaternions are then of length 1 again, which at 60 frames a
        second is within .001° of turning steadily.
        """
        first, last = ceil(self.start_s * rate_hz - 1e-6), floor(self.end_s * rate_hz + 1e-6)
        at = (np.arange(first, last + 1) / rate_hz - self.start_s) * self.rate_hz
        at = np.clip(at, 0, self.frames - 1)

        def mixed(values: Array) -> Array:
            below = np.minimum(at.astype(int), max(self.frames - 2, 0))
            share = (at - below).reshape(-1, *(1,) * (values.ndim - 1))
            after = values[np.minimum(below + 1, self.frames - 1)]
            found: Array = values[below] * (1 - share) + after * share
            return found

        return replace(
            self,
            rate_hz=rate_hz,
            start_s=first / rate_hz,
            rotations={joint: _unit(mixed(values)) for joint, values in self.rotations.items()},
            hips_m=mixed(self.hips_m),
            shapes={name: mixed(values) for name, values in self.shapes.items()},
            visemes={name: mixed(values) for name, values in self.visemes.items()},
        )


def read_clip(content: bytes) -> Clip:
    """A clip with our own joint names. Raises ValueError, which says what is wrong, if it is none."""
    try:
        written = json.loads(content)
    except ValueError as error:
        raise ValueError(f"the motion that was answered is not JSON: {error}") from None
    if not isinstance(written, dict) or (written.get("format"), written.get("version")) != ("understudy-clip", 1):
        raise ValueError("the service's motion is not an understudy-clip of version 1; update the add-on")
    frames, start_s = int(written["frames"]), float(written["audio_offset_s"])
    joints = written["skeleton"]["joints"]
    return Clip(
        rate_hz=float(written["frame_rate_hz"]),
        start_s=start_s,
        parents={joint["name"]: joint["parent"] or "" for joint in joints},
        offsets_m={joint["name"]: np.array(joint["offset_m"]) for joint in joints},
        rotations={name: _tracked(track, frames)[:, [3, 0, 1, 2]] for name, track in written["bones"].items()},
        hips_m=_tracked(written["hips_m"], frames),
        shapes={name: _tracked(track, frames) for name, track in written["blendshapes"].items()},
        visemes={name: _tracked(track, frames) for name, track in written.get("visemes", {}).items()},
        events=tuple(_event(each, start_s) for each in written["events"]),
        decisions=tuple(
            Decision(each["behavior"] or "", f"{each['action']}: {each['reason']}") for each in written["decisions"]
        ),
        notices=tuple(each["message"] for each in written["notices"]),
    )


def _event(each: Mapping[str, Any], start_s: float) -> Event:
    return Event(each["behavior"], each["point"], each["time_s"] + start_s)


def _tracked(track: list[Any], frames: int) -> Array:
    """A value a frame; a constant track has but one."""
    values = np.array(track, dtype=float)
    return np.broadcast_to(values, (frames, *values.shape[1:])) if len(values) == 1 else values


def _unit(values: Array) -> Array:
    unit: Array = values / np.linalg.norm(values, axis=-1, keepdims=True)
    return unit
