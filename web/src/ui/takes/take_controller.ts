// Takes in the page: the card of a kept one, the shelf, the time line of the open one, and exports.

import { PanelLayout } from '../widgets/panel_layout';
import { PlaybackAction, type SpeedPiece, type TakeKept, type TakeState } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';
import type { TakeActions } from '../../model/take_actions';
import { allowed, openingOf, othersOf, takeOpeningOf, whenAllowed } from '../../model/consent';
import { kTakeEnd, takeTitle, type OpenTake, type ShelvedTake, type TakeAbout } from '../../model/take_facts';
import { kSteeredPitch, kWatchedPitch } from '../../scene/camera/camera_controller';
import type { StudioScene } from '../../scene/studio_scene';
import { ExportController } from './export_controller';
import type { ExportGroup } from './export_kinds';
import { FilmCameraController } from './film_camera_controller';
import { TakeCard, type CardKind } from './take_card';
import { TakeShelf } from './take_shelf';
import { TimeLine } from './time_line';
import { RecordingPicture } from './recording_picture';
import { Scrubber } from './scrubber';
import { save } from '../../link/answers';
import { ShelfLink, pictureAddress, takeAddress } from '../../link/shelf_link';
import { scenarioBehind } from '../../model/scenario_behind';
import { hasRecorded, markCutOffSeen, rememberRecording, untoldCutOff } from './recorder';
import { TakeCopies, isCopyOnly, withCopies } from './take_copies';
import { openTake } from './takes';
import { fileInput } from '../widgets/file_input';
import { LiveRegion } from '../widgets/live_region';
import '../styles/shelf.css';
import '../styles/takes.css';

/** How long a picture blends towards a frame that has come [ms]. */
const kSettle = 90;
/** Other devices may come back to a server, too, before it is decided which one tells of a cut off recording [ms]. */
const kOthersCome = 2000;

export interface TakeControllerParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly canvas: HTMLCanvasElement;
  readonly page: HTMLElement;
}

/** The moment of the newest frame, and who waits for one. */
interface Waiting {
  readonly step: number;
  readonly done: () => void;
}

export class TakeController implements TakeActions {
  readonly exports: ExportController;
  private readonly shelf_ = new ShelfLink();
  private readonly copies_ = new TakeCopies();
  private readonly live_ = new LiveRegion();
  private readonly line_: TimeLine;
  private readonly film_: FilmCameraController;
  private readonly card_ = new TakeCard(this);
  private readonly shelfPanel_: TakeShelf;
  private readonly scrubber_: Scrubber;
  private take_: OpenTake | null = null;
  private takes_: readonly ShelvedTake[] = [];
  private step_ = 0;
  private waiting_: Waiting[] = [];
  private trims_ = false;
  /** The copy of the take that was removed last. */
  private removedCopy_: Blob | null = null;
  private readonly picture_: RecordingPicture;

  constructor(private readonly parts_: TakeControllerParts) {
    const { client, store, view, canvas, page } = parts_;
    const film = {
      keepView: () => this.film_.keep(this.step_),
      removeView: (step: number) => this.film_.remove(step),
      showMoment: (step: number) => this.seek(step),
      filmCamera: (on: boolean) => this.film_.switch(on),
    };
    this.line_ = new TimeLine(this, film, store);
    this.film_ = new FilmCameraController(view.camera, () => this.showKeys());
    this.scrubber_ = new Scrubber((message) => client.send(message));
    const file = fileInput({ label: 'Open a take', accept: '.take', chosen: ([one]) => void this.openFile(one!) });
    this.shelfPanel_ = new TakeShelf(this, pictureAddress, () => file.click());
    this.picture_ = new RecordingPicture(parts_);
    this.exports = new ExportController({
      shelf: this.shelf_,
      store,
      view,
      canvas,
      opened: (name) => this.opened(name),
      show: (step) => this.show(step),
    });
    const layout = PanelLayout.of(page);
    layout.add('time-line', this.line_.root);
    layout.add('take-card', this.card_.root);
    page.append(this.shelfPanel_.root, this.exports.dialog.root, file, this.live_.root);
    client.on('takeState', (state) => this.changed(state));
    client.on('takeReady', ({ steps }) => this.line_.track.setReady(steps));
    client.on('takeKept', (kept) => void this.kept(kept));
    client.on('frame', ({ frame }) => this.observe((this.picture_.crowd = frame).step));
    const offer = (): void => void window.setTimeout(() => void this.offerCutOff(), kOthersCome);
    client.on('welcome', offer);
    if (client.state.phase === 'open') offer();
    store.watch(['shelf'], ({ shelf }) => {
      this.shelfPanel_.setOpen(shelf);
      if (shelf) void this.refresh();
    });
    store.watch(['title'], () => this.take_ && this.line_.setTake(this.take_, this.titleOf(this.take_)));
    store.watch(['theme'], () => requestAnimationFrame(() => this.line_.track.drawMarks()));
  }

  // The open take.

  /** The server tells which take is open. */
  changed({ open, ...take }: TakeState): void {
    const before = this.take_;
    this.take_ = open ? take : null;
    document.documentElement.toggleAttribute('data-take', open);
    if (open && before?.name !== take.name) this.line_.track.setReady(0);
    this.film_.open(open ? take.name : '');
    this.line_.setTake(this.take_, this.titleOf(take));
    if (open !== (before !== null)) this.tilt(open);
    if (!open) return;
    if (!before) {
      this.live_.say('A take is open');
      this.card_.close();
    }
    if (this.trims_) requestAnimationFrame(() => this.line_.track.focusFrom());
    this.trims_ = false;
    this.waiting_ = this.waiting_.filter((one) => one.step >= 0 || (one.done(), false));
  }

  /** What is watched may be seen up to the horizon. */
  private tilt(watched: boolean): void {
    const { camera } = this.parts_.view;
    camera.flattest = watched ? kWatchedPitch : kSteeredPitch;
    camera.orbit(0, 0);
  }

  private titleOf(take: Pick<OpenTake, 'title'>): string {
    return take.title || this.parts_.store.state.title || 'Take';
  }

  private observe(step: number): void {
    this.step_ = step;
    if (this.take_) this.film_.observe(step);
    this.scrubber_.observe(step);
    this.line_.setStep(this.scrubber_.wished ?? step);
    this.waiting_ = this.waiting_.filter((one) => one.step !== step || (one.done(), false));
  }

  private showKeys(): void {
    const { keys, on } = this.film_;
    this.line_.setFilm(keys, on);
    this.line_.track.setKeys(keys.map(({ step }) => step));
  }

  beginScrub(): void {
    this.scrubber_.begin(this.parts_.store.state.playing);
  }

  seek(step: number): void {
    this.scrubber_.to(step);
  }

  endScrub(): void {
    this.scrubber_.end();
  }

  setPart(from: number, to: number): void {
    this.edit({ from, to });
  }

  setSpeeds(speeds: readonly SpeedPiece[]): void {
    this.edit({ speeds });
  }

  setLoop(loop: boolean): void {
    this.edit({ loop });
  }

  private edit(change: Partial<Pick<OpenTake, 'from' | 'to' | 'loop'>> & { speeds?: readonly SpeedPiece[] }): void {
    const take = this.take_;
    if (!take) return;
    const { title, from, to, loop, speeds } = { ...take, ...change };
    this.parts_.client.send({ type: 'EditTake', title, from, to, loop, speeds: [...speeds] });
  }

  takeAgain(keep: boolean): void {
    rememberRecording(true);
    this.parts_.client.send({ type: 'TakeAgain', keep });
    this.live_.say(keep ? 'Direct on top of the take' : 'Direct the take again from here');
  }

  leaveTake(): void {
    const { client, store } = this.parts_;
    const beneath = this.take_?.beneath ?? '';
    const back = (): void => client.send({ type: 'Playback', action: PlaybackAction.LeaveTake });
    if (beneath !== '') return void whenAllowed(store, openingOf(beneath), back);
    const { name, title } = scenarioBehind(store.state) ?? { name: '', title: '' };
    if (name) whenAllowed(store, openingOf(title), () => client.send({ type: 'LoadScenario', name }));
  }

  // Films and pictures.

  /** The open take, or that one as soon as it is open. */
  private async opened(name: string): Promise<OpenTake> {
    if (!this.take_ || (name !== '' && this.take_.name !== name)) {
      await this.shelf_.open(name);
      while (this.take_?.name !== name) await new Promise<void>((done) => this.waiting_.push({ step: -1, done }));
    }
    if (!this.take_) throw new Error('The take could not be opened.');
    if (this.parts_.store.state.playing) this.parts_.client.send({ type: 'Playback', action: PlaybackAction.Pause });
    return this.take_;
  }

  private async show(step: number): Promise<void> {
    if (step !== this.step_) {
      const come = new Promise<void>((done) => this.waiting_.push({ step, done }));
      this.scrubber_.to(step);
      await come;
    }
    await new Promise((done) => window.setTimeout(done, kSettle));
  }

  exportTake(name?: string): void {
    const listed = this.takes_.find((one) => one.name === name) ?? this.card_.take;
    const take = this.take_;
    if (take && (name === undefined || name === take.name))
      return this.exports.open({ ...take, title: this.titleOf(take), groups: this.groups() });
    if (listed) this.exports.open({ ...listed, title: takeTitle(listed), groups: [] });
  }

  /** Of the shown moment. */
  private groups(): readonly ExportGroup[] {
    return this.parts_.store.state.groups.map(({ id, name }) => ({ id, name: name || `Group ${id}` }));
  }

  // The shelf.

  private async refresh(): Promise<void> {
    await this.tried(async () => {
      this.takes_ = withCopies(await this.shelf_.list(), await this.copies_.list());
      this.shelfPanel_.setTakes(this.takes_, this.take_?.name ?? '');
    });
  }

  openTake(name: string, trim = false): void {
    void this.tried(async () => {
      const take = this.takes_.find((one) => one.name === name);
      if (!(await allowed(this.parts_.store, takeOpeningOf(take ? takeTitle(take) : name)))) return;
      this.trims_ = trim;
      await this.shelf_.open(await this.onShelf(name));
      this.closeCard();
      this.closeShelf();
    });
  }

  /** Its name on the shelf; a take that only the browser has is put there first. */
  private async onShelf(name: string): Promise<string> {
    const take = this.takes_.find((one) => one.name === name);
    if (!take || !isCopyOnly(take)) return name;
    const file = await this.copies_.read(name);
    if (!file) throw new Error('The copy of this take is lost.');
    const put = await this.shelf_.put(file, takeTitle(take));
    if (put !== name) await this.copies_.remove(name);
    return put;
  }

  private async openFile(file: File): Promise<void> {
    if (!(await allowed(this.parts_.store, takeOpeningOf(file.name.replace(/\.take$/, ''))))) return;
    const text = await openTake(file);
    if (text === null) this.closeShelf();
    else this.parts_.store.set({ notice: problem('take', text) });
  }

  saveTake(take: ShelvedTake): void {
    const title = takeTitle(take)
      .replace(/[^\p{L}\p{N}]+/gu, '-')
      .replace(/^-|-$/g, '');
    void save(takeAddress(take.name), `${title || 'take'}.take`);
  }

  renameTake(take: ShelvedTake, title: string): void {
    const { from, steps, speeds } = take;
    const about: TakeAbout = { title, from, to: take.to >= steps ? kTakeEnd : take.to, speeds };
    void this.tried(async () => {
      await this.shelf_.edit(take.name, about);
      this.live_.say(`The take is called ${title || take.scenario}`);
      await this.refresh();
      const fresh = this.takes_.find((one) => one.name === take.name);
      if (fresh && this.card_.take?.name === take.name) this.showCard(fresh, 'kept');
    });
  }

  removeTake(take: ShelvedTake): void {
    void this.tried(async () => {
      this.removedCopy_ = await this.copies_.read(take.name);
      await this.copies_.remove(take.name);
      if (!isCopyOnly(take)) await this.shelf_.remove(take.name);
      this.live_.say(`${takeTitle(take)} is removed`);
      if (this.parts_.store.state.shelf) this.shelfPanel_.offerUndo(take);
      if (this.card_.take?.name === take.name) this.showCard(take, 'removed');
      await this.refresh();
    });
  }

  restoreTake(take: ShelvedTake): void {
    void this.tried(async () => {
      if (!isCopyOnly(take)) await this.shelf_.restore(take.name);
      if (this.removedCopy_) await this.copies_.keep(take, this.removedCopy_);
      this.live_.say(`${takeTitle(take)} is back`);
      if (this.card_.take?.name === take.name) this.showCard(take, 'kept');
      await this.refresh();
    });
  }

  closeCard(): void {
    const { take } = this.card_;
    if (take && !take.finished) markCutOffSeen(take.name);
    this.card_.close();
  }

  closeShelf(): void {
    this.parts_.store.set({ shelf: false });
  }

  private async tried(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      this.parts_.store.set({ notice: problem('take', text) });
    }
  }

  // The card.

  private showCard(take: ShelvedTake, kind: CardKind): void {
    this.card_.show(take, kind, take.picture && kind !== 'removed' ? pictureAddress(take) : '');
  }

  private async kept({ name, scenario }: TakeKept): Promise<void> {
    rememberRecording(false);
    if (name === '') return;
    this.live_.say('The take is kept');
    await this.tried(async () => {
      const picture = await this.picture_.of(scenario);
      if (picture) await this.shelf_.putPicture(name, picture);
      await this.refresh();
      const take = this.takes_.find((one) => one.name === name);
      if (!take) return;
      // A take that was opened meanwhile has its time line where the card would be.
      if (!this.take_) this.showCard(take, 'kept');
      await this.copies_.keep(take, await this.shelf_.file(name));
    });
  }

  /** The newest recording that a server did not live to end. */
  private async offerCutOff(): Promise<void> {
    if (this.take_ || this.card_.take) return;
    // Of several devices only the one that recorded tells of it.
    if (othersOf(this.parts_.store.state).length > 0 && !hasRecorded()) return;
    try {
      this.takes_ = await this.shelf_.list();
    } catch {
      return;
    }
    const found = untoldCutOff(this.takes_);
    if (found) this.showCard(found, 'cut off');
    if (found) this.live_.say('A recording was cut off, and is safe');
  }
}
