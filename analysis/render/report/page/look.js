"use strict";
// Colours, markers and small helpers that every kind of block shares.
const raygauge = {
  data: null,    // what the page shows, once load() has read it
  redraw: [],  // functions to call when colours change
  charts: [],
  blocks: {},  // by type: a function that makes { node, start } of a block
};

raygauge.isDark = () => document.documentElement.dataset.theme === "dark";
raygauge.css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Colour, marker and dash of a method: the same in every figure and on every page (analysis/render/method_look.cc). */
raygauge.look = (name) => {
  const method = raygauge.data.methods.find((each) => each.name === name);
  const [marker, down] = method.marker.split(" ");
  return {
    color: raygauge.isDark() ? method.dark : method.color, marker, rotation: down ? 180 : 0, dash: method.dash,
    filled: method.filled,
  };
};

/** element("td", {class: "key"}, "text", child, ...) */
raygauge.element = (tag, attributes, ...children) => {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value !== undefined && value !== "" && value !== false) node.setAttribute(name, value);
  }
  node.append(...children.filter((child) => child !== undefined && child !== null));
  return node;
};

/** A number as people read it: at most three digits, powers of ten as 10⁻⁶. */
raygauge.short = (value) => {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "-∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return String(Number(value.toPrecision(3)));
  const [mantissa, exponent] = value.toExponential(2).split("e");
  const raised = [...String(Number(exponent))].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
  const sign = value < 0 ? "-" : "", digits = Math.abs(Number(mantissa));
  return sign + (digits === 1 ? "" : digits + "·") + "10" + raised;
};

/** Makes a group of nodes one stop of the Tab key: arrows move among them, `columns` beside each other. */
raygauge.oneStop = (nodes, columns) => {
  const settle = (at) => nodes.forEach((node, i) => { node.tabIndex = i === at ? 0 : -1; });
  settle(0);
  nodes.forEach((node, i) => {
    node.addEventListener("focus", () => settle(i));
    node.addEventListener("keydown", (event) => {
      const row = i - i % columns;
      const to = { ArrowRight: i + 1 < row + columns ? i + 1 : i, ArrowLeft: i > row ? i - 1 : i, ArrowDown: i + columns,
        ArrowUp: i - columns, Home: row, End: row + columns - 1 }[event.key];
      if (to === undefined || !nodes[to]) return;
      event.preventDefault();
      nodes[to].focus();
    });
  });
};
