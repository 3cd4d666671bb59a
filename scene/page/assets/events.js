'use strict';
// The list of events, the most dangerous first, and the list of bodies.
page.kinds = { contact: 'contacts', undecided: 'undecided', near: 'nearest approaches', free: 'proven apart', release: 'releases' };

page.eventItem = (event, number) => {
  const button = page.element('button', { type: 'button', class: event.kind }, event.text);
  button.addEventListener('click', () => page.goTo(event.time));
  const item = page.element('li', {}, button, page.element('small', {}, page.data.queries[event.query].name));
  item.dataset.kind = event.kind;
  const kStills = 4;
  if (page.view && event.time !== null && number < kStills) {
    page.view.draw(page.frameOf(event.time));
    item.append(page.element('img', { alt: 'The bodies then', src: page.byId('canvas').toDataURL('image/png') }));
  }
  return item;
};

page.startEvents = () => {
  const { events } = page.data, list = page.byId('event-list');
  if (!events.length) {
    page.byId('events').remove();
    return;
  }
  const items = events.map(page.eventItem);
  list.append(...items);
  const settle = page.oneStop(list), menu = page.byId('kind'), words = page.byId('words');
  const present = Object.keys(page.kinds).filter((kind) => events.some((event) => event.kind === kind));
  menu.append(page.element('option', { value: '' }, 'all events'),
    ...present.map((kind) => page.element('option', { value: kind }, page.kinds[kind])));
  const filter = () => {
    const wanted = words.value.toLowerCase().split(/\s+/);
    for (const item of items) {
      const text = item.textContent.toLowerCase();
      item.hidden = (menu.value !== '' && item.dataset.kind !== menu.value) || !wanted.every((word) => text.includes(word));
    }
    const shown = items.filter((item) => !item.hidden).length;
    page.byId('count').textContent = shown === items.length ? items.length + ' events' : shown + ' of ' + items.length + ' events';
    settle();
  };
  menu.addEventListener('change', filter);
  words.addEventListener('input', filter);
  filter();
};

page.startBodies = () => {
  if (!page.view) {
    page.byId('bodies').remove();
    return;
  }
  const list = page.byId('body-list');
  page.data.bodies.forEach((name, number) => {
    const button = page.element('button', { type: 'button' }, name);
    for (const event of ['focus', 'mouseenter', 'click']) button.addEventListener(event, () => page.point(number));
    for (const event of ['blur', 'mouseleave']) button.addEventListener(event, () => page.point(null));
    list.append(page.element('li', {}, button));
  });
  page.oneStop(list);
};
