// Error against frame time: a curve for each configuration over its periods (figure 7 of Scherzer et al. 2012).

const kZeroGutter = 46;  // pixels left of the logarithmic axis, where errors of exactly 0 are drawn

function drawTradeoff(run, view) {
  if (!run.curves.length) return hide('tradeoff');
  const filter = { strategy: '', all: true };
  const redraw = redrawOnResize(byId('tradeoff-plot'), (width) => tradeoffSvg(run, view, visibleCurves(run, view, filter), width));
  tradeoffControls(run, filter, redraw);
  view.onChange(redraw);
  byId('tradeoff-note').textContent =
    `Each curve is one way to cache one candidate; its points are the periods. Lower is faster, further left is closer to the original. ` +
    `The tinted area is what is asked for: an error of at most the threshold, faster than the original. Click a point to hold its candidate. ` +
    `Times are ${formatClock(run.clock)}.`;
  byId('tradeoff-legend').append(...tradeoffLegend(run));
}

const visibleCurves = (run, view, filter) => run.curves.filter((curve) => curve.candidate === view.held ||
  ((!filter.strategy || curve.configuration.strategy === filter.strategy) && (filter.all || curve.emphasised || curve.chosen)));

function tradeoffControls(run, filter, redraw) {
  const strategies = [...new Set(run.curves.map((curve) => curve.configuration.strategy))].sort();
  const select = html('select', { id: 'tradeoff-strategy' }, html('option', { value: '' }, 'all'),
    strategies.map((strategy) => html('option', { value: strategy }, strategy)));
  const all = html('input', { type: 'checkbox', checked: true });
  select.addEventListener('change', () => { filter.strategy = select.value; redraw(); });
  all.addEventListener('change', () => { filter.all = all.checked; redraw(); });
  byId('tradeoff-controls').append(
    html('label', {}, 'Strategy', select),
    html('label', {}, all, 'also what is not the best of its candidate (grey)'));
}

function tradeoffLegend(run) {
  const key = (mark, text) => html('span', {}, svg('svg', { width: 22, height: 16, viewBox: '0 0 22 16', 'aria-hidden': 'true' }, mark), text);
  const entries = [
    key(svg('g', { class: 'curve', color: 'var(--ink-2)' }, svg('circle', { class: 'mark', cx: 11, cy: 8, r: 4 })), 'error and time measured in training'),
    key(svg('g', { class: 'curve', color: 'var(--ink-2)' }, svg('circle', { class: 'mark predicted', cx: 11, cy: 8, r: 4 })), 'one of them, or both, by the model'),
    key(svg('g', { class: 'curve', color: 'var(--ink-2)' }, neverMark(11, 8, 'mark')), 'never refreshed'),
  ];
  if (run.isVariant) {
    entries.push(key(svg('circle', { class: 'choice-ring', cx: 11, cy: 8, r: 6 }), 'what the slider picks, as trained'),
      key(cross(11, 8, 5), 'the choice in validation'));
  }
  return entries;
}

const neverMark = (x, y, kind) => svg('rect', { class: kind, x: x - 4, y: y - 4, width: 8, height: 8 });

const cross = (x, y, r) => svg('path', { class: 'validated', d: `M${x - r} ${y - r}L${x + r} ${y + r}M${x - r} ${y + r}L${x + r} ${y - r}` });

// Where values lie on the drawing: x(error), y(ms), and the frame around them.
function tradeoffGeometry(run, view, curves, width) {
  const frame = { x0: 62, x1: width - 62, y0: 14, y1: Math.max(330, Math.min(520, width * 0.46)) };
  const points = curves.flatMap((curve) => curve.points);
  const extra = run.isVariant ? run.choice : {};
  const errors = [...points.map((point) => point.error), run.threshold.value, ...thresholdStops(run), extra.measured_error].filter((error) => error > 0);
  const times = [...points.map((point) => point.ms), run.baseline_ms, run.original.frame_ms, run.original.with_prepass_ms,
    run.limit.frame_ms, extra.measured_frame_ms].filter((ms) => ms > 0);
  const errorRange = [Math.min(...errors, run.threshold.value / 4 || 1e-3) / 1.25, Math.max(...errors, 1e-3) * 1.25];
  const timeRange = [Math.min(...times) / 1.1, Math.max(...times) * 1.08];
  const zero = points.some((point) => point.error === 0);
  const start = frame.x0 + (zero ? kZeroGutter : 0);
  const xOf = logScale(errorRange[0], errorRange[1], start, frame.x1);
  return {
    frame, zero, start, errorRange, timeRange,
    x: (error) => (error > 0 ? xOf(error) : frame.x0 + kZeroGutter / 2 - 6),
    y: logScale(timeRange[0], timeRange[1], frame.y1, frame.y0),
  };
}

function tradeoffSvg(run, view, curves, width) {
  const geometry = { ...tradeoffGeometry(run, view, curves, width), threshold: view.threshold };
  const { frame } = geometry;
  const root = svg('svg', {
    viewBox: `0 0 ${width} ${frame.y1 + 46}`, role: 'group',
    'aria-label': 'Error against frame time. The same figures are in the table of candidates.',
  });
  root.append(...tradeoffAxes(run, geometry));
  const bounds = tradeoffBounds(run, geometry);
  root.append(...bounds.lines);
  const groups = new Map();
  const ordered = [...curves].sort((a, b) => (a.candidate === view.held) - (b.candidate === view.held) || Boolean(a.emphasised) - Boolean(b.emphasised) || a.chosen - b.chosen);
  for (const curve of ordered) {
    const group = curveGroup(curve, geometry, view);
    groups.set(curve, group);
    root.append(group);
  }
  labelCurves(run, curves, geometry, groups, bounds);
  root.append(...bounds.labels, ...choiceMarks(run, view, curves, geometry));
  addHover(root, run, view, curves, geometry, groups);
  return root;
}

function tradeoffAxes(run, { frame, x, y, zero, start, errorRange, timeRange, threshold }) {
  const nodes = [];
  const base = frame.y1;
  if (run.baseline_ms) {
    const right = Math.min(x(threshold), frame.x1);
    nodes.push(svg('rect', { class: 'region', x: frame.x0, y: y(run.baseline_ms), width: Math.max(0, right - frame.x0), height: Math.max(0, base - y(run.baseline_ms)) }));
  }
  for (const tick of logTicks(timeRange[0], timeRange[1], 9)) {
    nodes.push(svg('line', { class: 'grid', x1: frame.x0, x2: frame.x1, y1: y(tick), y2: y(tick) }),
      svg('text', { x: frame.x0 - 8, y: y(tick) + 4, 'text-anchor': 'end' }, formatTick(tick)));
  }
  for (const tick of logTicks(errorRange[0], errorRange[1], Math.max(4, Math.floor((frame.x1 - start) / 70)))) {
    nodes.push(svg('line', { class: 'grid', x1: x(tick), x2: x(tick), y1: frame.y0, y2: base }),
      svg('text', { x: x(tick), y: base + 18, 'text-anchor': 'middle' }, formatTick(tick)));
  }
  if (zero) {
    nodes.push(svg('text', { x: x(0), y: base + 18, 'text-anchor': 'middle' }, '0'),
      svg('line', { class: 'axis dotted', x1: start - 4, x2: start - 4, y1: frame.y0, y2: base }));
  }
  nodes.push(svg('line', { class: 'axis', x1: frame.x0, x2: frame.x1, y1: base, y2: base }));
  nodes.push(svg('text', { class: 'title', x: (frame.x0 + frame.x1) / 2, y: base + 40, 'text-anchor': 'middle' }, `error (${run.threshold.metric}, logarithmic)`));
  const middle = (frame.y0 + base) / 2;
  nodes.push(svg('text', { class: 'title', x: 14, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 14 ${middle})` }, 'frame time (ms, logarithmic)'));
  if (run.baseline_ms) nodes.push(...speedupTicks(run, { frame, y, timeRange }, middle));
  return nodes;
}

// The same scale read as speed-up, on the right.
function speedupTicks(run, { frame, y, timeRange }, middle) {
  const ticks = logTicks(run.baseline_ms / timeRange[1], run.baseline_ms / timeRange[0], 9);
  const right = frame.x1 + 52;
  return [
    ...ticks.map((tick) => svg('text', { x: frame.x1 + 8, y: y(run.baseline_ms / tick) + 4 }, `${formatTick(tick)}×`)),
    svg('text', { class: 'title', x: right, y: middle, 'text-anchor': 'middle', transform: `rotate(90 ${right} ${middle})` }, 'speed-up'),
  ];
}

// The lines that curves are held against. Their labels stand at the right end, clear of each other.
function tradeoffBounds(run, { frame, x, y, threshold }) {
  const lines = [
    { ms: run.original.frame_ms, text: 'original', kind: 'bound dashed' },
    { ms: run.original.with_prepass_ms, text: 'original with depth prepass', kind: 'bound dotted' },
    { ms: run.limit.frame_ms, text: 'limit: tail alone, payload free', kind: 'bound dotted', left: true },
  ].filter((line) => isNumber(line.ms)).sort((a, b) => b.ms - a.ms);
  const nodes = [];
  const labels = [];
  const boxes = [];
  lines.forEach((line, i) => {
    const at = y(line.ms);
    const text = `${line.text} ${formatMs(line.ms)}`;
    const crowded = i > 0 && at - y(lines[i - 1].ms) < 2 * kLabelHeight;
    const textY = at + (crowded ? kLabelHeight - 2 : -6);
    nodes.push(svg('line', { class: line.kind, x1: frame.x0, x2: frame.x1, y1: at, y2: at }));
    const textX = line.left ? frame.x0 + 6 : frame.x1 - 6;  // no curve is both exact and near the limit
    labels.push(svg('text', { class: 'halo', x: textX, y: textY, 'text-anchor': line.left ? 'start' : 'end' }, text));
    boxes.push(boxAt(line.left ? textX : textX - labelWidth(text), textY - 4, labelWidth(text)));
  });
  const at = Math.min(frame.x1, Math.max(frame.x0, x(threshold)));
  const text = `threshold ${formatTick(Number(threshold.toPrecision(3)))}`;
  const left = at + 8 + labelWidth(text) > frame.x1;
  nodes.push(svg('line', { class: 'bound', x1: at, x2: at, y1: frame.y0, y2: frame.y1 }));
  labels.push(svg('text', { class: 'halo strong', x: at + (left ? -6 : 6), y: frame.y1 - 8, 'text-anchor': left ? 'end' : 'start' }, text));
  boxes.push(boxAt(left ? at - 6 - labelWidth(text) : at + 6, frame.y1 - 12, labelWidth(text)));
  const obstacles = [];
  for (let along = frame.y0; along < frame.y1; along += 8) obstacles.push({ x: at, y: along });
  return { lines: nodes, labels, boxes, obstacles };
}

function curveGroup(curve, { x, y }, view) {
  const at = curve.points.map((point) => [x(point.error), y(point.ms)]);
  const solid = [];
  const gaps = [];
  for (let i = 1; i < at.length; ++i) {
    const never = curve.points[i].period_frames === null;
    const fromZero = curve.points[i - 1].error === 0;
    if (fromZero && !curve.emphasised) continue;
    (never || fromZero ? gaps : solid).push(`M${at[i - 1]}L${at[i]}`);
  }
  const group = svg('g', {
    class: `curve${curve.emphasised ? '' : ' other'}${curve.candidate === view.held ? ' held' : ''}`, color: curve.emphasised ? curve.candidate.color : null,
    role: 'img', 'aria-label': `${curve.candidate.name}: ${formatVariant(curve.configuration)}`,
  });
  group.append(svg('path', { d: solid.join('') }), svg('path', { class: 'gap', d: gaps.join('') }));
  curve.points.forEach((point, i) => {
    const kind = point.measured ? 'mark' : 'mark predicted';
    const ci = point.measured_frame_ms_ci95;
    if (ci && curve.emphasised) group.append(svg('line', { class: 'whisker', x1: at[i][0], x2: at[i][0], y1: y(ci[0]), y2: y(ci[1]) }));
    const radius = curve.emphasised ? 4.5 : 3;
    group.append(point.period_frames === null && curve.emphasised
      ? neverMark(at[i][0], at[i][1], kind)
      : svg('circle', { class: kind, cx: at[i][0], cy: at[i][1], r: radius }));
  });
  return group;
}

// Names at the far ends of the emphasised curves; periods along the chosen one.
function labelCurves(run, curves, geometry, groups, bounding) {
  const { x, y, frame } = geometry;
  const named = curves.filter((curve) => curve.emphasised);
  const onCurves = named.flatMap((curve) => curve.points.flatMap((point, i) => {
    const at = { x: x(point.error), y: y(point.ms) };
    const next = curve.points[i + 1];
    if (!next) return [at];
    const to = { x: x(next.error), y: y(next.ms) };
    return [0, 0.25, 0.5, 0.75].map((t) => ({ x: at.x + t * (to.x - at.x), y: at.y + t * (to.y - at.y) }));
  }));
  const shorten = (name) => (name.length > 28 ? `${name.slice(0, 26)}…` : name);
  const anchors = named.map((curve) => {
    const point = curve.points[curve.points.length - 1];
    return { x: x(point.error), y: y(point.ms), text: shorten(curve.candidate.name), group: groups.get(curve) };
  });
  for (const curve of named.filter((candidate) => candidate.chosen)) {
    for (const point of curve.points.slice(0, -1)) {
      const chosen = point.period_frames === run.choice.period_frames;
      anchors.push({ x: x(point.error), y: y(point.ms), text: chosen ? `choice, period ${formatPeriod(point.period_frames)}` : formatPeriod(point.period_frames), group: groups.get(curve), small: !chosen, choice: chosen });
    }
  }
  const bounds = { x0: frame.x0 + 4, x1: frame.x1 - 4, y0: frame.y0 + 4, y1: frame.y1 - 4 };
  anchors.sort((a, b) => Boolean(b.choice) - Boolean(a.choice));
  placeLabels(anchors, [...onCurves, ...bounding.obstacles], bounds, bounding.boxes).forEach(({ box, far }, i) => {
    const anchor = anchors[i];
    if (far && anchor.small) return;
    const middle = (box.y0 + box.y1) / 2;
    if (far) {
      const side = box.x0 > anchor.x ? box.x0 - 2 : box.x1 < anchor.x ? box.x1 + 2 : (box.x0 + box.x1) / 2;
      anchor.group.append(svg('line', { class: 'leader', x1: anchor.x, y1: anchor.y, x2: side, y2: middle }));
    }
    anchor.group.append(svg('text', { class: anchor.small ? 'halo' : 'halo strong', x: box.x0 + 2, y: middle + 4 }, anchor.text));
  });
}

function choiceMarks(run, view, curves, { x, y }) {
  const nodes = [];
  const { pick } = view;
  const shown = curves.find((curve) => pick.candidate && curve.candidate === pick.candidate && curve.configuration === pick.configuration);
  const point = shown && shown.points.find((one) => one.period_frames === pick.period);
  if (point) nodes.push(svg('circle', { class: 'choice-ring', cx: x(point.error), cy: y(point.ms), r: 9 }));
  const { measured_error: error, measured_frame_ms: ms } = run.choice;
  if (run.isVariant && isNumber(error) && ms > 0) nodes.push(cross(x(error), y(ms), 6));
  return nodes;
}

// The nearest point within reach answers, so that marks need not be hit exactly; its curve stands out meanwhile.
function addHover(root, run, view, curves, { x, y }, groups) {
  const targets = curves.flatMap((curve) => curve.points.map((point) => ({ curve, point, x: x(point.error), y: y(point.ms) })));
  let focused = null;
  const focus = (group) => {
    if (focused) focused.classList.remove('focus');
    focused = group;
    root.classList.toggle('focusing', Boolean(group));
    if (group) group.classList.add('focus');
  };
  const nearestTo = (event) => {
    const box = root.getBoundingClientRect();
    const scale = root.viewBox.baseVal.width / box.width;
    const distance = (target) => Math.hypot(target.x - (event.clientX - box.left) * scale, target.y - (event.clientY - box.top) * scale) - (target.curve.emphasised ? 3 : 0);
    const nearest = targets.reduce((best, target) => (!best || distance(target) < distance(best) ? target : best), null);
    return nearest && distance(nearest) <= 22 ? nearest : null;
  };
  root.addEventListener('pointermove', (event) => {
    const nearest = nearestTo(event);
    if (!nearest) {
      focus(null);
      return hideTooltip();
    }
    focus(groups.get(nearest.curve));
    return showTooltip(event.clientX, event.clientY, pointTooltip(run, nearest.curve, nearest.point));
  });
  root.addEventListener('click', (event) => {
    const nearest = nearestTo(event);
    if (nearest) view.hold(nearest.curve.candidate);
  });
  view.focus = (candidate) => focus(candidate && candidate.leader ? groups.get(candidate.leader) || null : null);
  root.addEventListener('pointerleave', () => {
    focus(null);
    hideTooltip();
  });
}

function pointTooltip(run, { candidate, configuration }, point) {
  const both = (predicted, measured, format) => [format(predicted), format(measured)];
  return [
    html('b', {}, `${candidate.name}, ${formatPeriodLong(point.period_frames)}`),
    html('div', { class: 'sub' }, formatVariant(configuration)),
    html('div', { class: 'sub' }, formatPlace(candidate)),
    tooltipRows([
      ['', 'model', 'measured'],
      [`error, ${run.threshold.metric}`, ...both(point.predicted_error, point.measured_error, formatNumber)],
      ['frame time', ...both(point.predicted_frame_ms, point.measured_frame_ms, formatMs)],
      ['speed-up', ...both(run.baseline_ms / point.predicted_frame_ms || null, point.measured_frame_ms && run.baseline_ms / point.measured_frame_ms, formatSpeedup)],
    ]),
  ];
}
