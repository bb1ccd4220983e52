/** Vectors [x, y, z] and unit quaternions [x, y, z, w]; `multiply(a, b)` turns by b first. */

export type Vector = readonly [number, number, number];
export type Quaternion = readonly [number, number, number, number];

export const NO_TURN: Quaternion = [0, 0, 0, 1];

export function multiply(a: Quaternion, b: Quaternion): Quaternion {
  const [ax, ay, az, aw] = a;
  const [bx, by, bz, bw] = b;
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

export function inverse([x, y, z, w]: Quaternion): Quaternion {
  return [-x, -y, -z, w];
}

export function rotate(turn: Quaternion, [x, y, z]: Vector): Vector {
  const [rx, ry, rz] = multiply(multiply(turn, [x, y, z, 0]), inverse(turn));
  return [rx, ry, rz];
}

/** The smallest turn that takes the direction of `from` to that of `to`; none where either has no length. */
export function shortestTurn(from: Vector, to: Vector): Quaternion {
  const lengths = length(from) * length(to);
  if (lengths === 0) {
    return NO_TURN;
  }
  const cosine = dot(from, to) / lengths;
  if (cosine < -0.999999) {
    const across = Math.abs(from[0]) < Math.abs(from[1]) ? cross(from, [1, 0, 0]) : cross(from, [0, 1, 0]);
    return normalized([...across, 0]);
  }
  const [x, y, z] = cross(from, to);
  return normalized([x / lengths, y / lengths, z / lengths, 1 + cosine]);
}

/** `share` of the way from one turn to another along the shorter arc (slerp). */
export function between(a: Quaternion, b: Quaternion, share: number): Quaternion {
  const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const sine = Math.sin(angle);
  const first = sine < 1e-6 ? 1 - share : Math.sin((1 - share) * angle) / sine;
  const second = (sine < 1e-6 ? share : Math.sin(share * angle) / sine) * (cosine < 0 ? -1 : 1);
  return normalized([
    first * a[0] + second * b[0],
    first * a[1] + second * b[1],
    first * a[2] + second * b[2],
    first * a[3] + second * b[3],
  ]);
}

export function normalized([x, y, z, w]: Quaternion): Quaternion {
  const size = Math.hypot(x, y, z, w) || 1;
  return [x / size, y / size, z / size, w / size];
}

export function add(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scaled([x, y, z]: Vector, factor: number): Vector {
  return [x * factor, y * factor, z * factor];
}

export function length(vector: Vector): number {
  return Math.hypot(...vector);
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
