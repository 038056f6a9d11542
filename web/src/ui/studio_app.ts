// Wires client, scene, tools and panels.

import { LatencyMeter, pageClock } from '../engine/latency_meter';
import type { StudioClient } from '../engine/studio_client';
import { NoticeLevel, OverlayKind, ControlKind, type Frame, type GroupMesh, type Overlay, type Scene } from '../protocol/messages';
import { parseScene } from '../protocol/scene';
import { CameraGesture, OrbitGesture } from '../tools/camera_gesture';
import type { Contact } from '../tools/contact';
import { CrowdKeys } from '../tools/crowd_keys';
import { FormationHitTest } from '../tools/formation_hit_test';
import { HeldControls } from '../tools/held_controls';
import { PointerRouter } from '../tools/pointer_router';
import { ShortcutHandler } from '../tools/shortcuts';
import { SpaceKey } from '../tools/space_key';
import { ToolChooser } from '../tools/tool_chooser';
import { TouchEditor } from '../tools/touch_editor';
import { TouchSender } from '../tools/touch_sender';
import type { ScreenPoint } from '../view/camera_types';
import { fieldScale } from '../view/field_picture';
import type { StudioScene } from '../view/studio_view';
import { ControlWatch, KIND_NAMES, type ControlNews } from './control_watch';
import { formatClock } from './formatters';
import { FrameReader, sceneKey } from './frame_reader';
import { LayoutWatcher } from './layout';
import { HINT_KEY, StudioController } from './studio_controller';
import { StudioShell } from './studio_shell';
import { studioShortcuts } from './studio_shortcuts';
import { StudioStore } from './studio_state';
import { applyTheme, preferredTheme, readSetting } from './theme';

export class StudioApp {
  readonly latency = new LatencyMeter();
  readonly store = new StudioStore();
  /** Newest decoded frame. */
  frame: Frame | null = null;
  private sceneKey = '';
  private readonly meshes = new Map<number, GroupMesh>();
  private readonly reader = new FrameReader();
  private readonly watch = new ControlWatch();
  private readonly hitTest = new FormationHitTest();
  private readonly controller: StudioController;
  private readonly shell: StudioShell;
  private readonly touches: TouchSender;
  private readonly controls: HeldControls;
  private readonly chooser: ToolChooser;
  private readonly keys: CrowdKeys;

  constructor(
    private readonly client: StudioClient,
    private readonly view: StudioScene,
    private readonly canvas: HTMLCanvasElement,
    page: HTMLElement,
  ) {
    const say = (text: string): void => this.shell.live.say(text);
    this.controller = new StudioController(client, this.store, () => this.fit(), say);
    this.touches = new TouchSender(client, (time) => this.latency.touched(time));
    this.controls = new HeldControls(client, this.touches, () => client.clientId);
    const editor = new TouchEditor(this.touches, view);
    const camera = new CameraGesture(view.camera);
    const orbit = new OrbitGesture(view.camera);
    this.chooser = new ToolChooser({ scene: view, hitTest: this.hitTest, editor, camera, orbit, controls: this.controls });
    this.keys = new CrowdKeys(view, this.controls, this.chooser, () => this.middle(), say);
    const shortcuts = this.shortcuts();
    this.shell = new StudioShell(page, this.store, this.controller, shortcuts);
    new ShortcutHandler(window, shortcuts);
    new SpaceKey(window, (held) => (this.chooser.panning = held), () => this.controller.togglePlay());
    this.routePointers();
    this.followSettings();
    this.followClient();
    requestAnimationFrame(this.drawn);
  }

  private shortcuts() {
    const { keys, controller, store } = this;
    return studioShortcuts(controller, {
      arrow: (key, long) => keys.arrow(key, long),
      zoom: (factor) => keys.zoom(factor),
      turn: (radians) => keys.turn(radians),
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
  }

  /** Touching a formation chooses its group. */
  private chooseGroupOf({ ground }: Contact): void {
    const target = ground && this.chooser.formation(ground);
    if (target && target.index !== this.store.state.active) this.store.set({ active: target.index });
  }

  private pointed(contact: Contact): void {
    this.keys.pointer = contact.ground;
    const input = contact.kind === 'mouse' ? 'mouse' : 'touch';
    if (this.store.state.input !== input) this.store.set({ input });
    if (contact.kind !== 'mouse' || !contact.ground) return;
    const over = this.chooser.grab(contact.ground) ? 'grab' : this.chooser.formation(contact.ground) ? 'pointer' : 'default';
    if (this.canvas.style.cursor !== over) this.canvas.style.cursor = over;
  }

  private tapped(contact: Contact): void {
    if (this.store.state.overlay !== OverlayKind.Cost) return;
    const box = this.canvas.getBoundingClientRect();
    const picked = this.view.pick(contact.screen.x + box.left, contact.screen.y + box.top);
    if (picked && picked.character >= 0) this.controller.chooseCharacter(picked.character);
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
      const lost = link.phase !== 'open' && store.state.loaded;
      view.setLost(lost);
      document.documentElement.toggleAttribute('data-lost', lost);
      if (link.phase !== 'open') this.forgetTouches();
    });
    client.on('welcome', (welcome) => store.set({ scenarios: welcome.scenarios }));
    client.on('scene', (scene) => this.showScene(scene));
    client.on('groupMesh', (mesh) => {
      this.meshes.set(mesh.group, mesh);
      this.hitTest.setMesh(mesh);
      this.reader.setMesh(mesh);
      view.setGroupMesh(mesh);
    });
    client.on('frame', ({ frame, receivedAt }) => this.showFrame(frame, receivedAt));
    client.on('overlay', (overlay) => this.showOverlay(overlay));
    client.on('notice', (notice) => store.set({ notice }));
  }

  private forgetTouches(): void {
    this.controls.clear();
    this.latency.reset();
  }

  private showScene(message: Scene): void {
    try {
      const scene = parseScene(message.json);
      this.reader.setScene(scene);
      this.store.set({ title: scene.title, scenario: scene.name, credit: scene.credit, loaded: true });
      // A scene comes again when only a parameter or a count changed: that must not move the camera.
      const key = sceneKey(scene);
      if (key === this.sceneKey) return;
      this.sceneKey = key;
      this.forgetTouches();
      this.store.set({ active: 0, notice: null });
      this.view.setScene(scene);
      this.view.setPadding(this.shell.padding());
      for (const mesh of this.meshes.values()) this.view.setGroupMesh(mesh);
    } catch (error) {
      const text = `The scene could not be shown: ${String(error)}`;
      this.store.set({ notice: { type: 'Notice', level: NoticeLevel.Error, code: 'scene', text } });
    }
  }

  private showFrame(frame: Frame, receivedAt: number): void {
    this.frame = frame;
    this.hitTest.setGroups(frame.groups);
    this.chooser.observe(frame);
    this.keys.observe(frame);
    this.controls.observe(frame);
    this.view.pushFrame(frame, receivedAt);
    this.latency.echoed(frame.touchEcho, frame.frame, pageClock(receivedAt));
    this.timePicture();
    this.store.set(this.reader.change(frame, this.store.state));
    for (const news of this.watch.observe(frame)) this.announce(news);
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

  private middle(): ScreenPoint {
    return { x: this.canvas.clientWidth / 2, y: this.canvas.clientHeight / 2 };
  }

  /** Once per drawn frame: moves leave, and what this frame shows is timed when it is done. */
  private readonly drawn = (): void => {
    requestAnimationFrame(this.drawn);
    this.touches.flush();
    this.shell.scale.update(this.view.pixelsPerMetre());
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
