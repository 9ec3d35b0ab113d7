# SPDX-License-Identifier: Apache-2.0 OR MIT-0
"""Writes the log of a ray tracer for `glint diagnose` (docs/formats/trace_log.md). One file, Python 3.8 or later, no dependencies.

Copy it into your program, and call, in the order in which your program computes:

    import glint_log as log

    log.about("size", 64, 48)          a line about the whole log, once before the first pixel
    log.pixel(x, y)                    begins a pixel; returns True if this pixel is logged
    log.ray("camera")                  begins a ray; "mirror", "glass": from the surface that the open ray has hit
    log.value("origin", origin)        a vector or color: tuple, list, NumPy array, or three numbers
    log.value("t", t)                  a number
    log.value("blocked", True)         a flag
    log.value("shape", "ball")         a name
    log.value("miss")                  a key alone
    log.light(1)                       begins a light at the hit of the open ray
    log.end()                          ends the open ray
    log.end_pixel()                    ends the pixel

The environment variable GLINT_PIXELS="320,350;12,40" selects the pixels; without it, nothing is logged, and each call costs one branch.
GLINT_LOG names the file; default: glint.log. Each line is flushed, so a crash loses none. Threads may log: a pixel that is
logged waits until the one of another thread has ended. Processes (multiprocessing) append to one file: let them log one pixel only.
"""
import multiprocessing
import os
import threading


def _parse(text):
    try:
        return {(int(x), int(y)) for x, y in (pair.split(",") for pair in text.split(";") if pair.strip())}
    except ValueError:
        raise SystemExit('GLINT_PIXELS: expected "320,350;12,40", found "%s"' % text)


class _Thread(threading.local):
    on = False  # this thread is in a pixel that is logged


_pixels = _parse(os.environ.get("GLINT_PIXELS", ""))
_name = os.environ.get("GLINT_LOG") or "glint.log"
_thread = _Thread()
_lock = threading.RLock()
_file = None
if _pixels and multiprocessing.parent_process() is None:
    open(_name, "w").close()


def _write(line):
    global _file
    if _file is None:
        _file = open(_name, "a", buffering=1)
    _file.write(line + "\n")
    _file.flush()


def _texts(value):
    """The words of a value; those of vectors one after the other."""
    if isinstance(value, str):
        yield '"%s"' % value if any(c in " \t,;:=#()[]{}" for c in value) else value
    elif hasattr(value, "__iter__") and getattr(value, "ndim", 1) > 0:
        for part in value:
            yield from _texts(part)
    elif isinstance(value, (bool, int)) or str(getattr(value, "dtype", "")) == "bool":
        yield str(int(value))
    else:
        single = str(getattr(value, "dtype", "")) in ("float16", "float32")
        yield ("%.9g" if single else "%.17g") % value


def _line(key, values):
    return " ".join([key, *_texts(values)])


def about(key, *values):
    if not _pixels:
        return
    with _lock:
        _write(_line(key, values))


def pixel(x, y):
    if not _pixels:
        return False
    end_pixel()  # if it was forgotten
    if (int(x), int(y)) not in _pixels:
        return False
    _lock.acquire()
    _thread.on = True
    value("pixel", int(x), int(y))
    return True


def end_pixel():
    if not _thread.on:
        return
    _thread.on = False
    _lock.release()


def value(key, *values):
    if _thread.on:
        _write(_line(key, values))


def ray(kind):
    value("ray", kind)


def end():
    value("end")


def light(number):
    value("light", number)
