// A small character as a GLB: one box per bone, a skeleton under names of one's choice, and an animation if wanted.

import { kFaces } from './made_places.mjs';

/** Name of ours, parent, place in metres (x to the left, y up, z forward), as glTF has them. */
const kJoints = [
  ['Hips', -1, 0, 0.95, 0],
  ['Spine', 0, 0, 1.05, 0],
  ['Chest', 1, 0, 1.22, 0],
  ['Neck', 2, 0, 1.47, 0],
  ['Head', 3, 0, 1.56, 0],
  ...['Left', 'Right'].flatMap((side, i) => {
    const s = i === 0 ? 1 : -1;
    const first = 5 + 4 * i;
    return [
      [`${side}Shoulder`, 2, 0.03 * s, 1.41, 0],
      [`${side}Arm`, first, 0.18 * s, 1.41, 0],
      [`${side}ForeArm`, first + 1, 0.38 * s, 1.21, 0],
      [`${side}Hand`, first + 2, 0.56 * s, 1.03, 0],
    ];
  }),
  ...['Left', 'Right'].flatMap((side, i) => {
    const s = i === 0 ? 1 : -1;
    const first = 13 + 4 * i;
    return [
      [`${side}UpLeg`, 0, 0.09 * s, 0.91, 0],
      [`${side}Leg`, first, 0.09 * s, 0.49, 0],
      [`${side}Foot`, first + 1, 0.09 * s, 0.08, 0],
      [`${side}ToeBase`, first + 2, 0.09 * s, 0.03, 0.13],
    ];
  }),
];

const kCorners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);

/** Boxes in the middle between joint and child; numbers in `unit`s. */
function boxes(joints, unit) {
  const [positions, normals, jointsOf, weights, indices] = [[], [], [], [], []];
  joints.forEach(([, , x, y, z], j) => {
    const child = joints.find(([, parent]) => parent === j);
    const to = child ? child.slice(2) : [x, y, z];
    const middle = [x, y, z].map((one, k) => (one + to[k]) / 2);
    const half = [x, y, z].map((one, k) => Math.max(0.03, Math.abs(to[k] - one) / 2));
    const first = positions.length / 3;
    for (const corner of kCorners) {
      positions.push(...corner.map((sign, k) => (middle[k] + sign * half[k]) * unit));
      normals.push(...corner.map((sign) => sign / Math.sqrt(3)));
      jointsOf.push(j, 0, 0, 0);
      weights.push(1, 0, 0, 0);
    }
    for (const [a, b, c, d] of kFaces) indices.push(...[a, b, c, a, c, d].map((i) => first + i));
  });
  return { positions, normals, jointsOf, weights, indices };
}

class Bytes {
  chunks = [];
  size = 0;
  views = [];
  accessors = [];

  /** Returns the view's index. */
  view(array) {
    const padded = Buffer.alloc(Math.ceil(array.byteLength / 4) * 4);
    Buffer.from(array.buffer).copy(padded);
    this.views.push({ buffer: 0, byteOffset: this.size, byteLength: array.byteLength });
    this.chunks.push(padded);
    this.size += padded.length;
    return this.views.length - 1;
  }

  /** Returns the accessor's index. */
  add(array, type, componentType, extra = {}) {
    const width = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
    this.accessors.push({ bufferView: this.view(array), componentType, count: array.length / width, type, ...extra });
    return this.accessors.length - 1;
  }
}

function bounds(positions) {
  const part = (k) => positions.filter((_, i) => i % 3 === k);
  return { min: [0, 1, 2].map((k) => Math.min(...part(k))), max: [0, 1, 2].map((k) => Math.max(...part(k))) };
}

function inverseBinds(joints, unit) {
  return joints.flatMap(([, , x, y, z]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x * unit, -y * unit, -z * unit, 1]);
}

/** A turn of the hips about the vertical and back, walking forward 2 m. */
function animation(bytes, name, unit) {
  const input = bytes.add(Float32Array.of(0, 0.5, 1), 'SCALAR', 5126, { min: [0], max: [1] });
  const s = Math.sin(0.25);
  const c = Math.cos(0.25);
  const turns = bytes.add(Float32Array.of(0, 0, 0, 1, 0, s, 0, c, 0, 0, 0, 1), 'VEC4', 5126);
  const ways = bytes.add(
    Float32Array.of(0, 0.95, 0, 0, 0.85, 1, 0, 0.95, 2).map((one) => one * unit),
    'VEC3',
    5126,
  );
  return {
    name,
    samplers: [
      { input, output: turns },
      { input, output: ways },
    ],
    channels: [
      { sampler: 0, target: { node: 0, path: 'rotation' } },
      { sampler: 1, target: { node: 0, path: 'translation' } },
    ],
  };
}

/** One opaque pixel. */
const kPicture = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==',
  'base64',
);

/** A material, with a picture where wanted: what goes into the file for it. */
function paint(bytes, picture) {
  const pbrMetallicRoughness = {
    baseColorFactor: [0.8, 0.1, 0.6, 1],
    ...(picture ? { baseColorTexture: { index: 0 } } : {}),
  };
  if (!picture) return { materials: [{ pbrMetallicRoughness }] };
  const bufferView = bytes.view(Uint8Array.from(kPicture));
  return {
    materials: [{ pbrMetallicRoughness }],
    textures: [{ source: 0 }],
    images: [{ bufferView, mimeType: 'image/png' }],
  };
}

function container(json, binary) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 32)]);
  const head = Buffer.alloc(12);
  const chunk = (type, data) => {
    const front = Buffer.alloc(8);
    front.writeUInt32LE(data.length, 0);
    front.writeUInt32LE(type, 4);
    return Buffer.concat([front, data]);
  };
  const body = Buffer.concat([chunk(0x4e4f534a, padded), chunk(0x004e4942, binary)]);
  head.writeUInt32LE(0x46546c67, 0);
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + body.length, 8);
  return Buffer.concat([head, body]);
}

/**
 * `rename`: names of joints from ours; null leaves a joint out, with all below it. `unit`: numbers per metre.
 * `clip`: an animation's name. `picture`: the skin has a texture. The figure stands with arms held down at 45 degrees.
 */
export function madeCharacter({ rename = (name) => name, unit = 1, clip = '', picture = false } = {}) {
  const kept = [];
  kJoints.forEach(([name, parent, ...at], j) => {
    const above = parent < 0 ? -1 : kept.findIndex((one) => one.from === parent);
    const named = rename(name);
    if (named !== null && (parent < 0 || above >= 0)) kept.push({ from: j, joint: [named, above, ...at] });
  });
  const joints = kept.map((one) => one.joint);
  const bytes = new Bytes();
  const skin = boxes(joints, unit);
  const attributes = {
    POSITION: bytes.add(Float32Array.from(skin.positions), 'VEC3', 5126, bounds(skin.positions)),
    NORMAL: bytes.add(Float32Array.from(skin.normals), 'VEC3', 5126),
    JOINTS_0: bytes.add(Uint8Array.from(skin.jointsOf), 'VEC4', 5121),
    WEIGHTS_0: bytes.add(Float32Array.from(skin.weights), 'VEC4', 5126),
  };
  if (picture) attributes.TEXCOORD_0 = bytes.add(new Float32Array((2 * skin.positions.length) / 3), 'VEC2', 5126);
  const indices = bytes.add(Uint16Array.from(skin.indices), 'SCALAR', 5123);
  const inverse = bytes.add(Float32Array.from(inverseBinds(joints, unit)), 'MAT4', 5126);
  const animations = clip ? [animation(bytes, clip, unit)] : [];
  const nodes = joints.map(([name, parent, ...at], j) => {
    const from = parent < 0 ? [0, 0, 0] : joints[parent].slice(2);
    const children = joints.flatMap(([, above], k) => (above === j ? [k] : []));
    return {
      name,
      translation: at.map((one, k) => (one - from[k]) * unit),
      ...(children.length > 0 ? { children } : {}),
    };
  });
  nodes.push({ name: 'Skin', mesh: 0, skin: 0 });
  return container(
    {
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: [0, nodes.length - 1] }],
      nodes,
      meshes: [{ primitives: [{ attributes, indices, material: 0 }] }],
      ...paint(bytes, picture),
      skins: [{ joints: joints.map((_, j) => j), inverseBindMatrices: inverse }],
      animations,
      buffers: [{ byteLength: bytes.size }],
      bufferViews: bytes.views,
      accessors: bytes.accessors,
    },
    Buffer.concat(bytes.chunks),
  );
}
