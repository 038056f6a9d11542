// A QR code made of people, which a phone reads from above.

import { Component, type VNode } from 'preact';
import { kQuietZone, qrPlaces, type QrAnswer } from '../../model/letters/qr_places';
import type { OwnShape } from '../../model/shape_edit';
import { Dialog, Field } from '../widgets/dialog';
import { PlaceDots } from '../widgets/place_dots';
import { activeGroup, Ends, inMetres, leave, MorePeople, type ShapeDialogProps } from './dialog_ends';

/** Bodies stand so many of their radii apart, but never nearer than this [m]. */
const kRadii = 2.1;
const kLeastGap = 0.5;
/**
 * From so many times its width bodies melt together for a lens, as measured with pictures of a crowd: the code then fills a
 * quarter of what a common lens sees.
 */
const kFar = 4;

let lastAddress = 'https://';
let fromAbove = true;

export class QrDialog extends Component<ShapeDialogProps> {
  private input_: HTMLInputElement | null = null;
  private made_: { readonly key: string; readonly answer: QrAnswer | null } = { key: '', answer: null };
  private shown_: QrAnswer | null = null;

  override componentDidMount(): void {
    this.input_?.focus();
    this.componentDidUpdate();
  }

  override componentDidUpdate(): void {
    const { answer } = this.made_;
    if (this.shown_ === answer) return;
    this.shown_ = answer;
    this.props.shapes.lookAt(this.shape());
  }

  private gap(): number {
    return Math.max(kLeastGap, kRadii * this.props.state.bodyRadius);
  }

  private places() {
    const { answer } = this.made_;
    return answer && 'code' in answer ? inMetres(answer.code.places, 1, this.gap()) : [];
  }

  private shape(): OwnShape | null {
    const places = this.places();
    return places.length > 0 ? this.props.shapes.asSeen(places, this.gap()) : null;
  }

  private answer(address: string, count: number): QrAnswer | null {
    const key = `${count} ${address}`;
    const empty = address === '' || address === 'https://';
    if (this.made_.key !== key) this.made_ = { key, answer: empty ? null : qrPlaces(address, count) };
    return this.made_.answer;
  }

  private said(answer: QrAnswer | null, count: number): string {
    if (!answer) return `${count} people. The address that a phone shall open:`;
    if ('why' in answer) return answer.why;
    if ('needs' in answer) return `Cannot be read: ${count} people; ${answer.needs} needed.`;
    const { modules, side, spare } = answer.code;
    const metres = (modules + 2 * kQuietZone) * side * this.gap();
    const rest = spare > 0 ? ` ${spare} stand below it.` : '';
    const how = `Read from straight above and far away, about ${Math.round((kFar * metres) / 10) * 10} m up: it fills a quarter of the picture there.`;
    return `${Math.round(metres)} m wide with the free ground round it.${rest} ${how}`;
  }

  private look(): void {
    const { state, actions } = this.props;
    if (!fromAbove) return;
    if (!state.topView) actions.toggleTop();
    actions.frameGroup(state.active);
  }

  override render(props: ShapeDialogProps): VNode {
    const { state, shapes } = props;
    const group = activeGroup(state);
    const [address, count] = [lastAddress.trim(), group?.count ?? 0];
    const answer = this.answer(address, count);
    const submit = (): boolean => {
      const shape = this.shape();
      if (shape) shapes.takeShape(shape, 'QR code');
      if (shape) this.look();
      return shape !== null;
    };
    const bad = answer !== null && !('code' in answer);
    return (
      <Dialog title="QR code of people" close={() => leave(this.props)} submit={submit}>
        <Field label="Address">
          <input
            type="text"
            inputMode="url"
            autocomplete="off"
            spellcheck={false}
            value={lastAddress}
            ref={(made) => void (this.input_ = made)}
            onInput={({ currentTarget }) => {
              lastAddress = currentTarget.value;
              this.forceUpdate();
            }}
          />
        </Field>
        <PlaceDots
          class="shape-preview shape-preview-code"
          places={this.places()}
          radius={state.bodyRadius}
          width={240}
          height={240}
        />
        <p class={`secondary shape-note${bad ? ' warns' : ''}`} role="status">
          {this.said(answer, count)}
        </p>
        <MorePeople
          title="This code"
          needs={answer && 'needs' in answer ? answer.needs : 0}
          group={group}
          shapes={shapes}
        />
        <label class="shape-check">
          <input
            type="checkbox"
            checked={fromAbove}
            onChange={({ currentTarget }) => void (fromAbove = currentTarget.checked)}
          />
          Look from above
        </label>
        <Ends {...props} title="QR code" dialog="qr" shape={this.shape()} />
      </Dialog>
    );
  }
}
