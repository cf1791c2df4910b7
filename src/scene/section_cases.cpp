#include "scene/section_cases.h"

#include <fmt/format.h>

#include "scene/case_checks.h"
#include "scene/read_ground.h"

namespace runout {

std::vector<SectionCase> section_cases(const CaseSpec& spec) {
    check_keys_go_together(spec);
    const LineQuery& query = spec.section.map.line;
    if (!is_on_map(spec.section)) return {{spec, std::nullopt}};
    std::vector<SectionFeature> features = section_features(query);
    const bool many = features.size() > 1;
    std::vector<SectionCase> cases;
    for (SectionFeature& feature : features) {
        CaseSpec single = spec;
        if (many) single.section.map.line.feature_id = feature.feature.feature_id;
        if (many || (feature.named && !spec.has("run.name")))
            single.name = fmt::format("{}-{}", spec.name, feature.label);
        cases.push_back({std::move(single), std::move(feature)});
    }
    return cases;
}

}  // namespace runout
