/** The form of the report's data, version 2; written by tools/report/report_data.cpp. */
export interface ReportData {
  schema: 'edvo-report';
  version: 2;
  generator: string;
  scenarios: Scenario[];
}

export interface Scenario {
  name: string;
  why: string; // what would break the bounds
  folder: string; // where the command was given
  command: string; // repeats the run
  tracker?: string; // command of a tracker that is not ours
  passed: boolean;
  problem?: string; // why there is no result, or what is wrong beside the bounds
  alignment: 'none' | 'se3' | 'sim3'; // fitted before the absolute error is taken
  metrics: Metric[];
  notes: string[];
  options: Option[];
  camera?: Camera;
  frames: Frames;
  stride: number; // frames from picture to picture
  pictures: Pictures[];
  cloud?: Cloud;
  times?: Times;
}

export interface Metric {
  name: string; // ends in its unit
  value: number | null; // null: could not be measured
  min: number | null; // null: not bounded
  max: number | null;
  holds: boolean | null; // null: no bound
}

export interface Option {
  key: string;
  value: string;
  preset: string; // what it is when the scenario says nothing
  help: string;
}

export interface Camera {
  width: number; // px
  height: number; // px
  fx: number; // px
  fy: number; // px, negative where the camera's y axis points up
  cx: number; // px
  cy: number; // px
}

/** tx, ty, tz (m), qx, qy, qz, qw of T_world_camera; camera x right, y down, z forward. */
export type Pose = [number, number, number, number, number, number, number];

/** One element per frame in each array; null where there is nothing. */
export interface Frames {
  timestamp: number[]; // s
  truth: (Pose | null)[];
  estimate: (Pose | null)[]; // as tracked
  aligned: (Pose | null)[]; // as scored
  position_m: (number | null)[]; // of the aligned estimate
  rotation_deg: (number | null)[]; // of the aligned estimate
  step_translation_m: (number | null)[]; // of the motion since the frame before
  step_rotation_deg: (number | null)[];
  sigma_m?: (number | null)[]; // standard deviation of the estimate's position; while it runs alone
  covariance?: (number[] | null)[]; // upper triangle of that of the position, camera's frame, m^2
  status?: Status[];
  tracking?: Tracking; // absent for a tracker that is not ours
}

/** Returns whether there is no pose, or one that must not be relied on. */
export const isDoubted = (status: Status): boolean => status === 'lost' || status === 'uncertain';

export type Status = 'initialized' | 'tracked' | 'uncertain' | 'lost';

export interface Tracking {
  reason: string[]; // why it is lost or uncertain, or 'none'
  keyframe: boolean[];
  termination: string[]; // why the alignment ended
  iterations: number[];
  points: number[];
  visible_fraction: number[];
  correlation: number[];
  cost: number[];
  moving_fraction: number[]; // share of the view that moves by itself; 0 where none is looked for
}

/** WebP files in base64, all of one size. */
export interface Pictures {
  frame: number;
  size: [number, number]; // px
  colour?: string;
  edges?: string; // transparent but for the edges
  depth?: ValuePicture; // m
  residual_before?: string; // where the alignment started
  residual_after?: string;
  inverse_depth?: ValuePicture; // 1/m, estimated from images alone
  inverse_depth_truth?: ValuePicture; // 1/m, in the same colours
}

export interface ValuePicture {
  webp: string;
  dark: number; // value of the darkest colour
  bright: number; // value of the brightest colour
}

export interface Cloud {
  count: number;
  origin: [number, number, number]; // m, world
  step: number; // m
  positions: string; // base64 of int16 x, y, z of each point, little-endian: origin + step * n
  colours: string; // base64 of uint8 r, g, b of each point
}

/** Diagnostic: differs from run to run. */
export interface Times {
  pyramid_ms: number[];
  edges_ms: number[];
  alignment_ms: number[];
  mapping_ms?: number[];
}
