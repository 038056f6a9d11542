// A run of the study on the page, and the replay of a trial: one stage after the other, as the server tells.

import './study.css';
import { NoticeLevel, StudyAct, StudyStage, type StudyForm, type StudyState } from '../../protocol/messages';
import type { StudioClient } from '../../link/studio_client';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioView } from '../../scene/studio_view';
import { AttentionSender } from '../app/attention_sender';
import { LayoutWatcher } from '../app/layout_watcher';
import { schemeView } from '../steer/scheme_controller';
import { applyTheme, followSystemTheme, preferredTheme } from '../widgets/theme';
import { formPage } from './form_page';
import { ReplayBar } from './replay_bar';
import { elsewherePage, endPage, pausedPage, readyPage, waitingPage } from './stage_pages';
import { StudyShell } from './study_shell';
import { TrialBar } from './trial_bar';
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

export class StudyApp {
  /** Newest frame of a trial. */
  frame: StudioFrame | null = null;
  /** Where the run stands. */
  state: StudyState | null = null;
  private form_: StudyForm | null = null;
  private sceneRevision_ = 0;
  private readonly pointers_: TrialPointers;
  private readonly attention_: AttentionSender;
  private readonly shell_: StudyShell;
  private readonly trialBar_: TrialBar;
  private readonly replayBar_: ReplayBar;

  constructor(
    private readonly client_: StudioClient,
    private readonly view_: StudioView,
    private readonly canvas_: HTMLCanvasElement,
    page: HTMLElement,
  ) {
    this.trialBar_ = new TrialBar(
      () => this.act(StudyAct.GiveUp),
      () => this.shell_.askStop(),
    );
    this.replayBar_ = new ReplayBar(client_);
    this.shell_ = new StudyShell(page, [this.trialBar_.root, this.replayBar_.root], {
      stop: () => this.act(StudyAct.BreakOff),
      retry: () => client_.retry(),
    });
    this.pointers_ = new TrialPointers(client_, view_, canvas_, (text) => this.shell_.tell(text));
    this.attention_ = new AttentionSender(client_);
    this.followSettings();
    this.followClient();
    this.shell_.showCard(waitingPage());
    requestAnimationFrame(this.drawn);
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
      view.setLost(link.phase !== 'open' && this.state !== null);
      this.shell_.showLink(link);
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
      if (marks.notice !== '') this.shell_.tell(`${marks.notice}.`);
    });
    client.on('notice', ({ level, text }) => {
      this.shell_.tell(text, level === NoticeLevel.Error);
      // A refused form is asked again, with what was answered.
      if (level === NoticeLevel.Error) this.shell_.enableButtons();
    });
  }

  private act(act: StudyAct): void {
    this.client_.send({ type: 'DoInStudy', act });
  }

  private showState(state: StudyState): void {
    const before = this.state;
    this.state = state;
    if (state.token !== '' && tokenOf(location.hash) !== state.token) history.replaceState(null, '', `#${state.token}`);
    if (state.mmPerPixel > 0) this.pointers_.mmPerPixel = state.mmPerPixel;
    const trial = state.stage === StudyStage.Trial;
    const replay = state.stage === StudyStage.Replay;
    this.trialBar_.root.hidden = !trial;
    this.replayBar_.root.hidden = !replay;
    this.pointers_.setTrial(trial ? state : null);
    this.shell_.showRun(state);
    if (trial || replay) {
      const mesh = state.mesh;
      this.view_.setLayers({ mesh, places: false, paths: mesh });
      this.view_.orders.setScheme(null);
      this.shell_.showScene();
      if (replay) this.replayBar_.show(state);
      else if (before?.stage !== StudyStage.Paused) this.trialBar_.show(state);
      this.canvas_.focus({ preventScroll: true });
      this.lookDown();
    } else if (state.stage !== StudyStage.Form) {
      this.shell_.showCard(this.cardOf(state));
    }
  }

  private cardOf(state: StudyState): HTMLElement {
    if (state.stage === StudyStage.Ready) return readyPage(state, () => this.act(StudyAct.Start));
    if (state.stage === StudyStage.Elsewhere) return elsewherePage(() => location.reload());
    if (state.stage !== StudyStage.Paused) return endPage(state, () => this.nextPerson());
    this.trialBar_.show(state);
    return pausedPage(() => this.act(StudyAct.GoOn));
  }

  private nextPerson(): void {
    history.replaceState(null, '', location.pathname);
    location.reload();
  }

  private showForm(form: StudyForm): void {
    this.form_ = form;
    const send = (answers: readonly { name: string; text: string; number: number }[]): void =>
      this.client_.send({ type: 'AnswerForm', instrument: this.form_!.instrument, answers: [...answers] });
    this.shell_.showCard(formPage(form, send));
  }

  private showFrame(frame: StudioFrame, receivedAt: number): void {
    if (frame.sceneRevision !== this.sceneRevision_) return;
    this.frame = frame;
    this.view_.pushFrame(frame, receivedAt);
    const collected = countOf(frame.collected);
    if (this.state?.stage === StudyStage.Replay) this.replayBar_.update(frame, collected);
    else this.trialBar_.update(frame.time, collected);
  }

  private padding() {
    const bar = [this.trialBar_, this.replayBar_].map(({ root }) => root.getBoundingClientRect().bottom);
    return { top: Math.max(...bar) + kRoom, right: kRoom, bottom: kRoom, left: kRoom };
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
