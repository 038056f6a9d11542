// What is said when a demonstration begins and ends, whoever asked for it.

export class DemonstrationWatch {
  private running_ = false;

  /** What to say of a frame; null where nothing changed. */
  observe(running: boolean): string | null {
    if (running === this.running_) return null;
    this.running_ = running;
    return running ? 'A demonstration is running' : 'The demonstration has ended';
  }
}
