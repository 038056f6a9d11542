import { beforeEach, describe, expect, it } from 'vitest';
import type { Command, GiveOrderCommand } from '../../model/commands';
import type { StudioFrame } from '../../model/studio_frame';
import { StudioStore } from '../../model/studio_store';
import { kIdle, madeOrder } from '../../model/test_frames';
import { UnitNews } from '../../model/unit_news';
import { EventKind, type ClientMessage, type EventFrame } from '../../protocol/messages';
import { arrivalText, QueueController } from './queue_controller';

let sent: ClientMessage[];
let shown: unknown[];
let store: StudioStore;
let news: UnitNews;
let controller: QueueController;

/** Group 4 with these orders. */
function see(ids: readonly number[], events: EventFrame[] = [], more: object = {}): void {
  const orders = ids.map((id) => madeOrder(id, { target: [id, 0] }));
  const frame = { groups: [{ id: 4, ...kIdle, orders, ...more }], sceneRevision: 1, time: 0, events };
  news.observe(events);
  controller.observe(frame as unknown as StudioFrame);
}

function given(id: number): EventFrame {
  return { kind: EventKind.OrderGiven, subject: 4, value: id, x: 0, y: 0 };
}

function done(id: number): EventFrame {
  return { kind: EventKind.OrderDone, subject: 4, value: id, x: 0, y: 0 };
}

const commands = (): Command[] => sent.flatMap((one) => (one.type === 'Commands' ? one.commands : []));

beforeEach(() => {
  sent = [];
  shown = [];
  store = new StudioStore();
  news = new UnitNews((was, now) => controller.copied(was, now));
  const scene = {
    previewForecasts: (forecasts: readonly unknown[]) => void (shown = [...forecasts]),
    setWays: () => undefined,
    setPicked: () => undefined,
  };
  controller = new QueueController({ send: (one) => sent.push(one) }, store, scene, news, () => undefined);
  store.set({ groups: [{ id: 4, name: 'North', colour: 0, count: 3, formation: 'square' }], selected: [4] });
  see([7, 8, 9]);
});

describe('QueueController', () => {
  it('puts the next order before the chosen one, with a tool in hand', () => {
    controller.insertBefore(8);
    expect([store.state.tool, controller.spotOf(4, false)]).toEqual(['order', { mode: 'insert', index: 1 }]);
    // It is the first one by now.
    see([8, 9], [done(7)]);
    expect(controller.spotOf(4, true)).toEqual({ mode: 'insert', index: 0 });
    controller.given();
    expect([store.state.tool, store.state.insertBefore]).toEqual(['steer', 0]);
    expect([controller.spotOf(4, true), controller.spotOf(4, false)]).toEqual([
      { mode: 'append' },
      { mode: 'replace' },
    ]);
    controller.insertBefore(9);
    see([8]);
    expect(store.state.insertBefore).toBe(0);
  });

  it('moves an order and keeps it chosen under its new id', () => {
    controller.pick(9);
    controller.moveTo(9, 0);
    expect(commands()).toMatchObject([
      { kind: 'queue', edit: 'cancel', order: 9 },
      { kind: 'order', mode: 'insert', index: 0, order: { kind: 'move', target: [9, 0] } },
    ]);
    see([10, 7, 8], [given(10)]);
    expect(store.state.picked).toBe(10);
  });

  it('cancels and skips', () => {
    controller.cancel(8);
    see([7, 9]);
    controller.skip();
    expect(commands()).toMatchObject([
      { edit: 'cancel', order: 8 },
      { edit: 'cancel', order: 7 },
    ]);
  });

  it('says when a drawn order would arrive, after those that come before', () => {
    const move: GiveOrderCommand = { kind: 'order', group: 4, order: { target: [5, 5] } };
    const answer = (order: number, seconds: number, arrives = true): void => {
      const last = sent.at(-1) as Extract<ClientMessage, { type: 'AskForecasts' }>;
      const answers = last.asks.map((ask) => ({
        group: 4,
        order: order || ask.order,
        arrives,
        seconds,
        x: 0,
        y: 0,
        way: new Float32Array(),
      }));
      controller.answered({ type: 'Forecasts', number: last.number, answers }, 0);
    };
    controller.tick(0);
    answer(0, 10);
    expect(store.state.queue.map(({ span }) => span)).toEqual(['0:10', '0:20', '0:30']);
    controller.drawn([move], true);
    controller.tick(1000);
    const asked = sent.at(-1) as Extract<ClientMessage, { type: 'AskForecasts' }>;
    expect(asked.asks[0]).toMatchObject({ group: 4, order: 0, placed: true, x: 9, y: 0 });
    answer(0, 5);
    expect(shown).toMatchObject([{ text: 'in 0:35', arrives: true }]);
    controller.drawn([move], false);
    controller.tick(2000);
    answer(0, Infinity, false);
    expect(shown).toMatchObject([{ text: 'Cannot be reached', arrives: false }]);
    controller.drawn([], false);
    expect(shown).toEqual([]);
  });
});

it('tells of several groups in one sentence', () => {
  expect(arrivalText([12])).toBe('in 0:12');
  expect(arrivalText([40, 12.2, 12])).toBe('in 0:12 to 0:40');
  expect(arrivalText([12, Infinity, Infinity])).toBe('in 0:12, 2 cannot');
  expect(arrivalText([Infinity])).toBe('Cannot be reached');
  expect(arrivalText([null])).toBe('arrives');
});
