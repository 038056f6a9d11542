// Several directors: who is there, what each holds and may direct, and how others come in.

import { ask, setOwnNumber } from '../../link/answers';
import type { MessageSender } from '../../link/studio_client';
import {
  directorInfos,
  sameDirectors,
  type DirectorActions,
  type DirectorInfo,
  type Invitation,
} from '../../model/directors';
import type { GroupView } from '../../model/frame_view';
import type { StudioStore } from '../../model/studio_store';
import { PlaybackAction, type DirectorFrame } from '../../protocol/messages';
import { readSetting, writeSetting } from '../widgets/theme';

export const kNameKey = 'muster.name';

export interface DirectorsView {
  setDirectors(directors: readonly DirectorInfo[]): void;
}

export class DirectorsController implements DirectorActions {
  private frames_: readonly DirectorFrame[] = [];
  private groups_: readonly Pick<GroupView, 'id' | 'controls'>[] = [];

  /** `own` tells our number; `say` speaks to the live region. */
  constructor(
    private readonly client_: MessageSender,
    private readonly store_: StudioStore,
    private readonly view_: DirectorsView,
    private readonly own_: () => number,
    private readonly say_: (text: string) => void,
    private readonly storage_: () => Storage = () => window.localStorage,
  ) {}

  /** After each welcome: the server learns the name that this browser kept. */
  greeted(own: number): void {
    setOwnNumber(own);
    const name = readSetting(this.storage_, kNameKey);
    if (name) this.client_.send({ type: 'SetName', name });
    void this.askInvitation();
  }

  took(frames: readonly DirectorFrame[]): void {
    const before = new Map(this.frames_.map(({ client, name }) => [client, name]));
    const known = this.frames_.length > 0;
    this.frames_ = frames;
    if (known) {
      for (const { client, name } of frames) {
        if (!before.delete(client)) this.say_(`${name} came`);
      }
      for (const name of before.values()) this.say_(`${name} left`);
    }
    this.show();
  }

  observe(groups: readonly Pick<GroupView, 'id' | 'controls'>[]): void {
    this.groups_ = groups;
    // Who is alone looks at nobody else's hands.
    if (this.frames_.length > 1) this.show();
  }

  rename(name: string): void {
    writeSetting(this.storage_, kNameKey, name.trim());
    this.client_.send({ type: 'SetName', name });
  }

  giveGroup(client: number, group: number): void {
    this.client_.send({ type: 'GiveGroup', client, group });
  }

  goBack(): void {
    this.client_.send({ type: 'Playback', action: PlaybackAction.GoBack });
  }

  copyLink(link: string): void {
    // Only pages of this machine itself may copy.
    if (!window.isSecureContext) return this.say_('This page may not copy: choose the link and copy it');
    void navigator.clipboard.writeText(link).then(
      () => this.say_('Link copied'),
      () => this.say_('The link could not be copied'),
    );
  }

  private show(): void {
    const directors = directorInfos(this.frames_, this.own_(), this.groups_);
    if (sameDirectors(directors, this.store_.state.directors)) return;
    this.store_.set({ directors });
    this.view_.setDirectors(directors);
  }

  private async askInvitation(): Promise<void> {
    try {
      const answer = await ask('invitation.json', { cache: 'no-store' });
      if (!answer.ok) return;
      this.store_.set({ invitation: (await answer.json()) as Invitation });
    } catch {
      // A page without this server has no invitation.
    }
  }
}
