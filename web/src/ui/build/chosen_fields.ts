// Numbers and words of what is chosen.

import { formationKind, type FormationWords } from '../../model/sequence';
import { extentOf, moved, scaled, turned, type Thing } from '../../model/place/things';
import type { SceneFacts } from '../../protocol/scene';
import { element } from '../widgets/dom';
import { kShapes, type BuildActions } from './build_actions';
import { areaFields, stairsFields } from './area_fields';
import { numberField, selectField, textField } from '../widgets/fields';
import { groupColourField } from './group_colour_field';
import { groupBodyFields } from './group_body_fields';
import { PersonFields } from './person_fields';

const kDegree = Math.PI / 180;
const kFar = { min: -1e5, max: 1e5, unit: 'm' };
const kSize = { min: 0.05, max: 1e4, unit: 'm' };

const kAreas = { exit: 'Exit', source: 'Source', waiting: 'Waiting area' };

function titleOf({ kind, area, ascent }: Thing): string {
  if (area) return kAreas[area.kind];
  return ascent === null ? kNames[kind] : 'Stairs';
}

const kNames: Record<Thing['kind'], string> = {
  obstacle: 'Obstacle',
  patch: 'Patch',
  area: 'Area',
  item: 'Item',
  checkpoint: 'Checkpoint',
  group: 'People',
};

function nameOf(control: HTMLInputElement): string {
  return control.getAttribute('aria-label') ?? control.labels?.[0]?.firstElementChild?.textContent ?? '';
}

export class ChosenFields {
  readonly root = element('div', { class: 'build-chosen-fields' });
  private shown_ = '';
  /** A slider is being dragged: what is shown waits. */
  private held_ = false;
  private latest_: readonly [readonly Thing[], SceneFacts | null] = [[], null];

  private readonly persons_: PersonFields;

  constructor(private readonly actions_: BuildActions) {
    this.persons_ = new PersonFields(actions_);
  }

  private hold(held: boolean): void {
    this.held_ = held;
    if (!held) this.show(...this.latest_);
  }

  show(chosen: readonly Thing[], scene: SceneFacts | null): void {
    this.latest_ = [chosen, scene];
    if (this.held_ && chosen.length > 0) return;
    this.held_ = false;
    const key = JSON.stringify(chosen);
    if (key === this.shown_) return;
    this.shown_ = key;
    const [one] = chosen;
    if (!one) return this.root.replaceChildren();
    const title = chosen.length === 1 ? titleOf(one) : `${chosen.length} things`;
    const fields = chosen.length === 1 ? this.fieldsOf(one, scene) : [this.turn()];
    const focused = this.focused();
    this.root.replaceChildren(element('h3', {}, title), element('div', { class: 'build-fields' }, ...fields));
    if (focused)
      this.controls()
        .find((control) => nameOf(control) === focused)
        ?.focus();
  }

  private controls(): HTMLInputElement[] {
    return [...this.root.querySelectorAll<HTMLInputElement>('input, select, [role="radio"]')];
  }

  /** The label of the field that has the focus. */
  private focused(): string {
    const found = this.controls().find((control) => control === document.activeElement);
    return found ? nameOf(found) : '';
  }

  private fieldsOf(one: Thing, scene: SceneFacts | null): HTMLElement[] {
    const { actions_: actions } = this;
    const fields = [
      numberField('X', one.centre[0], kFar, (x) => actions.edit('Move', (it) => moved(it, x - it.centre[0], 0))),
      numberField('Y', one.centre[1], kFar, (y) => actions.edit('Move', (it) => moved(it, 0, y - it.centre[1]))),
    ];
    if (one.kind === 'obstacle' || one.kind === 'patch' || one.kind === 'area')
      fields.unshift(textField('Name', one.name, (name) => actions.edit('Rename', (it) => ({ ...it, name }))));
    if (one.polygon) fields.push(...this.size(one), this.turn());
    if (one.radius > 0 && one.kind !== 'group')
      fields.push(
        numberField('Radius', one.radius, kSize, (radius) => actions.edit('Resize', (it) => ({ ...it, radius }))),
      );
    if (one.kind === 'obstacle')
      fields.push(
        numberField('Height', one.height, { min: 0.01, max: 1000, unit: 'm' }, (height) =>
          actions.edit('Height', (it) => ({ ...it, height })),
        ),
      );
    if (one.kind === 'patch') fields.push(this.motion(one, scene));
    if (one.ascent !== null) fields.push(...stairsFields(one, one.ascent, actions));
    if (one.area) fields.push(...areaFields(one, one.area, scene, actions));
    if (one.kind === 'checkpoint') fields.push(...this.checkpoint(one));
    if (one.kind === 'group') fields.push(...this.group(one));
    if (one.path) fields.push(this.stop());
    return fields;
  }

  private size(one: Thing): HTMLElement[] {
    const extent = extentOf([one]);
    if (!extent) return [];
    const width = extent.maxX - extent.minX;
    const about = { x: (extent.minX + extent.maxX) / 2, y: (extent.minY + extent.maxY) / 2 };
    return [
      numberField('Across', width, kSize, (wide) =>
        this.actions_.edit('Scale', (it) => scaled(it, about, wide / Math.max(0.01, width))),
      ),
    ];
  }

  private turn(): HTMLElement {
    return numberField('Turn by', 0, { min: -360, max: 360, unit: '°' }, (degrees) =>
      this.actions_.turnChosen(degrees * kDegree),
    );
  }

  private motion(one: Thing, scene: SceneFacts | null): HTMLElement {
    const clips = scene?.clips.map(({ name }) => name) ?? [];
    return selectField('Motion', clips, clips[one.motion] ?? '', (name) =>
      this.actions_.edit('Motion', (it) => ({ ...it, motion: clips.indexOf(name) })),
    );
  }

  private checkpoint(one: Thing): HTMLElement[] {
    return [
      selectField('Formation', kShapes, one.formation.kind, (kind) =>
        this.actions_.edit('Formation', (it) => ({ ...it, formation: { ...it.formation, kind: formationKind(kind) } })),
      ),
    ];
  }

  private group(one: Thing): HTMLElement[] {
    const { actions_: actions } = this;
    const spacing = one.formation.spacing ?? 1;
    const formation = (change: Partial<FormationWords>): void =>
      actions.editGroup('Formation', (it) => ({
        kind: 'changeGroup',
        group: it.id,
        formation: { ...it.formation, ...change },
      }));
    return [
      textField('Name', one.name, (name) => {
        if (name) actions.editGroup('Rename', (it) => ({ kind: 'changeGroup', group: it.id, name }));
      }),
      numberField('People', one.count, { min: Math.min(1, one.count), max: 20000, whole: true }, (count) =>
        actions.editGroup('People', (it) => ({ kind: 'changeGroup', group: it.id, count })),
      ),
      numberField('Spacing', spacing, { min: 0.3, max: 20, unit: 'm' }, (value) => formation({ spacing: value })),
      selectField('Formation', kShapes, one.formation.kind, (kind) => formation({ kind: formationKind(kind) })),
      numberField('Faces', one.angle / kDegree, { min: -3600, max: 3600, unit: '°' }, (degrees) =>
        actions.edit('Turn', (it) => turned(it, { x: it.centre[0], y: it.centre[1] }, degrees * kDegree - it.angle)),
      ),
      groupColourField(one, actions),
      ...groupBodyFields(one, actions, (held) => this.hold(held)),
      this.persons_.make(one),
    ];
  }

  private stop(): HTMLElement {
    const button = element('button', { type: 'button', class: 'soft' }, 'Stand still');
    button.addEventListener('click', () => this.actions_.edit('Stand still', (it) => ({ ...it, path: null })));
    return button;
  }
}
