#include "profile/column_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace runout {
namespace {

constexpr std::size_t most_listed_names = 12;
constexpr const char* two_columns =
    "give --columns A,B (section.columns): names or numbers of the columns of "
    "chainage and elevation";

std::optional<std::size_t> column_number(const std::string& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || number == 0 || number > 1000)
        return std::nullopt;
    return number - 1;
}

std::vector<std::size_t> with_role(const std::vector<ColumnName>& names, ColumnRole role) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i].role == role) found.push_back(i);
    return found;
}

std::vector<std::size_t> first_filled(std::vector<std::size_t> best, std::vector<std::size_t> second) {
    return best.empty() ? second : best;
}

/// A name is met whole, with its unit, or without it.
std::vector<std::size_t> called(const std::vector<ColumnName>& names, const std::string& wanted) {
    std::vector<std::size_t> exact;
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].text == wanted) exact.push_back(i);
        if (plain_words(names[i].text) == plain_words(wanted) || names[i].plain == plain_words(wanted))
            alike.push_back(i);
    }
    return first_filled(exact, alike);
}

std::size_t the_only(const std::vector<std::size_t>& found, const char* what,
                     const std::vector<ColumnName>& names, const InputPlace& place) {
    if (found.size() == 1) return found.front();
    std::vector<ColumnName> rivals;
    for (const std::size_t i : found) rivals.push_back(names[i]);
    throw InputError(place, fmt::format("may have {} in any of the columns {}", what, listed_names(rivals)),
                     two_columns);
}

/// x and y are a place on a map where a third column has the elevation.
std::vector<std::size_t> chainage_columns(const std::vector<ColumnName>& names, bool elevation_is_named) {
    std::vector<std::size_t> found =
        first_filled(with_role(names, ColumnRole::chainage), with_role(names, ColumnRole::short_chainage));
    const bool on_map = elevation_is_named && !with_role(names, ColumnRole::y).empty();
    return on_map ? found : first_filled(found, with_role(names, ColumnRole::x));
}

std::vector<std::size_t> elevation_columns(const std::vector<ColumnName>& names) {
    return first_filled(with_role(names, ColumnRole::elevation),
                        with_role(names, ColumnRole::short_elevation));
}

bool has_map_coordinates(const std::vector<ColumnName>& names) {
    return with_role(names, ColumnRole::plan).size() >= 2 ||
           (!with_role(names, ColumnRole::x).empty() && !with_role(names, ColumnRole::y).empty());
}

}  // namespace

ColumnWish column_wish(const std::string& text, const std::string& path) {
    if (text.empty()) return {};
    const std::size_t comma = text.find(',');
    ColumnWish wish;
    if (comma != std::string::npos) {
        wish.chainage = text.substr(0, comma);
        wish.elevation = text.substr(comma + 1);
    }
    for (std::string* name : {&wish.chainage, &wish.elevation}) {
        name->erase(0, std::min(name->find_first_not_of(' '), name->size()));
        name->erase(name->find_last_not_of(' ') + 1);
    }
    const bool two = comma != std::string::npos && wish.elevation.find(',') == std::string::npos;
    if (!two || wish.chainage.empty() || wish.elevation.empty() || wish.chainage == wish.elevation)
        throw InputError(
            {path, 0, "section.columns", text}, "does not name two columns",
            "give names or numbers of the columns of chainage and elevation, such as Station,Elev or 1,3");
    const auto first = column_number(wish.chainage);
    const auto second = column_number(wish.elevation);
    if (first && second) wish.numbers = ColumnPair{*first, *second};
    return wish;
}

std::optional<ColumnPair> named_columns(const std::vector<ColumnName>& names, const ColumnWish& wish,
                                        const InputPlace& place) {
    if (wish.given()) {
        const auto chainage = called(names, wish.chainage);
        const auto elevation = called(names, wish.elevation);
        if (chainage.empty() || elevation.empty()) return std::nullopt;
        return ColumnPair{the_only(chainage, "chainage", names, place),
                          the_only(elevation, "elevation", names, place)};
    }
    std::vector<std::size_t> elevation = elevation_columns(names);
    const std::vector<std::size_t> chainage = chainage_columns(names, !elevation.empty());
    if (chainage.empty() && !elevation.empty() && has_map_coordinates(names))
        throw InputError(
            place, "names places on a map and elevations, and no chainage",
            "add a column of chainage, or give the points as a line with elevations (docs/maps.md)");
    // x and y alone are those of a drawing of the section.
    const bool drawing =
        elevation.empty() && chainage.size() == 1 && names[chainage.front()].role == ColumnRole::x;
    if (drawing) elevation = with_role(names, ColumnRole::y);
    if (chainage.empty() || elevation.empty()) return std::nullopt;
    return ColumnPair{the_only(chainage, "chainages", names, place),
                      the_only(elevation, "elevations", names, place)};
}

std::string listed_names(const std::vector<ColumnName>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most_listed_names; ++i)
        text += fmt::format("{}'{}'", i == 0 ? "" : ", ", names[i].text);
    return text + (names.size() > most_listed_names ? ", ..." : "");
}

}  // namespace runout
