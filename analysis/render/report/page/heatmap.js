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

raygauge.paint = (cell, low, high) => {
  let rgb;
  if (cell.group) {
    rgb = [0, 1, 2].map((i) => parseInt(raygauge.look(cell.group).color.slice(1 + 2 * i, 3 + 2 * i), 16));
  } else {
    if (cell.value === null || cell.value <= 0) return "";
    rgb = raygauge.viridisAt(high > low ? Math.log(cell.value / low) / Math.log(high / low) : 0.5);
  }
  const light = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2] > 140;
  return "background: rgb(" + rgb.join(",") + "); color: " + (light ? "#000" : "#fff");
};

raygauge.heatLegend = (cells) => {
  const groups = [...new Set(cells.map((cell) => cell.group).filter((group) => group))];
  return raygauge.element("div", { class: "legend" }, ...groups.map((group) => raygauge.element("span", {},
    raygauge.element("span", { class: "swatch", style: "background: " + raygauge.look(group).color }), group)));
};

raygauge.heatTable = (block, cells, onPoint) => {
  const order = (name) => [...new Set(cells.map((cell) => cell[name]))].sort((a, b) => a - b);
  const [rows, columns] = [order("row"), order("column")];
  const values = cells.map((cell) => cell.value).filter((value) => value > 0);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const at = new Map(cells.map((cell) => [cell.row + "/" + cell.column, cell]));
  const head = raygauge.element("tr", {}, raygauge.element("th", { class: "key" }, block.row + " \\ " + block.column),
    ...columns.map((value) => raygauge.element("th", {}, String(value))));
  const body = rows.map((row) => raygauge.element("tr", {}, raygauge.element("th", { class: "key" }, String(row)),
    ...columns.map((column) => {
      const cell = at.get(row + "/" + column);
      if (!cell) return raygauge.element("td", {});
      const place = block.row + " = " + row + ", " + block.column + " = " + column + ": ";
      const attributes = { style: raygauge.paint(cell, low, high), title: place + cell.remark, tabindex: "0" };
      const td = raygauge.element("td", attributes, cell.text);
      const tell = () => onPoint(place + cell.remark);
      for (const event of ["mouseenter", "focus", "click"]) td.addEventListener(event, tell);
      return td;
    })));
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
    legend.replaceChildren(raygauge.heatLegend(chosen));
    raygauge.fitTables();
  };
  const menus = raygauge.facetMenus(block.cells, (cells) => { chosen = cells; draw(); });
  raygauge.redraw.push(draw);
  const node = raygauge.element("div", { class: "block" }, raygauge.element("p", { class: "caption" }, block.caption),
    menus.controls, legend, holder, remark);
  return { node, start: menus.update };
};
