import { describe, expect, it } from 'vitest';
import { areaOf } from '../outline';
import { insidePolygon } from '../plane';
import { footprintsOf, groundOf } from './footprint';
import { likelyUp, standing, type ModelMesh } from './mesh';
import { readObj } from './obj';

const kBoxFaces = [
  0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
];

/** Boxes [x0, y0, z0, x1, y1, z1], turned by an angle about the origin. */
function boxes(list: readonly (readonly number[])[], turn = 0, name = 'box'): ModelMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  for (const b of list) {
    const first = positions.length / 3;
    for (let i = 0; i < 8; ++i) {
      const [x, y, z] = [b[i & 1 ? 3 : 0]!, b[i & 2 ? 4 : 1]!, b[i & 4 ? 5 : 2]!];
      positions.push(Math.cos(turn) * x - Math.sin(turn) * y, Math.sin(turn) * x + Math.cos(turn) * y, z);
    }
    triangles.push(...kBoxFaces.map((i) => first + i));
  }
  return { name, positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles), colour: [1, 1, 1] };
}

const kPlain = { scale: 1, ground: 0 };
const areas = (mesh: ModelMesh, options = kPlain): number[] =>
  footprintsOf([mesh], options).outlines.map(({ corners }) => areaOf(corners));

describe('footprints', () => {
  it.each([0, 0.3, 0.8])('of a box turned by %s are its four corners, as high as it is', (turn) => {
    const { outlines } = footprintsOf([boxes([[1, 2, 0, 5, 4, 7]], turn)], kPlain);
    expect(outlines).toHaveLength(1);
    expect(outlines[0]!.corners).toHaveLength(4);
    expect(areaOf(outlines[0]!.corners)).toBeCloseTo(8, 2);
    expect(outlines[0]!.height).toBeCloseTo(7, 5);
  });

  it.each([0, 0.4])('of an L turned by %s are an L', (turn) => {
    const { outlines } = footprintsOf(
      [
        boxes(
          [
            [0, 0, 0, 10, 4, 3],
            [0, 0, 0, 4, 9, 3],
          ],
          turn,
        ),
      ],
      kPlain,
    );
    expect(outlines).toHaveLength(1);
    expect(areaOf(outlines[0]!.corners) / 60).toBeCloseTo(1, 1);
    expect(outlines[0]!.corners.length).toBeLessThan(24);
    const inside = (x: number, y: number): boolean =>
      insidePolygon(
        { x: Math.cos(turn) * x - Math.sin(turn) * y, y: Math.sin(turn) * x + Math.cos(turn) * y },
        outlines[0]!.corners,
      );
    expect([inside(2, 8), inside(9, 2), inside(7, 7), inside(4.5, 4.5)]).toEqual([true, true, false, false]);
  });

  it('leave out what is ground and what people pass below', () => {
    expect(areas(boxes([[0, 0, 0, 9, 9, 0.05]]))).toEqual([]);
    const bridge = footprintsOf([boxes([[0, 0, 2.5, 9, 9, 3]])], kPlain);
    expect(bridge.outlines).toEqual([]);
    expect(bridge.left).toEqual({ above: 1 });
    // A table of two legs: the legs alone stand in the way of nobody who is shorter, but the top is low.
    expect(
      areas(
        boxes([
          [0, 0, 0.7, 2, 1, 0.75],
          [0, 0, 0, 0.1, 0.1, 0.7],
        ]),
      )[0],
    ).toBeCloseTo(2, 1);
  });

  it('of an arch are its two pillars, each as high as the arch', () => {
    const { outlines } = footprintsOf(
      [
        boxes([
          [0, 0, 0, 1, 1, 4],
          [5, 0, 0, 6, 1, 4],
          [0, 0, 4, 6, 1, 5],
        ]),
      ],
      kPlain,
    );
    expect(outlines.map(({ corners }) => areaOf(corners).toFixed(1))).toEqual(['1.0', '1.0']);
    expect(outlines.every(({ height }) => height > 3.9)).toBe(true);
  });

  it('of a closed house are filled; a yard under the sky stays open', () => {
    const walls = [
      [0, 0, 0, 10, 0.3, 3],
      [0, 9.7, 0, 10, 10, 3],
      [0, 0, 0, 0.3, 10, 3],
      [9.7, 0, 0, 10, 10, 3],
    ];
    const yard = footprintsOf([boxes(walls)], kPlain).outlines;
    const open = yard.reduce((sum, { corners }) => sum + areaOf(corners), 0);
    expect(open).toBeGreaterThan(8);
    expect(open).toBeLessThan(16);
    expect(yard.some(({ corners }) => insidePolygon({ x: 5, y: 5 }, corners))).toBe(false);
    expect(areas(boxes([...walls, [0, 0, 3, 10, 10, 3.2]]))[0]).toBeCloseTo(100, 0);
  });

  it('come in metres where the model is in centimetres', () => {
    expect(areas(boxes([[100, 200, 0, 500, 400, 700]]), { scale: 0.01, ground: 0 })[0]).toBeCloseTo(8, 2);
  });

  it('of thin posts are as thin', () => {
    const { outlines } = footprintsOf(
      [
        boxes([
          [0, 0, 0, 0.1, 0.1, 1],
          [3, 0, 0, 3.1, 0.1, 1],
        ]),
      ],
      kPlain,
    );
    expect(outlines).toHaveLength(2);
    for (const { corners } of outlines) expect(areaOf(corners)).toBeCloseTo(0.01, 3);
  });

  it('stand on the broadest floor', () => {
    expect(groundOf([boxes([[-20, -20, -0.5, 20, 20, 0]]), boxes([[0, 0, 0, 2, 2, 5]])])).toBeCloseTo(0, 5);
    expect(groundOf([boxes([[0, 0, 1, 2, 2, 5]])])).toBeCloseTo(1, 5);
  });

  it('of a hundred thousand triangles take no minute', () => {
    const many = Array.from({ length: 9000 }, (_, i) => [
      i % 100,
      Math.floor(i / 100),
      0,
      (i % 100) + 0.5,
      Math.floor(i / 100) + 0.5,
      1,
    ]);
    const start = performance.now();
    expect(footprintsOf([boxes(many)], kPlain).outlines).toHaveLength(9000);
    expect(performance.now() - start).toBeLessThan(8000);
  });
});

describe('OBJ', () => {
  const kText = [
    '# a box on y up',
    'mtllib x.mtl',
    'o Shed',
    'v 0 0 0',
    'v 4 0 0',
    'v 4 0 -2',
    'v 0 0 -2',
    'v 0 3 0',
    'v 4 3 0',
    'v 4 3 -2',
    'v 0 3 -2',
    'f 1/1/1 2/2/1 3/3/1 4/4/1',
    'f -4 -3 -2 -1',
    'f 1 2 6 5',
    'f 2 3 7 6',
    'f 3 4 8 \\',
    '7',
    'f 4 1 5 8',
    'g Nothing',
  ].join('\n');

  it('is read with objects, polygons, negative numbers and continued lines', () => {
    const meshes = readObj(kText, 'shed.obj');
    expect(meshes.map(({ name, triangles }) => [name, triangles.length / 3])).toEqual([['Shed', 12]]);
    expect(likelyUp(meshes)).toBe('z');
    const { outlines } = footprintsOf(
      meshes.map((mesh) => standing(mesh, 'y')),
      kPlain,
    );
    expect(areaOf(outlines[0]!.corners)).toBeCloseTo(8, 2);
    expect(outlines[0]).toMatchObject({ name: 'Shed', height: 3 });
    expect(Math.max(...outlines[0]!.corners.map(({ y }) => y))).toBeCloseTo(2, 5);
  });

  it.each([
    ['v 1 2\nf 1 1 1', '“x.obj” is broken in line 1: a corner has three numbers.'],
    ['v 1 2 3\n\nf 1 2 3', '“x.obj” is broken in line 3: it has no corner 2.'],
    ['v 1 2 3', '“x.obj” holds no faces.'],
  ])('that is bad gets one sentence: %j', (text, sentence) => {
    expect(() => readObj(text, 'x.obj')).toThrow(sentence);
  });
});
