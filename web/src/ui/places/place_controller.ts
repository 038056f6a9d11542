// Places in the page: the dialog, the browser's shelf, import, autosave, and models that are shown as scenery.

import { h, render } from 'preact';
import type { StudioClient } from '../../link/studio_client';
import { allowed, openingOf } from '../../model/consent';
import { sentenceOf } from '../../model/file_trouble';
import { fileNameOf, freeName, type KeptPlace } from '../../model/place_files/kept_place';
import { movedTo, type Imported, type ImportSettings, type ImportSource } from '../../model/place_files/imports';
import { leftOutText, type LeftOut } from '../../model/place_files/left_out';
import { additionOf, kSwim, within } from '../../model/place_files/new_place';
import { obstacleOf, waterOf, type PlaceDefinition } from '../../model/place_files/place';
import type { PlaceActions } from '../../model/place_files/place_actions';
import { boxOf } from '../../model/place_files/place_drawing';
import { sceneryOf, type SceneryModel } from '../../model/place_files/scenery';
import type { Template } from '../../model/place_files/templates';
import type { PlacesView } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { EditHistory, PlaceKept } from '../../protocol/messages';
import { problem, word } from '../../protocol/problem';
import type { StudioScene } from '../../scene/studio_scene';
import '../styles/shelf.css';
import '../styles/places.css';
import { KeptBanner, PlaceDialog } from './place_dialog';
import { importOf } from './place_import';
import { PlaceAutosave } from './place_autosave';
import { PlaceLink } from './place_link';
import { readSource } from './place_reader';
import { PlaceShelf } from './place_shelf';
import { keptPicture } from '../../scene/scene_picture';
import { saveBlob } from '../../link/answers';
import { element } from '../widgets/dom';

/** The server's answer is waited for so long [ms]. */
const kAnswerWait = 8000;

export interface PlaceParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly canvas: HTMLCanvasElement;
  readonly page: HTMLElement;
  readonly files: { open(files: readonly File[]): Promise<void> };
}

export class PlaceController implements PlaceActions {
  private readonly link_ = new PlaceLink();
  private readonly shelf_ = new PlaceShelf();
  private readonly autosave_ = new PlaceAutosave({
    link: this.link_,
    shelf: this.shelf_,
    picture: () => this.picture(),
  });
  private readonly banner_ = element('section', { class: 'banner panel place-banner', role: 'status', hidden: true });
  private readonly dialog_: PlaceDialog;
  private places_: readonly KeptPlace[] = [];
  private restore_: (() => Promise<void>) | null = null;
  /** The place whose models are shown. */
  private sceneryOf_ = '';
  private models_: readonly SceneryModel[] = [];

  constructor(private readonly parts_: PlaceParts) {
    const { store, client, page } = parts_;
    this.dialog_ = new PlaceDialog(this, () => this.close());
    page.append(this.dialog_.root);
    (page.querySelector('.banners') ?? page).append(this.banner_);
    store.watch(['places', 'placeFiles'], ({ places, placeFiles }) => this.shown(places, placeFiles));
    store.watch(['title'], ({ title }) => void this.showScenery(title));
    client.on('scene', () => this.autosave_.changed());
    // Another server may come back: its place is not what was edited.
    client.on('link', ({ phase }) => phase !== 'open' && this.autosave_.setEdited(false, '', false));
  }

  // The dialog.

  show(view: PlacesView): void {
    this.parts_.store.set({ places: view, placeFiles: [] });
  }

  private close(): void {
    this.show('none');
  }

  private shown(view: PlacesView, files: readonly File[]): void {
    const name = this.parts_.store.state.title || 'Place';
    this.dialog_.show({ view, said: '', ...(view === 'save' && { name, saved: '' }) });
    if (view === 'shelf') {
      this.dialog_.show({ removed: null });
      void this.refresh();
    }
    if (files.length > 0) void (view === 'import' ? this.readFiles(files) : this.openFile(files[0]!));
  }

  openFiles(files: readonly File[]): void {
    const { store } = this.parts_;
    const before = store.state;
    void this.parts_.files.open(files).then(() => {
      const { notice, placeFiles } = store.state;
      // A dialog hides the banner: it says itself what is wrong. What is no place is opened elsewhere.
      if (notice && notice !== before.notice) this.dialog_.show({ said: notice.text });
      else if (placeFiles === before.placeFiles) this.close();
    });
  }

  /** Does something of which the dialog tells where it fails; a banner does where the dialog is closed. */
  private async tried(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      const text = sentenceOf(error, 'The file cannot be used: parts of it are damaged.');
      if (this.dialog_.isOpen) this.dialog_.show({ said: text });
      else this.parts_.store.set({ notice: problem('place', text) });
    }
  }

  private tell(text: string): void {
    this.parts_.store.set({ notice: word('place', text) });
  }

  private async refresh(): Promise<void> {
    this.places_ = await this.shelf_.list();
    this.dialog_.show({ places: this.places_ });
  }

  // Opening.

  /** Opens a file for everybody; `models` are shown in it. */
  private async open(text: string, name: string, models?: readonly SceneryModel[]): Promise<void> {
    if (!(await allowed(this.parts_.store, openingOf(name)))) return;
    await this.autosave_.flush();
    const known = models ?? (await this.shelf_.scenery(name));
    await this.link_.open(text, name);
    await this.shelf_.keepScenery(name, known);
    this.sceneryOf_ = '';
    this.close();
    if (this.parts_.store.state.title === name) await this.showScenery(name);
  }

  private async openFile(file: File): Promise<void> {
    await this.tried(async () => {
      const text = await file.text();
      let name = file.name.replace(/\.json$/i, '');
      try {
        name = (JSON.parse(text) as PlaceDefinition).name || name;
      } catch {
        throw new Error(`“${file.name}” cannot be read: it is no whole JSON file.`);
      }
      try {
        await this.open(text, name);
      } catch (error) {
        throw new Error(sentenceOf(error, `“${name}” cannot be used.`).replace(`“${name}”`, `“${file.name}”`));
      }
    });
  }

  openTemplate(template: Template): void {
    void this.tried(() => this.open(JSON.stringify(template.make()), template.name, []));
  }

  openPlace(place: KeptPlace): void {
    void this.tried(async () => {
      if (place.auto) this.autosave_.markSeen(place);
      await this.open(await this.shelf_.read(place.id), place.name);
    });
  }

  // The shelf.

  duplicatePlace(place: KeptPlace): void {
    void this.tried(async () => {
      const name = freeName(
        `${place.name} copy`,
        this.places_.map((one) => one.name),
      );
      await this.shelf_.save(name, await this.shelf_.read(place.id), place.picture);
      await this.shelf_.keepScenery(name, await this.shelf_.scenery(place.name));
      await this.refresh();
    });
  }

  renamePlace(place: KeptPlace, wanted: string): void {
    void this.tried(async () => {
      const others = this.places_.filter((one) => one.id !== place.id && !one.auto);
      const name = freeName(
        wanted,
        others.map((one) => one.name),
      );
      await this.shelf_.keepScenery(name, await this.shelf_.scenery(place.name));
      // What was kept by itself is kept on purpose now.
      if (place.auto) await this.shelf_.save(name, await this.shelf_.read(place.id), place.picture);
      else await this.shelf_.rename(place.id, name);
      if (place.auto) await this.shelf_.remove(place.id);
      await this.refresh();
    });
  }

  downloadPlace(place: KeptPlace): void {
    void this.tried(async () => this.download(await this.shelf_.read(place.id), place.name));
  }

  removePlace(place: KeptPlace): void {
    void this.tried(async () => {
      this.restore_ = await this.shelf_.remove(place.id);
      await this.refresh();
      this.dialog_.show({ removed: place });
    });
  }

  restorePlace(): void {
    this.dialog_.show({ removed: null });
    void this.tried(async () => {
      await this.restore_?.();
      this.restore_ = null;
      await this.refresh();
    });
  }

  // Saving.

  /** The server keeps the place by its new name where it can; this browser always does. */
  private async keep(wanted: string): Promise<PlaceKept> {
    const { client } = this.parts_;
    const answer = new Promise<PlaceKept>((done, failed) => {
      const stop = client.on('placeKept', (kept) => {
        stop();
        done(kept);
      });
      window.setTimeout(() => failed(new Error('The server does not answer: try again.')), kAnswerWait);
    });
    client.send({ type: 'KeepPlace', title: wanted });
    const kept = await answer;
    if (kept.title === '') throw new Error(kept.problem);
    return kept;
  }

  sharePresent(name: string): void {
    void this.tried(async () => {
      const kept = await this.keepPresent(name);
      const { showShare } = await import('./share_dialog');
      await showShare({ kind: 'place', title: kept.title, fragment: `scenario=${kept.name}`, path: 'scenario' });
    });
  }

  savePresent(name: string): void {
    void this.tried(async () => void (await this.keepPresent(name)));
  }

  private async keepPresent(wanted: string): Promise<PlaceKept> {
    const present = this.parts_.store.state.title;
    const kept = await this.keep(wanted);
    const name = kept.title;
    const text = await this.link_.read();
    await this.shelf_.save(name, text, await this.picture());
    if (name !== present) await this.shelf_.keepScenery(name, await this.shelf_.scenery(present));
    const auto = (await this.shelf_.list()).find((one) => one.auto && one.name === present);
    if (auto) await this.shelf_.remove(auto.id);
    this.autosave_.saved(name);
    this.dialog_.show({ saved: this.savedText(kept) });
    return kept;
  }

  private savedText({ title, name }: PlaceKept): string {
    if (name !== '') return `“${title}” is saved: it stands in the list of places, for all who direct here.`;
    return this.shelf_.lasting
      ? `“${title}” is saved in this browser.`
      : `This browser keeps “${title}” only until the page is left: download it, too.`;
  }

  downloadPresent(name: string): void {
    void this.tried(async () => {
      const text = await this.link_.read();
      const place = JSON.parse(text) as PlaceDefinition;
      this.download(place.name === name ? text : JSON.stringify({ ...place, name }), name);
    });
  }

  private download(text: string, name: string): void {
    saveBlob(new Blob([text], { type: 'application/json' }), fileNameOf(name));
  }

  private picture(): Promise<Blob | null> {
    return keptPicture(this.parts_.view, this.parts_.canvas);
  }

  // Import.

  private async readFiles(files: readonly File[]): Promise<void> {
    await this.tried(async () => {
      const source = await readSource(files);
      const present = await this.link_.read().then(
        (text) => JSON.parse(text) as PlaceDefinition,
        () => null,
      );
      this.dialog_.show({ importing: importOf(source, present, this.parts_.view.attention()) });
    });
  }

  openImported(source: ImportSource, { place, meshes }: Imported, settings: ImportSettings, shown: boolean): void {
    void this.tried(async () => {
      const models = shown ? [sceneryOf(source.file, meshes, { x: 0, y: 0 }, place.obstacles ?? [])] : [];
      this.parts_.view.fitter.whole = true;
      await this.open(JSON.stringify(place), settings.name, models);
    });
  }

  addImported(source: ImportSource, imported: Imported, settings: ImportSettings, shown: boolean): void {
    void this.tried(async () => {
      const { client, store } = this.parts_;
      const present = JSON.parse(await this.link_.read()) as PlaceDefinition;
      const [[left, bottom], [right, top]] = boxOf(present);
      const out: LeftOut = {};
      const box = { min: { x: left, y: bottom }, max: { x: right, y: top } };
      const outlines = movedTo(imported.outlines, settings.at);
      const swim = (present.clips ?? []).findIndex((clip) => clip.name === kSwim);
      const kept = within(outlines, box, out).filter(({ water }) => !water || swim >= 0);
      if (kept.length === 0) throw new Error('All of it would lie outside the place.');
      const obstacles = kept.filter(({ water }) => !water).map(obstacleOf);
      const waters = kept.filter(({ water }) => water).map((one) => waterOf(one, swim));
      const gesture = 0x80000000 + Math.floor(Math.random() * 0x7fffffff);
      const label = `Import ${[...source.file].slice(0, 30).join('')}`;
      for (const message of additionOf(obstacles, label, gesture, waters)) client.send(message);
      const { title } = store.state;
      if (shown) {
        const model = sceneryOf(source.file, imported.meshes, settings.at, obstacles);
        await this.shelf_.keepScenery(title, [...(await this.shelf_.scenery(title)), model]);
        this.sceneryOf_ = '';
        await this.showScenery(title);
      }
      this.close();
      const added =
        obstacles.length === 1
          ? '1 obstacle is added.'
          : `${obstacles.length.toLocaleString('en')} obstacles are added.`;
      this.tell([added, leftOutText(out, outlines.length)].filter((one) => one !== '').join(' '));
    });
  }

  // Scenery and autosave.

  async showScenery(title: string): Promise<void> {
    if (title === this.sceneryOf_) return;
    this.sceneryOf_ = title;
    const models = await this.shelf_.scenery(title).catch(() => []);
    if (this.sceneryOf_ !== title || (models.length === 0 && this.models_.length === 0)) return;
    this.models_ = models;
    this.parts_.view.setScenery(models);
  }

  setHistory({ edited, undo, redo }: Omit<EditHistory, 'type'>): void {
    this.autosave_.setEdited(edited, this.parts_.store.state.title, undo + redo > 0);
  }

  /** `was`: the title of the place that was shown before. */
  async offerKept(was: string): Promise<void> {
    const place = await this.autosave_.lost(was);
    this.banner_.hidden = !place;
    if (!place) return;
    const choice = (act: () => void) => (): void => {
      this.banner_.hidden = true;
      act();
    };
    const open = choice(() => this.openPlace(place));
    const dismiss = choice(() => this.autosave_.markSeen(place));
    render(h(KeptBanner, { place, open, dismiss }), this.banner_);
  }
}
