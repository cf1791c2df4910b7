#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/printable.h"
#include "program/answer.h"
#include "program/case_arguments.h"
#include "program/command.h"
#include "run/effect_cost.h"
#include "scene/effect_settings.h"

namespace runout {
namespace {

using Json = nlohmann::ordered_json;

constexpr double scatter = 0.03;  // of the measured costs, on an idle machine

struct EffectsArguments {
    CaseArguments scenario;
    bool json = false;
};

std::string cost_text(const MeasuredEffect& effect) {
    if (!effect.on) return "nothing";
    if (std::isnan(effect.share)) return "not measured";
    if (std::abs(effect.share) < scatter) return "within 3 %";
    return fmt::format("{:+.0f} % of a step", 100 * effect.share);
}

std::string text_of(const Scene& scene, const std::vector<MeasuredEffect>& effects) {
    const auto settings = effect_settings(scene.effects, scene.profile);
    std::string text =
        fmt::format("Effects of {}: what the case does not name is not there.\n", printable(scene.name));
    text += fmt::format("  {:<14} {:<4} {:<16} {}\n", "effect", "", "costs", "why");
    for (const MeasuredEffect& effect : effects) {
        const std::string given = settings_text(settings, effect.name);
        text += fmt::format("  {:<14} {:<4} {:<16} {}{}\n", effect.name, effect.on ? "on" : "off",
                            cost_text(effect), effect.why, given.empty() ? "" : " (" + given + ")");
    }
    text +=
        "Costs are CPU time of the first steps at low resolution, with all effects of the case and without "
        "the one; they scatter by 3 %.\n";
    return text;
}

std::string json_of(const Scene& scene, const std::vector<MeasuredEffect>& effects) {
    Json object = Json::object();
    for (const MeasuredEffect& effect : effects) {
        Json settings = Json::object();
        for (const EffectSetting& setting : effect_settings(scene.effects, scene.profile))
            if (setting.effect == effect.name) settings[setting.key] = setting.value;
        object[effect.name] = {{"on", effect.on},
                               {"why", effect.why},
                               {"settings", settings},
                               {"cost_share", std::isnan(effect.share) ? Json(nullptr) : Json(effect.share)}};
    }
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int show_effects(const EffectsArguments& arguments) {
    const Scene scene = make_scene(case_from(arguments.scenario));
    log_reading(scene.profile);
    log_assumptions(scene.assumed);
    const std::vector<MeasuredEffect> effects = measure_effects(scene);
    if (arguments.json)
        print_json(json_of(scene, effects));
    else
        print_text(text_of(scene, effects));
    return exit_code::success;
}

}  // namespace

void add_effects_command(CommandLine& program) {
    const auto arguments = std::make_shared<EffectsArguments>();
    Command command =
        program.add_command("effects", "Show which effects a case asks for, why, and what each costs");
    add_case_arguments(command, arguments->scenario).required();
    command.add_flag("--json", &arguments->json, "Print them as one JSON object").group("Output");
    command.set_work([arguments] { return show_effects(*arguments); });
}

}  // namespace runout
