"use strict";
// Puts the page together from its data.

raygauge.setTheme = (dark) => {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  for (const draw of raygauge.redraw) draw();
};

raygauge.start = () => {
  const { data, element } = raygauge;
  const system = matchMedia("(prefers-color-scheme: dark)");
  raygauge.setTheme(system.matches);
  document.querySelector("h1").textContent = data.title;
  document.querySelector("#subtitle").textContent = data.subtitle;
  document.querySelector("footer").textContent = "raygauge " + data.version + ", with Chart.js " + Chart.version +
    ". Everything on this page is inside it.";
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  const [nav, main] = [document.querySelector("nav"), document.querySelector("main")];
  nav.append(...raygauge.sharedMenus(data.sections));
  for (const section of data.sections) {
    nav.append(element("a", { href: "#" + section.id }, section.title));
    const place = element("section", { id: section.id }, element("h2", {}, section.title));
    main.append(place);
    for (const block of section.blocks) {
      const { node, start } = raygauge.blocks[block.type](block);
      place.append(node);
      if (start) start();
    }
  }
  raygauge.fitTables();
  addEventListener("resize", raygauge.fitTables);
  document.getElementById("theme").addEventListener("click", () => raygauge.setTheme(!raygauge.isDark()));
  system.addEventListener("change", (event) => raygauge.setTheme(event.matches));
  let printed = false;
  addEventListener("beforeprint", () => {
    printed = raygauge.isDark();
    if (printed) raygauge.setTheme(false);
    for (const chart of raygauge.charts) chart.resize();
  });
  addEventListener("afterprint", () => {
    if (printed) raygauge.setTheme(true);
    for (const chart of raygauge.charts) chart.resize();
  });
  document.documentElement.dataset.ready = "true";
};

/** The data of the page stand in it as they are, or packed where they are many. */
raygauge.load = async () => {
  const script = document.getElementById("data");
  raygauge.data = JSON.parse(script.type === "application/json" ? script.textContent : await raygauge.unpack(script.textContent));
};

raygauge.load().then(raygauge.start);
