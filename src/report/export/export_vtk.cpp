#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/input_error.h"
#include "report/export/export_files.h"

namespace runout {
namespace {

struct Field {
    const char* name;
    std::vector<float> values;
    int components = 1;
};

/// Particles at one instant, in numbers that VTK reads.
struct Cloud {
    double time_s = 0;
    std::vector<float> points;  ///< x, y, 0 of each
    std::vector<Field> fields;
};

template <class Values>
std::string words(const Values& values) {
    std::string text;
    auto end = std::back_inserter(text);
    for (const auto value : values) fmt::format_to(end, "{} ", value);
    return text;
}

std::string data_array(const char* type, const char* name, int components, const std::string& values) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}\n</DataArray>\n",
        type, name, components, values);
}

/// Each particle is a vertex of its own: without cells ParaView shows nothing.
std::string vertices(std::size_t count) {
    std::string connectivity, offsets;
    auto end = std::back_inserter(connectivity);
    auto offset_end = std::back_inserter(offsets);
    for (std::size_t i = 0; i < count; ++i) {
        fmt::format_to(end, "{} ", i);
        fmt::format_to(offset_end, "{} ", i + 1);
    }
    return "<Verts>\n" + data_array("Int32", "connectivity", 1, connectivity) +
           data_array("Int32", "offsets", 1, offsets) + "</Verts>\n";
}

std::string poly_data(const Cloud& cloud) {
    const std::size_t count = cloud.points.size() / 3;
    std::string fields;
    for (const Field& field : cloud.fields)
        fields += data_array("Float32", field.name, field.components, words(field.values));
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<PolyData>\n<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
        "NumberOfStrips=\"0\" "
        "NumberOfPolys=\"0\">\n<PointData "
        "Scalars=\"{1}\">\n{2}</PointData>\n<Points>\n{3}</Points>\n{4}</Piece>\n"
        "</PolyData>\n</VTKFile>\n",
        count, cloud.fields.front().name, fields, data_array("Float32", "position_m", 3, words(cloud.points)),
        vertices(count));
}

Cloud cloud_of(const Snapshot& snapshot) {
    Cloud cloud{snapshot.time_s, {}, {}};
    Field speed{"speed_m_s", {}}, pressure{"pressure_pa", snapshot.pressure_pa},
        velocity{"velocity_m_s", {}, 3};
    for (std::size_t i = 0; i < snapshot.x_m.size(); ++i) {
        cloud.points.insert(cloud.points.end(), {snapshot.x_m[i], snapshot.y_m[i], 0.0F});
        velocity.values.insert(velocity.values.end(), {snapshot.vx_m_s[i], snapshot.vy_m_s[i], 0.0F});
        speed.values.push_back(std::hypot(snapshot.vx_m_s[i], snapshot.vy_m_s[i]));
    }
    cloud.fields = {std::move(speed), std::move(pressure), std::move(velocity)};
    return cloud;
}

Cloud cloud_of(const Frame& frame) {
    const FrameScale& scale = frame.scale;
    const auto decoded = [](double low, double step, unsigned code) {
        return static_cast<float>(low + step * code);
    };
    Cloud cloud{scale.time_s, {}, {}};
    Field speed{"speed_m_s", {}}, pressure{"pressure_pa", {}};
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        cloud.points.insert(cloud.points.end(), {decoded(scale.x_low_m, scale.x_step_m, frame.x[i]),
                                                 decoded(scale.y_low_m, scale.y_step_m, frame.y[i]), 0.0F});
        speed.values.push_back(decoded(scale.speed_low_m_s, scale.speed_step_m_s, frame.speed[i]));
        pressure.values.push_back(decoded(scale.pressure_low_pa, scale.pressure_step_pa, frame.pressure[i]));
    }
    cloud.fields = {std::move(speed), std::move(pressure)};
    return cloud;
}

template <class Instants>
ExportFiles files_of(const Instants& instants) {
    ExportFiles files;
    std::string list;
    for (const auto& instant : instants) {
        const Cloud cloud = cloud_of(instant);
        const std::string name = fmt::format("particles_{:04}.vtp", files.size());
        list += fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", cloud.time_s, name);
        files.emplace_back(name, poly_data(cloud));
    }
    files.emplace_back(
        "particles.pvd",
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n" + list +
            "</Collection>\n</VTKFile>\n");
    return files;
}

}  // namespace

ExportFiles vtk_files(const RunData& run, const std::vector<Snapshot>& snapshots) {
    if (!snapshots.empty()) return files_of(snapshots);
    if (!run.frames.empty()) return files_of(run.frames);
    throw InputError({.file = {}, .line = 0, .key = "run", .value = std::to_string(run.run.run_id)},
                     "has no particles stored",
                     "run it again with --frames 60, or with run.snapshot_times_s for every particle");
}

}  // namespace runout
