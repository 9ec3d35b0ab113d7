// SPDX-License-Identifier: Apache-2.0 OR MIT-0
// Writes the log of a ray tracer for `glint diagnose` (docs/formats/trace_log.md). One ES module, for node and browsers, no
// dependencies. Copy it into your program, and call, in the order in which your program computes:
//
//     import * as log from "./glint_log.mjs";
//
//     log.about("size", 64, 48);         a line about the whole log, once before the first pixel
//     log.pixel(x, y);                   begins a pixel; returns true if this pixel is logged
//     log.ray("camera");                 begins a ray; "mirror", "glass": from the surface that the open ray has hit
//     log.value("origin", origin);       a vector or color: array, typed array, { x, y, z }, { r, g, b }, or three numbers
//     log.value("t", t);                 a number
//     log.value("blocked", true);        a flag
//     log.value("shape", "ball");        a name
//     log.value("miss");                 a key alone
//     log.light(1);                      begins a light at the hit of the open ray
//     log.end();                         ends the open ray
//     log.endPixel();                    ends the pixel
//
// The pixels are selected by log.select("320,350;12,40"), in node by the environment variable GLINT_PIXELS, too, and in a
// browser by ?GLINT_PIXELS=320,350 in the page's address. Without them nothing is logged, and each call costs one branch.
// In node the file is GLINT_LOG (default: glint.log), and each line is written at once, so a crash loses none. In a
// browser log.text() is the log, and log.download() saves it as a file. A worker has a log of its own.

const node = typeof process !== "undefined" && process.versions?.node !== undefined;
const moduleName = "node:fs"; // a variable, so that bundlers for browsers leave it alone
const fs = node ? await import(/* @vite-ignore */ /* webpackIgnore: true */ moduleName) : null;
const environment = node ? process.env : Object.fromEntries(new URLSearchParams(globalThis.location?.search ?? ""));

let pixels = null; // a set of "x,y"
let on = false; // within a pixel that is logged
let file = null; // in node
let lines = []; // in a browser

/** Selects the pixels: "320,350;12,40". */
export function select(list) {
  const chosen = String(list ?? "").split(";").map((pair) => pair.split(",").map(Number));
  const valid = chosen.filter((pair) => pair.length === 2 && pair.every(Number.isInteger));
  pixels = valid.length > 0 ? new Set(valid.map(([x, y]) => `${x},${y}`)) : null;
}
select(environment.GLINT_PIXELS);

function write(line) {
  if (fs === null) {
    lines.push(line);
    return;
  }
  if (file === null) file = fs.openSync(environment.GLINT_LOG || "glint.log", "w");
  fs.writeSync(file, `${line}\n`);
}

function toWords(value) {
  if (typeof value === "boolean") return value ? "1" : "0";
  if (typeof value === "string") return /[\s,;:=#()[\]{}]/.test(value) ? `"${value}"` : value;
  if (Math.abs(value) === Number.POSITIVE_INFINITY) return value < 0 ? "-inf" : "inf";
  if (typeof value !== "object" || value === null) return String(value); // of a number: with its full precision
  if (typeof value[Symbol.iterator] === "function") return Array.from(value, toWords).join(" ");
  if ("x" in value) return [value.x, value.y, value.z].join(" ");
  return [value.r, value.g, value.b].join(" ");
}

const toLine = (key, values) => [key, ...values.map(toWords)].join(" ");

export function about(key, ...values) {
  if (pixels !== null) write(toLine(key, values));
}

export function pixel(x, y) {
  on = pixels?.has(`${x},${y}`) ?? false;
  if (on) write(`pixel ${x} ${y}`);
  return on;
}

export function endPixel() {
  on = false;
}

export function value(key, ...values) {
  if (on) write(toLine(key, values));
}

export function ray(kind) {
  value("ray", kind);
}

export function end() {
  value("end");
}

export function light(number) {
  value("light", number);
}

/** The log so far, in a browser. */
export function text() {
  return lines.map((line) => `${line}\n`).join("");
}

/** Forgets the log so far, in a browser: before the picture is rendered again. */
export function clear() {
  lines = [];
}

/** Saves the log as a file, in a browser. */
export function download(name = "glint.log") {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text()], { type: "text/plain" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
