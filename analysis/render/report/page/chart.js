"use strict";
// Blocks of type "chart": series of points [x, y, low, high, remark] in a Chart.js line chart.

/** Crosses a point behind which answers are wrong or missing. */
raygauge.cross = (ctx, x, y) => {
  const size = 7;
  ctx.save();
  ctx.strokeStyle = raygauge.css("--alarm");
  ctx.lineWidth = 2;
  ctx.beginPath();
  ctx.moveTo(x - size, y - size);
  ctx.lineTo(x + size, y + size);
  ctx.moveTo(x - size, y + size);
  ctx.lineTo(x + size, y - size);
  ctx.stroke();
  ctx.restore();
};

/** Bars from low to high through every point that has an interval. */
raygauge.intervalBars = {
  id: "intervalBars",
  beforeDatasetsDraw(chart) {
    const { ctx } = chart;
    chart.data.datasets.forEach((dataset, index) => {
      if (!chart.isDatasetVisible(index)) return;
      ctx.save();
      ctx.strokeStyle = dataset.borderColor;
      ctx.lineWidth = 1.2;
      for (const point of dataset.data) {
        if (point.flawed) raygauge.cross(ctx, chart.scales.x.getPixelForValue(point.x), chart.scales.y.getPixelForValue(point.y));
        if (point.low === undefined) continue;
        const x = chart.scales.x.getPixelForValue(point.x);
        ctx.beginPath();
        ctx.moveTo(x, chart.scales.y.getPixelForValue(point.low));
        ctx.lineTo(x, chart.scales.y.getPixelForValue(point.high));
        ctx.stroke();
      }
      ctx.restore();
    });
  },
};

raygauge.dataset = (series, stepped) => {
  const look = raygauge.look(series.method);
  const data = series.points.map(([x, y, low, high, remark, flawed]) => ({
    x, y, low: low === null ? undefined : low, high: high === null ? undefined : high, remark, flawed,
  }));
  return {
    label: series.name, data, stepped: stepped ? "before" : false, tension: 0,
    borderColor: look.color, backgroundColor: look.filled ? look.color : raygauge.css("--paper"),
    borderDash: look.dash, borderWidth: 1.8,
    pointStyle: look.marker, rotation: look.rotation, pointBorderColor: look.color, pointRadius: stepped ? 0 : 4, pointHoverRadius: 6,
  };
};

/** Where an axis begins and ends: at the data, a little wider. */
raygauge.limits = (series, index, logarithmic) => {
  const ends = index === 0 ? [0] : [1, 2, 3];
  const values = series.flatMap((each) => each.points.flatMap((point) => ends.map((i) => point[i])))
    .filter((value) => typeof value === "number" && (!logarithmic || value > 0));
  if (values.length === 0) return {};
  const [low, high] = values.reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [Infinity, -Infinity]);
  if (logarithmic) return low === high ? {} : { min: low / (high / low) ** 0.03, max: high * (high / low) ** 0.03 };
  const below = low - 0.03 * (high - low);
  return low === high ? {} : { min: low >= 0 ? Math.max(0, below) : below, max: high + 0.03 * (high - low) };
};

raygauge.axis = (axis, logarithmic, limits) => ({
  ...limits,
  type: logarithmic ? "logarithmic" : "linear",
  title: { display: true, text: axis.label, color: raygauge.css("--ink") },
  grid: { color: raygauge.css("--line") },
  ticks: {
    color: raygauge.css("--soft"), maxRotation: 0, autoSkip: true, autoSkipPadding: 12,
    callback(value) {
      const isEnd = value === this.min || value === this.max;
      if (!logarithmic) return isEnd && Number(value.toPrecision(2)) !== value ? "" : raygauge.short(value);
      const digit = Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9));
      if (Math.abs(value - Number(value.toPrecision(1))) > 1e-6 * value) return "";
      const decades = Math.log10(this.max / this.min);
      return (decades > 4 ? [1] : decades > 2 ? [1, 3] : [1, 2, 5]).includes(digit) ? raygauge.short(value) : "";
    },
  },
});

/** A value with the name of its axis, or its unit alone. */
raygauge.withUnit = (value, axis) => raygauge.short(value) + (axis.unit ? " " + axis.unit : "");

raygauge.pointWords = (block, label, point) => {
  const ends = [point.low, point.high].filter((end) => end !== undefined).map(raygauge.short);
  const bars = ends.length ? " [" + ends.join(", ") + "]" : "";
  const unit = block.y.unit ? " " + block.y.unit : "";
  return label + ": " + raygauge.short(point.y) + bars + unit + (point.remark ? "; " + point.remark : "");
};

raygauge.placeWords = (block, x) => block.x.label.replace(/ \(.*\)$/, "").replace(/, .*/, "") + " = " + raygauge.withUnit(x, block.x);

raygauge.options = (block, logarithmic, series) => ({
  animation: false, maintainAspectRatio: false, responsive: true, normalized: true,
  interaction: { mode: "nearest", intersect: false },
  scales: {
    x: raygauge.axis(block.x, logarithmic.x, raygauge.limits(series, 0, logarithmic.x)),
    y: raygauge.axis(block.y, logarithmic.y, raygauge.limits(series, 1, logarithmic.y)),
  },
  plugins: {
    legend: { display: false },
    tooltip: {
      callbacks: {
        label: (context) => raygauge.pointWords(block, context.dataset.label, context.raw),
        title: (items) => items.length ? raygauge.placeWords(block, items[0].parsed.x) : "",
      },
    },
  },
});

raygauge.logSwitch = (axis, logarithmic, redraw) => {
  const button = raygauge.element("button",
    { type: "button", "data-axis": axis, "aria-pressed": String(logarithmic[axis]) }, axis + " log");
  button.addEventListener("click", () => {
    logarithmic[axis] = !logarithmic[axis];
    button.setAttribute("aria-pressed", String(logarithmic[axis]));
    redraw();
  });
  return button;
};

/** Saves the chart as a picture on paper of the page's colour. */
raygauge.saveChart = (canvas, name) => {
  const copy = raygauge.element("canvas", { width: canvas.width, height: canvas.height });
  const context = copy.getContext("2d");
  context.fillStyle = raygauge.css("--paper");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  copy.toBlob((blob) => {
    const address = URL.createObjectURL(blob);
    raygauge.element("a", { href: address, download: name + ".png" }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  });
};

raygauge.saveButton = (canvas, block) => {
  const button = raygauge.element("button", { type: "button", class: "save" }, "Save as PNG");
  const name = (block.y.label + " " + block.x.label).replace(/[^A-Za-z0-9]+/g, "_");
  button.addEventListener("click", () => raygauge.saveChart(canvas, name));
  return button;
};

/** The marker of a method as a small picture. */
raygauge.sample = (look, stepped) => {
  const ratio = window.devicePixelRatio || 1;
  const canvas = raygauge.element("canvas", { width: 34 * ratio, height: 14 * ratio, class: "sample" });
  const ctx = canvas.getContext("2d");
  ctx.scale(ratio, ratio);
  ctx.strokeStyle = look.color;
  ctx.fillStyle = look.filled ? look.color : raygauge.css("--paper");
  ctx.lineWidth = 1.8;
  ctx.setLineDash(look.dash);
  ctx.beginPath();
  ctx.moveTo(1, 7);
  ctx.lineTo(33, 7);
  ctx.stroke();
  ctx.setLineDash([]);
  if (!stepped) Chart.helpers.drawPoint(ctx, { pointStyle: look.marker, rotation: look.rotation, radius: 4, borderWidth: 1.8 }, 17, 7);
  return canvas;
};

/** A button for each curve, which hides and shows it. */
raygauge.chartLegend = (chart, block, hidden) => {
  const buttons = chart.data.datasets.map((set, i) => {
    const button = raygauge.element("button", { type: "button", class: "entry", "aria-pressed": String(chart.isDatasetVisible(i)) },
      raygauge.sample(raygauge.look(set.method), block.stepped), set.label);
    button.addEventListener("click", () => {
      const visible = !chart.isDatasetVisible(i);
      chart.setDatasetVisibility(i, visible);
      button.setAttribute("aria-pressed", String(visible));
      if (visible) hidden.delete(set.method); else hidden.add(set.method);
      chart.update();
    });
    return button;
  });
  raygauge.oneStop(buttons, buttons.length || 1);
  return buttons;
};

/** Lets arrow keys go along a curve (left, right) and from one to the next (up, down); the words stand below. */
raygauge.walkChart = (canvas, chartNow, block, remark) => {
  let at = null;
  canvas.tabIndex = 0;
  const show = (chart) => {
    const set = chart.data.datasets[at.set];
    at.point = Math.max(0, Math.min(set.data.length - 1, at.point));
    const element = chart.getDatasetMeta(at.set).data[at.point], active = [{ datasetIndex: at.set, index: at.point }];
    chart.setActiveElements(active);
    chart.tooltip.setActiveElements(active, { x: element.x, y: element.y });
    chart.update();
    remark.textContent = raygauge.placeWords(block, set.data[at.point].x) + ": " + raygauge.pointWords(block, set.label, set.data[at.point]);
  };
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0], Home: [0, -1e9], End: [0, 1e9] }[event.key];
    const chart = chartNow(), count = chart.data.datasets.length;
    if (!step || count === 0) return;
    event.preventDefault();
    if (at === null || at.set >= count) at = { set: 0, point: 0 };
    else at = { set: (at.set + step[0] + count) % count, point: at.point + step[1] };
    show(chart);
  });
};

raygauge.blocks.chart = (block) => {
  const canvas = raygauge.element("canvas", { role: "img", "aria-label": block.caption });
  const legend = raygauge.element("div", { class: "legend", role: "group", "aria-label": "curves" });
  const remark = raygauge.element("div", { class: "remark", "aria-live": "polite" });
  const hidden = new Set();
  const logarithmic = { x: block.x.log, y: block.y.log };
  let chosen = block.series;
  let chart = null;
  const draw = () => {
    if (chart) {
      raygauge.charts.splice(raygauge.charts.indexOf(chart), 1);
      chart.destroy();
    }
    const datasets = chosen.map((series) =>
      ({ ...raygauge.dataset(series, block.stepped), method: series.method, hidden: hidden.has(series.method) }));
    const options = raygauge.options(block, logarithmic, chosen);
    chart = new Chart(canvas, { type: "line", data: { datasets }, options, plugins: [raygauge.intervalBars] });
    raygauge.charts.push(chart);
    legend.replaceChildren(...raygauge.chartLegend(chart, block, hidden));
  };
  raygauge.walkChart(canvas, () => chart, block, remark);
  const menus = raygauge.facetMenus(block.series, (series) => { chosen = series; draw(); });
  menus.controls.append(raygauge.logSwitch("x", logarithmic, draw), raygauge.logSwitch("y", logarithmic, draw),
    raygauge.saveButton(canvas, block));
  const node = raygauge.element("div", { class: "block" }, raygauge.element("p", { class: "caption" }, block.caption),
    menus.controls, legend, raygauge.element("div", { class: "chart" }, canvas), remark);
  raygauge.redraw.push(draw);
  return { node, start: menus.update };
};
