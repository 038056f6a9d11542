// Which controls of the page cannot be hit where they are drawn.
import { expect } from './expect.mjs';

/** Runs in the page: controls of the panels, or of what is open above them, that something else covers or the window cuts off,
 * and panels that do. */
function findUnreachable() {
  const kControls = 'button, a[href], input, select, textarea, summary, [role="slider"], [tabindex="0"]';
  const shows = (node) => {
    const box = node.getBoundingClientRect();
    return box.width > 1 && box.height > 1 && node.checkVisibility({ visibilityProperty: true });
  };
  const wanted = (node) =>
    shows(node) && !node.closest('[inert], .unseen') && node.type !== 'file' && node.ariaHidden !== 'true';
  const nameOf = (node) => {
    const panel = node.closest('.panel, dialog, [popover]');
    const word = node.ariaLabel || node.textContent.trim().slice(0, 24);
    return `${(panel?.className ?? 'scene').split(' ')[0]}: ${word || node.id || node.localName}`;
  };
  // What lets presses through is held by what it stands in.
  const held = (node) => (getComputedStyle(node).pointerEvents === 'none' ? held(node.parentElement) : node);
  const isIn = (hit, node) => hit !== null && [held(node), node.closest('label')].some((one) => one?.contains(hit));

  // Where no panel is seen a press is the scene's.
  const blindSpots = () => {
    const found = new Set();
    for (let x = 10; x < innerWidth; x += 40)
      for (let y = 10; y < innerHeight; y += 40) {
        const hit = document.elementFromPoint(x, y);
        if (!hit.closest('.panel, .sheet, canvas, svg')) found.add(`a press at ${x}, ${y} is caught by ${nameOf(hit)}`);
      }
    return [...found].slice(0, 2);
  };
  const dialog = [...document.querySelectorAll('dialog[open]')].at(-1);
  const popovers = [...document.querySelectorAll('#ui [popover]')].filter((node) => node.matches(':popover-open'));
  const menus = popovers.filter((node) => node.matches('[role], .panel') && node.role !== 'tooltip');
  const open = dialog ?? menus.at(-1);
  const root = open ?? document.querySelector('#ui');
  const covered = [];
  const outside = [];
  for (const node of [...root.querySelectorAll(kControls)].filter(wanted)) {
    node.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    const box = node.getBoundingClientRect();
    const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
    const hit = document.elementFromPoint(x, y);
    if (x < 0 || y < 0 || x > innerWidth || y > innerHeight) outside.push(nameOf(node));
    else if (!isIn(hit, node)) covered.push(`${nameOf(node)} (below ${hit ? nameOf(hit) : 'nothing'})`);
  }
  const panels = open ? [open] : [...document.querySelectorAll('#ui .panel')];
  for (const panel of panels.filter(shows)) {
    const box = panel.getBoundingClientRect();
    if (box.left < -0.5 || box.top < -0.5 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5)
      outside.push(`${panel.className} as a whole`);
  }
  document.scrollingElement.scrollTo(0, 0);
  if (open === undefined) outside.push(...blindSpots());
  return [...covered.map((what) => `covered: ${what}`), ...outside.map((what) => `outside: ${what}`)];
}

export const unreachable = (studio) => studio.page.evaluate(findUnreachable);

/** Presses the first of these that is visible; whether there was one. */
export const press = (studio, selector) =>
  studio.page.evaluate((wanted) => {
    const found = [...document.querySelectorAll(wanted)].find(
      (node) => node.getClientRects().length > 0 && !node.disabled,
    );
    found?.click();
    return found !== undefined;
  }, selector);

/** Those of them that are shown are hit where they are, before anything is scrolled. */
export async function inSight(locator) {
  const out = await locator.evaluateAll((nodes) =>
    nodes
      .filter((node) => node.checkVisibility())
      .filter((node) => {
        const { left, top, width, height } = node.getBoundingClientRect();
        return !node.contains(document.elementFromPoint(left + width / 2, top + height / 2));
      })
      .map((node) => node.textContent),
  );
  expect(out.length === 0, `out of sight: ${out.join(', ')}`);
}
