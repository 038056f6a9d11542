import { InstancedBufferGeometry, Mesh, type InterleavedBufferAttribute, Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { standingClip, type ClipPoses } from '../people/clip_bank';
import { makePlainBody } from '../people/plain_body';
import { kPoseNumbers } from '../people/rig';
import { CameraController } from './camera_controller';
import { CrowdLayer } from './crowd_layer';
import { CrowdState } from './crowd_state';
import type { FrameView } from './frame_types';
import { paletteOf } from './palette';
import type { Quality } from './quality';
import { madeFrame } from './test_frames';

const kClips: ClipPoses[] = ['idle', 'run', 'crawl'].map((name) => {
  const stand = standingClip();
  return { ...stand, name, motion: name, rate: 10, poses: 4, hips: [0, 1, 2, 3].flatMap(() => [0, 0, 0.95]), rotations: [0, 1, 2, 3].flatMap(() => Array.from(stand.rotations)) };
});

function camera(distance = 40): CameraController {
  const made = new CameraController();
  made.resize(1280, 800);
  made.setPose({ targetX: 0, targetY: 0, distance, turn: 0, pitch: 0.8 });
  return made;
}

/** A layer that drew people at these x, and the meshes that have instances. */
function drawn(quality: Quality, xs: readonly number[], more: Partial<FrameView> = {}, distance = 40) {
  const layer = new CrowdLayer(quality);
  layer.setBodies(['one', 'two'].map((name) => ({ ...makePlainBody(), name })));
  layer.setMotions(kClips);
  layer.setColours([0, 1], paletteOf('light'), 2);
  const state = new CrowdState();
  state.setClips(layer.bank);
  state.setMembers(xs.map((_, i) => i + 1), xs.map((_, i) => i % 2));
  const frame = madeFrame(1, xs, more);
  const blend = { from: frame, to: frame, alpha: 0 };
  state.update(blend);
  layer.update(state, blend, camera(distance));
  return { layer, state, blend };
}

/** Sixteen numbers per character, by x. */
function instances(layer: CrowdLayer): Map<number, number[]> {
  const found = new Map<number, number[]>();
  layer.group.traverse((node) => {
    if (!(node instanceof Mesh) || !(node.geometry instanceof InstancedBufferGeometry) || !node.geometry.attributes['aNow']) return;
    const geometry = node.geometry;
    for (let i = 0; i < geometry.instanceCount; ++i) {
      const numbers = ['aPlace', 'aNow', 'aBefore', 'aLook'].flatMap((name) => {
        const attribute = geometry.attributes[name] as InterleavedBufferAttribute;
        return [attribute.getX(i), attribute.getY(i), attribute.getZ(i), attribute.getW(i)];
      });
      found.set(Math.round(numbers[0]!), numbers);
    }
  });
  return found;
}

describe('CrowdLayer', () => {
  it('gives back the pictures of a visitor’s body that goes', () => {
    const layer = new CrowdLayer('full');
    const gone: string[] = [];
    const dressed = (name: string) => {
      const map = new Texture();
      map.addEventListener('dispose', () => gone.push(name));
      return { ...makePlainBody(), near: makePlainBody().near.map((part) => ({ ...part, map })), name };
    };
    const first = dressed('first');
    layer.setOwn(first);
    layer.setOwn(first);
    expect(gone).toEqual([]);
    layer.setOwn(dressed('second'));
    expect(new Set(gone)).toEqual(new Set(['first']));
    layer.setOwn(null);
    expect(new Set(gone)).toEqual(new Set(['first', 'second']));
    layer.setOwn(dressed('third'));
    layer.dispose();
    expect(new Set(gone).has('third')).toBe(true);
  });

  it('draws everybody once, by body and level', () => {
    const near = drawn('full', [-3, -1, 1, 3]).layer.drawn;
    expect(near.map((one) => one.near).reduce((a, b) => a + b)).toBe(4);
    expect(near.map((one) => one.body)).toEqual(['one', 'two']);
    const far = drawn('full', [-3, -1, 1, 3], {}, 300).layer.drawn;
    expect(far.map((one) => one.far).reduce((a, b) => a + b)).toBe(4);
    const light = drawn('light', [-3, -1, 1, 3]).layer.drawn;
    expect(light.map((one) => [one.near, one.far]).flat().reduce((a, b) => a + b)).toBe(4);
    expect(light.every((one) => one.near === 0)).toBe(true);
  });

  it('tells the clip, the one that fades, and who is never greyed', () => {
    const people = instances(drawn('full', [-3, 3], { clip: [1, 2], clipTime: [150, 0], fromClip: [0, 1], fromTime: [50, 100], fade: [0, 51] }).layer);
    const [left, right] = [people.get(-3)!, people.get(3)!];
    // Poses of clips follow each other in the bank.
    expect(left.slice(4, 6)).toEqual([5, 6]);
    expect(left[6]).toBeCloseTo(0.5);
    expect(left[7]).toBe(0);
    expect(right.slice(4, 6)).toEqual([8, 9]);
    expect(right[7]).toBeCloseTo(0.2);
    expect(right.slice(8, 10)).toEqual([5, 6]);
    expect([left[11], right[11]]).toEqual([-1, -1]);
    expect([left[15]! < 25, right[15]! >= 100]).toEqual([true, true]);
    expect(left.slice(12, 15)).not.toEqual(right.slice(12, 15));
  });

  it('shows whole poses of those who have them, but for clips of a visitor’s own', () => {
    const whole = new Array<number>(kPoseNumbers).fill(0);
    for (let j = 0; j < 21; ++j) whole[3 + 4 * j + 3] = 32767;
    const { layer, state, blend } = drawn('full', [-3, 3], { clip: [1, 1], near: [1], nearPoses: whole });
    expect([instances(layer).get(-3)![11], instances(layer).get(3)![11]]).toEqual([-1, 0]);
    layer.setOwn({ ...makePlainBody(), name: 'own' }, [{ ...kClips[1]!, poses: 4 }]);
    layer.update(state, blend, camera());
    expect(layer.drawn).toEqual([{ body: 'own', near: 2, far: 0 }]);
    expect(instances(layer).get(3)![11]).toBe(-1);
    layer.setOwn(null);
    layer.update(state, blend, camera());
    expect(layer.drawn.map((one) => one.body)).toEqual(['one', 'two']);
    expect(instances(layer).get(3)![11]).toBe(0);
    const light = drawn('light', [-3, 3], { clip: [1, 1], near: [1], nearPoses: whole });
    expect(instances(light.layer).get(3)![11]).toBe(-1);
  });
});
