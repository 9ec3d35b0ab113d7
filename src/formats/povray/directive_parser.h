// SPDX-License-Identifier: Apache-2.0
#pragma once
// Directives: what texts declare, define, include and choose. They move in the frames of the TokenStream.
#include <string>

#include "formats/povray/object_parser.h"

namespace glint::povray {

class DirectiveParser : public ObjectParser {
  protected:
    using ObjectParser::ObjectParser;

    // Those that texts also have without `#`.

    void read_declare(bool is_local);
    void read_default();

  private:
    void read_directive(const Token& at) override;
    void call_macro(const Token& name, const Macro& macro) override;

    // directives.cpp
    void read_undef();
    void read_version();
    void read_message(const Token& at);

    // files.cpp
    void read_fopen();
    bool is_file(const Token& name);
    void read_write();
    void read_fclose();

    // macros.cpp
    void read_macro(const Token& at);

    // conditions.cpp
    /// Whether an `#end` belongs to the directive.
    static bool begins_block(Word directive);
    bool condition();
    void read_if(const Token& at, bool is_true);
    void read_ifdef(const Token& at, bool wanted);
    void read_else(const Token& at);
    void read_elseif(const Token& at);
    void read_end(const Token& at);
    void run_while();
    void read_for(const Token& at);
    void read_switch(const Token& at);
    void read_case(const Token& at);
    void read_break(const Token& at);
    void leave_condition();
    void skip_to_branch(bool to_end_only);
    std::uint32_t find_end(std::uint32_t at, std::uint32_t end) const;

    // includes.cpp
    void read_include(const Token& at);
    struct FoundText {
        Result<std::string> text;
        bool is_own = false;  ///< of POV-Ray's own includes
    };
    std::string path_of(const std::string& name);
    FoundText find_text(const std::string& name);
    void include(const Token& at, const std::string& name);
    void report_missing();
    void add_text(const Token& at, const std::string& path, std::string text);
    void open_text(const Token& at, std::uint16_t number);
};

}  // namespace glint::povray
