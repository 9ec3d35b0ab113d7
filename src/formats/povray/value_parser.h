// SPDX-License-Identifier: Apache-2.0
#pragma once
// Values: numbers, vectors, colors, strings, arrays and functions; and what reads any value.
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "formats/povray/token_stream.h"

namespace glint::povray {

/// Comparisons of functions are exact: they have symbols of their own.
char exact_comparison(char symbol);
char rough_comparison(char symbol, bool& is_exact);

class ValueParser : public TokenStream {
  protected:
    using TokenStream::TokenStream;

    // Numbers.

    Numbers expression();            // terms, without comparisons
    Numbers full_expression();       // with comparisons, `&`, `|` and `? :`
    double number();                 // of one term
    Vec3 vector();                   // of three terms; a single number fills them
    double number_or(double value);  // an optional number
    bool flag();                     // an optional number that stands for true or false
    bool begins_number(const Token& token);

    // Colors.

    bool begins_color(const Token& token);
    std::array<double, 5> color(bool from_numbers);
    Numbers color_value();

    // Strings.

    bool begins_string(const Token& token);
    String string();

    // Any value, and what identifiers stand for.

    Value value();
    Value named_value(const Token& name);
    template <class T> std::shared_ptr<const T> named(const Token& name);
    bool read_defined();

    // Arrays.

    std::vector<std::uint32_t> read_indices();
    Value read_element(const Token& name, Value array);
    void assign_element(const Token& name, Value& whole, std::span<const std::uint32_t> indices,
                        Value assigned);

    /// Of the language: what #version gives, and its place.
    std::optional<double> version_;
    Token version_place_;
    /// What assumed_gamma gives; is_gamma_srgb_: as the word `srgb`.
    std::optional<double> gamma_;
    bool is_gamma_srgb_ = false;

    /// Whether a string of the text, not of chr() and the like, has characters beyond ASCII.
    bool has_text_beyond_ascii_ = false;
    /// `charset utf8`: else, POV-Ray draws these as spaces. (Measured)
    bool is_utf8_ = false;

    static bool is_beyond_ascii(std::string_view text);

  private:
    /// A value that begins with `first`, the next token, and is none of these: an object, a texture ...
    /// Unset, and nothing is read, if no value begins here.
    virtual Value other_value(const Token& first) = 0;

    // colors.cpp
    double of_srgb(double c) const;

    // expressions.cpp
    Numbers comparison();
    Numbers product();
    Numbers factor();
    Numbers combine(char op, const Token& at, Numbers a, Numbers b);
    Numbers expression_after(Numbers first);

    // operands.cpp
    Numbers primary();
    Numbers suffixed(Numbers value);
    Numbers vector_literal();
    Numbers identifier(const Token& name);
    bool is_end_of_number(std::uint32_t skipped) const;

    // functions.cpp
    Numbers function(const Token& name);
    double argument();
    double integer(const Token& name, double x);
    Vec3 vector_argument();
    Numbers call(const Token& name);
    Numbers array_size(const Token& name);
    RenderSettings scene_size() const;
    std::optional<double> declared_number(std::string_view name) const;

    // user_functions.cpp
    std::shared_ptr<const Function> read_function(const Token& at);
    std::uint32_t parameter_name(const Token& token);
    std::string what_problem(const Token& token);
    bool take_part(Token& token, const Function& function, const std::vector<std::uint32_t>& axes);
    Numbers call_function(const Token& name, const std::shared_ptr<const Function>& function);

    // splines.cpp
    bool read_spline_kind(std::size_t& kind);
    std::shared_ptr<const ValueSpline> read_value_spline();
    Numbers call_spline(const Token& name, const std::shared_ptr<const ValueSpline>& spline);

    // strings.cpp
    CountedString string_function(Word word);
    double value_of(const Token& at, std::string_view text);
    int compare(std::string_view a, std::string_view b);

    // values.cpp
    Value identifier_value(const Token& name);
    Numbers extent(const Token& function);

    // rays.cpp
    struct Traced;
    const Traced* traced(const std::shared_ptr<const Object>& object, const Token& at);
    std::shared_ptr<const Object> object_argument();
    Numbers trace(const Token& function);
    Numbers inside(const Token& function);

    // arrays.cpp
    Value array_value(const Token& at);
    void read_elements(Array& array, std::size_t dimensions, std::size_t& next, bool has_sizes);
    bool hold(Array& array, const Value& element, const Token& at);
    bool spend_elements(const Token& at, std::uint64_t count);
    std::uint32_t index();
    const Value* element(const Token& name, const Value& array, std::span<const std::uint32_t> indices);

    std::vector<std::uint32_t> random_;  // the states of seed()
    std::uint64_t elements_ = 0;
    std::vector<std::shared_ptr<const Traced>> traced_;
    std::uint64_t traced_bytes_ = 0;
};

// What an identifier that has been read, or an element of an array, stands for; null if that is nothing of
// this kind.
template <class T> std::shared_ptr<const T> ValueParser::named(const Token& name) {
    const Value value = named_value(name);
    const auto* held = std::get_if<std::shared_ptr<const T>>(&value);
    return held != nullptr ? *held : nullptr;
}

}  // namespace glint::povray
