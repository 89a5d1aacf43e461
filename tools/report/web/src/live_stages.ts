import { h } from './dom';
import type { Scenario } from './data';
import type { Player } from './player';

function median(values: number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? 0;
}

const kRecent = 200; // frames over which medians and the scale of the bars are taken

/** The time of each stage of the frame that is shown, beside its median. */
export function stageTimes(scenario: Scenario, player: Player): HTMLElement {
  const { pyramid_ms, edges_ms, alignment_ms, mapping_ms } = scenario.times!;
  const stages: [string, number[]][] = [
    ['pyramid', pyramid_ms],
    ['edges', edges_ms],
    ['alignment', alignment_ms],
    ['mapping', mapping_ms!],
  ];
  const rows = h('tbody');
  player.listen(() => {
    const frame = player.frame;
    const recent = (values: number[]) => values.slice(Math.max(0, frame - kRecent), frame + 1);
    const shown = stages.filter(([, values]) => values.some((value) => value > 0));
    const total = (i: number) => shown.reduce((sum, [, values]) => sum + (values[i] ?? 0), 0);
    const typical = median(recent(pyramid_ms.map((_, i) => total(i))));
    const longest = Math.max(1.5 * typical, total(frame), 1e-3);
    const row = (name: string, now: number, usual: number, kind: string) =>
      h(
        'tr',
        { class: kind },
        h('th', { scope: 'row' }, name),
        h(
          'td',
          { class: 'time-cell' },
          h(
            'div',
            { class: 'time-bar' },
            h('i', { style: `width:${((100 * now) / longest).toFixed(1)}%` }),
            h('b', { style: `left:${Math.min(99, (100 * usual) / longest).toFixed(1)}%` }),
          ),
        ),
        h('td', { class: 'number' }, now.toFixed(2)),
        h('td', { class: 'number' }, usual.toFixed(2)),
      );
    rows.replaceChildren(
      ...shown.map(([name, values]) => row(name, values[frame] ?? 0, median(recent(values)), '')),
      row('total', total(frame), typical, 'total'),
    );
  });
  const heads = ['stage', '', 'now', 'median'];
  return h(
    'section',
    { class: 'panel', 'aria-label': 'Time per stage' },
    h('h3', {}, 'Time per stage ', h('span', { class: 'which' }, 'ms; the mark is the median')),
    h(
      'table',
      { class: 'stage-times' },
      h('thead', {}, h('tr', {}, ...heads.map((head) => h('th', { scope: 'col' }, head)))),
      rows,
    ),
  );
}
