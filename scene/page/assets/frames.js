'use strict';
// Which answers belong to which picture, and the colours of bodies.
page.drawing = page.data.drawing;
page.times = page.drawing ? page.drawing.times : [];

/** The picture nearest to a time. */
page.frameOf = (time) => {
  const times = page.times;
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time - 1e-12) low = middle + 1; else high = middle;
  }
  if (low > 0 && Math.abs(times[low - 1] - time) <= Math.abs(times[low] - time)) --low;
  return low;
};

/** The answers at instants, an object each. */
page.records = (() => {
  const columns = page.data.records, names = Object.keys(columns);
  return columns.time.map((_, i) => Object.fromEntries(names.map((name) => [name, page.number(columns[name][i])])));
})();
page.atFrame = page.times.map(() => []);
if (page.drawing) for (const record of page.records) page.atFrame[page.frameOf(record.time)].push(record);

page.farthest = page.records.reduce((most, r) => (r.distance !== null && Number.isFinite(r.distance) ? Math.max(most, r.distance) : most), 0);

/** For each body 1: in contact, 0: as far as any recorded distance; null: nothing was asked. */
page.nearness = (k) => {
  const near = page.data.bodies.map(() => null);
  for (const r of page.atFrame[k] || []) {
    let value = null;
    if (r.touches) value = 1;
    else if (r.distance !== null) value = 0.9 * (1 - Math.min(1, r.distance / (page.farthest || 1)));
    if (value === null) continue;
    for (const b of [r.a, r.b]) near[b] = Math.max(near[b] === null ? 0 : near[b], value);
  }
  return near;
};
page.kContact = '#dc2626';
page.kUnasked = '#8a949e';
page.colour = (value) => {
  if (value === null) return page.kUnasked;
  if (value >= 1) return page.kContact;
  return 'hsl(' + Math.round(210 - 165 * value) + ', 70%, 52%)';
};
page.pose = (body, k) => body.poses[Math.min(k, body.poses.length - 1)];

/** The words for every colour of the picture. */
page.showLegend = (gridStep) => {
  const entry = (swatch, words) => page.element('span', {}, swatch, words);
  const patch = (background, more) => page.element('span', { class: 'swatch ' + (more || ''), style: 'background:' + background });
  const legend = page.byId('legend');
  legend.replaceChildren(entry(patch(page.kContact), 'in contact'));
  if (page.farthest > 0) {
    const stops = [0.9, 0.7, 0.5, 0.25, 0].map(page.colour).join(',');
    const unit = page.data.queries.some((q) => q.unit) ? ' m' : '';
    legend.append(entry(patch('linear-gradient(to right,' + stops + ')', 'scale'), 'distance 0 … ' + page.digits(page.farthest) + unit));
  }
  legend.append(entry(patch(page.kUnasked), page.farthest > 0 ? 'no distance asked at this time' : 'apart, or not asked'));
  if (page.records.some((r) => r.pa)) legend.append(entry(patch('var(--mark)'), page.records.some((r) => r.depth > 0) ? 'closest points, or points in contact' : 'closest points'));
  legend.append(entry(patch('var(--grid)'), (page.drawing.dimension === 3 ? 'ground' : 'grid') + ': squares of ' + page.digits(gridStep) + ' m'));
};
