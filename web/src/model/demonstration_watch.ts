// Announces the begin and the end of a demonstration, whichever client started it.

export class DemonstrationWatch {
  private running_ = false;

  /** What to say of a frame; null where nothing changed. */
  observe(running: boolean): string | null {
    if (running === this.running_) return null;
    this.running_ = running;
    return running ? 'A demonstration is running' : 'The demonstration has ended';
  }
}
