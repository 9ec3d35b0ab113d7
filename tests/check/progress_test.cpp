// SPDX-License-Identifier: Apache-2.0
// The callbacks of load(), prepare(), check() and find_causes() are called on the calling thread.
#include <thread>

#include "check/check_text.h"
#include "glint/compare.h"
#include "glint/render.h"

namespace glint::test {
namespace {

// Counts calls, and whether all came from this thread with a fraction that does not decrease.
struct Calls {
    std::thread::id thread = std::this_thread::get_id();
    int count = 0;
    double last = 0;
    bool in_order = true, on_thread = true;

    std::function<void(double)> callback() {
        return [this](double fraction) {
            ++count;
            on_thread = on_thread && std::this_thread::get_id() == thread;
            in_order = in_order && fraction >= last && fraction <= 1;
            last = fraction;
        };
    }
    void expect(const char* what) const {
        EXPECT_GT(count, 1) << what;
        EXPECT_TRUE(on_thread) << what;
        EXPECT_TRUE(in_order) << what;
        EXPECT_EQ(last, 1) << what;
    }
};

TEST(CheckProgress, ComesFromTheCallingThread) {
    std::string text = k_clean;
    for (int i = 0; i < 20000; ++i)
        text += fmt::format("sphere {{ center = ({}, {}, -3)  radius = 0.02 }}\n", i % 200 * 0.05 - 5,
                            i / 200 * 0.05);
    Calls load_calls, prepare_calls, check_calls, cause_calls;
    const SceneText texts[] = {{"scene.glint", text, {}}};
    LoadOptions loading;
    loading.progress = load_calls.callback();
    const Scene scene = load(texts, loading).value();
    load_calls.expect("load");
    ASSERT_TRUE(prepare(scene, {.threads = 4, .progress = prepare_calls.callback()}));
    prepare_calls.expect("prepare");
    CheckOptions checking;
    checking.threads = 4;
    checking.progress = check_calls.callback();
    ASSERT_TRUE(check(scene, checking));
    check_calls.expect("check");

    Scene small = load_text(k_clean, "scene.glint").value();
    small.settings.width = 64;
    small.settings.height = 48;
    const Image right = render(prepare(small).value()).value().image;
    small.settings.shadows = false;
    const Image wrong = render(prepare(small).value()).value().image;
    small.settings.shadows = true;
    CauseOptions searching;
    searching.threads = 4;
    searching.progress = cause_calls.callback();
    ASSERT_TRUE(find_causes(wrong, right, &small, searching));
    cause_calls.expect("find_causes");
}

}  // namespace
}  // namespace glint::test
