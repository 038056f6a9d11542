// While an order is drawn, and a moment after it was given: places that nobody can get to are marked, and counted in
// words.

import type { OrderPreview } from '../../tools/order_tools';
import { unfitWords } from '../../model/stand';
import type { OrderControllerScene } from './order_controller';
import { PlaceAsker, type PlacesLink } from './place_asker';

/** What is wrong with an order is told so long after it was given [ms]. */
const kLingers = 4000;

/** A scene that shows orders without a word about their places. */
interface DrawnScene extends Omit<OrderControllerScene, 'orders'> {
  readonly orders: Omit<OrderControllerScene['orders'], 'gaveOrder'>;
}

/** Shows orders on the scene, with what the server says of their places. */
class JudgedOrders {
  private readonly asker_: PlaceAsker;
  private shown_: OrderPreview | null = null;
  /** The order was given: it is shown only where something is wrong with it. */
  private given_ = false;
  private timer_: ReturnType<typeof setTimeout> | undefined;
  /** The newest answers, by groups. */
  private readonly unfit_ = new Map<number, Uint8Array>();

  constructor(
    private readonly scene_: DrawnScene,
    link: PlacesLink,
  ) {
    this.asker_ = new PlaceAsker(link);
  }

  previewOrder(preview: OrderPreview | null): void {
    if (!preview && this.given_) return;
    this.take(preview, false);
  }

  gaveOrder(given: OrderPreview): void {
    this.take(given, true);
    this.timer_ = setTimeout(() => this.take(null, false), kLingers);
  }

  private take(preview: OrderPreview | null, given: boolean): void {
    clearTimeout(this.timer_);
    this.shown_ = preview;
    this.given_ = given;
    this.show();
    if (!preview || preview.moves.length === 0) {
      this.asker_.drop();
      this.unfit_.clear();
      return;
    }
    const asks = preview.moves.map(({ group, places }) => ({
      group,
      formation: null,
      x: 0,
      y: 0,
      facing: 0,
      places: Float64Array.from(places.flatMap(({ x, y }) => [x, y])),
      count: 0,
    }));
    this.asker_.ask(asks, (answers) => {
      for (const { group, unfit } of answers) this.unfit_.set(group, unfit);
      this.show();
    });
  }

  private show(): void {
    const preview = this.shown_;
    if (!preview) return this.scene_.orders.previewOrder(null);
    const moves = preview.moves.map((move) => {
      const unfit = this.unfit_.get(move.group);
      return unfit?.length === move.places.length ? { ...move, unfit } : move;
    });
    const words = unfitWords(moves.flatMap((move) => ('unfit' in move ? [move.unfit] : [])));
    if (this.given_ && !words.warns) return this.scene_.orders.previewOrder(null);
    this.scene_.orders.previewOrder({ ...preview, moves, ...(words.warns ? { note: words } : {}) });
  }
}

/** The scene of a controller, on which drawn orders are judged. */
export function judged(scene: DrawnScene, link: PlacesLink): OrderControllerScene {
  const judge = new JudgedOrders(scene, link);
  const { orders } = scene;
  return {
    orders: {
      previewOrder: (preview) => judge.previewOrder(preview),
      gaveOrder: (given) => judge.gaveOrder(given),
      previewCut: (preview) => orders.previewCut(preview),
      previewForecasts: (forecasts) => orders.previewForecasts(forecasts),
      setWays: (ways, returns) => orders.setWays(ways, returns),
      setPicked: (order) => orders.setPicked(order),
    },
    previewControl: (index, points, closed) => scene.previewControl(index, points, closed),
    worldToScreen: (point) => scene.worldToScreen(point),
  };
}
