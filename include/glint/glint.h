// SPDX-License-Identifier: Apache-2.0
#pragma once
// The whole public API.
#include "glint/check.h"
#include "glint/compare.h"
#include "glint/conventions.h"
#include "glint/diagnostic.h"
#include "glint/explain.h"
#include "glint/export.h"
#include "glint/image.h"
#include "glint/layers.h"
#include "glint/load.h"
#include "glint/render.h"
#include "glint/scene.h"
#include "glint/shapes.h"
#include "glint/vec.h"
#include "glint/version.h"
#include "glint/world.h"
#include "glint/write.h"
