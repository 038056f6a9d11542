// Who directs this world: names, colours, what each holds and may direct.

import type { DirectorFrame } from '../protocol/messages';
import type { GroupView } from './frame_view';

export interface DirectorInfo {
  readonly client: number;
  readonly name: string;
  readonly colour: string;
  /** The reader of this page. */
  readonly own: boolean;
  /** Ids of the groups that they may direct; empty: all. */
  readonly groups: readonly number[];
  /** Ids of the groups on which they hold a control. */
  readonly holds: readonly number[];
}

/** How others come into this studio; no links where only this machine may connect. */
export interface Invitation {
  readonly links: readonly string[];
  /** Rows of the first link's QR code, "1" for dark. */
  readonly code: readonly string[];
  /** Address of a site, for links that need no studio; empty where none is known. */
  readonly site: string;
}

/** What the panel asks for. */
export interface DirectorActions {
  rename(name: string): void;
  /** 0: everything. */
  giveGroup(client: number, group: number): void;
  copyLink(link: string): void;
  /** The world that somebody has replaced comes back. */
  goBack(): void;
}

/** White is read on each of them, and each is seen on the ground, light or dark. */
const kColours = [
  '#7a3fc4',
  '#0a7d78',
  '#b8236b',
  '#2f62d6',
  '#9a5b00',
  '#3f7a1c',
  '#c0391b',
  '#5a6472',
  '#8a3d8f',
  '#00749c',
  '#a3482f',
  '#4a53c7',
  '#6c6a00',
  '#1c7f4b',
  '#ad2e4b',
  '#7b5a44',
] as const;

/** The colour of that number. */
export function directorColour(index: number): string {
  return kColours[((index % kColours.length) + kColours.length) % kColours.length]!;
}

/** The first letter of a name, or its number. */
export function initialOf(name: string): string {
  const number = /^Director (\d+)$/.exec(name);
  return number ? number[1]! : ([...name][0] ?? '?').toUpperCase();
}

/** Everybody who is connected, in their order, with what they hold in a frame. */
export function directorInfos(
  frames: readonly DirectorFrame[],
  own: number,
  groups: readonly Pick<GroupView, 'id' | 'controls'>[],
): DirectorInfo[] {
  return frames.map(({ client, name, colour, groups: given }) => ({
    client,
    name,
    colour: directorColour(colour),
    own: client === own,
    groups: [...given],
    holds: groups.filter(({ controls }) => controls.some((one) => one.client === client)).map(({ id }) => id),
  }));
}

/** Equal lists are not shown again. */
export function sameDirectors(a: readonly DirectorInfo[], b: readonly DirectorInfo[]): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
