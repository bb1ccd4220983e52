"""Plays a motion model's units to live speech (RTS §2.3): the modified Viterbi search decodes its prosody, a
phrase is announced as soon as its kind is likely, and the unit that joins best is played.

Announced phrases are what bodies move by, and may turn out otherwise; decided ones are final, at the latest
`COMMITMENT`'s bound after their sound. A unit is chosen by joint and duration as in RTS eq. 2.8, the duration being the
kind's mean one, for how long a phrase goes on is not known yet. When a unit is over and its kind is not, another of the
kind follows. Affect is not heard live.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..model import FRAME_SHIFT_S, Contours, FloatArray
from ..prosody_gestures.live_decoder import LiveDecoder
from ..prosody_gestures.live_gestures import COMMITMENT, Announcing
from ..prosody_gestures.prosody import HALF_WINDOW_S, ProsodyNormalizer, raw_frame, whole_frames
from ..prosody_gestures.semi_markov import FRAME_S
from ..prosody_gestures.trellis import EVERYTHING, Search
from ..realizer.arms.collisions import resolve_collisions
from ..realizer.body.motion import BodyMotion, Motion
from ..realizer.body.skeleton import Skeleton
from ..realizer.geometry.rotations import nearest_sign, normalized
from .model import THESIS_ALPHA, MotionModel, arm_angles
from .pairs import Voice
from .unit_selection import MotionUnit, led_over

AFFECTS = 3


def played(model: MotionModel, motion: Motion, voice: Contours, skeleton: Skeleton) -> Motion:
    """The motion with the joints of the model as they are played to this voice while it goes on."""
    player, at, heard = UnitPlayer(model), np.array(skeleton.chain(*model.joints)), 0
    rotations = motion.body.rotations.copy()
    for place, at_s in enumerate(motion.body.times_s - motion.lead_in_s):
        until = min(max(heard, int(at_s / FRAME_SHIFT_S)), len(voice.energy_db))
        player.hear(voice.energy_db[heard:until], voice.f0_hz[heard:until])
        heard = until
        rotations[place, at] = player.pose(rotations[place, at], float(at_s))
    body = BodyMotion(motion.body.times_s, rotations, motion.body.hips_m)
    moved_out = resolve_collisions(skeleton, body)
    return replace(motion, body=body, decisions=(*motion.decisions, *moved_out.decisions))


@dataclass(frozen=True, slots=True)
class AnnouncedPhrase:
    """A phrase of this `kind` begins at `start_s`; it is `decided`, or announced."""

    kind: int
    start_s: float
    decided: bool


class UnitPlayer:
    """Takes contours, a row each `FRAME_SHIFT_S`, and gives the joints of the model. Memory is bounded."""

    def __init__(self, model: MotionModel, search: Search = EVERYTHING) -> None:
        self.joints = model.joints
        self._model, self._pool = model, model.pool().units
        self._decoder = LiveDecoder(model.kinds, search, COMMITMENT)
        self._announcing, self._normalizer = Announcing(model.kinds.states), ProsodyNormalizer()
        durations = np.exp(model.kinds.log_duration)
        self._mean_s = durations @ np.arange(1, durations.shape[1] + 1) / durations.sum(axis=1) * FRAME_S
        self._levels_db, self._pitches_hz = np.empty(0), np.empty(0)
        self._base = self._frames = 0
        self._kind: int | None = None
        self._unit: MotionUnit | None = None
        self._track: FloatArray | None = None
        self._began_s = 0.0

    def hear(self, energy_db: FloatArray, f0_hz: FloatArray) -> tuple[AnnouncedPhrase, ...]:
        """The phrases that are announced and decided by more of the contours."""
        self._levels_db = np.concatenate([self._levels_db, energy_db])
        self._pitches_hz = np.concatenate([self._pitches_hz, f0_hz])
        found: list[AnnouncedPhrase] = []
        while self._frames < whole_frames(self._base + len(self._pitches_hz)):
            found += self._told_by_frame()
        done = max(0, int((self._frames * FRAME_S - HALF_WINDOW_S) / FRAME_SHIFT_S) - self._base - 1)
        self._levels_db, self._pitches_hz = self._levels_db[done:], self._pitches_hz[done:]
        self._base += done
        return tuple(found)

    def pose(self, usual: FloatArray, at_s: float) -> FloatArray:
        """The local rotations of the joints (joints × 4) at a time, each later than the one before; `usual` is how they
        are otherwise, until the first phrase."""
        if self._kind is None:
            return usual
        if self._track is None or self._unit is None or self._unit.state != self._kind:
            self._begin(self._kind, usual if self._track is None else self._shown(self._track, at_s), at_s)
        elif at_s - self._began_s > (len(self._track) - 1) * FRAME_S:
            self._begin(self._kind, self._track[-1], at_s)
        assert self._track is not None, "a unit has begun"
        return self._shown(self._track, at_s)

    def _told_by_frame(self) -> Iterator[AnnouncedPhrase]:
        raw = raw_frame(self._levels_db, self._pitches_hz, self._frames, self._base)
        voice = Voice(np.array([self._normalizer.push(*raw)]), np.zeros((1, AFFECTS)))
        start_s = self._frames * FRAME_S
        self._frames += 1
        decided = self._decoder.push(self._model.log_likelihoods(voice, "p")[0])
        kind = self._announcing.changed(self._decoder.scores())
        if kind is not None:
            self._kind = kind
            yield AnnouncedPhrase(kind, start_s, decided=False)
        for piece in decided:
            if piece.begins:
                yield AnnouncedPhrase(piece.segment.state, piece.segment.start * FRAME_S, decided=True)

    def _begin(self, kind: int, before: FloatArray, at_s: float) -> None:
        """Goes over to the unit of this kind that costs least, another than the one before where there is one."""
        offered = [unit for unit in self._pool[kind] if unit is not self._unit] or list(self._pool[kind])
        angles = arm_angles(self.joints, before[None])[0]
        joints = np.array([np.linalg.norm(unit.angles[0] - angles) for unit in offered])
        lasting = np.abs(np.array([unit.duration_s for unit in offered]) - self._mean_s[kind])
        self._unit = offered[int((THESIS_ALPHA * joints + (1 - THESIS_ALPHA) * lasting).argmin())]
        self._track, self._began_s = led_over(before, self._unit.rotations), at_s

    def _shown(self, track: FloatArray, at_s: float) -> FloatArray:
        place = min((at_s - self._began_s) / FRAME_S, len(track) - 1.0)
        first = int(place)
        one, other = track[first], track[min(first + 1, len(track) - 1)]
        return normalized(one + (place - first) * (nearest_sign(other, one) - one))
