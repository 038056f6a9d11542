// Building a place: what is chosen, what is being drawn, and the edits that follow from it.

import { PanelLayout } from '../widgets/panel_layout';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import { kDrawingOptions, motionOfTool, type BuildTool, type DrawingOptions } from '../../model/place/drawing';
import { mistakesOf, motionOf } from '../../model/place/motions';
import { withDoor } from '../../model/place/doors';
import { standing } from '../../model/place/routes';
import * as things from '../../model/place/things';
import type { PlaceChange, Thing, ThingKind } from '../../model/place/things';
import { OverlayKind, PlaybackAction } from '../../protocol/messages';
import type { SceneFacts } from '../../protocol/scene';
import { BuildPointer } from '../../tools/build_pointer';
import type { ArrowKey } from '../../tools/keyboard_steering';
import type { BuildActions } from './build_actions';
import { BuildEdits, type PlaceEdit } from './build_edits';
import { BuildKeys } from './build_keys';
import { BuildLayer } from './build_layer';
import { BuildPanel } from './build_panel';
import type { BuildParts } from './build_parts';
import { LayerFilter } from './layer_filter';
import { MistakeNotes } from './mistake_notes';
import { NewSources } from './new_sources';
import { placeClips } from './place_clips';
import { BuildStroking, type StrokeHost } from './build_strokes';
import { cursorOver } from './cursor_strokes';
import '../styles/build.css';

/** An arrow moves what is chosen by so much, with Shift by more [m]. */
const kNudge = { short: 0.1, long: 1 };
/** Of an edit that was refused [ms]. */
const kPreviewStays = 1500;

export class BuildController implements StrokeHost, BuildActions {
  private readonly layer_: BuildLayer;
  private readonly panel_: BuildPanel;
  private readonly notes_: MistakeNotes;
  scene: SceneFacts | null = null;
  time = 0;
  /** As the server shows them, and with what it has been told since. */
  private served_: readonly Thing[] = [];
  private servedAt_ = 0;
  private things_: readonly Thing[] = [];
  private chosen_: readonly Thing[] = [];
  preview: readonly Thing[] = [];
  private readonly strokes_ = new BuildStroking(this);
  private copied_: readonly Thing[] = [];
  private open_ = false;
  private readonly edits_: BuildEdits;
  private waits_ = 0;
  tool: BuildTool = 'select';
  snaps = true;
  private readonly layers_ = new LayerFilter();
  /** The next thing that comes is chosen. */
  private choosesNew_ = false;
  options: DrawingOptions = kDrawingOptions;
  private readonly sources_ = new NewSources((edit) => this.edits_.send(edit));

  constructor(private readonly parts_: BuildParts) {
    const { view, client } = parts_;
    this.layer_ = new BuildLayer({ toScreen: (point) => view.worldToScreen(point) });
    this.panel_ = new BuildPanel(this);
    this.notes_ = new MistakeNotes({
      toScreen: (point) => view.worldToScreen(point),
      choose: ({ thing }) => (this.chosen = [thing]),
      fit: ({ thing, fits }) => this.change(`Fit ${thing.kind}`, [fits]),
      page: parts_.page,
    });
    this.edits_ = new BuildEdits(
      client,
      () => this.refresh(),
      () => this.time,
    );
    parts_.page.before(this.layer_.root, this.notes_.root);
    // Whoever goes on to the scene has done with what was typed.
    this.layer_.root.addEventListener('pointerdown', () => {
      this.panel_.leaveField();
      parts_.cursor.hide();
    });
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
    client.on('frame', ({ frame }) => (this.time = frame.time));
    parts_.store.watch(['history', 'playing'], ({ history, playing }) => this.panel_.show({ history, playing }));
    this.setTool('select');
    this.layer_.root.style.display = 'none';
    this.panel_.root.hidden = true;
  }

  setOpen(open: boolean): void {
    if (open === this.open_) return;
    this.open_ = open;
    for (const { style } of [this.layer_.root, this.notes_.root]) style.display = open ? '' : 'none';
    this.panel_.root.hidden = !open;
    this.parts_.cursor.lend(open ? cursorOver(this.strokes_, () => this.tool) : null);
    this.strokes_.drop();
    this.showLayers();
    this.parts_.client.send({ type: 'Build', on: open });
    if (!open) return this.close();
    this.askReach();
    this.panel_.focus();
    this.showChosen();
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
    const same = this.scene?.world === scene.world && this.scene.name === scene.name;
    this.scene = scene;
    const follows = this.sources_.follow(scene, this.served_, same);
    if (!same)
      placeClips(scene.clips, (clips) => {
        if (this.scene?.world === scene.world) this.setOptions({ clips });
      });
    this.serve();
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
    if (this.layers_.hidesSome) queueMicrotask(() => this.showLayers());
  }

  /** Things that move, where they stand now. */
  private serve(): void {
    this.servedAt_ = this.time;
    this.served_ = this.scene ? things.thingsOf(this.scene).map((one) => standing(one, this.time)) : [];
  }

  private showLayers(): void {
    if (this.scene) this.parts_.view.setScene(this.open_ ? this.layers_.of(this.scene) : this.scene);
  }

  private readonly drawn = (): void => {
    if (!this.open_) return;
    requestAnimationFrame(this.drawn);
    if (this.time !== this.servedAt_ && !this.strokes_.busy && this.served_.some(({ path }) => path)) {
      this.serve();
      this.refresh();
    }
    const shown = this.preview.length > 0 ? this.preview : this.things_;
    this.notes_.draw(mistakesOf(shown, this.scene, this.options.clips));
    this.layer_.draw({
      time: this.time,
      things: this.things_.filter(this.layers_.sees),
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
    this.sources_.forget();
    this.edits_.answered();
    if (this.strokes_.busy) return;
    this.edits_.forget();
    this.refresh();
  }

  add(label: string, made: readonly Thing[]): void {
    if (made.length === 0) return;
    this.preview = made;
    this.choosesNew_ = true;
    if (!this.sources_.begin(made)) this.change(label, made);
    // A refusal brings no new thing.
    window.clearTimeout(this.waits_);
    this.waits_ = window.setTimeout(() => (this.preview = []), kPreviewStays);
  }

  change(label: string, changed: readonly Thing[]): void {
    this.edits_.send(this.edits_.changeOf(label, changed));
  }

  /** A door at that spot of a wall. */
  openWall(at: GroundPoint): void {
    const wall = things.hit(this.free, at, this.metres(6));
    const made = wall ? withDoor(wall, at, this.options.doorWidth) : 'Tap a wall where the door shall be.';
    if (typeof made === 'string') return this.say(made);
    this.edits_.send(this.edits_.changeOf('Add door', made));
  }

  /** Changes what is chosen; what becomes a thing of another kind is another thing. */
  become(label: string, change: (one: Thing) => Thing): void {
    const edit = this.edits_.become(label, this.chosen_, this.chosen_.map(change));
    this.choosesNew_ ||= edit.changed.length === 0;
    this.edits_.send(edit);
  }

  setOptions(change: Partial<DrawingOptions>): void {
    this.options = { ...this.options, ...change };
    this.showChosen();
  }

  dragBegins(): void {
    this.edits_.begin();
  }

  drag(label: string, changed: readonly Thing[]): void {
    this.preview = changed;
    this.edits_.drag(this.edits_.changeOf(label, changed));
  }

  dragEnds(label: string, changed: readonly Thing[]): void {
    this.preview = [];
    this.edits_.end(this.edits_.changeOf(label, changed));
  }

  dragCancelled(label: string, before: readonly Thing[]): void {
    this.preview = [];
    this.edits_.cancel(this.edits_.changeOf(label, before));
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
    this.edits_.remove(this.chosen_, this.things_);
    this.chosen_ = [];
    this.showChosen();
  }

  copy(): void {
    this.copied_ = this.chosen_;
  }

  paste(): void {
    this.add('Paste', this.copied_.map(things.beside));
  }

  duplicate(): void {
    this.copy();
    this.paste();
  }

  arrow(key: ArrowKey, long: boolean): void {
    if (this.tool !== 'select' || this.chosen_.length === 0 || this.strokes_.busy)
      return this.parts_.cursor.arrow(key, long);
    const step = (long ? kNudge.long : kNudge.short) * (key === 'ArrowLeft' || key === 'ArrowDown' ? -1 : 1);
    const aside = key === 'ArrowLeft' || key === 'ArrowRight';
    this.edit('Move', (one) => things.moved(one, aside ? step : 0, aside ? 0 : step));
  }

  enter(shift: boolean): void {
    const { at } = this.parts_.cursor;
    if (this.strokes_.ends(at)) return this.strokes_.finishPolygon();
    if (!shift && this.tool === 'select' && this.chosen_.length > 0 && !this.strokes_.busy)
      return this.panel_.toFields();
    this.parts_.cursor.press(shift);
  }

  toGround(): void {
    this.parts_.cursor.focus();
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
    // What is chosen makes room for what the next thing shall be like.
    if (tool !== 'select' && tool !== 'route') this.chosen = [];
    this.panel_.setTool(tool);
    const motion = motionOfTool(tool, this.options);
    if (motion && this.options.clips.length > 0 && motionOf(this.options.clips, motion) < 0)
      this.say(`People of this place cannot ${motion}.`);
  }

  setSnaps(on: boolean): void {
    this.snaps = on;
  }

  toggleLayer(kind: ThingKind, what: 'hidden' | 'locked', on: boolean): void {
    this.layers_.toggle(kind, what, on);
    this.chosen_ = this.chosen_.filter(this.layers_.takes);
    this.showLayers();
    this.showChosen();
  }

  leave(): void {
    if (this.parts_.cursor.giveUp()) return;
    if (this.strokes_.busy) return this.setTool(this.tool);
    if (this.tool !== 'select') return this.setTool('select');
    if (this.chosen_.length > 0) return void (this.chosen = []);
    this.parts_.store.set({ build: false });
  }

  private showChosen(): void {
    this.panel_.showChosen(this.chosen_, this.strokes_.dragging);
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
    return this.things_.filter(this.layers_.takes);
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
