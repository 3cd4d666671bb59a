"use strict";
// Choosing among the series of a chart or the cells of a map by the values of columns.

/** The columns in which the items differ, with their values in order of size, or of appearance for words. */
raygauge.facetChoices = (items) => {
  const choices = new Map();
  for (const item of items) {
    for (const [name, value] of Object.entries(item.facets)) {
      if (!choices.has(name)) choices.set(name, new Set());
      choices.get(name).add(value);
    }
  }
  return [...choices].filter(([, values]) => values.size > 1).map(([name, values]) => {
    const list = [...values];
    return [name, list.every((v) => !Number.isNaN(Number(v))) ? list.sort((a, b) => a - b) : list];
  });
};

/** The columns that are chosen once, for the whole page: { name: { value, listeners } }. */
raygauge.shared = {};

/** One menu for the problem of every chart and map, in the bar that stays on top. */
raygauge.sharedMenus = (sections) => {
  const items = sections.flatMap((section) => section.blocks).flatMap((block) => block.series || block.cells || [])
    .filter((item) => item.facets);
  return raygauge.facetChoices(items).filter(([name]) => name === "problem").map(([name, values]) => {
    const shared = raygauge.shared[name] = { value: values[0], listeners: [] };
    const options = values.map((value) => raygauge.element("option", { value }, value));
    const menu = raygauge.element("select", { "data-shared": name, "aria-label": name }, ...options);
    menu.addEventListener("change", () => {
      shared.value = menu.value;
      for (const listener of shared.listeners) listener();
    });
    return raygauge.element("label", {}, name + " ", menu);
  });
};

/** The items of the value that is chosen for the whole page, or all if there are none. */
raygauge.sharedItems = (items) => Object.entries(raygauge.shared).reduce((left, [name, shared]) => {
  const chosen = left.filter((item) => item.facets[name] === undefined || item.facets[name] === shared.value);
  return chosen.length > 0 ? chosen : left;
}, items);

/** Menus for the choices; onChange gets the chosen items. A value that leaves nothing moves the later menus. */
raygauge.facetMenus = (items, onChange) => {
  const controls = raygauge.element("div", { class: "controls" });
  const menus = raygauge.facetChoices(items).filter(([name]) => !raygauge.shared[name]).map(([name, values]) => {
    const options = values.map((value) => raygauge.element("option", { value }, value));
    const menu = raygauge.element("select", { "data-facet": name, "aria-label": name }, ...options);
    controls.append(raygauge.element("label", {}, name + " ", menu));
    return [name, menu];
  });
  const update = () => {
    let left = raygauge.sharedItems(items);
    for (const [name, menu] of menus) {
      const possible = new Set(left.map((item) => item.facets[name]));
      for (const option of menu.options) option.disabled = !possible.has(option.value);
      if (!possible.has(menu.value)) menu.value = [...menu.options].find((option) => !option.disabled).value;
      left = left.filter((item) => item.facets[name] === menu.value);
    }
    onChange(left);
  };
  for (const [, menu] of menus) menu.addEventListener("change", update);
  for (const shared of Object.values(raygauge.shared)) shared.listeners.push(update);
  return { controls, update };
};
