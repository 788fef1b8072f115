// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/page.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <cassert>

namespace drillwave {

QLayout* Page::makeAnswer() {
    assert(!m_answerLabel);
    m_answerLabel = new QLabel(this);
    m_answerLabel->setObjectName(QStringLiteral("answer"));
    QFont bold = m_answerLabel->font();
    bold.setBold(true);
    m_answerLabel->setFont(bold);
    m_answerLabel->setWordWrap(true);
    m_answerLabel->setMargin(4);
    m_answerLabel->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    QPushButton* copy = newButton(QStringLiteral("copyAnswer"), tr("Copy answer"),
                                  tr("Copies answer and sentences below it as text"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(answerText()); });
    auto* row = new QHBoxLayout;
    row->addWidget(m_answerLabel, 1);
    row->addWidget(copy, 0, Qt::AlignTop);
    return row;
}

QString Page::answerText() const {
    return m_answerLabel->text();
}

QPushButton* Page::newButton(const QString& name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    return button;
}

}  // namespace drillwave
