// Slow and fast parts of the open take.

import type { VNode } from 'preact';
import { formatSpeed } from '../../model/formatters';
import { withPiece, type OpenTake } from '../../model/take_facts';
import type { SpeedPiece } from '../../protocol/messages';
import { Button, ToolButton } from '../widgets/buttons';
import { Menu } from '../widgets/menu';

/** Speeds that a part can have. */
const kSpeeds: readonly number[] = [0.125, 0.25, 0.5, 2, 4, 8];
const kEases = 'Speeds come and go within the easing time; films and exports have them.';
const kBegin = 'Makes two seconds from the shown moment slow or fast.';

type Change = (change: Partial<SpeedPiece>) => void;

interface SecondsProps {
  readonly label: string;
  readonly part: number;
  readonly value: number;
  readonly set: (value: number) => void;
}

function Seconds({ label, part, value, set }: SecondsProps): VNode {
  const shown = Number(value.toFixed(2));
  return (
    <label>
      {label}
      <input
        key={shown}
        type="number"
        min={0}
        step={0.1}
        defaultValue={String(shown)}
        aria-label={`${label} of part ${part} in seconds`}
        onChange={({ currentTarget: { valueAsNumber: wished } }) => Number.isFinite(wished) && set(wished)}
      />
    </label>
  );
}

interface PieceProps {
  readonly piece: SpeedPiece;
  readonly part: number;
  readonly change: Change;
  readonly remove: () => void;
}

function Piece({ piece, part, change, remove }: PieceProps): VNode {
  const speeds = [...new Set([...kSpeeds, piece.speed])].sort((a, b) => a - b);
  return (
    <div class="speed-piece">
      <Seconds label="from" part={part} value={piece.from} set={(from) => change({ from })} />
      <Seconds label="to" part={part} value={piece.to} set={(to) => change({ to })} />
      <select
        aria-label={`Speed of part ${part}`}
        value={piece.speed}
        onChange={({ currentTarget }) => change({ speed: Number(currentTarget.value) })}
      >
        {speeds.map((speed) => (
          <option key={speed} value={speed}>
            {formatSpeed(speed)}
          </option>
        ))}
      </select>
      <Seconds label="ease" part={part} value={piece.ease} set={(ease) => change({ ease })} />
      <ToolButton icon="close" label={`Remove part ${part}`} iconOnly act={remove} />
    </div>
  );
}

export interface SpeedMenuProps {
  readonly take: OpenTake;
  /** The shown moment. */
  readonly step: number;
  readonly setSpeeds: (speeds: readonly SpeedPiece[]) => void;
}

export function SpeedMenu({ take, step, setSpeeds }: SpeedMenuProps): VNode {
  const { speeds } = take;
  const opener = { icon: 'dials', label: 'Speed', class: 'time-speed', tip: 'Slow and fast parts' } as const;
  const changed = (index: number, next: Partial<SpeedPiece>): void =>
    setSpeeds(speeds.map((one, i) => (i === index ? { ...one, ...next } : one)));
  return (
    <span class="time-speed-holder">
      <Menu opener={opener} class="speed-pieces" label="Slow and fast" placement="top-end">
        {() => (
          <>
            <div class="speed-add">
              {[0.5, 2].map((speed) => {
                const pieces = withPiece(take, step * take.stepTime, speed);
                return (
                  <Button key={speed} disabled={pieces === null} act={() => pieces && setSpeeds(pieces)}>
                    {formatSpeed(speed)} from here
                  </Button>
                );
              })}
            </div>
            {speeds.map((piece, i) => (
              <Piece
                key={i}
                piece={piece}
                part={i + 1}
                change={(next) => changed(i, next)}
                remove={() => setSpeeds(speeds.filter((_, k) => k !== i))}
              />
            ))}
            <p class="secondary">{speeds.length > 0 ? kEases : kBegin}</p>
          </>
        )}
      </Menu>
    </span>
  );
}
