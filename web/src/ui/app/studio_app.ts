// Wires client, scene, tools and panels.

import { LatencyMeter, timePicture } from '../../link/latency_meter';
import type { StudioClient } from '../../link/studio_client';
import {
  OverlayKind,
  ControlKind,
  type GroupMesh,
  type Notice,
  type Overlay,
  type Scene,
  type Welcome,
} from '../../protocol/messages';
import type { StudioFrame } from '../../model/studio_frame';
import { isSameWorld, type SceneFacts } from '../../protocol/scene';
import { problem, word } from '../../protocol/problem';
import { CameraGesture, OrbitGesture } from '../../tools/camera_gesture';
import type { Contact, ContactOwner } from '../../tools/contact';
import { heldWord } from '../../model/control_watch';
import { CrowdKeys } from '../../tools/crowd_keys';
import { Drafts } from '../../tools/drafts';
import { FormationHitTest } from '../../tools/formation_hit_test';
import { VirtualControls } from '../../tools/virtual_controls';
import { PointerRouter } from '../../tools/pointer_router';
import { ShortcutHandler, type Shortcut } from '../../tools/shortcuts';
import { SpaceKey } from '../../tools/space_key';
import { ToolChooser } from '../../tools/tool_chooser';
import { TouchEditor } from '../../tools/touch_editor';
import { TouchSender } from '../../tools/touch_sender';
import type { StudioScene } from '../../scene/studio_scene';
import { OrderChooser } from '../../tools/order_chooser';
import { judged } from '../orders/judged_orders';
import { OrderController } from '../orders/order_controller';
import { DirectorsController } from '../directors/directors_controller';
import { AttentionSender } from './attention_sender';
import { ControlAnnouncer } from './control_announcer';
import { LazyCursor } from '../steer/lazy_cursor';
import { GhostHand } from '../steer/ghost_hand';
import { openDialogsLazily } from './lazy_dialogs';
import { ShapeController } from '../formations/shape_controller';
import { CameraController } from '../steer/camera_controller';
import { DemonstrationWatch } from '../../model/demonstration_watch';
import { returnFocus } from '../widgets/focus_return';
import { FormationWatch } from '../../model/formation_watch';
import { FrameReader, sceneKey } from '../../model/frame_reader';
import { followSettings } from './page_settings';
import { StudioController } from './studio_controller';
import { FileController } from './file_controller';
import { OwnPeople } from '../steer/own_people';
import { OwnPeopleCopy } from '../steer/own_people_copy';
import { SchemeController } from '../steer/scheme_controller';
import { StandingController } from '../steer/standing_controller';
import { StudioShell } from './studio_shell';
import { studioShortcuts } from './studio_shortcuts';
import { StatsReadout, wantsStats } from './stats_readout';
import { isLost } from '../../model/studio_state';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import { pageClock } from '../../model/page_clock';
import type { Padding } from '../../scene/camera/camera_controls';
import { fieldScale } from '../../model/field_scale';
import { StudioStore } from '../../model/studio_store';

export class StudioApp {
  readonly latency = new LatencyMeter();
  readonly store = new StudioStore();
  /** Newest decoded frame. */
  frame: StudioFrame | null = null;
  private scene_: SceneFacts | null = null;
  private sceneRevision_ = 0;
  private readonly reader_ = new FrameReader();
  private readonly formations_ = new FormationWatch();
  private readonly demonstrations_ = new DemonstrationWatch();
  readonly camera: CameraController;
  readonly shapes: ShapeController;
  readonly files: FileController;
  private readonly attention_: AttentionSender;
  private readonly drafts_: Drafts;
  private readonly hitTest_ = new FormationHitTest();
  private readonly standing_: StandingController;
  private readonly controller_: StudioController;
  private readonly shell_: StudioShell;
  readonly orders: OrderController;
  private readonly schemes_: SchemeController;
  private readonly orders_: OrderChooser;
  private readonly directors_: DirectorsController;
  private readonly touches_: TouchSender;
  private readonly controls_: VirtualControls;
  private readonly chooser_: ToolChooser;
  private readonly keys_: CrowdKeys;
  readonly cursor = new LazyCursor();
  private readonly announcer_: ControlAnnouncer;
  private readonly stats_ = wantsStats(window.location.search) ? new StatsReadout() : null;

  constructor(
    private readonly client_: StudioClient,
    private readonly view_: StudioScene,
    private readonly canvas_: HTMLCanvasElement,
    page: HTMLElement,
  ) {
    const say = (text: string): void => this.shell_.live.say(text);
    const people = new OwnPeople(view_, this.store, undefined, new OwnPeopleCopy());
    void people.restore();
    this.camera = new CameraController({
      view: view_,
      store: this.store,
      canvas: canvas_,
      padding: (): Padding => this.shell_.padding(),
      say,
      moved: () => this.controller_.tried('camera'),
    });
    this.shapes = new ShapeController({
      client: client_,
      store: this.store,
      shapeOf: (group) => this.orders.shapes.of(group),
      known: () => this.orders.queues.forecaster.known,
      view: view_,
      say,
    });
    this.standing_ = new StandingController(client_, this.store, view_, this.camera, say);
    this.controller_ = new StudioController(client_, this.store, this.camera, say, people, this.shapes, this.standing_);
    this.announcer_ = new ControlAnnouncer(this.store, this.controller_, say);
    this.files = new FileController(this.store, this.controller_, this.shapes);
    this.attention_ = new AttentionSender(client_);
    this.drafts_ = new Drafts(
      (drafts) => view_.showDrafts(drafts),
      () => this.controls_.pending,
      () => client_.clientId,
    );
    this.touches_ = new TouchSender(client_, (time) => this.latency.touched(time));
    this.controls_ = new VirtualControls(client_, this.touches_, () => client_.clientId, this.drafts_);
    const camera = new CameraGesture(this.camera.hand);
    this.orders = new OrderController(client_, this.store, judged(view_, client_), say, this.held);
    this.schemes_ = new SchemeController(client_, this.store, view_, say, (time) => this.latency.touched(time));
    const toGround = (at: ScreenPoint): GroundPoint | null => view_.screenToWorld(at);
    this.orders_ = new OrderChooser({ orders: this.orders, camera, tool: () => this.store.state.tool, toGround });
    this.chooser_ = new ToolChooser({
      scene: view_,
      hitTest: this.hitTest_,
      editor: new TouchEditor(this.touches_, view_, this.drafts_),
      camera,
      orbit: new OrbitGesture(this.camera.hand),
      controls: this.controls_,
      orders: this.orders_,
      shapes: (contact) => this.shapes.owner(contact),
      tell: (text) => this.store.set({ notice: word('loop', text) }),
    });
    const hand = { camera: this.camera.hand, screenToWorld: toGround };
    this.keys_ = new CrowdKeys(hand, this.controls_, this.chooser_, this.middle, say);
    const shortcuts = this.shortcuts();
    this.directors_ = new DirectorsController(client_, this.store, view_, () => client_.clientId, say);
    this.shell_ = new StudioShell(page, this.store, this.controller_, this.orders, this.directors_, shortcuts);
    this.start(page, shortcuts);
  }

  private start(page: HTMLElement, shortcuts: readonly Shortcut[]): void {
    openDialogsLazily(page, this.store, this.controller_, this.shapes);
    this.files.acceptDrops(window);
    if (this.stats_) page.append(this.stats_.root);
    returnFocus(page, this.canvas_);
    new ShortcutHandler(window, shortcuts);
    new SpaceKey(
      window,
      (held) => (this.chooser_.panning = held),
      () => this.controller_.togglePlay(),
    );
    this.routePointers();
    this.cursor.serve({
      client: this.client_,
      store: this.store,
      view: this.view_,
      canvas: this.canvas_,
      camera: this.camera.hand,
      padding: () => this.shell_.padding(),
      choose: (contact) => this.steered(contact),
      frame: () => this.frame,
      say: (text) => this.shell_.live.say(text),
    });
    followSettings(this.store, this.view_, () => this.shell_.padding());
    new GhostHand(page, this.store, this.view_, () => this.frame?.groups[this.store.state.active] ?? null);
    this.followClient();
    requestAnimationFrame(this.drawn);
  }

  private shortcuts() {
    const { keys_: keys, controller_: controller, store, cursor } = this;
    return studioShortcuts(controller, this.orders, {
      arrow: (key, long) => (cursor.takesKeys ? cursor.arrow(key, long) : keys.arrow(key, long)),
      zoom: (factor) => keys.zoom(factor),
      turn: (radians) => keys.turn(radians),
      enter: (shift) => (cursor.takesKeys ? cursor.press(shift) : keys.grabOrDrop(store.state.active)),
      letGo: () => this.letGo(),
      togglePin: () => keys.togglePin(),
      removeControl: () => keys.removeControl(),
      nextGroup: () => controller.nextGroup(),
    });
  }

  /** The word for what Escape would let go of. */
  private readonly held = (): string | null => heldWord(this.frame && this.controls_.newestIn(this.frame)?.control);

  /** Escape drops what is being drawn, then puts the tool away, then ends controls. */
  private letGo(): void {
    if (this.cursor.giveUp()) return;
    this.orders_.abort();
    if (this.store.state.tool === 'steer') this.keys_.letGo();
    else this.orders.setTool('steer');
  }

  private routePointers(): void {
    new PointerRouter(this.canvas_, (at) => this.view_.screenToWorld(at), {
      choose: (contact) => this.schemes_.owner(contact) ?? this.steered(contact),
      tapped: (contact) => this.tapped(contact),
      doubleClicked: (contact) => this.doubleClicked(contact),
      wheel: (at, factor) => this.camera.hand.zoomAt(at, factor),
      pointed: (contact) => this.pointed(contact),
    });
    for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointerleave'] as const) {
      this.canvas_.addEventListener(type, (event) => this.keys_.pointed(event));
    }
    for (const type of ['pointerdown', 'pointermove'] as const) {
      this.canvas_.addEventListener(type, (event) => event.buttons !== 0 && this.camera.contact());
    }
  }

  /** Touching a formation chooses its group. */
  private steered(contact: Contact): ContactOwner {
    const { ground, button, shift } = contact;
    const { tool, active } = this.store.state;
    const target = tool === 'steer' && button <= 0 && ground ? this.chooser_.formation(ground) : null;
    if (target && (shift || target.index !== active)) this.orders.choose(target.index, shift);
    return this.chooser_.choose(contact);
  }

  private pointed(contact: Contact): void {
    const input = contact.kind === 'mouse' ? 'mouse' : 'touch';
    if (this.store.state.input !== input) this.store.set({ input });
    if (contact.kind !== 'mouse' || !contact.ground) return;
    this.shapes.pointed(contact.ground);
    const over = this.store.state.tool !== 'steer' ? 'crosshair' : this.chooser_.cursor(contact.ground);
    if (this.canvas_.style.cursor !== over) this.canvas_.style.cursor = over;
  }

  private tapped(contact: Contact): void {
    if (this.store.state.overlay !== OverlayKind.Cost || contact.button > 0) return;
    const box = this.canvas_.getBoundingClientRect();
    const character = this.view_.pick(contact.screen.x + box.left, contact.screen.y + box.top);
    if (character >= 0) this.controller_.chooseCharacter(character);
  }

  private doubleClicked({ ground, time }: Contact): void {
    if (!ground || this.schemes_.active || this.store.state.tool !== 'steer') return;
    const grab = this.chooser_.grab(ground);
    const target = this.chooser_.formation(ground);
    if (grab) this.controls_.togglePin(grab.group, grab.control, time);
    else if (target) {
      const { group } = target;
      this.controls_.create({ group, kind: ControlKind.Point, positions: [ground], time, keep: true, pinned: true });
    }
  }

  private followClient(): void {
    const { client_: client, store, view_: view } = this;
    client.on('link', (link) => {
      store.set({ link });
      const lost = isLost(store.state);
      view.setLost(lost);
      document.documentElement.toggleAttribute('data-lost', lost);
      if (link.phase !== 'open') this.forgetTouches();
      this.attention_.forget();
    });
    client.on('welcome', (welcome) => this.greeted(welcome));
    client.on('scene', (scene) => this.showScene(scene));
    client.on('motions', ({ clips }) => view.setMotions(clips));
    client.on('groupMesh', (mesh) => this.showMesh(mesh));
    client.on('frame', ({ frame, receivedAt }) => this.showFrame(frame, receivedAt));
    client.on('overlay', (overlay) => this.showOverlay(overlay));
    client.on('forecasts', (answers) => this.orders.queues.answered(answers, performance.now()));
    client.on('directors', ({ directors }) => this.directors_.took(directors));
    client.on('notice', (notice) => this.noticed(notice));
    this.stats_?.follow(client);
  }

  private greeted({ scenarios }: Welcome): void {
    this.store.set({ scenarios });
    this.controller_.askOverlayAgain();
    this.directors_.greeted(this.client_.clientId);
  }
  private noticed(notice: Notice): void {
    // The server refused these touches, so no frame will show them.
    if (notice.code === 'Touches' || notice.code === 'AddControl') this.drafts_.clear();
    if (notice.code === 'Commands' || notice.code === 'rejected') this.orders.refused();
    this.store.set({ notice });
  }

  private forgetTouches(): void {
    this.controls_.clear();
    this.drafts_.clear();
    this.latency.reset();
  }

  private showMesh(mesh: GroupMesh): void {
    this.hitTest_.setMesh(mesh);
    this.reader_.setMesh(mesh);
    this.orders.setMesh(mesh);
    this.view_.setGroupMesh(mesh);
  }

  private showScene(scene: Scene): void {
    this.sceneRevision_ = scene.revision;
    try {
      this.reader_.setScene(scene);
      const { title, name, credit, demonstration, parameters, areas, radius: bodyRadius } = scene;
      this.store.set({ title, scenario: name, credit, demonstration, parameters, areas, bodyRadius, loaded: true });
      const before = this.scene_;
      // A scene comes again when only a parameter or a count changed: nothing looks different then.
      this.view_.orders.setGroups(scene.groups);
      this.scene_ = scene;
      if (before && sceneKey(before) === sceneKey(scene)) return this.view_.setScene(scene, true);
      const opens = !before || !isSameWorld(before, scene);
      if (opens) this.forgetWorld();
      this.view_.setScene(scene);
      if (opens) this.view_.fitter.padding = this.shell_.padding();
    } catch (error) {
      this.store.set({ notice: problem('scene', `The scene could not be shown: ${String(error)}`) });
    }
  }

  private forgetWorld(): void {
    this.forgetTouches();
    this.formations_.clear();
    this.standing_.forgetWorld();
    this.orders.forgetWorld();
    this.camera.forgetWorld();
    this.store.set({ active: 0, notice: null });
  }

  private showFrame(frame: StudioFrame, receivedAt: number): void {
    // A frame that was sent before the scene changed belongs to the old scene.
    if (frame.sceneRevision !== this.sceneRevision_) return;
    const start = performance.now();
    this.takeFrame(frame, receivedAt);
    this.view_.stats.framesTakenMs += performance.now() - start;
    this.view_.stats.framesTaken += 1;
  }

  private takeFrame(frame: StudioFrame, receivedAt: number): void {
    this.frame = frame;
    this.hitTest_.setGroups(frame.groups);
    this.chooser_.observe(frame);
    this.keys_.observe(frame);
    this.controls_.observe(frame);
    // The touches of a take belong to no client of this session.
    this.view_.setClient(frame.replaying ? 0 : this.client_.clientId);
    this.view_.pushFrame(frame, receivedAt);
    this.camera.observe(frame);
    this.shapes.observe(frame);
    this.latency.echoed(frame.touchEcho, frame.frame, pageClock(receivedAt));
    timePicture(this.latency, this.view_.stats.shownFrame);
    this.store.set(this.reader_.change(frame, this.store.state, receivedAt));
    this.orders.observe(frame);
    this.directors_.observe(frame.groups);
    this.drafts_.observe(frame);
    this.announcer_.observe(frame, this.client_.clientId);
    for (const { name, formation } of this.formations_.observe(this.store.state.groups, frame.step)) {
      this.shell_.live.say(`${name}: ${formation}`);
    }
    this.standing_.observe(frame);
    const news = this.demonstrations_.observe(frame.demonstrating);
    if (news) this.shell_.live.say(news);
  }

  private showOverlay(overlay: Overlay): void {
    const { state } = this.store;
    if (overlay.kind !== state.overlay || overlay.kind === OverlayKind.None) return;
    if (overlay.kind === OverlayKind.Cost && overlay.character !== state.chosen) return;
    const { cost, way, straight } = overlay;
    this.store.set({ ramp: fieldScale(overlay.values), cost: { cost, way, straight } });
    this.view_.setOverlay(overlay);
  }

  private readonly middle = (): ScreenPoint => ({ x: this.canvas_.clientWidth / 2, y: this.canvas_.clientHeight / 2 });

  /** Runs once per picture of the display: queued moves are sent, and touches that the picture shows are timed. */
  private readonly drawn = (): void => {
    requestAnimationFrame(this.drawn);
    this.touches_.flush();
    this.orders.queues.tick(performance.now());
    this.camera.tick(performance.now());
    if (this.client_.state.phase === 'open') this.attention_.consider(this.view_.attention(), performance.now());
    this.shell_.scale.update(this.view_.pixelsPerMetre());
    this.stats_?.show(this.view_.stats);
    timePicture(this.latency, this.view_.stats.shownFrame);
  };
}
