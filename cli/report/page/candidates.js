// All candidates: trained ones with their models, the others folded, with the reason.

function drawCandidates(run) {
  const trained = run.candidates.filter((candidate) => candidate.status === 'trained');
  const dropped = run.candidates.filter((candidate) => candidate.status !== 'trained');
  if (!run.candidates.length) return hide('candidates');
  byId('candidates-note').textContent = `${run.candidates.length} found in the shader, ${trained.length} trained. ` +
    'Cost is the share of the shader that the candidate computes. Unfold a name for its models and measurements.';
  if (trained.length) byId('candidates-table').append(trainedTable(run, trained));
  for (const [status, members] of groupByStatus(dropped)) byId('candidates-dropped').append(droppedList(status, members));
}

function groupByStatus(candidates) {
  const groups = new Map();
  for (const candidate of candidates) groups.set(candidate.status, [...(groups.get(candidate.status) || []), candidate]);
  return groups;
}

const shareCell = (candidate) => {
  const bar = html('span', { class: 'share', 'aria-hidden': 'true' }, html('span'));
  bar.firstChild.style.width = `${Math.min(100, Math.max(0, 100 * candidate.cost_share))}%`;
  return [formatPercent(candidate.cost_share), bar];
};

const nameCell = (candidate) => [html('b', {}, candidate.name), ' ', html('code', { class: 'sub' }, candidate.type),
  html('div', { class: 'sub' }, html('code', { title: formatPlace(candidate) }, formatShortPlace(candidate)))];

function errorModelCell(model) {
  if (!model) return html('span', { class: 'sub' }, 'none');
  const parameters = model.parameters.map((parameter) => html('span', { class: 'line' }, `${parameter.name} ${formatNumber(parameter.value)}`));
  return [model.verdict ? `${model.family}, ${model.verdict}` : model.family,
    html('div', { class: 'sub' }, parameters.flatMap((parameter, i) => (i ? [', ', parameter] : [parameter]))),
    isNumber(model.r_squared) && html('div', { class: 'sub' }, `R² ${formatNumber(model.r_squared)}`)];
}

function trainedTable(run, candidates) {
  const columns = [
    { title: 'Candidate', class: 'text' }, { title: 'Cost', num: true }, { title: 'Depends on', class: 'inputs' },
    { title: 'Fastest under the threshold', class: 'fastest' }, { title: 'Error', num: true }, { title: 'Frame', num: true },
    { title: 'Speed-up', num: true }, { title: 'Model of error', class: 'model' },
  ];
  const body = html('tbody', {});
  candidates.forEach((candidate) => body.append(...trainedRows(run, candidate, columns.length)));
  return html('table', {}, html('thead', {}, html('tr', {}, columns.map((column) =>
    html('th', { class: column.num ? 'num' : column.class || '', scope: 'col' }, column.title)))), body);
}

function trainedRows(run, candidate, span) {
  const { leader } = candidate;
  const best = leader && leader.best;
  const chosen = run.isVariant && candidate.id === run.choice.candidate_id;
  const button = html('button', { class: 'unfold', type: 'button', 'aria-expanded': 'false' },
    html('span', { class: 'swatch', color: candidate.color }), html('b', {}, candidate.name), ' ', html('code', { class: 'sub' }, candidate.type));
  const detail = html('tr', { class: 'detail', hidden: true }, html('td', { colspan: span }));
  button.addEventListener('click', () => {
    const open = detail.hidden;
    if (open && !detail.firstChild.hasChildNodes()) detail.firstChild.append(...candidateDetail(run, candidate));
    detail.hidden = !open;
    button.setAttribute('aria-expanded', String(open));
  });
  const model = candidate.error_model;
  const row = html('tr', { class: chosen ? 'chosen' : '' },
    html('td', { class: 'text' }, button, html('div', { class: 'sub' }, html('code', { title: formatPlace(candidate) }, formatShortPlace(candidate)), chosen && [' ', html('span', { class: 'tag good' }, 'chosen')])),
    html('td', { class: 'num' }, shareCell(candidate)),
    html('td', { class: 'sub inputs' }, candidate.inputs.join(', ') || 'nothing'),
    html('td', { class: 'fastest' }, best ? [`${leader.configuration.strategy}, ${formatPeriodLong(best.period_frames)}`, html('div', { class: 'sub' }, formatStorage(leader.configuration))] : html('span', { class: 'sub' }, 'none')),
    html('td', { class: 'num' }, best ? formatNumber(best.error) : ''),
    html('td', { class: 'num' }, best ? formatMs(best.ms) : ''),
    html('td', { class: 'num' }, best && run.baseline_ms ? formatSpeedup(run.baseline_ms / best.ms) : ''),
    html('td', { class: 'model' }, errorModelCell(model)));
  return [row, detail];
}

function candidateDetail(run, candidate) {
  const { leader, error_model: model } = candidate;
  const facts = html('dl', {},
    html('dt', {}, 'Id'), html('dd', {}, html('code', {}, candidate.id)),
    html('dt', {}, 'Place'), html('dd', {}, html('code', {}, formatPlace(candidate))),
    isNumber(candidate.cost) && [html('dt', {}, 'Cost of the slice'), html('dd', {}, formatNumber(candidate.cost))],
    isNumber(candidate.hit_rate_mu) && [html('dt', {}, 'Hit rate μ(1 − 1/n)'), html('dd', {}, `μ = ${formatNumber(candidate.hit_rate_mu)}`)],
    model && model.parameters.map((parameter) => [html('dt', {}, `${model.family}: ${parameter.name}`),
      html('dd', {}, formatNumber(parameter.value), parameter.ci95 && ` (95%: ${formatInterval(parameter.ci95)})`)]));
  const plot = leader ? html('div', {}, html('div', { class: 'sub' }, `Error over the period, ${formatVariant(leader.configuration)}`), fitPlot(run, leader.configuration.points, candidate.color)) : null;
  return [html('div', { class: 'detail-grid' }, plot, facts),
    html('p', { class: 'note sub' }, `For each period: frame time in ms, bold where measured, else by the model; below it the ${run.threshold.metric} error.`),
    html('div', { class: 'scroll' }, configurationTable(run, candidate))];
}

function configurationTable(run, candidate) {
  const periods = [...new Set(candidate.configurations.flatMap((configuration) => configuration.points.map((point) => point.period_frames)))]
    .sort((a, b) => (a === null) - (b === null) || a - b);
  const pointCell = (configuration, period) => {
    const point = configuration.points.find((candidate_point) => candidate_point.period_frames === period);
    if (!point) return '';
    const measured = isNumber(point.measured_frame_ms);
    return [measured ? html('b', {}, formatNumber(point.measured_frame_ms)) : formatNumber(point.predicted_frame_ms),
      html('div', { class: 'sub' }, formatNumber(firstNumber(point.measured_error, point.predicted_error)))];
  };
  return table([
    { title: 'Configuration', cell: formatVariant, class: 'text' },
    { title: 'Δhit, ns', num: true, cell: (configuration) => formatNumber(configuration.hit_ns) },
    { title: 'Δmiss, ns', num: true, cell: (configuration) => formatNumber(configuration.miss_ns) },
    { title: 'c, ms', num: true, cell: (configuration) => formatNumber(configuration.overhead_ms) },
    { title: 'R²', num: true, cell: (configuration) => [formatNumber(configuration.cost_r_squared), html('div', { class: 'sub' }, configuration.cost_verdict)] },
    ...periods.map((period) => ({ title: period === null ? 'never' : `n = ${period}`, num: true, cell: (configuration) => pointCell(configuration, period) })),
  ], candidate.configurations, (configuration) => (isChoice(run, candidate, configuration) ? 'chosen' : ''));
}

const kStatusTitles = {
  pruned: 'Dropped before training', not_reached: 'Not reached within the budget', failed: 'Failed', refused: 'Refused: cannot be cached safely',
};

function droppedList(status, members) {
  return html('details', {}, html('summary', {}, `${kStatusTitles[status] || status} (${members.length})`),
    html('div', { class: 'scroll dropped' }, table([
      { title: 'Candidate', cell: nameCell, class: 'text' },
      { title: 'Cost', num: true, cell: shareCell },
      { title: 'Depends on', cell: (candidate) => candidate.inputs.join(', '), class: 'sub' },
      { title: 'Reason', class: 'text', cell: (candidate) => (candidate.reason ? [candidate.reason.message, html('div', { class: 'sub' }, html('code', {}, candidate.reason.code))] : '') },
    ], members)));
}
