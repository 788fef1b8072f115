// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/scrolled_label.h"

#include <QEvent>
#include <QLabel>
#include <QScrollBar>
#include <algorithm>

namespace drillwave {
namespace {

constexpr int leastLines = 2;

}  // namespace

ScrolledLabel::ScrolledLabel(QLabel* label, double shareOfWindow, QWidget* parent)
    : QScrollArea(parent), m_label(label), m_share(shareOfWindow) {
    setWidget(label);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);  // the label has it
    // The background shows through.
    viewport()->setAutoFillBackground(false);
    label->setAutoFillBackground(false);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void ScrolledLabel::setText(const QString& text) {
    if (text != m_label->text()) verticalScrollBar()->setValue(0);
    m_label->setText(text);
    updateGeometry();
}

QString ScrolledLabel::text() const {
    return m_label->text();
}

QSize ScrolledLabel::sizeHint() const {
    const int width = m_label->sizeHint().width();
    return {width, heightForWidth(width)};
}

QSize ScrolledLabel::minimumSizeHint() const {
    return {m_label->minimumSizeHint().width(), 0};
}

void ScrolledLabel::showEvent(QShowEvent* event) {
    QScrollArea::showEvent(event);
    window()->installEventFilter(this);
}

// The share of another window height is another height.
bool ScrolledLabel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == window() && event->type() == QEvent::Resize) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

int ScrolledLabel::heightForWidth(int width) const {
    const int least = leastLines * m_label->fontMetrics().lineSpacing() + 2 * m_label->margin();
    const int most = std::max(least, static_cast<int>(m_share * window()->height()));
    return std::min(std::max(m_label->heightForWidth(width), m_label->minimumHeight()), most);
}

}  // namespace drillwave
