// Paths of the open take, changed afterwards: whose is shown, the pull at it, and what the server makes of that.

import { PanelLayout } from '../../widgets/panel_layout';
import type { StudioClient } from '../../../link/studio_client';
import type { GroundPoint, ScreenPoint } from '../../../model/plane';
import type { StudioFrame } from '../../../model/studio_frame';
import type { StudioStore } from '../../../model/studio_store';
import type { OpenTake } from '../../../model/take_facts';
import { bent, grabbed, pointAt, wayOf, type PathPull, type TakeWay } from '../../../model/take_path';
import { PlaybackAction, type Notice, type TakeEdits, type TakePath, type TakeState } from '../../../protocol/messages';
import { problem } from '../../../protocol/problem';
import type { StudioScene } from '../../../scene/studio_scene';
import { BuildPointer, type BuildStroke, type BuildStrokes } from '../../../tools/build_pointer';
import { onEscape } from '../../widgets/escape_key';
import { ShelfLink } from '../../../link/shelf_link';
import { PathBar, type PathActions } from './path_bar';
import { PathLayer } from './path_layer';
import { PeopleEditor } from './people_editor';
import { peopleShapes } from './people_layer';
import { wordsOf } from './people_panel';
import '../../styles/path.css';

export interface PathParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly page: HTMLElement;
}

/** Who is who; frames tell it only where it changes. */
export interface Members {
  ids: Uint32Array;
  /** Index into the frame's groups. */
  group: Uint16Array;
}

/** How near a finger and a mouse take hold of a path [CSS px]. */
const kFinger = 26;
const kMouse = 14;
/** A tap shows the path of the nearest person within this [m]. */
const kTap = 2;
/** A shorter pull is none [m]. */
const kLeastPull = 0.05;

const kAsk = 'Tap somebody to see the path.';
const kNone = 'There is no path: crowds above 2,000 have those of groups only.';
const kPull = 'Drag the path where it should go elsewhere.';
const kAgain = 'Everything is simulated again…';

export class PathController implements BuildStrokes, PathActions {
  private readonly layer_: PathLayer;
  private readonly people_: PeopleEditor;
  private readonly bar_ = new PathBar(this);
  private readonly shelf_ = new ShelfLink();
  private take_: OpenTake | null = null;
  private frame_: StudioFrame | null = null;
  private way_: TakeWay | null = null;
  private whose_: { readonly group: number; readonly character: number } | null = null;
  private pull_: PathPull | null = null;
  private from_: GroundPoint = { x: 0, y: 0 };
  private pans_: ScreenPoint | null = null;
  private open_ = false;
  private single_ = false;
  private reach_ = 3;
  private waits_ = false;
  /** Takes before the changes, the last one last. */
  private before_: { readonly name: string; readonly step: number }[] = [];
  /** The moment to show when the take before has opened. */
  private shows_ = -1;

  constructor(
    private readonly parts_: PathParts,
    private readonly members_: Members,
  ) {
    const { client, view, page } = parts_;
    this.layer_ = new PathLayer((point) => view.worldToScreen(point));
    page.before(this.layer_.root);
    PanelLayout.of(page).add('paths', this.bar_.root);
    BuildPointer.over(view, this).listen(this.layer_.root);
    this.people_ = new PeopleEditor(parts_, members_, (state) => {
      this.bar_.setPeople(state, this.people_);
      if (this.single_) this.bar_.say(wordsOf(state));
    });
    client.on('frame', ({ frame }) => {
      this.frame_ = frame;
      if (this.open_ && this.single_) this.people_.setFrame(frame);
    });
    client.on('takePath', (path) => this.came(path));
    client.on('takeReady', ({ steps }) => this.readSoFar(steps));
    client.on('takeKept', () => this.waits_ && this.kept());
    client.on('notice', (notice) => this.refused(notice));
    onEscape(
      () => this.open_,
      () => this.leavePaths(),
    );
    this.layer_.root.style.display = 'none';
  }

  setOpen(open: boolean): void {
    if (open === this.open_) return;
    this.open_ = open;
    this.layer_.root.style.display = open ? '' : 'none';
    this.bar_.root.hidden = !open;
    this.bar_.setReach(this.reach_);
    this.bar_.setSingle(this.single_);
    this.bar_.setBack(this.before_.length > 0);
    if (!open) return this.cancel();
    this.parts_.client.send({ type: 'Playback', action: PlaybackAction.Pause });
    this.bar_.say(this.way_ ? kPull : kAsk);
    // A crowd of one group has but one path.
    const groups = this.parts_.store.state.groups;
    const only = groups[this.parts_.store.state.active] ?? groups[0];
    if (!this.whose_ && only) this.ask({ group: only.id, character: 0 });
    requestAnimationFrame(this.drawn);
  }

  setTake(state: TakeState): void {
    const { open, ...take } = state;
    const before = this.take_;
    this.take_ = open ? take : null;
    if (!open) return this.forget();
    if (before && before.name === take.name && before.steps === take.steps) return;
    this.pull_ = null;
    this.people_.restart(take.stepTime);
    if (this.shows_ >= 0) {
      this.parts_.client.send({ type: 'Playback', action: PlaybackAction.Pause });
      this.parts_.client.send({ type: 'Seek', step: Math.min(this.shows_, take.steps) });
    }
    this.shows_ = -1;
    if (this.whose_) this.ask(this.whose_);
  }

  setEdits(edits: TakeEdits): void {
    this.people_.told(edits);
  }

  private forget(): void {
    this.before_ = [];
    this.way_ = null;
    this.whose_ = null;
    this.waits_ = false;
    this.parts_.store.set({ paths: false });
  }

  private ask(whose: { readonly group: number; readonly character: number }): void {
    this.whose_ = whose;
    this.parts_.client.send({ type: 'AskPath', ...whose });
  }

  private came({ group, character, spacing, points }: TakePath): void {
    const asked = this.whose_;
    if (!this.take_ || asked?.group !== group || asked.character !== character) return;
    this.way_ = wayOf(points, spacing, this.take_.stepTime);
    if (points.length === 0) this.bar_.say(kNone);
    else if ([kAsk, kNone].includes(this.bar_.words)) this.bar_.say(kPull);
  }

  private readSoFar(steps: number): void {
    if (!this.waits_ || !this.take_) return;
    const share = Math.round((100 * steps) / Math.max(1, this.take_.steps));
    this.bar_.say(share < 100 ? `${kAgain} ${share} %` : kAgain);
  }

  private kept(): void {
    this.waits_ = false;
    this.bar_.say('Changed. The take before lies on the shelf.');
    this.bar_.setBack(this.before_.length > 0);
    this.parts_.view.wake();
  }

  private refused({ code }: Notice): void {
    if (code !== 'BendPath' || !this.waits_) return;
    this.waits_ = false;
    this.before_.pop();
    this.pull_ = null;
    this.bar_.say(kPull);
  }

  private readonly drawn = (): void => {
    if (!this.open_) return;
    requestAnimationFrame(this.drawn);
    if (this.single_)
      return this.layer_.drawShapes(
        peopleShapes(this.people_.picture(), (point) => this.parts_.view.worldToScreen(point)),
      );
    const { way_: way, pull_: pull } = this;
    this.layer_.draw({
      way,
      bent: way && pull ? bent(way, pull, this.reach_) : null,
      now: way ? pointAt(way, this.frame_?.step ?? 0) : -1,
      held: pull ? pull.at : -1,
    });
  };

  // Strokes.

  begin(stroke: BuildStroke): void {
    if (this.single_) return this.people_.begin(stroke);
    const { screen, ground, touch } = stroke;
    const step = this.frame_?.step ?? 0;
    const toScreen = (point: GroundPoint): ScreenPoint => this.parts_.view.worldToScreen(point);
    const at = this.way_ && !this.waits_ ? grabbed(this.way_, screen, toScreen, touch ? kFinger : kMouse, step) : -1;
    this.from_ = ground;
    this.pull_ = at >= 0 ? { at, dx: 0, dy: 0 } : null;
    this.pans_ = at >= 0 ? null : screen;
  }

  move(stroke: BuildStroke, still: boolean): void {
    if (this.single_) return this.people_.move(stroke, still);
    const { screen, ground } = stroke;
    if (this.pull_) this.pull_ = { at: this.pull_.at, dx: ground.x - this.from_.x, dy: ground.y - this.from_.y };
    else if (this.pans_) {
      this.parts_.view.camera.pan(this.pans_, screen);
      this.pans_ = screen;
      this.parts_.view.wake();
    }
  }

  end(stroke: BuildStroke, still: boolean): void {
    if (this.single_) return this.people_.end(stroke, still);
    const { ground } = stroke;
    const { pull_: pull, way_: way, whose_: whose } = this;
    this.pans_ = null;
    if (still) {
      this.pull_ = null;
      return this.choose(ground);
    }
    if (!pull || !way || !whose) return;
    if (Math.hypot(pull.dx, pull.dy) < kLeastPull) return void (this.pull_ = null);
    this.waits_ = true;
    if (this.take_?.name) this.before_.push({ name: this.take_.name, step: this.frame_?.step ?? 0 });
    this.bar_.say(kAgain);
    const step = pull.at * way.spacing;
    this.parts_.client.send({ type: 'BendPath', ...whose, step, dx: pull.dx, dy: pull.dy, seconds: this.reach_ });
  }

  cancel(): void {
    if (this.single_) this.people_.cancel();
    if (!this.waits_) this.pull_ = null;
    this.pans_ = null;
  }

  doubleTap(): void {
    // Means no more than a tap.
  }

  threeFingers(): void {
    if (this.single_) this.people_.threeFingers();
    else this.goBack();
  }

  /** The group of the person nearest to a tap. */
  private choose(at: GroundPoint): void {
    const frame = this.frame_;
    if (!frame || this.waits_) return;
    let best = -1;
    let least = kTap;
    for (let i = 0; i < frame.x.length; ++i) {
      const away = Math.hypot(frame.x[i]! - at.x, frame.y[i]! - at.y);
      if (away < least) [best, least] = [i, away];
    }
    if (best < 0) return;
    const group = frame.groups[this.members_.group[best] ?? -1];
    if (!group) return;
    this.ask({ group: group.id, character: 0 });
  }

  // Actions.

  setReach(seconds: number): void {
    this.reach_ = seconds;
    this.bar_.setReach(seconds);
  }

  setSingle(single: boolean): void {
    this.single_ = single;
    this.bar_.setSingle(single);
    if (single && this.frame_) this.people_.setFrame(this.frame_);
    this.people_.cancel();
    if (!single) this.bar_.say(this.way_ ? kPull : kAsk);
  }

  goBack(): void {
    const last = this.before_.pop();
    if (!last) return;
    this.shows_ = last.step;
    this.waits_ = false;
    this.bar_.setBack(this.before_.length > 0);
    this.shelf_.open(last.name).then(
      () => this.bar_.say(kPull),
      (error: unknown) =>
        this.parts_.store.set({ notice: problem('take', String(error instanceof Error ? error.message : error)) }),
    );
  }

  leavePaths(): void {
    this.parts_.store.set({ paths: false });
  }
}
