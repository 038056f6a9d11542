import { describe, expect, it } from 'vitest';
import { plainWords } from './plain_words';
import { kInitialState, type StudioState } from './studio_state';

function words(change: Partial<StudioState>): string {
  const { people, does, barred, items, slow } = plainWords({
    ...kInitialState,
    playing: true,
    characters: 100,
    standings: [[100, 0, 0, 0, 0, 0, 0, 0, 0]],
    ...change,
  });
  return [people, does, barred, items, slow].filter((one) => one !== '').join(' · ');
}

const kConduct = { stance: 'normal', cohesion: 0, squeeze: 1, avoids: false } as const;

describe('plainWords', () => {
  it('tells who is in place and who is on the way', () => {
    expect(words({ lag: 0.1 })).toBe('100 people · all in their places');
    expect(words({ lag: 0.2, standings: [[60, 40]] })).toBe('100 people · 40 on the way');
    expect(words({ lag: 3.14, standings: [[0, 100]] })).toBe('100 people · on the way, 3.1 m to go');
    expect(words({ lag: 42.4, characters: 1, standings: [[0, 1]] })).toBe('1 person · on the way, 42 m to go');
    expect(words({ playing: false, lag: 5 })).toBe('100 people · paused');
    expect(words({ characters: 0, standings: [] })).toBe('0 people');
    expect(words({ standings: [[88, 0, 0, 0, 12]] })).toBe(
      '100 people · 88 in their places · 12 places outside the ground',
    );
    const unit = {
      id: 1,
      orders: [{ id: 1, kind: 'move' as const }],
      held: false,
      patrols: false,
      classes: [],
      conduct: kConduct,
    };
    expect(words({ lag: 0.1, standings: [[0, 100]], units: [unit] })).toBe('100 people · walking as ordered');
    const held = { lag: 0.1, standings: [[0, 0, 100]], units: [{ ...unit, held: true }] };
    expect(words(held)).toBe('100 people · waiting');
  });
  it('counts items, and says when the world is slow', () => {
    expect(words({ items: 12, collected: 3 })).toContain('3 of 12 collected');
    expect(words({ characters: 12000 })).toContain('12\u2009000 people');
    expect(words({ pace: 0.5 })).toContain('at 50 % of real time');
    expect(words({ pace: 1.5, speed: 2 })).toContain('at 1.5×');
    expect(words({ pace: 1.99, speed: 2 })).not.toContain('slowed');
    expect(words({ pace: NaN })).not.toContain('slowed');
  });
});
