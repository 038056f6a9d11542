import { beforeEach, describe, expect, it } from 'vitest';
import type { StudioFrame } from '../model/studio_frame';
import { Drafts, type PendingControl } from './drafts';
import { VirtualControls } from './virtual_controls';
import { FakeClient, FakeScene, contactAt, controlFrame, frameWith } from './test_support';
import { TouchEditor } from './touch_editor';
import { TouchSender } from './touch_sender';
import type { DraftControl } from '../scene/marks/draft_control';

let shown: readonly DraftControl[];
let calls: number;
let asked: () => readonly PendingControl[];
let drafts: Drafts;

function frame(playing: boolean, touchEcho = 0, step = 1, more: Partial<StudioFrame> = {}): StudioFrame {
  return { ...frameWith(step, []), playing, touchEcho, replaying: false, ...more };
}

beforeEach(() => {
  shown = [];
  calls = 0;
  asked = () => [];
  drafts = new Drafts(
    (list) => {
      shown = list;
      calls += 1;
    },
    () => asked(),
    () => 1,
  );
});

describe('drafts of fingers', () => {
  const drawn = (): void => {
    for (const [time, x] of [
      [10, 0],
      [11, 1],
      [12, 2],
    ] as const)
      drafts.add(7, 5, { x, y: 0 }, time);
  };

  it('show what a finger draws while the world is paused, until a step takes it', () => {
    drafts.observe(frame(false));
    drawn();
    expect(shown).toEqual([
      {
        group: 0,
        points: [
          { x: 0, y: 0 },
          { x: 1, y: 0 },
          { x: 2, y: 0 },
        ],
        closed: false,
        handles: [{ x: 0, y: 0 }],
      },
    ]);
    drafts.observe(frame(false, 11, 2));
    expect(shown[0]?.points).toEqual([{ x: 2, y: 0 }]);
    drafts.observe(frame(false, 12, 3));
    expect(shown).toEqual([]);
  });

  it('go on from where the path of the finger ends that the frame shows', () => {
    const known = controlFrame(3, 0, [{ x: -9, y: 0 }]);
    known.points[0] = { ...known.points[0]!, touch: 7, down: true, path: new Float32Array([-5, 0, -1, 0.5]) };
    drafts.observe({ ...frame(false), groups: frameWith(1, [known]).groups });
    drawn();
    expect(shown[0]?.points[0]).toEqual({ x: -1, y: 0.5 });
    expect(shown[0]?.points).toHaveLength(4);
    expect(shown[0]?.handles).toEqual([]);
    known.client = 2;
    drafts.observe({ ...frame(false), groups: frameWith(1, [known]).groups });
    expect(shown[0]?.points).toHaveLength(3);
  });

  it('stay quiet while the world plays or a take is replayed', () => {
    drafts.observe(frame(true));
    drawn();
    drafts.observe(frame(true, 12, 2));
    drafts.observe(frame(false, 12, 2, { replaying: true }));
    drafts.add(8, 5, { x: 0, y: 0 }, 20);
    expect(calls).toBe(0);
  });

  it('go with a cancelled touch, and with a world that begins anew', () => {
    drafts.observe(frame(false, 0, 50));
    drawn();
    drafts.drop(7);
    expect(shown).toEqual([]);
    drawn();
    expect(shown).toHaveLength(1);
    drafts.observe(frame(false, 0, 0));
    expect(shown).toEqual([]);
  });
});

it('drafts of fingers and of new controls come from the tools that send them', () => {
  const client = new FakeClient();
  const sender = new TouchSender(client);
  const controls = new VirtualControls(client, sender, () => 1, drafts);
  asked = () => controls.pending;
  const editor = new TouchEditor(sender, new FakeScene(), drafts);
  drafts.observe(frame(false));
  const finger = editor.ownerFor({ index: 0, group: 5, distance: 0 });
  finger.begin(contactAt(0, 0, { time: 10 }));
  finger.move([contactAt(1, 0, { time: 11 })]);
  finger.end(contactAt(2, 0, { time: 12 }), false);
  expect(shown).toHaveLength(1);
  expect(shown[0]?.points.length).toBeGreaterThanOrEqual(2);
  const lost = editor.ownerFor({ index: 0, group: 5, distance: 0 });
  lost.begin(contactAt(3, 0, { time: 13 }));
  expect(shown).toHaveLength(2);
  lost.end(contactAt(3, 0, { time: 14 }), true);
  expect(shown).toHaveLength(1);
  // An area with a corner inside its hull.
  const positions = [
    { x: 0, y: 0 },
    { x: 4, y: 0 },
    { x: 2, y: 1 },
    { x: 2, y: 4 },
  ];
  const held = controls.create({ group: 5, kind: 2, positions, time: 15, keep: true, pinned: false });
  expect(shown).toHaveLength(2);
  expect(shown[1]).toMatchObject({ closed: true, handles: positions });
  expect(shown[1]?.points).toHaveLength(3);
  controls.move(held, held.fingers[1]!, { x: 5, y: 0 }, 16);
  expect(shown.some((draft) => draft.handles[1]?.x === 5)).toBe(true);
  const answer = controlFrame(8, 2, positions);
  answer.points.forEach((point, i) => (point.touch = held.fingers[i]!.touch));
  const answered = { ...frameWith(2, [answer]), playing: false, replaying: false, touchEcho: 16 };
  controls.observe(answered);
  drafts.observe(answered);
  expect(shown).toEqual([]);
});
