"use strict";
// Blocks of type "chart": series of points [x, y, low, high, remark] in a Chart.js line chart.

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
  const data = series.points.map(([x, y, low, high, remark]) => ({
    x, y, low: low === null ? undefined : low, high: high === null ? undefined : high, remark,
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

raygauge.tooltip = (context) => {
  const point = context.raw;
  const ends = [point.low, point.high].filter((end) => end !== undefined).map(raygauge.short);
  const bars = ends.length ? " [" + ends.join(", ") + "]" : "";
  return context.dataset.label + ": " + raygauge.short(point.y) + bars + (point.remark ? "; " + point.remark : "");
};

raygauge.options = (block, logarithmic, series) => ({
  animation: false, maintainAspectRatio: false, responsive: true, normalized: true,
  interaction: { mode: "nearest", intersect: false },
  scales: {
    x: raygauge.axis(block.x, logarithmic.x, raygauge.limits(series, 0, logarithmic.x)),
    y: raygauge.axis(block.y, logarithmic.y, raygauge.limits(series, 1, logarithmic.y)),
  },
  plugins: {
    legend: { labels: { color: raygauge.css("--ink"), usePointStyle: !block.stepped } },
    tooltip: {
      callbacks: {
        label: raygauge.tooltip,
        title: (items) => items.length ? raygauge.short(items[0].parsed.x) : "",
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

raygauge.blocks.chart = (block) => {
  const canvas = raygauge.element("canvas", { role: "img", "aria-label": block.caption });
  const logarithmic = { x: block.x.log, y: block.y.log };
  let chosen = block.series;
  let chart = null;
  const draw = () => {
    const hidden = new Set();
    if (chart) {
      chart.data.datasets.forEach((set, i) => { if (!chart.isDatasetVisible(i)) hidden.add(set.method); });
      raygauge.charts.splice(raygauge.charts.indexOf(chart), 1);
      chart.destroy();
    }
    const datasets = chosen.map((series) =>
      ({ ...raygauge.dataset(series, block.stepped), method: series.method, hidden: hidden.has(series.method) }));
    const options = raygauge.options(block, logarithmic, chosen);
    chart = new Chart(canvas, { type: "line", data: { datasets }, options, plugins: [raygauge.intervalBars] });
    raygauge.charts.push(chart);
  };
  const menus = raygauge.facetMenus(block.series, (series) => { chosen = series; draw(); });
  menus.controls.append(raygauge.logSwitch("x", logarithmic, draw), raygauge.logSwitch("y", logarithmic, draw),
    raygauge.saveButton(canvas, block));
  const node = raygauge.element("div", { class: "block" }, raygauge.element("p", { class: "caption" }, block.caption),
    menus.controls, raygauge.element("div", { class: "chart" }, canvas));
  raygauge.redraw.push(draw);
  return { node, start: menus.update };
};
