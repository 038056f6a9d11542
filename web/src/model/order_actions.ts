// What buttons, keys and tools do with orders and units.

import type { ConductFacts, OrderStyle } from './commands';
import type { ToolName } from './studio_state';

export interface OrderActions {
  setTool(tool: ToolName): void;
  /** Back to steering, where this tool is in hand; else takes it in hand. */
  toggleTool(tool: ToolName): void;
  setStyle(style: Partial<OrderStyle>): void;
  /** Makes a group the active one; `add`: together with those that are chosen. */
  choose(index: number, add: boolean): void;
  chooseAll(): void;
  /** Opens the line for words, or closes it. */
  toggleWords(): void;
  stop(): void;
  toggleHold(): void;
  togglePatrol(): void;
  /** Chooses an order in the active group's queue, or lets go of it. */
  pickOrder(order: number): void;
  /** The next order comes before this one; again: it does not. */
  insertBefore(order: number): void;
  /** Puts an order at an index of the active group's queue. */
  moveOrder(order: number, index: number): void;
  /** Goes on to the next order. */
  skipOrder(): void;
  /** Takes an order out of the active group's queue. */
  cancelOrder(order: number): void;
  setConduct(conduct: Partial<ConductFacts>): void;
  /** Joins a group to another one, by their ids. */
  merge(into: number, dragged: number): void;
  /** Takes back what was done last, or does it again. */
  undo(redo?: boolean): void;
}
