// The outcome at a glance: sentence, tiles, warnings, times, prediction check, attempts, facts, stages.

function drawHead(run) {
  if (run.leading) byId('leading').append(html('div', { class: 'alert' }, html('b', {}, run.leading)));
  byId('title').textContent = run.scenario.name || run.scenario.path;
  byId('headline').textContent = run.headline;
  byId('because').textContent = run.isVariant ? run.choice.reason : '';
}

// `name` and `value` let a script read the figure back.
function tile(name, label, value, shown, detail, meter) {
  const bar = meter === undefined ? null : html('div', { class: `meter${meter > 1 ? ' over' : ''}`, 'aria-hidden': 'true' }, html('span'));
  if (bar) bar.firstChild.style.width = `${Math.min(100, 100 * meter)}%`;
  return html('div', { class: 'tile', 'data-name': name, 'data-value': isNumber(value) ? value : '' },
    html('div', { class: 'label' }, label), html('div', { class: 'value' }, shown), bar, html('div', { class: 'detail' }, detail));
}

const withUnit = (value, unit) => [formatNumber(value), html('small', {}, unit)];

function drawTiles(run, view) {
  view.onChange(() => byId('tiles').replaceChildren(...(view.pick.kind === 'original' ? originalTiles(run, view) : pickTiles(run, view))));
}

function originalTiles(run, view) {
  const tiles = [];
  const tried = run.attempts.filter((attempt) => isNumber(attempt.measured_speedup));
  const fastest = tried.reduce((best, attempt) => (!best || attempt.measured_speedup > best.measured_speedup ? attempt : best), null);
  if (isNumber(run.baseline_ms)) tiles.push(tile('frame_ms', 'Original', run.baseline_ms, withUnit(run.baseline_ms, 'ms'), `per frame, ${formatClock(run.clock)}`));
  tiles.push(tile('allowed', 'Allowed error', view.threshold, formatTick(Number(view.threshold.toPrecision(3))), run.threshold.metric));
  if (fastest) tiles.push(tile('fastest', 'Fastest that was validated', fastest.measured_speedup, formatSpeedup(fastest.measured_speedup), `error ${formatNumber(fastest.measured_error)}`));
  if (isNumber(run.limit.frame_ms)) tiles.push(tile('limit', 'Limit', run.limit.frame_ms, withUnit(run.limit.frame_ms, 'ms'), 'tail alone, payload free'));
  return tiles;
}

// A figure as measured with its interval, the model's beside it; the model's where nothing was measured.
function pickTiles(run, { pick, threshold }) {
  const { choice, original, scenario } = run;
  const chosen = pick.kind === 'choice';
  const best = (measured, predicted) => (isNumber(measured) ? measured : predicted);
  const told = (measured, predicted, format) => (isNumber(measured) ? (isNumber(predicted) ? `predicted ${format(predicted)}` : '') : 'predicted, not measured');
  const joined = (...parts) => parts.filter(Boolean).join('; ');
  const speedup = best(pick.measured_speedup, pick.predicted_speedup);
  const error = best(pick.measured_error, pick.predicted_error);
  const ms = best(pick.measured_ms, pick.predicted_ms);
  const tiles = [
    tile('speedup', 'Speed-up', speedup, formatSpeedup(speedup), joined(pick.speedup_ci && `95% interval ${formatInterval(pick.speedup_ci)}`, told(pick.measured_speedup, pick.predicted_speedup, formatSpeedup))),
    tile('error', `Error, ${run.threshold.metric}`, error, formatNumber(error), joined(`of ${formatTick(Number(threshold.toPrecision(3)))} allowed`, told(pick.measured_error, pick.predicted_error, formatNumber),
      chosen && `worst frame ${formatNumber(choice.worst_frame_error)}`), error / threshold),
    tile('frame_ms', 'Frame time', ms, withUnit(ms, 'ms'), chosen ? joined(`original ${formatMs(original.frame_ms)}`, told(pick.measured_ms, pick.predicted_ms, formatMs), `p95 ${formatMs(choice.p95_ms)}, worst ${formatMs(choice.worst_ms)}`)
      : joined(`original ${formatMs(run.baseline_ms)}`, pick.ms_ci && `95% interval ${formatInterval(pick.ms_ci)}`, told(pick.measured_ms, pick.predicted_ms, formatMs))),
  ];
  if (isNumber(pick.limit_ms) && ms > 0) {
    const share = pick.limit_ms / ms;
    tiles.push(tile('limit', 'Share of the limit', share, formatPercent(share), `a free payload would take ${formatMs(pick.limit_ms)}`, Math.min(1, share)));
  }
  if (isNumber(pick.hit_rate)) tiles.push(tile('hit_rate', 'Hit rate', pick.hit_rate, formatPercent(pick.hit_rate), chosen ? 'of covered pixels, in validation' : 'predicted', pick.hit_rate));
  if (isNumber(pick.cache)) {
    const mebibytes = (pick.cache * scenario.width * scenario.height) / 2 ** 20;
    tiles.push(tile('cache', 'Cache', pick.cache, withUnit(pick.cache, 'bytes/pixel'), `${formatNumber(mebibytes)} MiB at ${scenario.width}×${scenario.height}`));
  }
  return tiles;
}

function drawAlerts(run) {
  const add = (title, entries) => {
    if (!entries.length) return;
    byId('alerts').append(html('div', { class: 'alert' }, html('b', {}, title), html('ul', {}, entries.map((entry) => html('li', {}, entry)))));
  };
  const warnings = run.leading ? run.warnings.slice(1) : run.warnings;
  add(warnings.length === 1 ? 'Warning' : `${warnings.length} warnings`, warnings);
  add('Not reached within the budget', run.not_reached);
}

function drawTimes(run) {
  const bars = [
    { label: 'original', value: run.original.frame_ms },
    { label: 'original with prepass', value: run.original.with_prepass_ms },
    { label: 'choice', value: run.isVariant ? run.choice.measured_frame_ms : null, strong: true },
    { label: 'limit: tail alone', value: run.limit.frame_ms },
  ].filter((bar) => isNumber(bar.value)).map((bar) => ({ ...bar, text: formatMs(bar.value) }));
  if (!bars.length) return hide('times');
  redrawOnResize(byId('times-bars'), (width) => horizontalBars(width, bars));
  const wall = isNumber(run.choice.wall_speedup)
    ? ` By wall time the choice is ${formatSpeedup(run.choice.wall_speedup)} as fast${run.choice.wall_speedup_ci95 ? ` (95%: ${formatInterval(run.choice.wall_speedup_ci95)})` : ''}.` : '';
  byId('times-note').textContent = `Medians by ${formatClock(run.clock)}, the clock that binds; speed-up is against the faster original.${wall}`;
}

function drawPrediction(run) {
  const { choice } = run;
  const rows = [
    ['Frame time', choice.predicted_frame_ms, choice.measured_frame_ms, formatMs],
    ['Speed-up', choice.predicted_speedup, choice.measured_speedup, formatSpeedup],
    [`Error, ${run.threshold.metric}`, choice.predicted_error, choice.measured_error, formatNumber],
  ].filter((row) => isNumber(row[1]) && isNumber(row[2]));
  if (!run.isVariant || !rows.length) return hide('prediction');
  const off = ([, predicted, measured]) => {
    if (measured === 0) return 'n/a';
    const percent = (100 * (predicted - measured)) / measured;
    return `${percent >= 0 ? '+' : '−'}${formatNumber(Math.abs(percent), 2)}%`;
  };
  byId('prediction-table').append(table([
    { title: '', cell: (row) => html('span', { class: 'line' }, row[0]) },
    { title: 'Predicted', num: true, cell: (row) => row[3](row[1]) },
    { title: 'Measured', num: true, cell: (row) => row[3](row[2]) },
    { title: 'Prediction off by', num: true, cell: off },
  ], rows));
}

// Each metric beside its threshold, where it has one.
function drawMetrics(run) {
  const metrics = run.metrics || [];
  if (!metrics.length) return hide('metrics');
  const allowed = new Map((run.thresholds || []).map((threshold) => [threshold.metric, threshold.value]));
  byId('metrics-note').textContent = `Of ${run.isVariant ? 'the choice' : 'the last variant tried'}. Thresholds are held against the worst session. 0 is identical.`;
  byId('metrics-table').append(table([
    { title: 'Metric', cell: (metric) => metric.metric },
    { title: 'All sessions', num: true, cell: (metric) => formatNumber(metric.all_sessions) },
    { title: 'Worst session', num: true, cell: (metric) => formatNumber(metric.worst_session) },
    { title: 'Worst frame', num: true, cell: (metric) => formatNumber(metric.worst_frame) },
    { title: 'Allowed', num: true, cell: (metric) => (allowed.has(metric.metric) ? formatTick(allowed.get(metric.metric)) : '') },
    { title: '', class: 'text', cell: (metric) => (!allowed.has(metric.metric) ? '' : metric.worst_session <= allowed.get(metric.metric)
      ? html('span', { class: 'tag good' }, '✓ kept') : html('span', { class: 'tag bad' }, '✗ exceeded')) },
  ], metrics));
}

function drawAttempts(run) {
  if (!run.attempts.length) return hide('attempts');
  const names = new Map(run.candidates.map((candidate) => [candidate.id, candidate.name]));
  byId('attempts-table').append(table([
    { title: '', num: true, cell: (attempt) => run.attempts.indexOf(attempt) + 1 },
    { title: 'Candidate', cell: (attempt) => names.get(attempt.candidate_id) || attempt.candidate_id },
    { title: 'Configuration', cell: (attempt) => attempt.configuration },
    { title: 'Period', num: true, cell: (attempt) => formatPeriod(attempt.period_frames) },
    { title: 'Error', num: true, cell: (attempt) => formatNumber(attempt.measured_error) },
    { title: 'Speed-up', num: true, cell: (attempt) => [formatSpeedup(attempt.measured_speedup), html('div', { class: 'sub' }, formatInterval(attempt.speedup_ci95))] },
    { title: 'Verdict', class: 'text', cell: (attempt) => [html('span', { class: `tag ${attempt.accepted ? 'good' : 'bad'}` }, attempt.accepted ? '✓ accepted' : '✗ not accepted'), ' ', attempt.reason] },
  ], run.attempts, (attempt) => (attempt.accepted ? 'chosen' : '')));
}

function drawFacts(run) {
  const { choice, device, scenario, shader } = run;
  const code = (text) => (text ? html('code', {}, text) : '');
  const payload = choice.payload.map((value) => html('div', {}, code(`${value.type} ${value.name}`), ' at ', code(formatPlace(value))));
  const facts = [
    ['Payload', payload.length ? payload : ''],
    ['Variant', run.isVariant ? `${formatVariant(choice)}, ${formatPeriodLong(choice.period_frames)}` : ''],
    ['Device', device.name], ['Driver', device.driver], ['Host', device.host],
    ['Binding clock', isNumber(run.baseline_ms) ? formatClock(run.clock) : ''],
    ['Resolution', scenario.width ? `${scenario.width} × ${scenario.height}` : ''],
    ['Training', scenario.frames ? `${scenario.frames} frames, seed ${scenario.seed}` : ''],
    ['Scenario', scenario.path && [code(scenario.path), scenario.hash && html('div', { class: 'sub' }, code(scenario.hash))]],
    ['Fragment shader', shader.fragment && [code(shader.fragment), shader.hash && html('div', { class: 'sub' }, code(shader.hash))]],
    ['Vertex shader', code(shader.vertex)],
    [run.quality ? `Thresholds, quality ${run.quality}` : 'Thresholds',
      (run.thresholds && run.thresholds.length ? run.thresholds : [run.threshold]).map((threshold) => html('div', {}, `${formatTick(threshold.value)} ${threshold.metric}`))],
    ['Least gain', isNumber(run.least_gain) ? `${formatTick(run.least_gain)}×` : ''],
    ['Strategies refused', (run.strategies_refused || []).map((text) => html('div', {}, text))],
    ['Finished', run.finished_at || ''],
    ['Reprise', run.tool_version],
    ['Repeat with', run.command ? html('code', { class: 'command' }, run.command.split(' ').flatMap((word) => [html('span', { class: 'token' }, word), ' '])) : ''],
  ];
  byId('facts-list').append(...facts.filter(([, value]) => value && value.length !== 0).flatMap(([label, value]) => [html('dt', {}, label), html('dd', {}, value)]));
}

function drawStages(run) {
  const stages = Object.entries(run.seconds).filter(([, seconds]) => isNumber(seconds));
  if (!stages.length) return hide('stages');
  const total = stages.reduce((sum, [, seconds]) => sum + seconds, 0);
  const bars = stages.map(([label, seconds]) => ({ label, value: seconds, text: formatSeconds(seconds) }));
  redrawOnResize(byId('stages-bars'), (width) => horizontalBars(width, bars));
  byId('stages').append(html('p', { class: 'note' }, `${formatSeconds(total)} in all.`));
}
