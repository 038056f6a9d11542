import { expect, it } from 'vitest';
import { EventKind, type EventFrame } from '../protocol/messages';
import { UnitNews } from './unit_news';

function event(kind: EventKind, subject: number, value: number): EventFrame {
  return { kind, subject, value, x: 0, y: 0 };
}

it('tells the groups that splits of ours have made, and no others', () => {
  const news = new UnitNews();
  news.splitAsked(3);
  const added = [event(EventKind.GroupAdded, 8, 3), event(EventKind.GroupAdded, 9, 7)];
  expect(news.observe(added)).toEqual([8]);
  expect(news.observe([event(EventKind.GroupAdded, 10, 3)])).toEqual([]);
});

it('forgets a split that the server refused', () => {
  const news = new UnitNews();
  news.splitAsked(5);
  news.refused();
  expect(news.observe([event(EventKind.GroupAdded, 8, 5)])).toEqual([]);
});

it('tells under which id a copied order goes on', () => {
  const copied: number[][] = [];
  const news = new UnitNews((was, now) => copied.push([was, now]));
  news.copiesAsked(4, [7, 8]);
  const given = [20, 21, 22].map((id) => event(EventKind.OrderGiven, id === 20 ? 5 : 4, id));
  news.observe(given);
  expect(copied).toEqual([
    [7, 21],
    [8, 22],
  ]);
});
