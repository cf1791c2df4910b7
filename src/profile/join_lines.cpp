#include "profile/join_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/input_error.h"

namespace runout {
namespace {

constexpr double widest_gap_m = 0.01;
constexpr double gap_share = 1e-4;

// Of the tolerance: points as near as this are one. Bulges and splines repeat their corners with rounding.
constexpr double same_point_share = 1e-4;

// More is no place in a section; beyond it, cells of the tolerance could not be counted.
constexpr double farthest_m = 1e8;

// A square of the tolerance that holds more ends than this is no joint of two lines.
constexpr std::size_t most_ends_in_a_cell = 64;

bool before(const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

std::string shown(const Vec2& p) {
    return fmt::format("({:.10g}, {:.10g})", p.x(), p.y());
}

[[noreturn]] void refuse(const LinePlace& place, const std::string& problem, const std::string& valid) {
    throw InputError({place.file, 0, place.what, ""}, problem, valid);
}

/// Numbers the places where ends of pieces are: ends within the tolerance have one number.
class Joints {
  public:
    Joints(double tolerance, const LinePlace& place)
        : tolerance_(tolerance), cell_(std::max(tolerance, 1e-9)), place_(place) {}

    std::size_t at(const Vec2& end) {
        const Cell home{std::floor(end.x() / cell_), std::floor(end.y() / cell_)};
        for (double i = -1; i <= 1; ++i)
            for (double j = -1; j <= 1; ++j)
                if (const auto found = found_in({home.first + i, home.second + j}, end)) return *found;
        std::vector<std::size_t>& here = cells_[home];
        if (here.size() >= most_ends_in_a_cell)
            refuse(place_, fmt::format("has a heap of line ends at {}", shown(end)), "clean the drawing up");
        here.push_back(found_.size());
        found_.push_back(end);
        kept_.push_back(end);
        return found_.size() - 1;
    }

    /// The end that stays of those that meet.
    void keep_first(std::size_t joint, const Vec2& end) {
        if (before(end, kept_[joint])) kept_[joint] = end;
    }
    [[nodiscard]] const Vec2& place(std::size_t joint) const { return kept_[joint]; }
    [[nodiscard]] std::size_t count() const { return kept_.size(); }

  private:
    using Cell = std::pair<double, double>;

    [[nodiscard]] std::optional<std::size_t> found_in(const Cell& cell, const Vec2& end) const {
        const auto found = cells_.find(cell);
        if (found == cells_.end()) return std::nullopt;
        for (const std::size_t joint : found->second)
            if ((found_[joint] - end).norm() <= tolerance_) return joint;
        return std::nullopt;
    }

    double tolerance_;
    double cell_;
    const LinePlace& place_;
    std::map<Cell, std::vector<std::size_t>> cells_;
    std::vector<Vec2> found_;  ///< the first end at each joint: what others are near to
    std::vector<Vec2> kept_;
};

/// A piece between two joints.
struct Link {
    const Polyline* points;
    std::size_t from;
    std::size_t to;
};

bool same_course(const Link& a, const Link& b, double tolerance) {
    const std::size_t n = a.points->size();
    if (n != b.points->size()) return false;
    const bool turned = a.from != b.from;
    for (std::size_t i = 0; i < n; ++i)
        if (((*a.points)[i] - (*b.points)[turned ? n - 1 - i : i]).norm() > tolerance) return false;
    return true;
}

bool is_a_dot(const Polyline& piece, double tolerance) {
    return std::ranges::all_of(piece, [&](const Vec2& p) { return (p - piece.front()).norm() <= tolerance; });
}

/// The pieces as links, each once.
std::vector<Link> links_of(const std::vector<Polyline>& pieces, double tolerance, Joints& joints) {
    // In order of their places, so that which ends meet does not hang on the order of the file.
    std::vector<const Polyline*> sorted;
    for (const Polyline& piece : pieces)
        if (!is_a_dot(piece, tolerance)) sorted.push_back(&piece);
    const auto first_end = [](const Polyline* p) {
        return before(p->front(), p->back()) ? p->front() : p->back();
    };
    std::ranges::stable_sort(
        sorted, [&](const Polyline* a, const Polyline* b) { return before(first_end(a), first_end(b)); });
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Link>> between;
    std::vector<Link> links;
    for (const Polyline* piece : sorted) {
        const Link link{piece, joints.at(piece->front()), joints.at(piece->back())};
        std::vector<Link>& rivals = between[std::minmax(link.from, link.to)];
        if (std::ranges::any_of(rivals, [&](const Link& r) { return same_course(r, link, tolerance); }))
            continue;
        // Two lines between the same ends make a ring; a third is refused at its joint.
        if (rivals.size() < 3) rivals.push_back(link);
        links.push_back(link);
        joints.keep_first(link.from, piece->front());
        joints.keep_first(link.to, piece->back());
    }
    return links;
}

using LinksAtJoints = std::vector<std::vector<std::size_t>>;

LinksAtJoints links_at_joints(const std::vector<Link>& links, const Joints& joints, const LinePlace& place) {
    LinksAtJoints at(joints.count());
    for (std::size_t i = 0; i < links.size(); ++i)
        for (const std::size_t joint : {links[i].from, links[i].to}) {
            at[joint].push_back(i);
            if (at[joint].size() > 2)
                refuse(place,
                       fmt::format("has more than two lines that meet at {}", shown(joints.place(joint))),
                       "leave one line, from one end to the other");
        }
    return at;
}

/// From a joint along links that were not walked, until there is none.
Polyline walked(std::size_t joint, const std::vector<Link>& links, const LinksAtJoints& at,
                const Joints& joints, std::vector<char>& done) {
    Polyline line{joints.place(joint)};
    while (true) {
        const auto next = std::ranges::find_if(at[joint], [&](std::size_t i) { return done[i] == 0; });
        if (next == at[joint].end()) return line;
        const Link& link = links[*next];
        done[*next] = 1;
        const Polyline& points = *link.points;
        const bool forwards = link.from == joint;
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            line.push_back(points[forwards ? i : points.size() - 1 - i]);
        joint = forwards ? link.to : link.from;
        line.push_back(joints.place(joint));
    }
}

void turn_to_rising_x(Polyline& line) {
    if (before(line.back(), line.front())) std::ranges::reverse(line);
}

void drop_repeated(Polyline& line, double nearest) {
    Polyline kept;
    for (const Vec2& p : line)
        if (kept.empty() || (p - kept.back()).norm() > nearest) kept.push_back(p);
    // The end is a joint, and stays where it is.
    if (kept.size() > 1) kept.back() = line.back();
    line = std::move(kept);
}

void make_steps_back_vertical(Polyline& line, double tolerance) {
    for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i].x() < line[i - 1].x() && line[i].x() > line[i - 1].x() - tolerance)
            line[i].x() = line[i - 1].x();
}

[[noreturn]] void refuse_gap(std::vector<Polyline>& lines, double tolerance, const LinePlace& place) {
    std::ranges::sort(lines,
                      [](const Polyline& a, const Polyline& b) { return before(a.front(), b.front()); });
    const Vec2& end = lines[0].back();
    const Vec2& begin = lines[1].front();
    if (begin.x() < end.x() - tolerance)
        refuse(place,
               fmt::format("has {} lines that do not meet, two of them one above the other between chainage "
                           "{:.10g} and {:.10g}",
                           lines.size(), begin.x(), std::min(end.x(), lines[1].back().x())),
               "a section has one ground: keep that line alone on its layer");
    refuse(place, fmt::format("has a gap between {} and {}", shown(end), shown(begin)),
           fmt::format("draw the line through; ends meet that are no more than {:.2g} m apart", tolerance));
}

void check_places(const std::vector<Polyline>& pieces, const LinePlace& place) {
    for (const Polyline& piece : pieces)
        for (const Vec2& p : piece)
            if (!p.allFinite() || p.cwiseAbs().maxCoeff() > farthest_m)
                refuse(place, fmt::format("has a point at {}", shown(p)),
                       fmt::format("give coordinates up to {:g} m of either sign", farthest_m));
}

/// The lines that the pieces make: open ones first, then rings.
std::vector<Polyline> lines_of(const std::vector<Polyline>& pieces, double tolerance, const LinePlace& place,
                               std::size_t& open) {
    Joints joints(tolerance, place);
    const std::vector<Link> links = links_of(pieces, tolerance, joints);
    const LinksAtJoints at = links_at_joints(links, joints, place);
    std::vector<char> done(links.size(), 0);
    std::vector<Polyline> lines;
    const auto walk_from = [&](std::size_t joint) {
        const auto left = std::ranges::any_of(at[joint], [&](std::size_t i) { return done[i] == 0; });
        if (left) lines.push_back(walked(joint, links, at, joints, done));
    };
    for (std::size_t joint = 0; joint < at.size(); ++joint)
        if (at[joint].size() == 1) walk_from(joint);
    open = lines.size();
    for (std::size_t joint = 0; joint < at.size(); ++joint) walk_from(joint);
    return lines;
}

}  // namespace

double joining_tolerance(const std::vector<Polyline>& pieces) {
    Vec2 low = Vec2::Constant(farthest_m);
    Vec2 high = -low;
    for (const Polyline& piece : pieces)
        for (const Vec2& p : piece) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    return std::min(widest_gap_m, gap_share * std::max(0.0, (high - low).maxCoeff()));
}

Polyline join_lines(const std::vector<Polyline>& pieces, Course course, const LinePlace& place) {
    check_places(pieces, place);
    const double tolerance = joining_tolerance(pieces);
    std::size_t open = 0;
    std::vector<Polyline> lines = lines_of(pieces, tolerance, place, open);
    if (lines.empty()) refuse(place, "has no line that is longer than a dot", "draw it as a line");
    const bool closed = open < lines.size();
    if (closed && course == Course::open)
        refuse(place,
               fmt::format("has a line that closes on itself at {}, or two with the same ends",
                           shown(lines.back().front())),
               "keep one line that runs from one end to the other");
    if (!closed && course == Course::closed)
        refuse(place,
               fmt::format("is not closed: its ends are at {} and {}", shown(lines.front().front()),
                           shown(lines.front().back())),
               "close the outline of the source, or name the layer of a slip line with slip=");
    for (Polyline& line : lines) turn_to_rising_x(line);
    if (lines.size() > 1 && course == Course::closed)
        refuse(place, fmt::format("has {} outlines that do not meet", lines.size()), "draw one outline");
    if (lines.size() > 1) refuse_gap(lines, tolerance, place);
    Polyline line = std::move(lines.front());
    if (course == Course::open) make_steps_back_vertical(line, tolerance);
    drop_repeated(line, same_point_share * tolerance);
    if (course == Course::closed) line.pop_back();
    return line;
}

}  // namespace runout
