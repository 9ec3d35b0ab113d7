// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text as Windows has it: UTF-16.
#include <string>
#include <string_view>

namespace glint::os {

std::wstring to_wide(std::string_view text);
std::string to_utf8(std::wstring_view text);

/// A path for Windows' functions, which take more than 260 characters only of whole paths that are marked.
std::wstring system_path(std::string_view path);

/// The system's handle of a descriptor.
void* handle_of(int descriptor);

/// Sets errno from the error of the last call of Windows.
void set_errno();

}  // namespace glint::os
