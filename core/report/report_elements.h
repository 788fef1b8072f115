// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of the page of a report: paragraphs, headings, tables and alerts, for screen and paper.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/alerts.h"
#include "core/text/handy_text.h"
#include "core/text/message.h"

namespace drillwave {

/// Use of a page.
enum class ReportMedium {
    screen,  ///< a file of its own, valid HTML 5, with the record from which it can be run again
    paper,   ///< the little HTML that QTextDocument knows; long scenarios are cut short
};

/// Returns a reason with a capital and a full stop; names such as e stay as they are.
std::string asSentence(std::string reason);

/// Writes elements in the language and units of a reader.
class ReportElements {
  public:
    /// Must not outlive the style.
    ReportElements(ReportMedium medium, const ReadingStyle& style) : m_medium(medium), m_style(style) {}

    bool isScreen() const { return m_medium == ReportMedium::screen; }
    const ReadingStyle& style() const { return m_style; }
    std::string said(const Message& message) const { return m_style.said(message); }

    std::string paragraph(const Message& text) const;
    std::string heading(const Message& text) const;
    /// Returns a table with a rule below each line, for which paper has less room.
    std::string table(const std::string& id, const std::string& rows) const;
    std::string alert(const Alert& alert) const;

  private:
    ReportMedium m_medium;
    const ReadingStyle& m_style;
};

}  // namespace drillwave
