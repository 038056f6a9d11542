// Files of the player, read by the player's own code, beside other exports of the same takes.
import { readFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { expect } from '../support/expect.mjs';

/** The script and a file of 100 people for 20 s, with gzip [bytes]. */
const kMost = 250_000;

let reader = null;

/** The player's code, without its pages. */
async function player() {
  if (reader) return reader;
  const outfile = join(mkdtempSync(join(tmpdir(), 'muster-player-')), 'player.mjs');
  const from = new URL('../../src/player/', import.meta.url).pathname;
  const contents = `export * from '${from}file/loaded_crowd'; export * from '${from}file/player_file';
    export * from '${from}play/crowd_moment'; export * from '${from}play/pose_bank';`;
  const stdin = { contents, resolveDir: from, loader: 'ts' };
  await build({ stdin, bundle: true, format: 'esm', outfile, logLevel: 'error' });
  reader = await import(pathToFileURL(outfile).href);
  return reader;
}

async function loaded(folder, name) {
  const { loadCrowd } = await player();
  return loadCrowd(new Uint8Array(readFileSync(join(folder, `${name}.muster-player`))));
}

const kB = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;

/** What everything weighs, and that the reference keeps its bound. */
export async function sizes(folder) {
  const { readPlayerFile } = await player();
  const script = gzipSync(readFileSync(join(folder, 'muster-player.js')), { level: 9 }).length;
  console.log(`measured: muster-player.js ${kB(script)} with gzip`);
  for (const name of ['market', 'course', 'cars', 'thousand']) {
    const bytes = readFileSync(join(folder, `${name}.muster-player`));
    const file = readPlayerFile(new Uint8Array(bytes));
    const { head } = file;
    const zipped = gzipSync(bytes, { level: 9 }).length;
    const seconds = head.samples / head.fps;
    console.log(
      `measured: ${name}: ${head.most} people, ${(head.frames / head.fps).toFixed(0)} s: ${kB(zipped)} with gzip: bodies ` +
        `${kB(file.body.length)}, ${head.clips} clips ${kB(file.clip.length)}, ground and things ${kB(file.land.length)}, ` +
        `frames ${kB(file.crowd.length)}, ${(file.crowd.length / seconds).toFixed(1)} bytes for a second of a person; with the script ${kB(script + zipped)}`,
    );
    if (name !== 'market') continue;
    expect(
      head.most === 100 && head.frames === 301,
      `the reference has 100 people for 20 s: ${head.most}, ${head.frames}`,
    );
    expect(script + zipped <= kMost, `${script + zipped} bytes, at most ${kMost}`);
  }
}

/** Every place in every frame, beside the trajectories that PedPy reads. */
export async function places(folder) {
  for (const name of ['market', 'cars']) {
    const { crowd, head } = await loaded(folder, name);
    const rows = readFileSync(join(folder, `${name}.txt`), 'utf8').split('\n');
    let [worst, compared] = [0, 0];
    for (const row of rows) {
      if (row.startsWith('#') || row.trim() === '') continue;
      const [id, frame, x, y] = row.trim().split(/\s+/).map(Number);
      if (frame >= head.frames) continue;
      let at = crowd.first[frame];
      while (at < crowd.first[frame + 1] && crowd.people[crowd.who[at]].id !== id) ++at;
      expect(at < crowd.first[frame + 1], `${name}: ${id} is in frame ${frame}`);
      worst = Math.max(worst, Math.abs(crowd.x[at] - x), Math.abs(crowd.y[at] - y));
      ++compared;
    }
    expect(compared === head.samples, `${name}: as many places: ${compared}, ${head.samples}`);
    expect(worst < 0.0026, `${name}: places differ by up to ${worst} m`);
    console.log(
      `measured: ${name}: ${compared} places differ by at most ${(1000 * worst).toFixed(2)} mm from the trajectories`,
    );
  }
}

/** Heights of hips and heads, and where hands are, beside the joints of the same moments, with feet that are locked. */
export async function bodies(folder) {
  const { CrowdMoment, PoseBank } = await player();
  const course = await loaded(folder, 'course');
  const real = JSON.parse(readFileSync(join(folder, 'course.json'), 'utf8'));
  const [moment, bank] = [new CrowdMoment(course), new PoseBank(course.figures.skeleton, course.clips)];
  const out = new Float32Array(8 * bank.joints);
  const joints = ['Hips', 'Head', 'LeftHand', 'RightHand'].map((name) => real.joints.indexOf(name));
  const errors = [];
  let lying = 0;
  for (const frame of real.frames) {
    moment.goTo(frame.time);
    expect(moment.count === frame.characters.length, `as many people at ${frame.time} s`);
    for (let i = 0; i < moment.count; ++i) {
      const { positions } = frame.characters[i];
      bank.write(moment.clip[i], moment.time[i], moment.fromClip[i], moment.fromTime[i], moment.fade[i], out, 0);
      for (const joint of joints) errors.push(Math.abs(height(course, out, joint) - positions[3 * joint + 2]));
      if (positions[3 * joints[1] + 2] < 0.9) ++lying;
    }
  }
  errors.sort((a, b) => a - b);
  const [median, p99] = [0.5, 0.99].map((share) => errors[Math.floor(share * errors.length)]);
  expect(lying > 100, `people crawl and swim: ${lying}`);
  expect(median < 0.03 && p99 < 0.15, `heights differ by ${median} m, p99 ${p99} m`);
  console.log(
    `measured: course: ${errors.length} heights of hips, heads and hands differ by ${(100 * median).toFixed(1)} cm from the joints with ` +
      `locked feet (median; bodies here all have the usual size), p99 ${(100 * p99).toFixed(1)} cm`,
  );
}

/** The height of a joint, whose rest place follows from the skeleton. */
function height({ figures }, out, joint) {
  const { parents, offsets } = figures.skeleton;
  const rest = [0, 0, 0];
  for (let j = joint; j >= 0; j = parents[j]) for (let k = 0; k < 3; ++k) rest[k] += offsets[3 * j + k];
  const [x, y, z, w, , , tz] = out.subarray(8 * joint, 8 * joint + 7);
  const t = [2 * (y * rest[2] - z * rest[1]), 2 * (z * rest[0] - x * rest[2]), 2 * (x * rest[1] - y * rest[0])];
  return rest[2] + w * t[2] + x * t[1] - y * t[0] + tz;
}

/** Areas of all surfaces by their finish, beside those of the GLB. */
export async function ground(folder) {
  for (const name of ['market', 'cars']) {
    const { scene } = await loaded(folder, name);
    const areas = new Map();
    for (const mesh of [scene.still, ...scene.moving])
      for (let t = 0; t < mesh.finishes.length; t += 3)
        add(
          areas,
          kFinishes[mesh.finishes[t]],
          areaOf([0, 1, 2].map((k) => mesh.positions.subarray(3 * (t + k), 3 * (t + k) + 3))),
        );
    const real = areasOfGlb(readFileSync(join(folder, `${name}.glb`)));
    for (const [finish, area] of real) {
      const found = areas.get(finish) ?? 0;
      expect(Math.abs(found - area) <= 0.01 * area + 0.05, `${name}: ${finish}: ${found} m², expected ${area} m²`);
    }
    for (const finish of areas.keys()) expect(real.has(finish), `${name}: the GLB has ${finish}, too`);
    console.log(`measured: ${name}: areas of ${real.size} finishes are those of the GLB, within 1 %`);
  }
}

const kFinishes = 'ground,wall,roof,stone,trunk,crown,leaves,water,tile,coping,net floor,net,brick,floor,shade,glass,tyre,paint 1,paint 2,paint 3,paint 4,fur'.split(','); // prettier-ignore

function add(areas, name, area) {
  areas.set(name, (areas.get(name) ?? 0) + area);
}

function areaOf([a, b, c]) {
  const [u, v] = [b, c].map((p) => [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
  return 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

function areasOfGlb(bytes) {
  const length = bytes.readUInt32LE(12);
  const gltf = JSON.parse(bytes.subarray(20, 20 + length).toString());
  const data = bytes.subarray(28 + length);
  const start = (accessor) => (gltf.bufferViews[accessor.bufferView].byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const areas = new Map();
  for (const mesh of gltf.nodes
    .filter((node) => node.mesh !== undefined && node.skin === undefined)
    .map((node) => gltf.meshes[node.mesh]))
    for (const { attributes, indices, material } of mesh.primitives) {
      const points = gltf.accessors[attributes.POSITION];
      const index = gltf.accessors[indices];
      const wide = index.componentType === 5125 ? 4 : 2;
      const corner = (k) => {
        const at = start(index) + wide * k;
        const from = start(points) + 12 * (wide === 4 ? data.readUInt32LE(at) : data.readUInt16LE(at));
        return [0, 4, 8].map((by) => data.readFloatLE(from + by));
      };
      for (let t = 0; t < index.count; t += 3)
        add(areas, gltf.materials[material].name, areaOf([corner(t), corner(t + 1), corner(t + 2)]));
    }
  return areas;
}
