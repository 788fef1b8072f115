// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of a report page: paragraphs, headings, tables and alerts, for screen and paper.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/alerts.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Intended use of a report page, which determines its HTML.
enum class ReportMedium {
    screen,  ///< separate file in valid HTML 5, including the data from which the report can be made again
    paper,   ///< subset of HTML that QTextDocument supports; long scenarios are truncated
};

/// Returns a phrase that states a reason, changed to a sentence with a capital letter and a full stop. Names
/// such as e at its start are not capitalised.
std::string asSentence(std::string reason);

/// Writer of the HTML elements of a report page, in the language and units of the reader.
class ReportElements {
  public:
    /// Stores a reference to the style, which must outlive this object.
    ReportElements(ReportMedium medium, const ReadingStyle& style) : m_medium(medium), m_style(style) {}

    bool isScreen() const { return m_medium == ReportMedium::screen; }
    const ReadingStyle& style() const { return m_style; }
    std::string said(const Message& message) const { return m_style.said(message); }

    std::string paragraph(const Message& text) const;
    std::string heading(const Message& text) const;
    /// Returns an HTML table with the identifier `id` and a line below each row. `rows` is the HTML of the
    /// rows. On paper, the spacing is narrower.
    std::string table(const std::string& id, const std::string& rows) const;
    std::string alert(const Alert& alert) const;

  private:
    ReportMedium m_medium;
    const ReadingStyle& m_style;
};

}  // namespace drillwave
