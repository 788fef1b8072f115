// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/study/labelled_control.h"

#include <QHBoxLayout>
#include <QLabel>

namespace drillwave {

QWidget* labelled(const QString& words, QWidget* control, QWidget* parent) {
    auto* box = new QWidget(parent);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* label = new QLabel(words, box);
    label->setBuddy(control);
    layout->addWidget(label);
    layout->addWidget(control);
    return box;
}

}  // namespace drillwave
