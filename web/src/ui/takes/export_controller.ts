// Carries out what the export dialog asks: files by the server, films and pictures by the page.

import type { StudioScene } from '../../scene/studio_scene';
import type { StudioStore } from '../../model/studio_store';
import type { OpenTake } from '../../model/take_facts';
import { formatBytes } from '../../model/take_facts';
import { ExportDialog, kExportKinds, type ExportChoice } from './export_dialog';
import { FilmMaker, canMakeFilms } from './film_maker';
import { saveBlob } from '../../link/answers';
import type { ShelfLink } from '../../link/shelf_link';
import { ServerExport } from './take_exports';
import { afterNextPicture } from '../../scene/scene_picture';

/** What is exported. */
export interface ExportSubject {
  /** On the shelf; empty where it lies elsewhere. */
  readonly name: string;
  readonly title: string;
  readonly from: number;
  readonly to: number;
  readonly stepTime: number;
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

function plainName(title: string): string {
  return title.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '') || 'take';
}

export class ExportController {
  readonly dialog: ExportDialog;
  private subject_: ExportSubject | null = null;
  private running_: { cancel(): void } | null = null;

  constructor(private readonly host_: ExportHost) {
    const kinds = kExportKinds.filter((kind) => !kind.film || canMakeFilms());
    this.dialog = new ExportDialog(kinds, {
      begin: (choice) => void this.begin(choice),
      cancel: () => this.running_?.cancel(),
    });
  }

  open(subject: ExportSubject): void {
    this.subject_ = subject;
    this.dialog.open(subject.title);
  }

  private async begin(choice: ExportChoice): Promise<void> {
    const subject = this.subject_;
    if (!subject || this.running_) return;
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
    if (choice.kind.film) return this.film(choice, subject);
    if (choice.kind.here) return this.picture(choice, subject);
    return this.file(choice, subject);
  }

  private async file(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    if (subject.name === '') throw new Error('This take lies on no shelf: save it as a file and open that first.');
    const run = new ServerExport(this.host_.shelf);
    this.running_ = run;
    const done = await run.run(
      {
        take: subject.name,
        format: choice.kind.name,
        from: subject.from * subject.stepTime,
        to: subject.to * subject.stepTime,
        fps: choice.fps,
        speeds: true,
      },
      (share) => this.dialog.setProgress(share),
    );
    return done ? `Saved ${done.file}, ${formatBytes(done.bytes)}.` : 'Cancelled.';
  }

  private async film(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    const maker = new FilmMaker({ draw: (step, onto) => this.draw(step, onto) });
    this.running_ = maker;
    const take = await this.host_.opened(subject.name);
    const [width, height] = choice.size;
    const film = await this.clean(choice, () =>
      maker.make(take, { fps: choice.fps, width, height }, (share) => this.dialog.setProgress(share)),
    );
    if (!film) return 'Cancelled.';
    const name = `${plainName(subject.title)}.${film.ending}`;
    saveBlob(film.blob, name);
    return `Saved ${name}, ${formatBytes(film.blob.size)}.`;
  }

  private async picture(choice: ExportChoice, subject: ExportSubject): Promise<string> {
    this.running_ = { cancel: () => undefined };
    const blob = await this.clean(choice, () => this.wholePicture());
    if (!blob) throw new Error('This browser makes no picture of the scene.');
    const name = `${plainName(subject.title)}.png`;
    saveBlob(blob, name);
    return `Saved ${name}, ${formatBytes(blob.size)}.`;
  }

  /** Without marks while `work` lasts, where that is chosen. */
  private async clean<T>({ clean }: ExportChoice, work: () => Promise<T>): Promise<T> {
    const { view, store } = this.host_;
    if (clean) view.setLayers(kClean);
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
    const { view, canvas } = this.host_;
    await this.host_.show(step);
    await new Promise<void>((done) =>
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
