// The body as sticks: joints in space from a frame's local rotations (x y z w), and lines between them.
const PARENTS = {
  spine: "hips", chest: "spine", upperChest: "chest", neck: "upperChest", head: "neck",
  leftShoulder: "upperChest", leftUpperArm: "leftShoulder", leftLowerArm: "leftUpperArm", leftHand: "leftLowerArm",
  leftMiddleProximal: "leftHand", leftUpperLeg: "hips", leftLowerLeg: "leftUpperLeg", leftFoot: "leftLowerLeg",
};
const OFFSETS_M = {
  spine: [0, .08, 0], chest: [0, .12, 0], upperChest: [0, .12, 0], neck: [0, .13, 0], head: [0, .1, 0],
  leftShoulder: [.03, .1, 0], leftUpperArm: [.13, 0, 0], leftLowerArm: [.28, 0, 0], leftHand: [.25, 0, 0],
  leftMiddleProximal: [.09, 0, 0], leftUpperLeg: [.09, -.05, 0], leftLowerLeg: [0, -.42, 0], leftFoot: [0, -.42, 0],
};
for (const joint of Object.keys(PARENTS).filter((name) => name.startsWith("left"))) {
  const right = joint.replace("left", "right");
  PARENTS[right] = PARENTS[joint].replace("left", "right");
  OFFSETS_M[right] = [-OFFSETS_M[joint][0], OFFSETS_M[joint][1], OFFSETS_M[joint][2]];
}

function multiply([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

function rotate(q, [x, y, z]) {
  const [qx, qy, qz, qw] = q;
  const [tx, ty, tz] = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)];
  return [
    x + qw * tx + qy * tz - qz * ty,
    y + qw * ty + qz * tx - qx * tz,
    z + qw * tz + qx * ty - qy * tx,
  ];
}

/** Where each joint is, metres, by its name. */
export function placed(joints, frame) {
  const local = (name) => {
    const at = 4 * joints.indexOf(name);
    return frame.rotations.slice(at, at + 4);
  };
  const found = { hips: { at: frame.hips_m, turned: local("hips") } };
  for (const [name, parent] of Object.entries(PARENTS)) {
    const { at, turned } = found[parent];
    const offset = rotate(turned, OFFSETS_M[name]);
    found[name] = { at: at.map((part, k) => part + offset[k]), turned: multiply(turned, local(name)) };
  }
  return found;
}

/** Draws the frame as seen from the front: its left is on our right. */
export function draw(canvas, joints, frame, jawOpen) {
  const context = canvas.getContext("2d");
  const pixels = canvas.height / 2;
  const shown = ([x, y]) => [canvas.width / 2 + x * pixels, canvas.height - 20 - y * pixels];
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.lineWidth = 7;
  context.lineCap = "round";
  context.strokeStyle = "#2a5d84";
  const bones = placed(joints, frame);
  context.beginPath();
  for (const [name, parent] of Object.entries(PARENTS)) {
    context.moveTo(...shown(bones[parent].at));
    context.lineTo(...shown(bones[name].at));
  }
  context.stroke();
  const face = rotate(bones.head.turned, [0, .1, .05]);
  const [x, y] = shown(bones.head.at.map((part, k) => part + face[k]));
  context.fillStyle = "#2a5d84";
  context.beginPath();
  context.arc(x, y, 0.11 * pixels, 0, 2 * Math.PI);
  context.fill();
  context.fillStyle = "#fff";
  context.beginPath();
  context.ellipse(x, y + 0.045 * pixels, 8, 1.5 + 30 * jawOpen, 0, 0, 2 * Math.PI);
  context.fill();
}
