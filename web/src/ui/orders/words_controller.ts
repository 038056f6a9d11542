// Directing by words: asks what a sentence would do while it is typed, shows that on the ground, and has it done.

import type { StudioClient } from '../../link/studio_client';
import { outlineOf } from '../../model/group_shapes';
import { forecastOf } from '../../model/forecast';
import { pointsOf } from '../../model/plane';
import { unfitWords } from '../../model/stand';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import { SayAct, type Said } from '../../protocol/messages';
import type { StudioScene } from '../../scene/studio_scene';
import { PanelLayout } from '../widgets/panel_layout';
import { arrivalText } from './queue_controller';
import { WordsLine } from './words_line';
import '../styles/words.css';

export interface WordsParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: Pick<StudioScene, 'orders'>;
  readonly canvas: HTMLElement;
  readonly page: HTMLElement;
  readonly frame: () => StudioFrame | null;
}

/** After the last letter [ms]. */
const kPause = 120;
/** It is asked about again after so long, as the crowd goes on [ms]. */
const kAgain = 1500;

export class WordsController {
  private readonly line_: WordsLine;
  private number_ = 0;
  private timer_: ReturnType<typeof setTimeout> | undefined;
  private text_ = '';

  constructor(private readonly parts_: WordsParts) {
    const { client, page, store } = parts_;
    this.line_ = new WordsLine({
      typed: (text) => this.typed(text),
      say: (text) => this.ask(text, SayAct.Do),
      leave: () => store.set({ words: false }),
    });
    PanelLayout.of(page).add('words', this.line_.root);
    client.on('said', (said) => said.number === this.number_ && this.answered(said));
  }

  setOpen(open: boolean): void {
    this.line_.setOpen(open);
    clearTimeout(this.timer_);
    if (open) return this.typed(this.text_);
    this.show(null);
    this.parts_.canvas.focus({ preventScroll: true });
  }

  private typed(text: string): void {
    this.text_ = text;
    clearTimeout(this.timer_);
    this.timer_ = setTimeout(() => this.ask(text, text.trim() ? SayAct.Preview : SayAct.Complete), kPause);
  }

  private ask(text: string, act: SayAct): void {
    clearTimeout(this.timer_);
    const { client, store } = this.parts_;
    const chosen = Uint32Array.from(store.state.selected);
    client.send({ type: 'Say', number: ++this.number_, act, text, chosen });
    // Also where no answer comes.
    if (act === SayAct.Preview) this.timer_ = setTimeout(() => this.ask(text, act), kAgain);
  }

  private answered(said: Said): void {
    const { store } = this.parts_;
    if (said.act === SayAct.Do) {
      this.show(null);
      clearTimeout(this.timer_);
      this.line_.done(said);
      if (!said.problem) this.text_ = '';
      return;
    }
    this.line_.show(said);
    if (store.state.words) this.show(said);
  }

  /** On the ground. */
  private show(said: Said | null): void {
    const { orders } = this.parts_.view;
    if (!said || said.places.length + said.forecasts.length === 0) {
      orders.previewOrder(null);
      return orders.previewForecasts([]);
    }
    const groups = this.parts_.frame()?.groups ?? [];
    const indexOf = (group: number): number => groups.findIndex(({ id }) => id === group);
    const moves = said.places.map(({ group, places, unfit }) => {
      const points = pointsOf(places);
      return { index: indexOf(group), places: points, outline: outlineOf(points), unfit };
    });
    const forecasts = said.forecasts.map(forecastOf);
    const text = arrivalText(forecasts.map(({ arrives, seconds }) => (arrives ? seconds : Infinity)));
    const note = unfitWords(said.places.map(({ unfit }) => unfit));
    orders.previewOrder({ moves, rectangle: [], route: [], ...(note.warns ? { note } : {}) });
    orders.previewForecasts(
      forecasts.map(({ group, way, arrives }, k) => ({
        index: indexOf(group),
        way,
        arrives,
        text: k === 0 ? text : '',
      })),
    );
  }
}
