// Numbers on the findings: buttons over the picture, which lead to the row of the finding; and what the eye is turned
// to by a row.
import {Vector3} from 'three';

/** Directions that are tried where the finding's own is hidden by the part. */
const AROUND = [[0, 0, 1], [1, -1, 1], [-1, -1, 1], [1, 1, 1], [-1, 1, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0],
  [1, -1, 0], [-1, -1, 0], [1, 1, 0], [-1, 1, 0], [1, -1, -1], [-1, -1, -1], [1, 1, -1], [-1, 1, -1], [0, 0, -1]];

export class Markers {
  /** chosen(finding): called by a click on a number. */
  constructor(layer, findings, chosen) {
    this.items = findings.map((finding) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.className = `v3-marker ${finding.severity}`;
      button.textContent = finding.n;
      button.title = `${finding.n}: ${finding.kind}`;
      button.setAttribute('aria-label', `Finding ${finding.n}, ${finding.kind}: to its row`);
      button.addEventListener('click', () => chosen(finding));
      layer.append(button);
      return {finding, button, place: new Vector3(...finding.at)};
    });
    this.shown = true;
  }

  choose(n) {
    for (const {finding, button} of this.items) button.classList.toggle('chosen', finding.n === n);
  }

  /** Puts them where the camera sees their places. */
  place(camera, width, height) {
    for (const {button, place} of this.items) {
      const p = place.clone().project(camera);
      const seen = this.shown && Math.abs(p.x) < 1 && Math.abs(p.y) < 1;
      button.hidden = !seen;
      if (seen) button.style.transform = `translate(${(((p.x + 1) / 2) * width).toFixed(1)}px,${(((1 - p.y) / 2) * height).toFixed(1)}px)`;
    }
  }
}

/** Does a ray from the place meet the mesh farther off than `clear`? (Möller and Trumbore, 1997) */
function hidden({positions, corners}, place, direction, clear) {
  const edge1 = new Vector3(), edge2 = new Vector3(), a = new Vector3(), p = new Vector3(), q = new Vector3(), s = new Vector3();
  for (let i = 0; i < corners.length; i += 3) {
    a.fromArray(positions, 3 * corners[i]);
    edge1.fromArray(positions, 3 * corners[i + 1]).sub(a);
    edge2.fromArray(positions, 3 * corners[i + 2]).sub(a);
    p.crossVectors(direction, edge2);
    const det = edge1.dot(p);
    if (Math.abs(det) < 1e-12) continue;
    s.subVectors(place, a);
    const u = s.dot(p) / det;
    if (u < 0 || u > 1) continue;
    q.crossVectors(s, edge1);
    const v = direction.dot(q) / det;
    if (v >= 0 && u + v <= 1 && edge2.dot(q) / det > clear) return true;
  }
  return false;
}

/** Mean normal of the part near the place. */
function normalNear({positions, corners}, place, reach) {
  const sum = new Vector3(), a = new Vector3(), b = new Vector3(), c = new Vector3();
  for (let i = 0; i < corners.length; i += 3) {
    a.fromArray(positions, 3 * corners[i]);
    b.fromArray(positions, 3 * corners[i + 1]);
    c.fromArray(positions, 3 * corners[i + 2]);
    const near = Math.min(a.distanceTo(place), b.distanceTo(place), c.distanceTo(place));
    if (near < reach) sum.add(b.sub(a).cross(c.sub(a)).multiplyScalar(1 - near / reach));
  }
  return sum.length() > 0 ? sum.normalize() : new Vector3(0, 0, 1);
}

/** From where a finding is seen: along the surface's normal, a little from above, or where nothing is before it. */
export function directionTo(part, finding, radius) {
  const place = new Vector3(...finding.at);
  const normal = finding.normal ? new Vector3(...finding.normal) : normalNear(part, place, 0.06 * radius);
  const own = normal.clone().add(new Vector3(0.25, -0.35, 0.35)).normalize();
  const around = AROUND.map((d) => new Vector3(...d).normalize()).sort((a, b) => b.dot(normal) - a.dot(normal));
  const start = place.clone().addScaledVector(normal, 0.003 * radius);
  for (const direction of [own, normal, ...around]) {
    if (!hidden(part, start, direction, 0.004 * radius)) return direction;
  }
  return own;
}
