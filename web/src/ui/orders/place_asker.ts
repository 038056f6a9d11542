// Asks the server where everybody would stand, and who could not get there. One question is out at a time; of wishes
// that come meanwhile only the newest is asked.

import type { MessageSender } from '../../link/studio_client';
import type { Places, PlacesAsk, PlacesFrame } from '../../protocol/messages';

/** The client, as far as questions about places need it. */
export interface PlacesLink extends MessageSender {
  on(event: 'places', listener: (message: Places) => void): void;
}

/** Between two questions, and more for each group asked about [ms]. */
const kPause = 60;
const kPausePerGroup = 30;
/** A question without an answer for so long is forgotten [ms]. */
const kLost = 1500;
/** Groups asked about at once. */
const kMostGroups = 16;

interface Wish {
  readonly asks: readonly PlacesAsk[];
  readonly done: (answers: readonly PlacesFrame[]) => void;
}

/** Askers of one page number their questions together, so that each knows its own answers. */
let lastNumber = 0;

export class PlaceAsker {
  private wish_: Wish | null = null;
  private open_: (Wish & { readonly number: number }) | null = null;
  private timer_: ReturnType<typeof setTimeout> | null = null;

  constructor(private readonly link_: PlacesLink) {
    link_.on('places', (message) => this.answered(message));
  }

  /** Asks soon; `done` hears the answers unless another wish has come by then. */
  ask(asks: readonly PlacesAsk[], done: Wish['done']): void {
    this.wish_ = { asks: asks.slice(0, kMostGroups), done };
    if (this.timer_ === null) this.next();
  }

  /** Nobody wants to know any more. */
  drop(): void {
    this.wish_ = null;
    if (this.open_) this.open_ = { ...this.open_, done: () => undefined };
  }

  private next(): void {
    const wish = this.wish_;
    this.wish_ = null;
    this.timer_ = null;
    if (!wish || wish.asks.length === 0) return;
    this.open_ = { ...wish, number: ++lastNumber };
    this.link_.send({ type: 'AskPlaces', number: lastNumber, asks: [...wish.asks] });
    this.wait(kLost);
  }

  private answered({ number, answers }: Places): void {
    const open = this.open_;
    if (open?.number !== number) return;
    this.open_ = null;
    this.wait(kPause + kPausePerGroup * open.asks.length);
    open.done(answers);
  }

  private wait(ms: number): void {
    if (this.timer_ !== null) clearTimeout(this.timer_);
    this.timer_ = setTimeout(() => this.next(), ms);
  }
}
