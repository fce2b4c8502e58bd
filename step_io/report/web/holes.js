// The holes: where they are, their numbers in the view, and their table.
import { short } from './scene.js';

/** Place, size and the direction to look from of every hole, from the courses of its edges. */
export function placeHoles(scene) {
  const model = scene.models[scene.models.length - 1]; // a fill's edges are those of the model before
  return scene.holes.map((hole) => {
    const lines = model ? hole.edges.map((edge) => polyline(model, edge)).filter((line) => line.length > 1) : [];
    const points = chain(lines);
    const low = [0, 1, 2].map((i) => Math.min(...points.map((p) => p[i])));
    const high = [0, 1, 2].map((i) => Math.max(...points.map((p) => p[i])));
    const centre = low.map((x, i) => (x + high[i]) / 2);
    return { ...hole, lines, points, centre, diameter: Math.hypot(...high.map((x, i) => x - low[i])), out: outward(points, centre, model, normalOfNeighbours(hole, model)) };
  });
}

function polyline(model, edge) {
  const line = [];
  for (let i = model.edgeFirst[edge - 1]; i < model.edgeFirst[edge]; ++i) {
    line.push(Array.from(model.edgePoints.subarray(3 * i, 3 * i + 3)));
  }
  return line;
}

const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);

/** The edges' points one after another, each edge turned so that it begins where the last one ends. */
function chain(lines) {
  const points = [];
  lines.forEach((line, i) => {
    const next = lines[i + 1];
    const end = points.length > 0 ? points[points.length - 1] : null;
    const turned = end ? distance(end, line[line.length - 1]) < distance(end, line[0])
      : next ? Math.min(distance(line[0], next[0]), distance(line[0], next[next.length - 1]))
        < Math.min(distance(line[line.length - 1], next[0]), distance(line[line.length - 1], next[next.length - 1])) : false;
    points.push(...(turned ? [...line].reverse() : line));
  });
  return points;
}

/** The sum of the neighbours' normals where they meet the hole, each in the middle of a side. */
function normalOfNeighbours(hole, model) {
  const sum = [0, 0, 0];
  hole.edges.forEach((edge, side) => {
    const line = model ? polyline(model, edge) : [];
    const middle = line[Math.floor(line.length / 2)];
    const face = hole.faces[side];
    let [nearest, found] = [Infinity, -1];
    for (let i = 3 * model?.first[face - 1]; middle && i < 3 * model.first[face]; ++i) {
      const at = 3 * model.corners[i];
      const d = distance(middle, model.points.subarray(at, at + 3));
      if (d < nearest) [nearest, found] = [d, at];
    }
    if (found >= 0) for (let i = 0; i < 3; ++i) sum[i] += model.normals[found + i];
  });
  return sum.map((x) => x / Math.max(hole.edges.length, 1));
}

/** The normal of the loop's area, to the side to which the neighbours look; where they stand upright
 *  on it, away from the middle of the model. */
function outward(points, centre, model, neighbours) {
  const area = [0, 0, 0];
  points.forEach((p, k) => {
    const q = points[(k + 1) % points.length];
    for (let i = 0; i < 3; ++i) {
      const [a, b] = [(i + 1) % 3, (i + 2) % 3];
      area[i] += (p[a] - centre[a]) * (q[b] - centre[b]) - (p[b] - centre[b]) * (q[a] - centre[a]);
    }
  });
  const size = Math.hypot(...area);
  if (!(size > 0)) return null;
  const along = area.reduce((sum, x, i) => sum + (x * neighbours[i]) / size, 0);
  if (Math.abs(along) > 0.1) return area.map((x) => (Math.sign(along) * x) / size);
  const middle = [0, 1, 2].map((i) => {
    let [low, high] = [Infinity, -Infinity];
    for (let k = i; k < model.points.length; k += 3) { low = Math.min(low, model.points[k]); high = Math.max(high, model.points[k]); }
    return (low + high) / 2;
  });
  const side = area.reduce((sum, x, i) => sum + x * (centre[i] - middle[i]), 0) < 0 ? -1 : 1;
  return area.map((x) => (side * x) / size);
}

/** "1, 2, 5-9" */
function ranges(numbers) {
  const sorted = [...new Set(numbers)].sort((a, b) => a - b);
  const parts = [];
  for (let i = 0; i < sorted.length;) {
    let j = i;
    while (sorted[j + 1] === sorted[j] + 1) ++j;
    parts.push(j > i ? `${sorted[i]}-${sorted[j]}` : `${sorted[i]}`);
    i = j + 1;
  }
  return parts.join(', ');
}

/** The table of holes. onPick gets the index of a hole. */
export class HoleTable {
  constructor(root, holes, onPick) {
    this.root = root;
    this.current = -1;
    this.onPick = onPick;
    root.hidden = holes.length === 0;
    root.innerHTML = '<h3>Holes</h3><div class="scroll" tabindex="0" role="region" aria-label="Holes"><table><thead><tr>'
      + ['hole', 'is', 'sides', 'size [mm]', 'at', 'edges', 'neighbours', ''].map((title) => `<th scope="col">${title}</th>`).join('')
      + '</tr></thead><tbody></tbody></table></div>';
    this.lines = holes.map((hole, index) => {
      const line = document.createElement('tr');
      line.dataset.hole = hole.id;
      const texts = [null, hole.status, hole.edges.length, short(hole.diameter), hole.centre.map(short).join('  '), ranges(hole.edges), ranges(hole.faces), hole.text];
      const cells = texts.map((text) => Object.assign(document.createElement('td'), { textContent: text ?? '', title: String(text ?? '') }));
      const button = Object.assign(document.createElement('button'), { type: 'button', textContent: hole.id, ariaLabel: `Look at hole ${hole.id}` });
      cells[0].title = '';
      cells[0].append(button);
      line.append(...cells);
      line.addEventListener('click', () => onPick(index));
      return line;
    });
    root.querySelector('tbody').append(...this.lines);
  }

  mark(index) {
    this.current = index;
    this.lines.forEach((line, i) => { line.ariaSelected = String(i === index); });
    this.lines[index]?.scrollIntoView({ block: 'nearest' });
  }
}
