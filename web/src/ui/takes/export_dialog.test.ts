// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { ExportDialog } from './export_dialog';

beforeEach(() => {
  vi.useFakeTimers();
  HTMLDialogElement.prototype.showModal = function () {
    this.open = true;
  };
});
afterEach(() => void vi.useRealTimers());

it('says nothing of the size of a choice that has been changed since', async () => {
  const answers: ((size: string) => void)[] = [];
  const size = (): Promise<string> => new Promise((done) => answers.push(done));
  const dialog = new ExportDialog(() => true, { begin: () => undefined, cancel: () => undefined, size });
  document.body.append(dialog.root);
  dialog.open({ title: 'Take', from: 0, to: 9, end: 9, groups: [] });
  const said = dialog.root.querySelector<HTMLElement>('.export-size')!;
  const choose = (kind: string): void => dialog.root.querySelector<HTMLElement>(`input[value="${kind}"]`)!.click();
  choose('csv');
  vi.advanceTimersByTime(400);
  choose('glb');
  answers[0]!('About 1 MB');
  await vi.advanceTimersByTimeAsync(100);
  expect(said.hidden).toBe(true);
  await vi.advanceTimersByTimeAsync(400);
  answers[1]!('About 7 MB');
  await vi.advanceTimersByTimeAsync(0);
  expect(said.textContent).toBe('About 7 MB');
  expect(said.hidden).toBe(false);
});
