import { h } from './dom';
import type { LiveEvents } from './live_data';
import { LiveRun } from './live_run';
import { LiveSection, type Move } from './live_section';
import { scrubByKeys } from './keys';
import { themeSwitch } from './theme';

const kPeriod = 200; // ms, least time between two drawings of the page

type State = 'waiting' | 'running' | 'paused' | 'over' | 'lost';

const kStates: Record<State, [string, string]> = {
  waiting: ['wait', '\u2026 waiting for the run'],
  running: ['pass', '\u25CF running'],
  paused: ['wait', '\u275A\u275A paused'],
  over: ['pass', '\u2713 done'],
  lost: ['fail', '\u2715 connection lost'],
};

/** The page of a run while it runs. */
class LivePage {
  private readonly badge = h('span', { class: 'badge', role: 'status' });
  private readonly title = h('span', { class: 'live-title' });
  private readonly progress = h('progress', { 'aria-label': 'Progress', max: 1, value: 0 });
  private readonly counted = h('span', { class: 'counted' });
  private readonly message = h('p', { class: 'note live-message' });
  private readonly trials = h('div', { class: 'trials' });
  private readonly place = h('main', {}, h('p', { class: 'hint' }, 'Waiting for the first frame \u2026'));
  private run: LiveRun | undefined;
  private section: LiveSection | undefined;
  private steps = { done: 0, total: 0 };
  private paused = false;
  private over = false;
  private lost = false;
  private pending = 0;

  constructor(root: HTMLElement) {
    root.append(
      h('header', { class: 'page-head' }, h('h1', {}, 'edvo live'), this.badge, this.title, this.progress, this.counted,
        themeSwitch(() => this.section?.recolour())),
      this.message,
      this.trials,
      this.place,
    );
    scrubByKeys({
      frame: () => this.section?.player.frame,
      scrub: (frame) => this.section?.scrub(frame),
      toggle: () => this.ask(this.paused ? 'resume' : 'pause'),
    });
    this.show();
    this.listen();
  }

  private listen(): void {
    const source = new EventSource(`events${location.search}`);
    const on = <Name extends keyof LiveEvents>(name: Name, act: (data: LiveEvents[Name]) => void) =>
      source.addEventListener(name, (event) => {
        act(JSON.parse((event as MessageEvent<string>).data) as LiveEvents[Name]);
        this.changed();
      });
    source.onopen = () => this.reset(); // all is told anew, also after a connection was lost
    source.onerror = () => {
      this.lost = true;
      this.changed();
    };
    on('stage', (stage) => this.begin(new LiveRun(stage)));
    on('path', (path) => this.run?.addPath(path));
    on('frame', (frame) => this.run?.add(frame));
    on('pictures', (pictures) => this.run?.addPictures(pictures));
    on('progress', (steps) => (this.steps = steps));
    on('gate', ({ paused }) => (this.paused = paused));
    on('problem', ({ text }) => (this.message.textContent = text));
    on('trial', (trial) =>
      this.trials.append(h('p', {}, h('span', { class: `badge ${['failed', 'error'].includes(trial.verdict) ? 'fail' : 'pass'}` }, trial.verdict), ' ', trial.name, ' ', h('small', {}, trial.text))));
    on('end', ({ how }) => {
      this.over = true;
      this.paused = false;
      this.message.textContent = how;
      source.close();
    });
  }

  private reset(): void {
    [this.paused, this.over, this.lost] = [false, false, false];
    this.message.textContent = '';
    this.trials.replaceChildren();
    this.changed();
  }

  private begin(run: LiveRun): void {
    this.run = run;
    this.steps = { done: 0, total: run.stage.frames };
    this.section?.remove();
    this.section = undefined;
    this.place.replaceChildren(h('p', { class: 'hint' }, `${run.stage.stage} \u2026`));
  }

  private ask(move: Move): void {
    void fetch(`${move}${location.search}`, { method: 'POST' }).catch(() => undefined);
  }

  /** Draws the page soon, once for all that comes until then. */
  private changed(): void {
    if (this.pending) return;
    this.pending = window.setTimeout(() => {
      this.pending = 0;
      this.grow();
      this.show();
    }, kPeriod);
  }

  private grow(): void {
    if (!this.run || this.run.count === 0) return;
    if (!this.section) {
      this.section = new LiveSection(this.run, (move) => this.ask(move));
      this.place.replaceChildren(this.section.element);
    }
    this.section.grow();
  }

  private show(): void {
    const state: State = this.over ? 'over' : this.lost ? 'lost' : !this.run ? 'waiting' : this.paused ? 'paused' : 'running';
    const [kind, text] = kStates[state];
    this.badge.className = `badge ${kind}`;
    this.badge.textContent = text;
    const { stage } = this.run ?? {};
    this.title.textContent = stage ? `${stage.stage} ${stage.title}` : '';
    const done = Math.max(this.run?.hasPath ? 0 : (this.run?.count ?? 0), this.steps.done);
    const total = this.steps.total;
    this.progress.hidden = total === 0;
    this.progress.max = Math.max(1, total);
    this.progress.value = done;
    this.counted.textContent = this.run ? (total > 0 ? `${done} of ${total}` : `${done}`) : '';
    document.title = `${this.counted.textContent} edvo live`.trim();
    this.message.hidden = !this.message.textContent;
    this.section?.show(this.paused, this.over);
  }
}

export function startLive(root: HTMLElement): void {
  new LivePage(root);
}
