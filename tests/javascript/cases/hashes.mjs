// The same hashes as the native program's: scenarios to their last step, through definitions and commands of JavaScript.
import { assert, begin, engine, hex, native, references, test, withScenarios } from '../checks.mjs';

/** Short ones by the fast plan, two by the exact one, and the obstacle course, for which clips and patches matter. */
const kMostSteps = 1300;
const wanted = references.filter(
  ({ name, plan, steps }) => (steps <= kMostSteps && plan === 'fast') || (name === 'course' && plan === 'fast'),
);
const exact = references.filter(
  ({ name, plan }) => plan === 'exact' && ['paper/x03-plain-block', 'paper/x09-corridor'].includes(name),
);

for (const { name, plan, steps, hash } of [...wanted, ...exact])
  test(`${name}, ${plan} plan: the hash after ${steps} steps is the reference`, async () => {
    const muster = withScenarios(await engine.loadMuster());
    const { world } = begin(muster, name, plan);
    world.step(steps);
    assert.equal(world.stepCount(), steps);
    assert.equal(hex(world.hash()), hash);
  });

test('events are those of the native program', async () => {
  const muster = withScenarios(await engine.loadMuster());
  const name = 'paper/x06-course';
  const { steps, hash, events } = JSON.parse(
    native('play', `scenarios/${name}.json`, '--demo', '--threads', '1', '--set', 'plan.solver=1', '--json'),
  );
  const { world } = begin(muster, name, 'fast');
  const counts = Object.fromEntries(Object.keys(events).map((kind) => [kind, 0]));
  for (let k = 0; k < steps; k += 1) {
    world.step();
    for (const { kind, position } of world.events()) {
      counts[muster.eventName(kind)] += 1;
      assert.ok(Number.isFinite(position.x + position.y));
    }
  }
  assert.deepEqual(counts, events);
  assert.equal(hex(world.hash()), hash);
});

test('a snapshot goes on bit for bit, restored and rewound', async () => {
  const muster = withScenarios(await engine.loadMuster());
  const { world } = begin(muster, 'paper/x11-transport', 'fast');
  world.step(200);
  const [snapshot, before] = [world.snapshot(), world.hash()];
  world.step(200);
  const after = world.hash();
  const other = muster.World.restore(snapshot);
  assert.equal(other.hash(), before);
  other.step(200);
  assert.equal(other.hash(), after);
  world.rewind(snapshot);
  assert.equal(world.stepCount(), 200);
  world.step(200);
  assert.equal(world.hash(), after);
});

test('two libraries have memories of their own', async () => {
  const [one, two] = [await engine.loadMuster(), await engine.loadMuster()];
  const [a, b] = [one.World.create({ groups: [{}] }), two.World.create({ groups: [{}] })];
  a.step(30);
  assert.equal(b.stepCount(), 0);
  b.step(30);
  assert.equal(a.hash(), b.hash());
});
