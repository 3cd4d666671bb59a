'use strict';
// A curve for each query: the least distance (minus the depth of bodies that overlap; or growth) over its pairs, with its certified band.
page.box = { left: 62, right: 705, top: 12, bottom: 150 };

/** The least answer at each instant of a query. */
page.leastOf = (number) => {
  const best = new Map();
  for (const r of page.records) {
    if (r.query !== number) continue;
    const growth = r.distance === null, overlap = r.depth_lower > 0;
    const p = growth ? { v: r.growth, l: r.growth_lower, u: r.growth_upper }
      : overlap ? { v: -r.depth, l: -r.depth_upper, u: -r.depth_lower } : { v: r.distance, l: r.lower, u: r.upper };
    if (p.v === null) continue;
    const known = best.get(r.time);
    if (!known || p.v < known.v) best.set(r.time, { ...p, t: r.time, touches: r.touches, growth, pair: page.data.bodies[r.a] + ' – ' + page.data.bodies[r.b] });
  }
  return [...best.values()].sort((p, q) => p.t - q.t);
};

page.axes = (picture, x, y, xTicks, yTicks, labels) => {
  const { left, right, top, bottom } = page.box;
  page.svg('path', { d: `M${left} ${top}V${bottom}H${right}`, fill: 'none', stroke: 'var(--ink)' }, picture);
  for (const t of xTicks) {
    page.svg('path', { d: `M${x(t.at)} ${bottom}v4`, stroke: 'var(--ink)' }, picture);
    page.svg('text', { x: x(t.at), y: bottom + 15, 'text-anchor': 'middle' }, picture, t.text);
  }
  for (const t of yTicks) {
    page.svg('path', { d: `M${left} ${y(t.at)}h-4`, stroke: 'var(--ink)' }, picture);
    page.svg('text', { x: left - 6, y: y(t.at) + 4, 'text-anchor': 'end' }, picture, t.text);
  }
  page.svg('text', { x: (left + right) / 2, y: bottom + 29, 'text-anchor': 'middle' }, picture, labels.x);
  page.svg('text', { x: 12, y: (top + bottom) / 2, 'text-anchor': 'middle', transform: `rotate(-90 12 ${(top + bottom) / 2})` }, picture, labels.y);
};

page.tellPoint = (p, unit) => 'at ' + page.digits(p.t) + ' s: ' + page.digits(p.v) + unit + ', certified [' + page.digits(p.l) + ', ' +
  page.digits(p.u) + ']' + unit + ', ' + p.pair + (p.touches ? ', in contact' : '');

/** Lets pointer and keys choose a point: the readout tells it, the picture shows its time. */
page.chooseOn = (picture, readout, points, x, unit) => {
  let at = -1;
  const tell = (k) => {
    at = Math.max(0, Math.min(points.length - 1, k));
    readout.textContent = page.tellPoint(points[at], unit);
    picture.setAttribute('aria-valuetext', readout.textContent);
  };
  const nearest = (event) => {
    const box = picture.getBoundingClientRect(), place = (event.clientX - box.left) / box.width * 720;
    return points.reduce((best, p, k) => (Math.abs(x(p.t) - place) < Math.abs(x(points[best].t) - place) ? k : best), 0);
  };
  picture.addEventListener('pointermove', (event) => tell(nearest(event)));
  picture.addEventListener('click', (event) => { tell(nearest(event)); page.goTo(points[at].t); });
  picture.addEventListener('keydown', (event) => {
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: points.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    tell(to);
    page.goTo(points[at].t);
  });
};

page.timeline = (query, points) => {
  const { left, right, top, bottom } = page.box;
  const what = points[0].growth ? 'growth' : points.some((p) => p.v < 0) ? 'signed distance' : 'distance', unit = points[0].growth ? '' : query.unit;
  const figure = page.element('figure', {}), readout = page.element('output', {});
  const picture = page.svg('svg', { viewBox: '0 0 720 185', class: 'timeline', tabindex: 0, role: 'slider', 'aria-label': query.name + ', ' + what + ' over time' }, figure);
  figure.append(readout, page.element('figcaption', {}, query.name + ': least ' + what + ' over its pairs. Band: what is certified. Dots: in contact.'));
  const times = page.times.length ? page.times : points.map((p) => p.t), from = times[0], to = times[times.length - 1];
  const lowest = Math.min(...points.map((p) => p.l).filter(Number.isFinite), 0);
  const highest = Math.max(...points.map((p) => p.u).filter(Number.isFinite), ...points.map((p) => p.v).filter(Number.isFinite), 0) || (lowest < 0 ? 0 : 1);
  const x = (t) => left + (right - left) * (t - from) / (to - from || 1);
  const y = (v) => bottom - (bottom - top) * Math.min(1, (v - lowest) / (highest - lowest));
  const path = (list, key) => list.map((p, i) => (i ? 'L' : 'M') + x(p.t).toFixed(2) + ' ' + y(p[key]).toFixed(2)).join('');
  const mark = (at) => ({ at, text: page.digits(at) });
  page.svg('path', { d: path(points, 'u') + path([...points].reverse(), 'l').replace('M', 'L') + 'Z', fill: 'var(--band)', stroke: 'var(--band)', 'stroke-width': 4 }, picture);
  page.svg('path', { d: path(points, 'v'), class: 'curve', fill: 'none', stroke: 'var(--line)', 'stroke-width': 1.6 }, picture);
  if (lowest < 0) page.svg('path', { d: `M${left} ${y(0)}H${right}`, stroke: 'var(--grid)' }, picture);
  for (const p of points) if (p.touches) page.svg('circle', { cx: x(p.t), cy: y(p.v), r: 2.5, fill: page.kContact }, picture);
  page.axes(picture, x, y, page.niceTicks(from, to, 6).map(mark), page.niceTicks(lowest, highest, 5).map(mark), { x: 'time / s', y: what + (unit ? ' / m' : '') });
  const cursor = page.svg('path', { d: '', stroke: 'var(--mark)' }, picture);
  page.cursors.push((t) => cursor.setAttribute('d', 'M' + x(t) + ' ' + top + 'V' + bottom));
  page.chooseOn(picture, readout, points, x, unit);
  return figure;
};

page.startTimelines = () => {
  const section = page.byId('timelines');
  page.data.queries.forEach((query, number) => {
    const points = page.leastOf(number);
    if (points.length > 1) section.append(page.timeline(query, points));
  });
  if (!section.querySelector('figure')) section.remove();
};
