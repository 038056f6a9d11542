// Finds what somebody would fill in.

/** The field with that label. */
export function fieldOf(root: HTMLElement, label: string): HTMLInputElement {
  const found = [...root.querySelectorAll<HTMLInputElement>('input, select')].find(
    (one) => (one.getAttribute('aria-label') ?? one.labels?.[0]?.firstElementChild?.textContent) === label,
  );
  if (!found) throw new Error(`no field ${label}`);
  return found;
}

/** Fills it in. */
export function fillIn(root: HTMLElement, label: string, value: string, ...events: string[]): void {
  const input = fieldOf(root, label);
  input.value = value;
  for (const event of events) input.dispatchEvent(new Event(event));
}
