// Elements, scales and the tooltip. Text is always set as text, never parsed as markup.

const kSvg = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes || {})) {
    if (value === undefined || value === null || value === false) continue;
    if (key === 'color') node.style.setProperty('--c', value);
    else node.setAttribute(key, value === true ? '' : value);
  }
  for (const child of children.flat(3)) {
    if (child === null || child === undefined || child === false) continue;
    node.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
  return node;
}

const html = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);
const svg = (tag, attributes, ...children) => fill(document.createElementNS(kSvg, tag), attributes, children);

const byId = (id) => document.getElementById(id);

const linearScale = (lo, hi, from, to) => (value) => from + ((value - lo) / (hi - lo || 1)) * (to - from);
const logScale = (lo, hi, from, to) => (value) =>
  from + (Math.log(value / lo) / (Math.log(hi / lo) || 1)) * (to - from);

function linearTicks(lo, hi, count) {
  const raw = (hi - lo) / Math.max(1, count);
  if (!(raw > 0)) return [lo];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= raw * 0.999);
  const ticks = [];
  for (let i = Math.ceil(lo / step - 1e-9); i * step <= hi * (1 + 1e-9); ++i) ticks.push(i * step);
  return ticks;
}

// The finest of the usual sets of mantissas that gives at most `most` ticks; a narrow range gets even steps instead.
function logTicks(lo, hi, most) {
  const sets = [[1, 1.5, 2, 3, 4, 5, 6, 8], [1, 2, 3, 5], [1, 2, 5], [1]];
  for (const mantissas of sets) {
    const ticks = [];
    for (let k = Math.floor(Math.log10(lo)); k <= Math.ceil(Math.log10(hi)); ++k) {
      for (const mantissa of mantissas) {
        const tick = Number((mantissa * 10 ** k).toPrecision(3));
        if (tick >= lo * 0.9999 && tick <= hi * 1.0001) ticks.push(tick);
      }
    }
    if (ticks.length <= most && ticks.length >= 3) return ticks;
  }
  const even = linearTicks(lo, hi, most).filter((tick) => tick > 0);
  return even.length <= most * 2 ? even : even.filter((_, i) => i % 3 === 0);
}

// Rebuilds a figure whenever its width changes; draw(width) returns an SVG element.
function redrawOnResize(holder, draw) {
  let lastWidth = 0;
  const update = () => {
    const width = Math.round(holder.clientWidth) || 1000;
    if (width === lastWidth) return;
    lastWidth = width;
    holder.replaceChildren(draw(width));
  };
  update();
  new ResizeObserver(() => requestAnimationFrame(update)).observe(holder);
  return () => {
    lastWidth = 0;
    update();
  };
}

function showTooltip(x, y, ...content) {
  const box = byId('tooltip');
  box.replaceChildren(...content.flat(3));
  box.hidden = false;
  const { width, height } = box.getBoundingClientRect();
  const left = x + 16 + width > window.innerWidth ? x - 16 - width : x + 16;
  const top = y + 12 + height > window.innerHeight ? y - 12 - height : y + 12;
  box.style.left = `${Math.max(4, left)}px`;
  box.style.top = `${Math.max(4, top)}px`;
}

function hideTooltip() {
  byId('tooltip').hidden = true;
}

function tooltipRows(rows) {
  return html('table', {}, html('tbody', {}, rows.map((cells) =>
    html('tr', {}, cells.map((cell, i) => html('td', { class: i ? 'num' : '' }, cell))))));
}

// columns: [{title, num, cell(row) → text, node or list, class}]; rowClass(row).
function table(columns, rows, rowClass = () => '') {
  const kind = (column) => (column.num ? 'num' : column.class || '');
  return html('table', {},
    html('thead', {}, html('tr', {}, columns.map((column) => html('th', { class: kind(column), scope: 'col' }, column.title)))),
    html('tbody', {}, rows.map((row) =>
      html('tr', { class: rowClass(row) }, columns.map((column) => html('td', { class: kind(column) }, column.cell(row)))))));
}

// Horizontal bars with their label above the figures' column: [{label, value, text, strong}].
function horizontalBars(width, bars) {
  const labelWidth = Math.min(190, width * 0.42);
  const rowHeight = 26;
  const most = Math.max(...bars.map((bar) => bar.value), 0) || 1;
  const length = linearScale(0, most, 0, width - labelWidth - 84);
  const height = bars.length * rowHeight + 4;
  return svg('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': bars.map((bar) => `${bar.label}: ${bar.text}`).join('; ') },
    bars.map((bar, i) => [
      svg('text', { x: labelWidth - 10, y: i * rowHeight + 18, 'text-anchor': 'end', class: bar.strong ? 'strong' : '' }, bar.label),
      svg('rect', { class: `bar${bar.strong ? ' strong' : ''}`, x: labelWidth, y: i * rowHeight + 5, height: 17, rx: 2, width: Math.max(1, length(bar.value)) }),
      svg('text', { x: labelWidth + length(bar.value) + 8, y: i * rowHeight + 18, class: bar.strong ? 'strong' : '' }, bar.text),
    ]),
    svg('line', { class: 'axis', x1: labelWidth, x2: labelWidth, y1: 0, y2: height }));
}
