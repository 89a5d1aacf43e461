import { svg, h } from './dom';
import type { Pose, Scenario } from './data';
import { rotated, upAxis } from './geometry';
import type { Player } from './player';
import { markedKeyframes } from './quantities';

type Point = [number, number];

const kSide = 400; // units of the drawing
const kMargin = 30;

/** The two axes of the floor so that the drawing is what one sees from above. */
function floorAxes(scenario: Scenario): { x: number; y: number; flip: number; names: string; arrows: string } {
  const { axis, sign } = upAxis(scenario.frames.truth, scenario.camera);
  const x = axis === 0 ? 1 : 0;
  const y = axis === 2 ? 1 : 2;
  // Seen from above with x to the right, y runs up the page where (x, y, up) is right-handed.
  const righthanded = (axis - y + 3) % 3 === 1 ? 1 : -1;
  const flip = -righthanded * sign;
  return {
    x,
    y,
    flip,
    names: `${'xyz'[x]} to the right, ${'xyz'[y]}`,
    arrows: `${'xyz'[x]} \u2192 ${'xyz'[y]} ${flip > 0 ? '\u2193' : '\u2191'}`,
  };
}

function roundLength(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5, 10].find((factor) => factor * power >= least) ?? 10) * power;
}

/** The path with a break wherever there is no pose. */
function pathData(points: (Point | null)[]): string {
  let broken = true;
  let text = '';
  for (const point of points) {
    if (point) text += `${broken ? 'M' : 'L'}${point[0].toFixed(1)} ${point[1].toFixed(1)}`;
    broken = !point;
  }
  return text;
}

/** The paths from above, the scene behind them; a click shows the nearest frame. */
export class TopView {
  readonly element: HTMLElement;
  private readonly axes;
  private readonly toDrawing: (p: ArrayLike<number>) => Point;
  private readonly pathOfEstimate = svg('path', { class: 'estimate-path' });
  private readonly truthMarker = svg('path', { class: 'truth-marker', d: 'M0 -16L7 6L0 2L-7 6Z' });
  private readonly estimateMarker = svg('path', { class: 'estimate-marker', d: 'M0 -14L6 6L0 2L-6 6Z' });
  private readonly keyframes = svg('g', { class: 'keyframes' });
  private estimate: (Pose | null)[];

  constructor(
    private readonly scenario: Scenario,
    private readonly player: Player,
  ) {
    const { truth, estimate, aligned } = scenario.frames;
    this.estimate = estimate;
    this.axes = floorAxes(scenario);
    const shown = [...truth, ...estimate, ...aligned].filter((p): p is Pose => p !== null);
    const { map, unit } = this.fit(shown);
    this.toDrawing = map;
    const drawing = svg(
      'svg',
      {
        viewBox: `0 0 ${kSide} ${kSide}`,
        role: 'img',
        'aria-label': `Paths from above, ${this.axes.names} along the page; truth and estimate`,
        click: (event) => this.seekNearest(event as MouseEvent),
      },
      this.scaleBar(unit),
      svg('path', { class: 'truth-path', d: pathData(truth.map((p) => p && map(p))) }),
      this.pathOfEstimate,
      this.keyframes,
      this.truthMarker,
      this.estimateMarker,
    );
    this.element = h('div', { class: 'top-view' }, drawing);
    this.show(estimate);
    player.listen(() => this.update());
  }

  /** Another estimate: as tracked or as scored. */
  show(estimate: (Pose | null)[]): void {
    this.estimate = estimate;
    this.pathOfEstimate.setAttribute('d', pathData(estimate.map((p) => p && this.toDrawing(p))));
    const flags = markedKeyframes(this.scenario);
    const dots = estimate.flatMap((pose, i) => {
      if (!pose || !flags[i]) return [];
      const [cx, cy] = this.toDrawing(pose);
      return [svg('circle', { cx, cy, r: 2.6 })];
    });
    this.keyframes.replaceChildren(...dots);
    this.update();
  }

  private fit(poses: Pose[]): { map: (p: ArrayLike<number>) => Point; unit: number } {
    const { x, y, flip } = this.axes;
    const xs = poses.map((p) => p[x]!);
    const ys = poses.map((p) => flip * p[y]!);
    const [left, right] = [Math.min(...xs), Math.max(...xs)];
    const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
    const unit = (kSide - 2 * kMargin) / Math.max(right - left, bottom - top, 1e-3); // per m
    const [midX, midY] = [(left + right) / 2, (top + bottom) / 2];
    return {
      unit,
      map: (p) => [kSide / 2 + unit * (p[x]! - midX), kSide / 2 + unit * (flip * p[y]! - midY)],
    };
  }

  private scaleBar(unit: number): SVGGElement {
    const length = roundLength(40 / unit);
    const label = length >= 1 ? `${length} m` : length >= 0.01 ? `${Math.round(length * 100)} cm` : `${+(length * 1000).toPrecision(1)} mm`;
    const end = 12 + length * unit;
    return svg(
      'g',
      { class: 'scale-bar' },
      svg('path', { d: `M12 382V390H${end}V382` }),
      svg('text', { x: end + 6, y: 390 }, label),
      svg('text', { x: kSide - 12, y: 390, 'text-anchor': 'end' }, `world from above: ${this.axes.arrows}`),
    );
  }

  private place(marker: SVGPathElement, pose: Pose | null | undefined): void {
    marker.style.display = pose ? '' : 'none';
    if (!pose) return;
    const { x, y, flip } = this.axes;
    const [u, v] = this.toDrawing(pose);
    const ahead = rotated(pose, [0, 0, 1]);
    const angle = (Math.atan2(flip * ahead[y]!, ahead[x]!) * 180) / Math.PI + 90;
    marker.setAttribute('transform', `translate(${u.toFixed(1)} ${v.toFixed(1)}) rotate(${angle.toFixed(1)})`);
  }

  private update(): void {
    this.place(this.truthMarker, this.scenario.frames.truth[this.player.frame]);
    this.place(this.estimateMarker, this.estimate[this.player.frame]);
  }

  private seekNearest(event: MouseEvent): void {
    const drawing = event.currentTarget as SVGSVGElement;
    const toDrawing = drawing.getScreenCTM()?.inverse();
    if (!toDrawing) return;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(toDrawing);
    let nearest = this.player.frame;
    let least = Infinity;
    this.scenario.frames.truth.forEach((truth, i) => {
      const pose = truth ?? this.estimate[i];
      if (!pose) return;
      const [u, v] = this.toDrawing(pose);
      const distance = Math.hypot(u - at.x, v - at.y);
      if (distance < least) [least, nearest] = [distance, i];
    });
    this.player.scrub(nearest);
  }
}
