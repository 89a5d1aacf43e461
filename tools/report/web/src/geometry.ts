import type { Camera, Pose } from './data';

export type Vector = [number, number, number];

/** A vector turned from the camera's into the world's axes. */
export function rotated([, , , x, y, z, w]: Pose, [a, b, c]: Vector): Vector {
  const tx = 2 * (y * c - z * b);
  const ty = 2 * (z * a - x * c);
  const tz = 2 * (x * b - y * a);
  return [
    a + w * tx + y * tz - z * ty,
    b + w * ty + z * tx - x * tz,
    c + w * tz + x * ty - y * tx,
  ];
}

/** The world's axis (0, 1, 2) that the images' top points along on the whole, and its sign. */
export function upAxis(poses: (Pose | null)[], camera: Camera | undefined): { axis: number; sign: number } {
  const down: Vector = [0, camera && camera.fy < 0 ? -1 : 1, 0];
  const sum: Vector = [0, 0, 0];
  for (const pose of poses) {
    if (pose) rotated(pose, down).forEach((value, i) => (sum[i]! -= value));
  }
  const axis = sum.reduce((best, value, i) => (Math.abs(value) > Math.abs(sum[best]!) ? i : best), 1);
  return { axis, sign: sum[axis]! < 0 ? -1 : 1 };
}

/** The four corners of the image, 1 m in front of the camera. */
export function imageCorners(camera: Camera | undefined): Vector[] {
  const { width, height, fx, fy, cx, cy } = camera ?? {
    width: 4, height: 3, fx: 4, fy: 4, cx: 2, cy: 1.5,
  };
  return ([[0, 0], [width, 0], [width, height], [0, height]] as const).map(([u, v]) => [
    (u - cx) / fx,
    (v - cy) / fy,
    1,
  ]);
}
