"use strict";
// Blocks of type "heatmap": a table whose cells are coloured by the logarithm of a value, or by a method.

raygauge.viridis = ["#440154", "#46327E", "#365C8D", "#277F8E", "#1FA187", "#4AC16D", "#A0DA39", "#FDE725"];

/** The channels of the colour at t in [0, 1]. */
raygauge.viridisAt = (t) => {
  const place = Math.min(Math.max(t, 0), 1) * (raygauge.viridis.length - 1);
  const below = Math.min(Math.floor(place), raygauge.viridis.length - 2);
  const channel = (color, i) => parseInt(color.slice(1 + 2 * i, 3 + 2 * i), 16);
  return [0, 1, 2].map((i) => {
    const [a, b] = [channel(raygauge.viridis[below], i), channel(raygauge.viridis[below + 1], i)];
    return Math.round(a + (place - below) * (b - a));
  });
};

/** Where the scale of a map begins and ends. */
raygauge.heatRange = (block, cells) => {
  if (!block.log) return [0, 1];
  const values = cells.map((cell) => cell.value).filter((value) => value > 0);
  return values.length ? [Math.min(...values), Math.max(...values)] : [1, 1];
};

raygauge.paint = (cell, low, high, logarithmic) => {
  let rgb;
  if (cell.group) {
    rgb = [0, 1, 2].map((i) => parseInt(raygauge.look(cell.group).color.slice(1 + 2 * i, 3 + 2 * i), 16));
  } else {
    if (cell.value === null || (logarithmic && cell.value <= 0)) return "";
    const place = logarithmic ? Math.log(cell.value / low) / Math.log(high / low) : (cell.value - low) / (high - low);
    rgb = raygauge.viridisAt(high > low ? place : 0.5);
  }
  const light = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2] > 140;
  return "background: rgb(" + rgb.join(",") + "); color: " + (light ? "#000" : "#fff");
};

/** A scale of the colours, from the least to the largest value. */
raygauge.colorBar = (block, low, high) => {
  const colors = raygauge.viridis.join(", ");
  const middle = block.log ? Math.sqrt(low * high) : (low + high) / 2;
  const ticks = (low < high ? [low, middle, high] : [low]).map((value) => raygauge.element("span", {}, raygauge.short(value)));
  return raygauge.element("div", { class: "colorbar" }, raygauge.element("span", {}, block.value),
    raygauge.element("div", { class: "scale" }, raygauge.element("div", { class: "gradient", style: "background: linear-gradient(to right, " + colors + ")" }),
      raygauge.element("div", { class: "ticks" }, ...ticks)));
};

raygauge.heatLegend = (block, cells) => {
  const groups = [...new Set(cells.map((cell) => cell.group).filter((group) => group))];
  if (groups.length === 0) return raygauge.colorBar(block, ...raygauge.heatRange(block, cells));
  const count = (group) => cells.filter((cell) => cell.group === group).length;
  return raygauge.element("div", { class: "legend" }, ...groups.map((group) => raygauge.element("span", {},
    raygauge.element("span", { class: "swatch", style: "background: " + raygauge.look(group).color }),
    group + " (" + count(group) + " of " + cells.length + ")")));
};

raygauge.heatTable = (block, cells, onPoint) => {
  const order = (name) => [...new Set(cells.map((cell) => cell[name]))].sort((a, b) => a - b);
  const [rows, columns] = [order("row"), order("column")];
  const nameOf = (names, value) => names.length ? names[value] : String(value);
  const [low, high] = raygauge.heatRange(block, cells);
  const at = new Map(cells.map((cell) => [cell.row + "/" + cell.column, cell]));
  const head = raygauge.element("tr", {}, raygauge.element("th", { class: "key" }, block.row + " \\ " + block.column),
    ...columns.map((value) => raygauge.element("th", {}, nameOf(block.columns, value))));
  const body = rows.map((row) => raygauge.element("tr", {}, raygauge.element("th", { class: "key" }, nameOf(block.rows, row)),
    ...columns.map((column) => {
      const cell = at.get(row + "/" + column);
      if (!cell) return raygauge.element("td", { "aria-label": "nothing" });
      const place = block.row + " = " + nameOf(block.rows, row) + ", " + block.column + " = " + nameOf(block.columns, column) + ": ";
      const attributes = { style: raygauge.paint(cell, low, high, block.log), title: place + cell.remark };
      const td = raygauge.element("td", attributes, cell.text);
      const tell = () => onPoint(place + cell.remark);
      for (const event of ["mouseenter", "focus", "click"]) td.addEventListener(event, tell);
      return td;
    })));
  raygauge.oneStop(body.flatMap((line) => [...line.querySelectorAll("td")]), columns.length);
  return raygauge.element("table", { class: "heat" },
    raygauge.element("thead", {}, head), raygauge.element("tbody", {}, ...body));
};

raygauge.blocks.heatmap = (block) => {
  const holder = raygauge.element("div", { class: "scroll" });
  const remark = raygauge.element("div", { class: "remark", "aria-live": "polite" });
  const legend = raygauge.element("div", {});
  let chosen = block.cells;
  const draw = () => {
    holder.replaceChildren(raygauge.heatTable(block, chosen, (text) => { remark.textContent = text; }));
    legend.replaceChildren(raygauge.heatLegend(block, chosen));
    raygauge.fitTables();
  };
  const menus = raygauge.facetMenus(block.cells, (cells) => { chosen = cells; draw(); });
  raygauge.redraw.push(draw);
  const node = raygauge.element("div", { class: "block" }, raygauge.element("p", { class: "caption" }, block.caption),
    menus.controls, legend, holder, remark);
  return { node, start: menus.update };
};
