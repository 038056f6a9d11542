import { describe, expect, it } from 'vitest';
import { type FenceContext, GpuPace } from './gpu_pace';

function madeContext() {
  const state = { signalled: false, fences: 0 };
  const gl = {
    SYNC_GPU_COMMANDS_COMPLETE: 1,
    SYNC_STATUS: 2,
    SIGNALED: 3,
    fenceSync: () => {
      state.fences += 1;
      return {} as WebGLSync;
    },
    getSyncParameter: () => (state.signalled ? 3 : 4),
    deleteSync: () => {
      state.fences -= 1;
    },
    flush: () => undefined,
  };
  return { state, gl: gl as unknown as FenceContext };
}

describe('GpuPace', () => {
  it('is busy from a picture handed over until its fence is signalled', () => {
    const { state, gl } = madeContext();
    const pace = new GpuPace(gl);
    expect(pace.busy(0, false)).toBe(false);
    pace.sent(10);
    expect(pace.busy(20, true)).toBe(true);
    state.signalled = true;
    expect(pace.busy(30, true)).toBe(false);
    expect(state.fences).toBe(0);
  });

  it('keeps one fence, and gives up one that never comes', () => {
    const { state, gl } = madeContext();
    const pace = new GpuPace(gl);
    pace.sent(0);
    pace.sent(10);
    expect(state.fences).toBe(1);
    expect(pace.busy(200, true)).toBe(true);
    expect(pace.busy(300, true)).toBe(false);
    expect(state.fences).toBe(0);
  });

  it('rests as long as the picture took, unless something is urgent', () => {
    const { state, gl } = madeContext();
    const pace = new GpuPace(gl);
    pace.sent(100);
    state.signalled = true;
    expect(pace.busy(120, false)).toBe(true);
    expect(pace.busy(125, true)).toBe(false);
    expect(pace.busy(139, false)).toBe(true);
    expect(pace.busy(140, false)).toBe(false);
    pace.sent(200);
    pace.busy(400, false);
    expect(pace.busy(441, false)).toBe(false);
  });
});
