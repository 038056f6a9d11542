// Owners of contacts that give orders: a drag for place, facing and width, a drawn way, a rectangle to guard, a leader
// to follow, an exit to leave by, an area to wait in.

import { planLine, planPoint, planRoute, type OrderedGroup, type PlannedMove } from '../model/order_plan';
import { distance, type GroundPoint } from '../model/plane';
import type { CameraGesture } from './camera_gesture';
import type { Contact, ContactOwner } from './contact';

/** What is shown until the contact ends. */
export interface OrderPreview {
  readonly moves: readonly PlannedMove[];
  /** The corners of a rectangle to guard. */
  readonly rectangle: readonly GroundPoint[];
  /** A drawn way. */
  readonly route: readonly GroundPoint[];
}

export interface OrderSink {
  /** The groups that get orders. */
  groups(): readonly OrderedGroup[];
  /** `contact`: with its keys; left out where nothing is drawn. */
  previewOrder(preview: OrderPreview | null, contact?: Contact): void;
  /** `contact`: with its keys. */
  move(moves: readonly PlannedMove[], contact: Contact): void;
  guard(centre: GroundPoint, halfSize: GroundPoint, facing: number, contact: Contact): void;
  follow(at: GroundPoint, contact: Contact): void;
  /** By the exit at the point, else by any. */
  leave(at: GroundPoint, contact: Contact): void;
  /** In the area at the point. */
  wait(at: GroundPoint, contact: Contact): void;
  /** True where a chosen group's mesh lies under the point. */
  isChosenAt(at: GroundPoint): boolean;
}

/** A contact that stays within this is a click [CSS px]. */
const kClickPx = 12;
/** A front is at least so wide [m]. */
const kShortestFront = 1;
const kLeastSide = 1;

const kNothing: OrderPreview = { moves: [], rectangle: [], route: [] };

/** Ends early where a second finger comes: both then move the camera. */
export abstract class OrderGesture implements ContactOwner {
  protected from: GroundPoint | null = null;
  protected start: Contact | null = null;
  private last_: Contact | null = null;
  private toCamera_ = false;

  constructor(
    protected readonly sink: OrderSink,
    private readonly camera_: CameraGesture,
    private readonly ended_: () => void,
  ) {}

  begin(contact: Contact): void {
    this.from = contact.ground;
    this.start = this.last_ = contact;
    this.began();
  }

  move(contacts: readonly Contact[]): void {
    if (this.toCamera_) return this.camera_.move(contacts);
    this.last_ = contacts[contacts.length - 1] ?? this.last_;
    if (this.from) this.moved(contacts);
  }

  end(contact: Contact, cancelled: boolean): void {
    if (this.toCamera_) return this.camera_.end(contact);
    this.sink.previewOrder(null);
    if (!cancelled && this.from) this.done(contact);
    this.from = null;
    this.ended_();
  }

  /** Drops the order; the contact goes on as one of the camera's. */
  giveToCamera(): void {
    if (this.toCamera_ || !this.last_) return;
    this.abort();
    this.toCamera_ = true;
    this.camera_.begin(this.last_);
  }

  abort(): void {
    this.from = null;
    this.sink.previewOrder(null);
  }

  protected stillAt({ screen }: Contact): boolean {
    const { start } = this;
    return !start || Math.hypot(screen.x - start.screen.x, screen.y - start.screen.y) < kClickPx;
  }

  protected began(): void {}
  protected abstract moved(contacts: readonly Contact[]): void;
  protected abstract done(contact: Contact): void;
}

/** A click moves there; a drag is the front from its left to its right end. */
export class OrderDrag extends OrderGesture {
  /** `tapped`: what a tap does instead of moving there. */
  constructor(
    sink: OrderSink,
    camera: CameraGesture,
    ended: () => void,
    private readonly tapped_: ((add: boolean) => void) | null = null,
  ) {
    super(sink, camera, ended);
  }

  protected override began(): void {
    if (this.from && !this.tapped_)
      this.sink.previewOrder({ ...kNothing, moves: planPoint(this.sink.groups(), this.from) }, this.start ?? undefined);
  }

  protected moved(contacts: readonly Contact[]): void {
    const contact = contacts[contacts.length - 1]!;
    const plan = this.plan(contact);
    if (plan) this.sink.previewOrder({ ...kNothing, moves: plan }, contact);
  }

  protected done(contact: Contact): void {
    if (this.tapped_ && this.stillAt(contact)) return this.tapped_(contact.shift);
    const plan = this.plan(contact);
    if (plan && plan.length > 0) this.sink.move(plan, contact);
  }

  private plan(contact: Contact): readonly PlannedMove[] | null {
    const { from } = this;
    const to = contact.ground;
    if (!from || !to) return null;
    const click = this.stillAt(contact) || distance(from, to) < kShortestFront;
    return click ? planPoint(this.sink.groups(), from) : planLine(this.sink.groups(), from, to);
  }
}

/** Drawn from a chosen formation: the way that it shall go. */
export class RouteDrag extends OrderGesture {
  private readonly drawn_: GroundPoint[] = [];

  protected override began(): void {
    if (this.from) this.drawn_.push(this.from);
  }

  protected moved(contacts: readonly Contact[]): void {
    for (const { ground } of contacts) if (ground) this.drawn_.push(ground);
    const moves = planRoute(this.sink.groups(), this.drawn_);
    this.sink.previewOrder({ ...kNothing, moves, route: this.drawn_ }, contacts[contacts.length - 1]);
  }

  protected done(contact: Contact): void {
    if (this.stillAt(contact)) return;
    const plan = planRoute(this.sink.groups(), this.drawn_);
    if (plan.length > 0) this.sink.move(plan, contact);
  }
}

/** From corner to corner. */
export class GuardDrag extends OrderGesture {
  protected moved(contacts: readonly Contact[]): void {
    const contact = contacts[contacts.length - 1]!;
    const to = contact.ground;
    if (this.from && to) this.sink.previewOrder({ ...kNothing, rectangle: rectangle(this.from, to) }, contact);
  }

  protected done(contact: Contact): void {
    const { from } = this;
    const to = contact.ground;
    if (!from || !to) return;
    const centre = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
    const half = { x: Math.abs(to.x - from.x) / 2, y: Math.abs(to.y - from.y) / 2 };
    if (half.x < kLeastSide / 2 || half.y < kLeastSide / 2) return;
    this.sink.guard(centre, half, 0, contact);
  }
}

/** A press on the group to follow, the exit to leave by, or the area to wait in. */
export class GoalPick extends OrderGesture {
  constructor(
    sink: OrderSink,
    camera: CameraGesture,
    ended: () => void,
    private readonly does_: 'follow' | 'leave' | 'wait',
  ) {
    super(sink, camera, ended);
  }

  protected moved(): void {}

  protected done(contact: Contact): void {
    if (contact.ground) this.sink[this.does_](contact.ground, contact);
  }
}

function rectangle(a: GroundPoint, b: GroundPoint): GroundPoint[] {
  return [a, { x: b.x, y: a.y }, b, { x: a.x, y: b.y }];
}
