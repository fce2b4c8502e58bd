// The table of edges: sortable, filtered, and only the rows in sight are in the page.
import { short } from './scene.js';

const ROW = 28; // pixels; style.css says the same
const PRINTED = 120; // rows on paper: the worst, some four pages

/** What the bar above the table can ask for. */
const KINDS = [
  { key: 'all', label: 'all edges' },
  { key: 'new', label: 'of new faces', test: (scene, row) => scene.isNew(row) },
  { key: 'failing', label: 'near misses', test: (scene, row) => scene.near[row] > 0 },
  { key: 'tangent', label: 'G1 and better', test: (scene, row) => ['G1', 'G2', 'G3'].includes(scene.className(row)) },
  { key: 'sharp', label: 'sharp', test: (scene, row) => scene.className(row) === 'sharp' },
];

export class EdgeTable {
  constructor(root, scene, onSelect) {
    this.root = root;
    this.data = scene;
    this.onSelect = onSelect;
    this.columns = [
      { title: 'edge', number: true, value: (r) => scene.edge(r), text: (r) => scene.edge(r) },
      { title: 'faces', value: (r) => scene.faces(r)[0], text: (r) => scene.faces(r).join(', ') },
      { title: 'class', value: (r) => scene.classes[r], text: (r) => scene.className(r), badge: true },
      { title: 'gap [mm]', number: true, value: (r) => scene.gap[r], text: (r) => short(scene.gap[r]) },
      { title: 'angle [°]', number: true, value: (r) => scene.angle[r], text: (r) => short(scene.angle[r]) },
      { title: 'curvature [%]', number: true, value: (r) => scene.mismatch(r), text: (r) => short(scene.mismatch(r)) + (scene.opposite[r] ? ' ⇅' : '') },
      { title: 'G3 [°]', number: true, value: (r) => scene.g3[r], text: (r) => short(scene.g3[r]) },
      { title: 'length [mm]', number: true, value: (r) => scene.length[r], text: (r) => short(scene.length[r]) },
      { title: 'remark', value: (r) => scene.remark(r), text: (r) => scene.remark(r) },
    ];
    this.order = Array.from({ length: scene.rows }, (_, i) => i); // the worst first
    this.shown = this.order;
    this.selected = new Set();
    this.current = -1;
    this.build();
    this.fill();
  }

  build() {
    this.root.innerHTML = '<div class="bar"><h3>Edges</h3><label>show <select class="which" aria-label="Which edges">'
      + KINDS.map(({ key, label }) => `<option value="${key}">${label}</option>`).join('') + '</select></label>'
      + '<label>find <input class="find" type="search" placeholder="edge, face, word" aria-label="Find edges: by number, f and a face\'s number, or a word of the remark"></label><p class="count" aria-live="polite"></p></div>'
      + '<div class="scroll" tabindex="0" role="region" aria-label="Edges"><table>'
      + '<thead><tr></tr></thead><tbody></tbody></table></div>';
    this.which = this.root.querySelector('.which');
    this.find = this.root.querySelector('.find');
    this.which.addEventListener('change', () => this.filter(this.accepts));
    this.find.addEventListener('input', () => this.filter(this.accepts));
    this.scroll = this.root.querySelector('.scroll');
    this.body = this.root.querySelector('tbody');
    this.count = this.root.querySelector('.count');
    const head = this.root.querySelector('thead tr');
    for (const column of this.columns) {
      const cell = document.createElement('th');
      cell.scope = 'col';
      cell.className = column.number ? 'n' : '';
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = column.title;
      button.addEventListener('click', () => this.sort(column, cell));
      cell.append(button);
      head.append(cell);
    }
    this.scroll.addEventListener('scroll', () => this.fill());
    this.scroll.addEventListener('keydown', (event) => this.key(event));
    this.body.addEventListener('click', (event) => {
      const row = event.target.closest('tr[data-row]');
      if (row) this.pick(Number(row.dataset.row), event.ctrlKey || event.metaKey || event.shiftKey);
    });
    new ResizeObserver(() => this.fill()).observe(this.scroll);
  }

  sort(column, cell) {
    const falling = cell.ariaSort !== 'descending';
    for (const other of this.root.querySelectorAll('th')) other.removeAttribute('aria-sort');
    cell.ariaSort = falling ? 'descending' : 'ascending';
    const sign = falling ? -1 : 1;
    const rank = (value) => (Number.isNaN(value) ? -Infinity : value);
    this.order = Array.from({ length: this.data.rows }, (_, i) => i).sort((a, b) => {
      const [x, y] = [rank(column.value(a)), rank(column.value(b))];
      return x < y ? -sign : x > y ? sign : a - b;
    });
    this.filter(this.accepts);
  }

  /** Shows only the rows that a test accepts, and that the bar above the table asks for. */
  filter(accepts) {
    this.accepts = accepts;
    const kind = KINDS.find(({ key }) => key === this.which.value).test;
    const word = this.find.value.trim().toLowerCase();
    this.shown = this.order.filter((row) => (!accepts || accepts(row)) && (!kind || kind(this.data, row)) && (!word || this.matches(row, word)));
    this.fill();
  }

  /** "12" is edge 12, "f7" an edge of face 7; any other word is looked for in class and remark. */
  matches(row, word) {
    if (/^\d+$/.test(word)) return this.data.edge(row) === Number(word);
    if (/^f\d+$/.test(word)) return this.data.faces(row).includes(Number(word.slice(1)));
    return `${this.data.category(row)} ${this.data.className(row)} ${this.data.remark(row)}`.toLowerCase().includes(word);
  }

  /** Shows edges of one kind: all, new, near, ... */
  ask(kind) {
    this.which.value = kind;
    this.filter(this.accepts);
  }

  /** After the limits have changed: the worst first again. */
  reorder() {
    const group = (row) => (this.data.near[row] === 2 ? 0 : this.data.near[row] === 1 ? 1 : this.data.className(row) === 'sharp' ? 3 : 2);
    for (const other of this.root.querySelectorAll('th')) other.removeAttribute('aria-sort');
    this.order = Array.from({ length: this.data.rows }, (_, i) => i)
      .sort((a, b) => group(a) - group(b) || this.data.excess(b) - this.data.excess(a) || a - b);
    this.filter(this.accepts);
  }

  /** While it is printed, as many as paper takes, whatever the size of the window. */
  print(printing) {
    this.printing = printing;
    this.fill();
  }

  fill() {
    const all = this.printing;
    const height = this.scroll.clientHeight || 300;
    const from = all ? 0 : Math.max(0, Math.floor(this.scroll.scrollTop / ROW) - 8);
    const to = all ? Math.min(this.shown.length, PRINTED)
      : Math.min(this.shown.length, Math.ceil((this.scroll.scrollTop + height) / ROW) + 8);
    const rows = [spacer(from)];
    for (let i = from; i < to; ++i) rows.push(this.makeRow(this.shown[i], i));
    rows.push(spacer(all ? 0 : this.shown.length - to));
    this.body.replaceChildren(...rows);
    this.count.textContent = this.data.rows === 0 ? 'The model has no edge between two faces.'
      : `${this.shown.length} of ${this.data.rows} edges${this.selected.size > 1 ? `, ${this.selected.size} selected` : ''}`;
  }

  makeRow(row, place) {
    const line = document.createElement('tr');
    line.dataset.row = row;
    line.dataset.edge = this.data.edge(row);
    line.className = place % 2 ? 'odd' : '';
    line.ariaSelected = String(this.selected.has(row));
    for (const column of this.columns) {
      const cell = document.createElement('td');
      cell.className = column.number ? 'n' : '';
      const text = String(column.text(row));
      if (column.badge) {
        const badge = document.createElement('span');
        badge.className = `badge ${this.data.category(row)}`;
        badge.textContent = text;
        cell.append(badge);
      } else {
        cell.textContent = text;
        if (text.length > 30) cell.title = text;
      }
      line.append(cell);
    }
    return line;
  }

  pick(row, add) {
    if (!add) this.selected.clear();
    if (add && this.selected.has(row)) this.selected.delete(row);
    else this.selected.add(row);
    this.current = row;
    this.fill();
    this.onSelect([...this.selected], row);
  }

  /** Selects a row from outside and brings it into sight. */
  show(row, add) {
    if (!this.shown.includes(row)) { // the bar hides it
      this.which.value = 'all';
      this.find.value = '';
      this.filter(this.accepts);
    }
    const place = this.shown.indexOf(row);
    if (place >= 0) {
      const top = place * ROW;
      const height = this.scroll.clientHeight;
      // The heading covers the first row's height.
      if (top < this.scroll.scrollTop || top > this.scroll.scrollTop + height - 3 * ROW) {
        this.scroll.scrollTop = Math.max(0, top - height / 2);
      }
    }
    this.pick(row, add);
  }

  clear() {
    this.selected.clear();
    this.current = -1;
    this.fill();
    this.onSelect([], -1);
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.scroll.clientHeight / ROW) - 2);
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity };
    if (!(event.key in steps) || this.shown.length === 0) return;
    event.preventDefault();
    const place = this.shown.indexOf(this.current);
    const next = Math.max(0, Math.min(this.shown.length - 1, place + steps[event.key]));
    this.show(this.shown[next], event.shiftKey);
  }
}

function spacer(rows) {
  const line = document.createElement('tr');
  line.className = 'spacer';
  line.setAttribute('aria-hidden', 'true');
  line.style.height = `${rows * ROW}px`;
  return line;
}
