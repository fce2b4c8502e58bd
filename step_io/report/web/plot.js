// Drawings in SVG: the course of an edge's figures along it, and the histogram of all angles.
import { short } from './scene.js';

const NS = 'http://www.w3.org/2000/svg';
const WIDTH = 460;
const LEFT = 58;
const RIGHT = 10;

function element(name, attributes, text) {
  const node = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  return node;
}

/** What nearly all values stay below, with room above: a singular point of 1e15 flattens no plot. */
export function robustTop(values) {
  const sorted = values.filter((value) => value > 0).sort((a, b) => a - b);
  if (sorted.length === 0) return 0;
  const usual = sorted[Math.floor(0.8 * (sorted.length - 1))];
  const top = sorted[sorted.length - 1];
  return top > 20 * usual ? 3 * usual : top;
}

const x = (along) => LEFT + along * (WIDTH - LEFT - RIGHT);

/** One figure along the edge: its curves, an axis with two ticks, and the limit if it is near. */
function panel(svg, top, height, title, unit, trace, curves, limit) {
  const values = curves.flatMap((curve) => trace.map(curve.value)).filter(Number.isFinite);
  const [least, most] = [Math.min(0, ...values), Math.max(0, ...values)];
  let low = Math.max(least, -robustTop(values.map((value) => -value)));
  let high = Math.min(most, robustTop(values));
  const clipped = low > least || high < most;
  if (limit && high < 4 * limit) high = Math.max(high, 1.15 * limit);
  if (high < -1e-6 * low) high = 0; // rounding noise
  if (low > -1e-6 * high) low = 0;
  if (high === low) high = low + 1;
  const y = (value) => top + height - ((Math.min(Math.max(value, low), high) - low) / (high - low)) * height;
  if (clipped) {
    const worst = most - high > low - least ? most : least;
    svg.append(element('text', { x: WIDTH - RIGHT, y: top - 7, class: 'label clipped', 'text-anchor': 'end' }, `cut off: reaches ${short(worst)}`));
  }
  svg.append(element('text', { x: LEFT, y: top - 7, class: 'title' }, `${title}${unit ? ` [${unit}]` : ''}`));
  svg.append(element('rect', { x: LEFT, y: top, width: WIDTH - LEFT - RIGHT, height, class: 'frame' }));
  for (const tick of new Set([low, 0, high])) {
    svg.append(element('line', { x1: LEFT, x2: WIDTH - RIGHT, y1: y(tick), y2: y(tick), class: 'tick' }));
    svg.append(element('text', { x: LEFT - 5, y: y(tick) + 4, class: 'label', 'text-anchor': 'end' }, short(tick)));
  }
  if (limit && limit < high) {
    svg.append(element('line', { x1: LEFT, x2: WIDTH - RIGHT, y1: y(limit), y2: y(limit), class: 'limit' }));
    svg.append(element('text', { x: WIDTH - RIGHT - 4, y: y(limit) - 4, class: 'label', 'text-anchor': 'end' }, `limit ${short(limit)}`));
  }
  for (const curve of curves) {
    let path = '';
    let pen = 'M';
    for (const p of trace) {
      const value = curve.value(p);
      if (!Number.isFinite(value)) { pen = 'M'; continue; }
      path += `${pen}${x(p.along).toFixed(2)} ${y(value).toFixed(2)}`;
      pen = 'L';
    }
    svg.append(element('path', { d: path, class: `curve ${curve.className}` }));
  }
}

/** The plot of an edge; onPoint is told which point of its course the pointer is over. */
export function plotEdge(root, scene, row, onPoint) {
  const trace = row >= 0 ? scene.trace(row) : [];
  if (trace.length === 0) {
    root.replaceChildren(Object.assign(document.createElement('p'), {
      className: 'hint',
      textContent: row < 0 ? 'Select an edge in the view or in the table to see its course.'
        : `Edge ${scene.edge(row)} is not among the edges whose course is in this report.`,
    }));
    return;
  }
  const svg = element('svg', { viewBox: `0 0 ${WIDTH} 318`, role: 'img', class: 'plot' });
  const [one, two] = scene.faces(row);
  svg.append(element('title', {}, `Edge ${scene.edge(row)}: angle, gap and curvature along it`));
  panel(svg, 24, 68, 'angle', '°', trace, [{ value: (p) => p.angle, className: 'main' }], scene.limits.g1);
  panel(svg, 122, 50, 'gap', 'mm', trace, [{ value: (p) => p.gap, className: 'main' }], scene.limits.g0);
  panel(svg, 202, 86, 'curvature across', '1/mm', trace, [
    { value: (p) => p.curvature[0], className: 'one' },
    { value: (p) => p.curvature[1], className: 'two' },
  ]);
  svg.append(element('text', { x: 205, y: 195, class: 'label one' }, `— face ${one}`));
  svg.append(element('text', { x: 275, y: 195, class: 'label two' }, `- - face ${two}`));
  svg.append(element('text', { x: LEFT, y: 306, class: 'label' }, '0'));
  svg.append(element('text', { x: WIDTH - RIGHT, y: 306, class: 'label', 'text-anchor': 'end' }, `${short(scene.length[row])} mm`));
  const cursor = element('line', { x1: -9, x2: -9, y1: 22, y2: 288, class: 'cursor' });
  svg.append(cursor);
  const heading = Object.assign(document.createElement('h3'), { textContent: `Edge ${scene.edge(row)} between faces ${one} and ${two}` });
  const reading = Object.assign(document.createElement('p'), { className: 'reading', textContent: scene.remark(row) || ' ' });
  svg.addEventListener('pointermove', (event) => {
    const box = svg.getBoundingClientRect();
    const along = ((event.clientX - box.left) / box.width * WIDTH - LEFT) / (WIDTH - LEFT - RIGHT);
    const p = trace.reduce((a, b) => (Math.abs(b.along - along) < Math.abs(a.along - along) ? b : a));
    cursor.setAttribute('x1', x(p.along));
    cursor.setAttribute('x2', x(p.along));
    reading.textContent = `at ${(100 * p.along).toFixed(0)} %: ${short(p.angle)}°, gap ${short(p.gap)} mm, curvature ${short(p.curvature[0])} and ${short(p.curvature[1])} /mm`;
    onPoint(p.point);
  });
  svg.addEventListener('pointerleave', () => { cursor.setAttribute('x1', -9); cursor.setAttribute('x2', -9); onPoint(null); });
  root.replaceChildren(heading, svg, reading);
}

/** How many edges have which angle, by powers of ten; the limits as lines. */
export function plotHistogram(root, scene) {
  const low = -6;
  const high = Math.log10(180);
  const bins = 33;
  const kinds = ['sharp', 'G3', 'G2', 'G1', 'near'];
  const counts = Array.from({ length: bins }, () => Object.fromEntries(kinds.map((kind) => [kind, 0])));
  for (let row = 0; row < scene.rows; ++row) {
    const kind = scene.category(row);
    if (!kinds.includes(kind)) continue;
    const s = (Math.log10(Math.max(scene.angle[row], 1e-6)) - low) / (high - low);
    counts[Math.min(bins - 1, Math.floor(s * bins))][kind] += 1;
  }
  const most = Math.max(1, ...counts.map((bin) => Object.values(bin).reduce((a, b) => a + b)));
  const width = WIDTH - 20;
  const height = 74;
  const place = (degree) => 10 + ((Math.log10(degree) - low) / (high - low)) * width;
  const svg = element('svg', { viewBox: `0 0 ${WIDTH} 112`, role: 'img', class: 'histogram' });
  svg.append(element('title', {}, 'How many edges meet at which angle'));
  counts.forEach((bin, i) => {
    let top = 12 + height;
    for (const kind of kinds) {
      // Heights by the square root: one bad edge among a thousand good ones is to be seen.
      if (bin[kind] === 0) continue;
      const size = (height * Math.sqrt(bin[kind] / most)) / Object.values(bin).filter((n) => n > 0).length;
      top -= size;
      const bar = element('rect', { x: 10 + (i * width) / bins, y: top, width: width / bins - 1, height: size, class: `bar ${kind}` });
      bar.append(element('title', {}, `${bin[kind]} ${kind}`));
      svg.append(bar);
    }
  });
  svg.append(element('line', { x1: 10, x2: 10 + width, y1: 12 + height, y2: 12 + height, class: 'tick' }));
  for (const [degree, text] of [[1e-6, '≤ 0.000001°'], [1e-4, '0.0001°'], [1e-2, '0.01°'], [1, '1°'], [90, '90°']]) {
    svg.append(element('text', { x: place(degree), y: 101, class: 'label', 'text-anchor': degree === 1e-6 ? 'start' : 'middle' }, text));
  }
  for (const limit of [scene.limits.g1, scene.limits.sharp]) {
    svg.append(element('line', { x1: place(limit), x2: place(limit), y1: 8, y2: 12 + height, class: 'limit' }));
  }
  root.replaceChildren(svg);
}
