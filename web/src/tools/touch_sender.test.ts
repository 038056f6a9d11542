import { beforeEach, describe, expect, it } from 'vitest';
import { TouchPhase, type ClientMessage, type Touches } from '../protocol/messages';
import { TouchSender } from './touch_sender';

let sent: Touches[];
let times: number[];
let now: number;
let sender: TouchSender;

beforeEach(() => {
  sent = [];
  times = [];
  now = 1000;
  sender = new TouchSender(
    { send: (message: ClientMessage) => sent.push(message as Touches) },
    (time) => times.push(time),
    () => now,
  );
});

const phases = (): number[][] => sent.map((message) => message.events.map((event) => event.phase));

describe('TouchSender', () => {
  it('sends downs and lifts at once, with the moves that wait, in order', () => {
    sender.down(1, { x: 0, y: 0 }, 5, 0);
    sender.move(1, { x: 1, y: 0 }, 6);
    sender.up(1, { x: 1, y: 0 }, 7);
    expect(phases()).toEqual([[TouchPhase.Down], [TouchPhase.Move, TouchPhase.Up]]);
    expect(times).toEqual([5, 6]);
  });
  it('sends moves at once, but not oftener than every 8 ms', () => {
    sender.move(1, { x: 1, y: 0 }, 1);
    sender.moved();
    expect(sent).toHaveLength(1);
    now += 3;
    sender.move(1, { x: 2, y: 0 }, 2);
    sender.moved();
    expect(sent).toHaveLength(1);
    now += 5;
    sender.move(1, { x: 3, y: 0 }, 3);
    sender.moved();
    expect(sent).toHaveLength(2);
    expect(sent[1]!.events.map((event) => event.x)).toEqual([2, 3]);
  });
  it('leaves nothing behind at the next drawn frame', () => {
    sender.move(1, { x: 1, y: 0 }, 1);
    sender.moved();
    sender.move(1, { x: 2, y: 0 }, 2);
    sender.moved();
    sender.flush();
    sender.flush();
    expect(sent).toHaveLength(2);
  });
});
