'use strict';
// The picture of a scene in space, by three.js.

/** A mesh with a normal at each corner: the mean over the faces there that turn by less than 30° from its own. */
page.shaded = (part) => {
  const faces = part.triangles.length / 3, corner = (f, j) => part.triangles[3 * f + j];
  const at = (v) => new THREE.Vector3(part.vertices[3 * v], part.vertices[3 * v + 1], part.vertices[3 * v + 2]);
  const normals = [], around = Array.from({ length: part.vertices.length / 3 }, () => []);
  for (let f = 0; f < faces; ++f) {
    const [a, b, c] = [0, 1, 2].map((j) => at(corner(f, j)));
    normals.push(b.sub(a).cross(c.sub(a)));  // its length is the weight of the face
    for (const j of [0, 1, 2]) around[corner(f, j)].push(f);
  }
  const units = normals.map((n) => n.clone().normalize()), positions = [], bends = [];
  for (let f = 0; f < faces; ++f) {
    for (const j of [0, 1, 2]) {
      const v = corner(f, j), sum = new THREE.Vector3();
      for (const g of around[v]) if (units[g].dot(units[f]) > 0.866) sum.add(normals[g]);
      positions.push(...part.vertices.slice(3 * v, 3 * v + 3));
      bends.push(...sum.normalize().toArray());
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(bends), 3));
  return geometry;
};

page.lines = (points, colour) => new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points.map((p) => new THREE.Vector3(...p))),
  new THREE.LineBasicMaterial({ color: colour }));

/** A plane without an end: lines on the part of it that is drawn. */
page.planeLines = (part) => {
  const corner = (i) => new THREE.Vector3(...part.vertices.slice(3 * i, 3 * i + 3)), points = [], kCells = 12;
  for (let i = 0; i <= kCells; ++i) {
    const between = (a, b) => corner(a).lerp(corner(b), i / kCells).toArray();
    points.push(between(0, 1), between(3, 2), between(0, 3), between(1, 2));
  }
  return page.lines(points, page.style('--muted'));
};

/** A letter that always faces the reader. */
page.letter = (text, size) => {
  const canvas = page.element('canvas', { width: 64, height: 64 }), context = canvas.getContext('2d');
  context.font = '52px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillStyle = '#fff';
  context.fillText(text, 32, 34);
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map: new THREE.CanvasTexture(canvas), depthTest: false }));
  sprite.scale.set(size, size, 1);
  return sprite;
};

/** The ground, a grid below everything, and the three axes from a corner of it. */
page.ground = (scene, bounds, size) => {
  const step = page.niceStep(size, 14), z = bounds.min.z - 1e-3 * size, points = [];
  const from = [0, 1].map((j) => step * Math.floor(bounds.min.getComponent(j) / step - 1));
  const to = [0, 1].map((j) => step * Math.ceil(bounds.max.getComponent(j) / step + 1));
  for (let x = from[0]; x <= to[0] + step / 2; x += step) points.push([x, from[1], z], [x, to[1], z]);
  for (let y = from[1]; y <= to[1] + step / 2; y += step) points.push([from[0], y, z], [to[0], y, z]);
  const grid = page.lines(points, page.style('--grid'));
  scene.add(grid);
  const length = 0.16 * size, origin = [from[0], from[1], z], inked = [];
  ['x', 'y', 'z'].forEach((name, j) => {
    const end = origin.map((value, i) => value + (i === j ? length : 0));
    const axis = page.lines([origin, end], page.style('--ink')), letter = page.letter(name, 0.05 * size);
    letter.position.set(...origin.map((value, i) => value + (i === j ? 1.15 * length : 0)));
    scene.add(axis, letter);
    inked.push(axis.material, letter.material);
  });
  page.showLegend(step);
  return () => {
    grid.material.color.set(page.style('--grid'));
    for (const material of inked) material.color.set(page.style('--ink'));
  };
};

page.spaceView = (canvas) => {
  const { drawing } = page;
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(canvas.width, canvas.height, false);
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(40, canvas.width / canvas.height, 0.001, 1e6);
  camera.up.set(0, 0, 1);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x555566, 0.85));
  const sun = new THREE.DirectionalLight(0xffffff, 0.5);
  sun.position.set(1, -2, 3);
  scene.add(sun);
  const groups = drawing.bodies.map((body, number) => {
    const group = new THREE.Group();
    group.matrixAutoUpdate = false;
    group.userData.number = number;
    group.userData.material = new THREE.MeshLambertMaterial({ side: THREE.DoubleSide });
    for (const part of body.parts) {
      group.add(new THREE.Mesh(page.shaded(part), group.userData.material));
      if (!part.plane) continue;
      group.add(page.planeLines(part));
      group.userData.material.transparent = true;
      group.userData.material.opacity = 0.4;
    }
    scene.add(group);
    return group;
  });
  const put = (k) => groups.forEach((group, number) => {
    const p = page.pose(drawing.bodies[number], k);
    group.matrix.set(p[3], p[6], p[9], p[0], p[4], p[7], p[10], p[1], p[5], p[8], p[11], p[2], 0, 0, 0, 1);
    group.updateMatrixWorld(true);
  });
  const bounds = new THREE.Box3();
  for (let k = 0; k < page.times.length; k += Math.max(1, page.times.length >> 4)) {
    put(k);
    for (const group of groups) bounds.expandByObject(group);
  }
  const middle = bounds.getCenter(new THREE.Vector3()), size = bounds.getSize(new THREE.Vector3()).length();
  const colourGround = page.ground(scene, bounds, size);
  const links = new THREE.Group();
  scene.add(links);
  const eye = { around: -0.9, above: 0.45, away: 1.35 * size };

  const drawLinks = (k) => {
    while (links.children.length) links.remove(links.children[0]);
    const material = new THREE.MeshBasicMaterial({ color: page.style('--mark'), depthTest: false });
    for (const r of page.atFrame[k] || []) {
      if (!r.pa) continue;
      const line = page.lines([r.pa, r.pb], page.style('--mark'));
      line.material.depthTest = false;
      links.add(line);
      for (const end of [r.pa, r.pb]) {
        const dot = new THREE.Mesh(new THREE.SphereBufferGeometry(size / 150, 12, 8), material);
        dot.position.set(...end);
        links.add(dot);
      }
    }
  };
  const draw = (k) => {
    put(k);
    const near = page.nearness(k);
    groups.forEach((group, number) => {
      group.userData.material.color.set(page.colour(near[number]));
      group.userData.material.emissive.set(page.highlit === number ? 0x404040 : 0);
    });
    drawLinks(k);
    colourGround();
    camera.position.set(middle.x + eye.away * Math.cos(eye.above) * Math.cos(eye.around),
      middle.y + eye.away * Math.cos(eye.above) * Math.sin(eye.around), middle.z + eye.away * Math.sin(eye.above));
    camera.lookAt(middle);
    camera.updateMatrixWorld();
    renderer.setClearColor(page.style('--soft'));
    renderer.render(scene, camera);
  };
  const ray = new THREE.Raycaster();
  return {
    draw,
    pick: (x, y) => {
      ray.setFromCamera(new THREE.Vector2(2 * x / canvas.width - 1, 1 - 2 * y / canvas.height), camera);
      const hit = ray.intersectObjects(groups, true)[0];
      return hit ? hit.object.parent.userData.number : null;
    },
    placeOf: (number) => {
      const p = new THREE.Box3().setFromObject(groups[number]).getCenter(new THREE.Vector3()).project(camera);
      return [(p.x + 1) / 2 * canvas.width, (1 - p.y) / 2 * canvas.height];
    },
    turn: (right, up, nearer) => {
      eye.around -= right;
      eye.above = Math.max(-1.5, Math.min(1.5, eye.above + up));
      eye.away *= Math.exp(-nearer);
      draw(page.frame);
    },
    hint: 'Space: play or pause. Arrow keys: one picture; in the picture they turn it, + and - move nearer. Drag: turn. Wheel: nearer. Point at a body for its name.',
  };
};
