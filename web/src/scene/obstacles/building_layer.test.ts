import { Color } from 'three';
import { expect, it } from 'vitest';
import { sceneOf } from '../../protocol/test_scene';
import { CameraController } from '../camera/camera_controller';
import { GeometryBuilder } from '../drawing/geometry_builder';
import { paletteOf } from '../drawing/palette';
import { BuildingLayer } from './building_layer';
import { addObstacle } from './obstacle_geometry';

const scene = sceneOf({
  box: { min: [-40, -40], max: [40, 40] },
  obstacles: [
    {
      id: 1,
      name: 'House',
      height: 8,
      polygon: [
        [-6, 0],
        [6, 0],
        [6, 4],
        [-6, 4],
      ],
    },
    {
      id: 2,
      name: 'Barn',
      height: 5,
      polygon: [
        [20, 0],
        [26, 0],
        [26, 4],
        [20, 4],
      ],
    },
    {
      id: 3,
      name: 'Kerb',
      height: 0.5,
      polygon: [
        [-30, 0],
        [-20, 0],
        [-20, 4],
        [-30, 4],
      ],
    },
  ],
});

function made(): BuildingLayer {
  const layer = new BuildingLayer({ uShadowKeeps: { value: 0.7 }, uHatch: { value: new Color() } });
  const builder = new GeometryBuilder();
  const ends = scene.obstacles.map((obstacle) => {
    addObstacle(builder, obstacle, paletteOf('light'));
    return builder.triangleCount;
  });
  layer.build(builder, scene.obstacles, ends, '#000000');
  return layer;
}

function revealed(layer: BuildingLayer, people: readonly (readonly [number, number])[]): readonly number[] {
  const camera = new CameraController();
  camera.resize(1280, 800);
  camera.setPose({ targetX: 0, targetY: 2, distance: 40, turn: 0, pitch: 0.7 });
  const standing = {
    someoneNear: (x: number, y: number, reach: number) => people.some((p) => Math.hypot(p[0] - x, p[1] - y) < reach),
  };
  for (let i = 0; i < 60; ++i) layer.reveal(standing, camera);
  return layer.solid;
}

it('thins the building that hides somebody, and no other', () => {
  const layer = made();
  // The camera looks north: behind is beyond y = 4.
  expect(revealed(layer, [[1, 5]])).toEqual([0.34, 1, 1]);
  expect(revealed(layer, [[23, 5.5]])).toEqual([1, 0.34, 1]);
});

it('leaves a building solid that stands beside or behind people, and a low one', () => {
  const layer = made();
  expect(
    revealed(layer, [
      [0, -2],
      [10, 5],
      [0, 14],
      [-25, 4.6],
    ]),
  ).toEqual([1, 1, 1]);
});
