// The module's files, and the package's own.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { assert, engine, place, refused, root, test } from '../checks.mjs';

test('files are written, listed, read and removed; failures name the path', async () => {
  const { files } = await engine.loadMuster();
  files.write('/a/b/one.txt', 'Grüße');
  files.write('/a/two.bin', new Uint8Array([1, 0, 255]));
  assert.equal(files.readText('/a/b/one.txt'), 'Grüße');
  assert.deepEqual([...files.read('/a/two.bin')], [1, 0, 255]);
  assert.deepEqual(files.list('/a'), ['b', 'two.bin']);
  assert.deepEqual(Object.keys(files.readFolder('/a')), ['b/one.txt', 'two.bin']);
  files.remove('/a');
  assert.equal(files.exists('/a'), false);
  refused('IoError', '/a/none: there is no such file or folder', () => files.read('/a/none'));
  refused('IoError', '/tmp: is a folder', () => files.write('/tmp', 'x'));
  refused('InvalidArgument', 'path: found 3', () => files.read(3));
});

test('a scenario file finds the map that lies beside it', async () => {
  const muster = await engine.loadMuster();
  const { files } = muster;
  files.write('/ground/yard.map', 'type octile\nheight 2\nwidth 2\nmap\n..\n@.\n');
  const scenario = muster.Scenario.fromDef({
    groups: [{ count: 1, position: { x: 1.5, y: 1.5 } }],
    box: { min: { x: 0, y: 0 }, max: { x: 2, y: 2 } },
  });
  const text = JSON.parse(scenario.text());
  text.map = { file: 'yard.map', origin: [0, 0] };
  files.write('/ground/yard.json', JSON.stringify(text));
  assert.equal(muster.Scenario.load('/ground/yard.json').createWorld().obstacleIds().length, 1);
  refused('ParseError', 'yard', () => muster.Scenario.parse(JSON.stringify(text), 'yard'));
});

for (const document of ['bindings/javascript/README.md', 'docs/javascript.md'])
  test(`the first program of ${document} runs`, () => {
    const [, program] = /```js\n([^]*?)```/.exec(readFileSync(join(root, document), 'utf8'));
    writeFileSync(join(place, 'first.mjs'), program);
    const said = execFileSync(process.execPath, [join(place, 'first.mjs')], { encoding: 'utf8' });
    // The order was to go to the right.
    const [, count, x] = /^(\d+) people, the first at (-?[\d.]+), /.exec(said);
    assert.equal(count, '64');
    assert.ok(Number(x) > 5 && Number(x) < 21, said);
  });

test('the package holds its licences, its types and no more than it needs', () => {
  const folder = join(place, 'node_modules/muster-engine');
  const found = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  assert.match(readFileSync(join(root, 'CMakeLists.txt'), 'utf8'), new RegExp(`muster VERSION ${found.version} `));
  assert.deepEqual(Object.keys(found.dependencies ?? {}), []);
  const notices = readFileSync(join(folder, 'THIRD-PARTY-NOTICES.txt'), 'utf8');
  for (const name of ['Eigen', 'JSON for Modern C++', 'Emscripten', 'musl', 'libc++'])
    assert.ok(notices.includes(name), name);
  assert.equal(readFileSync(join(folder, 'LICENSE'), 'utf8'), readFileSync(join(root, 'LICENSE'), 'utf8'));
  assert.ok(readFileSync(join(folder, 'README.md'), 'utf8').includes('loadMuster'));
});
