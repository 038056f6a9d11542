import { describe, expect, it } from 'vitest';
import { sceneOf } from '../../protocol/test_scene';
import { surroundings } from './opening';

const scene = sceneOf({
  box: { min: [-60, -60], max: [60, 60] },
  obstacles: [
    {
      id: 1,
      name: '',
      polygon: [
        [8, 0],
        [9, 0],
        [9, 1],
      ],
      height: 2,
    },
    { id: 2, name: '', centre: [0, 18], radius: 0.5, height: 2 },
    { id: 3, name: '', centre: [-50, 0], radius: 0.5, height: 2 },
  ],
});
const crowd = [
  { x: -2, y: -2 },
  { x: 2, y: 2 },
];

describe('surroundings', () => {
  it('holds what is near, drawn in, and leaves out what is far', () => {
    expect(surroundings(scene, crowd)).toEqual([
      { x: 8, y: 0 },
      { x: 8, y: 0 },
      { x: 8, y: 1 },
      { x: 0, y: 8 },
    ]);
  });
  it('draws them in more where there is less room', () => {
    expect(surroundings(scene, crowd, 2)).toContainEqual({ x: 4, y: 0 });
  });
  it('leaves out obstacles where there are patches, which say more of the place', () => {
    const patch = {
      id: 4,
      name: '',
      polygon: [
        [5, 0],
        [6, 0],
        [6, 1],
      ],
      motion: 1,
      speed: 1,
    };
    const both = surroundings({ ...scene, patches: [patch] } as unknown as typeof scene, crowd);
    expect(both).toEqual([
      { x: 5, y: 0 },
      { x: 6, y: 0 },
      { x: 6, y: 1 },
    ]);
  });
  it('holds checkpoints', () => {
    const goal = sceneOf({
      box: { min: [-60, -60], max: [60, 60] },
      checkpoints: [{ position: [5, 1], radius: 2, formation: { kind: 'ring' } }],
    });
    expect(surroundings(goal, crowd)).toEqual([{ x: 5, y: 1 }]);
  });
  it('has nothing to add where nobody is', () => {
    expect(surroundings(scene, [])).toEqual([]);
  });
});
