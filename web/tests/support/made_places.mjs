// Small files that become places, made by hand.

/** The corners of the sides of a box. */
export const kFaces = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
];

/** The eight corners of a box: wide, high and deep, standing at x, z with y up. */
function corners([x, z, wide, high, deep]) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [x + (i & 1 ? wide : 0), i & 2 ? high : 0, z + (i & 4 ? deep : 0)]);
}

/** Things of a yard by name, as boxes. */
export const kYard = {
  Hut: [
    [-6, -5, 4, 3, 3],
    [-6, -2, 2, 3, 3],
  ],
  Bench: [[2, 0, 2, 0.5, 0.6]],
  Floor: [[-10, -8, 20, 0.05, 16]],
};

/** A Wavefront OBJ with y up. */
export function madeObj(objects = kYard) {
  const lines = ['# A yard'];
  let count = 0;
  for (const [name, boxes] of Object.entries(objects)) {
    lines.push(`o ${name}`);
    for (const box of boxes) {
      for (const corner of corners(box)) lines.push(`v ${corner.join(' ')}`);
      for (const face of kFaces) lines.push(`f ${face.map((i) => i + 1 + count).join(' ')}`);
      count += 8;
    }
  }
  return Buffer.from(`${lines.join('\n')}\n`);
}

function padded(bytes, filler) {
  return Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
}

/** A GLB without skins: a node for each object, with a colour of its own; `shift` moves their nodes along x. */
export function madeModel({ objects = kYard, shift = 0 } = {}) {
  const chunks = [];
  const [bufferViews, accessors, meshes, nodes, materials] = [[], [], [], [], []];
  let size = 0;
  const add = (array, type, componentType, extra = {}) => {
    const bytes = padded(Buffer.from(array.buffer), 0);
    bufferViews.push({ buffer: 0, byteOffset: size, byteLength: array.byteLength });
    chunks.push(bytes);
    size += bytes.length;
    const count = array.length / { SCALAR: 1, VEC3: 3 }[type];
    accessors.push({ bufferView: bufferViews.length - 1, componentType, count, type, ...extra });
    return accessors.length - 1;
  };
  const colours = [
    [0.55, 0.2, 0.12, 1],
    [0.2, 0.35, 0.2, 1],
    [0.6, 0.58, 0.52, 1],
  ];
  for (const [name, boxes] of Object.entries(objects)) {
    const points = boxes.flatMap(corners);
    const indices = boxes.flatMap((_, k) => kFaces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d].map((i) => i + 8 * k)));
    const axis = (k) => points.map((point) => point[k]);
    const position = add(Float32Array.from(points.flat()), 'VEC3', 5126, {
      min: [0, 1, 2].map((k) => Math.min(...axis(k))),
      max: [0, 1, 2].map((k) => Math.max(...axis(k))),
    });
    const index = add(Uint16Array.from(indices), 'SCALAR', 5123);
    materials.push({ pbrMetallicRoughness: { baseColorFactor: colours[materials.length % 3] }, doubleSided: true });
    meshes.push({
      primitives: [{ attributes: { POSITION: position }, indices: index, material: materials.length - 1 }],
    });
    nodes.push({ name, mesh: meshes.length - 1, translation: [shift, 0, 0] });
  }
  const json = padded(
    Buffer.from(
      JSON.stringify({
        asset: { version: '2.0' },
        scene: 0,
        scenes: [{ nodes: nodes.map((_, i) => i) }],
        nodes,
        meshes,
        materials,
        accessors,
        bufferViews,
        buffers: [{ byteLength: size }],
      }),
    ),
    0x20,
  );
  const binary = Buffer.concat(chunks);
  const head = Buffer.alloc(20);
  head.write('glTF', 0);
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(28 + json.length + binary.length, 8);
  head.writeUInt32LE(json.length, 12);
  head.write('JSON', 16);
  const between = Buffer.alloc(8);
  between.writeUInt32LE(binary.length, 0);
  between.write('BIN\0', 4);
  return Buffer.concat([head, json, between, binary]);
}

/** A quarter with a courtyard, a tower, a wall and a road; `bad` outlines cross themselves. */
export function madeTown({ bad = 1 } = {}) {
  const [east, north] = [1 / 67900, 1 / 111270];
  const at = ([x, y]) => [13.4 + x * east, 52.5 + y * north];
  const ring = (...points) => [...points, points[0]].map(at);
  const box = (x, y, wide, high) => ring([x, y], [x + wide, y], [x + wide, y + high], [x, y + high]);
  const feature = (type, coordinates, properties) => ({ type: 'Feature', properties, geometry: { type, coordinates } });
  const features = [
    feature('Polygon', [box(0, 0, 40, 30), box(8, 8, 24, 14).reverse()], { building: 'yes', 'building:levels': '5' }),
    feature('Polygon', [box(55, 0, 12, 12)], { building: 'yes', height: '40 m', name: 'Tower' }),
    feature('Polygon', [ring([50, 20], [70, 20], [70, 44], [62, 44], [62, 28], [50, 28])], { building: 'house' }),
    feature(
      'LineString',
      [
        [-10, 40],
        [30, 40],
        [30, 48],
      ].map(at),
      { barrier: 'wall', height: '2.2' },
    ),
    feature(
      'LineString',
      [
        [-10, -10],
        [80, -10],
      ].map(at),
      { highway: 'residential' },
    ),
    ...Array.from({ length: bad }, (_, i) =>
      feature('Polygon', [ring([80, 10 * i], [90, 10 * i + 8], [90, 10 * i], [80, 10 * i + 8])], { building: 'yes' }),
    ),
  ];
  return Buffer.from(JSON.stringify({ type: 'FeatureCollection', features }));
}

/** A MovingAI map of 24 by 16 cells with two rooms. */
export function madeMap() {
  const rows = Array.from({ length: 16 }, (_, y) =>
    Array.from({ length: 24 }, (_, x) => {
      if (x === 0 || y === 0 || x === 23 || y === 15) return '@';
      return x === 12 && (y < 6 || y > 8) ? 'T' : '.';
    }).join(''),
  );
  return Buffer.from(`type octile\nheight 16\nwidth 24\nmap\n${rows.join('\n')}\n`);
}
