import { Color, InstancedMesh } from 'three';
import { expect, it } from 'vitest';
import { sceneOf } from '../protocol/test_scene';
import { paletteOf } from './drawing/palette';
import type { ShadeUniforms } from './drawing/shade';
import { EnvironmentLayer } from './environment_layer';

const scene = sceneOf({
  box: { min: [-9, -9], max: [9, 9] },
  obstacles: [1, 2, 3].map((id) => ({ id, name: 'Tree', centre: [id, 0], radius: 0.3, height: 5 })),
  items: [{ position: [0, 3], radius: 0.5 }],
});

it('gives back the buffers of trees and items when the world is built anew', () => {
  const shade: ShadeUniforms = { uShadowKeeps: { value: 0.7 }, uHatch: { value: new Color() } };
  const layer = new EnvironmentLayer(shade);
  layer.build(scene, paletteOf('light'));
  const instanced: InstancedMesh[] = [];
  layer.group.traverse((object) => {
    if (object instanceof InstancedMesh) instanced.push(object as InstancedMesh);
  });
  expect(instanced).toHaveLength(3);
  let disposed = 0;
  for (const mesh of instanced) mesh.addEventListener('dispose', () => (disposed += 1));
  layer.build(scene, paletteOf('dark'));
  expect(disposed).toBe(3);
  layer.dispose();
});
