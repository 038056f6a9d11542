import { InstancedMesh, MeshBasicMaterial } from 'three';
import { describe, expect, it } from 'vitest';
import type { SceneObstacle } from '../protocol/scene';
import { CameraController } from './camera_controller';
import { paletteOf } from './palette';
import { Trees } from './trees';

function madeTrees(): Trees {
  const trees = new Trees();
  const list = [0, 10].map((x, id): SceneObstacle => ({ id, name: 'Tree', centre: [x, 0], radius: 0.4, height: 6, moving: false }));
  trees.build(list, paletteOf('light'), new MeshBasicMaterial());
  return trees;
}

function camera(pitch: number): CameraController {
  const made = new CameraController();
  made.resize(1000, 800);
  made.setPose({ targetX: 0, targetY: 0, distance: 40, turn: 0, pitch });
  return made;
}

describe('trees', () => {
  it('let people be seen through the crowns before them, and close again', () => {
    const trees = madeTrees();
    const view = camera(Math.PI / 4);
    // Seen from the south at 45 degrees a crown hides who stands as far behind it as it is high.
    const behind = { count: 1, placement: Float32Array.of(0, 2, 0, 1) };
    let pictures = 0;
    while (trees.reveal(behind, view)) pictures += 1;
    expect(pictures).toBeGreaterThan(3);
    expect(trees.solid[0]).toBeLessThan(0.3);
    expect(trees.solid[1]).toBe(1);
    while (trees.reveal({ count: 1, placement: Float32Array.of(0, -5, 0, 1) }, view));
    expect(trees.solid[0]).toBeGreaterThan(0.95);
  });

  it('hide others when seen from above', () => {
    const trees = madeTrees();
    while (trees.reveal({ count: 1, placement: Float32Array.of(10.3, 0.2, 0, 1) }, camera(1.48)));
    expect([trees.solid[0]! > 0.9, trees.solid[1]! < 0.3]).toEqual([true, true]);
  });

  it('are two draw calls whatever their number, and give their buffers back', () => {
    const trees = madeTrees();
    expect(trees.group.children.map((mesh) => (mesh as InstancedMesh).count)).toEqual([2, 2]);
    trees.clear();
    expect(trees.group.children).toHaveLength(0);
    expect(trees.reveal({ count: 0, placement: new Float32Array(0) }, camera(1))).toBe(false);
  });
});
