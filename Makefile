# SPDX-License-Identifier: Apache-2.0
# The short way in: make demo, make test. CMakePresets.json has every configuration.
PREFIX ?= /usr/local
glint = build/release/glint

.PHONY: help deps demo test test-all test-aarch64 test-blender test-mpi test-node test-windows test-peers test-python blender build install uninstall release web playground site tidy fuzz bench format generated clean

help:
	@echo 'make demo     installs what is missing, builds glint, renders castle.png and explains one of its pixels'
	@echo 'make test     installs what is missing and runs the tests of glint, its browser build and its page'
	@echo 'make test-all runs these and the ones with the other compiler and with sanitizers'
	@echo 'make deps     installs what is missing to build the command and the library; nothing else'
	@echo 'make build    builds $(glint)'
	@echo 'make install  installs the command and the library (PREFIX=$(PREFIX), DESTDIR=$(DESTDIR))'
	@echo 'make uninstall  removes what make install has installed last (DESTDIR=$(DESTDIR))'
	@echo 'make playground  builds the web page (make web: to web/dist) and serves it on this machine'
	@echo 'make site     writes the page, the lessons, the documents and the C++ reference to build/site, for any web server'
	@echo 'make bench    installs POV-Ray, Tachyon and Embree and compares glint with them (docs/performance.md)'
	@echo 'make test-aarch64  cross-compiles for 64-bit ARM and runs tests under qemu'
	@echo 'make test-mpi  installs Open MPI, Dask and GNU parallel and tests rendering on many processes (docs/scale_out.md)'
	@echo 'make test-windows installs mingw-w64 and wine, builds the command for Windows and tests it'
	@echo 'make test-node  installs emscripten, builds the command for node and tests it (docs/platforms.md)'
	@echo 'make test-blender  installs Blender (571 MB) and tests the add-on for it (docs/blender.md); make blender builds its zip'
	@echo 'make test-peers  installs POV-Ray and Tachyon and compares their pixels with those of glint, rule by rule'
	@echo 'make test-python  installs the Python package in build/python-venv and tests it (docs/python.md)'
	@echo 'make release  writes the files of a release to build/release-files (tools/make-release)'
	@echo 'make tidy     runs clang-tidy; make format, clang-format; make fuzz, the fuzzers'
	@echo 'make generated writes the tables, schema and types that the terms of an explanation are in'
	@echo 'make clean    removes what was built'

started := $(shell date +%s)
demo: build
	@$(glint) render scenes/epfl/castle.json --size 640x640 --reflections 4 -o castle.png
	@echo 'Why is the pixel 320,350 this color?'
	@$(glint) explain scenes/epfl/castle.json --size 640x640 --reflections 4 -p 320,350
	@echo "The picture is $$PWD/castle.png; the demo took $$(($$(date +%s) - $(started))) s. What to try next:"
	@echo '  $(glint) render scenes/cgfs/three_mirrors.cgfs --show     # the picture in the terminal'
	@echo '  $(glint) check scenes/faults/black.glint                  # what is wrong with this scene?'
	@echo '  make playground                                           # the same in the browser'

test:
	@tools/install-dependencies tests
	@tools/run-tests

test-all:
	@tools/install-dependencies all-tests
	@tools/run-tests all

# Cross-compiled, and run by qemu: the same pixel values on 64-bit ARM.
test-aarch64:
	@tools/install-dependencies aarch64
	@tools/run-tests aarch64

# On many processes: MPI, GNU parallel, Dask.
test-mpi:
	@tools/install-dependencies mpi
	@tools/run-tests mpi

# The programs for Windows, run by wine.
test-windows:
	@tools/install-dependencies windows
	@tools/run-tests windows

# The command in node, from the npm package.
test-node:
	@tools/install-dependencies node
	@tools/run-tests node

# The add-on, in Blender itself.
test-blender:
	@tools/install-dependencies blender
	@tools/run-tests blender

# Small scenes beside POV-Ray and Tachyon.
test-peers:
	@tools/install-dependencies command
	@tools/install-dependencies peers
	@tools/run-tests peers

# The Python package, by Debian's Python.
test-python:
	@tools/install-dependencies python
	@tools/run-tests python

# The add-on's zip.
blender:
	@python3 blender/package.py

deps:
	@tools/install-dependencies command

build: deps
	@[ -e build/release/build.ninja ] || cmake --preset release -DGLINT_TESTS=OFF >/dev/null
	@cmake --build --preset release --target glint_command

install: build
	@cmake --build --preset release
	@DESTDIR='$(DESTDIR)' cmake --install build/release --prefix '$(PREFIX)'
	@cp build/release/install_manifest.txt build/installed.txt

uninstall:
	@tools/uninstall build/installed.txt '$(DESTDIR)'

release:
	@tools/install-dependencies release
	@tools/make-release

web:
	@tools/install-dependencies web
	@tools/build-web

# PORT: where; 0 is any that is free.
PORT ?= 8080
playground: web
	@node web/tools/serve.mjs web/dist $(PORT)

# One folder of static files: the page, the lessons, the documents, the C++ reference.
site:
	@tools/install-dependencies site
	@tools/make-site

tidy:
	@tools/install-dependencies checks
	@tools/run-tidy

# Runs the fuzzers, FUZZ_SECONDS for each reader.
FUZZ_SECONDS ?= 60
fuzz:
	@tools/install-dependencies checks
	@tools/run-fuzzers $(FUZZ_SECONDS)

# BENCH: further arguments of tools/bench, e.g. BENCH='--rounds 3 --scenes balls,gears'.
bench:
	@tools/install-dependencies bench
	@[ -e build/bench/build.ninja ] || cmake --preset bench >/dev/null
	@cmake --build build/bench
	@tools/bench $(BENCH)

format:
	@git ls-files '*.cpp' '*.h' | xargs clang-format-14 -i

# What the table of an explanation's terms is written to.
generated: build
	@cmake build/release -DGLINT_TESTS=ON >/dev/null && cmake --build build/release --target write_terms && build/release/tests/explain/write_terms .

clean:
	rm -rf build web/dist web/node_modules web/src/gallery web/src/lessons
