// The eye: turned about a point with the Z axis upright, by mouse, fingers and keys; parallel projection.
import {OrthographicCamera, Vector3} from 'three';

const MOST_TILT = Math.PI / 2 - 1e-4;
const TURN_MS = 450;

export class Orbit {
  /** radius: of what is looked at, mm. changed: called when the picture is to be drawn anew. */
  constructor(canvas, center, radius, changed) {
    this.canvas = canvas;
    this.radius = radius;
    this.changed = changed;
    this.home = center.clone();
    this.camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 1);
    this.camera.up.set(0, 0, 1);
    this.state = {target: center.clone(), azimuth: -Math.PI / 4, tilt: 0.615, height: 2 * radius};
    this.fingers = new Map();
    this.listen();
  }

  direction({azimuth, tilt} = this.state) {
    return new Vector3(Math.cos(tilt) * Math.cos(azimuth), Math.cos(tilt) * Math.sin(azimuth), Math.sin(tilt));
  }

  /** Puts the camera where the state says. */
  apply(width, height) {
    const {target, height: high} = this.state, c = this.camera;
    // A narrow picture shows as much across as a wide one up.
    const tall = high * Math.max(1, height / width);
    c.top = tall / 2;
    c.bottom = -tall / 2;
    c.right = (tall / 2) * (width / height);
    c.left = -c.right;
    const away = 20 * this.radius;
    c.far = 2 * away;
    c.position.copy(target).addScaledVector(this.direction(), away);
    c.lookAt(target);
    c.updateProjectionMatrix();
    c.updateMatrixWorld();
    this.mmPerPixel = tall / height;
  }

  turnBy(dx, dy) {
    this.stop();
    this.state.azimuth -= 0.008 * dx;
    this.state.tilt = Math.min(MOST_TILT, Math.max(-MOST_TILT, this.state.tilt + 0.008 * dy));
    this.changed();
  }
  shiftBy(dx, dy) {
    this.stop();
    const across = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.state.target.addScaledVector(across, -dx * this.mmPerPixel).addScaledVector(up, dy * this.mmPerPixel);
    this.changed();
  }
  zoomBy(factor) {
    this.stop();
    this.state.height = Math.min(20 * this.radius, Math.max(1e-3 * this.radius, this.state.height * factor));
    this.changed();
  }

  /** Turns there in a moment, or at once for those who want nothing to move. */
  turnTo({target = this.state.target, direction, height = this.state.height}) {
    const tilt = Math.min(MOST_TILT, Math.max(-MOST_TILT, Math.asin(direction.z / direction.length())));
    let azimuth = Math.hypot(direction.x, direction.y) < 1e-6 ? -Math.PI / 2 : Math.atan2(direction.y, direction.x);
    const from = {...this.state, target: this.state.target.clone()};
    while (azimuth - from.azimuth > Math.PI) azimuth -= 2 * Math.PI;
    while (azimuth - from.azimuth < -Math.PI) azimuth += 2 * Math.PI;
    const to = {target: target.clone(), azimuth, tilt, height};
    this.stop();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.state = to;
      this.changed();
      return;
    }
    const start = performance.now();
    const step = (now) => {
      const u = Math.min(1, Math.max(0, (now - start) / TURN_MS)), s = u * u * (3 - 2 * u);
      const mix = (a, b) => a + s * (b - a);
      this.state = {
        target: from.target.clone().lerp(to.target, s),
        azimuth: mix(from.azimuth, to.azimuth),
        tilt: mix(from.tilt, to.tilt),
        height: from.height * Math.pow(to.height / from.height, s),
      };
      this.changed();
      this.turning = u < 1 ? requestAnimationFrame(step) : 0;
    };
    this.turning = requestAnimationFrame(step);
  }
  lookFrom(direction) {
    this.turnTo({target: this.home, direction, height: 2 * this.radius});
  }
  stop() {
    if (this.turning) cancelAnimationFrame(this.turning);
    this.turning = 0;
  }

  listen() {
    const on = (name, act) => this.canvas.addEventListener(name, act, {passive: false});
    on('pointerdown', (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      this.fingers.set(e.pointerId, {x: e.clientX, y: e.clientY});
    });
    on('pointermove', (e) => this.drag(e));
    for (const name of ['pointerup', 'pointercancel']) on(name, (e) => this.fingers.delete(e.pointerId));
    on('contextmenu', (e) => e.preventDefault());
    // The wheel scrolls the page until the view has been clicked.
    on('wheel', (e) => {
      if (document.activeElement !== this.canvas && !e.ctrlKey) return;
      e.preventDefault();
      this.zoomBy(Math.exp(0.0012 * Math.max(-240, Math.min(240, e.deltaY))));
    });
    on('keydown', (e) => this.key(e));
  }

  drag(e) {
    const before = this.fingers.get(e.pointerId);
    if (!before) return;
    const dx = e.clientX - before.x, dy = e.clientY - before.y;
    if (this.fingers.size === 2) {
      const [other] = [...this.fingers].filter(([id]) => id !== e.pointerId).map(([, place]) => place);
      const apart = (p) => Math.max(20, Math.hypot(p.x - other.x, p.y - other.y));
      this.zoomBy(apart(before) / apart({x: e.clientX, y: e.clientY}));
      this.shiftBy(dx / 2, dy / 2);
    } else if (e.buttons & 6 || e.shiftKey) {
      this.shiftBy(dx, dy);
    } else {
      this.turnBy(dx, dy);
    }
    this.fingers.set(e.pointerId, {x: e.clientX, y: e.clientY});
  }

  key(e) {
    const step = 20;
    const arrows = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]};
    if (arrows[e.key]) e.shiftKey ? this.shiftBy(...arrows[e.key]) : this.turnBy(...arrows[e.key]);
    else if (e.key === '+' || e.key === '=') this.zoomBy(0.85);
    else if (e.key === '-') this.zoomBy(1 / 0.85);
    else if (e.key === 'Home') this.lookFrom(new Vector3(1, -1, 1));
    else return;
    e.preventDefault();
  }
}
