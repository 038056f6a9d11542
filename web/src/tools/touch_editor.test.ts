import { beforeEach, describe, expect, it } from 'vitest';
import { TouchPhase } from '../protocol/messages';
import { FakeClient, FakeScene, contactAt } from './test_support';
import { TouchEditor } from './touch_editor';
import { TouchSender } from './touch_sender';

const hit = { index: 0, group: 5, distance: 0 };
let client: FakeClient;
let scene: FakeScene;
let sender: TouchSender;
let editor: TouchEditor;
let timed: number[];

beforeEach(() => {
  client = new FakeClient();
  scene = new FakeScene();
  timed = [];
  sender = new TouchSender(client, (time) => timed.push(time));
  editor = new TouchEditor(sender, scene);
});

describe('TouchEditor', () => {
  it('sends a finger from down to up, with all coalesced moves and their times', () => {
    const owner = editor.ownerFor(hit);
    owner.begin(contactAt(1, 1, { time: 10 }));
    owner.move([contactAt(1.1, 1, { time: 10.01 }), contactAt(1.2, 1, { time: 10.02 })]);
    owner.end(contactAt(1.3, 1, { time: 10.03 }), false);
    const events = client.touches();
    expect(events.map((event) => event.phase)).toEqual([
      TouchPhase.Down,
      TouchPhase.Move,
      TouchPhase.Move,
      TouchPhase.Up,
    ]);
    expect(events.map((event) => event.time)).toEqual([10, 10.01, 10.02, 10.03]);
    expect(events[0]).toMatchObject({ group: 5, x: 1, y: 1 });
    expect(new Set(events.map((event) => event.touch)).size).toBe(1);
    expect(timed).toEqual([10, 10.01, 10.02]);
  });

  it('keeps ten fingers apart and never gives a number twice', () => {
    for (let round = 0; round < 2; ++round) {
      for (let pointer = 0; pointer < 10; ++pointer) editor.ownerFor(hit).begin(contactAt(pointer, 0, { pointer }));
      expect(editor.count).toBe(10);
      for (let pointer = 0; pointer < 10; ++pointer)
        editor.ownerFor(hit).end(contactAt(pointer, 0, { pointer }), false);
    }
    const downs = client.touches().filter((event) => event.phase === TouchPhase.Down);
    expect(new Set(downs.map((event) => event.touch)).size).toBe(20);
  });

  it('cancels where the browser took the contact away', () => {
    const owner = editor.ownerFor(hit);
    owner.begin(contactAt(1, 1));
    owner.end(contactAt(0, 0), true);
    expect(client.touches()[1]).toMatchObject({ phase: TouchPhase.Cancel, x: 1, y: 1 });
  });

  it('cancels a mouse click that drew nothing, but lifts a still finger', () => {
    const owner = editor.ownerFor(hit);
    owner.begin(contactAt(1, 1, { kind: 'mouse' }));
    owner.end(contactAt(1, 1, { kind: 'mouse' }), false);
    owner.begin(contactAt(1, 1));
    owner.end(contactAt(1, 1), false);
    expect(client.touches().map((event) => event.phase)).toEqual([
      TouchPhase.Down,
      TouchPhase.Cancel,
      TouchPhase.Down,
      TouchPhase.Up,
    ]);
  });

  it('marks the finger at once, by its touch, and lets the mark go', () => {
    const owner = editor.ownerFor(hit);
    owner.begin(contactAt(1, 1, { pointer: 4 }));
    owner.end(contactAt(1, 1, { pointer: 4 }), false);
    expect(scene.marks).toEqual([
      [1, { x: 1, y: 1 }, 0],
      [1, null, 0],
    ]);
  });
});

describe('TouchSender', () => {
  it('gathers moves until the frame is drawn, and sends them before a lift', () => {
    sender.move(1, { x: 0, y: 0 }, 1);
    sender.move(1, { x: 1, y: 0 }, 2);
    expect(client.sent).toHaveLength(0);
    sender.flush();
    expect(client.sent).toHaveLength(1);
    sender.move(1, { x: 2, y: 0 }, 3);
    sender.up(1, { x: 2, y: 0 }, 4);
    expect(client.sent).toHaveLength(2);
    expect(client.touches().map((event) => event.time)).toEqual([1, 2, 3, 4]);
    sender.flush();
    expect(client.sent).toHaveLength(2);
  });
});
