// SPDX-License-Identifier: Apache-2.0
// The names of a scene: what they stand for in each frame.
#include <algorithm>

#include "formats/povray/token_stream.h"

namespace glint::povray {

// Of a name that the text need not have.
std::uint32_t TokenStream::number_of(std::string_view name) {
    const std::uint32_t number = names_.number_of(name);
    if (bindings_.size() < names_.size()) bindings_.resize(names_.size());
    return number;
}

// What the caller declares.
void TokenStream::declare_numbers() {
    for (const auto& [name, value] : reading_.options.declared) {
        const std::uint32_t number = number_of(name);
        if (!Names::is_reserved(number)) bind(number, 0, Numbers(value));
    }
}

// The binding of a name as a frame sees it. References are followed: `name` becomes that of their target,
// even if it has no binding.
Binding* TokenStream::find_binding(std::uint32_t& name, std::uint32_t depth) {
    for (;;) {
        auto& bindings = bindings_[name];
        auto at = bindings.end();
        if (at != bindings.begin() && (at - 1)->depth > depth) {
            at = std::partition_point(bindings.begin(), bindings.end(),
                                      [&](const Binding& binding) { return binding.depth <= depth; });
        }
        if (at == bindings.begin()) return nullptr;
        --at;
        const auto* reference = std::get_if<Reference>(&at->value);
        if (reference == nullptr) return &*at;
        const Reference next = *reference;  // to a frame outside: this ends
        name = next.name;
        depth = next.depth;
    }
}

// The reference that stands for the same without others between: these cannot change while it exists.
Reference TokenStream::target_of(Reference reference) {
    for (;;) {
        const auto& bindings = bindings_[reference.name];
        const auto after = std::partition_point(bindings.begin(), bindings.end(),
                                                [&](const Binding& b) { return b.depth <= reference.depth; });
        if (after == bindings.begin()) return reference;
        const auto* next = std::get_if<Reference>(&(after - 1)->value);
        if (next == nullptr) return reference;
        reference = *next;
    }
}

const Value* TokenStream::find_value(const Token& token) {
    if (token.kind != TokenKind::word || Names::is_reserved(token.name)) return nullptr;
    std::uint32_t name = token.name;
    const Binding* binding = find_binding(name, depth());
    return binding == nullptr ? nullptr : &binding->value;
}

void TokenStream::bind(std::uint32_t name, std::uint32_t depth, Value value) {
    auto& bindings = bindings_[name];
    auto at = bindings.end();
    while (at != bindings.begin() && (at - 1)->depth > depth) --at;
    if (at != bindings.begin() && (at - 1)->depth == depth) {
        (at - 1)->value = std::move(value);
        return;
    }
    bindings.insert(at, {depth, std::move(value)});
    if (depth > 0) frames_[depth].locals.push_back(name);
}

// Whether the name is that of a parameter of this frame's macro, which stands for an identifier.
bool TokenStream::is_reference(std::uint32_t name, std::uint32_t depth) const {
    const auto& bindings = bindings_[name];
    return std::any_of(bindings.begin(), bindings.end(), [&](const Binding& b) {
        return b.depth == depth && std::holds_alternative<Reference>(b.value);
    });
}

// #declare changes what the name stands for here, if anything; else it declares a global identifier. So does
// #local of a parameter that stands for an identifier.
void TokenStream::assign(std::uint32_t name, bool is_local, std::uint32_t at_depth, Value value) {
    if (is_local && !is_reference(name, at_depth)) return bind(name, at_depth, std::move(value));
    if (Binding* binding = find_binding(name, at_depth)) {
        binding->value = std::move(value);
    } else {
        bind(name, 0, std::move(value));
    }
}

void TokenStream::unbind(std::uint32_t name) {
    if (Binding* binding = find_binding(name, depth())) {
        auto& bindings = bindings_[name];
        const auto at = bindings.begin() + (binding - bindings.data());
        if (at->depth > 0) {
            auto& locals = frames_[at->depth].locals;
            locals.erase(std::find(locals.begin(), locals.end(), name));
        }
        bindings.erase(at);
    }
}

}  // namespace glint::povray
