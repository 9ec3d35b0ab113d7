// SPDX-License-Identifier: Apache-2.0
// Every scene of the gallery gives the same floats for all instruction sets and numbers of threads, assembled
// from crops, and in every configuration that builds this test (g++, clang, sanitizers, debug); and the
// pictures are those that were inspected.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>

#include "gallery/scene_file.h"
#include "glint/glint.h"
#include "image/golden.h"

namespace glint::test {
namespace {

struct GalleryPicture {
    const char* scene;         // below scenes/
    const char* settings;      // "key=value key=value"
    std::uint64_t float_bits;  // FNV-1a over the bits of the floats
};

void PrintTo(const GalleryPicture& p, std::ostream* out) { *out << p.scene << ' ' << p.settings; }

// The hashes belong to the inspected pictures in golden/, and also cover differences below 8 bits per
// channel.
const GalleryPicture k_gallery[] = {
    {"cgfs/from_the_side.cgfs", "size=160x160", 0xbe4d194263430b9d},
    {"cgfs/three_mirrors.cgfs", "size=160x160", 0xf15ca10dce6ead20},
    {"cgfs/three_spheres.cgfs", "size=160x160", 0x5cbf6eb868b544d1},
    {"cgfs/three_spheres.cgfs", "size=160x160 shadows=false reflections=0 shading=diffuse",
     0x69701edfe137a32c},
    {"csc473/cone_tower.pov", "size=160x120 cones=true", 0x3874174e7dc0f55f},
    {"csc473/glass_ball.pov", "size=160x120 aa=2", 0x57275ad9a58b76e9},
    {"epfl/castle.json", "size=160x160", 0x8b84a0ab0157c45f},
    {"epfl/castle.json", "size=160x160 shading=phong aa=2", 0x3f2a06a94ec518fb},
    {"epfl/castle.json", "size=160x160 shading=normals", 0xa8b59ae468d7b681},
    {"epfl/mirror_room.json", "size=160x160 reflections=8", 0xf7ccdb3fc701bfda},
    {"epfl/three_lights.json", "size=160x160", 0x6999db1e60601be7},
    {"epfl/two_scenes.js", "size=160x160", 0x6f7cbeb3391345c5},
    {"glint/acne.glint", "size=160x100", 0xa96c24ede7d9f51d},
    {"glint/attenuation.glint", "size=160x42", 0x38950e9e0091f670},
    {"glint/caffeine.glint", "size=160x120", 0x2a831db41c33aa3a},
    {"glint/dahlia.glint", "size=160x160 aa=1", 0xab5aa2c27a30f4cb},
    {"glint/finishes.glint", "size=160x107", 0x426e0114d1ae4b8b},
    {"glint/colonnade.glint", "size=160x107 aa=adaptive:2:0.05", 0xd4547d0a3f37e4bb},
    {"glint/colonnade.glint", "size=160x107 aa=2:jitter", 0x6b77cb2fa519aa57},
    {"glint/figure.glint", "size=120x90 aa=1", 0x3eab0d11e1908bbd},
    {"glint/glass.glint", "size=120x79 aa=1", 0x8e402a0a40dc3035},
    {"glint/hall_of_mirrors.glint", "size=160x120", 0x04e811f38623f931},
    {"glint/hall_of_mirrors.glint", "size=160x120 reflections=3", 0xa3c1782ffd0aeb0b},
    {"glint/amber.glint", "size=160x120 aa=2", 0xae47357080cd15bf},
    {"glint/marbles.glint", "size=160x100 aa=2", 0x14f25b7c31d8ffdd},
    {"glint/glass_of_water.glint", "size=160x120 aa=2", 0xc0226b8cd2d655b5},
    {"glint/highlight_1.glint", "size=100x100", 0x161fe0b150e20575},
    {"glint/highlight_2.glint", "size=100x100", 0x00831f7cac3b1bb1},
    {"glint/highlight_3.glint", "size=100x100", 0xa505ae2867f6116d},
    {"glint/highlight_4.glint", "size=100x100", 0x963b808546f40b39},
    {"glint/lit_sphere.glint", "size=43x43", 0x7515c9fcc9e53450},
    {"glint/moon_phases.glint", "size=160x80", 0x825214feb3b7d955},
    {"glint/patterns.glint", "size=160x107", 0x1a6367166a40ee5b},
    {"glint/peapod.glint", "size=120x79 aa=1", 0x7b8ffb9a57b99dc6},
    {"glint/pond.glint", "size=160x120 aa=2", 0x214bbe6f770afa4f},
    {"glint/quartics.glint", "size=160x120 aa=2", 0xacff473843dc30c7},
    {"glint/rings.glint", "size=160x107 aa=2", 0x31e0147dfc05e08a},
    {"glint/shell.glint", "size=160x160 aa=1", 0xb3db701eb72175eb},
    {"glint/marble_and_wood.glint", "size=160x120 aa=2", 0x0f15d93ecad406ad},
    {"glint/carved.glint", "size=160x120 aa=2", 0xa395fb7aa8cb01da},
    {"glint/solids.glint", "size=160x120 aa=2", 0xa48cceeee0a60678},
    {"glint/stained_glass.glint", "size=160x120", 0x47240280c10c692b},
    {"glint/still_life.glint", "size=160x160", 0xc59e2be8e3fb8caa},
    {"glint/temple.glint", "size=160x160", 0xb8bd77e115244a2c},
    {"glint/textures.glint", "size=160x107 aa=2", 0xd47a742ee0bbf3f3},
    {"glint/three_spots.glint", "size=160x107", 0x39bec1930ad04fca},
    {"glint/two_colors_of_light.glint", "size=160x56", 0x57bcbe22b1d9adc1},
    {"glint/window.glint", "size=160x107", 0xb4465917fa5eac4c},
    {"gltf/studio.gltf", "size=160x107 aa=2", 0x1501e7a657f033a4},
    {"nff/fullerene.nff", "size=160x160", 0x7aa7f30a328e56de},
    {"nff/pyramid.nff", "size=160x160", 0x6294b60ab0edf756},
    {"nff/sphereflake.nff", "size=160x160", 0xa6b3e1aafdd01b07},
};

// Some of them as they were when k_picture_version was last raised.
constexpr std::uint32_t k_recorded_version = 6;
const GalleryPicture k_recorded[] = {
    {"cgfs/three_mirrors.cgfs", "size=160x160", 0xf15ca10dce6ead20},
    {"csc473/glass_ball.pov", "size=160x120 aa=2", 0x57275ad9a58b76e9},
    {"epfl/castle.json", "size=160x160", 0x8b84a0ab0157c45f},
    {"glint/attenuation.glint", "size=160x42", 0x38950e9e0091f670},
    {"glint/caffeine.glint", "size=160x120", 0x2a831db41c33aa3a},
    {"glint/hall_of_mirrors.glint", "size=160x120", 0x04e811f38623f931},
    {"glint/temple.glint", "size=160x160", 0xb8bd77e115244a2c},
    {"nff/sphereflake.nff", "size=160x160", 0xa6b3e1aafdd01b07},
};

// Otherwise a journal of an older glint would be continued with other pixels.
TEST(PictureVersion, IsRaisedWhenAPictureChanges) {
    EXPECT_EQ(k_picture_version, k_recorded_version) << "record the values of k_gallery here again";
    for (const GalleryPicture& recorded : k_recorded) {
        for (const GalleryPicture& p : k_gallery) {
            if (std::string_view(p.scene) != recorded.scene ||
                std::string_view(p.settings) != recorded.settings)
                continue;
            EXPECT_EQ(p.float_bits, recorded.float_bits)
                << p.scene << " has changed: raise k_picture_version (glint/render.h)";
        }
    }
}

std::string file_name(const GalleryPicture& p) {
    std::string name = std::string(p.scene) + ' ' + p.settings;
    for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

std::uint64_t hash(const Image& image) {
    std::uint64_t h = 14695981039346656037u;
    for (const float f : image.rgb) {
        for (std::uint32_t bits = std::bit_cast<std::uint32_t>(f), i = 0; i < 4; ++i, bits >>= 8)
            h = (h ^ (bits & 255)) * 1099511628211u;
    }
    return h;
}

Result<World> load_world(const GalleryPicture& p) {
    const auto scene = test::load_file(std::string(GLINT_PROJECT_DIR "/scenes/") + p.scene, p.settings);
    return scene ? prepare(*scene) : Result<World>();
}

class Gallery : public testing::TestWithParam<GalleryPicture> {};

TEST_P(Gallery, EqualsTheInspectedPicture) {
    const Result<World> world = load_world(GetParam());
    ASSERT_TRUE(world);
    const Result<Rendering> whole = render(*world);
    ASSERT_TRUE(whole) << whole.message;
    EXPECT_TRUE(test::matches_golden(whole->image, std::string(GLINT_PROJECT_DIR "/tests/gallery/golden/") +
                                                       file_name(GetParam()) + ".png"));
    EXPECT_EQ(hash(whole->image), GetParam().float_bits) << "0x" << std::hex << hash(whole->image);
}

TEST_P(Gallery, HasTheSameBitsForAllRenderOptions) {
    const Result<World> world = load_world(GetParam());
    ASSERT_TRUE(world);
    const Result<Rendering> whole = render(*world);
    ASSERT_TRUE(whole);
    int i = 0;
    for (const std::string& isa : isa_names()) {
        RenderOptions options;
        options.isa = isa;
        options.threads = std::array{1, 2, 7}[static_cast<std::size_t>(i++ % 3)];
        const Result<Rendering> again = render(*world, options);
        ASSERT_TRUE(again);
        EXPECT_EQ(hash(again->image), hash(whole->image)) << isa << ", " << options.threads << " threads";
        EXPECT_EQ(again->rays.total(), whole->rays.total());
    }
    Image joined{whole->image.width, whole->image.height, std::vector<float>(whole->image.rgb.size())};
    constexpr int step = 47;  // not a multiple of the sizes of tiles or packets
    for (int y = 0; y < joined.height; y += step) {
        for (int x = 0; x < joined.width; x += step) {
            RenderOptions options;
            options.crop = Crop{std::min(step, joined.width - x), std::min(step, joined.height - y), x, y};
            const Result<Rendering> part = render(*world, options);
            ASSERT_TRUE(part);
            for (int row = 0; row < part->image.height; ++row) {
                std::memcpy(&joined.rgb[3 * static_cast<std::size_t>((y + row) * joined.width + x)],
                            &part->image.rgb[3 * static_cast<std::size_t>(row * part->image.width)],
                            3 * sizeof(float) * static_cast<std::size_t>(part->image.width));
            }
        }
    }
    EXPECT_EQ(hash(joined), hash(whole->image));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Gallery, testing::ValuesIn(k_gallery),
                         [](const auto& p) { return file_name(p.param); });

TEST(GalleryList, NamesEveryScene) {
    for (const std::string& path : test::scene_files(GLINT_PROJECT_DIR "/scenes")) {
        if (path.find("/faults/") != std::string::npos) continue;  // of tests/compare
        const bool listed = std::any_of(std::begin(k_gallery), std::end(k_gallery),
                                        [&](const GalleryPicture& p) { return path.ends_with(p.scene); });
        EXPECT_TRUE(listed) << path << " is not rendered by any test";
    }
}

}  // namespace
}  // namespace glint::test
