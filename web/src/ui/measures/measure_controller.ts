// Measuring the crowd: lines and areas are drawn on the ground, and what they measure is shown and saved.

import { PanelLayout } from '../widgets/panel_layout';
import { saveBlob } from '../../link/answers';
import type { StudioClient } from '../../link/studio_client';
import { Measures } from '../../model/measures/measures';
import { allCsv, csvName, evacuationCsv, exitNames, measureCsv } from '../../model/measures/measures_csv';
import { thingsOf } from '../../model/place/things';
import { rightAngled, snapped } from '../../model/place/snap';
import type { GroundPoint } from '../../model/plane';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import type { SceneFacts } from '../../protocol/scene';
import type { StudioScene } from '../../scene/studio_scene';
import { BuildPointer, type BuildStroke, type BuildStrokes } from '../../tools/build_pointer';
import { onEscape } from '../widgets/escape_key';
import { rectangle } from './measure_card';
import { MeasureLayer } from './measure_layer';
import { MeasurePanel, type MeasureActions, type MeasureTool } from './measure_panel';
import '../styles/measures.css';

export interface MeasureParts {
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly page: HTMLElement;
}

/** Figures and plots are made anew so often [ms]. */
const kRenewed = 250;
/** Points go to corners this near [CSS px]. */
const kSnap = 12;
/** Nothing shorter is a line, or the side of an area [m]. */
const kLeast = 0.05;

export class MeasureController implements BuildStrokes, MeasureActions {
  readonly measures = new Measures();
  private readonly layer_: MeasureLayer;
  private readonly panel_ = new MeasurePanel(this, this.measures);
  private open_ = false;
  private tool_: MeasureTool | null = null;
  private from_: GroundPoint | null = null;
  private drawn_: readonly GroundPoint[] = [];
  private renewed_ = -Infinity;

  constructor(private readonly parts_: MeasureParts) {
    const { view, page } = parts_;
    this.layer_ = new MeasureLayer((point) => view.worldToScreen(point));
    page.before(this.layer_.root);
    PanelLayout.of(page).add('measures', this.panel_.root);
    BuildPointer.over(view, this).listen(this.layer_.root);
    onEscape(
      () => this.open_,
      () => (this.tool_ ? this.setTool(null) : this.leaveMeasures()),
    );
    this.layer_.root.style.display = 'none';
  }

  setScene(scene: SceneFacts): void {
    this.measures.setScene(scene);
    this.renewed_ = -Infinity;
  }

  /** `ids`: of everybody, also where the frame does not repeat them. */
  observe(frame: StudioFrame, ids: Uint32Array): void {
    if (ids.length !== frame.x.length) return;
    const { time, replaying, x, y, events, areas } = frame;
    this.measures.observe({ time, replaying, ids, x, y, events, areas });
  }

  setOpen(open: boolean): void {
    if (open === this.open_) return;
    this.open_ = open;
    this.layer_.root.style.display = open ? '' : 'none';
    this.panel_.root.hidden = !open;
    this.setTool(null);
    this.renewed_ = -Infinity;
    if (open) requestAnimationFrame(this.drawn);
  }

  private readonly drawn = (now: number): void => {
    if (!this.open_) return;
    requestAnimationFrame(this.drawn);
    this.layer_.draw({ measures: this.measures.list, drawn: this.drawn_ });
    if (now - this.renewed_ < kRenewed) return;
    this.renewed_ = now;
    this.panel_.update();
  };

  /** Nothing but drawing keeps fingers from the scene. */
  private setTool(tool: MeasureTool | null): void {
    this.tool_ = tool;
    this.cancel();
    this.layer_.root.classList.toggle('measure-drawing', tool !== null);
    this.panel_.setTool(tool);
  }

  // Strokes.

  private spot({ ground, free }: BuildStroke): GroundPoint {
    const { scene } = this.measures;
    if (free || !scene) return ground;
    return snapped(ground, thingsOf(scene), this.metres(ground));
  }

  /** So far on the ground is kSnap on the screen. */
  private metres(at: GroundPoint): number {
    const { view } = this.parts_;
    const [a, b] = [view.worldToScreen(at), view.worldToScreen({ x: at.x + 1, y: at.y })];
    return kSnap / Math.max(1, Math.hypot(b.x - a.x, b.y - a.y));
  }

  private pointsTo(from: GroundPoint, stroke: BuildStroke): GroundPoint[] {
    if (this.tool_ === 'area') return rectangle(from, this.spot(stroke));
    return [from, stroke.shift ? rightAngled(from, stroke.ground) : this.spot(stroke)];
  }

  begin(stroke: BuildStroke): void {
    this.from_ = this.spot(stroke);
  }

  move(stroke: BuildStroke): void {
    if (this.from_) this.drawn_ = this.pointsTo(this.from_, stroke);
  }

  end(stroke: BuildStroke, still: boolean): void {
    const { from_: from, tool_: tool } = this;
    const points = from && !still ? this.pointsTo(from, stroke) : [];
    this.cancel();
    const [a, b, c] = points;
    if (!a || !b || !tool) return;
    const sides = c ? [Math.abs(c.x - a.x), Math.abs(c.y - a.y)] : [Math.hypot(b.x - a.x, b.y - a.y)];
    if (Math.min(...sides) < kLeast) return this.panel_.say('That is too small to measure.');
    if (tool === 'line') this.measures.addLine(a, b);
    else this.measures.addArea(points);
    this.setTool(null);
    this.renewed_ = -Infinity;
  }

  cancel(): void {
    this.from_ = null;
    this.drawn_ = [];
  }

  doubleTap(): void {
    // Means no more than a tap.
  }

  threeFingers(): void {
    this.setTool(null);
  }

  // Actions.

  draw(tool: MeasureTool): void {
    this.setTool(this.tool_ === tool ? null : tool);
  }

  rename(id: number, name: string): void {
    this.measures.change(id, { name });
  }

  hide(id: number, hidden: boolean): void {
    this.measures.change(id, { hidden });
    this.renewed_ = -Infinity;
  }

  remove(id: number): void {
    this.measures.remove(id);
    this.renewed_ = -Infinity;
  }

  place(id: number, points: readonly GroundPoint[]): void {
    const [a, b, c] = points;
    if (c) this.measures.moveArea(id, points);
    else if (a && b) this.measures.moveLine(id, { a, b });
  }

  save(id: number): void {
    const one = this.measures.list.find((measure) => measure.id === id);
    if (one) this.saveText(measureCsv(one), one.name);
  }

  saveEvacuation(): void {
    const { evacuation } = this.measures;
    this.saveText(evacuationCsv(evacuation, this.exits), 'evacuation');
  }

  saveAll(): void {
    this.saveText(allCsv(this.measures, this.exits), 'measures');
  }

  leaveMeasures(): void {
    this.parts_.store.set({ measures: false });
  }

  private get exits(): string[] {
    return exitNames(this.measures.evacuation.exits, this.measures.scene?.areas ?? []);
  }

  private saveText(text: string, name: string): void {
    saveBlob(new Blob([text], { type: 'text/csv' }), csvName(`${this.parts_.store.state.title} ${name}`));
  }
}
