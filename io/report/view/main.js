// The 3-D view of report.html. The page gives a section "view3d" and a script element "view3d-data"; see scene_data.h
// for what is in that. Rows of findings have the ids "finding-1", "finding-2", ...
import {Color, Scene, Vector3, Vector4, WebGLRenderer} from 'three';
import {decode} from './decode.js';
import {Markers, directionTo} from './markers.js';
import {Orbit} from './orbit.js';
import {ToolPath} from './path.js';
import {Outline} from './section.js';
import {makeSurface} from './surface.js';
import styles from './view.css';
import licence from './three-licence.txt';
import template from './view.html';

const PART_TONE = '#b9c3cc', NOMINAL_TONE = '#7fb58f', CUT_TONE = '#e0a458', NOMINAL_CUT_TONE = '#a9cfb4';
const MACHINED_LINE = new Color(0xc2410c), NOMINAL_LINE = new Color(0x15803d);
/** A plane with everything on its near side. */
const NO_CUT = [0, 0, 0, -1];

const mm = (value) => `${value.toFixed(3)} mm`;
const clock = (s) => `${Math.floor(s / 60)}:${(s % 60).toFixed(1).padStart(4, '0')}`;

class View {
  constructor(section, data) {
    this.section = section;
    this.data = data;
    this.box = data.box;
    this.center = new Vector3(...[0, 1, 2].map((k) => (this.box.min[k] + this.box.max[k]) / 2));
    this.radius = Math.max(1e-6, new Vector3(...this.box.min).distanceTo(this.center));
    this.canvas = section.querySelector('canvas');
    this.renderer = new WebGLRenderer({canvas: this.canvas, alpha: true, antialias: true});
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
    this.orbit = new Orbit(this.canvas, this.center, this.radius, () => this.draw());
    this.fill();
    this.legend();
    this.note();
    this.wireShow();
    this.wireSection();
    if (this.path) this.wirePath();
    this.wireFindings();
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.resize();
    this.showNamed();
  }

  find(query) {
    return this.section.querySelector(query);
  }

  fill() {
    this.scene = new Scene();
    this.plane = new Vector4(...NO_CUT);
    const {part, nominal, scale} = this.data;
    this.outlines = [];
    const add = (mesh, look, line) => {
      const surface = makeSurface(mesh, look, this.plane);
      const outline = new Outline(mesh, line);
      this.scene.add(surface, outline.lines);
      this.outlines.push({outline, surface});
      return surface;
    };
    // Where both outlines are the same, that of the part is seen.
    this.part = add(part, {tone: PART_TONE, cutTone: CUT_TONE, opacity: 1, stops: scale && scale.stops}, MACHINED_LINE);
    this.outlines[0].outline.lines.renderOrder = 3;
    if (nominal) {
      this.nominal = add(nominal, {tone: NOMINAL_TONE, cutTone: NOMINAL_CUT_TONE, opacity: 1}, NOMINAL_LINE);
      this.nominal.visible = false;
    }
    if (this.data.path) {
      this.path = new ToolPath(this.data.path, this.radius);
      this.path.group.visible = false;
      this.scene.add(this.path.group);
    }
    this.markers = new Markers(this.find('.v3-markers'), this.data.findings, (finding) => this.toRow(finding));
  }

  /** Draws with the next picture of the screen. */
  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      const {clientWidth: width, clientHeight: height} = this.canvas;
      if (width === 0 || height === 0) return;
      this.orbit.apply(width, height);
      this.renderer.render(this.scene, this.orbit.camera);
      this.markers.place(this.orbit.camera, width, height);
      this.section.dataset.state = 'drawn';
    });
  }
  resize() {
    this.renderer.setSize(this.canvas.clientWidth, this.canvas.clientHeight, false);
    this.draw();
  }

  legend() {
    const {scale, part} = this.data;
    const box = this.find('.v3-legend');
    if (!scale || !part.deviations) return;
    const low = scale.stops[0][0], high = scale.stops[scale.stops.length - 1][0];
    const share = (value) => (100 * (value - low)) / (high - low);
    const bar = document.createElement('i');
    bar.style.background = `linear-gradient(to top,${scale.stops.map(([at, tone]) => `${tone} ${share(at).toFixed(2)}%`)})`;
    const ticks = document.createElement('div');
    const taken = [];
    for (const value of scale.ticks) {
      const at = share(value);
      if (at < -0.01 || at > 100.01 || taken.some((other) => Math.abs(other - at) < 7)) continue;
      taken.push(at);
      const label = document.createElement('span');
      label.style.top = `${100 - at}%`;
      label.textContent = `${value > 0 ? '+' : ''}${Number(value.toPrecision(3))}`;
      ticks.append(label);
    }
    box.append(bar, ticks);
    box.setAttribute('role', 'img');
    box.setAttribute('aria-label', `Colours of the deviation from ${low} to ${high} mm`);
    this.hasLegend = true;
  }

  note() {
    const {part, nominal, path} = this.data;
    const count = (n) => n.toLocaleString('en');
    const of = (mesh) => (mesh.off === 0 ? `its whole mesh of ${count(mesh.of)} triangles`
      : `a reduced mesh, ${count(mesh.triangles)} triangles made of ${count(mesh.of)}, at most ${Number(mesh.off.toPrecision(2))} mm off`);
    const says = [`For the eye, not for measuring. Part: ${of(part)}.`];
    if (nominal) says.push(`Nominal: ${of(nominal)}.`);
    if (path && path.off > 0) says.push(`Tool path: points nearer to each other than ${Number(path.off.toPrecision(2))} mm are left out.`);
    says.push('Drag turns, with Shift or the right button shifts; the wheel zooms once the view has been clicked, two fingers on a phone.');
    this.find('.v3-note').textContent = says.join(' ');
  }

  wireShow() {
    const boxes = Object.fromEntries([...this.section.querySelectorAll('[data-show]')].map((box) => [box.dataset.show, box]));
    const drop = (box) => box.closest('label').remove();
    if (!this.nominal) drop(boxes.nominal);
    if (!this.path) drop(boxes.path);
    if (!this.hasLegend) drop(boxes.deviation);
    if (this.data.findings.length === 0) drop(boxes.findings);
    this.boxes = boxes;
    for (const box of Object.values(boxes)) box.addEventListener('change', () => this.show());
    for (const button of this.section.querySelectorAll('[data-from]'))
      button.addEventListener('click', () => this.orbit.lookFrom(new Vector3(...button.dataset.from.split(',').map(Number))));
    this.show();
  }
  show() {
    const {boxes} = this;
    this.part.visible = boxes.part.checked;
    const coloured = Boolean(this.hasLegend && boxes.deviation.checked);
    this.part.material.uniforms.coloured.value = coloured;
    this.find('.v3-legend').hidden = !(coloured && boxes.part.checked);
    if (this.nominal) {
      this.nominal.visible = boxes.nominal.checked;
      // Beside the part it is seen through.
      const both = boxes.part.checked;
      this.nominal.material.uniforms.opacity.value = both ? 0.35 : 1;
      this.nominal.material.transparent = both;
      this.nominal.material.depthWrite = !both;
      // Where both are the same, the part is seen.
      Object.assign(this.nominal.material, {polygonOffset: both, polygonOffsetFactor: 1, polygonOffsetUnits: 4});
      this.nominal.renderOrder = 1;
    }
    if (this.path) this.path.group.visible = boxes.path.checked;
    this.find('.v3-path').hidden = !(this.path && boxes.path.checked);
    this.markers.shown = boxes.findings.checked;
    this.draw();
  }

  wireSection() {
    this.cut = Object.fromEntries([...this.section.querySelectorAll('[data-section]')].map((x) => [x.dataset.section, x]));
    this.cut.axis.addEventListener('input', () => this.chooseSide());
    for (const input of Object.values(this.cut)) input.addEventListener('input', () => this.moveSection());
    if (!this.nominal) this.section.querySelectorAll('.v3-section .nominal').forEach((key) => key.parentNode.replaceChildren());
    this.moveSection();
  }
  /** What is cut away first is the side that is nearer to the eye. */
  chooseSide() {
    if (this.cut.axis.value !== '') this.near = Math.sign(this.orbit.direction().getComponent(Number(this.cut.axis.value))) || 1;
    this.cut.flip.checked = false;
  }
  moveSection() {
    const {axis, level, flip} = this.cut;
    const chosen = axis.value !== '';
    for (const element of this.section.querySelectorAll('.v3-section .v3-long, .v3-section .v3-key')) element.hidden = !chosen;
    flip.closest('label').hidden = !chosen;
    if (!chosen) {
      this.plane.set(...NO_CUT);
    } else {
      const k = Number(axis.value), at = this.box.min[k] + (level.value / 1000) * (this.box.max[k] - this.box.min[k]);
      const side = flip.checked ? -this.near : this.near;
      this.plane.set(k === 0 ? side : 0, k === 1 ? side : 0, k === 2 ? side : 0, -side * at);
      this.find('.v3-section output').textContent = mm(at);
      for (const {outline} of this.outlines) outline.moveTo(k, at);
    }
    for (const {outline} of this.outlines) outline.lines.visible = chosen;
    this.draw();
  }

  wirePath() {
    const inputs = Object.fromEntries([...this.section.querySelectorAll('[data-path]')].map((x) => [x.dataset.path, x]));
    this.inputs = inputs;
    const last = this.data.path.blocks.length - 1;
    inputs.from.max = inputs.to.max = last;
    inputs.to.value = last;
    for (const end of ['from', 'to']) inputs[end].addEventListener('input', () => this.setRange(end));
    inputs.time.addEventListener('input', () => {
      this.pause();
      this.setTime(this.path.startTime + (inputs.time.value / 1000) * (this.path.endTime - this.path.startTime));
    });
    inputs.play.addEventListener('click', () => (this.playing ? this.pause() : this.play()));
    this.setRange('to');
  }
  setRange(moved) {
    const {from, to} = this.inputs;
    if (Number(from.value) > Number(to.value)) (moved === 'from' ? to : from).value = (moved === 'from' ? from : to).value;
    this.pause();
    this.path.setRange(Number(from.value), Number(to.value));
    this.inputs['from-text'].textContent = this.path.text(Number(from.value));
    this.inputs['to-text'].textContent = this.path.text(Number(to.value));
    this.setTime(this.path.endTime);
  }
  setTime(time) {
    const block = this.path.setTime(time);
    const {startTime, endTime} = this.path;
    this.inputs.time.value = endTime > startTime ? Math.round((1000 * (this.path.time - startTime)) / (endTime - startTime)) : 1000;
    this.find('.v3-path output').textContent = clock(this.path.time);
    this.inputs.now.textContent = this.path.text(block);
    this.draw();
  }
  play() {
    if (this.path.time >= this.path.endTime) this.setTime(this.path.startTime);
    let last = performance.now();
    const step = (now) => {
      this.setTime(this.path.time + (Math.max(0, now - last) / 1000) * Number(this.inputs.speed.value));
      last = now;
      if (this.path.time >= this.path.endTime) this.pause();
      else this.playing = requestAnimationFrame(step);
    };
    this.playing = requestAnimationFrame(step);
    this.inputs.play.textContent = 'Pause';
  }
  pause() {
    if (this.playing) cancelAnimationFrame(this.playing);
    this.playing = 0;
    this.inputs.play.textContent = 'Play';
  }

  wireFindings() {
    for (const finding of this.data.findings) {
      const row = document.getElementById(`finding-${finding.n}`);
      if (!row) continue;
      row.classList.add('v3-row');
      row.addEventListener('click', (e) => {
        if (!e.target.closest('a,button,summary') && !String(getSelection())) this.toFinding(finding);
      });
      row.querySelectorAll('a[href="#view3d"]').forEach((link) => link.addEventListener('click', (e) => {
        e.preventDefault();
        this.toFinding(finding);
      }));
    }
  }
  /** report.html#finding-3 shows that one. */
  showNamed() {
    const named = /^#finding-(\d+)$/.exec(location.hash);
    const finding = named && this.data.findings.find(({n}) => n === Number(named[1]));
    if (finding) this.toFinding(finding);
  }
  choose(finding) {
    this.markers.choose(finding.n);
    document.querySelectorAll('tr.chosen').forEach((row) => row.classList.remove('chosen'));
    const row = document.getElementById(`finding-${finding.n}`);
    if (row) row.classList.add('chosen');
    return row;
  }
  /** Turns the view to a finding, and the range of the path to the blocks around its own. */
  toFinding(finding) {
    this.choose(finding);
    this.section.dataset.finding = finding.n;
    if (this.path && finding.block >= 0) {
      const last = this.data.path.blocks.length - 1;
      this.inputs.from.value = Math.max(0, finding.block - 3);
      this.inputs.to.value = Math.min(last, finding.block + 3);
      this.setRange('to');
    }
    const height = Math.min(2 * this.radius, Math.max(6 * (finding.size || 0), 0.45 * this.radius));
    this.orbit.turnTo({target: new Vector3(...finding.at), direction: directionTo(this.data.part, finding, this.radius), height});
    this.section.scrollIntoView({block: 'nearest'});
  }
  toRow(finding) {
    const row = this.choose(finding);
    if (!row) return;
    row.scrollIntoView({block: 'center'});
    const link = row.querySelector('a');
    if (link) link.focus({preventScroll: true});
  }
}

async function start() {
  const section = document.getElementById('view3d');
  const carried = document.getElementById('view3d-data');
  if (!section || !carried) return;
  const body = section.querySelector('.v3-body');
  try {
    const data = await decode(carried.textContent.trim());
    const style = document.createElement('style');
    style.textContent = styles;
    document.head.append(style);
    body.innerHTML = template;
    body.append(document.createComment(licence));
    window.proveoutView = new View(section, data);
  } catch (error) {
    body.innerHTML = '';
    const says = document.createElement('p');
    says.className = 'quiet';
    says.textContent = `This browser cannot show the 3-D view (${error.message}). The pictures below show the part.`;
    body.append(says);
    section.dataset.state = 'failed';
  }
}
start();
