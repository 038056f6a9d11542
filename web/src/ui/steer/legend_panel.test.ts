import { describe, expect, it } from 'vitest';
import { OverlayKind } from '../../protocol/messages';
import { legendText, rampEnds } from './legend_panel';
import { kInitialState } from '../../model/studio_state';

describe('rampEnds', () => {
  it('numbers every fifth contour and marks what lies beyond', () => {
    expect(rampEnds({ max: 15, step: 1, beyond: true })).toEqual(['0', '5', '10', '15+']);
    expect(rampEnds({ max: 0.5, step: 0.1, beyond: false })).toEqual(['0', '0.5']);
  });
});

describe('legendText', () => {
  it('is silent without an overlay and asks for a character where none is chosen', () => {
    expect(legendText(kInitialState)).toBeNull();
    expect(legendText({ ...kInitialState, overlay: OverlayKind.Cost })?.about).toContain('Tap a person');
    const ramp = { max: 15, step: 1, beyond: true };
    const shown = legendText({ ...kInitialState, overlay: OverlayKind.Cost, chosen: 30, ramp });
    expect(shown?.about).toBe('Person 30: far, slow and crowded ground is hard. A line every 1.');
  });
});
