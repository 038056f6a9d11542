import { SkinnedMesh } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { describe, expect, it } from 'vitest';
import { madeCharacter } from '../../../../tests/support/made_glb.mjs';
import { trianglesOf } from './body';
import { readBody } from './gltf_body';
import { jointIndex } from '../../../model/skeleton';

function bytesOf(options: Parameters<typeof madeCharacter>[0] = {}): ArrayBuffer {
  return new Uint8Array(madeCharacter(options)).buffer;
}

describe('bodies of the server', () => {
  it('are read onto our axes and joints', () => {
    const body = readBody('body-9', bytesOf(), bytesOf());
    expect(trianglesOf(body.near)).toBe(21 * 12);
    const { geometry } = body.near[0]!;
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox!;
    // Height along z, arms along y, toes along x.
    expect(max.z).toBeGreaterThan(1.5);
    expect(max.y - min.y).toBeGreaterThan(1);
    expect(max.x).toBeGreaterThan(-min.x);
    const foot = 3 * jointIndex('RightFoot');
    expect(Array.from(body.rig.bind.slice(foot, foot + 3)).map((one) => Math.round(100 * one) / 100)).toEqual([
      0, -0.09, 0.08,
    ]);
    const joints = geometry.attributes['joints']!;
    expect(joints.getX(8 * jointIndex('Head'))).toBe(jointIndex('Head'));
  });

  it('are refused with other joints', () => {
    const strange = bytesOf({ rename: (name) => (name === 'Head' ? 'Skull' : name) });
    expect(() => readBody('x', strange, bytesOf())).toThrow('it has a joint called Skull');
    const few = bytesOf({ rename: (name) => (name === 'LeftToeBase' ? null : name) });
    expect(() => readBody('x', few, bytesOf())).toThrow('it has 20 of 21 joints');
  });

  it('are read as three.js reads them', async () => {
    const bytes = bytesOf();
    const ours = readBody('x', bytes, bytes).near[0]!.geometry;
    const { scene } = await new GLTFLoader().parseAsync(bytes, '');
    let theirs: SkinnedMesh | undefined;
    scene.traverse((node) => (theirs ??= node instanceof SkinnedMesh ? node : undefined));
    const source = theirs!.geometry;
    expect(Array.from(ours.index!.array)).toEqual(Array.from(source.index!.array));
    const pairs = [
      ['position', 'position', [2, 0, 1]],
      ['normal', 'normal', [2, 0, 1]],
      ['weights', 'skinWeight', [0, 1, 2, 3]],
    ] as const;
    for (const [own, other, columns] of pairs)
      for (let i = 0; i < source.attributes[other]!.count; ++i)
        columns.forEach((column, k) =>
          expect(ours.attributes[own]!.getComponent(i, k)).toBe(source.attributes[other]!.getComponent(i, column)),
        );
  });

  it('are refused when cut off, or of another kind', () => {
    const whole = bytesOf();
    for (const size of [0, 10, 40, 3000, whole.byteLength - 9])
      expect(() => readBody('x', whole.slice(0, size), whole)).toThrow(/it is (no GLB file|cut off)/);
    expect(() => readBody('x', new ArrayBuffer(200), whole)).toThrow('it is no GLB file');
  });
});
