import { describe, expect, it } from 'vitest';
import { CameraController } from './camera_controller';
import { ControlMarks } from './control_marks';
import { CrowdState } from './crowd_state';
import { makeTopology } from './mesh_topology';
import { pickCharacter, pickHandle, pickMesh, segmentDistance } from './picker';
import { madeControl, madeFrame, madeGroup } from './test_frames';

function camera(): CameraController {
  const made = new CameraController();
  made.resize(1280, 800);
  made.setPose({ targetX: 0, targetY: 0, distance: 40, turn: 0.2, pitch: 0.8 });
  return made;
}

describe('picking', () => {
  it('measures from a segment', () => {
    expect(segmentDistance({ x: 5, y: 3 }, { x: 0, y: 0 }, { x: 10, y: 0 })).toBe(3);
    expect(segmentDistance({ x: -3, y: 4 }, { x: 0, y: 0 }, { x: 10, y: 0 })).toBe(5);
    expect(segmentDistance({ x: 3, y: 4 }, { x: 0, y: 0 }, { x: 0, y: 0 })).toBe(5);
  });

  it('finds a character by feet, chest and head, and nobody far away', () => {
    const state = new CrowdState();
    state.setClips(['run']);
    state.setMembers([11, 12], [0, 0]);
    const frame = madeFrame(1, [-3, 3]);
    state.update({ from: frame, to: frame, alpha: 0 }, 0.02);
    const view = camera();
    for (const height of [0, 1, 1.7]) {
      expect(pickCharacter(view.worldToScreen(3, 0, height), state, view)).toBe(1);
    }
    expect(pickCharacter(view.worldToScreen(0, 0), state, view)).toBe(-1);
  });

  it('finds the nearest handle within its catch', () => {
    const marks = new ControlMarks();
    const controls = [madeControl(5, 1, [[0, 0], [6, 0]])];
    marks.update([madeGroup(1, controls)], 0);
    const view = camera();
    const at = view.worldToScreen(6, 0);
    expect(pickHandle({ x: at.x + 15, y: at.y + 15 }, marks.controls, view)).toEqual({ group: 0, control: 5, touch: 2 });
    expect(pickHandle({ x: at.x + 30, y: at.y }, marks.controls, view)).toBeNull();
  });

  it('finds a mesh inside and a little outside its rim', () => {
    const topology = makeTopology({ group: 1, version: 1, formation: '', triangles: [0, 1, 2, 0, 2, 3], boundary: [4, 0, 1, 2, 3] });
    const vertices = [-4, -4, 4, -4, 4, 4, -4, 4];
    const view = camera();
    const target = { topology, vertices };
    expect(pickMesh(view.worldToScreen(1, 1), [null, target], view)).toBe(1);
    const edge = view.worldToScreen(4, 0);
    expect(pickMesh({ x: edge.x + 15, y: edge.y }, [target], view)).toBe(0);
    expect(pickMesh({ x: edge.x + 60, y: edge.y }, [target], view)).toBe(-1);
  });
});
