'use strict';
// Puts the page of a scene together from its data.
(() => {
  const { data } = page, counted = (count, one, many) => count + ' ' + (count === 1 ? one : many);
  page.byId('verdict').textContent = data.verdict.text;
  page.byId('verdict').className = data.verdict.state;
  document.title = data.name + ' – raygauge scene';
  page.byId('summary').textContent = data.name + ': ' + counted(data.bodies.length, 'body', 'bodies') + ', ' +
    counted(data.queries.length, 'query', 'queries') + ', ' + counted(data.count, 'answer', 'answers') + (data.finished ? '.' : '. The run is not finished.');
  page.startStage();
  page.startEvents();
  page.startGrasps();
  page.startTimelines();
  page.startCosts();
  page.startSimulations();
  page.startBodies();
  page.startTallies();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => page.show(page.frame));
  page.show(0);
  document.documentElement.dataset.ready = 'true';
})();
