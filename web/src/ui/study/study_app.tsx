// A run of the study on the page, and the replay of a trial: one stage after the other, as the server tells.

import './study.css';
import { render } from 'preact';
import {
  NoticeLevel,
  StudyAct,
  StudyStage,
  type AnswerFrame,
  type StudyForm,
  type StudyState,
} from '../../protocol/messages';
import type { StudioClient } from '../../link/studio_client';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioView } from '../../scene/studio_view';
import { AttentionSender } from '../app/attention_sender';
import { LayoutWatcher } from '../app/layout_watcher';
import { schemeView } from '../steer/scheme_controller';
import { applyTheme, followSystemTheme, preferredTheme } from '../widgets/theme';
import type { Moment } from './bars';
import { StudyPage, type StudyActions, type StudyView } from './study_page';
import { TrialPointers } from './trial_pointers';

/** Between the bar and the ground, and round it [CSS px]. */
const kRoom = 8;

function tokenOf(hash: string): string {
  return /^#[0-9a-z-]{1,64}$/i.test(hash) ? hash.slice(1) : '';
}

function countOf(collected: ArrayLike<number>): number {
  let count = 0;
  for (let i = 0; i < collected.length; ++i) count += collected[i] ? 1 : 0;
  return count;
}

/** Messages vanish after this time [ms]. */
const kToast = 4000;
const kBeginning: Moment = { time: 0, playing: true, speed: 1, collected: 0 };

export class StudyApp {
  /** Newest frame of a trial. */
  frame: StudioFrame | null = null;
  /** Where the run stands. */
  state: StudyState | null = null;
  private shown_: StudyView = {
    state: null,
    form: null,
    moment: kBeginning,
    done: 0,
    busy: false,
    lost: false,
    toast: null,
    stopping: false,
  };
  private toasted_ = 0;
  /** So many were asked. */
  private forms_ = 0;
  private sceneRevision_ = 0;
  private readonly pointers_: TrialPointers;
  private readonly attention_: AttentionSender;
  private readonly actions_: StudyActions = {
    client: { send: (message) => this.client_.send(message) },
    goOn: () => this.goOn(),
    answer: (answers) => this.answer(answers),
    giveUp: () => this.act(StudyAct.GiveUp),
    askStop: (stopping) => this.show({ stopping }),
    stop: () => {
      this.show({ stopping: false });
      this.act(StudyAct.BreakOff);
    },
    retry: () => this.client_.retry(),
  };

  constructor(
    private readonly client_: StudioClient,
    private readonly view_: StudioView,
    private readonly canvas_: HTMLCanvasElement,
    private readonly page_: HTMLElement,
  ) {
    this.pointers_ = new TrialPointers(client_, view_, canvas_, (text) => this.tell(text));
    this.attention_ = new AttentionSender(client_);
    this.followSettings();
    this.followClient();
    this.show({});
    requestAnimationFrame(this.drawn);
  }

  private show(change: Partial<StudyView>): void {
    this.shown_ = { ...this.shown_, ...change };
    render(<StudyPage view={this.shown_} actions={this.actions_} />, this.page_);
  }

  private tell(text: string, error = false): void {
    window.clearTimeout(this.toasted_);
    this.toasted_ = window.setTimeout(() => this.show({ toast: null }), kToast);
    this.show({ toast: { text, error } });
  }

  private followSettings(): void {
    const dress = (theme: ReturnType<typeof preferredTheme>): void => {
      applyTheme(window, theme);
      this.view_.setTheme(theme);
    };
    dress(preferredTheme(window));
    followSystemTheme(window, dress);
    new LayoutWatcher(window, () => requestAnimationFrame(() => this.lookDown()));
    const motion = window.matchMedia('(prefers-reduced-motion: reduce)');
    this.view_.setReducedMotion(motion.matches);
    motion.addEventListener('change', () => this.view_.setReducedMotion(motion.matches));
  }

  private followClient(): void {
    const { client_: client, view_: view } = this;
    client.on('link', (link) => {
      const lost = link.phase !== 'open' && this.state !== null;
      view.setLost(lost);
      this.show({ lost });
      this.pointers_.forget();
      this.attention_.forget();
    });
    client.on('welcome', () => client.send({ type: 'EnterStudy', token: tokenOf(location.hash) }));
    client.on('studyState', (state) => this.showState(state));
    client.on('studyForm', (form) => this.showForm(form));
    client.on('scene', (scene) => {
      this.sceneRevision_ = scene.revision;
      view.orders.setGroups(scene.groups);
      view.setScene(scene);
      view.camera.straightDown(scene.box, this.padding());
      this.lookDown();
    });
    client.on('motions', ({ clips }) => view.setMotions(clips));
    client.on('groupMesh', (mesh) => view.setGroupMesh(mesh));
    client.on('frame', ({ frame, receivedAt }) => this.showFrame(frame, receivedAt));
    client.on('marks', (marks) => {
      view.orders.setScheme(schemeView(marks));
      if (marks.notice !== '') this.tell(`${marks.notice}.`);
    });
    client.on('notice', ({ level, text }) => {
      const error = level === NoticeLevel.Error;
      this.tell(text, error);
      // A refused form is asked again, with what was answered.
      if (error) this.show({ busy: false });
    });
  }

  private act(act: StudyAct): void {
    this.client_.send({ type: 'DoInStudy', act });
  }

  private goOn(): void {
    this.show({ busy: true });
    const stage = this.state?.stage;
    if (stage === StudyStage.Ready) return this.act(StudyAct.Start);
    if (stage === StudyStage.Paused) return this.act(StudyAct.GoOn);
    // Whoever is next begins a run.
    if (stage !== StudyStage.Elsewhere) history.replaceState(null, '', location.pathname);
    location.reload();
  }

  private answer(answers: AnswerFrame[]): void {
    const { form } = this.shown_;
    this.show({ busy: true });
    if (form) this.client_.send({ type: 'AnswerForm', instrument: form.form.instrument, answers });
  }

  private showState(state: StudyState): void {
    const before = this.state;
    this.state = state;
    const { stage } = state;
    if (state.token !== '' && tokenOf(location.hash) !== state.token) history.replaceState(null, '', `#${state.token}`);
    if (state.mmPerPixel > 0) this.pointers_.mmPerPixel = state.mmPerPixel;
    const trial = stage === StudyStage.Trial;
    this.pointers_.setTrial(trial ? state : null);
    const done = state.trial > 0 ? (state.trial - 1) / Math.max(1, state.trials) : this.shown_.done;
    const goesOn = trial && before?.stage === StudyStage.Paused;
    const moment = goesOn ? this.shown_.moment : kBeginning;
    const form = stage === StudyStage.Form ? this.shown_.form : null;
    this.show({ form, done, moment, busy: stage === StudyStage.Form && this.shown_.busy });
    // What is asked is on its way.
    if (stage !== StudyStage.Form || form) this.show({ state });
    if (trial || stage === StudyStage.Replay) this.showScene(state);
  }

  private showScene({ mesh }: StudyState): void {
    this.view_.setLayers({ mesh, places: false, paths: mesh });
    this.view_.orders.setScheme(null);
    this.canvas_.focus({ preventScroll: true });
    this.lookDown();
  }

  private showForm(form: StudyForm): void {
    const number = ++this.forms_;
    this.show({
      form: { form, number },
      busy: false,
      ...(this.state?.stage === StudyStage.Form && { state: this.state }),
    });
  }

  private showFrame(frame: StudioFrame, receivedAt: number): void {
    if (frame.sceneRevision !== this.sceneRevision_) return;
    this.frame = frame;
    this.view_.pushFrame(frame, receivedAt);
    const { time, playing, speed } = frame;
    this.show({ moment: { time, playing, speed, collected: countOf(frame.collected) } });
  }

  private padding() {
    const bar = this.page_.querySelector('.study-bar')?.getBoundingClientRect().bottom ?? 0;
    return { top: bar + kRoom, right: kRoom, bottom: kRoom, left: kRoom };
  }

  /** Keeps all of the ground in view, below the bar, and tells the server. */
  private lookDown(): void {
    this.view_.camera.keepDown(this.padding());
    this.pointers_.look();
  }

  private readonly drawn = (): void => {
    requestAnimationFrame(this.drawn);
    this.pointers_.flush();
    if (this.client_.state.phase === 'open' && this.frame)
      this.attention_.consider(this.view_.attention(), performance.now());
  };
}
