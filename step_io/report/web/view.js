// The model in 3D: faces, edges by category, the selected edges with their combs, the worst points.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { CATEGORIES } from './scene.js';
import { MEASURES, MODES, curvatureRange, makeFaceGeometry, makeFaceMaterial } from './shading.js';

/** Directions from the model to the eye, z upwards. */
const DIRECTIONS = {
  iso: [1, -1.2, 0.8], front: [0, -1, 0], back: [0, 1, 0], left: [-1, 0, 0], right: [1, 0, 0],
  top: [0, -1e-3, 1], bottom: [0, -1e-3, -1],
};
const PICK_PIXELS = 9;
const WORST_POINTS = 20;
const COMB_COLOURS = ['#0072b2', '#d55e00'];

export class View {
  constructor(canvas, scene, colours) {
    this.canvas = canvas;
    this.data = scene;
    this.colours = colours;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.01, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.invalidate());
    this.material = makeFaceMaterial();
    this.models = scene.models.map((model, i) => {
      const mesh = new THREE.Mesh(makeFaceGeometry(model, i === 0 ? scene.newFaces : []), this.material);
      mesh.frustumCulled = false;
      mesh.visible = i === 0;
      this.scene.add(mesh);
      return mesh;
    });
    this.box = new THREE.Box3();
    for (const mesh of this.models) {
      mesh.geometry.computeBoundingBox();
      if (!mesh.geometry.boundingBox.isEmpty()) this.box.union(mesh.geometry.boundingBox);
    }
    if (this.box.isEmpty()) this.box.set(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
    this.size = this.box.getSize(new THREE.Vector3()).length() || 1;
    this.range = scene.models.length > 0 ? curvatureRange(scene.models[0]) : 1;
    this.material.uniforms.range.value = this.range;
    this.lines = {};
    this.makeEdgeLines();
    this.selection = this.makeLines([], '#f0e442', 7);
    this.selection.material.depthTest = false;
    this.selection.renderOrder = 3;
    this.scene.add(this.selection);
    this.combs = new THREE.Group();
    this.scene.add(this.combs);
    this.combScale = 1;
    this.markers = this.makeMarkers();
    this.scene.add(this.markers);
    this.pointer = this.makePoints([[0, 0, 0]], '#f0e442', 15);
    this.pointer.visible = false;
    this.scene.add(this.pointer);
    this.look(this.home());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  // ---- what there is to see

  segmentsOf(edges, model = 0) {
    const { edgePoints, edgeFirst } = this.data.models[model];
    const positions = [];
    for (const edge of edges) {
      for (let i = edgeFirst[edge - 1]; i + 1 < edgeFirst[edge]; ++i) {
        for (let k = 0; k < 6; ++k) positions.push(edgePoints[3 * i + k]);
      }
    }
    return positions;
  }

  makeLines(positions, colour, width) {
    const lines = new LineSegments2(new LineSegmentsGeometry(),
      new LineMaterial({ color: colour, linewidth: width, polygonOffset: true, polygonOffsetFactor: -2 }));
    lines.frustumCulled = false;
    this.setSegments(lines, positions);
    return lines;
  }

  setSegments(lines, positions) {
    lines.geometry.dispose();
    lines.geometry = new LineSegmentsGeometry();
    lines.visible = positions.length > 0;
    if (positions.length > 0) lines.geometry.setPositions(positions);
  }

  makeEdgeLines() {
    const byCategory = this.data.byCategory();
    for (const category of CATEGORIES) {
      const positions = this.data.models.length > 0 ? this.segmentsOf(byCategory[category.key]) : [];
      const lines = this.makeLines(positions, this.colours[category.key], category.width);
      lines.userData = { some: positions.length > 0, edges: byCategory[category.key] };
      lines.renderOrder = category.key === 'near' ? 2 : 1;
      this.lines[category.key] = lines;
      this.scene.add(lines);
    }
    this.beforeLines = null;
    if (this.data.models.length > 1) {
      const count = this.data.models[1].edgeFirst.length - 1;
      const all = Array.from({ length: count }, (_, i) => i + 1);
      this.beforeLines = this.makeLines(this.segmentsOf(all, 1), this.colours.sharp, 1.5);
      this.beforeLines.visible = false;
      this.scene.add(this.beforeLines);
    }
  }

  makePoints(positions, colour, size) {
    const disc = document.createElement('canvas');
    disc.width = disc.height = 64;
    const pen = disc.getContext('2d');
    pen.beginPath();
    pen.arc(32, 32, 24, 0, 2 * Math.PI);
    pen.fillStyle = colour;
    pen.fill();
    pen.lineWidth = 8;
    pen.strokeStyle = '#000';
    pen.stroke();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions.flat(), 3));
    const points = new THREE.Points(geometry, new THREE.PointsMaterial({
      size: size * this.renderer.getPixelRatio(), sizeAttenuation: false, transparent: true,
      map: new THREE.CanvasTexture(disc), depthTest: false,
    }));
    points.material.map.colorSpace = THREE.SRGBColorSpace;
    points.frustumCulled = false;
    points.renderOrder = 4;
    return points;
  }

  makeMarkers() {
    const worst = [];
    for (let row = 0; row < this.data.rows && worst.length < WORST_POINTS; ++row) {
      if (this.data.near[row] === 1) worst.push(this.data.at(row));
    }
    for (const knot of this.data.knots) {
      if (knot.near && worst.length < WORST_POINTS) worst.push(knot.at);
    }
    const points = this.makePoints(worst, this.colours.near, 13);
    points.visible = worst.length > 0;
    points.userData.some = worst.length > 0;
    return points;
  }

  // ---- switches

  setMode(mode) { this.material.uniforms.mode.value = MODES.indexOf(mode); this.invalidate(); }
  setMeasure(measure) { this.material.uniforms.measure.value = MEASURES.indexOf(measure); this.invalidate(); }
  setStripes(count) { this.material.uniforms.stripes.value = count; this.invalidate(); }
  setFreshShown(shown) { this.material.uniforms.freshShown.value = shown ? 1 : 0; this.invalidate(); }
  setMarkersShown(shown) { this.markers.visible = shown && this.markers.userData.some; this.invalidate(); }
  setBackground(colour) { this.scene.background = new THREE.Color(colour); this.invalidate(); }
  setSharpColour(colour) {
    this.lines.sharp.material.color.set(colour);
    this.beforeLines?.material.color.set(colour);
    this.invalidate();
  }

  setShown(categories, before) {
    this.models.forEach((mesh, i) => { mesh.visible = (i === 1) === before; });
    for (const [key, lines] of Object.entries(this.lines)) {
      lines.visible = !before && categories.has(key) && lines.userData.some;
    }
    if (this.beforeLines) this.beforeLines.visible = before && categories.size > 0;
    this.selection.visible = this.combs.visible = !before;
    this.invalidate();
  }

  select(rows) {
    this.rows = rows;
    this.setSegments(this.selection, this.segmentsOf(rows.map((row) => this.data.edge(row))));
    this.drawCombs();
    this.invalidate();
  }

  setCombsShown(shown) { this.combsShown = shown; this.drawCombs(); this.invalidate(); }
  setCombScale(scale) { this.combScale = scale; this.drawCombs(); this.invalidate(); }

  /** Hedgehog combs: along the outward normal, as long as the curvature across the edge is large;
   *  against it where the face is convex. */
  drawCombs() {
    for (const old of this.combs.children) { old.geometry.dispose(); old.material.dispose(); }
    this.combs.clear();
    if (!this.combsShown || !this.rows) return;
    const traces = this.rows.map((row) => this.data.trace(row));
    let largest = 0;
    let length = 0;
    for (const trace of traces) {
      for (const p of trace) {
        for (const k of p.curvature) if (Number.isFinite(k)) largest = Math.max(largest, Math.abs(k));
      }
    }
    for (const row of this.rows) length = Math.max(length, this.data.length[row]);
    if (largest === 0) return;
    const scale = this.combScale * 0.35 * Math.min(length, this.size / 4) / largest;
    for (const side of [0, 1]) {
      const positions = [];
      for (const trace of traces) {
        let before = null;
        for (const p of trace) {
          const tip = Array.from(p.point, (x, i) => x - scale * p.curvature[side] * p.normal[side][i]);
          if (!tip.every(Number.isFinite)) { before = null; continue; }
          positions.push(...p.point, ...tip);
          if (before) positions.push(...before, ...tip);
          before = tip;
        }
      }
      const lines = this.makeLines(positions, COMB_COLOURS[side], side === 0 ? 2.2 : 1.2);
      lines.material.depthTest = false;
      lines.renderOrder = 5;
      this.combs.add(lines);
    }
  }

  /** Marks a point of the selected edge, or none. */
  point(at) {
    this.pointer.visible = Boolean(at);
    if (at) this.pointer.position.set(at[0], at[1], at[2]);
    this.invalidate();
  }

  // ---- camera

  /** Where to look from first: from where the new faces are seen, if there are any. */
  home() {
    const sum = new THREE.Vector3();
    const { first, corners, normals } = this.data.models[0] ?? {};
    for (const face of this.data.newFaces) {
      for (let i = 3 * first[face - 1]; i < 3 * first[face]; ++i) {
        sum.add(new THREE.Vector3().fromArray(normals, 3 * corners[i]));
      }
    }
    const iso = new THREE.Vector3(...DIRECTIONS.iso).normalize();
    return sum.length() < 1e-6 ? 'iso' : sum.normalize().addScaledVector(iso, 0.25).toArray();
  }

  look(direction) {
    const d = new THREE.Vector3(...(Array.isArray(direction) ? direction : DIRECTIONS[direction])).normalize();
    this.fly(this.box.getCenter(new THREE.Vector3()), d, this.distanceFor(0.5 * this.size), true);
  }

  distanceFor(radius) {
    const half = (this.camera.fov * Math.PI) / 360;
    const aspect = Math.min(this.camera.aspect, 1);
    return radius / Math.sin(Math.atan(Math.tan(half) * aspect));
  }

  /** Moves so that an edge is seen from the side to which its faces look. */
  lookAtEdge(row, at_once = false) {
    const trace = this.data.trace(row);
    const box = new THREE.Box3();
    const edge = this.data.edge(row);
    const { edgePoints, edgeFirst } = this.data.models[0];
    for (let i = edgeFirst[edge - 1]; i < edgeFirst[edge]; ++i) {
      box.expandByPoint(new THREE.Vector3().fromArray(edgePoints, 3 * i));
    }
    if (box.isEmpty()) return;
    const direction = new THREE.Vector3();
    for (const p of trace) {
      for (const n of p.normal) if (n.every(Number.isFinite)) direction.add(new THREE.Vector3(...n));
    }
    const eye = this.camera.position.clone().sub(this.controls.target).normalize();
    if (direction.length() < 1e-3) direction.copy(eye);
    direction.normalize().addScaledVector(eye, 0.35).normalize();
    const radius = Math.max(0.75 * box.getSize(new THREE.Vector3()).length(), 0.01 * this.size);
    this.fly(box.getCenter(new THREE.Vector3()), direction, this.distanceFor(radius), at_once);
  }

  fly(target, direction, distance, at_once) {
    const end = target.clone().addScaledVector(direction, distance);
    this.camera.near = Math.max(distance / 500, this.size * 1e-5);
    this.camera.far = distance + 4 * this.size;
    this.camera.updateProjectionMatrix();
    cancelAnimationFrame(this.flight);
    const still = at_once || window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    const from = { target: this.controls.target.clone(), position: this.camera.position.clone() };
    const begun = performance.now();
    const step = () => {
      const s = still ? 1 : Math.min(1, (performance.now() - begun) / 250);
      const ease = s * s * (3 - 2 * s);
      this.controls.target.lerpVectors(from.target, target, ease);
      this.camera.position.lerpVectors(from.position, end, ease);
      this.controls.update();
      this.invalidate();
      if (s < 1) this.flight = requestAnimationFrame(step);
    };
    step();
  }

  // ---- drawing and picking

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0 || (width === this.width && height === this.height)) return;
    Object.assign(this, { width, height });
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    // The new canvas is empty: at once, but for the first picture, which start() draws.
    if (this.started) this.draw(); else this.invalidate();
  }

  /** Draws the first picture, once for all that was set before: without a graphics card each takes a second. */
  start() {
    this.resize();
    this.started = true;
    this.draw();
  }

  invalidate() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => { if (this.pending) this.draw(); });
  }

  draw() {
    this.pending = false;
    this.renderer.render(this.scene, this.camera);
  }

  /** The shown edge nearest to a point of the canvas, or 0. */
  edgeAt(x, y) {
    const { width, height } = this.canvas.getBoundingClientRect();
    const matrix = new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse);
    const { edgePoints, edgeFirst } = this.data.models[0];
    const p = new THREE.Vector4();
    let best = 0;
    let nearest = PICK_PIXELS;
    let depth = Infinity;
    for (const lines of Object.values(this.lines)) {
      if (!lines.visible) continue;
      for (const edge of lines.userData.edges) {
        let before = null;
        for (let i = edgeFirst[edge - 1]; i < edgeFirst[edge]; ++i) {
          p.set(edgePoints[3 * i], edgePoints[3 * i + 1], edgePoints[3 * i + 2], 1).applyMatrix4(matrix);
          const now = p.w > 0 ? [(0.5 + (0.5 * p.x) / p.w) * width, (0.5 - (0.5 * p.y) / p.w) * height, p.w] : null;
          if (now && before) {
            const distance = segmentDistance(x, y, before, now);
            // Of edges under the pointer the one in front.
            if (distance < PICK_PIXELS && (distance < nearest - 3 || (distance < nearest + 3 && now[2] < depth))) {
              nearest = Math.min(nearest, distance);
              depth = now[2];
              best = edge;
            }
          }
          before = now;
        }
      }
    }
    return best;
  }
}

function segmentDistance(x, y, a, b) {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const s = Math.max(0, Math.min(1, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - a[0] - s * dx, y - a[1] - s * dy);
}
