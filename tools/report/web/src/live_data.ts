import type { Camera, Pictures, Pose, Status } from './data';

/** What a run tells its page, version 1, as server-sent events; written by tools/watch. */
export interface LiveEvents {
  stage: LiveStage; // a stage begins, its frames count from 0
  path: LivePath; // of a stage whose frames are all known beforehand, like those to render
  frame: LiveFrame; // every frame, in order
  pictures: Pictures; // of the latest frame that pictures were drawn of; may be missed
  progress: LiveProgress; // of a stage that has no frames; may be missed
  gate: LiveGate; // a viewer has paused the run or let it go on
  trial: LiveTrial; // a scenario of a test is done
  problem: LiveProblem; // pictures cannot be drawn
  end: LiveEnd; // the run is over
}

export interface LiveStage {
  schema: 'edvo-live';
  version: 1;
  stage: string; // what is done: tracking, rendering, testing
  title: string; // with what
  frames: number; // how many there will be; 0: not known
  camera: Camera | null;
}

export interface LivePath {
  timestamps: number[]; // s
  poses: Pose[]; // T_world_camera of each frame, exact
}

export interface LiveFrame {
  frame: number;
  timestamp: number; // s
  pose: Pose | null; // of the estimate; null where it is lost
  truth: Pose | null; // null where it is not known in the world of the estimate
  status: Status;
  reason: string; // why it is lost or uncertain, or 'none'
  keyframe: boolean;
  termination: string; // why the alignment ended
  iterations: number;
  points: number;
  visible_fraction: number | null;
  correlation: number | null;
  cost: number | null;
  moving_fraction: number | null;
  position_covariance: Covariance; // of the camera's own frame
  times_ms: [number, number, number, number]; // pyramid, edges, alignment, mapping
}

/** The upper triangle, row by row, of a covariance of a position, m^2. */
export type Covariance = (number | null)[];

export interface LiveProgress {
  done: number;
  total: number;
}

export interface LiveGate {
  paused: boolean;
}

export interface LiveTrial {
  name: string;
  verdict: string;
  text: string;
}

export interface LiveProblem {
  text: string;
}

export interface LiveEnd {
  how: string;
  frames_without_pictures: number;
}
