// SPDX-License-Identifier: Apache-2.0
// Arrays and their elements.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/value_parser.h"

namespace glint::povray {

bool ValueParser::spend_elements(const Token& at, std::uint64_t count) {
    elements_ += count;
    if (elements_ <= k_max_elements) return true;
    error(at, fmt::format("more than {} elements of arrays", k_max_elements));
    return false;
}

// array[SIZE]... { elements }, also without sizes.
Value ValueParser::array_value(const Token& at) {
    auto array = make_counted<Array>();
    std::uint64_t count = 1;
    while (!failed() && peek().is('[')) {
        const Token size_at = peek();
        const std::uint32_t size = index();
        if (!failed() && size < 1) error(size_at, "expected at least one element");
        if (array->sizes.size() >= 5) error(size_at, "expected at most five dimensions");
        array->sizes.push_back(size);
        count = std::min<std::uint64_t>(count * size, k_max_elements + 1);
    }
    if (failed()) return {};
    const bool has_sizes = !array->sizes.empty();
    if (has_sizes) {
        if (!spend_elements(at, count)) return {};
        if (!reading().memory.has_room(MemoryBudget::list_bytes(count, sizeof(Value)))) {
            reading().memory.add(MemoryBudget::list_bytes(count, sizeof(Value)));
            is_within_memory(at);
            return {};
        }
        array->elements.resize(static_cast<std::size_t>(count));
    }
    if (peek().is('{')) {
        std::size_t next = 0;
        read_elements(*array, has_sizes ? array->sizes.size() : 1, next, has_sizes);
        if (!has_sizes) array->sizes.push_back(static_cast<std::uint32_t>(array->elements.size()));
    } else if (!has_sizes) {
        expected("`[` or `{`");
    }
    return array;
}

// Notes an element of an array. False, with an error, if arrays are too deep within each other.
bool ValueParser::hold(Array& array, const Value& element, const Token& at) {
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&element)) {
        array.depth = std::max(array.depth, (*inner)->depth + 1);
        if (array.depth > k_max_depth) {
            error(at, fmt::format("arrays are nested more than {} deep", k_max_depth));
        }
    }
    return !failed();
}

// The elements of the last `dimensions` dimensions, in braces.
void ValueParser::read_elements(Array& array, std::size_t dimensions, std::size_t& next, bool has_sizes) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    while (!failed() && !accept('}')) {
        if (dimensions > 1) {
            read_elements(array, dimensions - 1, next, has_sizes);
        } else {
            const Token at = peek();
            Value element = value();
            if (failed() || !hold(array, element, at)) return;
            if (!has_sizes) {
                if (!spend_elements(at, 1)) return;
                array.elements.push_back(std::move(element));
            } else if (next >= array.elements.size()) {
                return error(at, fmt::format("expected `}}` after {} elements", array.elements.size()));
            } else {
                array.elements[next++] = std::move(element);
            }
        }
        accept(',');
    }
}

// [number]
std::uint32_t ValueParser::index() {
    if (!expect('[')) return 0;
    const Token at = peek();
    const double value = number();
    expect(']');
    if (failed()) return 0;
    if (!(value >= 0 && value <= 4e9)) {
        error(at, "expected an index from 0 to 4e9");
        return 0;
    }
    return static_cast<std::uint32_t>(value + 1e-8);
}

std::vector<std::uint32_t> ValueParser::read_indices() {
    std::vector<std::uint32_t> indices;
    while (!failed() && peek().is('[')) indices.push_back(index());
    return indices;
}

// The element of an array whose name has been read. Unset after an error. `array` is a copy: if the name is
// the last word of a macro, the look for a `[` ends the macro, and its parameters and locals.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
Value ValueParser::read_element(const Token& name, const Value array) {
    const std::vector<std::uint32_t> indices = read_indices();
    const Value* found = failed() ? nullptr : element(name, array, indices);
    return found != nullptr ? *found : Value();
}

// Null after an error.
const Value* ValueParser::element(const Token& name, const Value& from,
                                  std::span<const std::uint32_t> indices) {
    const auto* held = std::get_if<std::shared_ptr<Array>>(&from);
    if (held == nullptr) {
        error(name, fmt::format("{} is not an array", quoted(name_of(name.name))));
        return nullptr;
    }
    const Array& array = **held;
    std::size_t at = 0;
    for (std::size_t i = 0; i < array.sizes.size(); ++i) {
        if (i >= indices.size()) {
            error(name,
                  fmt::format("expected {} indices of {}", array.sizes.size(), quoted(name_of(name.name))));
            return nullptr;
        }
        if (indices[i] >= array.sizes[i]) {
            error(name, fmt::format("expected an index below {}, found {}", array.sizes[i], indices[i]));
            return nullptr;
        }
        at = at * array.sizes[i] + indices[i];
    }
    const Value& found = array.elements[at];
    if (indices.size() > array.sizes.size()) return element(name, found, indices.subspan(array.sizes.size()));
    return &found;
}

// Copies those of the arrays around the element that others share.
void ValueParser::assign_element(const Token& name, Value& whole, std::span<const std::uint32_t> indices,
                                 Value assigned) {
    if (element(name, whole, indices) == nullptr) return;
    Value* at = &whole;
    std::vector<Array*> around;
    do {
        auto& held = std::get<std::shared_ptr<Array>>(*at);
        if (held.use_count() > 1) {
            if (!spend_elements(name, held->elements.size())) return;
            held = make_counted<Array>(std::as_const(*held));
        }
        std::size_t offset = 0;
        for (std::size_t i = 0; i < held->sizes.size(); ++i) offset = offset * held->sizes[i] + indices[i];
        indices = indices.subspan(held->sizes.size());
        around.push_back(held.get());
        at = &held->elements[offset];
    } while (!indices.empty());
    if (!hold(*around.back(), assigned, name)) return;
    *at = std::move(assigned);
    for (std::size_t i = around.size(); --i > 0 && !failed();) {
        around[i - 1]->depth = std::max(around[i - 1]->depth, around[i]->depth + 1);
        if (around[i - 1]->depth > k_max_depth) {
            error(name, fmt::format("arrays are nested more than {} deep", k_max_depth));
        }
    }
}

// dimensions(ARRAY), dimension_size(ARRAY, i)
Numbers ValueParser::array_size(const Token& name) {
    const Token token = take();
    const Value* value = find_value(token);
    const auto* array = value ? std::get_if<std::shared_ptr<Array>>(value) : nullptr;
    if (array == nullptr) {
        error(token, fmt::format("expected an array, found {}{}", describe(token), what_is(token)));
        return {};
    }
    const CountedVector<std::uint32_t> sizes = (*array)->sizes;
    if (name.word() == Word::k_dimensions) return static_cast<double>(sizes.size());
    accept(',');
    const Token at = peek();
    const double i = number();
    if (!failed() && !(i >= 1 && i <= static_cast<double>(sizes.size()))) {
        error(at, fmt::format("expected a number from 1 to {}", sizes.size()));
    }
    return failed() ? 0.0 : static_cast<double>(sizes[static_cast<std::size_t>(i) - 1]);
}

}  // namespace glint::povray
