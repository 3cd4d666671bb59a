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

/** Menus for the choices; onChange gets the chosen items. A value that leaves nothing moves the later menus. */
raygauge.facetMenus = (items, onChange) => {
  const controls = raygauge.element("div", { class: "controls" });
  const menus = raygauge.facetChoices(items).map(([name, values]) => {
    const options = values.map((value) => raygauge.element("option", { value }, value));
    const menu = raygauge.element("select", { "data-facet": name, "aria-label": name }, ...options);
    controls.append(raygauge.element("label", {}, name + " ", menu));
    return [name, menu];
  });
  const update = () => {
    let left = items;
    for (const [name, menu] of menus) {
      const possible = new Set(left.map((item) => item.facets[name]));
      for (const option of menu.options) option.disabled = !possible.has(option.value);
      if (!possible.has(menu.value)) menu.value = [...menu.options].find((option) => !option.disabled).value;
      left = left.filter((item) => item.facets[name] === menu.value);
    }
    onChange(left);
  };
  for (const [, menu] of menus) menu.addEventListener("change", update);
  return { controls, update };
};
