// SPDX-License-Identifier: Apache-2.0
#pragma once
// The Standard Procedural Databases (Eric Haines, "A Proposal for Standard Graphics Environments", IEEE
// Computer Graphics and Applications, November 1987; lattice: Antonio Costa, 1993), rewritten. Sizes,
// views, lights and surfaces are the originals.
#include <span>

#include "scene_writer.h"

namespace spd {

struct Database {
    const char* name;
    int default_size, max_size;  ///< size factors go from 1
    void (*write)(SceneWriter& out, int size);
};

std::span<const Database> databases();

void write_balls(SceneWriter& out, int size);
void write_tetra(SceneWriter& out, int size);
void write_gears(SceneWriter& out, int size);
void write_mount(SceneWriter& out, int size);
void write_rings(SceneWriter& out, int size);
void write_tree(SceneWriter& out, int size);
void write_lattice(SceneWriter& out, int size);
void write_teapot(SceneWriter& out, int size);

}  // namespace spd
