// What the page reads and what it derives from it: curves, the best point of each candidate, colours.

const kMostEmphasised = 8;

function readRun() {
  const block = JSON.parse(byId('run-data').textContent);
  const run = block.result;
  run.headline = block.headline;
  run.leading = block.leading || '';
  run.pictures = block.images;
  run.evidence = block.evidence || null;
  run.shelf = block.pictures || {};
  run.isVariant = run.choice.kind === 'variant';
  const originals = [run.original.frame_ms, run.original.with_prepass_ms].filter(isNumber);
  run.baseline_ms = originals.length ? Math.min(...originals) : null;
  run.curves = makeCurves(run);
  emphasise(run);
  run.frontPoints = frontPoints(run);
  return run;
}

const firstNumber = (...values) => {
  const found = values.find(isNumber);
  return found === undefined ? null : found;
};

function makeCurves(run) {
  const curves = [];
  for (const candidate of run.candidates) {
    for (const configuration of candidate.configurations) {
      const points = configuration.points.map((point) => ({
        ...point,
        error: firstNumber(point.measured_error, point.predicted_error),
        ms: firstNumber(point.measured_frame_ms, point.predicted_frame_ms),
        measured: isNumber(point.measured_error) && isNumber(point.measured_frame_ms),
      })).filter((point) => point.error !== null && point.ms !== null);
      if (points.length) curves.push({ candidate, configuration, points, best: bestPoint(points, run.threshold.value) });
    }
  }
  return curves;
}

const matchesVariant = (variant, candidate, configuration) => variant.candidate_id === candidate.id &&
  ['strategy', 'pattern', 'block_pixels', 'filter', 'encoding'].every((key) => configuration[key] === variant[key]);

// The predicted Pareto front as result.json has it; of a run that does not say, by the same rule.
function frontPoints(run) {
  const all = run.candidates.flatMap((candidate) => candidate.configurations.flatMap((configuration) => configuration.points
    .filter((point) => isNumber(point.predicted_error) && isNumber(point.predicted_frame_ms) && point.period_frames !== 1)
    .map((point) => ({ candidate, configuration, point }))));
  if (run.front && run.front.length) {
    return run.front.map((variant) => all.find(({ candidate, configuration, point }) =>
      matchesVariant(variant, candidate, configuration) && point.period_frames === variant.period_frames)).filter(Boolean);
  }
  all.sort((a, b) => a.point.predicted_error - b.point.predicted_error || a.point.predicted_frame_ms - b.point.predicted_frame_ms);
  const front = [];
  for (const one of all) {
    if (!front.length || one.point.predicted_frame_ms < front[front.length - 1].point.predicted_frame_ms) front.push(one);
  }
  return front;
}

// The fastest point under the threshold; null if there is none. Period 1 reuses nothing and does not count.
function bestPoint(points, threshold) {
  const allowed = points.filter((point) => point.error <= threshold && point.period_frames !== 1);
  return allowed.length ? allowed.reduce((a, b) => (b.ms < a.ms ? b : a)) : null;
}

function isChoice(run, candidate, configuration) {
  const choice = run.choice;
  return run.isVariant && candidate.id === choice.candidate_id &&
    ['strategy', 'pattern', 'block_pixels', 'filter', 'encoding'].every((key) => configuration[key] === choice[key]);
}

// Each candidate is shown by its best configuration (the chosen one for the chosen candidate); the first eight candidates,
// the chosen first and then by their best frame time, get a colour that they keep everywhere on the page.
function emphasise(run) {
  const leaders = new Map();
  for (const curve of run.curves) {
    curve.chosen = isChoice(run, curve.candidate, curve.configuration);
    const leader = leaders.get(curve.candidate);
    if (!leader || (!leader.chosen && (curve.chosen || isBetter(curve, leader)))) leaders.set(curve.candidate, curve);
  }
  const chosenCandidate = (curve) => run.isVariant && curve.candidate.id === run.choice.candidate_id;
  const order = [...leaders.values()].sort((a, b) => chosenCandidate(b) - chosenCandidate(a) || (isBetter(a, b) ? -1 : 1));
  order.forEach((curve, rank) => {
    curve.candidate.leader = curve;
    curve.emphasised = rank < kMostEmphasised;
    if (curve.emphasised) curve.candidate.color = `var(--s${rank + 1})`;
  });
}

function isBetter(a, b) {
  if (Boolean(a.best) !== Boolean(b.best)) return Boolean(a.best);
  if (a.best) return a.best.ms < b.best.ms;
  return Math.min(...a.points.map((point) => point.error)) < Math.min(...b.points.map((point) => point.error));
}

const choicePoint = (run) => {
  const curve = run.curves.find((candidate) => candidate.chosen);
  return curve ? curve.points.find((point) => point.period_frames === run.choice.period_frames) || null : null;
};
