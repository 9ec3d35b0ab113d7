// SPDX-License-Identifier: Apache-2.0
#pragma once
// What was added to the list of a scene's shapes and removed from it, so that an older World can follow.
#include <cstdint>
#include <optional>
#include <vector>

namespace glint::python {

/// Shapes are added at the end.
class ShapeHistory {
  public:
    /// The version of the list; another one after each change.
    std::uint64_t version() const { return version_; }
    /// The list at this version has been read, so that later changes must be told from earlier ones.
    void seal() { is_sealed_ = true; }

    void add(std::size_t count);
    /// Sorted numbers, without repetitions.
    void remove(std::vector<std::uint32_t> numbers);
    /// Forgets what is older than `version`, and everything if it is no longer useful for `shapes` shapes.
    void forget(std::uint64_t version, std::size_t shapes);

    struct Change {
        std::vector<std::uint32_t> removed;  // sorted numbers of the old list
        std::size_t added = 0;               // at the end of the new one
    };
    /// From a version with this number of shapes until now; nothing if it is not known.
    std::optional<Change> since(std::uint64_t version, std::size_t shapes) const;

  private:
    // Shapes are removed, or added.
    struct Step {
        std::uint64_t from = 0, to = 0;  // versions
        std::vector<std::uint32_t> removed;
        std::size_t added = 0;
    };
    std::uint64_t version_ = 0;
    std::vector<Step> steps_;  // each from the version that the one before leads to
    bool is_sealed_ = true;
};

}  // namespace glint::python
