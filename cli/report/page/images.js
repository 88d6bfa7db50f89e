// The frame as original, cached, error and hits. A click magnifies all of them around the same pixel.

const kZoom = 4;

function drawImages(run) {
  const gain = run.images.error_gain;
  const kinds = [
    { key: 'original', title: 'Original', note: 'every pixel shaded' },
    { key: 'cached', title: 'Cached', note: run.isVariant ? `${run.choice.payload.map((value) => value.name).join(', ')} from the cache` : '' },
    { key: 'error', title: 'Error', note: `|cached − original|${gain === 1 ? '' : `, ${formatTick(gain)} times amplified`}` },
    { key: 'hit_miss', title: 'Hits and misses', note: hitLegend(run) },
  ].filter((kind) => run.pictures[kind.key]);
  if (!kinds.length) return hide('images');
  const where = run.images.session ? `Frame ${run.images.frame} of session ${run.images.session}. ` : '';
  byId('images-note').textContent = `${where}Click to look at pixels, all images at the same place; move to pan.`;
  const grid = byId('images-grid');
  grid.append(...kinds.map((kind) => html('figure', {},
    html('button', { class: 'view', type: 'button', 'aria-label': `Magnify ${kind.title}` },
      html('img', { src: run.pictures[kind.key], alt: `${kind.title} of frame ${run.images.frame}`, width: run.scenario.width, height: run.scenario.height })),
    html('figcaption', {}, html('b', {}, kind.title), ' ', kind.note))));
  addZoom(grid);
}

function hitLegend(run) {
  const isColor = (text) => /^#[0-9a-f]{6}$/i.test(text || '');
  const { hit_color: hit, miss_color: miss } = run.images;
  const rate = isNumber(run.choice.hit_rate) ? `${formatPercent(run.choice.hit_rate)} of covered pixels hit over the validation` : '';
  if (!isColor(hit) || !isColor(miss)) return rate;
  return html('span', {}, html('i', { class: 'swatch', color: hit }), 'hit ', html('i', { class: 'swatch second', color: miss }), `miss${rate ? `; ${rate}` : ''}`);
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
