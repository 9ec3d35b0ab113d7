// SPDX-License-Identifier: Apache-2.0
// explain's JSON is valid by docs/explain.schema.json; supports the parts of JSON Schema that this file uses.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <array>
#include <map>

#include <nlohmann/json.hpp>

#include "gallery/scene_file.h"
#include "glint/explain.h"
#include "glint/load.h"

namespace glint::test {
namespace {

using nlohmann::json;

class Schema {
  public:
    explicit Schema(json root) : root_(std::move(root)) {}

    // An error message for a value, or an empty string.
    std::string fault(const json& value) const { return fault(value, root_, "$"); }

  private:
    static bool has_type(const json& value, const std::string& type) {
        if (type == "integer") return value.is_number_integer();
        if (type == "number") return value.is_number();
        return type == value.type_name();
    }

    const json& part_of(const json& reference) const {
        return root_.at(json::json_pointer(reference["$ref"].get<std::string>().substr(1)));
    }

    std::string fault(const json& value, const json& rule, const std::string& at) const {
        if (rule.contains("$ref")) return fault(value, part_of(rule), at);
        if (rule.contains("type")) {
            const json types = rule["type"].is_array() ? rule["type"] : json::array({rule["type"]});
            bool fits = false;
            for (const json& type : types) fits = fits || has_type(value, type);
            if (!fits) return at + " is no " + rule["type"].dump() + ": " + value.dump();
        }
        if (rule.contains("enum")) {
            const json& words = rule["enum"];
            if (std::find(words.begin(), words.end(), value) == words.end())
                return at + " is " + value.dump();
        }
        for (const json& name : rule.value("required", json::array())) {
            if (!value.contains(name)) return at + " lacks " + name.dump();
        }
        if (value.is_array() && rule.contains("items")) {
            for (std::size_t i = 0; i < value.size(); ++i) {
                const std::string wrong = fault(value[i], rule["items"], at + "[" + std::to_string(i) + "]");
                if (!wrong.empty()) return wrong;
            }
        }
        if (!value.is_object()) return {};
        json properties = rule.value("properties", json::object());
        for (const json& part : rule.value("allOf", json::array())) {
            const json& common = part_of(part);
            const std::string wrong = fault(value, common, at);
            if (!wrong.empty()) return wrong;
            properties.update(common["properties"]);
        }
        for (const auto& [name, member] : value.items()) {
            if (properties.contains(name)) {
                const std::string wrong = fault(member, properties[name], at + "." + name);
                if (!wrong.empty()) return wrong;
            } else if (rule.value("additionalProperties", json(true)) == json(false) ||
                       rule.value("unevaluatedProperties", json(true)) == json(false)) {
                return at + " has '" + name + "', which the schema does not know";
            }
        }
        return {};
    }

    json root_;
};

// The recipe of docs/explain.md: what its layers are by the rays of the JSON alone.
json layers_by_recipe(const json& explanation) {
    std::map<std::string, std::array<double, 3>> sums;
    for (const json& ray : explanation["rays"]) {
        const auto add = [&](const std::string& own, const json& color) {
            std::array<double, 3>& sum = sums[ray["layer"].is_null() ? own : ray["layer"].get<std::string>()];
            for (std::size_t c = 0; c < 3; ++c) sum[c] += color[c].get<double>();
        };
        if (ray.contains("hit")) {
            const json& hit = ray["hit"];
            for (const char* part : {"ambient", "diffuse", "specular", "emission"})
                add(part, hit["parts"][part]);
            if (hit.contains("occlusion")) add("sky", hit["occlusion"]["part"]);
        } else {
            add("background", ray["background"]);
        }
        if (ray.contains("fog")) add("fog", ray["fog"]["added"]);
    }
    const double samples = explanation["samples"].get<double>() * explanation["samples"].get<double>();
    json layers = json::object();
    for (const auto& [name, value] : explanation["layers"].items()) {
        for (const double sum : sums[name]) layers[name].push_back(static_cast<float>(sum / samples));
    }
    return layers;
}

// The layers added up in their order, in single precision.
json value_by_recipe(const json& explanation) {
    float value[3] = {};
    for (const LayerInfo& info : layer_infos().first(k_light_layers)) {
        for (std::size_t c = 0; c < 3; ++c)
            value[c] += explanation["layers"][std::string(info.name)][c].get<float>();
    }
    return {value[0], value[1], value[2]};
}

// f of a surface without occluders, where no transparent surface colors the light.
void check_occlusion(const json& explanation, const Scene& scene) {
    for (const json& ray : explanation["rays"]) {
        if (!ray.contains("hit") || !ray["hit"].contains("occlusion")) continue;
        const json& occlusion = ray["hit"]["occlusion"];
        double f = occlusion["factor"];
        int samples = 0;
        for (const json& occluder : occlusion["occluders"]) {
            f += occluder["weight"].get<double>();
            samples += occluder["samples"].get<int>();
        }
        EXPECT_EQ(occlusion["direct"], scene.occlusion->direct);
        // The directions of the method `fixed` are not the same at each point.
        const double margin = scene.occlusion->method == OcclusionMethod::fixed ? 0.3 : 1e-12;
        if (samples != occlusion["blocked"]) continue;
        EXPECT_NEAR(f, 1, margin);
    }
}

// A picture of 8 x 4 pixels: sheets one behind the other, of which the left half is a hole, before a wall.
Scene sheets(int count) {
    std::string text =
        "render { size = 8 x 4 }\ncamera { position = (0, 0, 9)  look_at = (0, 0, 0)  fov_x = 20 }\n"
        "light { type = ambient }\n"
        "texture leaf { texels = (\"10203033 40506066\", \"10203033 405060ff\")  filter = nearest  "
        "alpha = mask  alpha_cutoff = 0.625  mapping = planar  scale = 8  translate = (-4, -4, 0) }\n";
    for (int i = 0; i < count; ++i)
        text += fmt::format(
            "disc \"sheet {0}\" {{ center = (0, 0, -{0})  normal = (0, 0, 1)  radius = 9  texture = leaf "
            "}}\n",
            i);
    text += "plane { point = (0, 0, -99)  normal = (0, 0, 1) }\n";
    const SceneText texts[] = {{"sheets.glint", text, {}}};
    Result<Scene> loaded = load(texts);
    EXPECT_TRUE(loaded);
    return loaded ? *std::move(loaded) : Scene{};
}

TEST(Explain, TheHolesOfARay) {
    const Scene scene = sheets(3);
    const Explanation left = explain(scene, *prepare(scene), 2, 2).value(),
                      right = explain(scene, *prepare(scene), 6, 2).value();
    ASSERT_EQ(left.rays.size(), 1u);
    const ExplainedRay& ray = left.rays[0];
    ASSERT_TRUE(ray.hit);
    EXPECT_EQ(ray.hit->shape, 3u);
    EXPECT_EQ(ray.hole_count, 3);
    ASSERT_EQ(ray.holes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const ExplainedHole& hole = ray.holes[i];
        EXPECT_EQ(hole.shape, i);
        EXPECT_LT(hole.t, ray.t);
        const Vec3 at = ray.origin + ray.direction * hole.t;
        EXPECT_NEAR(at.z, -static_cast<double>(i), 1e-12);
        EXPECT_FALSE(hole.back);
        ASSERT_TRUE(hole.texture);
        EXPECT_NEAR(hole.texture->u, (at.x + 4) / 8, 1e-12);
        EXPECT_EQ(hole.texture->column, 0);
        EXPECT_EQ(hole.texture->alpha, 0.2);
        EXPECT_EQ(hole.cutoff, 0.625);
    }
    EXPECT_EQ(right.rays[0].hole_count, 0);
    EXPECT_TRUE(right.rays[0].holes.empty());
    EXPECT_EQ(right.rays[0].hit->shape, 0u);
}

TEST(Explain, ListsTheFirstHoles) {
    const Scene scene = sheets(40);
    const Explanation e = explain(scene, *prepare(scene), 2, 2).value();
    EXPECT_EQ(e.rays[0].hole_count, 40);
    ASSERT_EQ(e.rays[0].holes.size(), k_max_explained_holes);
    EXPECT_EQ(e.rays[0].holes.back().shape, k_max_explained_holes - 1);
}

TEST(Explain, HolesOfAnotherSceneAreRefused) {
    const Scene scene = sheets(2);
    Explanation e = explain(scene, *prepare(scene), 2, 2).value();
    EXPECT_TRUE(explanation_json(e, scene));
    e.rays[0].holes[1].shape = 3;
    EXPECT_NE(explanation_json(e, scene).message.find("shape 3 of 3"), std::string::npos);
    e.rays[0].holes[1].shape = 2;
    e.rays[0].holes[1].texture->texture = 1;
    EXPECT_NE(explanation_json(e, scene).message.find("texture 1 of 1"), std::string::npos);
}

TEST(ExplainSchema, HoldsOverTheGallery) {
    std::ifstream file(GLINT_PROJECT_DIR "/docs/explain.schema.json");
    const Schema schema(json::parse(file));
    std::string all;
    for (const std::string& path : test::scene_files(GLINT_PROJECT_DIR "/scenes")) {
        const auto scene = test::load_file(path, "size=40x40");
        ASSERT_TRUE(scene) << path;
        const Result<World> world = prepare(*scene);
        for (int i = -1; i < 40; i += 3) {
            const int y = (7 * i + 11) % 40;
            const Result<Explanation> explained = explain(*scene, *world, i, y);
            ASSERT_EQ(explained.ok(), i >= 0) << explained.message;
            // The result of the browser's API for a position outside the picture.
            const json failed = {{"pixel", {i, y}}, {"samples", 1}, {"error", explained.message}};
            const std::string text = i < 0 ? failed.dump() : explanation_json(*explained, *scene).value();
            const json read = json::parse(text);
            EXPECT_EQ(schema.fault(read), "") << path << " pixel " << i;
            if (i >= 0) {
                EXPECT_EQ(layers_by_recipe(read), read["layers"]) << path << " pixel " << i;
                EXPECT_EQ(value_by_recipe(read), read["value"]) << path << " pixel " << i;
                check_occlusion(read, *scene);
            }
            all += text;
        }
    }
    for (const char* word :
         {"\"error\"", "\"blocker\"", "\"limit\"", "\"transmitted\",\"sample\"", "\"turned_away\"",
          "\"behind\"", "\"occluders\":[{", "\"added\"", "\"weight\":0.0625"})
        EXPECT_NE(all.find(word), std::string::npos) << word << " was never tested";
    EXPECT_NE(schema.fault(json{{"pixel", {1, 2}}}), "");
    EXPECT_NE(schema.fault(json{{"pixel", {1, 2}}, {"samples", 1}, {"more", 1}}), "");
    EXPECT_NE(schema.fault(json{{"pixel", {1, 2.5}}, {"samples", 1}}), "");
}

TEST(ExplainSchema, HoldsOfHoles) {
    std::ifstream file(GLINT_PROJECT_DIR "/docs/explain.schema.json");
    const Schema schema(json::parse(file));
    const Scene scene = sheets(3);
    const Explanation explained = explain(scene, *prepare(scene), 2, 2).value();
    const json read = json::parse(explanation_json(explained, scene).value());
    EXPECT_EQ(schema.fault(read), "");
    const json& ray = read["rays"][0];
    EXPECT_EQ(ray["hole_count"], 3);
    ASSERT_EQ(ray["holes"].size(), 3u);
    const json& hole = ray["holes"][1];
    EXPECT_EQ(hole["shape"]["name"], "sheet 1");
    EXPECT_EQ(hole["texture"]["name"], "leaf");
    EXPECT_EQ(hole["cutoff"], 0.625);
    EXPECT_EQ(hole["texture"]["alpha"], 0.2);
    EXPECT_LT(ray["holes"][0]["t"], hole["t"]);
    EXPECT_EQ(read["rays"].size(), 1u);
    const json other =
        json::parse(explanation_json(explain(scene, *prepare(scene), 6, 2).value(), scene).value());
    EXPECT_FALSE(other["rays"][0].contains("holes") || other["rays"][0].contains("hole_count"));

    for (const TextureMix mix : {TextureMix::multiply, TextureMix::replace, TextureMix::multiply_all}) {
        Scene mixed = scene;
        mixed.textures[0].mix = mix;
        const json with_mix =
            json::parse(explanation_json(explain(mixed, *prepare(mixed), 6, 2).value(), mixed).value());
        EXPECT_EQ(schema.fault(with_mix), "");
        EXPECT_EQ(with_mix["rays"][0]["hit"]["texture"]["mix"], to_string(mix));
    }

    const SceneText backs[] = {
        {"back.glint",
         "camera { position = (0, 0, 9)  look_at = (0, 0, 0)  fov_x = 20 }\n"
         "disc { center = (0, 0, 0)  normal = (0, 0, -1)  radius = 9  one_sided = true }\n",
         {}}};
    const Scene back = load(backs).value();
    const json passed =
        json::parse(explanation_json(explain(back, *prepare(back), 6, 2).value(), back).value());
    EXPECT_EQ(schema.fault(passed), "");
    EXPECT_EQ(passed["rays"][0]["holes"][0]["back"], true);
    EXPECT_FALSE(passed["rays"][0]["holes"][0].contains("texture"));
}

}  // namespace
}  // namespace glint::test
