import { h, svg } from './dom';
import { isDoubted, type Scenario, type Status } from './data';
import { words } from './format';
import type { Player } from './player';
import { markedKeyframes, valueText, type Quantity } from './quantities';

/** Keyframes as ticks, lost and uncertain frames as bars, one unit wide per frame. */
export function statusStrip(scenario: Scenario): SVGSVGElement | null {
  const statuses = scenario.frames.status;
  if (!statuses) return null;
  const frames = statuses.length;
  const marked = markedKeyframes(scenario);
  const marks = statuses.flatMap((status, i) => {
    if (isDoubted(status)) return [svg('rect', { class: status, x: i, y: 0, width: 1, height: 10 })];
    const width = Math.min(1, frames / 400);
    return marked[i]
      ? [svg('rect', { class: 'key', x: i + 0.5 - width / 2, y: 0, width, height: 10 })]
      : [];
  });
  return svg(
    'svg',
    { class: 'strip', viewBox: `0 0 ${frames} 10`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
    ...marks,
  );
}

export function statusText(scenario: Scenario, frame: number): string {
  const { status: statuses, tracking, estimate } = scenario.frames;
  if (!statuses) return estimate[frame] ? 'tracked' : 'no pose';
  const status = statuses[frame]!;
  const mark = status === 'lost' ? '\u2715' : '?';
  const reason = tracking ? `: ${words(tracking.reason[frame]!)}` : '';
  return [
    isDoubted(status) ? `${mark} ${status}${reason}` : status,
    tracking?.keyframe[frame] ? '\u25C6 keyframe' : '',
  ]
    .filter(Boolean)
    .join(', ');
}

/** The next frame in a direction where something begins. */
function nextEvent(begins: boolean[], frame: number, direction: 1 | -1): number | undefined {
  for (let i = frame + direction; i >= 0 && i < begins.length; i += direction) {
    if (begins[i]) return i;
  }
  return undefined;
}

/** The frame of the greatest value. */
function worst(values: (number | null)[]): number {
  return values.reduce<number>((best, v, i) => ((v ?? -1) > (values[best] ?? -1) ? i : best), 0);
}

function button(label: string, text: string, click: () => void): HTMLButtonElement {
  return h('button', { 'aria-label': label, title: label, click }, text);
}

/** What is shown, and where to go from there. Stays at the bottom of the window. */
export function timeline(scenario: Scenario, player: Player, main: Quantity | undefined): HTMLElement {
  const statuses = scenario.frames.status;
  const keyframes = markedKeyframes(scenario);
  const begins = (sought: Status) =>
    statuses?.map((s, i) => s === sought && statuses[i - 1] !== sought) ?? [];
  const lostBegins = begins('lost');
  const uncertainBegins = begins('uncertain');
  const go = (begins: boolean[], direction: 1 | -1) => () => {
    const frame = nextEvent(begins, player.frame, direction);
    if (frame !== undefined) player.scrub(frame);
  };
  const range = h('input', {
    type: 'range',
    min: 0,
    max: player.last,
    value: 0,
    'aria-label': 'Frame',
    input: () => player.scrub(range.valueAsNumber),
  });
  const play = button('Play', '\u25B6', () => player.toggle());
  const position = h('span', { class: 'position' });
  const status = h('span', { class: 'status' });
  const error = h('span', { class: 'error' });
  player.listen(() => {
    const frame = player.frame;
    const time = player.timestamps[frame]! - player.timestamps[0]!;
    range.valueAsNumber = frame;
    range.setAttribute('aria-valuetext', `frame ${frame}, ${time.toFixed(2)} seconds, ${statusText(scenario, frame)}`);
    position.textContent = `${frame} / ${player.last} \u00B7 ${time.toFixed(2)} s`;
    status.textContent = statusText(scenario, frame);
    status.classList.toggle('is-lost', statuses !== undefined && isDoubted(statuses[frame]!));
    error.textContent = main ? `error ${valueText(main, frame)}` : '';
    play.textContent = player.playing ? '\u275A\u275A' : '\u25B6';
    play.setAttribute('aria-label', player.playing ? 'Pause' : 'Play');
  });
  return h(
    'div',
    { class: 'timeline', role: 'group', 'aria-label': 'Time' },
    h('div', { class: 'track' }, range, statusStrip(scenario)),
    h(
      'div',
      { class: 'controls' },
      play,
      keyframes.some(Boolean) && button('Previous keyframe', '\u25C6\u2039', go(keyframes, -1)),
      keyframes.some(Boolean) && button('Next keyframe', '\u203A\u25C6', go(keyframes, 1)),
      lostBegins.some(Boolean) && button('Next frame at which tracking is lost', '\u203A\u2715', go(lostBegins, 1)),
      uncertainBegins.some(Boolean) &&
        button('Next frame at which the pose is uncertain', '\u203A?', go(uncertainBegins, 1)),
      main && button('Frame of the greatest step error', 'worst step', () =>
        player.scrub(worst(scenario.frames.step_translation_m)),
      ),
      h('div', { class: 'readout' }, position, status, error),
    ),
  );
}
