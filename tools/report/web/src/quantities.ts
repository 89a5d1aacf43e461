import type { Scenario } from './data';

/** What can be drawn over time. */
export interface Quantity {
  label: string;
  unit: string;
  values: (number | null)[];
  digits: number;
}

function scaled(values: (number | null)[], factor: number): (number | null)[] {
  return values.map((value) => (value === null ? null : value * factor));
}

/** All quantities of which there is at least one value. */
export function quantities(scenario: Scenario): Quantity[] {
  const { frames, times } = scenario;
  const { status, tracking } = frames;
  const aligned = status?.map((s) => s !== 'initialized') ?? [];
  const whereAligned = (values: number[] | undefined) =>
    (values ?? []).map((value, i) => (aligned[i] ? value : null));
  const moving = tracking?.moving_fraction ?? [];
  const whereAnyMoves = moving.some((share) => share > 0) ? whereAligned(moving) : [];
  const whereAny = (values: number[] = []) => (values.some((value) => value > 0) ? values : []);
  const all: Quantity[] = [
    { label: 'Position error', unit: 'mm', values: scaled(frames.position_m, 1000), digits: 2 },
    {
      label: 'Error of each step',
      unit: 'mm',
      values: scaled(frames.step_translation_m, 1000),
      digits: 2,
    },
    { label: 'Rotation error', unit: 'deg', values: frames.rotation_deg, digits: 3 },
    {
      label: 'Rotation error of each step',
      unit: 'deg',
      values: frames.step_rotation_deg,
      digits: 3,
    },
    {
      label: 'Position uncertainty, one sigma',
      unit: 'mm',
      values: scaled(frames.sigma_m ?? [], 1000),
      digits: 2,
    },
    { label: 'Correlation', unit: '', values: whereAligned(tracking?.correlation), digits: 4 },
    {
      label: 'Points in view',
      unit: '%',
      values: scaled(whereAligned(tracking?.visible_fraction), 100),
      digits: 1,
    },
    { label: 'Moving by itself', unit: '% of the view', values: scaled(whereAnyMoves, 100), digits: 1 },
    { label: 'Points', unit: '', values: whereAligned(tracking?.points), digits: 0 },
    { label: 'Iterations', unit: '', values: whereAligned(tracking?.iterations), digits: 0 },
    { label: 'Cost per point', unit: '', values: whereAligned(tracking?.cost), digits: 3 },
    { label: 'Pyramid (time)', unit: 'ms', values: times?.pyramid_ms ?? [], digits: 2 },
    { label: 'Edges (time)', unit: 'ms', values: times?.edges_ms ?? [], digits: 2 },
    { label: 'Alignment (time)', unit: 'ms', values: times?.alignment_ms ?? [], digits: 2 },
    { label: 'Mapping (time)', unit: 'ms', values: whereAny(times?.mapping_ms), digits: 2 },
  ];
  return all.filter(({ values }) => values.some((value) => value !== null));
}

export function axisTitle({ label, unit }: Quantity): string {
  return unit ? `${label}, ${unit}` : label;
}

export function valueText({ values, unit, digits }: Quantity, frame: number): string {
  const value = values[frame];
  return value === null || value === undefined ? '\u2013' : `${value.toFixed(digits)} ${unit}`.trim();
}

/** Which frames are keyframes, none where most are: marks would cover everything. */
export function markedKeyframes(scenario: Scenario): boolean[] {
  const keyframe = scenario.frames.tracking?.keyframe ?? [];
  return keyframe.filter(Boolean).length > keyframe.length / 2 ? [] : keyframe;
}
