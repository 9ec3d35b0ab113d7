// SPDX-License-Identifier: Apache-2.0
#pragma once
// The lists of large meshes: numbers and vectors of plain numbers in a block, which is one token.
#include <string_view>

#include "glint/vec.h"

namespace glint::povray {

/// The end of a list, where its block's `}` is. Null if something else than numbers, vectors of two or three
/// of them, and commas between these is in it, or what could be an expression.
const char* end_of_number_list(const char* from, const char* end);

/// Reads a list that end_of_number_list() has accepted.
class NumberList {
  public:
    NumberList() = default;
    explicit NumberList(std::string_view text)
        : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {
        skip_blanks();
    }
    bool at_end() const { return at_ == end_; }
    /// Not at the end: whether a vector is next.
    bool is_vector() const { return *at_ == '<'; }
    /// Of what is next, in bytes.
    std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    /// The next item, and the comma after it. A vector of two numbers gets a 0; is_short is set then.
    double number();
    Vec3 vector(bool& is_short);

  private:
    void skip_blanks();
    double read();
    void end_item();

    const char* begin_ = nullptr;
    const char* at_ = nullptr;
    const char* end_ = nullptr;
};

}  // namespace glint::povray
