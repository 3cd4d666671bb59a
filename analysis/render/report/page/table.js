"use strict";
// Blocks of type "table", "text" and "verbatim".

raygauge.tableRow = (row, keys, facts) => {
  const cells = row.cells.map((cell, i) => {
    const [text, emphasis] = Array.isArray(cell) ? cell : [cell, ""];
    const key = i < keys || facts ? "key " : "";
    return raygauge.element(i < keys ? "th" : "td", { class: (key + emphasis).trim() }, text);
  });
  return raygauge.element("tr", { class: row.group ? "group" : "" }, ...cells);
};

raygauge.blocks.table = (block) => {
  const facts = block.rows.some((row) => row.cells.some((cell) => String(cell).length > 60));
  const head = block.header.map((line) => raygauge.element("tr", {},
    ...line.map((text, i) => raygauge.element("th", { class: i < block.keys ? "key" : "" }, text))));
  const table = raygauge.element("table", { class: facts ? "facts" : "" },
    block.title ? raygauge.element("caption", {}, block.title) : null,
    raygauge.element("thead", {}, ...head),
    raygauge.element("tbody", {}, ...block.rows.map((row) => raygauge.tableRow(row, block.keys, facts))));
  const notes = block.notes.map((note) => raygauge.element("li", {}, note));
  return {
    node: raygauge.element("div", { class: "block" },
      raygauge.element("div", { class: block.rows.length > 40 ? "scroll long" : "scroll" }, table),
      raygauge.element("ul", { class: "notes" }, ...notes)),
  };
};

raygauge.blocks.text = (block) => ({
  node: raygauge.element("div", { class: block.lead ? "lead" : "" },
    ...block.paragraphs.map((text) => raygauge.element("p", {}, text))),
});

raygauge.blocks.verbatim = (block) => ({
  node: raygauge.element("details", { class: "block" },
    raygauge.element("summary", {}, block.title), raygauge.element("pre", {}, block.text)),
});
