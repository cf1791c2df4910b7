#include "profile/landxml_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <pugixml.hpp>
#include <string_view>

#include "core/input_error.h"
#include "core/text_file.h"

namespace runout {
namespace {

/// "CrossSect" of "lx:CrossSect".
std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<pugi::xml_node> children(const pugi::xml_node& parent, std::string_view name) {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node& child : parent.children())
        if (local_name(child) == name) found.push_back(child);
    return found;
}

/// Counts lines of a text in one byte a letter; 0 for other encodings.
class LineCount {
  public:
    explicit LineCount(const std::string& text)
        : text_(text), bytes_(std::string_view(text).substr(0, 4).find('\0') == std::string_view::npos) {}

    [[nodiscard]] bool counts() const { return bytes_; }
    /// Offsets are asked for from front to back.
    int line_at(std::ptrdiff_t offset) {
        if (!bytes_ || offset < 0) return 0;
        const auto end = std::min(static_cast<std::size_t>(offset), text_.size());
        for (; at_ < end; ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
        return line_;
    }

  private:
    const std::string& text_;
    bool bytes_;
    std::size_t at_ = 0;
    int line_ = 1;
};

struct NamedUnit {
    std::string_view name;
    const char* word;
};

constexpr std::array<NamedUnit, 6> named_units = {{{"meter", "m"},
                                                   {"centimeter", "cm"},
                                                   {"millimeter", "mm"},
                                                   {"foot", "ft"},
                                                   {"USSurveyFoot", "us-ft"},
                                                   {"inch", "in"}}};

std::string unit_of(const pugi::xml_node& root, const std::string& path) {
    for (const pugi::xml_node& units : children(root, "Units"))
        for (const pugi::xml_node& system : units.children()) {
            const pugi::xml_attribute linear = system.attribute("linearUnit");
            if (!linear) continue;
            for (const NamedUnit& unit : named_units)
                if (unit.name == linear.value()) return unit.word;
            throw InputError({path, 0, "linearUnit", linear.value()}, "is a unit that no section is in",
                             "give section.unit: m, cm, mm, ft, us-ft or in");
        }
    return {};
}

/// Reads the surfaces of the sections, front to back.
class SectionReader {
  public:
    SectionReader(const std::string& path, const std::string& text) : path_(path), lines_(text) {}

    /// Of `parent`, the surfaces with this element name.
    void read_surfaces(const pugi::xml_node& parent, const char* element, const LandXmlSection& place) {
        for (const pugi::xml_node& surface : children(parent, element)) {
            LandXmlSection section = place;
            section.surface = surface.attribute("name").value();
            for (const pugi::xml_node& list : children(surface, "PntList2D")) read_points(list, section);
            if (!section.parts.empty()) sections_.push_back(std::move(section));
        }
    }

    std::vector<LandXmlSection> take() { return std::move(sections_); }

  private:
    void read_points(const pugi::xml_node& list, LandXmlSection& section) {
        const pugi::xml_node content = list.first_child();
        const std::string_view text = content.value();
        int line = lines_.line_at(content.offset_debug());
        std::vector<double> numbers;
        std::vector<int> lines;
        for (std::size_t at = 0; at < text.size();) {
            if (std::string_view(" \t\r\n").find(text[at]) != std::string_view::npos) {
                if (lines_.counts() && text[at] == '\n') ++line;
                ++at;
                continue;
            }
            const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
            if (numbers.size() % 2 == 0) lines.push_back(line);
            numbers.push_back(number(text.substr(at, end - at), line));
            at = end;
        }
        if (numbers.size() % 2 != 0)
            throw InputError({path_, line, "PntList2D", ""}, "has an odd count of numbers",
                             "it lists pairs: offset and elevation");
        Polyline part;
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) part.emplace_back(numbers[i], numbers[i + 1]);
        if (part.empty()) return;
        section.parts.push_back(std::move(part));
        section.lines.push_back(lines_.counts() ? std::move(lines) : std::vector<int>{});
    }

    [[nodiscard]] double number(std::string_view text, int line) const {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc{} && end == text.data() + text.size()) return value;
        throw InputError({path_, line, "PntList2D", std::string(text)}, "is not a number",
                         "it lists pairs with a decimal point: offset and elevation");
    }

    const std::string& path_;
    LineCount lines_;
    std::vector<LandXmlSection> sections_;
};

}  // namespace

LandXmlFile load_landxml(const std::string& path) {
    const std::string text = read_text_file(path, "give the path of a LandXML file");
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) {
        LineCount lines(text);
        throw InputError({path, lines.line_at(parsed.offset), "", ""},
                         fmt::format("is not well-formed XML ({})", parsed.description()),
                         "export it again as LandXML");
    }
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "LandXML")
        throw InputError({path, 0, "", ""}, fmt::format("is XML of another kind ({})", root.name()),
                         "give a LandXML file with cross-sections");
    SectionReader reader(path, text);
    for (const pugi::xml_node& alignments : children(root, "Alignments"))
        for (const pugi::xml_node& alignment : children(alignments, "Alignment")) {
            const std::string name = alignment.attribute("name").value();
            // In the order of the file: lines are counted from front to back.
            for (const pugi::xml_node& part : alignment.children()) {
                if (local_name(part) == "Profile")
                    reader.read_surfaces(part, "ProfSurf", {name, "profile", {}, {}, {}});
                if (local_name(part) == "CrossSects")
                    for (const pugi::xml_node& cross : children(part, "CrossSect"))
                        reader.read_surfaces(cross, "CrossSectSurf",
                                             {name, cross.attribute("sta").value(), {}, {}, {}});
            }
        }
    return {reader.take(), unit_of(root, path)};
}

}  // namespace runout
