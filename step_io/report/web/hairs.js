// Hairs that stand on edges: combs of curvature, and how far an edge is from its limit.
import { short } from './scene.js';

/** Hedgehog combs of selected edges: along the outward normal, as long as the curvature across the
 *  edge is large; against it where the face is convex. One list of segments for each side.
 *
 *  A point that is singular, with a curvature of 1e15 say, is left out: it would hide all others. */
export function combs(scene, rows, size, scale) {
  const traces = rows.map((row) => scene.trace(row));
  const sizes = traces.flatMap((trace) => trace.flatMap((p) => p.curvature.map(Math.abs)))
    .filter((k) => Number.isFinite(k) && k > 0).sort((a, b) => a - b);
  if (sizes.length === 0) return [[], []];
  const usual = sizes[Math.floor(0.8 * (sizes.length - 1))];
  const largest = Math.min(sizes[sizes.length - 1], 20 * usual);
  const length = Math.max(...rows.map((row) => scene.length[row]));
  const factor = scale * 0.35 * Math.min(length, size / 4) / largest;
  return [0, 1].map((side) => segments(traces, (p) => {
    const k = p.curvature[side];
    return Math.abs(k) <= largest ? Array.from(p.point, (x, i) => x - factor * k * p.normal[side][i]) : null;
  }));
}

/** How far edges are from a limit, angle or gap: hairs along the mean normal, three times the limit
 *  and more at full length; those within the limit apart from those beyond it. The worst place of
 *  each edge, the worst edge first, with its figure. */
export function deviation(scene, rows, measure, length) {
  const limit = measure === 'gap' ? scene.limits.g0 : scene.limits.g1;
  const within = [];
  const beyond = [];
  const worst = [];
  for (const row of rows) {
    const trace = scene.trace(row);
    let top = null;
    for (const p of trace) if (Number.isFinite(p[measure]) && (!top || p[measure] > top[measure])) top = p;
    if (!top) continue;
    const tip = (p) => {
      const n = [0, 1, 2].map((i) => p.normal[0][i] + p.normal[1][i]);
      const unit = Math.hypot(...n) || 1;
      const part = Math.min(1, p[measure] / (3 * limit));
      return n.every(Number.isFinite) ? Array.from(p.point, (x, i) => x + (length * part * n[i]) / unit) : null;
    };
    within.push(...segments([trace], (p) => (p[measure] <= limit ? tip(p) : null)));
    beyond.push(...segments([trace], (p) => (p[measure] > limit ? tip(p) : null)));
    worst.push({ row, at: tip(top) ?? top.point, value: top[measure], text: `${short(top[measure])}${measure === 'gap' ? ' mm' : '°'}`, bad: top[measure] > limit });
  }
  worst.sort((a, b) => b.value - a.value);
  return { within, beyond, worst };
}

/** From each point to its tip, and from tip to tip. */
function segments(traces, tipOf) {
  const positions = [];
  for (const trace of traces) {
    let before = null;
    for (const p of trace) {
      const tip = tipOf(p);
      if (!tip || !tip.every(Number.isFinite)) { before = null; continue; }
      positions.push(...p.point, ...tip);
      if (before) positions.push(...before, ...tip);
      before = tip;
    }
  }
  return positions;
}
