// Every function of the C API has one verb, where its name says, and every verb is one of its functions.
import { api, assert, engine, test } from '../checks.mjs';

const kWords = {
  GridMap: ['map'],
  World: ['world'],
  ClipLibrary: ['clips'],
  Bvh: ['bvh'],
  MotionMoment: ['motion', 'moment'],
  Motion: ['motion'],
  Scenario: ['scenario'],
  TakeWriter: ['take', 'writer'],
  Take: ['take'],
};

/** What has no verb: memory and threads of a host, makers of what is only read, and what the verbs themselves call. */
const kWithout = new Set(
  `set_allocator allocator_covers_engine default_task_runner world_create_on world_restore_on last_error free_buffer
  command_list_get command_list_destroy default_characters default_group default_obstacle default_patch default_forecast
  default_take default_bvh`.split(/\s+/),
);

const camel = (words) => words.map((word, k) => (k === 0 ? word : word[0].toUpperCase() + word.slice(1))).join('');
const methodsOf = (prototype) => Object.getOwnPropertyNames(prototype).filter((name) => name !== 'constructor');

test('every function of the description has a verb, and every verb a function', async () => {
  const muster = await engine.loadMuster();
  const verbs = new Map();
  const own = Object.getPrototypeOf(Object.getPrototypeOf(muster));
  for (const name of methodsOf(own)) verbs.set(`.${name}`, own[name]);
  verbs.set('.setLog', muster.setLog);
  for (const name of Object.keys(kWords)) {
    for (const verb of methodsOf(engine[name].prototype)) verbs.set(`${name}.${verb}`, engine[name].prototype[verb]);
    const maker = muster[name];
    if (maker) for (const verb of methodsOf(Object.getPrototypeOf(maker))) verbs.set(`${name}.${verb}`, maker[verb]);
  }
  const claimed = new Set();
  for (const { name } of api.functions) {
    const words = name.replace('muster_', '').split('_');
    if (kWithout.has(words.join('_'))) continue;
    const owner = Object.keys(kWords).find(
      (one) =>
        kWords[one].every((word, k) => words[k] === word) &&
        verbs.has(`${one}.${camel(words.slice(kWords[one].length))}`),
    );
    const all = camel(words);
    const found = owner
      ? `${owner}.${camel(words.slice(kWords[owner].length))}`
      : [`.${all}`, `ClipLibrary.${all}`, `Take.${all}`].find((one) => verbs.has(one));
    assert.ok(found, `${name} has no verb`);
    assert.equal(typeof verbs.get(found), 'function', found);
    assert.ok(!claimed.has(found), `${found} stands for two functions`);
    claimed.add(found);
  }
  assert.deepEqual(
    [...verbs.keys()].filter((name) => !claimed.has(name)),
    [],
  );
  assert.equal(claimed.size, api.functions.length - kWithout.size);
});

test('every integer type with values is exported with the same numbers', () => {
  for (const { name, values } of api.integers) {
    if (!values) continue;
    const found = engine[name.replace('Muster', '')];
    assert.deepEqual(
      Object.values(found),
      values.map(({ value }) => value),
      name,
    );
  }
});

test('the library tells its version, components and formats', async () => {
  const muster = await engine.loadMuster();
  assert.match(muster.version(), /^\d+\.\d+\.\d+$/);
  for (const part of ['core', 'motion', 'io']) assert.equal(muster.hasComponent(part), true);
  assert.equal(muster.hasComponent('studio'), false);
  assert.ok(muster.exportFormats().some(({ name }) => name === 'glb'));
  assert.equal(muster.formationName(engine.FormationKind.Wedge), 'wedge');
  assert.equal(muster.formationName(99), null);
  assert.equal(muster.formationKind('ring'), engine.FormationKind.Ring);
  assert.equal(muster.statusName(engine.Status.Corrupt), 'corrupt');
  assert.equal(muster.parameterCount() > 20, true);
  for (let k = 0; k < muster.parameterCount(); k += 1) {
    const { name, standard, minimum, maximum } = muster.parameterInfo(k);
    assert.equal(muster.presetValue('muster', name), standard, name);
    assert.ok(minimum <= standard && standard <= maximum, name);
  }
});
