#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "store/store.h"

namespace runout {

// Pieces of a page. Whatever came from a user or a file goes through html_text, and so shows as it was typed.

/// Text as the content of an element or an attribute value.
std::string html_text(const std::string& text);

/// A number as people read it: four significant digits.
std::string html_number(double value);

/// One cell: what is shown, and, of a number, the number itself to the last bit (attribute data-value).
struct HtmlCell {
    std::string html;  ///< already escaped
    std::string value;
    bool is_number = false;
};
HtmlCell text_cell(const std::string& text);
/// Empty for what does not exist; `digits` significant ones are shown.
HtmlCell number_cell(double value, int digits = 4);
HtmlCell value_cell(const StoredValue& value);

using HtmlRow = std::vector<HtmlCell>;

/// A table with a caption for those who do not see it. `head` may be empty.
std::string html_table(const std::string& caption, const std::vector<std::string>& head,
                       const std::vector<HtmlRow>& rows);

std::string paragraph(const std::string& text);
std::string bullet_list(const std::vector<std::string>& sentences);

/// "run_out_m" -> {"run-out", "m"}: words and unit of a column's name.
struct ColumnWords {
    std::string words;
    std::string unit;  ///< empty for pure numbers and words
};
ColumnWords column_words(const std::string& column);

}  // namespace runout
