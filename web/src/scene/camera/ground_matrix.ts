// A camera's axes, and its view of the ground as one matrix.

import type { CameraPose } from './camera_controls';

/** Eye and axes of a camera in world coordinates, z up. */
export interface Basis {
  readonly eye: readonly [number, number, number];
  readonly forward: readonly [number, number, number];
  readonly right: readonly [number, number, number];
  readonly up: readonly [number, number, number];
}

/** Of that pose. */
export function basisOf({ targetX, targetY, distance, turn, pitch }: CameraPose): Basis {
  const sinTurn = Math.sin(turn);
  const cosTurn = Math.cos(turn);
  const sinPitch = Math.sin(pitch);
  const cosPitch = Math.cos(pitch);
  const forward = [-sinTurn * cosPitch, cosTurn * cosPitch, -sinPitch] as const;
  return {
    eye: [targetX - forward[0] * distance, targetY - forward[1] * distance, -forward[2] * distance],
    forward,
    right: [cosTurn, sinTurn, 0],
    up: [-sinTurn * sinPitch, cosTurn * sinPitch, cosPitch],
  };
}

/** Nine numbers by rows: from (x, y, 1) on the ground [m] to homogeneous px. `lens`: px per tangent of an angle. */
export function groundMatrix(
  { eye, forward, right, up }: Basis,
  lens: number,
  width: number,
  height: number,
): readonly number[] {
  const row = (axis: readonly [number, number, number]): readonly number[] => [
    axis[0],
    axis[1],
    -(axis[0] * eye[0] + axis[1] * eye[1] + axis[2] * eye[2]),
  ];
  const [depth, across, along] = [row(forward), row(right), row(up)];
  return [
    ...depth.map((d, i) => (width / 2) * d + lens * across[i]!),
    ...depth.map((d, i) => (height / 2) * d - lens * along[i]!),
    ...depth,
  ];
}
