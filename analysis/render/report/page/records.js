"use strict";
// Blocks of type "records": the records as CSV, packed inside the page until someone asks for them.

raygauge.unpack = async (gzip) => {
  const bytes = Uint8Array.from(atob(gzip), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
};

raygauge.blocks.records = (block) => {
  const button = raygauge.element("button", { type: "button", id: "csv" }, "Download as CSV");
  button.addEventListener("click", async () => {
    const address = URL.createObjectURL(new Blob([await raygauge.unpack(block.gzip)], { type: "text/csv" }));
    raygauge.element("a", { href: address, download: block.name }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  });
  const text = block.count + " records with every column of the results file; distances with all digits, times with " +
    block.time_digits + ".";
  return { node: raygauge.element("details", { class: "block" }, raygauge.element("summary", {}, "download"),
    raygauge.element("p", {}, text), button) };
};
