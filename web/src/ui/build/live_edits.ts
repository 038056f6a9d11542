// Edits while a drag goes on: the world follows, at most ten times a second and not faster than it answers. All edits of
// a drag have one number, so that they are taken back together.

export interface LiveEditing<What> {
  /** Tells the server. `gesture` is the number of the drag. */
  send(what: What, gesture: number): void;
  now(): number;
}

/** From one edit to the next [ms]. */
const kApart = 100;
/** Whoever has no answer for so long goes on [ms]. */
const kPatience = 1000;

export class LiveEdits<What> {
  private gesture_ = 0;
  private sent_ = false;
  private sentAt_ = -Infinity;
  private awaits_ = false;
  private next_: What | null = null;
  private timer_: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly host_: LiveEditing<What>) {}

  /** A drag begins; its edits have that number. */
  begin(gesture: number): void {
    this.stop();
    this.gesture_ = gesture;
    this.sent_ = false;
  }

  /** How the drag leaves things at present. */
  drag(what: What): void {
    this.next_ = what;
    this.sendNext();
  }

  /** The last edit of the drag. */
  end(what: What): void {
    this.stop();
    this.send(what);
  }

  /** The drag is given up: where the world has followed, it goes back. */
  cancel(before: What): void {
    this.stop();
    if (this.sent_) this.send(before);
    this.sent_ = false;
  }

  /** The server has shown something newer. */
  answered(): void {
    this.awaits_ = false;
    this.sendNext();
  }

  private stop(): void {
    clearTimeout(this.timer_);
    this.timer_ = undefined;
    this.next_ = null;
  }

  private send(what: What): void {
    this.next_ = null;
    this.sent_ = true;
    this.awaits_ = true;
    this.sentAt_ = this.host_.now();
    this.host_.send(what, this.gesture_);
  }

  private sendNext(): void {
    if (this.next_ === null) return;
    const since = this.host_.now() - this.sentAt_;
    const wait = (this.awaits_ ? kPatience : kApart) - since;
    if (wait <= 0) return this.send(this.next_);
    clearTimeout(this.timer_);
    this.timer_ = setTimeout(() => this.sendNext(), wait);
  }
}
