// Shows who cannot be in their places: the camera goes there, and these people and their places are marked.

import type { MessageSender } from '../../link/studio_client';
import type { GroundPoint } from '../../model/plane';
import { standingSum } from '../../model/standing';
import type { StudioStore } from '../../model/studio_store';
import type { Standings } from '../../protocol/messages';
import type { BarredPerson } from '../../scene/marks/barred_marks';

/** Marks vanish after so long [ms]. */
const kShown = 12000;

export interface StandingHost {
  readonly client: MessageSender;
  readonly store: StudioStore;
  mark(people: readonly BarredPerson[]): void;
  frame(points: readonly GroundPoint[]): void;
  lookAt(point: GroundPoint): void;
  say(text: string): void;
}

export class StandingController {
  private number_ = 0;
  private otherwise_: GroundPoint | null = null;
  private timer_ = 0;

  constructor(private readonly host_: StandingHost) {
    host_.store.watch(['standings'], ({ standings }) => {
      if (this.timer_ !== 0 && standingSum(standings).barred === '') this.hide();
    });
  }

  /** Asks who they are; `otherwise`: what is looked at where there is nobody. */
  show(otherwise: GroundPoint | null = null): void {
    this.otherwise_ = otherwise;
    this.host_.client.send({ type: 'AskStandings', number: ++this.number_ });
  }

  answered({ number, people }: Standings): void {
    if (number !== this.number_) return;
    const barred = people.map(({ id, x, y }) => ({ id, place: { x, y } }));
    if (barred.length === 0) {
      if (this.otherwise_) this.host_.lookAt(this.otherwise_);
      return;
    }
    this.host_.mark(barred);
    this.host_.frame(barred.map(({ place }) => place));
    this.host_.say(standingSum(this.host_.store.state.standings).barred);
    window.clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => this.hide(), kShown);
  }

  hide(): void {
    window.clearTimeout(this.timer_);
    this.timer_ = 0;
    this.host_.mark([]);
  }
}
