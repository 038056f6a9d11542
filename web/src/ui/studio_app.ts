// Wires client, scene, tools and panels.

import { LatencyMeter, pageClock } from '../engine/latency_meter';
import type { StudioClient } from '../engine/studio_client';
import { OverlayKind, ControlKind, type GroupMesh, type Notice, type Overlay, type Scene, type Welcome } from '../protocol/messages';
import type { StudioFrame } from '../engine/studio_frame';
import { isSameWorld, parseScene, type SceneFacts } from '../protocol/scene';
import { problem } from '../protocol/problem';
import { CameraGesture, OrbitGesture } from '../tools/camera_gesture';
import type { Contact } from '../tools/contact';
import { CrowdKeys } from '../tools/crowd_keys';
import { Drafts } from '../tools/drafts';
import { FormationHitTest } from '../tools/formation_hit_test';
import { HeldControls } from '../tools/held_controls';
import { PointerRouter } from '../tools/pointer_router';
import { ShortcutHandler } from '../tools/shortcuts';
import { SpaceKey } from '../tools/space_key';
import { ToolChooser } from '../tools/tool_chooser';
import { TouchEditor } from '../tools/touch_editor';
import { TouchSender } from '../tools/touch_sender';
import type { GroundPoint, ScreenPoint } from '../view/camera_types';
import { fieldScale } from '../view/field_picture';
import type { StudioScene } from '../view/studio_scene';
import { AttentionSender } from './attention_sender';
import { ControlWatch, KIND_NAMES, type ControlNews } from './control_watch';
import { DemonstrationCamera } from './demonstration_camera';
import { DemonstrationWatch } from './demonstration_watch';
import { returnFocus } from './focus_return';
import { FormationWatch } from './formation_watch';
import { formatClock } from './formatters';
import { FrameReader, sceneKey } from './frame_reader';
import { LayoutWatcher } from './layout';
import { HINT_KEY, StudioController } from './studio_controller';
import { OwnPeople } from './own_people';
import { StudioShell } from './studio_shell';
import { studioShortcuts } from './studio_shortcuts';
import { StatsReadout, wantsStats } from './stats_readout';
import { StudioStore, isLost } from './studio_state';
import { applyTheme, followSystemTheme, preferredTheme, readSetting } from './theme';

export class StudioApp {
  readonly latency = new LatencyMeter();
  readonly store = new StudioStore();
  /** Newest decoded frame. */
  frame: StudioFrame | null = null;
  private scene: SceneFacts | null = null;
  private sceneRevision = 0;
  private readonly reader = new FrameReader();
  private readonly watch = new ControlWatch();
  private readonly formations = new FormationWatch();
  private readonly demonstrations = new DemonstrationWatch();
  private readonly guide: DemonstrationCamera;
  private readonly attention: AttentionSender;
  private readonly drafts: Drafts;
  private readonly hitTest = new FormationHitTest();
  private readonly controller: StudioController;
  private readonly shell: StudioShell;
  private readonly touches: TouchSender;
  private readonly controls: HeldControls;
  private readonly chooser: ToolChooser;
  private readonly keys: CrowdKeys;
  private readonly stats = wantsStats(window.location.search) ? new StatsReadout() : null;

  constructor(
    private readonly client: StudioClient,
    private readonly view: StudioScene,
    private readonly canvas: HTMLCanvasElement,
    page: HTMLElement,
  ) {
    const say = (text: string): void => this.shell.live.say(text);
    const people = new OwnPeople(view, this.store);
    people.acceptDrops(window);
    const look = { fitCrowd: () => this.fit(), lookAt: (point: GroundPoint) => this.lookAt(point) };
    this.controller = new StudioController(client, this.store, look, say, people);
    this.attention = new AttentionSender(client);
    this.drafts = new Drafts((drafts) => view.showDrafts(drafts), () => this.controls.unanswered, () => client.clientId);
    this.touches = new TouchSender(client, (time) => this.latency.touched(time));
    this.controls = new HeldControls(client, this.touches, () => client.clientId, this.drafts);
    const editor = new TouchEditor(this.touches, view, this.drafts);
    const camera = new CameraGesture(view.camera);
    const orbit = new OrbitGesture(view.camera);
    this.chooser = new ToolChooser({ scene: view, hitTest: this.hitTest, editor, camera, orbit, controls: this.controls });
    this.guide = new DemonstrationCamera(view, () => this.fit());
    this.keys = new CrowdKeys(view, this.controls, this.chooser, () => this.middle(), say);
    const shortcuts = this.shortcuts();
    this.shell = new StudioShell(page, this.store, this.controller, shortcuts);
    if (this.stats) page.append(this.stats.root);
    returnFocus(page, canvas);
    new ShortcutHandler(window, shortcuts);
    new SpaceKey(window, (held) => (this.chooser.panning = held), () => this.controller.togglePlay());
    this.routePointers();
    this.followSettings();
    this.followClient();
    requestAnimationFrame(this.drawn);
  }

  private shortcuts() {
    const { keys, controller, store, guide } = this;
    const byHand = (act: () => void): void => {
      guide.release();
      act();
    };
    return studioShortcuts(controller, {
      arrow: (key, long) => byHand(() => keys.arrow(key, long)),
      zoom: (factor) => byHand(() => keys.zoom(factor)),
      turn: (radians) => byHand(() => keys.turn(radians)),
      grabOrDrop: () => keys.grabOrDrop(store.state.active),
      letGo: () => keys.letGo(),
      togglePin: () => keys.togglePin(),
      removeControl: () => keys.removeControl(),
      nextGroup: () => controller.nextGroup(),
    });
  }

  private routePointers(): void {
    new PointerRouter(this.canvas, (at) => this.view.screenToWorld(at), {
      choose: (contact) => {
        this.chooseGroupOf(contact);
        return this.chooser.choose(contact);
      },
      tapped: (contact) => this.tapped(contact),
      doubleClicked: (contact) => this.doubleClicked(contact),
      wheel: (at, factor) => this.view.camera.zoomAt(at, factor),
      pointed: (contact) => this.pointed(contact),
    });
    for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointerleave'] as const) {
      this.canvas.addEventListener(type, (event) => this.keys.pointed(event));
    }
    for (const type of ['pointerdown', 'wheel'] as const) {
      this.canvas.addEventListener(type, () => this.guide.release(), { passive: true });
    }
  }

  /** Touching a formation chooses its group. */
  private chooseGroupOf({ ground }: Contact): void {
    const target = ground && this.chooser.formation(ground);
    if (target && target.index !== this.store.state.active) this.store.set({ active: target.index });
  }

  private pointed(contact: Contact): void {
    const input = contact.kind === 'mouse' ? 'mouse' : 'touch';
    if (this.store.state.input !== input) this.store.set({ input });
    if (contact.kind !== 'mouse' || !contact.ground) return;
    const over = this.chooser.grab(contact.ground) ? 'grab' : this.chooser.formation(contact.ground) ? 'pointer' : 'default';
    if (this.canvas.style.cursor !== over) this.canvas.style.cursor = over;
  }

  private tapped(contact: Contact): void {
    if (this.store.state.overlay !== OverlayKind.Cost) return;
    const box = this.canvas.getBoundingClientRect();
    const character = this.view.pick(contact.screen.x + box.left, contact.screen.y + box.top);
    if (character >= 0) this.controller.chooseCharacter(character);
  }

  private doubleClicked({ ground, time }: Contact): void {
    if (!ground) return;
    const grab = this.chooser.grab(ground);
    const target = this.chooser.formation(ground);
    if (grab) this.controls.togglePin(grab.group, grab.control, time);
    else if (target) {
      const { group } = target;
      this.controls.create({ group, kind: ControlKind.Point, positions: [ground], time, keep: true, pinned: true });
    }
  }

  private followSettings(): void {
    const { store, view } = this;
    const touchFirst = window.matchMedia('(pointer: coarse)').matches;
    const hint = readSetting(() => window.localStorage, HINT_KEY) === null;
    store.set({ theme: preferredTheme(window), input: touchFirst ? 'touch' : 'mouse', hint });
    new LayoutWatcher(window, (layout) => {
      store.set({ layout });
      requestAnimationFrame(() => view.setPadding(this.shell.padding()));
    });
    followSystemTheme(window, (theme) => store.set({ theme }));
    store.watch(['theme'], ({ theme }) => {
      applyTheme(window, theme);
      view.setTheme(theme);
    });
    store.watch(['layers'], ({ layers }) => view.setLayers(layers));
    store.watch(['active'], ({ active }) => view.setActiveGroup(active));
    store.watch(['overlay', 'chosen'], ({ overlay }) => {
      document.documentElement.toggleAttribute('data-overlay', overlay !== OverlayKind.None);
      view.setOverlay(null);
    });
    store.watch(['title', 'recorded'], ({ title, recorded }) => {
      const name = title ? `${title} – Muster` : 'Muster';
      document.title = recorded >= 0 ? `● ${formatClock(recorded).slice(0, -2)} ${name}` : name;
    });
    const motion = window.matchMedia('(prefers-reduced-motion: reduce)');
    view.setReducedMotion(motion.matches);
    motion.addEventListener('change', () => view.setReducedMotion(motion.matches));
  }

  private followClient(): void {
    const { client, store, view } = this;
    client.on('link', (link) => {
      store.set({ link });
      const lost = isLost(store.state);
      view.setLost(lost);
      document.documentElement.toggleAttribute('data-lost', lost);
      if (link.phase !== 'open') this.forgetTouches();
      this.attention.forget();
    });
    client.on('welcome', (welcome) => this.greeted(welcome));
    client.on('scene', (scene) => this.showScene(scene));
    client.on('motions', ({ clips }) => view.setMotions(clips));
    client.on('groupMesh', (mesh) => this.showMesh(mesh));
    client.on('frame', ({ frame, receivedAt }) => this.showFrame(frame, receivedAt));
    client.on('overlay', (overlay) => this.showOverlay(overlay));
    client.on('notice', (notice) => this.noticed(notice));
  }

  private greeted({ scenarios }: Welcome): void {
    this.store.set({ scenarios });
    this.controller.askOverlayAgain();
  }

  private noticed(notice: Notice): void {
    // Fingers that were refused are answered: nothing of them will ever be shown.
    if (notice.code === 'Touches' || notice.code === 'AddControl') this.drafts.clear();
    this.store.set({ notice });
  }

  private forgetTouches(): void {
    this.controls.clear();
    this.drafts.clear();
    this.latency.reset();
  }

  private showMesh(mesh: GroupMesh): void {
    this.hitTest.setMesh(mesh);
    this.reader.setMesh(mesh);
    this.view.setGroupMesh(mesh);
  }

  private showScene(message: Scene): void {
    this.sceneRevision = message.revision;
    try {
      const scene = parseScene(message.json);
      this.reader.setScene(scene);
      const { title, name, credit, demonstration, parameters } = scene;
      this.store.set({ title, scenario: name, credit, demonstration, parameters, loaded: true });
      const before = this.scene;
      // A scene comes again when only a parameter or a count changed: nothing looks different then.
      if (before && sceneKey(before) === sceneKey(scene)) return;
      this.scene = scene;
      if (!before || !isSameWorld(before, scene)) this.forgetWorld();
      this.view.setScene(scene);
      this.view.setPadding(this.shell.padding());
    } catch (error) {
      this.store.set({ notice: problem('scene', `The scene could not be shown: ${String(error)}`) });
    }
  }

  private forgetWorld(): void {
    this.forgetTouches();
    this.formations.clear();
    this.guide.forget();
    this.store.set({ active: 0, notice: null });
  }

  private showFrame(frame: StudioFrame, receivedAt: number): void {
    // One that was on its way when the scene changed speaks of what is gone.
    if (frame.sceneRevision !== this.sceneRevision) return;
    const start = performance.now();
    this.takeFrame(frame, receivedAt);
    this.view.stats.takenMs += performance.now() - start;
    this.view.stats.taken += 1;
  }

  private takeFrame(frame: StudioFrame, receivedAt: number): void {
    this.frame = frame;
    this.hitTest.setGroups(frame.groups);
    this.chooser.observe(frame);
    this.keys.observe(frame);
    this.controls.observe(frame);
    // Whose touches a take has, they are nobody's now.
    this.view.setClient(frame.replaying ? 0 : this.client.clientId);
    this.view.pushFrame(frame, receivedAt);
    const { clientWidth, clientHeight } = this.canvas;
    this.guide.observe(frame, clientWidth, clientHeight, () => this.shell.padding());
    this.latency.echoed(frame.touchEcho, frame.frame, pageClock(receivedAt));
    this.timePicture();
    this.store.set(this.reader.change(frame, this.store.state));
    this.drafts.observe(frame);
    for (const news of this.watch.observe(frame)) this.announce(news);
    for (const { name, formation } of this.formations.observe(this.store.state.groups, frame.step)) {
      this.shell.live.say(`${name}: ${formation}`);
    }
    const news = this.demonstrations.observe(frame.demonstrating);
    if (news) this.shell.live.say(news);
  }

  private announce(news: ControlNews): void {
    if (news.client !== this.client.clientId) return;
    const group = this.store.state.groups[news.index];
    const kind = KIND_NAMES[news.kind];
    this.shell.live.say(`${kind} on ${group?.name ?? 'the formation'}`);
  }

  private showOverlay(overlay: Overlay): void {
    const { state } = this.store;
    if (overlay.kind !== state.overlay || overlay.kind === OverlayKind.None) return;
    if (overlay.kind === OverlayKind.Cost && overlay.character !== state.chosen) return;
    const { cost, way, straight } = overlay;
    this.store.set({ ramp: fieldScale(overlay.values), cost: { cost, way, straight } });
    this.view.setOverlay(overlay);
  }

  private fit(): void {
    this.view.setPadding(this.shell.padding());
    this.view.fitCrowd();
  }

  private lookAt(point: GroundPoint): void {
    this.view.setPadding(this.shell.padding());
    this.view.lookAt(point);
  }

  private middle(): ScreenPoint {
    return { x: this.canvas.clientWidth / 2, y: this.canvas.clientHeight / 2 };
  }

  /** Once per drawn frame: moves leave, and what this frame shows is timed when it is done. */
  private readonly drawn = (): void => {
    requestAnimationFrame(this.drawn);
    this.touches.flush();
    if (this.client.state.phase === 'open') this.attention.consider(this.view.attention(), performance.now());
    this.shell.scale.update(this.view.pixelsPerMetre());
    this.stats?.show(this.view.stats);
    this.timePicture();
  };

  /** Times the touches whose effect the last picture shows. */
  private timePicture(): void {
    const shown = this.latency.takeDrawn(this.view.stats.shownFrame);
    if (shown.length === 0) return;
    // The task after this one: the scene has been drawn by then.
    const after = new MessageChannel();
    after.port1.onmessage = () => this.latency.drawn(shown, pageClock());
    after.port2.postMessage(null);
  }
}
