// Chooses the owner of a contact that gives orders, cuts or chooses groups: by the tool in hand, and the mouse's right
// button with any tool.

import type { ToolName } from '../model/studio_state';
import type { GroundPoint, ScreenPoint } from '../model/plane';
import { BoxSelect, type BoxSink } from './box_select';
import type { CameraGesture } from './camera_gesture';
import type { Contact, ContactOwner } from './contact';
import { CutTool, type CutSink } from './cut_tool';
import { GoalPick, GuardDrag, OrderDrag, RouteDrag, type OrderGesture, type OrderSink } from './order_tools';

export type OrderControllerSink = OrderSink & CutSink & BoxSink & { choose(index: number, add: boolean): void };

export interface OrderChooserTools {
  readonly orders: OrderControllerSink;
  readonly camera: CameraGesture;
  readonly tool: () => ToolName;
  readonly toGround: (at: ScreenPoint) => GroundPoint | null;
}

const kRight = 2;

export class OrderChooser {
  private readonly cut_: CutTool;
  /** The order that is being drawn. */
  private gesture_: OrderGesture | null = null;

  constructor(private readonly tools_: OrderChooserTools) {
    this.cut_ = new CutTool(tools_.orders);
  }

  /** Null where the contact is no concern of orders; `over`: index of the formation under it, or -1. */
  choose(contact: Contact, over: number): ContactOwner | null {
    if (!contact.ground) return null;
    const tool = this.tools_.tool();
    const byMouse = contact.kind === 'mouse' && contact.button === kRight;
    if (!byMouse && (tool === 'steer' || contact.button > 0)) return null;
    if (this.gesture_ && contact.kind === 'touch' && tool !== 'cut') {
      this.gesture_.giveToCamera();
      return this.tools_.camera;
    }
    if (tool === 'cut' && !byMouse) return this.cut_.owner();
    return (this.gesture_ = this.gestureFor(tool, contact.ground, byMouse ? -1 : over));
  }

  /** Chooses the groups in a box. */
  box(): ContactOwner {
    return new BoxSelect(this.tools_.orders, this.tools_.toGround);
  }

  /** Drops what is being drawn. */
  abort(): void {
    this.gesture_?.abort();
    this.cut_.abort();
  }

  private gestureFor(tool: ToolName, at: GroundPoint, over: number): OrderGesture {
    const { orders, camera } = this.tools_;
    const ended = (): void => {
      this.gesture_ = null;
    };
    if (tool === 'guard') return new GuardDrag(orders, camera, ended);
    if (tool === 'follow' || tool === 'leave' || tool === 'wait') return new GoalPick(orders, camera, ended, tool);
    if (orders.isChosenAt(at)) return new RouteDrag(orders, camera, ended);
    const tapped = over < 0 ? null : (add: boolean): void => orders.choose(over, add);
    return new OrderDrag(orders, camera, ended, tapped);
  }
}
