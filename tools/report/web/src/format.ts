import type { Metric } from './data';

const kUnits: [RegExp, string][] = [
  [/_m$/, 'm'],
  [/_deg$/, 'deg'],
  [/_percent$/, '%'],
];

export function unitOf(metric: string): string {
  return kUnits.find(([ending]) => ending.test(metric))?.[1] ?? '';
}

/** Four significant digits, no exponent where it can be helped. */
export function significant(value: number | null | undefined): string {
  if (value === null || value === undefined) return '\u2013';
  if (value !== 0 && Math.abs(value) < 1e-4) return value.toExponential(2);
  return String(Number(value.toPrecision(4)));
}

export function boundText(metric: Metric): string {
  const parts = [];
  if (metric.min !== null) parts.push(`\u2265 ${significant(metric.min)}`);
  if (metric.max !== null) parts.push(`\u2264 ${significant(metric.max)}`);
  return parts.join(', ');
}

/** A name of the program's in words: too_few_points, too few points. */
export function words(name: string): string {
  return name.replaceAll('_', ' ');
}
