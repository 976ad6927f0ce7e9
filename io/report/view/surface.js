// Meshes as they are drawn: shaded with creases, coloured by deviation, cut by the section plane.
import {BufferAttribute, BufferGeometry, DoubleSide, Mesh, ShaderMaterial, Vector3, Vector4} from 'three';

/** Faces that turn less against each other are shaded as one. */
const CREASE_COS = Math.cos((35 * Math.PI) / 180);
/** Stops of the colour scale that the shader takes. */
const MOST_STOPS = 32;
/** In place of "not measured": no graphics card is sure to know NaN. */
const NOT_MEASURED = 1e9;

const VERTEX = `
attribute float deviation;
varying vec3 vNormal, vPlace;
varying float vDeviation;
void main() {
  vec4 place = modelMatrix * vec4(position, 1.0);
  vPlace = place.xyz;
  vNormal = normalMatrix * normal;
  vDeviation = deviation;
  gl_Position = projectionMatrix * viewMatrix * place;
}`;

// What is seen of the inside of a cut solid are back faces: in one tone they look like the face of the cut.
const FRAGMENT = `
uniform vec4 plane;
uniform bool coloured;
uniform vec3 tone, cutTone;
uniform float opacity;
uniform float stopAt[${MOST_STOPS}];
uniform vec3 stopTone[${MOST_STOPS}];
varying vec3 vNormal, vPlace;
varying float vDeviation;
vec3 scaleTone(float mm) {
  vec3 found = stopTone[0];
  for (int i = 0; i < ${MOST_STOPS - 1}; ++i) {
    if (mm >= stopAt[i])
      found = mix(stopTone[i], stopTone[i + 1], clamp((mm - stopAt[i]) / (stopAt[i + 1] - stopAt[i]), 0.0, 1.0));
  }
  return found;
}
void main() {
  if (dot(plane.xyz, vPlace) + plane.w > 0.0) discard;
  if (!gl_FrontFacing) {
    gl_FragColor = vec4(cutTone, opacity);
    return;
  }
  vec3 colour = tone;
  if (coloured) colour = vDeviation > ${NOT_MEASURED / 2}.0 ? vec3(0.45) : scaleTone(vDeviation);
  vec3 n = normalize(vNormal);
  float light = 0.42 + 0.5 * max(dot(n, vec3(0.30, 0.45, 0.84)), 0.0) + 0.12 * max(dot(n, vec3(-0.70, 0.20, 0.68)), 0.0);
  gl_FragColor = vec4(colour * light, opacity);
}`;

/** Unit normal and twice the area of each triangle: nx, ny, nz, area. */
function faceNormals(positions, corners) {
  const faces = new Float32Array((corners.length / 3) * 4);
  for (let t = 0; 3 * t < corners.length; ++t) {
    const a = 3 * corners[3 * t], b = 3 * corners[3 * t + 1], c = 3 * corners[3 * t + 2];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1], uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1], vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    const area = Math.hypot(x, y, z) || 1e-30;
    faces.set([x / area, y / area, z / area, area], 4 * t);
  }
  return faces;
}

/** Triangles around each vertex: those of v are list[start[v]] to list[start[v + 1] - 1]. */
function trianglesAround(corners, vertices) {
  const start = new Uint32Array(vertices + 1), list = new Uint32Array(corners.length);
  for (const v of corners) ++start[v + 1];
  for (let v = 0; v < vertices; ++v) start[v + 1] += start[v];
  const next = start.slice();
  for (let i = 0; i < corners.length; ++i) list[next[corners[i]]++] = Math.floor(i / 3);
  return {start, list};
}

/** A normal for each corner of each triangle: the mean of the faces around that turn little against its own. */
function cornerNormals(positions, corners) {
  const faces = faceNormals(positions, corners);
  const {start, list} = trianglesAround(corners, positions.length / 3);
  const normals = new Float32Array(3 * corners.length);
  for (let i = 0; i < corners.length; ++i) {
    const own = 4 * Math.floor(i / 3), v = corners[i];
    let x = 0, y = 0, z = 0;
    for (let k = start[v]; k < start[v + 1]; ++k) {
      const f = 4 * list[k];
      const turn = faces[f] * faces[own] + faces[f + 1] * faces[own + 1] + faces[f + 2] * faces[own + 2];
      if (turn < CREASE_COS) continue;
      const w = faces[f + 3];
      x += w * faces[f];
      y += w * faces[f + 1];
      z += w * faces[f + 2];
    }
    const length = Math.hypot(x, y, z) || 1;
    normals.set([x / length, y / length, z / length], 3 * i);
  }
  return normals;
}

/** Vertex by corner, so that each has a normal of its own. */
function geometryOf({positions, corners, deviations}) {
  const places = new Float32Array(3 * corners.length), values = new Float32Array(corners.length);
  corners.forEach((v, i) => {
    places.set(positions.subarray(3 * v, 3 * v + 3), 3 * i);
    values[i] = !deviations ? 0 : Number.isNaN(deviations[v]) ? NOT_MEASURED : deviations[v];
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('normal', new BufferAttribute(cornerNormals(positions, corners), 3));
  geometry.setAttribute('deviation', new BufferAttribute(values, 1));
  return geometry;
}

const tone = (hex) => new Vector3(...[1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255));

/** Value and colour of the stops, filled up to what the shader takes. */
function stopUniforms(stops) {
  const all = (stops && stops.length ? stops : [[0, '#cccccc']]).slice(0, MOST_STOPS);
  const last = all[all.length - 1];
  while (all.length < MOST_STOPS) all.push([NOT_MEASURED * (1 + all.length), last[1]]);
  return {stopAt: {value: all.map((stop) => stop[0])}, stopTone: {value: all.map((stop) => tone(stop[1]))}};
}

/** look: {tone, cutTone, opacity, stops}; plane: the Vector4 that the views share, n and w of n p + w <= 0. */
export function makeSurface(mesh, look, plane) {
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: DoubleSide,
    transparent: look.opacity < 1,
    depthWrite: look.opacity === 1,
    uniforms: {
      plane: {value: plane || new Vector4(0, 0, 0, -1)},
      coloured: {value: Boolean(mesh.deviations)},
      tone: {value: tone(look.tone)},
      cutTone: {value: tone(look.cutTone)},
      opacity: {value: look.opacity},
      ...stopUniforms(look.stops),
    },
  });
  const surface = new Mesh(geometryOf(mesh), material);
  surface.frustumCulled = false;
  return surface;
}
