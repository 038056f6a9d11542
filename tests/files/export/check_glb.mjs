// Checks a GLB with the Khronos validator, and joints in it against a list by `muster export --format joints`.
// Usage: node check_glb.mjs FOLDER_OF_NODE_MODULES FILE.glb JOINTS.json
// Prints "ok ..." or "FAILED ..." lines; exits 1 where anything failed.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const kLimit = 0.001; // Largest difference between joints [m].

const [modules, path, jointsPath] = process.argv.slice(2);
const bytes = readFileSync(path);
let failed = false;

function tell(good, what) {
  console.log(`${good ? 'ok' : 'FAILED'} ${what}`);
  failed ||= !good;
}

async function validate() {
  const validator = createRequire(`${modules}/`)('gltf-validator');
  const report = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 20 });
  const { numErrors, numWarnings, messages } = report.issues;
  tell(numErrors === 0 && numWarnings === 0, `validator: ${numErrors} errors, ${numWarnings} warnings`);
  for (const message of messages) console.log(`  ${message.code} ${message.pointer ?? ''}: ${message.message}`);
}

const text = bytes.readUInt32LE(12);
const gltf = JSON.parse(bytes.toString('utf8', 20, 20 + text));
const buffer = bytes.subarray(28 + text);

/** Reads value k of an accessor. */
function value(index, k) {
  const accessor = gltf.accessors[index];
  const parts = { SCALAR: 1, VEC3: 3, VEC4: 4 }[accessor.type];
  const short = accessor.componentType === 5122;
  const at = gltf.bufferViews[accessor.bufferView].byteOffset + (accessor.byteOffset ?? 0) + k * parts * (short ? 2 : 4);
  return Array.from({ length: parts }, (_, p) =>
    short ? Math.max(-1, buffer.readInt16LE(at + 2 * p) / 32767) : buffer.readFloatLE(at + 4 * p));
}

/** Matrix of a node's own placement at a key: rows of 4. */
function local(node, tracks, key) {
  const read = (what, usual) => {
    const track = tracks.get(`${node}:${what}`);
    return track === undefined ? gltf.nodes[node][what] ?? usual : value(track, key);
  };
  const [x, y, z, w] = read('rotation', [0, 0, 0, 1]);
  const [tx, ty, tz] = read('translation', [0, 0, 0]);
  const [s] = gltf.nodes[node].scale ?? [1];
  const n = 2 / (x * x + y * y + z * z + w * w);
  return [
    [s * (1 - n * (y * y + z * z)), s * n * (x * y - z * w), s * n * (x * z + y * w), tx],
    [s * n * (x * y + z * w), s * (1 - n * (x * x + z * z)), s * n * (y * z - x * w), ty],
    [s * n * (x * z - y * w), s * n * (y * z + x * w), s * (1 - n * (x * x + y * y)), tz],
  ];
}

function times(a, b) {
  return a.map((row) => [0, 1, 2, 3].map((c) => row[0] * b[0][c] + row[1] * b[1][c] + row[2] * b[2][c] + (c === 3 ? row[3] : 0)));
}

function compare() {
  const listed = JSON.parse(readFileSync(jointsPath, 'utf8'));
  const { channels, samplers } = gltf.animations[0];
  const tracks = new Map(channels.filter((one) => one.target.path !== 'scale')
    .map((one) => [`${one.target.node}:${one.target.path}`, samplers[one.sampler].output]));
  const input = samplers[0].input;
  const rate = gltf.accessors[input].count > 1 ? 1 / value(input, 1)[0] : 1;
  const roots = new Map(gltf.nodes.map((node, i) => [node.name, i]));
  let worst = 0, compared = 0;
  for (const frame of listed.frames) {
    const key = Math.round(frame.time * rate);
    for (const { id, positions } of frame.characters) {
      const walk = (node, above) => {
        const placed = times(above, local(node, tracks, key));
        const joint = listed.joints.indexOf(gltf.nodes[node].name);
        if (joint >= 0) {
          // The file's (X, Y, Z) is our (y, z, x).
          const [px, py, pz] = positions.slice(3 * joint, 3 * joint + 3);
          worst = Math.max(worst, Math.hypot(placed[0][3] - py, placed[1][3] - pz, placed[2][3] - px));
          compared += 1;
        }
        for (const child of gltf.nodes[node].children ?? []) walk(child, placed);
      };
      walk(roots.get(`character-${String(id).padStart(4, '0')}`), [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]);
    }
  }
  const wanted = listed.frames.reduce((sum, frame) => sum + frame.characters.length * listed.joints.length, 0);
  tell(compared === wanted && compared > 0 && worst < kLimit,
    `${compared} joints differ by at most ${(1000 * worst).toFixed(3)} mm`);
}

await validate();
compare();
process.exit(failed ? 1 : 0);
