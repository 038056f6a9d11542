import { describe, expect, it } from 'vitest';
import { MarkState } from './mark_state';
import type { ControlView } from '../../model/frame_view';
import { madeControl, madeGroup } from '../../model/test_frames';

const groupsOf = (controls: readonly ControlView[]) => [madeGroup(1, controls)];

describe('ControlMarks', () => {
  it('puts handles where the newest frame has them', () => {
    const marks = new MarkState();
    marks.update(groupsOf([madeControl(1, 0, [[0, 0]])]), 100);
    marks.update(groupsOf([madeControl(1, 0, [[4, 8]])]), 101);
    expect([...marks.controls][0]?.handles[0]).toEqual({ x: 4, y: 8 });
  });

  it('knows when a control grew into another kind', () => {
    const marks = new MarkState();
    marks.update(groupsOf([madeControl(1, 0, [[0, 0]])]), 100);
    marks.update(
      groupsOf([
        madeControl(1, 1, [
          [0, 0],
          [1, 0],
        ]),
      ]),
      180,
    );
    const shown = [...marks.controls][0];
    expect(shown?.born).toBe(100);
    expect(shown?.kindSince).toBe(180);
    expect(marks.grown(180, 240, 120)).toBeCloseTo(0.5);
  });

  it('fades what ended, then forgets it; faster with reduced motion', () => {
    for (const reduced of [false, true]) {
      const marks = new MarkState();
      marks.reducedMotion = reduced;
      marks.update(groupsOf([madeControl(1, 0, [[0, 0]])]), 100);
      marks.update(groupsOf([]), 200);
      const shown = [...marks.controls][0];
      expect(shown?.ended).toBe(200);
      expect(marks.left(shown?.ended ?? 0, 200 + marks.fade / 2)).toBeCloseTo(0.5);
      expect(marks.fade).toBe(reduced ? 80 : 160);
      marks.update(groupsOf([]), 200 + marks.fade);
      expect([...marks.controls]).toHaveLength(0);
    }
  });

  it('shows a ring from the touch on until it faded after the lift', () => {
    const marks = new MarkState();
    marks.touch(7, { x: 1, y: 2 }, 0, 10);
    marks.touch(7, { x: 3, y: 4 }, 0, 20);
    expect(marks.rings.get(7)).toMatchObject({ at: { x: 3, y: 4 }, since: 10, lifted: 0 });
    marks.touch(7, null, 0, 30);
    marks.update([], 100);
    expect(marks.rings.size).toBe(1);
    marks.touch(7, { x: 9, y: 9 }, 0, 110);
    expect(marks.rings.get(7)?.since).toBe(110);
    marks.touch(7, null, 0, 120);
    marks.update([], 300);
    expect(marks.rings.size).toBe(0);
  });

  it('knows the finger of a touch, but not where another client uses its number, nor after its lift', () => {
    const marks = new MarkState();
    marks.client = 3;
    marks.touch(7, { x: 1, y: 0 }, 0, 10);
    marks.touch(8, { x: 1.1, y: 0 }, 0, 10);
    expect(marks.fingerOf(3, 8)).toEqual({ x: 1.1, y: 0 });
    expect(marks.fingerOf(4, 8)).toBeNull();
    expect(marks.fingerOf(3, 9)).toBeNull();
    marks.touch(8, null, 0, 20);
    expect(marks.fingerOf(3, 8)).toBeNull();
  });

  it('gives rings to the fingers of others, at the end of what they drew, until they faded', () => {
    const marks = new MarkState();
    marks.client = 3;
    const made = madeControl(1, 1, [
      [0, 0],
      [4, 0],
    ]);
    const [first, second] = made.points;
    const theirs = {
      ...made,
      client: 1,
      points: [
        { ...first!, path: [1, 0, 2, 1] },
        { ...second!, down: false },
      ],
    };
    marks.update(groupsOf([theirs, { ...made, id: 2, client: 3 }]), 100);
    expect([...marks.others]).toEqual([['1:1', { at: { x: 2, y: 1 }, group: 0, since: 100, lifted: 0 }]]);
    marks.update(groupsOf([{ ...theirs, points: [first!] }]), 120);
    expect(marks.others.get('1:1')).toMatchObject({ at: { x: 0, y: 0 }, since: 100 });
    marks.update(groupsOf([]), 200);
    expect(marks.others.get('1:1')?.lifted).toBe(200);
    marks.update(groupsOf([]), 200 + marks.fade + 1);
    expect(marks.others.size).toBe(0);
    expect(marks.rings.size).toBe(0);
  });
});
