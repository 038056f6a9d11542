import { beforeEach, expect, it, vi } from 'vitest';
import type { StudioFrame } from '../../model/studio_frame';
import { StudioStore } from '../../model/studio_store';
import { EventKind, Standing, type ClientMessage, type Standings } from '../../protocol/messages';
import { StandingController } from './standing_controller';

let answer: (message: Standings) => void;
let sent: ClientMessage[];
let store: StudioStore;
let controller: StandingController;
const setBarred = vi.fn();
const camera = { frame: vi.fn(), lookAt: vi.fn() };
const say = vi.fn();

beforeEach(() => {
  vi.resetAllMocks();
  vi.useFakeTimers();
  sent = [];
  store = new StudioStore();
  store.set({
    groups: [{ id: 7, name: 'South', colour: 0, count: 9, formation: 'square' }],
    standings: [[8, 0, 0, 0, 1]],
  });
  const client = {
    send: (message: ClientMessage) => void sent.push(message),
    on: (_: 'standings', listener: (message: Standings) => void) => void (answer = listener),
  };
  controller = new StandingController(client, store, { orders: { setBarred } }, camera, say);
});

const people = [{ id: 3, standing: Standing.Outside, x: 9, y: 0 }];

it('marks who cannot be in place, brings them into view, and forgets them when all is well', () => {
  controller.show();
  expect(sent).toEqual([{ type: 'AskStandings', number: 1 }]);
  answer({ type: 'Standings', number: 0, people: [] });
  answer({ type: 'Standings', number: 1, people });
  expect(setBarred).toHaveBeenLastCalledWith([{ id: 3, place: { x: 9, y: 0 } }]);
  expect(camera.frame).toHaveBeenCalledWith([{ x: 9, y: 0 }]);
  store.set({ standings: [[9, 0, 0, 0, 0]] });
  expect(setBarred).toHaveBeenLastCalledWith([]);
});

it('looks at the spot of the message where nobody is barred any more', () => {
  controller.show({ x: 1, y: 2 });
  answer({ type: 'Standings', number: 1, people: [] });
  expect(camera.lookAt).toHaveBeenCalledWith({ x: 1, y: 2 });
  expect(setBarred).not.toHaveBeenCalled();
});

function frame(time: number, standings: number[], arrives = false): StudioFrame {
  const events = arrives ? [{ kind: EventKind.Arrived, subject: 7, value: 9, x: 0, y: 0 }] : [];
  return { time, events, groups: [{ id: 7, standings, x: 4, y: 5 }] } as unknown as StudioFrame;
}

it('speaks of an arrival, and shows it only after a long way out of sight', () => {
  const come = (from: number, to: number): void => {
    controller.observe(frame(from, [0, 9]));
    controller.observe(frame(to, [9, 0], true));
  };
  come(1, 30);
  expect(say).toHaveBeenCalledWith('South: everybody is in place');
  expect(store.state.notice).toBeNull();
  store.set({ arrows: [{ index: 0, id: 7, x: 0, y: 0, angle: 0 }] });
  come(40, 45);
  expect(store.state.notice).toBeNull();
  come(50, 75);
  expect(store.state.notice).toMatchObject({ text: 'South: everybody is in place.', x: 4, y: 5 });
});
