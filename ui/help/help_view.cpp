// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_view.h"

#include <QAbstractTextDocumentLayout>
#include <QScrollBar>
#include <QTextBlock>
#include <QWheelEvent>
#include <algorithm>
#include <memory>

#include "ui/help/manual_document.h"

namespace drillwave {
namespace {

constexpr int leastZoom = 60, mostZoom = 300;  // [%]
constexpr int wheelStep = 10;                  // [%]
constexpr qreal margin = 12;                   // [px]
const QString pictureFolder =
    QStringLiteral("../screenshots/");  // translated chapters stand in a folder more

}  // namespace

HelpView::HelpView(const ManualBook& book, QWidget* parent)
    : QTextBrowser(parent), m_book(book), m_usualSize(font().pointSizeF()) {
    setObjectName(QStringLiteral("manual"));
    setAccessibleName(tr("Manual"));
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    m_laterLayout.setSingleShot(true);
    connect(&m_laterLayout, &QTimer::timeout, this, &HelpView::layOut);
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        if (const ManualPlace place = placeOf(link); !place.chapter.isEmpty()) go(place);
    });
}

void HelpView::go(const ManualPlace& place) {
    leave();
    if (place == this->place()) return arrive();
    if (!this->place().chapter.isEmpty()) {
        m_history.resize(++m_at);
        m_history.append(Visit());
    }
    m_history[m_at].place = place;
    arrive();
}

void HelpView::backward() {
    if (hasBackward()) step(-1);
}

void HelpView::forward() {
    if (hasForward()) step(1);
}

void HelpView::step(int by) {
    leave();
    m_at += by;
    showChapter();
    verticalScrollBar()->setValue(m_history[m_at].scroll);
    emit placeChanged(place());
}

void HelpView::leave() {
    m_history[m_at].scroll = verticalScrollBar()->value();
}

void HelpView::arrive() {
    showChapter();
    bringUp(blockOf(*document(), place().heading));
    emit placeChanged(place());
}

void HelpView::showChapter() {
    if (m_shown == place().chapter) return;
    const BookChapter* chapter = m_book.find(place().chapter);
    if (!chapter) return;
    m_shown = chapter->name;
    // Each change of a visible document is laid out at once, which takes seconds for a page with tables.
    auto* made = new QTextDocument(this);
    made->setDocumentMargin(margin);
    made->setDefaultFont(font());
    QTextOption option = made->defaultTextOption();
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);  // nothing is wider than the view
    made->setDefaultTextOption(option);
    setChapter(*made, *chapter, m_book, viewport()->width() - 2 * margin, palette());
    // The first one belongs to the base class, which deletes it.
    const std::unique_ptr<QTextDocument> before(document()->parent() == this ? document() : nullptr);
    setDocument(made);
    setAccessibleDescription(chapter->title);
    markWords();
}

void HelpView::bringUp(const QTextBlock& block) {
    const QRectF room = document()->documentLayout()->blockBoundingRect(block);
    setTextCursor(QTextCursor(block));
    verticalScrollBar()->setValue(block == document()->begin() ? 0 : int(room.top() - margin / 2));
}

void HelpView::layOut() {
    const double share = double(verticalScrollBar()->value()) / std::max(1, verticalScrollBar()->maximum());
    m_shown.clear();
    showChapter();
    verticalScrollBar()->setValue(int(share * verticalScrollBar()->maximum()));
}

void HelpView::mark(const QStringList& words) {
    m_words = words;
    markWords();
    if (words.isEmpty()) return;
    const QTextCursor from(blockOf(*document(), place().heading));
    const QTextCursor found = document()->find(words.first(), from);
    if (found.isNull()) return;
    const QTextBlock head = from.block();
    bringUp(head);
    // The heading stays in view where it can.
    const qreal low = document()->documentLayout()->blockBoundingRect(found.block()).bottom();
    if (low > verticalScrollBar()->value() + viewport()->height()) bringUp(found.block());
}

void HelpView::markWords() {
    const ManualColours colours = manualColours(palette());
    QList<QTextEdit::ExtraSelection> marks;
    for (const QString& word : std::as_const(m_words))
        for (QTextCursor found = document()->find(word); !found.isNull();
             found = document()->find(word, found)) {
            QTextEdit::ExtraSelection mark;
            mark.cursor = found;
            mark.format.setBackground(colours.mark);
            mark.format.setForeground(colours.markedText);
            marks.append(mark);
        }
    setExtraSelections(marks);
}

void HelpView::setZoom(int percent) {
    m_zoom = std::clamp(percent, leastZoom, mostZoom);
    QFont type = font();
    type.setPointSizeF(m_usualSize * m_zoom / 100);
    const double share = double(verticalScrollBar()->value()) / std::max(1, verticalScrollBar()->maximum());
    setFont(type);
    verticalScrollBar()->setValue(int(share * verticalScrollBar()->maximum()));
    emit zoomChanged(m_zoom);
}

// Pictures are as wide as the text at most.
QVariant HelpView::loadResource(int type, const QUrl& name) {
    const QString path = name.toString();
    if (type != QTextDocument::ImageResource || !path.contains(pictureFolder)) return {};
    QImage picture(QStringLiteral(":/manual/screenshots/") + path.section(pictureFolder, -1));
    const qreal pixels = devicePixelRatioF();
    const int width = int((viewport()->width() - 2 * margin) * pixels);
    if (picture.width() > width && width > 0)
        picture = picture.scaledToWidth(width, Qt::SmoothTransformation);
    picture.setDevicePixelRatio(pixels);
    return picture;
}

void HelpView::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && !m_shown.isEmpty()) m_laterLayout.start(0);
}

void HelpView::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    // Pictures and tables are as wide as there is room.
    const BookChapter* chapter = m_book.find(m_shown);
    const bool hasWide = chapter && (chapter->markdown.contains(pictureFolder) ||
                                     chapter->markdown.contains(QStringLiteral("\n|")));
    if (hasWide && event->oldSize().width() != event->size().width()) m_laterLayout.start(0);
}

void HelpView::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QTextBrowser::wheelEvent(event);
    if (event->angleDelta().y() != 0)
        setZoom(m_zoom + (event->angleDelta().y() > 0 ? wheelStep : -wheelStep));
    event->accept();
}

}  // namespace drillwave
