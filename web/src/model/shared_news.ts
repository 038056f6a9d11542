// What is told of the others on the world that all share, and what one can do about it.

import { WorldChange, type SharedWorld } from '../protocol/messages';
import type { StudioState } from './studio_state';

export type SharedFacts = Omit<SharedWorld, 'type'>;

export const kNothingShared: SharedFacts = {
  pausedBy: 0,
  builders: new Uint32Array(),
  change: WorldChange.None,
  changedBy: 0,
  changer: '',
  before: '',
};

export interface SharedNews {
  readonly text: string;
  readonly offer: 'play' | 'back';
  readonly offerText: string;
}

type NewsState = Pick<StudioState, 'shared' | 'directors' | 'playing' | 'title' | 'replaying'>;

/** "Ada", "Ada and Ben", "Ada, Ben and Cleo". */
export function namesOf(names: readonly string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)!}`;
}

/** What the button is called that brings the world before back. */
export function backText({ shared, title }: Pick<NewsState, 'shared' | 'title'>): string {
  return shared.before === title ? 'Back to how it was' : `Back to ${shared.before}`;
}

function changeText({ shared, directors, title, replaying }: NewsState): string {
  const own = directors.some((one) => one.own && one.client === shared.changedBy);
  const place = replaying ? 'a take' : title;
  switch (shared.change) {
    case WorldChange.Opened:
      return own ? `${replaying ? 'The take' : title} is open for all.` : `${shared.changer} opened ${place}.`;
    case WorldChange.Restarted:
      return own ? 'It began again for all.' : `${shared.changer} began again.`;
    case WorldChange.Watched:
      return own ? 'All see the demonstration.' : `${shared.changer} shows the demonstration.`;
    case WorldChange.WentBack:
    case WorldChange.None:
      return own ? `All are back in ${place}.` : `${shared.changer} went back to ${place}.`;
  }
}

/** The most pressing news; null where there is none. `seen`: the last change has been read. */
export function sharedNews(state: NewsState, seen: boolean): SharedNews | null {
  const { shared, directors, playing } = state;
  const builders = directors.filter(({ own, client }) => !own && shared.builders.includes(client));
  const play = { offer: 'play', offerText: 'Play' } as const;
  if (builders.length > 0 && !playing) {
    const are = builders.length > 1 ? 'are' : 'is';
    return { text: `${namesOf(builders.map(({ name }) => name))} ${are} building; the world waits.`, ...play };
  }
  const pauser = directors.find(({ client }) => client === shared.pausedBy);
  if (pauser && !pauser.own && !playing) return { text: `${pauser.name} paused.`, ...play };
  if (seen || shared.before === '' || shared.change === WorldChange.None) return null;
  return { text: changeText(state), offer: 'back', offerText: backText(state) };
}
