// The time line of the open take: where it stands, which part of it plays, and what can be done with it.

import { formatClock, formatSpeed } from '../../model/formatters';
import type { TakeActions } from '../../model/take_actions';
import { withPiece, type OpenTake } from '../../model/take_facts';
import { element, setPressed, setText } from '../widgets/dom';
import { Popover } from '../widgets/popover';
import { toolButton } from '../widgets/tool_button';
import { TimeTrack } from './time_track';

/** Speeds that a part can have. */
const kPieceSpeeds: readonly number[] = [0.125, 0.25, 0.5, 2, 4, 8];

export class TimeLine {
  readonly track: TimeTrack;
  private readonly title_ = element('strong', { class: 'time-title' });
  private readonly clock_ = element('span', { class: 'time-clock' });
  private readonly loop_: HTMLButtonElement;
  private readonly pieces_ = element('div', {
    class: 'speed-pieces panel',
    role: 'group',
    'aria-label': 'Slow and fast',
  });
  private readonly stored_ = element(
    'p',
    { class: 'time-stored', role: 'note', hidden: true },
    'Recorded by another version of Muster: it plays from its stored frames and cannot be changed.',
  );
  readonly root: HTMLElement;
  private take_: OpenTake | null = null;

  /** `camera`: the menu of the film camera. */
  constructor(
    private readonly actions_: TakeActions,
    camera: HTMLElement | null = null,
  ) {
    this.track = new TimeTrack(actions_);
    this.loop_ = toolButton({
      icon: 'patrol',
      label: 'Loop',
      className: 'time-loop',
      pressed: false,
      tip: 'Play the part over and over',
      act: () => actions_.setLoop(!this.take_?.loop),
    });
    const again = toolButton({
      icon: 'steer',
      label: 'Take again',
      className: 'time-again',
      tip: 'Direct from this moment on: a new take with this beginning',
      act: () => actions_.takeAgain(false),
    });
    const layer = toolButton({
      icon: 'layers',
      label: 'On top',
      className: 'time-layer',
      tip: 'Direct on top of what was recorded, from this moment on',
      act: () => actions_.takeAgain(true),
    });
    const slow = toolButton({ icon: 'dials', label: 'Speed', className: 'time-speed', tip: 'Slow and fast parts' });
    const out = toolButton({
      icon: 'download',
      label: 'Export',
      className: 'time-export',
      tip: 'Files for other programs, pictures and films',
      act: () => actions_.exportTake(),
    });
    const close = toolButton({
      icon: 'close',
      label: 'Leave the take',
      iconOnly: true,
      className: 'time-close',
      act: () => actions_.leaveTake(),
    });
    new Popover(slow, this.pieces_, 'top-end', () => this.fillPieces());
    const holder = element('span', { class: 'time-speed-holder' }, slow, this.pieces_);
    this.root = element(
      'section',
      { class: 'time-line panel', 'aria-label': 'Time line', hidden: true },
      element(
        'div',
        { class: 'time-head' },
        element('div', { class: 'time-words' }, this.title_, this.clock_),
        element('div', { class: 'time-tools' }, again, layer, this.loop_, holder, ...(camera ? [camera] : []), out),
        close,
      ),
      element('div', { class: 'time-track-holder' }, this.track.root),
      this.stored_,
    );
  }

  /** Another button, beside those that direct again. */
  addTool(tool: HTMLElement): void {
    this.loop_.before(tool);
  }

  /** Null: no take is open. */
  setTake(take: OpenTake | null, title: string): void {
    this.take_ = take;
    this.root.hidden = take === null;
    if (!take) return;
    setText(this.title_, title);
    setPressed(this.loop_, take.loop);
    this.stored_.hidden = !take.stored;
    this.root.toggleAttribute('data-stored', take.stored);
    this.track.setTake(take);
    this.showClock();
    if (!this.pieces_.hidden) this.fillPieces();
  }

  setStep(step: number): void {
    this.track.setStep(step);
    this.showClock();
  }

  private showClock(): void {
    if (!this.take_) return;
    const { from, to, stepTime } = this.take_;
    const at = formatClock((this.track.step - from) * stepTime);
    setText(this.clock_, `${this.track.step < from ? '\u2212' : ''}${at} of ${formatClock((to - from) * stepTime)}`);
  }

  private fillPieces(): void {
    const take = this.take_;
    if (!take) return;
    const now = this.track.step * take.stepTime;
    const adders = [0.5, 2].map((speed) => {
      const pieces = withPiece(take, now, speed);
      const button = element(
        'button',
        { type: 'button', class: 'soft', disabled: pieces === null },
        `${formatSpeed(speed)} from here`,
      );
      button.addEventListener('click', () => pieces && this.actions_.setSpeeds(pieces));
      return button;
    });
    const rows = take.speeds.map((_, index) => this.pieceRow(take, index));
    const note =
      rows.length > 0
        ? element(
            'p',
            { class: 'secondary' },
            'Speeds come and go within the easing time; films and exports have them.',
          )
        : element('p', { class: 'secondary' }, 'Makes two seconds from the shown moment slow or fast.');
    this.pieces_.replaceChildren(element('div', { class: 'speed-add' }, ...adders), ...rows, note);
  }

  private pieceRow(take: OpenTake, index: number): HTMLElement {
    const piece = take.speeds[index]!;
    const change = (next: Partial<typeof piece>): void => {
      const speeds = take.speeds.map((one, i) => (i === index ? { ...one, ...next } : one));
      this.actions_.setSpeeds(speeds);
    };
    const number = (label: string, value: number, set: (value: number) => void): HTMLElement => {
      const input = element('input', {
        type: 'number',
        min: 0,
        step: 0.1,
        value: Number(value.toFixed(2)),
        'aria-label': `${label} of part ${index + 1} in seconds`,
      });
      input.addEventListener('change', () => Number.isFinite(input.valueAsNumber) && set(input.valueAsNumber));
      return element('label', {}, label, input);
    };
    const select = element('select', { 'aria-label': `Speed of part ${index + 1}` });
    for (const speed of [...new Set([...kPieceSpeeds, piece.speed])].sort((a, b) => a - b))
      select.append(element('option', { value: speed, selected: speed === piece.speed }, formatSpeed(speed)));
    select.addEventListener('change', () => change({ speed: Number(select.value) }));
    const remove = toolButton({
      icon: 'close',
      label: `Remove part ${index + 1}`,
      iconOnly: true,
      act: () => this.actions_.setSpeeds(take.speeds.filter((_, i) => i !== index)),
    });
    return element(
      'div',
      { class: 'speed-piece' },
      number('from', piece.from, (from) => change({ from })),
      number('to', piece.to, (to) => change({ to })),
      select,
      number('ease', piece.ease, (ease) => change({ ease })),
      remove,
    );
  }
}
