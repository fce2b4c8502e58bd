// The data of the page: arrays of numbers as the program wrote them, and what follows from them.

/** The categories of edges, in the order of the legend. Colours after Okabe and Ito: they differ
 *  for every kind of colour blindness, and in brightness. */
export const CATEGORIES = [
  { key: 'near', label: 'near miss', hint: 'neither within the limits nor sharp', width: 5 },
  { key: 'unmeasured', label: 'not measured', hint: 'the remark says why', width: 5 },
  { key: 'free', label: 'free', hint: 'one face only: a border or a hole', width: 3.5 },
  { key: 'crowded', label: 'non-manifold', hint: 'more than two faces', width: 3.5 },
  { key: 'G1', label: 'G1', hint: 'tangent', width: 2.5 },
  { key: 'G2', label: 'G2', hint: 'same curvature', width: 2.5 },
  { key: 'G3', label: 'G3', hint: 'same change of curvature', width: 2.5 },
  { key: 'sharp', label: 'sharp', hint: 'meant to be an edge', width: 1.5 },
];
const CLASSES = ['sharp', 'G0', 'G1', 'G2', 'G3'];
const TRACE = 14; // numbers of a point of a course along an edge

export function decode(text, Type) {
  if (Uint8Array.fromBase64) return new Type(Uint8Array.fromBase64(text).buffer);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return new Type(bytes.buffer);
}

function decodeModel(model) {
  return {
    points: decode(model.points, Float32Array),
    normals: unfold(decode(model.normals, Int16Array)),
    curvatures: decode(model.curvatures, Float32Array),
    corners: decode(model.corners, Uint32Array),
    first: decode(model.first, Uint32Array),
    edgePoints: decode(model.edge_points, Float32Array),
    edgeFirst: decode(model.edge_first, Uint32Array),
    facesWithout: model.faces_without,
  };
}

/** Octahedral normals back onto the sphere. */
function unfold(folded) {
  const normals = new Float32Array((folded.length / 2) * 3);
  for (let i = 0, o = 0; i < folded.length; i += 2, o += 3) {
    let x = folded[i] / 32767;
    let y = folded[i + 1] / 32767;
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) {
      const old = x;
      x = (1 - Math.abs(y)) * Math.sign(old || 1);
      y = (1 - Math.abs(old)) * Math.sign(y || 1);
    }
    const length = Math.hypot(x, y, z) || 1;
    normals[o] = x / length;
    normals[o + 1] = y / length;
    normals[o + 2] = z / length;
  }
  return normals;
}

export class Scene {
  constructor(json) {
    const { edges, traces } = json;
    this.models = json.models.map(decodeModel);
    this.newFaces = new Set(json.new_faces);
    this.profile = json.profile;
    this.knots = json.knots;
    this.pass = json.pass;
    this.numbers = decode(edges.numbers, Uint32Array);
    this.classes = decode(edges.classes, Uint8Array);
    this.near = decode(edges.near, Uint8Array);
    for (const name of ['length', 'gap', 'angle', 'mean', 'curvature', 'curvature_sum', 'opposite',
      'g3', 'severity', 'gap_at', 'angle_at']) {
      this[name] = decode(edges[name], Float32Array);
    }
    this.remarks = edges.remarks;
    this.traceValues = decode(traces.values, Float32Array);
    this.traceFirst = decode(traces.first, Uint32Array);
    this.freeEdges = json.free_edges;
    this.crowdedEdges = json.non_manifold_edges;
    this.rows = this.classes.length;
    this.rowOfEdge = new Map();
    for (let row = 0; row < this.rows; ++row) this.rowOfEdge.set(this.edge(row), row);
    this.holes = json.holes ?? [];
    this.parts = json.parts ?? [];
    this.limits = { g0: this.profile.g0_mm, g1: this.profile.g1_deg, g2: this.profile.g2_percent, sharp: this.profile.sharp_deg };
    this.asGiven = { ...this.limits, classes: this.classes.slice(), near: this.near.slice() };
  }

  /** Classes and near misses for other limits than those of the report, as the program tells them
   *  (kernel/suture/check/continuity.cpp, classify; kernel/suture/judge/summary.cpp, is_near_miss). */
  setLimits(limits) {
    this.limits = { ...limits };
    const given = this.asGiven;
    if (['g0', 'g1', 'g2', 'sharp'].every((key) => limits[key] === given[key])) {
      this.classes.set(given.classes);
      this.near.set(given.near);
      return;
    }
    for (let row = 0; row < this.rows; ++row) {
      if (given.near[row] === 2) continue; // not measured
      const sharp = this.angle[row] > limits.sharp;
      const within = this.gap[row] <= limits.g0 && this.angle[row] <= limits.g1;
      const mismatch = this.mismatch(row);
      this.classes[row] = sharp ? 0 : !within ? 1 : !(mismatch <= limits.g2) ? 2
        : this.g3[row] <= this.profile.g3_deg ? 4 : 3;
      this.near[row] = this.gap[row] > limits.g0 || (!sharp && this.angle[row] > limits.g1) ? 1 : 0;
    }
  }

  /** Whether one of the edge's faces is new. */
  isNew(row) { return this.faces(row).some((face) => this.newFaces.has(face)); }

  /** How far beyond the limits an edge is: 1 is at the limit. */
  excess(row) {
    const sharp = this.className(row) === 'sharp';
    return Math.max(this.gap[row] / this.limits.g0, sharp ? 0 : this.angle[row] / this.limits.g1);
  }

  edge(row) { return this.numbers[3 * row]; }
  faces(row) { return [this.numbers[3 * row + 1], this.numbers[3 * row + 2]]; }
  className(row) { return CLASSES[this.classes[row]]; }
  category(row) {
    if (this.near[row] === 2) return 'unmeasured';
    return this.near[row] === 1 ? 'near' : this.className(row);
  }
  mismatch(row) {
    return this.profile.g2_by === 'sum' ? this.curvature_sum[row] : this.curvature[row];
  }
  isNearKnot(knot) {
    return knot.gap > this.limits.g0 || (knot.angle > this.limits.g1 && knot.angle <= this.limits.sharp);
  }
  remark(row) { return this.remarks[row] || ''; }
  at(row) {
    const exceeded = this.gap[row] > this.limits.g0 ? this.gap_at : this.angle_at;
    return [exceeded[3 * row], exceeded[3 * row + 1], exceeded[3 * row + 2]];
  }

  /** The course along an edge: a list of points, empty where there is none. */
  trace(row) {
    const points = [];
    for (let i = this.traceFirst[row]; i < (this.traceFirst[row + 1] ?? 0); ++i) {
      const v = this.traceValues.subarray(TRACE * i, TRACE * (i + 1));
      points.push({
        along: v[0], point: v.slice(1, 4), gap: v[4], angle: v[5],
        curvature: [v[6], v[7]], normal: [v.slice(8, 11), v.slice(11, 14)],
      });
    }
    return points;
  }

  /** Rows of each category; of free and non-manifold edges their numbers. */
  byCategory() {
    const lists = Object.fromEntries(CATEGORIES.map((category) => [category.key, []]));
    for (let row = 0; row < this.rows; ++row) lists[this.category(row)]?.push(this.edge(row));
    lists.free = this.freeEdges;
    lists.crowded = this.crowdedEdges;
    return lists;
  }
}

/** A number as a reader wants it. */
export function short(value) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) return value.toExponential(2).replace('e+', 'e');
  return String(Number(value.toPrecision(4)));
}
