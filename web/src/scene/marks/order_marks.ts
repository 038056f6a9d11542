// Queues of orders as drawn ways: lines with arrow heads, a numbered point per order, and how the group will stand at the
// end. Orders that are being drawn are shown the same way, with all places.

import type { GroupView } from '../../model/frame_view';
import { targetOf, type QueueOrder } from '../../model/queue_order';
import { isPlaceless } from '../../model/goals';
import { frontLine, outlineOf, placed, widened, type GroupShapes } from '../../model/group_shapes';
import { distance, pointsOf, type GroundPoint, type ScreenPoint } from '../../model/plane';
import type { CameraController } from '../camera/camera_controller';
import { accentColour, casingOf, inkOn, type Palette } from '../drawing/palette';
import type { BarredPicture } from './barred_marks';
import type { MarkExtent } from './mark_extent';
import type { MarkColours, MarkPainter } from './mark_painter';
import { changesShape, drawStations, stationSpots } from './station_marks';
import { drawPlaces, roomFor, wordsOf, type Words } from './stand_marks';
import type { SchemePicture } from './scheme_marks';

/** How one group would stand. */
export interface StandPreview {
  readonly index: number;
  readonly places: readonly GroundPoint[];
  readonly outline: readonly GroundPoint[];
  /** Left and right end; left out where that is not known. */
  readonly front?: readonly [GroundPoint, GroundPoint];
  /** Per place: 0 where somebody can stand there; left out where that is not known. */
  readonly unfit?: ArrayLike<number>;
}

/** What is being drawn; empty lists for nothing. */
export interface DrawnOrder {
  readonly moves: readonly StandPreview[];
  readonly rectangle: readonly GroundPoint[];
  readonly route: readonly GroundPoint[];
  /** What is said of the places. */
  readonly note?: { readonly text: string; readonly warns: boolean };
}

/** What would come of an order that is being drawn. */
export interface DrawnForecast {
  readonly index: number;
  readonly way: readonly GroundPoint[];
  /** False where the way ends short of the target. */
  readonly arrives: boolean;
  /** When it would arrive, or that it would not. */
  readonly text: string;
}

/** A stroke of the cutting tool. */
export interface DrawnCut {
  readonly line: readonly GroundPoint[];
  readonly index: number;
  readonly leaving: readonly GroundPoint[];
  readonly onto: readonly GroundPoint[];
}

type Ways = ReadonlyMap<number, readonly GroundPoint[]>;

export interface OrderScene {
  readonly camera: CameraController;
  readonly palette: Palette;
  readonly colours: readonly number[];
  readonly greyed: boolean;
  readonly groups: readonly GroupView[];
  readonly shapes: GroupShapes;
  /** Ids of the groups that get orders: their ways are drawn fully, others' faintly. */
  readonly selected: ReadonlySet<number>;
  readonly queues: boolean;
  readonly drawn: DrawnOrder | null;
  readonly forecasts: readonly DrawnForecast[];
  /** Ways of orders that wait, by their ids, as far as they are known. */
  readonly ways: Ways;
  /** Ways of patrols back to their first orders, by groups. */
  readonly returns: Ways;
  /** The order that is chosen in the list of the queue; 0 for none. */
  readonly picked: number;
  readonly cut: DrawnCut | null;
  /** Of the keys. */
  readonly cursor: GroundPoint | null;
  readonly scheme: SchemePicture | null;
  /** People who cannot be in their places, while they are shown. */
  readonly barred: readonly BarredPicture[];
}

const kOthersAlpha = 0.42;
/** Arrow heads on long legs stand so far apart [CSS px]. */
const kArrowGap = 120;
/** An order's point is drawn this far from its group, or not at all [m]. */
const kReached = 0.4;
/** Round the badge of the picked order, as a share of a finger's ring. */
const kPickedRing = 0.62;
/** Labels stand so far above what they tell of [CSS px]. */
const kLabelGap = 20;

/** A stretch of a way, and the order at its end. */
interface Leg {
  readonly order: QueueOrder;
  readonly points: readonly GroundPoint[];
  readonly facing: number;
}

/** The legs of a queue, from where the group stands; by straight lines where ways are not known. */
export function legsOf(group: GroupView, groups: readonly GroupView[], ways: Ways = new Map()): Leg[] {
  let from: GroundPoint = { x: group.x, y: group.y };
  let facing = group.facing;
  return group.orders.map((order, k) => {
    const leader = order.kind === 'follow' ? groups.find(({ id }) => id === order.group) : undefined;
    const end = order.kind === 'face' || isPlaceless(order) ? from : (leader ?? targetOf(order));
    const between = k === 0 ? pointsOf(group.way) : (ways.get(order.id) ?? order.route.map(([x, y]) => ({ x, y })));
    const points = [from, ...between, { x: end.x, y: end.y }].filter(
      (point, i, all) => i === 0 || distance(point, all[i - 1]!) > 0.05,
    );
    const [a, b] = [points[points.length - 2], points[points.length - 1]!];
    facing = order.facing ?? (a ? Math.atan2(b.y - a.y, b.x - a.x) : facing);
    from = b;
    return { order, points, facing };
  });
}

export class OrderMarks {
  constructor(private readonly painter_: MarkPainter) {}

  extend(extent: MarkExtent, scene: OrderScene): void {
    const add = ({ x, y }: GroundPoint): void => extent.add(scene.camera.worldToScreen(x, y));
    for (const group of scene.queues ? scene.groups : []) {
      this.pointsOf(group, scene).forEach(add);
      for (const spot of stationSpots(legsOf(group, scene.groups, scene.ways), scene.camera)) extent.add(spot);
    }
    const { drawn, cut } = scene;
    if (drawn) this.extendDrawn(extent, drawn, scene);
    for (const points of [cut?.line, cut?.leaving, cut?.onto]) points?.forEach(add);
  }

  private extendDrawn(extent: MarkExtent, drawn: DrawnOrder, scene: OrderScene): void {
    const add = ({ x, y }: GroundPoint): void => extent.add(scene.camera.worldToScreen(x, y));
    for (const move of drawn.moves) [...move.outline, ...(move.front ?? [])].forEach(add);
    for (const points of [drawn.rectangle, drawn.route, ...scene.forecasts.map(({ way }) => way)]) points.forEach(add);
    const words = wordsOf(scene);
    if (!words) return;
    const { x, y } = this.labelSpot(scene, words);
    for (const dx of [-1, 1]) extent.add({ x: x + dx * words.half, y });
  }

  /** All that is drawn of a group's queue. */
  private pointsOf(group: GroupView, scene: OrderScene): GroundPoint[] {
    const points: GroundPoint[] = group.held ? [group] : [];
    for (const leg of legsOf(group, scene.groups, scene.ways)) {
      points.push(...leg.points, ...(this.ghost(group, leg, scene)?.outline ?? []));
      if (leg.order.kind === 'guard') points.push(...rectangleOf(leg.order));
    }
    return points;
  }

  draw(scene: OrderScene): void {
    if (scene.queues) {
      // The chosen ones' above the others'.
      for (const chosen of [false, true]) {
        scene.groups.forEach((group, index) => {
          if (scene.selected.has(group.id) === chosen) this.drawQueue(group, index, scene);
        });
      }
    }
    this.painter_.alpha = 1;
    if (scene.drawn) this.drawPreview(scene.drawn, scene);
    if (scene.cut) this.drawCut(scene.cut, scene);
  }

  private coloursOf(index: number, { palette, colours, greyed }: OrderScene): MarkColours {
    const accent = index < 0 ? palette.ink2 : accentColour(palette, colours[index] ?? index);
    if (greyed) return { accent: palette.obstacleEdge, casing: palette.casing };
    return { accent, casing: casingOf(palette, accent) };
  }

  private screen(points: readonly GroundPoint[], { camera }: OrderScene): ScreenPoint[] {
    return points.map(({ x, y }) => camera.worldToScreen(x, y));
  }

  private drawQueue(group: GroupView, index: number, scene: OrderScene): void {
    const legs = legsOf(group, scene.groups, scene.ways);
    const colours = this.coloursOf(index, scene);
    const { painter_: painter } = this;
    painter.alpha = scene.selected.has(group.id) ? 1 : kOthersAlpha;
    const last = legs[legs.length - 1];
    if (group.patrols && legs.length > 1 && last) this.drawReturn(group.id, last, legs[0]!, colours, scene);
    for (const leg of legs) this.drawLeg(leg, colours, scene);
    // How it stands in a formation that it takes up on the way is not known here.
    if (last && !changesShape(legs)) this.drawGhost(group, last, colours, scene);
    for (const { order } of legs) if (order.kind === 'guard') this.drawGuard(order, colours, scene);
    this.drawNumbers(group, legs, colours, scene);
    drawStations(painter, legs, colours, scene);
    if (group.held && legs.length > 0) {
      painter.holdBadge(scene.camera.worldToScreen(group.x, group.y), colours, inkOn(scene.palette, colours.accent));
    }
  }

  /** A number at the end of each leg; orders at one place share a badge. */
  private drawNumbers(group: GroupView, legs: readonly Leg[], colours: MarkColours, scene: OrderScene): void {
    const ends = legs.map(({ points }) => points[points.length - 1]!);
    let first = 0;
    ends.forEach((end, k) => {
      const next = ends[k + 1];
      if (next && distance(end, next) < kReached) return;
      const text = first < k ? `${first + 1}–${k + 1}` : `${k + 1}`;
      first = k + 1;
      const at = scene.camera.worldToScreen(end.x, end.y);
      if (legs[k]!.order.id === scene.picked) this.painter_.ring(at, colours, kPickedRing);
      if (legs.length > 1 || group.patrols)
        this.painter_.badge(at, text, colours, inkOn(scene.palette, colours.accent));
      else if (distance(end, group) >= kReached) this.painter_.checkpoint(at, colours, true);
    });
  }

  private drawLeg({ points, order }: Leg, colours: MarkColours, scene: OrderScene): void {
    if (points.length < 2) return;
    const at = this.screen(points, scene);
    if (order.kind === 'follow') this.painter_.dashed(at, colours.accent, 2.2, false, colours.casing);
    else this.painter_.cased(at, colours, 2.2, 5);
    this.drawArrows(at, colours);
  }

  /** Heads along a way, the last one some way before its end. */
  private drawArrows(at: readonly ScreenPoint[], colours: MarkColours): void {
    let gone = 0;
    let next = kArrowGap / 2;
    for (let i = 0; i + 1 < at.length; ++i) {
      const [a, b] = [at[i]!, at[i + 1]!];
      const length = distance(a, b);
      for (; length > 0 && next <= gone + length; next += kArrowGap) {
        const t = (next - gone) / length;
        const head = { x: a.x + (b.x - a.x) * t, y: a.y + (b.y - a.y) * t };
        this.painter_.chevron(head, Math.atan2(b.y - a.y, b.x - a.x), colours);
      }
      gone += length;
    }
  }

  private drawReturn(group: number, last: Leg, first: Leg, colours: MarkColours, scene: OrderScene): void {
    const ends = [last.points[last.points.length - 1]!, first.points[first.points.length - 1]!];
    const way = this.screen(scene.returns.get(group) ?? ends, scene);
    this.painter_.dashed(way, colours.accent, 2.2, false, colours.casing);
  }

  private ghost(group: GroupView, { order, points, facing }: Leg, { shapes }: OrderScene): StandPreview | null {
    const shape = shapes.of(group.id);
    const at = points[points.length - 1];
    if (!shape || !at || shape.places.length === 0 || order.kind === 'follow' || order.kind === 'guard') return null;
    if (isPlaceless(order)) return null;
    const local = widened(shape, order.width);
    const [left, right] = placed(frontLine(local), at, facing);
    const outline = outlineOf(placed(local, at, facing));
    return { index: 0, places: [], outline, front: [left!, right!] };
  }

  /** How it will stand: the outline dashed, the front with the way it faces. */
  private drawGhost(group: GroupView, leg: Leg, colours: MarkColours, scene: OrderScene): void {
    const ghost = this.ghost(group, leg, scene);
    const end = leg.points[leg.points.length - 1];
    if (!ghost || !end) return;
    // Who stands there already needs none.
    if (distance(group, end) < 1 && Math.abs(Math.sin((group.facing - leg.facing) / 2)) < 0.1) return;
    this.painter_.dashed(this.screen(ghost.outline, scene), colours.accent, 1.8, true, colours.casing);
    if (ghost.front) this.drawFront(ghost.front, colours, scene);
  }

  private drawFront([left, right]: readonly [GroundPoint, GroundPoint], colours: MarkColours, scene: OrderScene): void {
    const at = this.screen([left, right], scene);
    this.painter_.cased(at, colours, 3.4, 6.5);
    const middle = { x: (left.x + right.x) / 2, y: (left.y + right.y) / 2 };
    const width = Math.max(0.1, distance(left, right));
    const ahead = { x: middle.x - (right.y - left.y) / width, y: middle.y + (right.x - left.x) / width };
    const [from, to] = this.screen([middle, ahead], scene) as [ScreenPoint, ScreenPoint];
    const angle = Math.atan2(to.y - from.y, to.x - from.x);
    const head = { x: from.x + 12 * Math.cos(angle), y: from.y + 12 * Math.sin(angle) };
    this.painter_.chevron(head, angle, colours);
  }

  private drawGuard(order: QueueOrder, colours: MarkColours, scene: OrderScene): void {
    const corners = this.screen(rectangleOf(order), scene);
    this.painter_.veil(corners, colours.accent);
    this.painter_.dashed(corners, colours.accent, 2.2, true, colours.casing);
  }

  private drawPreview({ moves, rectangle, route }: DrawnOrder, scene: OrderScene): void {
    const { painter_: painter } = this;
    const first = moves[0];
    const colours = this.coloursOf(first?.index ?? this.firstChosen(scene), scene);
    if (route.length > 1) painter.cased(this.screen(route, scene), colours, 2.2, 5);
    if (rectangle.length > 2) {
      painter.veil(this.screen(rectangle, scene), colours.accent);
      painter.dashed(this.screen(rectangle, scene), colours.accent, 2.2, true, colours.casing);
    }
    for (const forecast of scene.forecasts) this.drawForecastWay(forecast, scene);
    for (const move of moves) {
      const lost = scene.forecasts.some(({ index, arrives }) => index === move.index && !arrives);
      const { accent, casing } = this.coloursOf(move.index, scene);
      const own = { accent: lost ? scene.palette.alarm : accent, casing };
      const outline = this.screen(move.outline, scene);
      painter.veil(outline, own.accent);
      painter.dashed(outline, own.accent, 1.8, true, own.casing);
      drawPlaces(painter, this.screen(move.places, scene), move.unfit, own, scene.palette.alarm);
      if (move.front) this.drawFront(move.front, own, scene);
    }
    const words = wordsOf(scene);
    if (words) painter.label(this.labelSpot(scene, words), words.text, scene.palette.panel, words.ink);
  }

  private drawForecastWay({ index, way, arrives }: DrawnForecast, scene: OrderScene): void {
    const colours = this.coloursOf(index, scene);
    const at = this.screen(way, scene);
    const end = at[at.length - 1];
    if (arrives) {
      this.painter_.cased(at, colours, 2.2, 5);
      this.drawArrows(at, colours);
      return;
    }
    this.painter_.dashed(at, colours.accent, 2.2, false, colours.casing);
    if (end) this.painter_.cross(end, { accent: scene.palette.alarm, casing: colours.casing });
  }

  /** Above all that is drawn. */
  private labelSpot(scene: OrderScene, words: Words): ScreenPoint {
    const outlines = scene.drawn?.moves.flatMap(({ outline }) => outline) ?? [];
    const drawn = outlines.length > 0 ? outlines : (scene.drawn?.rectangle ?? []);
    const ends = scene.forecasts.flatMap(({ way }) => way.slice(-1));
    const points = this.screen(drawn.length > 0 ? drawn : ends, scene);
    const [left, right] = [Math.min(...points.map(({ x }) => x)), Math.max(...points.map(({ x }) => x))];
    const above = { x: (left + right) / 2, y: Math.min(...points.map(({ y }) => y)) - kLabelGap };
    return roomFor(above, words, scene.camera);
  }

  private firstChosen({ groups, selected }: OrderScene): number {
    return groups.findIndex(({ id }) => selected.has(id));
  }

  private drawCut({ line, index, leaving, onto }: DrawnCut, scene: OrderScene): void {
    const colours = this.coloursOf(index, scene);
    const { painter_: painter } = this;
    for (const place of this.screen(leaving, scene)) {
      painter.dot(place, 6, colours.casing);
      painter.dot(place, 4.2, colours.accent);
    }
    if (onto.length > 2) {
      painter.veil(this.screen(onto, scene), colours.accent);
      painter.dashed(this.screen(onto, scene), colours.accent, 2.2, true);
    }
    const ink = { accent: index < 0 ? scene.palette.ink2 : scene.palette.ink, casing: colours.casing };
    const at = this.screen(line, scene);
    painter.cased(at, ink, 2.4, 6);
    const [a, b] = [at[at.length - 2], at[at.length - 1]];
    if (a && b && onto.length > 2) painter.chevron(b, Math.atan2(b.y - a.y, b.x - a.x), ink);
  }
}

function rectangleOf({ target: [x, y], halfSize: [halfX, halfY], facing }: QueueOrder): GroundPoint[] {
  const corners = [
    { x: -halfX, y: -halfY },
    { x: halfX, y: -halfY },
    { x: halfX, y: halfY },
    { x: -halfX, y: halfY },
  ];
  return placed(corners, { x, y }, facing ?? 0);
}
