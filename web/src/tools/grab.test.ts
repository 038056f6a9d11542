import { describe, expect, it } from 'vitest';
import { grabAt } from './grab';
import { controlFrame, frameWith } from './test_support';

const line = controlFrame(1, 1, [{ x: 0, y: 0 }, { x: 10, y: 0 }]);
const area = controlFrame(2, 2, [{ x: 0, y: 5 }, { x: 6, y: 5 }, { x: 3, y: 9 }]);
const { groups } = frameWith(1, [line, area]);

describe('grabAt', () => {
  it('takes one end, the whole bar, or all of an area', () => {
    expect(grabAt(groups, { x: 9.9, y: 0.2 }, 0.5, () => 'whole')).toMatchObject({ group: 5, control: { id: 1 }, points: [1] });
    expect(grabAt(groups, { x: 5, y: 0.2 }, 0.5, () => 'whole')).toMatchObject({ control: { id: 1 }, points: [0, 1] });
    expect(grabAt(groups, { x: 3, y: 6 }, 0.5, () => 'whole')).toMatchObject({ control: { id: 2 }, points: [0, 1, 2] });
    expect(grabAt(groups, { x: 3, y: 8.8 }, 0.5, () => 'whole')).toMatchObject({ control: { id: 2 }, points: [2] });
  });
  it('takes only what it may', () => {
    expect(grabAt(groups, { x: 5, y: 0 }, 0.5, () => 'handles')).toBeNull();
    expect(grabAt(groups, { x: 0, y: 0.1 }, 0.5, () => 'handles')?.points).toEqual([0]);
    expect(grabAt(groups, { x: 0, y: 0.1 }, 0.5, () => 'nothing')).toBeNull();
  });
  it('finds nothing where nothing is near', () => {
    expect(grabAt(groups, { x: 5, y: 2.5 }, 0.5, () => 'whole')).toBeNull();
  });
});
