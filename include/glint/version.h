// SPDX-License-Identifier: Apache-2.0
#pragma once
// The only definition of the version; CMake reads it from here.
#define GLINT_VERSION "0.3.0"
