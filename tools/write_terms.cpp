// SPDX-License-Identifier: Apache-2.0
// Writes what is generated from the table of an explanation's terms (src/explain/terms.h) and from that of a
// material's fields: parts of docs/explain.schema.json, docs/explain.md and src/wasm/glint.d.mts, and
// web/src/ui/terms.ts. With --check it writes nothing, and names the files that are not up to date.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "explain/terms.h"
#include "scene/material_fields.h"

namespace glint {
namespace {

/// The words for the type of a term or field, in a language.
struct Types {
    const char *number, *infinite, *whole, *flag, *vector;
};
constexpr Types k_schema_types = {R"("type": "number")", R"("type": ["number", "null"])",
                                  R"("type": "integer")", R"("type": "boolean")",
                                  R"("$ref": "#/$defs/triple")"};
constexpr Types k_script_types = {"number", "number | null", "number", "boolean", "Vec3"};

template <class Of> const char* type_of(const ExplainedTerm<Of>& term, const Types& types) {
    if (std::holds_alternative<double Of::*>(term.member))
        return term.may_be_infinite ? types.infinite : types.number;
    if (std::holds_alternative<int Of::*>(term.member)) return types.whole;
    return std::holds_alternative<bool Of::*>(term.member) ? types.flag : types.vector;
}
const char* type_of(double, const Types& types) { return types.number; }
const char* type_of(std::int32_t, const Types& types) { return types.whole; }
const char* type_of(std::uint32_t, const Types& types) { return types.infinite; }
const char* type_of(bool, const Types& types) { return types.flag; }
const char* type_of(const Color&, const Types& types) { return types.vector; }

template <class T> std::string quoted(const T& text) { return "\"" + std::string(text) + "\""; }

template <class Of, std::size_t n> std::string schema_of(const ExplainedTerm<Of> (&table)[n]) {
    std::string required, properties;
    for (const ExplainedTerm<Of>& term : table) {
        if (term.is_given == nullptr) required += (required.empty() ? "" : ", ") + quoted(term.name);
        properties += (properties.empty() ? "" : ",\n") + ("        " + quoted(term.name)) +
                      ": {\"description\": " + quoted(term.description) + ", " +
                      type_of(term, k_schema_types) + "}";
    }
    return "      \"type\": \"object\",\n      \"required\": [" + required + "],\n      \"properties\": {\n" +
           properties + "\n      }\n";
}

template <class Of, std::size_t n>
std::string interface_of(const char* name, const ExplainedTerm<Of> (&table)[n]) {
    std::string text = "export interface " + std::string(name) + " {\n";
    for (const ExplainedTerm<Of>& term : table) {
        text += "    /** " + std::string(term.description) + " */\n    " + std::string(term.name) +
                (term.is_given == nullptr ? ": " : "?: ") + type_of(term, k_script_types) + ";\n";
    }
    return text + "}\n";
}

std::string interface_of_material() {
    std::string text = "export interface MaterialValues {\n";
    for (const ItemField<Material>& field : k_material_fields) {
        text += "    /** " + std::string(field.description) + " */\n    " + std::string(field.name) + ": ";
        visit_field(field, Material{},
                    [&](const auto&, const auto& value) { text += type_of(value, k_script_types); });
        text += ";\n";
    }
    return text + "}\n";
}

template <class Of, std::size_t n> std::string rows_of(const char* of, const ExplainedTerm<Of> (&table)[n]) {
    std::string text;
    for (const ExplainedTerm<Of>& term : table)
        text += "| " + std::string(of) + " | `" + std::string(term.name) + "` | " +
                std::string(term.description) + " |\n";
    return text;
}

template <class Of, std::size_t n>
std::string listed_of(const char* name, const char* type, const ExplainedTerm<Of> (&table)[n]) {
    std::string text = "export const " + std::string(name) + ": readonly ListedTerm<" + type + ">[] = [\n";
    for (const ExplainedTerm<Of>& term : table) {
        if (term.label.empty()) continue;
        char usual[32];
        std::snprintf(usual, sizeof usual, "%g", term.usual);
        text += "    {name: " + quoted(term.name) + ", label: " + quoted(term.label) + ", usual: " + usual +
                "},\n";
    }
    return text + "];\n";
}

std::string read(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error("cannot read " + path);
    return text.str();
}

class Files {
  public:
    Files(std::string folder, bool checks) : folder_(std::move(folder)), checks_(checks) {}

    void put(const std::string& name, const std::string& text) {
        const std::string path = folder_ + "/" + name;
        std::ifstream file(path);
        std::ostringstream old;
        old << file.rdbuf();
        if (old.str() == text) return;
        if (checks_) {
            std::fprintf(stderr, "%s is not what the table says: make generated\n", name.c_str());
            fail_ = true;
            return;
        }
        std::ofstream(path) << text;
    }
    /// Replaces what is between two lines.
    static void replace(std::string& text, const std::string& begin, const std::string& end,
                        const std::string& part) {
        const std::size_t at = text.find(begin + "\n");
        const std::size_t to = at == std::string::npos ? at : text.find("\n" + end, at);
        if (to == std::string::npos) throw std::runtime_error("there is no line " + begin);
        const std::size_t from = at + begin.size() + 1;
        text.replace(from, to + 1 - from, part);
    }
    std::string text(const std::string& name) const { return read(folder_ + "/" + name); }
    bool fail() const { return fail_; }

  private:
    std::string folder_;
    bool checks_;
    bool fail_ = false;
};

void write_schema(Files& files) {
    std::string schema = files.text("docs/explain.schema.json");
    const auto put = [&](const char* name, const std::string& part) {
        Files::replace(schema, "    \"" + std::string(name) + "\": {", "    }", part);
    };
    put("ray_terms", schema_of(k_ray_terms));
    put("hit_terms", schema_of(k_hit_terms));
    put("light_terms", schema_of(k_light_terms));
    put("shadow_sample_terms", schema_of(k_shadow_sample_terms));
    put("texture_terms", schema_of(k_texture_terms));
    put("hole_terms", schema_of(k_hole_terms));
    put("crossing_terms", schema_of(k_crossing_terms));
    put("occlusion_terms", schema_of(k_occlusion_terms));
    files.put("docs/explain.schema.json", schema);
}

void write_types(Files& files) {
    std::string types = files.text("src/wasm/glint.d.mts");
    Files::replace(
        types, "// Generated by tools/write_terms.cpp.", "// End of what is generated.",
        interface_of_material() + "\n" + interface_of("RayTerms", k_ray_terms) + "\n" +
            interface_of("HitTerms", k_hit_terms) + "\n" + interface_of("LightTermValues", k_light_terms) +
            "\n" + interface_of("ShadowSampleTerms", k_shadow_sample_terms) + "\n" +
            interface_of("TextureTerms", k_texture_terms) + "\n" + interface_of("HoleTerms", k_hole_terms) +
            "\n" + interface_of("CrossingTerms", k_crossing_terms) + "\n" +
            interface_of("OcclusionTerms", k_occlusion_terms));
    files.put("src/wasm/glint.d.mts", types);
}

void write_document(Files& files) {
    std::string document = files.text("docs/explain.md");
    Files::replace(document, "<!-- The table is generated by tools/write_terms.cpp. -->", "<!-- Its end. -->",
                   "\n| of a | term | |\n|---|---|---|\n" + rows_of("ray", k_ray_terms) +
                       rows_of("hit", k_hit_terms) + rows_of("light", k_light_terms) +
                       rows_of("sample of an area light", k_shadow_sample_terms) +
                       rows_of("texture", k_texture_terms) + rows_of("hole", k_hole_terms) +
                       rows_of("crossing of a solid's shape", k_crossing_terms) +
                       rows_of("occlusion", k_occlusion_terms) + "\n");
    files.put("docs/explain.md", document);
}

void write_list(Files& files) {
    files.put("web/src/ui/terms.ts",
              "// SPDX-License-Identifier: Apache-2.0\n"
              "// Generated by tools/write_terms.cpp: the terms that are listed under a label.\n"
              "import type {ExplainedHit, LightTerms} from 'glint-wasm';\n\n"
              "/** usual: the number of a term that is not worth a line. */\n"
              "interface ListedTerm<Of> {name: keyof Of & string; label: string; usual: number}\n\n" +
                  listed_of("hitTerms", "ExplainedHit", k_hit_terms) + "\n" +
                  listed_of("lightTerms", "LightTerms", k_light_terms));
}

}  // namespace
}  // namespace glint

int main(int argc, char** argv) {
    const bool checks = argc == 3 && std::strcmp(argv[2], "--check") == 0;
    if (argc != 2 && !checks) {
        std::fprintf(stderr, "usage: write_terms PROJECT [--check]\n");
        return 2;
    }
    try {
        glint::Files files(argv[1], checks);
        glint::write_schema(files);
        glint::write_types(files);
        glint::write_document(files);
        glint::write_list(files);
        return files.fail() ? 1 : 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "write_terms: %s\n", e.what());
        return 1;
    }
}
