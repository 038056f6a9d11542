// Pointers and keys of a trial: all of them go to the server as they come, and nowhere else.

import type { StudyState } from '../../protocol/messages';
import type { MessageSender } from '../../link/studio_client';
import type { StudioScene } from '../../scene/studio_scene';
import type { Contact, ContactOwner } from '../../tools/contact';
import { PointerRouter } from '../../tools/pointer_router';
import { isKeyOf, RawInputs } from '../../tools/raw_inputs';

type Seen = Pick<StudioScene, 'camera' | 'screenToWorld' | 'touchMark'>;

const kNobody: ContactOwner = { begin: () => undefined, move: () => undefined, end: () => undefined };

export class TrialPointers implements ContactOwner {
  private readonly inputs_: RawInputs;
  private trial_: StudyState | null = null;

  /** `tell` says what a person should do instead. */
  constructor(
    client: MessageSender,
    private readonly view_: Seen,
    private readonly canvas_: HTMLCanvasElement,
    private readonly tell_: (text: string) => void,
  ) {
    this.inputs_ = new RawInputs(client, () => view_.camera.seenGround());
    new PointerRouter(canvas_, (at) => view_.screenToWorld(at), {
      choose: (contact) => this.ownerOf(contact),
      tapped: () => undefined,
      doubleClicked: () => undefined,
      wheel: () => undefined,
      pointed: () => undefined,
    });
    window.addEventListener('keydown', (event) => this.pressed(event), true);
  }

  /** Size of a pixel of the display [mm]. */
  set mmPerPixel(size: number) {
    this.inputs_.mmPerPixel = size;
  }

  /** The trial that goes on, or null. */
  setTrial(trial: StudyState | null): void {
    this.trial_ = trial;
    this.canvas_.style.cursor = trial === null || trial.touch ? 'default' : 'crosshair';
  }

  begin(contact: Contact): void {
    this.mark(contact, true);
    this.inputs_.begin(contact);
  }

  move(contacts: readonly Contact[]): void {
    this.mark(contacts[contacts.length - 1]!, true);
    this.inputs_.move(contacts);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.mark(contact, false);
    this.inputs_.end(contact, cancelled);
  }

  /** The server has to be told anew how the scene is seen. */
  forget(): void {
    this.inputs_.forget();
  }

  look(): void {
    if (this.trial_) this.inputs_.look();
  }

  flush(): void {
    this.inputs_.flush();
  }

  /** Each control has its own device: the other one would not be what is compared. */
  private ownerOf({ kind }: Contact): ContactOwner {
    if (!this.trial_) return kNobody;
    if (this.trial_.touch === (kind !== 'mouse')) return this;
    this.tell_(this.trial_.touch ? 'Use your fingers on the screen.' : 'Use the mouse.');
    return kNobody;
  }

  private mark({ kind, pointer, ground }: Contact, down: boolean): void {
    if (kind !== 'mouse') this.view_.touchMark(pointer, down ? ground : null, 0);
  }

  private pressed(event: KeyboardEvent): void {
    if (!this.trial_ || !isKeyOf(this.trial_.scheme, event)) return;
    event.preventDefault();
    if (!event.repeat) this.inputs_.key(event);
  }
}
