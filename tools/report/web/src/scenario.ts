import { Chart } from './chart';
import { h } from './dom';
import type { Scenario } from './data';
import { PictureSection } from './pictures';
import { Player } from './player';
import { markedKeyframes, quantities, type Quantity } from './quantities';
import { SceneView, type ViewMode } from './scene';
import { badge, commandLine, doubtSummary, frameFacts, metricTable, optionTable } from './tables';
import { timeline } from './timeline';
import { TopView } from './top_view';

const kAlignment = {
  none: 'without any alignment',
  se3: 'after a rigid alignment (SE(3))',
  sim3: 'after an alignment with scale (Sim(3))',
};

const kAlignedBy = { none: 'not aligned', se3: 'aligned by SE(3)', sim3: 'aligned by Sim(3)' };

/** One scenario's part of the page. */
export interface ScenarioSection {
  element: HTMLElement;
  player: Player;
  recolour: () => void;
  remove: () => void;
}

function legend(scenario: Scenario): HTMLElement {
  const entry = (name: string, text: string) => h('span', {}, h('i', { class: `swatch ${name}` }), text);
  return h(
    'p',
    { class: 'legend' },
    entry('truth', 'truth'),
    entry('estimate', 'estimate'),
    markedKeyframes(scenario).some(Boolean) && entry('key', 'keyframe'),
  );
}

/** Radio buttons in a row; `choose` gets the index. */
function choice(name: string, labels: string[], choose: (index: number) => void): HTMLElement {
  return h(
    'fieldset',
    { class: 'choice' },
    h('legend', {}, name),
    ...labels.map((label, i) =>
      h('label', {}, h('input', { type: 'radio', name, checked: i === 0, change: () => choose(i) }), h('span', {}, label)),
    ),
  );
}

export function makeScene(scenario: Scenario, player: Player): { scene: SceneView | undefined; element: HTMLElement } {
  try {
    const scene = new SceneView(scenario, player);
    return { scene, element: scene.element };
  } catch {
    return {
      scene: undefined,
      element: h('p', { class: 'scene absent' }, 'The 3D view needs WebGL, which this browser does not offer.'),
    };
  }
}

function trajectories(scenario: Scenario, player: Player): { element: HTMLElement; scene: SceneView | undefined } {
  const top = new TopView(scenario, player);
  const { scene, element } = makeScene(scenario, player);
  const { estimate, aligned } = scenario.frames;
  const modes: ViewMode[] = ['around', 'camera'];
  const isScored = aligned.some(Boolean);
  const show = (poses: typeof estimate) => {
    top.show(poses);
    scene?.show(poses);
  };
  if (isScored) show(aligned);
  const cloudBox = h('input', { type: 'checkbox', checked: true, change: () => scene?.setCloud(cloudBox.checked) });
  const controls = h(
    'div',
    { class: 'bar' },
    isScored
      ? choice('Estimate', [`as scored: ${kAlignedBy[scenario.alignment]}`, 'as tracked: not aligned'], (i) =>
          show(i === 0 ? aligned : estimate),
        )
      : h('span', {}, 'Estimate as tracked: not aligned'),
    scene && choice('View', ['around', 'through camera'], (i) => scene.setMode(modes[i]!)),
    scene && scenario.cloud && h('label', {}, cloudBox, ' scene'),
    scene && h('button', { click: () => scene.reset() }, 'reset view'),
  );
  const section = h(
    'section',
    { class: 'panel trajectories', 'aria-label': 'Trajectory' },
    h('h3', {}, 'Trajectory'),
    legend(scenario),
    controls,
    h('div', { class: 'views' }, element, top.element),
  );
  return { element: section, scene };
}

function chartSection(scenario: Scenario, player: Player, all: Quantity[]): { element: HTMLElement | null; charts: Chart[] } {
  if (all.length === 0) return { element: null, charts: [] };
  const charts = [0, Math.min(1, all.length - 1)].map((first) => new Chart(scenario, player, all, first));
  const element = h(
    'section',
    { class: 'panel charts', 'aria-label': 'Over time' },
    h('h3', {}, 'Over time'),
    h(
      'p',
      { class: 'hint' },
      'Click to see a frame, drag to zoom, double-click to zoom out. ',
      scenario.frames.tracking && 'Orange ticks are keyframes (none where most frames are). ',
      'Shaded frames are lost or uncertain.',
      ` Position and rotation errors are taken ${kAlignment[scenario.alignment]}; errors of a step need none.`,
    ),
    ...charts.map((chart) => chart.element),
  );
  return { element, charts };
}

function timesNote(scenario: Scenario): HTMLElement | null {
  if (!scenario.times) return null;
  return h(
    'p',
    { class: 'diagnostic' },
    'This report holds times of each stage. They are diagnostic: they differ from run to run, and so do the bytes of this file.',
  );
}

export function scenarioSection(scenario: Scenario): ScenarioSection {
  const player = new Player(scenario.frames.timestamp);
  const heading = h(
    'header',
    { class: 'scenario-head' },
    h('h2', { tabindex: -1 }, scenario.name, ' ', badge(scenario.passed)),
    h('p', { class: 'why' }, scenario.why),
    scenario.tracker && h('p', { class: 'tracker' }, 'Tracker: ', h('code', {}, scenario.tracker)),
    scenario.problem && h('p', { class: 'problem', role: 'alert' }, scenario.problem),
  );
  const measured = h(
    'section',
    { class: 'panel', 'aria-label': 'Metrics' },
    h('h3', {}, 'Metrics'),
    metricTable(scenario),
    h('p', { class: 'hint' }, `Absolute errors are taken ${kAlignment[scenario.alignment]}.`),
    doubtSummary(scenario),
    ...scenario.notes.map((note) => h('p', { class: 'note' }, note)),
    timesNote(scenario),
    commandLine(scenario),
  );
  if (player.timestamps.length === 0) {
    const element = h('section', { class: 'scenario' }, heading, measured, optionTable(scenario));
    return { element, player, recolour: () => undefined, remove: () => player.stop() };
  }
  const all = quantities(scenario);
  const paths = trajectories(scenario, player);
  const { element: charts, charts: plots } = chartSection(scenario, player, all);
  const facts = h(
    'section',
    { class: 'panel', 'aria-label': 'Frame' },
    h('h3', {}, 'Frame'),
    frameFacts(scenario, player, all),
  );
  const element = h(
    'section',
    { class: 'scenario' },
    heading,
    h('div', { class: 'columns' }, h('div', {}, measured, facts), h('div', {}, paths.element)),
    charts,
    scenario.pictures.length > 0 && new PictureSection(scenario, player).element,
    optionTable(scenario),
    timeline(scenario, player, all.find((q) => q.label === 'Position error')),
  );
  return {
    element,
    player,
    recolour: () => {
      paths.scene?.recolour();
      plots.forEach((plot) => plot.draw());
    },
    remove: () => {
      player.stop();
      paths.scene?.remove();
      plots.forEach((plot) => plot.remove());
    },
  };
}
