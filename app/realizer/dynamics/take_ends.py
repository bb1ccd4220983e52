"""Eases the motion in at the start of a take and out at its end, so that no take begins or ends in mid-movement.

The clock of arms and trunk stands still at both ends, and runs up to twice as fast a little further in; in between it
is the clock of the performance. The first and the last pose are those of the first and the last frame.

What moves a hand after that, such as limbs that are kept apart, does not follow this clock. Where a wrist is not at
rest in the first or the last frames of the finished motion, the whole body goes by such a clock again, but for the
eyes: they move as fast as eyes can already.
"""

import numpy as np

from ...model import FloatArray
from ..body.contacts import PosedBody
from ..body.motion import BodyMotion
from ..body.skeleton import HANDS, Skeleton
from ..geometry.curves import clipped
from ..geometry.rotations import length, nearest_sign, normalized

_STANDS_S = 0.02
"""The time for which the clock of arms and trunk stands still at either end."""
_BODY_STANDS_S = 1 / 24
"""The same of the whole body: a frame of film."""
_AT_REST_M_S = 0.08
"""The speed of a wrist that is at rest; people see a take begin in mid-movement from about .1 m/s on."""


def eased_at_the_ends(times_s: FloatArray, over_s: float, stands_s: float = _STANDS_S) -> FloatArray:
    """The times (T,) of the poses for frames at `times_s`: the clock stands still at both ends, and is that of the
    performance from `over_s` further in."""
    span_s = min(over_s, float(times_s[-1] - times_s[0]) / 2)
    if span_s <= stands_s:
        return times_s
    since_s, left_s = times_s - times_s[0], times_s[-1] - times_s
    return np.asarray(times_s - _behind_s(since_s, span_s, stands_s) + _behind_s(left_s, span_s, stands_s))


def _behind_s(from_end_s: FloatArray, span_s: float, stands_s: float) -> FloatArray:
    """The lag of a clock that stands, starts without speed and acceleration, and is on time at the end of the span, as
    fast as any: what it has made up is a polynomial of fifth degree of the share of the time in which it moves."""
    moves_s = span_s - stands_s
    whole = span_s / moves_s
    share = clipped((from_end_s - stands_s) / moves_s, 0.0, 1.0)
    made_up = share * share * share * (10 * whole - 4 + share * (7 - 15 * whole + share * (6 * whole - 3)))
    return np.asarray(np.minimum(from_end_s, span_s) - moves_s * made_up)


def ease_ends(skeleton: Skeleton, body: BodyMotion, over_s: float, posed: PosedBody | None = None) -> bool:
    """Bring the body to rest in its first and last frames, in place. Returns whether it was not: it is left as it is if
    its wrists are at rest, or `over_s` is 0. `posed`, where its joints are, need not be given."""
    if not over_s or not _moves_at_an_end(skeleton, body, posed):
        return False
    times_s = body.times_s
    eased_s = eased_at_the_ends(times_s, over_s, _BODY_STANDS_S)
    frames = np.flatnonzero(np.abs(eased_s - times_s) > 1e-9)
    place = np.interp(eased_s[frames], times_s, np.arange(len(times_s)))
    before = np.minimum(place.astype(int), len(times_s) - 2)
    share = (place - before)[:, None]
    body.hips_m[frames] = _between(body.hips_m[before], body.hips_m[before + 1], share)
    turned, now = body.rotations[before], body.rotations[frames]
    after = nearest_sign(body.rotations[before + 1], turned)
    eased = nearest_sign(normalized(_between(turned, after, share[:, None])), now)
    eyes = skeleton.chain("leftEye", "rightEye")
    eased[:, eyes] = now[:, eyes]
    body.rotations[frames] = eased
    return True


def _between(one: FloatArray, other: FloatArray, share: FloatArray) -> FloatArray:
    return np.asarray(one + share * (other - one))


def _moves_at_an_end(skeleton: Skeleton, body: BodyMotion, posed: PosedBody | None) -> bool:
    """Whether a wrist moves between the first or the last frames, of a film as slow as any."""
    step_s = float(body.times_s[1] - body.times_s[0])
    steps = min(max(int(_BODY_STANDS_S / step_s), 1), len(body.times_s) - 1)
    inwards = np.arange(steps + 1)
    frames = np.array((inwards, len(body.times_s) - 1 - inwards))
    posed = posed or PosedBody.carrying(skeleton, body.rotations, body.hips_m)
    wrists_m = posed.positions_m[frames[..., None], skeleton.chain(*HANDS)]
    way_m = length(wrists_m[:, 1:] - wrists_m[:, :1])[..., 0].max(axis=2)
    return bool(np.any(way_m > _AT_REST_M_S * step_s * inwards[1:]))
