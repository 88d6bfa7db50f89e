// Errors of one configuration over the period: measured points against the fitted model.

function fitPlot(run, points, color) {
  const width = 300;
  const height = 168;
  const frame = { x0: 48, x1: width - 10, y0: 10, y1: height - 34 };
  const finite = points.filter((point) => point.period_frames !== null);
  const never = points.find((point) => point.period_frames === null);
  const periods = finite.map((point) => point.period_frames);
  const last = Math.max(...periods, 2);
  const right = never ? frame.x1 - 46 : frame.x1;
  const x = logScale(Math.min(...periods, 2), last, frame.x0 + 8, right - 4);
  const xOf = (point) => (point.period_frames === null ? frame.x1 - 14 : x(point.period_frames));
  const errors = points.flatMap((point) => [point.predicted_error, point.measured_error]).filter(isNumber);
  const most = Math.max(...errors, run.threshold.value) * 1.08;
  const y = linearScale(0, most, frame.y1, frame.y0);
  const modelled = finite.filter((point) => isNumber(point.predicted_error));
  const model = modelled.map((point, i) => `${i ? 'L' : 'M'}${x(point.period_frames)},${y(point.predicted_error)}`).join('');
  return svg('svg', { viewBox: `0 0 ${width} ${height}`, width, role: 'img', 'aria-label': 'Measured errors and their model over the period', color: color || 'var(--ink-2)' },
    linearTicks(0, most, 4).map((tick) => [
      svg('line', { class: 'grid', x1: frame.x0, x2: frame.x1, y1: y(tick), y2: y(tick) }),
      svg('text', { x: frame.x0 - 6, y: y(tick) + 4, 'text-anchor': 'end' }, formatTick(tick)),
    ]),
    finite.map((point) => svg('text', { x: xOf(point), y: frame.y1 + 15, 'text-anchor': 'middle' }, formatPeriod(point.period_frames))),
    never && svg('text', { x: xOf(never), y: frame.y1 + 15, 'text-anchor': 'middle' }, 'never'),
    svg('text', { class: 'title', x: (frame.x0 + frame.x1) / 2, y: height - 4, 'text-anchor': 'middle' }, 'period (frames)'),
    svg('line', { class: 'bound', x1: frame.x0, x2: frame.x1, y1: y(run.threshold.value), y2: y(run.threshold.value) }),
    svg('text', { class: 'halo', x: frame.x0 + 4, y: y(run.threshold.value) - 5 }, 'threshold'),
    svg('path', { class: 'line', d: model }),
    svg('g', { class: 'curve', color: color || 'var(--ink-2)' },
      points.filter((point) => isNumber(point.measured_error)).map((point) =>
        svg('circle', { class: 'mark', cx: xOf(point), cy: y(point.measured_error), r: 4 }))));
}
