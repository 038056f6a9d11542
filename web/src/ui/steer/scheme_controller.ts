// The control scheme of this page: who judges pointers, what it shows, and its keys.

import { NoticeLevel, type Marks } from '../../protocol/messages';
import { pointsOf } from '../../model/plane';
import type { StudioStore } from '../../model/studio_store';
import type { StudioClient } from '../../link/studio_client';
import type { OrderPicture } from '../../scene/order_picture';
import type { Contact, ContactOwner } from '../../tools/contact';
import { isKeyOf, RawInputs } from '../../tools/raw_inputs';
import type { SchemeView } from '../../scene/marks/scheme_marks';
import type { GroundSight } from '../../scene/camera/camera_controls';

const kMiddle = 1;

/** The marks of a scheme for the scene. */
export function schemeView(marks: Marks): SchemeView {
  return {
    selected: new Set(marks.selected),
    rectangle: pointsOf(marks.rectangle),
    stroke: pointsOf(marks.stroke),
    goals: pointsOf(marks.goals),
    pointers: pointsOf(marks.pointers),
  };
}

export interface SchemeScene {
  readonly camera: GroundSight;
  readonly orders: Pick<OrderPicture, 'setScheme'>;
}

type OrderControllerClient = Pick<StudioClient, 'send' | 'on'>;

/** Controls to compare the studio's own with, by their names at the server. */
const kTitles: Readonly<Record<string, string>> = {
  touch: 'Fingers alone',
  'mouse-paper': 'Mouse: select and send',
  'mouse-full-continuum': 'Mouse: selections that flow to their goal',
  'mouse-full-free': 'Mouse: selections that stand in formation',
  'mouse-mesh': 'Mouse and keys on the mesh',
};

export class SchemeController {
  private readonly inputs_: RawInputs;
  private told_ = '';

  /** `say` speaks to the live region, `sent` hears the times of inputs that leave. */
  constructor(
    private readonly client_: OrderControllerClient,
    private readonly store_: StudioStore,
    private readonly scene_: SchemeScene,
    private readonly say_: (text: string) => void,
    sent: (time: number) => void,
  ) {
    this.inputs_ = new RawInputs(client_, () => scene_.camera.seenGround(), sent);
    client_.on('welcome', ({ schemes }) => {
      this.store_.set({ schemes: schemes.map((one) => ({ ...one, title: kTitles[one.name] ?? one.title })) });
      this.inputs_.forget();
      // A server that was found again has forgotten the choice.
      if (this.active) this.client_.send({ type: 'SetScheme', name: this.store_.state.scheme });
    });
    client_.on('marks', (marks) => this.show(marks));
    store_.watch(['scheme'], ({ scheme }) => this.choose(scheme));
    window.addEventListener('keydown', (event) => this.pressed(event), true);
    requestAnimationFrame(this.drawn);
  }

  /** A scheme of the server judges what pointers do. */
  get active(): boolean {
    return this.store_.state.scheme !== '';
  }

  /** Who owns a contact; null where it is the page's own business. */
  owner({ kind, button }: Contact): ContactOwner | null {
    const camera = kind === 'mouse' && button === kMiddle;
    return this.active && !camera ? this.inputs_ : null;
  }

  private choose(scheme: string): void {
    this.inputs_.forget();
    if (scheme === '' && this.told_ === '') return;
    this.told_ = scheme;
    this.client_.send({ type: 'SetScheme', name: scheme });
    this.scene_.orders.setScheme(null);
    const info = this.store_.state.schemes.find(({ name }) => name === scheme);
    this.say_(`Control: ${info?.title ?? 'the studio’s own'}`);
  }

  private show(marks: Marks): void {
    this.scene_.orders.setScheme(marks.scheme === '' ? null : schemeView(marks));
    if (marks.notice === '') return;
    const text = `${marks.notice}.`;
    this.store_.set({
      notice: { type: 'Notice', level: NoticeLevel.Info, code: 'control', text, hasPlace: false, x: 0, y: 0 },
    });
  }

  /** Before the page's own keys. */
  private pressed(event: KeyboardEvent): void {
    const { target } = event;
    const elsewhere = target instanceof Element && target.closest('input, textarea, select, dialog, button') !== null;
    if (elsewhere || !isKeyOf(this.store_.state.scheme, event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (!event.repeat) this.inputs_.key(event);
  }

  private readonly drawn = (): void => {
    requestAnimationFrame(this.drawn);
    this.inputs_.flush();
  };
}
