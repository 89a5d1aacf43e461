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
  { title: 'Edges', describe: 'of this image', layers: (p) => [p.colour, p.edges] },
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
export class PictureSection {
  readonly element: HTMLElement;
  private readonly which = h('span', { class: 'which' });
  private readonly gallery = h('div', { class: 'gallery' });
  private readonly offered: Kind[];
  private kinds: Kind[] = [];
  private figures: ReturnType<typeof figure>[] = [];
  private shown: Pictures | undefined;

  /** Where titles are given, only those kinds are shown, in that order. */
  constructor(
    private readonly scenario: Scenario,
    private readonly player: Player,
    titles?: string[],
  ) {
    this.offered = titles ? titles.map((title) => kKinds.find((kind) => kind.title === title)!) : kKinds;
    this.element = h(
      'section',
      { class: 'panel pictures', 'aria-label': 'Pictures' },
      h('h3', {}, 'Pictures ', this.which),
      this.gallery,
    );
    this.grow();
    player.listen(() => this.update());
  }

  /** After pictures were added. */
  grow(): void {
    const all = this.scenario.pictures;
    const kinds = this.offered.filter((kind) => this.kinds.includes(kind) || all.some((p) => kind.layers(p).every(Boolean)));
    if (kinds.length > this.kinds.length) {
      this.kinds = kinds;
      this.figures = kinds.map((kind) => figure(kind, all[0]!));
      this.gallery.replaceChildren(...this.figures.map(({ element }) => element));
      this.shown = undefined;
    }
    this.update();
  }

  private update(): void {
    const all = this.scenario.pictures;
    const pictures = all[nearestPictures(all, this.player.frame)];
    if (!pictures) {
      this.which.textContent = 'none yet';
      return;
    }
    this.which.textContent = this.describe(pictures);
    if (pictures === this.shown) return;
    this.shown = pictures;
    for (const { update } of this.figures) update(pictures);
  }

  private describe(pictures: Pictures): string {
    if (pictures.frame === this.player.frame) return `frame ${pictures.frame}`;
    const { stride } = this.scenario;
    const how = stride > 0 ? ` (one in ${stride} has some)` : '';
    return `frame ${pictures.frame}, the nearest with pictures${how}`;
  }
}
