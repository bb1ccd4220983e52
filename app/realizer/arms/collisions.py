"""Post-processing: keeps hands and forearms out of the body and each other, and joints within their limits.

Conventions: metres in the world, time in frames. Where a limb penetrates something, its wrist and elbow are displaced
along the shortest way out. The displacement is blended in and out over the surrounding frames so that velocity stays
continuous, and the arm is solved again for its new wrist. The hand keeps its orientation as far as joint limits allow.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray, Hand
from ..body.build import BUILD
from ..body.contacts import LIMBS, PAIRS, Contacts, PosedBody, contacts, depths_m, radii_m
from ..body.limits import MIRROR, clamped, swing_twist_deg
from ..body.motion import BodyMotion, Decision
from ..body.skeleton import SIDES, Skeleton
from ..geometry.easing import minimum_jerk
from ..geometry.rotations import angle_between, dot, from_axis_angle, inverse, length, multiply, nearest_sign, rotate
from ..gestures.wrist_angles import preserving_wrist_angles
from .arm_reach import ArmBones, reach_by_elbow, towards_elbow

_CLEARANCE_M = 0.004
_SWELLS_S = (0.18, 0.27, 0.36)
"""Over how long a displacement is blended in; longer only where something stays inside."""
_ROUNDS = 8
_ELBOW_AT_LEAST_M = 0.12
_FARTHEST_M = 0.22
_LOOK_S, _NEAR_M = 0.067, 0.012
_FASTEST_RAD_S = 19.0
_TOLERATED_M = 0.001
_MIRRORED: FloatArray = np.array([-1.0, 1.0, 1.0])


def _together() -> tuple[list[int], ...]:
    """Columns of contacts that are resolved on the same side: each limb's with trunk and legs, and all of arm with
    arm."""
    whose = ["arms" if BUILD[other].part in LIMBS else BUILD[limb].joint for limb, other in PAIRS]
    return tuple([column for column, name in enumerate(whose) if name == each] for each in dict.fromkeys(whose))


_TOGETHER = _together()


@dataclass(frozen=True, slots=True, eq=False)
class _Push:
    """The displacements (T, 3) of a wrist and an elbow."""

    wrist_m: FloatArray
    elbow_m: FloatArray

    def and_then(self, other: "_Push") -> "_Push":
        wrist_m, elbow_m = self.wrist_m + other.wrist_m, self.elbow_m + other.elbow_m
        return _Push(_at_most(wrist_m, _FARTHEST_M), _at_most(elbow_m, _FARTHEST_M))

    def swelling(self, swell: int, taper: FloatArray) -> "_Push":
        return _Push(*(taper * _swelling(push_m, swell) for push_m in (self.wrist_m, self.elbow_m)))


def resolve_collisions(skeleton: Skeleton, body: BodyMotion) -> tuple[BodyMotion, tuple[Decision, ...]]:
    """Move hands and forearms out of torso, head, upper legs and each other, and bring trunk, neck and arms within
    limits.

    Returns the new motion, and a decision for each stretch of time in which a hand was displaced, or could not be
    without making a joint jump.

    Penetration that is left after a round is added to the displacement and the arms are solved again from the original
    motion, so the displacement stays smooth however many rounds are needed. Where that leaves something inside, as when
    both arms fold at once, displacements are blended in over a longer time.
    """
    body = replace(body, rotations=clamped(skeleton, body.rotations))
    depth_m = depths_where_near_m(skeleton, body)
    decisions = _decisions(depth_m, body.times_s)
    if not decisions:
        return body, ()
    inside, best = depth_m.max(axis=1) > 0, tuple[_Clearance, ...]()
    for swell_s in _SWELLS_S:
        tried = tuple(_clearances(skeleton, body, inside, _frames(body.times_s, swell_s)))
        best = tried if not best or _left_m(tried) < _left_m(best) else best
        if _left_m(best) <= _TOLERATED_M:
            break
    for each in best:
        body.rotations[each.there] = each.rotations  # a copy already, and stretches do not overlap
    unsolved = (_unsolved(body.times_s[each.there], each.left_m) for each in best if each.left_m > _TOLERATED_M)
    return body, (*decisions, *unsolved)


@dataclass(frozen=True, slots=True, eq=False)
class _Clearance:
    """A stretch of frames, its local rotations with the arms displaced, and what is left of the penetration."""

    there: slice
    rotations: FloatArray
    left_m: float


def _left_m(clearances: Sequence[_Clearance]) -> float:
    return max(each.left_m for each in clearances)


def _clearances(skeleton: Skeleton, body: BodyMotion, inside: NDArray[np.bool_], swell: int) -> Iterator[_Clearance]:
    """The stretches around the frames with a limb `inside` something; displacements are blended over `swell` frames."""
    most_rad = _FASTEST_RAD_S * _SWELLS_S[0] / _frames(body.times_s, _SWELLS_S[0])
    for first, past in _stretches(_around(inside, 2 * swell)):
        there, ends = slice(first, past), (first > 0, past < len(inside))
        posed = PosedBody.of(skeleton, body.rotations[there], body.hips_m[there])
        taper = _taper(past - first, swell, ends)
        yield _Clearance(there, *_cleared(skeleton, posed, swell, taper, most_rad))


def depths_where_near_m(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    """The depths (T, P) in all frames in which a limb may be inside something; the others', -1, are not looked at.

    One frame every `_LOOK_S` is, and if one has a limb within `_NEAR_M` of something, the frames around it: how far
    limbs accelerate towards something from one of these frames to the next is less.
    """
    frames, stride = len(body.rotations), _frames(body.times_s, _LOOK_S)
    looked_at = np.zeros(frames, dtype=bool)
    looked_at[::stride] = looked_at[-1] = True
    found = np.full((frames, len(PAIRS)), -1.0)
    first = np.flatnonzero(looked_at)
    found[first] = depths_m(skeleton, body.rotations, body.hips_m, first)
    near = np.flatnonzero(_around(found.max(axis=1) > -_NEAR_M, stride) & ~looked_at)
    if len(near):
        found[near] = depths_m(skeleton, body.rotations, body.hips_m, near)
    return found


def _taper(frames: int, swell: int, ends: tuple[bool, bool]) -> FloatArray:
    """Weights (F, 1) that rise from 0 at the ends of the stretch, beyond which nothing is moved, to 1 after `swell`
    frames."""
    number = np.arange(frames)
    from_start = number if ends[0] else np.full(frames, swell)
    from_end = number[::-1] if ends[1] else np.full(frames, swell)
    return minimum_jerk(np.minimum(from_start, from_end) / swell)[:, None]


def _cleared(
    skeleton: Skeleton, start: PosedBody, swell: int, taper: FloatArray, most_rad: float
) -> tuple[FloatArray, float]:
    """The local rotations of a stretch of frames after the round with the least penetration, and its depth in metres;
    displacements are blended over `swell` frames, and no joint turns by more than `most_rad` from frame to frame unless
    it did before."""
    found = contacts(skeleton, start)
    nothing = np.zeros((len(start.rotations), 3))
    pushes = dict.fromkeys(SIDES, _Push(nothing, nothing))
    way_out = np.zeros_like(found.out)
    arms = skeleton.chain(*(side + name for side in SIDES for name in ("UpperArm", "LowerArm", "Hand")))
    least_m, rotations = float(found.depth_m.max()), start.rotations
    for _round in range(_ROUNDS):
        way_out = _way_out(found, way_out)
        one_way = _one_way(found, way_out, radii_m(skeleton))
        pushes = {side: push.and_then(_push(one_way, side)) for side, push in pushes.items()}
        swelling = {side: push.swelling(swell, taper) for side, push in pushes.items()}
        body = start.with_arms(skeleton, _moved(skeleton, start, swelling))
        found = contacts(skeleton, body)
        turned, before = (each.rotations.take(arms, axis=1) for each in (body, start))
        if found.depth_m.max() < least_m and not _jumps(turned, before, most_rad):
            least_m, rotations = float(found.depth_m.max()), body.rotations
        if found.depth_m.max() <= 0:
            break
    return rotations, least_m


def _jumps(rotations: FloatArray, before: FloatArray, most_rad: float) -> bool:
    """Whether a joint of (F, J, 4) turns by more than the most from frame to frame, and by more than it did before."""
    turned, did = (angle_between(each[1:], each[:-1]).max(initial=0.0) for each in (rotations, before))
    return bool(turned > max(most_rad, did))


def _way_out(found: Contacts, known: FloatArray) -> FloatArray:
    """The direction (T, P, 3) in which each contact is left.

    It is the same for a whole stretch of frames and for all parts of trunk and legs, that of the deepest frame, and the
    same in every round. Otherwise a limb that passes through the body would be pushed back and, from the middle on,
    forward, and one between belly and leg to and fro.
    """
    way_out = known.copy()
    deep_m = np.maximum(found.depth_m, 0.0)
    for columns in _TOGETHER:
        for first, past in _stretches(deep_m[:, columns].max(axis=1) > 0):
            there = slice(first, past), columns
            before = known[there].sum(axis=(0, 1))
            main = before if before.any() else np.einsum("tp,tpk->k", deep_m[there], found.out[there])
            way_out[there] = main
    return way_out


def _one_way(found: Contacts, way_out: FloatArray, touching_m: FloatArray) -> Contacts:
    """The contacts, with those that are nearer to the opposite side redirected through to this one; `touching_m` (P,)
    is the distance at which each begins."""
    wrong = (found.depth_m > 0) & (np.einsum("...k,...k->...", found.out, way_out) < 0)
    through_m = found.depth_m + 2 * (touching_m - found.depth_m)
    return replace(
        found, depth_m=np.where(wrong, through_m, found.depth_m), out=np.where(wrong[..., None], -found.out, found.out)
    )


def _moved(skeleton: Skeleton, body: PosedBody, pushes: Mapping[str, _Push]) -> FloatArray:
    """The local rotations with both arms displaced, in the frames concerned."""
    rotations = body.rotations.copy()
    for side, push in pushes.items():
        frames = np.nonzero((length(push.wrist_m) + length(push.elbow_m))[:, 0] > 1e-6)[0]
        if len(frames):
            pushed = _Push(push.wrist_m[frames], push.elbow_m[frames])
            joints = skeleton.rows(*(side + name for name in ("UpperArm", "LowerArm", "Hand")))
            rotations[frames, joints] = _solved_again(skeleton, body.frames(frames), Hand(side), pushed)
    return rotations


def _push(found: Contacts, side: str) -> _Push:
    """The sum of the displacements that the contacts of an arm require, each reduced by what the others already
    achieve.

    A hand is moved by its wrist; a forearm by wrist and elbow, in proportion to where the contact lies between them.
    Where both arms are in a contact, each moves by half.
    """
    wrist_m, elbow_m = np.zeros((2, len(found.depth_m), 3))
    deep_m = np.where(found.depth_m > 0, found.depth_m + _CLEARANCE_M, 0.0)
    for column in np.nonzero(deep_m.any(axis=0))[0]:
        ends = (BUILD[PAIRS[column][0]], found.on_limb, 1.0), (BUILD[PAIRS[column][1]], found.on_other, -1.0)
        both = all(capsule.part in LIMBS for capsule, _place, _sign in ends)
        for capsule, place, sign in ends:
            if capsule.part in LIMBS and capsule.joint.startswith(side):
                out = found.out[:, column] * (sign * deep_m[:, column] * (0.5 if both else 1.0))[:, None]
                share = place[:, column, None] if capsule.part == "forearm" else np.ones((len(out), 1))
                even = share**2 + (1 - share) ** 2
                wrist_m += _beyond(out * share / even, wrist_m)
                elbow_m += _beyond(out * (1 - share) / even, elbow_m)
    return _Push(wrist_m, elbow_m)


def _beyond(asked_m: FloatArray, given_m: FloatArray) -> FloatArray:
    """The part of `asked_m` that `given_m` does not already cover in its direction."""
    size_m = np.maximum(length(asked_m), 1e-12)
    done = np.sum(asked_m * given_m, axis=-1, keepdims=True) / size_m**2
    return np.asarray(asked_m * np.clip(1 - done, 0.0, 1.0))


def _at_most(push_m: FloatArray, farthest_m: float) -> FloatArray:
    return np.asarray(push_m * np.minimum(1.0, farthest_m / np.maximum(length(push_m), 1e-12)))


def _swelling(push_m: FloatArray, swell: int) -> FloatArray:
    """A displacement (T, 3) spread smoothly over neighbouring frames, hardly smaller than required.

    The maximum size within the window, averaged over the window, covers every frame's own; directions are averaged over
    twice the window, and where they disagree the displacement shrinks.
    """
    size_m = length(push_m)[:, 0]
    if not size_m.any():
        return push_m
    padded = np.pad(size_m, swell, mode="constant")
    largest = np.lib.stride_tricks.sliding_window_view(padded, 2 * swell + 1).max(axis=1)
    bell = np.hanning(2 * swell + 3)[1:-1]
    size_m = np.convolve(np.pad(largest, swell, mode="edge"), bell / bell.sum(), mode="valid")
    wide = np.hanning(4 * swell + 3)[1:-1]
    middle = slice(2 * swell, 2 * swell + len(push_m))
    towards = np.stack([np.convolve(part, wide)[middle] for part in push_m.T], axis=-1)
    agreed = np.convolve(length(push_m)[:, 0], wide)[middle]
    return np.asarray(towards / np.maximum(agreed, 1e-12)[:, None] * size_m[:, None])


def _solved_again(skeleton: Skeleton, body: PosedBody, side: Hand, push: _Push) -> FloatArray:
    """Upper arm, lower arm and hand (T, 3, 4) of the arm `side`, solved for the displaced wrist and elbow."""
    names = ("Shoulder", "UpperArm", "LowerArm", "Hand")
    chest, *joints = skeleton.chain("upperChest", *(side.value + name for name in names))
    bones = ArmBones.of(skeleton)
    at_m, turned = body.positions_m, body.orientations
    back = inverse(turned[:, chest])
    mirror, across = (np.ones(4), np.ones(3)) if side is Hand.LEFT else (MIRROR, _MIRRORED)
    root_m = bones.root_m - skeleton.offsets_m[skeleton.index["leftShoulder"]]
    wrist_m, elbow_push_m = (
        rotate(back, vector) * across for vector in (at_m[:, joints[-1]] + push.wrist_m - at_m[:, chest], push.elbow_m)
    )
    before = body.rotations.take(joints, axis=1)
    collarbone, upper_arm, lower_arm = (before[:, joint] * mirror for joint in range(3))
    elbow = towards_elbow(multiply(collarbone, upper_arm), _without_twist(lower_arm), bones)
    elbow = elbow + (elbow_push_m - dot(elbow_push_m, elbow) * elbow) / _ELBOW_AT_LEAST_M
    arm = reach_by_elbow(bones, collarbone, wrist_m + root_m, elbow)
    turn = preserving_wrist_angles(arm.forearm, multiply(back, turned[:, joints[-1]]) * mirror).clamped()
    after = np.stack((arm.upper_arm, multiply(arm.elbow, turn.forearm), turn.hand), axis=1)
    return nearest_sign(after * mirror, before[:, 1:])


def _without_twist(lower_arm: FloatArray) -> FloatArray:
    return multiply(lower_arm, from_axis_angle((-1.0, 0.0, 0.0), np.radians(swing_twist_deg(lower_arm, 0)[..., 0])))


def _frames(times_s: FloatArray, time_s: float) -> int:
    """The number of frames in a time, at least one."""
    rate_hz = (len(times_s) - 1) / max(times_s[-1] - times_s[0], 1e-9)
    return max(1, round(time_s * float(rate_hz)))


def _around(inside: NDArray[np.bool_], frames: int) -> NDArray[np.bool_]:
    """Frames within `frames` of one that is inside."""
    return np.convolve(inside, np.ones(2 * frames + 1), mode="full")[frames : frames + len(inside)] > 0


def _stretches(inside: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The first frame and the frame past the last of each run of true values: (n, 2)."""
    padded = np.concatenate([[False], inside, [False]])
    return np.nonzero(padded[1:] != padded[:-1])[0].reshape(-1, 2)


def _decisions(depths: FloatArray, times_s: FloatArray) -> tuple[Decision, ...]:
    """One decision for each stretch of frames in which a limb penetrated something."""
    decisions = []
    if depths.max() <= 0:
        return ()
    for side in SIDES:
        own = [column for column, (limb, _other) in enumerate(PAIRS) if BUILD[limb].joint.startswith(side)]
        depth_m = depths[:, own]
        for first, past in _stretches(depth_m.max(axis=1) > 0):
            column = int(np.argmax(depth_m[first:past].max(axis=0)))
            limb, other = (BUILD[number].part for number in PAIRS[own[column]])
            deepest_cm = 100 * depth_m[first:past].max()
            when = f"from {times_s[first]:.2f} s to {times_s[past - 1]:.2f} s"
            reason = f"the {side} {limb} would have been {deepest_cm:.1f} cm inside the {other} {when}"
            decisions.append(Decision("", "moved", reason))
    return tuple(decisions)


def _unsolved(times_s: FloatArray, left_m: float) -> Decision:
    when = f"between {times_s[0]:.2f} s and {times_s[-1]:.2f} s"
    return Decision("", "kept", f"a hand or forearm stays {100 * left_m:.1f} cm inside something {when}")
