// SPDX-License-Identifier: Apache-2.0 OR MIT-0
// One diffuse sphere, lit by one point light (diffuse_sphere.glint), with the calls that write a log for `glint diagnose`.
//     GLINT_PIXELS="40,18;2,2" node diffuse_sphere.mjs > diffuse_sphere.ppm
import * as log from "./glint_log.mjs";

const width = 64;
const height = 48;
const fovDegrees = 50;
const eye = [0, 0, 4];
const sphere = { center: [0, 0, 0], radius: 1, diffuse: [0.9, 0.5, 0.2] };
const light = { position: [3, 4, 5], color: [1, 0.9, 0.8] };

const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, f) => [a[0] * f, a[1] * f, a[2] * f];
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = (a) => scaled(a, 1 / Math.sqrt(dot(a, a)));

// The distance of the nearest hit, or -1.
function hitSphere(origin, direction) {
  const fromCenter = sub(origin, sphere.center);
  const b = dot(fromCenter, direction);
  const root = b * b - (dot(fromCenter, fromCenter) - sphere.radius * sphere.radius);
  return root < 0 ? -1 : -b - Math.sqrt(root);
}

function trace(origin, direction) {
  log.ray("camera");
  log.value("origin", origin);
  log.value("direction", direction);
  let color = [0, 0, 0];
  const t = hitSphere(origin, direction);
  if (t > 0) {
    const p = add(origin, scaled(direction, t));
    const n = unit(sub(p, sphere.center));
    const l = unit(sub(light.position, p));
    const nl = dot(n, l);
    color = sphere.diffuse.map((k, i) => k * light.color[i] * Math.max(nl, 0));
    log.value("shape", 1);
    log.value("t", t);
    log.value("P", p);
    log.value("N", n);
    log.light(1);
    log.value("L", l);
    log.value("N.L", nl);
    log.value("diffuse", color);
  } else {
    log.value("miss");
  }
  log.value("color", color);
  log.end();
  return color;
}

const toByte = (v) => Math.round(255 * Math.min(Math.max(v, 0), 1));

const viewWidth = 2 * Math.tan(((fovDegrees / 2) * Math.PI) / 180); // of the picture, at the distance 1
const bytes = [];
for (let y = 0; y < height; ++y) {
  for (let x = 0; x < width; ++x) {
    log.pixel(x, y);
    const toPixel = [
      ((x + 0.5) / width - 0.5) * viewWidth,
      ((0.5 - (y + 0.5) / height) * viewWidth * height) / width,
      -1,
    ];
    const rgb = trace(eye, unit(toPixel)).map(toByte);
    log.value("bytes", rgb);
    log.endPixel();
    bytes.push(...rgb);
  }
}
process.stdout.write(Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), Buffer.from(bytes)]));
