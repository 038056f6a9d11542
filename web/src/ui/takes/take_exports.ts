// One export on the server: begun, followed, cancelled, saved.

import { save } from '../../link/answers';
import { exportAddress, type ExportProgress, type ExportWish, type ShelfLink } from '../../link/shelf_link';

const kPollMs = 300;

/** Calls back with the share done until the file is there. */
export class ServerExport {
  private number_ = '';
  private cancelled_ = false;

  constructor(
    private readonly shelf_: Pick<ShelfLink, 'beginExport' | 'exportProgress' | 'cancelExport'>,
    private readonly wait_: (ms: number) => Promise<void> = (ms) => new Promise((done) => setTimeout(done, ms)),
    private readonly save_: (address: string, fileName: string) => unknown = save,
  ) {}

  /** The finished file, which is saved; null where it was cancelled. Throws a sentence where it fails. */
  async run(wish: ExportWish, progress: (share: number) => void): Promise<ExportProgress | null> {
    const done = await this.follow(wish, progress, 'The take could not be exported');
    if (done) await this.save_(exportAddress(this.number_), done.file);
    return done;
  }

  /** How large it will be; null where it was cancelled. Throws a sentence where it cannot be. */
  async estimate(wish: ExportWish): Promise<ExportProgress | null> {
    const told = await this.follow({ ...wish, estimate: true }, () => undefined, 'This cannot be exported');
    if (told) await this.forget();
    return told;
  }

  private async follow(
    wish: ExportWish,
    progress: (share: number) => void,
    failure: string,
  ): Promise<ExportProgress | null> {
    this.number_ = await this.shelf_.beginExport(wish);
    while (!this.cancelled_) {
      const now = await this.shelf_.exportProgress(this.number_);
      if (this.cancelled_) break;
      if (now.state === 'failed') throw new Error(`${failure}: ${now.problem ?? 'unknown'}.`);
      progress(now.share);
      if (now.state === 'done') return now;
      await this.wait_(kPollMs);
    }
    await this.forget();
    return null;
  }

  private async forget(): Promise<void> {
    await this.shelf_.cancelExport(this.number_).catch(() => undefined);
  }

  cancel(): void {
    this.cancelled_ = true;
  }
}
