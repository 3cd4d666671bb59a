'use strict';
// Answers of scenes of one instant, what each tolerance costs, and how the answers came about.
page.fillTable = (table, head, rows) => {
  const line = (cells, tag) => page.element('tr', {}, ...cells.map((cell) => (cell instanceof Node ? cell : page.element(tag, {}, cell))));
  table.append(line(head, 'th'), ...rows.map((row) => line(row, 'td')));
  return table;
};

/** Answers of one instant beside each other: the quality of grasps, or distances. */
page.startGrasps = () => {
  const section = page.byId('grasps'), { queries } = page.data;
  const single = queries.map((_, number) => page.leastOf(number)).map((points) => (points.length === 1 ? points[0] : null));
  if (!single.some((p) => p)) {
    section.remove();
    return;
  }
  const most = Math.max(...single.map((p) => (p && Number.isFinite(p.v) ? p.v : 0))) || 1;
  const rows = queries.map((query, number) => [query, single[number]]).filter(([, p]) => p).map(([query, p]) => {
    const bar = page.element('span', { class: 'bar', style: 'width:' + Math.min(100, 100 * p.v / most) + '%' });
    const cells = [query.name, page.digits(p.v) + query.unit, '[' + page.digits(p.l) + ', ' + page.digits(p.u) + ']'];
    if (page.data.grasp) cells.push(page.digits(p.v > 0 ? 1 / p.v : Infinity));
    return [...cells, page.element('td', { class: 'wide' }, bar)];
  });
  const head = page.data.grasp ? ['query', 'forces needed', 'certified', 'task resisted', ''] : ['query', 'answer', 'certified', ''];
  section.querySelector('h2').textContent = page.data.grasp ? 'Quality of each grasp' : 'Answers';
  if (page.data.grasp) {
    section.append(page.element('p', { class: 'hint' }, 'Forces needed: the sum of normal forces that resists the task; less is better. ' +
      'Task resisted: how much of the task forces of sum 1 resist.'));
  }
  section.append(page.fillTable(page.element('table', { id: 'grasp-table' }), head, rows));
};

page.logScale = (values, low, high) => {
  const from = Math.floor(Math.log10(Math.min(...values))), to = Math.max(Math.ceil(Math.log10(Math.max(...values)) + 1e-9), from + 1);
  const step = Math.ceil((to - from) / 6), ticks = [];
  for (let k = from; k <= to; k += step) ticks.push({ at: 10 ** k, text: page.digits(10 ** k) });
  return { at: (v) => low + (high - low) * (Math.log10(v) - from) / (to - from), ticks };
};

/** Queries for the same effects at several tolerances: time a frame against the certified gap. */
page.costs = (effects, list) => {
  list.sort((p, q) => q.tolerance - p.tolerance);
  const figure = page.element('figure', {}), { left, right, top, bottom } = page.box;
  const picture = page.svg('svg', { viewBox: '0 0 720 185', class: 'accuracy', role: 'img', 'aria-label': 'time a frame against certified gap' }, figure);
  const drawn = list.filter((q) => q.gap > 0 && q.frame_seconds > 0);
  const x = page.logScale(drawn.map((q) => q.gap), right - 20, left + 20), y = page.logScale(drawn.map((q) => 1e6 * q.frame_seconds), bottom, top);
  page.svg('path', { d: drawn.map((q, i) => (i ? 'L' : 'M') + x.at(q.gap).toFixed(2) + ' ' + y.at(1e6 * q.frame_seconds).toFixed(2)).join(''), fill: 'none', stroke: 'var(--line)', 'stroke-width': 1.6 }, picture);
  for (const q of drawn) {
    page.svg('circle', { cx: x.at(q.gap), cy: y.at(1e6 * q.frame_seconds), r: 4, fill: 'var(--line)' }, picture);
    page.svg('text', { x: x.at(q.gap), y: y.at(1e6 * q.frame_seconds) - 8, 'text-anchor': 'middle' }, picture, page.digits(q.tolerance));
  }
  page.axes(picture, x.at, y.at, x.ticks, y.ticks, { x: 'widest certified relative gap (more accurate to the right)', y: 'µs a frame' });
  figure.append(page.element('figcaption', {}, effects + ': each mark is a tolerance.'));
  const loosest = list[0].frame_seconds;
  const rows = list.map((q) => [page.digits(q.tolerance), page.digits(q.gap), page.duration(q.frame_seconds), page.digits(Number((q.frame_seconds / loosest).toPrecision(3)))]);
  figure.append(page.fillTable(page.element('table', { class: 'costs' }), ['tolerance', 'widest certified gap', 'time a frame', 'times the loosest'], rows));
  return figure;
};

page.startCosts = () => {
  const section = page.byId('accuracy'), groups = new Map();
  for (const q of page.data.queries) {
    const known = groups.get(q.effects) || [];
    known.push(q);
    groups.set(q.effects, known);
  }
  for (const [effects, list] of groups) {
    const measured = list.filter((q) => q.gap > 0 && q.frame_seconds > 0);
    if (new Set(measured.map((q) => q.tolerance)).size > 1) section.append(page.costs(effects, list));
  }
  if (!section.querySelector('figure')) section.remove();
};

/** Simulations of a scene at several steps and tolerances: what each cost, and how accurate it was. */
page.startSimulations = () => {
  const section = page.byId('simulations'), list = page.data.simulations;
  if (list.length === 0) {
    section.remove();
    return;
  }
  if (list.length === 1) section.querySelector('h2').textContent = 'The simulation';
  const drawn = list.filter((s) => s.error > 0 && s.seconds > 0), { left, right, top, bottom } = page.box;
  if (drawn.length > 1) {
    const figure = page.element('figure', {});
    const picture = page.svg('svg', { viewBox: '0 0 720 185', class: 'accuracy', role: 'img', 'aria-label': 'error against time' }, figure);
    const x = page.logScale(drawn.map((s) => s.seconds), left + 20, right - 20), y = page.logScale(drawn.map((s) => s.error), bottom, top);
    for (const s of drawn) {
      page.svg('circle', { cx: x.at(s.seconds), cy: y.at(s.error), r: 4, fill: 'var(--line)' }, picture);
      page.svg('text', { x: x.at(s.seconds), y: y.at(s.error) - 8, 'text-anchor': 'middle' }, picture, s.engine === 'raygauge' ? page.digits(s.step) : `${s.engine} ${page.digits(s.step)}`);
    }
    page.axes(picture, x.at, y.at, x.ticks, y.ticks, { x: 'seconds', y: 'distance from the finest / m' });
    figure.append(page.element('figcaption', {}, 'Each mark is a simulation, with its step in seconds.'));
    section.append(figure);
  }
  const head = ['engine', 'step', 'tolerance', 'time', 'steps', 'cuts', 'unproven', 'proven overlap', 'residual', 'energy change', 'energy rise', 'from the finest'];
  section.append(page.fillTable(page.element('table', { id: 'simulation-table' }), head, list.map((s) => [s.engine, page.digits(s.step), page.digits(s.tolerance),
    page.duration(s.seconds), s.steps, s.cuts, s.unproven, page.digits(s.overlap), s.residual === null ? '–' : page.digits(s.residual), page.digits(s.energy_change),
    page.digits(s.energy_rise), s.error === null ? '–' : page.digits(s.error)].map(String))));
};

page.startTallies = () => {
  const head = ['query', 'asked', 'solved', 'shared', 'broad phase', 'coherence', 'static', 'tolerance', 'widest gap', 'time a frame', 'time'];
  page.fillTable(page.byId('tallies'), head, page.data.queries.map((q) => [q.name, q.asked, q.solved, q.shared, q.broad_phase, q.coherence,
    q.standing, page.digits(q.tolerance), page.digits(q.gap), page.duration(q.frame_seconds), page.duration(q.seconds)].map(String)));
};
