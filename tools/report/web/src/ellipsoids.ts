import { InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, SphereGeometry, Vector3 } from 'three';
import type { Frames, Pose } from './data';

const kMost = 24; // ellipsoids along the path
const kSigmas = 3;
const kLargest = 0.06; // of the path's extent

/** The matrix that takes the unit sphere to the ellipsoid of one sigma: Cholesky's factor. */
function factorOf([xx, xy, xz, yy, yz, zz]: number[]): Matrix4 {
  const root = (value: number) => Math.sqrt(Math.max(value, 1e-18));
  const a = root(xx!);
  const b = xy! / a;
  const c = xz! / a;
  const d = root(yy! - b * b);
  const e = (yz! - b * c) / d;
  const f = root(zz! - c * c - e * e);
  return new Matrix4().set(a, 0, 0, 0, b, d, 0, 0, c, e, f, 0, 0, 0, 0, 1);
}

/** The uncertainty of positions along the path, enlarged by a power of ten where it is too small to see. */
export class Ellipsoids {
  readonly mesh = new InstancedMesh(
    new SphereGeometry(1, 20, 14),
    new MeshBasicMaterial({ transparent: true, opacity: 0.4, depthTest: false }),
    kMost + 1,
  );
  factor: number | undefined;

  constructor() {
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
    this.mesh.count = 0;
  }

  /** Shows those of frames up to this one. */
  show({ estimate, covariance = [], sigma_m: sigmas = [] }: Frames, frame: number, extent: number): void {
    const shown = sigmas.slice(0, frame + 1).map((sigma) => sigma ?? 0);
    const largest = kSigmas * shown.reduce((most, sigma) => Math.max(most, sigma), 0);
    this.factor = largest > 0 ? Math.max(1, 10 ** Math.floor(Math.log10((kLargest * extent) / largest))) : undefined;
    const stride = Math.max(1, Math.ceil((frame + 1) / kMost));
    const indices = [...Array(Math.ceil((frame + 1) / stride)).keys()].map((i) => i * stride);
    let count = 0;
    for (const i of new Set([...indices, frame])) {
      const [pose, spread] = [estimate[i], covariance[i]];
      if (pose && spread) this.mesh.setMatrixAt(count++, this.matrixOf(pose, spread));
    }
    this.mesh.count = count;
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  remove(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.dispose();
  }

  /** The covariance is of the camera's own axes. */
  private matrixOf(pose: Pose, spread: number[]): Matrix4 {
    const size = kSigmas * (this.factor ?? 1);
    return new Matrix4()
      .compose(new Vector3(pose[0], pose[1], pose[2]), new Quaternion(pose[3], pose[4], pose[5], pose[6]), new Vector3(size, size, size))
      .multiply(factorOf(spread));
  }
}
