// The web component <muster-player>.

import { CameraGestures } from './camera_gestures';
import { ControlBar } from './control_bar';
import { CannotDraw } from './draw/gl';
import type { LoadedCrowd } from './file/loaded_crowd';
import { loadFile } from './load_file';
import { CrowdMoment } from './play/crowd_moment';
import { Playback, clockText, type PlaybackEvent } from './play/playback';
import { kStyle } from './player_style';
import { PlayerView, type ViewSettings } from './player_view';
import type { ViewCamera } from './play/view_camera';

/** Controls go away so long after the last move, while it plays [ms]. */
const kAwayAfter = 2500;
/** A player loads when it is so near the window. */
const kNear = '300px';
const kSeekKey = 1;
/** The controls and the room round them [px]. */
const kBarHeight = 66;

/** Height of a head [m]. */
const kHead = 1.6;

/** Somebody at some time. */
export interface PlayerCharacter {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly heading: number;
  readonly screen: { readonly x: number; readonly y: number };
}

/** Other than in a browser there is no class to extend: the module can be imported all the same. */
const kBase = globalThis.HTMLElement ?? class {};

export class MusterPlayer extends kBase {
  static readonly observedAttributes = ['src', 'autoplay', 'loop', 'controls', 'poster', 'speed', 'camera', 'theme'];

  private readonly root_ = document.createElement('div');
  private readonly place_ = document.createElement('div');
  private readonly poster_ = document.createElement('img');
  private readonly message_ = document.createElement('p');
  private readonly controls_: ControlBar;
  private readonly near_: IntersectionObserver;
  private readonly size_: ResizeObserver;
  private readonly dark_ = matchMedia('(prefers-color-scheme: dark)');
  private there_: AbortController | null = null;
  private loading_: AbortController | null = null;
  private loaded_: LoadedCrowd | null = null;
  private view_: PlayerView | null = null;
  private playback_: Playback | null = null;
  private isNear_ = false;
  private wanted_ = false;
  private started_ = false;
  private picture_ = 0;
  private last_ = 0;
  private away_ = 0;

  constructor() {
    super();
    this.controls_ = new ControlBar({
      toggle: () => this.toggle(),
      seek: (time) => (this.currentTime = time),
      wholeScreen: () => void this.wholeScreen(),
    });
    this.near_ = new IntersectionObserver((entries) => this.near(entries.at(-1)!.isIntersecting), {
      rootMargin: kNear,
    });
    this.size_ = new ResizeObserver(() => this.ask());
    this.build();
    this.listen();
  }

  /** Seconds from the first frame to the last; NaN before the file is there. */
  get duration(): number {
    return this.playback_?.duration ?? NaN;
  }

  get currentTime(): number {
    return this.playback_?.time ?? 0;
  }

  set currentTime(time: number) {
    this.playback_?.seek(Number(time));
    if (Number(time) > 0) this.begun();
    this.ask();
  }

  get paused(): boolean {
    return this.playback_ ? this.playback_.paused : !this.wanted_;
  }

  get ended(): boolean {
    return this.playback_?.ended ?? false;
  }

  /** Of the file: its title, or an empty text. */
  get crowdTitle(): string {
    return this.loaded_?.head.title ?? '';
  }

  /**
   * Who is where at a time since the first frame [s]: ids, places on the ground [m], headings counter-clockwise from +x [rad], and
   * where their heads are in the picture that was drawn last [CSS px from the upper left of the player]. Empty before the file is
   * there.
   */
  charactersAt(time: number): readonly PlayerCharacter[] {
    const { loaded_: loaded, view_: view } = this;
    if (!loaded || !view) return [];
    const moment = new CrowdMoment(loaded);
    moment.goTo(time);
    return Array.from({ length: moment.count }, (_, i) => {
      const [x, y] = [moment.x[i]!, moment.y[i]!];
      const { id } = loaded.crowd.people[moment.who[i]!]!;
      return { id, x, y, heading: moment.yaw[i]!, screen: view.screenOf(x, y, kHead) };
    });
  }

  /** Begins to play, as soon as the file is there. */
  play(): void {
    this.wanted_ = true;
    this.near_.takeRecords();
    if (!this.playback_) return this.load();
    this.begun();
    this.playback_.play();
    this.ask();
  }

  pause(): void {
    this.wanted_ = false;
    this.playback_?.pause();
  }

  connectedCallback(): void {
    this.near_.observe(this);
    this.size_.observe(this);
    this.there_ = new AbortController();
    const { signal } = this.there_;
    this.dark_.addEventListener('change', () => this.themed(), { signal });
    document.addEventListener('fullscreenchange', () => this.filled(), { signal });
    this.dress();
  }

  disconnectedCallback(): void {
    this.near_.disconnect();
    this.size_.disconnect();
    this.there_?.abort();
    this.near(false);
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (before === now) return;
    if (name === 'src') {
      this.forget();
      if (this.isNear_) this.load();
    } else {
      this.dress();
      this.ask();
    }
  }

  private build(): void {
    const shadow = this.attachShadow({ mode: 'open' });
    const style = document.createElement('style');
    style.textContent = kStyle;
    this.root_.className = 'root';
    this.root_.setAttribute('part', 'root');
    this.place_.className = 'view';
    this.place_.setAttribute('part', 'view');
    this.poster_.className = 'poster';
    this.poster_.setAttribute('part', 'poster');
    this.poster_.alt = '';
    this.message_.className = 'message';
    this.message_.setAttribute('part', 'message');
    this.message_.setAttribute('role', 'alert');
    this.message_.hidden = true;
    this.controls_.start.hidden = true;
    this.controls_.root.hidden = true;
    this.root_.append(this.place_, this.poster_, this.controls_.start, this.controls_.root, this.message_);
    shadow.append(style, this.root_);
  }

  private listen(): void {
    const camera = (): ViewCamera | null =>
      this.getAttribute('camera') === 'fixed' ? null : (this.view_?.camera ?? null);
    const whole = (): boolean => this.isWhole;
    const host = {
      get camera() {
        return camera();
      },
      get whole() {
        return whole();
      },
      moved: () => this.ask(),
    };
    new CameraGestures(this.place_, host, this.root_);
    for (const name of ['pointermove', 'pointerdown', 'focusin', 'keydown'] as const)
      this.addEventListener(name, () => this.wake());
    this.addEventListener('keydown', (event) => this.key(event));
  }

  private get isWhole(): boolean {
    return document.fullscreenElement === this;
  }

  private themed(): void {
    this.dress();
    this.ask();
  }

  private filled(): void {
    this.controls_.setWhole(this.isWhole);
    this.ask();
  }

  /** What attributes ask for. */
  private dress(): void {
    const { settings } = this;
    this.root_.dataset['theme'] = settings.theme;
    this.view_?.set(settings);
    if (this.playback_) {
      this.playback_.loop = this.hasAttribute('loop');
      this.playback_.speed = this.speed;
    }
    const fixed = this.getAttribute('camera') === 'fixed';
    this.place_.toggleAttribute('data-orbit', !fixed);
    if (fixed) this.place_.removeAttribute('tabindex');
    else this.place_.tabIndex = 0;
    const poster = this.getAttribute('poster') ?? '';
    if (this.poster_.getAttribute('src') !== poster) this.poster_.setAttribute('src', poster);
    this.poster_.hidden = poster === '' || this.started_;
    this.showControls();
  }

  private get settings(): ViewSettings {
    const asked = this.getAttribute('theme');
    const dark = asked === 'dark' || (asked !== 'light' && this.dark_.matches);
    const covered = this.hasAttribute('controls') ? kBarHeight : 0;
    return { theme: dark ? 'dark' : 'light', follows: this.getAttribute('camera') === 'follow', covered };
  }

  private get speed(): number {
    const speed = Number(this.getAttribute('speed') ?? 1);
    return Number.isFinite(speed) ? Math.min(16, Math.max(0.05, speed)) : 1;
  }

  /** One large button at first, then the bar. */
  private showControls(): void {
    const there = this.playback_ !== null && this.message_.hidden && this.hasAttribute('controls');
    this.controls_.root.hidden = !there || !this.started_;
    this.controls_.start.hidden = !there || this.started_;
  }

  private near(isNear: boolean): void {
    this.isNear_ = isNear;
    this.last_ = 0;
    if (!isNear) {
      cancelAnimationFrame(this.picture_);
      this.picture_ = 0;
      this.view_?.rest();
    } else if (this.loaded_) this.ask();
    else this.load();
  }

  private forget(): void {
    this.loading_?.abort();
    this.loading_ = null;
    this.view_?.rest();
    this.place_.replaceChildren();
    this.view_ = null;
    this.loaded_ = null;
    this.playback_ = null;
    this.started_ = false;
    this.message_.hidden = true;
    this.dress();
  }

  private load(): void {
    const src = this.getAttribute('src');
    if (this.loading_ || src === null) return;
    const loading = (this.loading_ = new AbortController());
    loadFile(src, loading.signal).then(
      (loaded) => !loading.signal.aborted && this.arrived(loaded),
      (error: unknown) => !loading.signal.aborted && this.fail(error instanceof Error ? error.message : String(error)),
    );
  }

  private arrived(loaded: LoadedCrowd): void {
    this.loaded_ = loaded;
    this.view_ = new PlayerView(loaded, this.place_, this.settings, () => this.ask());
    this.playback_ = new Playback(loaded.duration, (event) => this.tell(event));
    this.controls_.setDuration(loaded.duration);
    this.place_.setAttribute('role', 'img');
    this.place_.setAttribute('aria-label', this.described(loaded));
    this.dress();
    this.dispatchEvent(new Event('loadedmetadata'));
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    if (this.wanted_ || (this.hasAttribute('autoplay') && !still)) this.play();
    this.ask();
  }

  private described({ head, duration }: LoadedCrowd): string {
    const people = head.most === 1 ? 'one person' : `${head.most} people`;
    const moves =
      this.getAttribute('camera') === 'fixed' ? '' : '. Arrow keys turn the view, + and - zoom, 0 resets it';
    return `${head.title || 'A crowd'}: ${people}, ${clockText(duration)}${moves}`;
  }

  private fail(sentence: string): void {
    this.message_.textContent = sentence;
    this.message_.hidden = false;
    this.poster_.hidden = true;
    this.playback_?.pause();
    this.showControls();
    this.dispatchEvent(new ErrorEvent('error', { message: sentence }));
  }

  private tell(event: PlaybackEvent): void {
    const { playback_: playback } = this;
    if (!playback) return;
    if (event === 'timeupdate') this.controls_.setTime(playback.time);
    else this.controls_.setPaused(playback.paused);
    if (event === 'play' || event === 'pause') this.wake();
    this.dispatchEvent(new Event(event));
  }

  private begun(): void {
    if (this.started_) return;
    this.started_ = true;
    this.dress();
  }

  private toggle(): void {
    if (this.paused) this.play();
    else this.pause();
  }

  private async wholeScreen(): Promise<void> {
    await (this.isWhole ? document.exitFullscreen() : this.requestFullscreen()).catch(() => undefined);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented || !this.playback_) return;
    const on = event.composedPath()[0];
    const own = on instanceof HTMLButtonElement || on instanceof HTMLInputElement;
    const actions: Readonly<Record<string, () => unknown>> = {
      k: () => this.toggle(),
      j: () => (this.currentTime -= kSeekKey),
      l: () => (this.currentTime += kSeekKey),
      f: () => this.wholeScreen(),
      ...(own ? {} : { ' ': () => this.toggle() }),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  /** Shows the controls, which go away again while it plays. */
  private wake(): void {
    this.controls_.root.removeAttribute('data-away');
    clearTimeout(this.away_);
    if (this.playback_?.paused !== false) return;
    this.away_ = window.setTimeout(() => this.controls_.root.setAttribute('data-away', ''), kAwayAfter);
  }

  /** Asks for a picture, if somebody could see it. */
  private ask(): void {
    if (this.picture_ !== 0 || !this.isNear_ || !this.view_ || !this.message_.hidden) return;
    this.picture_ = requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.picture_ = 0;
    const { playback_: playback, view_: view } = this;
    if (!playback || !view) return;
    const passed = this.last_ > 0 ? (now - this.last_) / 1000 : 0;
    const playing = !playback.paused;
    this.last_ = playing ? now : 0;
    if (playing) {
      playback.advance(passed);
      if (passed > 0) view.took(passed);
    }
    try {
      view.draw(playback.time);
    } catch (error) {
      if (!(error instanceof CannotDraw)) throw error;
      return this.fail(`The crowd cannot be shown: ${error.message}.`);
    }
    if (!playback.paused) this.ask();
  }
}

/** Makes <muster-player> known to the page. */
export function defineMusterPlayer(): void {
  if (globalThis.customElements && !customElements.get('muster-player'))
    customElements.define('muster-player', MusterPlayer);
}
