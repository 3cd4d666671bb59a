'use strict';
// The picture with its controls.
page.view = null;

page.show = (k) => {
  if (!page.view) return;
  page.frame = Math.max(0, Math.min(page.times.length - 1, k));
  page.byId('slider').value = page.frame;
  page.byId('slider').setAttribute('aria-valuetext', page.digits(page.times[page.frame]) + ' seconds');
  page.byId('clock').textContent = page.digits(page.times[page.frame]) + ' s';
  for (const move of page.cursors) move(page.times[page.frame]);
  page.view.draw(page.frame);
};

page.play = (on) => {
  page.playing = on;
  page.byId('play').textContent = on ? 'Pause' : 'Play';
  let previous = 0;
  const step = (now) => {
    if (!page.playing) return;
    if (now - previous > 40) { previous = now; page.show(page.frame + 1 < page.times.length ? page.frame + 1 : 0); }
    requestAnimationFrame(step);
  };
  if (on) requestAnimationFrame(step);
};

/** Shows the picture of a time, and keeps it in view. */
page.goTo = (time) => {
  if (!page.view || time === null) return;
  page.play(false);
  page.show(page.frameOf(time));
  const box = page.byId('view').getBoundingClientRect();
  if (box.top < 0 || box.bottom > innerHeight) page.byId('view').scrollIntoView({ block: 'nearest' });
};

/** Names a body beside the pointer, or in the picture where there is none; null: no body. */
page.point = (number, place) => {
  const label = page.byId('name');
  if (page.highlit !== number) {
    page.highlit = number;
    page.view.draw(page.frame);
  }
  label.hidden = number === null;
  if (number === null) return;
  const canvas = page.byId('canvas');
  const [x, y] = place || page.view.placeOf(number).map((value) => value * canvas.clientWidth / canvas.width);
  label.textContent = page.data.bodies[number];
  label.style.left = Math.max(0, Math.min(canvas.clientWidth - label.offsetWidth, x + 12)) + 'px';
  label.style.top = Math.max(0, Math.min(canvas.clientHeight - label.offsetHeight, y + 12)) + 'px';
};

page.listenToPointer = (canvas) => {
  let held = null;
  const inside = (event) => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  canvas.addEventListener('pointerdown', (event) => { held = [event.clientX, event.clientY]; });
  addEventListener('pointerup', () => { held = null; });
  addEventListener('pointermove', (event) => {
    if (held) {
      page.view.turn((event.clientX - held[0]) / 150, (event.clientY - held[1]) / 150, 0);
      held = [event.clientX, event.clientY];
    } else if (event.target === canvas) {
      const [x, y] = inside(event), grow = canvas.width / canvas.clientWidth;
      page.point(page.view.pick(x * grow, y * grow), [x, y]);
    }
  });
  canvas.addEventListener('pointerleave', () => page.point(null));
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    page.view.turn(0, 0, -event.deltaY / 800);
  }, { passive: false });
};

page.listenToKeys = (canvas) => {
  const turns = { ArrowLeft: [-0.1, 0, 0], ArrowRight: [0.1, 0, 0], ArrowUp: [0, 0.1, 0], ArrowDown: [0, -0.1, 0], '+': [0, 0, 0.1], '-': [0, 0, -0.1] };
  canvas.addEventListener('keydown', (event) => {
    if (!turns[event.key] || page.drawing.dimension === 2) return;
    event.preventDefault();
    event.stopPropagation();
    page.view.turn(...turns[event.key]);
  });
  addEventListener('keydown', (event) => {
    if (['INPUT', 'SELECT'].includes(event.target.tagName)) return;
    if (event.key === ' ' && event.target.tagName !== 'BUTTON') { event.preventDefault(); page.play(!page.playing); }
    const steps = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (steps) { page.play(false); page.show(page.frame + steps); }
  });
};

page.startStage = () => {
  const canvas = page.byId('canvas');
  if (!page.drawing) {
    page.byId('stage').remove();
    document.querySelector('main').classList.add('plain');
    return;
  }
  try {
    page.view = page.drawing.dimension === 2 ? page.flatView(canvas) : page.spaceView(canvas);
  } catch (error) {
    page.byId('view').textContent = 'This browser has no WebGL; the answers below are complete without it.';
    page.byId('controls').remove();
    return;
  }
  page.byId('hint').textContent = page.view.hint;
  page.byId('slider').max = page.times.length - 1;
  page.byId('slider').addEventListener('input', (event) => { page.play(false); page.show(Number(event.target.value)); });
  page.byId('play').addEventListener('click', () => page.play(!page.playing));
  page.listenToPointer(canvas);
  page.listenToKeys(canvas);
};
