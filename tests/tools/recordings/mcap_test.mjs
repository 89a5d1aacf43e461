// node mcap_test.mjs EDVO SCENE FOLDER: what `edvo convert --format mcap` writes of a rendered sequence
// is read by npm's @mcap/core, decoded by its own definitions and written as a TUM folder again, on
// which `edvo track` gives the same bytes as on the sequence and on the MCAP file; what @mcap/core
// writes, in layouts of its own, is tracked alike. Packages are looked up from the current folder.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFile, mkdir, readFile, rm } from 'node:fs/promises';
import path from 'node:path';

import { readMcap, writeTumFolder } from './reading.mjs';
import { writeMcap } from './writing.mjs';

const [edvo, scene, folder] = process.argv.slice(2);
const at = (name) => path.join(folder, name);
const run = (...args) => execFileSync(edvo, [...args, '--quiet'], { encoding: 'utf8' });

const kColour = '/camera/color/image_raw';
const kDepth = '/camera/aligned_depth_to_color/image_raw';

async function tracked(sequence, ...options) {
  const out = `${sequence}.estimate.txt`;
  run('track', sequence, '--preset', 'paper', '--out', out, '--force', ...options);
  return readFile(out, 'utf8');
}

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
const orbit = '--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8';
const size = '--rate 30 --duration 0.2 --size 160x120 --samples 1';
run('render', scene, ...`${orbit} ${size}`.split(' '), '--out', at('tum'));
const camera = ['--camera', path.join(at('tum'), 'camera.toml')];
const expected = await tracked(at('tum'));
const truth = (await readFile(path.join(at('tum'), 'groundtruth.txt'), 'utf8'))
  .split('\n')
  .filter((line) => line && !line.startsWith('#'))
  .map((line) => line.split(' ').map(Number));
assert.equal(truth.length, 7);

for (const compression of ['none', 'lz4', 'zstd']) {
  const file = at(`${compression}.mcap`);
  run('convert', at('tum'), file, '--format', 'mcap', '--compression', compression, '--points');
  const { profile, topics } = await readMcap(file);
  assert.equal(profile, 'ros2');
  const types = Object.fromEntries(Object.entries(topics).map(([name, t]) => [name, t.type]));
  assert.deepEqual(types, {
    [kColour]: 'sensor_msgs/msg/Image',
    '/camera/color/camera_info': 'sensor_msgs/msg/CameraInfo',
    [kDepth]: 'sensor_msgs/msg/Image',
    '/camera/aligned_depth_to_color/camera_info': 'sensor_msgs/msg/CameraInfo',
    '/camera/aligned_depth_to_color/points': 'sensor_msgs/msg/PointCloud2',
    '/camera/pose': 'geometry_msgs/msg/PoseStamped',
    '/tf': 'tf2_msgs/msg/TFMessage',
  });
  for (const [i, [, x, y, z, qx, qy, qz, qw]] of truth.entries()) {
    const { position, orientation } = topics['/camera/pose'].messages[i].data.pose;
    assert.deepEqual(position, { x, y, z });
    const [transform] = topics['/tf'].messages[i].data.transforms;
    assert.deepEqual(transform.transform.translation, { x, y, z });
    assert.equal(transform.header.frame_id, 'world');
    for (const q of [orientation, transform.transform.rotation]) {
      const dot = q.x * qx + q.y * qy + q.z * qz + q.w * qw;
      assert.ok(Math.abs(Math.abs(dot) - 1) < 1e-8, 'the rotation is the truth');
    }
  }
  checkPoints(topics);
  const copy = at(`${compression}_tum`);
  await writeTumFolder(copy, topics[kColour].messages, topics[kDepth].messages, 5000);
  await copyFile(path.join(at('tum'), 'camera.toml'), path.join(copy, 'camera.toml'));
  assert.equal(await tracked(copy), expected, `${compression}: as @mcap/core reads it`);
  assert.equal(await tracked(file, ...camera), expected, `${compression}: as edvo reads it`);
}

/** Each point of the cloud, projected, is where the depth image has its depth. */
function checkPoints(topics) {
  const info = topics['/camera/aligned_depth_to_color/camera_info'].messages[0].data;
  const cloud = topics['/camera/aligned_depth_to_color/points'].messages[0].data;
  const depth = topics[kDepth].messages[0].data;
  assert.deepEqual([...cloud.fields].map((field) => field.name), ['x', 'y', 'z', 'rgb']);
  assert.equal(cloud.data.length, cloud.width * cloud.point_step);
  const points = new DataView(cloud.data.buffer, cloud.data.byteOffset);
  const pixels = new DataView(depth.data.buffer, depth.data.byteOffset);
  assert.ok(cloud.width > 1000);
  for (let i = 0; i < cloud.width; ++i) {
    const [x, y, z] = [0, 4, 8].map((k) => points.getFloat32(i * cloud.point_step + k, true));
    const u = Math.round((x / z) * info.k[0] + info.k[2]);
    const v = Math.round((y / z) * info.k[4] + info.k[5]);
    assert.equal(depth.encoding, '32FC1');
    assert.equal(pixels.getFloat32(v * depth.step + 4 * u, true), z);
  }
}

const { topics } = await readMcap(at('zstd.mcap'));
for (const layout of ['chunks', 'no_chunks', 'no_summary', 'compressed']) {
  const file = at(`by_npm_${layout}.mcap`);
  await writeMcap(file, topics, kColour, kDepth, layout);
  assert.equal(await tracked(file, ...camera), expected, `${layout}: as @mcap/core writes it`);
}
console.log('MCAP: three compressions read and four layouts written by @mcap/core');
