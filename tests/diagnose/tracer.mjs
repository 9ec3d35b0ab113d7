// SPDX-License-Identifier: Apache-2.0
// A whole ray tracer for tests of `glint diagnose`: the scenes of EPFL's RT2 (scenes/epfl/*.json), with its loop over
// reflections in place of recursion.
//     MISTAKE=half-not-unit GLINT_PIXELS=80,60 node tracer.mjs 160 120 [SCENE.json] > picture.ppm
// MISTAKE: one of mistakes.json; without it, the picture is right. --list prints all that this tracer has.
// Shapes are counted from 0 in the order spheres, planes, cylinders, and lights from 0 without the ambient light, as the
// homework does. SHADING=phong computes R in place of H. LOOSE=1: the log has no `end`.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import * as log from "../../examples/trace_log/glint_log.mjs";

const mistake = process.env.MISTAKE ?? "";
const wrong = (name) => name === mistake;
const isPhong = process.env.SHADING === "phong";
const limit = 4 + (wrong("depth-more") ? 1 : wrong("depth-less") ? -1 : 0);
const epsilon = 0.001;
const end = process.env.LOOSE === "1" ? () => {} : log.end;

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (a, f) => [a[0] * f, a[1] * f, a[2] * f];
const tint = (a, b) => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.sqrt(dot(a, a));
const unit = (a) => mul(a, 1 / norm(a));

// The roots of t^2 + 2 b t + c, the smaller one first.
function roots(b, c) {
  const square = b * b - c;
  if (square < 0) return [];
  const root = Math.sqrt(square);
  return wrong("far-root") ? [-b + root] : [-b - root, -b + root];
}

// The hit of each shape: { t, n }, or null. Directions are unit vectors.
const kinds = {
  sphere(s, origin, d, tMin) {
    const fromCenter = sub(origin, s.center);
    const t = roots(dot(fromCenter, d), dot(fromCenter, fromCenter) - s.radius ** 2).find((v) => v > tMin);
    if (t === undefined) return null;
    const p = add(origin, mul(d, t));
    if (wrong("normal-is-point")) return { t, n: unit(p) };
    return { t, n: wrong("normal-not-unit") ? sub(p, s.center) : mul(sub(p, s.center), 1 / s.radius) };
  },
  plane(s, origin, d, tMin) {
    const n = unit(s.normal);
    const sign = wrong("plane-sign") ? -1 : 1;
    const t = (sign * dot(sub(s.center, origin), n)) / dot(d, n);
    return t > tMin ? { t, n: dot(n, d) > 0 ? mul(n, -1) : n } : null;
  },
  cylinder(s, origin, d, tMin) {
    const axis = wrong("cylinder-axis-not-unit") ? s.axis : unit(s.axis);
    const from = sub(origin, s.center);
    const dAcross = sub(d, mul(axis, dot(d, axis)));
    const fromAcross = wrong("cylinder-not-across") ? from : sub(from, mul(axis, dot(from, axis)));
    const a = dot(dAcross, dAcross);
    const ts = roots(dot(fromAcross, dAcross) / a, (dot(fromAcross, fromAcross) - s.radius ** 2) / a);
    const half = wrong("cylinder-full-height") ? s.height : s.height / 2;
    for (const t of wrong("cylinder-first-root-only") ? ts.slice(0, 1) : ts) {
      if (!(t > tMin)) continue;
      const p = add(origin, mul(d, t));
      const along = dot(sub(p, s.center), axis);
      if (Math.abs(along) > half && !wrong("cylinder-endless")) continue;
      const across = wrong("cylinder-normal-from-center") ? sub(p, s.center) : sub(sub(p, s.center), mul(axis, along));
      const n = unit(across);
      return { t, n: dot(n, d) > 0 && !wrong("inside-not-flipped") ? mul(n, -1) : n };
    }
    return null;
  },
};

function readScene(name) {
  const scene = JSON.parse(fs.readFileSync(name, "utf8"));
  const materials = new Map(scene.materials.map((m) => [m.name, m]));
  const shapes = ["sphere", "plane", "cylinder"].flatMap((kind) =>
    (scene[`${kind}s`] ?? []).map((s) => ({ ...s, hit: kinds[kind], material: materials.get(s.material) })),
  );
  return { camera: scene.camera, lights: scene.lights, shapes };
}

function closest(scene, origin, d) {
  let best = null;
  for (const [index, shape] of scene.shapes.entries()) {
    const hit = shape.hit(shape, origin, d, wrong("negative-t") ? Number.NEGATIVE_INFINITY : 0);
    if (hit === null || (best !== null && wrong("first-hit"))) continue;
    if (best === null || hit.t < best.t || wrong("last-hit")) best = { ...hit, index, shape };
  }
  return best;
}

const isBlocked = (scene, origin, d, tMax) =>
  scene.shapes.some((shape) => {
    const hit = shape.hit(shape, origin, d, 0);
    return hit !== null && hit.t < tMax;
  });

function highlight(m, n, l, v, nl, d) {
  let s;
  if (isPhong) {
    let r = sub(mul(n, 2 * dot(n, l)), l);
    if (wrong("reflection-sign")) r = add(mul(n, 2 * dot(n, l)), l);
    s = dot(r, v);
    log.value("R", r);
    log.value("R.V", s);
  } else {
    let h = add(l, wrong("half-from-direction") ? d : v);
    if (!wrong("half-not-unit")) h = unit(h);
    s = dot(n, h);
    log.value("H", h);
    log.value("N.H", s);
  }
  let power = 0;
  if (s > 0 && nl > 0) {
    power = s ** (m.shininess * (wrong("exponent-times-4") ? 4 : 1));
    if (wrong("exponent-missing")) power = s;
    if (wrong("exponent-as-factor")) power = m.shininess * s;
  }
  log.value("power", power);
  return power;
}

function lightOf(scene, m, p, n, v, d) {
  const ambient = mul(m.color, wrong("ambient-missing") ? 0 : m.ambient);
  log.value("ambient", ambient);
  let sum = ambient;
  for (const [index, light] of scene.lights.entries()) {
    log.light(index);
    if (wrong("ambient-for-each-light")) sum = add(sum, ambient);
    if (wrong("only-first-light") && index > 0) break;
    const toLight = sub(light.position, p);
    const distance = norm(toLight);
    let l = unit(toLight);
    if (wrong("light-reversed")) l = mul(l, -1);
    if (wrong("light-not-unit")) l = toLight;
    if (wrong("light-position")) l = unit(light.position);
    let nl = dot(n, l);
    if (wrong("cosine-abs")) nl = Math.abs(nl);
    log.value("L", l);
    log.value("distance", distance);
    log.value("N.L", nl);
    const power = highlight(m, n, l, v, nl, d);
    let factor = 1;
    if (wrong("distance-squared")) {
      factor = 1 / (distance * distance);
      log.value("attenuation", factor);
    }
    const start = wrong("shadow-no-epsilon") ? p : add(p, mul(n, epsilon));
    const toEnd = sub(light.position, start);
    const direction = wrong("shadow-to-camera") ? v : unit(toEnd);
    log.ray("shadow");
    log.value("origin", start);
    log.value("direction", direction);
    end();
    const tMax = wrong("shadow-without-limit") ? Number.POSITIVE_INFINITY : norm(toEnd);
    const blocked = !wrong("no-shadows") && isBlocked(scene, start, direction, tMax);
    log.value("blocked", blocked);
    const visible = blocked ? 0 : factor;
    const cosine = wrong("cosine-not-clamped") ? nl : Math.max(nl, 0);
    const color = wrong("light-color-missing") ? [1, 1, 1] : light.color;
    const surface = wrong("diffuse-color-missing") ? [1, 1, 1] : m.color;
    const diffuse = mul(tint(surface, color), m.diffuse * cosine * visible);
    let specular = mul(tint(m.color, color), m.specular * power * (wrong("specular-in-shadow") ? factor : visible));
    if (wrong("specular-color-white")) specular = mul(color, m.specular * power * visible);
    if (wrong("specular-times-cosine")) specular = mul(specular, cosine);
    log.value("diffuse", diffuse);
    log.value("specular", specular);
    sum = add(sum, add(diffuse, specular));
  }
  log.value("local", sum);
  return sum;
}

// The color that a ray from the camera brings: the sum over the surfaces along its mirror rays.
function trace(scene, eye, direction) {
  let color = [0, 0, 0];
  let weight = 1;
  let a = 1;
  let origin = eye;
  let d = direction;
  let rays = 0;
  for (let i = 0; i <= limit; ++i) {
    log.ray(i === 0 ? "camera" : "mirror");
    ++rays;
    log.value("origin", origin);
    log.value("direction", d);
    if (i > 0) log.value("weight", a);
    const hit = closest(scene, origin, d);
    if (hit === null) {
      log.value("miss");
      break;
    }
    const p = wrong("point-without-origin") ? mul(d, hit.t) : add(origin, mul(d, hit.t));
    const n = wrong("normal-reversed") ? mul(hit.n, -1) : hit.n;
    let v = mul(d, -1);
    if (wrong("view-reversed")) v = d;
    if (wrong("view-not-unit")) v = sub(origin, p);
    if (wrong("view-to-camera")) v = unit(sub(eye, p));
    const m = hit.shape.material;
    log.value("shape", hit.index);
    log.value("t", hit.t);
    log.value("P", p);
    log.value("N", n);
    log.value("V", v);
    const local = lightOf(scene, m, p, n, v, d);
    const isLast = i === limit && !wrong("last-surface-reduced");
    let share = isLast || wrong("mirror-add") ? 1 : 1 - m.mirror;
    if (wrong("blend-reversed") && m.mirror > 0) share = m.mirror;
    color = add(color, mul(local, weight * share));
    a = m.mirror;
    if (a === 0) break;
    if (wrong("mirror-weight-missing")) a = 1;
    weight = wrong("weight-not-multiplied") ? a : weight * a;
    origin = wrong("mirror-no-epsilon") ? p : add(p, mul(n, epsilon));
    if (wrong("mirror-from-camera")) origin = eye;
    d = sub(d, mul(n, 2 * dot(n, d)));
    if (wrong("mirror-direction-sign")) d = mul(d, -1);
  }
  for (let i = 0; i < rays; ++i) end();
  return color;
}

function directionOf(camera, x, y, width, height) {
  const forward = unit(sub(camera.target, camera.position));
  const right = unit(cross(forward, camera.up));
  const up = cross(right, forward);
  let angle = ((camera.fov / 2) * Math.PI) / 180;
  if (wrong("fov-full-angle")) angle *= 2;
  if (wrong("fov-in-degrees")) angle = camera.fov / 2;
  const inPixel = wrong("pixel-centre-missing") ? 0 : 0.5;
  let sx = (2 * (x + inPixel)) / width - 1;
  let sy = 1 - (2 * (y + inPixel)) / height;
  if (wrong("rows-flipped")) sy = -sy;
  if (wrong("columns-mirrored")) sx = -sx;
  const half = Math.tan(angle);
  let aspect = height / width;
  if (wrong("aspect-ignored")) aspect = 1;
  if (wrong("aspect-inverted")) aspect = width / height;
  const d = add(forward, add(mul(right, sx * half), mul(up, sy * half * aspect)));
  return wrong("direction-not-unit") ? d : unit(d);
}

function toByte(c) {
  let v = Math.min(Math.max(c, 0), 1);
  if (wrong("gamma")) v **= 1 / 2.2;
  if (wrong("bytes-truncated")) return Math.floor(255 * v);
  if (wrong("bytes-times-256")) return Math.floor(256 * v) & 255;
  return Math.round(255 * v);
}

function render(scene, width, height) {
  const bytes = [];
  log.about("size", width, height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      log.pixel(x, y);
      const color = trace(scene, scene.camera.position, directionOf(scene.camera, x, y, width, height));
      const rgb = color.map(toByte);
      if (wrong("colors-swapped")) rgb.reverse();
      log.value("color", color);
      log.value("clamped", color.map((c) => Math.min(Math.max(c, 0), 1)));
      log.value("bytes", rgb);
      log.endPixel();
      bytes.push(...rgb);
    }
  }
  process.stdout.write(Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), Buffer.from(bytes)]));
}

const here = fileURLToPath(import.meta.url);
const names = new Set([...fs.readFileSync(here, "utf8").matchAll(/wrong\("([a-z0-9-]+)"\)/g)].map((found) => found[1]));
if (process.argv[2] === "--list") {
  console.log([...names].join("\n"));
} else if (mistake !== "" && !names.has(mistake)) {
  console.error(`tracer.mjs: there is no mistake ${mistake}`);
  process.exitCode = 1;
} else {
  const name = process.argv[4] ?? path.join(path.dirname(here), "../../scenes/epfl/three_lights.json");
  render(readScene(name), Number(process.argv[2] ?? 160), Number(process.argv[3] ?? 120));
}
