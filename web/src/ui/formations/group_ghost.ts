// A new group on the ground, where the pointer is, before it is put down: its places, those marked where nobody can stand.

import { Standing } from '../../protocol/messages';
import type { GroundPoint } from '../../model/plane';
import type { NewGroup } from '../../model/shape_actions';
import { movedStand, standOf, takenPlaces, unfitCount, type Stand, type StandWords } from '../../model/stand';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import { PlaceAsker, type PlacesLink } from '../orders/place_asker';
import type { StandScene } from './stand_preview';

export interface GhostHost {
  readonly client: PlacesLink;
  readonly store: StudioStore;
  readonly orders: StandScene;
}

/** Why nobody can stand at a place, whatever leads there. */
const kNoRoom: readonly number[] = [Standing.Outside, Standing.Obstacle, Standing.Narrow];

/** A place is taken where somebody stands nearer than this share of the spacing. */
const kTaken = 0.8;

export class GroupGhost {
  private readonly asker_: PlaceAsker;
  private stand_: Stand | null = null;
  private at_: GroundPoint | null = null;

  constructor(
    private readonly host_: GhostHost,
    private readonly group_: NewGroup,
  ) {
    this.asker_ = new PlaceAsker(host_.client);
  }

  /** The places follow the pointer at once; which of them are free is asked. */
  show(at: GroundPoint, frame: StudioFrame): void {
    // The server knows the ground as some group sees it.
    const known = frame.groups[0];
    if (!known) return;
    if (this.stand_ && this.at_) this.draw(movedStand(this.stand_, at.x - this.at_.x, at.y - this.at_.y));
    this.at_ = at;
    const { count, formation: kind, spacing } = this.group_;
    const pose = { x: at.x, y: at.y, facing: 0 };
    const ask = { group: known.id, formation: { kind, spacing }, ...pose, places: new Float64Array(0), count };
    this.asker_.ask([ask], ([answer]) => {
      if (!answer || !this.at_) return;
      if (answer.problem) return this.tell({ text: answer.problem, warns: true });
      const stand = standOf(answer, frame.groups.length, pose);
      const taken = takenPlaces(stand.places, frame, kTaken * spacing);
      // Where no way leads from that group, a new one can stand.
      const unfit = taken.map((one, k) => one || Number(kNoRoom.includes(stand.unfit[k]!)));
      const bad = unfitCount(unfit);
      this.tell(
        bad > 0
          ? { text: `${bad} of ${count} spots are not free`, warns: true }
          : { text: 'All spots are free', warns: false },
      );
      const now = this.at_;
      this.draw(movedStand({ ...stand, unfit }, now.x - pose.x, now.y - pose.y));
    });
  }

  hide(): void {
    this.stand_ = this.at_ = null;
    this.asker_.drop();
    this.host_.orders.previewOrder(null);
    this.host_.store.set({ stand: null });
  }

  private draw(stand: Stand): void {
    this.stand_ = stand;
    this.host_.orders.previewOrder({ moves: [stand], rectangle: [], route: [] });
  }

  private tell(stand: StandWords): void {
    this.host_.store.set({ stand });
  }
}
