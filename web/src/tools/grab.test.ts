import { describe, expect, it } from 'vitest';
import { grabAt } from './grab';
import { controlFrame, frameWith, onScreen } from './test_support';

const line = controlFrame(1, 1, [
  { x: 0, y: 0 },
  { x: 10, y: 0 },
]);
const area = controlFrame(2, 2, [
  { x: 0, y: 5 },
  { x: 6, y: 5 },
  { x: 3, y: 9 },
]);
const { groups } = frameWith(1, [line, area]);

describe('grabAt', () => {
  it('takes one end, the whole bar, or all of an area', () => {
    expect(grabAt(groups, { x: 9.9, y: 0.1 }, onScreen, () => 'whole')).toMatchObject({
      group: 5,
      control: { id: 1 },
      touches: [2],
    });
    expect(grabAt(groups, { x: 5, y: 0.1 }, onScreen, () => 'whole')).toMatchObject({
      control: { id: 1 },
      touches: [1, 2],
    });
    expect(grabAt(groups, { x: 3, y: 6 }, onScreen, () => 'whole')).toMatchObject({
      control: { id: 2 },
      touches: [1, 2, 3],
    });
    expect(grabAt(groups, { x: 3, y: 8.8 }, onScreen, () => 'whole')).toMatchObject({
      control: { id: 2 },
      touches: [3],
    });
  });
  it('takes only what it may', () => {
    expect(grabAt(groups, { x: 5, y: 0 }, onScreen, () => 'handles')).toBeNull();
    expect(grabAt(groups, { x: 0, y: 0.1 }, onScreen, () => 'handles')?.touches).toEqual([1]);
    expect(grabAt(groups, { x: 0, y: 0.1 }, onScreen, () => 'nothing')).toBeNull();
  });
  it('catches a handle within 24 px on the screen, in depth as well as sideways', () => {
    const low = ({ x, y }: { x: number; y: number }) => ({ x: 40 * x, y: -20 * y });
    const catches = (x: number, y: number) => grabAt(groups, { x, y }, low, () => 'handles') !== null;
    expect([catches(10.55, 0), catches(10.65, 0)]).toEqual([true, false]);
    expect([catches(10, -1.15), catches(10, -1.25)]).toEqual([true, false]);
  });
  it('finds nothing where nothing is near', () => {
    expect(grabAt(groups, { x: 5, y: 2.5 }, onScreen, () => 'whole')).toBeNull();
  });
});
