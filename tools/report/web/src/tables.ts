import { h } from './dom';
import { isDoubted, type Metric, type ReportData, type Scenario } from './data';
import { boundText, significant, unitOf, words } from './format';
import type { Player } from './player';
import { axisTitle, valueText, type Quantity } from './quantities';

export function badge(passed: boolean): HTMLElement {
  return h('span', { class: `badge ${passed ? 'pass' : 'fail'}` }, passed ? '\u2713 PASS' : '\u2715 FAIL');
}

function mark(holds: boolean | null): HTMLElement | null {
  if (holds === null) return null;
  const text = holds ? '\u2713' : '\u2715';
  return h('span', { role: 'img', 'aria-label': holds ? 'holds' : 'violated', class: holds ? 'holds' : 'breaks' }, text, ' ');
}

function metricCell(metric: Metric | undefined): HTMLTableCellElement {
  const violated = metric?.holds === false;
  return h(
    'td',
    { class: violated ? 'number violated' : 'number' },
    violated && mark(false),
    significant(metric?.value),
  );
}

const kColumns = ['ate_rmse_m', 'rpe_translation_rmse_m', 'rpe_rotation_rmse_deg', 'drift_percent', 'tracked_fraction'];

/** How many of the bounds hold, or why there is no such number. */
function boundsText(scenario: Scenario, bounds: number, held: number): string {
  if (bounds > 0) return `${held} of ${bounds}`;
  return scenario.metrics.some((m) => m.value !== null) ? 'none set' : 'no result';
}

/** One line per scenario; choosing one shows it below. */
export function verdictTable(
  data: ReportData,
  choose: (index: number) => void,
): { element: HTMLElement; mark: (index: number) => void } {
  const columns = kColumns.filter((name) => data.scenarios.some((s) => s.metrics.some((m) => m.name === name)));
  const rows = data.scenarios.map((scenario, i) => {
    const bounded = scenario.metrics.filter((m) => m.holds !== null);
    const held = bounded.filter((m) => m.holds).length;
    return h(
      'tr',
      { click: () => choose(i) },
      h('th', { scope: 'row' }, h('button', { class: 'link' }, scenario.name)),
      h('td', {}, badge(scenario.passed)),
      h('td', { class: 'number' }, boundsText(scenario, bounded.length, held)),
      ...columns.map((name) => metricCell(scenario.metrics.find((m) => m.name === name))),
    );
  });
  const element = h(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Verdicts' },
    h(
      'table',
      { class: 'verdicts' },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          ...['scenario', 'verdict', 'bounds held', ...columns].map((name) => h('th', { scope: 'col' }, words(name))),
        ),
      ),
      h('tbody', {}, ...rows),
    ),
  );
  return {
    element,
    mark: (index) =>
      rows.forEach((row, i) => {
        row.classList.toggle('chosen', i === index);
        row.querySelector('button')?.setAttribute('aria-current', String(i === index));
      }),
  };
}

/** How much of an upper bound is used. */
function usedShare({ value, max }: Metric): string {
  return value === null || max === null || max <= 0 ? '' : `${((100 * value) / max).toFixed(0)} %`;
}

/** Those of another kind of tracker are left out: neither measured nor bounded. */
function ownMetrics({ metrics }: Scenario): Metric[] {
  return metrics.filter(({ value, holds }) => value !== null || holds !== null);
}

export function metricTable(scenario: Scenario): HTMLElement {
  const rows = ownMetrics(scenario).map((metric) =>
    h(
      'tr',
      { class: metric.holds === false ? 'violated' : '' },
      h('th', { scope: 'row' }, h('code', {}, metric.name)),
      h('td', { class: 'number' }, `${significant(metric.value)} ${unitOf(metric.name)}`),
      h('td', { class: 'bound' }, mark(metric.holds), boundText(metric)),
      h('td', { class: 'number' }, usedShare(metric)),
    ),
  );
  const heads = ['metric', 'measured', 'bound', 'used'];
  return h(
    'div',
    { class: 'scroll' },
    h(
      'table',
      { class: 'metrics' },
      h('thead', {}, h('tr', {}, ...heads.map((head) => h('th', { scope: 'col' }, head)))),
      h('tbody', {}, ...rows),
    ),
  );
}

/** How many frames are lost or uncertain, and why; null where none is. */
export function doubtSummary(scenario: Scenario): HTMLElement | null {
  const { status = [], tracking } = scenario.frames;
  const sentences = (['lost', 'uncertain'] as const).flatMap((kind) => {
    const counts = new Map<string, number>();
    status.forEach((s, i) => {
      const reason = tracking?.reason[i];
      if (s === kind && reason) counts.set(reason, (counts.get(reason) ?? 0) + 1);
    });
    const total = status.filter((s) => s === kind).length;
    const reasons = [...counts].sort((a, b) => b[1] - a[1]).map(([name, count]) => `${words(name)} ${count}`);
    const why = reasons.length > 0 ? `: ${reasons.join(', ')}` : '';
    return total > 0 ? [`${total} of ${status.length} frames are ${kind}${why}.`] : [];
  });
  return sentences.length > 0 ? h('p', { class: 'note' }, sentences.join(' ')) : null;
}

/** All that is known of the frame that is shown. */
export function frameFacts(scenario: Scenario, player: Player, all: Quantity[]): HTMLElement {
  const { status, tracking } = scenario.frames;
  const list = h('dl', { class: 'facts' });
  player.listen(() => {
    const frame = player.frame;
    const facts: [string, string][] = [
      ['Time stamp', `${player.timestamps[frame]!.toFixed(4)} s`],
      ...(status ? ([['Status', words(status[frame]!)]] as [string, string][]) : []),
      ...(tracking
        ? ([
            ...(status && isDoubted(status[frame]!)
              ? [[`${words(status[frame]!)} because`, words(tracking.reason[frame]!)]]
              : []),
            ['Keyframe', tracking.keyframe[frame] ? 'yes' : 'no'],
            ...(status?.[frame] === 'initialized'
              ? []
              : [['Alignment ended', words(tracking.termination[frame]!)]]),
          ] as [string, string][])
        : []),
      ...all.map((q): [string, string] => [axisTitle(q).replace(/, [^,]*$/, ''), valueText(q, frame)]),
    ];
    list.replaceChildren(...facts.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))));
  });
  return list;
}

/** Every option; those that differ from the preset first in the eye, the others on demand. */
export function optionTable(scenario: Scenario): HTMLElement | null {
  if (scenario.options.length === 0) return null;
  const body = h('tbody');
  const filter = h('input', { type: 'search', placeholder: 'filter by name or meaning', 'aria-label': 'Filter options', input: () => fill() });
  const changedOnly = h('input', { type: 'checkbox', checked: true, change: () => fill() });
  const count = h('output', { class: 'count' });
  const fill = () => {
    const wanted = filter.value.toLowerCase();
    const shown = scenario.options.filter(
      (o) =>
        (!changedOnly.checked || o.value !== o.preset) && `${o.key} ${o.help}`.toLowerCase().includes(wanted),
    );
    count.textContent = `${shown.length} of ${scenario.options.length}`;
    body.replaceChildren(
      ...shown.map((o) =>
        h(
          'tr',
          { class: o.value === o.preset ? '' : 'changed' },
          h('th', { scope: 'row' }, h('code', {}, o.key)),
          h('td', {}, h('code', {}, o.value)),
          h('td', {}, h('code', {}, o.value === o.preset ? '' : o.preset)),
          h('td', {}, o.help),
        ),
      ),
    );
  };
  fill();
  const heads = ['option', 'value', 'preset', 'meaning'];
  return h(
    'details',
    { class: 'panel options' },
    h('summary', {}, h('h3', {}, 'Options')),
    h('div', { class: 'bar' }, filter, h('label', {}, changedOnly, ' only what differs from the preset'), count),
    h(
      'div',
      { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Options' },
      h('table', {}, h('thead', {}, h('tr', {}, ...heads.map((head) => h('th', { scope: 'col' }, head)))), body),
    ),
  );
}

/** The command that repeats the run, ready to be copied, and the folder it belongs in. */
export function commandLine({ command, folder }: Scenario): HTMLElement {
  const copy = h(
    'button',
    {
      click: () => {
        const done = () => (copy.textContent = 'copied');
        navigator.clipboard?.writeText(command).then(done, select);
      },
    },
    'copy',
  );
  const code = h('code', {}, command);
  const select = () => getSelection()?.selectAllChildren(code);
  return h('p', { class: 'command' }, 'Repeat in ', h('code', {}, folder), ': ', code, ' ', copy);
}
