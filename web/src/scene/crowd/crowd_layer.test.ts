import { type InstancedBufferGeometry, Mesh, type InstancedBufferAttribute, Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { standingClip, type ClipPoses } from './clips/clip_bank';
import { makePlainBody } from './bodies/plain_body';
import { kPoseNumbers } from './bodies/rig';
import { CameraController } from '../camera/camera_controller';
import { CrowdLayer } from './crowd_layer';
import { CrowdState } from './crowd_state';
import type { FrameView } from '../../model/frame_view';
import { kWhoBits } from '../drawing/instance_list';
import { paletteOf } from '../drawing/palette';
import type { Quality } from '../drawing/quality';
import { madeFrame, type Played } from '../../model/test_frames';

const kClips: ClipPoses[] = ['idle', 'run', 'crawl'].map((name) => {
  const stand = standingClip();
  return {
    ...stand,
    name,
    motion: name,
    rate: 10,
    poses: 4,
    hips: [0, 1, 2, 3].flatMap(() => [0, 0, 0.95]),
    rotations: [0, 1, 2, 3].flatMap(() => Array.from(stand.rotations)),
  };
});

function camera(distance = 40): CameraController {
  const made = new CameraController();
  made.resize(1280, 800);
  made.setPose({ targetX: 0, targetY: 0, distance, turn: 0, pitch: 0.8 });
  return made;
}

/** A layer that drew people at these x, and the meshes that have instances. */
function drawn(quality: Quality, xs: readonly number[], more: Partial<FrameView> & Played = {}, distance = 40) {
  const layer = new CrowdLayer(quality);
  layer.setBodies(['one', 'two'].map((name) => ({ ...makePlainBody(), name })));
  layer.setMotions(kClips);
  layer.setColours([0, 1], paletteOf('light'), 2);
  const state = new CrowdState();
  state.setMembers(
    xs.map((_, i) => i + 1),
    xs.map((_, i) => i % 2),
  );
  const frame = madeFrame(1, xs, more);
  const blend = { from: frame, to: frame, alpha: 0 };
  state.update(blend);
  layer.update(state, blend, camera(distance));
  return { layer, state, blend };
}

/** Rows of whole poses, by number in the crowd. */
function slots(layer: CrowdLayer): Map<number, number> {
  const found = new Map<number, number>();
  layer.group.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const geometry = node.geometry as InstancedBufferGeometry;
    const who = geometry.attributes['aWho'] as InstancedBufferAttribute | undefined;
    if (!who || !geometry.attributes['joints']) return;
    for (let i = 0; i < geometry.instanceCount; ++i)
      found.set(who.getX(i) % 2 ** kWhoBits, (who.getX(i) >>> kWhoBits) - 1);
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
    expect(
      light
        .map((one) => [one.near, one.far])
        .flat()
        .reduce((a, b) => a + b),
    ).toBe(4);
    expect(light.every((one) => one.near === 0)).toBe(true);
  });

  it('draws tiny bodies where a person is a few px tall', () => {
    const tiny = drawn('full', [-3, -1, 1, 3], {}, 900).layer.drawn;
    expect(
      tiny
        .map((one) => [one.near, one.far, one.tiny])
        .flat()
        .reduce((a, b) => a + b),
    ).toBe(4);
    expect(tiny.map((one) => one.tiny).reduce((a, b) => a + b)).toBe(4);
  });

  it('shows whole poses of those who have them, but for clips of a visitor’s own', () => {
    const whole = new Array<number>(kPoseNumbers).fill(0);
    for (let j = 0; j < 21; ++j) whole[3 + 4 * j + 3] = 1;
    const { layer, state, blend } = drawn('full', [-3, 3], { clip: [1, 1], near: [1], nearPoses: whole });
    expect([slots(layer).get(0), slots(layer).get(1)]).toEqual([-1, 0]);
    layer.setOwn({ ...makePlainBody(), name: 'own' }, [{ ...kClips[1]!, poses: 4 }]);
    layer.update(state, blend, camera());
    expect(layer.drawn).toEqual([{ body: 'own', near: 2, far: 0, tiny: 0, speck: 0 }]);
    expect(slots(layer).get(1)).toBe(-1);
    layer.setOwn(null);
    layer.update(state, blend, camera());
    expect(layer.drawn.map((one) => one.body)).toEqual(['one', 'two']);
    expect(slots(layer).get(1)).toBe(0);
    const light = drawn('light', [-3, 3], { clip: [1, 1], near: [1], nearPoses: whole });
    expect(slots(light.layer).get(1)).toBe(-1);
  });
});
