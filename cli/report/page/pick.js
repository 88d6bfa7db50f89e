// What is looked at: a threshold, the point that it picks from the Pareto front, and a candidate that is held for comparison.
// Everything that shows one of them registers with onChange and is told when it changes.

const kSliderSteps = 400;

function makeView(run) {
  const listeners = [];
  const view = {
    threshold: run.threshold.value,
    pick: pickAt(run, run.threshold.value),
    held: null,
    onChange: (listener) => {
      listeners.push(listener);
      listener(view);
    },
    setThreshold: (threshold) => {
      view.threshold = threshold;
      view.pick = pickAt(run, threshold);
      listeners.forEach((listener) => listener(view));
    },
    hold: (candidate) => {
      view.held = view.held === candidate ? null : candidate;
      listeners.forEach((listener) => listener(view));
    },
  };
  return view;
}

const marginOf = (run) => (isNumber(run.threshold.margin) ? run.threshold.margin : 0);

// The fastest point of the front whose predicted error keeps the margin below the threshold. At the run's own threshold it is what
// validation accepted, which need not be what was predicted.
function pickAt(run, threshold) {
  if (threshold === run.threshold.value) return run.isVariant ? choicePick(run) : originalPick(run);
  const allowed = run.frontPoints.filter(({ point }) => point.predicted_error <= threshold * (1 - marginOf(run)) && point.predicted_frame_ms < run.baseline_ms);
  if (!allowed.length) return originalPick(run);
  return trainedPick(run, allowed.reduce((a, b) => (b.point.predicted_frame_ms < a.point.predicted_frame_ms ? b : a)));
}

const originalPick = (run) => ({ kind: 'original', measured_ms: run.baseline_ms });

function choicePick(run) {
  const { choice } = run;
  const candidate = run.candidates.find((one) => one.id === choice.candidate_id) || null;
  const configuration = candidate && candidate.configurations.find((one) => isChoice(run, candidate, one));
  return {
    kind: 'choice', candidate, configuration, variant: choice, period: choice.period_frames,
    predicted_error: choice.predicted_error, measured_error: choice.measured_error,
    predicted_ms: choice.predicted_frame_ms, measured_ms: choice.measured_frame_ms,
    predicted_speedup: choice.predicted_speedup, measured_speedup: choice.measured_speedup, speedup_ci: choice.speedup_ci95,
    hit_rate: choice.hit_rate, cache: choice.cache_bytes_per_pixel, limit_ms: run.limit.frame_ms,
  };
}

function trainedPick(run, { candidate, configuration, point }) {
  return {
    kind: 'trained', candidate, configuration, variant: configuration, period: point.period_frames,
    predicted_error: point.predicted_error, measured_error: point.measured_error,
    predicted_ms: point.predicted_frame_ms, measured_ms: point.measured_frame_ms, ms_ci: point.measured_frame_ms_ci95,
    predicted_speedup: run.baseline_ms / point.predicted_frame_ms, measured_speedup: point.measured_speedup, speedup_ci: point.speedup_ci95,
    hit_rate: point.predicted_hit_rate, cache: configuration.cache_bytes_per_pixel, limit_ms: candidate.limit_frame_ms,
  };
}

// Thresholds at which the pick changes, ascending, the run's own among them.
function thresholdStops(run) {
  const stops = run.frontPoints.map(({ point }) => point.predicted_error / (1 - marginOf(run))).filter((stop) => stop > 0);
  return [...new Set([...stops, run.threshold.value])].sort((a, b) => a - b);
}

function drawSlider(run, view) {
  const stops = thresholdStops(run);
  if (!run.frontPoints.length || !isNumber(run.baseline_ms)) return hide('slider');
  const lo = stops[0] / 1.3;
  const hi = stops[stops.length - 1] * 1.3;
  const toStep = logScale(lo, hi, 0, kSliderSteps);
  const toThreshold = (step) => {
    if (Math.round(toStep(run.threshold.value)) === step) return run.threshold.value;
    // Rounding to the digits shown must not fall short of the stop that the step stands for.
    const stop = stops.find((one) => Math.round(toStep(one)) === step);
    return stop || Number((lo * (hi / lo) ** (step / kSliderSteps)).toPrecision(4));
  };
  const slider = html('input', { type: 'range', id: 'threshold', min: 0, max: kSliderSteps, step: 1, 'aria-label': `largest allowed error, ${run.threshold.metric}` });
  const shown = html('output', { id: 'threshold-value', for: 'threshold' });
  const back = html('button', { type: 'button', class: 'plain-button', id: 'threshold-back' }, `back to ${formatTick(run.threshold.value)}`);
  slider.addEventListener('input', () => view.setThreshold(toThreshold(Number(slider.value))));
  back.addEventListener('click', () => view.setThreshold(run.threshold.value));
  const marks = svg('svg', { class: 'stops', viewBox: `0 0 ${kSliderSteps} 10`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
    stops.map((stop) => svg('line', { x1: toStep(stop), x2: toStep(stop), y1: 0, y2: 7, class: stop === run.threshold.value ? 'own' : '' })));
  byId('slider').append(html('label', { for: 'threshold' }, `Allowed error, ${run.threshold.metric}`), html('div', { class: 'track' }, slider, marks), shown, back);
  view.onChange(() => {
    slider.value = Math.round(toStep(view.threshold));
    shown.textContent = formatTick(Number(view.threshold.toPrecision(3)));
    back.hidden = view.threshold === run.threshold.value;
  });
}

// The line under the slider: what is chosen, and how far it has been tested.
function drawPick(run, view) {
  view.onChange(({ pick, threshold }) => {
    const place = byId('pick');
    if (pick.kind === 'original') {
      place.replaceChildren(html('b', {}, 'the original'), ' ', threshold === run.threshold.value ? run.choice.reason || '' : 'no trained variant is both predicted to keep this threshold and to be faster');
      return;
    }
    const { candidate, variant } = pick;
    const name = candidate ? candidate.name || candidate.id : run.choice.candidate_id;
    place.replaceChildren(
      html('span', { class: 'swatch', color: candidate && candidate.color }), html('b', {}, name), ' ',
      candidate && html('code', { class: 'sub' }, candidate.type), ' ', candidate && html('code', { class: 'sub' }, formatShortPlace(candidate)),
      html('span', { class: 'dot' }, '·'), formatVariant(variant), html('span', { class: 'dot' }, '·'), formatPeriodLong(pick.period), ' ',
      pick.kind === 'choice' ? html('span', { class: 'tag good' }, 'validated') : html('span', { class: 'tag' }, 'from training, not validated'));
  });
}
