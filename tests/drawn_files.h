#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry.h"

// The text of drawings and LandXML files, as programs write them.

namespace runout {

/// A DXF in ASCII: release 12, or 2000 with the marks of its classes.
class DxfText {
  public:
    enum class Release { r12, r2000 };

    explicit DxfText(Release release = Release::r2000) : release_(release) {}

    /// $INSUNITS, or $MEASUREMENT.
    DxfText& variable(const std::string& name, int value) {
        header_ += fmt::format("  9\n{}\n 70\n{}\n", name, value);
        return *this;
    }
    DxfText& line(const std::string& layer, const Vec2& a, const Vec2& b) {
        begin("LINE", layer, "AcDbLine");
        text_ += point(10, a) + point(11, b);
        return *this;
    }
    /// LWPOLYLINE, or POLYLINE in release 12.
    DxfText& polyline(const std::string& layer, const Polyline& points, bool closed = false,
                      const std::vector<double>& bulges = {}) {
        return release_ == Release::r12 ? old_polyline(layer, points, closed)
                                        : light_polyline(layer, points, closed, bulges);
    }
    DxfText& arc(const std::string& layer, const Vec2& centre, double radius, double from_deg,
                 double to_deg) {
        begin("ARC", layer, "AcDbCircle");
        text_ += point(10, centre) + pair(40, radius);
        if (release_ == Release::r2000) text_ += "100\nAcDbArc\n";
        text_ += pair(50, from_deg) + pair(51, to_deg);
        return *this;
    }
    /// Clamped, with uniform knots.
    DxfText& spline(const std::string& layer, int degree, const Polyline& control) {
        begin("SPLINE", layer, "AcDbSpline");
        const int n = static_cast<int>(control.size());
        text_ += fmt::format(" 70\n8\n 71\n{}\n 72\n{}\n 73\n{}\n", degree, n + degree + 1, n);
        for (int i = 0; i < n + degree + 1; ++i)
            text_ += pair(40, i <= degree ? 0 : i >= n ? n - degree : i - degree);
        for (const Vec2& p : control) text_ += point(10, p);
        return *this;
    }
    /// As AutoCAD has it while it is being edited: no control points yet.
    DxfText& spline_of_fit_points(const std::string& layer, const Polyline& points) {
        begin("SPLINE", layer, "AcDbSpline");
        text_ += fmt::format(" 70\n8\n 71\n3\n 72\n0\n 73\n0\n 74\n{}\n", points.size());
        for (const Vec2& p : points) text_ += point(11, p);
        return *this;
    }
    DxfText& text(const std::string& layer, const Vec2& at, const std::string& words) {
        begin("TEXT", layer, "AcDbText");
        text_ += point(10, at) + pair(40, 2.5) + "  1\n" + words + "\n";
        return *this;
    }
    /// Any entity by its pairs of code and value.
    DxfText& entity(const std::string& type, const std::string& layer, const std::string& pairs) {
        begin(type, layer, "AcDbEntity");
        text_ += pairs;
        return *this;
    }

    [[nodiscard]] std::string whole() const { return unfinished() + "  0\nENDSEC\n  0\nEOF\n"; }
    /// Cut off within its entities.
    [[nodiscard]] std::string unfinished() const {
        const std::string version = release_ == Release::r12 ? "AC1009" : "AC1015";
        return "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\n" + version + "\n" + header_ +
               "  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n" + text_;
    }

  private:
    static std::string pair(int code, double value) { return fmt::format("{:3}\n{:.17g}\n", code, value); }
    static std::string point(int code, const Vec2& p) { return pair(code, p.x()) + pair(code + 10, p.y()); }

    void begin(const std::string& type, const std::string& layer, const std::string& kind) {
        text_ += fmt::format("  0\n{}\n", type);
        if (release_ == Release::r2000) text_ += fmt::format("  5\n{:X}\n100\nAcDbEntity\n", ++handle_);
        text_ += fmt::format("  8\n{}\n", layer);
        if (release_ == Release::r2000) text_ += fmt::format("100\n{}\n", kind);
    }
    DxfText& light_polyline(const std::string& layer, const Polyline& points, bool closed,
                            const std::vector<double>& bulges) {
        begin("LWPOLYLINE", layer, "AcDbPolyline");
        text_ += fmt::format(" 90\n{}\n 70\n{}\n", points.size(), closed ? 1 : 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            text_ += point(10, points[i]);
            if (i < bulges.size() && bulges[i] != 0) text_ += pair(42, bulges[i]);
        }
        return *this;
    }
    DxfText& old_polyline(const std::string& layer, const Polyline& points, bool closed) {
        begin("POLYLINE", layer, "");
        text_ += fmt::format(" 66\n1\n 10\n0\n 20\n0\n 30\n0\n 70\n{}\n", closed ? 1 : 0);
        for (const Vec2& p : points) {
            begin("VERTEX", layer, "");
            text_ += point(10, p) + pair(30, 0);
        }
        begin("SEQEND", layer, "");
        return *this;
    }

    Release release_;
    std::string header_;
    std::string text_;
    int handle_ = 255;
};

/// "0 32 30 32", as PntList2D has it.
inline std::string pairs_text(const Polyline& points) {
    std::string text;
    for (const Vec2& p : points) text += fmt::format("{:.17g} {:.17g} ", p.x(), p.y());
    return text;
}

inline std::string csv_text(const Polyline& points) {
    std::string text = "chainage_m,elevation_m\n";
    for (const Vec2& p : points) text += fmt::format("{:.17g},{:.17g}\n", p.x(), p.y());
    return text;
}

/// A whole LandXML file around what one alignment holds.
inline std::string landxml_text(const std::string& units, const std::string& alignment) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<LandXML xmlns=\"http://www.landxml.org/schema/LandXML-1.2\" version=\"1.2\">\n" +
           units + "\n<Alignments>\n<Alignment name=\"A\" length=\"100\" staStart=\"0\">\n" + alignment +
           "\n</Alignment>\n</Alignments>\n</LandXML>\n";
}

inline const char* const metric_units =
    "<Units><Metric areaUnit=\"squareMeter\" linearUnit=\"meter\"/></Units>";

inline std::string cross_section(const std::string& station, const std::string& surfaces) {
    return fmt::format("<CrossSects><CrossSect sta=\"{}\">{}</CrossSect></CrossSects>", station, surfaces);
}

inline std::string surface_text(const std::string& name, const std::vector<Polyline>& parts) {
    std::string text = fmt::format("<CrossSectSurf name=\"{}\">", name);
    for (const Polyline& part : parts) text += "\n<PntList2D>" + pairs_text(part) + "</PntList2D>";
    return text + "</CrossSectSurf>";
}

}  // namespace runout
