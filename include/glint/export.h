// SPDX-License-Identifier: Apache-2.0
#pragma once
// GLINT_API marks the functions that a shared libglint exports; all others are hidden.

#if defined(__GNUC__)
#define GLINT_API __attribute__((visibility("default")))
#else
#define GLINT_API
#endif
