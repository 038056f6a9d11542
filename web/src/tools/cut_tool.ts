// The cutting tool: a stroke across a formation divides it, one from a formation onto another joins them, and two
// fingers on one formation that are pulled apart divide it between them.

import { cutBy, joinedBy, lineBetween, type Cut, type Cuttable } from '../model/cut';
import { distance, insidePolygon, turn, type GroundPoint } from '../model/plane';
import type { Contact, ContactOwner } from './contact';

/** What is shown until the stroke ends. */
export interface CutPreview {
  /** The line, and the formation that it cuts or joins; -1 for none. */
  readonly line: readonly GroundPoint[];
  readonly index: number;
  /** The places that leave. */
  readonly leaving: readonly GroundPoint[];
  /** The formation that the other one is dragged onto. */
  readonly onto: readonly GroundPoint[];
}

export interface CutSink {
  formations(): readonly Cuttable[];
  previewCut(preview: CutPreview | null): void;
  split(cut: Cut): void;
  merge(into: number, dragged: number): void;
  /** The stroke did nothing, and why. */
  missed(reason: string): void;
}

/** Two fingers pull a formation apart when they are so many times as far from each other as when both were down. */
const kApart = 1.6;
const kHalfLine = 60;
/** A stroke shorter than this is a tap [CSS px]. */
const kTapPx = 12;

interface Finger {
  from: GroundPoint;
  at: GroundPoint;
}

export class CutTool {
  private readonly strokes_ = new Map<number, CutStroke>();

  constructor(private readonly sink_: CutSink) {}

  owner(): ContactOwner {
    return new CutStroke(this.sink_, this.strokes_);
  }

  abort(): void {
    for (const stroke of this.strokes_.values()) stroke.abort();
    this.sink_.previewCut(null);
  }
}

class CutStroke implements ContactOwner {
  private points_: GroundPoint[] = [];
  private start_: Contact | null = null;
  /** The other finger, once both pull one formation apart. */
  private partner_: CutStroke | null = null;
  private apartFrom_ = 0;

  constructor(
    private readonly sink_: CutSink,
    private readonly all_: Map<number, CutStroke>,
  ) {}

  begin(contact: Contact): void {
    this.start_ = contact;
    if (contact.ground) this.points_ = [contact.ground];
    const partner = [...this.all_.values()].find((one) => one.partner_ === null && one.points_.length > 0);
    this.all_.set(contact.pointer, this);
    if (partner && contact.ground && this.sharesFormation(partner, contact.ground)) {
      this.pairWith(partner);
      partner.pairWith(this);
    }
  }

  move(contacts: readonly Contact[]): void {
    if (this.points_.length === 0) return;
    for (const { ground } of contacts) if (ground) this.points_.push(ground);
    this.show();
  }

  end(contact: Contact, cancelled: boolean): void {
    this.all_.delete(contact.pointer);
    const partner = this.partner_;
    if (!cancelled && this.points_.length > 0) {
      if (partner) this.endPair(partner);
      else this.endStroke(contact);
    }
    if (partner) partner.abort();
    this.abort();
    this.sink_.previewCut(null);
  }

  abort(): void {
    this.points_ = [];
    this.partner_ = null;
  }

  private get finger(): Finger | null {
    const [from, at] = [this.points_[0], this.points_[this.points_.length - 1]];
    return from && at ? { from, at } : null;
  }

  private pairWith(partner: CutStroke): void {
    this.partner_ = partner;
    const [a, b] = [this.finger, partner.finger];
    if (a && b) this.apartFrom_ = distance(a.at, b.at);
  }

  /** Both fingers are on one formation, and neither has drawn a stroke yet. */
  private sharesFormation(partner: CutStroke, at: GroundPoint): boolean {
    const other = partner.finger;
    if (!other) return false;
    return this.sink_
      .formations()
      .some(({ outline }) => insidePolygon(at, outline) && insidePolygon(other.at, outline));
  }

  /** The line between both fingers, as they came down; null until they are far enough apart. */
  private pairLine(partner: CutStroke): readonly [GroundPoint, GroundPoint] | null {
    const [a, b] = [this.finger, partner.finger];
    if (!a || !b || this.apartFrom_ === 0) return null;
    return distance(a.at, b.at) >= kApart * this.apartFrom_ ? lineBetween(a.from, b.from, kHalfLine) : null;
  }

  private endPair(partner: CutStroke): void {
    const line = this.pairLine(partner);
    const cut = line && cutBy(line, this.sink_.formations());
    if (cut) this.split(cut);
  }

  private endStroke({ screen }: Contact): void {
    const start = this.start_;
    if (start && Math.hypot(screen.x - start.screen.x, screen.y - start.screen.y) < kTapPx) return;
    const formations = this.sink_.formations();
    const joined = joinedBy(this.points_, formations);
    if (joined) return this.sink_.merge(joined.onto.group, joined.dragged.group);
    const cut = cutBy(this.points_, formations);
    if (cut) return this.split(cut);
    this.sink_.missed('The stroke crosses no formation: draw it from one side to the other');
  }

  private split(cut: Cut): void {
    if (cut.left === 0 || cut.right === 0) this.sink_.missed('The stroke leaves nobody on one side');
    else this.sink_.split(cut);
  }

  private show(): void {
    const formations = this.sink_.formations();
    const pair = this.partner_ && this.pairLine(this.partner_);
    if (this.partner_ && !pair) return this.sink_.previewCut(null);
    const stroke = pair ?? this.points_;
    const line = pair ?? [stroke[0], stroke[stroke.length - 1]!];
    const joined = pair ? null : joinedBy(stroke, formations);
    if (joined) {
      const { dragged, onto } = joined;
      return this.sink_.previewCut({ line, index: dragged.index, leaving: [], onto: onto.outline });
    }
    const cut = cutBy(stroke, formations);
    const places = formations.find((one) => one.group === cut?.group)?.places ?? [];
    const leaving = cut ? places.filter((place) => turn(cut.from, cut.to, place) > 0) : [];
    this.sink_.previewCut({
      line: cut && pair ? clipped(line, places) : line,
      index: cut?.index ?? -1,
      leaving,
      onto: [],
    });
  }
}

/** The part of a long line near these places. */
function clipped(line: readonly GroundPoint[], places: readonly GroundPoint[]): readonly GroundPoint[] {
  const [a, b] = [line[0]!, line[1]!];
  const length = distance(a, b);
  const along = places.map((p) => ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length);
  if (along.length === 0) return line;
  const at = (t: number): GroundPoint => ({ x: a.x + ((b.x - a.x) * t) / length, y: a.y + ((b.y - a.y) * t) / length });
  return [at(Math.min(...along) - 2), at(Math.max(...along) + 2)];
}
