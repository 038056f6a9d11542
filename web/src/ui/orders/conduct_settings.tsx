// How new orders are given, and how the chosen groups behave.

import type { VNode } from 'preact';
import { kManners, kStances, kTurns } from '../../model/commands';
import type { OrderActions } from '../../model/order_actions';
import type { StudioState, UnitInfo } from '../../model/studio_state';
import { ChoiceRow, Dial, SwitchRow } from '../widgets/settings_rows';

const kWays = ['In formation, waiting for the last', 'Each by the shortest way (Alt)'];
const kTurnTips = [
  'Faces along its way',
  'Its rear becomes its front',
  'Faces one way until it has arrived',
  'Each to a near place: arrives first',
];
const kStanceTips = ['Both make room', 'Holds its ground', 'Makes room'];

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
        title="Cohesion"
        ends={['own pace', 'the slowest’s']}
        value={conduct.cohesion}
        act={(cohesion) => actions.setConduct({ cohesion })}
      />
      <Dial
        title="Squeeze"
        ends={['keeps its width', 'gives it up']}
        value={conduct.squeeze}
        act={(squeeze) => actions.setConduct({ squeeze })}
      />
      <SwitchRow
        title="Give way"
        tip="Its mesh keeps clear of others and of moving obstacles"
        on={conduct.avoids}
        act={(avoids) => actions.setConduct({ avoids })}
      />
    </>
  );
}
