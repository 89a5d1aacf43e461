import type { Pictures, Pose, Scenario } from './data';
import type { LiveFrame, LivePath, LiveStage } from './live_data';

const kMostPictures = 96; // sets of pictures that the page keeps

function distance(a: Pose, b: Pose): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** The standard deviation of a position, m; null where it is not known. */
function sigmaOf({ position_covariance: [xx, , , yy, , zz], status }: LiveFrame): number | null {
  const sum = (xx ?? NaN) + (yy ?? NaN) + (zz ?? NaN);
  return status === 'lost' || !Number.isFinite(sum) || sum <= 0 ? null : Math.sqrt(sum);
}

/** An empty scenario of the report's form, to which frames are added. */
function emptyScenario(stage: LiveStage): Scenario {
  return {
    name: stage.title,
    why: '',
    folder: '',
    command: '',
    passed: true,
    alignment: 'none',
    metrics: [],
    notes: [],
    options: [],
    ...(stage.camera ? { camera: stage.camera } : {}),
    frames: {
      timestamp: [], truth: [], estimate: [], aligned: [], position_m: [], rotation_deg: [],
      step_translation_m: [], step_rotation_deg: [], sigma_m: [], covariance: [], status: [],
      tracking: {
        reason: [], keyframe: [], termination: [], iterations: [], points: [], visible_fraction: [],
        correlation: [], cost: [], moving_fraction: [],
      },
    },
    stride: 0,
    pictures: [],
    times: { pyramid_ms: [], edges_ms: [], alignment_ms: [], mapping_ms: [] },
  };
}

/** One stage of a run as far as it has been told, in the form that the report's parts show. */
export class LiveRun {
  readonly scenario: Scenario;
  hasPath = false; // whether all frames were known beforehand

  constructor(readonly stage: LiveStage) {
    this.scenario = emptyScenario(stage);
  }

  get count(): number {
    return this.scenario.frames.timestamp.length;
  }

  /** The frame that the run has come to. */
  get latest(): number {
    return this.hasPath ? (this.scenario.pictures.at(-1)?.frame ?? 0) : Math.max(0, this.count - 1);
  }

  /** All frames at once, of which nothing but the pose is known. */
  addPath({ timestamps, poses }: LivePath): void {
    const { frames } = this.scenario;
    this.hasPath = true;
    const empty = [frames.estimate, frames.aligned, frames.position_m, frames.rotation_deg, frames.step_translation_m, frames.step_rotation_deg];
    timestamps.forEach((timestamp, i) => {
      frames.timestamp.push(timestamp);
      frames.truth.push(poses[i]!);
      for (const values of empty) values.push(null);
    });
    delete frames.status;
    delete frames.tracking;
    delete frames.sigma_m;
    delete frames.covariance;
    delete this.scenario.times;
  }

  add(frame: LiveFrame): void {
    const { frames, times } = this.scenario;
    const tracking = frames.tracking!;
    frames.timestamp.push(frame.timestamp);
    frames.truth.push(frame.truth);
    frames.estimate.push(frame.pose);
    frames.aligned.push(null);
    frames.position_m.push(frame.pose && frame.truth ? distance(frame.pose, frame.truth) : null);
    for (const empty of [frames.rotation_deg, frames.step_translation_m, frames.step_rotation_deg]) empty.push(null);
    frames.sigma_m!.push(sigmaOf(frame));
    frames.covariance!.push(sigmaOf(frame) === null ? null : (frame.position_covariance as number[]));
    frames.status!.push(frame.status);
    tracking.reason.push(frame.reason);
    tracking.keyframe.push(frame.keyframe);
    tracking.termination.push(frame.termination);
    tracking.iterations.push(frame.iterations);
    tracking.points.push(frame.points);
    tracking.visible_fraction.push(frame.visible_fraction ?? 0);
    tracking.correlation.push(frame.correlation ?? 0);
    tracking.cost.push(frame.cost ?? 0);
    tracking.moving_fraction.push(frame.moving_fraction ?? 0);
    const [pyramid, edges, alignment, mapping] = frame.times_ms;
    times!.pyramid_ms.push(pyramid);
    times!.edges_ms.push(edges);
    times!.alignment_ms.push(alignment);
    times!.mapping_ms!.push(mapping);
  }

  /** Every other one of the older pictures goes where there are too many. */
  addPictures(pictures: Pictures): void {
    const all = this.scenario.pictures;
    all.push(pictures);
    if (all.length > kMostPictures) {
      const recent = all.length / 2;
      all.splice(0, all.length, ...all.filter((_, i) => i >= recent || i % 2 === 0));
    }
  }
}
