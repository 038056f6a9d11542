// Replaces Muster's characters by a visitor's own, from a chosen file.

import { sentenceOf } from '../../model/file_trouble';
import { NoticeLevel, type Notice } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { OwnCharacter } from '../../scene/crowd/own_character/own_character';
import type { StudioScene } from '../../scene/studio_scene';
import type { StudioStore } from '../../model/studio_store';
import type { CharacterCopy } from './own_people_copy';

/** Reads files; throws with a sentence for the visitor. */
export type CharacterReader = (files: readonly File[]) => Promise<OwnCharacter>;

/** More triangles than this make a crowd slow. */
const kManyTriangles = 15000;

async function readLazily(files: readonly File[]): Promise<OwnCharacter> {
  const { readCharacter } = await import('../../scene/crowd/own_character/own_character');
  return readCharacter(files);
}

function noticeOf(code: string, level: NoticeLevel, text: string): Notice {
  return { ...problem(code, text), level };
}

/** What is said when it has come. */
export function welcomeText({ body, clips, triangles }: OwnCharacter): string {
  const own = clips.length > 0 ? `, with ${clips.map((clip) => clip.name).join(', ')} of its own` : '';
  const slow =
    triangles > kManyTriangles
      ? `; with ${Math.round(triangles).toLocaleString('en')} triangles a large crowd of it will be slow`
      : '';
  return `Everybody is ${body.name} now${own}${slow}.`;
}

export class OwnPeople {
  /** Number of the newest request. A file whose reading ends after a newer request is dropped. */
  private requests_ = 0;

  constructor(
    private readonly view_: Pick<StudioScene, 'setOwnBody'>,
    private readonly store_: StudioStore,
    private readonly read_: CharacterReader = readLazily,
    private readonly copy_: CharacterCopy | null = null,
  ) {}

  /** Reads files and dresses everybody; says why where it cannot. */
  async open(files: readonly File[]): Promise<void> {
    if (files.length === 0 || !(await this.dress(files))) return;
    await this.copy_?.keep(files);
  }

  /** Dresses everybody as before a reload, without a word. */
  async restore(): Promise<void> {
    const requests = this.requests_;
    const files = (await this.copy_?.read()) ?? [];
    if (files.length === 0 || requests !== this.requests_) return;
    const { notice } = this.store_.state;
    if (await this.dress(files)) this.store_.set({ notice });
  }

  /** False where the files will not do, or something else was asked for meanwhile. */
  private async dress(files: readonly File[]): Promise<boolean> {
    const mine = ++this.requests_;
    try {
      const character = await this.read_(files);
      if (mine !== this.requests_) return false;
      this.view_.setOwnBody(character.body, character.clips);
      const level = character.triangles > kManyTriangles ? NoticeLevel.Warning : NoticeLevel.Info;
      this.store_.set({
        ownCharacter: character.body.name,
        notice: noticeOf('character', level, welcomeText(character)),
      });
      return true;
    } catch (error) {
      if (mine !== this.requests_) return false;
      const text = sentenceOf(error, 'The character cannot be used: its skeleton or its meshes are damaged.');
      this.store_.set({ notice: problem('character', text) });
      return false;
    }
  }

  reset(): void {
    this.requests_ += 1;
    this.view_.setOwnBody(null);
    this.store_.set({ ownCharacter: '' });
    void this.copy_?.forget();
  }
}
