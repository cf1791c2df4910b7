#include "gis/line_corridor.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "gis/gdal_access.h"

namespace runout {
namespace {

/// Pieces of an outline are no longer than this share of the half-width where the section bends.
constexpr double finest_share = 0.02;
constexpr int pieces_of_a_quarter_circle = 16;

OGRSpatialReference frame_of(const MapLine& line) {
    const OGRSpatialReference reference = map_reference(reference_from(line.crs, "coordinate system"));
    const double middle = 0.5 * (line.chainage_m.front() + line.chainage_m.back());
    return metric_reference(reference, point_at(line, middle), line.points);
}

OGRLineString line_through(const Polyline& points) {
    OGRLineString line;
    for (const Vec2& point : points) line.addPoint(point.x(), point.y());
    return line;
}

class Gathering : public OGRDefaultConstGeometryVisitor {
  public:
    using OGRDefaultConstGeometryVisitor::visit;
    void visit(const OGRPoint* point) override {
        if (point->IsEmpty() == 0) points.emplace_back(point->getX(), point->getY());
    }

    Polyline points;
};

}  // namespace

Polyline vertices_of(const OGRGeometry& geometry) {
    Gathering gathering;
    geometry.accept(&gathering);
    return std::move(gathering.points);
}

LineCorridor::LineCorridor(const MapLine& line, double half_width_m)
    : frame_(frame_of(line)), chainage_m_(line.chainage_m) {
    const Transformation there(map_reference(reference_from(line.crs, "coordinate system")), frame_);
    const double unit_m = frame_.GetLinearUnits();
    for (const Vec2& point : line.points) points_.push_back(there(point));
    const double reach = half_width_m / unit_m;
    finest_ = finest_share * reach;
    area_.reset(line_through(points_).Buffer(reach, pieces_of_a_quarter_circle));
    if (!area_) throw std::invalid_argument("a section line without an area beside it");
    const Vec2 back = (points_[0] - points_[1]).normalized();
    const Vec2 ahead = (points_.back() - points_[points_.size() - 2]).normalized();
    points_.insert(points_.begin(), points_.front() + reach * back);
    points_.push_back(points_.back() + reach * ahead);
    chainage_m_.insert(chainage_m_.begin(), chainage_m_.front() - half_width_m);
    chainage_m_.push_back(chainage_m_.back() + half_width_m);
    axis_ = line_through(points_);
}

Polyline LineCorridor::rim() const {
    return vertices_of(*area_);
}

double LineCorridor::chainage_of(const Vec2& point) const {
    double nearest = std::numeric_limits<double>::infinity(), chainage = 0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        const Vec2 along = points_[i + 1] - points_[i];
        const double share = std::clamp((point - points_[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const double distance = (points_[i] + share * along - point).squaredNorm();
        if (!(distance < nearest)) continue;
        nearest = distance;
        chainage = chainage_m_[i] + share * (chainage_m_[i + 1] - chainage_m_[i]);
    }
    return chainage;
}

std::optional<std::pair<double, double>> LineCorridor::stretch_of(const OGRGeometry& geometry) const {
    std::unique_ptr<OGRGeometry> part;
    if (geometry.getDimension() == 1) part.reset(geometry.Intersection(&axis_));
    if (!part || part->IsEmpty() != 0) part.reset(geometry.Intersection(area_.get()));
    if (!part) throw std::invalid_argument("a geometry that cannot be cut");
    if (part->IsEmpty() != 0) return std::nullopt;
    const bool bends = points_.size() > 4;
    if (bends) part->segmentize(finest_);
    std::pair<double, double> stretch{std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity()};
    for (const Vec2& point : vertices_of(*part)) {
        const double chainage = chainage_of(point);
        stretch = {std::min(stretch.first, chainage), std::max(stretch.second, chainage)};
    }
    return stretch;
}

}  // namespace runout
