// Where a plane across an axis cuts a mesh: the outline that is drawn in the section.
import {BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments} from 'three';

/** Ends of the lines, x y z after each other. axis: 0, 1 or 2; level: mm. */
export function cutLines({positions, corners}, axis, level) {
  const ends = [];
  const height = (v) => positions[3 * v + axis] - level;
  const cross = (v, w) => {
    const share = height(v) / (height(v) - height(w));
    for (let k = 0; k < 3; ++k) ends.push(positions[3 * v + k] + share * (positions[3 * w + k] - positions[3 * v + k]));
  };
  for (let i = 0; i < corners.length; i += 3) {
    const t = [corners[i], corners[i + 1], corners[i + 2]];
    const above = t.map((v) => height(v) > 0);
    if (above[0] === above[1] && above[1] === above[2]) continue;
    // The corner that is alone on its side of the plane: both edges of it are crossed.
    const alone = above[0] === above[1] ? 2 : above[0] === above[2] ? 1 : 0;
    cross(t[alone], t[(alone + 1) % 3]);
    cross(t[alone], t[(alone + 2) % 3]);
  }
  return new Float32Array(ends);
}

/** An outline that can be moved. */
export class Outline {
  constructor(mesh, colour) {
    this.mesh = mesh;
    this.lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({color: colour, depthTest: false}));
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 2;
    this.lines.visible = false;
  }
  moveTo(axis, level) {
    this.lines.geometry.dispose();
    this.lines.geometry = new BufferGeometry();
    this.lines.geometry.setAttribute('position', new BufferAttribute(cutLines(this.mesh, axis, level), 3));
  }
}
