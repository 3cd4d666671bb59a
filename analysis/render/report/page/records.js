"use strict";
// Blocks of type "records": the records as CSV, packed inside the page until someone asks for them.

raygauge.unpack = async (gzip) => {
  const bytes = Uint8Array.from(atob(gzip), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
};

/** The lines of a CSV file from its columns, which stand one below the other with an empty line after each. */
raygauge.csvOfColumns = (text, count) => {
  // Fields in quotes may hold line breaks: a field ends where its quotes are even in number.
  const fields = [];
  let open = "";
  for (const line of text.split("\n")) {
    open = open === "" ? line : open + "\n" + line;
    if ((open.match(/"/g) || []).length % 2 === 1) continue;
    fields.push(open);
    open = "";
  }
  const height = count + 2, columns = Math.floor(fields.length / height), lines = [];
  for (let row = 0; row <= count; ++row) {
    const line = [];
    for (let column = 0; column < columns; ++column) line.push(fields[column * height + row]);
    lines.push(line.join(","));
  }
  return lines.join("\n") + "\n";
};

raygauge.blocks.records = (block) => {
  if (!block.gzip) {
    const words = block.count + " records are too many for a page. This command writes them as a CSV file: ";
    return { node: raygauge.element("p", { class: "block", id: "too-many" }, words,
      raygauge.element("code", {}, "raygauge export RESULTS.h5 --csv " + block.name)) };
  }
  const button = raygauge.element("button", { type: "button", id: "csv" }, "Download as CSV");
  button.addEventListener("click", async () => {
    const address = URL.createObjectURL(new Blob([raygauge.csvOfColumns(await raygauge.unpack(block.gzip), block.count)], { type: "text/csv" }));
    raygauge.element("a", { href: address, download: block.name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  });
  const text = block.count + " records with every column of the results file; distances with all digits, times with " +
    block.time_digits + ".";
  return { node: raygauge.element("details", { class: "block" }, raygauge.element("summary", {}, "download"),
    raygauge.element("p", {}, text), button) };
};
