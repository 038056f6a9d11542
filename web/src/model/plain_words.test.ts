import { describe, expect, it } from 'vitest';
import { plainWords } from './plain_words';
import { kInitialState, type StudioState } from './studio_state';

function words(change: Partial<StudioState>): string {
  const { people, does, items, slow } = plainWords({ ...kInitialState, playing: true, characters: 100, ...change });
  return [people, does, items, slow].filter((one) => one !== '').join(' · ');
}

const kConduct = { stance: 'normal', cohesion: 0, squeeze: 1, avoids: false } as const;

describe('plainWords', () => {
  it('tells where the crowd is on its way', () => {
    expect(words({ lag: 0.1 })).toBe('100 people · all in their places');
    expect(words({ lag: 0.8 })).toBe('100 people · nearly in their places');
    expect(words({ lag: 3.14 })).toBe('100 people · on the way, 3.1 m to go');
    expect(words({ lag: 42.4, characters: 1 })).toBe('1 person · on the way, 42 m to go');
    expect(words({ lag: NaN })).toBe('100 people · all in their places');
    expect(words({ playing: false, lag: 5 })).toBe('100 people · paused');
    expect(words({ characters: 0 })).toBe('0 people');
    const unit = {
      id: 1,
      orders: [{ id: 1, kind: 'move' as const }],
      held: false,
      patrols: false,
      classes: [],
      conduct: kConduct,
    };
    expect(words({ lag: 0.1, units: [unit] })).toBe('100 people · walking as ordered');
    expect(words({ lag: 0.1, units: [{ ...unit, held: true }] })).toBe('100 people · all in their places');
  });
  it('counts items, and says when the server cannot keep up', () => {
    expect(words({ items: 12, collected: 3 })).toContain('3 of 12 collected');
    expect(words({ stepMs: 33.3, characters: 12000 })).toContain('12\u2009000 people');
    expect(words({ stepMs: 33.3 })).toContain('at 50 % of its speed');
    expect(words({ stepMs: 10, speed: 1 })).not.toContain('%');
  });
});
