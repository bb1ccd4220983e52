/** The outline of a body behind the grid of sectors. Its heights are those of the sectors: shoulders, belly, hips. */

const SVG = "http://www.w3.org/2000/svg";

/** A figure from the thighs up in a square of 100 by 100. */
export function body() {
  const picture = document.createElementNS(SVG, "svg");
  for (const [name, value] of Object.entries({ viewBox: "0 0 100 100", preserveAspectRatio: "none", "aria-hidden": "true", class: "outline" })) {
    picture.setAttribute(name, value);
  }
  for (const path of [HEAD, TRUNK]) {
    const drawn = document.createElementNS(SVG, "path");
    drawn.setAttribute("d", path);
    picture.append(drawn);
  }
  return picture;
}

const HEAD = "M 43 9 a 7 9 0 1 0 14 0 a 7 9 0 1 0 -14 0";
const TRUNK = "M 47 19 L 53 19 L 54 26 L 68 32 L 71 70 L 67 71 L 63 45 L 62 72 L 66 100 L 34 100 L 38 72 L 37 45 L 33 71 L 29 70 L 32 32 L 46 26 Z";
