// Wrong values, destroyed handles, functions that throw: one sentence each, and the library goes on.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { assert, engine, place, refused, smallDef, test } from '../checks.mjs';

test('wrong definitions are refused with the place of the fault', async () => {
  const muster = await engine.loadMuster();
  const create = (def) => () => muster.World.create(def);
  refused(
    'InvalidArgument',
    'def.groups[0]: found "cuont", expected no other fields',
    create({ groups: [{ cuont: 3 }] }),
  );
  refused(
    'InvalidArgument',
    'def.groups[0].count: found 3.5, expected a whole number',
    create({ groups: [{ count: 3.5 }] }),
  );
  refused('InvalidArgument', 'def.groups[0].count: found "3", expected a number', create({ groups: [{ count: '3' }] }));
  refused('InvalidArgument', 'def.groups: found an object, expected an array', create({ groups: { count: 3 } }));
  refused(
    'InvalidArgument',
    'def.box.min.y: found nothing, expected a number',
    create({ box: { min: { x: 1 }, max: { x: 2, y: 2 } } }),
  );
  refused(
    'InvalidArgument',
    'def.box.max: found nothing, expected an object',
    create({ box: { min: { x: 1, y: 1 } } }),
  );
  refused('InvalidArgument', 'def.seed: found -1', create({ seed: -1 }));
  refused('InvalidArgument', 'def.name: found 7, expected a text', create({ name: 7 }));
  refused('InvalidArgument', 'zero characters', create({ name: 'a\0b' }));
  refused('InvalidArgument', 'def.groups[0].demands[1]: found "x"', create({ groups: [{ demands: [1, 'x'] }] }));
  refused('InvalidArgument', 'def: found an array', create([]));
  refused('InvalidArgument', 'groups[0]: count is -3', create({ groups: [{ count: -3 }] }));
  refused('InvalidArgument', 'nan', create({ groups: [{ position: { x: NaN, y: 0 } }] }));
  refused('NotFound', 'no.such', create({ parameters: [{ name: 'no.such', value: 1 }] }));
  refused('InvalidArgument', 'threads: found "two"', () => muster.World.create({}, 'two'));
  assert.equal(muster.World.create(smallDef).characters().count, 36);
});

test('wrong commands are refused with the place of the fault', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  const submit = (command) => () => world.submit(command);
  const { Count } = engine.CommandKind;
  refused(
    'InvalidArgument',
    `command.kind: found ${Count}, expected a CommandKind, 0 to ${Count - 1}`,
    submit({ kind: Count }),
  );
  refused('InvalidArgument', 'command.kind: found nothing', submit({}));
  refused('InvalidArgument', 'command: found an array', submit([]));
  refused('InvalidArgument', 'command', submit(undefined));
  refused('InvalidArgument', 'command.body: found "finger"', submit({ kind: 0, body: { finger: 1 } }));
  refused('InvalidArgument', 'command.body.touch: found -1', submit({ kind: 0, body: { touch: -1 } }));
  refused('InvalidArgument', 'command.body.position: found an array', submit({ kind: 0, body: { position: [1, 2] } }));
  world.step(5);
  refused('InvalidArgument', 'step', submit({ kind: 7, step: 2 }));
  assert.equal(world.stepCount(), 5);
});

test('handles that were destroyed, or are of another kind or library, are refused', async () => {
  const [muster, other] = [await engine.loadMuster(), await engine.loadMuster()];
  const world = muster.World.create(smallDef);
  const motion = muster.Motion.create(muster.ClipLibrary.own());
  refused('InvalidArgument', 'world: found a Motion, expected a World', () => motion.update(motion));
  refused('InvalidArgument', 'world: found nothing, expected a World', () => motion.update());
  refused('InvalidArgument', 'of the same module', () => motion.update(other.World.create(smallDef)));
  assert.equal(world.isValid(), true);
  world.destroy();
  assert.equal(world.isValid(), false);
  for (const action of [
    () => world.step(),
    () => world.hash(),
    () => world.characters(),
    () => motion.update(world),
    () => world.destroy(),
  ])
    refused('NotFound', 'handle', action);
  world[Symbol.dispose]();
  const next = muster.World.create(smallDef);
  refused('NotFound', 'handle', () => world.step());
  next.step();
});

test('scenarios are refused as by the program', async () => {
  const muster = await engine.loadMuster();
  refused('ParseError', 'mine.json', () => muster.Scenario.parse('{"muster_scenario": 1, "groups": [', 'mine.json'));
  refused('IoError', '/none.json', () => muster.Scenario.load('/none.json'));
  assert.ok(JSON.parse(muster.scenarioSchema()).$schema.includes('2020-12'));
  assert.ok(JSON.parse(muster.gesturesSchema()).$schema.includes('2020-12'));
  const warned = muster.Scenario.fromDef({
    ...smallDef,
    obstacles: [{ centre: { x: 0, y: 0 }, radius: 1 }],
    items: [{ position: { x: 500, y: 0 }, radius: 1 }],
  });
  for (const sentence of warned.warnings()) assert.equal(typeof sentence, 'string');
});

test('the log hears of failures; what its function throws comes out of the call', async () => {
  const muster = await engine.loadMuster();
  const heard = [];
  muster.setLog((level, message) => heard.push([level, message]));
  refused('NotFound', 'nope', () => muster.World.create(smallDef).parameter('nope'));
  assert.deepEqual(heard.length, 1);
  assert.equal(heard[0][0], engine.LogLevel.Failure);
  assert.match(heard[0][1], /nope/);
  muster.setLog(() => {
    throw new TypeError('from the log');
  });
  assert.throws(() => muster.formationKind('none'), /^TypeError: from the log$/);
  muster.setLog(() => muster.version());
  refused('InvalidArgument', 'must not call the library', () => muster.formationKind('none'));
  muster.setLog(null);
  refused('NotFound', 'none', () => muster.formationKind('none'));
  assert.equal(heard.length, 1);
  refused('InvalidArgument', 'function: found 3', () => muster.setLog(3));
});

/** The module with memory for 100 MB at most: its memory section says so, `05 size 01 01 LEAST MOST`. */
function smallModule() {
  const bytes = readFileSync(join(place, 'node_modules/muster-engine/dist/muster.wasm'));
  let at = 8;
  const number = () => {
    let [value, shift] = [0, 0];
    for (;;) {
      const byte = bytes[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
      shift += 7;
    }
  };
  for (;;) {
    const section = bytes[at++];
    const size = number();
    if (section === 5) break;
    at += size;
  }
  at += 2;
  number();
  const pages = 1600;
  assert.deepEqual([...bytes.subarray(at, at + 3)], [0x80, 0x80, 2], 'the most is 2 GB');
  bytes.set([(pages & 127) | 128, (pages >> 7) | 128, 0], at);
  return bytes;
}

test('a module that has no memory left stops with a sentence, others go on', async () => {
  const [muster, other] = [await engine.loadMuster({ wasm: smallModule() }), await engine.loadMuster()];
  muster.World.create(smallDef).step();
  const large = {
    box: { min: { x: -480, y: -480 }, max: { x: 480, y: 480 } },
    cell: 0.25,
    groups: [{}],
  };
  refused('Internal', 'the module has stopped', () => muster.World.create(large));
  refused('Internal', 'load it anew', () => muster.version());
  other.World.create(smallDef).step();
  const many = new Float64Array(2e7);
  const third = await engine.loadMuster({ wasm: smallModule() });
  refused('OutOfMemory', 'memory', () => third.World.create({ groups: [{ demands: many }] }));
  third.World.create(smallDef).step();
});

test('the module is not found', async () => {
  await assert.rejects(engine.loadMuster({ wasm: new URL('file:///none/muster.wasm') }), /none\/muster\.wasm/);
  await assert.rejects(engine.loadMuster({ wasm: new Uint8Array([1, 2, 3]) }), WebAssembly.CompileError);
});
