// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/section_box.h"

#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/text/settings.h"

namespace drillwave {

namespace {

constexpr int mostHeight = 900;   // asked for; the rest is scrolled [px]
constexpr int leastHeight = 200;  // [px]

}  // namespace

SectionBox::SectionBox(const QString& title, QWidget* parent)
    : QWidget(parent), m_header(new QToolButton(this)), m_content(new QWidget(this)) {
    setTitle(title);
    m_header->setAutoRaise(true);
    m_header->setArrowType(Qt::DownArrow);
    m_header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont bold = m_header->font();
    bold.setBold(true);
    m_header->setFont(bold);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_header);
    layout->addWidget(m_content);
    connect(m_header, &QToolButton::clicked, this, [this] {
        setOpen(!isOpen());
        if (!m_key.isEmpty()) Settings().setValue(m_key, isOpen());
    });
}

void SectionBox::setTitle(const QString& title) {
    m_header->setText(title);
    m_header->setAccessibleName(title);
}

void SectionBox::setOpen(bool open) {
    m_header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    m_header->setAccessibleDescription(open ? tr("open") : tr("folded"));
    m_content->setVisible(open);
    emit toggled(open);
}

void SectionBox::rememberAs(const QString& key, Begin begin) {
    m_key = key;
    setOpen(Settings().value(key, begin == Begin::open).toBool());
}

SteadyScrollArea::SteadyScrollArea(QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
}

// Content that has become wider needs a wider area; Qt would leave the width as it was.
bool SteadyScrollArea::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::event(event);
}

QSize SteadyScrollArea::around(const QSize& content, int height) const {
    return {content.width() + verticalScrollBar()->sizeHint().width() + 2, height};
}

QSize SteadyScrollArea::sizeHint() const {
    const QSize content = widget()->sizeHint();
    return around(content, std::min(content.height(), mostHeight));
}

QSize SteadyScrollArea::minimumSizeHint() const {
    return around(widget()->minimumSizeHint(), leastHeight);
}

}  // namespace drillwave
