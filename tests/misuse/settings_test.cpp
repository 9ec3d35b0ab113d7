// SPDX-License-Identifier: Apache-2.0
// Keys, values and profiles that do not exist.
#include "misuse/misused.h"

namespace glint::test {
namespace {

TEST(Misuse, OfSettings) {
    Scene scene = some_scene();
    const Conventions conventions = scene.conventions;
    const RenderSettings settings = scene.settings;
    const std::size_t count = setting_keys().size();
    for (const std::size_t key : {count, count + 1, std::numeric_limits<std::size_t>::max()}) {
        EXPECT_EQ(set_setting(scene, key, "1", {}).code, ErrorCode::invalid_argument);
        EXPECT_EQ(get_setting(scene, key), "");
    }
    const std::string huge(100000, '9');
    for (std::size_t key = 0; key < count; ++key) {
        for (const std::string_view value :
             {std::string_view(), std::string_view("no such value"), std::string_view("nan"),
              std::string_view("inf"), std::string_view("-1"), std::string_view("1e999"),
              std::string_view("\0\xff", 2), std::string_view(huge)}) {
            const Status status = set_setting(scene, key, value, {beyond<SettingOrigin::Kind>(), {}});
            EXPECT_EQ(status.code, ErrorCode::invalid_argument)
                << setting_keys()[key].name << " = " << value.substr(0, 20);
        }
    }
    EXPECT_EQ(scene.conventions, conventions);
    EXPECT_EQ(scene.settings, settings);
    for (const char* const name : {"", "Size", "speculargate", "size "})
        EXPECT_FALSE(find_setting(name)) << name;
}

TEST(Misuse, OfSettingsThatCodePutThere) {
    Scene scene = some_scene();
    scene.conventions.offset = beyond<Offset>();
    scene.conventions.epsilon = k_nan;
    scene.settings.shading = beyond<Shading>();
    scene.settings.samples = -3;
    for (std::size_t key = 0; key < setting_keys().size(); ++key) get_setting(scene, key);
    EXPECT_TRUE(has_errors(validate(scene)));
    EXPECT_EQ(prepare(scene).code, ErrorCode::invalid_scene);
}

TEST(Misuse, OfProfiles) {
    Scene scene = some_scene();
    const Conventions before = scene.conventions;
    for (const char* const name : {"", "EPFL", "none"})
        EXPECT_EQ(apply_profile(scene, name).code, ErrorCode::invalid_argument) << name;
    EXPECT_EQ(scene.conventions, before);
    for (const std::string_view name : profile_names()) EXPECT_TRUE(apply_profile(scene, name));
}

}  // namespace
}  // namespace glint::test
