// What the view shows of groups and their orders: colours by id, who is chosen, and what is being drawn.

import { withChosen } from '../model/accent';
import { GroupShapes } from '../model/group_shapes';
import type { GroupView, ShapeMeshView } from '../model/frame_view';
import type { GroundPoint } from '../model/plane';
import type { BodyBuildWord } from '../protocol/generated/words';
import type { SceneGroup } from '../protocol/messages';
import { barredPicture, type BarredPerson } from './marks/barred_marks';
import type { DrawnCut, DrawnForecast, DrawnOrder, OrderScene } from './marks/order_marks';
import { saidOf } from './marks/stand_marks';
import { schemePicture, type CrowdPlaces, type SchemeView } from './marks/scheme_marks';

type Ways = ReadonlyMap<number, readonly GroundPoint[]>;

export class OrderPicture {
  private readonly shapes_ = new GroupShapes();
  private byId_ = new Map<number, number>();
  private buildsById_ = new Map<number, BodyBuildWord | null>();
  private selected_: ReadonlySet<number> = new Set();
  private drawn_: DrawnOrder | null = null;
  private forecasts_: readonly DrawnForecast[] = [];
  private ways_: Ways = new Map();
  private returns_: Ways = new Map();
  private picked_ = 0;
  private cut_: DrawnCut | null = null;
  private scheme_: SchemeView | null = null;
  private cursor_: GroundPoint | null = null;
  private barred_: readonly BarredPerson[] = [];
  private groups_: readonly GroupView[] = [];
  private colours_: readonly number[] = [];
  private builds_: readonly (BodyBuildWord | null)[] = [];

  /** `changed` asks for another picture; `crowd` tells where everybody is in the next one. */
  constructor(
    private readonly changed_: () => void,
    private readonly crowd_: CrowdPlaces,
  ) {}

  /** Accent indices of the newest frame's groups. */
  get colours(): readonly number[] {
    return this.colours_;
  }

  /** The build of each of them; null for both. */
  get builds(): readonly (BodyBuildWord | null)[] {
    return this.builds_;
  }

  clear(): void {
    this.shapes_.clear();
    this.groups_ = [];
    this.barred_ = [];
  }

  setMesh(mesh: ShapeMeshView): void {
    this.shapes_.setMesh(mesh);
  }

  /** Colours of the groups by id; groups come and go. */
  setGroups(groups: readonly SceneGroup[]): void {
    this.byId_ = new Map(groups.map(({ id, accent, definition }) => [id, withChosen(accent, definition.colour)]));
    this.buildsById_ = new Map(groups.map(({ id, definition }) => [id, definition.build]));
    this.changed_();
  }

  /** Ids of the groups that get orders. */
  setSelected(ids: readonly number[]): void {
    this.selected_ = new Set(ids);
    this.changed_();
  }

  /** An order that is being drawn; null takes it away. */
  previewOrder(drawn: DrawnOrder | null): void {
    this.drawn_ = drawn;
    this.changed_();
  }

  /** What would come of the order that is being drawn. */
  previewForecasts(forecasts: readonly DrawnForecast[]): void {
    this.forecasts_ = forecasts;
    this.changed_();
  }

  /** The ways of orders that wait, by their ids; those of patrols back to their first orders, by groups. */
  setWays(ways: Ways, returns: Ways): void {
    this.ways_ = ways;
    this.returns_ = returns;
    this.changed_();
  }

  /** The order that is chosen in the list of the queue; 0 for none. */
  setPicked(order: number): void {
    this.picked_ = order;
    this.changed_();
  }

  /** A stroke of the cutting tool; null takes it away. */
  previewCut(cut: DrawnCut | null): void {
    this.cut_ = cut;
    this.changed_();
  }

  /** The cursor of the keys; null while it is away. */
  get cursor(): GroundPoint | null {
    return this.cursor_;
  }

  set cursor(at: GroundPoint | null) {
    this.cursor_ = at;
    this.changed_();
  }

  /** What a control scheme shows; null for nothing. */
  setScheme(scheme: SchemeView | null): void {
    this.scheme_ = scheme;
    this.changed_();
  }

  /** Marks people who cannot be in their places, and these places. */
  setBarred(people: readonly BarredPerson[]): void {
    this.barred_ = people;
    this.changed_();
  }

  /** Takes the groups of the newest frame; true where their people look otherwise than before. */
  update(groups: readonly GroupView[]): boolean {
    this.groups_ = groups;
    const colours = groups.map(({ id }) => this.byId_.get(id) ?? id - 1);
    const builds = groups.map(({ id }) => this.buildsById_.get(id) ?? null);
    if (colours.join() === this.colours_.join() && builds.join() === this.builds_.join()) return false;
    [this.colours_, this.builds_] = [colours, builds];
    return true;
  }

  /** What would come of the order that is being drawn, in words. */
  get words(): string {
    return saidOf(this.forecasts_, this.drawn_?.note?.text);
  }

  /** For the marks. */
  scene(queues: boolean): Omit<OrderScene, 'camera' | 'palette' | 'colours' | 'greyed'> {
    return {
      groups: this.groups_,
      shapes: this.shapes_,
      selected: this.selected_,
      queues,
      drawn: this.drawn_,
      forecasts: this.forecasts_,
      ways: this.ways_,
      returns: this.returns_,
      picked: this.picked_,
      cut: this.cut_,
      cursor: this.cursor_,
      barred: barredPicture(this.barred_, this.crowd_),
      scheme: this.scheme_ && schemePicture(this.scheme_, this.crowd_),
    };
  }
}
