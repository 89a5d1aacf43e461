import uPlot from 'uplot';
import { h, themeColour } from './dom';
import { isDoubted, type Scenario } from './data';
import type { Player } from './player';
import { axisTitle, markedKeyframes, valueText, type Quantity } from './quantities';

const kHeight = 190; // px

/** Frames as shaded bands where they are lost or uncertain and ticks where they became keyframes. */
function drawEvents(plot: uPlot, scenario: Scenario): void {
  const statuses = scenario.frames.status;
  if (!statuses) return;
  const { ctx, bbox } = plot;
  const stamps = plot.data[0];
  const x = (i: number) => plot.valToPos(stamps[Math.min(i, stamps.length - 1)]!, 'x', true);
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  statuses.forEach((status, i) => {
    if (isDoubted(status)) {
      ctx.fillStyle = themeColour(`${status}-band`);
      ctx.fillRect(x(i), bbox.top, Math.max(2, x(i + 1) - x(i)), bbox.height);
    }
  });
  ctx.fillStyle = themeColour('keyframe');
  const tick = 7 * devicePixelRatio;
  markedKeyframes(scenario).forEach((keyframe, i) => {
    if (keyframe) ctx.fillRect(x(i) - 1, bbox.top + bbox.height - tick, 2 * devicePixelRatio, tick);
  });
  ctx.restore();
}

function drawCursor(plot: uPlot, frame: number): void {
  const { ctx, bbox } = plot;
  const x = plot.valToPos(plot.data[0][frame]!, 'x', true);
  if (x < bbox.left || x > bbox.left + bbox.width) return;
  ctx.save();
  ctx.strokeStyle = themeColour('now');
  ctx.lineWidth = 1.5 * devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  const y = plot.data[1]?.[frame];
  if (y !== null && y !== undefined) {
    ctx.fillStyle = themeColour('estimate');
    ctx.beginPath();
    ctx.arc(x, plot.valToPos(y, 'y', true), 4 * devicePixelRatio, 0, 2 * Math.PI);
    ctx.fill();
  }
  ctx.restore();
}

function axis(): uPlot.Axis {
  return {
    stroke: themeColour('muted'),
    grid: { stroke: themeColour('grid'), width: 1 },
    ticks: { stroke: themeColour('grid'), width: 1 },
    font: '12px system-ui, sans-serif',
  };
}

/** A click (not a drag, which zooms) shows the frame that it points at. */
function seekOnClick(plot: uPlot, player: Player): void {
  let pressedAt = 0;
  plot.over.addEventListener('pointerdown', (event) => (pressedAt = event.clientX));
  plot.over.addEventListener('click', (event) => {
    if (Math.abs(event.clientX - pressedAt) < 4) player.scrub(plot.posToIdx(event.offsetX));
  });
}

function summary(quantity: Quantity, stamps: number[]): string {
  let greatest = -1;
  quantity.values.forEach((value, i) => {
    if (value !== null && (greatest < 0 || value > quantity.values[greatest]!)) greatest = i;
  });
  return `${axisTitle(quantity)} over time; greatest ${valueText(quantity, greatest)} at ${(
    stamps[greatest]! - stamps[0]!
  ).toFixed(2)} s`;
}

/** One quantity over time, chosen from a list, linked to the frame that is shown. */
export class Chart {
  readonly element: HTMLElement;
  private readonly host = h('div', { class: 'plot', role: 'img' });
  private readonly now = h('output', { class: 'now' });
  private plot: uPlot | undefined;
  private readonly select: HTMLSelectElement;
  private quantity: Quantity;
  private readonly resize = new ResizeObserver(() => this.fit());

  constructor(
    private readonly scenario: Scenario,
    private readonly player: Player,
    private readonly choices: Quantity[],
    first: number,
  ) {
    this.quantity = choices[first]!;
    this.select = h(
      'select',
      {
        'aria-label': 'Quantity over time',
        change: () => {
          this.quantity = this.choices[this.select.selectedIndex]!;
          this.draw();
        },
      },
      ...this.options(),
    );
    this.element = h('div', { class: 'chart' }, h('div', { class: 'bar' }, this.select, this.now), this.host);
    this.resize.observe(this.host);
    this.draw();
    player.listen(() => this.update());
  }

  /** After frames were added, and quantities to those that can be chosen. */
  grow(): void {
    const { label } = this.quantity;
    this.quantity = this.choices.find((quantity) => quantity.label === label) ?? this.choices[0]!;
    if (this.select.options.length !== this.choices.length) this.select.replaceChildren(...this.options());
    const stamps = this.player.timestamps;
    this.plot?.setData([stamps.map((stamp) => stamp - stamps[0]!), this.quantity.values], !this.isZoomed());
    this.host.setAttribute('aria-label', summary(this.quantity, stamps));
    this.update();
  }

  draw(): void {
    this.plot?.destroy();
    const stamps = this.player.timestamps;
    const start = stamps[0] ?? 0;
    this.plot = new uPlot(
      {
        width: Math.max(200, this.host.clientWidth),
        height: kHeight,
        legend: { show: false },
        scales: {
          x: { time: false },
          y: { range: (_, low, high) => (low >= 0 ? [0, high > 0 ? high * 1.05 : 1] : [low, high]) },
        },
        axes: [
          { ...axis(), values: (_, ticks) => ticks.map((tick) => `${tick} s`) },
          { ...axis(), size: 56 },
        ],
        series: [
          {},
          { stroke: themeColour('estimate'), width: 1.5, points: { show: false }, spanGaps: false },
        ],
        cursor: { sync: { key: 'time' }, points: { show: false }, drag: { x: true, y: false } },
        hooks: {
          drawClear: [(plot) => drawEvents(plot, this.scenario)],
          draw: [(plot) => drawCursor(plot, this.player.frame)],
        },
      },
      [stamps.map((stamp) => stamp - start), this.quantity.values],
      this.host,
    );
    seekOnClick(this.plot, this.player);
    this.host.setAttribute('aria-label', summary(this.quantity, stamps));
    this.update();
  }

  remove(): void {
    this.resize.disconnect();
    this.plot?.destroy();
  }

  private options(): HTMLOptionElement[] {
    return this.choices.map((q) => h('option', { selected: q.label === this.quantity.label }, axisTitle(q)));
  }

  /** Whether a part of the time is shown alone. */
  private isZoomed(): boolean {
    const { min, max } = this.plot?.scales['x'] ?? {};
    const stamps = this.plot?.data[0] ?? [];
    return min !== undefined && max !== undefined && (min > stamps[0]! || max < stamps[stamps.length - 1]!);
  }

  private fit(): void {
    this.plot?.setSize({ width: Math.max(200, this.host.clientWidth), height: kHeight });
  }

  private update(): void {
    this.now.textContent = valueText(this.quantity, this.player.frame);
    this.plot?.redraw(false);
  }
}
