"use strict";
// Colours, markers and small helpers that every kind of block shares.
const raygauge = {
  data: JSON.parse(document.getElementById("data").textContent),
  redraw: [],  // functions to call when colours change
  charts: [],
  blocks: {},  // by type: a function that makes { node, start } of a block
};

// Okabe and Ito, which colour-blind readers tell apart; methods of raygauge solid with filled markers, competitors
// dashed with hollow ones, so that curves also differ in grey. A competitor's last entry is its
// colour on dark paper.
raygauge.own = [["#D55E00", "circle"], ["#0072B2", "rect"], ["#009E73", "triangle"], ["#CC79A7", "rectRot"]];
raygauge.competitors = [["#000000", "circle", [7, 4], "#FFFFFF"], ["#8C8C8C", "rect", [2, 3], "#A8A8A8"],
  ["#56B4E9", "triangle", [7, 4], "#56B4E9"], ["#E69F00", "rectRot", [2, 3], "#E69F00"]];

raygauge.isDark = () => document.documentElement.dataset.theme === "dark";
raygauge.css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

raygauge.look = (name) => {
  const method = raygauge.data.methods.find((each) => each.name === name) || { competitor: false, rank: 0 };
  const list = method.competitor ? raygauge.competitors : raygauge.own;
  const [color, marker, dash, darkColor] = list[method.rank % list.length];
  const shown = raygauge.isDark() && darkColor ? darkColor : color;
  return { color: shown, marker, dash: dash || [], filled: !method.competitor };
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
