'use strict';
// The picture of a scene in the plane.
page.flatView = (canvas) => {
  const context = canvas.getContext('2d'), { drawing } = page;
  const apply = (p, x, y) => [p[0] + p[2] * x + p[4] * y, p[1] + p[3] * x + p[5] * y];
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
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
  const scale = 0.9 * Math.min(canvas.width / (high[0] - low[0]), canvas.height / (high[1] - low[1]));
  const middle = [0, 1].map((j) => (low[j] + high[j]) / 2);
  const place = (q) => [canvas.width / 2 + scale * (q[0] - middle[0]), canvas.height / 2 - scale * (q[1] - middle[1])];
  const ends = (j) => { const half = (j ? canvas.height : canvas.width) / 2 / scale; return [middle[j] - half, middle[j] + half]; };
  const step = page.niceStep(canvas.width / scale, 9);
  page.showLegend(step);

  const drawGrid = () => {
    context.strokeStyle = page.style('--grid');
    context.fillStyle = page.style('--muted');
    context.font = '15px system-ui, sans-serif';
    context.lineWidth = 1;
    for (const j of [0, 1]) {
      const [from, to] = ends(j);
      for (let k = Math.ceil(from / step); k * step <= to; ++k) {
        const at = place(j ? [0, k * step] : [k * step, 0])[j];
        context.beginPath();
        if (j) { context.moveTo(0, at); context.lineTo(canvas.width, at); } else { context.moveTo(at, 0); context.lineTo(at, canvas.height); }
        context.stroke();
        const text = page.digits(k * step);
        if (j) context.fillText(text, 4, at - 3); else context.fillText(text, at + 3, canvas.height - 5);
      }
    }
    context.fillText('x / m', canvas.width - 48, canvas.height - 22);
    context.fillText('y / m', 4, 16);
  };
  const outline = (body, part, k) => {
    context.beginPath();
    for (let i = 0; i < part.vertices.length; i += 2) {
      const [x, y] = place(apply(page.pose(body, k), part.vertices[i], part.vertices[i + 1]));
      if (i === 0) context.moveTo(x, y); else context.lineTo(x, y);
    }
    context.closePath();
  };
  const drawBodies = (k) => {
    const near = page.nearness(k);
    drawing.bodies.forEach((body, number) => {
      context.fillStyle = page.colour(near[number]);
      context.strokeStyle = page.style('--ink');
      context.lineWidth = page.highlit === number ? 4 : 1;
      for (const part of body.parts) { outline(body, part, k); context.fill(); context.stroke(); }
    });
  };
  const drawClosest = (k) => {
    context.strokeStyle = context.fillStyle = page.style('--mark');
    context.lineWidth = 2;
    for (const r of page.atFrame[k] || []) {
      if (!r.pa) continue;
      const line = [place(r.pa), place(r.pb)];
      context.beginPath();
      context.moveTo(...line[0]);
      context.lineTo(...line[1]);
      context.stroke();
      for (const [x, y] of line) { context.beginPath(); context.arc(x, y, 4, 0, 7); context.fill(); }
    }
  };
  return {
    draw: (k) => {
      context.fillStyle = page.style('--soft');
      context.fillRect(0, 0, canvas.width, canvas.height);
      drawGrid();
      drawBodies(k);
      drawClosest(k);
    },
    pick: (x, y) => {
      let found = null;
      drawing.bodies.forEach((body, number) => {
        for (const part of body.parts) { outline(body, part, page.frame); if (context.isPointInPath(x, y)) found = number; }
      });
      return found;
    },
    placeOf: (number) => {
      const body = drawing.bodies[number], points = body.parts[0].vertices;
      return place(apply(page.pose(body, page.frame), points[0], points[1]));
    },
    turn: () => {},
    hint: 'Space: play or pause. Arrow keys: one picture. Point at a body for its name.',
  };
};
