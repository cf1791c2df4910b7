#include "study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

#include "scene/toml_reading.h"
#include "study/distribution.h"

namespace runout {
namespace {

namespace fs = std::filesystem;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int most_values_of_a_range = 10'000;
constexpr std::size_t longest_quoted = 60;  // of a key or a value, in a message
constexpr std::array study_keys = {"name", "case", "design", "samples", "seed"};
constexpr std::array shapes = {"normal", "lognormal", "triangular", "uniform"};
// Values that name a file, from the study's folder.
constexpr std::array path_keys = {"section.file", "section.raster", "section.line", "effects.shaking.record"};

std::string text_of(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (const auto whole = node.value_exact<std::int64_t>()) return fmt::format("{}", *whole);
    if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
    std::ostringstream other;
    node.visit([&](const auto& value) { other << value; });
    return other.str();
}

/// Reads the tables of one study file.
class StudyReader {
  public:
    explicit StudyReader(Study& study) : study_(study) {}

    void read(const toml::table& root) {
        for (const auto& [key, node] : root) {
            const std::string name(key.str());
            if (name != "study" && name != "vary" && name != "correlation")
                throw InputError(place(name, node), "is not known", "valid: study, vary, correlation");
        }
        if (const toml::table* table = table_of(root, "study")) read_head(*table);
        if (const toml::table* table = table_of(root, "vary")) read_factors("", *table);
        if (study_.factors.empty())
            throw InputError({.file = study_.file, .line = 0, .key = "vary", .value = {}},
                             "names nothing to vary",
                             "give keys of a case with lists, ranges or distributions");
        if (const toml::node* node = root.get("correlation")) read_correlations(*node);
        check_samples(root);
    }

  private:
    [[nodiscard]] InputPlace place(std::string key, const toml::node& node) const {
        const bool simple = !node.is_table() && !node.is_array();
        std::string value = simple ? text_of(node) : std::string();
        for (std::string* text : {&key, &value})
            if (text->size() > longest_quoted) *text = text->substr(0, longest_quoted) + "...";
        return {.file = study_.file,
                .line = static_cast<int>(node.source().begin.line),
                .key = std::move(key),
                .value = std::move(value)};
    }

    /// nullptr where it is not there.
    [[nodiscard]] const toml::table* table_of(const toml::table& root, const char* name) const {
        const toml::node* node = root.get(name);
        if (node != nullptr && !node->is_table())
            throw InputError(place(name, *node), "is not a table", fmt::format("write [{}]", name));
        return node == nullptr ? nullptr : node->as_table();
    }

    [[nodiscard]] std::string word(const char* key, const toml::node& node) const {
        const auto text = node.value_exact<std::string>();
        if (!text || text->empty() || text->find('\0') != std::string::npos)
            throw InputError(place(fmt::format("study.{}", key), node), "is not a text in quotes",
                             "give one without a zero byte");
        return *text;
    }

    void read_head(const toml::table& table) {
        for (const auto& [key, node] : table) {
            const std::string name(key.str());
            if (std::ranges::find(study_keys, name) == study_keys.end())
                throw InputError(place("study." + name, node), "is not known",
                                 fmt::format("valid: {}", fmt::join(study_keys, ", ")));
        }
        if (const toml::node* node = table.get("name")) study_.name = word("name", *node);
        if (const toml::node* node = table.get("case")) study_.case_file = in_folder(word("case", *node));
        if (const toml::node* node = table.get("design")) study_.design = design_of(*node);
        if (const toml::node* node = table.get("samples"))
            study_.samples = static_cast<int>(count_of("samples", *node, 1'000'000));
        if (const toml::node* node = table.get("seed"))
            study_.seed =
                static_cast<std::uint64_t>(count_of("seed", *node, std::numeric_limits<std::int64_t>::max()));
    }

    [[nodiscard]] StudyDesign design_of(const toml::node& node) const {
        const std::string word = text_of(node);
        if (word == "full") return StudyDesign::full;
        if (word == "one-at-a-time") return StudyDesign::one_at_a_time;
        throw InputError(place("study.design", node), "is not known", "valid: full, one-at-a-time");
    }

    [[nodiscard]] std::int64_t count_of(const char* name, const toml::node& node, std::int64_t most) const {
        const auto value = node.value_exact<std::int64_t>();
        if (!value || *value < 1 || *value > most)
            throw InputError(place(fmt::format("study.{}", name), node), "is not a count",
                             fmt::format("give a whole number from 1 to {}", most));
        return *value;
    }

    /// material.friction_angle_deg may be one quoted key, dotted, or a table within a table.
    void read_factors(const std::string& before, const toml::table& table) {
        for (const auto& [key, node] : table) {
            const std::string name = fmt::format("{}{}", before, key.str());
            const toml::table* inner = node.as_table();
            if (inner != nullptr && !is_spread(*inner)) {
                read_factors(name + ".", *inner);
                continue;
            }
            const auto earlier = std::ranges::find(study_.factors, name, &Factor::key);
            if (earlier != study_.factors.end())
                throw InputError(place(name, node),
                                 fmt::format("is varied in line {} too", earlier->place.line),
                                 "vary it once");
            study_.factors.push_back({name, values_of(name, node), place(name, node)});
        }
    }

    static bool is_spread(const toml::table& table) {
        return table.contains("distribution") || table.contains("from");
    }

    [[nodiscard]] std::variant<std::vector<std::string>, Distribution> values_of(
        const std::string& name, const toml::node& node) const {
        if (const toml::table* table = node.as_table()) {
            if (table->contains("distribution")) return distribution(name, *table);
            return range(name, *table);
        }
        std::vector<std::string> values;
        if (const toml::array* array = node.as_array()) {
            for (const toml::node& item : *array) values.push_back(text_of(item));
        } else {
            values.push_back(text_of(node));
        }
        if (values.empty())
            throw InputError(place(name, node), "is an empty list", "give at least one value");
        if (std::ranges::find(path_keys, name) != path_keys.end())
            for (std::string& value : values) value = in_folder(value);
        check_values_differ(name, node, values);
        return values;
    }

    [[nodiscard]] double number(const std::string& name, const toml::table& table, const char* key) const {
        const toml::node* node = table.get(key);
        if (node == nullptr)
            throw InputError(place(name, table), fmt::format("has no {}", key), "give a number");
        const std::optional<double> value = number_in(*node);
        if (!value || !std::isfinite(*value))
            throw InputError(place(fmt::format("{}.{}", name, key), *node), "is not a number",
                             "give a number");
        return *value;
    }
    [[nodiscard]] double number_or(const std::string& name, const toml::table& table, const char* key,
                                   double otherwise) const {
        return table.contains(key) ? number(name, table, key) : otherwise;
    }

    void check_keys(const std::string& name, const toml::table& table,
                    std::initializer_list<const char*> known) const {
        for (const auto& [key, node] : table)
            if (std::ranges::find(known, std::string(key.str())) == known.end())
                throw InputError(place(fmt::format("{}.{}", name, key.str()), node), "is not known",
                                 fmt::format("valid: {}", fmt::join(known, ", ")));
    }

    [[nodiscard]] std::vector<std::string> range(const std::string& name, const toml::table& table) const {
        check_keys(name, table, {"from", "to", "step"});
        const double from = number(name, table, "from"), to = number(name, table, "to"),
                     step = number(name, table, "step");
        const double count = std::floor((to - from) / step + 1e-9);
        if (!(step != 0 && count >= 0 && count < most_values_of_a_range))
            throw InputError(place(name, table),
                             fmt::format("does not lead from {} to {} in steps of {}", from, to, step),
                             "give from, to and a step between them");
        std::vector<std::string> values;
        for (int k = 0; k <= static_cast<int>(count); ++k)
            values.push_back(fmt::format("{:.12g}", from + k * step));
        check_values_differ(name, table, values);
        return values;
    }

    /// A value that stands there twice would count twice in what the table says of probabilities.
    void check_values_differ(const std::string& name, const toml::node& node,
                             const std::vector<std::string>& values) const {
        std::set<std::string> seen;
        for (const std::string& value : values) {
            double number = 0;
            const char* const end = value.data() + value.size();
            const auto read = std::from_chars(value.data(), end, number);
            const bool is_number = read.ec == std::errc{} && read.ptr == end;
            if (!seen.insert(is_number ? fmt::format("{}", number) : value).second)
                throw InputError(place(name, node), fmt::format("gives {} twice", value),
                                 "give each value once");
        }
    }

    [[nodiscard]] Distribution distribution(const std::string& name, const toml::table& table) const {
        const std::string word = text_of(*table.get("distribution"));
        const auto shape = std::ranges::find(shapes, word);
        if (shape == shapes.end())
            throw InputError(place(name + ".distribution", *table.get("distribution")), "is not known",
                             fmt::format("valid: {}", fmt::join(shapes, ", ")));
        Distribution result;
        result.shape = static_cast<Distribution::Shape>(shape - shapes.begin());
        switch (result.shape) {
            case Distribution::Shape::normal:
            case Distribution::Shape::lognormal:
                check_keys(name, table, {"distribution", "mean", "deviation", "low", "high"});
                result.mean = number(name, table, "mean");
                result.deviation = number(name, table, "deviation");
                result.low = number_or(name, table, "low", -infinite);
                result.high = number_or(name, table, "high", infinite);
                break;
            case Distribution::Shape::triangular:
                check_keys(name, table, {"distribution", "low", "mode", "high"});
                result.mode = number(name, table, "mode");
                [[fallthrough]];
            case Distribution::Shape::uniform:
                if (result.shape == Distribution::Shape::uniform)
                    check_keys(name, table, {"distribution", "low", "high"});
                result.low = number(name, table, "low");
                result.high = number(name, table, "high");
                break;
        }
        check_spread(name, table, result);
        return result;
    }

    void check_spread(const std::string& name, const toml::table& table, const Distribution& d) const {
        using Shape = Distribution::Shape;
        const bool by_moments = d.shape == Shape::normal || d.shape == Shape::lognormal;
        if (!(d.low < d.high) || (by_moments && !(d.deviation > 0)))
            throw InputError(
                place(name, table), "is a distribution without spread",
                by_moments ? "give a deviation above zero, and low below high" : "give low below high");
        if (d.shape == Shape::lognormal && !(d.mean > 0))
            throw InputError(place(name, table),
                             "is a lognormal distribution with a mean that is not positive",
                             "give a mean above zero");
        if (d.shape == Shape::triangular && !(d.low <= d.mode && d.mode <= d.high))
            throw InputError(place(name, table), "has its mode outside its ends", "give low <= mode <= high");
    }

    void read_correlations(const toml::node& node) {
        const toml::array* list = node.as_array();
        if (list == nullptr)
            throw InputError(place("correlation", node), "is not a list of tables", "write [[correlation]]");
        for (const toml::node& item : *list) {
            const toml::table* table = item.as_table();
            if (table == nullptr)
                throw InputError(place("correlation", item), "is not a table", "write [[correlation]]");
            check_keys("correlation", *table, {"between", "rank"});
            const toml::array* between = (*table)["between"].as_array();
            if (between == nullptr || between->size() != 2)
                throw InputError(place("correlation.between", item), "does not name two keys",
                                 "give between = [\"one.key\", \"another.key\"]");
            Correlation correlation{sampled_factor((*between)[0]), sampled_factor((*between)[1]),
                                    number("correlation", *table, "rank")};
            if (!(std::abs(correlation.rank) < 1) || correlation.first == correlation.second)
                throw InputError(place("correlation.rank", item), "is not a correlation of two things",
                                 "give a number between -1 and 1, and two different keys");
            if (std::ranges::any_of(study_.correlations, [&](const Correlation& earlier) {
                    return std::minmax(earlier.first, earlier.second) ==
                           std::minmax(correlation.first, correlation.second);
                }))
                throw InputError(place("correlation.between", item),
                                 "names two keys that are correlated before", "say it once");
            study_.correlations.push_back(correlation);
        }
    }

    [[nodiscard]] std::size_t sampled_factor(const toml::node& node) const {
        const std::string key = text_of(node);
        const auto found = std::ranges::find(study_.factors, key, &Factor::key);
        if (found == study_.factors.end() || !found->is_sampled())
            throw InputError(place("correlation.between", node), "is not varied by a distribution",
                             "give a key of [vary] that has one");
        return static_cast<std::size_t>(found - study_.factors.begin());
    }

    void check_samples(const toml::table& root) const {
        const bool sampled = std::ranges::any_of(study_.factors, &Factor::is_sampled);
        const bool full = study_.design == StudyDesign::full;
        if (sampled && full && study_.samples == 0)
            throw InputError(place("study.samples", root), "is missing for a study with distributions",
                             "give the number of samples to draw");
        if ((!sampled || !full) && study_.samples > 0)
            throw InputError(place("study.samples", *root["study"]["samples"].node()),
                             "has nothing to draw from",
                             "give a distribution in a full design, or leave it out");
    }

    [[nodiscard]] std::string in_folder(const std::string& path) const {
        if (path.empty() || fs::path(path).is_absolute()) return path;
        return (fs::path(study_.file).parent_path() / path).lexically_normal().string();
    }

    Study& study_;
};

}  // namespace

Study read_study(const std::string& path) {
    Study study;
    study.file = path;
    study.text = read_toml_text(path, "give a study (.toml)");
    study.name = fs::path(path).stem().string();
    StudyReader(study).read(parse_toml(study.text, path));
    for (const Factor& factor : study.factors) check_share(factor);
    return study;
}

}  // namespace runout
