import 'uplot/dist/uPlot.min.css';
import './style.css';
import { h } from './dom';
import type { ReportData } from './data';
import { scrubByKeys } from './keys';
import { startLive } from './live';
import { scenarioSection, type ScenarioSection } from './scenario';
import { badge, verdictTable } from './tables';
import { themeSwitch } from './theme';

/** `#scenario=name&frame=12`: a link to what is shown. */
function readLink(): { scenario: string | null; frame: number } {
  const link = new URLSearchParams(location.hash.slice(1));
  return { scenario: link.get('scenario'), frame: Number(link.get('frame')) || 0 };
}

function writeLink(scenario: string, frame: number): void {
  const link = new URLSearchParams({ scenario, frame: String(frame) });
  history.replaceState(null, '', `#${link}`);
}

function start(data: ReportData, root: HTMLElement): void {
  const passed = data.scenarios.filter((s) => s.passed).length;
  const place = h('main');
  let section: ScenarioSection | undefined;

  const choose = (index: number) => {
    const scenario = data.scenarios[index]!;
    section?.remove();
    section = scenarioSection(scenario);
    place.replaceChildren(section.element);
    verdicts.mark(index);
    let pending = 0;
    section.player.listen(() => {
      clearTimeout(pending); // browsers refuse links that change with every frame
      const frame = section!.player.frame;
      pending = window.setTimeout(() => writeLink(scenario.name, frame), 300);
    });
  };
  const chooseByHand = (index: number) => {
    choose(index);
    place.querySelector('h2')?.scrollIntoView();
  };
  const verdicts = verdictTable(data, chooseByHand);

  root.append(
    h(
      'header',
      { class: 'page-head' },
      h('h1', {}, 'edvo report'),
      badge(passed === data.scenarios.length),
      h('span', {}, `${passed} of ${data.scenarios.length} scenarios passed`),
      h('span', { class: 'generator' }, data.generator),
      themeSwitch(() => section?.recolour()),
    ),
    verdicts.element,
    h(
      'p',
      { class: 'hint' },
      'Arrow keys move from frame to frame, with Shift by ten; the space bar plays.',
    ),
    place,
  );
  const follow = () => {
    const { scenario, frame } = readLink();
    const found = data.scenarios.findIndex((s) => s.name === scenario);
    const firstFailed = data.scenarios.findIndex((s) => !s.passed);
    choose(found >= 0 ? found : Math.max(0, firstFailed));
    section?.player.seek(found >= 0 ? frame : 0);
  };
  follow();
  addEventListener('hashchange', follow);
  scrubByKeys({
    frame: () => section?.player.frame,
    scrub: (frame) => section?.player.scrub(frame),
    toggle: () => section?.player.toggle(),
  });
}

const live = document.getElementById('live');
if (live) {
  startLive(live);
} else {
  const element = document.getElementById('edvo-data')!;
  start(JSON.parse(element.textContent!) as ReportData, document.getElementById('report')!);
}
