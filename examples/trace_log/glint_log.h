// SPDX-License-Identifier: Apache-2.0 OR MIT-0
// Writes the log of a ray tracer for `glint diagnose` (docs/formats/trace_log.md). One header, C99 or C++11,
// no dependencies. Copy it into your program, and call, in the order in which your program computes:
//
//     glint_pixel(x, y);                      begins a pixel; returns 1 if this pixel is logged, else 0
//     glint_ray("camera");                    begins a ray; "mirror", "glass": from the open ray's hit
//     glint_vector("origin", o.x, o.y, o.z);  a point or vector
//     glint_color("diffuse", r, g, b);        a color
//     glint_number("t", t);                   a number
//     glint_flag("blocked", 1);               0 or 1
//     glint_name("shape", "ball");            a name
//     glint_word("miss");                     a key alone
//     glint_light(1);                         begins a light at the hit of the open ray
//     glint_end();                            ends the open ray
//     glint_pixel_end();                      ends the pixel
//     glint_about("size", "64 48");           a line about the whole log, once before the first pixel
//
// The environment variable GLINT_PIXELS="320,350;12,40" selects the pixels; without it, nothing is logged,
// and each call costs one branch (glint_pixel: a getenv). GLINT_LOG names the file; default: glint.log. Each
// line is flushed, so a crash loses none. Threads may log: a pixel that is logged waits until that of another
// thread has ended.
#ifndef GLINT_LOG_H_
#define GLINT_LOG_H_

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// One variable for all source files that include this header, and a thread's own variable.
#if defined(_WIN32)
#define GLINT_SHARED_ __declspec(selectany)
#else
#define GLINT_SHARED_ __attribute__((weak))
#endif
#if defined(_MSC_VER)
#define GLINT_THREAD_ __declspec(thread)
#else
#define GLINT_THREAD_ __thread
#endif

GLINT_SHARED_ FILE* glint_file_ = NULL;
GLINT_SHARED_ GLINT_THREAD_ int glint_on_ = 0;  // this thread is in a pixel that is logged

// The log's lock is that of stdin: it exists before the first thread, and no renderer reads stdin meanwhile.
#if defined(_WIN32)
static inline void glint_lock_(void) { _lock_file(stdin); }
static inline void glint_unlock_(void) { _unlock_file(stdin); }
#else
#ifndef __cplusplus
void flockfile(FILE* file);  // POSIX; -std=c99 hides them
void funlockfile(FILE* file);
#endif
static inline void glint_lock_(void) { flockfile(stdin); }
static inline void glint_unlock_(void) { funlockfile(stdin); }
#endif

static inline int glint_is_selected_(const char* list, int x, int y) {
    int px, py;
    while (list != NULL && sscanf(list, " %d , %d", &px, &py) == 2) {
        if (px == x && py == y) return 1;
        list = strchr(list, ';');
        if (list != NULL) ++list;
    }
    return 0;
}

static inline void glint_open_(void) {
    const char* name = getenv("GLINT_LOG");
    if (glint_file_ != NULL) return;
    if (name == NULL || *name == 0) name = "glint.log";
    glint_file_ = fopen(name, "w");
    if (glint_file_ == NULL) {
        fprintf(stderr, "glint_log.h: cannot write %s; the log goes to stderr\n", name);
        glint_file_ = stderr;
    }
}

static inline void glint_end_line_(void) {
    fputc('\n', glint_file_);
    fflush(glint_file_);
}

static inline void glint_pixel_end(void) {
    if (!glint_on_) return;
    glint_on_ = 0;
    glint_unlock_();
}

static inline int glint_pixel(int x, int y) {
    glint_pixel_end();  // if it was forgotten
    if (!glint_is_selected_(getenv("GLINT_PIXELS"), x, y)) return 0;
    glint_lock_();
    glint_open_();
    glint_on_ = 1;
    fprintf(glint_file_, "pixel %d %d", x, y);
    glint_end_line_();
    return 1;
}

static inline void glint_about(const char* key, const char* value) {
    if (getenv("GLINT_PIXELS") == NULL) return;
    glint_lock_();
    glint_open_();
    fprintf(glint_file_, "%s %s", key, value);
    glint_end_line_();
    glint_unlock_();
}

static inline void glint_word(const char* key) {
    if (!glint_on_) return;
    fputs(key, glint_file_);
    glint_end_line_();
}

static inline void glint_name(const char* key, const char* name) {
    if (!glint_on_) return;
    fprintf(glint_file_, strpbrk(name, " \t,;:=#()[]{}") != NULL ? "%s \"%s\"" : "%s %s", key, name);
    glint_end_line_();
}

static inline void glint_flag(const char* key, int flag) {
    if (!glint_on_) return;
    fprintf(glint_file_, "%s %d", key, flag != 0);
    glint_end_line_();
}

static inline void glint_number(const char* key, double value) {
    if (!glint_on_) return;
    fprintf(glint_file_, "%s %.17g", key, value);
    glint_end_line_();
}

static inline void glint_vector(const char* key, double x, double y, double z) {
    if (!glint_on_) return;
    fprintf(glint_file_, "%s %.17g %.17g %.17g", key, x, y, z);
    glint_end_line_();
}

static inline void glint_color(const char* key, double r, double g, double b) { glint_vector(key, r, g, b); }
static inline void glint_ray(const char* kind) { glint_name("ray", kind); }
static inline void glint_end(void) { glint_word("end"); }

static inline void glint_light(int number) {
    if (!glint_on_) return;
    fprintf(glint_file_, "light %d", number);
    glint_end_line_();
}

#endif  // GLINT_LOG_H_
