#include <cmath>

#include "fuzz/bytes.h"
#include "fuzz/targets.h"
#include "study/scenarios.h"
#include "study/study_file.h"

namespace runout::fuzz {
namespace {

constexpr double few = 1000;

}  // namespace

void read_study_file(std::span<const std::uint8_t> bytes) {
    const std::string path = written(bytes, ".toml");
    accept_input_error([&] {
        const Study study = read_study(path);
        require(!study.factors.empty(), "a study varies something");
        const double count = combination_count(study);
        require(count >= 1, "a study has a combination");
        if (count > few) return;
        const Combinations all(study);
        require(static_cast<double>(all.size()) <= count, "no more combinations than were counted");
        for (std::size_t k = 0; k < all.size(); ++k) {
            const std::vector<Setting> settings = all[k];
            require(settings.size() == study.factors.size(), "each combination sets every factor");
            require(settings_json(settings).size() > 2, "settings can be told");
        }
    });
}

}  // namespace runout::fuzz
