// SPDX-License-Identifier: Apache-2.0
// Values: what #declare and the parameters of macros take. Arrays.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

Value Reader::value() {
    const Token token = peek();
    if (token.kind == TokenKind::number || token.is('<')) return expression();
    if (begins_string(token)) return string();
    if (token.kind != TokenKind::word) return expression();
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    if (!Names::is_reserved(token.name)) return identifier_value(token);
    switch (token.word()) {
        case Word::k_array:
            take();
            return array_value(token);
        case Word::k_texture: {
            // Several textures are the layers of one.
            std::shared_ptr<const Texture> texture;
            while (!failed_ && accept(Word::k_texture)) texture = layered(texture, read_texture());
            return texture;
        }
        case Word::k_pigment: {
            take();
            Pigment pigment = default_texture_.pigment;
            read_pigment(pigment);
            return make_counted<const Pigment>(std::move(pigment));
        }
        case Word::k_finish: {
            take();
            Finish finish = default_texture_.finish;
            read_finish(finish);
            return make_counted<const Finish>(std::move(finish));
        }
        case Word::k_material:
            take();
            return make_counted<const MaterialValue>(read_material());
        case Word::k_camera:
            take();
            return make_counted<const CameraItems>(read_camera(token));
        case Word::k_function:
            take();
            return read_function(token);
        case Word::k_transform:
            take();
            return make_counted<const Affine>(read_transform_block());
        default:
            break;
    }
    if (begins_object(token)) return read_part();
    if (begins_number(token) || begins_color(token)) return expression();
    if (is_opaque(token.word())) {
        take();
        return read_opaque(token.word(), token);
    }
    expected("a value");
    return {};
}

// A copy of what the identifier stands for, or an expression that begins with it.
Value Reader::identifier_value(const Token& name) {
    const Value* value = find_value(name.name);
    if (value == nullptr) {
        const std::string_view word = names_.name(name.name);
        if (begins_object(name)) return read_part();
        if (!povray_meaning(word).empty() && !at_frame_end() && raw().is('{')) {  // media, a map, ...
            take();
            return read_opaque(Word::k_none, name);
        }
        error(name, fmt::format("expected a value, found {}{}", quoted(word), what_is(name)));
        return {};
    }
    if (std::holds_alternative<Numbers>(*value)) return expression();
    if (std::holds_alternative<std::shared_ptr<Array>>(*value)) {
        Value whole = *value;
        take();
        if (!peek().is('[')) return whole;
        const Value element = read_element(name, whole);
        const auto* function = std::get_if<std::shared_ptr<const Function>>(&element);
        if (function != nullptr && peek().is('(')) return expression_after(call_function(name, *function));
        const auto* numbers = std::get_if<Numbers>(&element);
        return numbers != nullptr ? expression_after(*numbers) : element;
    }
    const bool is_called =
        std::holds_alternative<std::shared_ptr<const Function>>(*value) && !at_frame_end() && raw().is('(');
    if (is_called) return expression();
    Value copy = *value;
    take();
    return copy;
}

// The value of an identifier that has been read, also of an element of an array.
Value Reader::named_value(const Token& name) {
    if (name.kind != TokenKind::word || Names::is_reserved(name.name)) return {};
    const Value* value = find_value(name.name);
    if (value == nullptr) return {};
    Value whole = *value;
    if (!std::holds_alternative<std::shared_ptr<Array>>(whole) || !peek().is('[')) return whole;
    return read_element(name, whole);
}

// The rest of an expression whose first operand has been read.
Numbers Reader::expression_after(Numbers first) {
    first = suffixed(first);
    while (!failed_ && (peek().is('*') || peek().is('/'))) {
        const Token at = take();
        first = combine(at.symbol, at, first, factor());
    }
    while (!failed_ && (peek().is('+') || peek().is('-'))) {
        const Token at = take();
        first = combine(at.symbol, at, first, product());
    }
    return first;
}

bool Reader::spend_elements(const Token& at, std::uint64_t count) {
    elements_ += count;
    if (elements_ <= k_max_elements) return true;
    error(at, fmt::format("more than {} elements of arrays", k_max_elements));
    return false;
}

// array[SIZE]... { elements }, also without sizes.
Value Reader::array_value(const Token& at) {
    auto array = make_counted<Array>();
    std::uint64_t count = 1;
    while (!failed_ && peek().is('[')) {
        const Token size_at = peek();
        const std::uint32_t size = index();
        if (!failed_ && size < 1) error(size_at, "expected at least one element");
        if (array->sizes.size() >= 5) error(size_at, "expected at most five dimensions");
        array->sizes.push_back(size);
        count = std::min<std::uint64_t>(count * size, k_max_elements + 1);
    }
    if (failed_) return {};
    const bool has_sizes = !array->sizes.empty();
    if (has_sizes) {
        if (!spend_elements(at, count)) return {};
        if (!reading_.memory.has_room(MemoryBudget::list_bytes(count, sizeof(Value)))) {
            reading_.memory.add(MemoryBudget::list_bytes(count, sizeof(Value)));
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
bool Reader::hold(Array& array, const Value& element, const Token& at) {
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&element)) {
        array.depth = std::max(array.depth, (*inner)->depth + 1);
        if (array.depth > k_max_depth) {
            error(at, fmt::format("arrays are nested more than {} deep", k_max_depth));
        }
    }
    return !failed_;
}

// The elements of the last `dimensions` dimensions, in braces.
void Reader::read_elements(Array& array, std::size_t dimensions, std::size_t& next, bool has_sizes) {
    const Deeper deeper(*this);
    if (!deeper.ok || !expect('{')) return;
    while (!failed_ && !accept('}')) {
        if (dimensions > 1) {
            read_elements(array, dimensions - 1, next, has_sizes);
        } else {
            const Token at = peek();
            Value element = value();
            if (failed_ || !hold(array, element, at)) return;
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
std::uint32_t Reader::index() {
    if (!expect('[')) return 0;
    const Token at = peek();
    const double value = number();
    expect(']');
    if (failed_) return 0;
    if (!(value >= 0 && value <= 4e9)) {
        error(at, "expected an index from 0 to 4e9");
        return 0;
    }
    return static_cast<std::uint32_t>(value + 1e-8);
}

std::vector<std::uint32_t> Reader::read_indices() {
    std::vector<std::uint32_t> indices;
    while (!failed_ && peek().is('[')) indices.push_back(index());
    return indices;
}

// The element of an array whose name has been read. Unset after an error. `array` is a copy: if the name is
// the last word of a macro, the look for a `[` ends the macro, and its parameters and locals.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
Value Reader::read_element(const Token& name, const Value array) {
    const std::vector<std::uint32_t> indices = read_indices();
    const Value* found = failed_ ? nullptr : element(name, array, indices);
    return found != nullptr ? *found : Value();
}

// Null after an error.
const Value* Reader::element(const Token& name, const Value& from, std::span<const std::uint32_t> indices) {
    const auto* held = std::get_if<std::shared_ptr<Array>>(&from);
    if (held == nullptr) {
        error(name, fmt::format("{} is not an array", quoted(names_.name(name.name))));
        return nullptr;
    }
    const Array& array = **held;
    std::size_t at = 0;
    for (std::size_t i = 0; i < array.sizes.size(); ++i) {
        if (i >= indices.size()) {
            error(name, fmt::format("expected {} indices of {}", array.sizes.size(),
                                    quoted(names_.name(name.name))));
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
void Reader::assign_element(const Token& name, Value& whole, std::span<const std::uint32_t> indices,
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
    for (std::size_t i = around.size(); --i > 0 && !failed_;) {
        around[i - 1]->depth = std::max(around[i - 1]->depth, around[i]->depth + 1);
        if (around[i - 1]->depth > k_max_depth) {
            error(name, fmt::format("arrays are nested more than {} deep", k_max_depth));
        }
    }
}

}  // namespace glint::povray
