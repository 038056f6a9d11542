// Takes back what this director did last, whatever it was, and does it again. The server keeps the history; this tells
// what came of it.

import type { MessageSender, StudioClient } from '../../link/studio_client';
import type { HistoryFacts } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { EditHistory } from '../../protocol/messages';
import { word } from '../../protocol/problem';
import { ThreeFingerTap } from '../../tools/three_finger_tap';

/** How long it is told what was taken back [ms]. */
const kToldMs = 2500;

const kFirst = ', first';

/** The label of what fingers have dragged. */
const kDrag = 'Drag';

/** The label of an edit that goes with the next one, of this label: both are taken back, and done again, together. An edit that
 * needs the id of what another one makes cannot be one with it. */
export function firstOf(label: string): string {
  return label && label + kFirst;
}

export class HistoryController {
  /** What was asked for and not answered yet. */
  private asked_: { readonly redo: boolean; readonly before: HistoryFacts } | null = null;
  private timer_: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly client_: MessageSender,
    private readonly store_: StudioStore,
    /** What this director holds: "line"; null for nothing. */
    private readonly held_: () => string | null = () => null,
  ) {}

  /** `canvas`: three fingers that tap on it take back. */
  listen(client: StudioClient, canvas: HTMLElement): void {
    client.on('editHistory', (history) => this.took(history));
    client.on('notice', ({ code }) => {
      if (code === 'UndoEdit') this.asked_ = null;
    });
    client.on('welcome', () => {
      this.asked_ = null;
      this.store_.set({ history: { undo: 0, undoLabel: '', redo: 0, redoLabel: '' } });
    });
    new ThreeFingerTap(canvas, () => {
      const { tool, scheme, replaying } = this.store_.state;
      // With these, with other control schemes, and in takes, fingers do something else.
      if (tool !== 'draw' && tool !== 'place' && scheme === '' && !replaying) this.undo();
    });
  }

  undo(redo = false): void {
    const { history } = this.store_.state;
    if ((redo ? history.redo : history.undo) === 0) return this.tell(this.nothing(redo));
    this.ask(redo);
  }

  /** Without a look at what is known: an edit may just have been sent. */
  ask(redo: boolean): void {
    this.asked_ ??= { redo, before: this.store_.state.history };
    this.client_.send({ type: 'UndoEdit', redo });
  }

  took({ undo, undoLabel, redo, redoLabel }: Omit<EditHistory, 'type' | 'edited'>): void {
    const plain = (label: string): string => label.replace(kFirst, '');
    this.store_.set({ history: { undo, undoLabel: plain(undoLabel), redo, redoLabel: plain(redoLabel) } });
    const { asked_: asked } = this;
    if (!asked) return;
    if (asked.redo ? undo <= asked.before.undo : redo <= asked.before.redo) {
      const gone = asked.redo ? redo < asked.before.redo : undo < asked.before.undo;
      if (!gone) return;
      this.asked_ = null;
      return this.tell('Nothing of it was left');
    }
    this.asked_ = null;
    const [gone, next] = asked.redo ? [undoLabel, redoLabel] : [redoLabel, undoLabel];
    if (asked.redo ? gone === firstOf(next) : next === firstOf(gone)) return this.ask(asked.redo);
    const walks = gone === kDrag && !asked.redo ? '. The crowd walks back' : '';
    this.tell(`${asked.redo ? 'Done again' : 'Undone'}: ${plain(gone)}${walks}`);
  }

  private nothing(redo: boolean): string {
    const held = redo ? null : this.held_();
    const more = held ? `. Esc lets go of the ${held}` : '';
    return `There is nothing to ${redo ? 'redo' : 'undo'}${more}`;
  }

  private tell(text: string): void {
    const notice = word('undo', text);
    this.store_.set({ notice });
    clearTimeout(this.timer_);
    this.timer_ = setTimeout(() => {
      if (this.store_.state.notice === notice) this.store_.set({ notice: null });
    }, kToldMs);
  }
}
