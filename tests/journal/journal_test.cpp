// SPDX-License-Identifier: Apache-2.0
// Journals as bytes: what is written is read, and nothing else is.
#include "journal/journal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "journal/hash.h"
#include "trace/film/assemble.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr Crop k_picture{70, 40, 3, 5};  // 3 x 2 tiles

JournalHeader some_header() {
    JournalHeader header;
    header.picture_version = k_picture_version;
    header.picture = k_picture;
    header.layers = {Layer::depth, Layer::normal};
    header.files = {{"a scene.cgfs", hash_of("one")}, {"odd\nname\\.inc", hash_of("two")}};
    header.settings = {{"size", "100x90"}, {"scene", ""}, {"offset", "1e-3"}};
    return header;
}

Result<Rendering> render_some(std::string* records) {
    Scene scene;
    set_size(scene, 100, 90);
    scene.camera.position = {0, 0, 5};
    scene.add(Sphere{{0, 0, 0}, 1.5});
    scene.lights = {point_light({5, 6, 7})};
    RenderOptions options;
    options.crop = k_picture;
    options.layers = {Layer::depth, Layer::normal};
    if (records != nullptr)
        options.on_tile = [&](const FinishedTile& tile) { *records += record_bytes(tile); };
    return render(*make_world(scene), options);
}

TEST(Journal, HeadersComeBack) {
    const JournalHeader header = some_header();
    const Result<ParsedHeader> parsed = parse_header(header_bytes(header) + "more");
    ASSERT_TRUE(parsed) << parsed.message;
    EXPECT_EQ(header_difference(parsed->header, header), "");
    EXPECT_EQ(parsed->header.files, header.files);
    EXPECT_EQ(parsed->header.settings, header.settings);
    EXPECT_EQ(parsed->size, header_bytes(header).size());
}

TEST(Journal, HashesAreThoseOfXxh3) {
    EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");  // xxhsum -H2 of an empty file
    EXPECT_NE(hash_of("a"), hash_of("b"));
}

TEST(Journal, DifferencesAreNamed) {
    const JournalHeader header = some_header();
    const auto difference = [&](auto&& change) {
        JournalHeader other = header;
        change(other);
        return header_difference(header, other);
    };
    EXPECT_EQ(difference([](JournalHeader& h) { h.files[0].second = hash_of("x"); }),
              "'a scene.cgfs' has changed");
    EXPECT_EQ(difference([](JournalHeader& h) {
                  h.files[0] = {"b.cgfs", hash_of("x")};
              }),
              "'a scene.cgfs' was read there and 'b.cgfs' is read here");
    EXPECT_EQ(difference([](JournalHeader& h) { h.files[0].first = "elsewhere/a.cgfs"; }), "");
    EXPECT_EQ(difference([](JournalHeader& h) { h.files.pop_back(); }),
              "'odd\\x0aname\\.inc' is not read here");
    EXPECT_EQ(difference([](JournalHeader& h) { h.settings[0].second = "50x45"; }),
              "size is 100x90 there and 50x45 here");
    EXPECT_EQ(difference([](JournalHeader& h) { h.settings[1].second = "castle"; }),
              "scene is not set there and castle here");
    EXPECT_EQ(difference([](JournalHeader& h) { h.settings.pop_back(); }),
              "offset is 1e-3 there and not set here");
    EXPECT_EQ(difference([](JournalHeader& h) { h.picture.x = 4; }),
              "the crop is 70x40+3+5 there and 70x40+4+5 here");
    EXPECT_EQ(difference([](JournalHeader& h) { h.layers.clear(); }),
              "the list of layers is depth,normal there and not set here");
    EXPECT_EQ(difference([](JournalHeader& h) { ++h.picture_version; }),
              fmt::format("the version of glint's pictures is {} there and {} here", k_picture_version,
                          k_picture_version + 1));
    EXPECT_EQ(difference([](JournalHeader& h) { h.part = 2, h.parts = 3; }), "");
}

TEST(Journal, TilesComeBack) {
    std::string bytes = header_bytes(some_header());
    const Result<Rendering> whole = render_some(&bytes);
    ASSERT_TRUE(whole) << whole.message;
    const Result<Journal> journal = parse_journal(bytes);
    ASSERT_TRUE(journal) << journal.message;
    EXPECT_EQ(journal->tiles.size(), 6u);
    EXPECT_FALSE(journal->damaged);
    EXPECT_EQ(journal->size, bytes.size());
    Rendering copy = empty_rendering(journal->header.layers, journal->header.picture, 1);
    for (const JournalTile& tile : journal->tiles) {
        copy_tile(tile, journal->header, copy);
        add_rays(copy.rays, tile.rays);
    }
    EXPECT_EQ(copy.image.rgb, whole->image.rgb);
    ASSERT_EQ(copy.layers.size(), 2u);
    EXPECT_EQ(copy.layers[0].values, whole->layers[0].values);
    EXPECT_EQ(copy.layers[1].values, whole->layers[1].values);
    EXPECT_EQ(copy.rays.camera, whole->rays.camera);
    EXPECT_EQ(copy.rays.shadow, whole->rays.shadow);
}

// Records without a checksum, and those whose checksum is wrong, are read only by the function for them.
TEST(Journal, RecordsWithoutChecksum) {
    std::string bytes;
    ASSERT_TRUE(render_some(&bytes));
    const JournalHeader header = some_header();
    const std::string journal = header_bytes(header) + bytes;
    const auto whole = parse_journal(journal);
    ASSERT_TRUE(whole && whole->tiles.size() == 6);
    const std::size_t length = 52 + whole->tiles[0].floats.size();
    std::string record = bytes.substr(0, length + 4);
    for (const bool with_checksum : {true, false}) {
        const std::string_view part = std::string_view(record).substr(0, length + (with_checksum ? 4 : 0));
        const auto tile = parse_unchecked_record(part, header);
        ASSERT_TRUE(tile);
        EXPECT_EQ(tile->number, whole->tiles[0].number);
        EXPECT_EQ(tile->floats, whole->tiles[0].floats);
        EXPECT_EQ(tile->rays.camera, whole->tiles[0].rays.camera);
    }
    for (const std::size_t size : {std::size_t{0}, std::size_t{51}, length - 1, length + 1, length + 3})
        EXPECT_FALSE(parse_unchecked_record(std::string_view(record).substr(0, size), header)) << size;
    EXPECT_FALSE(parse_unchecked_record(record + "x", header));
    record[100] = static_cast<char>(record[100] ^ 1);
    EXPECT_TRUE(parse_unchecked_record(record, header));
    EXPECT_TRUE(parse_journal(header_bytes(header) + record)->tiles.empty());
}

// A journal that ends anywhere gives its whole records and no other.
TEST(Journal, CutAnywhere) {
    std::string bytes = header_bytes(some_header());
    const std::size_t header = bytes.size();
    ASSERT_TRUE(render_some(&bytes));
    const Journal whole = *parse_journal(bytes);
    std::vector<std::size_t> ends{header};
    for (const JournalTile& tile : whole.tiles) ends.push_back(ends.back() + 56 + tile.floats.size());
    ASSERT_EQ(ends.back(), bytes.size());
    for (std::size_t size = 0; size < bytes.size(); size += size < header + 200 ? 1 : 61) {
        const Result<Journal> journal = parse_journal(std::string_view(bytes).substr(0, size));
        if (size < header) {
            EXPECT_EQ(journal.code, ErrorCode::parse) << size;
            continue;
        }
        ASSERT_TRUE(journal) << size;
        const auto expected = std::upper_bound(ends.begin(), ends.end(), size) - ends.begin() - 1;
        EXPECT_EQ(journal->tiles.size(), static_cast<std::size_t>(expected)) << size;
        EXPECT_EQ(journal->damaged, ends[static_cast<std::size_t>(expected)] != size) << size;
    }
}

// A flipped bit costs the record that it is in and those after it; in the header, the whole journal.
TEST(Journal, FlippedBits) {
    std::string bytes = header_bytes(some_header());
    const std::size_t header = bytes.size();
    ASSERT_TRUE(render_some(&bytes));
    const std::string good = bytes;
    const Journal whole = *parse_journal(good);
    for (std::size_t at = 0; at < bytes.size(); at += at < header + 100 ? 1 : 997) {
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << at % 8);
        const Result<Journal> journal = parse_journal(bytes);
        if (at < header) {
            EXPECT_FALSE(journal) << at;
        } else {
            ASSERT_TRUE(journal) << at;
            EXPECT_TRUE(journal->damaged) << at;
            for (std::size_t i = 0; i < journal->tiles.size(); ++i) {
                EXPECT_EQ(journal->tiles[i].number, whole.tiles[i].number);
                EXPECT_EQ(journal->tiles[i].floats, whole.tiles[i].floats);
            }
        }
        bytes[at] = good[at];
    }
}

TEST(Journal, HeadersThatLie) {
    const auto refused = [](JournalHeader header) { return !parse_header(header_bytes(header)); };
    JournalHeader header = some_header();
    EXPECT_FALSE(refused(header));
    header.picture.width = 0;
    EXPECT_TRUE(refused(header));
    header.picture.width = k_max_size + 1;
    EXPECT_TRUE(refused(header));
    header = some_header();
    header.layers = {Layer::depth, Layer::depth};
    EXPECT_TRUE(refused(header));
    for (const auto& [part, parts] : {std::pair{0u, 1u}, {2u, 1u}, {0u, 0u}}) {
        header = some_header();
        header.part = part, header.parts = parts;
        EXPECT_TRUE(refused(header));
    }
    header = some_header();
    header.settings.emplace_back("newline", "a\nunknown_key 1");
    EXPECT_FALSE(refused(header));
}

TEST(Journal, PartsShareTheTiles) {
    JournalHeader header = some_header();
    header.parts = 4;
    std::vector<std::uint32_t> all;
    for (header.part = 1; header.part <= 4; ++header.part) {
        for (const std::uint32_t tile : tiles_of_part(header)) all.push_back(tile);
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    header.part = header.parts = 7;
    EXPECT_TRUE(tiles_of_part(header).empty());
}

}  // namespace
}  // namespace glint::test
