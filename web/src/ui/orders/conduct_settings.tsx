// How new orders are given, and how the chosen groups behave.

import type { VNode } from 'preact';
import { kManners, kStances, kTurns } from '../../model/commands';
import type { OrderActions } from '../../model/order_actions';
import type { StudioState, UnitInfo } from '../../model/studio_state';
import { ChoiceRow, Dial, SwitchRow } from '../widgets/settings_rows';

const kWays = ['In formation, waiting for the last', 'Each by the shortest way (Alt)'];
const kTurnTips = [
  'Turns as a whole, its front ahead',
  'Turns on the spot: its rear becomes its front',
  'Keeps its front where it is, and walks sideways or backwards',
  'Everybody takes a near spot in the new place: arrives first',
];
const kStanceTips = ['Both groups make room', 'Goes straight on, others make room', 'Makes room for others'];

export interface ConductSettingsProps {
  readonly style: StudioState['style'];
  readonly conduct: UnitInfo['conduct'];
  readonly actions: OrderActions;
}

export function ConductSettings({ style, conduct, actions }: ConductSettingsProps): VNode {
  return (
    <>
      <h2>Orders</h2>
      <ChoiceRow
        title="Way"
        words={kManners}
        tips={kWays}
        value={style.manner}
        act={(manner) => actions.setStyle({ manner })}
      />
      <ChoiceRow
        title="Turns"
        words={kTurns}
        tips={kTurnTips}
        value={style.turn}
        act={(turn) => actions.setStyle({ turn })}
      />
      <SwitchRow
        title="Add to the queue"
        tip="New orders come last, as with Shift"
        on={style.mode === 'append'}
        act={(on) => actions.setStyle({ mode: on ? 'append' : 'replace' })}
      />
      <h2>Conduct</h2>
      <ChoiceRow
        title="Meets others"
        words={kStances}
        tips={kStanceTips}
        value={conduct.stance}
        act={(stance) => actions.setConduct({ stance })}
      />
      <Dial
        title="Stay together"
        tip="How far everybody keeps the pace of the slowest"
        ends={['own pace', 'the slowest’s']}
        value={conduct.cohesion}
        act={(cohesion) => actions.setConduct({ cohesion })}
      />
      <Dial
        title="Narrow"
        tip="How far the formation gives up its width at a gap"
        ends={['keeps its width', 'gives it up']}
        value={conduct.squeeze}
        act={(squeeze) => actions.setConduct({ squeeze })}
      />
      <SwitchRow
        title="Give way"
        tip="Bends away from other groups and from moving obstacles"
        on={conduct.avoids}
        act={(avoids) => actions.setConduct({ avoids })}
      />
    </>
  );
}
