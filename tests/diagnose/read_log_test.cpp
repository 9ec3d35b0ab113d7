// SPDX-License-Identifier: Apache-2.0
// The reader of logs: lines, JSON, printrays, and what is wrong with a log.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "diagnose/log_keys.h"
#include "diagnose/trace_log.h"

namespace glint::test {
namespace {

TraceLog read(std::string_view text, std::vector<Diagnostic>* messages = nullptr) {
    Diagnostics diagnostics;
    TraceLog log = read_trace_log({"log", text}, diagnostics);
    if (messages != nullptr) {
        *messages = diagnostics.take();
    } else {
        EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics.list()[0]);
    }
    return log;
}

std::string first_message(std::string_view text) {
    std::vector<Diagnostic> messages;
    read(text, &messages);
    return messages.empty()
               ? ""
               : fmt::format("{}:{}: {}", messages[0].line, messages[0].column, messages[0].message);
}

TEST(TraceLog, LinesAndJsonSayTheSame) {
    const TraceLog lines = read("pixel 3 4\nray camera\nN 0 1 0\nlight 2\nN.L 0.75\nblocked 0\n");
    const TraceLog one =
        read("pixel 3 4 ray camera N = (0, 1, 0); light: 2 n_l: 0.75 blocked false # the same\n");
    const TraceLog json = read(
        "{\"N\": [0, 1, 0], \"pixel\": [3, 4], \"ray\": \"camera\"}\n{\"N·L\": 0.75, \"blocked\": false, "
        "\"light\": 2}\n");
    for (const TraceLog* log : {&lines, &one, &json}) {
        ASSERT_EQ(log->pixels.size(), 1u);
        ASSERT_EQ(log->pixels[0].rays.size(), 1u);
        const LoggedRay& ray = log->pixels[0].rays[0];
        EXPECT_EQ(ray.vector(Quantity::normal)->y.v, 1);
        ASSERT_EQ(ray.lights.size(), 1u);
        EXPECT_EQ(ray.lights[0].number(Quantity::n_l)->v, 0.75);
        EXPECT_EQ(ray.lights[0].number(Quantity::blocked)->v, 0);
        EXPECT_EQ(log->light_labels[0].number, 2);
    }
}

TEST(TraceLog, RaysAreNestedUntilTheirEnd) {
    const TraceLog log = read(
        "pixel 0 0\nray camera\nray mirror\nray glass\nend\nray mirror\nend\nend\ncolor 1 1 1\nend\ncolor 0 "
        "0 0\n");
    const std::vector<LoggedRay>& rays = log.pixels[0].rays;
    ASSERT_EQ(rays.size(), 4u);
    EXPECT_EQ(rays[1].parent, 0);
    EXPECT_EQ(rays[2].parent, 1);
    EXPECT_EQ(rays[3].parent, 1);
    EXPECT_EQ(rays[3].generation, 2);
    EXPECT_NE(rays[0].find(Quantity::color), nullptr);
    EXPECT_NE(log.pixels[0].find(Quantity::pixel_color), nullptr);
}

TEST(TraceLog, ALoopHasNoEnds) {
    const TraceLog log =
        read("pixel 0 0\nray camera\nray mirror\nray mirror\ncolor 1 1 1\nbytes 255 255 255\n");
    EXPECT_EQ(log.pixels[0].rays[2].parent, 1);
    EXPECT_EQ(log.pixels[0].rays[2].find(Quantity::color), nullptr);
    EXPECT_NE(log.pixels[0].find(Quantity::pixel_color), nullptr);
}

TEST(TraceLog, RaysMayHaveNumbers) {
    const TraceLog log = read("pixel 0 0\nray camera 0\nray mirror 1 0\nray glass 2 0\nray 1\ncolor 1 1 1\n");
    EXPECT_EQ(log.pixels[0].rays[2].parent, 0);
    EXPECT_NE(log.pixels[0].rays[1].find(Quantity::color), nullptr);
}

TEST(TraceLog, AShadowRayIsOfItsLight) {
    const TraceLog log = read(
        "pixel 0 0\nray camera\nshape 1\nlight 1\nray shadow\norigin 0 0 0\nshape 7\nt 2\nblocked 1\nlight "
        "2\nray shadow\nend\nblocked 0\nlocal 1 1 1\nend\n");
    const LoggedRay& ray = log.pixels[0].rays[0];
    EXPECT_EQ(log.shape_labels.size(), 1u);
    EXPECT_EQ(ray.find(Quantity::t), nullptr);
    EXPECT_EQ(ray.lights[0].number(Quantity::blocked)->v, 1);
    EXPECT_NE(ray.find(Quantity::local), nullptr);
}

TEST(TraceLog, DigitsAreTheError) {
    const TraceLog fixed = read(
        "pixel 0 0\nray camera\nt 1.250\nN 0.123 1.000 0.000\nray mirror\nt 2.000\nray mirror\nt 4.000\nray "
        "mirror\nt 0.002\n");
    EXPECT_DOUBLE_EQ(fixed.pixels[0].rays[0].vector(Quantity::t)->x.e, 0.0005);
    const TraceLog whole = read("pixel 0 0\nray camera\nN 0 1 0\nD 0.12345678901234567 0.5 1\n");
    EXPECT_EQ(whole.pixels[0].rays[0].vector(Quantity::normal)->error(), 0);
    EXPECT_EQ(whole.pixels[0].rays[0].vector(Quantity::direction)->error(), 0);
    const TraceLog short_digits = read("pixel 0 0\nray camera\nP 1.23457 0.5 12.5\n");
    EXPECT_NEAR(short_digits.pixels[0].rays[0].vector(Quantity::point)->x.e, 6.17e-6, 1e-8);
}

TEST(TraceLog, PrintraysOfCsc473) {
    const TraceLog log = read(
        "Pixel: [1, 2] Color: (10, 20, 30)\n----\n      Iteration type: Primary\n                 Ray: "
        "{0.0000 0.0000 14.0000} -> {-0.4181 0.0000 "
        "-0.9084}\n          Hit Object: (ID #2 - Sphere)\n        Intersection: {1.0000 2.0000 3.0000} at T "
        "= 12.5000\n              Normal: {0.0000 "
        "1.0000 0.0000}\n             Ambient: {0.1000, 0.2000, 0.3000}\n----\n      Iteration type: "
        "Reflection\n                 Ray: {1.0000 2.0000 "
        "3.0000} -> {0.0000 0.0000 1.0000}\n  No intersection.\n");
    ASSERT_EQ(log.pixels.size(), 1u);
    EXPECT_EQ(log.pixels[0].vector(Quantity::bytes)->y.v, 20);
    const std::vector<LoggedRay>& rays = log.pixels[0].rays;
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_EQ(rays[0].vector(Quantity::t)->x.v, 12.5);
    EXPECT_EQ(rays[0].vector(Quantity::direction)->z.v, -0.9084);
    EXPECT_TRUE(rays[1].is_miss);
}

TEST(TraceLog, ErrorsNameTheLine) {
    EXPECT_EQ(first_message("N 0 1 0\n"), "1:1: expected `pixel X Y` before 'N'");
    EXPECT_EQ(first_message("pixel 0 0\nN 0 1 0\n"), "2:1: expected `ray camera` before 'N'");
    EXPECT_EQ(first_message("pixel 0 0\nray camera\nt 1 N 0 1\nt 1\n"),
              "3:5: expected 3 numbers after 'N', found 2");
    EXPECT_EQ(first_message("pixel 0 0\nray mirror\nt 1\n"),
              "2:1: a mirror ray starts from the hit of another ray: expected `ray camera` before");
    EXPECT_EQ(first_message("pixel 0 0\nray camera 0\nray mirror 1 5\nt 1\n"),
              "3:1: the parent, ray 5, is not among the rays before");
    EXPECT_EQ(first_message("pixel 0 0\nray camera 0\nray mirror 1 1\nt 1\n"),
              "3:1: the parent, ray 1, is not among the rays before");
    EXPECT_EQ(first_message("pixel 0 0\nray camera\nlight 1\nnormall 0 1 0\n"),
              "4:1: the key 'normall' is unknown and is skipped; did you mean `normal`?");
    EXPECT_EQ(first_message("pixel 0 0\nray camera\nt 1\nt 2\nt 3\n"), "4:1: 't' is given twice");
    EXPECT_EQ(first_message("pixel 0 -1\nray camera\n"), "1:1: expected a pixel from 0 to 65535");
    EXPECT_EQ(first_message("pixel 0 0\nray sideways\nt 1\n"),
              "2:1: expected `camera`, `mirror`, `glass` or `shadow` after `ray`, found 'sideways'");
    // A log that was cut.
    EXPECT_EQ(first_message("pixel 0 0\nray camera\nN 0 1"),
              "3:1: the log does not end with a newline: its last value is left out");
}

// One message for a line that cannot be read, not one for each of those that belong to it.
TEST(TraceLog, WhatBelongsToABadLineIsSkipped) {
    const auto count = [](std::string_view text) {
        std::vector<Diagnostic> messages;
        read(text, &messages);
        return messages.size();
    };
    EXPECT_EQ(count("pixel 5\nray camera\nt 1\nlight 1\nN.L 1\nend\npixel 1 1\nray camera\nt 1\n"), 1u);
    EXPECT_EQ(count("pixel 0 0\nray sideways\nt 1\nN 0 1 0\nend\nray camera\nt 1\n"), 1u);
    // The next pixel is read again.
    EXPECT_EQ(count("pixel 5\nt 1\npixel 1 1\nray camera\nt 1 2\n"), 2u);
}

std::string normalized(std::string_view name) {
    std::string text;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c))) text += static_cast<char>(std::tolower(c));
    return text;
}

std::string document(const std::string& name) {
    std::ifstream file(GLINT_SOURCE "/docs/formats/" + name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(TraceLogDocument, HasAllKeys) {
    std::istringstream lines(document("trace_log.md"));
    std::set<std::string> written;
    const std::regex word("`([^`]+)`");
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| `")) continue;
        const std::string keys = line.substr(0, line.find('|', line.find('|', 1) + 1));
        for (std::sregex_iterator it(keys.begin(), keys.end(), word), end; it != end; ++it) {
            const std::string key = normalized((*it)[1].str());
            // `color` of the pixel.
            EXPECT_NE(find_key(key), nullptr) << key;
            written.insert(key);
        }
    }
    for (const LogKey& key : log_keys()) EXPECT_TRUE(written.contains(std::string(key.name))) << key.name;
}

TEST(TraceLogDocument, TheSchemaHasAllKeysWithTheirKinds) {
    const auto schema = nlohmann::json::parse(document("trace_log.schema.json"));
    std::set<std::pair<KeyUse, Quantity>> written;
    for (const auto& [name, property] : schema["properties"].items()) {
        const LogKey* key = find_key(normalized(name));
        ASSERT_NE(key, nullptr) << name;
        written.emplace(key->use, key->quantity);
        if (key->use != KeyUse::none || key->quantity == Quantity::weight) continue;
        const QuantityKind kind = info_of(key->quantity).kind;
        const std::string wanted = kind == QuantityKind::number  ? "number"
                                   : kind == QuantityKind::flag  ? "flag"
                                   : kind == QuantityKind::color ? "color"
                                                                 : "vector";
        EXPECT_EQ(property["$ref"], "#/$defs/" + wanted) << name;
    }
    for (const LogKey& key : log_keys()) EXPECT_TRUE(written.contains({key.use, key.quantity})) << key.name;
}

TEST(TraceLog, TooManyRaysAreRefused) {
    std::string text = "pixel 0 0\nray camera\n";
    for (int i = 0; i < 20'001; ++i) text += "ray mirror\nend\n";
    EXPECT_EQ(first_message(text), "40001:1: a pixel has at most 20000 rays, and a log 4000000");
    text = "pixel 0 0\nray camera\n";
    for (int i = 0; i < 1001; ++i) text += "ray mirror\n";
    EXPECT_EQ(first_message(text), "1003:1: at most 1000 rays may follow each other: is an `end` missing?");
}

}  // namespace
}  // namespace glint::test
