#include "report/chart/section_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/printable.h"
#include "core/units.h"

namespace runout {
namespace {

constexpr int most_rows = 24;
constexpr int fewest_rows = 6;
constexpr double character_height = 2;  // of a terminal, in widths of a character

std::string point_text(const Profile& profile, const Vec2& local) {
    const Vec2 at = profile.to_section(local);
    return fmt::format("({:.10g}, {:.10g})", at.x(), at.y());
}

/// Lowest and highest elevation of a chain at x; none where the chain is not there.
std::optional<std::pair<double, double>> heights_at(const Polyline& chain, double x, bool closed) {
    std::optional<std::pair<double, double>> heights;
    const std::size_t segments = chain.size() - (closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
        const Vec2& a = chain[i];
        const Vec2& b = chain[(i + 1) % chain.size()];
        if (x < std::min(a.x(), b.x()) || x > std::max(a.x(), b.x())) continue;
        const bool vertical = a.x() == b.x();
        const std::vector<double> shares =
            vertical ? std::vector{0.0, 1.0} : std::vector{(x - a.x()) / (b.x() - a.x())};
        for (const double share : shares) {
            const double y = a.y() + share * (b.y() - a.y());
            if (!heights) heights = {y, y};
            heights->first = std::min(heights->first, y);
            heights->second = std::max(heights->second, y);
        }
    }
    return heights;
}

/// A drawing in characters of which one place stands for `width` x `height` metres.
class Canvas {
  public:
    Canvas(const Profile& profile, int columns) : columns_(columns) {
        left_ = profile.ground.front().x();
        right_ = profile.ground.back().x();
        low_ = high_ = profile.ground.front().y();
        for (const Vec2& point : profile.ground) {
            low_ = std::min(low_, point.y());
            high_ = std::max(high_, point.y());
        }
        width_ = (right_ - left_) / columns;
        const double true_rows = (high_ - low_) / (character_height * width_);
        rows_ = std::clamp(static_cast<int>(std::lround(true_rows)), fewest_rows, most_rows);
        height_ = std::max((high_ - low_) / rows_, 1e-9);
        exaggeration_ = character_height * width_ / height_;
        lines_.assign(static_cast<std::size_t>(rows_) + 1,
                      std::string(static_cast<std::size_t>(columns), ' '));
    }

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] double exaggeration() const { return exaggeration_; }
    [[nodiscard]] double x_of(int column) const { return left_ + (column + 0.5) * width_; }

    void put(int column, double y, char mark) {
        const int row = std::clamp(static_cast<int>(std::lround((high_ - y) / height_)), 0, rows_);
        lines_[static_cast<std::size_t>(row)][static_cast<std::size_t>(std::clamp(column, 0, columns_ - 1))] =
            mark;
    }
    void put(const Vec2& at, char mark) { put(static_cast<int>((at.x() - left_) / width_), at.y(), mark); }
    void fill(int column, double from, double to, char mark) {
        for (double y = from; y <= to; y += height_ / 2) put(column, y, mark);
        put(column, to, mark);
    }

    /// Lines with the elevation of every fourth; mirrored when chainage grows to the left.
    [[nodiscard]] std::string text(const Profile& profile) const {
        std::string drawing;
        for (int row = 0; row <= rows_; ++row) {
            std::string line = lines_[static_cast<std::size_t>(row)];
            if (!profile.descends_with_chainage) std::ranges::reverse(line);
            line.erase(line.find_last_not_of(' ') + 1);
            const double elevation = profile.toe_elevation_m + high_ - row * height_;
            drawing += (row % 4 == 0 ? fmt::format("{:>9.1f} |", elevation) : std::string(9, ' ') + " |") +
                       line + "\n";
        }
        const auto [from, to] =
            std::minmax({profile.to_section({left_, 0}).x(), profile.to_section({right_, 0}).x()});
        const std::string first = fmt::format("{:.6g}", from);
        const std::string last = fmt::format("{:.6g} m", to);
        const auto gap =
            static_cast<std::size_t>(std::max(1, columns_ - static_cast<int>(first.size() + last.size())));
        return drawing + std::string(11, ' ') + first + std::string(gap, ' ') + last + "\n";
    }

  private:
    int columns_;
    int rows_ = 0;
    double left_ = 0;
    double right_ = 0;
    double low_ = 0;
    double high_ = 0;
    double width_ = 1;
    double height_ = 1;
    double exaggeration_ = 1;
    std::vector<std::string> lines_;
};

void draw_source(Canvas& canvas, const Profile& profile, const Source& source) {
    for (int column = 0; column < canvas.columns(); ++column)
        if (const auto heights = heights_at(source.outline, canvas.x_of(column), true))
            canvas.fill(column, heights->first, heights->second, '#');
    const Polyline line = discontinuity_line(source);
    const char stroke = profile.descends_with_chainage ? '\\' : '/';
    for (int column = 0; column < canvas.columns(); ++column)
        if (const auto heights = heights_at(line, canvas.x_of(column), false))
            canvas.put(column, heights->first, stroke);
}

Curve curve(const std::string& label, Curve::Style style, const Profile& profile, const Polyline& local) {
    Curve drawn{label, style, {}};
    for (const Vec2& point : local) drawn.points.push_back(profile.to_section(point));
    return drawn;
}

}  // namespace

Polyline discontinuity_line(const Source& source) {
    double top = source.exit_point.y();
    for (const Vec2& point : source.outline) top = std::max(top, point.y());
    const double rise = top - source.exit_point.y();
    return {source.exit_point, source.exit_point + Vec2(-rise / std::tan(source.discontinuity_angle), rise)};
}

std::string section_text(const SectionView& view) {
    const Profile& profile = view.profile;
    const Vec2& crest = profile.ground[profile.crest];
    std::string text = fmt::format("{}\n", printable(profile.origin));
    if (!profile.read_as.empty()) text += fmt::format("  {}\n", printable(profile.read_as));
    text += fmt::format("  length         {:.6g} m, {} points\n",
                        profile.ground.back().x() - profile.ground.front().x(), profile.ground.size());
    text += fmt::format("  toe            {}, {}\n", point_text(profile, profile.ground[profile.toe]),
                        profile.toe_given ? "given" : "found");
    text += fmt::format("  crest          {}, {}, {:.4g} m above the toe\n", point_text(profile, crest),
                        profile.crest_given ? "given" : "found", crest.y());
    text += fmt::format("  face           {:.4g} deg from toe to crest\n", degrees(profile.slope_angle));
    for (const std::string& doubt : profile.doubts) text += "WARNING: " + doubt + "\n";
    if (view.source == nullptr) return text;
    const Source& source = *view.source;
    text += fmt::format("  source         type {}, {:.6g} m2, head {}\n", to_string(source.type), source.area,
                        point_text(profile, source.head));
    text += fmt::format("  discontinuity  {:.4g} deg through P {}, S_front/S {:.4f}\n",
                        degrees(source.discontinuity_angle), point_text(profile, source.exit_point),
                        source.front_area / source.area);
    return text;
}

std::string section_drawing(const SectionView& view, int columns) {
    const Profile& profile = view.profile;
    Canvas canvas(profile, columns);
    for (int column = 0; column < columns; ++column)
        if (const auto heights = heights_at(profile.ground, canvas.x_of(column), false))
            canvas.fill(column, heights->first, heights->second, '.');
    if (view.source != nullptr) draw_source(canvas, profile, *view.source);
    canvas.put(profile.ground[profile.crest], 'C');
    if (view.source != nullptr) canvas.put(view.source->exit_point, 'P');
    canvas.put(profile.ground[profile.toe], 'T');
    std::string legend = "           . ground  T toe  C crest";
    if (view.source != nullptr)
        legend += fmt::format("  # source  P exit point  {} discontinuity",
                              profile.descends_with_chainage ? '\\' : '/');
    if (canvas.exaggeration() > 1.05 || canvas.exaggeration() < 0.95)
        legend += fmt::format("; heights x {:.2g}", canvas.exaggeration());
    return canvas.text(profile) + legend + "\n";
}

Figure section_figure(const SectionView& view, const std::string& title) {
    const Profile& profile = view.profile;
    Figure figure;
    figure.name = "section";
    figure.title = title;
    figure.x_label = "chainage, m";
    figure.y_label = "elevation, m";
    figure.equal_scales = true;
    figure.curves.push_back(curve("ground", Curve::Style::line, profile, profile.ground));
    if (view.source != nullptr) {
        Polyline outline = view.source->outline;
        outline.push_back(outline.front());
        figure.curves.push_back(curve("source", Curve::Style::line, profile, outline));
        figure.curves.push_back(
            curve(fmt::format("discontinuity, {:.4g} deg", degrees(view.source->discontinuity_angle)),
                  Curve::Style::dashed, profile, discontinuity_line(*view.source)));
    }
    figure.curves.push_back(curve("toe and crest", Curve::Style::markers, profile,
                                  {profile.ground[profile.toe], profile.ground[profile.crest]}));
    return figure;
}

}  // namespace runout
