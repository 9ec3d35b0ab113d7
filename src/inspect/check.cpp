// A scene's likely mistakes: all checks, one after the other.
#include "glint/check.h"

#include <fmt/format.h>

#include "base/fp_environment.h"
#include "base/guard.h"
#include "inspect/checks.h"

namespace glint {
namespace {

constexpr CheckKind k_kinds[] = {
    {"camera-inside-shape", "the camera stands inside a closed shape that is not all of the scene"},
    {"camera-sees-nothing", "no bounded shape is in the picture, nor in its mirrors"},
};

void run_checks(const Scene& scene, World& world, const CheckOptions& options, CheckResult& result) {
    Subject subject(scene, world, options);
    const Sight sight(world, options.threads);
    const bool sees = check_camera(subject, sight);
    (void)sees;
    result.findings = subject.take();
}

}  // namespace

std::span<const CheckKind> check_kinds() { return k_kinds; }

CheckResult check(const Scene& scene, const CheckOptions& options) {
    CheckResult result;
    PrepareResult prepared = prepare(scene, options.threads);
    result.diagnostics = std::move(prepared.diagnostics);
    if (!prepared.world) return result;
    result.error = guard([&] {
        const DefaultFpEnvironment environment;
        // prepare() made it, and nobody else has it.
        run_checks(scene, const_cast<World&>(*prepared.world), options, result);
    });
    if (!result.error.empty()) result.findings.clear();
    return result;
}

std::string to_string(const Finding& finding) {
    Diagnostic d = finding.diagnostic;
    d.message += fmt::format(" [{}]", finding.id);
    return to_string(d) + "  remedy: " + finding.remedy + '\n';
}

}  // namespace glint
