// Building a place: what is chosen, what is being drawn, and the edits that follow from it.

import { PanelLayout } from '../widgets/panel_layout';
import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import { kDrawingOptions, type BuildTool, type DrawingOptions } from '../../model/place/drawing';
import { emptiedGroups, isNobody, joinedSource, newArrivals } from '../../model/place/areas';
import * as things from '../../model/place/things';
import type { PlaceChange, Thing, ThingKind } from '../../model/place/things';
import { OverlayKind, PlaybackAction } from '../../protocol/messages';
import type { SceneFacts } from '../../protocol/scene';
import type { StudioScene } from '../../scene/studio_scene';
import { BuildPointer } from '../../tools/build_pointer';
import { firstOf, type HistoryController } from '../orders/history_controller';
import type { BuildActions } from './build_actions';
import { BuildEdits, changeOf, type PlaceEdit } from './build_edits';
import { BuildKeys } from './build_keys';
import { BuildLayer } from './build_layer';
import { BuildPanel } from './build_panel';
import { BuildStroking, type StrokeHost } from './build_strokes';
import '../styles/build.css';

export interface BuildParts {
  readonly history: Pick<HistoryController, 'ask'>;
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly page: HTMLElement;
}

/** What is pasted or doubled stands beside the old one [m]. */
const kBeside = 1;
/** Of an edit that was refused [ms]. */
const kPreviewStays = 1500;
/** Numbers follow what is dragged so often [ms]. */
const kNumbersFollow = 150;

export class BuildController implements StrokeHost, BuildActions {
  private readonly layer_: BuildLayer;
  private readonly panel_: BuildPanel;
  private scene_: SceneFacts | null = null;
  /** As the server shows them, and with what it has been told since. */
  private served_: readonly Thing[] = [];
  private things_: readonly Thing[] = [];
  private chosen_: readonly Thing[] = [];
  preview: readonly Thing[] = [];
  private readonly strokes_ = new BuildStroking(this);
  private copied_: readonly Thing[] = [];
  private open_ = false;
  private readonly edits_: BuildEdits;
  private waits_ = 0;
  private showsSoon_ = 0;
  tool: BuildTool = 'select';
  snaps = true;
  private readonly hidden_ = new Set<ThingKind>();
  private readonly locked_ = new Set<ThingKind>();
  /** The next thing that comes is chosen. */
  private choosesNew_ = false;
  options: DrawingOptions = kDrawingOptions;
  /** A source that waits for its group. */
  private source_: Thing | null = null;

  constructor(private readonly parts_: BuildParts) {
    const { view, client } = parts_;
    this.layer_ = new BuildLayer({ toScreen: (point) => view.worldToScreen(point) });
    this.panel_ = new BuildPanel(this);
    this.edits_ = new BuildEdits(client, () => this.refresh());
    parts_.page.before(this.layer_.root);
    PanelLayout.of(parts_.page).add('build', this.panel_.root);
    BuildPointer.over(view, this.strokes_).listen(this.layer_.root);
    new BuildKeys(this, () => this.open_);
    client.on('overlay', (overlay) => {
      if (overlay.kind === OverlayKind.Reach) this.layer_.setReach(overlay);
    });
    client.on('welcome', () => {
      if (this.open_) client.send({ type: 'Build', on: true });
      this.askReach();
    });
    client.on('notice', ({ code }) => this.refused(code));
    parts_.store.watch(['history'], ({ history }) => this.panel_.setHistory(history));
    parts_.store.watch(['playing'], ({ playing }) => this.panel_.setPlaying(playing));
    this.setTool('select');
    this.layer_.root.style.display = 'none';
    this.panel_.root.hidden = true;
  }

  setOpen(open: boolean): void {
    if (open === this.open_) return;
    this.open_ = open;
    this.layer_.root.style.display = open ? '' : 'none';
    this.panel_.root.hidden = !open;
    this.strokes_.drop();
    this.showLayers();
    this.parts_.client.send({ type: 'Build', on: open });
    if (!open) return this.close();
    this.askReach();
    this.panel_.focus();
    requestAnimationFrame(this.drawn);
  }

  private close(): void {
    const { overlay, chosen } = this.parts_.store.state;
    this.parts_.client.send({ type: 'SetOverlay', kind: overlay, character: Math.max(0, chosen) });
    this.chosen_ = [];
  }

  private askReach(): void {
    if (this.open_) this.parts_.client.send({ type: 'SetOverlay', kind: OverlayKind.Reach, character: 0 });
  }

  setScene(scene: SceneFacts): void {
    const before = this.served_;
    const same = this.scene_?.world === scene.world && this.scene_.name === scene.name;
    this.scene_ = scene;
    const follows = this.sourceFollows(scene, same);
    const walk = scene.clips.findIndex(({ name }) => name === 'walk');
    this.options = { ...this.options, stairsMotion: Math.max(0, walk) };
    this.served_ = things.thingsOf(scene);
    if (!same) this.edits_.forget();
    this.things_ = this.edits_.over(this.served_);
    this.chosen_ = things.chosenAgain(this.chosen_, before, this.things_, same);
    if (this.choosesNew_ && same && !follows) {
      const fresh = this.served_.filter((one) => !before.some((old) => things.sameThing(old, one)));
      if (fresh.length > 0) this.chosen_ = fresh;
      this.choosesNew_ = fresh.length === 0;
    }
    if (!this.strokes_.busy) this.preview = [];
    window.clearTimeout(this.waits_);
    this.edits_.answered();
    this.showChosen();
    // Whoever wakes the view later shows it whole; what is hidden is left out once the studio has shown it.
    if (this.hidden_.size > 0) queueMicrotask(() => this.showLayers());
  }

  private showLayers(): void {
    if (!this.scene_) return;
    const shown = (kind: ThingKind): boolean => !this.open_ || !this.hidden_.has(kind);
    const { obstacles, patches, areas, items, checkpoints } = this.scene_;
    this.parts_.view.setScene({
      ...this.scene_,
      obstacles: shown('obstacle') ? obstacles : [],
      patches: shown('patch') ? patches : [],
      areas: shown('area') ? areas : [],
      items: shown('item') ? items : [],
      checkpoints: shown('checkpoint') ? checkpoints : [],
    });
  }

  private readonly drawn = (): void => {
    if (!this.open_) return;
    requestAnimationFrame(this.drawn);
    this.layer_.draw({
      things: this.things_.filter((one) => !this.hidden_.has(one.kind) && !isNobody(one)),
      chosen: this.chosen_,
      preview: this.preview,
      line: this.strokes_.line.length > 0 ? this.strokes_.line : this.strokes_.corners,
      closed: this.strokes_.closed,
      handles: this.tool === 'select' && this.chosen_.length > 0,
      corner: this.strokes_.tapped,
      guides: this.strokes_.guides,
    });
  };

  // Edits.

  /** What is on the way to the server, or no longer, changes what is shown. */
  private refresh(): void {
    this.things_ = this.edits_.over(this.served_);
    this.chosen_ = things.chosenAgain(this.chosen_, this.served_, this.things_, true);
    // Later: whoever leaves a field by Tab goes on to the next one.
    window.setTimeout(() => this.showChosen());
  }

  private refused(code: string): void {
    if (code !== 'rejected' && code !== 'Edit') return;
    this.source_ = null;
    this.edits_.answered();
    if (this.strokes_.busy) return;
    this.edits_.forget();
    this.refresh();
  }

  add(label: string, made: readonly Thing[]): void {
    if (made.length === 0) return;
    this.preview = made;
    this.choosesNew_ = true;
    const source = made.find(({ area, group }) => area?.kind === 'source' && group === 0);
    if (source) {
      this.source_ = source;
      this.edits_.send({ label: firstOf('Add source'), changes: [newArrivals(source)], changed: [] });
    } else this.edits_.send({ label, changes: made.map(things.addCommand), changed: [] });
    // A refusal brings no new thing.
    window.clearTimeout(this.waits_);
    this.waits_ = window.setTimeout(() => (this.preview = []), kPreviewStays);
  }

  /** True where the group of a new source has come: the source is next. */
  private sourceFollows(scene: SceneFacts, sameWorld: boolean): boolean {
    const made = this.source_ && sameWorld ? joinedSource(this.source_, scene, this.served_) : null;
    if (made || !sameWorld) this.source_ = null;
    if (made) this.edits_.send({ label: 'Add source', changes: [things.addCommand(made)], changed: [] });
    return made !== null;
  }

  change(label: string, changed: readonly Thing[]): void {
    this.edits_.send(changeOf(label, changed));
  }

  dragBegins(): void {
    this.edits_.begin();
  }

  drag(label: string, changed: readonly Thing[]): void {
    this.preview = changed;
    this.edits_.drag(changeOf(label, changed));
  }

  dragEnds(label: string, changed: readonly Thing[]): void {
    this.preview = [];
    this.edits_.end(changeOf(label, changed));
  }

  dragCancelled(label: string, before: readonly Thing[]): void {
    this.preview = [];
    this.edits_.cancel(changeOf(label, before));
  }

  /** Changes the chosen ones by numbers and words of the panel. */
  edit(label: string, change: (one: Thing) => Thing): void {
    this.change(label, this.chosen_.map(change));
  }

  /** A change of the chosen group that has an event of its own. */
  editGroup(label: string, event: (one: Thing) => PlaceChange): void {
    this.edits_.send(this.groupEdit(label, event));
  }

  dragGroup(label: string, event: (one: Thing) => PlaceChange, ends: boolean): void {
    const edit = this.groupEdit(label, event);
    if (ends) this.edits_.end(edit);
    else this.edits_.drag(edit);
  }

  private groupEdit(label: string, event: (one: Thing) => PlaceChange): PlaceEdit {
    const changes = this.chosen_.filter(({ kind }) => kind === 'group').map(event);
    return { label, changes, changed: [] };
  }

  undo(redo = false): void {
    if (this.strokes_.dragging) return this.strokes_.drop();
    this.edits_.forget();
    this.refresh();
    this.parts_.history.ask(redo);
  }

  remove(): void {
    if (this.chosen_.length === 0 || this.strokes_.removeCorner()) return;
    this.strokes_.drop();
    const [one] = this.chosen_;
    const label = this.chosen_.length === 1 ? `Remove ${one!.area?.kind ?? one!.kind}` : 'Remove';
    // Nobody would ever be in the group of a source that is gone. Groups go last, and so come back first.
    const removed = [...this.chosen_, ...emptiedGroups(this.chosen_, this.things_)];
    const sources = removed.filter(({ group }) => removed.some(({ kind, id }) => kind === 'group' && id === group));
    const others = removed.filter((gone) => !sources.includes(gone));
    const first = sources.length > 0 && others.length > 0 ? firstOf(label) : label;
    this.edits_.send({ label: first, changes: sources.map(things.removeCommand), changed: [] });
    this.edits_.send({ label, changes: others.map(things.removeCommand), changed: [] });
    this.chosen_ = [];
    this.showChosen();
  }

  copy(): void {
    this.copied_ = this.chosen_;
  }

  paste(): void {
    this.add(
      'Paste',
      this.copied_.map((one) => things.moved({ ...one, id: 0 }, kBeside, -kBeside)),
    );
  }

  duplicate(): void {
    this.copied_ = this.chosen_;
    this.paste();
  }

  nudge(dx: number, dy: number): void {
    this.edit('Move', (one) => things.moved(one, dx, dy));
  }

  togglePlay(): void {
    const { playing } = this.parts_.store.state;
    this.parts_.client.send({ type: 'Playback', action: playing ? PlaybackAction.Pause : PlaybackAction.Play });
  }

  turnChosen(angle: number): void {
    const about = things.middleOfAll(this.chosen_);
    if (about) this.edit('Turn', (one) => things.turned(one, about, angle));
  }

  chooseAll(): void {
    this.chosen = this.free;
  }

  setTool(tool: BuildTool): void {
    this.strokes_.drop();
    this.tool = tool;
    this.panel_.setTool(tool, this.scene_);
  }

  setSnaps(on: boolean): void {
    this.snaps = on;
  }

  toggleLayer(kind: ThingKind, what: 'hidden' | 'locked', on: boolean): void {
    const set = what === 'hidden' ? this.hidden_ : this.locked_;
    if (on) set.add(kind);
    else set.delete(kind);
    this.chosen_ = this.chosen_.filter((one) => !set.has(one.kind));
    this.showLayers();
    this.showChosen();
  }

  leave(): void {
    if (this.strokes_.busy) return this.setTool(this.tool);
    if (this.tool !== 'select') return this.setTool('select');
    if (this.chosen_.length > 0) {
      this.chosen_ = [];
      return this.showChosen();
    }
    this.parts_.store.set({ build: false });
  }

  finishPolygon(): void {
    this.strokes_.finishPolygon();
  }

  /** While something is dragged the numbers follow a few times a second. */
  private showChosen(): void {
    if (this.strokes_.dragging) {
      this.showsSoon_ ||= window.setTimeout(() => this.showNow(), kNumbersFollow);
      return;
    }
    this.showNow();
  }

  private showNow(): void {
    window.clearTimeout(this.showsSoon_);
    this.showsSoon_ = 0;
    this.panel_.setChosen(this.chosen_, this.scene_);
  }

  get chosen(): readonly Thing[] {
    return this.chosen_;
  }

  set chosen(chosen: readonly Thing[]) {
    this.chosen_ = chosen;
    this.showChosen();
  }

  get all(): readonly Thing[] {
    return this.things_;
  }

  get free(): readonly Thing[] {
    return this.things_.filter((one) => !this.locked_.has(one.kind) && !this.hidden_.has(one.kind) && !isNobody(one));
  }

  say(text: string): void {
    this.panel_.say(text);
  }

  toScreen(point: GroundPoint): ScreenPoint {
    return this.parts_.view.worldToScreen(point);
  }

  metres(px: number): number {
    return px / Math.max(1, this.parts_.view.pixelsPerMetre());
  }
}
