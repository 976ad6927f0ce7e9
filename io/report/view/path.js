// The tool path of a range of blocks, and the tool on it at a time.
import {BufferAttribute, BufferGeometry, Group, LineSegments, OctahedronGeometry, Mesh, MeshBasicMaterial, Quaternion,
  ShaderMaterial, Vector3} from 'three';
import {makeSurface} from './surface.js';

/** By kind of motion: rapid, feed, thread, probe. A point of kind START begins a line of its own. */
const TONES = [[0.85, 0.55, 0.1], [0.1, 0.5, 0.75], [0.5, 0.3, 0.75], [0.2, 0.6, 0.3]];
const START = 4;
const SIDES = 40;

const LINE_VERTEX = `
attribute vec3 tone;
varying vec3 vTone;
void main() {
  vTone = tone;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;
const LINE_FRAGMENT = `
varying vec3 vTone;
void main() { gl_FragColor = vec4(vTone, 1.0); }`;

/** A solid of revolution about z from its outline, points [r, z] from the tip upwards. */
function turned(outline) {
  const positions = [], corners = [];
  for (const [r, z] of outline) {
    for (let k = 0; k < SIDES; ++k) {
      const a = (2 * Math.PI * k) / SIDES;
      positions.push(r * Math.cos(a), r * Math.sin(a), z);
    }
  }
  for (let i = 0; i + 1 < outline.length; ++i) {
    for (let k = 0; k < SIDES; ++k) {
      const a = i * SIDES + k, b = i * SIDES + ((k + 1) % SIDES);
      if (outline[i][0] > 0) corners.push(a, b, b + SIDES);
      if (outline[i + 1][0] > 0) corners.push(a, b + SIDES, a + SIDES);
    }
  }
  return {positions: new Float32Array(positions), corners: new Uint32Array(corners), deviations: null};
}

function makeTool(tool, radius) {
  if (tool && tool.outline.length > 1)
    return makeSurface(turned(tool.outline), {tone: '#8d9aa6', cutTone: '#6d7a86', opacity: 0.55});
  const mark = new Mesh(new OctahedronGeometry(radius / 40), new MeshBasicMaterial({color: 0xd04a02}));
  mark.frustumCulled = false;
  return mark;
}

export class ToolPath {
  constructor(path, radius) {
    this.path = path;
    this.group = new Group();
    this.lines = new LineSegments(this.segments(), new ShaderMaterial({vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT}));
    this.lines.frustumCulled = false;
    this.group.add(this.lines);
    this.tools = path.tools.map((tool) => makeTool(tool, radius));
    for (const tool of this.tools) this.group.add(tool);
    this.setRange(0, path.blocks.length - 1);
  }

  /** A line to each point that is no start; before[i]: so many lines end at points before i. */
  segments() {
    const {points, kinds} = this.path;
    this.before = new Uint32Array(kinds.length + 1);
    for (let i = 0; i < kinds.length; ++i) this.before[i + 1] = this.before[i] + (kinds[i] === START ? 0 : 1);
    const count = this.before[kinds.length];
    this.ends = new Float32Array(6 * count);
    const tones = new Float32Array(6 * count);
    for (let i = 1; i < kinds.length; ++i) {
      if (kinds[i] === START) continue;
      const at = 6 * this.before[i];
      this.ends.set(points.subarray(3 * i - 3, 3 * i + 3), at);
      tones.set([...TONES[kinds[i]], ...TONES[kinds[i]]], at);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.ends, 3));
    geometry.setAttribute('tone', new BufferAttribute(tones, 3));
    return geometry;
  }

  /** Of the blocks with these places in the order of the run. */
  setRange(from, to) {
    const {blocks, times, kinds} = this.path;
    this.from = blocks[from].first;
    this.to = (to + 1 < blocks.length ? blocks[to + 1].first : kinds.length) - 1;
    this.startTime = times[Math.max(0, this.from - 1)];
    this.endTime = times[this.to];
    this.setTime(this.endTime);
  }

  /** The point that is reached last at the time, within the range. */
  reached(time) {
    const {times} = this.path;
    let low = Math.max(0, this.from - 1), high = this.to;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Draws up to that time and puts the tool there; gives the place of the block that is at work. */
  setTime(time) {
    const {points, times, kinds, blocks, axes} = this.path;
    this.time = Math.min(this.endTime, Math.max(this.startTime, time));
    const at = this.reached(this.time), next = Math.min(at + 1, this.to);
    const moves = next > at && kinds[next] !== START;
    const share = moves ? Math.min(1, (this.time - times[at]) / Math.max(1e-9, times[next] - times[at])) : 0;
    const place = new Vector3().fromArray(points, 3 * at).lerp(new Vector3().fromArray(points, 3 * (moves ? next : at)), share);
    this.restore();
    const first = this.before[this.from], last = this.before[at + 1];
    if (moves && share > 0) this.shorten(this.before[next], place);
    this.lines.geometry.setDrawRange(2 * first, 2 * Math.max(0, last - first + (moves && share > 0 ? 1 : 0)));
    const block = this.blockOf(share > 0 && share < 1 ? next : at);
    this.placeTool(blocks[block].tool, place, axes ? new Vector3().fromArray(axes, 3 * (moves ? next : at)) : null);
    return block;
  }

  /** The line that the tool is on ends at the tool. */
  shorten(line, place) {
    this.cut = {line, end: this.ends.slice(6 * line + 3, 6 * line + 6)};
    this.ends.set(place.toArray(), 6 * line + 3);
    this.lines.geometry.attributes.position.needsUpdate = true;
  }
  restore() {
    if (!this.cut) return;
    this.ends.set(this.cut.end, 6 * this.cut.line + 3);
    this.lines.geometry.attributes.position.needsUpdate = true;
    this.cut = null;
  }

  placeTool(index, place, axis) {
    this.tools.forEach((tool, k) => {
      tool.visible = k === index;
      if (k !== index) return;
      tool.position.copy(place);
      tool.quaternion.copy(axis ? new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis.normalize()) : new Quaternion());
    });
  }

  blockOf(point) {
    const {blocks} = this.path;
    let low = 0, high = blocks.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (blocks[middle].first <= point) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** "plate.nc:12  N120 G1 X10" */
  text(block) {
    const {setup, file, line, n} = this.path.blocks[block];
    const name = this.path.files[file] || '';
    const words = (this.path.texts[file] || [])[line - 1] || (n >= 0 ? `N${n}` : '');
    return `${this.path.setups[setup] ? this.path.setups[setup] + ', ' : ''}${name}:${line}  ${words}`;
  }
}
