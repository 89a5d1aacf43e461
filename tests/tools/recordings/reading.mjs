// What readers that are not ours make of an MCAP file: topics, messages in order of time, and a
// folder in TUM's layout.
import { createHash } from 'node:crypto';
import { mkdir, open, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { deflateSync } from 'node:zlib';

const require = createRequire(path.join(process.cwd(), 'package.json'));

/** Imports a package from the current folder; without it, exit code 77 (1 in CI). */
export function load(name) {
  try {
    return require(name);
  } catch {
    console.log(`skipped: ${name} is not installed`);
    process.exit(process.env.CI ? 1 : 77);
  }
}

const { McapIndexedReader, McapStreamReader } = load('@mcap/core');
const { loadDecompressHandlers } = load('@mcap/support');
const { parse } = load('@foxglove/rosmsg');
const { MessageReader } = load('@foxglove/rosmsg2-serialization');

/** Reads a file by its index, every CRC checked, and by its records from begin to end; throws where
 * the two differ. Returns { profile, topics: { name: { type, messages: [{ time, data }] } } }, each
 * message decoded by the definition that the file itself has of it. */
export async function readMcap(file) {
  const handle = await open(file);
  const size = BigInt((await handle.stat()).size);
  const readable = {
    size: async () => size,
    read: async (offset, length) => {
      const bytes = new Uint8Array(Number(length));
      await handle.read(bytes, 0, bytes.length, Number(offset));
      return bytes;
    },
  };
  const decompressHandlers = await loadDecompressHandlers();
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const topics = {};
  const decoders = new Map();
  const sum = createHash('sha256');
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    if (!decoders.has(channel.id)) {
      if (schema.encoding !== 'ros2msg' || channel.messageEncoding !== 'cdr') {
        throw new Error(`${channel.topic}: ${schema.encoding}, ${channel.messageEncoding}`);
      }
      const definition = parse(new TextDecoder().decode(schema.data), { ros2: true });
      decoders.set(channel.id, new MessageReader(definition));
      topics[channel.topic] = { type: schema.name, messages: [] };
    }
    sum.update(`${channel.topic} ${message.logTime}`).update(message.data);
    topics[channel.topic].messages.push({
      time: message.logTime,
      data: decoders.get(channel.id).readMessage(message.data),
    });
  }
  await handle.close();
  const streamed = await countByStream(file, decompressHandlers);
  const counted = Object.values(topics).reduce((n, topic) => n + topic.messages.length, 0);
  if (streamed !== counted || Number(reader.statistics.messageCount) !== counted) {
    throw new Error(`${counted} messages by the index, ${streamed} by reading the file`);
  }
  return { profile: reader.header.profile, topics };
}

/** Counts the messages of a file as it is read from begin to end, its CRCs checked. */
async function countByStream(file, decompressHandlers) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  const handle = await open(file);
  let count = 0;
  for await (const bytes of handle.createReadStream()) {
    reader.append(bytes);
    for (let record; (record = reader.nextRecord()); ) {
      count += record.type === 'Message' ? 1 : 0;
    }
  }
  if (!reader.done()) {
    throw new Error(`${file}: does not end as an MCAP file does`);
  }
  return count;
}

const crcTable = Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) {
    c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  }
  return c >>> 0;
});

function pngChunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  let crc = 0xffffffff;
  for (const byte of body) {
    crc = crcTable[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  }
  const head = Buffer.alloc(4);
  head.writeUInt32BE(data.length);
  const tail = Buffer.alloc(4);
  tail.writeUInt32BE((crc ^ 0xffffffff) >>> 0);
  return Buffer.concat([head, body, tail]);
}

/** Encodes rows of samples as a PNG: colour type 0 (grey) or 2 (RGB). */
export function encodePng(width, height, depth, colourType, row) {
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([depth, colourType], 8);
  const rows = Array.from({ length: height }, (_, v) => Buffer.concat([Buffer.alloc(1), row(v)]));
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    pngChunk('IHDR', head),
    pngChunk('IDAT', deflateSync(Buffer.concat(rows))),
    pngChunk('IEND', Buffer.alloc(0)),
  ]);
}

function colourPng(image) {
  if (image.encoding === 'mono8') {
    return encodePng(image.width, image.height, 8, 0, (v) =>
      Buffer.from(image.data.subarray(v * image.step, v * image.step + image.width)),
    );
  }
  return encodePng(image.width, image.height, 8, 2, (v) => {
    const row = Buffer.alloc(3 * image.width);
    for (let i = 0; i < row.length; i += 3) {
      const at = v * image.step + i;
      row.set([image.data[at + 2], image.data[at + 1], image.data[at]], i);  // bgr8
    }
    return row;
  });
}

function depthPng(image, unitsPerMetre) {
  const view = new DataView(image.data.buffer, image.data.byteOffset, image.data.byteLength);
  return encodePng(image.width, image.height, 16, 0, (v) => {
    const row = Buffer.alloc(2 * image.width);
    for (let u = 0; u < image.width; ++u) {
      const value =
        image.encoding === '16UC1'
          ? (view.getUint16(v * image.step + 2 * u, true) * unitsPerMetre) / 1000
          : view.getFloat32(v * image.step + 4 * u, true) * unitsPerMetre;
      row.writeUInt16BE(Math.round(value), 2 * u);
    }
    return row;
  });
}

const seconds = ({ sec, nanosec }) => `${sec}.${String(nanosec).padStart(9, '0')}`;

/** Writes images and depth of a recording as a folder in TUM's layout, without a camera. */
export async function writeTumFolder(folder, colour, depth, unitsPerMetre) {
  for (const [name, messages, encode] of [
    ['rgb', colour, colourPng],
    ['depth', depth, (image) => depthPng(image, unitsPerMetre)],
  ]) {
    await mkdir(path.join(folder, name), { recursive: true });
    let list = '';
    for (const [i, { data }] of messages.entries()) {
      await writeFile(path.join(folder, name, `${i}.png`), encode(data));
      list += `${seconds(data.header.stamp)} ${name}/${i}.png\n`;
    }
    await writeFile(path.join(folder, `${name}.txt`), list);
  }
}
