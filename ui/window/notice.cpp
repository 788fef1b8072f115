// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/notice.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "ui/text/scrolled_label.h"

namespace drillwave {
namespace {

constexpr double mostOfWindow = 0.09;  // of its height: five lines of usual type in a usual window

}  // namespace

Notice::Notice(Tone tone, QWidget* parent) : QFrame(parent), m_layout(new QHBoxLayout(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setForegroundRole(QPalette::Text);

    const bool warns = tone == Tone::warning;
    auto* icon = new QLabel(this);
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    icon->setPixmap(
        style()
            ->standardIcon(warns ? QStyle::SP_MessageBoxWarning : QStyle::SP_MessageBoxInformation)
            .pixmap(size));
    auto* words = new QLabel;
    words->setForegroundRole(QPalette::Text);
    words->setObjectName(QStringLiteral("text"));
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    words->setAccessibleName(warns ? tr("Warning") : tr("Note"));
    m_text = new ScrolledLabel(words, mostOfWindow, this);
    auto* dismiss = new QToolButton(this);
    dismiss->setObjectName(QStringLiteral("dismiss"));
    dismiss->setText(QStringLiteral("✕"));
    dismiss->setAutoRaise(true);
    dismiss->setForegroundRole(QPalette::Text);
    dismiss->setAccessibleName(tr("Dismiss this note"));
    dismiss->setToolTip(tr("Dismiss this note"));
    connect(dismiss, &QToolButton::clicked, this, [this] {
        hide();
        emit dismissed();
    });

    m_layout->setContentsMargins(8, 4, 4, 4);
    m_layout->addWidget(icon, 0, Qt::AlignTop);
    m_layout->addWidget(m_text, 1);
    m_layout->addWidget(dismiss, 0, Qt::AlignTop);
    hide();
}

QPushButton* Notice::addButton(const QString& text, const QString& toolTip) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(toolTip);
    m_layout->insertWidget(m_layout->count() - 1, button, 0, Qt::AlignTop);
    return button;
}

void Notice::say(const QString& text) {
    m_text->setText(text);
    show();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void Notice::setText(const QString& text) {
    m_text->setText(text);
}

QString Notice::text() const {
    return m_text->text();
}

}  // namespace drillwave
