// Made by schema/generate.mjs from schema/parameters.txt: change these, not this file.
// Names of parameters, and the values of those that choose.

/** How often places are assigned to characters. */
export const kPlanMode = { transport: 0, assignedOnce: 1, fixed: 2 } as const;

/** Which method makes plans. */
export const kPlanSolver = { exact: 0, fast: 1 } as const;

/** What a plan minimises. */
export const kPlanObjective = { power: 0, longestWalk: 1 } as const;

/** A parameter of the world. */
export type ParameterName =
  | 'time.step'
  | 'input.window'
  | 'input.reach'
  | 'input.checkpointSpacing'
  | 'control.speed'
  | 'control.clockRate'
  | 'control.softWeight'
  | 'opposing.enabled'
  | 'opposing.gain'
  | 'mesh.relaxTime'
  | 'field.enabled'
  | 'field.range'
  | 'field.strength'
  | 'field.gain'
  | 'field.speed'
  | 'mesh.morphSpeed'
  | 'place.speed'
  | 'place.clearance'
  | 'cost.alpha'
  | 'cost.beta'
  | 'cost.gamma'
  | 'cost.minSpeed'
  | 'density.enabled'
  | 'density.cell'
  | 'density.lambda'
  | 'density.min'
  | 'density.max'
  | 'density.lookAhead'
  | 'discomfort.enabled'
  | 'discomfort.time'
  | 'discomfort.range'
  | 'discomfort.gain'
  | 'plan.mode'
  | 'plan.solver'
  | 'plan.objective'
  | 'plan.period'
  | 'plan.exponent'
  | 'plan.threshold'
  | 'plan.thresholdShare'
  | 'plan.geodesic'
  | 'plan.waits'
  | 'character.radius'
  | 'character.maxSpeed'
  | 'character.acceleration'
  | 'character.velocityGain'
  | 'character.positionGain'
  | 'character.directReach'
  | 'character.headway'
  | 'character.inStep'
  | 'character.foresight'
  | 'contact.iterations';
