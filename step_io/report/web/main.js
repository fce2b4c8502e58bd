// The page: puts view, tables, plot and panels together, and obeys buttons, keys and the address.
import { CATEGORIES, Scene, short } from './scene.js';
import { View } from './view.js';
import { EdgeTable } from './table.js';
import { HoleTable, placeHoles } from './holes.js';
import { PAGE } from './page.js';
import { makeLimits, makeParts } from './panels.js';
import { curvatureAt, curvatureSpread } from './shading.js';
import { plotEdge, plotHistogram } from './plot.js';

const byId = (id) => document.getElementById(id);
const scene = new Scene(JSON.parse(byId('suture-scene').textContent));
byId('suture-scene').remove(); // its text is no longer needed
const wishes = new URLSearchParams(location.hash.slice(1));
const picture = wishes.has('picture');
document.documentElement.classList.toggle('picture', picture);
document.documentElement.classList.add('live');
document.body.insertAdjacentHTML('beforeend', PAGE);
byId('report').before(byId('app'));

// ---- look

const style = () => getComputedStyle(document.documentElement);
const COLOURED = [...CATEGORIES.map(({ key }) => key), 'good', 'bad', 'one', 'two', 'hole'];
const colours = () => Object.fromEntries(COLOURED.map((key) => [key, style().getPropertyValue(`--${key}`).trim()]));
let lists = scene.byCategory();
const shown = new Set(CATEGORIES.map(({ key }) => key));
const holes = placeHoles(scene);
const filled = scene.models.length > 1;
let before = false;
let view = null;
try {
  view = new View(byId('view'), scene, colours());
} catch (error) {
  byId('message').hidden = false;
  byId('message').textContent = `This browser shows no 3D (${error.message}). The tables and the plots work all the same.`;
}

function useTheme(theme) {
  if (theme) document.documentElement.dataset.theme = theme;
  view?.setBackground(picture ? '#ffffff' : style().getPropertyValue('--stage').trim());
  view?.setColours(colours());
  showBorders();
}
function dark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}

// ---- legend and filters

const nearOf = (name) => Array.from(scene.near).filter((near, row) => near === 1 && scene.className(row) === name).length;
function makeLegend() {
  byId('legend').replaceChildren(...CATEGORIES.filter(({ key }) => lists[key].length > 0).map(({ key, label, hint }) => {
    const entry = document.createElement('label');
    entry.title = hint;
    // The verdict counts edges by class; near misses that are sharp stand apart here.
    const sharp = key === 'sharp' ? nearOf('sharp') : 0;
    entry.innerHTML = `<input type="checkbox" ${shown.has(key) ? 'checked' : ''} data-category="${key}"><span class="swatch ${key}"></span>${label} <b>${lists[key].length}</b>${sharp ? ` + ${sharp} near` : ''}`;
    entry.firstChild.addEventListener('change', (event) => {
      if (event.target.checked) shown.add(key); else shown.delete(key);
      applyShown();
    });
    return entry;
  }));
}
function applyShown() {
  view?.setShown(shown, before);
  table.filter(shown.size === CATEGORIES.length ? null : (row) => shown.has(scene.category(row)));
}

// ---- shading

function useMode(mode) {
  for (const button of document.querySelectorAll('[data-mode]')) {
    button.setAttribute('aria-checked', String(button.dataset.mode === mode));
  }
  byId('stripes-label').hidden = mode !== 'zebra';
  byId('measure-label').hidden = byId('range-label').hidden = mode !== 'curvature';
  byId('scale').hidden = mode !== 'curvature';
  view?.setMode(mode);
  if (mode === 'curvature') useRange();
}
const spreads = {};
function useRange() {
  if (!view || scene.models.length === 0) return;
  const measure = byId('measure').value;
  spreads[measure] ??= curvatureSpread(scene.models[0], measure);
  const part = Number(byId('range').value) / 100;
  const range = curvatureAt(spreads[measure], part);
  view.material.uniforms.range.value = range;
  view.invalidate();
  byId('scale').innerHTML = `<span>−${short(range)}</span><i></i><span>+${short(range)} /mm</span><small>${(100 * part).toFixed(0)} % of the curved area is within</small>`;
}
function toggle(id, apply) {
  const button = byId(id);
  button.addEventListener('click', () => {
    const on = button.getAttribute('aria-pressed') !== 'true';
    button.setAttribute('aria-pressed', String(on));
    apply(on);
  });
}

// ---- selection: table, view and plot say the same

const table = new EdgeTable(byId('table'), scene, (rows, current) => {
  view?.select(rows);
  if (current >= 0) view?.lookAtEdge(current);
  if (current >= 0) holeTable.mark(holeOfEdge(current));
  view?.point(null);
  plotEdge(byId('plot'), scene, current, (at) => view?.point(at));
});
// ---- holes: their table, their numbers and borders in the view

function holeOfEdge(row) {
  // A fill's new face keeps the edges of the hole, though their numbers may have changed: told by place.
  const trace = scene.trace(row);
  const middle = trace[Math.floor(trace.length / 2)]?.point;
  if (!middle || !(filled ? scene.isNew(row) : true)) return -1;
  return holes.findIndex((hole) => hole.lines.some((line) => nearLine(middle, line)));
}
function nearLine(p, line) {
  let [length, nearest] = [0, Infinity];
  for (let i = 0; i + 1 < line.length; ++i) {
    const d = line[i].map((x, k) => line[i + 1][k] - x);
    const size = Math.hypot(...d);
    length += size;
    const s = size > 0 ? Math.max(0, Math.min(1, d.reduce((sum, x, k) => sum + x * (p[k] - line[i][k]), 0) / size ** 2)) : 0;
    nearest = Math.min(nearest, Math.hypot(...d.map((x, k) => line[i][k] + s * x - p[k])));
  }
  return nearest < 0.02 * length;
}
const holeTable = new HoleTable(byId('holes'), holes, (index) => {
  holeTable.mark(index);
  showBorders();
  const hole = holes[index];
  view?.lookAtPoints(hole.points, hole.out);
});
function isOpen(hole) { return !filled || ['refused', 'skipped'].includes(hole.status); }
function showBorders() {
  if (!view) return;
  // What is filled is marked in the picture before it, and when it is chosen.
  const marked = holes.filter((hole, index) => before || isOpen(hole) || index === holeTable.current);
  view.setBorders(marked.flatMap((hole) => hole.lines.flatMap((line) => line.slice(1).flatMap((p, i) => [...line[i], ...p]))), colours().hole);
}
function showPins() {
  const most = 60;
  view?.setPins('hole', picture ? [] : holes.slice(0, most).filter((hole) => hole.points.length > 0).map((hole) => ({
    at: hole.centre, text: hole.id, label: `Hole ${hole.id}: ${hole.status}, ${hole.edges.length} sides, ${short(hole.diameter)} mm`, hole: holes.indexOf(hole) })));
}
if (view) {
  view.onPin = (pin) => (pin.kind === 'hole' ? holeTable.onPick(pin.hole) : table.show(pin.row, false));
  showPins();
}
/** The static tables below name holes too: a click on a hole's number shows it. */
for (const heading of document.querySelectorAll('#report h2')) {
  if (!/^(Holes|Other loops|Findings)$/.test(heading.textContent)) continue;
  for (const cell of heading.nextElementSibling?.querySelectorAll('tbody td:first-child') ?? []) {
    const index = holes.findIndex((hole) => hole.id.split('+').includes(cell.textContent) || hole.id === cell.textContent);
    if (index < 0) continue;
    const button = Object.assign(document.createElement('button'), { type: 'button', textContent: cell.textContent, ariaLabel: `Look at hole ${cell.textContent}` });
    button.addEventListener('click', () => { byId('app').scrollIntoView(); holeTable.onPick(index); });
    cell.replaceChildren(button);
  }
}

const BORDERS = ['free', 'crowded']; // edges that are not between two faces
function makeSummary() {
  const { profile, limits } = scene;
  let gap = 0;
  let angle = 0;
  for (let row = 0; row < scene.rows; ++row) {
    gap = Math.max(gap, scene.gap[row]);
    if (scene.className(row) !== 'sharp') angle = Math.max(angle, scene.angle[row]);
  }
  const counted = (wanted) => CATEGORIES.filter((category) => wanted(category) && lists[category.key].length > 0)
    .map(({ key, label }) => `${lists[key].length} ${label}`).join(', ');
  const entries = [
    ['limits', `${profile.name}: ${short(limits.g0)} mm, ${short(limits.g1)}°, ${short(limits.g2)} % (of the ${profile.g2_by}), G3 ${short(profile.g3_deg)}°, sharp from ${short(limits.sharp)}°`],
    ['edges', `${scene.rows} between two faces: ${counted(({ key }) => !BORDERS.includes(key))}${counted(({ key }) => BORDERS.includes(key)).replace(/^(?=.)/, '; ')}`],
    ['largest', `gap ${short(gap)} mm, angle of edges that are not sharp ${short(angle)}°`],
    ['inside faces', `${scene.knots.length} knot lines of no more than C1, ${scene.knots.filter((knot) => scene.isNearKnot(knot)).length} near misses`],
  ];
  byId('summary').replaceChildren(...entries.flatMap(([term, text]) => [
    Object.assign(document.createElement('dt'), { textContent: term }),
    Object.assign(document.createElement('dd'), { textContent: text })]));
}
/** All that follows from the limits. */
function useLimits(limits) {
  scene.setLimits(limits);
  lists = scene.byCategory();
  makeLegend();
  makeSummary();
  plotHistogram(byId('histogram'), scene);
  table.reorder();
  plotEdge(byId('plot'), scene, table.current, (at) => view?.point(at));
  view?.refresh();
  useDeviation();
}
makeLegend();
makeSummary();
plotEdge(byId('plot'), scene, -1);
plotHistogram(byId('histogram'), scene);
view?.setCombsShown(true);
makeLimits(byId('limits'), scene, useLimits);
makeParts(byId('parts'), scene, (faces, edges) => view?.setHidden(faces, edges));

// ---- deviation along edges, section

/** New faces' edges, or else all that are not sharp, the worst first. */
function useDeviation() {
  const rows = table.order.filter((row) => scene.near[row] !== 2 && scene.className(row) !== 'sharp');
  const fresh = rows.filter((row) => scene.isNew(row));
  view?.setDeviation(byId('deviation').value, fresh.length > 0 ? fresh : rows);
}
function useSection() {
  const axis = byId('section').value;
  byId('section-label').hidden = axis === '';
  if (!view) return;
  const flip = byId('section-flip').getAttribute('aria-pressed') === 'true' ? -1 : 1;
  const normals = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
  if (axis === 'eye') normals.eye = view.camera.position.clone().sub(view.controls.target).toArray();
  const at = Number(byId('section-at').value) / 100;
  view.setSection(axis === '' ? null : normals[axis].map((x) => flip * x), flip > 0 ? at : 1 - at);
}
byId('deviation').addEventListener('change', useDeviation);
byId('section').addEventListener('change', useSection);
byId('section-at').addEventListener('input', useSection);

for (const button of document.querySelectorAll('[data-mode]')) {
  button.addEventListener('click', () => useMode(button.dataset.mode));
}
byId('stripes').addEventListener('input', (event) => view?.setStripes(Number(event.target.value)));
byId('measure').addEventListener('change', (event) => { view?.setMeasure(event.target.value); useRange(); });
byId('range').addEventListener('input', useRange);
byId('comb-size').addEventListener('input', (event) => { view?.setCombScale(10 ** Number(event.target.value)); view?.drawDeviation(); });
toggle('section-flip', useSection);
toggle('combs', (on) => view?.setCombsShown(on));
toggle('markers', (on) => view?.setMarkersShown(on));
toggle('fresh', (on) => view?.setFreshShown(on));
toggle('before', (on) => {
  before = on;
  byId('before').textContent = on ? 'Show after' : 'Show before'; // what a click does
  applyShown();
  showBorders();
});
byId('fresh').hidden = scene.newFaces.size === 0;
byId('before').hidden = scene.models.length < 2;
byId('before').textContent = 'Show before';
if (scene.newFaces.size > 0) table.ask('new');
else table.which.querySelector('[value=new]').remove();
byId('look').addEventListener('change', (event) => view?.look(event.target.value));
byId('fit').addEventListener('click', () => view?.look(view.home()));
byId('theme').addEventListener('click', () => useTheme(dark() ? 'light' : 'dark'));
byId('help').addEventListener('click', () => byId('keys').showModal());
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => useTheme());

let pressed = null;
byId('view').addEventListener('pointerdown', (event) => { pressed = [event.clientX, event.clientY]; });
byId('view').addEventListener('pointerup', (event) => {
  if (!pressed || !view || before || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
  const row = scene.rowOfEdge.get(view.edgeAt(event.offsetX, event.offsetY));
  if (row !== undefined) table.show(row, event.ctrlKey || event.metaKey || event.shiftKey);
});

const KEYS = {
  z: () => useMode('zebra'), c: () => useMode('curvature'), s: () => useMode('shaded'),
  h: () => byId('combs').click(), m: () => byId('markers').click(),
  n: () => !byId('fresh').hidden && byId('fresh').click(), b: () => !byId('before').hidden && byId('before').click(),
  x: () => { byId('section').value = byId('section').value === '' ? 'x' : ''; useSection(); },
  d: () => { byId('deviation').value = byId('deviation').value === '' ? 'angle' : ''; useDeviation(); },
  '/': () => table.find.focus(), o: () => nextHole(),
  f: () => byId('fit').click(), t: () => byId('theme').click(), '?': () => byId('help').click(),
  Escape: () => table.clear(),
};
document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  const boxes = document.querySelectorAll('#legend input');
  if (/^[1-8]$/.test(event.key)) boxes[Number(event.key) - 1]?.click();
  else if (KEYS[event.key]) { event.preventDefault(); KEYS[event.key](); }
});
function nextHole() {
  if (holes.length > 0) holeTable.onPick((holeTable.current + 1) % holes.length);
}
window.addEventListener('beforeprint', () => { view?.draw(); table.print(true); });
window.addEventListener('afterprint', () => table.print(false));

// ---- what the address asks for

useTheme(wishes.get('theme'));
useMode(wishes.get('shade') || 'shaded');
if (wishes.get('before') === '1') byId('before').click();
if (wishes.get('edges') === '0') { shown.clear(); applyShown(); view?.setMarkersShown(false); }
const wanted = wishes.get('view');
if (view && !wanted && !picture) lookAtWork();
if (view && wanted) {
  const row = wanted === 'worst' ? 0 : scene.rowOfEdge.get(Number(wanted.replace(/^edge/, '')));
  if (/^(worst|edge\d+)$/.test(wanted)) {
    if (row !== undefined && row < scene.rows) {
      table.show(row, false);
      view.lookAtEdge(row, true);
    }
  } else if (wanted.includes(',')) view.look(wanted.split(',').map(Number));
  else view.look(wanted);
}
/** What the page is about: the new faces, or the holes. */
function lookAtWork() {
  const fresh = view.newPoints();
  const open = holes.filter((hole) => hole.status === 'hole');
  const listed = open.length > 0 ? open : holes;
  if (fresh.length > 0) view.lookAtPoints(fresh, view.home(), true);
  else if (listed.length === 1) view.lookAtPoints(listed[0].points, listed[0].out, true);
  else if (listed.length > 0) view.lookAtPoints(listed.flatMap((hole) => hole.points), listed[0].out, true);
}
view?.start();
document.documentElement.dataset.ready = Math.round(performance.now());
window.sutureReport = { scene, view, table, holes, holeTable }; // for the console, and for tests
