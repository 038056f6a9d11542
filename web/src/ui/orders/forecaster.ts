// Asks the server what would come of orders: of those that are drawn, and of those that wait in queues. One question is
// out at a time; what is drawn comes first, and an answer to an older question is dropped.

import type { MessageSender } from '../../link/studio_client';
import { forecastOf, queueAsks, returnAsk, type Asker, type Forecast } from '../../model/forecast';
import type { ForecastAsk, Forecasts } from '../../protocol/messages';

/** Between two questions, and more for each order asked about [ms]. */
const kPause = 60;
const kPausePerOrder = 25;
/** A server that is slow to answer is asked more rarely: the pause is so many times what the last answer took. */
const kPatience = 3;
/** A question without an answer for so long is forgotten [ms]. */
const kLost = 1000;
/** What is drawn is asked about again after so long, as the crowd goes on [ms]. */
const kDrawnAgain = 700;
/** Queues are asked about again after so long [ms]. */
const kRefresh = 4000;
/** Orders asked about at once: the world waits for the answer, which takes up to some 40 ms each in a city of 256 m. */
const kAtOnce = 3;

/** How far the questions about one queue are. */
interface Queue {
  group: Asker;
  key: string;
  /** The next order to ask about. */
  next: number;
  /** When the last round of questions ended [ms]. */
  asked: number;
  /** World time of the answer about the first order [s]. */
  since: number;
}

/** What a question is about. */
type Subject = 'drawn' | 'queue' | 'return';

interface Question {
  readonly number: number;
  readonly subject: Subject;
  readonly group: number;
  readonly asked: number;
  readonly orders: number;
}

export class Forecaster {
  /** Answers about orders that wait, by their ids. */
  readonly known = new Map<number, Forecast>();
  /** The ways of patrols back to their first orders, by groups. */
  readonly returns = new Map<number, Forecast>();
  private readonly queues_ = new Map<number, Queue>();
  private drawn_: readonly ForecastAsk[] | null = null;
  /** The newest answers about what is drawn, by groups. */
  private readonly answers_ = new Map<number, Forecast>();
  /** How many groups of what is drawn are to be asked about yet, and the one whose turn it is. */
  private drawnLeft_ = 0;
  private drawnNext_ = 0;
  /** When it was asked about last [ms]. */
  private drawnAsked_ = -Infinity;
  private open_: Question | null = null;
  private number_ = 0;
  private free_ = 0;
  private time_ = 0;

  /** `drawn`: answers about what is drawn; none where the drawing has ended. `queues`: answers about queues have come. */
  constructor(
    private readonly client_: MessageSender,
    private readonly drawnKnown_: (forecasts: readonly Forecast[]) => void,
    private readonly queuesKnown_: () => void,
  ) {}

  clear(): void {
    this.known.clear();
    this.returns.clear();
    this.queues_.clear();
    this.open_ = null;
    this.draw(null);
  }

  /** What is drawn now; null where the drawing has ended. */
  draw(asks: readonly ForecastAsk[] | null): void {
    if (!asks && !this.drawn_) return;
    this.drawn_ = asks;
    this.drawnLeft_ = asks?.length ?? 0;
    if (asks) return;
    this.answers_.clear();
    this.drawnKnown_([]);
  }

  /** Takes the groups of a frame. `ground`: another value where the ground has changed; `time` of the world [s]. */
  observe(groups: readonly Asker[], ground: number, time: number): void {
    this.time_ = time;
    const there = new Set(groups.map(({ id }) => id));
    for (const id of this.queues_.keys()) if (!there.has(id)) this.queues_.delete(id);
    for (const { id, patrols } of groups) if (!patrols) this.returns.delete(id);
    let changed = false;
    for (const group of groups) {
      const key = `${ground} ${group.patrols} ${group.orders.map(({ id }) => id).join()}`;
      const queue = this.queues_.get(group.id);
      if (queue?.key === key) {
        queue.group = group;
        continue;
      }
      changed = true;
      this.queues_.set(group.id, { group, key, next: 0, asked: -Infinity, since: time });
    }
    if (changed) this.forgetDone(groups);
  }

  /** Asks what is to be asked. `now` [ms]. */
  tick(now: number): void {
    if (this.open_ && now - this.open_.asked < kLost) return;
    if (this.open_) this.lost(this.open_);
    if (now < this.free_) return;
    if (this.askOfDrawn(now)) return;
    for (const queue of this.queues_.values()) if (this.askOf(queue, now)) return;
  }

  answered({ number, answers }: Forecasts, now: number): void {
    const question = this.open_;
    if (question?.number !== number) return;
    this.open_ = null;
    const pause = Math.max(kPause + kPausePerOrder * question.orders, kPatience * (now - question.asked));
    this.free_ = now + pause;
    const forecasts = answers.map(forecastOf);
    if (question.subject === 'drawn') {
      if (!this.drawn_) return;
      for (const forecast of forecasts) this.answers_.set(forecast.group, forecast);
      this.drawnKnown_(this.drawn_.flatMap(({ group }) => this.answers_.get(group) ?? []));
      return;
    }
    for (const forecast of forecasts) {
      if (question.subject === 'return') {
        this.returns.set(forecast.group, forecast);
        continue;
      }
      this.known.set(forecast.order, forecast);
      const queue = this.queues_.get(forecast.group);
      if (queue && queue.group.orders[0]?.id === forecast.order) queue.since = this.time_;
    }
    this.queuesKnown_();
  }

  /** World time at which the forecast of a group's first order was made [s]. */
  since(group: number): number {
    return this.queues_.get(group)?.since ?? this.time_;
  }

  /** Asks about the next groups of what is drawn, where that is due. */
  private askOfDrawn(now: number): boolean {
    const asks = this.drawn_ ?? [];
    if (asks.length > 0 && now - this.drawnAsked_ > kDrawnAgain) this.drawnLeft_ = asks.length;
    const count = Math.min(kAtOnce, this.drawnLeft_);
    if (count === 0) return false;
    const next = Array.from({ length: count }, (_, k) => asks[(this.drawnNext_ + k) % asks.length]!);
    this.drawnNext_ = (this.drawnNext_ + count) % asks.length;
    this.drawnLeft_ -= count;
    this.drawnAsked_ = now;
    this.ask(next, 'drawn', now);
    return true;
  }

  /** Asks about the next orders of a queue, where that is due. */
  private askOf(queue: Queue, now: number): boolean {
    if (queue.group.orders.length === 0 || now - queue.asked < kRefresh) return false;
    const asks = queueAsks(queue.group, this.known).slice(queue.next, queue.next + kAtOnce);
    if (asks.length > 0) {
      queue.next += kAtOnce;
      this.ask(asks, 'queue', now);
      return true;
    }
    [queue.asked, queue.next] = [now, 0];
    const back = returnAsk(queue.group, this.known);
    if (back) this.ask([back], 'return', now);
    return back !== null;
  }

  /** Begins the round of questions about its queue again. */
  private lost({ subject, group }: Question): void {
    this.open_ = null;
    const queue = this.queues_.get(group);
    if (queue && subject !== 'drawn') [queue.asked, queue.next] = [-Infinity, 0];
  }

  private ask(asks: readonly ForecastAsk[], subject: Subject, now: number): void {
    this.open_ = { number: ++this.number_, subject, group: asks[0]!.group, asked: now, orders: asks.length };
    this.free_ = now + kPause + kPausePerOrder * asks.length;
    this.client_.send({ type: 'AskForecasts', number: this.number_, asks: [...asks] });
  }

  private forgetDone(groups: readonly Asker[]): void {
    const there = new Set(groups.flatMap(({ orders }) => orders.map(({ id }) => id)));
    for (const id of this.known.keys()) if (!there.has(id)) this.known.delete(id);
  }
}
