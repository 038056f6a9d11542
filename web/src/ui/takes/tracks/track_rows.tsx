// The rows of the time line: the ruler, the groups with their blocks, and the camera with its keys and shots.

import type { ComponentChildren, VNode } from 'preact';
import { clockAt, type OpenTake } from '../../../model/take_facts';
import { edited, linesOf, rowsOf, ticksOf, xOf, type TrackRow } from '../../../model/take_tracks';
import { TakeBlockKind, type TakeBlock } from '../../../protocol/messages';
import { shotsOf } from '../../../scene/camera/film_camera';
import { Icon, ToolButton } from '../../widgets/buttons';
import { GroupMark } from '../../widgets/group_icons';
import { accentVariable } from '../../widgets/group_marks';
import type { IconName } from '../../widgets/icons';
import type { TrackActions, TracksState } from './track_actions';

/** A block is at least so broad, for a finger, and its line so high [CSS px]. */
const kLeastWidth = 44;
const kLine = 44;

export interface RowsProps {
  readonly state: TracksState;
  readonly actions: TrackActions;
}

const kIcons: readonly (readonly [RegExp, IconName])[] = [
  [/^Form|formation$/, 'mesh'],
  [/^Follow/, 'follow'],
  [/^Guard/, 'guard'],
  [/^Leave/, 'leave'],
  [/^Wait/, 'wait'],
  [/^(Stop|Cancel)/, 'stop'],
  [/^Hold/, 'hold'],
  [/^(Split|Merge)/, 'cut'],
  [/people|group/i, 'directors'],
  [/place|Remove/, 'build'],
  [/path$/, 'paths'],
];

export function iconOf({ kind, label }: Pick<TakeBlock, 'kind' | 'label'>): IconName {
  if (kind === TakeBlockKind.Gesture) return 'steer';
  const found = kIcons.find(([words]) => words.test(label));
  return found?.[1] ?? (kind === TakeBlockKind.Order ? 'order' : 'dials');
}

/** `Move to Fountain, 0:00.5 to 0:08.0`. */
function spoken(block: TakeBlock, begin: number, end: number, take: OpenTake): string {
  const from = clockAt(take, begin);
  return end > begin ? `${block.label}, ${from} to ${clockAt(take, end)}` : `${block.label}, ${from}`;
}

function Block({ state, actions, block, line }: RowsProps & { block: TakeBlock; line: number }): VNode {
  const { shown, width, take, drag, chosen } = state;
  const change = drag && drag.edit !== 'key' && drag.id === block.id ? drag : null;
  const copies = change?.edit === 'copy';
  const { begin, end } = copies ? block : edited(block, change);
  const left = xOf(shown, width, begin);
  const breadth = Math.max(kLeastWidth, xOf(shown, width, end) - left);
  const waits = Math.min(breadth, xOf(shown, width, block.begun + begin - block.begin) - left);
  const isChosen = chosen !== null && 'block' in chosen && chosen.block === block.id;
  return (
    <>
      <button
        type="button"
        class="track-block"
        data-block={block.id}
        data-fixed={!block.moves || undefined}
        data-moved={(change !== null && !copies) || undefined}
        aria-label={spoken(block, begin, end, take)}
        aria-pressed={isChosen}
        onClick={() => actions.choose({ block: block.id })}
        style={{ left: `${left}px`, width: `${breadth}px`, top: `${2 + line * kLine}px`, '--wait': `${waits}px` }}
      >
        {/* What begins before the part that is shown is named where it can be seen. */}
        <span class="track-words" style={{ marginLeft: `${Math.max(0, Math.min(-left, breadth - kLeastWidth))}px` }}>
          <Icon name={iconOf(block)} size={16} />
          {breadth > 64 && <span class="track-label">{block.label}</span>}
        </span>
        {block.stretches && block.moves && <span class="track-grip" />}
      </button>
      {copies && (
        <span
          class="track-block track-ghost"
          style={{
            left: `${xOf(shown, width, change.step)}px`,
            width: `${breadth}px`,
            top: `${2 + line * kLine}px`,
          }}
        />
      )}
    </>
  );
}

function Lane(props: { name: string; class?: string; height?: number; children: ComponentChildren }): VNode {
  return (
    <div
      class={`track-lane ${props.class ?? ''}`}
      role="group"
      aria-label={props.name}
      style={props.height ? { height: `${props.height}px` } : undefined}
    >
      {props.children}
    </div>
  );
}

function Row({ row, state, actions }: RowsProps & { row: TrackRow }): VNode {
  const { shown, width } = state;
  const { track, blocks } = row;
  const name = track.name || `Group ${track.group}`;
  const lines = linesOf(blocks, ((shown.to - shown.from) * kLeastWidth) / Math.max(1, width));
  const colour = state.colours.get(track.group) ?? track.group - 1;
  const x = (step: number): number => Math.min(width, Math.max(0, xOf(shown, width, step)));
  return (
    <div
      class="track-row"
      style={{ '--track': track.group > 0 ? accentVariable(colour) : 'var(--ink-2)' }}
      data-group={track.group}
    >
      <div class="track-name" title={name}>
        {track.group > 0 ? <GroupMark colour={colour} /> : <Icon name="build" size={16} />}
        <span>{name}</span>
      </div>
      <Lane name={name} height={4 + kLine * Math.max(1, ...lines.map((line) => line + 1))}>
        {x(track.from) > 0 && <span class="track-absent" style={{ left: 0, width: `${x(track.from)}px` }} />}
        {x(track.to) < width && <span class="track-absent" style={{ left: `${x(track.to)}px`, right: 0 }} />}
        {blocks.map((block, k) => (
          <Block key={block.id} state={state} actions={actions} block={block} line={lines[k]!} />
        ))}
      </Lane>
    </div>
  );
}

function Ruler({ state }: { state: TracksState }): VNode {
  const { shown, width, take } = state;
  const { steps, every } = ticksOf(shown, width, take);
  return (
    <div class="track-row track-times">
      <div class="track-name" />
      <Lane name="Times" class="track-ruler">
        {steps.map((step) => (
          <span key={step} class="track-tick" style={{ left: `${xOf(shown, width, step)}px` }}>
            {every < 1 ? clockAt(take, step) : clockAt(take, step).replace(/\.0$/, '')}
          </span>
        ))}
      </Lane>
    </div>
  );
}

function CameraRow({ state, actions }: RowsProps): VNode {
  const { shown, width, take, keys, drag, chosen, films } = state;
  const stepOf = (step: number): number => (drag?.edit === 'key' && drag.id === step ? drag.step : step);
  const shots = shotsOf(
    keys.map((key) => ({ ...key, step: stepOf(key.step) })),
    take.from,
    take.to,
  );
  return (
    <div class="track-row track-camera" data-off={!films || undefined}>
      <div class="track-name" title="Camera">
        <Icon name="camera" size={16} />
        <span>Camera</span>
        <ToolButton icon="plus" iconSize={16} label="Keep this view here" iconOnly act={() => actions.keepView()} />
      </div>
      <Lane name="Camera">
        {shots.map(({ from, to }, k) => (
          <span
            key={`shot-${k}`}
            class="track-shot"
            style={{
              left: `${xOf(shown, width, from)}px`,
              width: `${xOf(shown, width, to) - xOf(shown, width, from)}px`,
            }}
          >
            <span class="track-label">{`Shot ${k + 1}`}</span>
          </span>
        ))}
        {keys.map(({ step, cut = false }, k) => (
          <button
            key={k}
            type="button"
            class="track-key"
            data-key={step}
            data-cut={cut || undefined}
            aria-label={`${cut ? 'Cut to view' : 'View'} ${k + 1}, ${clockAt(take, stepOf(step))}`}
            aria-pressed={chosen !== null && 'key' in chosen && chosen.key === step}
            onClick={() => actions.choose({ key: step })}
            style={{ left: `${xOf(shown, width, stepOf(step))}px` }}
          />
        ))}
      </Lane>
    </div>
  );
}

export function TrackRows({ state, actions }: RowsProps): VNode {
  const { tracks, take } = state;
  return (
    <>
      <Ruler state={state} />
      {tracks &&
        rowsOf(tracks, take.steps).map((row) => (
          <Row key={row.track.group} row={row} state={state} actions={actions} />
        ))}
      <CameraRow state={state} actions={actions} />
    </>
  );
}
