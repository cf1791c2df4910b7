#include "scene/places_on_map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace runout {
namespace {

constexpr std::size_t most_places = 1000;  // as of [[place]]
constexpr std::size_t most_names = 5;      // in a sentence

std::string name_of(const NearFeature& feature) {
    return feature.name.empty() ? fmt::format("feature {}", feature.feature_id) : feature.name;
}

Place place_of(const NearFeature& feature, const Profile& profile) {
    const double a = profile.to_local({feature.from_m, 0}).x();
    const double b = profile.to_local({feature.to_m, 0}).x();
    return {name_of(feature), std::min(a, b), std::abs(b - a), feature.kind};
}

/// What a run on this section may say something of: from the end of the source on, to that of the section.
struct Reach {
    double from, to;
};

bool is_out_of_reach(const Place& place, const Reach& reach) {
    return place.x + place.width < reach.from || place.x >= reach.to;
}

/// The part within reach; whether that is not all.
bool cut(Place& place, const Reach& reach) {
    const double from = std::max(place.x, reach.from), to = std::min(place.x + place.width, reach.to);
    const bool is_less = from > place.x || to < place.x + place.width;
    place.x = from;
    place.width = std::max(0.0, to - from);
    return is_less;
}

std::string list_of(const std::vector<std::string>& names) {
    const std::size_t told = std::min(most_names, names.size());
    std::string list = fmt::format("{}", fmt::join(names.begin(), names.begin() + told, ", "));
    if (told < names.size()) list += fmt::format(" and {} more", names.size() - told);
    return list;
}

void tell(const char* what, const std::vector<std::string>& names, Profile& profile) {
    if (!names.empty()) profile.doubts.push_back(fmt::format("{}: {}.", what, list_of(names)));
}

/// Names of a map may come twice; in tables they are columns.
void tell_apart(std::vector<Place>& places, const std::vector<long>& ids, std::span<const Place> named) {
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto same = [&](const Place& other) { return other.name == places[i].name; };
        if (std::ranges::count_if(places, same) > 1 || std::ranges::any_of(named, same)) alike.push_back(i);
    }
    for (const std::size_t i : alike) places[i].name += fmt::format(" ({})", ids[i]);
}

}  // namespace

std::vector<Place> places_on_map(const CaseSpec& spec, Site& site, double source_end,
                                 std::span<const Place> named) {
    const FeatureQuery& query = spec.map_places;
    if (query.file.empty()) return {};
    if (!site.profile.map_line)
        throw InputError(spec.place("places.file"), "needs a section that lies on a map",
                         "give section.line, or section.origin with section.bearing_deg and section.crs");
    const std::vector<NearFeature> near = features_near(*site.profile.map_line, query);
    if (near.empty())
        site.profile.doubts.push_back(fmt::format("No feature of {} is within {:g} m of the section line.",
                                                  query.file, query.max_offset_m));
    std::vector<std::pair<Place, long>> found;
    std::vector<std::string> left_out, shortened;
    const Reach reach{source_end, site.profile.ground.back().x()};
    for (const NearFeature& feature : near) {
        Place place = place_of(feature, site.profile);
        if (is_out_of_reach(place, reach)) {
            left_out.push_back(place.name);
            continue;
        }
        if (cut(place, reach)) shortened.push_back(place.name);
        found.emplace_back(std::move(place), feature.feature_id);
    }
    if (found.size() > most_places)
        throw InputError(
            spec.place("places.file"), fmt::format("gives {} places", found.size()),
            fmt::format("valid: up to {}; give places.where, or a smaller places.max_offset_m", most_places));
    std::ranges::stable_sort(found, {}, [](const auto& each) { return each.first.x; });
    std::vector<Place> places;
    std::vector<long> ids;
    for (auto& [place, id] : found) {
        places.push_back(std::move(place));
        ids.push_back(id);
    }
    tell(
        "Places of the map that lie beyond the end of the section, in the source or uphill of it are left "
        "out",
        left_out, site.profile);
    tell("Places of the map are counted from the end of the source or to the end of the section only",
         shortened, site.profile);
    tell_apart(places, ids, named);
    return places;
}

}  // namespace runout
