// What a new group is, before it is put on the ground.

import { Component, type VNode } from 'preact';
import { formationKind } from '../../model/sequence';
import { Button } from '../widgets/buttons';
import { Dialog, Field } from '../widgets/dialog';
import { leave, type ShapeDialogProps } from './dialog_ends';
import { kFormations } from './formation_panel';

const kNumbers = [
  { name: 'count', label: 'People', min: 1, max: 5000, step: 1, value: 36 },
  { name: 'spacing', label: 'Spacing [m]', min: 0.5, max: 10, step: 0.1, value: 1 },
  { name: 'radius', label: 'Radius of a body [m]', min: 0.05, max: 1.5, step: 0.01 },
  { name: 'speed', label: 'Top speed [m/s]', min: 0.1, max: 12, step: 0.1 },
] as const;

export class GroupDialog extends Component<ShapeDialogProps> {
  private form_: HTMLElement | null = null;

  override componentDidMount(): void {
    this.form_?.querySelector('input')?.select();
  }

  /** It is drawn once: what is typed stays. */
  override shouldComponentUpdate(): boolean {
    return false;
  }

  private submit(): boolean {
    const fields = [...this.form_!.querySelectorAll<HTMLInputElement | HTMLSelectElement>('input, select')];
    const text = (name: string): string => fields.find((field) => field.name === name)?.value.trim() ?? '';
    const number = (name: string): number => Number(text(name)) || 0;
    this.props.shapes.holdGroup({
      name: text('name'),
      count: number('count'),
      formation: formationKind(text('formation')),
      spacing: number('spacing'),
      radius: number('radius'),
      speed: number('speed'),
    });
    return true;
  }

  override render(props: ShapeDialogProps): VNode {
    const [count, ...others] = kNumbers.map(({ name, label, ...limits }) => (
      <Field key={name} label={label}>
        <input
          type="number"
          name={name}
          inputMode="decimal"
          required={'value' in limits}
          placeholder={'value' in limits ? undefined : 'as usual'}
          {...limits}
        />
      </Field>
    ));
    return (
      <Dialog title="Add a group" close={() => leave(props)} submit={() => this.submit()}>
        <div class="shape-form-part" ref={(made) => void (this.form_ = made)}>
          <Field label="Name">
            <input
              type="text"
              name="name"
              maxLength={40}
              autocomplete="off"
              required
              value={`Group ${props.state.groups.length + 1}`}
            />
          </Field>
          {count}
          <Field label="Formation">
            <select name="formation">
              {kFormations.slice(0, 8).map(({ name, label }) => (
                <option key={name} value={name}>
                  {label}
                </option>
              ))}
            </select>
          </Field>
          {others}
        </div>
        <p class="secondary shape-note">Then press on the ground where it shall stand.</p>
        <Button type="submit" class="solid">
          Place it
        </Button>
      </Dialog>
    );
  }
}
