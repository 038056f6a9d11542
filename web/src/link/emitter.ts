// Typed events.

type Handler<T> = (value: T) => void;

export class Emitter<Events extends object> {
  private readonly handlers_ = new Map<keyof Events, Set<Handler<never>>>();

  /** Returns what ends the subscription. */
  on<K extends keyof Events>(name: K, handler: Handler<Events[K]>): () => void {
    const set = this.handlers_.get(name) ?? new Set();
    set.add(handler);
    this.handlers_.set(name, set);
    return () => set.delete(handler);
  }

  protected emit<K extends keyof Events>(name: K, value: Events[K]): void {
    for (const handler of this.handlers_.get(name) ?? []) (handler as Handler<Events[K]>)(value);
  }
}
