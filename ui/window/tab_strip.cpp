// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/tab_strip.h"

#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QStyleOptionTab>
#include <QToolButton>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int captionMargin = 10;  // pixels on either side of a caption
constexpr double smallLetters = 0.9;
constexpr int leastLetters = 4;  // letters that a shortened name keeps

QFont captionFont(const QTabBar& bar) {
    QFont font = bar.font();
    font.setPointSizeF(font.pointSizeF() * 0.8);
    font.setBold(true);
    return font;
}

}  // namespace

TabStrip::TabStrip(QWidget* parent) : QTabBar(parent) {
    setDrawBase(false);
    setExpanding(false);
    setElideMode(Qt::ElideNone);  // an initial names no page; where all have no room they are scrolled
    setUsesScrollButtons(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Pages"));
}

void TabStrip::insertCaption(int index, const QString& text) {
    insertTab(index, text);
    setTabEnabled(index, false);
}

void TabStrip::insertPage(int index, QWidget* page, const QString& title) {
    const int at = insertTab(index, title);
    setTabData(at, QVariant::fromValue(page));
    rename(at, title);
}

void TabStrip::rename(int index, const QString& title) {
    setTabText(index, title);
    if (isTabEnabled(index)) setTabToolTip(index, title);  // it may be cut short
}

void TabStrip::setOffered(int index, bool offered, const QString& why) {
    setTabEnabled(index, offered);
    setTabVisible(index, offered || !why.isEmpty());
    setTabToolTip(index, offered ? tabText(index) : QStringLiteral("%1: %2").arg(tabText(index), why));
}

QWidget* TabStrip::pageAt(int index) const {
    return tabData(index).value<QWidget*>();
}

int TabStrip::indexOf(const QWidget* page) const {
    for (int index = 0; index < count(); ++index)
        if (pageAt(index) == page) return index;
    return -1;
}

void TabStrip::choose(int step) {
    int index = currentIndex();
    do index = (index + step + count()) % count();
    while (!isTabEnabled(index) && index != currentIndex());  // nor are captions
    setCurrentIndex(index);
}

int TabStrip::captionWidth(int index) const {
    return QFontMetrics(captionFont(*this)).horizontalAdvance(tabText(index)) + 2 * captionMargin;
}

// The names of the pages go first.
bool TabStrip::hasRoomForCaptions() const {
    int wanted = 0;
    for (int index = 0; index < count(); ++index)
        if (isTabVisible(index))
            wanted += isCaption(index) ? captionWidth(index) : QTabBar::tabSizeHint(index).width();
    return wanted <= width();
}

QSize TabStrip::tabSizeHint(int index) const {
    const QSize tab = QTabBar::tabSizeHint(index);
    if (!isCaption(index)) return tab;
    return {hasRoomForCaptions() ? captionWidth(index) : captionMargin, tab.height()};
}

QSize TabStrip::minimumTabSizeHint(int index) const {
    return isCaption(index) ? tabSizeHint(index) : QTabBar::minimumTabSizeHint(index);
}

// The row without the buttons that scroll it.
QRect TabStrip::shownRect() const {
    QRect shown = rect();
    for (const QToolButton* button : findChildren<QToolButton*>(Qt::FindDirectChildrenOnly))
        if (button->isVisible()) shown.setRight(std::min(shown.right(), button->x() - 1));
    return shown;
}

// The style draws no tab where a caption is. A tab that is partly out of view has the words that are in view.
void TabStrip::initStyleOption(QStyleOptionTab* option, int index) const {
    QTabBar::initStyleOption(option, index);
    if (isCaption(index)) {
        option->rect = {};
        option->text.clear();
    } else if (const QRect shown = shownRect(); !shown.contains(option->rect)) {
        const int edges = option->rect.width() - fontMetrics().horizontalAdvance(tabText(index));
        option->rect &= shown;
        option->text = fontMetrics().elidedText(tabText(index), Qt::ElideRight,
                                                std::max(0, option->rect.width() - edges));
        if (option->text.size() < leastLetters) option->text.clear();
    }
}

void TabStrip::resizeEvent(QResizeEvent* event) {
    fitLetters();
    QTabBar::resizeEvent(event);
}

void TabStrip::tabLayoutChange() {
    QTabBar::tabLayoutChange();
    fitLetters();
}

// Smaller only where that brings all tabs into view.
void TabStrip::fitLetters() {
    const QFont usual = parentWidget() ? parentWidget()->font() : font();
    if (usual.pointSizeF() <= 0) return;  // given in pixels
    QFont small = usual;
    small.setPointSizeF(smallLetters * usual.pointSizeF());
    const auto isWide = [this](const QFont& letters) {
        const auto nameIn = [](const QFontMetrics& metrics, const QString& name) {
            return metrics.size(Qt::TextShowMnemonic, name).width();
        };
        int wanted = 0;
        for (int index = 0; index < count(); ++index)
            if (isTabVisible(index))
                wanted += isCaption(index) ? captionMargin
                                           : QTabBar::tabSizeHint(index).width() +
                                                 nameIn(QFontMetrics(letters), tabText(index)) -
                                                 nameIn(fontMetrics(), tabText(index));
        return wanted > width();
    };
    const QFont& fitting = isWide(usual) && !isWide(small) ? small : usual;
    if (m_isFitting || font().pointSizeF() == fitting.pointSizeF()) return;
    const QScopedValueRollback fits(m_isFitting, true);  // another font is another layout
    setFont(fitting);
}

void TabStrip::mousePressEvent(QMouseEvent* event) {
    QTabBar::mousePressEvent(event);
    const int index = tabAt(event->position().toPoint());
    if (event->button() == Qt::LeftButton && index >= 0 && !isCaption(index) && !isTabEnabled(index))
        emit refused(pageAt(index));
}

void TabStrip::paintEvent(QPaintEvent* event) {
    QTabBar::paintEvent(event);
    QPainter painter(this);
    painter.setFont(captionFont(*this));
    const bool named = hasRoomForCaptions();
    for (int index = 0; index < count(); ++index) {
        if (!isCaption(index)) continue;
        const QRect place = tabRect(index);
        painter.setPen(palette().color(QPalette::Active, QPalette::WindowText));
        if (named) painter.drawText(place, Qt::AlignCenter, tabText(index));
        painter.setPen(palette().color(QPalette::Mid));
        if (index > 0)
            painter.drawLine(place.left() + 2, place.top() + 4, place.left() + 2, place.bottom() - 4);
    }
}

}  // namespace drillwave
