import { expect, it, vi } from 'vitest';
import { madeModel, madeObj } from '../../../tests/support/made_places.mjs';
import { importedFrom, usualSettings, type ImportSource } from '../../model/place_files/imports';
import { readObj } from '../../model/place_files/obj';
import { sceneryOf, shownBy } from '../../model/place_files/scenery';
import { readModel } from './model_file';

const fileOf = (bytes: Uint8Array<ArrayBuffer>, name: string): File => new File([bytes], name);

it('a GLB has the objects, places and colours of its nodes', async () => {
  const file = fileOf(madeModel({ shift: 5 }), 'yard.glb');
  const meshes = await readModel(file, [file]);
  expect(meshes.map(({ name, triangles }) => [name, triangles.length / 3])).toEqual([
    ['Hut', 24],
    ['Bench', 12],
    ['Floor', 12],
  ]);
  expect(Math.min(...meshes[1]!.positions.filter((_, i) => i % 3 === 0))).toBeCloseTo(7, 5);
  expect(meshes[0]!.colour[0]).toBeCloseTo(0.55, 5);
});

it('a GLB and an OBJ of the same yard come to the same obstacles', async () => {
  const file = fileOf(madeModel(), 'yard');
  const glb: ImportSource = { kind: 'model', file: 'yard', meshes: await readModel(file, [file]), up: 'y' };
  const text = new TextDecoder().decode(madeObj());
  const obj: ImportSource = { kind: 'model', file: 'yard', meshes: readObj(text, 'yard'), up: null };
  const [a, b] = [glb, obj].map((one) => importedFrom(one, usualSettings(one)));
  expect(a!.outlines.map(({ name }) => name)).toEqual(['yard: Hut', 'yard: Bench']);
  expect(a!.outlines).toEqual(b!.outlines);
});

it('a bad glTF gets one sentence that names what is missing', async () => {
  const broken = fileOf(madeModel().slice(0, 200), 'cut.glb');
  await expect(readModel(broken, [broken])).rejects.toThrow(/^“cut\.glb” cannot be read: .*\.$/);
  vi.spyOn(console, 'error').mockImplementation(() => undefined);
  const json = JSON.stringify({ asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [] }], nodes: [] });
  const empty = fileOf(new TextEncoder().encode(json), 'empty.gltf');
  await expect(readModel(empty, [empty])).rejects.toThrow('“empty.gltf” holds no surfaces.');
});

it('an obstacle is shown by its model as long as it is where it was', () => {
  const polygon = [
    [0, 0],
    [2, 0],
    [2, 1],
    [0, 1],
  ] as const;
  const isShown = shownBy([sceneryOf('x', [], { x: 0, y: 0 }, [{ name: 'x: Bench', polygon }])]);
  expect(isShown({ name: 'x: Bench', polygon })).toBe(true);
  expect(isShown({ name: 'Bench', polygon })).toBe(false);
  expect(isShown({ name: 'x: Bench', polygon: polygon.map(([x, y]) => [x + 1, y] as const) })).toBe(false);
});
