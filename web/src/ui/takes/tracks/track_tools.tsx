// What can be done with what is chosen on the rows of the time line, and what is told of them.

import type { VNode } from 'preact';
import { clockAt } from '../../../model/take_facts';
import type { TakeBlock } from '../../../protocol/messages';
import { Icon, ToolButton } from '../../widgets/buttons';
import { iconOf, type RowsProps } from './track_rows';

const kHint = 'Drag a block to another time. Each change is simulated again.';
const kEmpty = 'Nothing was told to anybody in this take.';

function Seconds(props: {
  label: string;
  word: string;
  value: number;
  least: number;
  set: (seconds: number) => void;
}): VNode {
  const { label, word, value, least, set } = props;
  return (
    <label class="track-seconds">
      {word}
      <input
        type="number"
        min={least}
        step={0.1}
        aria-label={label}
        value={Number(value.toFixed(2))}
        onChange={({ currentTarget }) => {
          const seconds = currentTarget.valueAsNumber;
          if (Number.isFinite(seconds) && seconds >= least) set(seconds);
          else currentTarget.value = value.toFixed(2);
        }}
      />
      s
    </label>
  );
}

function CopyFor({ state, actions, block }: RowsProps & { block: TakeBlock }): VNode | null {
  const { id, group } = block;
  const others = (state.tracks?.tracks ?? []).filter((one) => one.group !== group);
  if (others.length === 0 || group === 0) return null;
  return (
    <select
      class="track-copy-to"
      aria-label="Copy for another group, at the playhead"
      value=""
      onChange={({ currentTarget }) => {
        const to = Number(currentTarget.value);
        currentTarget.value = '';
        if (to > 0) actions.copyTo(id, to);
      }}
    >
      <option value="">Copy for…</option>
      {others.map(({ group: other, name }) => (
        <option key={other} value={other}>
          {name || `Group ${other}`}
        </option>
      ))}
    </select>
  );
}

function BlockTools({ state, actions, block }: RowsProps & { block: TakeBlock }): VNode {
  const { take, step } = state;
  const { stepTime } = take;
  const { id, begin, begun, end, label } = block;
  const put = (seconds: number): void =>
    actions.commit({ edit: 'move', id, step: Math.min(take.steps - 1, take.from + Math.round(seconds / stepTime)) });
  return (
    <>
      <strong class="track-chosen">
        <Icon name={iconOf(block)} size={16} />
        {label}
      </strong>
      {block.moves && (
        <>
          <Seconds
            label={`When ${label} begins`}
            word="at"
            value={(begin - take.from) * stepTime}
            least={-take.from * stepTime}
            set={put}
          />
          {block.stretches && end > begun && (
            <Seconds
              label={`How long ${label} takes`}
              word="takes"
              value={(end - begun) * stepTime}
              least={0.2}
              set={(seconds) => actions.commit({ edit: 'stretch', id, step: begun + Math.round(seconds / stepTime) })}
            />
          )}
          <ToolButton
            icon="later"
            label="To the playhead"
            tip={`Begins at ${clockAt(take, step)}`}
            act={() => put((step - take.from) * stepTime)}
          />
          <ToolButton
            icon="copy"
            label="Copy"
            shortcut="Ctrl+C"
            tip="A copy begins at the playhead"
            act={() => actions.copyTo(id, 0)}
          />
          <CopyFor state={state} actions={actions} block={block} />
        </>
      )}
      <ToolButton icon="close" label="Remove" shortcut="Del" act={() => actions.remove()} />
    </>
  );
}

function KeyTools({ state, actions, at }: RowsProps & { at: number }): VNode {
  const { keys, take } = state;
  const index = keys.findIndex(({ step }) => step === at);
  const cut = keys[index]?.cut ?? false;
  const move = (seconds: number): void =>
    actions.commit({
      edit: 'key',
      id: at,
      step: Math.min(take.steps, take.from + Math.round(seconds / take.stepTime)),
    });
  return (
    <>
      <strong class="track-chosen">View {index + 1}</strong>
      <Seconds
        label={`When view ${index + 1} is shown`}
        word="at"
        value={(at - take.from) * take.stepTime}
        least={-take.from * take.stepTime}
        set={move}
      />
      <ToolButton
        icon="cut"
        label="Cut"
        pressed={cut}
        tip="The camera is here at once, instead of travelling from the view before"
        act={() => actions.cut(at, !cut)}
      />
      <ToolButton icon="show" label="Show" tip="Takes the playhead there" act={() => actions.seek(at)} />
      <ToolButton icon="camera" label="Take this view" act={() => actions.takeView(at)} />
      <ToolButton icon="close" label="Remove" shortcut="Del" act={() => actions.remove()} />
    </>
  );
}

/** What can be done with the chosen block or view; null where nothing is chosen. */
function chosenTools({ state, actions }: RowsProps): VNode | null {
  const { chosen, tracks, keys } = state;
  if (!chosen) return null;
  if ('key' in chosen)
    return keys.some(({ step }) => step === chosen.key) ? (
      <KeyTools state={state} actions={actions} at={chosen.key} />
    ) : null;
  const block = tracks?.blocks.find(({ id }) => id === chosen.block);
  return block ? <BlockTools state={state} actions={actions} block={block} /> : null;
}

export function TrackTools({ state, actions }: RowsProps): VNode {
  const { tracks, waits, words } = state;
  const { undo = '', redo = '' } = tracks ?? {};
  const said = words || (tracks?.blocks.length === 0 ? kEmpty : kHint);
  const tools = words ? null : chosenTools({ state, actions });
  return (
    <div class="tracks-bar">
      <ToolButton
        icon="undo"
        label={undo ? `Undo: ${undo}` : 'Undo'}
        iconOnly
        class="tracks-undo"
        shortcut="Ctrl+Z"
        idle={!undo}
        act={() => actions.undo(false)}
      />
      <ToolButton
        icon="redo"
        label={redo ? `Redo: ${redo}` : 'Redo'}
        iconOnly
        class="tracks-redo"
        shortcut="Ctrl+Shift+Z"
        idle={!redo}
        act={() => actions.undo(true)}
      />
      <div class="tracks-chosen" role="group" aria-label="What is chosen" inert={waits}>
        {tools}
        <p class="tracks-words" role="status" hidden={tools !== null}>
          {said}
        </p>
      </div>
      <ToolButton
        label="Less time, nearer"
        word="+"
        iconOnly={false}
        class="tracks-zoom"
        act={() => actions.zoom(1.6)}
      />
      <ToolButton label="More time, farther" word="−" class="tracks-zoom" act={() => actions.zoom(1 / 1.6)} />
    </div>
  );
}
