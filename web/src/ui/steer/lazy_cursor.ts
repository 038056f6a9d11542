// The cursor of the keys, loaded with the first tool that draws on the ground.

import type { StudioScene } from '../../scene/studio_scene';
import type { HandMoves, Padding } from '../../scene/camera/camera_controls';
import type { Scene } from '../../protocol/messages';
import type { StudioFrame } from '../../model/studio_frame';
import type { GroundPoint } from '../../model/plane';
import type { ToolName } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { StudioClient } from '../../link/studio_client';
import type { Contact, ContactOwner } from '../../tools/contact';
import type { CursorHost, GroundCursor } from '../../tools/ground_cursor';
import type { ArrowKey } from '../../tools/keyboard_steering';
import { couldNotLoad, once } from '../widgets/lazily';

export interface CursorParts {
  readonly client: Pick<StudioClient, 'on'>;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly canvas: HTMLCanvasElement;
  readonly camera: HandMoves;
  padding(): Padding;
  choose(contact: Contact): ContactOwner;
  frame(): StudioFrame | null;
  say(text: string): void;
}

/** Who draws on the ground instead of the tools of the scene. */
export interface CursorUser {
  choose(contact: Contact): ContactOwner;
  /** As CursorHost.picks(), asked once a stroke has begun. */
  picks(): boolean;
}

const kPicks: readonly ToolName[] = ['follow', 'leave', 'wait', 'place'];
/** The cursor keeps so far from the panels [CSS px]. */
const kMargin = 30;

/** The part of a picture that panels leave free, however small it is. */
export function roomWithin(
  canvas: HTMLCanvasElement,
  { top, right, bottom, left }: Padding,
): ReturnType<CursorHost['room']> {
  const span = (size: number, before: number, after: number): readonly [number, number] => {
    const [from, to] = [before + kMargin, size - after - kMargin];
    return from < to ? [from, to] : [size / 2, size / 2];
  };
  const [x, y] = [span(canvas.clientWidth, left, right), span(canvas.clientHeight, top, bottom)];
  return { from: { x: x[0], y: y[0] }, to: { x: x[1], y: y[1] } };
}

export class LazyCursor {
  private parts_: CursorParts | null = null;
  private scene_: Scene | null = null;
  private cursor_: GroundCursor | null = null;
  private user_: CursorUser | null = null;
  private readonly loaded_ = once(() => this.load(this.parts_!));

  serve(parts: CursorParts): void {
    const { client, store, canvas } = parts;
    this.parts_ = parts;
    client.on('scene', (scene) => (this.scene_ = scene));
    canvas.addEventListener('focus', () => this.showOrHide());
    canvas.addEventListener('pointerdown', () => this.cursor_?.hide(), { capture: true });
    store.watch(['tool'], () => this.showOrHide());
  }

  /** Null gives it back to the tools of the scene. */
  lend(user: CursorUser | null): void {
    this.cursor_?.hide();
    this.user_ = user;
  }

  hide(): void {
    this.cursor_?.hide();
  }

  /** The keys go on to the ground, where the cursor is shown. */
  focus(): void {
    this.parts_?.canvas.focus();
    void this.loaded().then((cursor) => cursor.show());
  }

  /** Where it is shown; null while it is away. */
  get at(): GroundPoint | null {
    return this.parts_?.view.orders.cursor ?? null;
  }

  /** True where arrows and Enter are the cursor's. */
  get takesKeys(): boolean {
    return this.user_ !== null || this.parts_?.store.state.tool !== 'steer';
  }

  arrow(key: ArrowKey, long: boolean): void {
    this.use((cursor) => cursor.arrow(key, long));
  }

  press(shift: boolean): void {
    this.use((cursor) => cursor.press(shift));
  }

  giveUp(): boolean {
    return this.cursor_?.giveUp() ?? false;
  }

  /** Who works with keys sees it as soon as the tool is in hand. */
  private showOrHide(): void {
    if (!this.takesKeys) return this.cursor_?.hide();
    if (this.parts_?.canvas.matches(':focus-visible')) this.use((cursor) => cursor.show());
  }

  private use(act: (cursor: GroundCursor) => void): void {
    void this.loaded_().then(act, () => couldNotLoad(this.parts_!.store));
  }

  private async load(parts: CursorParts): Promise<GroundCursor> {
    const [module, { spotWords }] = await Promise.all([
      import('../../tools/ground_cursor'),
      import('../../model/spot_words'),
    ]);
    const { view, camera, store, canvas } = parts;
    this.cursor_ = new module.GroundCursor({
      view,
      camera,
      show: (at) => (view.orders.cursor = at),
      room: () => roomWithin(canvas, parts.padding()),
      choose: (contact) => (this.user_ ?? parts).choose(contact),
      picks: () => this.user_?.picks() ?? kPicks.includes(store.state.tool),
      words: (at) => {
        const groups = (parts.frame()?.groups ?? []).map((group) => ({
          ...group,
          name: store.state.groups.find(({ id }) => id === group.id)?.name ?? 'the group',
        }));
        return this.scene_ ? spotWords(at, this.scene_, groups) : '';
      },
      forecast: () => view.orders.words,
      say: (text) => parts.say(text),
    });
    return this.cursor_;
  }
}
