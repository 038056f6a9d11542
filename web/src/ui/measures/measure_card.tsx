// What one line or area has measured: figures, plots, its place, its name, its table.

import type { VNode } from 'preact';
import { kWindow, type AreaMeasure, type LineMeasure, type Measure } from '../../model/measures/measures';
import type { GroundPoint } from '../../model/plane';
import { toolButton } from '../widgets/buttons';
import { NumberField, TextField } from '../widgets/fields';
import { Plot, type PlotPoint } from './plot';

export interface CardActions {
  rename(id: number, name: string): void;
  hide(id: number, hidden: boolean): void;
  remove(id: number): void;
  save(id: number): void;
  /** Other ends of a line, or corners of an area: it begins anew. */
  place(id: number, points: readonly GroundPoint[]): void;
}

/** Points of a curve of flow. */
const kFlowPoints = 120;
const kFar = { min: -1e5, max: 1e5, unit: 'm' };

export function withUnit(value: number, unit: string, digits = 2): string {
  return Number.isFinite(value) ? `${value.toFixed(digits)} ${unit}` : '–';
}

/** Names and values, side by side. */
export function Figures({ of }: { readonly of: Readonly<Record<string, string>> }): VNode {
  return (
    <dl class="measure-figures">
      {Object.entries(of).map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

/** How many have crossed in a direction, step by step. */
function crossed({ record, since }: LineMeasure, time: number, direction: 1 | -1): PlotPoint[] {
  let count = 0;
  const points: PlotPoint[] = [[since, 0]];
  for (const crossing of record.crossings) if (crossing.direction === direction) points.push([crossing.time, ++count]);
  return [...points, [time, count]];
}

interface ResultProps<Of> {
  readonly one: Of;
  readonly time: number;
}

function LineResults({ one, time }: ResultProps<LineMeasure>): VNode {
  const { record, since, a, b } = one;
  const { persons, right, left, rightFlow, leftFlow, meanFlow } = record.figures(time, kWindow, since);
  const flows = Array.from({ length: kFlowPoints + 1 }, (_, k) => {
    const at = since + ((time - since) * k) / kFlowPoints;
    return { at, ...record.flowAt(at, kWindow, since) };
  });
  const span = { from: since, to: time };
  return (
    <>
      <Figures
        of={{
          'Persons who crossed, N': String(persons),
          'With the arrow / against it': `${right} / ${left}`,
          [`Flow of the last ${kWindow} s`]: `${rightFlow.toFixed(2)} / ${leftFlow.toFixed(2)} /s`,
          'Mean flow since the first person': withUnit(meanFlow, '/s'),
          'Mean flow per metre of the line': withUnit(meanFlow / Math.hypot(b.x - a.x, b.y - a.y), '/s/m'),
        }}
      />
      <div class="plots">
        <Plot
          {...span}
          quantity="N"
          unit="persons"
          least={5}
          curves={[
            { name: 'with', points: crossed(one, time, 1), stepped: true },
            { name: 'against', points: crossed(one, time, -1), stepped: true },
          ]}
        />
        <Plot
          {...span}
          quantity={`Flow, ${kWindow} s`}
          unit="1/s"
          least={1}
          curves={[
            { points: flows.map((flow) => [flow.at, flow.right]) },
            { points: flows.map((flow) => [flow.at, flow.left]) },
          ]}
        />
      </div>
    </>
  );
}

function AreaResults({ one: { record, since }, time }: ResultProps<AreaMeasure>): VNode {
  const { samples, last } = record.series;
  const span = { from: since, to: time };
  return (
    <>
      <Figures
        of={{
          Persons: last ? String(last.persons) : '–',
          Area: withUnit(record.size, 'm²'),
          Density: withUnit(last?.density ?? NaN, '/m²'),
          'Mean speed': withUnit(last?.speed ?? NaN, 'm/s'),
        }}
      />
      <div class="plots">
        <Plot
          {...span}
          quantity="Density"
          unit="1/m²"
          least={1}
          curves={[{ points: samples.map((s) => [s.time, s.density]) }]}
        />
        <Plot
          {...span}
          quantity="Speed"
          unit="m/s"
          least={1.5}
          curves={[{ points: samples.map((s) => [s.time, s.speed]) }]}
        />
      </div>
    </>
  );
}

interface CardProps {
  readonly one: Measure;
  readonly actions: CardActions;
}

/** Ends of a line; of an area, which is a rectangle, two corners. */
function PlaceFields({ one, actions }: CardProps): VNode {
  const ends = one.kind === 'line' ? [one.a, one.b] : [one.record.polygon[0]!, one.record.polygon[2]!];
  const move = (k: number, axis: 'x' | 'y', value: number): void => {
    const [from, to] = ends.map((end, n) => (n === k ? { ...end, [axis]: value } : end));
    if (!from || !to || (from.x === to.x && from.y === to.y)) return;
    if (one.kind === 'area' && (from.x === to.x || from.y === to.y)) return;
    actions.place(one.id, one.kind === 'line' ? [from, to] : rectangle(from, to));
  };
  return (
    <div class="build-fields">
      {ends.flatMap((end, k) =>
        (['x', 'y'] as const).map((axis) => (
          <NumberField
            key={`${k} ${axis}`}
            label={`${k === 0 ? 'From' : 'To'} ${axis}`}
            value={end[axis]}
            range={kFar}
            act={(value) => move(k, axis, value)}
          />
        )),
      )}
    </div>
  );
}

/** Curves are drawn from when on it measures. */
export function MeasureCard({ one, actions, time }: CardProps & { readonly time: number }): VNode {
  const { id, name, hidden } = one;
  return (
    <section class="measure-card" aria-label={name}>
      <header>
        <TextField label="" name="Name" value={name} act={(typed) => typed && actions.rename(id, typed)} />
        {toolButton('watch', 'Hide', () => actions.hide(id, !hidden), { iconOnly: true, pressed: hidden })}
        {toolButton('download', 'Save as CSV', () => actions.save(id), { iconOnly: true })}
        {toolButton('close', 'Remove', () => actions.remove(id), { iconOnly: true })}
      </header>
      {one.kind === 'line' ? <LineResults one={one} time={time} /> : <AreaResults one={one} time={time} />}
      <details>
        <summary>Place</summary>
        <PlaceFields one={one} actions={actions} />
      </details>
    </section>
  );
}

/** The corners of a rectangle with these two opposite ones. */
export function rectangle(from: GroundPoint, to: GroundPoint): GroundPoint[] {
  return [from, { x: to.x, y: from.y }, to, { x: from.x, y: to.y }];
}
