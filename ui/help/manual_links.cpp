// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_links.h"

#include <QRegularExpression>

#include "core/blow/outputs.h"
#include "ui/help/help_topic.h"

namespace drillwave {
namespace {

// What stands between two citations of one chapter.
bool goesOn(const QString& between) {
    static const QRegularExpression comma(QStringLiteral("^(, | %1 )$").arg(QStringView(andWords)));
    return comma.match(between).hasMatch();
}

// "theory §3", and "§3" alone, which is of this chapter or, behind "theory §1 and", of that one.
void addSections(const QString& line, const QString& chapter, const ManualBook& book,
                 QList<ManualLink>& links) {
    static const QRegularExpression citation(
        QStringLiteral("(?:\\b([a-z]+)[ \\x{a0}])?(§[0-9]+(?:\\.[0-9]+)*)"));
    QString last = chapter;
    qsizetype end = -1;
    for (auto found = citation.globalMatch(line); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const bool isNamed = book.find(match.captured(1));
        const qsizetype begin = match.capturedStart(isNamed ? 0 : 2);
        const QString between = end < 0 ? QString() : line.mid(end, begin - end);
        if (isNamed)
            last = match.captured(1);
        else if (!goesOn(between))
            last = chapter;
        end = match.capturedEnd();
        const ManualPlace to{last, match.captured(2)};
        if (book.has(to)) links.append({begin, end - begin, to});
    }
}

void addEquations(const QString& line, const ManualBook& book, QList<ManualLink>& links) {
    static const QRegularExpression equation(QStringLiteral("\\([TSD][0-9]+\\)"));
    for (auto found = equation.globalMatch(line); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        for (const BookChapter& chapter : book.chapters())
            if (chapter.equations.contains(match.captured()))
                links.append(
                    {match.capturedStart(), match.capturedLength(), {chapter.name, match.captured()}});
    }
}

}  // namespace

QList<ManualLink> linksIn(const QString& line, const QString& chapter, const ManualBook& book) {
    QList<ManualLink> links;
    addSections(line, chapter, book, links);
    addEquations(line, book, links);
    std::ranges::sort(links, {}, &ManualLink::begin);
    return links;
}

ManualPlace placeOfCode(const QString& code, const ManualBook& book) {
    static const QRegularExpression page(QStringLiteral("^([a-z]+)\\.md$")),
        command(QStringLiteral("^drillwave ([a-z]+)"));
    if (const auto match = page.match(code); match.hasMatch() && book.find(match.captured(1)))
        return {match.captured(1)};
    if (const auto match = command.match(code); match.hasMatch()) {
        const ManualPlace to{QStringLiteral("commands"), match.captured(1)};
        return book.has(to) ? to : ManualPlace();
    }
    if (findOutput(code.toStdString())) return {QStringLiteral("outputs"), code};
    const ManualPlace parameter = placeOfKey(code);
    return book.has(parameter) ? parameter : ManualPlace();
}

}  // namespace drillwave
