import { h } from './dom';
import type { Pictures, Scenario, ValuePicture } from './data';
import { significant } from './format';
import type { Player } from './player';

interface Kind {
  title: string;
  describe: string;
  layers: (p: Pictures) => (string | undefined)[];
  scale?: (p: Pictures) => ValuePicture | undefined;
  unit?: string;
}

const kKinds: Kind[] = [
  { title: 'Colour', describe: 'the image as measured', layers: (p) => [p.colour] },
  { title: 'Edges', describe: 'of this image, in yellow', layers: (p) => [p.colour, p.edges] },
  {
    title: 'Depth',
    describe: 'near is bright, no measurement grey',
    layers: (p) => [p.depth?.webp],
    scale: (p) => p.depth,
    unit: 'm',
  },
  {
    title: 'Residual before',
    describe: 'red brighter, blue darker',
    layers: (p) => [p.residual_before],
  },
  {
    title: 'Residual after',
    describe: 'white equal, yellow out of view',
    layers: (p) => [p.residual_after],
  },
  {
    title: 'Inverse depth, estimated',
    describe: 'from images alone; near is bright',
    layers: (p) => [p.inverse_depth?.webp],
    scale: (p) => p.inverse_depth,
    unit: '1/m',
  },
  {
    title: 'Inverse depth, true',
    describe: 'in the same colours',
    layers: (p) => [p.inverse_depth_truth?.webp],
    scale: (p) => p.inverse_depth_truth,
    unit: '1/m',
  },
];

/** The index of the frame's own pictures, or of the nearest frame that has some. */
export function nearestPictures(all: Pictures[], frame: number): number {
  let nearest = 0;
  all.forEach((candidate, i) => {
    if (Math.abs(candidate.frame - frame) < Math.abs(all[nearest]!.frame - frame)) nearest = i;
  });
  return nearest;
}

function show(image: HTMLImageElement, webp: string | undefined): void {
  if (webp) {
    image.src = `data:image/webp;base64,${webp}`;
  } else {
    image.removeAttribute('src');
  }
}

function colourBar(value: ValuePicture | undefined, unit: string | undefined): Node[] {
  if (!value) return [];
  return [
    h('span', {}, `${significant(value.dark)} ${unit}`),
    h('span', { class: 'viridis', 'aria-hidden': 'true' }),
    h('span', {}, `${significant(value.bright)} ${unit}`),
  ];
}

/** One kind of picture; a click enlarges it. */
function figure(kind: Kind, first: Pictures): { element: HTMLElement; update: (p: Pictures) => void } {
  const [width, height] = first.size;
  const layers = kind.layers(first).map((_, i) =>
    h('img', { alt: i === 0 ? `${kind.title}: ${kind.describe}` : '', width, height, class: `layer${i}` }),
  );
  const none = h('span', { class: 'none' }, 'none at this frame');
  const button = h(
    'button',
    {
      class: `picture${layers.length > 1 ? ' layered' : ''}`,
      'aria-pressed': 'false',
      'aria-label': `Enlarge ${kind.title}`,
      style: `aspect-ratio:${width}/${height}`,
      click: () => {
        const wide = element.classList.toggle('wide');
        button.setAttribute('aria-pressed', String(wide));
      },
    },
    ...layers,
    none,
  );
  const bar = h('div', { class: 'colour-bar' });
  const element = h(
    'figure',
    {},
    h('figcaption', {}, h('b', {}, kind.title), ' ', h('small', {}, kind.describe)),
    button,
    bar,
  );
  return {
    element,
    update: (pictures) => {
      const files = kind.layers(pictures);
      layers.forEach((layer, i) => show(layer, files[i]));
      button.classList.toggle('empty', !files[0]);
      bar.replaceChildren(...colourBar(kind.scale?.(pictures), kind.unit));
    },
  };
}

/** The pictures of the frame that is shown, or of the nearest that has some. */
export function pictureSection(scenario: Scenario, player: Player): HTMLElement | null {
  const all = scenario.pictures;
  if (all.length === 0) return null;
  const kinds = kKinds.filter((kind) => all.some((p) => kind.layers(p).every(Boolean)));
  const figures = kinds.map((kind) => figure(kind, all[0]!));
  const which = h('span', { class: 'which' });
  let shown = -1;
  player.listen(() => {
    const index = nearestPictures(all, player.frame);
    const pictures = all[index]!;
    const own = pictures.frame === player.frame;
    which.textContent = own
      ? `frame ${pictures.frame}`
      : `frame ${pictures.frame}, the nearest with pictures (one in ${scenario.stride} has some)`;
    if (index === shown) return;
    shown = index;
    for (const { update } of figures) update(pictures);
  });
  return h(
    'section',
    { class: 'panel pictures', 'aria-label': 'Pictures' },
    h('h3', {}, 'Pictures ', which),
    h('div', { class: 'gallery' }, ...figures.map(({ element }) => element)),
  );
}
