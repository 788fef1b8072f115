// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/file_lines.h"

#include <QFontDatabase>
#include <QScrollBar>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int linesOnShow = 6;
constexpr std::size_t shownBytes = 1000;  // of a line: more is not read by anybody

}  // namespace

FileLines::FileLines(QWidget* parent) : QPlainTextEdit(parent) {
    setObjectName(QStringLiteral("lines"));
    setAccessibleName(tr("First lines of the file"));
    setToolTip(tr("First lines of the file; samples begin at the marked one"));
    setReadOnly(true);
    setTabChangesFocus(true);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setFixedHeight(linesOnShow * fontMetrics().lineSpacing() + horizontalScrollBar()->sizeHint().height() +
                   12);
}

void FileLines::present(const std::vector<std::string>& lines, std::size_t firstSample) {
    QStringList shown;
    const int digits = lines.size() < 1000 ? 3 : 4;
    for (std::size_t i = 0; i < lines.size(); ++i)
        shown.append(QStringLiteral("%1%2  %3")
                         .arg(i + 1 == firstSample ? QLatin1Char('>') : QLatin1Char(' '))
                         .arg(i + 1, digits)
                         .arg(QString::fromStdString(lines[i].substr(0, shownBytes))));
    setPlainText(shown.join(QLatin1Char('\n')));
    constexpr int above = 3;
    verticalScrollBar()->setValue(std::max(0, static_cast<int>(firstSample) - above));
}

}  // namespace drillwave
