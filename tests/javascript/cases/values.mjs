// Definitions and what is read: defaults, round trips, and numbers of every kind.
import { api, assert, engine, refused, smallDef, test } from '../checks.mjs';

test('a definition comes back as it was given, bit for bit', async () => {
  const muster = await engine.loadMuster();
  const def = {
    ...smallDef,
    name: 'Plätze ✓',
    description: 'two groups',
    seed: 2n ** 53n - 3n,
    cell: 0.25,
    patches: [
      {
        name: 'pool',
        polygon: {
          points: [
            { x: -5, y: 5 },
            { x: 5, y: 5 },
            { x: 5, y: 9 },
          ],
        },
        motion: 4,
        speed: 0.5,
      },
    ],
    groups: [
      {
        name: 'one',
        count: 4,
        colour: 0x010203,
        demands: [1, 2, 1, 0.5],
        position: { x: 1 / 3, y: -1e-7 },
      },
      {
        name: 'two',
        count: 2,
        position: { x: 9, y: -9 },
        starts: [
          { x: 8, y: -8 },
          { x: 9, y: -8 },
        ],
        motions: engine.MotionSet.March,
      },
    ],
    items: [{ position: { x: 1, y: 2 }, radius: 0.5 }],
    parameters: [{ name: 'plan.exponent', value: 2 }],
  };
  const scenario = muster.Scenario.fromDef(def);
  const read = scenario.def();
  assert.equal(read.seed, def.seed);
  assert.equal(read.name, def.name);
  assert.equal(read.groups[0].position.x, 1 / 3);
  assert.deepEqual(
    [read.groups[0].colour, read.groups[0].motions, read.groups[1].motions],
    [0x010203, null, engine.MotionSet.March],
  );
  assert.deepEqual(read.groups[0].demands, [1, 2, 1, 0.5]);
  assert.equal(read.map, null);
  const text = scenario.text();
  assert.equal(muster.Scenario.fromDef(read).text(), text);
  assert.equal(muster.Scenario.parse(text).text(), text);
  assert.equal(JSON.parse(text).name, def.name);
  assert.equal(muster.World.create(read).hash(), muster.Scenario.parse(text).createWorld().hash());
  assert.equal(muster.World.create(def).hash(), muster.World.create(read).hash());
  const seeded = (seed) => muster.World.create({ ...def, seed, groups: [{ jitter: 0.1 }] }).hash();
  assert.notEqual(seeded(2n ** 53n - 1n), seeded(2n ** 53n - 2n));
  assert.equal(seeded(12), seeded(12n));
  refused('InvalidArgument', 'seed', () => seeded(2n ** 64n - 1n));
});

test('an empty definition is the default one', async () => {
  const muster = await engine.loadMuster();
  assert.equal(muster.Scenario.fromDef({}).text(), muster.Scenario.fromDef(muster.defaultWorldDef()).text());
  assert.deepEqual(muster.defaultGroupDef().position, { x: 0, y: 0 });
  assert.equal(muster.defaultGroupDef().count, 36);
  assert.equal(muster.defaultBody().mass, 1);
});

test('every struct that is given has its defaults in JavaScript, and is taken back', async () => {
  const muster = await engine.loadMuster();
  for (const { name, parameters } of api.functions) {
    if (!/^muster_default_/.test(name) || parameters.length > 0) continue;
    const verb = name.replace('muster_', '').replace(/_(.)/g, (_, letter) => letter.toUpperCase());
    if (muster[verb]) assert.equal(typeof muster[verb](), 'object', verb);
  }
  for (let kind = 0; kind < engine.CommandKind.Count; kind += 1) {
    const command = muster.defaultCommand(kind);
    assert.equal(command.kind, kind);
    // Defaults of some kinds are not valid in themselves; where they are, they become the same bytes.
    try {
      muster.commandValidate(command);
    } catch {
      continue;
    }
    assert.deepEqual(muster.commandEncode(command), muster.commandEncode({ kind }), String(kind));
  }
});

test('paths, lines and travels give what analysis says', async () => {
  const muster = await engine.loadMuster();
  const path = {
    waypoints: [
      { time: 0, position: { x: 0, y: 0 }, angle: 0 },
      { time: 2, position: { x: 4, y: -2 }, angle: 1 },
    ],
    loop: false,
  };
  const state = muster.timedPathAt(path, 0.5);
  assert.deepEqual(state, {
    at: { time: 0.5, position: { x: 1, y: -0.5 }, angle: 0.25 },
    velocity: { x: 2, y: -1 },
    angularVelocity: 0.5,
  });
  const order = muster.orderToLine({ x: -3, y: 2 }, { x: 3, y: 2 });
  assert.deepEqual(order.target, { x: 0, y: 2 });
  assert.equal(order.width, 6);
  assert.ok(Math.abs(order.facing - Math.PI / 2) < 1e-12, 'left at the left hand of whoever faces +y');
  const turned = muster.travelCompose({ x: 1, y: 0, yaw: Math.PI / 2 }, { x: 2, y: 0, yaw: 0.5 });
  assert.ok(
    Math.abs(turned.x - 1) < 1e-6 && Math.abs(turned.y - 2) < 1e-6 && Math.abs(turned.yaw - Math.PI / 2 - 0.5) < 1e-6,
  );
});

test('orders are carried out, foreseen and reported', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  const { id } = world.group(0);
  const forecast = world.forecast(id, { target: { x: -10, y: 8 } });
  assert.equal(forecast.arrives, true);
  assert.deepEqual([...forecast.way.slice(-2)].map(Math.round), [-10, 8]);
  const give = {
    kind: engine.CommandKind.GiveOrder,
    client: 1,
    body: { group: id, order: { target: { x: -10, y: 8 } } },
  };
  world.submit(give);
  world.submit({
    kind: engine.CommandKind.GiveOrder,
    client: 1,
    sequence: 1,
    body: { group: 77, order: {} },
  });
  world.step();
  const [rejection, ...others] = world.rejections();
  assert.equal(others.length, 0);
  assert.equal(rejection.status, engine.Status.NotFound);
  assert.match(rejection.message, /77/);
  assert.equal(rejection.command.body.group, 77);
  assert.deepEqual(world.groupOrders(0)[0].order.target, { x: -10, y: 8 });
  const seen = new Set();
  for (let k = 0; k < 60 * Math.ceil(forecast.seconds + 15); k += 1) {
    world.step();
    for (const { kind } of world.events()) seen.add(muster.eventName(kind));
  }
  for (const kind of ['orderDone', 'arrived']) assert.ok(seen.has(kind), kind);
  const { position, count } = world.characters();
  let [x, y] = [0, 0];
  for (let k = 0; k < count; k += 1) [x, y] = [x + position[2 * k] / count, y + position[2 * k + 1] / count];
  assert.ok(Math.hypot(x + 10, y - 8) < 0.1, `${x}, ${y}`);
});

test('areas, people and the ring of a world come back with what areas have seen', async () => {
  const muster = await engine.loadMuster();
  const points = [
    { x: 6, y: -1 },
    { x: 8, y: -1 },
    { x: 8, y: 1 },
  ];
  const def = {
    ...smallDef,
    ring: true,
    groups: [{ count: 4, people: [muster.adults()] }],
    areas: [
      { name: 'Tür', polygon: { points } },
      { kind: engine.AreaKind.Source, polygon: { points }, rate: 1.5, timetable: [{ time: 2, count: 3 }] },
    ],
  };
  const world = muster.World.create(def);
  assert.equal(world.ring(), true);
  const [exit, source] = world.areas();
  assert.deepEqual([exit.id, exit.def.name, exit.group, exit.passed], [1, 'Tür', 0, 0]);
  assert.deepEqual([source.def.rate, source.group, source.waiting], [1.5, 1, 0]);
  assert.deepEqual(source.def.timetable, [{ time: 2, count: 3 }]);
  assert.deepEqual([...world.characters().goal], [0, 0, 0, 0]);
  assert.equal(JSON.parse(muster.Scenario.fromDef(def).text()).groups[0].people, 'adults');
  const { speed } = muster.adults();
  assert.ok(Math.abs(muster.distributionQuantile(speed, 0.5) - 1.34) < 0.01);
  assert.equal(muster.walkingSpeedAtAge(20), 1.62);
  refused('InvalidArgument', 'share: ', () => muster.distributionQuantile(speed, 0));
});
