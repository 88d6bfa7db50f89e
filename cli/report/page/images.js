// The frame as original, cached, error, hits and payload, of what the slider picks and of the candidate that is held. A wipe goes from
// original to cached; a click magnifies all images around the same pixel.

const kZoom = 4;

function drawImages(run, view) {
  const none = !run.pictures.original && !Object.keys(run.shelf).length;
  if (none) return hide('images');
  drawStrip(run, view);
  view.onChange(() => {
    view.stripFrame = null;
    showImages(run, view);
  });
}

// The pictures nearest to a point: the point itself, its configuration at another period, its candidate in another configuration.
function picturesOf(run, candidate, configuration, period) {
  if (!run.evidence || !candidate) return null;
  const own = run.evidence.pictures.filter((one) => one.variant.candidate_id === candidate.id);
  const same = own.filter((one) => configuration && matchesVariant(one.variant, candidate, configuration));
  const found = same.find((one) => one.variant.period_frames === period) || same[0] || own[0];
  if (!found || !run.shelf[found.cached]) return null;
  const of = (name) => run.shelf[name] || null;
  return {
    original: of(run.evidence.original), cached: of(found.cached), error: of(found.error), hit_miss: of(found.hit_miss), payload: of(found.payload),
    variant: found.variant, exact: found.variant.period_frames === period && same.includes(found), frame: run.evidence.frame, session: run.evidence.session,
  };
}

function picturesOfPick(run, view) {
  const { pick } = view;
  if (pick.kind === 'original' && !run.isVariant) return null;
  const found = picturesOf(run, pick.candidate, pick.configuration, pick.period);
  if (found) return found;
  if (pick.kind !== 'choice' || !run.pictures.cached) return null;
  return { ...run.pictures, payload: null, variant: run.choice, exact: true, frame: run.images.frame, session: run.images.session };
}

function showImages(run, view) {
  const grid = byId('images-grid');
  grid.replaceChildren();
  grid.classList.remove('zoomed');
  const pictures = picturesOfPick(run, view);
  const held = view.held && picturesOf(run, view.held, view.held.leader && view.held.leader.configuration, undefined);
  byId('images-note').textContent = imagesNote(run, view, pictures);
  if (pictures) grid.append(wipe(pictures.original, pictures.cached, 'images-wipe'), ...panels(run, pictures));
  else if (run.evidence && run.shelf[run.evidence.original]) grid.append(figure(run, run.shelf[run.evidence.original], 'Original', 'every pixel shaded'));
  if (held && held.variant !== (pictures && pictures.variant)) {
    grid.append(html('p', { class: 'images-held' }, html('span', { class: 'swatch', color: view.held.color }), html('b', {}, `Held: ${view.held.name || view.held.id}`),
      ` ${formatVariant(held.variant)}, ${formatPeriodLong(held.variant.period_frames)}`));
    grid.append(wipe(held.original, held.cached, 'held-wipe'), ...panels(run, held));
  } else if (view.held && !held) {
    grid.append(html('p', { class: 'images-held sub' }, `No pictures were rendered of ${view.held.name || view.held.id}.`));
  }
  addZoom(grid);
}

function imagesNote(run, view, pictures) {
  if (!pictures) return view.pick.kind === 'original' ? 'At this threshold the original is played.' : 'No pictures were rendered of this point.';
  const other = pictures.exact ? '' : ` Rendered at ${formatVariant(pictures.variant)}, ${formatPeriodLong(pictures.variant.period_frames)}: the nearest to what the slider picks.`;
  return `Frame ${pictures.frame} of session ${pictures.session}.${other} Pull the line from original (left) to cached (right). Click an image to look at pixels, all at the same place.`;
}

function panels(run, pictures) {
  const gain = run.images.error_gain > 1 ? run.images.error_gain : 8;
  return [
    pictures.error && figure(run, pictures.error, 'Error', `|cached − original|, ${formatTick(gain)} times amplified`),
    pictures.hit_miss && figure(run, pictures.hit_miss, 'Hits and misses', hitLegend(run)),
    pictures.payload && figure(run, pictures.payload, 'Payload', 'each channel over its range in this frame'),
  ].filter(Boolean);
}

const figure = (run, source, title, note) => html('figure', {},
  html('button', { class: 'view', type: 'button', 'aria-label': `Magnify ${title}` }, html('img', { src: source, alt: title, width: run.scenario.width || null, height: run.scenario.height || null })),
  html('figcaption', {}, html('b', {}, title), ' ', note));

// Two images on one another; the upper one is cut off left of the line.
function wipe(original, cached, id) {
  const upper = html('div', { class: 'wipe-upper' }, html('img', { src: cached, alt: 'Cached' }));
  const line = html('div', { class: 'wipe-line' });
  const slider = html('input', { type: 'range', min: 0, max: 1000, value: 500, id, 'aria-label': 'wipe between original and cached' });
  const apply = () => {
    const share = Number(slider.value) / 10;
    upper.style.clipPath = `inset(0 0 0 ${share}%)`;
    line.style.left = `${share}%`;
  };
  slider.addEventListener('input', apply);
  apply();
  return html('figure', { class: 'wipe' },
    html('div', { class: 'wipe-box' }, html('img', { src: original, alt: 'Original' }), upper, line, html('span', { class: 'wipe-left' }, 'original'), html('span', { class: 'wipe-right' }, 'cached'), slider));
}

// Frames through the validation session with the choice; a click shows that frame in the wipe.
function drawStrip(run, view) {
  const frames = run.evidence ? run.evidence.strip.filter((frame) => run.shelf[frame.cached] && run.shelf[frame.original]) : [];
  if (!frames.length) return hide('strip');
  const session = run.validation.find((one) => one.name === run.evidence.session);
  const figuresOf = (frame) => {
    const row = session && session.frames.find((one) => one.frame === frame.frame);
    return row ? `error ${formatNumber(row.error)}${isNumber(row.hit_rate) ? `, hits ${formatPercent(row.hit_rate)}` : ''}` : '';
  };
  byId('strip').append(html('h3', {}, `Through session ${run.evidence.session}`), html('div', { class: 'thumbs' }, frames.map((frame) => {
    const button = html('button', { type: 'button', class: 'thumb', 'data-frame': frame.frame, 'aria-label': `show frame ${frame.frame}` },
      html('img', { src: run.shelf[frame.cached], alt: '' }), html('span', {}, `frame ${frame.frame}`), html('span', { class: 'sub' }, figuresOf(frame)));
    button.addEventListener('click', () => {
      const figure = byId('images-grid').querySelector('.wipe');
      if (!figure) return;
      figure.replaceWith(wipe(run.shelf[frame.original], run.shelf[frame.cached], 'images-wipe'));
      byId('images-note').textContent = `Wipe: frame ${frame.frame} of session ${run.evidence.session}, reduced in size. ${figuresOf(frame)}. Move the threshold or click a point to come back.`;
      for (const other of byId('strip').querySelectorAll('.thumb')) other.classList.toggle('shown', other === button);
    });
    return button;
  })));
  view.onChange(() => byId('strip').querySelectorAll('.thumb').forEach((thumb) => thumb.classList.remove('shown')));
}

function hitLegend(run) {
  const isColor = (text) => /^#[0-9a-f]{6}$/i.test(text || '');
  const hit = isColor(run.images.hit_color) ? run.images.hit_color : '#2a9d4b';
  const miss = isColor(run.images.miss_color) ? run.images.miss_color : '#d1495b';
  return html('span', {}, html('i', { class: 'swatch', color: hit }), 'hit ', html('i', { class: 'swatch second', color: miss }), 'miss');
}

function addZoom(grid) {
  let zoomed = false;
  const apply = (fx, fy) => {
    grid.classList.toggle('zoomed', zoomed);
    for (const image of grid.querySelectorAll('img')) {
      image.style.transformOrigin = `${fx * 100}% ${fy * 100}%`;
      image.style.transform = zoomed ? `scale(${kZoom})` : '';
    }
  };
  const place = (event, view) => {
    const box = view.getBoundingClientRect();
    if (event.type === 'click' && event.detail === 0) return [0.5, 0.5];  // by keyboard
    const clamp = (value) => Math.min(1, Math.max(0, value));
    return [clamp((event.clientX - box.left) / box.width), clamp((event.clientY - box.top) / box.height)];
  };
  for (const view of grid.querySelectorAll('.view')) {
    view.addEventListener('click', (event) => {
      zoomed = !zoomed;
      apply(...place(event, view));
    });
    view.addEventListener('pointermove', (event) => {
      if (zoomed) apply(...place(event, view));
    });
  }
}
