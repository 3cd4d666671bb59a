'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const drawing = data.drawing;
  const byId = (id) => document.getElementById(id);
  const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const digits = (x) => (x === null || x === undefined ? '–' : Number(x).toPrecision(5).replace(/\.?0+$/, ''));
  const times = drawing ? drawing.times : [];
  let frame = 0;
  let playing = false;

  byId('title').textContent = data.name;
  document.title = data.name + ' – raygauge scene';
  byId('summary').textContent = data.bodies.length + ' bodies, ' + data.records.length + ' answers, ' +
    data.queries.length + ' queries' + (data.finished ? '.' : '. The run is not finished.');

  // Records at instants, by the nearest frame; the latest answer of a pair stands until the next.
  const frameOf = (time) => {
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle] < time - 1e-12) low = middle + 1; else high = middle;
    }
    if (low > 0 && Math.abs(times[low - 1] - time) <= Math.abs(times[low] - time)) --low;
    return low;
  };
  const atFrame = times.map(() => []);
  for (const record of data.records) {
    if (drawing && record.kind === 'instant') atFrame[frameOf(record.time)].push(record);
  }
  let farthest = 0;
  for (const r of data.records) if (r.distance !== null) farthest = Math.max(farthest, r.distance);

  // 1: in contact, 0: as far as any recorded distance; null: nothing is known of the body.
  const nearness = (k) => {
    const near = data.bodies.map(() => null);
    for (const r of atFrame[k] || []) {
      let value = null;
      if (r.status === 'intersecting') value = 1;
      else if (r.distance !== null) value = 0.9 * (1 - r.distance / (farthest || 1));
      if (value === null) continue;
      for (const b of [r.a, r.b]) near[b] = Math.max(near[b] === null ? 0 : near[b], value);
    }
    return near;
  };
  const colour = (value) => {
    if (value === null) return '#8a949e';
    if (value >= 1) return '#dc2626';
    return 'hsl(' + Math.round(210 - 165 * value) + ', 70%, 52%)';
  };
  const pose = (body, k) => body.poses[Math.min(k, body.poses.length - 1)];

  const canvas = byId('canvas');
  const flatView = () => {
    const context = canvas.getContext('2d');
    const apply = (p, x, y) => [p[0] + p[2] * x + p[4] * y, p[1] + p[3] * x + p[5] * y];
    let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (const body of drawing.bodies) {
      for (const p of body.poses) {
        for (const part of body.parts) {
          for (let i = 0; i < part.vertices.length; i += 2) {
            const q = apply(p, part.vertices[i], part.vertices[i + 1]);
            for (const j of [0, 1]) { low[j] = Math.min(low[j], q[j]); high[j] = Math.max(high[j], q[j]); }
          }
        }
      }
    }
    const scale = 0.92 * Math.min(canvas.width / (high[0] - low[0]), canvas.height / (high[1] - low[1]));
    const place = (q) => [canvas.width / 2 + scale * (q[0] - (low[0] + high[0]) / 2),
      canvas.height / 2 - scale * (q[1] - (low[1] + high[1]) / 2)];
    return (k) => {
      context.fillStyle = style('--soft');
      context.fillRect(0, 0, canvas.width, canvas.height);
      const near = nearness(k);
      drawing.bodies.forEach((body, number) => {
        context.fillStyle = colour(near[number]);
        for (const part of body.parts) {
          context.beginPath();
          for (let i = 0; i < part.vertices.length; i += 2) {
            const [x, y] = place(apply(pose(body, k), part.vertices[i], part.vertices[i + 1]));
            if (i === 0) context.moveTo(x, y); else context.lineTo(x, y);
          }
          context.closePath();
          context.fill();
        }
      });
      context.strokeStyle = context.fillStyle = style('--mark');
      context.lineWidth = 2;
      for (const r of atFrame[k] || []) {
        if (!r.pa) continue;
        const ends = [place(r.pa), place(r.pb)];
        context.beginPath();
        context.moveTo(...ends[0]);
        context.lineTo(...ends[1]);
        context.stroke();
        for (const [x, y] of ends) { context.beginPath(); context.arc(x, y, 4, 0, 7); context.fill(); }
      }
    };
  };

  const spaceView = () => {
    const renderer = new THREE.WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
    renderer.setSize(canvas.width, canvas.height, false);
    const scene = new THREE.Scene();
    const camera = new THREE.PerspectiveCamera(40, canvas.width / canvas.height, 0.001, 1e6);
    camera.up.set(0, 0, 1);
    scene.add(new THREE.HemisphereLight(0xffffff, 0x555566, 0.85));
    const sun = new THREE.DirectionalLight(0xffffff, 0.5);
    sun.position.set(1, -2, 3);
    scene.add(sun);
    const groups = drawing.bodies.map((body) => {
      const group = new THREE.Group();
      group.matrixAutoUpdate = false;
      group.userData.material = new THREE.MeshLambertMaterial({side: THREE.DoubleSide, flatShading: true});
      for (const part of body.parts) {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(part.vertices), 3));
        geometry.setIndex(part.triangles);
        geometry.computeVertexNormals();
        group.add(new THREE.Mesh(geometry, group.userData.material));
      }
      scene.add(group);
      return group;
    });
    const links = new THREE.Group();
    scene.add(links);
    const put = (k) => groups.forEach((group, number) => {
      const p = pose(drawing.bodies[number], k);
      group.matrix.set(p[3], p[6], p[9], p[0], p[4], p[7], p[10], p[1], p[5], p[8], p[11], p[2], 0, 0, 0, 1);
      group.updateMatrixWorld(true);
    });
    const bounds = new THREE.Box3();
    for (let k = 0; k < times.length; k += Math.max(1, times.length >> 4)) {
      put(k);
      for (const group of groups) bounds.expandByObject(group);
    }
    const middle = bounds.getCenter(new THREE.Vector3());
    const size = bounds.getSize(new THREE.Vector3()).length();
    let around = -0.9, above = 0.45, away = 1.35 * size;
    const draw = (k) => {
      put(k);
      const near = nearness(k);
      groups.forEach((group, number) => group.userData.material.color.set(colour(near[number])));
      while (links.children.length) links.remove(links.children[0]);
      const material = new THREE.MeshBasicMaterial({color: style('--mark'), depthTest: false});
      for (const r of atFrame[k] || []) {
        if (!r.pa) continue;
        const ends = [new THREE.Vector3(...r.pa), new THREE.Vector3(...r.pb)];
        links.add(new THREE.Line(new THREE.BufferGeometry().setFromPoints(ends),
          new THREE.LineBasicMaterial({color: style('--mark'), depthTest: false})));
        for (const end of ends) {
          const dot = new THREE.Mesh(new THREE.SphereBufferGeometry(size / 150, 12, 8), material);
          dot.position.copy(end);
          links.add(dot);
        }
      }
      camera.position.set(middle.x + away * Math.cos(above) * Math.cos(around),
        middle.y + away * Math.cos(above) * Math.sin(around), middle.z + away * Math.sin(above));
      camera.lookAt(middle);
      renderer.setClearColor(style('--soft'));
      renderer.render(scene, camera);
    };
    let held = null;
    canvas.addEventListener('pointerdown', (event) => { held = [event.clientX, event.clientY]; });
    addEventListener('pointerup', () => { held = null; });
    addEventListener('pointermove', (event) => {
      if (!held) return;
      around -= (event.clientX - held[0]) / 150;
      above = Math.max(-1.5, Math.min(1.5, above + (event.clientY - held[1]) / 150));
      held = [event.clientX, event.clientY];
      draw(frame);
    });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      away *= Math.exp(event.deltaY / 800);
      draw(frame);
    }, {passive: false});
    return draw;
  };

  let draw = () => {};
  if (drawing) {
    try {
      draw = drawing.dimension === 2 ? flatView() : spaceView();
    } catch (error) {
      byId('view').textContent = 'This browser has no WebGL; the timelines below are complete without it.';
    }
  } else {
    byId('stage').remove();
  }

  const cursors = [];
  const show = (k) => {
    if (!drawing) return;
    frame = Math.max(0, Math.min(times.length - 1, k));
    byId('slider').value = frame;
    byId('clock').textContent = digits(times[frame]) + ' s';
    for (const move of cursors) move(times[frame]);
    draw(frame);
  };
  if (drawing) {
    byId('slider').max = times.length - 1;
    byId('slider').addEventListener('input', (event) => { playing = false; label(); show(Number(event.target.value)); });
  }
  const label = () => { if (drawing) byId('play').textContent = playing ? 'Pause' : 'Play'; };
  let previous = 0;
  const step = (now) => {
    if (!playing) return;
    if (now - previous > 40) { previous = now; show(frame + 1 < times.length ? frame + 1 : 0); }
    requestAnimationFrame(step);
  };
  const toggle = () => { playing = !playing; label(); if (playing) requestAnimationFrame(step); };
  if (drawing) byId('play').addEventListener('click', toggle);
  addEventListener('keydown', (event) => {
    if (!drawing || event.target.tagName === 'INPUT') return;
    if (event.key === ' ' && event.target.tagName !== 'BUTTON') { event.preventDefault(); toggle(); }
    if (event.key === 'ArrowRight') { playing = false; label(); show(frame + 1); }
    if (event.key === 'ArrowLeft') { playing = false; label(); show(frame - 1); }
  });

  // Timelines: the least distance (or growth) over the pairs of a query, with its certified band.
  const svg = (name, attributes, parent) => {
    const node = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    parent.appendChild(node);
    return node;
  };
  data.queries.forEach((query, number) => {
    const best = new Map();
    for (const r of data.records) {
      if (r.query !== number || r.kind !== 'instant') continue;
      const useGrowth = r.distance === null;
      const point = useGrowth ? {v: r.growth, l: r.growth_lower, u: r.growth_upper} : {v: r.distance, l: r.lower, u: r.upper};
      if (point.v === null) continue;
      const known = best.get(r.time);
      if (!known || point.v < known.v) best.set(r.time, {...point, t: r.time, touching: r.status === 'intersecting'});
    }
    const points = [...best.values()].sort((x, y) => x.t - y.t);
    if (points.length < 2) return;
    const figure = document.createElement('figure');
    const picture = svg('svg', {viewBox: '0 0 720 170', role: 'img', class: 'timeline'}, figure);
    const caption = document.createElement('figcaption');
    caption.textContent = query.name + ': ' + query.effects + ', least over its pairs; the band is what is certified.';
    figure.appendChild(caption);
    byId('timelines').appendChild(figure);
    const from = times.length ? times[0] : points[0].t;
    const to = times.length ? times[times.length - 1] : points[points.length - 1].t;
    const top = Math.max(...points.map((p) => p.u)) || 1;
    const x = (t) => 50 + 655 * (t - from) / (to - from || 1);
    const y = (v) => 145 - 130 * v / top;
    const path = (list, key) => list.map((p, i) => (i ? 'L' : 'M') + x(p.t).toFixed(2) + ' ' + y(p[key]).toFixed(2)).join('');
    svg('path', {d: path(points, 'u') + path([...points].reverse(), 'l').replace('M', 'L') + 'Z', fill: 'var(--band)', stroke: 'var(--band)', 'stroke-width': 4}, picture);
    svg('path', {d: path(points, 'v'), fill: 'none', stroke: 'var(--line)', 'stroke-width': 1.6}, picture);
    for (const p of points) if (p.touching) svg('circle', {cx: x(p.t), cy: y(p.v), r: 2.5, fill: 'var(--mark)'}, picture);
    svg('path', {d: 'M50 10V145H705', fill: 'none', stroke: 'var(--ink)'}, picture);
    svg('text', {x: 46, y: 18, 'text-anchor': 'end'}, picture).textContent = digits(top);
    svg('text', {x: 46, y: 148, 'text-anchor': 'end'}, picture).textContent = '0';
    svg('text', {x: 50, y: 162}, picture).textContent = digits(from) + ' s';
    svg('text', {x: 705, y: 162, 'text-anchor': 'end'}, picture).textContent = digits(to) + ' s';
    const cursor = svg('path', {d: 'M50 10V145', stroke: 'var(--mark)'}, picture);
    cursors.push((t) => cursor.setAttribute('d', 'M' + x(t) + ' 10V145'));
    picture.addEventListener('click', (event) => {
      const box = picture.getBoundingClientRect();
      const t = from + (to - from) * ((event.clientX - box.left) / box.width * 720 - 50) / 655;
      if (drawing) show(frameOf(t));
    });
  });

  data.events.slice(0, 60).forEach((event, number) => {
    const item = document.createElement('li');
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = event.text;
    if (drawing && event.time !== null) button.addEventListener('click', () => { playing = false; label(); show(frameOf(event.time)); });
    item.appendChild(button);
    if (drawing && event.time !== null && number < 12 && byId('canvas')) {
      draw(frameOf(event.time));
      const still = document.createElement('img');
      still.alt = event.text;
      still.src = canvas.toDataURL('image/png');
      item.appendChild(still);
    }
    byId('event-list').appendChild(item);
  });
  if (!data.events.length) byId('events').remove();

  // What accuracy costs: queries for the same effects at several tolerances, time a frame against certified gap.
  const groups = new Map();
  for (const q of data.queries) {
    if (!(q.gap > 0) || !(q.frame_seconds > 0)) continue;
    if (!groups.has(q.effects)) groups.set(q.effects, []);
    groups.get(q.effects).push(q);
  }
  const curves = [...groups].filter(([, list]) => new Set(list.map((q) => q.tolerance)).size > 1);
  if (!curves.length) byId('accuracy').remove();
  for (const [effects, list] of curves) {
    list.sort((p, q) => p.gap - q.gap);
    const figure = document.createElement('figure');
    const picture = svg('svg', {viewBox: '0 0 720 220', role: 'img', class: 'accuracy'}, figure);
    const caption = document.createElement('figcaption');
    caption.textContent = effects + ': seconds a frame against the widest certified gap (upper - lower) / upper, a mark for each tolerance.';
    figure.appendChild(caption);
    byId('accuracy').appendChild(figure);
    const scale = (values, low, high) => {
      const from = Math.floor(Math.log10(Math.min(...values))), to = Math.ceil(Math.log10(Math.max(...values)) + 1e-9);
      return {from, to: Math.max(to, from + 1), at: (v) => low + (high - low) * (Math.log10(v) - from) / (Math.max(to, from + 1) - from)};
    };
    const x = scale(list.map((q) => q.gap), 70, 690), y = scale(list.map((q) => q.frame_seconds), 180, 15);
    svg('path', {d: list.map((q, i) => (i ? 'L' : 'M') + x.at(q.gap).toFixed(2) + ' ' + y.at(q.frame_seconds).toFixed(2)).join(''), fill: 'none', stroke: 'var(--line)', 'stroke-width': 1.6}, picture);
    for (const q of list) {
      svg('circle', {cx: x.at(q.gap), cy: y.at(q.frame_seconds), r: 4, fill: 'var(--mark)'}, picture);
      svg('text', {x: x.at(q.gap) + 6, y: y.at(q.frame_seconds) - 7}, picture).textContent = digits(q.tolerance);
    }
    svg('path', {d: 'M70 10V180H700', fill: 'none', stroke: 'var(--ink)'}, picture);
    for (const end of [x.from, x.to]) svg('text', {x: x.at(10 ** end), y: 198, 'text-anchor': 'middle'}, picture).textContent = '1e' + end;
    for (const end of [y.from, y.to]) svg('text', {x: 64, y: y.at(10 ** end) + 4, 'text-anchor': 'end'}, picture).textContent = '1e' + end + ' s';
  }

  const table = byId('tallies');
  const row = (cells, tag) => {
    const line = table.insertRow();
    for (const text of cells) { const cell = document.createElement(tag); cell.textContent = text; line.appendChild(cell); }
  };
  row(['query', 'asked', 'solved', 'shared', 'broad phase', 'coherence', 'static', 'tolerance', 'widest gap', 'seconds a frame', 'seconds'], 'th');
  for (const q of data.queries) row([q.name, q.asked, q.solved, q.shared, q.broad_phase, q.coherence, q.standing, digits(q.tolerance), digits(q.gap), digits(q.frame_seconds), digits(q.seconds)], 'td');
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => show(frame));
  show(0);
})();
