import { describe, expect, it } from 'vitest';
import { type FenceContext, GpuPace } from './gpu_pace';

function madeContext() {
  const state = { signalled: false, fences: 0 };
  const gl = {
    SYNC_GPU_COMMANDS_COMPLETE: 1, SYNC_STATUS: 2, SIGNALED: 3,
    fenceSync: () => { state.fences += 1; return {} as WebGLSync; },
    getSyncParameter: () => (state.signalled ? 3 : 4),
    deleteSync: () => { state.fences -= 1; },
    flush: () => undefined,
  };
  return { state, gl: gl as unknown as FenceContext };
}

describe('GpuPace', () => {
  it('is busy from a picture handed over until its fence is signalled', () => {
    const { state, gl } = madeContext();
    const pace = new GpuPace(gl);
    expect(pace.busy(0)).toBe(false);
    pace.sent(10);
    expect(pace.busy(20)).toBe(true);
    state.signalled = true;
    expect(pace.busy(30)).toBe(false);
    expect(state.fences).toBe(0);
  });

  it('keeps one fence, and gives up one that never comes', () => {
    const { state, gl } = madeContext();
    const pace = new GpuPace(gl);
    pace.sent(0);
    pace.sent(10);
    expect(state.fences).toBe(1);
    expect(pace.busy(200)).toBe(true);
    expect(pace.busy(300)).toBe(false);
    expect(state.fences).toBe(0);
  });
});
