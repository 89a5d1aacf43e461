// MCAP files in several layouts, written by npm's @mcap/core.
import { open } from 'node:fs/promises';

import { encodePng, load } from './reading.mjs';

const { McapWriter } = load('@mcap/core');
const { parse } = load('@foxglove/rosmsg');
const { MessageWriter } = load('@foxglove/rosmsg2-serialization');

const kHeader = `std_msgs/Header header
`;
const kHeaderDefinition = `================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
`;
const kImage = `${kHeader}uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data
${kHeaderDefinition}`;
const kCompressedImage = `${kHeader}string format
uint8[] data
${kHeaderDefinition}`;

/** The rows of a bgr8 image as rgb8. */
function swapped(image) {
  const data = Uint8Array.from(image.data);
  for (let i = 0; i + 2 < data.length; i += 3) {
    [data[i], data[i + 2]] = [image.data[i + 2], image.data[i]];
  }
  return { ...image, encoding: 'rgb8', data };
}

function compressedColour({ header, width, height, step, data }) {
  const png = encodePng(width, height, 8, 2, (v) => {
    const row = Buffer.from(data.subarray(v * step, v * step + 3 * width));
    for (let i = 0; i < row.length; i += 3) {
      [row[i], row[i + 2]] = [row[i + 2], row[i]];
    }
    return row;
  });
  return { header, format: 'bgr8; png compressed bgr8', data: new Uint8Array(png) };
}

/** image_transport's compressedDepth of depth in units of 1 / 5000 m. */
function compressedDepth({ header, width, height, step, data }) {
  const view = new DataView(data.buffer, data.byteOffset);
  const png = encodePng(width, height, 16, 0, (v) => {
    const row = Buffer.alloc(2 * width);
    for (let u = 0; u < width; ++u) {
      row.writeUInt16BE(Math.round(view.getFloat32(v * step + 4 * u, true) * 5000), 2 * u);
    }
    return row;
  });
  const config = Buffer.alloc(12);  // the kind of compression and two parameters for floats
  return {
    header,
    format: '16UC1; compressedDepth png',
    data: new Uint8Array(Buffer.concat([config, png])),
  };
}

/** Writes images and depth of a recording that readMcap returned; `layout` is chunks, no_chunks,
 * no_summary or compressed (images, not chunks). */
export async function writeMcap(file, topics, colour, depth, layout) {
  const handle = await open(file, 'w');
  let position = 0n;
  const writable = {
    position: () => position,
    write: async (bytes) => {
      await handle.write(bytes);
      position += BigInt(bytes.length);
    },
  };
  const isSummary = layout !== 'no_summary';
  const writer = new McapWriter({
    writable,
    chunkSize: 200_000,
    useChunks: layout !== 'no_chunks',
    useStatistics: isSummary,
    useSummaryOffsets: isSummary,
    useChunkIndex: isSummary,
    useMessageIndex: isSummary,
    repeatSchemas: isSummary,
    repeatChannels: isSummary,
  });
  await writer.start({ profile: 'ros2', library: 'test' });
  const isCompressed = layout === 'compressed';
  const definition = isCompressed ? kCompressedImage : kImage;
  const schemaId = await writer.registerSchema({
    name: isCompressed ? 'sensor_msgs/msg/CompressedImage' : 'sensor_msgs/msg/Image',
    encoding: 'ros2msg',
    data: new TextEncoder().encode(definition),
  });
  const encoder = new MessageWriter(parse(definition, { ros2: true }));
  const streams = [
    [isCompressed ? `${colour}/compressed` : colour, colour,
      isCompressed ? compressedColour : swapped],
    [isCompressed ? `${depth}/compressedDepth` : depth, depth,
      isCompressed ? compressedDepth : (image) => image],
  ];
  const messages = [];
  for (const [topic, source, convert] of streams) {
    const channelId = await writer.registerChannel({
      schemaId, topic, messageEncoding: 'cdr', metadata: new Map(),
    });
    for (const { time, data } of topics[source].messages) {
      messages.push({ channelId, time, data: encoder.writeMessage(convert(data)) });
    }
  }
  messages.sort((a, b) => (a.time < b.time ? -1 : a.time > b.time ? 1 : a.channelId - b.channelId));
  for (const [sequence, { channelId, time, data }] of messages.entries()) {
    await writer.addMessage({ channelId, sequence, logTime: time, publishTime: time, data });
  }
  await writer.end();
  await handle.close();
}
