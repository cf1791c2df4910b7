#pragma once

#include <string>
#include <vector>

#include "core/figure.h"

namespace runout {

/// A chart that the reader's browser draws: the figure, with what only a screen needs.
struct PageChart {
    std::string id;  ///< unique in the page
    Figure figure;
    bool logarithmic_y = false;
    std::string caption;
};

/// A part of a page. Empty body: it does not apply and is left out.
struct PageSection {
    std::string id;     ///< of the anchor
    std::string title;  ///< of the heading, plain text
    std::string body;   ///< HTML; place_of() a chart where it shall stand
    std::vector<PageChart> charts;
    std::string animation;  ///< JSON of animation_json(); empty: none
};

/// Where a chart of the section is to be drawn.
std::string place_of(const PageChart& chart);

/// The whole page, one file that needs nothing else: style, charting library, script and data are in it.
/// `title` and `subtitle` are plain text.
std::string html_page(const std::string& title, const std::string& subtitle,
                      const std::vector<PageSection>& sections);

}  // namespace runout
