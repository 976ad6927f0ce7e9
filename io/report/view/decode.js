// Unpacks what the page carries: base64 of deflated bytes. They are the length of a JSON head, the head, and whole
// numbers of variable length (LEB128; signed ones zigzag). scene_data.cpp writes them in the same order.

/** Reads whole numbers one after the other. */
class Numbers {
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }
  unsigned() {
    let value = 0, scale = 1, byte;
    do {
      byte = this.bytes[this.at++];
      value += (byte & 127) * scale;
      scale *= 128;
    } while (byte & 128);
    return value;
  }
  signed() {
    const code = this.unsigned();
    return code % 2 ? -(code + 1) / 2 : code / 2;
  }
}

/** Places on a grid over the box, each as the step from the one before. */
function readPlaces(numbers, count, box) {
  const places = new Float32Array(3 * count);
  const step = [0, 1, 2].map((k) => (box.max[k] - box.min[k]) / 65535);
  const at = [0, 0, 0];
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 3; ++k) {
      at[k] += numbers.signed();
      places[3 * i + k] = box.min[k] + at[k] * step[k];
    }
  }
  return places;
}

/** A corner is told by how far it is behind the first vertex that was not used yet. */
function readTriangles(numbers, count) {
  const corners = new Uint32Array(3 * count);
  let next = 0;
  for (let i = 0; i < corners.length; ++i) {
    const back = numbers.unsigned();
    corners[i] = next - back;
    if (back === 0) ++next;
  }
  return corners;
}

/** mm; NaN where nothing was measured. */
function readDeviations(numbers, count, unit) {
  const values = new Float32Array(count);
  let at = 0;
  for (let i = 0; i < count; ++i) {
    const code = numbers.unsigned();
    if (code === 0) {
      values[i] = NaN;
      continue;
    }
    at += code % 2 ? (code - 1) / 2 : -code / 2;
    values[i] = at * unit;
  }
  return values;
}

function readMesh(numbers, head, box) {
  if (!head) return null;
  return {
    ...head,
    positions: readPlaces(numbers, head.vertices, box),
    corners: readTriangles(numbers, head.triangles),
    deviations: head.unit ? readDeviations(numbers, head.vertices, head.unit) : null,
  };
}

/** Blocks in the order in which they ran: {setup, file, line, n, tool, first}; first: of its points. */
function readBlocks(numbers, count) {
  const blocks = [];
  const row = [0, 0, 0, 0, 0];
  let first = 0;
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 5; ++k) row[k] += numbers.signed();
    const [setup, file, line, n, tool] = row;
    blocks.push({setup, file, line, n, tool, first});
    first += numbers.unsigned();
  }
  return blocks;
}

/** Kind of the way to each point (4: a start), and the time at it, s. */
function readTimes(numbers, count) {
  const kinds = new Uint8Array(count), times = new Float64Array(count);
  let ms = 0;
  for (let i = 0; i < count; ++i) {
    kinds[i] = numbers.unsigned();
    ms += numbers.unsigned();
    times[i] = ms / 1000;
  }
  return {kinds, times};
}

/** Directions of the tool, in thousandths. */
function readAxes(numbers, count) {
  const axes = new Float32Array(3 * count);
  const at = [0, 0, 0];
  for (let i = 0; i < axes.length; ++i) axes[i] = (at[i % 3] += numbers.signed()) / 1000;
  return axes;
}

function readPath(numbers, head) {
  if (!head) return null;
  const blocks = readBlocks(numbers, head.blocks);
  const points = readPlaces(numbers, head.points, head.box);
  const {kinds, times} = readTimes(numbers, head.points);
  return {...head, blocks, points, kinds, times, axes: head.turns ? readAxes(numbers, head.points) : null};
}

export async function decode(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const numbers = new Numbers(bytes, 0);
  const length = numbers.unsigned();
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(numbers.at, numbers.at + length)));
  numbers.at += length;
  return {
    ...head,
    part: readMesh(numbers, head.part, head.box),
    nominal: readMesh(numbers, head.nominal, head.box),
    path: readPath(numbers, head.path),
  };
}
