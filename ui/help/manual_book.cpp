// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/manual_book.h"

#include <QRegularExpression>
#include <algorithm>

#include "core/manual/markdown.h"
#include "core/text/languages.h"

namespace drillwave {
namespace {

BookChapter bookChapter(const Chapter& chapter) {
    BookChapter made;
    made.name = QString::fromStdString(chapter.name);
    made.title = QString::fromStdString(chapter.title);
    made.markdown = QString::fromStdString(chapter.text);
    static const QRegularExpression equation(QStringLiteral(" (\\([TSD][0-9]+\\))$"),
                                             QRegularExpression::MultilineOption);
    made.blocks = readMarkdown(chapter.text);
    for (const ManualBlock& block : made.blocks) {
        const QString text = QString::fromStdString(
            block.kind == ManualBlock::Kind::code ? block.text : withoutMarks(block.text));
        if (block.kind == ManualBlock::Kind::heading)
            made.headings.append({QString(text).remove(u'`'), block.level});
        if (block.kind != ManualBlock::Kind::code) continue;
        for (auto found = equation.globalMatch(text); found.hasNext();)
            made.equations.append(found.next().captured(1));
    }
    return made;
}

}  // namespace

ManualBook::ManualBook(const Language& language) {
    for (const Chapter& chapter : manualChapters(styleOf(language))) m_chapters.append(bookChapter(chapter));
}

const BookChapter* ManualBook::find(const QString& name) const {
    const auto found = std::ranges::find(m_chapters, name, &BookChapter::name);
    return found == m_chapters.end() ? nullptr : &*found;
}

bool ManualBook::has(const ManualPlace& place) const {
    const BookChapter* chapter = find(place.chapter);
    if (!chapter || place.heading.isEmpty()) return chapter;
    return chapter->equations.contains(place.heading) ||
           std::ranges::any_of(chapter->headings, [&place](const BookChapter::Heading& heading) {
               return isHeading(heading.text, place.heading);
           });
}

void ManualBook::append(const QString& name, const QString& markdown) {
    const auto found = std::ranges::find(m_chapters, name, &BookChapter::name);
    if (found == m_chapters.end()) return;
    *found = bookChapter(chapterOf(name.toStdString(), (found->markdown + u'\n' + markdown).toStdString()));
}

}  // namespace drillwave
