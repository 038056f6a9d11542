// Strokes over the scene while somebody builds: what they choose, drag and draw.

import type { GroundPoint, ScreenPoint } from '../../model/plane';
import { drawn, polygonThing, type BuildTool, type DrawingOptions } from '../../model/place/drawing';
import { crossesItself, gripAt, hasCorners, withCorner, withoutCorner, type Grip } from '../../model/place/corners';
import { queued } from '../../model/place/areas';
import { aligned, type Guide } from '../../model/place/guides';
import { carAlong, routed } from '../../model/place/routes';
import { rightAngled, snapped } from '../../model/place/snap';
import * as things from '../../model/place/things';
import type { Thing } from '../../model/place/things';
import type { BuildStroke, BuildStrokes } from '../../tools/build_pointer';
import { handlesOf } from './build_layer';

/** What strokes work on. */
export interface StrokeHost {
  readonly tool: BuildTool;
  readonly options: DrawingOptions;
  readonly snaps: boolean;
  /** Of the world [s]. */
  readonly time: number;
  /** All things, and those that can be taken. */
  readonly all: readonly Thing[];
  readonly free: readonly Thing[];
  chosen: readonly Thing[];
  preview: readonly Thing[];
  add(label: string, made: readonly Thing[]): void;
  change(label: string, changed: readonly Thing[]): void;
  openWall(at: GroundPoint): void;
  /** A drag begins. The world follows it, and all of it is one step of the history. */
  dragBegins(): void;
  drag(label: string, changed: readonly Thing[]): void;
  dragEnds(label: string, changed: readonly Thing[]): void;
  /** The drag is given up: all is as it was before. */
  dragCancelled(label: string, before: readonly Thing[]): void;
  setTool(tool: BuildTool): void;
  say(text: string): void;
  undo(): void;
  toScreen(point: GroundPoint): ScreenPoint;
  metres(px: number): number;
}

/** Moves, scales or turns things about the middle that they had, or pulls at a corner. */
interface Handling {
  readonly does: 'move' | 'scale' | 'turn' | 'corner';
  readonly from: GroundPoint;
  readonly before: readonly Thing[];
  readonly about: GroundPoint;
  readonly grip: Grip;
}

/** What a stroke does. */
type Drag = Handling | { readonly does: 'draw' | 'box' | 'lasso' | 'route'; readonly from: GroundPoint };

/** Handles are taken from so near [CSS px]. */
const kReach = { touch: 26, mouse: 14 };

const kWords = { move: 'Move', scale: 'Scale', turn: 'Turn', corner: 'Move corner' } as const;
/** Obstacles and patches move along a route; at an exit people queue along it. */
function takesRoute({ kind, area }: Thing): boolean {
  return kind === 'obstacle' || kind === 'patch' || area?.kind === 'exit';
}

/** The cursor has not moved from a corner, which snapping may have moved [m]. */
const kOneSpot = 0.36;

const kCrosses = 'An outline must not cross itself.';

export class BuildStroking implements BuildStrokes {
  /** A line, box or lasso that is being drawn. */
  line: GroundPoint[] = [];
  /** Of the polygon that is being drawn. */
  corners: GroundPoint[] = [];
  /** Of what is chosen: the corner that was tapped; -1 for none. */
  tapped = -1;
  /** What is moved lines up along these. */
  guides: readonly Guide[] = [];
  private drag_: Drag | null = null;

  constructor(private readonly host_: StrokeHost) {}

  get busy(): boolean {
    return this.drag_ !== null || this.corners.length > 0;
  }

  /** Things are being moved, scaled or turned. */
  get dragging(): boolean {
    return this.drag_ !== null && 'before' in this.drag_;
  }

  /** The line that is shown is a loop. */
  get closed(): boolean {
    return this.drag_?.does === 'box' || this.drag_?.does === 'lasso';
  }

  /** Drops what is being drawn. */
  drop(): void {
    this.cancel();
    this.corners = [];
  }

  /** Enter ends the polygon that is being drawn: without a cursor anywhere, else on its last corner. */
  ends(cursor: GroundPoint | null): boolean {
    const last = this.corners[this.corners.length - 1];
    return last !== undefined && (!cursor || Math.hypot(last.x - cursor.x, last.y - cursor.y) < kOneSpot);
  }

  finishPolygon(): void {
    const corners = this.corners.map(({ x, y }) => [x, y] as const);
    this.corners = [];
    const made = polygonThing(corners, this.host_.options.height);
    if (made) this.host_.add('Add polygon', [made]);
  }

  private handle(does: Handling['does'], from: GroundPoint, grip: Grip = { index: 0, isNew: false }): void {
    const before = this.host_.chosen;
    this.drag_ = { does, from, before, about: things.middleOfAll(before) ?? from, grip };
    this.host_.dragBegins();
  }

  private snap(stroke: BuildStroke): GroundPoint {
    if (!this.host_.snaps || stroke.free) return stroke.ground;
    const others = this.host_.all.filter((one) => !this.host_.chosen.some((chosen) => things.sameThing(chosen, one)));
    return snapped(stroke.ground, others, this.host_.metres(12));
  }

  private handleAt({ screen, touch }: BuildStroke): 'scale' | 'turn' | null {
    const extent = things.extentOf(this.host_.chosen);
    if (!extent) return null;
    const handles = handlesOf(extent, this.host_);
    const near = (at: ScreenPoint): boolean =>
      Math.hypot(at.x - screen.x, at.y - screen.y) <= (touch ? kReach.touch : kReach.mouse);
    return near(handles.scale) ? 'scale' : near(handles.turn) ? 'turn' : null;
  }

  begin(stroke: BuildStroke): void {
    const from = this.snap(stroke);
    if (this.host_.tool === 'select') return this.beginSelect(stroke);
    if (this.host_.tool === 'polygon') return;
    if (this.host_.tool === 'car') return this.beginRoute(stroke.ground);
    if (this.host_.tool === 'route') {
      const found = things.hit(this.host_.free, stroke.ground, this.host_.metres(12));
      const mover = found && takesRoute(found) ? found : this.host_.chosen.find(takesRoute);
      if (!mover) return this.host_.say('Begin on the thing that shall move, or on the exit of a queue.');
      this.host_.chosen = [mover];
      return this.beginRoute(stroke.ground);
    }
    this.drag_ = { does: 'draw', from };
  }

  private beginRoute(from: GroundPoint): void {
    this.drag_ = { does: 'route', from };
    this.line = [from];
  }

  private gripOf({ screen, touch }: BuildStroke): Grip | null {
    const [one] = this.host_.chosen;
    if (!one || !hasCorners(this.host_.chosen)) return null;
    return gripAt(one, screen, (point) => this.host_.toScreen(point), touch ? 22 : 10);
  }

  /** Takes away the corner that was tapped; false where there is none. */
  removeCorner(): boolean {
    const [one] = this.host_.chosen;
    if (this.tapped < 0 || !one) return false;
    const less = withoutCorner(one, this.tapped);
    this.tapped = -1;
    if (!less) this.host_.say('An outline has three corners at least.');
    else if (crossesItself(less)) this.host_.say(kCrosses);
    else this.host_.change('Remove corner', [less]);
    return true;
  }

  private beginSelect(stroke: BuildStroke): void {
    const grip = stroke.shift ? null : this.gripOf(stroke);
    this.tapped = grip && !grip.isNew ? grip.index : -1;
    if (grip) return this.handle('corner', stroke.ground, grip);
    const handle = this.handleAt(stroke);
    if (handle) return this.handle(handle, stroke.ground);
    const found = things.hit(this.host_.free, stroke.ground, this.host_.metres(stroke.touch ? 16 : 6));
    if (!found) {
      this.drag_ = { does: stroke.free ? 'lasso' : 'box', from: stroke.ground };
      this.line = [stroke.ground];
      return;
    }
    const taken = this.host_.chosen.some((one) => things.sameThing(one, found));
    if (stroke.shift && taken) this.host_.chosen = this.host_.chosen.filter((one) => !things.sameThing(one, found));
    else if (stroke.shift) this.host_.chosen = [...this.host_.chosen, found];
    else if (!taken) this.host_.chosen = [found];
    this.handle('move', stroke.ground);
  }

  move(stroke: BuildStroke, still: boolean): void {
    const drag = this.drag_;
    if (!drag) return;
    const { ground } = stroke;
    switch (drag.does) {
      case 'move':
      case 'scale':
      case 'turn':
      case 'corner':
        if (!still) this.handled(drag, this.dragged(drag, stroke));
        break;
      case 'box':
        this.line = [drag.from, { x: ground.x, y: drag.from.y }, ground, { x: drag.from.x, y: ground.y }];
        break;
      case 'lasso':
      case 'route':
        this.line.push(ground);
        break;
      case 'draw': {
        const made = drawn(this.host_.tool, drag.from, this.endOf(drag.from, stroke), this.host_.options);
        this.host_.preview = made ? [made] : [];
      }
    }
  }

  /** Where a drawn line ends: with Shift at a right or half right angle. */
  private endOf(from: GroundPoint, stroke: BuildStroke): GroundPoint {
    return stroke.shift ? rightAngled(from, stroke.ground) : this.snap(stroke);
  }

  private dragged(drag: Handling, stroke: BuildStroke): Thing[] {
    const { about } = drag;
    const { ground } = stroke;
    if (drag.does === 'corner') return drag.before.map((one) => withCorner(one, drag.grip, this.snap(stroke)));
    if (drag.does === 'move')
      return this.carried(drag.before, ground.x - drag.from.x, ground.y - drag.from.y, stroke.free);
    const [from, to] = [drag.from, ground].map((p) => ({ x: p.x - about.x, y: p.y - about.y }));
    if (drag.does === 'scale') {
      const factor = Math.max(0.1, Math.hypot(to!.x, to!.y) / Math.max(0.1, Math.hypot(from!.x, from!.y)));
      return drag.before.map((one) => things.scaled(one, about, factor));
    }
    // The shorter way round.
    const angle = Math.atan2(from!.x * to!.y - from!.y * to!.x, from!.x * to!.x + from!.y * to!.y);
    const step = Math.PI / 12;
    const turn = this.host_.snaps && !stroke.free ? Math.round(angle / step) * step : angle;
    return drag.before.map((one) => things.turned(one, about, turn));
  }

  /** Moved by so much: to lines of others, else by steps of the grid. */
  private carried(before: readonly Thing[], dx: number, dy: number, free: boolean): Thing[] {
    this.guides = [];
    if (free || !this.host_.snaps) return before.map((one) => things.moved(one, dx, dy));
    const others = this.host_.all.filter((one) => !before.some((taken) => things.sameThing(taken, one)));
    const lined = aligned(before, others, dx, dy, this.host_.metres(8));
    this.guides = lined.guides;
    const step = (wished: number, line: number): number => (line === wished ? Math.round(wished * 2) / 2 : line);
    return before.map((one) => things.moved(one, step(dx, lined.dx), step(dy, lined.dy)));
  }

  end(stroke: BuildStroke, still: boolean): void {
    const { drag_: drag, line, host_: host } = this;
    this.drag_ = null;
    this.line = [];
    this.guides = [];
    if (host.tool === 'polygon') return this.corner(stroke);
    if (!drag) return;
    if ('before' in drag) {
      if (!still) this.endHandling(drag, this.dragged(drag, stroke));
      this.guides = [];
    } else if (drag.does === 'route') this.endRoute(line);
    else if (drag.does === 'draw') this.endDrawing(drag.from, stroke);
    else host.chosen = still ? [] : things.within(host.free, line);
  }

  /** An outline that crosses itself is shown, but not told to the server. */
  private handled(drag: Handling, changed: readonly Thing[]): void {
    if (drag.does === 'corner' && changed.some(crossesItself)) this.host_.preview = changed;
    else this.host_.drag(this.labelOf(drag), changed);
  }

  private endHandling(drag: Handling, changed: readonly Thing[]): void {
    if (drag.does === 'corner' && changed.some(crossesItself)) {
      this.host_.preview = [];
      this.host_.dragCancelled(this.labelOf(drag), drag.before);
      return this.host_.say(kCrosses);
    }
    this.host_.dragEnds(this.labelOf(drag), changed);
  }

  private labelOf(drag: Handling): string {
    return drag.does === 'corner' && drag.grip.isNew ? 'Add corner' : kWords[drag.does];
  }

  private endRoute(line: readonly GroundPoint[]): void {
    const { host_: host } = this;
    if (host.tool === 'car') {
      const car = carAlong(line, host.options.speed, host.time);
      return car ? host.add('Add car', [car]) : host.say('Draw the way of the car.');
    }
    const [mover] = host.chosen;
    if (mover?.area) host.change('Queue', [queued(mover, line)]);
    else if (mover) host.change(`Route of ${mover.kind}`, [routed(mover, line, host.options.speed, host.time)]);
    host.setTool('select');
  }

  private endDrawing(from: GroundPoint, stroke: BuildStroke): void {
    const { host_: host } = this;
    if (host.tool === 'door') return host.openWall(stroke.ground);
    const made = drawn(host.tool, from, this.endOf(from, stroke), host.options);
    host.preview = [];
    if (made) host.add(`Add ${host.tool}`, [made]);
  }

  private corner(stroke: BuildStroke): void {
    const last = this.corners[this.corners.length - 1];
    const p = last ? this.endOf(last, stroke) : this.snap(stroke);
    const [first] = this.corners;
    const closes = first && Math.hypot(first.x - p.x, first.y - p.y) < this.host_.metres(16);
    if (closes && this.corners.length >= 3) return this.finishPolygon();
    if (!last || Math.hypot(last.x - p.x, last.y - p.y) > 1e-6) this.corners = [...this.corners, p];
  }

  cancel(): void {
    const drag = this.drag_;
    this.guides = [];
    this.drag_ = null;
    this.line = [];
    this.host_.preview = [];
    if (drag && 'before' in drag) this.host_.dragCancelled(this.labelOf(drag), drag.before);
  }

  doubleTap(): void {
    if (this.host_.tool === 'select') this.removeCorner();
    if (this.host_.tool === 'polygon' && this.corners.length >= 3) this.finishPolygon();
  }

  threeFingers(): void {
    this.host_.undo();
  }
}
