// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_elements.h"

#include "core/report/alert_words.h"
#include "core/report/html_text.h"

namespace drillwave {

std::string asSentence(std::string reason) {
    const bool beginsWithWord = reason.size() > 1 && ((reason[1] >= 'a' && reason[1] <= 'z') ||
                                                      static_cast<unsigned char>(reason[1]) >= 0x80);
    if (beginsWithWord && reason[0] >= 'a' && reason[0] <= 'z')
        reason[0] = static_cast<char>(reason[0] - 'a' + 'A');
    if (!reason.empty() && !reason.ends_with('.')) reason += '.';
    return reason;
}

std::string ReportElements::paragraph(const Message& text) const {
    return htmlElement("p", said(text)) + "\n";
}

std::string ReportElements::heading(const Message& text) const {
    return htmlElement("h2", said(text)) + "\n";
}

std::string ReportElements::table(const std::string& id, const std::string& rows) const {
    constexpr std::size_t mostColumns = 6;  // wider tables are set in a smaller type on paper
    std::size_t columns = 0;
    const std::size_t end = rows.find("</tr>");
    for (std::size_t at = rows.find("<th"); at < end; at = rows.find("<th", at + 1)) ++columns;
    const std::string kind = columns > mostColumns ? "ruled dense" : "ruled";
    return (isScreen() ? "<table id=\"" + id + "-table\">\n"
                       : "<table class=\"" + kind + "\" cellspacing=\"0\" border=\"0\">\n") +
           rows + "</table>\n";
}

std::string ReportElements::alert(const Alert& alert) const {
    const bool isWarning = alert.level == AlertLevel::warning;
    return std::string("<p class=\"") + (isWarning ? "warning" : "note") + "\"><b>" +
           escapedHtml(said(isWarning ? translatable("Warning:") : translatable("Note:"))) + "</b> " +
           escapedHtml(alertText(alert, m_style)) + "</p>\n";
}

}  // namespace drillwave
