// Cut off recordings that the visitor has seen: each is offered once.

const kKey = 'muster.cutoff';

export function seenTakes(): readonly string[] {
  try {
    return JSON.parse(window.localStorage.getItem(kKey) ?? '[]') as string[];
  } catch {
    return [];
  }
}

export function markSeen(name: string): void {
  try {
    window.localStorage.setItem(kKey, JSON.stringify([...seenTakes(), name].slice(-50)));
  } catch {
    // Without storage it is offered again.
  }
}
