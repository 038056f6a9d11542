// Maps, obstacles, patches, items and checkpoints.
import { assert, engine, refused, smallDef, test } from '../checks.mjs';

const kRows = ['..@@....', '..@@..SS', '........', '@.......'];
const kMap = `type octile\nheight 4\nwidth 8\nmap\n${kRows.join('\n')}\n`;

const areaOf = ({ points }) =>
  points.reduce((sum, a, k) => {
    const b = points[(k + 1) % points.length];
    return sum + (a.x * b.y - a.y * b.x) / 2;
  }, 0);

test('a map’s obstacles cover its blocked cells, its patches the swamp', async () => {
  const muster = await engine.loadMuster();
  const map = muster.GridMap.parse(kMap);
  const def = map.def();
  assert.deepEqual([def.width, def.height, def.cells], [8, 4, kRows.join('')]);
  const placement = { metresPerCell: 2, origin: { x: -8, y: -4 } };
  const blocked = map.obstacles(placement);
  assert.equal(
    blocked.reduce((sum, { polygon }) => sum + areaOf(polygon), 0),
    5 * 4,
  );
  const swamp = map.patches(placement, 1);
  assert.equal(
    swamp.reduce((sum, { polygon }) => sum + areaOf(polygon), 0),
    2 * 4,
  );
  assert.deepEqual(
    swamp.map(({ motion }) => motion),
    [1],
  );
  // The same ground whether the map or what it makes is given.
  const world = muster.World.create({
    box: { min: { x: -8, y: -4 }, max: { x: 8, y: 4 } },
    map: { ...def, ...placement },
    groups: [{ count: 2, position: { x: 3, y: -2 } }],
  });
  assert.equal(world.obstacleIds().length, blocked.length);
  refused('ParseError', 'line', () => muster.GridMap.parse('type octile\nheight x\n'));
});

test('what stands in a world is read as it was given, and changed by commands', async () => {
  const muster = await engine.loadMuster();
  const path = {
    waypoints: [
      { time: 0, position: { x: 0, y: 0 }, angle: 0 },
      { time: 1, position: { x: 3, y: 0 }, angle: 0 },
    ],
    loop: false,
  };
  const points = [
    { x: -4, y: 8 },
    { x: 4, y: 8 },
    { x: 4, y: 11 },
    { x: -4, y: 11 },
  ];
  const world = muster.World.create({
    ...smallDef,
    obstacles: [{ name: 'cart', centre: { x: -9, y: -9 }, radius: 1, path }],
    patches: [{ name: 'pool', polygon: { points }, motion: 4 }],
    items: [
      { position: { x: 0, y: 0 }, radius: 1 },
      { position: { x: 15, y: 15 }, radius: 1 },
    ],
    checkpoints: [{ position: { x: 1, y: 1 }, radius: 2, group: 0 }],
  });
  const [id] = world.obstacleIds();
  assert.deepEqual(world.obstacle(id).centre, { x: -9, y: -9 });
  // Things that move stand where they were at the begin of the last step.
  world.step(61);
  assert.ok(Math.abs(world.obstacle(id).centre.x + 6) < 1e-9);
  assert.equal(world.obstacle(id).def.name, 'cart');
  assert.deepEqual(
    [...world.patch(world.patchIds()[0]).outline],
    points.flatMap(({ x, y }) => [x, y]),
  );
  const { items, ids, collected } = world.items();
  assert.deepEqual(
    items.map(({ position }) => position.x),
    [0, 15],
  );
  assert.deepEqual([[...collected], ids.length], [[1, 0], 2]);
  assert.deepEqual(world.checkpoints().groups.length, 1);
  assert.equal(world.checkpoints().checkpoints[0].radius, 2);
  assert.ok(world.contacts().overlapPairs >= 0);
  const { stages, total } = world.stageTimes();
  assert.ok(total >= 0 && stages.length > 5 && stages.every(({ name }) => name.length > 0));
  world.submit({
    kind: engine.CommandKind.RemoveThing,
    step: 61,
    body: { thing: engine.ThingKind.Obstacle, id },
  });
  world.step();
  refused('NotFound', 'obstacle', () => world.obstacle(id));
});

test('controls are read while fingers are down', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  const { finalMesh } = world.group(0);
  const down = {
    touch: 5,
    position: { x: finalMesh[0], y: finalMesh[1] },
    time: 0,
  };
  world.submit({ kind: engine.CommandKind.Touch, client: 2, body: down });
  world.step(2);
  const [control] = world.groupControls(0);
  assert.deepEqual(
    [control.client, control.points.length, control.points[0].touch, control.points[0].down],
    [2, 1, 5, true],
  );
  assert.equal(control.weights.length, control.supplementary.length * control.points.length);
});
