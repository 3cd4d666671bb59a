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

raygauge.cellText = (row, index) => row.children[index] ? row.children[index].textContent : "";

/** Sorts the rows by a column: numbers by size, "unsolved" and other words last. Rows whose keys stand in a row above
 * get them first. */
raygauge.sortRows = (table, index, keys, ascending) => {
  const body = table.tBodies[0], rows = [...body.rows];
  rows.forEach((row, r) => {
    row.classList.remove("group");
    for (let i = 0; i < keys && r > 0; i++)
      if (row.children[i].textContent === "") row.children[i].textContent = rows[r - 1].children[i].textContent;
  });
  const number = (row) => parseFloat(raygauge.cellText(row, index).replace(/^[<*]/, ""));
  const order = (a, b) => {
    const [x, y] = [number(a), number(b)];
    if (Number.isNaN(x) !== Number.isNaN(y)) return Number.isNaN(x) ? 1 : -1;
    const sign = ascending ? 1 : -1;
    if (!Number.isNaN(x)) return sign * (x - y);
    return sign * raygauge.cellText(a, index).localeCompare(raygauge.cellText(b, index));
  };
  body.append(...rows.sort(order));
};

/** Makes the last line of the head sort: by click or Enter, again for the other direction. */
raygauge.makeSortable = (table, keys) => {
  const heads = [...table.tHead.rows[table.tHead.rows.length - 1].cells];
  heads.forEach((head, index) => {
    head.tabIndex = 0;
    const sort = () => {
      const ascending = head.getAttribute("aria-sort") !== "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", ascending ? "ascending" : "descending");
      raygauge.sortRows(table, index, keys, ascending);
    };
    head.addEventListener("click", sort);
    head.addEventListener("keydown", (event) => { if (event.key === "Enter") sort(); });
  });
};

/** Narrows the tables that are wider than their boxes: smaller and wrapped, then each row on lines of its own. */
raygauge.fitTables = () => {
  for (const box of document.querySelectorAll(".scroll")) {
    const table = box.querySelector("table");
    if (!table) continue;
    table.classList.remove("dense", "stacked");
    if (box.clientWidth === 0 || table.offsetWidth <= box.clientWidth) continue;
    table.classList.add("dense");
    if (table.offsetWidth > box.clientWidth) table.classList.add("stacked");
  }
};

raygauge.blocks.table = (block) => {
  const facts = block.rows.some((row) => row.cells.some((cell) => String(cell).length > 60));
  const head = block.header.map((line) => raygauge.element("tr", {},
    ...line.map((text, i) => raygauge.element("th", { class: i < block.keys ? "key" : "" }, text))));
  const table = raygauge.element("table", { class: facts ? "facts" : "" },
    block.title ? raygauge.element("caption", {}, block.title) : null,
    raygauge.element("thead", {}, ...head),
    raygauge.element("tbody", {}, ...block.rows.map((row) => raygauge.tableRow(row, block.keys, facts))));
  const names = block.header.length ? block.header[0].map((_, i) => block.header.map((line) => line[i]).join(" ").trim()) : [];
  for (const row of table.tBodies[0].rows) [...row.cells].forEach((cell, i) => { cell.dataset.label = names[i] || ""; });
  if (block.header.length && block.rows.length > 1) raygauge.makeSortable(table, block.keys);
  const notes = raygauge.element("ul", { class: "notes" }, ...block.notes.map((note) => raygauge.element("li", {}, note)));
  const box = raygauge.element("div", { class: block.rows.length > 40 ? "scroll long" : "scroll" }, table);
  const long = block.rows.length > 12 || block.title.startsWith("time = factor");
  if (!long) return { node: raygauge.element("div", { class: "block" }, box, notes) };
  const name = (block.title || "table") + " (" + block.rows.length + (block.rows.length === 1 ? " row)" : " rows)");
  const fold = raygauge.element("details", { class: "block" }, raygauge.element("summary", {}, name), box, notes);
  fold.addEventListener("toggle", raygauge.fitTables);
  return { node: fold };
};

raygauge.blocks.text = (block) => ({
  node: raygauge.element("div", { class: block.lead ? "lead" : "" },
    ...block.paragraphs.map((text) => raygauge.element("p", {}, text))),
});

raygauge.blocks.verbatim = (block) => ({
  node: raygauge.element("details", { class: "block" },
    raygauge.element("summary", {}, block.title), raygauge.element("pre", {}, block.text)),
});
