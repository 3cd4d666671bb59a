'use strict';
// Numbers, colours and small helpers that every part of the page uses.
const page = {
  data: JSON.parse(document.getElementById('data').textContent),
  frame: 0,
  playing: false,
  cursors: [],    // functions of a time: they mark it on a timeline
  highlit: null,  // number of the body that is pointed at
};
page.byId = (id) => document.getElementById(id);
page.style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** A number of the data: null where there is none; JSON has no infinity. */
page.number = (x) => (x === 'inf' ? Infinity : x === '-inf' ? -Infinity : x);

/** At most five significant digits: "12200", "1e-10", "0", "∞". */
page.digits = (raw) => {
  const x = page.number(raw);
  if (x === null || x === undefined || Number.isNaN(x)) return '–';
  if (!Number.isFinite(x)) return x > 0 ? '∞' : '-∞';
  const rounded = Number(x.toPrecision(5)), size = Math.abs(rounded);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? rounded.toExponential().replace('e+', 'e') : String(rounded);
};

page.duration = (seconds) => {
  if (seconds === null || !(seconds > 0)) return page.digits(seconds) + (seconds === null ? '' : ' s');
  if (seconds >= 1) return page.digits(seconds) + ' s';
  return seconds >= 1e-3 ? page.digits(1e3 * seconds) + ' ms' : page.digits(1e6 * seconds) + ' µs';
};

/** element('td', {class: 'wide'}, 'text', child, ...) */
page.element = (tag, attributes, ...children) => {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes || {})) if (value !== undefined) node.setAttribute(key, value);
  node.append(...children);
  return node;
};

page.svg = (name, attributes, parent, text) => {
  const node = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  if (text !== undefined) node.textContent = text;
  parent.appendChild(node);
  return node;
};

/** 1, 2 or 5 times a power of ten, of which about `count` fit into `length`. */
page.niceStep = (length, count) => {
  const rough = length / count, power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((k) => k * power).find((step) => step >= rough * 0.999);
};

/** The multiples of a nice step within [low, high]. */
page.niceTicks = (low, high, count) => {
  if (!(high > low)) return [low];
  const step = page.niceStep(high - low, count), ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
};

/** Makes buttons one stop of the Tab key: arrows move among those that are shown. */
page.oneStop = (list) => {
  const shown = () => [...list.querySelectorAll('button')].filter((button) => !button.closest('li').hidden);
  const settle = () => {
    const buttons = shown();
    if (!buttons.length || buttons.some((button) => button.tabIndex === 0)) return;
    buttons[0].tabIndex = 0;
  };
  const move = (to) => {
    for (const button of list.querySelectorAll('button')) button.tabIndex = -1;
    to.tabIndex = 0;
    to.focus();
  };
  for (const button of list.querySelectorAll('button')) button.tabIndex = -1;
  list.addEventListener('focusin', (event) => {
    for (const button of list.querySelectorAll('button[tabindex="0"]')) button.tabIndex = -1;
    event.target.tabIndex = 0;
  });
  list.addEventListener('keydown', (event) => {
    const buttons = shown(), at = buttons.indexOf(document.activeElement);
    const to = { ArrowDown: at + 1, ArrowRight: at + 1, ArrowUp: at - 1, ArrowLeft: at - 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (to === undefined || !buttons[to]) return;
    event.preventDefault();
    event.stopPropagation();
    move(buttons[to]);
  });
  settle();
  return () => {
    for (const button of list.querySelectorAll('button')) button.tabIndex = -1;
    settle();
  };
};
