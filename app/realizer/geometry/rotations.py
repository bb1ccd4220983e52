"""Vectorized operations on rotations as unit quaternions x y z w, in arrays of shape (…, 4), and rotations as pitch,
yaw and roll.

Conventions: the last axis holds the quaternion (or the vector, x y z); angles are radians; `multiply(a, b)` applies b
first, then a, as with matrices. Positive `pitch` looks down (about x), `yaw` to the character's left (about y), `roll`
tilts to the character's right (about z); roll is applied first, yaw last. A direction is a vector; (0, 0, 1) is
straight ahead.
"""

from math import atan2, copysign, dist, hypot, sin
from operator import add, mul

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray

IDENTITY: FloatArray = np.array([0.0, 0.0, 0.0, 1.0])
IDENTITY.setflags(write=False)

_NEAR_ZERO = 1e-12
_FEW = 1200
_FIRST, _SECOND = np.triu_indices(4)
"""The parts of a quaternion that are multiplied in a rotation: each with itself and with those after it."""
_COMPLEX, _REAL = np.dtype(np.complex128), np.dtype(np.float64)
_I, _MINUS_I = np.array(1j), np.array(-1j)
"""As arrays, since NumPy takes longer with Python's numbers."""


def _weights() -> FloatArray:
    """The weights (3, 30) of a vector's parts in those of its image: of x, y and z in turn, the ten of `_FIRST` and
    `_SECOND`, x x, x y, x z, x w, y y, y z, y w, z z, z w, w w."""
    matrix = (
        ((1, 0, 0, 0, -1, 0, 0, -1, 0, 1), (0, 2, 0, 0, 0, 0, 0, 0, -2, 0), (0, 0, 2, 0, 0, 0, 2, 0, 0, 0)),
        ((0, 2, 0, 0, 0, 0, 0, 0, 2, 0), (-1, 0, 0, 0, 1, 0, 0, -1, 0, 1), (0, 0, 0, -2, 0, 2, 0, 0, 0, 0)),
        ((0, 0, 2, 0, 0, 0, -2, 0, 0, 0), (0, 0, 0, 2, 0, 2, 0, 0, 0, 0), (-1, 0, 0, 0, -1, 0, 0, 1, 0, 1)),
    )
    return np.array(matrix, dtype=np.float64).transpose(1, 0, 2).reshape(3, -1)


_WEIGHTS = _weights()


def multiply(a: FloatArray, b: FloatArray) -> FloatArray:
    """The rotation by `b`, then by `a`.

    As pairs of complex numbers x + iy, z + iw (Cayley and Dickson), which takes a third of the calls of NumPy, and
    calls are what the quaternions of a line cost.
    """
    pairs, other = _as_pairs(a), _as_pairs(b)
    first, second, xy, zw = pairs[..., 0] * _I, pairs[..., 1] * _MINUS_I, other[..., 0], other[..., 1]
    last, crossed = second * zw, first * zw
    product = np.empty((*last.shape, 2), _COMPLEX)
    np.add(last, np.conjugate(first) * xy, product[..., 1])
    np.subtract(np.conjugate(second) * xy, crossed, product[..., 0])
    return product.view(_REAL)


def multiply_parts(a: FloatArray, b: FloatArray) -> FloatArray:
    """`multiply` of rotations whose parts are four arrays (4, …) of the same shape, one after the other in memory: for
    thousands of rotations at once several times as fast."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    product = np.empty(b.shape)
    product[0] = aw * bx + ax * bw + ay * bz - az * by
    product[1] = aw * by - ax * bz + ay * bw + az * bx
    product[2] = aw * bz + ax * by - ay * bx + az * bw
    product[3] = aw * bw - ax * bx - ay * by - az * bz
    return product


def turn_about_z(q: FloatArray, angle: FloatArray) -> None:
    """Turn `q` (…, 4) by the angles (…) about their own z axes, in place: as `multiply` by such rotations, but with one
    product of complex numbers. Raises ValueError for quaternions whose parts are not side by side in memory."""
    pairs, half = q.view(_COMPLEX), 0.5 * angle
    turned = np.empty(half.shape, dtype=np.complex128)
    sine, turned.real = sine_and_cosine(half)
    np.negative(sine, out=turned.imag)
    pairs[..., 0] *= turned  # one after the other, since NumPy takes four times as long with both at a time
    pairs[..., 1] *= turned


def _as_pairs(q: FloatArray) -> NDArray[np.complex128]:
    """The quaternions (…, 4) as complex numbers (…, 2), without a copy where that can be."""
    try:
        return q.view(_COMPLEX)
    except ValueError:
        return np.ascontiguousarray(q).view(_COMPLEX)


def inverse(q: FloatArray) -> FloatArray:
    """The inverse rotation."""
    turned_back = np.negative(q)
    turned_back[..., 3] = q[..., 3]
    return turned_back


def rotate(q: FloatArray, vector: FloatArray) -> FloatArray:
    """`vector` (…, 3) rotated by `q`: with pairs of complex numbers as in `multiply`, q v, then times the inverse."""
    pairs = _as_pairs(q)
    xy, wz = pairs[..., 0], np.conjugate(pairs[..., 1])
    across, z = (np.zeros(vector.shape[:-1], _COMPLEX) for _each in range(2))
    across.real, across.imag, z.real = vector[..., 0], vector[..., 1], vector[..., 2]
    first, second = xy * np.conjugate(across) + wz * z, xy * z - wz * across
    flat = xy * first + wz * second
    rotated = np.empty((*flat.shape, 3))
    rotated[..., 0], rotated[..., 1] = flat.real, flat.imag
    rotated[..., 2] = (wz * np.conjugate(first)).real - (xy * np.conjugate(second)).real
    return rotated


def images(q: FloatArray, vector: FloatArray) -> FloatArray:
    """A vector (…, 1, 3) rotated by each of `q` (…, N, 4), one part after the other (…, 3, N): each is a sum of the
    products of any two parts of the quaternion, with weights that are the same for all."""
    parts, weights = np.ascontiguousarray(q.swapaxes(-1, -2)), vector @ _WEIGHTS
    products = parts.take(_FIRST, axis=-2)
    products *= parts.take(_SECOND, axis=-2)
    return np.asarray(weights.reshape(*vector.shape[:-2], 3, len(_FIRST)) @ products)


def x_axis(q: FloatArray) -> FloatArray:
    """Where `q` (…, 4) takes the x axis (…, 3)."""
    x, y, z, w = q[..., 0], q[..., 1], q[..., 2], q[..., 3]
    towards = np.empty((*x.shape, 3))
    towards[..., 0] = 1.0 - 2.0 * (y * y + z * z)
    towards[..., 1] = 2.0 * (x * y + w * z)
    towards[..., 2] = 2.0 * (x * z - w * y)
    return towards


def cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """The cross products (…, 3): several times as fast as `np.cross`."""
    ax, ay, az = a[..., 0], a[..., 1], a[..., 2]
    bx, by, bz = b[..., 0], b[..., 1], b[..., 2]
    x = ay * bz - az * by
    product = np.empty((*x.shape, 3))
    product[..., 0] = x
    product[..., 1] = az * bx - ax * bz
    product[..., 2] = ax * by - ay * bx
    return product


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """The dot products over the last axis, which is kept with length 1; for few vectors twice as fast as by
    `np.einsum`, which is faster for many."""
    if max(a.size, b.size) < _FEW:
        return np.asarray(np.vecdot(a, b)[..., None])
    return np.asarray(np.einsum("...k,...k->...", a, b)[..., None])


def length(vector: FloatArray) -> FloatArray:
    """The norms over the last axis, which is kept with length 1: several times as fast as `np.linalg.norm`."""
    return np.asarray(np.sqrt(dot(vector, vector)))


def from_rotation_vector(vector: FloatArray) -> FloatArray:
    """The rotation about the axis `vector` (…, 3) by its length in radians."""
    angle = np.maximum(length(vector)[..., 0], _NEAR_ZERO)
    turned = np.empty((*angle.shape, 4))
    sine, turned[..., 3] = sine_and_cosine(0.5 * angle)
    sine /= angle
    for part in range(3):
        np.multiply(vector[..., part], sine, out=turned[..., part])
    return turned


def to_rotation_vector(q: FloatArray) -> FloatArray:
    """Axis times angle (…, 3) of the shorter rotation, at most π long."""
    q = np.where(q[..., 3:] < 0, -q, q)
    sine = np.maximum(length(q[..., :3]), _NEAR_ZERO)
    return np.asarray(q[..., :3] * (2 * np.arctan2(sine, q[..., 3:]) / sine))


def from_axis_angle(axis: tuple[float, float, float], angle: FloatArray) -> FloatArray:
    """The rotations by the angles (…) about one unit axis."""
    sine, cosine = sine_and_cosine(np.asarray(angle) / 2)
    turned = np.zeros((*sine.shape, 4))
    for part, size in enumerate(axis):
        if size:
            turned[..., part] = size * sine
    turned[..., 3] = cosine
    return turned


def shortest_rotation(a: FloatArray, b: FloatArray) -> FloatArray:
    """The shortest rotation that takes the direction `a` (…, 3) to the direction `b`."""
    a, b = a / length(a), b / length(b)
    w = 1 + dot(a, b)
    sideways = np.where(np.abs(a[..., :1]) < 0.9, np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]))
    axis = np.where(w > 1e-9, cross(a, b), cross(a, sideways))
    return normalized(np.concatenate([axis, np.where(w > 1e-9, w, 0.0)], axis=-1))


def from_axes(x: FloatArray, y: FloatArray, z: FloatArray) -> FloatArray:
    """The rotation that maps the base axes to `x`, `y` and `z` (…, 3), which are orthonormal and right-handed."""
    by_w = np.empty((*x.shape[:-1], 4))
    by_w[..., 0], by_w[..., 1], by_w[..., 2] = y[..., 2] - z[..., 1], z[..., 0] - x[..., 2], x[..., 1] - y[..., 0]
    by_w[..., 3] = 1 + x[..., 0] + y[..., 1] + z[..., 2]
    if by_w[..., 3].min(initial=1.0) > 0.1:
        return normalized(by_w)
    return normalized(_largest_first(x, y, z, by_w))


def _largest_first(x: FloatArray, y: FloatArray, z: FloatArray, by_w: FloatArray) -> FloatArray:
    """The quaternion computed from its largest component, for numerical accuracy."""
    yz, zx, xy, w = (by_w[..., part] for part in range(4))
    weights = [
        1 + x[..., 0] - y[..., 1] - z[..., 2],
        1 - x[..., 0] + y[..., 1] - z[..., 2],
        1 - x[..., 0] - y[..., 1] + z[..., 2],
    ]
    sxy, sxz, syz = y[..., 0] + x[..., 1], z[..., 0] + x[..., 2], z[..., 1] + y[..., 2]
    choices = ((yz, zx, xy, w), (weights[0], sxy, sxz, yz), (sxy, weights[1], syz, zx), (sxz, syz, weights[2], xy))
    candidates = np.stack([np.stack(choice, axis=-1) for choice in choices])
    best = np.argmax(np.stack([w, *weights]), axis=0)[None, ..., None]
    return np.asarray(np.take_along_axis(candidates, best, axis=0)[0])


def normalized(q: FloatArray) -> FloatArray:
    """The quaternions scaled to unit length."""
    return np.asarray(q / length(q))


def normalize(q: FloatArray) -> None:
    """`normalized` in place: one part after the other, since NumPy is slow with four at a time."""
    size = length(q)[..., 0]
    for part in range(4):
        q[..., part] /= size


def with_continuous_signs(q: FloatArray) -> FloatArray:
    """The same rotations (T, …, 4), with signs such that each quaternion is near to the previous one in time."""
    turned = dot(q[1:], q[:-1]) < 0
    if not turned.any():
        return q
    return np.concatenate([q[:1], q[1:] * np.cumprod(np.where(turned, -1.0, 1.0), axis=0)])


def keep_signs(q: FloatArray) -> None:
    """`with_continuous_signs` in place."""
    turned = dot(q[1:], q[:-1]) < 0
    if turned.any():
        q[1:] *= np.cumprod(np.where(turned, -1.0, 1.0), axis=0)


def nearest_sign(q: FloatArray, to: FloatArray) -> FloatArray:
    """The same rotations `q` (…, 4), with the sign nearer to `to` (…, 4)."""
    return np.asarray(np.where(dot(q, to) < 0, -q, q))


def slerp(a: FloatArray, b: FloatArray, share: FloatArray) -> FloatArray:
    """Spherical linear interpolation: the rotation at `share` (…), in [0, 1], of the shorter way from `a` to `b`."""
    cosine, share = dot(a, b), np.asarray(share)[..., None]
    angle = np.arccos(np.minimum(np.abs(cosine), 1.0))
    sine = np.sin(angle)
    far, sine = sine > _NEAR_ZERO, np.maximum(sine, _NEAR_ZERO)
    of_a = np.where(far, np.sin((1.0 - share) * angle) / sine, 1.0 - share)
    of_b = np.where(far, np.sin(share * angle) / sine, share)
    return np.asarray(of_a * a + np.copysign(of_b, cosine) * b)


def angle_between(a: FloatArray, b: FloatArray) -> FloatArray:
    """The angle from `a` to `b` in radians, in [0, π]."""
    return np.asarray(length(to_rotation_vector(multiply(inverse(a), b)))[..., 0])


def from_pitch_yaw_roll(pitch: FloatArray, yaw: FloatArray, roll: FloatArray) -> FloatArray:
    """The rotations (…, 4) by `roll`, then `pitch`, then `yaw`."""
    (sx, sy, sz), (cx, cy, cz) = sine_and_cosine(0.5 * np.array((pitch, yaw, roll)))
    both, pitched, rolled, neither = sx * sz, sx * cz, cx * sz, cx * cz
    turned = np.empty((*both.shape, 4))
    turned[..., 0] = cy * pitched + sy * rolled
    turned[..., 1] = sy * neither - cy * both
    turned[..., 2] = cy * rolled - sy * pitched
    turned[..., 3] = cy * neither + sy * both
    return turned


def from_pitch_yaw(pitch: FloatArray, yaw: FloatArray) -> FloatArray:
    """The rotations (…, 4) by `pitch`, then `yaw`."""
    (sx, cx), (sy, cy) = (sine_and_cosine(angle / 2) for angle in (pitch, yaw))
    turned = np.empty((*sx.shape, 4))
    turned[..., 0], turned[..., 1], turned[..., 2], turned[..., 3] = cy * sx, sy * cx, -sy * sx, cy * cx
    return turned


def to_pitch_yaw_roll(q: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Pitch, yaw and roll of the rotations (…, 4); pitch lies in [-π/2, π/2]."""
    x, y, z, w = (q[..., k] for k in range(4))
    pitch = np.arcsin(np.clip(2 * (w * x - y * z), -1.0, 1.0))
    yaw = np.arctan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y))
    roll = np.arctan2(2 * (w * z + x * y), 1 - 2 * (x * x + z * z))
    return pitch, yaw, roll


def pitch_and_yaw(direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Pitch and yaw of the directions (…, 3), of any length."""
    x, y, z = (direction[..., k] for k in range(3))
    return np.arctan2(-y, np.sqrt(x * x + z * z)), np.arctan2(x, z)


def unit_vector(pitch: FloatArray, yaw: FloatArray) -> FloatArray:
    """The unit vectors (…, 3) with this pitch and yaw."""
    (up, level), (aside, ahead) = sine_and_cosine(pitch), sine_and_cosine(yaw)
    vector = np.empty((*up.shape, 3))
    vector[..., 0], vector[..., 1], vector[..., 2] = level * aside, -up, level * ahead
    return vector


def sine_and_cosine(angle: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The sines and the cosines of the angles (…) in radians."""
    tangent = np.tan(0.5 * np.asarray(angle))
    whole = tangent * tangent
    whole += 1.0
    whole = 2.0 / whole
    tangent *= whole
    whole -= 1.0
    return np.asarray(tangent), np.asarray(whole)


def within_speed(rotations: FloatArray, frame_s: float, fastest_rad_s: float | FloatArray) -> FloatArray:
    """The same rotations (T, 4) where none is farther from the one before than the speed allows, one for all or one
    (T - 1,) a step; where one is, those that follow go after it at that speed until they have caught up."""
    most = np.broadcast_to(np.asarray(fastest_rad_s) * frame_s, len(rotations) - 1)
    cosines = np.abs(np.einsum("tk,tk->t", rotations[1:], rotations[:-1]))
    too_far = np.flatnonzero(cosines < np.cos(most / 2)) + 1
    if not len(too_far):
        return rotations
    kept = rotations.copy()
    frame = int(too_far[0])
    while frame < len(kept):
        reached = _at_most_as_far(kept[frame - 1].tolist(), kept[frame].tolist(), float(most[frame - 1]))
        if reached is not None:
            kept[frame] = reached
            frame += 1
        else:
            later = too_far[too_far > frame]
            frame = int(later[0]) if len(later) else len(kept)
    return kept


def _at_most_as_far(start: list[float], end: list[float], angle: float) -> list[float] | None:
    """The rotation that is `angle` away from `start` on the shorter way to `end`, with the sign of `end`; None where
    that is no farther. One rotation at a time, for which NumPy takes ten times as long."""
    sign = copysign(1.0, sum(map(mul, start, end)))
    near = [sign * part for part in start]
    half = 2 * atan2(dist(near, end), hypot(*map(add, near, end)))
    if 2 * half <= angle:
        return None
    of_start, of_end = sin(half - angle / 2) / sin(half), sin(angle / 2) / sin(half)
    return [of_start * one + of_end * other for one, other in zip(near, end, strict=True)]


def at_times(rotations: FloatArray, times_s: FloatArray, at_s: FloatArray) -> FloatArray:
    """The rotations (T, …, 4) of frames at `times_s` as they are at other times (T,), between frames along the
    chord."""
    place = np.interp(at_s, times_s, np.arange(len(times_s)))
    before = np.minimum(place.astype(int), len(times_s) - 2)
    share = (place - before).reshape(-1, *(1,) * (rotations.ndim - 1))
    one = rotations[before]
    return normalized(one + share * (nearest_sign(rotations[before + 1], one) - one))
