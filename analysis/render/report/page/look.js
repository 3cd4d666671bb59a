"use strict";
// Colours, markers and small helpers that every kind of block shares.
const raygauge = {
  data: JSON.parse(document.getElementById("data").textContent),
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
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return String(Number(value.toPrecision(3)));
  const [mantissa, exponent] = value.toExponential(2).split("e");
  const raised = [...String(Number(exponent))].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
  return (Number(mantissa) === 1 ? "" : Number(mantissa) + "·") + "10" + raised;
};
