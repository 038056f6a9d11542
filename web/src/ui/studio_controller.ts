// Carries out what panels and keys ask for.

import { OverlayKind, TransportAction } from '../protocol/messages';
import { problem } from '../protocol/problem';
import type { MessageSender } from '../engine/studio_client';
import type { GroundPoint } from '../view/camera_types';
import { OBJECTIVES, objectiveParameter } from './objective';
import type { OwnPeople } from './own_people';
import type { StudioActions } from './studio_actions';
import type { LayerState, StudioStore } from './studio_state';
import { downloadTake, openTake } from './takes';
import { rememberTheme, writeSetting } from './theme';

export const SPEEDS: readonly number[] = [0.25, 0.5, 1, 2, 4];
export const HINT_KEY = 'muster.hint';

/** The next speed in the list, round its ends; from between two, the next in that direction. */
export function nextSpeed(speed: number, back: boolean): number {
  const list = back ? [...SPEEDS].reverse() : SPEEDS;
  const next = list.find((one) => (back ? one < speed - 1e-3 : one > speed + 1e-3));
  return next ?? list[0]!;
}

export interface ControllerLink extends MessageSender {
  retry(): void;
}

/** What panels and keys ask of the camera. */
export interface ControllerCamera {
  fitCrowd(): void;
  lookAt(point: GroundPoint): void;
}

export class StudioController implements StudioActions {
  /** `say` speaks to the live region. */
  constructor(
    private readonly client: ControllerLink,
    private readonly store: StudioStore,
    private readonly camera: ControllerCamera,
    private readonly say: (text: string) => void,
    private readonly people: Pick<OwnPeople, 'open' | 'reset'>,
  ) {}

  togglePlay(): void {
    const { playing } = this.store.state;
    this.client.send({ type: 'Transport', action: playing ? TransportAction.Pause : TransportAction.Play });
    this.say(playing ? 'Paused' : 'Playing');
  }

  singleStep(): void {
    this.client.send({ type: 'Transport', action: TransportAction.SingleStep });
  }

  restart(): void {
    this.client.send({ type: 'Transport', action: TransportAction.Restart });
    this.say('Back to the start');
  }

  toggleDemonstration(): void {
    const { demonstration, demonstrating } = this.store.state;
    if (demonstrating) return this.restart();
    if (!demonstration) return this.say('There is nothing to watch here');
    this.client.send({ type: 'Transport', action: TransportAction.Demonstrate });
  }

  nextSpeed(back = false): void {
    const factor = nextSpeed(this.store.state.speed, back);
    this.client.send({ type: 'SetSpeed', factor });
    this.say(`Speed ${factor}`);
  }

  toggleRecord(): void {
    if (this.store.state.replaying) {
      this.say('A take is replayed: leave it to record');
      return;
    }
    const on = this.store.state.recorded < 0;
    this.client.send({ type: 'Record', on });
    this.say(on ? 'Recording' : 'Recording stopped');
  }

  downloadTake(): void {
    void downloadTake(this.store.state.title).then((text) => this.tell(text));
  }

  openTake(file: File): void {
    void openTake(file).then((text) => this.tell(text));
  }

  openCharacter(files: readonly File[]): void {
    void this.people.open(files).then(() => this.say(this.store.state.notice?.text ?? ''));
  }

  ourPeople(): void {
    this.people.reset();
    this.say('Our people are back');
  }

  /** Loads what was there before the take; where that is unknown, the scenario that is called like it, or the first. */
  leaveReplay(): void {
    const { scenarios, title, lastLive } = this.store.state;
    const found = scenarios.find(({ name }) => name === lastLive) ?? scenarios.find((one) => one.title === title) ?? scenarios[0];
    if (found) this.loadScenario(found.name);
  }

  loadScenario(name: string): void {
    this.setOverlay(OverlayKind.None, -1);
    this.client.send({ type: 'LoadScenario', name });
  }

  setObjective(index: number): void {
    const { name, value } = objectiveParameter(this.store.state.parameters, index);
    this.client.send({ type: 'SetParameter', name, value });
    this.say(`Plans: ${OBJECTIVES[index]!.label.toLowerCase()}`);
  }

  setFormation(name: string): void {
    const { groups, active } = this.store.state;
    const group = groups[active];
    if (!group) return;
    this.client.send({ type: 'SetFormation', group: group.id, formation: name });
    // The change itself is spoken when it happens.
    if (!this.store.state.playing) this.say(`${group.name}: ${name} with the next step`);
  }

  setActiveGroup(index: number): void {
    const group = this.store.state.groups[index];
    if (!group) return;
    this.store.set({ active: index });
    this.say(`${group.name} chosen`);
  }

  /** Round the list. */
  nextGroup(): void {
    const { groups, active } = this.store.state;
    if (groups.length > 0) this.setActiveGroup((active + 1) % groups.length);
  }

  toggleLayer(layer: keyof LayerState): void {
    const { layers } = this.store.state;
    this.store.set({ layers: { ...layers, [layer]: !layers[layer] } });
  }

  toggleOverlay(kind: OverlayKind): void {
    const shown = this.store.state.overlay === kind;
    this.setOverlay(shown ? OverlayKind.None : kind, -1);
  }

  /** The character whose cost is shown. */
  chooseCharacter(id: number): void {
    this.setOverlay(OverlayKind.Cost, id);
    this.say(`Cost of character ${id}`);
  }

  toggleTheme(): void {
    const theme = this.store.state.theme === 'dark' ? 'light' : 'dark';
    rememberTheme(window, theme);
    this.store.set({ theme });
  }

  showHelp(open: boolean): void {
    if (this.store.state.help !== open) this.store.set({ help: open });
  }

  dismissHint(): void {
    writeSetting(() => window.localStorage, HINT_KEY, 'seen');
    this.store.set({ hint: false });
  }

  showNoticePlace(): void {
    const { notice } = this.store.state;
    if (notice?.hasPlace) this.camera.lookAt({ x: notice.x, y: notice.y });
  }

  dismissNotice(): void {
    this.store.set({ notice: null });
  }

  retry(): void {
    this.client.retry();
  }

  fit(): void {
    this.camera.fitCrowd();
  }

  /** A server that was found again knows nothing of what was asked for. */
  askOverlayAgain(): void {
    const { overlay, chosen } = this.store.state;
    if (overlay !== OverlayKind.None) this.askOverlay(overlay, chosen);
  }

  private setOverlay(kind: OverlayKind, chosen: number): void {
    this.store.set({ overlay: kind, chosen, cost: null, ramp: null });
    this.askOverlay(kind, chosen);
  }

  private askOverlay(kind: OverlayKind, chosen: number): void {
    // Nobody chosen yet: there is no field to ask for.
    const asked = kind === OverlayKind.Cost && chosen < 0 ? OverlayKind.None : kind;
    this.client.send({ type: 'SetOverlay', kind: asked, character: Math.max(0, chosen) });
  }

  private tell(text: string | null): void {
    if (text === null) return;
    this.store.set({ notice: problem('take', text) });
  }
}
