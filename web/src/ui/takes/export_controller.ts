// Carries out what the export dialog asks: files by the server, films and pictures by the page.

import type { StudioScene } from '../../scene/studio_scene';
import type { StudioStore } from '../../model/studio_store';
import type { OpenTake } from '../../model/take_facts';
import { formatBytes, formatLengthOf } from '../../model/take_facts';
import { ExportDialog } from './export_dialog';
import type { ExportChoice, ExportGroup } from './export_kinds';
import { FilmMaker, canMakeFilms, type Film } from './film_maker';
import { PictureSeries } from './picture_series';
import { saveBlob } from '../../link/answers';
import type { ExportWish, ShelfLink } from '../../link/shelf_link';
import { ServerExport } from './take_exports';
import { plainBackdrop, skyBackdrop, solidBackdrop } from '../../scene/backdrop';
import { afterNextPicture } from '../../scene/scene_picture';

/** What is exported. */
export interface ExportSubject {
  /** On the shelf; empty where it lies elsewhere. */
  readonly name: string;
  readonly title: string;
  readonly from: number;
  readonly to: number;
  readonly steps: number;
  readonly stepTime: number;
  /** None where they are not known. */
  readonly groups: readonly ExportGroup[];
}

export interface ExportHost {
  readonly shelf: ShelfLink;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly canvas: HTMLCanvasElement;
  /** The open take; opens that one first where it is another. */
  opened(name: string): Promise<OpenTake>;
  /** Shows a step of the open take; resolves when the scene's newest picture is of it. */
  show(step: number): Promise<void>;
}

const kClean = { mesh: false, places: false, paths: false };
const kNoPart = 'The part ends before it begins.';
const kNoShelf = 'This take lies on no shelf: save it as a file and open that first.';

function plainName(title: string): string {
  return title.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '') || 'take';
}

const tenth = (seconds: number): number => Math.round(seconds * 10) / 10;

export class ExportController {
  readonly dialog: ExportDialog;
  private subject_: ExportSubject | null = null;
  private running_: { cancel(): void } | null = null;
  private sizing_: ServerExport | null = null;

  constructor(private readonly host_: ExportHost) {
    this.dialog = new ExportDialog((kind) => !kind.film || canMakeFilms(), {
      begin: (choice) => void this.begin(choice),
      cancel: () => {
        this.sizing_?.cancel();
        this.running_?.cancel();
      },
      size: (choice) => this.size(choice),
    });
  }

  open(subject: ExportSubject): void {
    this.subject_ = subject;
    const { title, from, to, steps, stepTime, groups } = subject;
    const end = tenth(steps * stepTime);
    this.dialog.open({ title, from: tenth(from * stepTime), to: Math.min(end, tenth(to * stepTime)), end, groups });
  }

  private async begin(choice: ExportChoice): Promise<void> {
    const subject = this.subject_;
    if (!subject || this.running_) return;
    this.sizing_?.cancel();
    this.dialog.setRunning(true);
    try {
      this.dialog.say(await this.make(choice, subject));
    } catch (error) {
      this.dialog.say(error instanceof Error ? error.message : String(error));
    } finally {
      this.running_ = null;
      this.dialog.setRunning(false);
    }
  }

  private make(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    if (choice.kind.series) return this.series(choice, subject);
    return choice.kind.here ? this.picture(choice, subject) : this.file(choice, subject);
  }

  /** What the server is asked for. */
  private wish(choice: ExportChoice, { name, steps, stepTime }: ExportSubject): ExportWish {
    if (name === '') throw new Error(kNoShelf);
    const end = steps * stepTime;
    const { groups, people, kind, fps } = choice;
    const to = choice.to >= tenth(end) ? end : choice.to;
    const who = { ...(groups.length > 0 && { groups }), ...(people && { people }) };
    return { take: name, format: kind.name, from: choice.from, to, fps, speeds: true, ...who };
  }

  private async file(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    const run = new ServerExport(this.host_.shelf);
    this.running_ = run;
    const done = await run.run(this.wish(choice, subject), (share) => this.dialog.setProgress(share));
    return done ? `Saved ${done.file}, ${formatBytes(done.bytes)}.` : 'Cancelled.';
  }

  /** How large it will be; null where something else is asked meanwhile. */
  private async size(choice: ExportChoice): Promise<string | null> {
    this.sizing_?.cancel();
    this.sizing_ = null;
    const subject = this.subject_;
    if (!subject || this.running_ || choice.kind.name === 'picture') return null;
    if (choice.kind.here) {
      const seconds = choice.to - choice.from;
      if (seconds < 0) return kNoPart;
      return `${Math.floor(seconds * choice.fps) + 1} pictures, ${formatLengthOf(seconds)}`;
    }
    const run = new ServerExport(this.host_.shelf);
    this.sizing_ = run;
    try {
      const told = await run.estimate(this.wish(choice, subject));
      if (!told || this.sizing_ !== run) return null;
      return `About ${formatBytes(told.bytes)}, ${told.people === 1 ? '1 person' : `${told.people} people`}`;
    } catch (error) {
      return this.sizing_ === run && error instanceof Error ? error.message : null;
    }
  }

  /** A film, or pictures of people without background. */
  private async series(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    const { kind, fps, size } = choice;
    const maker = kind.film
      ? new FilmMaker({ draw: (step, onto) => this.draw(step, onto) })
      : new PictureSeries({
          show: (step) => this.host_.show(step),
          drawPeople: (dark, bright) => this.drawPeople(dark, bright, choice.shadows),
        });
    if (choice.to < choice.from) throw new Error(kNoPart);
    this.running_ = maker;
    const take = await this.host_.opened(subject.name);
    const steps = (seconds: number): number => Math.min(take.steps, Math.max(0, Math.round(seconds / take.stepTime)));
    const part = { ...take, from: steps(choice.from), to: steps(choice.to) };
    const wish = { fps, width: size[0], height: size[1] };
    const made = await this.dressed<Film | Blob | null>(choice, () =>
      maker.make(part, wish, (share) => this.dialog.setProgress(share)),
    );
    if (!made) return 'Cancelled.';
    const [blob, ending] = made instanceof Blob ? [made, '-pictures.zip'] : [made.blob, `.${made.ending}`];
    return this.saved(blob, subject, ending);
  }

  private async picture(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    this.running_ = { cancel: () => undefined };
    const blob = await this.dressed(choice, () => this.wholePicture());
    if (!blob) throw new Error('This browser makes no picture of the scene.');
    return this.saved(blob, subject, '.png');
  }

  private saved(blob: Blob, { title }: ExportSubject, ending: string): string {
    const name = plainName(title) + ending;
    saveBlob(blob, name);
    return `Saved ${name}, ${formatBytes(blob.size)}.`;
  }

  /** While `work` lasts: without marks and under a sky, where that is chosen, and nothing solid is seen through. */
  private async dressed<T>({ clean, sky }: ExportChoice, work: () => Promise<T>): Promise<T> {
    const { view, store } = this.host_;
    view.setLayers(clean ? kClean : store.state.layers, sky ? skyBackdrop(store.state.theme) : solidBackdrop());
    try {
      return await work();
    } finally {
      view.setLayers(store.state.layers);
    }
  }

  private wholePicture(): Promise<Blob | null> {
    const { view, canvas } = this.host_;
    return new Promise((done) => afterNextPicture(view, () => canvas.toBlob(done, 'image/png')));
  }

  private async draw(step: number, onto: HTMLCanvasElement): Promise<void> {
    await this.host_.show(step);
    await this.copyPicture(onto);
  }

  private async drawPeople(dark: HTMLCanvasElement, bright: HTMLCanvasElement, shadows: boolean): Promise<void> {
    const { view, store } = this.host_;
    for (const [onto, colour] of [
      [dark, '#000'],
      [bright, '#fff'],
    ] as const) {
      view.setLayers(kClean, plainBackdrop(colour, shadows, store.state.theme));
      await this.copyPicture(onto);
    }
  }

  /** The scene's next picture, as large as it fills the canvas. */
  private copyPicture(onto: HTMLCanvasElement): Promise<void> {
    const { view, canvas } = this.host_;
    return new Promise((done) =>
      afterNextPicture(view, () => {
        const scale = Math.max(onto.width / canvas.width, onto.height / canvas.height);
        const [w, h] = [canvas.width * scale, canvas.height * scale];
        const context = onto.getContext('2d')!;
        context.imageSmoothingQuality = 'high';
        context.drawImage(canvas, (onto.width - w) / 2, (onto.height - h) / 2, w, h);
        done();
      }),
    );
  }
}
