#include "report/compare/travel_relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.h"

// Origin of every number: Hunter & Fell (2003), Can. Geotech. J. 40, 1123-1141; Finlay, Mostyn & Fell (1999),
// second-hand, it agrees with Hunter & Fell's line within about 4 %; Corominas (1996), Can. Geotech. J. 33,
// 260-271, table 1 (its line through all 204 landslides second-hand); fits to wet and dry landslides: the
// public travel-angle calculator after Brideau et al. (GNS Science, New Zealand), whose data are in
// data/travel_angles.csv.

namespace runout {
namespace {

constexpr double hunter_fell_most_m3 = 500;
constexpr double level_deg = 5;  // our reading of "near-horizontal"

/// log10(H/L) = a + b log10(V), 95 % within +- half_width.
struct ClassLine {
    const char* kind;
    const char* path;
    int count;
    double a, b, half_width;
    bool second_hand;
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array corominas = {
    ClassLine{"rockfalls", "all", 47, 0.21, -0.109, 0.253, false},
    ClassLine{"rockfalls", "obstructed", 16, 0.231, -0.091, 0.103, false},
    ClassLine{"rockfalls", "deflected", 6, 1.078, -0.233, 0.413, false},
    ClassLine{"rockfalls", "unobstructed", 14, 0.167, -0.119, 0.309, false},
    ClassLine{"translational slides", "all", 69, -0.159, -0.068, 0.435, false},
    ClassLine{"translational slides", "obstructed", 23, -0.133, -0.057, 0.382, false},
    ClassLine{"translational slides", "unobstructed", 42, -0.143, -0.08, 0.433, false},
    ClassLine{"debris flows", "all", 71, -0.012, -0.105, 0.386, false},
    ClassLine{"debris flows", "obstructed", 18, -0.031, -0.102, 0.358, false},
    ClassLine{"debris flows", "channelized", 19, -0.077, -0.109, 0.467, false},
    ClassLine{"debris flows", "unobstructed", 29, -0.049, -0.108, 0.27, false},
    ClassLine{"earthflows and mudslides", "all", 17, -0.214, -0.07, 0.512, false},
    ClassLine{"earthflows and mudslides", "unobstructed", 8, -0.22, -0.138, 0.408, false},
    ClassLine{"all landslides", "all", 204, -0.047, -0.085, none, true},
};

/// H/L = c V^k; c for 50, 16 and 2 % that go further.
struct Fit {
    const char* kind;
    double c50, c16, c2, k;
    double least_m3, most_m3;
};

constexpr std::array fits = {
    Fit{"dry landslides", 1.0795, 0.9026, 0.7547, -0.033690, 0, 1e5},
    Fit{"wet landslides", 0.8467, 0.6807, 0.5472, -0.070562, 0, 1e5},
    Fit{"debris flows", 0.8169, 0.5798, 0.4116, -0.107499, 0, 1e6},
    Fit{"rock avalanches", 4.7786, 3.4085, 2.4312, -0.163147, 1e5, std::numeric_limits<double>::infinity()},
};

constexpr const char* needs_width = "needs the volume: give the width of the slide with --width";

bool is_level(const TravelCase& slide) {
    return std::abs(degrees(slide.apron_angle)) <= level_deg;
}

std::string level_refusal(const TravelCase& slide) {
    return fmt::format("the run-out surface dips {:.1f} deg, and is not near-horizontal",
                       degrees(slide.apron_angle));
}

TravelEstimate hunter_fell(const TravelCase& slide) {
    TravelEstimate estimate{
        "Hunter & Fell, cut slopes",
        "Hunter & Fell 2003, eq. 2",
        false,
        "H/L = 0.78 sqrt(tan of the cut's angle)",
        fmt::format("cut above near-horizontal ground (taken as within {:g} deg), V < {:g} m3", level_deg,
                    hunter_fell_most_m3),
        {},
        {},
        {}};
    if (!is_level(slide))
        estimate.refusal = level_refusal(slide);
    else if (slide.volume >= hunter_fell_most_m3)
        estimate.refusal = fmt::format("the volume of {:.4g} m3 is beyond its range", slide.volume);
    else if (!(slide.slope_angle > 0) || slide.slope_angle >= radians(90))
        estimate.refusal = "the cut has no angle between 0 and 90 deg";
    if (!estimate.refusal.empty()) return estimate;
    if (std::isnan(slide.volume)) estimate.caution = "its limit on the volume is not checked: no --width";
    estimate.lines = {{"line", 0.78 * std::sqrt(std::tan(slide.slope_angle))}};
    return estimate;
}

TravelEstimate finlay(const TravelCase& slide) {
    TravelEstimate estimate{
        "Finlay et al., Hong Kong cuts",
        "Finlay, Mostyn & Fell 1999",
        true,
        "log L = 0.109 + 1.010 log H - 0.506 log(tan of the cut's angle)",
        "cuts above near-horizontal ground in Hong Kong; its range of sizes has not been read",
        {},
        {},
        {}};
    if (!is_level(slide))
        estimate.refusal = level_refusal(slide);
    else if (!(slide.slope_angle > 0) || slide.slope_angle >= radians(90))
        estimate.refusal = "the cut has no angle between 0 and 90 deg";
    else if (!(slide.drop > 0))
        estimate.refusal = "there is no drop";
    if (!estimate.refusal.empty()) return estimate;
    const double length = std::pow(
        10.0, 0.109 + 1.010 * std::log10(slide.drop) - 0.506 * std::log10(std::tan(slide.slope_angle)));
    estimate.lines = {{"line", slide.drop / length}};
    return estimate;
}

TravelEstimate corominas_line(const TravelCase& slide, const ClassLine& line) {
    TravelEstimate estimate{
        fmt::format("Corominas, {} ({})", line.kind, line.path),
        "Corominas 1996, table 1",
        line.second_hand,
        fmt::format("log(H/L) = {:g} {:+g} log V", line.a, line.b),
        fmt::format("{} landslides of this class; the table gives no limits of the volume", line.count),
        {},
        {},
        {}};
    if (!(slide.volume > 0)) {
        estimate.refusal = needs_width;
        return estimate;
    }
    const double middle = line.a + line.b * std::log10(slide.volume);
    estimate.lines = {{"mean", std::pow(10.0, middle)}};
    if (std::isfinite(line.half_width)) {
        estimate.lines.push_back({"95 % lower limit", std::pow(10.0, middle - line.half_width)});
        estimate.lines.push_back({"95 % upper limit", std::pow(10.0, middle + line.half_width)});
    }
    return estimate;
}

std::string range_of(const Fit& fit) {
    if (fit.least_m3 > 0) return fmt::format("V >= {:g} m3", fit.least_m3);
    return fmt::format("V <= {:g} m3", fit.most_m3);
}

TravelEstimate fitted(const TravelCase& slide, const Fit& fit) {
    TravelEstimate estimate{fmt::format("H/L = c V^k, {}", fit.kind),
                            "travel-angle calculator after Brideau et al. (GNS Science)",
                            false,
                            fmt::format("H/L = {:g} V^{:g}; {:g} and {:g} for 16 and 2 % that go further",
                                        fit.c50, fit.k, fit.c16, fit.c2),
                            range_of(fit),
                            {},
                            {},
                            {}};
    if (!(slide.volume > 0))
        estimate.refusal = needs_width;
    else if (slide.volume < fit.least_m3 || slide.volume > fit.most_m3)
        estimate.refusal = fmt::format("the volume of {:.4g} m3 is beyond its range", slide.volume);
    if (!estimate.refusal.empty()) return estimate;
    const double power = std::pow(slide.volume, fit.k);
    estimate.lines = {{"50 % go further", fit.c50 * power},
                      {"16 % go further", fit.c16 * power},
                      {"2 % go further", fit.c2 * power}};
    return estimate;
}

}  // namespace

std::vector<TravelEstimate> travel_estimates(const TravelCase& slide) {
    std::vector<TravelEstimate> estimates = {hunter_fell(slide), finlay(slide)};
    for (const Fit& fit : fits) estimates.push_back(fitted(slide, fit));
    for (const ClassLine& line : corominas) estimates.push_back(corominas_line(slide, line));
    return estimates;
}

std::vector<VolumeBand> volume_bands() {
    constexpr double least = 10, most = 1e5;  // of the chart
    std::vector<VolumeBand> bands;
    for (const Fit& fit : fits) {
        if (fit.least_m3 >= most) continue;
        const double to = std::min(fit.most_m3, most);
        bands.push_back({fmt::format("{}, 50 % go further", fit.kind), fit.c50, fit.k, least, to, false});
        bands.push_back({fmt::format("{}, 2 %", fit.kind), fit.c2, fit.k, least, to, false});
    }
    for (const ClassLine& line : corominas)
        if (line.second_hand)
            bands.push_back({fmt::format("Corominas, {} (second-hand)", line.kind), std::pow(10.0, line.a),
                             line.b, least, most, true});
    return bands;
}

}  // namespace runout
