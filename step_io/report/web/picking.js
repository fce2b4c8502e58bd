// Which of the edges that are shown is under the pointer.
import * as THREE from 'three';

const PICK_PIXELS = 9;

/** The shown edge nearest to a point of the canvas, or 0. */
export function edgeAt(view, x, y) {
  const { width, height } = view.canvas.getBoundingClientRect();
  const matrix = new THREE.Matrix4().multiplyMatrices(view.camera.projectionMatrix, view.camera.matrixWorldInverse);
  const { edgePoints, edgeFirst } = view.data.models[0];
  const p = new THREE.Vector4();
  let best = 0;
  let nearest = PICK_PIXELS;
  let depth = Infinity;
  for (const lines of Object.values(view.lines)) {
    if (!lines.visible) continue;
    for (const edge of lines.userData.edges) {
      if (view.hiddenEdges.has(edge)) continue;
      let before = null;
      for (let i = edgeFirst[edge - 1]; i < edgeFirst[edge]; ++i) {
        p.set(edgePoints[3 * i], edgePoints[3 * i + 1], edgePoints[3 * i + 2], 1);
        const cut = view.isCut(p);
        p.applyMatrix4(matrix);
        const now = p.w > 0 && !cut ? [(0.5 + (0.5 * p.x) / p.w) * width, (0.5 - (0.5 * p.y) / p.w) * height, p.w] : null;
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

function segmentDistance(x, y, a, b) {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const s = Math.max(0, Math.min(1, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - a[0] - s * dx, y - a[1] - s * dy);
}
