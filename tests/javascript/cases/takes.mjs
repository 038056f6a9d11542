// Takes of the package for the native program, and the reverse.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { jupedsimRows } from '../../../web/tests/support/jupedsim_rows.mjs';
import { assert, begin, engine, hex, native, refused, test, withScenarios } from '../checks.mjs';

const folder = mkdtempSync(join(tmpdir(), 'muster-takes-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));

/** Records a scenario with what it carries; the bytes of the take and the last hash. */
function record(muster, name, steps) {
  const { def, world, commands } = begin(muster, name, 'fast');
  const writer = muster.TakeWriter.create('/takes/recorded.take', def, true);
  for (const command of commands) writer.command(command);
  for (let k = 0; k < steps; k += 1) {
    world.step();
    writer.observe(world);
  }
  writer.finish(world);
  return {
    bytes: muster.files.read('/takes/recorded.take'),
    hash: hex(world.hash()),
  };
}

async function recorded() {
  const muster = withScenarios(await engine.loadMuster());
  muster.files.write('/takes/.keep', '');
  return { muster, ...record(muster, 'paper/x08-congestion', 600) };
}

test('a take of the package is reproduced by the native program, all hashes equal', async () => {
  const { bytes, hash } = await recorded();
  const file = join(folder, 'package.take');
  writeFileSync(file, bytes);
  const report = JSON.parse(native('replay', file, '--json'));
  assert.equal(report.reproduced, true);
  assert.equal(report.steps, 600);
  assert.equal(report.hash, hash);
  assert.ok(report.marks > 8 && report.unmarked_steps === 0 && report.finished);
});

test('a take of the native program is reproduced by the package, all hashes equal', async () => {
  const muster = await engine.loadMuster();
  const file = join(folder, 'native.take');
  native('play', 'scenarios/corridor.json', '--demo', '--threads', '1', '--take', file);
  const said = JSON.parse(native('replay', file, '--json'));
  const take = muster.Take.parse(readFileSync(file), 'native.take');
  let seen = 0;
  const report = take.replay(1, engine.ReplayFrom.Simulation, (world) => {
    seen += 1;
    assert.equal(world.stepCount(), seen);
  });
  assert.deepEqual([report.steps, report.compared, hex(report.hash)], [said.steps, said.marks, said.hash]);
  assert.equal(seen, said.steps);
  const { commands, marks, frames, finished, def } = take.get();
  assert.deepEqual([commands.length, marks.length, finished], [said.commands, said.marks, true]);
  assert.equal(marks.at(-1).hash, report.hash);
  assert.equal(frames[0].ids.length * 2, frames[0].positions.length);
  // The same by hand: a world of the definition, and each command as JavaScript has it.
  const world = muster.World.create(def);
  for (const command of commands) world.submit(muster.commandDecode(muster.commandEncode(command))[0]);
  for (const { step, hash } of marks) {
    world.step(step - world.stepCount());
    assert.equal(world.hash(), hash);
  }
});

test('a replay ends where its function says so, and throws what it throws', async () => {
  const { muster, bytes } = await recorded();
  const take = muster.Take.parse(bytes);
  let seen = 0;
  assert.equal(take.replay(1, 0, () => ++seen < 25).steps, 25);
  assert.throws(
    () =>
      take.replay(1, 0, () => {
        throw new RangeError('enough');
      }),
    /^RangeError: enough$/,
  );
  const throwsNumber = () => {
    throw 7; // As C++ exceptions would come out of the module.
  };
  assert.throws(
    () => take.replay(1, 0, throwsNumber),
    (error) => error === 7,
  );
  assert.equal(take.replay().steps, 600, 'the library goes on');
  let kept;
  take.replay(1, 0, (world) => ((kept = world), false));
  refused('NotFound', 'handle', () => kept.step());
});

test('damaged takes are refused with the place of the damage', async () => {
  const { muster, bytes } = await recorded();
  const wrong = bytes.slice();
  wrong[400] ^= 1;
  refused('Corrupt', 'a.take', () => muster.Take.parse(wrong, 'a.take'));
  refused('ParseError', 'b.take', () => muster.Take.parse(new Uint8Array(20), 'b.take'));
  const torn = muster.Take.parse(bytes.subarray(0, bytes.length - 7), 'c.take');
  assert.ok(torn.get().tornBytes > 0n && !torn.get().finished);
});

/** The deepest difference of numbers in two values of the same shape. */
function farthest(a, b) {
  if (typeof a === 'number') return Math.abs(a - b);
  assert.equal(typeof a, typeof b);
  if (typeof a !== 'object' || a === null) return assert.equal(a, b) ?? 0;
  assert.deepEqual(Object.keys(a), Object.keys(b));
  return Object.keys(a).reduce((most, key) => Math.max(most, farthest(a[key], b[key])), 0);
}

test('exports are those of the native program: trajectories byte for byte, joints to a tenth of a millimetre', async () => {
  const { muster, bytes } = await recorded();
  const file = join(folder, 'exported.take');
  writeFileSync(file, bytes);
  const [take, library] = [muster.Take.parse(bytes), muster.ClipLibrary.own()];
  for (const format of ['pedpy', 'joints', 'glb']) {
    const out = join(folder, `out.${format}`);
    native(
      'export',
      file,
      '--format',
      format,
      '--out',
      out,
      '--from',
      '1',
      '--to',
      '3',
      '--fps',
      '24',
      '--threads',
      '1',
    );
    const shares = [];
    take.exportTake(library, format, `/out.${format}`, { from: 1, to: 3, fps: 24 }, (share) => void shares.push(share));
    const text = muster.files.readText(`/out.${format}`);
    if (format === 'pedpy') assert.equal(text, readFileSync(out, 'utf8'));
    if (format === 'joints') assert.ok(farthest(JSON.parse(text), JSON.parse(readFileSync(out, 'utf8'))) < 1e-4);
    if (format === 'glb')
      assert.deepEqual([...muster.files.read('/out.glb').subarray(0, 8)], [...readFileSync(out).subarray(0, 8)]);
    assert.ok(shares.length > 2 && shares.every((share, k) => share >= (shares[k - 1] ?? 0)) && shares.at(-1) === 1);
  }
  take.exportTake(library, 'bvh', '/bvh', { to: 1 });
  assert.ok(Object.keys(muster.files.readFolder('/bvh')).length >= 36);
  refused('Unsupported', 'cancelled', () => take.exportTake(library, 'glb', '/none.glb', {}, () => false));
  assert.equal(muster.files.exists('/none.glb'), false);
  refused('Unsupported', 'jupedsim', () => take.exportTake(library, 'jupedsim', '/a.sqlite'));
});

test('with an SQLite of the caller files for JuPedSim have the rows of the native program', async () => {
  const tools = createRequire(new URL('../../../web/package.json', import.meta.url));
  const sqlite = await tools('sql.js')();
  const recording = await recorded();
  const file = join(folder, 'for-jupedsim.take');
  writeFileSync(file, recording.bytes);
  const out = join(folder, 'native.sqlite');
  native('export', file, '--format', 'jupedsim', '--out', out, '--fps', '10', '--to', '3');
  const muster = await engine.loadMuster({ sqlite });
  const library = muster.ClipLibrary.own();
  muster.Take.parse(recording.bytes).exportTake(library, 'jupedsim', '/a.sqlite', { fps: 10, to: 3 });
  const ours = jupedsimRows(sqlite, muster.files.read('/a.sqlite'));
  assert.equal(ours[3].length, 31 * 36);
  assert.deepEqual(ours, jupedsimRows(sqlite, readFileSync(out)));
});
