#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/effects.h"
#include "profile/profile.h"

namespace runout {

/// What a case said of one effect, as one line of its file would: in its units, numbers in the shortest text
/// that reads back the same.
struct EffectSetting {
    std::string effect;  ///< "cohesion"
    std::string key;     ///< "cohesion_kpa"
    std::string value;
};

/// All settings of the effects that are there, in the order of the documentation. Effects that are absent
/// have none.
std::vector<EffectSetting> effect_settings(const Effects& effects, const Profile& profile);

/// "cohesion_kpa = 5, tension_cut_off_kpa = 2" of one effect, cut short where it is long; empty when there
/// are none.
std::string settings_text(const std::vector<EffectSetting>& settings, const std::string& effect);

/// One effect of the program: whether the case asks for it, and what it says when it does not.
struct EffectState {
    std::optional<EffectId> effect;  ///< none: the places
    std::string name;                ///< "pore_pressure", as in the case file
    bool on = false;
    std::string meaning;  ///< "water in the pores takes off pressure", "no water: the soil is dry"
};

/// Every effect the program knows, and the places, on or off.
std::vector<EffectState> effect_states(const Effects& effects, std::size_t places);

/// The same effects without one.
Effects without(Effects effects, EffectId effect);

}  // namespace runout
