import { describe, expect, it } from 'vitest';
import { madeCharacter } from '../../../../tests/support/made_glb.mjs';
import { trianglesOf } from './body';
import { readBody } from './gltf_body';
import { jointIndex } from '../../../model/skeleton';

function bytesOf(options: Parameters<typeof madeCharacter>[0] = {}): ArrayBuffer {
  return new Uint8Array(madeCharacter(options)).buffer;
}

describe('bodies of the server', () => {
  it('are read onto our axes and joints', async () => {
    const body = await readBody('body-9', bytesOf(), bytesOf());
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

  it('are refused with other joints', async () => {
    const strange = bytesOf({ rename: (name) => (name === 'Head' ? 'Skull' : name) });
    await expect(readBody('x', strange, bytesOf())).rejects.toThrow('it has a joint called Skull');
    const few = bytesOf({ rename: (name) => (name === 'LeftToeBase' ? null : name) });
    await expect(readBody('x', few, bytesOf())).rejects.toThrow('it has 20 of 21 joints');
  });
});
