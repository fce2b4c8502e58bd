// The model in 3D: faces, edges by category, the selected edges with their combs, the worst points.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { CATEGORIES } from './scene.js';
import { ISO, distanceFor, towardsNewFaces } from './framing.js';
import { combs, deviation } from './hairs.js';
import { edgeAt } from './picking.js';
import { MEASURES, MODES, makeFaceGeometry, makeFaceMaterial } from './shading.js';

/** Directions from the model to the eye, z upwards. */
const DIRECTIONS = {
  iso: ISO, front: [0, -1, 0], back: [0, 1, 0], left: [-1, 0, 0], right: [1, 0, 0],
  top: [0, -1e-3, 1], bottom: [0, -1e-3, -1],
};
const WORST_POINTS = 20;
const MOST_LABELS = 12; // of deviations
const LABEL = [80, 20]; // pixels that a figure takes
const MOST_TRACED = 400; // edges with hairs of deviation at once

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
    this.renderer.localClippingEnabled = true;
    this.plane = new THREE.Plane(new THREE.Vector3(0, 0, -1), Infinity);
    this.cutting = false;
    this.shownCategories = new Set(CATEGORIES.map(({ key }) => key));
    this.before = false;
    this.hiddenEdges = new Set();
    this.pins = [];
    this.lines = {};
    this.makeEdgeLines();
    this.selection = this.makeLines([], '#f0e442', 7);
    this.selection.material.depthTest = false;
    this.selection.renderOrder = 3;
    this.scene.add(this.selection);
    this.combs = new THREE.Group();
    this.scene.add(this.combs);
    this.combScale = 1;
    this.hairs = new THREE.Group();
    this.scene.add(this.hairs);
    this.borders = new THREE.Group();
    this.scene.add(this.borders);
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
      if (model === 0 && this.hiddenEdges?.has(edge)) continue;
      for (let i = edgeFirst[edge - 1]; i + 1 < edgeFirst[edge]; ++i) {
        for (let k = 0; k < 6; ++k) positions.push(edgePoints[3 * i + k]);
      }
    }
    return positions;
  }

  makeLines(positions, colour, width) {
    const lines = new LineSegments2(new LineSegmentsGeometry(),
      new LineMaterial({ color: colour, linewidth: width, clipping: true, clippingPlanes: this.cutting ? [this.plane] : [], polygonOffset: true, polygonOffsetFactor: -2 }));
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

  /** Lines for every category; anew after limits or parts have changed. */
  makeEdgeLines() {
    const byCategory = this.data.byCategory();
    for (const old of [...Object.values(this.lines), this.beforeLines]) {
      if (!old) continue;
      old.geometry.dispose();
      old.material.dispose();
      this.scene.remove(old);
    }
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

  remakeMarkers() {
    const { visible } = this.markers;
    this.scene.remove(this.markers);
    this.markers = this.makeMarkers();
    this.markers.visible = visible && this.markers.userData.some;
    this.markers.material.clippingPlanes = this.cutting ? [this.plane] : [];
    this.scene.add(this.markers);
  }

  /** The borders of holes: over everything, faint where they are hidden. */
  setBorders(segments, colour) {
    this.emptyGroup(this.borders);
    for (const [through, opacity, width] of [[true, 0.35, 4], [false, 1, 6]]) {
      const lines = this.makeLines(segments, colour, width);
      Object.assign(lines.material, { depthTest: !through, transparent: through, opacity });
      lines.renderOrder = 2;
      this.borders.add(lines);
    }
    this.invalidate();
  }

  emptyGroup(group) {
    for (const old of group.children) { old.geometry.dispose(); old.material.dispose(); }
    group.clear();
  }

  /** Faces and edges of the parts that are not shown. */
  setHidden(faces, edges) {
    this.hiddenEdges = edges;
    const { first, corners } = this.data.models[0];
    const kept = [];
    for (let face = 1; face < first.length; ++face) {
      if (faces.has(face)) continue;
      for (let i = 3 * first[face - 1]; i < 3 * first[face]; ++i) kept.push(corners[i]);
    }
    this.models[0].geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(kept), 1));
    this.refresh();
  }

  /** Draws edges, markers and hairs anew: limits, parts or colours have changed. */
  refresh() {
    this.makeEdgeLines();
    this.remakeMarkers();
    this.setShown(this.shownCategories, this.before);
    this.select(this.rows ?? []);
  }

  /** What lies beyond a plane is not drawn; none without a normal. `at` from 0 to 1 through the model. */
  setSection(normal, at) {
    this.cutting = Boolean(normal);
    if (normal) {
      const n = new THREE.Vector3(...normal).normalize();
      let [low, high] = [Infinity, -Infinity];
      for (let k = 0; k < 8; ++k) {
        const d = n.dot(new THREE.Vector3(k & 1 ? this.box.max.x : this.box.min.x, k & 2 ? this.box.max.y : this.box.min.y, k & 4 ? this.box.max.z : this.box.min.z));
        [low, high] = [Math.min(low, d), Math.max(high, d)];
      }
      const d = low + at * (high - low);
      this.plane.set(n.clone().negate(), d);
      this.material.uniforms.section.value.set(n.x, n.y, n.z, d);
    } else this.material.uniforms.section.value.set(0, 0, 0, 1);
    this.scene.traverse((object) => {
      if (object.material && object.material !== this.material) object.material.clippingPlanes = this.cutting ? [this.plane] : [];
    });
    this.invalidate();
  }

  isCut(p) { return this.cutting && this.plane.normal.x * p.x + this.plane.normal.y * p.y + this.plane.normal.z * p.z + this.plane.constant < 0; }

  /** The worst points; of a fill those of its new faces, as the old ones are not what it is about. */
  makeMarkers() {
    const { newFaces } = this.data;
    const worst = [];
    for (let row = 0; row < this.data.rows && worst.length < WORST_POINTS; ++row) {
      if (this.data.near[row] === 1 && (newFaces.size === 0 || this.data.isNew(row))) worst.push(this.data.at(row));
    }
    for (const knot of this.data.knots) {
      if (this.data.isNearKnot(knot) && (newFaces.size === 0 || newFaces.has(knot.face)) && worst.length < WORST_POINTS) worst.push(knot.at);
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
  setColours(colours) {
    Object.assign(this.colours, colours);
    for (const [key, lines] of Object.entries(this.lines)) lines.material.color.set(this.colours[key]);
    this.beforeLines?.material.color.set(this.colours.sharp);
    this.drawCombs();
    this.invalidate();
  }

  setShown(categories, before) {
    this.shownCategories = categories;
    this.before = before;
    this.models.forEach((mesh, i) => { mesh.visible = (i === 1) === before; });
    for (const [key, lines] of Object.entries(this.lines)) {
      lines.visible = !before && categories.has(key) && lines.userData.some;
    }
    if (this.beforeLines) this.beforeLines.visible = before && categories.size > 0;
    this.selection.visible = this.combs.visible = this.hairs.visible = !before;
    this.invalidate();
  }

  select(rows) {
    this.rows = rows;
    this.setSegments(this.selection, this.segmentsOf(rows.map((row) => this.data.edge(row))));
    this.drawCombs();
    this.drawDeviation();
    this.invalidate();
  }

  setCombsShown(shown) { this.combsShown = shown; this.drawCombs(); this.invalidate(); }
  setCombScale(scale) { this.combScale = scale; this.drawCombs(); this.invalidate(); }

  drawCombs() {
    this.emptyGroup(this.combs);
    if (!this.combsShown || !this.rows || this.rows.length === 0) return;
    combs(this.data, this.rows, this.size, this.combScale).forEach((positions, side) => {
      if (positions.length === 0) return;
      const lines = this.makeLines(positions, this.colours[side === 0 ? 'one' : 'two'], side === 0 ? 2.2 : 1.2);
      lines.material.depthTest = false;
      lines.renderOrder = 5;
      this.combs.add(lines);
    });
  }

  /** measure: 'angle', 'gap', or '' for none. rows: the edges, where none is selected. */
  setDeviation(measure, rows) {
    this.deviationOf = measure;
    this.deviationRows = rows;
    this.drawDeviation();
    this.invalidate();
  }

  drawDeviation() {
    this.emptyGroup(this.hairs);
    this.setPins('deviation', []);
    if (!this.deviationOf) return;
    const rows = (this.rows?.length ? this.rows : this.deviationRows).filter((row) => !this.hiddenEdges.has(this.data.edge(row)));
    const length = this.combScale * 0.12 * Math.min(this.size, this.camera.position.distanceTo(this.controls.target));
    const found = deviation(this.data, rows.slice(0, MOST_TRACED), this.deviationOf, length);
    for (const [positions, colour] of [[found.within, this.colours.good], [found.beyond, this.colours.bad]]) {
      const lines = this.makeLines(positions, colour, 2);
      lines.renderOrder = 5;
      this.hairs.add(lines);
    }
    this.setPins('deviation', found.worst.slice(0, MOST_LABELS).map(({ row, at, text, bad }) => ({
      at, text, row, className: bad ? 'bad' : 'good', label: `Edge ${this.data.edge(row)}: ${text}` })));
  }

  // ---- labels that stand at points of the model

  /** onPin is told which of them was clicked. */
  setPins(kind, pins) {
    this.pins = this.pins.filter((pin) => { if (pin.kind === kind) pin.element.remove(); return pin.kind !== kind; });
    for (const pin of pins) {
      const element = Object.assign(document.createElement('button'), {
        type: 'button', className: `pin ${kind} ${pin.className ?? ''}`, textContent: pin.text, ariaLabel: pin.label, title: pin.label });
      element.addEventListener('click', () => this.onPin?.({ ...pin, kind }));
      this.canvas.parentElement.append(element);
      this.pins.push({ ...pin, kind, element });
    }
    this.invalidate();
  }

  placePins() {
    const p = new THREE.Vector3();
    const figures = []; // that are shown, the worst first: what would lie on one of them is hidden
    for (const { at, element, kind } of this.pins) {
      p.set(...at);
      const cut = this.isCut(p);
      p.project(this.camera);
      const [x, y] = [(0.5 + p.x / 2) * this.width, (0.5 - p.y / 2) * this.height];
      element.hidden = cut || p.z > 1 || Math.abs(p.x) > 1 || Math.abs(p.y) > 1
        || (kind === 'deviation' && (this.before || figures.some(([a, b]) => Math.abs(a - x) < LABEL[0] && Math.abs(b - y) < LABEL[1])));
      if (kind === 'deviation' && !element.hidden) figures.push([x, y]);
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
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
    return towardsNewFaces(this.data)?.toArray() ?? 'iso';
  }

  look(direction) {
    const d = new THREE.Vector3(...(Array.isArray(direction) ? direction : DIRECTIONS[direction])).normalize();
    this.fly(this.box.getCenter(new THREE.Vector3()), d, this.distanceFor(0.5 * this.size), true);
  }

  /** Moves to a ball around points of the model. */
  lookAtPoints(points, direction, at_once = false) {
    const box = new THREE.Box3();
    for (const point of points) box.expandByPoint(new THREE.Vector3(...point));
    if (box.isEmpty()) return;
    const iso = new THREE.Vector3(...DIRECTIONS.iso).normalize();
    const d = direction ? new THREE.Vector3(...direction).normalize().addScaledVector(iso, 0.35) : iso;
    const radius = Math.max(0.9 * box.getSize(new THREE.Vector3()).length(), 0.02 * this.size);
    this.fly(box.getCenter(new THREE.Vector3()), d.normalize(), this.distanceFor(Math.min(radius, 0.5 * this.size)), at_once);
  }

  /** The corners of the new faces' triangles. */
  newPoints() {
    const { first, corners, points } = this.data.models[0] ?? {};
    const found = [];
    for (const face of this.data.newFaces) {
      for (let i = 3 * first[face - 1]; i < 3 * first[face]; ++i) found.push(Array.from(points.subarray(3 * corners[i], 3 * corners[i] + 3)));
    }
    return found;
  }

  distanceFor(radius) { return distanceFor(this.camera, radius); }

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
    this.placePins();
  }

  /** The shown edge nearest to a point of the canvas, or 0. */
  edgeAt(x, y) { return edgeAt(this, x, y); }
}
