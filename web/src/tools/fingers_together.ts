// Fingers that come down together make one new control, also where one of them touches what an earlier finger has left
// behind: a lifted control lies under the hand for as long as the crowd follows it.

import type { Contact, ContactOwner } from './contact';
import type { FormationHit } from './formation_hit_test';
import type { Grab } from './grab';

/** As the server's `input.window` [s]. */
const kTogether = 0.15;

/** Drags a lifted control, until another finger shows that a new one was meant. */
class Finger implements ContactOwner {
  private first_: Contact | null = null;
  private last_: Contact | null = null;

  constructor(
    private owner_: ContactOwner,
    private readonly fresh_: ContactOwner,
  ) {}

  begin(contact: Contact): void {
    this.first_ = this.last_ = contact;
    this.owner_.begin(contact);
  }

  move(contacts: readonly Contact[]): void {
    this.last_ = contacts[contacts.length - 1] ?? this.last_;
    this.owner_.move(contacts);
  }

  end(contact: Contact, cancelled: boolean): void {
    this.first_ = null;
    this.owner_.end(contact, cancelled);
  }

  /** Lets go of what it drags, and is a finger on the formation from its start on. */
  turn(): void {
    const { first_: first, last_: last } = this;
    if (!first || !last || this.owner_ === this.fresh_) return;
    this.owner_.end(last, true);
    this.owner_ = this.fresh_;
    this.fresh_.begin(first);
    if (last !== first) this.fresh_.move([last]);
  }
}

/** Nobody holds it, and it is not to stay. */
function isLeftBehind({ control }: Grab): boolean {
  return !control.pinned && control.points.every(({ down }) => !down);
}

export class FingersTogether {
  private young_: { readonly finger: Finger; readonly time: number; readonly group: number }[] = [];

  /** The owner of a finger on this formation: `drag` where it comes alone onto a control, else `fresh`. */
  ownerFor(
    contact: Contact,
    { group }: FormationHit,
    grab: Grab | null,
    drag: () => ContactOwner,
    fresh: ContactOwner,
  ): ContactOwner {
    if (grab && !isLeftBehind(grab)) return drag();
    this.young_ = this.young_.filter(({ time }) => contact.time - time <= kTogether);
    const others = this.young_.filter((one) => one.group === group);
    for (const { finger } of others) finger.turn();
    const finger = new Finger(grab && others.length === 0 ? drag() : fresh, fresh);
    this.young_.push({ finger, time: contact.time, group });
    return finger;
  }
}
