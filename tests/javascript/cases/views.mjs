// Read-outs: views without copies, their end, growth of the memory, rows and columns.
import { assert, engine, refused, smallDef, test } from '../checks.mjs';

test('characters are views of the engine’s own arrays', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  world.step(3);
  const one = world.characters();
  const two = world.characters();
  assert.equal(one.position.length, 72);
  assert.equal(one.position.buffer, two.position.buffer);
  assert.equal(one.position.byteOffset, two.position.byteOffset);
  assert.deepEqual(
    [...one.id],
    Array.from({ length: 36 }, (_, k) => k + 1),
  );
  assert.deepEqual(
    [one.group.constructor, one.phase.constructor, one.place.constructor],
    [Uint32Array, Uint8Array, Int32Array],
  );
  for (let k = 0; k < 36; k += 1)
    assert.ok(Math.abs(Math.hypot(one.heading[2 * k], one.heading[2 * k + 1]) - 1) < 1e-9);
});

test('a read-out ends with the step, its copy does not', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  const [characters, group] = [world.characters(), world.group(0)];
  const copy = characters.copy();
  const { body } = characters;
  const first = copy.position.slice();
  world.submit({
    kind: engine.CommandKind.GiveOrder,
    body: { group: group.id, order: { target: { x: -5, y: 5 } } },
  });
  assert.equal(characters.count, 36, 'commands end nothing');
  world.step(60);
  refused('InvalidArgument', 'Characters: ', () => characters.position);
  refused('InvalidArgument', 'Group: ', () => group.name);
  refused('InvalidArgument', 'Body: ', () => body.at(0));
  assert.deepEqual(copy.position, first);
  assert.notDeepEqual(world.characters().position, first);
  assert.equal(JSON.parse(JSON.stringify(world.group(0))).name, 'all');
  const last = world.characters();
  world.destroy();
  refused('InvalidArgument', 'Characters: ', () => last.id);
});

test('read-outs stay right when the memory grows', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  world.step(5);
  const characters = world.characters();
  const before = characters.position.slice();
  const stale = characters.position;
  const size = muster.memorySize();
  const large = muster.World.create({
    box: { min: { x: -150, y: -150 }, max: { x: 150, y: 150 } },
    cell: 0.25,
    groups: [{ count: 5000 }],
  });
  large.step(2);
  assert.ok(muster.memorySize() > size, 'the large world has taken more memory');
  assert.equal(stale.length, 0, 'a view of before is detached');
  assert.deepEqual(characters.position, before);
  world.step();
  assert.equal(world.characters().count, 36);
});

test('rows and columns say the same', async () => {
  const muster = await engine.loadMuster();
  const bodies = Array.from({ length: 4 }, (_, k) => ({
    radius: 0.25 * (k + 1),
    mass: k + 1,
    supply: 1,
    unitClass: k,
  }));
  const world = muster.World.create({
    ...smallDef,
    groups: [{ count: 4, bodies }],
  });
  const { body } = world.characters();
  assert.equal(body.length, 4);
  assert.deepEqual(
    [...body].map(({ unitClass }) => unitClass),
    [0, 1, 2, 3],
  );
  assert.deepEqual([...body.column('mass')], [1, 2, 3, 4]);
  assert.deepEqual([...body.column('unitClass')], [0, 1, 2, 3]);
  const room = new Float64Array(6).fill(9);
  assert.equal(body.column('radius', room), room);
  assert.deepEqual([...room], [0.25, 0.5, 0.75, 1, 9, 9]);
  refused('InvalidArgument', 'index: found 4', () => body.at(4));
  refused('InvalidArgument', 'name: found "weight"', () => body.column('weight'));
  refused('InvalidArgument', 'into: found a Float32Array', () => body.column('mass', new Float32Array(4)));
});

test('a mesh’s triangles lie counter-clockwise and cover its places', async () => {
  const muster = await engine.loadMuster();
  const group = muster.World.create(smallDef).group(0);
  const { restMesh, triangles, meshPlaces, placePositions, finalMesh } = group;
  let area = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => ({
      x: restMesh[2 * triangles[t + k]],
      y: restMesh[2 * triangles[t + k] + 1],
    }));
    const one = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    assert.ok(one > 0);
    area += one;
  }
  assert.ok(area > 25 && area < 60, `36 places at 1 m, found ${area} m^2`);
  assert.equal(meshPlaces.length, 36);
  meshPlaces.column('triangle').forEach((triangle, k) => {
    const { weight } = meshPlaces.at(k);
    const [x, y] = [0, 1].map((axis) =>
      weight.reduce((sum, one, corner) => sum + one * finalMesh[2 * triangles[3 * triangle + corner] + axis], 0),
    );
    assert.ok(Math.hypot(x - placePositions[2 * k], y - placePositions[2 * k + 1]) < 1e-9);
  });
});
