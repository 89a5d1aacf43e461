import { Chart } from './chart';
import { h } from './dom';
import { isDoubted } from './data';
import { LiveRun } from './live_run';
import { stageTimes } from './live_stages';
import { PictureSection } from './pictures';
import { Player } from './player';
import { quantities, type Quantity } from './quantities';
import { makeScene } from './scenario';
import { frameFacts } from './tables';
import { statusStrip, statusText } from './timeline';

/** What a viewer may ask of the run. */
export type Move = 'pause' | 'resume' | 'step';

const kFirstCharts = ['Position uncertainty, one sigma', 'Alignment (time)'];

/** The bar at the bottom: what is shown, and what the run is asked. */
class LiveBar {
  readonly element: HTMLElement;
  private readonly strip = h('div', { class: 'strip-place' });
  private readonly range;
  private readonly pause;
  private readonly step;
  private readonly follow;
  private readonly position = h('span', { class: 'position' });
  private readonly status = h('span', { class: 'status' });
  private paused = false;
  private over = false;

  constructor(
    private readonly run: LiveRun,
    private readonly player: Player,
    private readonly section: { following: boolean; followLatest: () => void },
    ask: (move: Move) => void,
  ) {
    this.range = h('input', {
      type: 'range',
      min: 0,
      max: 0,
      value: 0,
      'aria-label': 'Frame',
      input: () => {
        section.following = false;
        player.scrub(this.range.valueAsNumber);
      },
    });
    this.pause = h('button', { class: 'pause', click: () => ask(this.paused ? 'resume' : 'pause') });
    this.step = h('button', { 'aria-label': 'Step', title: 'One more frame', click: () => {
      section.followLatest();
      ask('step');
    } }, '\u25B6\u275A step');
    this.follow = h('button', { class: 'follow', click: () => section.followLatest() }, '\u25CF latest');
    this.element = h(
      'div',
      { class: 'timeline', role: 'group', 'aria-label': 'Time' },
      h('div', { class: 'track' }, this.range, this.strip),
      h(
        'div',
        { class: 'controls' },
        this.pause,
        this.step,
        this.follow,
        h('div', { class: 'readout' }, this.position, this.status),
      ),
    );
    this.show(false, false);
    player.listen(() => this.update());
  }

  show(paused: boolean, over: boolean): void {
    [this.paused, this.over] = [paused, over];
    this.pause.textContent = paused ? '\u25B6 go on' : '\u275A\u275A pause';
    this.pause.setAttribute('aria-label', paused ? 'Go on' : 'Pause');
    this.pause.disabled = over;
    this.step.disabled = over;
    this.update();
  }

  grow(): void {
    this.range.max = String(this.player.last);
    const strip = statusStrip(this.run.scenario);
    this.strip.replaceChildren(...(strip ? [strip] : []));
    this.update();
  }

  private update(): void {
    const { player, run } = this;
    const frame = player.frame;
    const { status, timestamp } = run.scenario.frames;
    const seconds = timestamp[frame]! - timestamp[0]!;
    this.range.valueAsNumber = frame;
    this.range.setAttribute('aria-valuetext', `frame ${frame}, ${seconds.toFixed(2)} seconds, ${statusText(run.scenario, frame)}`);
    this.position.textContent = `${frame} / ${player.last} \u00B7 ${seconds.toFixed(2)} s`;
    this.status.textContent = run.hasPath ? '' : statusText(run.scenario, frame);
    this.status.classList.toggle('is-lost', status !== undefined && isDoubted(status[frame]!));
    this.follow.classList.toggle('is-on', this.section.following && !this.over);
  }
}

/** What is shown of a stage that has frames. It needs at least one. */
export class LiveSection {
  readonly element: HTMLElement;
  readonly player: Player;
  following = true;
  private readonly all: Quantity[] = [];
  private readonly charts: Chart[] = [];
  private readonly chartPlace = h('div');
  private readonly pictures: PictureSection;
  private readonly scene;
  private readonly legend = h('span', { class: 'which' });
  private readonly bar: LiveBar;

  constructor(
    private readonly run: LiveRun,
    ask: (move: Move) => void,
  ) {
    const { scenario } = run;
    this.player = new Player(scenario.frames.timestamp);
    this.all.push(...quantities(scenario));
    this.pictures = new PictureSection(scenario, this.player, run.hasPath ? ['Colour', 'Depth'] : ['Edges', 'Residual after', 'Inverse depth, estimated', 'Depth', 'Residual before']);
    const { scene, element } = makeScene(scenario, this.player);
    this.scene = scene;
    this.bar = new LiveBar(run, this.player, this, ask);
    const trajectory = h(
      'section',
      { class: 'panel trajectories', 'aria-label': 'Trajectory' },
      h('h3', {}, 'Trajectory ', this.legend),
      element,
      scene && h('div', { class: 'bar' }, h('button', { click: () => scene.reset() }, 'reset view')),
    );
    const facts = h('section', { class: 'panel', 'aria-label': 'Frame' }, h('h3', {}, 'Frame'), frameFacts(scenario, this.player, this.all));
    this.element = h(
      'section',
      { class: 'scenario live' },
      h('div', { class: 'live-columns' },
        this.pictures.element,
        h('div', {}, trajectory, scenario.times && stageTimes(scenario, this.player)),
      ),
      facts,
      this.all.length > 0 && h('section', { class: 'panel charts', 'aria-label': 'Over time' }, h('h3', {}, 'Over time'),
        h('p', { class: 'hint' }, 'Click to see a frame, drag to zoom, double-click to zoom out. Orange ticks are keyframes; shaded frames are lost or uncertain.'),
        this.chartPlace),
      this.bar.element,
    );
    this.player.listen(() => this.describeEllipsoids());
  }

  show(paused: boolean, over: boolean): void {
    this.bar.show(paused, over);
  }

  followLatest(): void {
    this.following = true;
    this.player.scrub(this.run.latest);
    this.bar.grow();
  }

  /** By hand: the page stays at that frame while the run goes on. */
  scrub(frame: number): void {
    this.following = false;
    this.player.scrub(frame);
  }

  /** Shows what was added since the last call. */
  grow(): void {
    this.all.splice(0, this.all.length, ...quantities(this.run.scenario));
    this.growCharts();
    this.scene?.grow();
    this.pictures.grow();
    this.bar.grow();
    if (this.following) this.player.seek(this.run.latest);
  }

  recolour(): void {
    this.scene?.recolour();
    this.charts.forEach((chart) => chart.draw());
  }

  remove(): void {
    this.player.stop();
    this.scene?.remove();
    this.charts.forEach((chart) => chart.remove());
  }

  private describeEllipsoids(): void {
    const factor = this.scene?.covarianceFactor;
    const enlarged = factor && factor > 1 ? `, ${factor} times enlarged` : '';
    this.legend.textContent = factor ? `ellipsoids: 3 \u03C3 of the position${enlarged}` : '';
  }

  private growCharts(): void {
    if (this.charts.length === 0 && this.all.length > 0 && this.player.last > 0) {
      for (const label of kFirstCharts) {
        const first = Math.max(0, this.all.findIndex((quantity) => quantity.label === label));
        this.charts.push(new Chart(this.run.scenario, this.player, this.all, first));
      }
      this.chartPlace.replaceChildren(...this.charts.map((chart) => chart.element));
    }
    this.charts.forEach((chart) => chart.grow());
  }
}
