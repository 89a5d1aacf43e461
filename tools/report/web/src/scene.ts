import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, PerspectiveCamera,
  Points, PointsMaterial, Quaternion, Scene, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { decodeBase64, h, themeColour } from './dom';
import type { Cloud, Pose, Scenario } from './data';
import { Ellipsoids } from './ellipsoids';
import { imageCorners, rotated, upAxis } from './geometry';
import type { Player } from './player';

const kTurn = Math.PI / 24; // of one key press
const kZoom = 0.9;

export type ViewMode = 'around' | 'camera';

function cloudPoints(cloud: Cloud): { positions: Float32Array; colours: Float32Array } {
  const bytes = decodeBase64(cloud.positions);
  const units = new DataView(bytes.buffer);
  const positions = new Float32Array(3 * cloud.count);
  for (let i = 0; i < positions.length; ++i) {
    positions[i] = cloud.origin[i % 3]! + cloud.step * units.getInt16(2 * i, true);
  }
  const colour = new Color();
  const rgb = decodeBase64(cloud.colours);
  const colours = new Float32Array(3 * cloud.count);
  for (let i = 0; i < rgb.length; i += 3) {
    colour.setRGB(rgb[i]! / 255, rgb[i + 1]! / 255, rgb[i + 2]! / 255, 'srgb').toArray(colours, i);
  }
  return { positions, colours };
}

/** A path as thick segments between frames that follow each other, drawn up to a frame. */
class Path {
  readonly line: LineSegments2;
  private readonly ends: number[] = []; // frame at which each segment ends

  constructor(poses: (Pose | null)[], width: number) {
    const corners: number[] = [];
    for (let i = 1; i < poses.length; ++i) {
      const [from, to] = [poses[i - 1], poses[i]];
      if (from && to) {
        corners.push(from[0], from[1], from[2], to[0], to[1], to[2]);
        this.ends.push(i);
      }
    }
    const geometry = new LineSegmentsGeometry().setPositions(corners.length ? corners : [0, 0, 0, 0, 0, 0]);
    this.line = new LineSegments2(geometry, new LineMaterial({ linewidth: width, depthTest: false, transparent: true }));
    this.line.frustumCulled = false;
  }

  upTo(frame: number): void {
    const count = this.ends.filter((end) => end <= frame).length;
    this.line.geometry.instanceCount = count;
    this.line.visible = count > 0;
  }

  remove(): void {
    this.line.geometry.dispose();
    this.line.material.dispose();
  }
}

/** The pyramid that a camera sees, its top edge marked. */
function frustum(scenario: Scenario): LineSegments<BufferGeometry, LineBasicMaterial> {
  const corners = imageCorners(scenario.camera).map(([x, y, z]) => new Vector3(x, y, z));
  const points: Vector3[] = [];
  corners.forEach((corner, i) => points.push(new Vector3(), corner, corner, corners[(i + 1) % 4]!));
  const top = corners[0]!.clone().add(corners[1]!).multiplyScalar(0.5);
  const tip = top.clone().add(new Vector3(0, Math.sign(top.y) * 0.15, 0));
  points.push(corners[0]!, tip, tip, corners[1]!);
  const lines = new LineSegments(
    new BufferGeometry().setFromPoints(points),
    new LineBasicMaterial({ depthTest: false, transparent: true }),
  );
  lines.frustumCulled = false;
  lines.renderOrder = 3;
  return lines;
}

/** Scene, paths and cameras in 3D. Throws where there is no WebGL. */
export class SceneView {
  readonly element: HTMLElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(50, 1, 0.01, 1000);
  private readonly controls: OrbitControls;
  private truthPath: Path;
  private allOfTruth: Path;
  private estimatePath: Path;
  private readonly truthCamera;
  private readonly estimateCamera;
  private readonly cloud: Points<BufferGeometry, PointsMaterial> | undefined;
  private readonly up = new Vector3(0, 1, 0);
  private readonly ellipsoids: Ellipsoids | undefined;
  private isTurned = false; // whether somebody has chosen a view
  private readonly middle = new Vector3();
  private extent = 1; // m, of the paths
  private distance = 1; // m, from which the scene is seen
  private mode: ViewMode = 'around';
  private estimate: (Pose | null)[];
  private pending = false;
  private readonly resize = new ResizeObserver(() => this.fit());

  constructor(
    private readonly scenario: Scenario,
    private readonly player: Player,
  ) {
    this.renderer = new WebGLRenderer({ antialias: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute(
      'aria-label',
      'Scene with the true and the estimated path in 3D. Arrow keys turn the view, plus and minus zoom.',
    );
    this.element = h('div', { class: 'scene' }, canvas);

    const { truth, estimate, covariance } = scenario.frames;
    this.estimate = estimate;
    this.orient();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.addEventListener('start', () => (this.isTurned = true));
    // The page scrolls over the view until somebody has clicked into it.
    this.controls.enableZoom = false;
    canvas.addEventListener('focus', () => (this.controls.enableZoom = true));
    canvas.addEventListener('blur', () => (this.controls.enableZoom = false));
    canvas.style.touchAction = 'pan-y';

    this.measure([...truth, ...estimate]);
    this.allOfTruth = new Path(truth, 1.5);
    this.truthPath = new Path(truth, 4);
    this.estimatePath = new Path(estimate, 2.5);
    this.truthCamera = frustum(scenario);
    this.estimateCamera = frustum(scenario);
    if (covariance) {
      this.ellipsoids = new Ellipsoids();
      this.scene.add(this.ellipsoids.mesh);
    }
    if (scenario.cloud) this.cloud = this.addCloud(scenario.cloud);
    this.scene.add(this.allOfTruth.line, this.truthPath.line, this.estimatePath.line, this.truthCamera, this.estimateCamera);
    this.recolour();
    this.reset();
    canvas.addEventListener('keydown', (event) => this.key(event));
    this.resize.observe(this.element);
    player.listen(() => this.update());
  }

  show(estimate: (Pose | null)[]): void {
    this.estimate = estimate;
    this.scene.remove(this.estimatePath.line);
    this.estimatePath.remove();
    this.estimatePath = new Path(estimate, 2.5);
    this.scene.add(this.estimatePath.line);
    this.recolour();
    this.update();
  }

  /** After poses were added. The view is fitted to them until somebody has chosen one. */
  grow(): void {
    const { truth, estimate } = this.scenario.frames;
    const before = this.distance;
    const middle = this.middle.clone();
    this.orient();
    this.measure([...truth, ...estimate]);
    this.scene.remove(this.allOfTruth.line, this.truthPath.line);
    this.allOfTruth.remove();
    this.truthPath.remove();
    this.allOfTruth = new Path(truth, 1.5);
    this.truthPath = new Path(truth, 4);
    this.scene.add(this.allOfTruth.line, this.truthPath.line);
    this.show(estimate);
    const isOther = this.distance > 1.05 * before || middle.distanceTo(this.middle) > 0.05 * this.extent;
    if (isOther && !this.isTurned && this.mode === 'around') this.reset();
  }

  /** How many times larger than 3 sigma the ellipsoids are; undefined where there are none. */
  get covarianceFactor(): number | undefined {
    return this.ellipsoids?.factor;
  }

  setMode(mode: ViewMode): void {
    this.mode = mode;
    this.controls.enabled = mode === 'around';
    if (mode === 'around') this.reset();
    this.fit();
    this.update();
  }

  setCloud(visible: boolean): void {
    if (this.cloud) this.cloud.visible = visible;
    this.redraw();
  }

  recolour(): void {
    this.scene.background = new Color(themeColour('canvas'));
    const paint = (material: { color: Color }, name: string) => material.color.set(themeColour(name));
    paint(this.allOfTruth.line.material, 'truth');
    paint(this.truthPath.line.material, 'truth');
    paint(this.estimatePath.line.material, 'estimate');
    paint(this.truthCamera.material, 'truth');
    paint(this.estimateCamera.material, 'estimate');
    if (this.ellipsoids) paint(this.ellipsoids.mesh.material, 'keyframe');
    this.allOfTruth.line.material.opacity = 0.45;
    this.allOfTruth.line.renderOrder = 1;
    this.truthPath.line.renderOrder = 1;
    this.estimatePath.line.renderOrder = 2;
    this.redraw();
  }

  reset(): void {
    this.isTurned = false;
    const away = this.backwards().addScaledVector(this.up, 0.8).normalize();
    this.camera.fov = 50;
    this.camera.up.copy(this.up);
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(this.middle);
    if (this.cloud) this.controls.target.lerp(this.cloud.geometry.boundingSphere!.center, 0.5);
    this.camera.position.copy(this.controls.target).addScaledVector(away, this.distance);
    this.controls.update();
    this.redraw();
  }

  remove(): void {
    this.resize.disconnect();
    this.controls.dispose();
    for (const path of [this.allOfTruth, this.truthPath, this.estimatePath]) path.remove();
    this.ellipsoids?.remove();
    this.cloud?.geometry.dispose();
    this.cloud?.material.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** The poses that tell where up is and where the cameras look: the true ones where there are any. */
  private reference(): (Pose | null)[] {
    const { truth, estimate } = this.scenario.frames;
    return truth.some(Boolean) ? truth : estimate;
  }

  private orient(): void {
    const { axis, sign } = upAxis(this.reference(), this.scenario.camera);
    this.up.set(0, 0, 0).setComponent(axis, sign);
    this.camera.up.copy(this.up);
  }

  /** On the floor, away from what the cameras look at on the whole, a little to the side. */
  private backwards(): Vector3 {
    const heading = new Vector3();
    for (const pose of this.reference()) {
      if (pose) heading.add(new Vector3(...rotated(pose, [0, 0, 1])));
    }
    heading.divideScalar(-Math.max(1, this.reference().length)).projectOnPlane(this.up);
    if (heading.length() < 0.2) heading.set(1, 1, 1).projectOnPlane(this.up);
    return heading.normalize().applyAxisAngle(this.up, Math.PI / 7);
  }

  private measure(poses: (Pose | null)[]): void {
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = new Vector3(-Infinity, -Infinity, -Infinity);
    for (const pose of poses) {
      if (!pose) continue;
      const point = new Vector3(pose[0], pose[1], pose[2]);
      low.min(point);
      high.max(point);
    }
    if (low.x > high.x) return;
    this.middle.addVectors(low, high).multiplyScalar(0.5);
    this.extent = Math.max(low.distanceTo(high), 0.3);
    this.distance = 1.75 * this.extent;
  }

  private addCloud(cloud: Cloud): Points<BufferGeometry, PointsMaterial> {
    const { positions, colours } = cloudPoints(cloud);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('color', new BufferAttribute(colours, 3));
    geometry.computeBoundingSphere();
    const size = (2.8 * geometry.boundingSphere!.radius) / Math.sqrt(cloud.count);
    const points = new Points(geometry, new PointsMaterial({ size, vertexColors: true }));
    this.distance = Math.max(this.distance, 1.1 * geometry.boundingSphere!.radius);
    this.scene.add(points);
    return points;
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.update();
  }

  private place(object: LineSegments, pose: Pose | null | undefined, size: number): void {
    object.scale.setScalar(size * this.extent);
    object.visible = Boolean(pose) && this.mode === 'around';
    if (!pose) return;
    object.position.set(pose[0], pose[1], pose[2]);
    object.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
  }

  private update(): void {
    const frame = this.player.frame;
    this.truthPath.upTo(frame);
    this.estimatePath.upTo(frame);
    this.place(this.truthCamera, this.scenario.frames.truth[frame], 0.09);
    this.place(this.estimateCamera, this.estimate[frame], 0.08);
    this.ellipsoids?.show(this.scenario.frames, frame, this.extent);
    if (this.mode === 'camera') this.lookThrough(this.estimate[frame] ?? this.scenario.frames.truth[frame]);
    this.redraw();
  }

  /** three's cameras look along -z with y up, ours along z with y down. */
  private lookThrough(pose: Pose | null | undefined): void {
    if (!pose) return;
    const { width, height, fx, fy } = this.scenario.camera ?? { width: 4, height: 3, fx: 4, fy: 4 };
    const half = Math.max(height / (2 * Math.abs(fy)), width / (2 * fx) / this.camera.aspect);
    this.camera.fov = (2 * Math.atan(half) * 180) / Math.PI;
    this.camera.position.set(pose[0], pose[1], pose[2]);
    const flip = fy < 0 ? new Quaternion(0, 1, 0, 0) : new Quaternion(1, 0, 0, 0);
    this.camera.quaternion.set(pose[3], pose[4], pose[5], pose[6]).multiply(flip);
    this.camera.updateProjectionMatrix();
  }

  private key(event: KeyboardEvent): void {
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.controls.rotateLeft(kTurn),
      ArrowRight: () => this.controls.rotateLeft(-kTurn),
      ArrowUp: () => this.controls.rotateUp(kTurn),
      ArrowDown: () => this.controls.rotateUp(-kTurn),
      '+': () => this.controls.dollyIn(kZoom),
      '-': () => this.controls.dollyOut(kZoom),
    };
    const action = actions[event.key];
    if (!action || this.mode !== 'around' || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  }

  private redraw(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.renderer.render(this.scene, this.camera);
    });
  }
}
