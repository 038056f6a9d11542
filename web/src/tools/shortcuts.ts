// One table of keys, for the handler and for the help.

export type ShortcutGroup = 'Crowd' | 'Orders' | 'Formations' | 'Time' | 'Camera' | 'Show';

export interface Shortcut {
  /** As the help shows it. */
  readonly keys: string;
  readonly does: string;
  readonly group: ShortcutGroup;
  /** `KeyboardEvent.key`, letters in lower case; empty for what is only explained here. */
  readonly match: readonly string[];
  readonly run?: (event: KeyboardEvent) => void;
  /** The key came up again, or the page lost it. */
  readonly release?: () => void;
  /** Only while the scene, not a button, has the focus. */
  readonly sceneOnly?: boolean;
  /** Again and again while the key is held. */
  readonly repeats?: boolean;
  /** With Ctrl (or Cmd) as well, or only so. */
  readonly ctrl?: true | 'only';
  /** Only with Alt, by `KeyboardEvent.code`: Alt changes the letter on some keyboards. */
  readonly alt?: readonly string[];
  /** Another line of the help tells of it. */
  readonly unlisted?: boolean;
}

/** Where typing or choosing goes on, shortcuts keep out. */
function isTyping(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    target.closest('input, textarea, select, dialog, [role="menu"], [role="listbox"]') !== null
  );
}

function isControl(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest('button, a, [role="toolbar"]') !== null;
}

export function findShortcut(
  shortcuts: readonly Shortcut[],
  event: Pick<KeyboardEvent, 'key' | 'code' | 'ctrlKey' | 'metaKey' | 'altKey' | 'target'>,
): Shortcut | null {
  if (isTyping(event.target)) return null;
  const ctrl = event.ctrlKey || event.metaKey;
  if (event.altKey) return ctrl ? null : (shortcuts.find((one) => one.run && one.alt?.includes(event.code)) ?? null);
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const fits = (shortcut: Shortcut): boolean => (ctrl ? !!shortcut.ctrl : shortcut.ctrl !== 'only');
  const found = shortcuts.find((shortcut) => shortcut.run && fits(shortcut) && shortcut.match.includes(key));
  return !found || (found.sceneOnly && isControl(event.target)) ? null : found;
}

export class ShortcutHandler {
  /** Keys that are held, by `KeyboardEvent.code`. */
  private readonly held_ = new Map<string, () => void>();

  constructor(
    target: EventTarget,
    private readonly shortcuts_: readonly Shortcut[],
  ) {
    target.addEventListener('keydown', (event) => this.handle(event as KeyboardEvent));
    target.addEventListener('keyup', (event) => this.release((event as KeyboardEvent).code));
    target.addEventListener('blur', () => [...this.held_.keys()].forEach((code) => this.release(code)));
  }

  private handle(event: KeyboardEvent): void {
    const shortcut = findShortcut(this.shortcuts_, event);
    if (!shortcut?.run || event.defaultPrevented) return;
    event.preventDefault();
    if (event.repeat && !shortcut.repeats) return;
    if (shortcut.release) this.held_.set(event.code, shortcut.release);
    shortcut.run(event);
  }

  private release(code: string): void {
    const release = this.held_.get(code);
    this.held_.delete(code);
    release?.();
  }
}
