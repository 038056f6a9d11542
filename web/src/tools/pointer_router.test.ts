// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import type { Contact } from './contact';
import { PointerRouter } from './pointer_router';

let surface: HTMLElement;
let log: string[];
let router: PointerRouter;
let zoom: number;

/** jsdom has no PointerEvent: a mouse event with the fields that the router reads. */
function fire(type: string, fields: Record<string, unknown> = {}): void {
  const event = new MouseEvent(type, {
    bubbles: true,
    cancelable: true,
    clientX: Number(fields['x'] ?? 0),
    clientY: Number(fields['y'] ?? 0),
  });
  const all = { pointerId: 1, pointerType: 'touch', ...fields };
  for (const [name, value] of Object.entries(all)) {
    if (name !== 'x' && name !== 'y') Object.defineProperty(event, name, { value });
  }
  surface.dispatchEvent(event);
}

beforeEach(() => {
  log = [];
  zoom = 0;
  surface = document.createElement('div');
  document.body.replaceChildren(surface);
  const owner = (name: string) => ({
    begin: (c: Contact) => log.push(`${name} begin ${c.pointer}`),
    move: (cs: readonly Contact[]) => log.push(`${name} move ${cs.map((c) => c.screen.x).join(' ')}`),
    end: (_c: Contact, cancelled: boolean) => log.push(`${name} ${cancelled ? 'cancel' : 'end'}`),
  });
  router = new PointerRouter(surface, ({ x, y }) => ({ x, y }), {
    choose: (c) => owner(c.screen.x < 100 ? 'edit' : 'camera'),
    tapped: () => log.push('tap'),
    doubleClicked: () => log.push('double'),
    wheel: (_at, factor) => (zoom = factor),
    pointed: () => undefined,
  });
});

describe('PointerRouter', () => {
  it('ignores a palm, and lets go where a finger becomes one', () => {
    fire('pointerdown', { x: 50, width: 90, height: 70 });
    fire('pointermove', { x: 60, width: 90, height: 70 });
    fire('pointerup', { x: 60, width: 90, height: 70 });
    expect(log).toEqual([]);
    fire('pointerdown', { x: 50, width: 30, height: 34 });
    fire('pointermove', { x: 54, width: 70, height: 60 });
    fire('pointermove', { x: 56, width: 120, height: 90 });
    fire('pointermove', { x: 58, width: 120, height: 90 });
    expect(log).toEqual(['edit begin 1', 'edit move 54', 'edit cancel']);
    expect(router.count).toBe(0);
  });
  it('decides the owner at the start and keeps it wherever the contact goes', () => {
    fire('pointerdown', { x: 50 });
    fire('pointermove', { x: 300 });
    fire('pointerup', { x: 300 });
    expect(log).toEqual(['edit begin 1', 'edit move 300', 'edit end']);
  });
  it('hands on every coalesced event', () => {
    fire('pointerdown', { x: 50 });
    const coalesced = [60, 70, 80].map((x) => ({
      clientX: x,
      clientY: 0,
      pointerId: 1,
      pointerType: 'touch',
      timeStamp: 0,
    }));
    fire('pointermove', { x: 80, getCoalescedEvents: () => coalesced });
    expect(log[1]).toBe('edit move 60 70 80');
  });
  it('follows raw updates, and hears nothing twice', () => {
    fire('pointerdown', { x: 50 });
    fire('pointerrawupdate', { x: 60 });
    fire('pointerrawupdate', { x: 70 });
    fire('pointermove', { x: 70 });
    fire('pointerup', { x: 70 });
    expect(log).toEqual(['edit begin 1', 'edit move 60', 'edit move 70', 'edit end']);
    fire('pointerrawupdate', { x: 90 });
    expect(log).toHaveLength(4);
  });
  it('keeps contacts apart, a pen among fingers, and takes ten at most', () => {
    for (let pointerId = 1; pointerId <= 12; ++pointerId) {
      fire('pointerdown', { x: pointerId === 2 ? 200 : 50, pointerId, pointerType: pointerId === 3 ? 'pen' : 'touch' });
    }
    expect(router.count).toBe(10);
    expect(log.filter((line) => line.startsWith('edit'))).toHaveLength(9);
  });
  it('ends a cancelled contact once, also where capture is lost afterwards', () => {
    fire('pointerdown', { x: 50 });
    fire('pointercancel', { x: 50 });
    fire('lostpointercapture', { x: 50 });
    expect(log).toEqual(['edit begin 1', 'edit cancel']);
    expect(router.count).toBe(0);
  });
  it('knows a tap', () => {
    fire('pointerdown', { x: 50 });
    fire('pointermove', { x: 53 });
    fire('pointerup', { x: 53 });
    expect(log[log.length - 1]).toBe('tap');
  });
  it('zooms in when the wheel turns away, and stops the page from scrolling', () => {
    const event = new WheelEvent('wheel', { deltaY: -100, bubbles: true, cancelable: true });
    surface.dispatchEvent(event);
    expect(zoom).toBeGreaterThan(1);
    expect(event.defaultPrevented).toBe(true);
  });
});
