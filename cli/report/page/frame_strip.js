// Validation sessions: error and frame time of every frame, one above the other on the same frames.

function drawValidation(run) {
  const sessions = run.validation.filter((session) => session.frames.length);
  if (!sessions.length) return hide('validation');
  const values = (key) => sessions.flatMap((session) => session.frames.map((frame) => frame[key])).filter(isNumber);
  const range = {
    error: Math.max(...values('error'), run.threshold.value) * 1.1,
    ms: Math.max(...values('frame_ms'), ...values('original_ms'), run.original.frame_ms || 0) * 1.08,
    timed: values('frame_ms').length > 0,
  };
  byId('validation-note').textContent = `Sessions that no fit has seen, with the ${run.isVariant ? 'chosen variant' : 'last variant tried'}. ` +
    `The threshold binds the ${run.threshold.metric} error over all frames of a session, not each frame.`;
  for (const session of sessions) {
    const holder = html('div', { class: 'figure' });
    byId('validation-strips').append(html('div', { class: 'strip' }, html('h3', {}, session.name), holder));
    redrawOnResize(holder, (width) => sessionSvg(run, session, range, width));
  }
}

function sessionSvg(run, session, range, width) {
  const x0 = 62;
  const x1 = width - 118;
  const numbers = session.frames.map((frame) => frame.frame);
  const x = linearScale(Math.min(...numbers), Math.max(...numbers), x0, x1);
  const panels = [{ y0: 16, y1: 96, most: range.error, title: `error, ${run.threshold.metric}`, lines: [{ key: 'error', color: 'var(--s1)', name: 'cached' }], bound: run.threshold.value }];
  if (range.timed) {
    panels.push({ y0: 130, y1: 210, most: range.ms, title: 'frame time, ms', lines: [
      { key: 'original_ms', color: 'var(--ink-3)', name: 'original' }, { key: 'frame_ms', color: 'var(--s1)', name: 'cached' }] });
  }
  const bottom = panels[panels.length - 1].y1;
  const root = svg('svg', { viewBox: `0 0 ${width} ${bottom + 36}`, role: 'img', 'aria-label': `Error and frame time of session ${session.name}` },
    panels.map((panel) => stripPanel(session, panel, x, { x0, x1 })),
    linearTicks(Math.min(...numbers), Math.max(...numbers), Math.min(12, width / 90)).filter(Number.isInteger).map((tick) =>
      svg('text', { x: x(tick), y: bottom + 16, 'text-anchor': 'middle' }, tick)),
    svg('text', { class: 'title', x: (x0 + x1) / 2, y: bottom + 32, 'text-anchor': 'middle' }, 'frame'));
  stripCursor(root, run, session, x, bottom);
  return root;
}

function stripPanel(session, panel, x, { x0, x1 }) {
  const y = linearScale(0, panel.most, panel.y1, panel.y0);
  const nodes = [svg('text', { class: 'title', x: x0, y: panel.y0 - 6 }, panel.title)];
  for (const tick of linearTicks(0, panel.most, 3)) {
    nodes.push(svg('line', { class: tick === 0 ? 'axis' : 'grid', x1: x0, x2: x1, y1: y(tick), y2: y(tick) }),
      svg('text', { x: x0 - 8, y: y(tick) + 4, 'text-anchor': 'end' }, formatTick(tick)));
  }
  const ends = [];
  if (panel.bound) {
    nodes.push(svg('line', { class: 'bound', x1: x0, x2: x1, y1: y(panel.bound), y2: y(panel.bound) }));
    ends.push({ y: y(panel.bound), text: 'threshold' });
  }
  for (const line of panel.lines) {
    const present = session.frames.filter((frame) => isNumber(frame[line.key]));
    if (!present.length) continue;
    let pen = 'M';
    const path = session.frames.map((frame) => {
      if (!isNumber(frame[line.key])) {
        pen = 'M';
        return '';
      }
      const step = `${pen}${x(frame.frame).toFixed(1)},${y(frame[line.key]).toFixed(1)}`;
      pen = 'L';
      return step;
    }).join('');
    nodes.push(svg('path', { class: 'line', color: line.color, d: path }));
    ends.push({ y: y(present[present.length - 1][line.key]), text: line.name, color: line.color });
  }
  ends.sort((a, b) => a.y - b.y);
  ends.forEach((end, i) => {
    if (i > 0) end.y = Math.max(end.y, ends[i - 1].y + 14);
    nodes.push(svg('text', { x: x1 + 8, y: end.y + 4, class: end.color ? 'strong' : '' }, end.text));
  });
  return nodes;
}

function stripCursor(root, run, session, x, bottom) {
  const cursor = svg('line', { class: 'cursor', y1: 10, y2: bottom, visibility: 'hidden' });
  root.append(cursor);
  root.addEventListener('pointermove', (event) => {
    const box = root.getBoundingClientRect();
    const px = (event.clientX - box.left) * (root.viewBox.baseVal.width / box.width);
    const frame = session.frames.reduce((a, b) => (Math.abs(x(b.frame) - px) < Math.abs(x(a.frame) - px) ? b : a));
    cursor.setAttribute('x1', x(frame.frame));
    cursor.setAttribute('x2', x(frame.frame));
    cursor.setAttribute('visibility', 'visible');
    showTooltip(event.clientX, event.clientY, html('b', {}, `${session.name}, frame ${frame.frame}`), tooltipRows([
      [`error, ${run.threshold.metric}`, formatNumber(frame.error)],
      ['cached', formatMs(frame.frame_ms)],
      ['original', formatMs(frame.original_ms)],
      ['hit rate', formatPercent(frame.hit_rate)],
    ]));
  });
  root.addEventListener('pointerleave', () => {
    cursor.setAttribute('visibility', 'hidden');
    hideTooltip();
  });
}
