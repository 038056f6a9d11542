// muster-player.js: the web component <muster-player>, which plays takes that Muster exported.

import { defineMusterPlayer } from './muster_player';

defineMusterPlayer();
