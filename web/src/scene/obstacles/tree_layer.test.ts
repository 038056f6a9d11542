import { type InstancedMesh, MeshBasicMaterial } from 'three';
import { describe, expect, it } from 'vitest';
import { CameraController } from '../camera/camera_controller';
import { paletteOf } from '../drawing/palette';
import { type Standing, TreeLayer } from './tree_layer';
import { StandingGrid } from '../../model/standing_grid';
import { obstacleOf } from '../../protocol/test_scene';

function standing(places: readonly number[]): Standing {
  const grid = new StandingGrid();
  grid.fill(Float32Array.from(places), 2, places.length / 2);
  return grid;
}

function madeTrees(): TreeLayer {
  const trees = new TreeLayer();
  const list = [0, 10].map((x, id) => obstacleOf({ id, name: 'Tree', centre: [x, 0], radius: 0.4, height: 6 }));
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
    const behind = standing([0, 2]);
    let pictures = 0;
    while (trees.reveal(behind, view)) pictures += 1;
    expect(pictures).toBeGreaterThan(3);
    expect(trees.solid[0]).toBeLessThan(0.3);
    expect(trees.solid[1]).toBe(1);
    while (trees.reveal(standing([0, -5]), view));
    expect(trees.solid[0]).toBeGreaterThan(0.95);
  });

  it('hide others when seen from above', () => {
    const trees = madeTrees();
    while (trees.reveal(standing([10.3, 0.2]), camera(1.48)));
    expect([trees.solid[0]! > 0.9, trees.solid[1]! < 0.3]).toEqual([true, true]);
  });

  it('are two draw calls whatever their number, and give their buffers back', () => {
    const trees = madeTrees();
    expect(trees.group.children.map((mesh) => (mesh as InstancedMesh).count)).toEqual([2, 2]);
    trees.clear();
    expect(trees.group.children).toHaveLength(0);
    expect(trees.reveal(standing([]), camera(1))).toBe(false);
  });
});
