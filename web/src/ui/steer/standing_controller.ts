// Tells of groups that are in place, and shows who cannot be: the camera goes there, and these people and their places
// are marked.

import type { MessageSender } from '../../link/studio_client';
import { ArrivalWatch } from '../../model/arrival_watch';
import type { GroundPoint } from '../../model/plane';
import { standingSum } from '../../model/standing';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import { NoticeLevel, type Standings } from '../../protocol/messages';
import type { BarredPerson } from '../../scene/marks/barred_marks';

/** Marks vanish after so long [ms]. */
const kShown = 12000;
/** An arrival after a longer way is told of on the screen where it is out of sight [s]. */
const kLongWay = 10;

interface StandingLink extends MessageSender {
  on(event: 'standings', listener: (answer: Standings) => void): void;
}

interface StandingScene {
  readonly orders: { setBarred(people: readonly BarredPerson[]): void };
}

interface StandingCamera {
  frame(points: readonly GroundPoint[]): void;
  lookAt(point: GroundPoint): void;
}

export class StandingController {
  private readonly arrivals_ = new ArrivalWatch();
  private number_ = 0;
  private otherwise_: GroundPoint | null = null;
  private timer_: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly client_: StandingLink,
    private readonly store_: StudioStore,
    private readonly scene_: StandingScene,
    private readonly camera_: StandingCamera,
    private readonly say_: (text: string) => void,
  ) {
    client_.on('standings', (answer) => this.answered(answer));
    store_.watch(['standings'], ({ standings }) => {
      if (this.timer_ !== undefined && standingSum(standings).barred === '') this.hide();
    });
  }

  forgetWorld(): void {
    this.arrivals_.clear();
    this.hide();
  }

  /** A crowd that nobody watched come is told of on the screen; others are seen. */
  observe(frame: StudioFrame): void {
    for (const { id, index, seconds, x, y } of this.arrivals_.observe(frame)) {
      const { groups, arrows } = this.store_.state;
      const text = `${groups[index]?.name ?? 'The group'}: everybody is in place`;
      this.say_(text);
      if (seconds < kLongWay || !arrows.some((arrow) => arrow.id === id)) continue;
      const about = { code: 'arrived', text: `${text}.`, hasPlace: true, x, y };
      this.store_.set({ notice: { type: 'Notice', level: NoticeLevel.Info, ...about } });
    }
  }

  /** Asks who cannot be in their places; `otherwise`: what is looked at where there is nobody. */
  show(otherwise: GroundPoint | null = null): void {
    this.otherwise_ = otherwise;
    this.client_.send({ type: 'AskStandings', number: ++this.number_ });
  }

  private answered({ number, people }: Standings): void {
    if (number !== this.number_) return;
    const barred = people.map(({ id, x, y }) => ({ id, place: { x, y } }));
    if (barred.length === 0) {
      if (this.otherwise_) this.camera_.lookAt(this.otherwise_);
      return;
    }
    this.scene_.orders.setBarred(barred);
    this.camera_.frame(barred.map(({ place }) => place));
    this.say_(standingSum(this.store_.state.standings).barred);
    clearTimeout(this.timer_);
    this.timer_ = setTimeout(() => this.hide(), kShown);
  }

  private hide(): void {
    clearTimeout(this.timer_);
    this.timer_ = undefined;
    this.scene_.orders.setBarred([]);
  }
}
