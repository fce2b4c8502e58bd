// The page's elements.
const option = (value, text = value) => `<option value="${value}">${text}</option>`;

export const PAGE = `
<div id="app">
  <div id="toolbar" role="toolbar" aria-label="View">
    <span class="group" role="radiogroup" aria-label="Faces">
      <button data-mode="shaded" role="radio" title="S">Shaded</button><button data-mode="zebra" role="radio" title="Z">Zebra</button><button data-mode="curvature" role="radio" title="C">Curvature</button></span>
    <label id="stripes-label" hidden>stripes <input id="stripes" type="range" min="4" max="60" value="16"></label>
    <label id="measure-label" hidden><select id="measure" aria-label="Which curvature">${option('mean')}${option('gauss', 'Gauss (signed root)')}${option('largest')}</select></label>
    <label id="range-label" hidden>range <input id="range" type="range" min="50" max="100" step="1" value="90" aria-label="Percent of the curved area that the range covers"></label>
    <button id="combs" aria-pressed="true" title="H">Combs</button>
    <label>deviation <select id="deviation" title="D">${option('', 'off')}${option('angle')}${option('gap')}</select></label>
    <label>size <input id="comb-size" type="range" min="-2" max="2" step="0.1" value="0" aria-label="Size of combs and deviations"></label>
    <button id="markers" aria-pressed="true" title="M">Worst points</button>
    <label>section <select id="section" title="X">${option('', 'off')}${option('x')}${option('y')}${option('z')}${option('eye', 'facing me')}</select></label>
    <span id="section-label" hidden><input id="section-at" type="range" min="0" max="100" step="0.5" value="50" aria-label="Where the section is"><button id="section-flip" aria-pressed="false">Flip</button></span>
    <button id="fresh" aria-pressed="true" title="N" hidden>New faces</button>
    <button id="before" aria-pressed="false" title="B" hidden>Show before</button>
    <select id="look" aria-label="Look from">${option('iso', 'Look from…')}${['front', 'back', 'left', 'right', 'top', 'bottom', 'iso'].map((name) => option(name)).join('')}</select>
    <button id="fit" title="F">Fit</button><button id="theme" title="T">Light / dark</button><button id="help" title="?">Keys</button>
  </div>
  <section id="stage" aria-label="The model in 3D"><canvas id="view" tabindex="0" aria-label="3D view: drag to turn, wheel to zoom, click an edge to select it"></canvas>
    <div id="legend" role="group" aria-label="Edges shown"></div>
    <div id="scale" hidden></div><p id="message" role="alert" hidden></p></section>
  <aside id="side" aria-label="Figures">
    <section id="holes" aria-label="Table of holes" hidden></section>
    <div id="plot" aria-live="polite"></div>
    <details open><summary>Limits</summary><form id="limits"></form></details>
    <details open><summary>Angles of all edges</summary><div id="histogram"></div><dl id="summary"></dl></details>
    <details id="parts-box" hidden><summary>Parts</summary><div id="parts" role="group" aria-label="Parts shown"></div></details>
  </aside>
  <section id="table" aria-label="Table of edges"></section>
</div>
<dialog id="keys"><h3>Keys</h3><dl><dt>Z, C, S</dt><dd>zebra, curvature, shaded</dd><dt>H, D, M</dt><dd>combs, deviation from the limit, worst points</dd><dt>X</dt><dd>section on or off</dd><dt>N, B</dt><dd>new faces, before and after</dd><dt>O</dt><dd>next hole</dd><dt>1 to 8</dt><dd>classes of edges, in the legend's order</dd><dt>↑ ↓</dt><dd>next edge in the table; with Shift add it</dd><dt>/</dt><dd>find an edge</dd><dt>F, Esc</dt><dd>see all, select nothing</dd><dt>T</dt><dd>light or dark</dd></dl><form method="dialog"><button>Close</button></form></dialog>`;
