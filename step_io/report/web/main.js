// The page: puts view, table and plot together, and obeys buttons, keys and the address.
import { CATEGORIES, Scene, short } from './scene.js';
import { View } from './view.js';
import { EdgeTable } from './table.js';
import { plotEdge, plotHistogram } from './plot.js';

const byId = (id) => document.getElementById(id);
const scene = new Scene(JSON.parse(byId('suture-scene').textContent));
byId('suture-scene').remove(); // its text is no longer needed
const wishes = new URLSearchParams(location.hash.slice(1));
const picture = wishes.has('picture');
document.documentElement.classList.toggle('picture', picture);
document.documentElement.classList.add('live');
document.body.insertAdjacentHTML('beforeend', `
<div id="app">
  <section id="stage" aria-label="The model in 3D"><canvas id="view" tabindex="0" aria-label="3D view: drag to turn, wheel to zoom, click an edge to select it"></canvas>
    <div id="legend" role="group" aria-label="Edges shown"></div>
    <div id="scale" hidden></div><p id="message" role="alert" hidden></p></section>
  <div id="toolbar" role="toolbar" aria-label="View">
    <span class="group" role="radiogroup" aria-label="Faces">
      <button data-mode="shaded" role="radio">Shaded</button><button data-mode="zebra" role="radio" title="Z">Zebra</button><button data-mode="curvature" role="radio" title="C">Curvature</button></span>
    <label id="stripes-label" hidden>stripes <input id="stripes" type="range" min="4" max="60" value="16"></label>
    <label id="measure-label" hidden><select id="measure" aria-label="Which curvature"><option value="mean">mean</option><option value="gauss">Gauss (signed root)</option><option value="largest">largest</option></select></label>
    <label id="range-label" hidden>range <input id="range" type="range" min="-2" max="2" step="0.05" value="0"></label>
    <button id="combs" aria-pressed="true" title="H">Combs</button><label>size <input id="comb-size" type="range" min="-2" max="2" step="0.1" value="0"></label>
    <button id="markers" aria-pressed="true" title="M">Worst points</button>
    <button id="fresh" aria-pressed="true" title="N" hidden>New faces</button>
    <button id="before" aria-pressed="false" title="B" hidden>Before</button>
    <select id="look" aria-label="Look from"><option value="iso">Look from…</option><option>front</option><option>back</option><option>left</option><option>right</option><option>top</option><option>bottom</option><option>iso</option></select>
    <button id="fit" title="F">Fit</button><button id="theme" title="T">Light / dark</button><button id="help" title="?">Keys</button>
  </div>
  <aside id="side"><div id="plot"></div><h3>Angles of all edges</h3><div id="histogram"></div><h3>Summary</h3><dl id="summary"></dl></aside>
  <section id="table" aria-label="Table of edges"></section>
</div>
<dialog id="keys"><h3>Keys</h3><dl><dt>Z, C, S</dt><dd>zebra, curvature, shaded</dd><dt>H, M</dt><dd>combs, worst points</dd><dt>N, B</dt><dd>new faces, before and after</dd><dt>1 to 8</dt><dd>classes of edges, in the legend's order</dd><dt>↑ ↓</dt><dd>next edge in the table; with Shift add it</dd><dt>F, Esc</dt><dd>see all, select nothing</dd><dt>T</dt><dd>light or dark</dd></dl><form method="dialog"><button>Close</button></form></dialog>`);
byId('report').before(byId('app'));

// ---- look

const style = () => getComputedStyle(document.documentElement);
const colours = Object.fromEntries(CATEGORIES.map(({ key }) => [key, style().getPropertyValue(`--${key}`).trim()]));
const lists = scene.byCategory();
const shown = new Set(CATEGORIES.map(({ key }) => key));
let before = false;
let view = null;
try {
  view = new View(byId('view'), scene, colours);
} catch (error) {
  byId('message').hidden = false;
  byId('message').textContent = `This browser shows no 3D (${error.message}). The table and the plots work all the same.`;
}

function useTheme(theme) {
  if (theme) document.documentElement.dataset.theme = theme;
  view?.setBackground(picture ? '#ffffff' : style().getPropertyValue('--stage').trim());
  view?.setSharpColour(style().getPropertyValue('--sharp').trim());
}
function dark() {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}

// ---- legend and filters

function makeLegend() {
  byId('legend').replaceChildren(...CATEGORIES.filter(({ key }) => lists[key].length > 0).map(({ key, label, hint }) => {
    const entry = document.createElement('label');
    entry.title = hint;
    entry.innerHTML = `<input type="checkbox" checked data-category="${key}"><span class="swatch ${key}"></span>${label} <b>${lists[key].length}</b>`;
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
}
function useRange() {
  if (!view) return;
  const range = view.range * 10 ** Number(byId('range').value);
  view.material.uniforms.range.value = range;
  view.invalidate();
  byId('scale').innerHTML = `<span>−${short(range)}</span><i></i><span>+${short(range)} /mm</span>`;
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
  view?.point(null);
  plotEdge(byId('plot'), scene, current, (at) => view?.point(at));
});
function makeSummary() {
  const { profile } = scene;
  let gap = 0;
  let angle = 0;
  for (let row = 0; row < scene.rows; ++row) {
    gap = Math.max(gap, scene.gap[row]);
    if (scene.className(row) !== 'sharp') angle = Math.max(angle, scene.angle[row]);
  }
  const entries = [
    ['limits', `${profile.name}: ${short(profile.g0_mm)} mm, ${short(profile.g1_deg)}°, ${short(profile.g2_percent)} % (of the ${profile.g2_by}), G3 ${short(profile.g3_deg)}°, sharp from ${short(profile.sharp_deg)}°`],
    ['edges', `${scene.rows} between two faces: ${CATEGORIES.filter(({ key }) => lists[key].length > 0).map(({ key, label }) => `${lists[key].length} ${label}`).join(', ')}`],
    ['largest', `gap ${short(gap)} mm, angle of edges that are not sharp ${short(angle)}°`],
    ['inside faces', `${scene.knots.length} knot lines of no more than C1, ${scene.knots.filter((knot) => knot.near).length} near misses`],
  ];
  byId('summary').replaceChildren(...entries.flatMap(([term, text]) => [
    Object.assign(document.createElement('dt'), { textContent: term }),
    Object.assign(document.createElement('dd'), { textContent: text })]));
}
makeLegend();
makeSummary();
plotEdge(byId('plot'), scene, -1);
plotHistogram(byId('histogram'), scene);
view?.setCombsShown(true);

for (const button of document.querySelectorAll('[data-mode]')) {
  button.addEventListener('click', () => useMode(button.dataset.mode));
}
byId('stripes').addEventListener('input', (event) => view?.setStripes(Number(event.target.value)));
byId('measure').addEventListener('change', (event) => view?.setMeasure(event.target.value));
byId('range').addEventListener('input', useRange);
byId('comb-size').addEventListener('input', (event) => view?.setCombScale(10 ** Number(event.target.value)));
toggle('combs', (on) => view?.setCombsShown(on));
toggle('markers', (on) => view?.setMarkersShown(on));
toggle('fresh', (on) => view?.setFreshShown(on));
toggle('before', (on) => {
  before = on;
  byId('before').textContent = on ? 'Before' : 'After';
  applyShown();
});
byId('fresh').hidden = scene.newFaces.size === 0;
byId('before').hidden = scene.models.length < 2;
byId('before').textContent = 'After';
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
  f: () => byId('fit').click(), t: () => byId('theme').click(), '?': () => byId('help').click(),
  Escape: () => table.clear(),
};
document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  const boxes = document.querySelectorAll('#legend input');
  if (/^[1-8]$/.test(event.key)) boxes[Number(event.key) - 1]?.click();
  else KEYS[event.key]?.();
});
window.addEventListener('beforeprint', () => table.fill(true));
window.addEventListener('afterprint', () => table.fill());

// ---- what the address asks for

useTheme(wishes.get('theme'));
useMode(wishes.get('shade') || 'shaded');
useRange();
if (wishes.get('before') === '1') byId('before').click();
if (wishes.get('edges') === '0') { shown.clear(); applyShown(); view?.setMarkersShown(false); }
const wanted = wishes.get('view');
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
view?.start();
document.documentElement.dataset.ready = Math.round(performance.now());
window.sutureReport = { scene, view, table }; // for the console, and for tests
