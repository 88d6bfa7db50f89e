// The shader with the share of cost of each line, the candidates in the margin, and the cut of the one that is looked at: lines of the
// payload's slice, of the tail, and of both.

function drawSource(run, view) {
  const sources = run.evidence ? run.evidence.sources : [];
  if (!sources.length) return hide('source');
  const markers = markersByLine(run, sources);
  const most = Math.max(...sources.flatMap((source) => source.line_shares), 1e-9);
  const tables = sources.map((source, index) => sourceTable(run, view, source, markers[index], most));
  const holder = byId('source-files');
  sources.forEach((source, index) => holder.append(html('details', { open: true, class: 'source-file' },
    html('summary', {}, html('code', {}, source.path.replace(/^.*\//, '')), html('span', { class: 'sub' }, ` ${formatPercent(source.line_shares.reduce((a, b) => a + b, 0))} of the cost`)),
    html('div', { class: 'code', tabindex: 0 }, tables[index].table))));
  const select = html('select', { id: 'source-candidate' }, html('option', { value: '' }, 'the choice at the slider'),
    run.candidates.filter((candidate) => cutOf(run, candidate)).map((candidate) => html('option', { value: candidate.id }, `${candidate.name || candidate.id} (${formatPercent(candidate.cost_share)})`)));
  select.addEventListener('change', () => {
    const wanted = run.candidates.find((candidate) => candidate.id === select.value) || null;
    if (wanted !== view.held) view.hold(wanted || view.held);
  });
  byId('source-controls').append(html('label', {}, 'Cut at', select), sourceLegend());
  view.onChange(() => {
    const looked = view.held || view.pick.candidate || null;
    select.value = view.held ? view.held.id : '';
    const cut = cutOf(run, looked);
    tables.forEach(({ rows }, source) => rows.forEach((row, i) => {
      row.className = cut ? cut.kinds.get(`${source}:${i + 1}`) || '' : '';
    }));
    for (const button of holder.querySelectorAll('button.marker')) button.classList.toggle('held', Boolean(looked) && button.dataset.id === looked.id);
    if (view.held) showLine(run, sources, tables, view.held);
  });
}

const sourceLegend = () => html('span', { class: 'legend' },
  html('span', {}, html('i', { class: 'swatch cut-slice' }), 'only the payload needs it: a hit skips it'),
  html('span', {}, html('i', { class: 'swatch cut-tail' }), 'tail: from the payload to the output'),
  html('span', {}, html('i', { class: 'swatch cut-both' }), 'both'));

function cutOf(run, candidate) {
  const slice = candidate && run.evidence.slices.find((one) => one.candidate_id === candidate.id);
  if (!slice) return null;
  const kinds = new Map();
  for (const kind of ['slice', 'tail', 'both']) slice[kind].forEach(([source, line]) => kinds.set(`${source}:${line}`, `cut-${kind}`));
  return { kinds };
}

const sameFile = (a, b) => a === b || a.replace(/^.*\//, '') === b.replace(/^.*\//, '');

// By source, then line: candidates that stand there, those with a cut first.
function markersByLine(run, sources) {
  return sources.map((source) => {
    const byLine = new Map();
    for (const candidate of run.candidates) {
      if (!candidate.line || !candidate.file || !sameFile(candidate.file, source.path) || !cutOf(run, candidate)) continue;
      byLine.set(candidate.line, [...(byLine.get(candidate.line) || []), candidate]);
    }
    return byLine;
  });
}

function sourceTable(run, view, source, markers, most) {
  const lines = source.text.replace(/\r?\n$/, '').split(/\r?\n/);
  const rows = lines.map((text, i) => {
    const share = source.line_shares[i] || 0;
    const bar = html('span', { class: 'cost-bar' });
    bar.style.width = `${Math.round((100 * share) / most)}%`;
    return html('tr', {},
      html('td', { class: 'cost', title: share ? `${formatPercent(share)} of the cost` : null }, share >= 0.0005 && [bar, html('span', {}, formatPercent(share))]),
      html('td', { class: 'margin' }, (markers.get(i + 1) || []).map((candidate) => marker(view, candidate))),
      html('td', { class: 'number' }, i + 1),
      html('td', { class: 'text' }, text || ' '));
  });
  return { rows, table: html('table', { class: 'listing' }, html('tbody', {}, rows)) };
}

function marker(view, candidate) {
  const button = html('button', { type: 'button', class: 'marker', 'data-id': candidate.id, color: candidate.color, title: `${candidate.name || candidate.id} (${candidate.type}): ${formatPercent(candidate.cost_share)} of the cost. Click to hold it.`, 'aria-label': `hold ${candidate.name || candidate.id}` });
  button.addEventListener('click', () => view.hold(candidate));
  button.addEventListener('pointerenter', () => view.focus && view.focus(candidate));
  button.addEventListener('pointerleave', () => view.focus && view.focus(null));
  return button;
}

// Scrolls the listing, not the page: who clicks in the plot wants to stay there.
function showLine(run, sources, tables, candidate) {
  const index = sources.findIndex((source) => candidate.file && sameFile(candidate.file, source.path));
  const row = index >= 0 && tables[index].rows[candidate.line - 1];
  if (!row) return;
  const box = row.closest('.code');
  box.scrollTop = Math.max(0, row.offsetTop - box.clientHeight / 3);
}
