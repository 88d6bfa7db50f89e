// The fits of one configuration, held against what was measured: error over the period; frame time over hits and over misses.
//
// Eq. 5 has two variables, so its time is shown as partial residuals: against the hits, what is left of each measured time when the
// modelled part of misses and the overhead is taken off, and the reverse. A good fit has its points scattered about the line.

const kPeriodColors = ['var(--s1)', 'var(--s2)', 'var(--s3)', 'var(--s5)', 'var(--s6)'];

function drawFits(run, view) {
  if (!run.curves.length) return hide('fits');
  const figures = { error: byId('fit-error'), hits: byId('fit-hits'), misses: byId('fit-misses') };
  const shown = () => {
    if (view.held && view.held.leader) return { candidate: view.held, configuration: view.held.leader.configuration };
    if (view.pick.candidate && view.pick.configuration) return view.pick;
    return run.curves[0];
  };
  const redraws = [
    redrawOnResize(figures.error, (width) => errorPeriodPlot(run, view, shown(), width)),
    redrawOnResize(figures.hits, (width) => timePlot(run, shown(), width, 'hits')),
    redrawOnResize(figures.misses, (width) => timePlot(run, shown(), width, 'misses')),
  ];
  view.onChange(() => {
    const { candidate, configuration } = shown();
    const model = candidate.error_model;
    byId('fits-of').replaceChildren(html('span', { class: 'swatch', color: candidate.color }), html('b', {}, candidate.name || candidate.id), ': ', formatVariant(configuration),
      '. Error: ', model ? `${model.family}, ${model.verdict}${isNumber(model.r_squared) ? `, R² ${formatNumber(model.r_squared)}` : ''}` : 'no model',
      '. Time: ', configuration.cost_verdict || 'no model', isNumber(configuration.cost_r_squared) ? `, R² ${formatNumber(configuration.cost_r_squared)}` : '', '.');
    redraws.forEach((redraw) => redraw());
  });
}

// Axes with their ticks and titles. frame: {x0, x1, y0, y1}.
function plotAxes(frame, { x, y, xTicks, yTicks, xTitle, yTitle, xFormat = formatTick }) {
  return [
    yTicks.map((tick) => [svg('line', { class: 'grid', x1: frame.x0, x2: frame.x1, y1: y(tick), y2: y(tick) }),
      svg('text', { x: frame.x0 - 7, y: y(tick) + 4, 'text-anchor': 'end' }, formatTick(tick))]),
    xTicks.map((tick) => [svg('line', { class: 'grid', x1: x(tick), x2: x(tick), y1: frame.y0, y2: frame.y1 }),
      svg('text', { x: x(tick), y: frame.y1 + 17, 'text-anchor': 'middle' }, xFormat(tick))]),
    svg('line', { class: 'axis', x1: frame.x0, x2: frame.x1, y1: frame.y1, y2: frame.y1 }),
    svg('text', { class: 'title', x: (frame.x0 + frame.x1) / 2, y: frame.y1 + 37, 'text-anchor': 'middle' }, xTitle),
    svg('text', { class: 'title', x: frame.x0 - 48, y: 12 }, yTitle),
  ];
}

function errorPeriodPlot(run, view, { candidate, configuration }, width) {
  const frame = { x0: 56, x1: width - 12, y0: 26, y1: 210 };
  const finite = configuration.points.filter((point) => point.period_frames !== null && point.period_frames > 1);
  const never = configuration.points.find((point) => point.period_frames === null);
  const last = Math.max(...finite.map((point) => point.period_frames), 4);
  const right = never ? frame.x1 - 44 : frame.x1 - 8;
  const x = logScale(2, last, frame.x0 + 12, right);
  const xOf = (point) => (point.period_frames === null ? frame.x1 - 16 : x(point.period_frames));
  const ends = configuration.points.flatMap((point) => [point.predicted_error, point.measured_error, ...(point.measured_error_frames || [])]);
  const positive = [...ends, view.threshold].filter((error) => error > 0);
  const range = [Math.max(Math.min(...positive), Math.max(...positive) / 300) / 1.3, Math.max(...positive) * 1.25];
  const y = logScale(range[0], range[1], frame.y1, frame.y0);
  const inside = (error) => Math.min(frame.y1, Math.max(frame.y0, y(Math.max(error, range[0]))));
  const own = modelOfConfiguration(candidate, configuration);
  const model = own ? Array.from({ length: 61 }, (_, i) => 2 * (last / 2) ** (i / 60)).map((n) => [x(n), inside(modelledError(own, n))])
    : finite.filter((point) => isNumber(point.predicted_error)).map((point) => [x(point.period_frames), inside(point.predicted_error)]);
  const band = finite.filter((point) => point.predicted_error_ci95);
  return svg('svg', { viewBox: `0 0 ${width} 252`, role: 'img', 'aria-label': 'Error over the period, measured and modelled', color: candidate.color || 'var(--ink-2)' },
    plotAxes(frame, { x, y, xTicks: finite.map((point) => point.period_frames), yTicks: logTicks(range[0], range[1], 7), xTitle: 'period, frames', yTitle: `error, ${run.threshold.metric}` }),
    never && svg('text', { x: xOf(never), y: frame.y1 + 17, 'text-anchor': 'middle' }, 'never'),
    band.length > 1 && svg('path', { class: 'band', d: `M${[...band.map((point) => [x(point.period_frames), inside(point.predicted_error_ci95[1])]),
      ...[...band].reverse().map((point) => [x(point.period_frames), inside(point.predicted_error_ci95[0])])].join('L')}Z` }),
    svg('line', { class: 'bound', x1: frame.x0, x2: frame.x1, y1: inside(view.threshold), y2: inside(view.threshold) }),
    // Errors rise to the right: above the line the left end is free, below it the right one.
    svg('text', { class: 'halo', ...(inside(view.threshold) < (frame.y0 + frame.y1) / 2 ? { x: frame.x0 + 6, y: inside(view.threshold) - 6 } : { x: frame.x1 - 6, y: inside(view.threshold) + 15, 'text-anchor': 'end' }) }, `allowed ${formatTick(Number(view.threshold.toPrecision(3)))}`),
    model.length > 1 && svg('path', { class: 'line', d: `M${model.join('L')}` }),
    configuration.points.filter((point) => isNumber(point.measured_error) && point.period_frames !== 1).map((point) => [
      point.measured_error_frames && svg('line', { class: 'whisker', x1: xOf(point), x2: xOf(point), y1: inside(point.measured_error_frames[0]), y2: inside(point.measured_error_frames[1]) }),
      svg('g', { class: 'curve', color: candidate.color || 'var(--ink-2)' }, svg('circle', { class: 'mark', cx: xOf(point), cy: inside(point.measured_error), r: 4.5 },
        svg('title', {}, `${formatPeriodLong(point.period_frames)}: measured ${formatNumber(point.measured_error)}, model ${formatNumber(point.predicted_error)}`)))]));
}

// The candidate's error model is that of its first study; other filters and encodings have fits of their own, known at the periods only.
function modelOfConfiguration(candidate, configuration) {
  const model = candidate.error_model;
  const point = configuration.points.find((one) => one.period_frames > 1 && one.predicted_error > 0);
  if (!model || !point) return null;
  const value = modelledError(model, point.period_frames);
  return value !== null && Math.abs(value / point.predicted_error - 1) < 1e-3 ? model : null;
}

const samplesOf = (run, candidate, configuration) => {
  const found = run.evidence && run.evidence.costs.find((cost) => matchesVariant(cost.variant, candidate, configuration));
  return found ? found.samples.map(([period, hits, misses, ms]) => ({ period, hits, misses, ms })) : [];
};

function timePlot(run, { candidate, configuration }, width, kind) {
  const frame = { x0: 56, x1: width - 12, y0: 26, y1: 210 };
  const samples = samplesOf(run, candidate, configuration);
  const other = kind === 'hits' ? 'misses' : 'hits';
  const title = `ms less the part of ${other}`;
  if (!samples.length || modelledMs(configuration, 0, 0) === null) {
    return svg('svg', { viewBox: `0 0 ${width} 252`, role: 'img', 'aria-label': `no frames timed and counted` },
      svg('text', { class: 'title', x: 8, y: 12 }, title), svg('text', { x: width / 2, y: 110, 'text-anchor': 'middle' }, 'no frame was timed and counted'));
  }
  const rest = (sample) => sample.ms - modelledMs(configuration, kind === 'hits' ? 0 : sample.hits, kind === 'hits' ? sample.misses : 0);
  const most = Math.max(...samples.map((sample) => sample[kind]), 1) * 1.05;
  const values = samples.map(rest);
  const slope = (kind === 'hits' ? configuration.hit_ns : configuration.miss_ns) * 1e-6;
  const low = Math.min(0, ...values);
  const high = Math.max(...values, most * slope, low + 1e-6) * 1.05;
  const x = linearScale(0, most, frame.x0, frame.x1);
  const y = linearScale(low, high, frame.y1, frame.y0);
  const periods = [...new Set(samples.map((sample) => sample.period))].sort((a, b) => (a === null) - (b === null) || a - b);
  const colorOf = (period) => kPeriodColors[periods.indexOf(period) % kPeriodColors.length];
  return svg('svg', { viewBox: `0 0 ${width} 252`, role: 'img', 'aria-label': `Frame time over ${kind}, partial residuals` },
    plotAxes(frame, { x, y, xTicks: linearTicks(0, most, Math.max(2, Math.floor(width / 110))), yTicks: linearTicks(low, high, 5),
      xTitle: `${kind} per frame, 1000 fragments`, yTitle: title, xFormat: (tick) => formatTick(tick / 1000) }),
    samples.map((sample) => svg('circle', { class: 'sample', color: colorOf(sample.period), cx: x(sample[kind]), cy: y(rest(sample)), r: 2.6 })),
    svg('line', { class: 'bound', x1: x(0), y1: y(0), x2: x(most), y2: y(most * slope) }),
    periods.map((period, i) => [svg('circle', { class: 'sample', color: colorOf(period), cx: frame.x1 - 62, cy: frame.y1 - 14 - 16 * (periods.length - 1 - i), r: 3.5 }),
      svg('text', { class: 'halo', x: frame.x1 - 54, y: frame.y1 - 10 - 16 * (periods.length - 1 - i) }, `n = ${formatPeriod(period)}`)]));
}
