// SPDX-License-Identifier: Apache-2.0
// Whatever receives the tiles of a picture, they are the picture that render() returns.
#include <gtest/gtest.h>

#include <stdexcept>

#include "image/memory_file.h"
#include "journal/journal.h"
#include "output/journal_sink.h"
#include "output/memory_sink.h"
#include "output/strip_sink.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr Crop k_area{130, 100, 3, 5};  // 5 x 4 tiles

World some_world() {
    Scene scene;
    set_size(scene, 140, 110);
    scene.camera.position = {0, 0, 5};
    scene.add(Sphere{{0, 0, 0}, 1.5});
    scene.lights = {point_light({5, 6, 7})};
    return *make_world(scene);
}

RenderOptions some_options(std::vector<Layer> layers) {
    RenderOptions options;
    options.crop = k_area;
    options.layers = std::move(layers);
    options.threads = 3;
    return options;
}

JournalHeader header_of(std::vector<Layer> layers) {
    JournalHeader header;
    header.picture = k_area;
    header.layers = std::move(layers);
    return header;
}

void expect_same(const Rendering& got, const Rendering& wanted) {
    EXPECT_EQ(got.image.rgb, wanted.image.rgb);
    EXPECT_EQ(got.rays.total(), wanted.rays.total());
    ASSERT_EQ(got.layers.size(), wanted.layers.size());
    for (std::size_t i = 0; i < got.layers.size(); ++i)
        EXPECT_EQ(got.layers[i].values, wanted.layers[i].values) << i;
}

// A file in memory, which may have room for a few bytes only.
class SomeFile : public FileInProgress {
  public:
    SomeFile(std::vector<std::uint8_t>& bytes, bool is_full) : memory_(bytes), is_full_(is_full) {}
    void write(std::span<const std::uint8_t> bytes) override {
        if (is_full_ && position() + bytes.size() > 100) throw std::runtime_error("no space");
        memory_.write(bytes);
    }
    std::uint64_t position() const override { return memory_.position(); }
    void seek(std::uint64_t position) override { memory_.seek(position); }
    void commit(bool) override {}

  private:
    MemoryFile memory_;
    const bool is_full_;
};

class SomeRecords : public RecordFile {
  public:
    void append(std::string_view record) override {
        if (left-- == 0) throw std::runtime_error("no space");
        bytes += record;
    }
    std::string bytes;
    int left = 1000;
};

TEST(Sinks, Memory) {
    const World world = some_world();
    const std::vector<Layer> layers{Layer::depth, Layer::ambient};
    const Rendering whole = render(world, some_options(layers)).value();
    const JournalHeader header = header_of(layers);
    MemorySink sink(header, 2);
    Rendering rendering = render_into(sink, world, some_options(layers)).value();
    EXPECT_TRUE(rendering.image.rgb.empty());
    sink.move_to(rendering);
    expect_same(rendering, whole);
}

TEST(Sinks, RecordsOfOtherProcesses) {
    const World world = some_world();
    const std::vector<Layer> layers{Layer::normal};
    RenderOptions options = some_options(layers);
    std::vector<std::string> records;
    options.on_tile = [&](const FinishedTile& tile) { records.push_back(record_bytes(tile)); };
    const Rendering whole = render(world, options).value();

    const JournalHeader header = header_of(layers);
    MemorySink memory(header, 1);
    SomeRecords file;
    const std::vector<std::uint32_t> none;
    JournalSink journal(header, none, {}, file);
    Rendering copied;
    for (const std::string& record : records) {
        const auto rays = memory.receive_record(record);
        ASSERT_TRUE(rays);
        copied.rays = {copied.rays.camera + rays->camera, copied.rays.shadow + rays->shadow};
        ASSERT_TRUE(journal.receive_record(record));
    }
    memory.move_to(copied);
    expect_same(copied, whole);
    EXPECT_EQ(file.bytes, "") << "it is written by write_received() only";
    journal.write_received();
    EXPECT_EQ(file.bytes.size(), records.size() * 52 + records.size() * 4 + 6 * 4 * 130 * 100);
    EXPECT_FALSE(memory.receive_record(records.front().substr(7)));
    EXPECT_FALSE(journal.receive_record("TILE"));
}

TEST(Sinks, Strips) {
    const World world = some_world();
    for (const bool alpha : {false, true}) {
        for (const int threads : {1, 4}) {
            RenderOptions options = some_options(alpha ? std::vector{Layer::alpha} : std::vector<Layer>());
            options.threads = threads;
            const Rendering whole = render(world, options).value();
            const auto wanted =
                alpha ? encode(whole.image, whole.layers.back().values, {}) : encode(whole.image);
            std::vector<std::uint8_t> bytes;
            StripWriter writer(std::make_unique<SomeFile>(bytes, false), {}, k_area.width, k_area.height,
                               alpha);
            StripSink sink(k_area, threads, alpha, writer);
            double fraction = 0;
            options.progress = [&](double done) { fraction = done; };
            const Result<Rendering> rendering = render_into(sink, world, options);
            ASSERT_TRUE(rendering) << rendering.message;
            sink.finish();
            EXPECT_EQ(bytes, wanted.value()) << alpha << ' ' << threads;
            EXPECT_EQ(rendering->rays.total(), whole.rays.total());
            EXPECT_EQ(fraction, 1);
        }
    }
}

TEST(Sinks, JournalsThatHaveTiles) {
    const World world = some_world();
    const std::vector<Layer> layers{Layer::depth};
    const Rendering whole = render(world, some_options(layers)).value();
    const JournalHeader header = header_of(layers);
    SomeRecords file;
    file.bytes = header_bytes(header);
    const std::vector<std::uint32_t> first{7, 3, 19},
        others{0, 1, 2, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
    JournalSink before(header, first, {20, 3, {}}, file);
    const Rendering some = render_into(before, world, some_options(layers)).value();
    JournalSink after(header, others, {20, 17, some.rays}, file);
    RenderOptions options = some_options(layers);
    double least = 1;
    options.progress = [&](double done) { least = std::min(least, done); };
    Rendering rendering = render_into(after, world, options).value();
    EXPECT_EQ(least, 4 / 20.0);

    const Journal journal = parse_journal(file.bytes).value();
    EXPECT_EQ(journal.tiles.size(), 20u);
    MemorySink memory(header, 1);
    memory.move_to(rendering);
    for (const JournalTile& tile : journal.tiles) copy_tile(tile, header, rendering);
    expect_same(rendering, whole);
}

TEST(Sinks, ThatFailEndTheRender) {
    const World world = some_world();
    const JournalHeader header = header_of({});
    std::vector<std::uint32_t> all(count_tiles(k_area));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    SomeRecords file;
    file.left = 2;
    JournalSink journal(header, all, {all.size(), all.size(), {}}, file);
    EXPECT_THROW((void)render_into(journal, world, some_options({})), std::runtime_error);
    EXPECT_TRUE(journal.failed());
    EXPECT_EQ(file.left, -1) << "nothing is written after the failure";

    std::vector<std::uint8_t> bytes;
    StripWriter writer(std::make_unique<SomeFile>(bytes, true), {}, k_area.width, k_area.height);
    StripSink strips(k_area, 3, false, writer);
    EXPECT_THROW((void)render_into(strips, world, some_options({})), std::runtime_error);
}

}  // namespace
}  // namespace glint::test
