import { beforeEach, describe, expect, it } from 'vitest';
import type { Asker, Forecast } from '../../model/forecast';
import { madeOrder } from '../../model/test_frames';
import type { ClientMessage, ForecastAsk, ForecastFrame } from '../../protocol/messages';
import { Forecaster } from './forecaster';

type Question = Extract<ClientMessage, { type: 'AskForecasts' }>;

let asked: Question[];
let drawn: (readonly Forecast[])[];
let forecaster: Forecaster;

const ask = (x: number): ForecastAsk => ({ group: 1, order: 0, asked: {}, placed: false, x, y: 0, facing: 0 });

function answer(question: Question, more: Partial<ForecastFrame> = {}): ForecastFrame[] {
  const none = { arrives: true, seconds: 3, x: 0, y: 0, way: new Float32Array(), ...more };
  return question.asks.map(({ group, order }) => ({ group, order, ...none }));
}

function reply(question: Question, now: number): void {
  forecaster.answered({ type: 'Forecasts', number: question.number, answers: answer(question) }, now);
}

function group(id: number, ids: readonly number[]): Asker {
  return { id, x: 0, y: 0, facing: 0, patrols: false, orders: ids.map((one) => madeOrder(one, { target: [one, 0] })) };
}

beforeEach(() => {
  asked = [];
  drawn = [];
  const send = (message: ClientMessage): void => void (message.type === 'AskForecasts' && asked.push(message));
  forecaster = new Forecaster(
    { send },
    (forecasts) => drawn.push(forecasts),
    () => undefined,
  );
});

describe('what is drawn', () => {
  it('is asked about one question at a time, and only about the newest', () => {
    for (let now = 0; now < 50; now += 10) {
      forecaster.draw([ask(now)]);
      forecaster.tick(now);
    }
    expect(asked.map(({ asks }) => asks[0]!.x)).toEqual([0]);
    reply(asked[0]!, 50);
    expect(drawn.at(-1)).toHaveLength(1);
    for (let now = 51; now < 400; now += 10) forecaster.tick(now);
    expect(asked.map(({ asks }) => asks[0]!.x)).toEqual([0, 40]);
  });

  it('is asked about at a bounded rate, and more rarely where answers are slow', () => {
    const count = (delay: number): number => {
      asked = [];
      for (let now = 10000 * delay, due = 0; now < 10000 * delay + 2000; now += 5) {
        forecaster.draw([ask(now)]);
        const before = asked.length;
        forecaster.tick(now);
        if (asked.length > before) due = now + delay;
        if (due > 0 && now >= due) [due] = [0, reply(asked.at(-1)!, now)];
      }
      return asked.length;
    };
    const fast = count(5);
    expect(fast).toBeGreaterThan(10);
    expect(fast).toBeLessThan(26);
    expect(count(100)).toBeLessThan(7);
  });

  it('for many groups is asked about in parts, each group in its turn', () => {
    const asks = [1, 2, 3, 4, 5].map((id) => ({ ...ask(0), group: id }));
    for (let now = 0; now < 1000; now += 250) {
      forecaster.draw(asks);
      forecaster.tick(now);
      reply(asked.at(-1)!, now + 1);
    }
    expect(asked.map((one) => one.asks.map((each) => each.group))).toEqual([
      [1, 2, 3],
      [4, 5, 1],
      [2, 3, 4],
      [5, 1, 2],
    ]);
    expect(drawn.at(-1)!.map((one) => one.group)).toEqual([1, 2, 3, 4, 5]);
  });

  it('drops answers to older questions, and those that come after the end', () => {
    forecaster.draw([ask(1)]);
    forecaster.tick(0);
    forecaster.draw([ask(2)]);
    forecaster.tick(1500);
    expect(asked).toHaveLength(2);
    reply(asked[0]!, 1501);
    expect(drawn).toHaveLength(0);
    forecaster.draw(null);
    expect(drawn).toEqual([[]]);
    reply(asked[1]!, 1502);
    expect(drawn).toEqual([[]]);
  });
});

describe('queues', () => {
  it('are asked about when they change, and then rarely', () => {
    const run = (from: number, to: number): void => {
      for (let now = from; now < to; now += 20) {
        const before = asked.length;
        forecaster.tick(now);
        if (asked.length > before) reply(asked.at(-1)!, now + 5);
      }
    };
    forecaster.observe([group(1, [7, 8]), group(2, [])], 1, 0);
    run(0, 2000);
    expect(asked.map(({ asks }) => asks.map(({ order }) => order))).toEqual([[7, 8]]);
    expect([...forecaster.known.keys()]).toEqual([7, 8]);
    forecaster.observe([group(1, [8]), group(2, [])], 1, 2);
    expect([...forecaster.known.keys()]).toEqual([8]);
    run(2000, 5000);
    expect(asked).toHaveLength(2);
    run(5000, 7000);
    expect(asked).toHaveLength(3);
    // Other ground.
    forecaster.observe([group(1, [8]), group(2, [])], 2, 7);
    run(7000, 7500);
    expect(asked).toHaveLength(4);
  });

  it('of many orders are asked about in parts, and what is drawn comes first', () => {
    forecaster.observe([group(1, [1, 2, 3, 4, 5])], 1, 0);
    forecaster.tick(0);
    reply(asked[0]!, 1);
    forecaster.draw([ask(0)]);
    forecaster.tick(1000);
    reply(asked[1]!, 1001);
    forecaster.draw(null);
    forecaster.tick(2000);
    expect(asked.map(({ asks }) => asks.map(({ order }) => order))).toEqual([[1, 2, 3], [0], [4, 5]]);
  });

  it('of patrols have a way back to the first order', () => {
    forecaster.observe([{ ...group(1, [7, 8]), patrols: true }], 1, 0);
    forecaster.tick(0);
    reply(asked[0]!, 1);
    forecaster.tick(500);
    expect(asked[1]!.asks).toMatchObject([{ order: 7, placed: true, x: 8 }]);
    reply(asked[1]!, 501);
    expect([...forecaster.returns.keys()]).toEqual([1]);
    forecaster.observe([group(1, [7, 8])], 1, 1);
    expect(forecaster.returns.size).toBe(0);
  });

  it('with a question that was lost are asked about again', () => {
    forecaster.observe([group(1, [1])], 1, 0);
    forecaster.tick(0);
    forecaster.tick(900);
    expect(asked).toHaveLength(1);
    forecaster.tick(4100);
    expect(asked).toHaveLength(2);
  });
});
