// Panels beside the view: the limits, and the tree of parts.
import { decode } from './scene.js';

const LIMITS = [
  { key: 'g0', label: 'gap', unit: 'mm' },
  { key: 'g1', label: 'angle', unit: '°' },
  { key: 'g2', label: 'curvature', unit: '%' },
  { key: 'sharp', label: 'sharp from', unit: '°' },
];

/** Fields for the limits. apply gets all of them, whenever one has changed. */
export function makeLimits(root, scene, apply) {
  const fields = LIMITS.map(({ key, label, unit }) => {
    const entry = document.createElement('label');
    const input = Object.assign(document.createElement('input'), { type: 'number', min: '0', step: 'any', name: key, value: String(Number(scene.limits[key].toPrecision(6))) });
    entry.append(`${label} `, input, ` ${unit}`);
    return { entry, input, key };
  });
  const reset = Object.assign(document.createElement('button'), { type: 'reset', textContent: 'As measured' });
  root.append(...fields.map(({ entry }) => entry), reset);
  const read = () => {
    const limits = { ...scene.limits };
    for (const { key, input } of fields) {
      const value = Number(input.value);
      input.setAttribute('aria-invalid', String(!(value > 0)));
      if (!(value > 0)) return;
      // What stands there unchanged is the limit itself, with all its digits.
      limits[key] = input.value === input.defaultValue ? scene.asGiven[key] : value;
    }
    apply(limits);
  };
  for (const { input } of fields) {
    input.defaultValue = input.value;
    input.addEventListener('change', read);
  }
  root.addEventListener('submit', (event) => { event.preventDefault(); read(); });
  root.addEventListener('reset', () => setTimeout(read));
}

/** The tree of parts, with a box for each. apply gets the faces and edges that are hidden. */
export function makeParts(root, scene, apply) {
  const parts = scene.parts.map((part) => ({ ...part, faces: decode(part.faces, Uint32Array), edges: decode(part.edges, Uint32Array) }));
  if (parts.length < 2) return;
  root.parentElement.hidden = false;
  const boxes = parts.map((part, index) => {
    const entry = document.createElement('label');
    entry.style.paddingLeft = `${1.1 * part.depth}rem`;
    const box = Object.assign(document.createElement('input'), { type: 'checkbox', checked: true });
    entry.append(box, ` ${part.name || `part ${index + 1}`}`);
    root.append(entry);
    box.addEventListener('change', () => {
      for (let i = index + 1; i < parts.length && parts[i].depth > part.depth; ++i) boxes[i].checked = box.checked;
      const hidden = (kind) => {
        const seen = new Set(parts.flatMap((p, i) => (boxes[i].checked ? Array.from(p[kind]) : [])));
        return new Set(parts.flatMap((p) => Array.from(p[kind]).filter((number) => !seen.has(number))));
      };
      apply(hidden('faces'), hidden('edges'));
    });
    return box;
  });
}
