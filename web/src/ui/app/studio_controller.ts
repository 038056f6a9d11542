// Carries out the actions of panels and keys.

import { OverlayKind, PlaybackAction } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { MessageSender } from '../../link/studio_client';
import type { ShapeActions } from '../../model/shape_actions';
import { kHintSteps, type DialogName, type HintStep, type PlacesView } from '../../model/studio_state';
import { kBeginAgain, kWatch, openingOf, takeOpeningOf, whenAllowed } from '../../model/consent';
import { kObjectives, objectiveParameters } from '../../model/objective';
import { formationKind } from '../../model/sequence';
import type { OwnPeople } from '../steer/own_people';
import type { StandingController } from '../steer/standing_controller';
import type { StudioActions } from '../../model/studio_actions';
import { rememberRecording } from '../takes/recorder';
import { downloadTake, openTake } from '../takes/takes';
import { rememberTheme, writeSetting } from '../widgets/theme';
import type { GroundPoint } from '../../model/plane';
import type { Layers } from '../../model/view_settings';
import { scenarioBehind } from '../../model/scenario_behind';
import type { StudioStore } from '../../model/studio_store';

export const kSpeeds: readonly number[] = [0.25, 0.5, 1, 2, 4];
/** How long the hint stays when all of it is done [ms]. */
const kHintLingers = 1600;
export const kHintKey = 'muster.hint';
export const kFiguresKey = 'muster.figures';

/** The next speed in the list, round its ends; from between two, the next in that direction. */
export function nextSpeed(speed: number, back: boolean): number {
  const list = back ? [...kSpeeds].reverse() : kSpeeds;
  const next = list.find((one) => (back ? one < speed - 1e-3 : one > speed + 1e-3));
  return next ?? list[0]!;
}

export interface ControllerLink extends MessageSender {
  retry(): void;
}

/** What panels and keys ask of the camera. */
export type ControllerCamera = Pick<
  StudioActions,
  'toggleFollow' | 'frameGroup' | 'toggleTop' | 'toggleFlat' | 'saveView' | 'showView'
> & { lookAt(point: GroundPoint): void; fitInTurn(): void };

/** Notices about people who may not be in their places. */
const kOfStanding: readonly string[] = ['standing', 'stuck', 'noPath', 'partial', 'blocked'];

export class StudioController implements StudioActions {
  /** `say` speaks to the live region. */
  constructor(
    private readonly client_: ControllerLink,
    private readonly store_: StudioStore,
    private readonly camera_: ControllerCamera,
    private readonly say_: (text: string) => void,
    private readonly people_: Pick<OwnPeople, 'open' | 'reset'>,
    private readonly shapes_: Pick<ShapeActions, 'toggleDraw' | 'holdDraw' | 'lookAt' | 'shape'>,
    private readonly standing_: Pick<StandingController, 'show'>,
  ) {}

  togglePlay(): void {
    const { playing } = this.store_.state;
    this.client_.send({ type: 'Playback', action: playing ? PlaybackAction.Pause : PlaybackAction.Play });
    this.say_(playing ? 'Paused' : 'Playing');
  }

  singleStep(): void {
    this.client_.send({ type: 'Playback', action: PlaybackAction.SingleStep });
  }

  restart(): void {
    // In a take it is a seek, which harms nobody.
    if (this.store_.state.replaying) return this.beginAgain();
    whenAllowed(this.store_, kBeginAgain, () => this.beginAgain());
  }

  private beginAgain(): void {
    const { playing } = this.store_.state;
    this.client_.send({ type: 'Playback', action: PlaybackAction.Restart });
    // Who paused looks at the start before going on.
    if (!playing) this.client_.send({ type: 'Playback', action: PlaybackAction.Pause });
    this.say_(playing ? 'Back to the start' : 'Back to the start, paused');
  }

  toggleDemonstration(): void {
    const { demonstration, demonstrating } = this.store_.state;
    if (demonstrating) return this.restart();
    if (!demonstration) return this.say_('There is nothing to watch here');
    const action = PlaybackAction.Demonstrate;
    whenAllowed(this.store_, kWatch, () => this.client_.send({ type: 'Playback', action }));
  }

  nextSpeed(back = false): void {
    const factor = nextSpeed(this.store_.state.speed, back);
    this.client_.send({ type: 'SetSpeed', factor });
    this.say_(`Speed ${factor}`);
  }

  toggleRecord(): void {
    if (this.store_.state.replaying) {
      this.say_('A take is replayed: leave it to record');
      return;
    }
    const on = this.store_.state.recorded < 0;
    if (on) rememberRecording(true);
    this.client_.send({ type: 'Record', on });
    this.say_(on ? 'Recording' : 'Recording stopped');
  }

  showShelf(open: boolean): void {
    if (this.store_.state.shelf !== open) this.store_.set({ shelf: open });
  }

  downloadTake(): void {
    void downloadTake(this.store_.state.title).then((text) => this.tell(text));
  }

  openTake(file: File): void {
    const open = (): void => void openTake(file).then((text) => this.tell(text));
    whenAllowed(this.store_, takeOpeningOf(file.name.replace(/\.take$/, '')), open);
  }

  openCharacter(files: readonly File[]): void {
    void this.people_.open(files).then(() => this.say_(this.store_.state.notice?.text ?? ''));
  }

  ourPeople(): void {
    this.people_.reset();
    this.say_('Our people are back');
  }

  /**
   * Loads the scenario that was steered before the replay; where that is unknown, the one with the take's title, or
   * the first.
   */
  leaveReplay(): void {
    const found = scenarioBehind(this.store_.state);
    if (found) this.loadScenario(found.name);
  }

  loadScenario(name: string): void {
    const title = this.store_.state.scenarios.find((one) => one.name === name)?.title || name;
    whenAllowed(this.store_, openingOf(title), () => {
      this.setOverlay(OverlayKind.None, -1);
      this.client_.send({ type: 'LoadScenario', name });
    });
  }

  setObjective(index: number): void {
    const commands = objectiveParameters(this.store_.state.parameters, index).map(
      ({ name, value }) => ({ kind: 'parameter', name, value }) as const,
    );
    if (commands.length > 0) this.client_.send({ type: 'Commands', commands });
    this.say_(`Spots are given for: ${kObjectives[index]!.label.toLowerCase()}`);
  }

  setFormation(name: string): void {
    const { groups, active } = this.store_.state;
    const group = groups[active];
    if (!group) return;
    const formation = { kind: formationKind(name), spacing: this.shapes_.shape()?.spacing ?? 1 };
    this.client_.send({ type: 'Commands', commands: [{ kind: 'changeGroup', group: group.id, formation }] });
    // The change is announced when it happens.
    if (!this.store_.state.playing) this.say_(`${group.name}: ${name} with the next step`);
  }

  lookAtFormation(name: string | null): void {
    this.shapes_.lookAt(name);
  }

  setActiveGroup(index: number): void {
    const group = this.store_.state.groups[index];
    if (!group) return;
    this.store_.set({ active: index, selected: [group.id] });
    this.say_(`${group.name} chosen`);
  }

  /** Round the list. */
  nextGroup(): void {
    const { groups, active } = this.store_.state;
    if (groups.length > 0) this.setActiveGroup((active + 1) % groups.length);
  }

  toggleLayer(layer: keyof Layers): void {
    const { layers } = this.store_.state;
    this.store_.set({ layers: { ...layers, [layer]: !layers[layer] } });
  }

  toggleOverlay(kind: OverlayKind): void {
    const shown = this.store_.state.overlay === kind;
    this.setOverlay(shown ? OverlayKind.None : kind, -1);
  }

  /** The character whose cost is shown. */
  chooseCharacter(id: number): void {
    this.setOverlay(OverlayKind.Cost, id);
    this.say_(`Effort of person ${id}`);
  }

  openDialog(dialog: DialogName): void {
    this.store_.set({ dialog });
  }

  showPlaces(places: PlacesView, placeFiles: readonly File[] = []): void {
    this.store_.set({ places, placeFiles });
  }

  holdDraw(held: boolean, lost = false): void {
    this.shapes_.holdDraw(held, lost);
  }

  toggleDraw(): void {
    this.shapes_.toggleDraw();
  }

  toggleFigures(): void {
    const figures = !this.store_.state.figures;
    writeSetting(() => window.localStorage, kFiguresKey, figures ? 'shown' : 'hidden');
    this.store_.set({ figures });
  }

  toggleTheme(): void {
    const theme = this.store_.state.theme === 'dark' ? 'light' : 'dark';
    rememberTheme(window, theme);
    this.store_.set({ theme });
  }

  showHelp(open: boolean): void {
    if (this.store_.state.help !== open) this.store_.set({ help: open });
  }

  showSchemes(open: boolean): void {
    if (this.store_.state.schemesOpen !== open) this.store_.set({ schemesOpen: open });
  }

  chooseScheme(name: string): void {
    this.store_.set({ scheme: name });
  }

  tried(step: HintStep): void {
    const { hint, tried } = this.store_.state;
    if (!hint || tried.includes(step)) return;
    this.store_.set({ tried: [...tried, step] });
    // All is done: the ticks are seen for a moment.
    if (tried.length + 1 === kHintSteps.length) window.setTimeout(() => this.dismissHint(), kHintLingers);
  }

  dismissHint(): void {
    writeSetting(() => window.localStorage, kHintKey, 'seen');
    this.store_.set({ hint: false });
  }

  showNoticePlace(): void {
    const { notice } = this.store_.state;
    if (!notice?.hasPlace) return;
    const spot = { x: notice.x, y: notice.y };
    if (kOfStanding.includes(notice.code)) this.standing_.show(spot);
    else this.camera_.lookAt(spot);
  }

  showBarred(): void {
    this.standing_.show();
  }

  dismissNotice(): void {
    this.store_.set({ notice: null });
  }

  retry(): void {
    this.client_.retry();
  }

  goOnAlone(): void {
    if (this.store_.state.standby === 'ready') this.store_.set({ standby: 'wanted' });
  }

  fit(): void {
    this.camera_.fitInTurn();
  }

  toggleFollow(): void {
    this.camera_.toggleFollow();
  }

  frameGroup(index: number): void {
    this.camera_.frameGroup(index);
  }

  toggleTop(): void {
    this.camera_.toggleTop();
  }

  toggleFlat(): void {
    this.camera_.toggleFlat();
  }

  saveView(number: number): void {
    this.camera_.saveView(number);
  }

  showView(number: number): void {
    this.camera_.showView(number);
  }

  toggleClean(): void {
    const clean = !this.store_.state.clean;
    this.store_.set({ clean });
    this.say_(clean ? 'Marks and panels are hidden' : 'Marks and panels are back');
  }

  /** A server that was found again has forgotten the overlay. */
  askOverlayAgain(): void {
    const { overlay, chosen } = this.store_.state;
    if (overlay !== OverlayKind.None) this.askOverlay(overlay, chosen);
  }

  private setOverlay(kind: OverlayKind, chosen: number): void {
    this.store_.set({ overlay: kind, chosen, cost: null, ramp: null });
    this.askOverlay(kind, chosen);
  }

  private askOverlay(kind: OverlayKind, chosen: number): void {
    // Nobody chosen yet: there is no field to ask for.
    const wanted = kind === OverlayKind.Cost && chosen < 0 ? OverlayKind.None : kind;
    this.client_.send({ type: 'SetOverlay', kind: wanted, character: Math.max(0, chosen) });
  }

  private tell(text: string | null): void {
    if (text === null) return;
    this.store_.set({ notice: problem('take', text) });
  }
}
